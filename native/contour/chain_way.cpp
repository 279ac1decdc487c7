#include "contour/chain_way.h"

#include "contour/feature_edges.h"
#include "surface/locate.h"

namespace illustrate {
namespace {

int place_of(const Surface& surface, int triangle, int corner) {
  return surface.places[idx(surface.triangles[idx(triangle)][idx(corner)])];
}

// Where a point lies on a triangle. Exact points are off the plane of the triangle: where they are
// on an edge they have to be for both its sides.
Vec2 place_on(const Surface& surface, int triangle, const ChainPoint& p) {
  if (p.on.triangle == triangle) return {p.on.b1, p.on.b2};
  const EdgeSide side =
      p.edge == none ? EdgeSide{} : opposite_side(surface, {p.on.triangle, p.edge});
  if (side.triangle != triangle) return barycentrics(surface, triangle, p.position);
  const bool parallel =
      place_of(surface, triangle, side.corner) == place_of(surface, p.on.triangle, p.edge);
  const SurfacePoint on = on_edge(triangle, side.corner, parallel ? p.fraction : 1 - p.fraction);
  return {on.b1, on.b2};
}

// The points of a segment: its ends and where it passes edges.
using Way = std::vector<const ChainPoint*>;

void add_pieces(const Surface& surface, const Way& way, int curve, int segment,
                PiecesByTriangle& result) {
  double length = 0;
  for (std::size_t k = 0; k + 1 < way.size(); ++k) {
    length += (way[k + 1]->position - way[k]->position).norm();
  }
  double reached = 0;
  for (std::size_t k = 0; k + 1 < way.size(); ++k) {
    const int triangle = way[k]->on.triangle;
    const double step = (way[k + 1]->position - way[k]->position).norm();
    const double from = length > 0 ? reached / length : 0;
    reached += step;
    const double to = k + 2 < way.size() && length > 0 ? reached / length : 1;
    result[triangle].push_back({curve, segment, place_on(surface, triangle, *way[k]),
                                place_on(surface, triangle, *way[k + 1]), from, to});
  }
}

}  // namespace

PiecesByTriangle pieces_by_triangle(const Surface& surface, const Silhouettes& silhouettes) {
  PiecesByTriangle result;
  auto passed = silhouettes.passed.begin();
  Way way;
  for (std::size_t c = 0; c < silhouettes.chains.size(); ++c) {
    const Span<const ChainPoint> chain = silhouettes.chains[c];
    const std::size_t count = chain.size() - (silhouettes.closed[c] ? 0 : 1);
    for (std::size_t i = 0; i < count; ++i) {
      const int curve = static_cast<int>(c), segment = static_cast<int>(i);
      way = {&chain[i]};
      for (; passed != silhouettes.passed.end() && passed->chain == curve &&
             passed->segment == segment;
           ++passed) {
        way.push_back(&passed->point);
      }
      way.push_back(&chain[(i + 1) % chain.size()]);
      add_pieces(surface, way, curve, segment, result);
    }
  }
  return result;
}

}  // namespace illustrate
