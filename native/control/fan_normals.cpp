#include "control/fan_normals.h"

#include <algorithm>
#include <cmath>

#include "core/pi.h"
#include "mesh/polygons.h"
#include "mesh/shading.h"

namespace illustrate {
namespace {

// The face's area vector times the angle of each of its corners.
Points corner_weights(const SoundMesh& mesh, const Faces& faces) {
  Points weights(faces.corners.size());
  Points polygon;
  for (int f = 0; f < faces.size(); ++f) {
    polygon.clear();
    for (const int v : faces[f]) polygon.push_back(mesh.positions[idx(v)]);
    const Vec3 area = newell_normal({polygon.data(), polygon.size()});
    const std::size_t size = polygon.size();
    for (std::size_t k = 0; k < size; ++k) {
      const Vec3 a = polygon[(k + 1) % size] - polygon[k];
      const Vec3 b = polygon[(k + size - 1) % size] - polygon[k];
      weights[idx(faces.offsets[idx(f)]) + k] = std::atan2(a.cross(b).norm(), a.dot(b)) * area;
    }
  }
  return weights;
}

// The mean of the sector's shading normals; zero where one of them is far from it.
Vec3 agreed_normal(const Points& normals, Span<const int> corners) {
  static const double same = std::cos(crease_normals_deg * pi / 180);
  Vec3 sum = Vec3::Zero();
  for (const int c : corners) {
    const Vec3& n = normals[idx(c)];
    sum += n.dot(normals[idx(corners[0])]) < 0 ? Vec3(-n) : n;
  }
  const Vec3 mean = unit_or_zero(sum);
  const bool agree = std::all_of(corners.begin(), corners.end(), [&](int c) {
    return std::abs(normals[idx(c)].dot(mean)) >= same;
  });
  return agree ? mean : Vec3(Vec3::Zero());
}

}  // namespace

FanNormals fan_normals(const SoundMesh& mesh, const HalfEdges& edges,
                       const VertexSectors& sectors) {
  const Points weights = corner_weights(mesh, edges.faces);
  FanNormals normals{Points(weights.size()), Points(weights.size())};
  for (std::size_t s = 0; s < sectors.corners.size(); ++s) {
    const Span<const int> corners = sectors.corners[s];
    Vec3 sum = Vec3::Zero();
    for (const int c : corners) sum += weights[idx(c)];
    const Vec3 geometric = unit_or_zero(sum);
    const Vec3 agreed = mesh.corner_normals.empty() ? Vec3(Vec3::Zero())
                                                    : agreed_normal(mesh.corner_normals, corners);
    for (const int c : corners) {
      normals.geometric[idx(c)] = geometric;
      normals.shading[idx(c)] = agreed.isZero() ? geometric : agreed;
    }
  }
  return normals;
}

}  // namespace illustrate
