#include "contour/chain_way.h"

#include "contour/feature_edges.h"
#include "surface/locate.h"

namespace illustrate {
namespace {

constexpr int longest_way = 64;  // triangles

int place_of(const Surface& surface, int triangle, int corner) {
  return surface.places[idx(surface.triangles[idx(triangle)][idx(corner)])];
}

// The same point of an edge as the triangle on its other side sees it; no triangle where the point
// lies on no edge or there is nothing beyond.
SurfacePoint on_other_side(const Surface& surface, const ChainPoint& p) {
  if (p.edge == none) return {none, 0, 0};
  const EdgeSide side = opposite_side(surface, {p.on.triangle, p.edge});
  if (side.triangle == none) return {none, 0, 0};
  const bool parallel =
      place_of(surface, side.triangle, side.corner) == place_of(surface, p.on.triangle, p.edge);
  return on_edge(side.triangle, side.corner, parallel ? p.fraction : 1 - p.fraction);
}

Vec3 corner_at(const Surface& surface, int triangle, int corner) {
  return surface.positions[idx(surface.triangles[idx(triangle)][idx(corner)])];
}

Vec3 flat_point(const Surface& surface, const SurfacePoint& on) {
  const Vec3 &a = corner_at(surface, on.triangle, 0), b = corner_at(surface, on.triangle, 1),
             c = corner_at(surface, on.triangle, 2);
  return a + on.b1 * (b - a) + on.b2 * (c - a);
}

// Through the triangles that a plane through two points of the surface cuts, from one to the other.
class PlaneWalk {
 public:
  PlaneWalk(const Surface& surface, const SurfacePoint& from, const SurfacePoint& to)
      : surface_(surface), from_(from), start_(flat_point(surface, from)) {
    along_ = flat_point(surface, to) - start_;
    const Vec3 first = face_normal(surface, from.triangle),
               last = face_normal(surface, to.triangle);
    across_ = along_.cross(first.dot(last) < 0 ? Vec3(first - last) : Vec3(first + last));
  }

  // Empty where it does not get to either of the places that stand for the last point.
  std::vector<ChainPiece> run(const std::array<SurfacePoint, 2>& targets) {
    int triangle = from_.triangle, entered = none;
    Vec2 here{from_.b1, from_.b2};
    pieces_.clear();
    for (int step = 0; step < longest_way; ++step) {
      for (const SurfacePoint& target : targets) {
        if (target.triangle == triangle)
          return finish({triangle, here, {target.b1, target.b2}, 0, 1});
      }
      const int exit = exit_edge(triangle, entered);
      if (exit == none) return {};
      const double fraction = cut(triangle, exit);
      const SurfacePoint out = on_edge(triangle, exit, fraction);
      const EdgeSide side = opposite_side(surface_, {triangle, exit});
      if (side.triangle == none) return {};
      pieces_.push_back({triangle, here, {out.b1, out.b2}, 0, share(out)});
      const bool parallel =
          place_of(surface_, side.triangle, side.corner) == place_of(surface_, triangle, exit);
      const SurfacePoint in =
          on_edge(side.triangle, side.corner, parallel ? fraction : 1 - fraction);
      here = {in.b1, in.b2};
      triangle = side.triangle;
      entered = side.corner;
    }
    return {};
  }

 private:
  double height(int triangle, int corner) const {
    return across_.dot(corner_at(surface_, triangle, corner) - start_);
  }

  bool is_cut(int triangle, int edge) const {
    return (height(triangle, edge) < 0) != (height(triangle, next_corner(edge)) < 0);
  }

  double cut(int triangle, int edge) const {
    const double low = height(triangle, edge), high = height(triangle, next_corner(edge));
    return low / (low - high);
  }

  // How far a point lies towards the last one.
  double share(const SurfacePoint& on) const {
    const double square = along_.squaredNorm();
    return square > 0 ? (flat_point(surface_, on) - start_).dot(along_) / square : 0;
  }

  // The cut edge other than the entered one; in the first triangle that nearer to the last point.
  int exit_edge(int triangle, int entered) const {
    int best = none;
    double farthest = 0;
    for (int k = 0; k < 3; ++k) {
      if (k == entered || !is_cut(triangle, k)) continue;
      const double reached = share(on_edge(triangle, k, cut(triangle, k)));
      if (best != none && reached <= farthest) continue;
      best = k;
      farthest = reached;
    }
    return best;
  }

  // Shares that do not run backwards, from 0 to 1.
  std::vector<ChainPiece> finish(const ChainPiece& last) {
    pieces_.push_back(last);
    double reached = 0;
    for (ChainPiece& piece : pieces_) {
      piece.from = reached;
      piece.to = reached = std::max(reached, std::min(piece.to, 1.0));
    }
    return std::move(pieces_);
  }

  const Surface& surface_;
  SurfacePoint from_;
  Vec3 start_, along_, across_;
  std::vector<ChainPiece> pieces_;
};

}  // namespace

std::vector<ChainPiece> chain_pieces(const Surface& surface, const ChainPoint& from,
                                     const ChainPoint& to) {
  const int first = from.on.triangle;
  const Vec2 start{from.on.b1, from.on.b2};
  const std::array<SurfacePoint, 2> targets{to.on, on_other_side(surface, to)};
  for (const SurfacePoint& target : targets) {
    if (target.triangle == first) return {{first, start, {target.b1, target.b2}, 0, 1}};
  }
  std::vector<ChainPiece> pieces = PlaneWalk(surface, from.on, to.on).run(targets);
  if (!pieces.empty()) return pieces;
  return {{first, start, barycentrics(surface, first, to.position), 0, 1}};
}

PiecesByTriangle pieces_by_triangle(const Surface& surface, const Silhouettes& silhouettes) {
  PiecesByTriangle result;
  for (std::size_t c = 0; c < silhouettes.chains.size(); ++c) {
    const Span<const ChainPoint> chain = silhouettes.chains[c];
    const std::size_t count = chain.size() - (silhouettes.closed[c] ? 0 : 1);
    for (std::size_t i = 0; i < count; ++i) {
      for (const ChainPiece& p : chain_pieces(surface, chain[i], chain[(i + 1) % chain.size()])) {
        result[p.triangle].push_back({p, static_cast<int>(c), static_cast<int>(i)});
      }
    }
  }
  return result;
}

}  // namespace illustrate
