#include "surface/limit/limit_patches.h"

#include <opensubdiv/bfr/patchTree.h>
#include <opensubdiv/bfr/refinerSurfaceFactory.h>
#include <opensubdiv/bfr/surface.h>

#include <algorithm>
#include <atomic>
#include <mutex>

#include "surface/limit/leaf_polynomials.h"
#include "surface/limit/polynomial_patch.h"
#include "surface/subdivision/level_topology.h"
#include "surface/subdivision/topology.h"

namespace illustrate {
namespace {

namespace Bfr = OpenSubdiv::Bfr;
namespace Far = OpenSubdiv::Far;

// How deep the patches go on after the last sharpness has faded: OpenSubdiv's largest level.
constexpr int patch_level_smooth = 7, patch_level_sharp = 10;

constexpr int most_edges = 100;

// What is kept for good of one mesh; beyond, only what was asked for last. A face takes .8 kB: all
// of a scan of 100,000 irregular ones take half of it.
constexpr std::size_t most_kept_bytes = std::size_t{160} << 20;
constexpr std::size_t recent_faces = 4096;  // more than a long contour passes, 3 MB of them
// Of trees that wait for other faces of the same kind. Where every edge is semi-sharp in its own
// way each face has one of its own, of about a megabyte.
constexpr std::size_t most_tree_bytes = std::size_t{128} << 20;

std::size_t bytes_of(const Bfr::internal::IrregularPatchType& tree) {
  constexpr std::size_t points_of_patch = 16;
  const auto points = idx(tree.GetNumSubPatchPoints());
  return sizeof(double) * points * idx(tree.GetNumControlPoints()) +
         sizeof(int) * points_of_patch * idx(tree.GetNumPatches());
}

// The trees of patches of irregular faces, one for all faces of the same kind, counted.
class PatchTrees : public Bfr::SurfaceFactoryCache {
 public:
  std::size_t bytes() const { return bytes_; }

  // The tree handed out since the last call, if one was.
  LeafPolynomials::Tree take_last() { return std::move(last_); }

 protected:
  DataType Find(const KeyType& key) const override { return last_ = find(key); }

  DataType Add(const KeyType& key, const DataType& tree) override {
    bytes_ += bytes_of(*tree);
    return last_ = add(key, tree);
  }

 private:
  std::size_t bytes_ = 0;
  mutable LeafPolynomials::Tree last_;
};

// What OpenSubdiv makes for one face: its surface, and where that is irregular the tree that is
// shared with faces of its kind, and the bytes of what was made for it first.
struct FaceSurface {
  Bfr::Surface<double> surface;
  LeafPolynomials::Tree tree;
  std::size_t shared_bytes = 0;
};

// Makes the surfaces of faces; what they share is forgotten when it is too much.
class SurfaceMaker {
 public:
  explicit SurfaceMaker(const Far::TopologyRefiner& refiner) : refiner_(refiner) { start(); }

  FaceSurface make(int face) {
    if (trees_->bytes() > most_tree_bytes) start();
    const std::size_t before = trees_->bytes();
    FaceSurface made;
    trees_->take_last();
    factory_->InitVertexSurface(face, &made.surface);
    made.tree = trees_->take_last();
    made.shared_bytes = trees_->bytes() - before;
    return made;
  }

 private:
  void start() {
    factory_.reset();
    trees_.emplace();
    Bfr::SurfaceFactory::Options options;
    options.SetApproxLevelSmooth(patch_level_smooth).SetApproxLevelSharp(patch_level_sharp);
    factory_.emplace(refiner_, options.SetExternalCache(&*trees_));
  }

  const Far::TopologyRefiner& refiner_;
  std::optional<PatchTrees> trees_;
  std::optional<Bfr::RefinerSurfaceFactory<>> factory_;
};

// Beyond a border OpenSubdiv repeats a control point where there is none.
bool all_differ(std::vector<int> controls) {
  std::sort(controls.begin(), controls.end());
  return std::adjacent_find(controls.begin(), controls.end()) == controls.end();
}

template <std::size_t count>
std::array<Vec3, count> first_of(const Points& points) {
  std::array<Vec3, count> result;
  std::copy_n(points.begin(), count, result.begin());
  return result;
}

// A regular face as one polynomial.
PolynomialPatch polynomial_of(const Bfr::Surface<double>& surface, const std::vector<int>& indices,
                              const Points& controls) {
  const bool is_quad = surface.GetFaceSize() == 4;
  if (all_differ(indices)) {
    return is_quad ? PolynomialPatch::b_spline(first_of<16>(controls))
                   : PolynomialPatch::box_spline(first_of<12>(controls));
  }
  const double* points = controls.front().data();
  const auto at = [&](const Vec2& uv) {
    LimitPoint p;
    surface.Evaluate(uv.data(), points, 3, p.position.data(), p.du.data(), p.dv.data(),
                     p.duu.data(), p.duv.data(), p.dvv.data());
    return p;
  };
  if (!is_quad) return PolynomialPatch::quartic([&](const Vec2& uv) { return at(uv).position; });
  return PolynomialPatch::bicubic({at({0, 0}), at({1, 0}), at({0, 1}), at({1, 1})});
}

// The surface of one base face.
class FacePatches {
 public:
  // Points are taken from the first of them, so that nothing is lost far from the world's origin.
  FacePatches(FaceSurface made, LeafRoom& room, const Points& points)
      : shared_bytes_(made.shared_bytes) {
    const Bfr::Surface<double>& surface = made.surface;
    if (!surface.IsValid()) return;
    std::vector<int> indices(idx(surface.GetNumControlPoints()));
    surface.GetControlPointIndices(indices.data());
    origin_ = points[idx(indices[0])];
    Points controls;
    controls.reserve(indices.size());
    for (const int i : indices) controls.push_back(points[idx(i)] - origin_);
    if (surface.IsRegular()) {
      polynomial_ =
          std::make_unique<const PolynomialPatch>(polynomial_of(surface, indices, controls));
    } else {
      leaves_ =
          std::make_unique<const LeafPolynomials>(std::move(made.tree), std::move(controls), room);
    }
  }

  bool is_valid() const { return polynomial_ || leaves_; }

  std::size_t bytes() const {
    return sizeof(*this) + shared_bytes_ + (polynomial_ ? sizeof(*polynomial_) : 0) +
           (leaves_ ? leaves_->bytes() : 0);
  }

  LimitPoint evaluate(int sub_face, const Vec2& uv) const {
    LimitPoint p = polynomial_ ? polynomial_->evaluate(uv) : leaves_->evaluate(sub_face, uv);
    p.position += origin_;
    return p;
  }

 private:
  Vec3 origin_ = Vec3::Zero();
  std::size_t shared_bytes_;
  std::unique_ptr<const PolynomialPatch> polynomial_;
  std::unique_ptr<const LeafPolynomials> leaves_;
};

Vec2 clamped(const Vec2& uv, bool triangular) {
  Vec2 at = uv.cwiseMax(0).cwiseMin(1);
  const double over = at.sum() - 1;
  if (triangular && over > 0) at = (at.array() - over / 2).matrix().cwiseMax(0).cwiseMin(1);
  return at;
}

// Taylor's polynomial of the second degree.
LimitPoint continued(const LimitPoint& p, const Vec2& step) {
  const double u = step.x(), v = step.y();
  LimitPoint q = p;
  q.position += u * p.du + v * p.dv + u * u / 2 * p.duu + u * v * p.duv + v * v / 2 * p.dvv;
  q.du += u * p.duu + v * p.duv;
  q.dv += u * p.duv + v * p.dvv;
  return q;
}

}  // namespace

struct LimitPatches::Data {
  Scheme scheme;
  Points points;
  std::unique_ptr<Far::TopologyRefiner> refiner;
  LeafRoom room;                // outlives the faces that take of it
  std::vector<int> ptex_faces;  // first of each base face
  std::vector<int> base_faces;  // of each ptex face
  std::optional<SurfaceMaker> maker;
  std::mutex making;
  std::vector<std::shared_ptr<const FacePatches>> kept;
  std::size_t kept_bytes = 0;
  std::vector<std::atomic<const FacePatches*>> faces;                      // those that are kept
  std::vector<std::pair<int, std::shared_ptr<const FacePatches>>> recent;  // once no more are kept

  Data(const SoundMesh& mesh, Scheme s, std::size_t leaf_bytes)
      : scheme(s),
        points(mesh.positions),
        refiner(make_refiner(mesh, s)),
        room(leaf_bytes),
        ptex_faces(illustrate::ptex_faces(mesh, s)),
        faces(mesh.face_sizes.size()) {
    if (!refiner) return;
    maker.emplace(*refiner);
    for (std::size_t f = 0; f + 1 < ptex_faces.size(); ++f) {
      base_faces.resize(idx(ptex_faces[f + 1]), static_cast<int>(f));
    }
  }

  std::optional<LimitPoint> evaluate(int f, const BasePlace& place) {
    std::atomic<const FacePatches*>& slot = faces[idx(f)];
    if (const FacePatches* found = slot.load(std::memory_order_acquire)) {
      return evaluate(*found, f, place);
    }
    const std::shared_ptr<const FacePatches> patches = find_or_make(f);
    return evaluate(*patches, f, place);
  }

  std::shared_ptr<const FacePatches> find_or_make(int f) {
    if (std::shared_ptr<const FacePatches> found = find_recent(f)) return found;
    std::shared_ptr<const FacePatches> patches = make(f);
    remember(f, patches);
    return patches;
  }

  std::shared_ptr<const FacePatches> find_recent(int f) {
    const std::lock_guard<std::mutex> lock(making);
    if (recent.empty()) return nullptr;
    const auto& [face, patches] = recent[idx(f) % recent_faces];
    return face == f ? patches : nullptr;
  }

  // Two threads may have made the same.
  void remember(int f, const std::shared_ptr<const FacePatches>& patches) {
    const std::lock_guard<std::mutex> lock(making);
    std::atomic<const FacePatches*>& slot = faces[idx(f)];
    if (slot.load(std::memory_order_relaxed)) return;
    if (kept_bytes < most_kept_bytes) {
      kept_bytes += patches->bytes();
      kept.push_back(patches);
      slot.store(patches.get(), std::memory_order_release);
    } else {
      if (recent.empty()) recent.resize(recent_faces, {none, nullptr});
      recent[idx(f) % recent_faces] = {f, patches};
    }
  }

  // What faces share is made by one thread at a time, the points of their own patches by all.
  std::shared_ptr<const FacePatches> make(int f) {
    return std::make_shared<const FacePatches>(surface_of(f), room, points);
  }

  FaceSurface surface_of(int f) {
    const std::lock_guard<std::mutex> lock(making);
    return is_small_enough(f) ? maker->make(f) : FaceSurface{};
  }

  // What the patches of a face need grows with the square of the edges round its corners.
  bool is_small_enough(int f) const {
    const Far::TopologyLevel& level = refiner->GetLevel(0);
    const auto vertices = level.GetFaceVertices(f);
    return vertices.size() <= most_edges &&
           std::all_of(vertices.begin(), vertices.end(),
                       [&](int v) { return level.GetVertexEdges(v).size() <= most_edges; });
  }

  // The base face of a ptex face, none where there is no such.
  int base_face(int ptex_face) const {
    const bool exists = ptex_face >= 0 && idx(ptex_face) < base_faces.size();
    return exists ? base_faces[idx(ptex_face)] : none;
  }

  std::optional<LimitPoint> evaluate(const FacePatches& patches, int f,
                                     const BasePlace& place) const {
    if (!patches.is_valid()) return {};
    const Vec2 inside = clamped(place.uv, scheme == Scheme::loop);
    const LimitPoint p = patches.evaluate(place.ptex_face - ptex_faces[idx(f)], inside);
    return inside == place.uv ? p : continued(p, place.uv - inside);
  }
};

LimitPatches::LimitPatches(const SoundMesh& mesh, Scheme scheme, std::size_t leaf_bytes)
    : data_(std::make_unique<Data>(mesh, scheme, leaf_bytes)) {}

LimitPatches::~LimitPatches() = default;

std::optional<LimitPoint> LimitPatches::evaluate(const BasePlace& place) const {
  const int face = data_->base_face(place.ptex_face);
  return face == none ? std::nullopt : data_->evaluate(face, place);
}

std::optional<LimitPoint> LimitPatches::Pass::evaluate(const BasePlace& place) {
  Data& data = *patches_.data_;
  const int face = data.base_face(place.ptex_face);
  if (face == none) return {};
  if (face != face_) {
    made_ = data.make(face);
    face_ = face;
  }
  return data.evaluate(*static_cast<const FacePatches*>(made_.get()), face, place);
}

}  // namespace illustrate
