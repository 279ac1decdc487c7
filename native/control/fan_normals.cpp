#include "control/fan_normals.h"

#include <algorithm>
#include <cmath>

#include "core/angles.h"
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
      weights[idx(faces.offsets[idx(f)]) + k] = angle_between(a, b) * area;
    }
  }
  return weights;
}

// The mean of the sector's shading normals; zero where one of them is far from it.
Vec3 agreed_normal(const Points& normals, Span<const int> corners) {
  Vec3 sum = Vec3::Zero();
  for (const int c : corners) {
    const Vec3& n = normals[idx(c)];
    sum += n.dot(normals[idx(corners[0])]) < 0 ? Vec3(-n) : n;
  }
  const Vec3 mean = unit_or_zero(sum);
  const bool agree = std::all_of(corners.begin(), corners.end(), [&](int c) {
    return std::abs(normals[idx(c)].dot(mean)) >= crease_normals_cosine;
  });
  return agree ? mean : Vec3(Vec3::Zero());
}

// Flat faces know what is level: where there are some, those alone count. And the larger faces know
// more than narrow strips beside them, which a long edge would follow far.
Vec3 sum_of_faces(const SoundMesh& mesh, const Faces& faces, const Points& weights,
                  Span<const int> corners) {
  constexpr double small = 0.25;  // of the largest
  const auto is_level = [&](int c) {
    return !mesh.face_planes.empty() && mesh.face_planes[idx(faces.corner_faces[idx(c)])] != none;
  };
  const bool has_level = std::any_of(corners.begin(), corners.end(), is_level);
  double largest = 0;
  for (const int c : corners) largest = std::max(largest, weights[idx(c)].norm());
  Vec3 sum = Vec3::Zero();
  for (const int c : corners) {
    const double share = weights[idx(c)].norm() / largest;
    if (share > 0 && (!has_level || is_level(c)))
      sum += std::min(1., share / small) * weights[idx(c)];
  }
  return sum;
}

}  // namespace

FanNormals fan_normals(const SoundMesh& mesh, const HalfEdges& edges,
                       const VertexSectors& sectors) {
  const Points weights = corner_weights(mesh, edges.faces);
  FanNormals normals{Points(weights.size()), Points(weights.size())};
  for (std::size_t s = 0; s < sectors.corners.size(); ++s) {
    const Span<const int> corners = sectors.corners[s];
    const Vec3 geometric = unit_or_zero(sum_of_faces(mesh, edges.faces, weights, corners));
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
