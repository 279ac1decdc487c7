#include "mesh/gaps.h"

#include <cmath>

#include "tests/cpp/check_sound.h"
#include "tests/cpp/shapes.h"

namespace illustrate {
namespace {

// Faces of their own, as programs for mechanical design export them, with the normals of the
// welded mesh's vertices.
PolygonMesh patches(const PolygonMesh& mesh, const Points& normals) {
  PolygonMesh result = shapes::unwelded(mesh);
  result.cage = false;
  for (const int vertex : mesh.corner_vertices)
    result.corner_normals.push_back(normals[idx(vertex)]);
  return result;
}

// Two squares side by side, apart by `gap`, in whose common edge the second one's normals are
// turned by `turn_deg`.
PolygonMesh two_squares(double gap, double turn_deg = 0) {
  PolygonMesh mesh = patches(shapes::plane(2, 1), Points(6, Vec3(0, 0, 1)));
  for (std::size_t v = 4; v < 8; ++v) {
    const bool is_near = std::abs(mesh.positions[v].x()) < 0.1;
    const double turn = is_near ? turn_deg * pi / 180 : 0;
    mesh.corner_normals[v] = {std::sin(turn), 0, std::cos(turn)};
    mesh.positions[v].x() += gap;
  }
  return mesh;
}

std::int64_t closed_gaps(const PolygonMesh& mesh) { return mend(mesh).report.at("closed_gaps"); }

TEST(Gaps, PatchesWithinToleranceAreOneSurface) {
  for (const double gap : {1e-8, 1e-6, 1e-4, -1e-4}) {
    const Mended mended = mend(two_squares(gap));
    EXPECT_EQ(mended.report.at("closed_gaps"), 1) << gap;
    EXPECT_EQ(mended.report.at("welded_vertices"), 2) << gap;
    EXPECT_EQ(mended.report.at("parts"), 1) << gap;
    EXPECT_EQ(mended.report.at("normal_creases"), 0) << gap;
  }
}

TEST(Gaps, WhatIsWiderStaysOpen) {
  const double widest = 1e-4 * std::sqrt(2 * 2 + 2 * 2);
  EXPECT_EQ(closed_gaps(two_squares(0.99 * widest)), 1);
  EXPECT_EQ(closed_gaps(two_squares(1.01 * widest)), 0);
}

TEST(Gaps, WhatIsShadedApartStaysOpen) {
  EXPECT_EQ(closed_gaps(two_squares(1e-6, 4.5)), 1);
  EXPECT_EQ(closed_gaps(two_squares(1e-6, 5.5)), 0);
}

TEST(Gaps, CagesHaveNone) {
  PolygonMesh mesh = two_squares(1e-6);
  mesh.cage = true;
  EXPECT_EQ(closed_gaps(mesh), 0);
}

// Two squares shaded flat that meet at an angle.
TEST(Gaps, BetweenFlatFacesCloseUpToTheCreaseAngle) {
  for (const bool has_normals : {true, false}) {
    for (const double turn : {0., 20., 29., 31., 90., 180.}) {
      PolygonMesh mesh = two_squares(0);
      const double angle = turn * pi / 180;
      const Vec3 normal(std::sin(angle), 0, std::cos(angle));
      for (std::size_t v = 4; v < 8; ++v) {
        Vec3& p = mesh.positions[v];
        p = {p.x() * std::cos(angle) + 1e-6, p.y(), -p.x() * std::sin(angle)};
        mesh.corner_normals[v] = normal;
      }
      if (!has_normals) mesh.corner_normals.clear();
      EXPECT_EQ(closed_gaps(mesh), turn < 30 ? 1 : 0) << turn;
      mesh.crease_angle_deg = 10;
      EXPECT_EQ(closed_gaps(mesh), turn < 10 ? 1 : 0) << turn;
    }
  }
}

TEST(Gaps, TheSidesOfAThinSheetStayApart) {
  const PolygonMesh plane = shapes::plane(1, 1);
  PolygonMesh mesh = shapes::joined(plane, shapes::turned(plane));
  for (std::size_t v = 4; v < 8; ++v) mesh.positions[v].z() -= 1e-6;
  mesh.cage = false;
  mesh.corner_normals = Points(8, Vec3(0, 0, 1));
  std::fill(mesh.corner_normals.begin() + 4, mesh.corner_normals.end(), Vec3(0, 0, -1));
  EXPECT_EQ(closed_gaps(mesh), 0);
}

// A hair: its two long sides are as close as those of a gap.
TEST(Gaps, AThinStripIsNone) {
  PolygonMesh mesh = patches(shapes::plane(4, 1), Points(10, Vec3(0, 0, 1)));
  for (Vec3& p : mesh.positions) p.y() *= 1e-5;
  const Mended mended = mend(mesh);
  EXPECT_EQ(mended.report.at("closed_gaps"), 0);
  EXPECT_EQ(mended.report.at("kept_faces"), 4);
}

TEST(Gaps, OfTwoSheetsTheNearestIsTheOther) {
  PolygonMesh mesh = two_squares(2e-6);
  const PolygonMesh nearer = two_squares(1e-6);
  mesh = shapes::joined(mesh, nearer);  // 2e-6, and the two of `nearer`
  mesh.corner_normals.assign(mesh.corner_vertices.size(), Vec3(0, 0, 1));
  mesh.cage = false;
  for (std::size_t v = 8; v < 12; ++v) mesh.positions[v].x() -= 5e-7;
  const Mended mended = mend(mesh);
  // Of 0, -5e-7, 1e-6 and 2e-6 the two in the middle are nearer than the outer ones to any.
  EXPECT_EQ(mended.report.at("closed_gaps"), 1);
}

// The patches of a sphere, each moved by up to the tolerance, close to the sphere.
TEST(Gaps, APatchedSphereCloses) {
  const PolygonMesh sphere = shapes::uv_sphere_mesh(1, 24, 13);
  Points normals;
  for (const Vec3& p : sphere.positions) normals.push_back(p.normalized());
  PolygonMesh mesh = patches(sphere, normals);
  std::size_t corner = 0;
  for (std::size_t f = 0; f < mesh.face_sizes.size(); ++f) {
    const double t = 0.7 * static_cast<double>(f);
    const Vec3 off = 4e-5 * Vec3(std::sin(t), std::sin(3 * t), std::cos(5 * t));
    for (int k = 0; k < mesh.face_sizes[f]; ++k) mesh.positions[corner++] += off;
  }
  const Mended mended = mend(mesh);
  EXPECT_EQ(mended.mesh.positions.size(), sphere.positions.size());
  EXPECT_EQ(mended.report.at("open_edges"), 0);
  EXPECT_EQ(mended.report.at("parts"), 1);
  EXPECT_EQ(mended.report.at("normal_creases"), 0);
  EXPECT_EQ(mended.report.at("kept_faces"), mended.report.at("input_faces"));
}

}  // namespace
}  // namespace illustrate
