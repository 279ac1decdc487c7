// What the tests of the field share: the paper's formula once more, what holds for any field,
// surfaces.
#pragma once

#include <gtest/gtest.h>

#include "field/cross_field.h"
#include "field/problem/energy.h"
#include "field/search/diffusion.h"
#include "tests/cpp/shapes.h"

namespace illustrate::field_checks {

inline FieldOptions all_free() {
  FieldOptions options;
  options.parabolic_ratio = 0;
  options.threads = 1;
  return options;
}

inline std::size_t index_of(int i) { return static_cast<std::size_t>(i); }

// --- the paper's formulas, written down once more ------------------------------------------------

inline double projected_angle(const Vec3& normal, const Vec3& from, const Vec3& to) {
  const Vec3 a = (from - from.dot(normal) * normal).normalized();
  const Vec3 b = (to - to.dot(normal) * normal).normalized();
  return std::atan2(a.cross(b).dot(normal), a.dot(b));
}

// - sum of cos 4((theta_i - phi_ij) - (theta_j - phi_ji)); across sheets the angles at j are turned
// over.
inline double paper_energy(const Surface& surface, const Points& directions,
                           int* edge_count = nullptr) {
  std::map<Edge, double> terms;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    for (int k = 0; k < 3; ++k) {
      const int a = surface.triangles[t][index_of(k)];
      const int b = surface.triangles[t][index_of(next_corner(k))];
      const auto i = index_of(std::min(a, b)), j = index_of(std::max(a, b));
      const Vec3 along = surface.positions[j] - surface.positions[i];
      const double sign = surface.corner_sign(static_cast<int>(t), k) *
                          surface.corner_sign(static_cast<int>(t), next_corner(k));
      const double at_i = projected_angle(surface.normals[i], along, directions[i]);
      const double at_j = projected_angle(surface.normals[j], along, directions[j]);
      terms[{std::min(a, b), std::max(a, b)}] = -std::cos(4 * (at_i - sign * at_j));
    }
  }
  double sum = 0;
  for (const auto& [edge, term] : terms) sum += term;
  if (edge_count) *edge_count = static_cast<int>(terms.size());
  return sum;
}

// What holds for the field of any surface.
inline void check(const Surface& surface, const CrossField& field) {
  const std::size_t n = surface.positions.size();
  ASSERT_EQ(field.theta.size(), n);
  ASSERT_EQ(field.reliable.size(), n);
  for (std::size_t i = 0; i < n; ++i) {
    ASSERT_TRUE(std::isfinite(field.theta[i]));
    ASSERT_NEAR(field.directions[i].norm(), 1, 1e-9);
    ASSERT_NEAR(field.reference[i].norm(), 1, 1e-9);
    if (surface.normals[i].norm() > 0.5) {
      ASSERT_NEAR(field.directions[i].dot(surface.normals[i]), 0, 1e-9);
      ASSERT_NEAR(projected_angle(surface.normals[i], field.reference[i], field.directions[i]),
                  field.theta[i], 1e-9);
    }
  }
  EXPECT_LE(field.energy, field.energy_initial);
  EXPECT_EQ(field.singular_triangles.size(), field.singular_indices.size());
}

inline CrossField solved(const Surface& surface, const FieldOptions& options) {
  CrossField field = solve_cross_field(surface, surface.curvature, options);
  check(surface, field);
  return field;
}

inline int index_sum(const CrossField& field) {
  int sum = 0;
  for (const int index : field.singular_indices) sum += index;
  return sum;
}

// Sine of the angle between a direction and the nearest branch of a cross.
inline double off_cross(const Vec3& cross, const Vec3& normal, const Vec3& direction) {
  return std::min(std::abs(cross.dot(direction)), std::abs(normal.cross(cross).dot(direction)));
}

// --- surfaces ------------------------------------------------------------------------------------

// Open, axis `axis`, radius 1, with analytic normals and curvature.
inline Surface cylinder(int around, int along, const Vec3& axis, double height = 3) {
  const Vec3 x = axis.unitOrthogonal(), y = axis.cross(x);
  Points positions;
  for (int i = 0; i < around; ++i)
    for (int j = 0; j <= along; ++j) {
      const double u = 2 * pi * i / around;
      positions.push_back(std::cos(u) * x + std::sin(u) * y + height * j / along * axis);
    }
  Surface surface = shapes::plain_surface(shapes::quads(
      around, along, positions, [=](int i, int j) { return i % around * (along + 1) + j; }));
  for (std::size_t i = 0; i < positions.size(); ++i) {
    surface.normals[i] = (positions[i] - positions[i].dot(axis) * axis).normalized();
    shapes::set_curvature(surface, i, -1, axis.cross(surface.normals[i]), 0, axis);
  }
  return surface;
}

// The surface of unit cubes: a slab of 5 x 3 x 1 with two holes, each face cut in `cells` squared.
inline Surface two_holed_slab(int cells) {
  const auto is_solid = [](const Eigen::Vector3i& c) {
    const bool inside = c.minCoeff() >= 0 && c.x() < 5 && c.y() < 3 && c.z() < 1;
    return inside && !(c.y() == 1 && (c.x() == 1 || c.x() == 3));
  };
  PolygonMesh mesh;
  std::map<std::array<int, 3>, int> numbers;
  const auto vertex = [&](const Eigen::Vector3i& at) {
    const auto [entry, is_new] =
        numbers.try_emplace({at.x(), at.y(), at.z()}, static_cast<int>(mesh.positions.size()));
    if (is_new) mesh.positions.push_back(at.cast<double>() / cells);
    return entry->second;
  };
  for (int c = 0; c < 15; ++c)
    for (int axis = 0; axis < 3; ++axis)
      for (int side = 0; side < 2; ++side) {
        const Eigen::Vector3i cube(c % 5, c / 5, 0), out = Eigen::Vector3i::Unit(axis);
        if (!is_solid(cube) || is_solid(cube + (2 * side - 1) * out)) continue;
        const Eigen::Vector3i u = Eigen::Vector3i::Unit((axis + (side ? 1 : 2)) % 3);
        const Eigen::Vector3i v = Eigen::Vector3i::Unit((axis + (side ? 2 : 1)) % 3);
        for (int a = 0; a < cells; ++a)
          for (int b = 0; b < cells; ++b) {
            const Eigen::Vector3i at = cells * (cube + side * out) + a * u + b * v;
            shapes::add_face(mesh,
                             {vertex(at), vertex(at + u), vertex(at + u + v), vertex(at + v)});
          }
      }
  return shapes::plain_surface(mesh);
}

// Triangles keep their windings; the normal of a vertex is that of the sheet of its first triangle.
inline Surface unorientable(const PolygonMesh& mesh) {
  Surface surface = shapes::plain_surface(mesh);
  const auto face_normal = [&](const Triangle& t) {
    const Vec3& origin = surface.positions[index_of(t[0])];
    return Vec3((surface.positions[index_of(t[1])] - origin)
                    .cross(surface.positions[index_of(t[2])] - origin));
  };
  Points sums(surface.positions.size(), Vec3::Zero());
  for (const Triangle& t : surface.triangles) {
    for (const int vertex : t) {
      Vec3& sum = sums[index_of(vertex)];
      sum += sum.dot(face_normal(t)) < 0 ? Vec3(-face_normal(t)) : face_normal(t);
    }
  }
  for (std::size_t i = 0; i < sums.size(); ++i) surface.normals[i] = sums[i].normalized();
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3& normal = surface.normals[index_of(surface.triangles[t][k])];
      if (normal.dot(face_normal(surface.triangles[t])) < 0) {
        surface.flips[t] = static_cast<std::uint8_t>(surface.flips[t] | 1U << k);
      }
    }
  }
  return surface;
}

// |x|^6 + |y|^6 + |z|^6 = 1: a cube with smooth edges and corners.
inline Surface smooth_cube(int level) {
  PolygonMesh mesh = shapes::icosphere_mesh(1, level);
  for (Vec3& p : mesh.positions) p /= std::pow(p.array().abs().pow(6).sum(), 1.0 / 6);
  return shapes::plain_surface(mesh);
}

inline Surface blob(int level) {
  PolygonMesh mesh = shapes::icosphere_mesh(1, level);
  for (Vec3& p : mesh.positions) {
    const double x = p.x(), y = p.y(), z = p.z();
    p *= 1 + 0.15 * std::sin(5 * x + 1) * std::sin(4 * y + 2) * std::sin(6 * z + 3) +
         0.06 * std::sin(11 * x) * std::sin(9 * y + 1) + 0.05 * std::sin(13 * z + x);
  }
  return shapes::plain_surface(mesh);
}

// Faces as they are, with vertices of their own; what was one vertex is one place, what was one
// edge a crease.
inline Surface creased(const PolygonMesh& mesh) {
  Surface surface = shapes::plain_surface(shapes::unwelded(mesh));
  surface.places = mesh.corner_vertices;
  shapes::link_neighbours(surface);
  std::map<Edge, int> triangles;
  const auto own_edge = [&](std::size_t t, int k) {
    const int a = surface.triangles[t][index_of(k)];
    const int b = surface.triangles[t][index_of(next_corner(k))];
    return Edge{std::min(a, b), std::max(a, b)};
  };
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
    for (int k = 0; k < 3; ++k) ++triangles[own_edge(t, k)];
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
    for (int k = 0; k < 3; ++k)
      if (triangles[own_edge(t, k)] == 1) surface.edge_kinds[t][index_of(k)] = EdgeKind::crease;
  return surface;
}

inline PolygonMesh rotated(PolygonMesh mesh, double angle, const Vec3& axis) {
  const Eigen::AngleAxisd rotation(angle, axis.normalized());
  for (Vec3& p : mesh.positions) p = rotation * p;
  return mesh;
}

inline FieldGraph whole_graph(const Surface& surface, const CrossNumbers& pulls) {
  const TangentFrames frames = tangent_frames(surface.normals, 1);
  std::vector<int> vertices;
  return free_graph(field_edges(surface, triangle_edges(surface), frames, {}, 1), pulls,
                    std::vector<std::uint8_t>(pulls.size(), 0), CrossNumbers(pulls.size(), 1),
                    vertices);
}

inline FieldGraph whole_graph(const Surface& surface) {
  return whole_graph(surface, CrossNumbers(surface.positions.size(), 0));
}

inline CrossNumbers random_crosses(std::size_t count, std::uint64_t seed) {
  SeededNumbers numbers(seed);
  CrossNumbers z(count);
  for (CrossNumber& cross : z) cross = normalized(numbers.number(), 1);
  return z;
}

inline std::vector<double> arguments(const CrossNumbers& z) {
  std::vector<double> u;
  for (const CrossNumber& cross : z) u.push_back(std::arg(cross));
  return u;
}

}  // namespace illustrate::field_checks
