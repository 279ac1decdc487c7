#include "surface/subdivision/levels.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "core/errors.h"
#include "mesh/mesh_size.h"
#include "surface/subdivision/base_edges.h"
#include "surface/subdivision/coarse_bends.h"

namespace illustrate {
namespace {

// Finer than any drawing needs from any cage; the budget usually ends it before.
constexpr int highest_automatic_level = 7;
constexpr std::int64_t most_triangles = 200'000'000;
// Part of the diagonal of all meshes (core/spread.h) that the edges of an automatic level have: in
// a drawing as large as 1400 pixels two or three of them.
constexpr double automatic_edge_share = 1.0 / 600;

bool is_drawn(const SoundMesh& mesh, std::size_t face) {
  return (mesh.kept.empty() || mesh.kept[face]) && (mesh.holes.empty() || !mesh.holes[face]);
}

void count_faces(const SoundMesh& mesh, LevelWish& wish) {
  for (std::size_t f = 0; f < mesh.face_sizes.size(); ++f) {
    if (!is_drawn(mesh, f)) continue;
    wish.triangles += mesh.face_sizes[f] - 2;
    wish.corners += mesh.face_sizes[f];
  }
  wish.copies = static_cast<int>(std::max<std::size_t>(1, mesh.placements.size()));
}

// Triangles on a level, in all the places where the mesh is drawn; more than most_triangles only
// says that it is more.
std::int64_t triangle_count(const LevelWish& wish, int level) {
  if (level == 0 || wish.scheme == Scheme::polygons) return wish.copies * wish.triangles;
  const std::int64_t split = wish.scheme == Scheme::loop ? 4 * wish.triangles : 2 * wish.corners;
  std::int64_t count = wish.copies * split;
  for (int l = 1; l < level && count <= most_triangles; ++l) count *= 4;
  return count;
}

double largest_scale(const SoundMesh& mesh) {
  double scale = mesh.placements.empty() ? 1 : 0;
  for (const Similarity& placement : mesh.placements) scale = std::max(scale, placement.scale);
  return scale;
}

std::vector<double> edge_lengths(const SoundMesh& mesh) {
  std::vector<double> lengths;
  const std::vector<int> offsets = face_offsets(mesh.face_sizes);
  for (std::size_t f = 0; f < mesh.face_sizes.size(); ++f) {
    for (int c = offsets[f]; c < offsets[f + 1]; ++c) {
      const int next = c + 1 == offsets[f + 1] ? offsets[f] : c + 1;
      const Vec3& a = mesh.positions[idx(mesh.corner_vertices[idx(c)])];
      lengths.push_back((mesh.positions[idx(mesh.corner_vertices[idx(next)])] - a).stableNorm());
    }
  }
  return lengths;
}

// Reorders them.
double median(std::vector<double>& lengths) {
  if (lengths.empty()) return 0;
  const auto middle = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2);
  std::nth_element(lengths.begin(), middle, lengths.end());
  return *middle;
}

// In world units, where the mesh is drawn largest.
void measure_edges(const SoundMesh& mesh, LevelWish& wish) {
  std::vector<double> lengths = edge_lengths(mesh);
  const double middle = median(lengths);
  double all = 0, long_ones = 0;
  for (const double length : lengths) {
    all += length;
    if (is_coarse(length, middle)) long_ones += length;
  }
  wish.median_edge = largest_scale(mesh) * middle;
  wish.has_long_edges = long_ones > ignored_coarse_share * all;
}

// Each level halves the edges.
int level_for(double edge, double longest) {
  int level = 0;
  while (level < highest_automatic_level && edge > longest) {
    edge /= 2;
    ++level;
  }
  return level;
}

// By the median edge, and by the bends of faces that are much larger.
int automatic_level(const SoundMesh& mesh, const LevelWish& wish, double longest) {
  const int level = level_for(wish.median_edge, longest);
  if (!wish.has_long_edges) return level;
  const double scale = largest_scale(mesh);
  return std::max(level, level_for_coarse_bends(mesh, wish.median_edge / scale, longest / scale,
                                                highest_automatic_level));
}

int explicit_level(const std::optional<int>& own, const SurfaceOptions& options) {
  return own.value_or(options.level);
}

void check_explicit_level(const SoundMesh& mesh, const LevelWish& wish) {
  if (triangle_count(wish, wish.level) <= most_triangles) return;
  throw InvalidInput("level " + std::to_string(wish.level) + " of mesh '" + mesh.name +
                     "' makes more than 200 million triangles: choose a lower level");
}

// Of meshes that have triangles to give up, the one whose shortest edges show least where they are
// doubled; of equal ones the first; or none.
int next_to_give_up(const std::vector<LevelWish>& wishes, const std::vector<int>& levels) {
  const auto edge = [&](std::size_t i) { return std::ldexp(wishes[i].median_edge, -levels[i]); };
  // The first level of a mesh with coarse bends is worth most: on it the surface keeps to the mesh.
  const auto keeps = [&](std::size_t i) { return wishes[i].has_long_edges && levels[i] == 1; };
  const auto gives_up_sooner = [&](std::size_t i, std::size_t other) {
    return keeps(i) != keeps(other) ? keeps(other) : edge(i) < edge(other);
  };
  int first = none;
  for (std::size_t i = 0; i < wishes.size(); ++i) {
    if (!wishes[i].is_automatic || levels[i] == 0) continue;
    if (first == none || gives_up_sooner(i, idx(first))) first = static_cast<int>(i);
  }
  return first;
}

}  // namespace

double usual_edge_length(const std::vector<SoundMesh>& meshes) {
  static const std::vector<Similarity> as_it_is(1);
  Spread spread;
  for (const SoundMesh& mesh : meshes) {
    for (const Similarity& placement : mesh.placements.empty() ? as_it_is : mesh.placements)
      add_faces(mesh, placement, spread);
  }
  return spread.diagonal() * automatic_edge_share;
}

bool goes_by_the_scene(const SurfaceOptions& options, std::optional<int> own_level,
                       std::optional<double> own_edge_length) {
  return explicit_level(own_level, options) < 0 && !own_edge_length && options.edge_length <= 0;
}

LevelWish level_wish(const SoundMesh& mesh, Scheme scheme, const SurfaceOptions& options,
                     double usual_edge_length) {
  LevelWish wish;
  wish.scheme = scheme;
  if (scheme == Scheme::polygons) return wish;
  count_faces(mesh, wish);
  wish.level = explicit_level(mesh.level, options);
  wish.is_automatic = wish.level < 0;
  if (!wish.is_automatic) {
    check_explicit_level(mesh, wish);
    return wish;
  }
  measure_edges(mesh, wish);
  wish.level = automatic_level(mesh, wish, mesh.edge_length.value_or(usual_edge_length));
  return wish;
}

std::vector<int> choose_levels(const std::vector<LevelWish>& wishes, int triangle_budget) {
  std::vector<int> levels;
  std::int64_t total = 0;
  for (const LevelWish& wish : wishes) {
    levels.push_back(wish.level);
    if (wish.is_automatic) total += triangle_count(wish, wish.level);
  }
  while (total > triangle_budget) {
    const int first = next_to_give_up(wishes, levels);
    if (first == none) break;
    int& level = levels[idx(first)];
    total -= triangle_count(wishes[idx(first)], level);
    total += triangle_count(wishes[idx(first)], --level);
  }
  return levels;
}

}  // namespace illustrate
