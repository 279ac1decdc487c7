// One stroke on its way to the drawing: clipped at the frame, simplified, tapered.
#pragma once

#include "core/types.h"
#include "view/camera.h"

namespace illustrate {

struct StrokePoint {
  Vec3 position;
  SurfacePoint on;
  Vec2 image;
  double width = 0;  // px
};

struct StrokePath {
  std::vector<StrokePoint> points;  // closed: the first is not repeated
  bool closed = false;
  bool free_start = false;  // ends that meet no other line thin out; never true where closed
  bool free_end = false;
};

// The point where the image segment from a to b has gone the share t of its length. World points
// follow in perspective.
StrokePoint point_between(const StrokePoint& a, const StrokePoint& b, double t,
                          const Camera& camera);

// How many pieces of at most `step_px` a segment of the image has; 4096 where they would be more.
double piece_count(const Vec2& segment, double step_px);

// With points between those that are more than `step_px` apart: between such pieces.
StrokePath with_close_points(const StrokePath& path, double step_px, const Camera& camera);

// In the image, of an open path.
double length_of(const StrokePath& path);

// The parts inside the frame, in order. A closed path that is cut becomes open ones; cut ends are
// not free. Parts of no length are dropped.
std::vector<StrokePath> clip_at_frame(const StrokePath& path, const Camera& camera);

// Douglas-Peucker in (x, y, width): nothing moves by more than `tolerance_px`, and in the world by
// no more than five times that, so that a stroke does not sink into its surface. `pixel_size`:
// world length of a pixel at the path. Open paths keep their ends, closed ones three points far
// apart.
StrokePath simplify(const StrokePath& path, double tolerance_px, double pixel_size);

// Thins free ends over `taper_px`, on a short stroke over at most a third of it, adding points
// where needed.
StrokePath taper(const StrokePath& path, double taper_px, const Camera& camera);

}  // namespace illustrate
