#include "pipeline/same_input.h"

#include <cstring>
#include <tuple>

namespace illustrate {
namespace {

// By bytes, not by value: NaN is the same as NaN.
template <class T>
bool same_bytes(const std::vector<T>& a, const std::vector<T>& b) {
  return a.size() == b.size() &&
         (a.empty() || std::memcmp(static_cast<const void*>(a.data()),
                                   static_cast<const void*>(b.data()), a.size() * sizeof(T)) == 0);
}

bool is_same(const std::vector<Guide>& a, const std::vector<Guide>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const Guide& x, const Guide& y) {
    return x.weight == y.weight && same_bytes(x.points, y.points);
  });
}

}  // namespace

bool has_same_form(const PolygonMesh& a, const PolygonMesh& b) {
  const auto settings = [](const PolygonMesh& m) {
    return std::tie(m.cage, m.boundary, m.crease_angle_deg, m.scheme, m.level);
  };
  return settings(a) == settings(b) && a.positions.size() == b.positions.size() &&
         same_bytes(a.face_sizes, b.face_sizes) &&
         same_bytes(a.corner_vertices, b.corner_vertices) &&
         same_bytes(a.edge_vertices, b.edge_vertices) &&
         same_bytes(a.edge_sharpness, b.edge_sharpness) &&
         same_bytes(a.vertex_sharpness, b.vertex_sharpness) &&
         same_bytes(a.marked_edges, b.marked_edges) && same_bytes(a.loose_edges, b.loose_edges) &&
         same_bytes(a.face_materials, b.face_materials) && same_bytes(a.hole_faces, b.hole_faces);
}

bool has_same_place(const PolygonMesh& a, const PolygonMesh& b) {
  return same_bytes(a.positions, b.positions) && same_bytes(a.corner_normals, b.corner_normals);
}

bool is_same(const PolygonMesh& a, const PolygonMesh& b) {
  return a.edge_length == b.edge_length && a.name == b.name && a.placement == b.placement &&
         !a.original == !b.original && has_same_place(a, b) && has_same_form(a, b);
}

bool is_same(const SurfaceOptions& a, const SurfaceOptions& b) {
  return a.scheme == b.scheme && a.level == b.level && a.edge_length == b.edge_length &&
         a.triangle_budget == b.triangle_budget;
}

bool is_same(const JetOptions& a, const JetOptions& b) { return a.rings == b.rings; }

bool is_same(const FieldOptions& a, const FieldOptions& b) {
  const auto values = [](const FieldOptions& o) {
    return std::make_tuple(o.parabolic_ratio, o.least_curvature, o.largest_energy,
                           o.alignment_weight, o.inverse_length_weights, o.start, o.guide_radius,
                           o.max_evaluations);
  };
  return values(a) == values(b) && a.default_direction == b.default_direction &&
         is_same(a.guides, b.guides) &&
         same_bytes(a.singularities.positions, b.singularities.positions) &&
         same_bytes(a.singularities.indices, b.singularities.indices);
}

}  // namespace illustrate
