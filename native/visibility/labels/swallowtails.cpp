#include "visibility/labels/swallowtails.h"

#include <algorithm>
#include <cmath>

#include "visibility/labels/path_arcs.h"
#include "visibility/labels/repairs.h"

namespace illustrate {
namespace {

constexpr double swallowtail_px = 1.0;

// A strand between two cusps of one jump; `step` enters it.
struct Swallowtail {
  double reach_px;
  std::size_t step;
};

// Whether the strands before and behind a swallowtail cross next to it in the way that makes up for
// its two cusps: such a one keeps all rules, whatever else is wrong with its path.
bool has_its_crossing(const Arrangement& arrangement, int before, int tail, int behind, int jump) {
  const Vec2& tip = arrangement.image.image[arrangement.point(tail, 0)];
  const std::vector<Visit>& visits = arrangement.visits[idx(before)];
  return std::any_of(visits.begin(), visits.end(), [&](const Visit& visit) {
    const Crossing& x = arrangement.crossings[idx(visit.crossing)];
    const int other = visit.front ? x.back.strand : x.front.strand;
    return other == behind && arrangement.is_live(visit.crossing) &&
           back_change(arrangement, x) == -2 * jump && (x.image - tip).norm() <= swallowtail_px;
  });
}

std::vector<Swallowtail> swallowtails_of(const Arrangement& arrangement, const Path& path,
                                         int jump) {
  std::vector<Swallowtail> result;
  const std::size_t count = path.strands.size();
  for (std::size_t i = 0; count > 1 && i < count; ++i) {
    if (path.jumps[i] != jump || path.jumps[(i + 1) % count] != jump) continue;
    const int tail = path.strands[i];
    const double reach = arrangement.reach_px(tail);
    if (reach > swallowtail_px) continue;
    const int before = path.strands[(i + count - 1) % count];
    if (has_its_crossing(arrangement, before, tail, path.strands[(i + 1) % count], jump)) continue;
    result.push_back({reach, i});
  }
  std::sort(result.begin(), result.end(), [](const Swallowtail& a, const Swallowtail& b) {
    return a.reach_px != b.reach_px ? a.reach_px < b.reach_px : a.step < b.step;
  });
  return result;
}

// At the end of an open path nothing ties its label, and a stretch of no length has none to show.
int drop_cusps_at_ends(const Arrangement& arrangement, Path& path, double& moved_px) {
  if (path.cyclic) return 0;
  int dropped = 0;
  const auto drop = [&](int strand, int& jump) {
    const double reach = arrangement.reach_px(strand);
    if (jump == 0 || reach > end_px) return;
    jump = 0;
    moved_px = std::max(moved_px, reach);
    ++dropped;
  };
  if (path.strands.size() > 1) {
    drop(path.strands.front(), path.jumps[1]);
    drop(path.strands.back(), path.jumps.back());
  }
  return dropped;
}

}  // namespace

int collapse_swallowtails(Arrangement& arrangement, double& moved_px) {
  int collapsed = 0;
  for (Path& path : arrangement.paths) {
    collapsed += drop_cusps_at_ends(arrangement, path, moved_px);
    int residual = imbalance(arrangement, path);
    if (std::abs(residual) < 2) continue;
    const int jump = residual > 0 ? 1 : -1;
    for (const Swallowtail& s : swallowtails_of(arrangement, path, jump)) {
      int& first = path.jumps[s.step];
      int& second = path.jumps[(s.step + 1) % path.strands.size()];
      if (std::abs(residual) < 2 || first == 0 || second == 0) continue;
      first = second = 0;
      residual -= 2 * jump;
      moved_px = std::max(moved_px, s.reach_px);
      ++collapsed;
    }
  }
  return collapsed;
}

}  // namespace illustrate
