#include "control/limit_masks.h"

#include <cmath>

#include "core/pi.h"
#include "mesh/polygons.h"

namespace illustrate {
namespace {

using Rule = LimitPlaces::Rule;

// Sums over what is round each vertex.
struct Sums {
  Vec3 edges = Vec3::Zero(), faces = Vec3::Zero(), normal = Vec3::Zero();
  Vec3 first_sharp = Vec3::Zero(), sharp = Vec3::Zero();  // one end, and the sum of both
  double count = 0;
  int sharp_count = 0;
};

class Masks {
 public:
  Masks(const SoundMesh& mesh, const HalfEdges& edges, const VertexSectors& sectors,
        const Points& points, Scheme scheme)
      : mesh_(mesh),
        edges_(edges),
        faces_(edges.faces),
        sectors_(sectors),
        points_(points),
        quads_(scheme == Scheme::catmull_clark) {}

  LimitPlaces run() {
    add_up();
    LimitPlaces places;
    for (std::size_t v = 0; v < points_.size(); ++v) {
      const Rule rule = rule_at(v);
      places.rules.push_back(rule);
      places.positions.push_back(rule == Rule::smooth   ? smooth_limit(v)
                                 : rule == Rule::crease ? crease_limit(v)
                                                        : points_[v]);
      const Sums& sums = sums_[v];
      places.directions.push_back(unit_or_zero(
          rule == Rule::crease ? Vec3(2 * sums.first_sharp - sums.sharp) : sums.normal));
    }
    return places;
  }

 private:
  const Vec3& at(int vertex) const { return points_[idx(vertex)]; }

  void add_up() {
    sums_.resize(points_.size());
    for (const int h : edges_.first) {
      const int a = faces_.corners[idx(h)], b = faces_.head(h);
      for (const auto& [here, other] : {Edge{a, b}, Edge{b, a}}) {
        Sums& sums = sums_[idx(here)];
        sums.edges += at(other);
        ++sums.count;
        if (!edges_.is_sharp(h)) continue;
        if (sums.sharp_count++ == 0) sums.first_sharp = at(other);
        sums.sharp += at(other);
      }
    }
    for (int c = 0; c < faces_.corner_count(); ++c) {
      const int v = faces_.corners[idx(c)];
      const int next = faces_.next(c), previous = faces_.previous(c);
      const Vec3 a = at(faces_.corners[idx(next)]) - at(v);
      const Vec3 b = at(faces_.corners[idx(previous)]) - at(v);
      sums_[idx(v)].normal += a.cross(b);
      if (quads_) sums_[idx(v)].faces += at(faces_.corners[idx(faces_.next(next))]);
    }
  }

  Rule rule_at(std::size_t v) const {
    const int sharp = sectors_.sharp_edges[v];
    if (mesh_.vertex_sharpness[v] >= infinitely_sharp || sharp > 2) return Rule::corner;
    return sharp == 2 ? Rule::crease : Rule::smooth;
  }

  // A crease is a cubic B-spline in both schemes.
  Vec3 crease_limit(std::size_t v) const { return (4 * points_[v] + sums_[v].sharp) / 6; }

  Vec3 smooth_limit(std::size_t v) const {
    const Sums& sums = sums_[v];
    const double k = sums.count;
    // Quads: Halstead, Kass, DeRose 1993; triangles: Loop 1987.
    if (k == 0) return points_[v];
    if (quads_) return (k * k * points_[v] + 4 * sums.edges + sums.faces) / (k * (k + 5));
    const double c = 3. / 8 + std::cos(2 * pi / k) / 4, w = 3 * k / (8 * (5. / 8 - c * c));
    return (w * points_[v] + sums.edges) / (w + k);
  }

  const SoundMesh& mesh_;
  const HalfEdges& edges_;
  const Faces& faces_;
  const VertexSectors& sectors_;
  const Points& points_;
  const bool quads_;
  std::vector<Sums> sums_;
};

}  // namespace

LimitPlaces limit_places(const SoundMesh& mesh, const HalfEdges& edges,
                         const VertexSectors& sectors, const Points& points, Scheme scheme) {
  return Masks(mesh, edges, sectors, points, scheme).run();
}

}  // namespace illustrate
