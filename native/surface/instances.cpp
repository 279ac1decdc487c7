#include "surface/instances.h"

#include <algorithm>

namespace illustrate {
namespace {

std::vector<int> first_of_each(const std::vector<int>& objects, std::size_t count) {
  std::vector<int> first(count + 1, 0);
  for (const int object : objects) ++first[idx(object) + 1];
  for (std::size_t o = 0; o < count; ++o) first[o + 1] += first[o];
  return first;
}

PrincipalCurvature placed(PrincipalCurvature curvature, const Similarity& place) {
  curvature.k1 /= place.scale;
  curvature.k2 /= place.scale;
  curvature.w1 = place.direction(curvature.w1);
  curvature.w2 = place.direction(curvature.w2);
  return curvature;
}

// Appends one object after another.
class Placer {
 public:
  Placer(const Surface& from, Surface& to)
      : from_(from),
        to_(to),
        first_vertices_(first_vertices(from)),
        first_triangles_(first_triangles(from)),
        features_(features_of_objects()) {}

  void add(int original, const Similarity& place) {
    object_ = static_cast<int>(to_.object_is_smooth.size());
    vertex_shift_ = static_cast<int>(to_.positions.size()) - first_vertices_[idx(original)];
    triangle_shift_ = static_cast<int>(to_.triangles.size()) - first_triangles_[idx(original)];
    const PlacedControl& control = from_.controls[idx(original)];
    ptex_shift_ = next_ptex_face_ - control.first_ptex_face;
    plane_shift_ = static_cast<int>(to_.planes.size()) - first_plane(original);
    for (int v = first_vertices_[idx(original)]; v < first_vertices_[idx(original) + 1]; ++v) {
      add_vertex(idx(v), place);
    }
    for (int t = first_triangles_[idx(original)]; t < first_triangles_[idx(original) + 1]; ++t) {
      add_triangle(idx(t));
    }
    for (const int e : features_[idx(original)]) add_feature(idx(e));
    add_planes(original, place);
    to_.object_is_smooth.push_back(from_.object_is_smooth[idx(original)]);
    to_.controls.push_back({control.mesh, next_ptex_face_, original, place});
    next_ptex_face_ += control.mesh->ptex_faces;
  }

 private:
  std::vector<std::vector<int>> features_of_objects() const {
    std::vector<std::vector<int>> features(from_.object_is_smooth.size());
    for (std::size_t e = 0; e < from_.feature_edges.size(); ++e) {
      const int object = from_.objects[idx(from_.feature_edges[e][0])];
      features[idx(object)].push_back(static_cast<int>(e));
    }
    return features;
  }

  void add_vertex(std::size_t v, const Similarity& place) {
    if (from_.is_tip(static_cast<int>(v)))
      to_.tips.push_back(static_cast<int>(to_.positions.size()));
    to_.positions.push_back(place.point(from_.positions[v]));
    to_.normals.push_back(place.direction(from_.normals[v]));
    to_.objects.push_back(object_);
    to_.places.push_back(from_.places[v] + vertex_shift_);
    const int face = from_.base_faces[v];
    to_.base_faces.push_back(face == none ? none : face + ptex_shift_);
    to_.base_uv.push_back(from_.base_uv[v]);
    to_.curvature.push_back(placed(from_.curvature[v], place));
  }

  void add_triangle(std::size_t t) {
    Triangle triangle = from_.triangles[t];
    std::array<int, 3> neighbours = from_.neighbours[t];
    for (int& vertex : triangle) vertex += vertex_shift_;
    for (int& neighbour : neighbours) neighbour += neighbour == none ? 0 : triangle_shift_;
    PatchTriangle patch = from_.patches[t];
    patch.ptex_face += patch.ptex_face == none ? 0 : ptex_shift_;
    to_.triangles.push_back(triangle);
    to_.neighbours.push_back(neighbours);
    to_.patches.push_back(patch);
    to_.flips.push_back(from_.flips[t]);
    to_.edge_kinds.push_back(from_.edge_kinds[t]);
    const int plane = from_.planes.empty() ? none : from_.triangle_planes[t];
    to_.triangle_planes.push_back(plane == none ? none : plane + plane_shift_);
    to_.triangle_faces.push_back(from_.triangle_faces[t]);
    to_.triangle_objects.push_back(object_);
  }

  void add_planes(int original, const Similarity& place) {
    for (std::size_t p = idx(first_plane(original)); p < idx(first_plane(original + 1)); ++p) {
      PlaneFace plane = from_.planes[p];
      plane.object = object_;
      plane.normal = place.direction(plane.normal);
      plane.direction = place.direction(plane.direction);
      plane.centre = place.point(plane.centre);
      plane.half *= place.scale;
      plane.rim_length *= place.scale;
      to_.planes.push_back(plane);
    }
  }

  // Of the first flat face of an original among all.
  int first_plane(int original) const {
    // They stand object after object.
    const auto is_earlier = [](const PlaneFace& plane, int object) {
      return plane.object < object;
    };
    const auto first =
        std::lower_bound(from_.planes.begin(), from_.planes.end(), original, is_earlier);
    return static_cast<int>(first - from_.planes.begin());
  }

  void add_feature(std::size_t e) {
    const auto [a, b] = from_.feature_edges[e];
    to_.feature_edges.push_back({a + vertex_shift_, b + vertex_shift_});
    to_.feature_kinds.push_back(from_.feature_kinds[e]);
  }

  const Surface& from_;
  Surface& to_;
  std::vector<int> first_vertices_, first_triangles_;
  std::vector<std::vector<int>> features_;  // (originals)
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

Surface placed(const Surface& originals, const Instances& instances) {
  Surface surface;
  Placer placer(originals, surface);
  for (std::size_t o = 0; o < instances.originals.size(); ++o) {
    placer.add(instances.originals[o], instances.placements[o]);
  }
  measure_diagonals(surface);
  return surface;
}

Curvature placed(const Curvature& curvature, const Surface& originals, const Instances& instances) {
  const std::vector<int> first = first_vertices(originals);
  Curvature result;
  for (std::size_t o = 0; o < instances.originals.size(); ++o) {
    const std::size_t original = idx(instances.originals[o]);
    for (int v = first[original]; v < first[original + 1]; ++v) {
      result.push_back(placed(curvature[idx(v)], instances.placements[o]));
    }
  }
  return result;
}

}  // namespace illustrate
