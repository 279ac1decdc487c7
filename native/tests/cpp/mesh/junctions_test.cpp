// Patches that divide the curve where they meet differently.
#include "mesh/junctions.h"

#include <cmath>

#include "tests/cpp/check_sound.h"
#include "tests/cpp/shapes.h"

namespace illustrate {
namespace {

// Two bands of a cylinder of radius 1, one above the other, divided into so many faces round a
// quarter; each with the cylinder's normals.
PolygonMesh two_bands(int lower, int upper, double gap = 0) {
  PolygonMesh mesh;
  for (const bool is_upper : {false, true}) {
    const int columns = is_upper ? upper : lower, first = static_cast<int>(mesh.positions.size());
    for (int k = 0; k <= columns; ++k) {
      const double angle = k * pi / 2 / columns, z = is_upper ? gap : -1;
      for (const double height : {z, z + 1})
        mesh.positions.emplace_back(std::cos(angle), std::sin(angle), height);
    }
    for (int k = 0; k < columns; ++k) {
      const int a = first + 2 * k;
      shapes::add_face(mesh, {a, a + 2, a + 3, a + 1});
    }
  }
  for (const int v : mesh.corner_vertices) {
    const Vec3& p = mesh.positions[idx(v)];
    mesh.corner_normals.emplace_back(p.x(), p.y(), 0);
  }
  mesh.cage = false;
  return mesh;
}

std::int64_t open_edges(const PolygonMesh& mesh) { return mend(mesh).report.at("open_edges"); }

TEST(Junctions, JoinPatchesThatDivideTheirCurveDifferently) {
  // Fine enough that a vertex is within a ten-thousandth of the diagonal off the other's edge.
  for (const auto& [lower, upper] : {std::pair{60, 120}, {50, 75}, {47, 64}}) {
    const Mended mended = mend(two_bands(lower, upper));
    EXPECT_GT(mended.report.at("junctions"), 0);
    EXPECT_EQ(mended.report.at("parts"), 1) << lower << " " << upper;
    EXPECT_EQ(mended.report.at("open_edges"), lower + upper + 4) << lower << " " << upper;
    EXPECT_EQ(mended.report.at("normal_creases"), 0) << lower << " " << upper;
    EXPECT_EQ(mended.report.at("kept_faces"), lower + upper);
  }
}

TEST(Junctions, CloseGapsToo) {
  for (const double gap : {1e-6, -1e-6, 1e-4}) {
    const Mended mended = mend(two_bands(60, 90, gap));
    EXPECT_EQ(mended.report.at("parts"), 1) << gap;
  }
}

TEST(Junctions, AreNoneFarther) {
  EXPECT_EQ(mend(two_bands(60, 90, 1e-3)).report.at("junctions"), 0);
  EXPECT_EQ(mend(two_bands(4, 8)).report.at("junctions"), 0) << "the chord is too far off";
}

TEST(Junctions, AreNoneOfCages) {
  PolygonMesh mesh = two_bands(60, 120);
  mesh.cage = true;
  EXPECT_EQ(mend(mesh).report.at("junctions"), 0);
}

// The normals of the upper band, turned up by this angle.
PolygonMesh two_bands_shaded_apart(double turn_deg) {
  PolygonMesh mesh = two_bands(60, 120);
  const double up = std::tan(turn_deg * pi / 180);
  for (std::size_t c = 240; c < mesh.corner_normals.size(); ++c)
    mesh.corner_normals[c] = (mesh.corner_normals[c] + up * Vec3(0, 0, 1)).normalized();
  return mesh;
}

TEST(Junctions, AreCreasesWhereShadingBreaks) {
  const Mended mended = mend(two_bands_shaded_apart(20));
  EXPECT_EQ(mended.report.at("parts"), 1);
  EXPECT_EQ(mended.report.at("normal_creases"), 120);
}

TEST(Junctions, AreNoneWhereNormalsPointApart) {
  EXPECT_EQ(mend(two_bands_shaded_apart(40)).report.at("junctions"), 0);
}

TEST(Junctions, AreNoneOfOneSheetBehindAnother) {
  PolygonMesh mesh = two_bands(60, 120);
  for (std::size_t v = 122; v < mesh.positions.size(); ++v) mesh.positions[v].z() -= 1;
  EXPECT_EQ(mend(mesh).report.at("junctions"), 0) << "their edges run the same way";
}

// A needle, and two patches on its sides that meet at a vertex within it: all three of their
// vertices are within reach of both sides.
TEST(Junctions, TakeAVertexIntoAFaceOnce) {
  const double thin = 1e-5;
  PolygonMesh mesh = shapes::polygon_mesh({{0, 0, 0},
                                           {1, thin, 0},
                                           {1, -thin, 0},
                                           {.5, 0, 0},
                                           {.25, thin / 8, 0},
                                           {.25, -thin / 8, 0},
                                           {.4, 1, 0},
                                           {.4, -1, 0}},
                                          {{0, 2, 1}, {6, 4, 3}, {7, 3, 5}});
  mesh.cage = false;
  const Mended mended = mend(mesh);
  EXPECT_EQ(mended.report.at("junctions"), 3);
  EXPECT_EQ(mended.report.at("kept_faces"), 3);
}

// Sixty thousand open edges that end at one vertex.
TEST(Junctions, AreFoundInAFanOfSingleFaces) {
  PolygonMesh mesh;
  mesh.positions.emplace_back(0, 0, 0);
  const int count = 30000;
  for (int k = 0; k < 2 * count; ++k) {
    const double angle = k * pi / count;
    mesh.positions.emplace_back(std::cos(angle), std::sin(angle), 0);
    if (k % 2 == 1) shapes::add_face(mesh, {0, k, k + 1});
  }
  mesh.cage = false;
  EXPECT_EQ(mend(mesh).report.at("parts"), count);
}

TEST(Junctions, WhatMeetsAlikeHasNone) {
  EXPECT_EQ(mend(two_bands(60, 60)).report.at("junctions"), 0);
  EXPECT_EQ(open_edges(two_bands(60, 60)), 124);
}

}  // namespace
}  // namespace illustrate
