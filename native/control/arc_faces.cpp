#include "control/arc_faces.h"

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
  ArcMaker(const HalfEdges& parent, Points points, Scheme scheme)
      : edges_(parent),
        faces_(parent.faces),
        places_(std::move(points)),
        edge_points_(static_cast<int>(places_.size()) - parent.edge_count()),
        quads_(scheme == Scheme::catmull_clark) {
    if (quads_) edge_points_ -= faces_.size();
  }

  ArcFaces run(std::vector<double> weights) {
    for (int f = 0; f < faces_.size(); ++f) quads_ ? add_quads(read(f)) : add_triangles(read(f));
    spread(weights);
    return {std::move(places_), std::move(sags_), std::move(weights)};
  }

 private:
  const Vec3& place(int vertex) const { return places_[idx(vertex)]; }

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
        sags_.push_back(sag);
    }
  }

  // In a quadratic patch curves that run along an edge have its sag, those of half its length a
  // quarter of it.
  void add_triangles(const ParentFace& face) {
    for (std::size_t k = 0; k < 3; ++k) {
      for (const std::size_t along : {k, (k + 1) % 3, (k + 2) % 3})
        sags_.push_back(face.sags[along] / 4);
    }
    for (const std::size_t along : {2, 0, 1}) sags_.push_back(face.sags[along] / 4);
  }

  void spread(std::vector<double>& weights) const {
    for (const int h : edges_.first)
      weights.push_back((weights[idx(faces_.corners[idx(h)])] + weights[idx(faces_.head(h))]) / 2);
    for (int f = 0; quads_ && f < faces_.size(); ++f) {
      double sum = 0;
      for (const int v : faces_[f]) sum += weights[idx(v)];
      weights.push_back(sum / static_cast<double>(faces_[f].size()));
    }
  }

  const HalfEdges& edges_;
  const Faces& faces_;
  Points places_, sags_;
  int edge_points_;  // first of them
  bool quads_;
};

// Share of each corner, and of the arc of each edge, edge k leaving corner k.
struct Shares {
  std::array<double, 4> corners, edges;
};

Shares shares_of_triangle(const Vec2& uv) {
  const double u = uv.x(), v = uv.y(), w = 1 - u - v;
  return {{w, u, v, 0}, {4 * w * u, 4 * u * v, 4 * v * w, 0}};
}

Shares shares_of_quad(const Vec2& uv) {
  const double u = uv.x(), v = uv.y(), along = 4 * u * (1 - u), across = 4 * v * (1 - v);
  return {{(1 - u) * (1 - v), u * (1 - v), u * v, (1 - u) * v},
          {along * (1 - v), across * u, along * v, across * (1 - u)}};
}

}  // namespace

ArcFaces arc_faces(const HalfEdges& parent, Points points, std::vector<double> weights,
                   Scheme scheme) {
  return ArcMaker(parent, std::move(points), scheme).run(std::move(weights));
}

ArcPoint evaluate(const ArcFaces& arcs, Span<const int> vertices, int first, const Vec2& uv) {
  const Shares shares = vertices.size() == 3 ? shares_of_triangle(uv) : shares_of_quad(uv);
  ArcPoint point{Vec3::Zero(), 0};
  for (std::size_t k = 0; k < vertices.size(); ++k) {
    const std::size_t vertex = idx(vertices[k]), corner = idx(first) + k;
    point.position += shares.corners[k] * arcs.places[vertex] + shares.edges[k] * arcs.sags[corner];
    point.weight += shares.corners[k] * arcs.weights[vertex];
  }
  return point;
}

}  // namespace illustrate
