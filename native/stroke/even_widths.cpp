#include "stroke/even_widths.h"

#include <algorithm>
#include <cmath>

namespace illustrate {
namespace {

// The integral of the width along a path, three times round a closed one: in the middle every point
// has all its neighbours.
class WidthIntegral {
 public:
  explicit WidthIntegral(const StrokePath& path)
      : path_(path),
        at_(path.points.size() * (path.closed ? 3 : 1), 0),
        sum_(at_.size(), 0),
        first_(path.closed ? path.points.size() : 0) {
    for (std::size_t i = 1; i < at_.size(); ++i) {
      const double step = (point(i).image - point(i - 1).image).norm();
      at_[i] = at_[i - 1] + step;
      sum_[i] = sum_[i - 1] + step * (point(i).width + point(i - 1).width) / 2;
    }
  }

  // The mean width within a reach of point i, no farther than the path's own length.
  double mean_round(std::size_t i, double reach) const {
    const double length = path_.closed ? at_[first_] / 2 : at_.back();
    const double place = at_[first_ + i], half = std::min(reach, length);
    const double low = std::max(place - half, 0.0), high = std::min(place + half, at_.back());
    return high > low ? (until(high) - until(low)) / (high - low) : point(i).width;
  }

 private:
  const StrokePoint& point(std::size_t i) const { return path_.points[i % path_.points.size()]; }

  double until(double place) const {
    const auto above = std::upper_bound(at_.begin(), at_.end(), place) - at_.begin();
    const std::size_t j = std::min(static_cast<std::size_t>(above), at_.size() - 1);
    const double step = j > 0 ? at_[j] - at_[j - 1] : 0;
    if (!(step > 0)) return sum_[j];
    const double t = std::clamp((place - at_[j - 1]) / step, 0.0, 1.0);
    const double before = point(j - 1).width;
    return sum_[j - 1] + t * step * (before + t / 2 * (point(j).width - before));
  }

  const StrokePath& path_;
  std::vector<double> at_, sum_;
  std::size_t first_;  // of the lap that is asked about
};

}  // namespace

StrokePath with_even_widths(const StrokePath& path, double blend_px, const Camera& camera) {
  if (path.points.size() < 2 || !(blend_px > 0)) return path;
  const StrokePath close = with_close_points(path, blend_px / 4, camera);
  const WidthIntegral widths(close);
  StrokePath result = path;
  result.points.clear();
  for (std::size_t i = 0; i < close.points.size(); ++i) {
    const StrokePoint& p = close.points[i];
    if (!result.points.empty() && result.points.back().image == p.image) continue;
    result.points.push_back({p.position, p.on, p.image, widths.mean_round(i, blend_px / 2)});
  }
  return result;
}

std::vector<StrokePath> parts_with_width(const StrokePath& path, double speck_px) {
  const auto is_bare = [](const StrokePoint& p) { return !(p.width > 0); };
  const auto bare = std::find_if(path.points.begin(), path.points.end(), is_bare);
  if (bare == path.points.end()) return {path};
  StrokePath open = path;
  open.closed = false;
  if (path.closed) {
    std::rotate(open.points.begin(), open.points.begin() + (bare - path.points.begin()),
                open.points.end());
  }
  std::vector<StrokePath> parts;
  for (auto next = open.points.begin(); next != open.points.end();) {
    const auto first = std::find_if_not(next, open.points.end(), is_bare);
    next = std::find_if(first, open.points.end(), is_bare);
    StrokePath part;
    part.points.assign(first, next);
    part.free_start = open.free_start && first == open.points.begin();
    part.free_end = open.free_end && next == open.points.end();
    if (length_of(part) > speck_px) parts.push_back(std::move(part));
  }
  return parts;
}

}  // namespace illustrate
