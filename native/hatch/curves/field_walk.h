// Walking over the triangles of the surface, whatever the view: along the cross field, or straight.
#pragma once

#include "field/cross_field.h"

namespace illustrate {

// A straight way through one triangle, in units of length.
struct Course {
  Vec3 direction;                // that was asked for
  std::array<double, 3> change;  // of the weights
  double exit = 0;               // length to the edge
  int exit_edge = none;          // none: the triangle has no area, or there is no way
};

// Tells a walk that gets nowhere: round a vertex it may cross edge after edge without end.
class Headway {
 public:
  explicit Headway(double length) : least_(least_share * length), last_(length) {}

  // Asked at each edge, with the length that is left: false where none of the last edges have
  // brought the walk on, or it has crossed more than any walk needs.
  bool is_made(double left) {
    if (++crossings_ % between_looks != 0) return true;
    const bool is_less = last_ - left > least_;
    last_ = left;
    return is_less && crossings_ < most_crossings;
  }

 private:
  static constexpr int between_looks = 64;     // edges; few vertices have as many
  static constexpr double least_share = 1e-6;  // of the length, between looks
  static constexpr int most_crossings = 4096;

  double least_, last_;
  int crossings_ = 0;
};

// Lines are straight inside each triangle and go on in the triangle across the edge. Across the
// seam of a double cover only the sheet's normal changes sign. Nothing crosses boundaries, creases
// or seams.
class FieldWalker {
 public:
  FieldWalker(const Surface& surface, const CrossField& field) : surface_(surface), field_(field) {}

  const Surface& surface() const { return surface_; }
  const CrossField& field() const { return field_; }

  Course course(const SurfacePoint& on, const Vec3& direction) const;

  // In the direction of the cross at the middle of the way (second order), at most `reach` long. A
  // walk that would turn back over the edge it came by, `entry_edge`, slides along that edge.
  Course course_along_cross(const SurfacePoint& on, const Vec3& tangent, int entry_edge,
                            double reach) const;

  static void move(SurfacePoint& on, const Course& course, double length);

  // Into the triangle across an edge, which becomes the entry edge; false where none may be
  // crossed. `side` changes its sign with the sheet's normal.
  bool cross_edge(SurfacePoint& on, int edge, int& entry_edge, double& side) const;

  // Along the branch of the cross nearest to `tangent`, which is kept up to date. The length that
  // is left where the surface ends, 0 where all of it was walked.
  double advance(SurfacePoint& on, Vec3& tangent, double length) const;

  // Straight by `run`, turned into each triangle's plane; false where something ends it before.
  bool slide(SurfacePoint& on, Vec3 run) const;

 private:
  const Surface& surface_;
  const CrossField& field_;
};

}  // namespace illustrate
