// Solids that touch: flush faces, walls on floors, blocks on a grid, whose edges lie in each
// other's planes. Whether an edge is seen is told here by intervals of its line of sight within
// boxes, without any mesh.
#include <gtest/gtest.h>

#include <random>

#include "tests/cpp/blocks.h"
#include "tests/cpp/cameras.h"
#include "tests/cpp/stroke_distance.h"

namespace illustrate {
namespace {

using Box = Eigen::AlignedBox3d;

PolygonMesh mesh_of(const Box& box) { return blocks::block(box.min(), box.max()); }

// The open part of the way from p to the eye that lies within the box.
double inside(const Box& box, const Vec3& p, const Vec3& to_eye) {
  double from = 0, to = 1;
  for (int k = 0; k < 3; ++k) {
    const double a = (box.min()[k] - p[k]) / to_eye[k], b = (box.max()[k] - p[k]) / to_eye[k];
    from = std::max(from, std::min(a, b));
    to = std::min(to, std::max(a, b));
  }
  return to - from;
}

Drawing drawn(const std::vector<Box>& boxes, const Camera& camera, int triangle_budget = 5000) {
  std::vector<PolygonMesh> meshes;
  for (const Box& box : boxes) meshes.push_back(mesh_of(box));
  return blocks::drawn(meshes, camera, triangle_budget);
}

constexpr int samples = 40;  // along an edge

Vec3 edge_sample(const Box& box, int edge, int i) {
  const int axis = edge / 4;
  Vec3 share;
  share[axis] = (i + 0.5) / samples;
  share[(axis + 1) % 3] = edge & 1;
  share[(axis + 2) % 3] = edge >> 1 & 1;
  return box.min() + (share.array() * box.sizes().array()).matrix();
}

// Of samples along edges, those for which something is so.
struct Sampled {
  int samples = 0, counted = 0;

  void operator+=(const Sampled& more) {
    samples += more.samples;
    counted += more.counted;
  }
};

// Of samples along the edges of boxes that are seen, how many have no line. Edges that run within
// another box, in its surface, may be drawn or not.
Sampled missed_edges(const std::vector<Box>& boxes, const Camera& camera,
                     int triangle_budget = 5000) {
  const Drawing drawing = drawn(boxes, camera, triangle_budget);
  Sampled found;
  for (std::size_t b = 0; b < boxes.size(); ++b) {
    for (int edge = 0; edge < 12; ++edge) {
      for (int i = 0; i < samples; ++i) {
        const Vec3 p = edge_sample(boxes[b], edge, i);
        const Vec3 within = p + 1e-3 * (boxes[b].center() - p);
        const auto hides = [&](const Box& box) {
          return inside(box, p, camera.to_eye(p)) > 1e-7 ||
                 (&box != &boxes[b] && box.contains(within));
        };
        if (std::any_of(boxes.begin(), boxes.end(), hides)) continue;
        ++found.samples;
        found.counted += distance_px(drawing, camera.project(p).xy) > 1.5;
      }
    }
  }
  return found;
}

Box box(const Vec3& low, const Vec3& high) { return {low, high}; }

constexpr double margin = 0.1;

// The axis of the face in which p lies, `margin` from its edges at least; else none.
int axis_of_face(const Box& box, const Vec3& p) {
  const Box inner(box.min().array() + margin, box.max().array() - margin);
  for (int k = 0; k < 3; ++k) {
    Vec3 moved = p;
    moved[k] = box.center()[k];
    if ((p[k] == box.min()[k] || p[k] == box.max()[k]) && inner.contains(moved)) return k;
  }
  return none;
}

// Whether p on an edge of `own` lies within a face of `other` that goes on in a face of `own`.
bool is_flush(const Box& own, const Box& other, const Vec3& p) {
  const int axis = axis_of_face(other, p);
  return axis != none && ((p[axis] == own.min()[axis] && p[axis] == other.min()[axis]) ||
                          (p[axis] == own.max()[axis] && p[axis] == other.max()[axis]));
}

// Of samples along edges that are flush with another box and in front of all, how many have a line.
// Where a third box comes near it may have its own.
Sampled flush_lines(const std::vector<Box>& boxes, const Camera& camera) {
  const Drawing drawing = drawn(boxes, camera);
  Sampled found;
  for (const Box& own : boxes) {
    for (const Box& other : boxes) {
      for (int sample = 0; sample < 12 * samples; ++sample) {
        const Vec3 p = edge_sample(own, sample / samples, sample % samples);
        const auto disturbs = [&](const Box& box) {
          const bool is_third = &box != &own && &box != &other;
          return inside(box, p, camera.to_eye(p)) > 1e-7 ||
                 (is_third && box.exteriorDistance(p) < margin);
        };
        if (!is_flush(own, other, p) || std::any_of(boxes.begin(), boxes.end(), disturbs)) continue;
        ++found.samples;
        found.counted += distance_px(drawing, camera.project(p).xy) < 1;
      }
    }
  }
  return found;
}

TEST(TouchingSolids, WallsStandOnAFloor) {
  const Camera camera = cameras::perspective(Vec3(16, -26, 14), Vec3(0, 0, 1));
  const std::vector<Box> walls{box(Vec3(-4, 3.9, 0), Vec3(4, 4.1, 4)),
                               box(Vec3(-4.1, -4, 0), Vec3(-3.9, 4, 4))};
  std::vector<PolygonMesh> meshes{shapes::plane(1, 1)};
  for (Vec3& p : meshes[0].positions) p *= 8;
  const Vec3 middle = (meshes[0].positions.front() + meshes[0].positions.back()) / 2;
  for (Vec3& p : meshes[0].positions) p -= middle;
  for (const Box& wall : walls) meshes.push_back(mesh_of(wall));
  for (int turn = 0; turn < 3; ++turn) {
    std::rotate(meshes.begin(), meshes.begin() + 1, meshes.end());
    const Drawing drawing = blocks::drawn(meshes, camera);
    for (double t = -3.8; t < 3.8; t += 0.1) {
      EXPECT_LT(distance_px(drawing, camera.project(Vec3(t, 3.9, 0)).xy), 1.5) << t;
      EXPECT_LT(distance_px(drawing, camera.project(Vec3(-3.9, t, 0)).xy), 1.5) << t;
    }
  }
}

TEST(TouchingSolids, OfTwoFlushBlocksNoEdgeIsMissed) {
  const Camera camera = cameras::perspective(Vec3(-14, 12.4, -28.4), Vec3::Zero());
  const Sampled found = missed_edges(
      {box(Vec3(-2, -2, -2), Vec3(-1, 1, 1)), box(Vec3(-2, -1, 1), Vec3(0, 2, 2))}, camera);
  EXPECT_EQ(found.counted, 0) << "of " << found.samples;
}

TEST(TouchingSolids, MeetingInAnEdgeDoNotHideIt) {
  const Camera camera = cameras::perspective(Vec3(-18, 12, 21), Vec3::Zero());
  const Sampled found = missed_edges(
      {box(Vec3(0, 0, -1), Vec3(3, 3, 2)), box(Vec3(-1, -1, -1), Vec3(0, 0, 2))}, camera);
  EXPECT_EQ(found.counted, 0) << "of " << found.samples;
}

// Walls of a room that meet in an edge alone, seen from inside, with triangles so small that rays
// beside the corner meet none that ends there.
TEST(TouchingSolids, CornersOfRoomsAreDrawn) {
  const std::vector<Box> walls{
      box(Vec3(-3, -3, -0.2), Vec3(3, 3, 0)), box(Vec3(-3, 3, 0), Vec3(3, 3.2, 3)),
      box(Vec3(3, -3, 0), Vec3(3.2, 3, 3)), box(Vec3(-3.2, -3, 0), Vec3(-3, 3, 3))};
  Sampled found;
  for (const Vec3& eye : {Vec3(-1, -6, 2), Vec3(0.3, -7, 1.5), Vec3(0.77, -5.1, 1.9)}) {
    found += missed_edges(walls, cameras::perspective(eye, Vec3(0, 1, 1.2), 0.1, 120), 100'000);
  }
  EXPECT_EQ(found.counted, 0) << "of " << found.samples;
}

// Of pickets, and of a rail that runs through them a pixel or two behind their fronts.
TEST(TouchingSolids, ARailWithinPicketsIsNotSeenThroughThem) {
  const Camera camera = cameras::perspective(Vec3(0.5, -10, 1), Vec3::Zero());
  const double pixel = camera.pixel_size(Vec3::Zero());
  for (const double depth : {0.7 * pixel, 1.5 * pixel, 2.5 * pixel}) {
    std::vector<PolygonMesh> meshes{mesh_of(box(Vec3(-2, depth, -0.2), Vec3(2, depth + 0.3, 0.2)))};
    for (const double x : {-1.5, 0., 1.5}) {
      meshes.push_back(mesh_of(box(Vec3(x - 0.3, 0, -1), Vec3(x + 0.3, 4 * pixel, 1))));
    }
    const Drawing drawing = blocks::drawn(meshes, camera);
    for (const double x : {-1.5, 0., 1.5}) {
      for (const double z : {-0.2, 0.2}) {
        const auto distance = [&](double at) {
          return distance_px(drawing, camera.project(Vec3(at, depth, z)).xy);
        };
        EXPECT_GT(distance(x), 10) << depth / pixel << " px behind the front";
        EXPECT_LT(distance(x + 0.4), 1) << "beside the picket";
      }
    }
  }
}

// Where it enters the other's plane it lies in its own and in that one, however they are moved.
TEST(TouchingSolids, IntersectionsAreHiddenByNeitherSheet) {
  const Camera camera = cameras::perspective(Vec3(3, -20, 14), Vec3::Zero());
  const Drawing drawing = blocks::drawn(
      {shapes::uv_sphere_mesh(1, 32, 16), mesh_of(box(Vec3(-3, -3, -2), Vec3(3, 3, 0.3)))}, camera);
  const double radius = std::sqrt(1 - 0.3 * 0.3);
  for (double angle = -2.6; angle < -0.5; angle += 0.05) {
    const Vec3 p(radius * std::cos(angle), radius * std::sin(angle), 0.3);
    EXPECT_LT(distance_px(drawing, camera.project(p).xy), 1.5) << angle;
  }
}

// The sum of measure(boxes, camera) over so many scenes of two or three boxes whose corners are
// whole numbers.
template <class Measure>
Sampled sum_over_grids_of_boxes(int scenes, const Measure& measure) {
  std::mt19937 random(7);
  const auto whole = [&](int low, int high) {
    return low + static_cast<int>(random() % static_cast<unsigned>(high - low + 1));
  };
  Sampled sum;
  for (int scene = 0; scene < scenes; ++scene) {
    std::vector<Box> boxes;
    for (int k = whole(2, 3); k > 0; --k) {
      const Vec3 low(whole(-3, 1), whole(-3, 1), whole(-3, 1));
      boxes.push_back(box(low, low + Vec3(whole(1, 3), whole(1, 3), whole(1, 3))));
    }
    Vec3 eye;
    for (double& x : eye) x = whole(0, 1) ? whole(100, 300) / 10. : -whole(100, 300) / 10.;
    sum += measure(boxes, cameras::perspective(eye, Vec3::Zero()));
  }
  return sum;
}

TEST(TouchingSolids, BlocksOnAGridHaveTheirEdges) {
  for (const int triangles : {5000, 50'000}) {
    const Sampled all =
        sum_over_grids_of_boxes(30, [&](const std::vector<Box>& boxes, const Camera& camera) {
          return missed_edges(boxes, camera, triangles);
        });
    EXPECT_LT(all.counted, all.samples / 400) << "of " << all.samples;
  }
}

TEST(TouchingSolids, BlocksOnAGridHaveNoEdgesWithinOthersThatAreFlush) {
  const Sampled all = sum_over_grids_of_boxes(300, flush_lines);
  EXPECT_GT(all.samples, 1000);
  // Lines of what is in front, or behind, cross the edge in the image.
  EXPECT_LT(all.counted, all.samples / 40) << "of " << all.samples;
}

TEST(TouchingSolids, OfABeamWhoseEndIsFlushWithAWallNothingIsDrawn) {
  const Box wall = box(Vec3(-3, -1, -2), Vec3(3, 0, 2));
  const Box beam = box(Vec3(-0.5, -5, -0.5), Vec3(0.5, 0, 0.5));
  const Camera camera = cameras::perspective(Vec3(4, 20, 6), Vec3::Zero());
  for (const auto& boxes : {std::vector<Box>{wall, beam}, std::vector<Box>{beam, wall}}) {
    const Sampled found = flush_lines(boxes, camera);
    EXPECT_EQ(found.samples, 4 * samples);
    // Edges that meet in a corner, moved inward by less than a pixel of the grid, may cross there:
    // then the one that goes back is drawn, over a sample or two.
    EXPECT_LE(found.counted, 2);
  }
}

}  // namespace
}  // namespace illustrate
