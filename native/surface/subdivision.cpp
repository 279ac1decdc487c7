#include "surface/subdivision.h"

#include <opensubdiv/bfr/refinerSurfaceFactory.h>
#include <opensubdiv/bfr/surface.h>
#include <opensubdiv/far/primvarRefiner.h>

#include <algorithm>

#include "surface/level_topology.h"
#include "surface/topology.h"

namespace illustrate {
namespace {

namespace Bfr = OpenSubdiv::Bfr;
namespace Far = OpenSubdiv::Far;

// How deep the patches go on after the last sharpness has faded: OpenSubdiv's largest level.
constexpr int patch_level_smooth = 6, patch_level_sharp = 10;

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

// The patches of one base face after another.
class PatchEvaluator {
 public:
  PatchEvaluator(const Far::TopologyRefiner& refiner, const Points& points)
      : factory_(refiner, options()), points_(points) {}

  std::optional<LimitPoint> evaluate(int face, int sub_face, const Vec2& uv) {
    if (face != face_) load(face);
    if (!surface_.IsValid()) return std::nullopt;
    std::array<double, 2> at{uv.x(), uv.y()};
    if (surface_.GetParameterization().HasSubFaces()) {
      surface_.GetParameterization().ConvertNormalizedSubFaceToCoord(sub_face, uv.data(),
                                                                     at.data());
    }
    LimitPoint p;
    surface_.Evaluate(at.data(), patch_points_.data(), 3, p.position.data(), p.du.data(),
                      p.dv.data(), p.duu.data(), p.duv.data(), p.dvv.data());
    return p;
  }

 private:
  static Bfr::SurfaceFactory::Options options() {
    Bfr::SurfaceFactory::Options options;
    options.SetApproxLevelSmooth(patch_level_smooth).SetApproxLevelSharp(patch_level_sharp);
    return options;
  }

  void load(int face) {
    face_ = face;
    if (!factory_.InitVertexSurface(face, &surface_)) return;
    patch_points_.resize(3 * static_cast<std::size_t>(surface_.GetNumPatchPoints()));
    surface_.PreparePatchPoints(points_[0].data(), 3, patch_points_.data(), 3);
  }

  Bfr::RefinerSurfaceFactory<> factory_;
  const Points& points_;
  Bfr::Surface<double> surface_;
  std::vector<double> patch_points_;
  int face_ = none;
};

}  // namespace

struct Subdivision::Data {
  const SoundMesh& mesh;
  Scheme scheme;
  std::unique_ptr<Far::TopologyRefiner> refiner;
  std::vector<Points> points;   // of each level
  std::vector<int> ptex_faces;  // first of each base face
  std::optional<PatchEvaluator> patches;
};

Subdivision::Subdivision(const SoundMesh& mesh, Scheme scheme, int levels, const Progress& progress)
    : data_(new Data{mesh, scheme, make_refiner(mesh, scheme), {}, {}, {}}) {
  if (!is_valid()) return;
  progress.report(0);
  Far::TopologyRefiner::UniformOptions options(levels);
  options.fullTopologyInLastLevel = true;
  data_->refiner->RefineUniform(options);
  data_->points = points_of_levels(*data_->refiner, mesh.positions, progress);
  data_->ptex_faces = illustrate::ptex_faces(mesh, scheme);
  data_->patches.emplace(*data_->refiner, data_->points[0]);
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

const std::vector<int>& Subdivision::ptex_faces() const { return data_->ptex_faces; }

std::optional<LimitPoint> Subdivision::evaluate(const BasePlace& place) const {
  const std::vector<int>& first = data_->ptex_faces;
  const auto after = std::upper_bound(first.begin(), first.end(), place.ptex_face);
  const auto face = static_cast<int>(after - first.begin()) - 1;
  return data_->patches->evaluate(face, place.ptex_face - first[static_cast<std::size_t>(face)],
                                  place.uv);
}

}  // namespace illustrate
