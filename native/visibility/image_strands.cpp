#include "visibility/image_strands.h"

#include <algorithm>
#include <cmath>

#include "core/tolerances.h"

namespace illustrate {
namespace {

// Twice this many pixels, in grid units, stay below 2^46: products of differences fit 128 bits.
// Only what nearly touches the eye lies farther out.
constexpr double farthest_px = 5e8;

double within_reach(double x) {
  return std::isfinite(x) ? std::clamp(x, -farthest_px, farthest_px) : 0;
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

ImageStrands project_strands(const CurveNetwork& network, const Camera& camera) {
  ImageStrands result;
  result.perspective = camera.is_perspective();
  const int nodes = static_cast<int>(network.nodes.size());
  result.image.reserve(network.points.values.size());
  result.depth.reserve(network.points.values.size());
  result.grid.reserve(network.points.values.size());
  for (const CurvePoint& p : network.points.values) {
    const ImagePoint seen = camera.project(p.position);
    const Vec2 xy(within_reach(seen.xy.x()), within_reach(seen.xy.y()));
    result.image.push_back(xy);
    result.depth.push_back(std::isfinite(seen.depth) ? seen.depth : 0);
    const int id = nodes + static_cast<int>(result.grid.size());
    result.grid.push_back({to_grid(xy.x()), -to_grid(xy.y()), id});
  }
  share_node_ids(network, result.grid);
  merge_coincident(network, result.grid);
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
