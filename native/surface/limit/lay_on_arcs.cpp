#include "surface/limit/lay_on_arcs.h"

#include <algorithm>
#include <cmath>

#include "mesh/polygons.h"
#include "surface/jets/curvature.h"
#include "surface/shading.h"

namespace illustrate {
namespace {

// Corners of less than 2 degrees, and of more than 178.
constexpr double sine_of_sliver = 0.035;

class Layer {
 public:
  Layer(const SoundMesh& base, const ArcFaces& arcs, const RefinedMesh& mesh,
        const Sectors& sectors, SectorLimits& limits)
      : base_(base),
        arcs_(arcs),
        mesh_(mesh),
        sectors_(sectors),
        limits_(limits),
        size_(idx(base.face_sizes[0])),
        is_laid_(sectors.count(), 0) {}

  // (faces of the base) whether their arcs have weight.
  std::vector<std::uint8_t> changed() const {
    std::vector<std::uint8_t> changed(base_.face_sizes.size(), 0);
    for (std::size_t c = 0; c < base_.corner_vertices.size(); ++c)
      changed[c / size_] |= arcs_.weights[idx(base_.corner_vertices[c])] > 0;
    return changed;
  }

  // All sectors of a place have the position that the first of its corners gives it.
  void move_points(const std::vector<std::uint8_t>& changed) {
    std::vector<int> first(mesh_.points.size(), none);  // sectors of places
    for (int c = 0; c < corner_count(); ++c) {
      const std::size_t s = idx(sector(c));
      if (is_laid_[s] || !changed[idx(mesh_.base_faces[idx(mesh_.face(c))])]) continue;
      const ArcPoint point = on_arcs(c);
      if (point.weight == 0 || !point.position.allFinite()) continue;
      const std::size_t place = idx(place_of(mesh_, mesh_.vertex(c)));
      if (place >= first.size()) first.resize(place + 1, none);
      Vec3& position = limits_.positions[s];
      if (first[place] == none) {
        first[place] = sector(c);
        position += point.weight * (point.position - position);
      }
      position = limits_.positions[idx(first[place])];
      is_laid_[s] = 1;
      limits_.needs_jet[s] = 0;
    }
  }

  // Those of the refined faces, weighted by the angles of their corners; slivers, whose normals are
  // nearly noise, by less.
  void turn_normals() {
    Points sums(sectors_.count(), Vec3::Zero());
    for_each_laid_corner([&](int c, double angle, const Vec3& across) {
      const double share = std::min(1., std::sin(angle) / sine_of_sliver);
      sums[idx(sector(c))] += share * angle * unit_or_zero(across);
    });
    for (std::size_t s = 0; s < sums.size(); ++s) {
      if (is_laid_[s]) limits_.normals[s] = unit_or_zero(sums[s]);
    }
  }

  // The means of the patches' shape operators, weighted alike.
  void bend() {
    std::vector<Eigen::Matrix3d> sums(sectors_.count(), Eigen::Matrix3d::Zero());
    std::vector<double> angles(sectors_.count(), 0);
    for_each_laid_corner([&](int c, double angle, const Vec3&) {
      const ArcPoint p = on_arcs(c);
      const Vec3 normal = unit_or_zero(p.du.cross(p.dv));
      const auto k = principal_curvature(p.du, p.dv, p.duu, p.duv, p.dvv, normal);
      if (normal.isZero() || !std::isfinite(k.k1) || !std::isfinite(k.k2)) return;
      sums[idx(sector(c))] +=
          angle * (k.k1 * k.w1 * k.w1.transpose() + k.k2 * k.w2 * k.w2.transpose());
      angles[idx(sector(c))] += angle;
    });
    for (std::size_t s = 0; s < sums.size(); ++s) {
      if (is_laid_[s] && angles[s] > 0) limits_.curvature[s] = mean(sums[s] / angles[s], s);
    }
  }

 private:
  int corner_count() const { return static_cast<int>(mesh_.corner_count()); }
  int sector(int corner) const { return sectors_.corner_sectors[idx(corner)]; }
  const Vec3& position(int corner) const { return limits_.positions[idx(sector(corner))]; }

  // visit(corner, its angle, the cross product of its edges)
  template <class Visit>
  void for_each_laid_corner(const Visit& visit) const {
    for (int c = 0; c < corner_count(); ++c) {
      if (!is_laid_[idx(sector(c))]) continue;
      const Vec3 a = position(mesh_.next(c)) - position(c);
      const Vec3 b = position(mesh_.previous(c)) - position(c), across = a.cross(b);
      visit(c, std::atan2(across.norm(), a.dot(b)), across);
    }
  }

  PrincipalCurvature mean(const Eigen::Matrix3d& shape, std::size_t s) const {
    const Vec3& normal = limits_.normals[s];
    const Vec3 x = any_tangent(normal), y = normal.cross(x);
    const auto along = [&](const Vec3& a, const Vec3& b) -> Vec3 {
      return a.dot(shape * b) * normal;
    };
    return principal_curvature(x, y, along(x, x), along(x, y), along(y, y), normal);
  }

  ArcPoint on_arcs(int corner) const {
    const int refined = mesh_.face(corner);
    const auto at = place_on_domain(mesh_.domains[idx(refined)], mesh_.face_size(refined),
                                    corner - mesh_.first(refined));
    const std::size_t first = size_ * idx(mesh_.base_faces[idx(refined)]);
    const Span<const int> vertices{base_.corner_vertices.data() + first, size_};
    return evaluate(arcs_, vertices, static_cast<int>(first),
                    Vec2(at[0], at[1]) / FaceDomain::steps);
  }

  const SoundMesh& base_;
  const ArcFaces& arcs_;
  const RefinedMesh& mesh_;
  const Sectors& sectors_;
  SectorLimits& limits_;
  std::size_t size_;  // of all faces of the base
  std::vector<std::uint8_t> is_laid_;
};

}  // namespace

std::vector<std::uint8_t> lay_on_arcs(const SoundMesh& base, const ArcFaces& arcs,
                                      const RefinedMesh& mesh, const Sectors& sectors, int threads,
                                      SectorLimits& limits) {
  if (arcs.weights.empty() || !mesh.twin_faces.empty()) return {};
  Layer layer(base, arcs, mesh, sectors, limits);
  std::vector<std::uint8_t> changed = layer.changed();
  layer.move_points(changed);
  layer.turn_normals();
  mend_normals(mesh, sectors, threads, limits);
  layer.bend();
  return changed;
}

}  // namespace illustrate
