#include "surface/joined.h"

#include <algorithm>

namespace illustrate {
namespace {

std::vector<int> first_of_each(const std::vector<int>& objects, std::size_t count) {
  std::vector<int> first(count + 1, 0);
  for (const int object : objects) ++first[idx(object) + 1];
  for (std::size_t o = 0; o < count; ++o) first[o + 1] += first[o];
  return first;
}

PrincipalCurvature placed(PrincipalCurvature curvature, const Move& place) {
  curvature.k1 /= place.scale();
  curvature.k2 /= place.scale();
  curvature.w1 = place.direction(curvature.w1);
  curvature.w2 = place.direction(curvature.w2);
  return curvature;
}

// A surface that objects are taken from, and where they begin.
struct Source {
  explicit Source(const Surface& from)
      : surface(from),
        first_vertex(first_vertices(from)),
        first_triangle(first_triangles(from)),
        features(from.object_is_smooth.size()) {
    for (std::size_t e = 0; e < from.feature_edges.size(); ++e) {
      const int object = from.objects[idx(from.feature_edges[e][0])];
      features[idx(object)].push_back(e);
    }
  }

  // Of the first flat face of an object among all: they stand object after object.
  int first_plane(int object) const {
    const auto is_earlier = [](const PlaneFace& plane, int other) { return plane.object < other; };
    const auto first =
        std::lower_bound(surface.planes.begin(), surface.planes.end(), object, is_earlier);
    return static_cast<int>(first - surface.planes.begin());
  }

  const Surface& surface;
  std::vector<int> first_vertex, first_triangle;   // (objects + 1)
  std::vector<std::vector<std::size_t>> features;  // (objects) edges
};

// Appends one object after another.
class Joiner {
 public:
  explicit Joiner(Surface& to) : to_(to) {}

  void add(const Source& source, int object, const Similarity& similarity) {
    const Move place(similarity);
    object_ = static_cast<int>(to_.object_is_smooth.size());
    const Surface& from = source.surface;
    const PlacedControl& control = from.controls[idx(object)];
    vertex_shift_ = static_cast<int>(to_.positions.size()) - source.first_vertex[idx(object)];
    triangle_shift_ = static_cast<int>(to_.triangles.size()) - source.first_triangle[idx(object)];
    ptex_shift_ = next_ptex_face_ - control.first_ptex_face;
    plane_shift_ = static_cast<int>(to_.planes.size()) - source.first_plane(object);
    for (int v = source.first_vertex[idx(object)]; v < source.first_vertex[idx(object) + 1]; ++v) {
      add_vertex(from, idx(v), place);
    }
    const int end = source.first_triangle[idx(object) + 1];
    for (int t = source.first_triangle[idx(object)]; t < end; ++t) add_triangle(from, idx(t));
    for (const std::size_t e : source.features[idx(object)]) add_feature(from, e);
    add_planes(source, object, place);
    to_.object_is_smooth.push_back(from.object_is_smooth[idx(object)]);
    to_.controls.push_back({control.mesh, next_ptex_face_, similarity * control.placement});
    next_ptex_face_ += control.mesh->ptex_faces;
  }

 private:
  void add_vertex(const Surface& from, std::size_t v, const Move& place) {
    if (from.is_tip(static_cast<int>(v)))
      to_.tips.push_back(static_cast<int>(to_.positions.size()));
    to_.positions.push_back(place.point(from.positions[v]));
    to_.normals.push_back(place.direction(from.normals[v]));
    to_.objects.push_back(object_);
    to_.places.push_back(from.places[v] + vertex_shift_);
    const int face = from.base_faces[v];
    to_.base_faces.push_back(face == none ? none : face + ptex_shift_);
    to_.base_uv.push_back(from.base_uv[v]);
    to_.curvature.push_back(placed(from.curvature[v], place));
  }

  void add_triangle(const Surface& from, std::size_t t) {
    Triangle triangle = from.triangles[t];
    std::array<int, 3> neighbours = from.neighbours[t];
    for (int& vertex : triangle) vertex += vertex_shift_;
    for (int& neighbour : neighbours) neighbour += neighbour == none ? 0 : triangle_shift_;
    PatchTriangle patch = from.patches[t];
    patch.ptex_face += patch.ptex_face == none ? 0 : ptex_shift_;
    to_.triangles.push_back(triangle);
    to_.neighbours.push_back(neighbours);
    to_.patches.push_back(patch);
    to_.flips.push_back(from.flips[t]);
    to_.edge_kinds.push_back(from.edge_kinds[t]);
    const int plane = from.planes.empty() ? none : from.triangle_planes[t];
    to_.triangle_planes.push_back(plane == none ? none : plane + plane_shift_);
    to_.triangle_faces.push_back(from.triangle_faces[t]);
    to_.triangle_objects.push_back(object_);
  }

  void add_planes(const Source& source, int object, const Move& place) {
    for (int p = source.first_plane(object); p < source.first_plane(object + 1); ++p) {
      PlaneFace plane = source.surface.planes[idx(p)];
      plane.object = object_;
      plane.normal = place.direction(plane.normal);
      plane.direction = place.direction(plane.direction);
      plane.centre = place.point(plane.centre);
      plane.half *= place.scale();
      plane.rim_length *= place.scale();
      to_.planes.push_back(plane);
    }
  }

  void add_feature(const Surface& from, std::size_t e) {
    const auto [a, b] = from.feature_edges[e];
    to_.feature_edges.push_back({a + vertex_shift_, b + vertex_shift_});
    to_.feature_kinds.push_back(from.feature_kinds[e]);
  }

  Surface& to_;
  int object_ = 0, vertex_shift_ = 0, triangle_shift_ = 0, ptex_shift_ = 0, plane_shift_ = 0,
      next_ptex_face_ = 0;
};

}  // namespace

std::vector<int> first_vertices(const Surface& surface) {
  return first_of_each(surface.objects, surface.object_is_smooth.size());
}

std::vector<int> first_triangles(const Surface& surface) {
  return first_of_each(surface.triangle_objects, surface.object_is_smooth.size());
}

ObjectSources objects_as_they_are(const std::vector<int>& objects) {
  ObjectSources sources;
  for (const int object : objects) sources.push_back({0, object, {}});
  return sources;
}

Surface joined(const std::vector<const Surface*>& surfaces, const ObjectSources& sources) {
  std::vector<Source> from;
  for (const Surface* one : surfaces) from.emplace_back(*one);
  Surface surface;
  Joiner joiner(surface);
  for (const ObjectSource& source : sources) {
    joiner.add(from[idx(source.surface)], source.object, source.place);
  }
  measure_diagonals(surface);
  return surface;
}

Curvature joined(const std::vector<const Curvature*>& curvatures,
                 const std::vector<const Surface*>& surfaces, const ObjectSources& sources) {
  Curvature result;
  visit_sources(surfaces, sources, first_vertices,
                [&](const ObjectSource& source, int begin, int end) {
                  const Curvature& from = *curvatures[idx(source.surface)];
                  const Move move(source.place);
                  for (int v = begin; v < end; ++v) result.push_back(placed(from[idx(v)], move));
                });
  return result;
}

}  // namespace illustrate
