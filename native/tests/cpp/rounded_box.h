// A box with rounded edges as modelling programs make it: large walls, and strips round them.
#pragma once

#include <cmath>

#include "mesh/polygon_mesh.h"
#include "tests/cpp/shapes.h"

namespace illustrate::shapes {

// Half its sides; the radius of its edges; so many strips round a quarter.
struct RoundedBox {
  Vec3 half{2, 1, .5};
  double radius = .1;
  int strips = 3;

  // How far a point is off its surface.
  double distance(const Vec3& p) const {
    const Vec3 beyond = (p.cwiseAbs() - half).array() + radius;
    return beyond.cwiseMax(0).norm() + std::min(beyond.maxCoeff(), 0.) - radius;
  }
};

inline PolygonMesh mesh_of(const RoundedBox& box) {
  const int k = box.strips, columns = 4 * (k + 1);
  PolygonMesh mesh;
  const Vec3 inner = box.half.array() - box.radius;
  // Column k + 1 of a quarter is the first of the next.
  const auto add = [&](int column, double latitude, double up) {
    const int quarter = column / (k + 1);
    const double longitude = (quarter + static_cast<double>(column % (k + 1)) / k) * pi / 2;
    const double middle = (quarter + .5) * pi / 2;
    const Vec3 signs(std::cos(middle) > 0 ? 1 : -1, std::sin(middle) > 0 ? 1 : -1, up);
    mesh.positions.push_back(signs.cwiseProduct(inner) +
                             box.radius * Vec3(std::cos(latitude) * std::cos(longitude),
                                               std::cos(latitude) * std::sin(longitude),
                                               std::sin(latitude)));
  };
  for (int row = 0; row < 2 * k; ++row) {
    const double latitude = (row < k ? row + 1 - k : row - k) * pi / 2 / k;
    for (int c = 0; c < columns; ++c) add(c, latitude, row < k ? -1 : 1);
  }
  for (const int up : {-1, 1}) {
    for (int q = 0; q < 4; ++q) add(q * (k + 1), up * pi / 2, up);
  }
  for (int row = 0; row + 1 < 2 * k; ++row) {
    for (int c = 0; c < columns; ++c) {
      const int a = row * columns + c, b = row * columns + (c + 1) % columns;
      add_face(mesh, {a, b, b + columns, a + columns});
    }
  }
  const int low = 2 * k * columns, high = low + 4, top = (2 * k - 1) * columns;
  for (int c = 0; c < columns; ++c) {
    const int next = (c + 1) % columns, q = c / (k + 1), r = next / (k + 1);
    if (q == r) {
      add_face(mesh, {low + q, next, c});
      add_face(mesh, {top + c, top + next, high + q});
    } else {
      add_face(mesh, {low + q, low + r, next, c});
      add_face(mesh, {top + c, top + next, high + r, high + q});
    }
  }
  add_face(mesh, {low + 3, low + 2, low + 1, low});
  add_face(mesh, {high, high + 1, high + 2, high + 3});
  mesh.cage = false;
  return mesh;
}

}  // namespace illustrate::shapes
