// Whether two triangles of a surface cross, decided exactly, for `intersections` only.
#pragma once

#include "contour/intersection/intersections.h"
#include "surface/surface.h"

namespace illustrate {

// Where an edge pierces a triangle. The same for all triangles round the edge: this is what links
// segments.
struct Piercing {
  int low, high;  // places of the edge's ends, low < high
  int triangle;   // the pierced one

  bool operator==(const Piercing& other) const {
    return low == other.low && high == other.high && triangle == other.triangle;
  }
  bool operator<(const Piercing& other) const {
    if (low != other.low) return low < other.low;
    if (high != other.high) return high < other.high;
    return triangle < other.triangle;
  }
};

// Whether the smaller of two triangles lies no farther than this from the plane of the larger one.
bool lie_in_one_plane(const std::array<Vec3, 3>& a, const std::array<Vec3, 3>& b, double distance);

enum class TriangleIntersection { apart, segment, undecided };

class CrossingTest {
 public:
  explicit CrossingTest(const Surface& surface);

  // segment: the triangles share a segment between the two ends.
  TriangleIntersection cross(int s, int t, std::array<Piercing, 2>& ends) const;

  // How far along its edge, from low to high, a piercing lies.
  double parameter(const Piercing& piercing) const;

  // Where a piercing is once everything is moved inward, world units.
  Vec3 decided(const Piercing& piercing) const;

  // Whether two triangles of different parts lie in one plane, up to `reach`, and face the same
  // way, or one is a sliver, no wider than that. Whether they overlap is not asked.
  bool are_flush(int s, int t) const;

  // The connected part of the surface that a triangle belongs to.
  int part(int triangle) const { return parts_[idx(triangles_[idx(triangle)][0])]; }

  // Of a piercing, in a triangle that it lies in.
  SurfacePoint surface_point(const Piercing& piercing, int triangle) const;

  // Of the vertices of the surface, world units.
  Insets insets(const Surface& surface) const;

  // How near each other, in world units, the boxes of triangles that cross or are flush are.
  double reach() const;

  // How far apart triangles that were moved and lie in one plane may be by rounding, world units.
  double one_plane() const;

  // A vertex at each place.
  const std::vector<int>& vertices() const { return vertices_; }

 private:
  using Sides = std::array<int, 3>;
  struct Ends;

  const Vec3& at(int triangle, int corner) const {
    return points_[idx(triangles_[idx(triangle)][idx(corner)])];
  }
  const Vec3& moved(int triangle, int corner) const {
    return moved_[idx(triangles_[idx(triangle)][idx(corner)])];
  }
  void place_vertices(const Surface& surface);
  void scale_points(const Surface& surface);
  void measure_size();
  void choose_inset();
  void move_points_inward(const Surface& surface);
  void retract_borders(const Surface& surface);
  void number_parts();
  int side(int a, int b, int c, int d) const;
  Sides filtered_sides(int triangle, int other) const;
  bool share_vertex_or_are_flat(int s, int t) const;
  bool has_separating_edge(int s, int t) const;
  bool are_coplanar(int s, int t) const;
  bool pierces(int a, int b, int triangle) const;
  // Where an edge meets the triangle's plane, and how far the farther of its ends is from it.
  double share_to_plane(const Points& points, const Piercing& piercing, double& farther) const;
  SurfacePoint projected(const Vec3& point, int triangle) const;
  void add_piercings(int triangle, int other, Ends& ends) const;

  std::vector<Triangle> triangles_;  // places
  std::vector<int> vertices_;        // (places)
  Points points_;                    // (places) from middle_, the largest coordinate 1 .. 2
  Points moved_;                     // (places) points_ moved inward: what is decided on
  std::vector<int> parts_;           // (places) connected part, numbered by first place
  int part_count_ = 0;
  Vec3 middle_ = Vec3::Zero();  // of all corners, world units
  double scale_ = 1;            // world length of 1 in points_
  double size_ = 0;             // how far points_ are from their middle
  double inset_ = 0;            // how far points are moved, in points_
  double one_plane_ = 0;        // and how far apart those of one plane may be then
};

}  // namespace illustrate
