#include "control/keep_to_mesh.h"

#include <algorithm>
#include <cmath>

#include "control/bent_points.h"
#include "control/folds.h"
#include "control/limit_masks.h"
#include "control/smoothstep.h"
#include "control/split_once.h"

namespace illustrate {
namespace {

constexpr double invisible_px = 0.75;
constexpr double visible_px = 2.25;
constexpr double longest_step = 0.2;  // of the shortest edge at the point
// Lengths outside of this are not squared without loss; such a mesh stays a cage.
constexpr double least_extent = 1e-100, largest_extent = 1e100;

double median(std::vector<double>& values) {
  if (values.empty()) return 0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

double diagonal(const SoundMesh& mesh) {
  Eigen::AlignedBox3d box;
  for (const int v : mesh.corner_vertices) box.extend(mesh.positions[idx(v)]);
  return box.isEmpty() ? 0 : box.diagonal().stableNorm();
}

bool is_usable(const SoundMesh& mesh) {
  double extent = diagonal(mesh);
  for (const Vec3& p : mesh.positions) extent = std::max(extent, p.cwiseAbs().maxCoeff());
  return diagonal(mesh) > least_extent && extent < largest_extent;
}

class Keeper {
 public:
  Keeper(const SoundMesh& mesh, Scheme scheme)
      : mesh_(mesh),
        scheme_(scheme),
        edges_(mesh),
        child_(split_once(mesh, edges_, scheme)),
        child_edges_(child_),
        child_sectors_(find_sectors(child_edges_, child_.positions.size())),
        cage_(cage_points(mesh, edges_, scheme)) {}

  std::vector<double> weights() const {
    const LimitPlaces limits = limit_places(child_, child_edges_, child_sectors_, cage_, scheme_);
    std::vector<int> patches;
    const int count = find_patches(edges_, patches);
    const double px = diagonal_px / diagonal(mesh_);
    std::vector<double> patch_weights;
    const Ragged<int> vertices = vertices_of(patches, count);
    for (std::size_t patch = 0; patch < vertices.size(); ++patch) {
      std::vector<double> shifts;
      for (const int v : vertices[patch])
        shifts.push_back(px * (limits.positions[idx(v)] - mesh_.positions[idx(v)]).norm());
      patch_weights.push_back(smoothstep(invisible_px, visible_px, median(shifts)));
    }
    std::vector<double> weights;
    for (const int patch : patches) weights.push_back(patch_weights[idx(patch)]);
    return weights;
  }

  // Of the split mesh, with the weights of the faces.
  Points points(const std::vector<double>& weights) const {
    if (std::all_of(weights.begin(), weights.end(), [](double w) { return w == 0; })) return cage_;
    const Points targets =
        bent_points(mesh_, edges_, find_sectors(edges_, mesh_.positions.size()), scheme_);
    Points kept = stepped(targets);
    const std::vector<double> shares = vertex_weights(weights);
    for (std::size_t v = 0; v < kept.size(); ++v) {
      const Vec3 point = cage_[v] + shares[v] * (kept[v] - cage_[v]);
      kept[v] = point.allFinite() ? point : cage_[v];
    }
    return kept;
  }

  // (n) how far the limit is from the mesh's vertices with the patches' own weights, in pixels:
  // along the normal, or across the crease. Within the surface vertices slide to longer edges. As
  // far as the faces have weight: what is off where most of a patch is not is noise.
  std::vector<double> distances(const std::vector<double>& weights) const {
    if (std::all_of(weights.begin(), weights.end(), [](double w) { return w == 0; }))
      return std::vector<double>(mesh_.positions.size(), 0);
    const Points whole = points(this->weights());
    const LimitPlaces limits = limit_places(child_, child_edges_, child_sectors_, whole, scheme_);
    const std::vector<double> shares = vertex_weights(weights);
    const double px = diagonal_px / diagonal(mesh_);
    std::vector<double> distances;
    for (std::size_t v = 0; v < mesh_.positions.size(); ++v) {
      const Vec3 off = limits.positions[v] - mesh_.positions[v];
      const double along = off.dot(limits.directions[v]);
      const bool smooth = limits.rules[v] == LimitPlaces::Rule::smooth;
      distances.push_back(shares[v] * px *
                          (smooth ? std::abs(along) : (off - along * limits.directions[v]).norm()));
    }
    return distances;
  }

  SoundMesh take(Points points) {
    child_.positions = std::move(points);
    join_twins();
    return std::move(child_);
  }

 private:
  // Each vertex once in each of its patches.
  Ragged<int> vertices_of(const std::vector<int>& patches, int count) const {
    Ragged<int> vertices;
    std::vector<std::vector<int>> lists(idx(count));
    const Faces& faces = edges_.faces;
    for (int c = 0; c < faces.corner_count(); ++c)
      lists[idx(patches[idx(faces.corner_faces[idx(c)])])].push_back(faces.corners[idx(c)]);
    for (std::vector<int>& list : lists) {
      std::sort(list.begin(), list.end());
      list.erase(std::unique(list.begin(), list.end()), list.end());
      vertices.add(list);
    }
    return vertices;
  }

  std::vector<double> shortest_edges(const Points& points) const {
    std::vector<double> shortest(points.size(), largest_extent);
    for (const int h : child_edges_.first) {
      const int a = child_edges_.faces.corners[idx(h)], b = child_edges_.faces.head(h);
      const double length = (points[idx(a)] - points[idx(b)]).norm();
      for (const int v : {a, b}) shortest[idx(v)] = std::min(shortest[idx(v)], length);
    }
    return shortest;
  }

  // How far smooth vertices step along their normals: as far as their limit is off, or as those of
  // their smooth neighbours are on average, whichever is less; not where those are off to the other
  // side. On a sphere that is the same; what alternates from vertex to vertex is noise that a step
  // would sharpen.
  std::vector<double> calm_steps(const Points& targets, const LimitPlaces& limits) const {
    std::vector<double> own(targets.size(), 0), sums(targets.size(), 0), counts(targets.size(), 0);
    const auto is_smooth = [&](int v) { return limits.rules[idx(v)] == LimitPlaces::Rule::smooth; };
    for (std::size_t v = 0; v < own.size(); ++v)
      own[v] = (targets[v] - limits.positions[v]).dot(limits.directions[v]);
    for (const int h : child_edges_.first) {
      const int a = child_edges_.faces.corners[idx(h)], b = child_edges_.faces.head(h);
      if (!is_smooth(a) || !is_smooth(b)) continue;
      for (const auto& [here, other] : {Edge{a, b}, Edge{b, a}}) {
        sums[idx(here)] += own[idx(other)];
        ++counts[idx(here)];
      }
    }
    for (std::size_t v = 0; v < own.size(); ++v) {
      if (counts[v] == 0) continue;
      const double mean = sums[v] / counts[v];
      own[v] = own[v] * mean <= 0 ? 0 : std::abs(mean) < std::abs(own[v]) ? mean : own[v];
    }
    return own;
  }

  Points stepped(const Points& targets) const {
    const LimitPlaces limits = limit_places(child_, child_edges_, child_sectors_, targets, scheme_);
    const std::vector<double> shortest = shortest_edges(targets);
    const std::vector<double> steps = calm_steps(targets, limits);
    Points points = targets;
    for (std::size_t v = 0; v < points.size(); ++v) {
      if (limits.rules[v] == LimitPlaces::Rule::corner) continue;
      const Vec3 off = targets[v] - limits.positions[v];
      const Vec3& direction = limits.directions[v];
      const bool smooth = limits.rules[v] == LimitPlaces::Rule::smooth;
      Vec3 step = smooth ? Vec3(steps[v] * direction) : Vec3(off - off.dot(direction) * direction);
      const double length = step.norm(), most = longest_step * shortest[v];
      if (length > most) step *= most / length;
      points[v] += step;
    }
    return points;
  }

  // The largest of the faces around.
  std::vector<double> vertex_weights(const std::vector<double>& weights) const {
    std::vector<double> shares(child_.positions.size(), 0);
    const Faces& faces = child_edges_.faces;
    const Faces& parents = edges_.faces;
    int child = 0;
    for (int f = 0; f < parents.size(); ++f) {
      const int extra = scheme_ == Scheme::loop ? 1 : 0;
      const int end = child + static_cast<int>(parents[f].size()) + extra;
      for (; child < end; ++child)
        for (const int v : faces[child]) shares[idx(v)] = std::max(shares[idx(v)], weights[idx(f)]);
    }
    return shares;
  }

  void join_twins() {
    for (std::size_t v = 0; v < child_.twin_vertices.size(); ++v) {
      const int twin = child_.twin_vertices[v];
      if (twin > static_cast<int>(v)) child_.positions[idx(twin)] = child_.positions[v];
    }
  }

  const SoundMesh& mesh_;
  Scheme scheme_;
  HalfEdges edges_;
  SoundMesh child_;
  HalfEdges child_edges_;
  VertexSectors child_sectors_;
  Points cage_;
};

// (n) of the vertices of a split mesh: the largest of the corners that each lies between.
std::vector<double> shares_of_children(const SoundMesh& mesh, const std::vector<double>& shares,
                                       std::size_t count) {
  const HalfEdges edges(mesh);
  const Faces& faces = edges.faces;
  std::vector<double> result = shares;
  for (const int h : edges.first)
    result.push_back(std::max(shares[idx(faces.corners[idx(h)])], shares[idx(faces.head(h))]));
  for (int f = 0; result.size() < count; ++f) {
    double largest = 0;
    for (const int v : faces[f]) largest = std::max(largest, shares[idx(v)]);
    result.push_back(largest);
  }
  return result;
}

struct Kept {
  std::optional<SoundMesh> mesh;  // none: its own cage
  std::vector<double> distances;  // Keeper's
};

using Weights = std::optional<std::vector<double>>;

Kept keep_smooth(const SoundMesh& mesh, Scheme scheme, const Weights& weights) {
  Keeper keeper(mesh, scheme);
  const std::vector<double> own = weights ? *weights : keeper.weights();
  Points points = keeper.points(own);
  Kept kept{{}, keeper.distances(own)};
  const bool is_cage = std::all_of(own.begin(), own.end(), [](double w) { return w == 0; });
  if (!is_cage) kept.mesh = keeper.take(std::move(points));
  return kept;
}

// Beside folds the points of the mesh that has them as creases.
Kept keep_folded(const FoldedMesh& folded, Scheme scheme, const Weights& weights) {
  Keeper soft(folded.soft, scheme), hard(folded.hard, scheme);
  const std::vector<double> soft_weights = weights ? *weights : soft.weights();
  const std::vector<double> hard_weights = weights ? *weights : hard.weights();
  Points points = soft.points(soft_weights);
  const Points beside = hard.points(hard_weights);
  Kept kept{{}, soft.distances(soft_weights)};
  const std::vector<double> distances = hard.distances(soft_weights);
  const std::vector<double> shares = shares_of_children(folded.soft, folded.shares, points.size());
  for (std::size_t v = 0; v < points.size(); ++v) points[v] += shares[v] * (beside[v] - points[v]);
  for (std::size_t v = 0; v < distances.size(); ++v)
    kept.distances[v] += shares[v] * (distances[v] - kept.distances[v]);
  kept.mesh = soft.take(std::move(points));
  return kept;
}

Kept keep(const SoundMesh& mesh, const std::optional<FoldedMesh>& folded, Scheme scheme,
          const Weights& weights) {
  return folded ? keep_folded(*folded, scheme, weights) : keep_smooth(mesh, scheme, weights);
}

}  // namespace

std::vector<double> kept_weights(const SoundMesh& mesh, Scheme scheme) {
  if (!is_usable(mesh)) return std::vector<double>(mesh.face_sizes.size(), 0);
  return Keeper(mesh, scheme).weights();
}

std::optional<SoundMesh> keep_to_mesh(const SoundMesh& mesh, Scheme scheme,
                                      const std::optional<std::vector<double>>& weights,
                                      const Progress& progress) {
  if (!is_usable(mesh)) return {};
  progress.report(0);
  const std::optional<FoldedMesh> folded = fold(mesh);
  Kept kept = keep(mesh, folded, scheme, weights);
  progress.report(.5);
  // How far the surface misses the vertices is known only now. One more round and no other: each
  // costs as much as the first.
  const std::optional<FoldedMesh> again = fold(mesh, kept.distances);
  const bool has_more =
      again && (!folded || again->soft.edge_sharpness != folded->soft.edge_sharpness);
  if (has_more) kept = keep(mesh, again, scheme, weights);
  return std::move(kept.mesh);
}

}  // namespace illustrate
