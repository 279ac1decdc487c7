// How large a surface is, alike however it is turned and wherever it is.
#pragma once

#include "core/types.h"

namespace illustrate {

// Triangles, and how far they reach from their middle. A box round them, which is usual, depends on
// the axes: of a cube it grows by half as it turns, and what is told by it changes.
class Spread {
 public:
  void add(const Vec3& a, const Vec3& b, const Vec3& c);

  // The diagonal of a box in which points spread evenly vary as much as on the triangles: of balls,
  // rods and plates that of the box round them, of a cube a quarter more. 0 without area.
  double diagonal() const;
  Vec3 middle() const;  // of the area; without any, the first corner
  double area() const { return area_ / (per_unit_ * per_unit_); }

 private:
  // Squares of squares are summed: what may be very large or very small is measured in a unit near
  // the size of the first triangle, a power of two.
  void measure_from(const Vec3& a, const Vec3& b, const Vec3& c);

  Vec3 origin_ = Vec3::Zero();  // the first corner
  double per_unit_ = 1;
  double area_ = 0;
  Vec3 sum_ = Vec3::Zero();  // of the places from there, and of their squares, over the area
  double squares_ = 0;
};

// The size by which the rounding of coordinates in single precision is told. It grows with the
// distance from the origin, which counts in octaves of the size, and only where it is so large that
// shifts by a few sizes hardly change it: what is decided by it does not change as a scene moves.
double rounding_size(double size, double distance);

}  // namespace illustrate
