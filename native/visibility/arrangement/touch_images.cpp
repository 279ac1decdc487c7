#include "visibility/arrangement/touch_images.h"

#include <algorithm>
#include <limits>

#include "core/segments.h"
#include "visibility/labels/repairs.h"

namespace illustrate {
namespace {

// A strand from a joint at one of its ends up to a crossing: its points, the joint's first.
struct Way {
  int strand = none;
  bool forward = true;
  int count = 0;
};

// What stands out farther is not the noise of two polylines of one fold: a hook of the contour
// beyond the joint, say.
constexpr double farthest_move_px = 0.1;

struct Foot {
  Vec2 point;
  bool is_left;  // whether what it is the foot of is left of the way, as the viewer sees it
};

Foot nearest_on(const std::vector<Vec2>& line, const Vec2& p) {
  Foot result{p, false};
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const Vec2 along = line[i + 1] - line[i];
    if (along.squaredNorm() == 0) continue;
    const Vec2 foot = line[i] + nearest_share(line[i], line[i + 1], p) * along;
    const double distance = (p - foot).squaredNorm();
    if (distance >= least) continue;
    least = distance;
    result = {foot, cross(along, p - line[i]) < 0};  // y is down
  }
  return result;
}

class TouchImages {
 public:
  explicit TouchImages(Arrangement& arrangement)
      : arrangement_(arrangement), network_(*arrangement.network) {}

  void pull(int touch) {
    const Crossing& x = arrangement_.crossings[idx(touch)];
    const bool is_front = network_.strands[idx(x.front.strand)].kind == Kind::silhouette;
    Way contour, curve;
    if (!find_ways(is_front ? x.front : x.back, is_front ? x.back : x.front, contour, curve))
      return;
    const Strand& strand = network_.strands[idx(contour.strand)];
    const bool surface_is_left = (strand.left_layers > strand.right_layers) == contour.forward;
    move(curve, line(contour, x.image), !surface_is_left);
    move(contour, line(curve, x.image), surface_is_left);
  }

 private:
  // The shortest ones that start at one joint, or no farther apart than a cusp at the end of a
  // contour from it; false where there are none.
  bool find_ways(const StrandPlace& a, const StrandPlace& b, Way& one, Way& two) {
    int least = std::numeric_limits<int>::max();
    for (const bool a_forward : {true, false}) {
      for (const bool b_forward : {true, false}) {
        const Way from_a = way(a, a_forward), from_b = way(b, b_forward);
        if ((image(from_a, 0) - image(from_b, 0)).norm() > end_px) continue;
        if (from_a.count + from_b.count >= least) continue;
        least = from_a.count + from_b.count;
        one = from_a;
        two = from_b;
      }
    }
    return one.strand != none;
  }

  Way way(const StrandPlace& to, bool forward) const {
    const int points = arrangement_.point_count(to.strand);
    return {to.strand, forward, forward ? to.segment + 1 : points - 1 - to.segment};
  }

  int index(const Way& way, int k) const {
    return way.forward ? k : arrangement_.point_count(way.strand) - 1 - k;
  }

  Vec2& image(const Way& way, int k) {
    return arrangement_.image.image[arrangement_.point(way.strand, index(way, k))];
  }

  std::vector<Vec2> line(const Way& way, const Vec2& end) {
    std::vector<Vec2> result;
    for (int k = 0; k < way.count; ++k) result.push_back(image(way, k));
    result.push_back(end);
    return result;
  }

  // Onto a line, the points that are on this side of it.
  void move(const Way& way, const std::vector<Vec2>& line, bool left) {
    for (int k = 1; k < way.count; ++k) {
      if (is_next_to_crossing(way.strand, index(way, k))) continue;
      const Foot foot = nearest_on(line, image(way, k));
      const bool is_near = (foot.point - image(way, k)).norm() <= farthest_move_px;
      if (foot.is_left == left && is_near) image(way, k) = foot.point;
    }
  }

  bool is_next_to_crossing(int strand, int point) const {
    const std::vector<Visit>& visits = arrangement_.visits[idx(strand)];
    return std::any_of(visits.begin(), visits.end(), [&](const Visit& visit) {
      return visit.place.segment == point || visit.place.segment + 1 == point;
    });
  }

  Arrangement& arrangement_;
  const CurveNetwork& network_;
};

}  // namespace

std::vector<int> dropped_crossings(const Arrangement& arrangement) {
  std::vector<int> result;
  for (std::size_t c = 0; c < arrangement.states.size(); ++c) {
    if (arrangement.states[c] == CrossingState::dropped) result.push_back(static_cast<int>(c));
  }
  return result;
}

void pull_touches_together(Arrangement& arrangement, const std::vector<int>& touches) {
  TouchImages images(arrangement);
  for (const int touch : touches) images.pull(touch);
}

}  // namespace illustrate
