#include "control/turned_faces.h"

#include <algorithm>

#include "control/pieces.h"
#include "control/smoothstep.h"
#include "control/split_values.h"
#include "core/angles.h"

namespace illustrate {
namespace {

constexpr double level_deg = 5, bent_deg = 15;
constexpr double least_kept = 0.1;  // of its area that a piece of a face keeps
constexpr int faces_around = 3, most_rounds = 8;

// Raises values to `others`, and tells whether any is raised.
bool raise(std::vector<double>& values, const std::vector<double>& others) {
  bool is_raised = false;
  for (std::size_t i = 0; i < values.size(); ++i) {
    is_raised |= others[i] > values[i];
    values[i] = std::max(values[i], others[i]);
  }
  return is_raised;
}

class Turner {
 public:
  Turner(const SoundMesh& mesh, const HalfEdges& edges, const LimitPlaces& limits)
      : edges_(edges),
        faces_(edges.faces),
        limits_(limits),
        places_(mesh.positions),
        normals_(unit_normals(faces_, mesh.positions)),
        vertices_(static_cast<int>(mesh.positions.size())),
        has_centres_(limits.positions.size() > mesh.positions.size() + edges.first.size()) {
    append_means(edges, limits.positions.size(), places_);
  }

  // (n) by the faces that turn over where the surface leaves the limit by these weights.
  std::vector<double> weights_of_turned(const std::vector<double>& weights) {
    mix(weights);
    std::vector<double> of_faces(idx(faces_.size()), 0);
    for (int f = 0; f < faces_.size(); ++f) {
      const double share = turned(f);
      if (share > 0) of_faces[idx(f)] = share * levelness(f);
    }
    std::vector<double> result(weights.size(), 0);
    if (*std::max_element(of_faces.begin(), of_faces.end()) == 0) return result;
    const VertexSectors sectors = find_sectors(edges_, idx(vertices_));
    for (int ring = 0; ring < faces_around; ++ring) of_faces = wider(of_faces, sectors);
    for (int c = 0; c < faces_.corner_count(); ++c) {
      double& value = result[idx(faces_.corners[idx(c)])];
      value = std::max(value, of_faces[idx(faces_.corner_faces[idx(c)])]);
    }
    return result;
  }

 private:
  // 0 .. 1 by its smooth neighbour that it turns farthest from; what has no area is none.
  double levelness(int f) const {
    double turn = 0;
    for (int h = faces_.offsets[idx(f)]; h < faces_.offsets[idx(f) + 1]; ++h) {
      if (edges_.is_sharp(h)) continue;
      const Vec3& other = normals_[idx(faces_.corner_faces[idx(edges_.mates[idx(h)])])];
      if (!other.isZero()) turn = std::max(turn, degrees_between(normals_[idx(f)], other));
    }
    return 1 - smoothstep(level_deg, bent_deg, turn);
  }

  // The points of the surface by these weights, level places for arcs.
  void mix(std::vector<double> weights) {
    append_means(edges_, places_.size(), weights);
    mixed_ = limits_.positions;
    for (std::size_t v = 0; v < mixed_.size(); ++v)
      mixed_[v] += weights[v] * (places_[v] - mixed_[v]);
  }

  // The largest of the faces at each corner, between creases.
  std::vector<double> wider(const std::vector<double>& of_faces,
                            const VertexSectors& sectors) const {
    std::vector<double> result = of_faces;
    const auto face = [&](int corner) { return idx(faces_.corner_faces[idx(corner)]); };
    for (std::size_t s = 0; s < sectors.corners.size(); ++s) {
      double most = 0;
      for (const int c : sectors.corners[s]) most = std::max(most, of_faces[face(c)]);
      for (const int c : sectors.corners[s]) result[face(c)] = std::max(result[face(c)], most);
    }
    return result;
  }

  // 0 .. 1 by the piece of a face that keeps least.
  double turned(int f) const {
    double least = 1;
    for_each_piece(edges_, vertices_, has_centres_, f, [&](int a, int b, int c) {
      least = std::min(least, share_kept(places_, mixed_, normals_[idx(f)], a, b, c));
    });
    return 1 - smoothstep(0, least_kept, least);
  }

  const HalfEdges& edges_;
  const Faces& faces_;
  const LimitPlaces& limits_;
  Points places_;  // of the split mesh, were all edges straight
  const Points normals_;
  int vertices_;
  bool has_centres_;
  Points mixed_;
};

}  // namespace

std::vector<double> weights_of_turned_faces(const SoundMesh& mesh, const HalfEdges& edges,
                                            const LimitPlaces& limits,
                                            std::vector<double> weights) {
  if (edges.faces.size() == 0) return weights;
  Turner turner(mesh, edges, limits);
  for (int round = 0; round < most_rounds && raise(weights, turner.weights_of_turned(weights));
       ++round) {
  }
  return weights;
}

}  // namespace illustrate
