#include "pipeline/originals.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>
#include <utility>

#include "pipeline/same_input.h"
#include "surface/same_objects.h"

namespace illustrate {
namespace {

// Of lengths and scales: what matrices in single precision make of one number.
constexpr double same_size = 1e-4;
// Of shading normals, in single precision and turned.
constexpr double same_normal = 1e-3;

bool is_near(double a, double b) { return std::abs(a - b) <= same_size * std::abs(a); }

bool is_near(const std::optional<double>& a, const std::optional<double>& b) {
  return a && b ? is_near(*a, *b) : !a == !b;
}

bool has_moved_normals(const PolygonMesh& from, const PolygonMesh& to, const Similarity& motion) {
  const Points &before = from.corner_normals, &now = to.corner_normals;
  if (before.size() != now.size()) return false;
  for (std::size_t c = 0; c < now.size(); ++c) {
    const double length = now[c].norm();
    if (!((motion.direction(before[c]) - now[c]).norm() <= same_normal * length)) return false;
  }
  return true;
}

// From the mesh that the last frame's surface was made from to this one.
std::optional<Similarity> motion_of(const Original& last, const PolygonMesh& now) {
  if (!has_same_form(*last.made_from, now)) return {};
  if (has_same_place(*last.given, now)) return last.motion;
  const std::optional<Similarity> motion = rigid_motion(last.made_from->positions, now.positions);
  if (!motion || !has_moved_normals(*last.made_from, now, *motion)) return {};
  return motion;
}

void keep_where_same(Original& original, const Original& last) {
  if (!is_near(original.edge_length, last.edge_length) ||
      !is_near(original.given->edge_length, last.given->edge_length) ||
      !is_near(original.largest_scale(), last.largest_scale())) {
    return;
  }
  const std::optional<Similarity> motion = motion_of(last, *original.given);
  if (!motion) return;
  original.is_kept = true;
  original.made_from = last.made_from;
  original.motion = *motion;
  original.mended = last.mended;
  original.wish = last.wish;
  original.wish.copies = static_cast<int>(original.placements.size());
  original.level = last.level;
}

// Tells each original how long its edges may be, in world units, where it is drawn largest, so that
// they are short enough for every object.
void set_edge_lengths(Originals& originals) {
  for (std::size_t i = 0; i < originals.objects.size(); ++i) {
    if (!originals.objects[i]->edge_length) continue;
    Original& original = originals.each[idx(originals.instances.originals[i])];
    const double scale = originals.instances.placements[i].scale;
    const double length = *originals.objects[i]->edge_length / scale * original.largest_scale();
    original.edge_length = std::min(length, original.edge_length.value_or(length));
  }
}

void find_last(Originals& originals, const Originals& last) {
  originals.last_objects = objects_by_name(names_of(last.objects), names_of(originals.objects));
  std::vector<std::uint8_t> is_taken(last.each.size(), 0);
  for (std::size_t i = 0; i < originals.objects.size(); ++i) {
    Original& original = originals.each[idx(originals.instances.originals[i])];
    const int object = originals.last_objects[i];
    if (object == none || original.last != none) continue;
    const int number = last.instances.originals[idx(object)];
    if (!std::exchange(is_taken[idx(number)], std::uint8_t{1})) original.last = number;
  }
}

bool is_any_by_the_scene(const Originals& originals, const SurfaceOptions& options) {
  return std::any_of(originals.each.begin(), originals.each.end(), [&](const Original& original) {
    return goes_by_the_scene(options, original.given->level, original.edge_length);
  });
}

SoundMesh sanitize_one(Original& original, const Progress& progress) {
  original.mended.clear();
  SoundMesh sound = sanitize(*original.given, original.mended, progress);
  sound.placements = original.placements;
  sound.edge_length = original.edge_length;
  return sound;
}

// Of those that are not kept.
void set_wishes(Originals& originals, std::vector<SoundMesh>& sound,
                const SurfaceOptions& options) {
  std::vector<SoundMesh> fresh;
  std::vector<std::size_t> numbers;
  for (std::size_t o = 0; o < originals.each.size(); ++o) {
    if (originals.each[o].is_kept) continue;
    fresh.push_back(std::move(sound[o]));
    numbers.push_back(o);
  }
  const std::vector<LevelWish> wishes = level_wishes(fresh, options);
  for (std::size_t k = 0; k < numbers.size(); ++k) {
    originals.each[numbers[k]].wish = wishes[k];
    sound[numbers[k]] = std::move(fresh[k]);
  }
}

// Returns whether something is no longer kept.
bool set_levels(Originals& originals, const Originals* last, const SurfaceOptions& options,
                std::vector<SoundMesh>& sound) {
  std::vector<LevelWish> wishes;
  for (const Original& original : originals.each) wishes.push_back(original.wish);
  const std::vector<int> levels = choose_levels(wishes, options.triangle_budget);
  bool has_changed = false;
  for (std::size_t o = 0; o < levels.size(); ++o) {
    Original& original = originals.each[o];
    original.chosen_level = levels[o];
    if (!original.is_kept || levels[o] == last->each[idx(original.last)].chosen_level) continue;
    original.is_kept = false;
    original.made_from = original.given;
    original.motion = {};
    sound[o] = sanitize_one(original, {});
    has_changed = true;
  }
  return has_changed;
}

// The surface of what is not kept.
Surface refine_those(Originals& originals, std::vector<SoundMesh>& sound,
                     const SurfaceOptions& options, const Progress& progress) {
  std::vector<SoundMesh> fresh;
  std::vector<LevelWish> wishes;
  std::vector<int> levels;
  for (std::size_t o = 0; o < originals.each.size(); ++o) {
    const Original& original = originals.each[o];
    if (original.is_kept) continue;
    fresh.push_back(std::move(sound[o]));
    wishes.push_back(original.wish);
    levels.push_back(original.chosen_level);
  }
  Refined refined = refine_to(std::move(fresh), wishes, levels, options, progress);
  auto level = refined.levels.begin();
  for (Original& original : originals.each) {
    if (!original.is_kept) original.level = *level++;
  }
  return std::move(refined.surface);
}

// From the last frame to this one: exactly nothing where an original rests.
Similarity step_of(const Original& last, const Original& now) {
  return now.motion == last.motion ? Similarity() : now.motion * last.motion.inverse();
}

EarlierObjects earlier_objects(const Originals& originals, const Originals& last) {
  EarlierObjects earlier;
  for (const Original& original : originals.each) {
    Earlier& found = earlier.emplace_back();
    found.object = original.last;
    found.is_kept = original.is_kept;
    if (found.is_kept) found.step = step_of(last.each[idx(original.last)], original);
  }
  return earlier;
}

}  // namespace

std::vector<std::string> names_of(const std::vector<MeshPointer>& meshes) {
  std::vector<std::string> names;
  for (const MeshPointer& mesh : meshes) names.push_back(mesh->name);
  return names;
}

double Original::largest_scale() const {
  double largest = 0;
  for (const Similarity& placement : placements) largest = std::max(largest, placement.scale);
  return largest;
}

void Originals::report(Counts& counts) const {
  for (const int original : instances.originals) {
    for (const auto& [name, count] : each[idx(original)].mended) counts[name] += count;
  }
  std::vector<LevelWish> wishes;
  std::vector<int> levels;
  for (const Original& original : each) {
    wishes.push_back(original.wish);
    levels.push_back(original.level);
  }
  report_refined(*surface, wishes, levels, counts);
}

Originals find_originals(const std::vector<MeshPointer>& meshes, const SurfaceOptions& options,
                         const Originals* last) {
  Originals found;
  found.objects = meshes;
  std::unordered_map<const PolygonMesh*, int> numbers;
  for (const MeshPointer& mesh : meshes) {
    const MeshPointer& original = mesh->original ? mesh->original : mesh;
    const auto next = static_cast<int>(found.each.size());
    const auto [it, is_new] = numbers.try_emplace(original.get(), next);
    if (is_new) {
      found.each.emplace_back();
      found.each.back().given = found.each.back().made_from = original;
    }
    found.each[idx(it->second)].placements.push_back(mesh->placement);
    found.instances.originals.push_back(it->second);
    found.instances.placements.push_back(mesh->placement);
    if (!is_new || mesh->original) found.instances.are_trivial = false;
  }
  set_edge_lengths(found);
  if (!last) return found;
  find_last(found, *last);
  if (is_any_by_the_scene(found, options)) return found;
  for (Original& original : found.each) {
    if (original.last != none) keep_where_same(original, last->each[idx(original.last)]);
  }
  return found;
}

std::vector<SoundMesh> sanitize_fresh(Originals& originals, const Progress& progress) {
  std::vector<SoundMesh> sound(originals.each.size());
  const auto count = static_cast<double>(sound.size());
  for (std::size_t o = 0; o < sound.size(); ++o) {
    const auto done = static_cast<double>(o);
    const Progress part = progress.part(done / count, (done + 1) / count);
    if (!originals.each[o].is_kept) sound[o] = sanitize_one(originals.each[o], part);
  }
  return sound;
}

void refine_fresh(Originals& originals, std::vector<SoundMesh> sound, const SurfaceOptions& options,
                  const Originals* last, const Progress& progress) {
  set_wishes(originals, sound, options);
  if (set_levels(originals, last, options, sound)) set_wishes(originals, sound, options);
  auto fresh = std::make_shared<const Surface>(refine_those(originals, sound, options, progress));
  originals.surface = fresh;
  if (!last) return;
  originals.earlier = earlier_objects(originals, *last);
  if (!keeps_any(originals.earlier)) return;
  originals.surface = std::make_shared<const Surface>(
      joined({last->surface.get(), fresh.get()}, sources_of(originals.earlier)));
}

}  // namespace illustrate
