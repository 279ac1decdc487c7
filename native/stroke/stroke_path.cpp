#include "stroke/stroke_path.h"

#include <algorithm>
#include <cmath>

namespace illustrate {
namespace {

// A tapered end starts at this share of the width and follows a parabola through these shares of
// the taper's length.
constexpr double tip_width = 0.15;
constexpr std::array<double, 3> taper_steps{1.0 / 3, 2.0 / 3, 1.0};

constexpr double most_pieces = 4096;  // of one segment

double clip_w(const Camera& camera, const Vec3& p) {
  return camera.projection().row(3).dot(camera.view() * p.homogeneous());
}

SurfacePoint on_between(const SurfacePoint& a, const SurfacePoint& b, double s) {
  if (a.triangle != b.triangle) return s < 0.5 ? a : b;
  return {a.triangle, a.b1 + s * (b.b1 - a.b1), a.b2 + s * (b.b2 - a.b2)};
}

// The share [from, to] of a segment that lies inside the frame; from > to: none. Values that are
// not finite give none.
struct Share {
  double from = 0;
  double to = 1;
  bool is_empty() const { return !(from <= to); }
};

Share share_inside(const Vec2& a, const Vec2& b, const Vec2& frame) {
  Share share;
  for (int axis = 0; axis < 2; ++axis) {
    const double step = b[axis] - a[axis];
    if (step == 0) {
      if (!(a[axis] >= 0 && a[axis] <= frame[axis])) return {1, 0};
      continue;
    }
    const double at_low = -a[axis] / step;
    const double at_high = (frame[axis] - a[axis]) / step;
    if (!std::isfinite(at_low) || !std::isfinite(at_high)) return {1, 0};
    share.from = std::max(share.from, std::min(at_low, at_high));
    share.to = std::min(share.to, std::max(at_low, at_high));
  }
  return share;
}

bool is_inside(const Vec2& p, const Vec2& frame) {
  return p.x() >= 0 && p.x() <= frame.x() && p.y() >= 0 && p.y() <= frame.y();
}

// Cuts an open path into its parts inside the frame.
class FrameCutter {
 public:
  FrameCutter(const Camera& camera, const Vec2& frame) : camera_(camera), frame_(frame) {}

  std::vector<StrokePath> cut(const StrokePath& path) {
    const std::vector<StrokePoint>& p = path.points;
    part_.free_start = path.free_start && is_inside(p.front().image, frame_);
    for (std::size_t i = 0; i + 1 < p.size(); ++i) add_segment(p[i], p[i + 1]);
    part_.free_end = path.free_end && is_inside(p.back().image, frame_);
    end_part();
    return std::move(parts_);
  }

 private:
  void add_segment(const StrokePoint& a, const StrokePoint& b) {
    const Share share = share_inside(a.image, b.image, frame_);
    if (share.is_empty()) return end_part();
    if (share.from > 0) {
      end_part();
      part_.points.push_back(on_frame(a, b, share.from));
    } else if (part_.points.empty()) {
      part_.points.push_back(a);
    }
    if (share.to < 1) {
      part_.points.push_back(on_frame(a, b, share.to));
      end_part();
    } else {
      part_.points.push_back(b);
    }
  }

  StrokePoint on_frame(const StrokePoint& a, const StrokePoint& b, double t) const {
    StrokePoint p = point_between(a, b, t, camera_);
    p.image = p.image.cwiseMax(Vec2::Zero()).cwiseMin(frame_);
    return p;
  }

  void end_part() {
    if (length_of(part_) > 0) parts_.push_back(std::move(part_));
    part_ = {};
  }

  const Camera& camera_;
  const Vec2 frame_;
  StrokePath part_;
  std::vector<StrokePath> parts_;
};

// The closed path as an open one that starts and ends at its first point outside the frame.
StrokePath opened_outside(const StrokePath& path, const Vec2& frame) {
  StrokePath open;
  open.points = path.points;
  const auto outside = std::find_if(open.points.begin(), open.points.end(),
                                    [&](const auto& p) { return !is_inside(p.image, frame); });
  std::rotate(open.points.begin(), outside, open.points.end());
  open.points.push_back(open.points.front());
  return open;
}

// What simplification must keep: image, width, and the place in the world in pixels, which counts
// less.
using Place = Eigen::Matrix<double, 6, 1>;
constexpr double world_share = 0.2;

// Squared distances that differ by less than this share are the same: a symmetric line is not to
// change where rounding does.
constexpr double same_distance = 1e-3;

std::vector<Place> places_of(const std::vector<StrokePoint>& points, double pixel_size) {
  std::vector<Place> places;
  for (const StrokePoint& p : points) {
    const Vec3 world = (p.position - points.front().position) * (world_share / pixel_size);
    places.push_back((Place() << p.image, p.width, world).finished());
  }
  return places;
}

struct Farthest {
  std::size_t index;
  double square;  // of its distance
};

// Of the points strictly between two, the one farthest from their chord; of several as far but for
// the rounding to the image grid, the first.
Farthest farthest_between(const std::vector<Place>& points, std::size_t first, std::size_t last) {
  const Place &start = points[first], chord = points[last] - start;
  const double square = chord.squaredNorm(), per_square = square > 0 ? 1 / square : 0;
  Farthest found{first, -1};
  for (std::size_t i = first + 1; i < last; ++i) {
    const Place offset = points[i] - start;
    const double t = std::clamp(offset.dot(chord) * per_square, 0.0, 1.0);
    const double distance = (offset - t * chord).squaredNorm();
    if (distance > found.square * (1 + same_distance)) found = {i, distance};
  }
  return found;
}

void mark_needed(const std::vector<Place>& points, std::size_t begin, std::size_t end,
                 double tolerance, std::vector<std::uint8_t>& needed) {
  std::vector<std::array<std::size_t, 2>> open{{begin, end}};
  needed[begin] = needed[end] = 1;
  while (!open.empty()) {
    const auto [first, last] = open.back();
    open.pop_back();
    const Farthest far = farthest_between(points, first, last);
    if (far.square <= tolerance * tolerance) continue;
    needed[far.index] = 1;
    open.push_back({first, far.index});
    open.push_back({far.index, last});
  }
}

// Points at distances from the start of an open path, each between the two that enclose it.
StrokePath with_points_at(const StrokePath& path, const std::vector<double>& distances,
                          const Camera& camera) {
  StrokePath result = path;
  result.points.clear();
  double gone = 0;
  std::size_t next = 0;
  for (std::size_t i = 0; i + 1 < path.points.size(); ++i) {
    const StrokePoint& a = path.points[i];
    const StrokePoint& b = path.points[i + 1];
    const double length = (b.image - a.image).norm();
    result.points.push_back(a);
    for (; next < distances.size() && distances[next] < gone + length; ++next) {
      const double t = (distances[next] - gone) / length;
      if (t > 0) result.points.push_back(point_between(a, b, t, camera));
    }
    gone += length;
  }
  result.points.push_back(path.points.back());
  return result;
}

double thinned(double share_of_taper) {
  const double rest = 1 - std::clamp(share_of_taper, 0.0, 1.0);
  return 1 - (1 - tip_width) * rest * rest;
}

}  // namespace

double piece_count(const Vec2& segment, double step_px) {
  return std::min(std::ceil(segment.norm() / step_px), most_pieces);
}

StrokePath with_close_points(const StrokePath& path, double step_px, const Camera& camera) {
  StrokePath result = path;
  result.points.clear();
  const std::size_t count = path.points.size();
  for (std::size_t i = 0; i < count; ++i) {
    const StrokePoint& a = path.points[i];
    result.points.push_back(a);
    if (i + 1 == count && !path.closed) break;
    const StrokePoint& b = path.points[(i + 1) % count];
    const double pieces = piece_count(b.image - a.image, step_px);
    for (int k = 1; k < pieces; ++k) {
      result.points.push_back(point_between(a, b, k / pieces, camera));
    }
  }
  return result;
}

double length_of(const StrokePath& path) {
  double length = 0;
  for (std::size_t i = 1; i < path.points.size(); ++i) {
    length += (path.points[i].image - path.points[i - 1].image).norm();
  }
  return length;
}

StrokePoint point_between(const StrokePoint& a, const StrokePoint& b, double t,
                          const Camera& camera) {
  const double weight_a = (1 - t) * clip_w(camera, b.position);
  const double weight_b = t * clip_w(camera, a.position);
  const double sum = weight_a + weight_b;
  const double s = sum > 0 ? std::clamp(weight_b / sum, 0.0, 1.0) : t;
  return {a.position + s * (b.position - a.position), on_between(a.on, b.on, s),
          a.image + t * (b.image - a.image), a.width + t * (b.width - a.width)};
}

std::vector<StrokePath> clip_at_frame(const StrokePath& path, const Camera& camera) {
  const Vec2 frame(camera.width_px(), camera.height_px());
  if (path.points.size() < 2) return {};
  const bool whole = std::all_of(path.points.begin(), path.points.end(),
                                 [&](const auto& p) { return is_inside(p.image, frame); });
  if (whole && length_of(path) > 0) return {path};
  if (whole) return {};
  return FrameCutter(camera, frame).cut(path.closed ? opened_outside(path, frame) : path);
}

StrokePath simplify(const StrokePath& path, double tolerance_px, double pixel_size) {
  StrokePath result = path;
  const std::size_t count = path.points.size();
  if (count < 3 || (path.closed && count < 4)) return result;
  std::vector<Place> points = places_of(path.points, pixel_size);
  std::vector<std::uint8_t> needed(count + 1, 0);
  if (path.closed) {
    points.push_back(points.front());
    const std::size_t far = farthest_between(points, 0, count).index;
    const Farthest before = farthest_between(points, 0, far);
    const Farthest after = farthest_between(points, far, count);
    needed[before.square > after.square ? before.index : after.index] = 1;
    mark_needed(points, 0, far, tolerance_px, needed);
    mark_needed(points, far, count, tolerance_px, needed);
  } else {
    mark_needed(points, 0, count - 1, tolerance_px, needed);
  }
  result.points.clear();
  for (std::size_t i = 0; i < count; ++i) {
    if (needed[i]) result.points.push_back(path.points[i]);
  }
  return result;
}

StrokePath taper(const StrokePath& path, double taper_px, const Camera& camera) {
  const double length = length_of(path);
  const double reach = std::min(taper_px, length / 3);
  if (!(reach > 0) || !(path.free_start || path.free_end)) return path;
  std::vector<double> distances;
  for (const double step : taper_steps) {
    if (path.free_start) distances.push_back(step * reach);
    if (path.free_end) distances.push_back(length - step * reach);
  }
  std::sort(distances.begin(), distances.end());
  StrokePath result = with_points_at(path, distances, camera);
  double gone = 0;
  for (std::size_t i = 0; i < result.points.size(); ++i) {
    if (i > 0) gone += (result.points[i].image - result.points[i - 1].image).norm();
    if (path.free_start) result.points[i].width *= thinned(gone / reach);
    if (path.free_end) result.points[i].width *= thinned((length - gone) / reach);
  }
  return result;
}

}  // namespace illustrate
