#include "surface/subdivision/subdivision.h"

#include <opensubdiv/far/primvarRefiner.h>

#include <algorithm>

#include "surface/subdivision/level_topology.h"
#include "surface/subdivision/topology.h"

namespace illustrate {
namespace {

namespace Far = OpenSubdiv::Far;

// Points as OpenSubdiv's refiner reads and writes them.
template <class Array>
struct PointBuffer {
  struct Target {
    Vec3& point;
    void Clear() { point.setZero(); }
    void AddWithWeight(const Vec3& source, double weight) { point += weight * source; }
    void AddWithWeight(const Target& source, double weight) { point += weight * source.point; }
  };
  Array& points;
  Target operator[](int i) { return {points[idx(i)]}; }
  const Vec3& operator[](int i) const { return points[idx(i)]; }
};

Points next_points(const Far::TopologyRefiner& refiner, const Points& points, int level) {
  Points next(idx(refiner.GetLevel(level).GetNumVertices()));
  const PointBuffer<const Points> source{points};
  PointBuffer<Points> target{next};
  Far::PrimvarRefinerReal<double>(refiner).Interpolate(level, source, target);
  return next;
}

}  // namespace

struct Subdivision::Data {
  const SoundMesh& mesh;
  Scheme scheme;
  std::unique_ptr<Far::TopologyRefiner> refiner;  // null where there is only level 0
  std::vector<RefinedMesh> levels;

  void add_level(int threads) {
    const RefinedMesh& parent = levels.back();
    const int level = static_cast<int>(levels.size());
    RefinedMesh next =
        next_level(parent, refiner->GetLevel(level - 1), refiner->GetLevel(level), threads);
    next.points = next_points(*refiner, parent.points, level);
    levels.push_back(std::move(next));
  }
};

Subdivision::Subdivision(const SoundMesh& mesh, Scheme scheme, int levels, int threads,
                         const Progress& progress)
    : data_(new Data{mesh, scheme, {}, {}}) {
  if (!can_be_refined(mesh)) return;
  progress.report(0);
  if (levels > 0) {
    data_->refiner = make_refiner(mesh, scheme);
    if (!data_->refiner) return;
    data_->refiner->RefineUniform(Far::TopologyRefiner::UniformOptions(levels));
  }
  data_->levels.push_back(base_level(mesh, scheme, threads));
  for (int l = 1; l <= levels; ++l) {
    progress.report(static_cast<double>(l) / (1 + levels));
    data_->add_level(threads);
  }
}

Subdivision::~Subdivision() = default;

bool Subdivision::is_valid() const { return !data_->levels.empty(); }

const RefinedMesh& Subdivision::level(int level) const { return data_->levels[idx(level)]; }

int Subdivision::descendant(int vertex, int from, int to) const {
  for (int l = from; l < to; ++l) vertex = data_->refiner->GetLevel(l).GetVertexChildVertex(vertex);
  return vertex;
}

const SoundMesh& Subdivision::base() const { return data_->mesh; }

Scheme Subdivision::scheme() const { return data_->scheme; }

int Subdivision::ptex_faces() const {
  return illustrate::ptex_faces(data_->mesh, data_->scheme).back();
}

}  // namespace illustrate
