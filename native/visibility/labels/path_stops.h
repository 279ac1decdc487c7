// Where paths meet crossings, and the way from one of these places to another.
#pragma once

#include <limits>

#include "visibility/arrangement/arrangement.h"

namespace illustrate {

// Where a crossing is met along a path: on which strand of it, at which visit of that strand.
struct Stop {
  int path;
  int step;   // index into Path::strands
  int visit;  // index into Arrangement::visits
};

inline bool operator==(const Stop& a, const Stop& b) {
  return a.path == b.path && a.step == b.step && a.visit == b.visit;
}

// The image points of a path from one stop to a later one.
struct Stretch {
  std::vector<Vec2> points;
  int cusps = 0;
  bool found = false;  // false: longer than a repair may be
};

// How far one stretch gets from the other at most; infinite where one was not found.
double gap_px(const Stretch& one, const Stretch& two);

// Of an arrangement as it is; where crossings are dropped from it later this is of no use any more.
class PathStops {
 public:
  explicit PathStops(const Arrangement& arrangement);

  // Where a crossing is in front, and where it is behind.
  const Stop& front(int crossing) const { return stops_[2 * idx(crossing)]; }
  const Stop& back(int crossing) const { return stops_[2 * idx(crossing) + 1]; }

  int strand(const Stop& stop) const {
    return arrangement_.paths()[idx(stop.path)].strands[idx(stop.step)];
  }
  const Visit& visit(const Stop& stop) const {
    return arrangement_.visits(strand(stop))[idx(stop.visit)];
  }

  // The next stop along the path; visit none where an open path ends.
  Stop next(const Stop& stop) const;
  // Forward from one to another on the same path, round a closed one.
  Stretch stretch(const Stop& from, const Stop& to) const;
  // From a stop to the end, or the start, of its strand.
  Stretch stretch_to_end(const Stop& stop, Direction direction) const;
  // The node there.
  int end_node(const Stop& stop, Direction direction) const;
  // Whether the strand crosses another one on the way there.
  bool crosses_before_end(const Stop& stop, Direction direction, int other) const;

 private:
  const Vec2& image(const Stop& stop) const {
    return arrangement_.crossing(visit(stop).crossing).image;
  }

  const Arrangement& arrangement_;
  std::vector<Stop> stops_;  // [2 c] where crossing c is in front, [2 c + 1] where it is behind
};

}  // namespace illustrate
