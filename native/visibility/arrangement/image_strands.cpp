#include "visibility/arrangement/image_strands.h"

#include <algorithm>
#include <cmath>

#include "core/tolerances.h"
#include "visibility/reaches.h"

namespace illustrate {
namespace {

// Twice this many pixels, in grid units, stay below 2^46: products of differences fit 128 bits.
// Only what nearly touches the eye lies farther out.
constexpr double farthest_px = 5e8;

// Of the farthest move: depths of curves that touch, once they are moved, on surfaces seen aslant.
constexpr double touching_moves = 20;

// And where they are apart by rounding alone, far below what keeps parts apart.
constexpr double rounding_moves = 0x1p-16;

double farthest_move(const CurveNetwork& network, const Points& decided) {
  double farthest = 0;
  for (std::size_t i = 0; i < decided.size(); ++i)
    farthest = std::max(farthest, (decided[i] - network.points.values[i].position).norm());
  return farthest;
}

// A place on a needle may have any shares of its corners, far beyond it. It moves as far as they
// do: one that is thought far off would have everything in view touch everything.
Vec3 inset_at(const Surface& surface, const Points& insets, const SurfacePoint& on) {
  const Triangle& t = surface.triangles[idx(on.triangle)];
  const Vec3 shares = Vec3(1 - on.b1 - on.b2, on.b1, on.b2).cwiseMax(0).cwiseMin(1);
  const Vec3 sum =
      shares[0] * insets[idx(t[0])] + shares[1] * insets[idx(t[1])] + shares[2] * insets[idx(t[2])];
  const double all = shares.sum();
  return all > 0 ? Vec3(sum / all) : insets[idx(t[0])];
}

// To the nearest, halves away from zero.
std::int64_t to_grid(double px) {
  const double units = px / tolerance::image_grid_px;
  return static_cast<std::int64_t>(units + (units < 0 ? -0.5 : 0.5));
}

void share_node_ids(const CurveNetwork& network, std::vector<GridPoint>& grid) {
  for (std::size_t s = 0; s < network.strands.size(); ++s) {
    const Strand& strand = network.strands[s];
    if (strand.closed()) continue;
    grid[idx(network.points.offsets[s])].id = strand.start_node;
    grid[idx(network.points.offsets[s + 1] - 1)].id = strand.end_node;
  }
}

// Consecutive points at one place of the grid become one point, that of the strand's end there if
// there is one: a segment of no length would cross others at the whim of the perturbation.
void merge_coincident(const CurveNetwork& network, std::vector<GridPoint>& grid) {
  const auto follow = [&](std::size_t i, std::size_t neighbour) {
    const bool same = grid[i].x == grid[neighbour].x && grid[i].y == grid[neighbour].y;
    if (same) grid[i].id = grid[neighbour].id;
    return same;
  };
  for (std::size_t s = 0; s < network.strands.size(); ++s) {
    const std::size_t begin = idx(network.points.offsets[s]);
    const std::size_t end = idx(network.points.offsets[s + 1]);
    if (end - begin < 2) continue;
    const bool closed = network.strands[s].closed();
    for (std::size_t i = begin + 1; i + (closed ? 0 : 1) < end; ++i) follow(i, i - 1);
    std::size_t next = closed ? begin : end - 1;
    for (std::size_t i = closed ? end - 1 : end - 2; i > begin && follow(i, next); --i) next = i;
  }
}

}  // namespace

double within_reach(double px) {
  return std::isfinite(px) ? std::clamp(px, -farthest_px, farthest_px) : 0;
}

Points inset_points(const CurveNetwork& network, const Surface& surface, const Points& insets) {
  Points moved;
  if (insets.empty()) return moved;
  for (const CurvePoint& p : network.points.values)
    moved.push_back(p.position + inset_at(surface, insets, p.on));
  std::vector<const Vec3*> at_nodes(network.nodes.size(), nullptr);
  for (std::size_t s = 0; s < network.strands.size(); ++s) {
    const Strand& strand = network.strands[s];
    if (strand.closed()) continue;
    const int first = network.points.offsets[s], last = network.points.offsets[s + 1] - 1;
    for (const auto& [node, i] : {Edge{strand.start_node, first}, Edge{strand.end_node, last}}) {
      if (!at_nodes[idx(node)]) at_nodes[idx(node)] = &moved[idx(i)];
      moved[idx(i)] = *at_nodes[idx(node)];
    }
  }
  return moved;
}

ImageStrands project_strands(const CurveNetwork& network, const Camera& camera, Points decided) {
  ImageStrands result;
  result.perspective = camera.is_perspective();
  const int nodes = static_cast<int>(network.nodes.size());
  result.image.reserve(network.points.values.size());
  result.depth.reserve(network.points.values.size());
  result.grid.reserve(network.points.values.size());
  const auto project = [&](const Vec3& p) -> ImagePoint {
    const ImagePoint seen = camera.project(p);
    return {Vec2(within_reach(seen.xy.x()), within_reach(seen.xy.y())),
            std::isfinite(seen.depth) ? seen.depth : 0};
  };
  const double farthest = farthest_move(network, decided);
  for (std::size_t i = 0; i < network.points.values.size(); ++i) {
    const Vec3& p = network.points.values[i].position;
    const ImagePoint seen = project(p);
    ImagePoint taken = seen;
    if (farthest > 0) {
      const double share = std::min(1., reaches.decided_move * camera.pixel_size(p) / farthest);
      const Vec3 moved = p + share * (decided[i] - p);
      if (camera.near_distance(moved) > 0) taken = project(moved);
    }
    result.image.push_back(seen.xy);
    result.depth.push_back(seen.depth);
    result.decided_depth.push_back(taken.depth);
    const int id = nodes + static_cast<int>(result.grid.size());
    result.places.push_back({to_grid(seen.xy.x()), -to_grid(seen.xy.y()), id});
    result.grid.push_back({to_grid(taken.xy.x()), -to_grid(taken.xy.y()), id});
  }
  for (std::vector<GridPoint>* grid : {&result.places, &result.grid}) {
    share_node_ids(network, *grid);
    merge_coincident(network, *grid);
  }
  result.decided = std::move(decided);
  result.touching = touching_moves * farthest;
  result.same_depth = rounding_moves * farthest;
  return result;
}

std::vector<StrandSegment> all_segments(const CurveNetwork& network) {
  std::vector<StrandSegment> result;
  result.reserve(network.points.values.size());
  for (std::size_t s = 0; s < network.strands.size(); ++s) {
    const int begin = network.points.offsets[s], end = network.points.offsets[s + 1];
    const int strand = static_cast<int>(s);
    for (int p = begin; p + 1 < end; ++p) result.push_back({strand, p - begin, p, p + 1});
    if (network.strands[s].closed()) result.push_back({strand, end - 1 - begin, end - 1, begin});
  }
  return result;
}

double world_fraction(double image_fraction, double depth_a, double depth_b, bool perspective) {
  if (!perspective) return image_fraction;
  const double denominator = depth_b + image_fraction * (depth_a - depth_b);
  const double fraction = image_fraction * depth_a / denominator;
  return fraction >= 0 && fraction <= 1 ? fraction : image_fraction;
}

}  // namespace illustrate
