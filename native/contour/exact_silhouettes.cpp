#include "contour/exact_silhouettes.h"

#include <algorithm>
#include <iterator>

#include "contour/cusp_ends.h"
#include "contour/patchwork.h"

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
};

class Drawer {
 public:
  Drawer(LimitContour& contour, const Camera& camera, bool everywhere, const Progress& progress)
      : contour_(contour),
        camera_(camera),
        segment_(contour, camera),
        everywhere_(everywhere),
        progress_(progress) {}

  // Chains with troubled triangles stay empty, unless all are wanted.
  ExactChains draw(const Surface& surface, const ContourFunctions& functions,
                   const LinearSilhouettes& linear, SolvedEdges* solved, bool all) {
    ExactChain exact(surface, contour_, functions, solved);
    ExactChains result;
    for (std::size_t c = 0; c < linear.chains.size(); ++c) {
      progress_.report(static_cast<double>(c) / static_cast<double>(linear.chains.size()));
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

  LimitContour& contour_;
  const Camera& camera_;
  ExactSegment segment_;
  bool everywhere_;
  const Progress& progress_;
};

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
  void redraw(const Camera& camera, Drawer& drawer, ExactChains& drawn) {
    include(drawn.troubled);
    std::vector<int> wanted;
    for (const int t : drawn.troubled) wanted.push_back(patchwork_.number_of(t));
    SolvedEdges solved;
    ExactChains finer;
    for (int round = 1; !wanted.empty(); ++round) {
      const bool is_last = !patchwork_.cut(wanted) || round == most_cuts;
      include(patchwork_.take_added());
      const Surface& surface = patchwork_.surface();
      const ContourFunctions functions(surface, camera);
      const LinearSilhouettes traced = linear_silhouettes(surface, functions);
      finer = drawer.draw(surface, functions, traced, &solved, is_last);
      wanted.clear();
      if (!is_last) wanted = finer.troubled;
    }
    restore(patchwork_, finer);
    replace(drawn, finer);
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
      std::move(more.begin(), more.end(), std::back_inserter(values));
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
                              const Progress& progress) {
  LimitContour contour(limit, camera);
  Drawer drawer(contour, camera, everywhere, progress);
  ExactChains drawn = drawer.draw(surface, functions, linear, nullptr, false);
  counts["troubled_triangles"] += static_cast<std::int64_t>(drawn.troubled.size());
  if (!drawn.troubled.empty()) Finer(surface, limit, linear).redraw(camera, drawer, drawn);
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
  counts["evaluations"] += contour.evaluations();
  return result;
}

}  // namespace illustrate
