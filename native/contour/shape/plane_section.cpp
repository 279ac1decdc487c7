#include "contour/shape/plane_section.h"

#include <algorithm>
#include <optional>

#include "contour/contour_functions.h"
#include "surface/locate.h"

namespace illustrate {
namespace {

class Follower {
 public:
  Follower(const Surface& surface, const SectionPlane& section, const SectionPlane& goal)
      : surface_(surface), section_(section), goal_(goal) {}

  // Each step comes nearer to the goal, so no triangle is passed twice.
  bool run(ZeroPoint& at, std::vector<ZeroSegment>& way) const {
    for (;;) {
      const double before = goal_.side(at.position);
      if (before >= 0) return true;
      const std::optional<ZeroPoint> out = way_out(at);
      if (!out) return false;
      const double after = goal_.side(out->position);
      if (!(after > before)) return false;
      if (after >= 0) {
        const ZeroPoint end = between(at, *out, before / (before - after));
        way.push_back({at, end});
        at = end;
        return true;
      }
      way.push_back({at, *out});
      at = *out;
      if (!cross(at)) return false;
    }
  }

 private:
  double side(int triangle, int corner) const {
    return section_.side(surface_.positions[idx(surface_.triangles[idx(triangle)][idx(corner)])]);
  }

  // From both triangles of an edge the same place.
  ZeroPoint crossing(int triangle, int corner) const {
    const Triangle& t = surface_.triangles[idx(triangle)];
    const int next = next_corner(corner);
    const bool ascending = t[idx(corner)] < t[idx(next)];
    const double from = side(triangle, corner), to = side(triangle, next);
    const double zero = ascending ? zero_between(from, to) : zero_between(to, from);
    return point_on_edge(surface_, triangle, corner, zero);
  }

  // Where the section leaves the triangle: over the other edge than that which it came by; from an
  // inner point over the one that is nearer to the goal.
  std::optional<ZeroPoint> way_out(const ZeroPoint& at) const {
    std::optional<ZeroPoint> best;
    for (int k = 0; k < 3; ++k) {
      const bool is_crossed =
          (side(at.on.triangle, k) >= 0) != (side(at.on.triangle, next_corner(k)) >= 0);
      if (!is_crossed || k == at.edge) continue;
      const ZeroPoint out = crossing(at.on.triangle, k);
      if (!best || goal_.side(out.position) > goal_.side(best->position)) best = out;
    }
    return best;
  }

  // The same point as one of the triangle across its edge; false where there is none.
  bool cross(ZeroPoint& at) const {
    const int from = at.on.triangle;
    const int to = surface_.neighbours[idx(from)][idx(at.edge)];
    if (to == none) return false;
    const auto& back = surface_.neighbours[idx(to)];
    const int corner = static_cast<int>(std::find(back.begin(), back.end(), from) - back.begin());
    if (corner == 3) return false;
    const bool is_opposite = place(from, at.edge) != place(to, corner);
    at.on = on_edge(to, corner, is_opposite ? 1 - at.fraction : at.fraction);
    at.fraction = is_opposite ? 1 - at.fraction : at.fraction;
    at.edge = corner;
    return true;
  }

  int place(int triangle, int corner) const {
    return surface_.places[idx(surface_.triangles[idx(triangle)][idx(corner)])];
  }

  const Surface& surface_;
  const SectionPlane& section_;
  const SectionPlane& goal_;
};

}  // namespace

bool follow_section(const Surface& surface, const SectionPlane& section, const SectionPlane& goal,
                    ZeroPoint& start, std::vector<ZeroSegment>& way) {
  return Follower(surface, section, goal).run(start, way);
}

}  // namespace illustrate
