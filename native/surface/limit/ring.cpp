#include "surface/limit/ring.h"

#include <algorithm>
#include <cmath>

#include "core/angles.h"
#include "mesh/polygons.h"

namespace illustrate {
namespace {

// Sums of f_i, f_i cos(m x_i), f_i sin(m x_i) over x_i = start + 2 pi i / k, m = 1, 2.
struct Waves {
  Vec3 sum = Vec3::Zero(), cos1 = Vec3::Zero(), sin1 = Vec3::Zero(), cos2 = Vec3::Zero(),
       sin2 = Vec3::Zero();

  Waves(const std::vector<Vec3>& values, double start_cos, double start_sin, double step_cos,
        double step_sin) {
    double c = start_cos, s = start_sin;
    for (const Vec3& f : values) {
      sum += f;
      cos1 += c * f;
      sin1 += s * f;
      cos2 += (c * c - s * s) * f;
      sin2 += 2 * s * c * f;
      const double turned = c * step_cos - s * step_sin;
      s = s * step_cos + c * step_sin;
      c = turned;
    }
  }
};

// Catmull-Clark's eigenvalue of the wave that turns by an angle from edge to edge.
double quad_eigenvalue(double cos_angle, double cos_half) {
  return 5. / 16 + (cos_angle + cos_half * std::sqrt(2 * (9 + cos_angle))) / 16;
}

// The ring on the unit circle, faces at the radius of Catmull-Clark's characteristic map.
struct QuadMap {
  double step_cos, step_sin, half_cos, half_sin, face_radius;

  explicit QuadMap(double k)
      : step_cos(k == 4 ? 0 : std::cos(2 * pi / k)),
        step_sin(k == 4 ? 1 : std::sin(2 * pi / k)),
        half_cos(std::cos(pi / k)),
        half_sin(std::sin(pi / k)) {
    face_radius = k < 3 ? 0 : 2 * half_cos / (4 * quad_eigenvalue(step_cos, half_cos) - 1);
  }
};

LimitPoint fit_quads(const Ring& ring) {
  const auto k = static_cast<double>(ring.edges.size());
  static const QuadMap regular(4);
  const QuadMap map = k == 4 ? regular : QuadMap(k);
  const double r = map.face_radius, r2 = r * r;
  const Waves e(ring.edges, 1, 0, map.step_cos, map.step_sin);
  const Waves f(ring.faces, map.half_cos, map.half_sin, map.step_cos, map.step_sin);
  LimitPoint p;
  p.position = (k * k * ring.centre + 4 * e.sum + f.sum) / (k * (k + 5));
  const double first = (4 + r2) * k / 2;
  p.du = (4 * e.cos1 + r * f.cos1) / first;
  p.dv = (4 * e.sin1 + r * f.sin1) / first;
  // Least squares of a0 + a20 r^2 with weights k^2 : 4 : 1.
  const double a = k * (k + 5), b = k * (4 + r2), c = k * (4 + r2 * r2);
  const Vec3 m0 = k * k * ring.centre + 4 * e.sum + f.sum, m2 = 4 * e.sum + r2 * f.sum;
  const Vec3 a20 = (a * m2 - b * m0) / (a * c - b * b);
  // At valence 4 the edges see cos 2x only and the faces sin 2x only.
  const double second_cos = k == 4 ? 4 * k : (4 + r2 * r2) * k / 2;
  const double second_sin = k == 4 ? r2 * r2 * k : second_cos;
  const Vec3 a22 = (4 * e.cos2 + r2 * f.cos2) / second_cos;
  const Vec3 a21 = (4 * e.sin2 + r2 * f.sin2) / second_sin;
  p.duu = 2 * (a20 + a22);
  p.dvv = 2 * (a20 - a22);
  p.duv = 2 * a21;
  return p;
}

// The ring on the unit circle, and the weight of the centre in the limit position, against 1 for
// every neighbour.
struct TriangleMap {
  double step_cos, step_sin, centre_weight;

  explicit TriangleMap(double k) : step_cos(std::cos(2 * pi / k)), step_sin(std::sin(2 * pi / k)) {
    const double c = 3. / 8 + step_cos / 4;
    centre_weight = 3 * k / (8 * (5. / 8 - c * c));
  }
};

LimitPoint fit_triangles(const Ring& ring) {
  const auto k = static_cast<double>(ring.edges.size());
  static const TriangleMap regular(6);
  const TriangleMap map = k == 6 ? regular : TriangleMap(k);
  const Waves e(ring.edges, 1, 0, map.step_cos, map.step_sin);
  LimitPoint p;
  const double w = map.centre_weight;
  p.position = (w * ring.centre + e.sum) / (w + k);
  p.du = 2 / k * e.cos1;
  p.dv = 2 / k * e.sin1;
  const Vec3 a20 = e.sum / k - ring.centre, a21 = 2 / k * e.sin2, a22 = 2 / k * e.cos2;
  p.duu = 2 * (a20 + a22);
  p.dvv = 2 * (a20 - a22);
  p.duv = 2 * a21;
  return p;
}

LimitPoint fit(const Ring& ring) {
  return ring.faces.empty() ? fit_triangles(ring) : fit_quads(ring);
}

// Regular open rings are halves or quarters of a spline's ring: the rest is the reflection that
// makes the second derivative across the border vanish, as in OpenSubdiv's regular boundary
// patches.
Ring completed(const Ring& ring) {
  Ring full = ring;
  full.closed = true;
  full.rule = VertexRule::smooth;
  const Vec3& c = ring.centre;
  const std::vector<Vec3>&e = ring.edges, &f = ring.faces;
  if (f.empty()) {
    full.edges.push_back(c + e[3] - e[2]);
    full.edges.push_back(c + e[0] - e[1]);
  } else if (f.size() == 2) {
    full.edges.push_back(2 * c - e[1]);
    full.faces.push_back(2 * e[2] - f[1]);
    full.faces.push_back(2 * e[0] - f[0]);
  } else {
    full.edges.push_back(2 * c - e[0]);
    full.edges.push_back(2 * c - e[1]);
    full.faces.push_back(2 * e[1] - f[0]);
    full.faces.push_back(4 * c - 2 * e[0] - 2 * e[1] + f[0]);
    full.faces.push_back(2 * e[0] - f[0]);
  }
  return full;
}

// The tangent that leads from the border into a crease sector of n > 1 faces: the left eigenvector
// of their subdivision whose weights at inner edges are sin(i pi / n). OpenSubdiv's own masks
// (Hoppe et al. 1994, Biermann et al. 2000) are this in the regular case; beyond it they belong to
// modified schemes, and their normals change from level to level.
Vec3 inward_tangent(const Ring& ring) {
  const std::size_t n = ring.face_count();
  const double theta = pi / static_cast<double>(n);
  const bool quads = !ring.faces.empty();
  const double eigenvalue =
      quads ? quad_eigenvalue(std::cos(theta), std::cos(theta / 2)) : 3. / 8 + std::cos(theta) / 4;
  const double face_share = quads ? 1 / (16 * eigenvalue - 4) : 0;
  Vec3 sum = Vec3::Zero();
  double edge_weights = 0, face_weights = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const double here = std::sin(static_cast<double>(i) * theta);
    const double next = std::sin(static_cast<double>(i + 1) * theta);
    edge_weights += here;
    face_weights += face_share * (here + next);
    sum += here * ring.edges[i];
    if (quads) sum += face_share * (here + next) * ring.faces[i];
  }
  // What inner edges and faces hand to an end of the border and to the centre.
  const double to_end = quads ? std::sin(theta) * (1 + 4 * face_share) / 16 : std::sin(theta) / 8;
  const double to_centre = 3. / 8 * edge_weights + face_weights / 4;
  const double past_half = eigenvalue - 1. / 2, past_three_quarters = eigenvalue - 3. / 4;
  const double centre =
      (to_end + past_half * to_centre) / (past_half * past_three_quarters - 1. / 8);
  const double end = past_three_quarters * centre - to_centre;
  return sum + centre * ring.centre + end * (ring.edges.front() + ring.edges.back());
}

double reach(const Ring& ring) {
  double reach = 0;
  for (const Vec3& p : ring.edges) reach = std::max(reach, (p - ring.centre).stableNorm());
  for (const Vec3& p : ring.faces) reach = std::max(reach, (p - ring.centre).stableNorm());
  return reach;
}

Vec3 crease_normal(const Ring& ring, double least) {
  const Vec3 along = ring.edges.front() - ring.edges.back();
  const Vec3 inward = ring.face_count() == 1
                          ? Vec3(ring.edges.front() + ring.edges.back() - 2 * ring.centre)
                          : inward_tangent(ring);
  return spanned_normal(along, inward, reach(ring), least);
}

// Exact for one face, and for two triangles, whose plane is that of the sharp edges. A corner of
// more faces has no tangent plane: there the mean of its faces.
Vec3 corner_normal(const Ring& ring, double least) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = 0; i < ring.face_count(); ++i) {
    const Vec3 a = ring.edges[i] - ring.centre;
    const Vec3 b = ring.edges[(i + 1) % ring.edges.size()] - ring.centre;
    sum += angle_between(unit_or_zero(a), unit_or_zero(b)) * spanned_normal(a, b, 0, least);
  }
  const Vec3 mean = unit_of_sum(sum);
  if (!ring.faces.empty() || ring.closed || ring.face_count() != 2) return mean;
  const Vec3 across =
      spanned_normal(ring.edges[0] - ring.centre, ring.edges[2] - ring.centre, 0, least);
  if (across.isZero()) return mean;
  return mean.dot(across) < 0 ? Vec3(-across) : across;
}

VertexRule rule_at(const RefinedMesh& mesh, const Sectors& sectors, int vertex) {
  const int sharp = sectors.sharp_edges[idx(vertex)];
  if (mesh.sharp_vertices[idx(vertex)] || sharp > 2) return VertexRule::corner;
  return sharp == 2 ? VertexRule::crease : VertexRule::smooth;
}

}  // namespace

bool read_ring(const RefinedMesh& mesh, const Sectors& sectors, int sector, Ring& ring) {
  const auto s = idx(sector);
  const int size = mesh.triangles_are_patches ? 3 : 4;
  int c = sectors.first_corners[s];
  ring.centre = mesh.point(c);
  ring.closed = sectors.closed[s];
  ring.rule = rule_at(mesh, sectors, mesh.vertex(c));
  ring.edges.clear();
  ring.faces.clear();
  for (int i = 0; i < sectors.sizes[s]; ++i) {
    if (mesh.face_size(mesh.face(c)) != size) return false;
    ring.edges.push_back(mesh.point(mesh.next(c)));
    if (size == 4) ring.faces.push_back(mesh.point(mesh.next(mesh.next(c))));
    if (i + 1 < sectors.sizes[s]) c = next_round_vertex(mesh, c);
  }
  if (!ring.closed) ring.edges.push_back(mesh.point(mesh.previous(c)));
  return true;
}

Vec3 limit_position(const Ring& ring) {
  if (ring.rule == VertexRule::corner) return ring.centre;
  if (ring.rule == VertexRule::crease) {
    return (4 * ring.centre + (ring.edges.front() + ring.edges.back())) / 6;
  }
  return fit(ring).position;
}

Vec3 limit_normal(const Ring& ring, double least) {
  if (ring.rule == VertexRule::corner) return corner_normal(ring, least);
  if (ring.rule == VertexRule::crease) return crease_normal(ring, least);
  const LimitPoint p = fit(ring);
  return spanned_normal(p.du, p.dv, reach(ring), least);
}

bool is_regular(const Ring& ring) {
  const bool triangles = ring.faces.empty();
  if (ring.rule == VertexRule::smooth) return ring.edges.size() == (triangles ? 6 : 4);
  if (ring.closed) return false;
  if (ring.rule == VertexRule::crease) return ring.face_count() == (triangles ? 3 : 2);
  return !triangles && ring.face_count() == 1;
}

bool fit_derivatives(const Ring& ring, LimitPoint& point) {
  if (ring.rule != VertexRule::smooth && !is_regular(ring)) return false;
  point = ring.rule == VertexRule::smooth ? fit(ring) : fit(completed(ring));
  return true;
}

}  // namespace illustrate
