#include "field/families/families.h"

#include <algorithm>
#include <cmath>

#include "field/families/last_families.h"
#include "field/families/signed_labels.h"
#include "field/families/smooth_bends.h"

namespace illustrate {
namespace {

// What decides where the form does not, as bends in diagonals of a piece: its longer way, then the
// upright, then the side of its first triangle.
constexpr double worth_of_length = 1e-2;
constexpr double worth_of_upright = 1e-3;
constexpr double worth_of_first_side = 1e-4;

class FamilyProblem {
 public:
  FamilyProblem(const Surface& surface, const CrossField& field, const Progress& progress)
      : surface_(surface),
        field_(field),
        edges_(triangle_edges(surface, progress)),
        cells_(dual_cells(surface, edges_)),
        links_(dual_links(surface, edges_, cells_)) {}

  SignedGraph graph(const Curvature& curvature, const Progress& progress) const {
    SignedGraph graph = ties();
    const Ragged<int> pieces = connected_nodes(graph);
    std::vector<double> diagonals;
    for (std::size_t p = 0; p < pieces.size(); ++p) diagonals.push_back(diagonal_of(pieces[p]));
    const std::vector<Vec2> bends =
        smooth_bends(surface_, curvature, field_, links_, cells_, pieces, diagonals, progress);
    for (std::size_t v = 0; v < graph.size(); ++v) {
      graph.pulls[v] = cells_.areas[v] * (bends[v][0] - bends[v][1]);
    }
    const std::vector<int> first_sides = first_sides_of(pieces);
    for (std::size_t p = 0; p < pieces.size(); ++p) {
      if (diagonals[p] > 0) decide_ties(pieces[p], diagonals[p], first_sides[p], graph.pulls);
    }
    return graph;
  }

 private:
  Vec3 across(std::size_t v) const { return illustrate::across(surface_, field_, v); }

  // Both ends of an edge keep directions that agree.
  SignedGraph ties() const {
    SignedGraph graph;
    graph.pulls.assign(surface_.positions.size(), 0);
    graph.links.values.reserve(links_.values.size());
    for (std::size_t v = 0; v < links_.size(); ++v) {
      for (const DualLink& link : links_[v]) {
        const double sign = agree(v, idx(link.vertex)) ? 1 : -1;
        graph.links.push({link.vertex, sign * link.length});
      }
      graph.links.close_list();
    }
    return graph;
  }

  // Whether the `directions` of two vertices are of one family rather than of two; the same from
  // both, and whichever direction stands for a cross.
  bool agree(std::size_t v, std::size_t w) const {
    const Vec3 &d = field_.directions[v], &e = field_.directions[w], across_v = across(v),
               across_w = across(w);
    const auto square = [](double x) { return x * x; };
    return square(d.dot(e)) + square(across_v.dot(across_w)) >=
           square(d.dot(across_w)) + square(across_v.dot(e));
  }

  double diagonal_of(Span<const int> piece) const {
    Eigen::AlignedBox3d box;
    for (const int v : piece) box.extend(surface_.positions[idx(v)]);
    return box.isEmpty() ? 0 : box.diagonal().norm();
  }

  // (pieces) the first triangle that has a vertex of each.
  std::vector<int> first_sides_of(const Ragged<int>& pieces) const {
    std::vector<int> piece_of(surface_.positions.size(), none);
    for (std::size_t p = 0; p < pieces.size(); ++p) {
      for (const int v : pieces[p]) piece_of[idx(v)] = static_cast<int>(p);
    }
    std::vector<int> result(pieces.size(), none);
    // Backwards: the first triangle of a piece is the last to be written down.
    for (std::size_t t = surface_.triangles.size(); t-- > 0;) {
      result[idx(piece_of[idx(surface_.triangles[t][0])])] = static_cast<int>(t);
    }
    return result;
  }

  // Second moments of a piece about its middle, over their sum.
  Mat3 moments_of(Span<const int> piece) const {
    Vec3 middle = Vec3::Zero();
    double area = 0;
    for (const int v : piece) {
      middle += cells_.areas[idx(v)] * surface_.positions[idx(v)];
      area += cells_.areas[idx(v)];
    }
    if (!(area > 0)) return Mat3::Zero();
    middle /= area;
    Mat3 sum = Mat3::Zero();
    for (const int v : piece) {
      const Vec3 offset = surface_.positions[idx(v)] - middle;
      sum += cells_.areas[idx(v)] * offset * offset.transpose();
    }
    return sum.trace() > 0 ? Mat3(sum / sum.trace()) : Mat3::Zero();
  }

  void decide_ties(Span<const int> piece, double diagonal, int first_triangle,
                   std::vector<double>& pulls) const {
    if (first_triangle == none) return;
    const Triangle& first = surface_.triangles[idx(first_triangle)];
    const Vec3 side =
        (surface_.positions[idx(first[1])] - surface_.positions[idx(first[0])]).normalized();
    const Mat3 wish = worth_of_length * moments_of(piece) +
                      worth_of_upright * Vec3::UnitZ() * Vec3::UnitZ().transpose() +
                      worth_of_first_side * side * side.transpose();
    for (const int v : piece) {
      const Vec3 &d = field_.directions[idx(v)], e = across(idx(v));
      pulls[idx(v)] += cells_.areas[idx(v)] / diagonal * (d.dot(wish * d) - e.dot(wish * e));
    }
  }

  const Surface& surface_;
  const CrossField& field_;
  TriangleEdges edges_;
  DualCells cells_;
  Ragged<DualLink> links_;
};

}  // namespace

Families find_families(const Surface& surface, const Curvature& curvature, const CrossField& field,
                       const LastFamilies& last, int threads, const Progress& progress) {
  const FamilyProblem problem(surface, field, progress.part(0, 0.1));
  const SignedGraph graph = problem.graph(curvature, progress.part(0.1, 0.4));
  const Families before = last_families(surface, field, last);
  const bool is_first = before.empty();
  const Families labels = cheap_labels(graph, threads, progress.part(0.4, 1), before);
  return is_first ? labels : nearby_labels(graph, labels);
}

double kept_share(const Surface& surface, const CrossField& field, const Families& families,
                  const SurfacePoint& at, const Vec3& tangent) {
  const Triangle& vertices = surface.triangles[idx(at.triangle)];
  const std::array<double, 3> weights{1 - at.b1 - at.b2, at.b1, at.b2};
  double share = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t v = idx(vertices[k]);
    const double along = field.directions[v].dot(tangent);
    const double aside = across(surface, field, v).dot(tangent);
    const double sum = along * along + aside * aside;
    if (sum > 0) share += weights[k] * families[v] * (along * along - aside * aside) / sum;
  }
  return share;
}

}  // namespace illustrate
