#include "visibility/labels/swallowtails.h"

#include <algorithm>
#include <cmath>

#include "visibility/labels/path_arcs.h"
#include "visibility/reaches.h"

namespace illustrate {
namespace {

// A strand between two cusps of one jump; `step` enters it.
struct Swallowtail {
  double reach_px;
  std::size_t step;
};

// Whether the strands before and behind a swallowtail cross next to it in the way that makes up for
// its two cusps: such a one keeps all rules, whatever else is wrong with its path.
bool has_its_crossing(const Arrangement& arrangement, int before, int tail, int behind, int jump) {
  const Vec2& tip = arrangement.image_of(tail, 0);
  const std::vector<Visit>& visits = arrangement.visits(before);
  return std::any_of(visits.begin(), visits.end(), [&](const Visit& visit) {
    const Crossing& x = arrangement.crossing(visit.crossing);
    const int other = visit.front ? x.back.strand : x.front.strand;
    return other == behind && arrangement.is_live(visit.crossing) &&
           back_change(arrangement, x) == -2 * jump &&
           (x.image - tip).norm() <= reaches.swallowtail;
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
    if (reach > reaches.swallowtail) continue;
    const int before = path.strands[(i + count - 1) % count];
    if (has_its_crossing(arrangement, before, tail, path.strands[(i + 1) % count], jump)) continue;
    result.push_back({reach, i});
  }
  // The smallest first: it is the likeliest to be none, and the path may balance without the
  // others.
  std::sort(result.begin(), result.end(), [](const Swallowtail& a, const Swallowtail& b) {
    return a.reach_px != b.reach_px ? a.reach_px < b.reach_px : a.step < b.step;
  });
  return result;
}

// Not where a third sheet changes an intersection: that is decided, however near to an end.
bool is_cusp(const Arrangement& arrangement, const Path& path, int step) {
  const CurveNetwork& network = arrangement.network();
  const int node = network.strands[idx(path.strands[idx(step)])].start_node;
  return path.jumps[idx(step)] != 0 && network.nodes[idx(node)].kind == NodeKind::cusp;
}

// At the end of an open path nothing ties its label, and a stretch of no length has none to show.
int drop_cusps_at_ends(Arrangement& arrangement, int index, double& moved_px) {
  const Path& path = arrangement.paths()[idx(index)];
  const int last = static_cast<int>(path.strands.size()) - 1;
  if (path.cyclic || last == 0) return 0;
  int dropped = 0;
  const auto drop = [&](int strand, int step) {
    const double reach = arrangement.reach_px(strand);
    if (!is_cusp(arrangement, path, step) || reach > reaches.end) return;
    arrangement.drop_jump(index, step);
    moved_px = std::max(moved_px, reach);
    ++dropped;
  };
  drop(path.strands.front(), 1);
  drop(path.strands.back(), last);
  return dropped;
}

int collapse(Arrangement& arrangement, int index, double& moved_px) {
  const Path& path = arrangement.paths()[idx(index)];
  int residual = imbalance(arrangement, path);
  if (std::abs(residual) < 2) return 0;
  const int jump = residual > 0 ? 1 : -1;
  int collapsed = 0;
  for (const Swallowtail& s : swallowtails_of(arrangement, path, jump)) {
    const std::size_t next = (s.step + 1) % path.strands.size();
    if (std::abs(residual) < 2 || path.jumps[s.step] == 0 || path.jumps[next] == 0) continue;
    for (const std::size_t step : {s.step, next})
      arrangement.drop_jump(index, static_cast<int>(step));
    residual -= 2 * jump;
    moved_px = std::max(moved_px, s.reach_px);
    ++collapsed;
  }
  return collapsed;
}

}  // namespace

int collapse_swallowtails(Arrangement& arrangement, double& moved_px) {
  int collapsed = 0;
  for (int p = 0; p < static_cast<int>(arrangement.paths().size()); ++p) {
    collapsed += drop_cusps_at_ends(arrangement, p, moved_px);
    collapsed += collapse(arrangement, p, moved_px);
  }
  return collapsed;
}

}  // namespace illustrate
