// What the tests of the surface share.
#pragma once

#include "mesh/sanitize.h"
#include "surface/refine.h"
#include "tests/cpp/check_surface.h"
#include "tests/cpp/shapes.h"

namespace illustrate::surface_checks {

using check::index;

inline SurfaceOptions at_level(int level, Scheme scheme = Scheme::automatic) {
  SurfaceOptions options;
  options.level = level;
  options.scheme = scheme;
  return options;
}

inline SoundMesh sound(const PolygonMesh& mesh) {
  Counts report;
  return sanitize(mesh, report);
}

inline Surface refined(const std::vector<PolygonMesh>& meshes, const SurfaceOptions& options,
                       Counts& report) {
  std::vector<SoundMesh> sounds;
  for (const PolygonMesh& mesh : meshes) sounds.push_back(sanitize(mesh, report));
  Surface surface = refine(sounds, options, report);
  check_surface(surface);
  return surface;
}

inline Surface refined(const PolygonMesh& mesh, const SurfaceOptions& options) {
  Counts report;
  return refined({mesh}, options, report);
}

inline int count_kind(const Surface& surface, EdgeKind kind) {
  return static_cast<int>(
      std::count(surface.feature_kinds.begin(), surface.feature_kinds.end(), kind));
}

inline Vec3 area_vector(const Surface& surface, int t) {
  const Triangle& triangle = surface.triangles[index(t)];
  const Vec3& a = surface.positions[index(triangle[0])];
  return (surface.positions[index(triangle[1])] - a)
             .cross(surface.positions[index(triangle[2])] - a) /
         2;
}

inline double area(const Surface& surface) {
  double sum = 0;
  for (int t = 0; t < static_cast<int>(surface.triangles.size()); ++t)
    sum += area_vector(surface, t).norm();
  return sum;
}

// Triangles whose own normal contradicts that of a corner.
inline int count_backward(const Surface& surface) {
  int count = 0;
  for (int t = 0; t < static_cast<int>(surface.triangles.size()); ++t) {
    for (int k = 0; k < 3; ++k) {
      const Vec3& normal = surface.normals[index(surface.triangles[index(t)][index(k)])];
      count += surface.corner_sign(t, k) * normal.dot(area_vector(surface, t)) <= 0;
    }
  }
  return count;
}

inline PolygonMesh creased(PolygonMesh mesh, double sharpness) {
  int first = 0;
  for (const int size : mesh.face_sizes) {
    for (int k = 0; k < size; ++k) {
      const int a = mesh.corner_vertices[index(first + k)];
      const int b = mesh.corner_vertices[index(first + (k + 1) % size)];
      if (a > b) continue;
      mesh.edge_vertices.push_back({a, b});
      mesh.edge_sharpness.push_back(sharpness);
    }
    first += size;
  }
  return mesh;
}

inline PolygonMesh bumpy_plane(int n) {
  return shapes::height_field(
      n, n, [](double x, double y) { return .3 * std::sin(3 * x + y * y) + .2 * x * y; });
}

}  // namespace illustrate::surface_checks
