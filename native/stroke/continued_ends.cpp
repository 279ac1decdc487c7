#include "stroke/continued_ends.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "core/segments.h"

namespace illustrate {
namespace {

constexpr double least_continued_cosine =
    0.866;  // of 30 degrees, between two lines that go on as one

struct End {
  std::size_t path;
  bool at_start;
  Vec2 place;
  Vec2 outward;  // unit
};

// The direction in which an end points is taken over this length: its last segment may be a hook.
constexpr double outward_px = 3;

End end_of(const std::vector<StrokePath>& paths, std::size_t path, bool at_start) {
  const std::vector<StrokePoint>& points = paths[path].points;
  const auto nth = [&](std::size_t i) -> const StrokePoint& {
    return at_start ? points[i] : points[points.size() - 1 - i];
  };
  Vec2 outward = Vec2::Zero();
  for (std::size_t i = 1; i < points.size() && outward.norm() < outward_px; ++i) {
    outward = nth(0).image - nth(i).image;
  }
  return {path, at_start, nth(0).image, outward.stableNormalized()};
}

std::vector<End> free_ends(const std::vector<StrokePath>& paths) {
  std::vector<End> ends;
  for (std::size_t p = 0; p < paths.size(); ++p) {
    if (paths[p].points.size() < 2) continue;
    if (paths[p].free_start) ends.push_back(end_of(paths, p, true));
    if (paths[p].free_end) ends.push_back(end_of(paths, p, false));
  }
  ends.erase(std::remove_if(ends.begin(), ends.end(),
                            [](const End& end) { return !end.place.allFinite(); }),
             ends.end());
  return ends;
}

// Ends in columns of the image, each from its top.
class EndsByPlace {
 public:
  EndsByPlace(std::vector<End> ends, double column_px)
      : ends_(std::move(ends)), column_px_(column_px) {
    std::sort(ends_.begin(), ends_.end(), [&](const End& a, const End& b) {
      return std::tuple(column(a.place.x()), a.place.y()) <
             std::tuple(column(b.place.x()), b.place.y());
    });
  }

  // Calls visit(end) for all within a box. Columns without ends are passed over: a line may come
  // from far beyond the image.
  template <class Visit>
  void within(const Eigen::AlignedBox2d& box, const Visit& visit) const {
    const double low = box.min().y(), last = column(box.max().x());
    if (!box.min().allFinite() || !box.max().allFinite()) return;
    auto end = first_in(column(box.min().x()), low);
    while (end != ends_.end() && column(end->place.x()) <= last) {
      const double here = column(end->place.x());
      if (end->place.y() < low) {
        end = first_in(here, low);
      } else if (end->place.y() > box.max().y()) {
        end = first_behind(here);
      } else {
        if (box.contains(end->place)) visit(*end);
        ++end;
      }
    }
  }

 private:
  using Iterator = std::vector<End>::const_iterator;

  double column(double x) const { return std::floor(x / column_px_); }

  Iterator first_in(double wanted, double low) const {
    return std::partition_point(ends_.begin(), ends_.end(), [&](const End& end) {
      return std::tuple(column(end.place.x()), end.place.y()) < std::tuple(wanted, low);
    });
  }

  Iterator first_behind(double passed) const {
    return std::partition_point(ends_.begin(), ends_.end(),
                                [&](const End& end) { return column(end.place.x()) <= passed; });
  }

  std::vector<End> ends_;
  double column_px_;
};

double widest(const std::vector<StrokePath>& paths) {
  double result = 0;
  for (const StrokePath& path : paths) {
    for (const StrokePoint& p : path.points) result = std::max(result, p.width);
  }
  return result;
}

// Whether a path runs on for so long from a place on its segment i, forwards or backwards.
bool runs_on(const StrokePath& path, std::size_t i, const Vec2& from, bool forwards, double reach) {
  const std::size_t count = path.points.size();
  double length = (path.points[(forwards ? i + 1 : i) % count].image - from).norm();
  for (std::size_t k = 1; k < count && length < reach; ++k) {
    const std::size_t at = forwards ? i + k : i + count - k;
    const bool is_beyond = forwards ? at + 1 >= count : k > i;
    if (is_beyond && !path.closed) return false;
    length += (path.points[(at + 1) % count].image - path.points[at % count].image).norm();
  }
  return length >= reach;
}

class Continuations {
 public:
  Continuations(std::vector<StrokePath>& paths, double reach_px, double near_px)
      : paths_(paths),
        reach_(reach_px),
        near_(near_px),
        margin_(std::max(near_px, widest(paths))),
        ends_(free_ends(paths), 2 * margin_) {}

  void keep() {
    for (std::size_t p = 0; p < paths_.size(); ++p) {
      const std::size_t count = paths_[p].points.size();
      const std::size_t segments =
          paths_[p].closed ? count : count - std::min<std::size_t>(count, 1);
      for (std::size_t i = 0; i < segments; ++i) look_beside(p, i);
    }
  }

 private:
  // At the ends near segment i of a path.
  void look_beside(std::size_t p, std::size_t i) {
    const StrokePath& path = paths_[p];
    const Vec2& a = path.points[i].image;
    const Vec2& b = path.points[(i + 1) % path.points.size()].image;
    const Vec2 margin(margin_, margin_);
    ends_.within({a.cwiseMin(b) - margin, a.cwiseMax(b) + margin}, [&](const End& end) {
      if (end.path != p && goes_on(end, path, i, a, b)) stop_taper(end);
    });
  }

  bool goes_on(const End& end, const StrokePath& path, std::size_t i, const Vec2& a,
               const Vec2& b) const {
    const Vec2 along = b - a;
    const double square = along.squaredNorm();
    if (!(square > 0)) return false;
    const Vec2 foot = a + nearest_share(a, b, end.place) * along;
    if ((foot - end.place).norm() > std::max(near_, path.points[i].width / 2)) return false;
    const double cosine = end.outward.dot(along) / std::sqrt(square);
    return std::abs(cosine) >= least_continued_cosine && runs_on(path, i, foot, cosine > 0, reach_);
  }

  void stop_taper(const End& end) {
    (end.at_start ? paths_[end.path].free_start : paths_[end.path].free_end) = false;
  }

  std::vector<StrokePath>& paths_;
  const double reach_, near_, margin_;
  const EndsByPlace ends_;
};

}  // namespace

void keep_continued_ends(std::vector<StrokePath>& paths, double reach_px, double near_px) {
  Continuations(paths, reach_px, near_px).keep();
}

}  // namespace illustrate
