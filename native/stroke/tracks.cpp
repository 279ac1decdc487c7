#include "stroke/tracks.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <tuple>

#include "hatch/greedy/neighbour_grid.h"
#include "surface/same_objects.h"

namespace illustrate {
namespace {

// In units of paper: between samples of the last strokes and of these, and how far a stroke may
// have moved in the image.
constexpr double last_step = 2;
constexpr double step = 3;
constexpr double reach = 12;
constexpr double near_share = 0.25;  // of it, where a stroke is looked for first

// Silhouettes slide in depth, which counts so much of what it is.
constexpr double depth_share = 0.2;

// Strokes that run more than 45 degrees apart are not one (cosine).
constexpr double least_cosine = 0.7;

// An heir shares so much of the shorter of the two strokes.
constexpr double least_overlap = 0.25;

struct Sample {
  Vec2 image;
  Vec2 heading;      // unit
  double depth = 0;  // px
  int stroke = none;
  double along = 0;  // px from the stroke's first point, in its own image
};

// What may be one stroke in two frames.
using Group = std::tuple<Kind, int, bool>;

Group group_of(const Drawing& drawing, int stroke) {
  const Kind kind = drawing.kinds[idx(stroke)];
  return {kind == Kind::cross_hatch ? Kind::hatch : kind, drawing.objects[idx(stroke)],
          drawing.invisibility[idx(stroke)] > 0};
}

int count_of(const Drawing& drawing) { return static_cast<int>(drawing.kinds.size()); }

// The segments of a stroke as pairs of points, that back to the first one too.
template <class Visit>
void visit_segments(const Drawing& drawing, int stroke, const Visit& visit) {
  const int first = drawing.offsets[idx(stroke)], end = drawing.offsets[idx(stroke) + 1];
  for (int i = first; i + 1 < end; ++i) visit(idx(i), idx(i + 1));
  if (drawing.closed[idx(stroke)] && end - first > 1) visit(idx(end - 1), idx(first));
}

double length_of(const Drawing& drawing, int stroke) {
  double length = 0;
  visit_segments(drawing, stroke, [&](std::size_t a, std::size_t b) {
    length += (drawing.image[b] - drawing.image[a]).norm();
  });
  return length;
}

// Samples about `step_px` apart, of the strokes of a drawing whose points are at `points` now, as
// far as they are before the camera.
std::vector<Sample> samples_of(const Drawing& drawing, int stroke, const Points& points,
                               const Camera& camera, double step_px) {
  std::vector<Sample> samples;
  double before = 0;
  visit_segments(drawing, stroke, [&](std::size_t a, std::size_t b) {
    const double length = (drawing.image[b] - drawing.image[a]).norm();
    const double parts = std::max(1.0, std::round(length / step_px));
    const bool is_seen = camera.near_distance(points[a]) > 0 && camera.near_distance(points[b]) > 0;
    for (double k = 0.5; is_seen && k < parts; ++k) {
      const Vec3 p = points[a] + k / parts * (points[b] - points[a]);
      const Vec2 way = camera.project(points[b]).xy - camera.project(points[a]).xy;
      if (way.norm() > 0) {
        samples.push_back({camera.project(p).xy, way.normalized(),
                           camera.depth(p) / camera.pixel_size(p), stroke,
                           before + k / parts * length});
      }
    }
    before += length;
  });
  return samples;
}

// Where the points of the last drawing are on the surface as it is now. Points of no surface, and
// of objects that are not the same, are where they were.
Points moved_points(const Drawing& last, const Surface& surface,
                    const std::vector<int>& last_objects) {
  Points points = last.points;
  if (!last.surface) return points;
  const SameObjects same(*last.surface, surface, last_objects);
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (last.on[i].triangle == none || !same.has(last.on[i])) continue;
    points[i] += same.position(last.on[i]) - position_at(*last.surface, last.on[i]);
  }
  return points;
}

// Finds the nearest place on the strokes of the last drawing.
class LastStrokes {
 public:
  LastStrokes(const Drawing& last, const Points& points, const Camera& camera, double unit_px)
      : last_(last),
        reach_(reach * unit_px),
        grid_(camera.width_px(), camera.height_px(), near_share * reach_) {
    for (int s = 0; s < count_of(last); ++s) {
      for (const Sample& sample : samples_of(last, s, points, camera, last_step * unit_px)) {
        grid_.add({sample.image, Vec3::Zero(), static_cast<int>(samples_.size())});
        samples_.push_back(sample);
      }
    }
  }

  const Sample* nearest(const Sample& sample, const Group& group) const {
    Near near;
    // Most are near by: what is found there is nearer than all farther away.
    find_within(near_share * reach_, sample, group, near);
    if (!near.sample) find_within(reach_, sample, group, near);
    return near.sample;
  }

 private:
  struct Near {
    const Sample* sample = nullptr;
    double square = 0;  // of its distance, px
  };

  void find_within(double radius, const Sample& sample, const Group& group, Near& near) const {
    near.square = radius * radius;
    grid_.any_within(sample.image, radius, [&](const HatchNode& node) {
      const Sample& other = samples_[idx(node.point)];
      const double deep = depth_share * (other.depth - sample.depth);
      const double square = (other.image - sample.image).squaredNorm() + deep * deep;
      if (square < near.square && suits(sample, other, group)) near = {&other, square};
      return false;
    });
  }

  bool suits(const Sample& sample, const Sample& other, const Group& group) const {
    const double cosine = sample.heading.dot(other.heading);
    const bool may_turn = std::get<Kind>(group) != Kind::silhouette;
    return (may_turn ? std::abs(cosine) : cosine) > least_cosine &&
           group_of(last_, other.stroke) == group;
  }

  const Drawing& last_;
  double reach_;
  NeighbourGrid grid_;
  std::vector<Sample> samples_;
};

// How a stroke lies on one of the last frame.
struct Overlap {
  int stroke = none, last = none;
  double length = 0;                           // px
  double turned = 0;                           // px of it that run the other way
  std::vector<std::array<double, 2>> matches;  // along the stroke, along the last one
};

class Follower {
 public:
  // last_objects: (objects) of the last drawing; empty: the same numbers.
  Follower(Drawing& drawing, const Drawing& last, const std::vector<int>& last_objects)
      : drawing_(drawing), last_(last), last_objects_(last_objects) {}

  void run(const Points& moved, const Camera& camera, double unit_px) {
    const LastStrokes strokes(last_, moved, camera, unit_px);
    for (int s = 0; s < count_of(drawing_); ++s) match(s, strokes, camera, step * unit_px);
    name();
    for (const int overlap : longest_) {
      if (overlap != none) carry(overlaps_[idx(overlap)]);
    }
  }

 private:
  // What the stroke may have been: of no object that there was, where its own is new.
  Group last_group(int stroke) const {
    auto [kind, object, is_hidden] = group_of(drawing_, stroke);
    constexpr int of_no_object = -2;  // none: strokes that are of none
    const bool is_mapped = object != none && !last_objects_.empty();
    const int last = is_mapped ? last_objects_[idx(object)] : object;
    return {kind, is_mapped && last == none ? of_no_object : last, is_hidden};
  }

  void match(int stroke, const LastStrokes& strokes, const Camera& camera, double step_px) {
    std::map<int, Overlap> found;
    const Group group = last_group(stroke);
    for (const Sample& sample : samples_of(drawing_, stroke, drawing_.points, camera, step_px)) {
      const Sample* other = strokes.nearest(sample, group);
      if (!other) continue;
      Overlap& overlap = found[other->stroke];
      overlap.length += step_px;
      if (sample.heading.dot(other->heading) < 0) overlap.turned += step_px;
      const double beyond = (sample.image - other->image).dot(other->heading);
      overlap.matches.push_back({sample.along, other->along + beyond});
    }
    longest_.push_back(none);
    for (auto& [last, overlap] : found) {
      overlap.stroke = stroke;
      overlap.last = last;
      int& longest = longest_.back();
      if (longest == none || overlap.length > overlaps_[idx(longest)].length) {
        longest = static_cast<int>(overlaps_.size());
      }
      overlaps_.push_back(std::move(overlap));
    }
  }

  // The longest overlaps first: each gives its last stroke's number on, where neither has one yet.
  void name() {
    std::vector<int> order(overlaps_.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [&](int a, int b) {
      return overlaps_[idx(a)].length > overlaps_[idx(b)].length;
    });
    StrokeTracks& tracks = drawing_.tracks;
    tracks = {last_.tracks.frame + 1, {}, {}, {}, {}, last_.tracks.next_id};
    tracks.ids.assign(drawing_.kinds.size(), none);
    tracks.births.assign(drawing_.kinds.size(), tracks.frame);
    tracks.starts.assign(drawing_.kinds.size(), 0);
    std::vector<std::uint8_t> has_heir(last_.kinds.size(), 0);
    for (const int i : order) {
      const Overlap& o = overlaps_[idx(i)];
      if (has_heir[idx(o.last)] || tracks.ids[idx(o.stroke)] != none || !is_same(o)) continue;
      has_heir[idx(o.last)] = 1;
      tracks.ids[idx(o.stroke)] = last_.tracks.ids[idx(o.last)];
      tracks.births[idx(o.stroke)] = last_.tracks.births[idx(o.last)];
    }
    for (int& id : tracks.ids) {
      if (id == none) id = tracks.next_id++;
    }
    for (std::size_t s = 0; s < has_heir.size(); ++s) {
      if (!has_heir[s]) tracks.deaths.push_back(last_.tracks.ids[s]);
    }
    std::sort(tracks.deaths.begin(), tracks.deaths.end());
  }

  bool is_same(const Overlap& overlap) const {
    return overlap.length >= least_overlap * std::min(length_of(drawing_, overlap.stroke),
                                                      length_of(last_, overlap.last));
  }

  // Direction, first point and where it counts from, as the last stroke has them.
  void carry(Overlap& overlap) {
    const double length = length_of(drawing_, overlap.stroke);
    if (2 * overlap.turned > overlap.length) {
      turn(overlap.stroke);
      for (auto& match : overlap.matches) match[0] = length - match[0];
    }
    const bool both_close = drawing_.closed[idx(overlap.stroke)] && last_.closed[idx(overlap.last)];
    if (both_close) rotate(overlap, length);
    std::vector<double> shifts;
    for (const auto& [now, then] : overlap.matches) {
      const double shift = then - now;
      if (!both_close || std::abs(shift) < length / 2) shifts.push_back(shift);
    }
    if (shifts.empty()) return;
    const auto middle = shifts.begin() + static_cast<std::ptrdiff_t>(shifts.size() / 2);
    std::nth_element(shifts.begin(), middle, shifts.end());
    drawing_.tracks.starts[idx(overlap.stroke)] = last_.tracks.starts[idx(overlap.last)] + *middle;
  }

  // All that a stroke has of each point, by `change(first, last)`.
  template <class Change>
  void change_points(int stroke, const Change& change) {
    const auto from = drawing_.offsets[idx(stroke)], to = drawing_.offsets[idx(stroke) + 1];
    const auto each = [&](auto& values) { change(values.begin() + from, values.begin() + to); };
    each(drawing_.points);
    each(drawing_.image);
    each(drawing_.widths);
    each(drawing_.on);
  }

  void turn(int stroke) {
    change_points(stroke, [](auto first, auto last) { std::reverse(first, last); });
  }

  // A closed stroke begins at the point nearest to where the last one began.
  void rotate(Overlap& overlap, double length) {
    const auto begins = std::min_element(overlap.matches.begin(), overlap.matches.end(),
                                         [](const auto& a, const auto& b) { return a[1] < b[1]; });
    const double goal = (*begins)[0] - (*begins)[1];
    double before = 0, least = std::numeric_limits<double>::infinity(), passed = 0;
    std::size_t first = 0, k = 0;
    visit_segments(drawing_, overlap.stroke, [&](std::size_t a, std::size_t b) {
      const double off = std::abs(std::remainder(before - goal, length));
      if (off < least) {
        least = off;
        passed = before;
        first = k;
      }
      before += (drawing_.image[b] - drawing_.image[a]).norm();
      ++k;
    });
    change_points(overlap.stroke, [&](auto begin, auto end) {
      std::rotate(begin, begin + static_cast<std::ptrdiff_t>(first), end);
    });
    for (auto& match : overlap.matches) {
      match[0] -= passed;
      if (match[0] < 0) match[0] += length;
    }
  }

  Drawing& drawing_;
  const Drawing& last_;
  const std::vector<int>& last_objects_;
  std::vector<Overlap> overlaps_;
  std::vector<int> longest_;  // (s) of the overlaps, or none
};

}  // namespace

StrokeTracks first_tracks(const Drawing& drawing) {
  StrokeTracks tracks;
  tracks.next_id = count_of(drawing);
  tracks.ids.resize(drawing.kinds.size());
  std::iota(tracks.ids.begin(), tracks.ids.end(), 0);
  tracks.births.assign(drawing.kinds.size(), 0);
  tracks.starts.assign(drawing.kinds.size(), 0);
  return tracks;
}

void follow_strokes(Drawing& drawing, const Drawing& last, const Surface& surface,
                    const Camera& camera, double unit_px) {
  const std::vector<int> last_objects = objects_by_name(last.object_names, drawing.object_names);
  const Points moved = moved_points(last, surface, last_objects);
  Follower(drawing, last, last_objects).run(moved, camera, unit_px);
}

}  // namespace illustrate
