#include "surface/subdivision/sharpness.h"

#include <algorithm>
#include <tuple>

#include "core/parallel.h"
#include "surface/subdivision/base_edges.h"

namespace illustrate {
namespace {

using OpenSubdiv::Far::TopologyLevel;

// One end of a seam: the split vertex, which of its copies, and where the seam goes.
struct SeamEnd {
  int source, copy, other_source;
  bool operator<(const SeamEnd& e) const {
    return std::tie(source, copy, other_source) < std::tie(e.source, e.copy, e.other_source);
  }
};

std::vector<SeamEnd> seam_ends(const SoundMesh& mesh) {
  std::vector<SeamEnd> ends;
  const auto source = [&](int v) { return mesh.source_vertices[idx(v)]; };
  for (const Edge& e : mesh.seams) {
    ends.push_back({source(e[0]), e[0], source(e[1])});
    ends.push_back({source(e[1]), e[1], source(e[0])});
  }
  std::sort(ends.begin(), ends.end());
  return ends;
}

// The boundary rule moves a vertex between the ends of its two open edges. Copies of a split vertex
// whose seams lead to different ends would part, so they stay where they are.
std::vector<int> vertices_held_by_seams(const SoundMesh& mesh) {
  const std::vector<SeamEnd> ends = seam_ends(mesh);
  std::vector<int> held;
  for (std::size_t from = 0, to = 0; from < ends.size(); from = to) {
    while (to < ends.size() && ends[to].source == ends[from].source) ++to;
    bool agree = (to - from) % 2 == 0;
    for (std::size_t i = from; agree && i < to; ++i) {
      agree = ends[i].copy == ends[from + (i - from) / 2 * 2].copy &&
              ends[i].other_source == ends[from + (i - from) % 2].other_source;
    }
    for (std::size_t i = from; !agree && i < to; ++i) held.push_back(ends[i].copy);
  }
  held.erase(std::unique(held.begin(), held.end()), held.end());
  return held;
}

bool is_infinite(float sharpness) { return sharpness >= static_cast<float>(infinitely_sharp); }
bool is_semi_sharp(float sharpness) { return sharpness > 0 && !is_infinite(sharpness); }

void set_semi_sharp(int vertex, RefinedMesh& mesh) {
  mesh.semi_sharp.resize(mesh.sharp_vertices.size(), 0);
  mesh.semi_sharp[idx(vertex)] = 1;
}

// A boundary is infinitely sharp, whatever was said of its edges.
void find_semi_sharp_edges(const SoundMesh& base, RefinedMesh& mesh) {
  std::vector<Edge> edges;
  for (std::size_t e = 0; e < base.edge_vertices.size(); ++e) {
    const auto sharpness = static_cast<float>(base.edge_sharpness[e]);
    if (is_semi_sharp(sharpness)) edges.push_back(base.edge_vertices[e]);
  }
  if (edges.empty()) return;
  const EdgeTable table(base.positions.size(), edges);
  for (int c = 0; c < static_cast<int>(mesh.corner_count()); ++c) {
    const int from = mesh.vertex(c), to = mesh.vertex(mesh.next(c));
    if (mesh.mate(c) == none || table.find(from, to) == none) continue;
    set_semi_sharp(from, mesh);
    set_semi_sharp(to, mesh);
  }
}

// Vertices of one face.
void sharpen_corners_of_boundary(RefinedMesh& mesh) {
  for (int c = 0; c < static_cast<int>(mesh.corner_count()); ++c) {
    if (mesh.mate(c) != none || mesh.mate(mesh.previous(c)) != none) continue;
    mesh.sharp_vertices[idx(mesh.vertex(c))] = 1;
    if (!mesh.semi_sharp.empty()) mesh.semi_sharp[idx(mesh.vertex(c))] = 0;
  }
}

// Edges inside a face are smooth, so that those of the parent tell of all.
void inherit_semi_sharp_edges(const TopologyLevel& level, const TopologyLevel& next,
                              RefinedMesh& child) {
  for (int e = 0; e < level.GetNumEdges(); ++e) {
    const auto ends = level.GetEdgeVertices(e), halves = level.GetEdgeChildEdges(e);
    for (int k = 0; k < 2; ++k) {
      if (!next.IsEdgeSemiSharp(halves[k])) continue;
      set_semi_sharp(level.GetVertexChildVertex(ends[k]), child);
      set_semi_sharp(level.GetEdgeChildVertex(e), child);
    }
  }
}

}  // namespace

std::vector<float> vertex_sharpness(const SoundMesh& mesh) {
  std::vector<float> sharpness(mesh.vertex_sharpness.begin(), mesh.vertex_sharpness.end());
  sharpness.resize(mesh.positions.size(), 0);
  for (const int v : vertices_held_by_seams(mesh)) sharpness[idx(v)] = infinitely_sharp;
  return sharpness;
}

void find_sharp_vertices(const SoundMesh& base, RefinedMesh& mesh) {
  const std::vector<float> sharpness = vertex_sharpness(base);
  mesh.sharp_vertices.resize(sharpness.size());
  mesh.semi_sharp.clear();
  for (std::size_t v = 0; v < sharpness.size(); ++v) {
    mesh.sharp_vertices[v] = is_infinite(sharpness[v]);
    if (is_semi_sharp(sharpness[v])) set_semi_sharp(static_cast<int>(v), mesh);
  }
  if (base.boundary == BoundaryRule::corners) sharpen_corners_of_boundary(mesh);
  find_semi_sharp_edges(base, mesh);
}

void inherit_sharp_vertices(const RefinedMesh& parent, const TopologyLevel& level,
                            const TopologyLevel& next, int threads, RefinedMesh& child) {
  child.sharp_vertices.resize(idx(next.GetNumVertices()));
  parallel_for(child.sharp_vertices.size(), threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) {
      child.sharp_vertices[v] = next.IsVertexInfSharp(static_cast<int>(v));
    }
  });
  if (parent.semi_sharp.empty()) return;
  for (int v = 0; v < next.GetNumVertices(); ++v) {
    if (next.IsVertexSemiSharp(v)) set_semi_sharp(v, child);
  }
  inherit_semi_sharp_edges(level, next, child);
}

}  // namespace illustrate
