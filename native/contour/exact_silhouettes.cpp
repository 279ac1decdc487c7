#include "contour/exact_silhouettes.h"

#include "contour/cusp_ends.h"

namespace illustrate {

Silhouettes exact_silhouettes(const Surface& surface, const LimitSurface& limit,
                              const ContourFunctions& functions, const Camera& camera,
                              const Silhouettes& linear, bool everywhere, Counts& counts) {
  constexpr std::size_t smallest_loop = 3;
  LimitContour contour(limit, camera);
  ExactChain exact(surface, contour, functions, camera);
  ExactSegment segment(contour, camera);
  Silhouettes result;
  result.triangles = linear.triangles;
  result.triangles_visited = linear.triangles_visited;
  for (std::size_t c = 0; c < linear.chains.size(); ++c) {
    const bool closed = linear.closed[c];
    std::vector<ExactPoint> chain = exact.run(linear.chains[c], closed, everywhere);
    counts["swallowtails"] += collapse_swallowtails(surface, closed, chain);
    thin_at_cusps(surface, camera, segment, closed, chain);
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
