#include "field/last_field.h"

#include "core/parallel.h"
#include "surface/same_vertices.h"

namespace illustrate {
namespace {

// (n) how far the edges round each vertex have turned in the vertex's frame, four times, between
// two surfaces of the same vertices; the length has no meaning.
CrossNumbers turns_of_edges(const Surface& from, const TangentFrames& from_frames,
                            const Surface& to, const TangentFrames& to_frames,
                            const TriangleEdges& edges, const Progress& progress) {
  CrossNumbers turns(to_frames.size(), 0);
  parallel_for(edges.size(), 1, progress, [&](std::size_t begin, std::size_t end) {
    for (std::size_t e = begin; e < end; ++e) {
      const auto [i, j] = edges.vertices[e];
      const Vec3 before = from.positions[idx(j)] - from.positions[idx(i)];
      const Vec3 now = to.positions[idx(j)] - to.positions[idx(i)];
      for (const std::size_t end_vertex : {idx(i), idx(j)}) {
        const CrossNumber start = direction_in_frame(from_frames, end_vertex, before);
        const CrossNumber goal = direction_in_frame(to_frames, end_vertex, now);
        turns[end_vertex] += fourth_power(product(goal, std::conj(start)));
      }
    }
  });
  return turns;
}

}  // namespace

CrossNumbers last_crosses(const Surface& surface, const TangentFrames& frames,
                          const TriangleEdges& edges, const FieldAids& aids,
                          const Progress& progress) {
  if (!aids.last_field || !aids.last_surface) return {};
  const bool is_same_surface = aids.last_surface == &surface;
  if (!is_same_surface && !has_same_vertices(*aids.last_surface, surface)) return {};
  CrossNumbers z(frames.size());
  for (std::size_t i = 0; i < z.size(); ++i) {
    const double u = 4 * aids.last_field->theta[i];
    z[i] = {std::cos(u), std::sin(u)};
  }
  if (is_same_surface) return z;
  const TangentFrames last_frames = tangent_frames(aids.last_surface->normals, 1);
  const CrossNumbers turns =
      turns_of_edges(*aids.last_surface, last_frames, surface, frames, edges, progress);
  for (std::size_t i = 0; i < z.size(); ++i) z[i] = product(normalized(turns[i], 1), z[i]);
  return z;
}

}  // namespace illustrate
