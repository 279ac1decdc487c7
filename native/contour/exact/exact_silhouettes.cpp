#include "contour/exact/exact_silhouettes.h"

#include <algorithm>
#include <iterator>
#include <numeric>

#include "contour/exact/cusp_ends.h"
#include "contour/exact/patchwork.h"
#include "core/parallel.h"

namespace illustrate {
namespace {

constexpr int most_rounds = 6;  // of making crossed strands finer
constexpr int most_cuts = 5;    // of a triangle
constexpr std::size_t smallest_loop = 3;
constexpr double finest_px = 0.03;  // below, the image grid would twist strands

// One for each linear chain; empty where it is left out or too small to be drawn.
struct ExactChains {
  std::vector<ExactPolyline> chains;
  std::vector<int> swallowtails;  // in each chain
  std::vector<int> troubled;      // triangles, ascending
  std::int64_t evaluations = 0;   // of the limit surface
};

// A view of the limit surface, and how a drawing of its contour is worked out.
struct Task {
  const LimitSurface& limit;
  const Camera& camera;
  Exactness exactness;
  int threads;
};

// What becomes of chains with troubled triangles.
enum class Troubled : std::uint8_t { left_empty, drawn };

class Drawer {
 public:
  explicit Drawer(const Task& task)
      : camera_(task.camera),
        contour_(task.limit, task.camera),
        segment_(contour_, task.camera),
        exactness_(task.exactness) {}

  ExactChains draw(const Surface& surface, const ContourFunctions& functions,
                   const LinearSilhouettes& linear, std::size_t begin, std::size_t end,
                   SolvedEdges* solved, Troubled troubled_ones) {
    ExactChain exact(surface, contour_, functions, solved);
    ExactChains result;
    result.chains.resize(end - begin);
    result.swallowtails.resize(end - begin);
    for (std::size_t c = begin; c < end; ++c) {
      if (linear.is_left_out(c)) continue;
      exact.solve(linear.chains[c], linear.closed[c], exactness_);
      ExactPolyline line = exact.polyline();
      const std::vector<int> troubled = exact.troubled();
      result.troubled.insert(result.troubled.end(), troubled.begin(), troubled.end());
      if (troubled_ones == Troubled::left_empty && !troubled.empty()) continue;
      result.swallowtails[c - begin] = finish(surface, exact, line);
      result.chains[c - begin] = std::move(line);
    }
    std::sort(result.troubled.begin(), result.troubled.end());
    result.evaluations = contour_.evaluations();
    return result;
  }

 private:
  // Returns the number of swallowtails.
  int finish(const Surface& surface, ExactChain& exact, ExactPolyline& line) {
    int swallowtails = tidy(surface, line);
    for (int round = 0; round < most_rounds && untangle(line, exact); ++round) {
      line = exact.polyline();
      swallowtails = tidy(surface, line);
    }
    if (line.closed && line.points.size() < smallest_loop) line.points.clear();
    line.left_out = exact.left_out(line);
    return swallowtails;
  }

  int tidy(const Surface& surface, ExactPolyline& line) {
    const int swallowtails = collapse_swallowtails(surface, camera_, line);
    thin_at_cusps(surface, camera_, segment_, line);
    return swallowtails;
  }

  // Asks for finer segments where strands of a cusp cross; whether there are any.
  bool untangle(const ExactPolyline& line, ExactChain& exact) const {
    bool any = false;
    for (const CrossedSegment& s : crossed_at_cusps(camera_, line)) {
      if (s.length_px / 2 < finest_px) continue;
      exact.make_finer(s.segment, s.length_px / 2);
      any = true;
    }
    return any;
  }

  const Camera& camera_;
  LimitContour contour_;
  ExactSegment segment_;
  Exactness exactness_;
};

// Points of linear chains that are worth a turn on another thread.
constexpr std::size_t least_share = 500;

template <class Value>
void append(std::vector<Value>& values, std::vector<Value>& more) {
  std::move(more.begin(), more.end(), std::back_inserter(values));
}

// All chains, but those with troubled triangles; many at a time.
ExactChains draw_untroubled(const Surface& surface, const ContourFunctions& functions,
                            const LinearSilhouettes& linear, const Task& task,
                            const Progress& progress) {
  std::vector<std::size_t> sizes;
  for (std::size_t c = 0; c < linear.chains.size(); ++c) sizes.push_back(linear.chains[c].size());
  const std::vector<std::size_t> starts = shares_of(sizes, least_share);
  std::vector<ExactChains> shares(starts.size() - 1);
  parallel_each(shares.size(), task.threads, progress, [&](std::size_t i) {
    shares[i] = Drawer(task).draw(surface, functions, linear, starts[i], starts[i + 1], nullptr,
                                  Troubled::left_empty);
  });
  ExactChains result;
  for (ExactChains& share : shares) {
    append(result.chains, share.chains);
    append(result.swallowtails, share.swallowtails);
    append(result.troubled, share.troubled);
    result.evaluations += share.evaluations;
  }
  std::sort(result.troubled.begin(), result.troubled.end());
  return result;
}

// Back from the patchwork to the whole surface.
void restore(const Patchwork& patchwork, ExactChains& drawn) {
  const auto restore_point = [&](ChainPoint& p) {
    const Patchwork::Place place = patchwork.on_whole(p.on, p.edge);
    p.on = place.on;
    p.edge = place.edge;
    p.fraction = place.fraction;
  };
  for (ExactPolyline& line : drawn.chains) {
    for (ExactPoint& p : line.points) restore_point(p);
    for (LeftOutPoint& p : line.left_out) restore_point(p.point);
  }
}

// Which point of the linear chains starts the segment of a triangle.
class SegmentsOf {
 public:
  explicit SegmentsOf(const LinearSilhouettes& linear)
      : linear_(linear), points_(linear.chains.values.size()) {
    const std::vector<EdgePoint>& points = linear.chains.values;
    for (std::size_t i = 0; i < points.size(); ++i) {
      points_.at(points[i].on.triangle) = static_cast<int>(i);
    }
  }

  // none where no chain passes.
  int chain(int triangle) const {
    const int point = points_[triangle];
    if (point == none) return none;
    const std::vector<int>& offsets = linear_.chains.offsets;
    const auto behind = std::upper_bound(offsets.begin(), offsets.end(), point);
    return static_cast<int>(behind - offsets.begin()) - 1;
  }

  bool is_unseen(int triangle) const {
    const int point = points_[triangle];
    return point != none && linear_.chains.values[idx(point)].is_unseen;
  }

 private:
  const LinearSilhouettes& linear_;
  IndexMap points_;
};

// What takes the place of some of the linear chains.
struct Redrawn {
  std::vector<int> replaced;   // chains
  std::vector<int> triangles;  // that were looked at
  ExactChains chains;
};

// Redraws the chains through some troubled triangles, with these cut, until no trouble is left.
// Chains that run through a triangle beside them are redrawn with them, also those left out: of
// them too the patchwork needs to have all.
class Finer {
 public:
  Finer(const Surface& surface, const LinearSilhouettes& linear, const SegmentsOf& segments,
        const Task& task, const std::vector<int>& groups)
      : patchwork_(surface, task.limit),
        linear_(linear),
        segments_(segments),
        task_(task),
        groups_(groups) {}

  // Stops where it meets another group's chain: both are to be redrawn together.
  Redrawn redraw(const std::vector<int>& troubled) {
    include(troubled);
    std::vector<int> wanted;
    for (const int t : troubled) wanted.push_back(patchwork_.number_of(t));
    SolvedEdges solved;
    Drawer drawer(task_);
    for (int round = 1; !wanted.empty(); ++round) {
      const bool is_last = !patchwork_.cut(wanted) || round == most_cuts;
      include(patchwork_.take_added());
      if (meets_another_) break;
      const Surface& surface = patchwork_.surface();
      const ContourFunctions functions(surface, task_.camera);
      const LinearSilhouettes traced = trace(surface, functions);
      redrawn_.chains = drawer.draw(surface, functions, traced, 0, traced.chains.size(), &solved,
                                    is_last ? Troubled::drawn : Troubled::left_empty);
      wanted.clear();
      if (!is_last) wanted = redrawn_.chains.troubled;
    }
    if (!meets_another_) restore(patchwork_, redrawn_.chains);
    redrawn_.triangles = patchwork_.wholes();
    return std::move(redrawn_);
  }

 private:
  void include(const std::vector<int>& triangles) {
    std::vector<int>& replaced = redrawn_.replaced;
    for (const int t : triangles) {
      const int chain = segments_.chain(t);
      if (chain == none || std::count(replaced.begin(), replaced.end(), chain) > 0) continue;
      const int group = groups_[idx(chain)];
      meets_another_ |=
          group != none && !replaced.empty() && group != groups_[idx(replaced.front())];
      replaced.push_back(chain);
      std::vector<int> along;
      for (const EdgePoint& p : linear_.chains[idx(chain)]) along.push_back(p.on.triangle);
      patchwork_.add(along);
    }
  }

  LinearSilhouettes trace(const Surface& surface, const ContourFunctions& functions) const {
    LinearSilhouettes traced = linear_silhouettes(surface, functions);
    for (EdgePoint& p : traced.chains.values) {
      p.is_unseen = segments_.is_unseen(patchwork_.on_whole(p.on, none).on.triangle);
    }
    return traced;
  }

  Patchwork patchwork_;
  const LinearSilhouettes& linear_;
  const SegmentsOf& segments_;
  const Task& task_;
  const std::vector<int>& groups_;  // (linear chains) none: not troubled
  bool meets_another_ = false;
  Redrawn redrawn_;
};

// Troubled triangles that are cut together.
struct Group {
  std::vector<int> troubled;
  Redrawn redrawn;
  bool is_done = false;
};

// One for each chain with troubled triangles. Those of chains that run beside them will be redrawn
// too: each chain stands here for itself by its first triangle.
std::vector<Group> group_by_chain(const Surface& surface, const LinearSilhouettes& linear,
                                  const SegmentsOf& segments, const std::vector<int>& troubled) {
  std::vector<Group> groups(linear.chains.size());
  for (const int t : troubled) {
    Group& group = groups[idx(segments.chain(t))];
    group.troubled.push_back(t);
    const auto touch = [&](int triangle) {
      const int chain = triangle == none ? none : segments.chain(triangle);
      if (chain == none) return;
      group.redrawn.triangles.push_back(linear.chains[idx(chain)].front().on.triangle);
    };
    touch(t);
    for (const int beside : surface.neighbours[idx(t)]) touch(beside);
  }
  return groups;
}

int head_of(std::vector<int>& heads, int group) {
  while (heads[idx(group)] != group) group = heads[idx(group)] = heads[idx(heads[idx(group)])];
  return group;
}

// Groups that came to share a triangle become one, which is to be redrawn.
void join_those_that_meet(std::vector<Group>& groups) {
  std::vector<int> heads(groups.size());
  std::iota(heads.begin(), heads.end(), 0);
  IndexMap owners;
  for (int g = 0; g < static_cast<int>(groups.size()); ++g) {
    for (const int t : groups[idx(g)].redrawn.triangles) {
      int& owner = owners.at(t);
      if (owner == none) owner = g;
      const auto [low, high] = std::minmax({head_of(heads, owner), head_of(heads, g)});
      heads[idx(high)] = low;
    }
  }
  for (int g = 0; g < static_cast<int>(groups.size()); ++g) {
    const int head = head_of(heads, g);
    if (head == g) continue;
    append(groups[idx(head)].troubled, groups[idx(g)].troubled);
    groups[idx(g)].troubled.clear();
    groups[idx(head)].is_done = false;
  }
  groups.erase(std::remove_if(groups.begin(), groups.end(),
                              [](const Group& g) { return g.troubled.empty(); }),
               groups.end());
}

// The group of each chain with troubled triangles.
std::vector<int> groups_of_chains(const std::vector<Group>& groups, const SegmentsOf& segments,
                                  std::size_t chains) {
  std::vector<int> result(chains, none);
  for (std::size_t g = 0; g < groups.size(); ++g) {
    for (const int t : groups[g].troubled) result[idx(segments.chain(t))] = static_cast<int>(g);
  }
  return result;
}

// Takes the place of the chains of `drawn` that were troubled.
void replace(std::vector<Group>& groups, ExactChains& drawn) {
  std::vector<std::uint8_t> is_replaced(drawn.chains.size(), 0);
  for (const Group& group : groups) {
    for (const int c : group.redrawn.replaced) is_replaced[idx(c)] = 1;
  }
  std::size_t kept = 0;
  for (std::size_t c = 0; c < drawn.chains.size(); ++c) {
    if (is_replaced[c]) continue;
    if (kept != c) drawn.chains[kept] = std::move(drawn.chains[c]);
    drawn.swallowtails[kept++] = drawn.swallowtails[c];
  }
  drawn.chains.resize(kept);
  drawn.swallowtails.resize(kept);
  for (Group& group : groups) {
    append(drawn.chains, group.redrawn.chains.chains);
    append(drawn.swallowtails, group.redrawn.chains.swallowtails);
    drawn.evaluations += group.redrawn.chains.evaluations;
  }
}

// Redraws the troubled chains of `drawn`, group by group, until no two groups meet: what comes out
// depends on no order.
void redraw_troubled(const Surface& surface, const LinearSilhouettes& linear, const Task& task,
                     ExactChains& drawn, const Progress& progress) {
  const SegmentsOf segments(linear);
  std::vector<Group> groups = group_by_chain(surface, linear, segments, drawn.troubled);
  join_those_that_meet(groups);
  for (bool is_done = false; !is_done;) {
    const std::vector<int> of_chains = groups_of_chains(groups, segments, linear.chains.size());
    parallel_each(groups.size(), task.threads, progress, [&](std::size_t g) {
      if (groups[g].is_done) return;
      groups[g].redrawn =
          Finer(surface, linear, segments, task, of_chains).redraw(groups[g].troubled);
      groups[g].is_done = true;
    });
    join_those_that_meet(groups);
    is_done = std::all_of(groups.begin(), groups.end(), [](const Group& g) { return g.is_done; });
  }
  replace(groups, drawn);
}

}  // namespace

Silhouettes exact_silhouettes(const Surface& surface, const LimitSurface& limit,
                              const ContourFunctions& functions, const Camera& camera,
                              const LinearSilhouettes& linear, Exactness exactness, Counts& counts,
                              const Progress& progress, int threads) {
  const Task task{limit, camera, exactness, threads};
  ExactChains drawn = draw_untroubled(surface, functions, linear, task, progress.part(0, 0.5));
  counts["troubled_triangles"] += static_cast<std::int64_t>(drawn.troubled.size());
  if (!drawn.troubled.empty()) {
    redraw_troubled(surface, linear, task, drawn, progress.part(0.5, 1));
  }
  Silhouettes result;
  std::size_t points = 0;
  for (const ExactPolyline& line : drawn.chains) points += line.points.size();
  result.chains.values.reserve(points);
  for (std::size_t c = 0; c < drawn.chains.size(); ++c) {
    counts["swallowtails"] += drawn.swallowtails[c];
    const ExactPolyline& line = drawn.chains[c];
    if (line.points.empty()) continue;
    for (const ExactPoint& p : line.points) {
      result.chains.push(p);
      result.cusps += p.is_cusp();
    }
    const int chain = static_cast<int>(result.chains.size());
    for (const LeftOutPoint& p : line.left_out) result.passed.push_back({chain, p.behind, p.point});
    result.chains.close_list();
    result.closed.push_back(line.closed);
  }
  counts["evaluations"] += drawn.evaluations;
  return result;
}

}  // namespace illustrate
