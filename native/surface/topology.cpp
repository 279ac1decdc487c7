#include "surface/topology.h"

#include <opensubdiv/far/topologyDescriptor.h>
#include <opensubdiv/far/topologyRefinerFactory.h>

#include <algorithm>

namespace illustrate {
namespace {

namespace Far = OpenSubdiv::Far;
namespace Sdc = OpenSubdiv::Sdc;

// One end of a seam: the split vertex, which of its copies, and where the seam goes.
struct SeamEnd {
  int source, copy, other_source;
  bool operator<(const SeamEnd& e) const {
    return std::tie(source, copy, other_source) < std::tie(e.source, e.copy, e.other_source);
  }
};

std::vector<SeamEnd> seam_ends(const SoundMesh& mesh) {
  std::vector<SeamEnd> ends;
  const auto source = [&](int v) { return mesh.source_vertices[static_cast<std::size_t>(v)]; };
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

struct Sharpness {
  std::vector<int> crease_vertices, corner_vertices;
  std::vector<float> creases, corners;
};

Sharpness sharpness_of(const SoundMesh& mesh) {
  Sharpness sharp;
  for (std::size_t i = 0; i < mesh.edge_vertices.size(); ++i) {
    sharp.crease_vertices.insert(sharp.crease_vertices.end(), mesh.edge_vertices[i].begin(),
                                 mesh.edge_vertices[i].end());
    sharp.creases.push_back(static_cast<float>(mesh.edge_sharpness[i]));
  }
  for (std::size_t v = 0; v < mesh.vertex_sharpness.size(); ++v) {
    if (!(mesh.vertex_sharpness[v] > 0)) continue;
    sharp.corner_vertices.push_back(static_cast<int>(v));
    sharp.corners.push_back(static_cast<float>(mesh.vertex_sharpness[v]));
  }
  for (const int v : vertices_held_by_seams(mesh)) {
    sharp.corner_vertices.push_back(v);
    sharp.corners.push_back(static_cast<float>(infinitely_sharp));
  }
  return sharp;
}

Far::TopologyDescriptor describe(const SoundMesh& mesh, const Sharpness& sharp) {
  Far::TopologyDescriptor descriptor;
  descriptor.numVertices = static_cast<int>(mesh.positions.size());
  descriptor.numFaces = static_cast<int>(mesh.face_sizes.size());
  descriptor.numVertsPerFace = mesh.face_sizes.data();
  descriptor.vertIndicesPerFace = mesh.corner_vertices.data();
  descriptor.numCreases = static_cast<int>(sharp.creases.size());
  descriptor.creaseVertexIndexPairs = sharp.crease_vertices.data();
  descriptor.creaseWeights = sharp.creases.data();
  descriptor.numCorners = static_cast<int>(sharp.corners.size());
  descriptor.cornerVertexIndices = sharp.corner_vertices.data();
  descriptor.cornerWeights = sharp.corners.data();
  return descriptor;
}

// OpenSubdiv numbers the edges round a vertex and a face in 16 bits, and does not look whether they
// fit.
bool fits(const SoundMesh& mesh) {
  constexpr int most = 65535;
  std::vector<int> faces(mesh.positions.size(), 0);
  for (const int v : mesh.corner_vertices) ++faces[static_cast<std::size_t>(v)];
  const auto small = [](int count) { return count < most; };
  return std::all_of(faces.begin(), faces.end(), small) &&
         std::all_of(mesh.face_sizes.begin(), mesh.face_sizes.end(), small);
}

}  // namespace

std::unique_ptr<Far::TopologyRefiner> make_refiner(const SoundMesh& mesh, Scheme scheme) {
  if (!fits(mesh)) return nullptr;
  Sdc::Options options;
  options.SetVtxBoundaryInterpolation(mesh.boundary == BoundaryRule::corners
                                          ? Sdc::Options::VTX_BOUNDARY_EDGE_AND_CORNER
                                          : Sdc::Options::VTX_BOUNDARY_EDGE_ONLY);
  const Sdc::SchemeType type = scheme == Scheme::loop ? Sdc::SCHEME_LOOP : Sdc::SCHEME_CATMARK;
  const Sharpness sharp = sharpness_of(mesh);
  using Factory = Far::TopologyRefinerFactory<Far::TopologyDescriptor>;
  return std::unique_ptr<Far::TopologyRefiner>(
      Factory::Create(describe(mesh, sharp), Factory::Options(type, options)));
}

}  // namespace illustrate
