#include "surface/subdivision.h"

#include <opensubdiv/far/primvarRefiner.h>

#include <algorithm>

#include "surface/level_topology.h"
#include "surface/topology.h"

namespace illustrate {
namespace {

namespace Far = OpenSubdiv::Far;

// Points as OpenSubdiv's refiner reads and writes them.
struct PointBuffer {
  struct Target {
    Vec3& point;
    void Clear() { point.setZero(); }
    void AddWithWeight(const Vec3& source, double weight) { point += weight * source; }
    void AddWithWeight(const Target& source, double weight) { point += weight * source.point; }
  };
  Points& points;
  Target operator[](int i) { return {points[static_cast<std::size_t>(i)]}; }
  const Vec3& operator[](int i) const { return points[static_cast<std::size_t>(i)]; }
};

std::vector<Points> points_of_levels(const Far::TopologyRefiner& refiner, const Points& base,
                                     const Progress& progress) {
  std::vector<Points> levels{base};
  const Far::PrimvarRefinerReal<double> refine(refiner);
  for (int l = 1; l <= refiner.GetMaxLevel(); ++l) {
    progress.report(static_cast<double>(l) / (1 + refiner.GetMaxLevel()));
    levels.emplace_back(static_cast<std::size_t>(refiner.GetLevel(l).GetNumVertices()));
    const PointBuffer source{levels[static_cast<std::size_t>(l) - 1]};
    PointBuffer target{levels.back()};
    refine.Interpolate(l, source, target);
  }
  return levels;
}

}  // namespace

struct Subdivision::Data {
  const SoundMesh& mesh;
  Scheme scheme;
  std::unique_ptr<Far::TopologyRefiner> refiner;
  std::vector<Points> points;  // of each level
};

Subdivision::Subdivision(const SoundMesh& mesh, Scheme scheme, int levels, const Progress& progress)
    : data_(new Data{mesh, scheme, make_refiner(mesh, scheme), {}}) {
  if (!is_valid()) return;
  progress.report(0);
  Far::TopologyRefiner::UniformOptions options(levels);
  options.fullTopologyInLastLevel = true;
  data_->refiner->RefineUniform(options);
  data_->points = points_of_levels(*data_->refiner, mesh.positions, progress);
}

Subdivision::~Subdivision() = default;

bool Subdivision::is_valid() const { return data_->refiner != nullptr; }

RefinedMesh Subdivision::level(int level) const {
  RefinedMesh mesh = base_level(data_->mesh, *data_->refiner, data_->scheme);
  for (int l = 1; l <= level; ++l) mesh = next_level(mesh, *data_->refiner, l);
  mesh.points = data_->points[static_cast<std::size_t>(level)];
  read_corners(mesh, data_->refiner->GetLevel(level));
  return mesh;
}

int Subdivision::descendant(int vertex, int from, int to) const {
  for (int l = from; l < to; ++l) vertex = data_->refiner->GetLevel(l).GetVertexChildVertex(vertex);
  return vertex;
}

int Subdivision::child_corner(const RefinedMesh& parent, int corner) const {
  const int face = parent.face(corner), k = corner - parent.first(face);
  const int child = data_->refiner->GetLevel(0).GetFaceChildFaces(face)[k];
  const bool keeps_corners = parent.face_size(face) == 4 || parent.triangles_are_patches;
  const int corners = parent.triangles_are_patches ? 3 : 4;
  return corners * child + (keeps_corners ? k : 0);
}

const SoundMesh& Subdivision::base() const { return data_->mesh; }

Scheme Subdivision::scheme() const { return data_->scheme; }

int Subdivision::ptex_faces() const {
  return illustrate::ptex_faces(data_->mesh, data_->scheme).back();
}

}  // namespace illustrate
