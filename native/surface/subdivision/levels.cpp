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

// The drawn faces of a mesh, in all the places where it is drawn.
struct FaceCount {
  std::int64_t triangles = 0, corners = 0;
};

FaceCount count_faces(const SoundMesh& mesh) {
  FaceCount count;
  for (std::size_t f = 0; f < mesh.face_sizes.size(); ++f) {
    if (!is_drawn(mesh, f)) continue;
    count.triangles += mesh.face_sizes[f] - 2;
    count.corners += mesh.face_sizes[f];
  }
  const auto copies = static_cast<std::int64_t>(std::max<std::size_t>(1, mesh.placements.size()));
  return {copies * count.triangles, copies * count.corners};
}

// Triangles on a level; more than most_triangles only says that it is more.
std::int64_t triangle_count(const FaceCount& faces, Scheme scheme, int level) {
  if (level == 0 || scheme == Scheme::polygons) return faces.triangles;
  std::int64_t count = scheme == Scheme::loop ? 4 * faces.triangles : 2 * faces.corners;
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

// What an automatic level goes by, in world units, where the mesh is drawn largest.
struct Edges {
  double median = 0;
  bool has_long = false;  // so many that their bends have to be looked at
};

Edges measure_edges(const SoundMesh& mesh) {
  std::vector<double> lengths = edge_lengths(mesh);
  const double middle = median(lengths);
  double all = 0, long_ones = 0;
  for (const double length : lengths) {
    all += length;
    if (is_coarse(length, middle)) long_ones += length;
  }
  return {largest_scale(mesh) * middle, long_ones > ignored_coarse_share * all};
}

double automatic_edge_length(const std::vector<SoundMesh>& meshes) {
  static const std::vector<Similarity> as_it_is(1);
  Spread spread;
  for (const SoundMesh& mesh : meshes) {
    for (const Similarity& placement : mesh.placements.empty() ? as_it_is : mesh.placements)
      add_faces(mesh, placement, spread);
  }
  return spread.diagonal() * automatic_edge_share;
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
int automatic_level(const SoundMesh& mesh, const Edges& edges, double longest) {
  const int level = level_for(edges.median, longest);
  if (!edges.has_long) return level;
  const double scale = largest_scale(mesh);
  return std::max(level, level_for_coarse_bends(mesh, edges.median / scale, longest / scale,
                                                highest_automatic_level));
}

int explicit_level(const SoundMesh& mesh, const SurfaceOptions& options) {
  return mesh.level.value_or(options.level);
}

void check_explicit_level(const SoundMesh& mesh, Scheme scheme, int level) {
  if (triangle_count(count_faces(mesh), scheme, level) <= most_triangles) return;
  throw InvalidInput("level " + std::to_string(level) + " of mesh '" + mesh.name +
                     "' makes more than 200 million triangles: choose a lower level");
}

void keep_budget(const std::vector<SoundMesh>& meshes, const std::vector<Scheme>& schemes,
                 const std::vector<Edges>& edges, const std::vector<std::uint8_t>& automatic,
                 int budget, std::vector<int>& levels) {
  std::vector<FaceCount> faces;
  std::int64_t total = 0;
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    faces.push_back(automatic[i] ? count_faces(meshes[i]) : FaceCount{});
    total += triangle_count(faces[i], schemes[i], levels[i]);
  }
  const auto edge = [&](std::size_t i) { return std::ldexp(edges[i].median, -levels[i]); };
  // The first level of a mesh with coarse bends is worth most: on it the surface keeps to the mesh.
  const auto keeps = [&](std::size_t i) { return edges[i].has_long && levels[i] == 1; };
  const auto gives_up_sooner = [&](std::size_t i, std::size_t other) {
    return keeps(i) != keeps(other) ? keeps(other) : edge(i) < edge(other);
  };
  while (total > budget) {
    int first = none;
    for (std::size_t i = 0; i < meshes.size(); ++i) {
      if (!automatic[i] || levels[i] == 0) continue;
      // The shortest edges show least where they are doubled; of equal ones the first mesh's go.
      if (first == none || gives_up_sooner(i, idx(first))) first = static_cast<int>(i);
    }
    if (first == none) return;
    const FaceCount& given_up = faces[idx(first)];
    int& level = levels[idx(first)];
    total -= triangle_count(given_up, schemes[idx(first)], level);
    total += triangle_count(given_up, schemes[idx(first)], --level);
  }
}

}  // namespace

std::vector<int> choose_levels(const std::vector<SoundMesh>& meshes,
                               const std::vector<Scheme>& schemes, const SurfaceOptions& options) {
  std::vector<int> levels(meshes.size(), 0);
  std::vector<Edges> edges(meshes.size());
  std::vector<std::uint8_t> automatic(meshes.size(), 0);
  const double usual =
      options.edge_length > 0 ? options.edge_length : automatic_edge_length(meshes);
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    if (schemes[i] == Scheme::polygons) continue;
    levels[i] = explicit_level(meshes[i], options);
    if (levels[i] >= 0) {
      check_explicit_level(meshes[i], schemes[i], levels[i]);
      continue;
    }
    automatic[i] = 1;
    edges[i] = measure_edges(meshes[i]);
    levels[i] = automatic_level(meshes[i], edges[i], meshes[i].edge_length.value_or(usual));
  }
  keep_budget(meshes, schemes, edges, automatic, options.triangle_budget, levels);
  return levels;
}

}  // namespace illustrate
