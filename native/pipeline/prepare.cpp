#include "pipeline/prepare.h"

#include "field/placed_field.h"
#include "pipeline/originals.h"
#include "pipeline/same_input.h"
#include "pipeline/stopwatch.h"
#include "surface/same_objects.h"

namespace illustrate {
namespace {

// Triangles whose search without field takes less than half a second, so that the first drawing
// need not wait for it.
constexpr std::size_t most_searched_at_once = 500000;

PrepareOptions with_threads(PrepareOptions options) {
  options.surface.threads = options.jet.threads = options.cross_field.threads = options.threads;
  return options;
}

void add(Counts& sum, const Counts& counts) {
  for (const auto& [name, count] : counts) sum[name] += count;
}

}  // namespace

template <class Make>
auto Prepared::timed(const char* stage, Make&& make) const {
  struct Addition {
    const Prepared& prepared;
    const char* stage;
    const Stopwatch watch{};
    // Also where `make` throws: what was cancelled took its time too.
    ~Addition() {
      const std::lock_guard<std::mutex> lock(prepared.timings_mutex_);
      prepared.timings_[stage] += watch.seconds();
    }
  };
  const Addition addition{*this, stage};
  return make();
}

Prepared::Prepared(const std::vector<MeshPointer>& meshes, const PrepareOptions& options,
                   const Prepared* previous, const Progress& progress)
    : options_(with_threads(options)),
      meshes_(meshes),
      curvature_(std::make_shared<Lazy<Curvature>>()),
      placed_curvature_(std::make_shared<Lazy<Curvature>>()),
      field_(std::make_shared<Lazy<CrossField>>()),
      placed_field_(std::make_shared<Lazy<CrossField>>()),
      families_(std::make_shared<Lazy<Families>>()),
      placed_families_(std::make_shared<Lazy<Families>>()),
      diagonal_families_(std::make_shared<Lazy<Families>>()),
      placed_diagonal_families_(std::make_shared<Lazy<Families>>()),
      hatch_curves_(std::make_shared<Lazy<std::unique_ptr<ObjectCurves>>>()),
      derivative_(std::make_shared<Lazy<CurvatureDerivative>>()) {
  timings_ = {{"sanitize", 0}, {"surface", 0},       {"dual_surface", 0}, {"curvature", 0},
              {"field", 0},    {"intersections", 0}, {"hatch_curves", 0}};
  if (previous && previous->has_surface_of(meshes, options)) {
    take_over(*previous);
  } else {
    make_geometry(meshes, progress.part(0, options.field ? 0.4 : 0.7));
  }
  if (previous && previous->field_ != field_ && previous->field_->peek()) {
    const Geometry& last = *previous->geometry_;
    // The families that stay follow the last ones only if those were ever asked for.
    last_field_ = {previous->shares_field() ? last.originals : last.surface, previous->field_,
                   previous->families_};
    if (previous->families_->peek()) last_families_ = last_field_;
  }
  first_areas_ = triangle_areas(surface());
  if (previous) keep_first_areas(*previous);
  const bool searches = options.field || surface().triangles.size() <= most_searched_at_once;
  if (searches) search(progress.part(options.field ? 0.4 : 0.7, options.field ? 0.6 : 1));
  if (options.field) {
    hatch_curvature(progress.part(0.6, 0.7));
    field(progress.part(0.7, 1));
  }
}

bool Prepared::has_surface_of(const std::vector<MeshPointer>& meshes,
                              const PrepareOptions& options) const {
  if (meshes.size() != object_count() || !is_same(options.surface, options_.surface)) return false;
  if (options.most_intersections != options_.most_intersections) return false;
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    if (!is_same(*meshes[i], *geometry_->meshes[i])) return false;
  }
  return true;
}

void Prepared::keep_first_areas(const Prepared& previous) {
  // Seeds of hatches are dealt by area: with those of the first frame they stay where they are on a
  // mesh that stretches.
  const SameObjects same(previous.surface(), surface());
  for (std::size_t t = 0; t < first_areas_.size(); ++t) {
    const int last = same.last_triangle(t);
    if (last != none) first_areas_[t] = previous.first_areas_[idx(last)];
  }
}

void Prepared::take_over(const Prepared& previous) {
  // What follows depends on what precedes: curvature on the surface, the field on curvature,
  // families and curves on the field.
  geometry_ = previous.geometry_;
  if (!is_same(options_.jet, previous.options_.jet)) return;
  curvature_ = previous.curvature_;
  placed_curvature_ = previous.placed_curvature_;
  derivative_ = previous.derivative_;
  if (!is_same(options_.cross_field, previous.options_.cross_field)) return;
  field_ = previous.field_;
  placed_field_ = previous.placed_field_;
  families_ = previous.families_;
  placed_families_ = previous.placed_families_;
  diagonal_families_ = previous.diagonal_families_;
  placed_diagonal_families_ = previous.placed_diagonal_families_;
  hatch_curves_ = previous.hatch_curves_;
}

// Each original once. What the instances need of it is what the most demanding of them needs.
std::vector<SoundMesh> Prepared::sanitize_all(Geometry& geometry, const Progress& progress) const {
  const OriginalMeshes originals = find_originals(geometry.meshes);
  geometry.instances = originals.instances;
  std::vector<SoundMesh> sound;
  std::vector<Counts> counts(originals.meshes.size());
  const auto count = static_cast<double>(originals.meshes.size());
  for (const PolygonMesh* mesh : originals.meshes) {
    const auto done = static_cast<double>(sound.size());
    const Progress part = progress.part(done / count, (done + 1) / count);
    sound.push_back(sanitize(*mesh, counts[sound.size()], part));
  }
  set_placements(geometry.meshes, geometry.instances, sound);
  for (std::size_t i = 0; i < geometry.meshes.size(); ++i) {
    const Counts& of_original = counts[idx(geometry.instances.originals[i])];
    add(geometry.counts, of_original);
    geometry.mesh_reports.push_back({geometry.meshes[i]->name, of_original});
  }
  return sound;
}

// The surface of all objects, and its size and levels in the report.
void Prepared::place_originals(Geometry& geometry) const {
  geometry.surface = geometry.originals;
  if (geometry.instances.are_trivial) return;
  geometry.surface =
      std::make_shared<const Surface>(placed(*geometry.originals, geometry.instances));
  const Surface& surface = *geometry.surface;
  geometry.counts["triangles"] = static_cast<std::int64_t>(surface.triangles.size());
  geometry.counts["vertices"] = static_cast<std::int64_t>(surface.positions.size());
  const Counts of_originals = geometry.counts;
  for (std::size_t o = 0; o < surface.controls.size(); ++o) {
    geometry.counts["level_" + std::to_string(o)] =
        of_originals.at("level_" + std::to_string(geometry.instances.originals[o]));
  }
}

void Prepared::make_geometry(const std::vector<MeshPointer>& meshes, const Progress& progress) {
  auto geometry = std::make_shared<Geometry>();
  geometry->meshes = meshes;
  std::vector<SoundMesh> sound =
      timed("sanitize", [&] { return sanitize_all(*geometry, progress.part(0, 0.1, "sanitize")); });
  const Progress surface_progress = progress.part(0.1, 1, "surface");
  timed("surface", [&] {
    geometry->originals = std::make_shared<const Surface>(
        refine(std::move(sound), options_.surface, geometry->counts, surface_progress));
    place_originals(*geometry);
    geometry->limit_surface.emplace(*geometry->surface);
    geometry->features = feature_edges(*geometry->surface);
  });
  surface_progress.report(1);
  geometry_ = std::move(geometry);
}

const Prepared::Search& Prepared::search(const Progress& progress) const {
  return geometry_->search.get([&] {
    const Progress trees = progress.part(0, 0.4, "surface");
    Bvh bvh = timed("surface", [&] {
      return Bvh(surface().positions, surface().triangles, options_.threads, trees.part(0, 0.5));
    });
    DualSurface dual_surface = timed("dual_surface", [&] {
      return DualSurface(surface(), options_.threads, trees.part(0.5, 1));
    });
    Search made{std::move(bvh), std::move(dual_surface), {}, {}};
    timed("intersections", [&] {
      made.intersections = illustrate::intersections(surface(), made.bvh, made.counts,
                                                     progress.part(0.4, 1, "intersections"),
                                                     options_.most_intersections);
    });
    return made;
  });
}

Counts Prepared::report() const {
  Counts report = geometry_->counts;
  add(report, search().counts);
  return report;
}

const Curvature& Prepared::curvature_of_originals(const Progress& progress) const {
  return curvature_->get([&] {
    return timed("curvature", [&] {
      return jet_curvature(*geometry_->originals, options_.jet, progress.part(0, 1, "curvature"));
    });
  });
}

const Curvature& Prepared::hatch_curvature(const Progress& progress) const {
  const Curvature& curvature = curvature_of_originals(progress);
  if (geometry_->instances.are_trivial) return curvature;
  return placed_curvature_->get(
      [&] { return placed(curvature, *geometry_->originals, geometry_->instances); });
}

// What guides the field is in the world, and not the same for two objects that share a surface.
bool Prepared::shares_field() const {
  return !geometry_->instances.are_trivial && !needs_tree(options_.cross_field);
}

const CrossField& Prepared::field(const Progress& progress) const {
  const CrossField& field = field_->get([&] { return solve_field(progress); });
  if (!shares_field()) return field;
  return placed_field_->get(
      [&] { return placed(field, *geometry_->originals, geometry_->instances); });
}

CrossField Prepared::solve_field(const Progress& progress) const {
  const bool is_shared = shares_field();
  const Progress before = progress.part(0, 0.2);
  const Curvature& curvature = is_shared ? curvature_of_originals(before) : hatch_curvature(before);
  FieldAids aids;
  aids.objects_share_space = !is_shared;
  if (needs_tree(options_.cross_field)) aids.bvh = &bvh();
  if (last_field_.field) {
    aids.last_surface = last_field_.surface.get();
    aids.last_field = last_field_.field->peek();
  }
  CrossField solved = timed("field", [&] {
    return solve_cross_field(is_shared ? *geometry_->originals : surface(), curvature,
                             options_.cross_field, aids, progress.part(0.2, 1, "field"));
  });
  // Not needed again: the last frame's surface may go.
  last_field_ = {};
  return solved;
}

Families Prepared::label_families(bool of_diagonals, const Progress& progress) const {
  field(progress.part(0, 0.5));
  const Surface& solved_on = solved_surface();
  const Curvature& curvature = shares_field() ? curvature_of_originals({}) : hatch_curvature();
  const CrossField& solved = *field_->peek();
  const Progress labels = progress.part(0.5, 1, "field");
  return timed("field", [&] {
    if (of_diagonals) {
      return find_families(solved_on, curvature, diagonals(solved_on, solved), {}, options_.threads,
                           labels);
    }
    // Stays until the families are found, since `last` points into it; the last frame's surface may
    // go then.
    const LastField before = std::move(last_families_);
    last_families_ = {};
    LastFamilies last;
    if (before.families) {
      last = {before.surface.get(), before.field->peek(), before.families->peek()};
    }
    return find_families(solved_on, curvature, solved, last, options_.threads, labels);
  });
}

const Families& Prepared::placed_families(Lazy<Families>& solved, Lazy<Families>& placed_ones,
                                          bool of_diagonals, const Progress& progress) const {
  const Families& found = solved.get([&] { return label_families(of_diagonals, progress); });
  if (!shares_field()) return found;
  return placed_ones.get(
      [&] { return placed(found, *geometry_->originals, geometry_->instances); });
}

const Families& Prepared::families(const Progress& progress) const {
  return placed_families(*families_, *placed_families_, false, progress);
}

const Families& Prepared::diagonal_families(const Progress& progress) const {
  return placed_families(*diagonal_families_, *placed_diagonal_families_, true, progress);
}

CurvesOfObjects Prepared::hatch_curves(const std::vector<double>& radii,
                                       const std::vector<std::uint8_t>& seeds_only,
                                       const Progress& progress) const {
  const auto& curves = hatch_curves_->get([&] {
    const CrossField& cross_field = field(progress.part(0, 0.5));
    if (shares_field()) {
      return std::make_unique<ObjectCurves>(*geometry_->originals, *field_->peek(),
                                            geometry_->instances, first_areas_);
    }
    return std::make_unique<ObjectCurves>(surface(), cross_field, first_areas_);
  });
  const Progress curve_progress = progress.part(0.5, 1, "hatch curves");
  return timed("hatch_curves", [&] {
    return curves->down_to(radii, seeds_only, options_.threads, curve_progress);
  });
}

const CurvatureDerivative& Prepared::curvature_derivative(const Progress& progress) const {
  return derivative_->get([&] {
    const Curvature& curvature = hatch_curvature(progress.part(0, 0.7));
    return timed("curvature", [&] {
      return illustrate::curvature_derivative(surface(), curvature, options_.threads,
                                              progress.part(0.7, 1, "curvature"));
    });
  });
}

Timings Prepared::timings() const {
  const std::lock_guard<std::mutex> lock(timings_mutex_);
  return timings_;
}

std::shared_ptr<const Prepared> prepare(const std::vector<MeshPointer>& meshes,
                                        const PrepareOptions& options, const Prepared* previous,
                                        const Progress& progress) {
  validate(options);
  return std::make_shared<const Prepared>(meshes, options, previous, progress);
}

}  // namespace illustrate
