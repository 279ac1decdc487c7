#include "control/arc_faces.h"

#include "control/split_values.h"

namespace illustrate {
namespace {

// Of one face of the parent; edge k leaves corner k.
struct ParentFace {
  Points middles, sags;  // of edges
  Vec3 centre;           // of quads and other faces that are split round it

  std::size_t size() const { return sags.size(); }
};

class ArcMaker {
 public:
  ArcMaker(const HalfEdges& parent, Points points, std::vector<double> weights, Scheme scheme)
      : edges_(parent),
        faces_(parent.faces),
        edge_points_(static_cast<int>(weights.size())),
        quads_(scheme == Scheme::catmull_clark),
        arcs_{std::move(points), {}, std::move(weights)} {}

  ArcFaces run() {
    for (int f = 0; f < faces_.size(); ++f) quads_ ? add_quads(read(f)) : add_triangles(read(f));
    append_means(edges_, arcs_.places.size(), arcs_.weights);
    return std::move(arcs_);
  }

 private:
  const Vec3& place(int vertex) const { return arcs_.places[idx(vertex)]; }

  ParentFace read(int f) const {
    ParentFace face;
    for (int h = faces_.offsets[idx(f)]; h < faces_.offsets[idx(f) + 1]; ++h) {
      const Vec3& middle = place(edge_points_ + edges_.edges[idx(h)]);
      face.middles.push_back(middle);
      face.sags.push_back(middle - (place(faces_.corners[idx(h)]) + place(faces_.head(h))) / 2);
    }
    if (quads_) face.centre = place(edge_points_ + edges_.edge_count() + f);
    return face;
  }

  // The sag of the curve from the middle of edge k to the centre: of a quad that of half the curve
  // to the opposite edge, of other faces as if there were one.
  static Vec3 inner_sag(const ParentFace& face, std::size_t k) {
    const std::size_t n = face.size();
    if (n == 4) return (face.centre - (face.middles[k] + face.middles[(k + 2) % 4]) / 2) / 4;
    Vec3 mean = Vec3::Zero();
    for (const Vec3& middle : face.middles) mean += middle / static_cast<double>(n);
    return (face.centre - mean) / 4;
  }

  // Half of a parabola has a quarter of its sag.
  void add_quads(const ParentFace& face) {
    const std::size_t n = face.size();
    for (std::size_t k = 0; k < n; ++k) {
      const std::size_t before = (k + n - 1) % n;
      for (const Vec3& sag : {Vec3(face.sags[k] / 4), inner_sag(face, k), inner_sag(face, before),
                              Vec3(face.sags[before] / 4)})
        arcs_.sags.push_back(sag);
    }
  }

  // In a quadratic patch curves that run along an edge have its sag, those of half its length a
  // quarter of it.
  void add_triangles(const ParentFace& face) {
    for (std::size_t k = 0; k < 3; ++k) {
      for (const std::size_t along : {k, (k + 1) % 3, (k + 2) % 3})
        arcs_.sags.push_back(face.sags[along] / 4);
    }
    for (const std::size_t along : {2, 0, 1}) arcs_.sags.push_back(face.sags[along] / 4);
  }

  const HalfEdges& edges_;
  const Faces& faces_;
  int edge_points_;  // first of them, after the parent's vertices
  bool quads_;
  ArcFaces arcs_;
};

// Corners, sags of the edges that leave them, and weights.
struct Patch {
  std::array<Vec3, 4> p, s;
  std::array<double, 4> weights;
};

ArcPoint on_triangle(const Patch& patch, double u, double v) {
  const auto& [p, s, weights] = patch;
  const double w = 1 - u - v;
  ArcPoint point;
  point.position =
      w * p[0] + u * p[1] + v * p[2] + 4 * (w * u * s[0] + u * v * s[1] + v * w * s[2]);
  point.du = p[1] - p[0] + 4 * ((w - u) * s[0] + v * s[1] - v * s[2]);
  point.dv = p[2] - p[0] + 4 * (-u * s[0] + u * s[1] + (w - v) * s[2]);
  point.duu = -8 * s[0];
  point.duv = 4 * (s[1] - s[0] - s[2]);
  point.dvv = -8 * s[2];
  point.weight = w * weights[0] + u * weights[1] + v * weights[2];
  return point;
}

ArcPoint on_quad(const Patch& patch, double u, double v) {
  const auto& [p, s, weights] = patch;
  const Vec3 along = (1 - v) * s[0] + v * s[2], across = (1 - u) * s[3] + u * s[1];
  const Vec3 low = (1 - u) * p[0] + u * p[1], high = (1 - u) * p[3] + u * p[2];
  ArcPoint point;
  point.position = (1 - v) * low + v * high + 4 * (u * (1 - u) * along + v * (1 - v) * across);
  point.du = (1 - v) * (p[1] - p[0]) + v * (p[2] - p[3]) +
             4 * ((1 - 2 * u) * along + v * (1 - v) * (s[1] - s[3]));
  point.dv = high - low + 4 * (u * (1 - u) * (s[2] - s[0]) + (1 - 2 * v) * across);
  point.duu = -8 * along;
  point.duv =
      p[0] - p[1] + p[2] - p[3] + 4 * ((1 - 2 * u) * (s[2] - s[0]) + (1 - 2 * v) * (s[1] - s[3]));
  point.dvv = -8 * across;
  point.weight = (1 - v) * ((1 - u) * weights[0] + u * weights[1]) +
                 v * ((1 - u) * weights[3] + u * weights[2]);
  return point;
}

}  // namespace

ArcFaces arc_faces(const HalfEdges& parent, Points points, std::vector<double> weights,
                   Scheme scheme) {
  return ArcMaker(parent, std::move(points), std::move(weights), scheme).run();
}

ArcPoint evaluate(const ArcFaces& arcs, Span<const int> vertices, int first, const Vec2& uv) {
  Patch patch;
  for (std::size_t k = 0; k < vertices.size(); ++k) {
    patch.p[k] = arcs.places[idx(vertices[k])];
    patch.s[k] = arcs.sags[idx(first) + k];
    patch.weights[k] = arcs.weights[idx(vertices[k])];
  }
  return vertices.size() == 3 ? on_triangle(patch, uv.x(), uv.y()) : on_quad(patch, uv.x(), uv.y());
}

}  // namespace illustrate
