// Shapes with known answers, for all tests: polygon meshes from formulas, and plain surfaces with
// analytic normals and curvature.
#pragma once

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "core/pi.h"
#include "mesh/polygon_mesh.h"
#include "surface/surface.h"

namespace illustrate::shapes {

// --- polygon meshes

inline void add_face(PolygonMesh& mesh, const std::vector<int>& corners) {
  mesh.face_sizes.push_back(static_cast<int>(corners.size()));
  mesh.corner_vertices.insert(mesh.corner_vertices.end(), corners.begin(), corners.end());
}

inline PolygonMesh polygon_mesh(Points positions, const std::vector<std::vector<int>>& faces) {
  PolygonMesh mesh;
  mesh.positions = std::move(positions);
  for (const auto& face : faces) add_face(mesh, face);
  return mesh;
}

// Side 2, centre 0, six quads, outward.
inline PolygonMesh cube() {
  Points corners;
  for (int i = 0; i < 8; ++i) corners.emplace_back(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
  return polygon_mesh(
      std::move(corners),
      {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}});
}

// Four corners of cube(), outward.
inline PolygonMesh tetrahedron() {
  return polygon_mesh({{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}},
                      {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}});
}

// m x n quads; vertex(i, j) names the vertex of grid corner (i, j), 0 <= i <= m, 0 <= j <= n.
template <class Vertex>
PolygonMesh quads(int m, int n, Points positions, const Vertex& vertex) {
  PolygonMesh mesh;
  mesh.positions = std::move(positions);
  for (int i = 0; i < m; ++i)
    for (int j = 0; j < n; ++j)
      add_face(mesh, {vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1)});
  return mesh;
}

// Every quad cut along the same diagonal: on a regular mesh every vertex has six neighbours.
inline PolygonMesh split_the_same_way(const PolygonMesh& quads) {
  PolygonMesh mesh;
  mesh.positions = quads.positions;
  for (std::size_t f = 0; f < quads.face_sizes.size(); ++f) {
    const int* c = quads.corner_vertices.data() + 4 * f;
    add_face(mesh, {c[0], c[1], c[2]});
    add_face(mesh, {c[0], c[2], c[3]});
  }
  return mesh;
}

// z = height(x, y) over [-1, 1]^2, facing +z, open.
template <class Height>
PolygonMesh height_field(int m, int n, const Height& height) {
  Points positions;
  for (int i = 0; i <= m; ++i)
    for (int j = 0; j <= n; ++j) {
      const double x = 2.0 * i / m - 1, y = 2.0 * j / n - 1;
      positions.emplace_back(x, y, height(x, y));
    }
  return quads(m, n, std::move(positions), [n](int i, int j) { return i * (n + 1) + j; });
}

inline PolygonMesh plane(int m, int n) {
  return height_field(m, n, [](double, double) { return 0.0; });
}

inline Vec3 torus_point(double R, double r, double u, double v) {
  return {(R + r * std::cos(v)) * std::cos(u), (R + r * std::cos(v)) * std::sin(u),
          r * std::sin(v)};
}

// Axis z, core radius R, tube radius r, m quads round the axis, n round the tube, outward.
inline PolygonMesh torus_mesh(double R, double r, int m, int n) {
  Points positions;
  for (int i = 0; i < m; ++i)
    for (int j = 0; j < n; ++j)
      positions.push_back(torus_point(R, r, 2 * pi * i / m, 2 * pi * j / n));
  return quads(m, n, std::move(positions), [m, n](int i, int j) { return i % m * n + j % n; });
}

// m quads along the band, n across, one half turn: one side, one boundary.
inline PolygonMesh moebius_mesh(int m, int n) {
  Points positions;
  for (int i = 0; i < m; ++i)
    for (int j = 0; j <= n; ++j) {
      const double u = 2 * pi * i / m, s = static_cast<double>(j) / n - 0.5;
      const double rho = 1 + s * std::cos(u / 2);
      positions.emplace_back(rho * std::cos(u), rho * std::sin(u), s * std::sin(u / 2));
    }
  return quads(m, n, std::move(positions),
               [m, n](int i, int j) { return i < m ? i * (n + 1) + j : n - j; });
}

// The figure-eight immersion: crosses itself along the circle of radius 2. n even puts vertices on
// that circle.
inline PolygonMesh klein_mesh(int m, int n) {
  Points positions;
  for (int i = 0; i < m; ++i)
    for (int j = 0; j < n; ++j) {
      const double u = 2 * pi * i / m, v = 2 * pi * j / n;
      const double a = std::sin(v), b = std::sin(2 * v), c = std::cos(u / 2), s = std::sin(u / 2);
      const double rho = 2 + c * a - s * b;
      positions.emplace_back(rho * std::cos(u), rho * std::sin(u), s * a + c * b);
    }
  return quads(m, n, std::move(positions),
               [m, n](int i, int j) { return i < m ? i * n + j % n : (n - j) % n; });
}

// Quads with triangles at the poles, axis z, outward.
inline PolygonMesh uv_sphere_mesh(double radius, int segments, int rings) {
  PolygonMesh mesh;
  for (int j = 1; j < rings; ++j)
    for (int i = 0; i < segments; ++i) {
      const double u = 2 * pi * i / segments, v = pi * j / rings;
      mesh.positions.emplace_back(radius * std::sin(v) * std::cos(u),
                                  radius * std::sin(v) * std::sin(u), radius * std::cos(v));
    }
  const int top = segments * (rings - 1), bottom = top + 1;
  mesh.positions.emplace_back(0, 0, radius);
  mesh.positions.emplace_back(0, 0, -radius);
  const auto at = [segments](int i, int j) { return (j - 1) * segments + i % segments; };
  for (int i = 0; i < segments; ++i) {
    add_face(mesh, {top, at(i, 1), at(i + 1, 1)});
    for (int j = 1; j + 1 < rings; ++j)
      add_face(mesh, {at(i, j), at(i, j + 1), at(i + 1, j + 1), at(i + 1, j)});
    add_face(mesh, {at(i, rings - 1), bottom, at(i + 1, rings - 1)});
  }
  return mesh;
}

// n sides round z, from z = -1 to 1, with n-gons at the ends.
inline PolygonMesh drum(int n) {
  PolygonMesh mesh;
  std::vector<int> top, bottom;
  for (int i = 0; i < n; ++i) {
    const double a = 2 * pi * i / n;
    mesh.positions.emplace_back(std::cos(a), std::sin(a), -1);
    mesh.positions.emplace_back(std::cos(a), std::sin(a), 1);
    add_face(mesh, {2 * i, 2 * ((i + 1) % n), 2 * ((i + 1) % n) + 1, 2 * i + 1});
    top.push_back(2 * i + 1);
    bottom.insert(bottom.begin(), 2 * i);
  }
  add_face(mesh, top);
  add_face(mesh, bottom);
  return mesh;
}

inline PolygonMesh octahedron() {
  return polygon_mesh(
      {{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
      {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}, {1, 0, 5}, {2, 1, 5}, {3, 2, 5}, {0, 3, 5}});
}

inline PolygonMesh icosahedron() {
  const double g = (1 + std::sqrt(5.0)) / 2;
  return polygon_mesh(
      {{-1, g, 0},
       {1, g, 0},
       {-1, -g, 0},
       {1, -g, 0},
       {0, -1, g},
       {0, 1, g},
       {0, -1, -g},
       {0, 1, -g},
       {g, 0, -1},
       {g, 0, 1},
       {-g, 0, -1},
       {-g, 0, 1}},
      {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
       {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
       {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}});
}

// Every triangle in four.
inline PolygonMesh split_triangles(const PolygonMesh& mesh) {
  PolygonMesh fine;
  fine.positions = mesh.positions;
  std::map<Edge, int> middles;
  const auto middle = [&](int a, int b) {
    const auto [entry, is_new] = middles.try_emplace(Edge{std::min(a, b), std::max(a, b)},
                                                     static_cast<int>(fine.positions.size()));
    if (is_new) fine.positions.push_back((mesh.positions[a] + mesh.positions[b]) / 2);
    return entry->second;
  };
  for (std::size_t f = 0; f < mesh.face_sizes.size(); ++f) {
    const int a = mesh.corner_vertices[3 * f], b = mesh.corner_vertices[3 * f + 1];
    const int c = mesh.corner_vertices[3 * f + 2];
    const int ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
    for (const auto& face : {Triangle{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}})
      add_face(fine, {face[0], face[1], face[2]});
  }
  return fine;
}

// 20 * 4^level triangles on the sphere, outward.
inline PolygonMesh icosphere_mesh(double radius, int level) {
  PolygonMesh mesh = icosahedron();
  for (int i = 0; i < level; ++i) mesh = split_triangles(mesh);
  for (Vec3& position : mesh.positions) position *= radius / position.norm();
  return mesh;
}

inline PolygonMesh moved(PolygonMesh mesh, const Vec3& offset) {
  for (Vec3& position : mesh.positions) position += offset;
  return mesh;
}

// Every face with the other winding.
inline PolygonMesh turned(PolygonMesh mesh) {
  auto corner = mesh.corner_vertices.begin();
  for (const int size : mesh.face_sizes) {
    std::reverse(corner, corner + size);
    corner += size;
  }
  return mesh;
}

// Both in one mesh, nothing welded. Positions and faces only.
inline PolygonMesh joined(PolygonMesh a, const PolygonMesh& b) {
  const int first = static_cast<int>(a.positions.size());
  a.positions.insert(a.positions.end(), b.positions.begin(), b.positions.end());
  a.face_sizes.insert(a.face_sizes.end(), b.face_sizes.begin(), b.face_sizes.end());
  for (const int vertex : b.corner_vertices) a.corner_vertices.push_back(vertex + first);
  return a;
}

// Every face with vertices of its own.
inline PolygonMesh unwelded(const PolygonMesh& mesh) {
  PolygonMesh loose;
  loose.face_sizes = mesh.face_sizes;
  for (const int vertex : mesh.corner_vertices) {
    loose.corner_vertices.push_back(static_cast<int>(loose.positions.size()));
    loose.positions.push_back(mesh.positions[vertex]);
  }
  return loose;
}

// --- surfaces

// Fills neighbours, and edge_kinds with boundary (one triangle) and smooth. Edges are matched by
// places.
inline void link_neighbours(Surface& surface) {
  const auto count = surface.triangles.size();
  surface.neighbours.assign(count, {none, none, none});
  surface.edge_kinds.assign(count, {EdgeKind::boundary, EdgeKind::boundary, EdgeKind::boundary});
  std::map<Edge, Edge> open;
  for (int t = 0; t < static_cast<int>(count); ++t)
    for (int k = 0; k < 3; ++k) {
      const int a = surface.places[surface.triangles[t][k]];
      const int b = surface.places[surface.triangles[t][next_corner(k)]];
      const Edge key{std::min(a, b), std::max(a, b)};
      const auto found = open.find(key);
      if (found == open.end()) {
        open[key] = {t, k};
        continue;
      }
      const auto [other, j] = found->second;
      surface.neighbours[t][k] = other;
      surface.neighbours[other][j] = t;
      surface.edge_kinds[t][k] = surface.edge_kinds[other][j] = EdgeKind::smooth;
      open.erase(found);
    }
}

// Sizes of everything but positions, normals, triangles; one smooth object, every vertex its own
// place.
inline void complete(Surface& surface) {
  const auto n = surface.positions.size(), t = surface.triangles.size();
  surface.objects.assign(n, 0);
  surface.triangle_planes.assign(t, none);
  surface.places.resize(n);
  for (std::size_t i = 0; i < n; ++i) surface.places[i] = static_cast<int>(i);
  surface.flips.assign(t, 0);
  surface.patches.assign(t, {});
  surface.triangle_objects.assign(t, 0);
  surface.base_faces.assign(n, none);
  surface.base_uv.assign(n, Vec2::Zero());
  surface.object_is_smooth.assign(1, 1);
  surface.controls.assign(1, PlacedControl{std::make_shared<const ControlMesh>(), 0, {}});
  surface.curvature.resize(n);
  measure_diagonals(surface);
  link_neighbours(surface);
}

// Faces as fans of triangles, area-weighted normals, no curvature.
inline Surface plain_surface(const PolygonMesh& mesh) {
  Surface surface;
  surface.positions = mesh.positions;
  surface.normals.assign(mesh.positions.size(), Vec3::Zero());
  const int* corner = mesh.corner_vertices.data();
  for (const int size : mesh.face_sizes) {
    for (int k = 1; k + 1 < size; ++k) {
      surface.triangles.push_back({corner[0], corner[k], corner[k + 1]});
      const Vec3 origin = mesh.positions[corner[0]];
      const Vec3 area =
          (mesh.positions[corner[k]] - origin).cross(mesh.positions[corner[k + 1]] - origin);
      for (const int vertex : surface.triangles.back()) surface.normals[vertex] += area;
    }
    corner += size;
  }
  for (Vec3& normal : surface.normals) normal.normalize();
  complete(surface);
  return surface;
}

// Vertex v's curvatures in directions a and b, in the order that Surface asks for.
inline void set_curvature(Surface& surface, std::size_t v, double ka, const Vec3& a, double kb,
                          const Vec3& b) {
  const bool a_first = std::abs(ka) >= std::abs(kb);
  surface.curvature[v] =
      a_first ? PrincipalCurvature{ka, kb, a, b} : PrincipalCurvature{kb, ka, b, a};
}

// torus_mesh with analytic normals and curvature.
inline Surface torus_surface(double R, double r, int m, int n) {
  Surface surface = plain_surface(torus_mesh(R, r, m, n));
  for (int i = 0; i < m; ++i)
    for (int j = 0; j < n; ++j) {
      const double u = 2 * pi * i / m, v = 2 * pi * j / n;
      const auto vertex = static_cast<std::size_t>(i * n + j);
      const Vec3 out{std::cos(u), std::sin(u), 0}, around{-std::sin(u), std::cos(u), 0};
      surface.normals[vertex] = out * std::cos(v) + Vec3::UnitZ() * std::sin(v);
      const Vec3 up = -out * std::sin(v) + Vec3::UnitZ() * std::cos(v);
      set_curvature(surface, vertex, -1 / r, up, -std::cos(v) / (R + r * std::cos(v)), around);
    }
  return surface;
}

// icosphere_mesh with analytic normals and curvature (its directions are any).
inline Surface sphere_surface(double radius, int level, const Vec3& centre = Vec3::Zero()) {
  Surface surface = plain_surface(moved(icosphere_mesh(radius, level), centre));
  for (std::size_t v = 0; v < surface.positions.size(); ++v) {
    surface.normals[v] = (surface.positions[v] - centre) / radius;
    const Vec3 a = surface.normals[v].unitOrthogonal();
    set_curvature(surface, v, -1 / radius, a, -1 / radius, surface.normals[v].cross(a));
  }
  return surface;
}

template <class T>
void append(std::vector<T>& list, const std::vector<T>& more) {
  list.insert(list.end(), more.begin(), more.end());
}

// Both surfaces as objects of one; every index of b moves on.
inline Surface joined(Surface a, Surface b) {
  const int vertices = static_cast<int>(a.positions.size());
  const int triangles = static_cast<int>(a.triangles.size());
  const int objects = static_cast<int>(a.object_is_smooth.size());
  const int places = a.places.empty() ? 0 : *std::max_element(a.places.begin(), a.places.end()) + 1;
  for (int& object : b.objects) object += objects;
  for (int& object : b.triangle_objects) object += objects;
  for (int& place : b.places) place += places;
  for (Triangle& triangle : b.triangles)
    for (int& vertex : triangle) vertex += vertices;
  for (auto& row : b.neighbours)
    for (int& neighbour : row) neighbour += neighbour == none ? 0 : triangles;
  for (Edge& edge : b.feature_edges)
    for (int& vertex : edge) vertex += vertices;
  append(a.positions, b.positions);
  append(a.normals, b.normals);
  append(a.objects, b.objects);
  append(a.places, b.places);
  append(a.triangles, b.triangles);
  append(a.flips, b.flips);
  append(a.neighbours, b.neighbours);
  append(a.edge_kinds, b.edge_kinds);
  append(a.triangle_objects, b.triangle_objects);
  append(a.triangle_planes, b.triangle_planes);
  append(a.base_faces, b.base_faces);
  append(a.base_uv, b.base_uv);
  append(a.object_is_smooth, b.object_is_smooth);
  append(a.patches, b.patches);
  append(a.controls, b.controls);
  append(a.feature_edges, b.feature_edges);
  append(a.feature_kinds, b.feature_kinds);
  append(a.curvature, b.curvature);
  measure_diagonals(a);
  return a;
}

}  // namespace illustrate::shapes
