#include "surface/subdivision/topology.h"

#include <opensubdiv/far/topologyDescriptor.h>
#include <opensubdiv/far/topologyRefinerFactory.h>

#include <algorithm>

#include "surface/subdivision/sharpness.h"

namespace illustrate {
namespace {

namespace Far = OpenSubdiv::Far;
namespace Sdc = OpenSubdiv::Sdc;

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
  const std::vector<float> corners = vertex_sharpness(mesh);
  for (std::size_t v = 0; v < corners.size(); ++v) {
    if (!(corners[v] > 0)) continue;
    sharp.corner_vertices.push_back(static_cast<int>(v));
    sharp.corners.push_back(corners[v]);
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

}  // namespace

bool can_be_refined(const SoundMesh& mesh) {
  constexpr int most = 65535;
  std::vector<int> faces(mesh.positions.size(), 0);
  for (const int v : mesh.corner_vertices) ++faces[idx(v)];
  const auto small = [](int count) { return count < most; };
  return std::all_of(faces.begin(), faces.end(), small) &&
         std::all_of(mesh.face_sizes.begin(), mesh.face_sizes.end(), small);
}

std::unique_ptr<Far::TopologyRefiner> make_refiner(const SoundMesh& mesh, Scheme scheme) {
  if (!can_be_refined(mesh)) return nullptr;
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
