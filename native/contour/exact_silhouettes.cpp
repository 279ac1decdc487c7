#include "contour/exact_silhouettes.h"

#include <algorithm>

#include "contour/cusp_ends.h"
#include "contour/patchwork.h"

namespace illustrate {
namespace {

constexpr int most_rounds = 6;  // of making crossed strands finer
constexpr int most_cuts = 5;    // of a triangle
constexpr std::size_t smallest_loop = 3;
constexpr double finest_px = 0.03;  // below, the image grid would twist strands

struct ExactChains {
  std::vector<std::vector<ExactPoint>> chains;
  std::vector<std::uint8_t> closed;
  std::vector<int> troubled;  // triangles, ascending
  int swallowtails = 0;
};

class Drawer {
 public:
  Drawer(LimitContour& contour, const Camera& camera, bool everywhere)
      : contour_(contour), camera_(camera), segment_(contour, camera), everywhere_(everywhere) {}

  ExactChains draw(const Surface& surface, const ContourFunctions& functions,
                   const Silhouettes& linear) {
    ExactChain exact(surface, contour_, functions, camera_);
    ExactChains result;
    for (std::size_t c = 0; c < linear.chains.size(); ++c) {
      const bool closed = linear.closed[c];
      std::vector<ExactPoint> chain = exact.run(linear.chains[c], closed, everywhere_);
      exact.add_troubled(result.troubled);
      int swallowtails = tidy(surface, closed, chain);
      for (int round = 0; round < most_rounds && untangle(closed, chain, exact); ++round) {
        chain = exact.again();
        swallowtails = tidy(surface, closed, chain);
      }
      result.swallowtails += swallowtails;
      if (closed && chain.size() < smallest_loop) continue;
      result.chains.push_back(std::move(chain));
      result.closed.push_back(closed);
    }
    std::sort(result.troubled.begin(), result.troubled.end());
    return result;
  }

 private:
  int tidy(const Surface& surface, bool closed, std::vector<ExactPoint>& chain) {
    const int swallowtails = collapse_swallowtails(surface, closed, chain);
    thin_at_cusps(surface, camera_, segment_, closed, chain);
    return swallowtails;
  }

  // Asks for finer segments where strands of a cusp cross; whether there are any.
  static bool untangle(bool closed, const std::vector<ExactPoint>& chain, ExactChain& exact) {
    bool any = false;
    for (const CrossedSegment& s : crossed_at_cusps(closed, chain)) {
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
};

// Back from the patchwork to the whole surface.
void restore(const Patchwork& patchwork, ExactChains& drawn) {
  for (std::vector<ExactPoint>& chain : drawn.chains) {
    for (ExactPoint& p : chain) {
      const Patchwork::Place place = patchwork.on_whole(p.point.on, p.point.edge);
      p.point.on = place.on;
      p.point.edge = place.edge;
      p.point.fraction = place.fraction;
    }
  }
}

// Cuts troubled triangles and traces again, until none is left.
ExactChains draw_finer(const Surface& surface, const LimitSurface& limit, const Camera& camera,
                       const Silhouettes& linear, const std::vector<int>& troubled,
                       Drawer& drawer) {
  Patchwork patchwork(surface, limit, linear.triangles);
  std::vector<int> wanted;
  for (const int t : troubled) wanted.push_back(patchwork.number_of(t));
  ExactChains drawn;
  for (int round = 0; round < most_cuts; ++round) {
    const bool is_cut = patchwork.cut(wanted);
    if (!is_cut && round > 0) break;
    const Surface& finer = patchwork.surface();
    const ContourFunctions functions(finer, camera);
    drawn = drawer.draw(finer, functions, silhouettes(finer, functions, camera));
    wanted = drawn.troubled;
    if (wanted.empty() || !is_cut) break;
  }
  restore(patchwork, drawn);
  return drawn;
}

}  // namespace

Silhouettes exact_silhouettes(const Surface& surface, const LimitSurface& limit,
                              const ContourFunctions& functions, const Camera& camera,
                              const Silhouettes& linear, bool everywhere, Counts& counts) {
  LimitContour contour(limit, camera);
  Drawer drawer(contour, camera, everywhere);
  ExactChains drawn = drawer.draw(surface, functions, linear);
  counts["troubled_triangles"] += static_cast<std::int64_t>(drawn.troubled.size());
  if (!drawn.troubled.empty()) {
    drawn = draw_finer(surface, limit, camera, linear, drawn.troubled, drawer);
  }
  Silhouettes result;
  result.triangles = linear.triangles;
  result.triangles_visited = linear.triangles_visited;
  result.closed = drawn.closed;
  for (const std::vector<ExactPoint>& chain : drawn.chains) {
    for (const ExactPoint& p : chain) {
      result.chains.push(p.point);
      result.cusps += p.is_cusp();
    }
    result.chains.close_list();
  }
  counts["swallowtails"] += drawn.swallowtails;
  counts["evaluations"] += contour.evaluations();
  return result;
}

}  // namespace illustrate
