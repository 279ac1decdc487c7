// Sheets that adjoin: a solid whose faces are meshes of their own, as CAD is imported, has the
// lines of the solid, and no others.
#include <gtest/gtest.h>

#include <random>

#include "tests/cpp/blocks.h"
#include "tests/cpp/cameras.h"
#include "tests/cpp/stroke_distance.h"

namespace illustrate {
namespace {

using Face = std::vector<int>;

constexpr double unseen_px = 0.3;  // loops of the solid's lines this small are repaired

// A ring, upright on z = 0, on polygons of n corners; without a hole where `hole` is 0.
PolygonMesh ring(int n, double hole, double radius, double height) {
  Points points;
  for (const double r : {hole, radius}) {
    for (const double z : {0., height}) {
      for (int i = 0; i < n; ++i) {
        const double angle = 2 * 3.141592653589793 * i / n;
        points.emplace_back(r * std::cos(angle), r * std::sin(angle), z);
      }
    }
  }
  std::vector<Face> faces;
  for (int i = 0; i < n; ++i) {
    const int j = (i + 1) % n, top = n, outer = 2 * n;
    faces.push_back({outer + i, outer + j, outer + top + j, outer + top + i});
    faces.push_back({top + i, outer + top + i, outer + top + j, top + j});
    faces.push_back({j, outer + j, outer + i, i});
    if (hole > 0) faces.push_back({j, i, top + i, top + j});
  }
  return blocks::sharp(shapes::polygon_mesh(points, faces));
}

PolygonMesh joined(const std::vector<PolygonMesh>& meshes) {
  PolygonMesh all = meshes.front();
  for (std::size_t i = 1; i < meshes.size(); ++i) all = shapes::joined(all, meshes[i]);
  return all;
}

// Turned, and rounded to single precision as a modelling program stores it.
PolygonMesh turned(PolygonMesh mesh, const Eigen::Quaterniond& by) {
  for (Vec3& p : mesh.positions) p = (by * p).cast<float>().cast<double>();
  return mesh;
}

Vec3 normal_of(const PolygonMesh& mesh, const Face& face) {
  Vec3 normal = Vec3::Zero();
  for (std::size_t k = 0; k < face.size(); ++k) {
    normal += mesh.positions[idx(face[k])].cross(mesh.positions[idx(face[(k + 1) % face.size()])]);
  }
  return normal.normalized();
}

struct PlaneFaces {
  Vec3 normal;
  double distance;
  std::vector<Face> faces;
};

std::vector<PlaneFaces> faces_by_plane(const PolygonMesh& solid) {
  std::vector<PlaneFaces> planes;
  auto corner = solid.corner_vertices.begin();
  for (const int size : solid.face_sizes) {
    const Face face(corner, corner + size);
    corner += size;
    const Vec3 normal = normal_of(solid, face);
    const double distance = normal.dot(solid.positions[idx(face[0])]);
    const auto found = std::find_if(planes.begin(), planes.end(), [&](const PlaneFaces& plane) {
      return (plane.normal - normal).norm() < 1e-3 && std::abs(plane.distance - distance) < 1e-3;
    });
    if (found == planes.end()) {
      planes.push_back({normal, distance, {face}});
    } else {
      found->faces.push_back(face);
    }
  }
  return planes;
}

// The faces of each plane are a mesh of their own.
std::vector<PolygonMesh> sheets_of(const PolygonMesh& solid) {
  std::vector<PolygonMesh> sheets;
  for (const PlaneFaces& plane : faces_by_plane(solid)) {
    sheets.push_back(blocks::sharp(shapes::polygon_mesh(solid.positions, plane.faces)));
  }
  return sheets;
}

void expect_same_lines(const PolygonMesh& solid, const std::vector<PolygonMesh>& sheets,
                       const Camera& camera) {
  const Drawing one = blocks::drawn({solid}, camera), apart = blocks::drawn(sheets, camera);
  EXPECT_LT(farthest_px(one, apart), unseen_px) << "a line is missed";
  EXPECT_LT(farthest_px(apart, one), unseen_px) << "a hidden line is drawn";
}

void expect_same_lines_from_all_sides(const PolygonMesh& solid) {
  EXPECT_EQ(blocks::prepared(sheets_of(solid))->intersections().curves.size(), 0u);
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  for (int view = 0; view < 12; ++view) {
    SCOPED_TRACE(view);
    Eigen::Quaterniond by;
    for (double& x : by.coeffs()) x = normal(random);
    Vec3 eye;
    for (double& x : eye) x = normal(random);
    const PolygonMesh mesh = turned(solid, by.normalized());
    const Camera camera = cameras::perspective(12 * eye.normalized(), Vec3::Zero());
    expect_same_lines(mesh, sheets_of(mesh), camera);
  }
}

TEST(AdjoiningSheets, OfPrismsHaveTheirLines) {
  for (const int n : {3, 4, 6}) expect_same_lines_from_all_sides(ring(n, 0, 2, 1.5));
}

// What is seen through the hole, and what is not.
TEST(AdjoiningSheets, OfPlatesWithAHoleHaveTheirLines) {
  for (const int n : {4, 6}) expect_same_lines_from_all_sides(ring(n, 1, 2, 0.7));
}

// One behind another, so that lines pass behind borders that lie on each other.
TEST(AdjoiningSheets, OfPartsHaveTheirLines) {
  expect_same_lines_from_all_sides(
      joined({ring(4, 1, 2, 0.7), shapes::moved(ring(5, 0, 1.5, 0.5), Vec3(0.2, 0.1, 1.1)),
              shapes::moved(ring(6, 0.5, 1, 0.5), Vec3(0.3, -0.4, -1))}));
}

}  // namespace
}  // namespace illustrate
