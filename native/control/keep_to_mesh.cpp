#include "control/keep_to_mesh.h"

#include <algorithm>
#include <cmath>

#include "control/bent_points.h"
#include "control/folds.h"
#include "control/limit_masks.h"
#include "control/slides.h"
#include "control/smoothstep.h"
#include "control/split_once.h"
#include "mesh/mesh_size.h"
#include "mesh/polygons.h"

namespace illustrate {
namespace {

constexpr double longest_step = 0.2;  // of the shortest edge at the point
// Lengths outside of this are not squared without loss; such a mesh stays a cage.
constexpr double least_extent = 1e-100, largest_extent = 1e100;

struct Weighted {
  double value, weight;
};

// Where half of the weight lies below: between the middles of two values in proportion, so that it
// is continuous in the values and in their weights.
double median(std::vector<Weighted>& values) {
  std::sort(values.begin(), values.end(),
            [](const Weighted& a, const Weighted& b) { return a.value < b.value; });
  double total = 0;
  for (const Weighted& v : values) total += v.weight;
  double below = 0, last_middle = 0, last_value = values.empty() ? 0 : values.front().value;
  for (const Weighted& v : values) {
    const double middle = below + v.weight / 2;
    if (middle > total / 2) {
      const double share = (total / 2 - last_middle) / (middle - last_middle);
      return last_value + share * (v.value - last_value);
    }
    below += v.weight;
    last_middle = middle;
    last_value = v.value;
  }
  return last_value;
}

bool is_usable(const SoundMesh& mesh) {
  const double size = diagonal(mesh);
  double extent = size;
  for (const Vec3& p : mesh.positions) extent = std::max(extent, p.cwiseAbs().maxCoeff());
  return size > least_extent && extent < largest_extent;
}

bool is_none(const std::vector<double>& weights) {
  return std::all_of(weights.begin(), weights.end(), [](double w) { return w == 0; });
}

// All copies of a vertex have the largest value of them, or the surface would tear there.
void join_copies(const std::vector<int>& sources, std::vector<double>& values) {
  std::vector<double> largest(idx(1 + *std::max_element(sources.begin(), sources.end())), 0);
  for (std::size_t v = 0; v < values.size(); ++v)
    if (sources[v] != none)
      largest[idx(sources[v])] = std::max(largest[idx(sources[v])], values[v]);
  for (std::size_t v = 0; v < values.size(); ++v)
    if (sources[v] != none) values[v] = largest[idx(sources[v])];
}

// What a mesh is given.
struct Shape {
  Points points;               // of the split mesh
  LimitPlaces limits;          // of the points that it has by itself
  std::vector<double> slides;  // (n) control/slides.h
};

class Keeper {
 public:
  Keeper(const SoundMesh& mesh, Scheme scheme)
      : mesh_(mesh),
        scheme_(scheme),
        edges_(mesh),
        child_(split_once(mesh, edges_, scheme)),
        child_edges_(child_),
        child_sectors_(find_sectors(child_edges_, child_.positions.size())),
        cage_(cage_points(mesh, edges_, scheme)),
        cage_limits_(limits_of(cage_)) {
    patch_count_ = find_patches(edges_, patches_);
    straighten_flat_patches();
  }

  std::vector<double> weights() const {
    std::vector<double> patch_weights;
    for (std::vector<Weighted>& shifts : shifts_of_patches())
      patch_weights.push_back(smoothstep(invisible_px, visible_px, median(shifts)));
    std::vector<double> weights;
    for (const int patch : patches_) weights.push_back(patch_weights[idx(patch)]);
    return weights;
  }

  // weights: of the faces. own: those that the mesh has by itself.
  Shape shape(const std::vector<double>& weights, const std::vector<double>& own) {
    const Points kept = is_none(weights) && is_none(own) ? cage_ : stepped(bent());
    Points points = faded(kept, own);
    LimitPlaces limits = is_none(own) ? cage_limits_ : limits_of(points);
    if (weights != own) points = faded(kept, weights);
    std::vector<double> off = slides(mesh_, edges_, limits, diagonal(mesh_));
    return {std::move(points), std::move(limits), std::move(off)};
  }

  // (n) how far the surface misses the mesh's vertices, in pixels: its limit along the normal, or
  // across the crease; within the surface vertices slide to longer edges. Where it leaves the limit
  // for arcs it goes through the vertices, and is off by what the arcs bulge, if that is less. As
  // far as the faces have weight: what is off where most of a patch is not is noise.
  std::vector<double> distances(const Shape& shape, const std::vector<double>& weights) {
    const std::vector<double> shares = vertex_weights(weights), bulges = bulges_of_arcs(shape);
    const double px = diagonal_px / diagonal(mesh_);
    std::vector<double> distances;
    for (std::size_t v = 0; v < mesh_.positions.size(); ++v) {
      const Vec3& direction = shape.limits.directions[v];
      const Vec3 off = shape.limits.positions[v] - mesh_.positions[v];
      const double along = off.dot(direction);
      const bool smooth = shape.limits.rules[v] == LimitPlaces::Rule::smooth;
      const double missed = smooth ? std::abs(along) : (off - along * direction).norm();
      const double bulged = std::min(missed, bulges[v]);
      distances.push_back(shares[v] * px * (missed + shape.slides[v] * (bulged - missed)));
    }
    return distances;
  }

  // bent_points.
  const Points& bent() {
    if (bent_.empty())
      bent_ = bent_points(mesh_, edges_, find_sectors(edges_, mesh_.positions.size()), scheme_);
    return bent_;
  }

  // bent: the arcs' points; any where nothing slides.
  KeptMesh take(Shape shape, Points bent) {
    child_.positions = std::move(shape.points);
    join_twins();
    if (is_none(shape.slides)) return {std::move(child_), {}};
    join_copies(mesh_.source_vertices, shape.slides);
    return {std::move(child_),
            arc_faces(edges_, std::move(bent), std::move(shape.slides), scheme_)};
  }

 private:
  // (f) 1: on a patch that lies in one plane.
  std::vector<std::uint8_t> on_flat_patches() const {
    std::vector<int> planes;  // of the patches, which are numbered by their first faces
    for (std::size_t f = 0; f < patches_.size(); ++f) {
      const int plane = mesh_.face_planes.empty() ? none : mesh_.face_planes[f];
      if (idx(patches_[f]) == planes.size()) planes.push_back(plane);
      if (planes[idx(patches_[f])] != plane) planes[idx(patches_[f])] = none;
    }
    std::vector<std::uint8_t> flat;
    for (const int patch : patches_) flat.push_back(planes[idx(patch)] != none);
    return flat;
  }

  // Whatever points of its plane a flat patch has inside, its surface is the same. Those of the
  // scheme may lie beyond its border where that has more than 180 degrees inside, since they are
  // drawn to the middles of faces however large, and the surface would fold over.
  void straighten_flat_patches() {
    const std::vector<std::uint8_t> is_flat = on_flat_patches();
    const Points& p = mesh_.positions;
    std::vector<std::uint8_t> is_inside(p.size(), 1);
    for (std::size_t e = 0; e < edges_.first.size(); ++e) {
      const int h = edges_.first[e];
      const std::size_t a = idx(edges_.faces.corners[idx(h)]), b = idx(edges_.faces.head(h));
      if (is_flat[idx(edges_.faces.corner_faces[idx(h)])] && !edges_.is_sharp(h)) {
        cage_[p.size() + e] = (p[a] + p[b]) / 2;
      } else {
        is_inside[a] = is_inside[b] = 0;
      }
    }
    for (std::size_t v = 0; v < p.size(); ++v)
      if (is_inside[v]) cage_[v] = p[v];
  }

  // How far the corners of each patch's faces are from their limits, in pixels, weighed by the
  // faces' areas: what is large is seen, however many vertices the letters in it have.
  std::vector<std::vector<Weighted>> shifts_of_patches() const {
    std::vector<std::vector<Weighted>> shifts(idx(patch_count_));
    const Faces& faces = edges_.faces;
    const double px = diagonal_px / diagonal(mesh_);
    for (int f = 0; f < faces.size(); ++f) {
      const double weight = twice_area(faces[f], px) / static_cast<double>(faces[f].size());
      for (const int v : faces[f]) {
        const double shift = px * (cage_limits_.positions[idx(v)] - mesh_.positions[idx(v)]).norm();
        if (std::isfinite(shift)) shifts[idx(patches_[idx(f)])].push_back({shift, weight});
      }
    }
    return shifts;
  }

  double twice_area(Span<const int> face, double scale) const {
    Points polygon;
    for (const int v : face)
      polygon.push_back(scale * (mesh_.positions[idx(v)] - mesh_.positions[idx(face[0])]));
    return newell_normal({polygon.data(), polygon.size()}).norm();
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

  // (n) the largest sag of the edges at each vertex; 0 where nothing slides.
  std::vector<double> bulges_of_arcs(const Shape& shape) {
    std::vector<double> bulges(mesh_.positions.size(), 0);
    if (is_none(shape.slides)) return bulges;
    for (int e = 0; e < edges_.edge_count(); ++e) {
      const int h = edges_.first[idx(e)];
      const std::size_t a = idx(edges_.faces.corners[idx(h)]), b = idx(edges_.faces.head(h));
      const Vec3 middle = (mesh_.positions[a] + mesh_.positions[b]) / 2;
      const double sag = (bent()[mesh_.positions.size() + idx(e)] - middle).norm();
      for (const std::size_t v : {a, b}) bulges[v] = std::max(bulges[v], sag);
    }
    return bulges;
  }

  LimitPlaces limits_of(const Points& points) const {
    return limit_places(child_, child_edges_, child_sectors_, points, scheme_);
  }

  Points faded(Points kept, const std::vector<double>& weights) const {
    const std::vector<double> shares = vertex_weights(weights);
    for (std::size_t v = 0; v < kept.size(); ++v) {
      const Vec3 point = cage_[v] + shares[v] * (kept[v] - cage_[v]);
      kept[v] = point.allFinite() ? point : cage_[v];
    }
    return kept;
  }

  Points stepped(const Points& targets) const {
    const LimitPlaces limits = limits_of(targets);
    const std::vector<double> shortest = shortest_edges(child_edges_, targets);
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
  Points cage_, bent_;
  LimitPlaces cage_limits_;
  std::vector<int> patches_;  // (f)
  int patch_count_ = 0;
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
  std::optional<KeptMesh> mesh;   // none: its own cage
  std::vector<double> distances;  // Keeper's
};

using Weights = std::optional<std::vector<double>>;

Kept keep_smooth(const SoundMesh& mesh, Scheme scheme, const Weights& given) {
  Keeper keeper(mesh, scheme);
  const std::vector<double> own = keeper.weights(), &weights = given ? *given : own;
  Shape shape = keeper.shape(weights, own);
  Kept kept{{}, keeper.distances(shape, weights)};
  if (!is_none(weights) || !is_none(shape.slides))
    kept.mesh = keeper.take(std::move(shape), keeper.bent());
  return kept;
}

template <class T>
void mix(std::vector<T>& values, const std::vector<T>& others, const std::vector<double>& shares) {
  for (std::size_t v = 0; v < values.size(); ++v) values[v] += shares[v] * (others[v] - values[v]);
}

// Beside folds the shape of the mesh that has them as creases.
Kept keep_folded(const FoldedMesh& folded, Scheme scheme, const Weights& given) {
  Keeper soft(folded.soft, scheme), hard(folded.hard, scheme);
  const std::vector<double> own = soft.weights(), &weights = given ? *given : own;
  Shape shape = soft.shape(weights, own);
  const std::vector<double> own_hard = hard.weights();
  const Shape beside = hard.shape(given ? *given : own_hard, own_hard);
  Points bent = soft.bent();
  const std::vector<double> shares = shares_of_children(folded.soft, folded.shares, bent.size());
  mix(shape.points, beside.points, shares);
  mix(bent, hard.bent(), shares);
  mix(shape.slides, beside.slides, folded.shares);
  Kept kept{{}, soft.distances(shape, weights)};
  mix(kept.distances, hard.distances(beside, weights), folded.shares);
  kept.mesh = soft.take(std::move(shape), std::move(bent));
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

std::optional<KeptMesh> keep_to_mesh(const SoundMesh& mesh, Scheme scheme,
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
