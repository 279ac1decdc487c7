#include "hatch/streamlines/finish_streamlines.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/angles.h"
#include "hatch/view/hatch_runs.h"

namespace illustrate {
namespace {

// Between points of a finished hatch, in spacings.
constexpr double point_step = 0.2;

// Shorter hatches, in spacings, are not worth a stroke.
constexpr double least_length = 0.4;

class Finisher {
 public:
  explicit Finisher(const HatchView& view) : view_(view) {}

  void add(const Streamline& streamline) {
    streamline_ = &streamline;
    split(0, streamline.nodes.size());
  }

  Hatches take() { return std::move(hatches_); }

 private:
  const std::vector<StreamlineNode>& nodes() const { return streamline_->nodes; }

  // The nodes [from, to), as far as they go with the middle one; then what is left on both sides.
  void split(std::size_t from, std::size_t to) {
    if (to - from < 2) return;
    const std::size_t middle = from + (to - from) / 2;
    const double most = limit_px() / 2;
    std::size_t first = middle, last = middle;
    for (double length = 0; first > from && goes_with(middle, first, first - 1, length, most);) {
      --first;
    }
    for (double length = 0; last + 1 < to && goes_with(middle, last, last + 1, length, most);) {
      ++last;
    }
    add_piece(first, last + 1);
    if (first < middle) split(from, first + 1);
    if (last > middle) split(last, to);
  }

  // Neighbours must not end in a row: golden-ratio steps between .6 and 1 of the greatest length,
  // by the hatches that the object has.
  double limit_px() {
    const double turns = 0.6180339887498949 * static_cast<double>(counts_[streamline_->object]);
    return view_.options.max_length_px * (0.6 + 0.4 * (turns - std::floor(turns)));
  }

  bool goes_with(std::size_t middle, std::size_t last, std::size_t next, double& length,
                 double most) const {
    length += (nodes()[next].image - nodes()[last].image).norm();
    const double turn = nodes()[middle].tangent.dot(nodes()[next].tangent);
    return length <= most && (view_.options.max_turn_deg >= 180 ||
                              turn >= std::cos(radians(view_.options.max_turn_deg)));
  }

  void add_piece(std::size_t from, std::size_t to) {
    if (to - from < 2) return;
    for (std::size_t i = from; i + 1 < to; ++i) {
      add_point(nodes()[i].on, nodes()[i].tangent);
      add_between(i);
    }
    add_point(nodes()[to - 1].on, nodes()[to - 1].tangent);
    close();
  }

  // A cubic through the nodes, put on the surface.
  void add_between(std::size_t i) {
    const StreamlineNode &a = nodes()[i], &b = nodes()[i + 1];
    const double gap = (b.image - a.image).norm();
    const double parts = std::ceil(gap / (point_step * streamline_->spacing));
    const double length = (b.position - a.position).norm();
    const Vec3 from = length * slope_at(i), to = length * slope_at(i + 1);
    for (double k = 1; k < parts; ++k) {
      const double t = k / parts, s = 1 - t;
      const Vec3 way =
          t * t * (3 - 2 * t) * (b.position - a.position) + t * s * s * from - t * t * s * to;
      SurfacePoint on = a.on;
      if (!view_.walker.on_surface().slide(on, way)) return;
      add_point(on, t < 0.5 ? a.tangent : b.tangent);
    }
  }

  // What lies between nodes is clipped as they are: the hatch ends where it would cross a critical
  // curve, where the sheet turns away from the eye, or where it may not run.
  void add_point(const SurfacePoint& on, const Vec3& tangent) {
    const HatchPoint point = view_.walker.point(on);
    if (!view_.may_pass(point) || !view_.area.suits(point, tangent)) return close();
    if (!line_.empty() && !joins(point)) close();
    line_.push_back(point);
  }

  // Round the end of a fold a curve gets from the hidden sheet to the near one past no visible
  // silhouette: the side that is seen tells them apart.
  bool joins(const HatchPoint& point) const {
    const HatchPoint& last = line_.back();
    return view_.walker.facing_at(last.on) * view_.walker.facing_at(point.on) > 0 &&
           !view_.curves.separate(last.image, point.image);
  }

  void close() {
    if (length_px({line_.data(), line_.size()}) >= least_length * streamline_->spacing) {
      hatches_.add({line_.data(), line_.size()}, view_.kind(), streamline_->object);
      ++counts_[streamline_->object];
    }
    line_.clear();
  }

  // Of the curve at a node, by length: of the segments on both sides, the shorter one counts more.
  Vec3 slope_at(std::size_t i) const {
    const auto segment = [&](std::size_t k) -> Vec3 {
      return nodes()[k + 1].position - nodes()[k].position;
    };
    if (i == 0) return unit(segment(0));
    if (i + 1 == nodes().size()) return unit(segment(i - 1));
    const Vec3 before = segment(i - 1), after = segment(i);
    return (after.norm() * unit(before) + before.norm() * unit(after)) /
           std::max(before.norm() + after.norm(), 1e-300);
  }

  static Vec3 unit(const Vec3& v) { return v / std::max(v.norm(), 1e-300); }

  const HatchView& view_;
  const Streamline* streamline_ = nullptr;
  std::vector<HatchPoint> line_;
  Hatches hatches_;
  std::map<int, int> counts_;  // of hatches of each object
};

}  // namespace

Hatches finished(const Streamlines& streamlines, const HatchView& view) {
  Finisher finisher(view);
  for (const Streamline& streamline : streamlines) {
    if (!streamline.is_fixed) finisher.add(streamline);
  }
  return finisher.take();
}

}  // namespace illustrate
