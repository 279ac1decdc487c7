#include "surface/jets/jet.h"

#include <algorithm>
#include <cmath>

#include "core/parallel.h"
#include "surface/jets/control_jets.h"

namespace illustrate {
namespace {

// Enough for three rings of a regular mesh three times over; beyond it points are taken by stride.
constexpr std::size_t most_points = 100;
// Of a vertex with very many neighbours only so many are followed, by stride.
constexpr std::size_t most_neighbours = 48;

}  // namespace

JetFitter::JetFitter(const Surface& surface, int rings)
    : surface_(surface),
      rings_(rings),
      offsets_(surface.positions.size() + 1, 0),
      at_border_(surface.positions.size(), 0) {
  for (const Triangle& t : surface.triangles) {
    for (const int v : t) offsets_[idx(v) + 1] += 2;
  }
  for (std::size_t v = 1; v < offsets_.size(); ++v) offsets_[v] += offsets_[v - 1];
  std::vector<int> cursor(offsets_.begin(), offsets_.end() - 1);
  neighbours_.resize(idx(offsets_.back()));
  for (std::size_t i = 0; i < surface.triangles.size(); ++i) {
    const Triangle& t = surface.triangles[i];
    for (int k = 0; k < 3; ++k) {
      const int a = t[idx(k)], b = t[idx(next_corner(k))];
      neighbours_[idx(cursor[idx(a)]++)] = b;
      neighbours_[idx(cursor[idx(b)]++)] = a;
      const EdgeKind kind = surface.edge_kinds[i][idx(k)];
      if (surface.neighbours[i][idx(k)] != none && kind != EdgeKind::crease) continue;
      at_border_[idx(a)] = at_border_[idx(b)] = 1;
    }
  }
  std::size_t kept = 0;
  for (std::size_t v = 0; v + 1 < offsets_.size(); ++v) {
    const auto begin = neighbours_.begin() + offsets_[v],
               end = neighbours_.begin() + offsets_[v + 1];
    std::sort(begin, end);
    offsets_[v] = static_cast<int>(kept);
    for (auto i = begin; i != end; ++i) {
      if (i == begin || *i != *(i - 1)) neighbours_[kept++] = *i;
    }
  }
  offsets_.back() = static_cast<int>(kept);
}

void JetFitter::gather(int vertex, Workspace& work) const {
  work.visited.resize(surface_.positions.size(), none);
  work.found.assign(1, vertex);
  work.visited[idx(vertex)] = vertex;
  std::size_t from = 0;
  for (int ring = 0; ring < rings_ && work.found.size() < most_points; ++ring) {
    const std::size_t to = work.found.size();
    for (; from < to; ++from) {
      const std::size_t v = idx(work.found[from]);
      const std::size_t count = idx(offsets_[v + 1] - offsets_[v]);
      const std::size_t stride = (count + most_neighbours - 1) / most_neighbours;
      for (std::size_t k = 0; k < count; k += stride) {
        const int n = neighbours_[idx(offsets_[v]) + k];
        if (work.visited[idx(n)] == vertex) continue;
        work.visited[idx(n)] = vertex;
        work.found.push_back(n);
      }
    }
  }
  thin(work.found, most_points);
}

PrincipalCurvature JetFitter::fit(int vertex, Workspace& work) const {
  gather(vertex, work);
  work.jet.take(surface_, work.found);
  // The normal of a limit surface is exact, that of a polygon mesh is worse than the fit's own.
  const bool exact_normal = surface_.object_is_smooth[idx(surface_.objects[idx(vertex)])] != 0;
  // With points on one side only a higher degree swings.
  return work.jet.fit(at_border_[idx(vertex)] ? 2 : 4, exact_normal);
}

void fit_jets(const Surface& surface, const std::vector<int>& vertices, const JetOptions& options,
              const Progress& progress, Curvature& result) {
  progress.report(0);
  if (vertices.empty()) return;
  const JetFitter fitter(surface, options.rings);
  parallel_for(vertices.size(), options.threads, progress, [&](std::size_t begin, std::size_t end) {
    JetFitter::Workspace work;
    for (std::size_t i = begin; i < end; ++i) {
      result[idx(vertices[i])] = fitter.fit(vertices[i], work);
    }
  });
}

Curvature jet_curvature(const Surface& surface, const JetOptions& options,
                        const Progress& progress) {
  Curvature result(surface.positions.size());
  const std::vector<int> left = control_jets(surface, options, progress.part(0, .5), result);
  fit_jets(surface, left, options, progress.part(.5, 1), result);
  return result;
}

}  // namespace illustrate
