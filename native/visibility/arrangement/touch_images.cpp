#include "visibility/arrangement/touch_images.h"

#include <algorithm>
#include <limits>

#include "core/segments.h"
#include "visibility/reaches.h"

namespace illustrate {
namespace {

// A strand from a joint at one of its ends up to a crossing: its points, the joint's first.
struct Lead {
  int strand = none;
  Direction direction = Direction::forward;
  int count = 0;
};

// A side of a curve, as the viewer sees it.
enum class Side : std::uint8_t { left, right };

constexpr Side other(Side side) { return side == Side::left ? Side::right : Side::left; }

struct Foot {
  Vec2 point;
  Side side;  // of the line, on which the point is whose foot it is
};

Foot nearest_on(const std::vector<Vec2>& line, const Vec2& p) {
  Foot result{p, Side::right};
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const Vec2 along = line[i + 1] - line[i];
    if (along.squaredNorm() == 0) continue;
    const Vec2 foot = line[i] + nearest_share(line[i], line[i + 1], p) * along;
    const double distance = (p - foot).squaredNorm();
    if (distance >= least) continue;
    least = distance;
    result = {foot, cross(along, p - line[i]) < 0 ? Side::left : Side::right};  // y is down
  }
  return result;
}

class TouchImages {
 public:
  explicit TouchImages(Arrangement& arrangement)
      : arrangement_(arrangement), network_(arrangement.network()) {}

  void pull(int touch) {
    const Crossing& x = arrangement_.crossing(touch);
    const bool is_front = network_.strands[idx(x.front.strand)].kind == Kind::silhouette;
    Lead contour, curve;
    if (!find_leads(is_front ? x.front : x.back, is_front ? x.back : x.front, contour, curve))
      return;
    const Strand& strand = network_.strands[idx(contour.strand)];
    const bool is_left =
        (strand.left_layers > strand.right_layers) == (contour.direction == Direction::forward);
    const Side surface = is_left ? Side::left : Side::right;
    move(curve, line(contour, x.image), other(surface));
    move(contour, line(curve, x.image), surface);
  }

 private:
  // The shortest ones that start at one joint, or no farther apart than a cusp at the end of a
  // contour from it; false where there are none.
  bool find_leads(const StrandPlace& a, const StrandPlace& b, Lead& one, Lead& two) const {
    int least = std::numeric_limits<int>::max();
    for (const Direction of_a : {Direction::forward, Direction::backward}) {
      for (const Direction of_b : {Direction::forward, Direction::backward}) {
        const Lead from_a = lead(a, of_a), from_b = lead(b, of_b);
        if ((image(from_a, 0) - image(from_b, 0)).norm() > reaches.end) continue;
        if (from_a.count + from_b.count >= least) continue;
        least = from_a.count + from_b.count;
        one = from_a;
        two = from_b;
      }
    }
    return one.strand != none;
  }

  Lead lead(const StrandPlace& to, Direction direction) const {
    const int points = arrangement_.point_count(to.strand);
    const bool forward = direction == Direction::forward;
    return {to.strand, direction, forward ? to.segment + 1 : points - 1 - to.segment};
  }

  int index(const Lead& lead, int k) const {
    const bool forward = lead.direction == Direction::forward;
    return forward ? k : arrangement_.point_count(lead.strand) - 1 - k;
  }

  const Vec2& image(const Lead& lead, int k) const {
    return arrangement_.image_of(lead.strand, index(lead, k));
  }

  std::vector<Vec2> line(const Lead& lead, const Vec2& end) const {
    std::vector<Vec2> result;
    for (int k = 0; k < lead.count; ++k) result.push_back(image(lead, k));
    result.push_back(end);
    return result;
  }

  // Onto a line, the points that are on this side of it.
  void move(const Lead& lead, const std::vector<Vec2>& line, Side side) {
    for (int k = 1; k < lead.count; ++k) {
      if (is_next_to_crossing(lead.strand, index(lead, k))) continue;
      const Foot foot = nearest_on(line, image(lead, k));
      const bool is_near = (foot.point - image(lead, k)).norm() <= reaches.touching_move;
      if (foot.side == side && is_near)
        arrangement_.move_point(lead.strand, index(lead, k), foot.point);
    }
  }

  bool is_next_to_crossing(int strand, int point) const {
    const std::vector<Visit>& visits = arrangement_.visits(strand);
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
  for (int c = 0; c < static_cast<int>(arrangement.crossings().size()); ++c) {
    if (arrangement.state(c) == CrossingState::dropped) result.push_back(c);
  }
  return result;
}

void pull_touches_together(Arrangement& arrangement, const std::vector<int>& touches) {
  TouchImages images(arrangement);
  for (const int touch : touches) images.pull(touch);
}

}  // namespace illustrate
