#include "field/last_field.h"

#include "core/parallel.h"
#include "surface/same_objects.h"

namespace illustrate {
namespace {

// Positions in single precision, and motion too slow to be seen, are no stretch (a share).
constexpr double least_stretch = 1e-3;

// How far along an edge is from one end to the other, in the last frame and now.
struct EdgeMove {
  int from, to;  // vertices of the last surface, or none
  Vec3 before, now;
};

EdgeMove move_of(const SameObjects& same, const Surface& surface, const Edge& edge) {
  EdgeMove move{same.last_vertex(idx(edge[0])), same.last_vertex(idx(edge[1])), {}, {}};
  move.now = surface.positions[idx(edge[1])] - surface.positions[idx(edge[0])];
  if (move.from == none || move.to == none) return {none, none, {}, move.now};
  move.before = same.last().positions[idx(move.to)] - same.last().positions[idx(move.from)];
  return move;
}

// (n) how far the edges round each vertex have turned in the vertex's frame, four times; the length
// has no meaning.
CrossNumbers turns_of_edges(const SameObjects& same, const Surface& surface,
                            const TangentFrames& frames, const TriangleEdges& edges,
                            const Progress& progress) {
  const TangentFrames last_frames = tangent_frames(same.last().normals, 1);
  CrossNumbers turns(frames.size(), 0);
  parallel_for(edges.size(), 1, progress, [&](std::size_t begin, std::size_t end) {
    for (std::size_t e = begin; e < end; ++e) {
      const EdgeMove move = move_of(same, surface, edges.vertices[e]);
      if (move.from == none) continue;
      const std::array<int, 2> last_ends{move.from, move.to};
      for (std::size_t k = 0; k < 2; ++k) {
        const std::size_t vertex = idx(edges.vertices[e][k]);
        const CrossNumber start = direction_in_frame(last_frames, idx(last_ends[k]), move.before);
        const CrossNumber goal = direction_in_frame(frames, vertex, move.now);
        turns[vertex] += fourth_power(product(goal, std::conj(start)));
      }
    }
  });
  return turns;
}

CrossNumber fourth(const CrossField& field, std::size_t vertex) {
  const double u = 4 * field.theta[vertex];
  return {std::cos(u), std::sin(u)};
}

}  // namespace

CrossNumbers last_crosses(const Surface& surface, const TangentFrames& frames,
                          const TriangleEdges& edges, const FieldAids& aids,
                          const Progress& progress) {
  if (!aids.last_field || !aids.last_surface) return {};
  CrossNumbers z(frames.size(), 0);
  if (aids.last_surface == &surface) {
    for (std::size_t i = 0; i < z.size(); ++i) z[i] = fourth(*aids.last_field, i);
    return z;
  }
  const SameObjects same(*aids.last_surface, surface, aids.last_objects);
  if (!same.any()) return {};
  const CrossNumbers turns = turns_of_edges(same, surface, frames, edges, progress);
  for (std::size_t i = 0; i < z.size(); ++i) {
    const int last = same.last_vertex(i);
    if (last == none) continue;
    z[i] = product(normalized(turns[i], 1), fourth(*aids.last_field, idx(last)));
  }
  return z;
}

std::vector<std::uint8_t> resting_vertices(const Surface& surface, const TriangleEdges& edges,
                                           const FieldAids& aids) {
  if (!aids.last_field || !aids.last_surface || aids.last_surface == &surface) return {};
  const SameObjects same(*aids.last_surface, surface, aids.last_objects);
  if (!same.any()) return {};
  std::vector<std::uint8_t> rests(surface.positions.size());
  for (std::size_t i = 0; i < rests.size(); ++i) rests[i] = same.last_vertex(i) != none;
  for (const Edge& edge : edges.vertices) {
    const EdgeMove move = move_of(same, surface, edge);
    const double before = move.before.norm(), stretch = std::abs(move.now.norm() - before);
    if (move.from != none && stretch <= least_stretch * before) continue;
    rests[idx(edge[0])] = rests[idx(edge[1])] = 0;
  }
  return rests;
}

}  // namespace illustrate
