#include "contour/exact_silhouettes.h"

#include "contour/cusp_ends.h"

namespace illustrate {
namespace {

constexpr int most_rounds = 6;
constexpr std::size_t smallest_loop = 3;
constexpr double finest_px = 0.03;  // below, the image grid would twist strands

// Asks for finer segments where strands of a cusp cross; whether there are any.
bool untangle(bool closed, const std::vector<ExactPoint>& chain, ExactChain& exact) {
  bool any = false;
  for (const CrossedSegment& s : crossed_at_cusps(closed, chain)) {
    if (s.length_px / 2 < finest_px) continue;
    exact.make_finer(s.segment, s.length_px / 2);
    any = true;
  }
  return any;
}

}  // namespace

Silhouettes exact_silhouettes(const Surface& surface, const LimitSurface& limit,
                              const ContourFunctions& functions, const Camera& camera,
                              const Silhouettes& linear, bool everywhere, Counts& counts) {
  LimitContour contour(limit, camera);
  ExactChain exact(surface, contour, functions, camera);
  ExactSegment segment(contour, camera);
  Silhouettes result;
  result.triangles = linear.triangles;
  result.triangles_visited = linear.triangles_visited;
  for (std::size_t c = 0; c < linear.chains.size(); ++c) {
    const bool closed = linear.closed[c];
    std::vector<ExactPoint> chain = exact.run(linear.chains[c], closed, everywhere);
    int swallowtails = collapse_swallowtails(surface, closed, chain);
    thin_at_cusps(surface, camera, segment, closed, chain);
    for (int round = 0; round < most_rounds && untangle(closed, chain, exact); ++round) {
      chain = exact.again();
      swallowtails = collapse_swallowtails(surface, closed, chain);
      thin_at_cusps(surface, camera, segment, closed, chain);
    }
    counts["swallowtails"] += swallowtails;
    if (closed && chain.size() < smallest_loop) continue;
    for (const ExactPoint& p : chain) {
      result.chains.push(p.point);
      result.cusps += p.is_cusp();
    }
    result.chains.close_list();
    result.closed.push_back(closed);
  }
  counts["evaluations"] += contour.evaluations();
  return result;
}

}  // namespace illustrate
