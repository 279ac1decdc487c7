#include "field/problem/problem.h"

#include "field/problem/guides.h"
#include "field/singularities.h"

namespace illustrate {
namespace {

// An edge turned by an angle of the cross at its first end.
FieldEdge adjusted(FieldEdge edge, double turn) {
  edge.transport = product(edge.transport, {std::cos(4 * turn), -std::sin(4 * turn)});
  return edge;
}

void prescribe(const Surface& surface, const PrescribedSingularities& singularities, const Bvh& bvh,
               FieldProblem& p) {
  p.prescribed =
      place_singularities(surface, p.triangle_edges, p.parts, bvh, p.excess, singularities);
  p.turns = least_turns(surface, p.triangle_edges, p.excess, p.parts, p.prescribed);
  for (std::size_t e = 0; e < p.edges.size(); ++e) p.edges[e] = adjusted(p.edges[e], p.turns[e]);
}

bool is_prescribed(const FieldProblem& p, std::size_t vertex) {
  return !p.turns.empty() && p.prescribed.has_parts[idx(p.parts.of_vertex[vertex])];
}

void release(const std::vector<std::uint8_t>& released, FieldProblem& p) {
  release_planes(released, p.planes.planes);
  for (std::size_t i = 0; i < released.size(); ++i) {
    if (released[i]) p.reliable[i] = 0;
  }
}

// Guides and prescribed singularities overrule curvature and flat faces.
void withdraw_reliability(const Surface& surface, const std::vector<double>& diagonals,
                          const FieldOptions& options, FieldProblem& p) {
  if (!p.turns.empty()) {
    std::vector<std::uint8_t> released(p.reliable.size());
    for (std::size_t i = 0; i < released.size(); ++i) released[i] = is_prescribed(p, i);
    release(released, p);
  }
  if (options.guides.empty()) return;
  release(near_pulls(surface, p.guide_pulls, diagonals, options.guide_radius), p);
}

// Flat faces overrule curvature: that of a flat face is what its rim has of the form beyond.
void hold_flat_faces(const Surface& surface, const FieldOptions& options, const FieldAids& aids,
                     FieldProblem& p) {
  p.planes = {std::vector<int>(p.frames.size(), none), p.by_default};
  if (!(options.alignment_weight > 0)) return;
  p.planes = plane_crosses(surface, p.frames, p.by_default, aids.objects_share_space);
  for (std::size_t i = 0; i < p.reliable.size(); ++i) {
    if (p.planes.planes[i] != none) p.reliable[i] = 0;
  }
}

// Principal directions; in a part without a reliable vertex the default direction, parallel where
// singularities are prescribed, turned towards its features and guides.
CrossNumbers initial_field(const FieldProblem& p) {
  std::vector<std::uint8_t> has_reliable(idx(p.parts.count), 0);
  for (std::size_t i = 0; i < p.reliable.size(); ++i) {
    if (p.reliable[i]) has_reliable[idx(p.parts.of_vertex[i])] = 1;
  }
  CrossNumbers z = p.principal.z;
  for (std::size_t i = 0; i < z.size(); ++i) {
    if (!has_reliable[idx(p.parts.of_vertex[i])]) z[i] = p.by_default[i];
  }
  for (std::size_t i = 0; i < z.size(); ++i) {
    if (p.planes.planes[i] != none) z[i] = p.planes.z[i];
  }
  if (!p.turns.empty()) comb_along_tree(p.edges, p.parts, p.prescribed.has_parts, z);
  CrossNumbers wanted = p.alignment.pulls;
  for (std::size_t i = 0; i < wanted.size(); ++i) wanted[i] += p.guide_pulls[i];
  turn_parts(p.parts, parts_that_may_turn(p), wanted, z);
  return z;
}

// Of the edges of each object.
class ObjectMeans {
 public:
  ObjectMeans(const Surface& surface, const TriangleEdges& edges)
      : surface_(surface),
        edges_(edges),
        sums_(surface.object_is_smooth.size(), 0),
        counts_(sums_.size(), 0) {}

  void add(std::size_t edge, double value) {
    sums_[object(edge)] += value;
    counts_[object(edge)] += 1;
  }
  double of(std::size_t edge) const { return sums_[object(edge)] / counts_[object(edge)]; }

 private:
  std::size_t object(std::size_t edge) const {
    return idx(surface_.objects[idx(edges_.vertices[edge][0])]);
  }

  const Surface& surface_;
  const TriangleEdges& edges_;
  std::vector<double> sums_, counts_;
};

// (m) 1 / length, 1 in the mean of each object; edges much shorter than the others are not let
// rule them.
std::vector<double> inverse_lengths(const Surface& surface, const TriangleEdges& edges) {
  constexpr double most = 100;
  std::vector<double> weights(edges.size());
  ObjectMeans lengths(surface, edges), means(surface, edges);
  for (std::size_t e = 0; e < weights.size(); ++e) {
    const auto [i, j] = edges.vertices[e];
    weights[e] = (surface.positions[idx(j)] - surface.positions[idx(i)]).norm();
    lengths.add(e, std::isfinite(weights[e]) ? weights[e] : 0);
  }
  for (std::size_t e = 0; e < weights.size(); ++e) {
    const double mean = lengths.of(e);
    double& weight = weights[e];
    weight = std::isfinite(weight) ? std::min(most, mean / std::max(weight, mean / most)) : 0;
    if (!(mean > 0)) weight = 1;
    means.add(e, weight);
  }
  for (std::size_t e = 0; e < weights.size(); ++e) weights[e] /= means.of(e);
  return weights;
}

}  // namespace

FieldProblem state_problem(const Surface& surface, const Curvature& curvature,
                           const FieldOptions& options, const FieldAids& aids,
                           const Progress& progress) {
  FieldProblem p;
  const Bvh* bvh = aids.bvh;
  const int threads = options.threads;
  p.frames = tangent_frames(surface.normals, threads, progress.part(0, 0.05));
  p.triangle_edges = triangle_edges(surface, progress.part(0.05, 0.3));
  const std::vector<double> weights = options.inverse_length_weights
                                          ? inverse_lengths(surface, p.triangle_edges)
                                          : std::vector<double>();
  p.edges =
      field_edges(surface, p.triangle_edges, p.frames, weights, threads, progress.part(0.3, 0.45));
  p.parts = connected_parts(p.frames.size(), p.edges, progress.part(0.45, 0.55));
  const std::vector<double> diagonals = object_diagonals(surface);
  p.alignment = align_to_features(surface, p.frames, diagonals, options.alignment_weight,
                                  progress.part(0.55, 0.6));
  p.by_default = default_crosses(p.frames, options.default_direction, progress.part(0.6, 0.65));
  p.principal = principal_crosses(p.frames, curvature, p.by_default, progress.part(0.65, 0.7));
  p.reliable = reliable_vertices(curvature, p.edges, p.principal, diagonals, options,
                                 progress.part(0.7, 0.8));
  p.excess =
      triangle_excess(surface, p.triangle_edges, p.frames, threads, progress.part(0.8, 0.95));
  Bvh own;
  if (!bvh && needs_tree(options)) {
    own = Bvh(surface.positions, surface.triangles, threads);
    bvh = &own;
  }
  p.guide_pulls = CrossNumbers(p.frames.size(), 0);
  if (!options.guides.empty()) {
    p.guide_pulls = guide_pulls(surface, p.frames, *bvh, options.guides, progress.part(0.95, 0.97));
  }
  if (!options.singularities.empty()) prescribe(surface, options.singularities, *bvh, p);
  hold_flat_faces(surface, options, aids, p);
  withdraw_reliability(surface, diagonals, options, p);
  progress.report(0.98);
  p.initial = initial_field(p);
  return p;
}

std::vector<double> part_energies(const FieldProblem& p, const CrossNumbers& z) {
  std::vector<double> sums = part_energies(p.parts, p.edges, z);
  for (std::size_t i = 0; i < z.size(); ++i) {
    sums[idx(p.parts.of_vertex[i])] -= product(std::conj(z[i]), p.guide_pulls[i]).real();
  }
  return sums;
}

std::vector<double> least_energies(const FieldProblem& p) {
  std::vector<double> least(idx(p.parts.count), 0);
  for (const FieldEdge& edge : p.edges) {
    least[idx(p.parts.of_vertex[idx(edge.from)])] -= std::sqrt(std::norm(edge.transport));
  }
  for (std::size_t i = 0; i < p.guide_pulls.size(); ++i) {
    if (p.guide_pulls[i] == CrossNumber(0)) continue;
    least[idx(p.parts.of_vertex[i])] -= std::abs(p.guide_pulls[i]);
  }
  return least;
}

std::vector<std::uint8_t> parts_that_may_turn(const FieldProblem& p) {
  std::vector<std::uint8_t> may_turn(idx(p.parts.count), 1);
  for (std::size_t i = 0; i < p.reliable.size(); ++i) {
    if (p.is_held(i)) may_turn[idx(p.parts.of_vertex[i])] = 0;
  }
  for (const FieldEdge& edge : p.edges) {
    // Where all turn by one angle, a cross on the other sheet turns the other way as seen from
    // here.
    if (edge.mirrored) may_turn[idx(p.parts.of_vertex[idx(edge.from)])] = 0;
  }
  return may_turn;
}

std::vector<std::uint8_t> parts_with_features(const FieldProblem& p) {
  std::vector<std::uint8_t> has_features(idx(p.parts.count), 0);
  for (std::size_t i = 0; i < p.alignment.pulls.size(); ++i) {
    if (std::norm(p.alignment.pulls[i]) > 0) has_features[idx(p.parts.of_vertex[i])] = 1;
  }
  for (const FieldEdge& edge : p.alignment.couplings) {
    has_features[idx(p.parts.of_vertex[idx(edge.from)])] = 1;
    has_features[idx(p.parts.of_vertex[idx(edge.to)])] = 1;
  }
  return has_features;
}

std::vector<FieldEdge> plain_edges(const FieldProblem& p) {
  std::vector<FieldEdge> edges = p.edges;
  for (std::size_t e = 0; e < p.turns.size(); ++e) edges[e] = adjusted(edges[e], -p.turns[e]);
  return edges;
}

}  // namespace illustrate
