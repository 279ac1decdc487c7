#include "surface/limit/limit.h"

#include <algorithm>
#include <cmath>

#include "core/parallel.h"
#include "core/tolerances.h"
#include "mesh/polygons.h"
#include "surface/jets/curvature.h"
#include "surface/limit/limit_patches.h"
#include "surface/shading.h"

namespace illustrate {
namespace {

Vec3 normal_of(const LimitPoint& p, double least) {
  double reach = 0;
  for (const Vec3* d : {&p.du, &p.dv, &p.duu, &p.duv, &p.dvv})
    reach = std::max(reach, d->stableNorm());
  return spanned_normal(p.du, p.dv, reach, least);
}

void resize(SectorLimits& result, std::size_t count) {
  result.positions.resize(count);
  result.normals.resize(count);
  result.curvature.resize(count);
  result.needs_jet.resize(count);
}

void set_undefined(std::size_t i, SectorLimits& result) {
  result.normals[i].setZero();
  result.curvature[i] = {};
}

void limit_of_sector(const RefinedMesh& mesh, const Sectors& sectors, std::size_t s, double least,
                     Ring& ring, SectorLimits& result) {
  if (!read_ring(mesh, sectors, static_cast<int>(s), ring)) {
    result.positions[s] = ring.centre;
    set_undefined(s, result);
    return;
  }
  LimitPoint p;
  const bool fitted = fit_derivatives(ring, p);
  const bool smooth = ring.rule == VertexRule::smooth;
  result.positions[s] = smooth ? p.position : limit_position(ring);
  if (fitted) {
    result.normals[s] = normal_of(p, least);
    result.curvature[s] = principal_curvature(p, result.normals[s]);
  } else {
    set_undefined(s, result);
    result.normals[s] = limit_normal(ring, least);
    result.needs_jet[s] = 1;
  }
}

// Where sharpness has not faded yet, and at the end of a sharp edge that is no corner, the limit is
// several levels away: the patches know it.
void evaluate_patches(const Subdivision& subdivision, const RefinedMesh& mesh,
                      const Sectors& sectors, double least, int threads, SectorLimits& result) {
  const auto beyond_masks = [&](int vertex) {
    const bool semi_sharp = !mesh.semi_sharp.empty() && mesh.semi_sharp[idx(vertex)];
    const bool is_dart = sectors.sharp_edges[idx(vertex)] == 1 && !mesh.sharp_vertices[idx(vertex)];
    return semi_sharp || is_dart;
  };
  int vertex = 0;
  const int vertices = static_cast<int>(mesh.points.size());
  while (vertex < vertices && !beyond_masks(vertex)) ++vertex;
  if (vertex == vertices) return;
  const LimitPatches patches(subdivision.base(), subdivision.scheme());
  parallel_for(sectors.count(), threads, [&](std::size_t begin, std::size_t end) {
    LimitPatches::Pass pass(patches);
    for (std::size_t s = begin; s < end; ++s) {
      const int corner = sectors.first_corners[s];
      if (!beyond_masks(mesh.vertex(corner))) continue;
      const std::optional<LimitPoint> p = pass.evaluate(base_place(mesh, corner));
      if (!p || !p->position.allFinite()) continue;
      result.positions[s] = p->position;
      result.normals[s] = normal_of(*p, least);
      result.needs_jet[s] = 0;
      result.curvature[s] = principal_curvature(*p, result.normals[s]);
    }
  });
}

// For each vertex inside the surface that is extraordinary its sector, else `none`.
std::vector<int> extraordinary_sectors(const RefinedMesh& mesh, const Sectors& sectors) {
  const int regular = mesh.triangles_are_patches ? 6 : 4;
  std::vector<int> found(mesh.points.size(), none);
  for (std::size_t s = 0; s < sectors.count(); ++s) {
    if (!sectors.closed[s] || sectors.sizes[s] == regular) continue;
    found[idx(mesh.vertex(sectors.first_corners[s]))] = static_cast<int>(s);
  }
  return found;
}

// Around extraordinary vertices the ratio of curvatures that a ring shows drifts from level to
// level (it converges to 0, 1 or infinity); appendix A wants that of the control mesh: the first
// level on which the vertex exists and all faces around are patches.
void inherit_extraordinary(const Subdivision& subdivision, const std::vector<int>& extraordinary,
                           int birth, int level, SectorLimits& result) {
  const RefinedMesh& mesh = subdivision.level(birth);
  const auto heir = [&](int vertex) {
    return extraordinary[idx(subdivision.descendant(vertex, birth, level))];
  };
  std::vector<std::uint8_t> wanted(mesh.points.size());
  for (std::size_t v = 0; v < wanted.size(); ++v) {
    const bool semi_sharp = !mesh.semi_sharp.empty() && mesh.semi_sharp[v];
    wanted[v] = !semi_sharp && heir(static_cast<int>(v)) != none;
  }
  const Sectors sectors = smooth_sectors(mesh, wanted);
  Ring ring;
  LimitPoint p;
  for (std::size_t s = 0; s < sectors.count(); ++s) {
    if (!read_ring(mesh, sectors, static_cast<int>(s), ring)) continue;
    if (ring.rule != VertexRule::smooth) continue;
    fit_derivatives(ring, p);
    const std::size_t target = idx(heir(mesh.vertex(sectors.first_corners[s])));
    result.curvature[target] = principal_curvature(p, result.normals[target]);
  }
}

// Normals that were mended move the tangent plane away from the directions found before.
void turn_directions(int threads, SectorLimits& result) {
  parallel_for(result.normals.size(), threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t s = begin; s < end; ++s) {
      const Vec3& n = result.normals[s];
      Vec3 &w1 = result.curvature[s].w1, &w2 = result.curvature[s].w2;
      const bool is_tangent = std::abs(w1.dot(n)) < 1e-9 && std::abs(w2.dot(n)) < 1e-9;
      if (is_tangent && w1.squaredNorm() > .5) continue;
      w1 = tangent_towards(w1, n);
      w2 = n.cross(w1);
    }
  });
}

}  // namespace

SectorLimits limits(const Subdivision& subdivision, const RefinedMesh& mesh, const Sectors& sectors,
                    int level, int threads, const Progress& progress) {
  SectorLimits result;
  resize(result, sectors.count());
  const double least = tolerance::same_place * mean_edge(mesh);
  parallel_for(sectors.count(), threads, [&](std::size_t begin, std::size_t end) {
    Ring ring;
    for (std::size_t s = begin; s < end; ++s)
      limit_of_sector(mesh, sectors, s, least, ring, result);
  });
  progress.report(.5);
  const std::vector<int> extraordinary = extraordinary_sectors(mesh, sectors);
  // Faces that are no patches become patches on level 1; what was fitted on level 0 overrides.
  for (int birth = std::min(level, 2) - 1; birth >= 0; --birth) {
    inherit_extraordinary(subdivision, extraordinary, birth, level, result);
  }
  progress.report(.8);
  evaluate_patches(subdivision, mesh, sectors, least, threads, result);
  share_positions(mesh, sectors, result.positions);
  mend_normals(mesh, sectors, threads, result);
  turn_directions(threads, result);
  return result;
}

SectorLimits polygonal_limits(const RefinedMesh& mesh, const Sectors& sectors, int threads) {
  SectorLimits result;
  resize(result, sectors.count());
  for (std::size_t s = 0; s < sectors.count(); ++s) {
    set_undefined(s, result);
    result.positions[s] = mesh.point(sectors.first_corners[s]);
    result.needs_jet[s] = 1;
  }
  polygon_normals(mesh, sectors, threads, result.normals);
  mend_normals(mesh, sectors, threads, result);
  return result;
}

}  // namespace illustrate
