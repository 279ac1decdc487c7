#include "contour/network/surface_ways.h"

#include <algorithm>

#include "contour/shape/feature_edges.h"
#include "surface/locate.h"

namespace illustrate {
namespace {

// Least weights of corners. Chains keep off vertices by far more.
constexpr double chain_inside = 1e-8, intersection_inside = 1e-9;

double weight(const SurfacePoint& p, int corner) {
  return corner == 0 ? 1 - p.b1 - p.b2 : corner == 1 ? p.b1 : p.b2;
}

Vec2 kept_inside(const Vec2& p, double least) {
  Vec3 weights(1 - p.x() - p.y(), p.x(), p.y());
  weights = weights.cwiseMax(least);
  return weights.tail<2>() / weights.sum();
}

// From a fraction of a triangle's edge to that of the same edge of its neighbour.
double beyond(const Surface& surface, const EdgeSide& here, const EdgeSide& there,
              double fraction) {
  const auto place = [&](const EdgeSide& side) {
    return surface.places[idx(surface.triangles[idx(side.triangle)][idx(side.corner)])];
  };
  return place(here) == place(there) ? fraction : 1 - fraction;
}

Vec2 place_on_edge(const EdgeSide& side, double fraction) {
  const SurfacePoint on = on_edge(side.triangle, side.corner, fraction);
  return {on.b1, on.b2};
}

// Exact points are off the plane of the triangle: where they are on an edge they have to be for
// both its sides.
Vec2 place_on(const Surface& surface, int triangle, const ChainPoint& p) {
  if (p.edge != none && p.on.triangle == triangle) return {p.on.b1, p.on.b2};
  const EdgeSide own{p.on.triangle, p.edge};
  const EdgeSide side = p.edge == none ? EdgeSide{} : opposite_side(surface, own);
  if (side.triangle == triangle) return place_on_edge(side, beyond(surface, own, side, p.fraction));
  if (p.on.triangle == triangle) return kept_inside({p.on.b1, p.on.b2}, chain_inside);
  return kept_inside(barycentrics(surface, triangle, p.position), chain_inside);
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
    if (!result.holds(triangle)) continue;
    const double to = k + 2 < way.size() && length > 0 ? reached / length : 1;
    result.add(triangle, {curve, segment, place_on(surface, triangle, *way[k]),
                          place_on(surface, triangle, *way[k + 1]), from, to});
  }
}

class IntersectionWay {
 public:
  IntersectionWay(const Surface& surface, const IntersectionCurves& intersections, int curve,
                  int sheet)
      : surface_(surface),
        points_(intersections.curves[idx(curve)]),
        triangles_(intersections.segment_triangles.data() +
                   intersections.curves.offsets[idx(curve)]),
        count_(static_cast<int>(points_.size())),
        closed_(intersections.closed[idx(curve)] != 0),
        sheet_(idx(sheet)) {}

  std::array<Vec2, 2> ends(int segment) const {
    const int here = triangle(segment);
    return {at(segment, before(segment), here), at(after(segment), after(segment), here)};
  }

 private:
  int triangle(int segment) const { return triangles_[segment][sheet_]; }
  int before(int i) const { return i > 0 ? i - 1 : closed_ ? count_ - 1 : none; }
  int after(int i) const { return i + 1 < count_ ? i + 1 : closed_ ? 0 : none; }

  // Point i as triangle `here` sees it, whose other segment there is `beside`.
  Vec2 at(int i, int beside, int here) const {
    const Vec3& position = points_[idx(i == none ? count_ - 1 : i)].position;
    const int there = beside == none ? none : triangle(beside);
    for (int k = 0; there != none && there != here && k < 3; ++k) {
      if (opposite_side(surface_, {here, k}).triangle == there) return on_shared(i, here, k);
    }
    return kept_inside(barycentrics(surface_, here, position), intersection_inside);
  }

  // On edge k of the triangle: the fraction that the point's own triangle tells.
  Vec2 on_shared(int i, int here, int k) const {
    const IntersectionPoint& point = points_[idx(i)];
    const SurfacePoint& on = sheet_ == 0 ? point.a : point.b;
    const EdgeSide own{here, k};
    double fraction = weight(on, next_corner(k));
    if (on.triangle != here) {
      const EdgeSide side = opposite_side(surface_, own);
      fraction = beyond(surface_, side, own, weight(on, next_corner(side.corner)));
    }
    return place_on_edge(own, std::clamp(fraction, intersection_inside, 1 - intersection_inside));
  }

  const Surface& surface_;
  Span<const IntersectionPoint> points_;
  const std::array<int, 2>* triangles_;  // (points)
  int count_;
  bool closed_;
  std::size_t sheet_;
};

}  // namespace

PiecesByTriangle::PiecesByTriangle(const std::vector<int>& triangles) : lists_(triangles.size()) {
  int count = 0;
  for (const int triangle : triangles) {
    if (triangle != none && !holds(triangle)) lists_.at(triangle) = count++;
  }
  pieces_.resize(idx(count));
}

void PiecesByTriangle::add(int triangle, const CurvePiece& piece) {
  if (holds(triangle)) pieces_[idx(lists_[triangle])].push_back(piece);
}

Span<const CurvePiece> PiecesByTriangle::operator[](int triangle) const {
  if (!holds(triangle)) return {};
  const std::vector<CurvePiece>& list = pieces_[idx(lists_[triangle])];
  return {list.data(), list.size()};
}

PiecesByTriangle pieces_of_chains(const Surface& surface, const Silhouettes& silhouettes,
                                  const std::vector<int>& triangles) {
  PiecesByTriangle result(triangles);
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

std::array<Vec2, 2> ends_on_sheet(const Surface& surface, const IntersectionCurves& intersections,
                                  int curve, int segment, int sheet) {
  return IntersectionWay(surface, intersections, curve, sheet).ends(segment);
}

}  // namespace illustrate
