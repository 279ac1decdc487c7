#include "contour/exact_silhouettes.h"

#include <algorithm>
#include <iterator>

#include "contour/cusp_ends.h"
#include "contour/patchwork.h"
#include "core/parallel.h"

namespace illustrate {
namespace {

constexpr int most_rounds = 6;  // of making crossed strands finer
constexpr int most_cuts = 5;    // of a triangle
constexpr std::size_t smallest_loop = 3;
constexpr double finest_px = 0.03;  // below, the image grid would twist strands

// One for each linear chain; empty where it is too small to be drawn.
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
  bool everywhere;
  int threads;
};

class Drawer {
 public:
  explicit Drawer(const Task& task)
      : camera_(task.camera),
        contour_(task.limit, task.camera),
        segment_(contour_, task.camera),
        everywhere_(task.everywhere) {}

  // Chains with troubled triangles stay empty, unless all are wanted.
  ExactChains draw(const Surface& surface, const ContourFunctions& functions,
                   const LinearSilhouettes& linear, std::size_t begin, std::size_t end,
                   SolvedEdges* solved, bool all) {
    ExactChain exact(surface, contour_, functions, solved);
    ExactChains result;
    for (std::size_t c = begin; c < end; ++c) {
      exact.solve(linear.chains[c], linear.closed[c], everywhere_);
      ExactPolyline line = exact.polyline();
      const std::vector<int> troubled = exact.troubled();
      result.troubled.insert(result.troubled.end(), troubled.begin(), troubled.end());
      result.chains.emplace_back();
      result.swallowtails.push_back(0);
      if (!all && !troubled.empty()) continue;
      result.swallowtails.back() = finish(surface, exact, line);
      result.chains.back() = std::move(line);
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
  bool everywhere_;
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
    shares[i] =
        Drawer(task).draw(surface, functions, linear, starts[i], starts[i + 1], nullptr, false);
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

// Redraws the chains with troubled triangles, with these cut, until none is left. Chains that run
// through a triangle beside them are redrawn with them.
class Finer {
 public:
  Finer(const Surface& surface, const LimitSurface& limit, const LinearSilhouettes& linear)
      : patchwork_(surface, limit, linear.triangles.size() / 2),
        linear_(linear),
        is_redrawn_(linear.chains.size(), 0),
        chain_of_(linear.triangles.size()) {
    for (std::size_t c = 0; c < linear.chains.size(); ++c) {
      for (const EdgePoint& p : linear.chains[c]) {
        chain_of_.at(p.on.triangle) = static_cast<int>(c);
      }
    }
  }

  // Takes the place of the chains of `drawn` that were troubled.
  void redraw(const Task& task, ExactChains& drawn) {
    include(drawn.troubled);
    std::vector<int> wanted;
    for (const int t : drawn.troubled) wanted.push_back(patchwork_.number_of(t));
    SolvedEdges solved;
    Drawer drawer(task);
    ExactChains finer;
    for (int round = 1; !wanted.empty(); ++round) {
      const bool is_last = !patchwork_.cut(wanted) || round == most_cuts;
      include(patchwork_.take_added());
      const Surface& surface = patchwork_.surface();
      const ContourFunctions functions(surface, task.camera);
      const LinearSilhouettes traced = linear_silhouettes(surface, functions);
      finer = drawer.draw(surface, functions, traced, 0, traced.chains.size(), &solved, is_last);
      wanted.clear();
      if (!is_last) wanted = finer.troubled;
    }
    restore(patchwork_, finer);
    replace(drawn, finer);
    drawn.evaluations += finer.evaluations;
  }

 private:
  void include(const std::vector<int>& triangles) {
    for (const int t : triangles) {
      const int chain = chain_of_[t];
      if (chain == none || is_redrawn_[idx(chain)]) continue;
      is_redrawn_[idx(chain)] = 1;
      std::vector<int> along;
      for (const EdgePoint& p : linear_.chains[idx(chain)]) along.push_back(p.on.triangle);
      patchwork_.add(along);
    }
  }

  void replace(ExactChains& drawn, ExactChains& finer) const {
    std::size_t kept = 0;
    for (std::size_t c = 0; c < drawn.chains.size(); ++c) {
      if (is_redrawn_[c]) continue;
      if (kept != c) drawn.chains[kept] = std::move(drawn.chains[c]);
      drawn.swallowtails[kept++] = drawn.swallowtails[c];
    }
    const auto keep_and_add = [kept](auto& values, auto& more) {
      values.resize(kept);
      append(values, more);
    };
    keep_and_add(drawn.chains, finer.chains);
    keep_and_add(drawn.swallowtails, finer.swallowtails);
  }

  Patchwork patchwork_;
  const LinearSilhouettes& linear_;
  std::vector<std::uint8_t> is_redrawn_;  // (chains)
  IndexMap chain_of_;                     // of each triangle with a segment
};

}  // namespace

Silhouettes exact_silhouettes(const Surface& surface, const LimitSurface& limit,
                              const ContourFunctions& functions, const Camera& camera,
                              const LinearSilhouettes& linear, bool everywhere, Counts& counts,
                              const Progress& progress, int threads) {
  const Task task{limit, camera, everywhere, threads};
  ExactChains drawn = draw_untroubled(surface, functions, linear, task, progress);
  counts["troubled_triangles"] += static_cast<std::int64_t>(drawn.troubled.size());
  if (!drawn.troubled.empty()) Finer(surface, limit, linear).redraw(task, drawn);
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
