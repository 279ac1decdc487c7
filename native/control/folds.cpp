#include "control/folds.h"

#include <algorithm>
#include <cmath>

#include "control/smoothstep.h"
#include "mesh/edge_table.h"
#include "mesh/polygons.h"

namespace illustrate {
namespace {

// Each fold has a sharpness of its own, so that no two patches beside folds are alike: with more of
// them a view takes minutes.
constexpr std::ptrdiff_t most_folds = 20'000;

constexpr double pi = 3.14159265358979323846;
constexpr double rounding_px = 0.5;
// Sharpness that the last of eight levels still shows.
constexpr double sharpest_fold = 8;

// Edges of hexagons are curves, those of squares are none.
constexpr double curve_deg = 64, fold_deg = 76;
// Shading turns 72 degrees over a face of a pentagonal prism, 90 across a chamfer.
constexpr double bent_face_deg = 72, folded_face_deg = 84;

// What is missed by less is near enough, and what turns by less makes no corner.
constexpr double near_px = 2, missed_px = 5;
constexpr double flat_deg = 20, missed_fold_deg = 40;

double degrees_between(const Vec3& a, const Vec3& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b)) * 180 / pi;
}

class FoldFinder {
 public:
  FoldFinder(const SoundMesh& mesh, const HalfEdges& edges, const std::vector<double>& distances)
      : mesh_(mesh), edges_(edges), faces_(edges.faces), distances_(distances) {}

  std::vector<double> run() {
    Eigen::AlignedBox3d box;
    for (const int v : mesh_.corner_vertices) box.extend(mesh_.positions[idx(v)]);
    px_ = diagonal_px / box.diagonal().norm();
    normals_ = unit_normals(faces_, mesh_.positions);
    std::vector<double> sharpness;
    for (const int h : edges_.first) sharpness.push_back(sharpness_of(h));
    return continued(sharpness);
  }

 private:
  // 0 .. 1: how far the shading of the face turns, from the edge to its other corners, as if there
  // were a fold.
  double folded_share(int h) const {
    if (mesh_.corner_normals.empty()) return 0;
    Vec3 near = Vec3::Zero(), far = Vec3::Zero();
    const int face = faces_.corner_faces[idx(h)];
    for (int c = faces_.offsets[idx(face)]; c < faces_.offsets[idx(face) + 1]; ++c)
      (c == h || c == faces_.next(h) ? near : far) += mesh_.corner_normals[idx(c)];
    return smoothstep(bent_face_deg, folded_face_deg, degrees_between(near, far));
  }

  // The same of an edge that turns by so many degrees and whose ends the smooth surface misses.
  double missed_share(int h, double turn) const {
    if (distances_.empty()) return 0;
    const double missed =
        std::min(distances_[idx(faces_.corners[idx(h)])], distances_[idx(faces_.head(h))]);
    return smoothstep(near_px, missed_px, missed) * smoothstep(flat_deg, missed_fold_deg, turn);
  }

  double sharpness_of(int h) const {
    const int mate = edges_.mates[idx(h)];
    if (mate == none || edges_.is_sharp(h)) return 0;
    const int face = faces_.corner_faces[idx(h)], other = faces_.corner_faces[idx(mate)];
    const double turn = degrees_between(normals_[idx(face)], normals_[idx(other)]);
    const double share = std::max({smoothstep(curve_deg, fold_deg, turn), missed_share(h, turn),
                                   folded_share(h), folded_share(mate)});
    if (share == 0) return 0;
    // A cubic spline's limit is a sixth of its control polygon's second difference inside it.
    const double height = std::min(height_over(h), height_over(mate));
    const double rounding = px_ * height * std::sin(std::min(turn, 90.) * pi / 180) / 6;
    if (!(rounding > rounding_px)) return 0;
    return share * std::min(sharpest_fold, std::log(rounding / rounding_px) / std::log(2.));
  }

  // No edge is sharper than what goes on from either end: folds are lines, and a single edge that
  // turns far is noise.
  std::vector<double> continued(const std::vector<double>& sharpness) const {
    const std::size_t vertices = mesh_.positions.size();
    std::vector<double> first(vertices, 0), second(vertices, 0);  // the sharpest two at each vertex
    const auto ends = [&](std::size_t e) {
      const int h = edges_.first[e];
      return Edge{faces_.corners[idx(h)], faces_.head(h)};
    };
    for (std::size_t e = 0; e < sharpness.size(); ++e) {
      const double here = edges_.is_sharp(edges_.first[e]) ? infinitely_sharp : sharpness[e];
      for (const int v : ends(e)) {
        second[idx(v)] = std::max(second[idx(v)], std::min(first[idx(v)], here));
        first[idx(v)] = std::max(first[idx(v)], here);
      }
    }
    std::vector<double> result = sharpness;
    for (std::size_t e = 0; e < result.size(); ++e)
      for (const int v : ends(e))
        result[e] =
            std::min(result[e], first[idx(v)] > sharpness[e] ? first[idx(v)] : second[idx(v)]);
    return result;
  }

  // Of the face, from the line of the edge to its farthest corner.
  double height_over(int h) const {
    const Vec3& start = mesh_.positions[idx(faces_.corners[idx(h)])];
    const Vec3 along = unit_or_zero(mesh_.positions[idx(faces_.head(h))] - start);
    double height = 0;
    for (const int v : faces_[faces_.corner_faces[idx(h)]])
      height = std::max(height, (mesh_.positions[idx(v)] - start).cross(along).norm());
    return height;
  }

  const SoundMesh& mesh_;
  const HalfEdges& edges_;
  const Faces& faces_;
  const std::vector<double>& distances_;
  double px_ = 0;
  Points normals_;  // (f)
};

constexpr double corner_deg = 80;  // as creases have corners (mesh/creases.h)

// Adds folds of a sharpness (e) to a mesh.
class FoldedMeshMaker {
 public:
  FoldedMeshMaker(const SoundMesh& mesh, const HalfEdges& edges, std::vector<double> sharpness)
      : mesh_(mesh),
        edges_(edges),
        faces_(edges.faces),
        sharpness_(std::move(sharpness)),
        result_{mesh, mesh, std::vector<double>(mesh.positions.size(), 0)} {}

  FoldedMesh run() {
    join_twins();
    add_edges();
    add_corners();
    for (int c = 0; c < static_cast<int>(mesh_.corner_normals.size()); ++c) {
      if (result_.shares[idx(faces_.corners[idx(c)])] > 0)
        result_.hard.corner_normals[idx(c)] = Vec3::Zero();
    }
    return std::move(result_);
  }

 private:
  Edge ends(std::size_t edge) const {
    const int h = edges_.first[edge];
    return {faces_.corners[idx(h)], faces_.head(h)};
  }

  // Rounding decides the same for both sheets of a double cover.
  void join_twins() {
    if (mesh_.twin_faces.empty()) return;
    std::vector<Edge> all;
    for (std::size_t e = 0; e < sharpness_.size(); ++e) all.push_back(ends(e));
    const EdgeTable table(mesh_.positions.size(), all);
    for (std::size_t e = 0; e < sharpness_.size(); ++e) {
      const int a = mesh_.twin_vertices[idx(all[e][0])], b = mesh_.twin_vertices[idx(all[e][1])];
      const int twin = a == none || b == none ? none : table.find(a, b);
      if (twin > static_cast<int>(e)) sharpness_[idx(twin)] = sharpness_[e];
    }
  }

  void add_edges() {
    const EdgeTable table(mesh_.positions.size(), mesh_.edge_vertices);
    for (std::size_t e = 0; e < sharpness_.size(); ++e) {
      if (sharpness_[e] == 0) continue;
      const Edge edge = ends(e);
      const int known = table.find(edge[0], edge[1]);
      set_sharpness(edge, known, std::max(sharpness_[e], edges_.sharpness[e]), result_.soft);
      set_sharpness(edge, known, infinitely_sharp, result_.hard);
      for (const int v : edge)
        result_.shares[idx(v)] = std::max(result_.shares[idx(v)], std::min(1., sharpness_[e]));
    }
  }

  static void set_sharpness(const Edge& edge, int known, double sharpness, SoundMesh& mesh) {
    if (known != none) {
      mesh.edge_sharpness[idx(known)] = sharpness;
      return;
    }
    mesh.edge_vertices.push_back(edge);
    mesh.edge_sharpness.push_back(sharpness);
  }

  // Where a fold turns; where three meet they make a corner themselves.
  void add_corners() {
    std::vector<std::vector<int>> others(mesh_.positions.size());
    std::vector<double> least(mesh_.positions.size(), infinitely_sharp);
    for (std::size_t e = 0; e < sharpness_.size(); ++e) {
      if (sharpness_[e] == 0 && !edges_.is_sharp(edges_.first[e])) continue;
      const auto [a, b] = ends(e);
      for (const auto& [here, other] : {Edge{a, b}, Edge{b, a}}) {
        if (result_.shares[idx(here)] == 0) continue;
        others[idx(here)].push_back(other);
        if (sharpness_[e] > 0) least[idx(here)] = std::min(least[idx(here)], sharpness_[e]);
      }
    }
    for (std::size_t v = 0; v < others.size(); ++v) {
      if (others[v].size() != 2) continue;
      const Points& p = mesh_.positions;
      if (degrees_between(p[v] - p[idx(others[v][0])], p[idx(others[v][1])] - p[v]) < corner_deg)
        continue;
      double& sharpness = result_.soft.vertex_sharpness[v];
      sharpness = std::max(sharpness, least[v]);
      result_.hard.vertex_sharpness[v] = infinitely_sharp;
    }
  }

  const SoundMesh& mesh_;
  const HalfEdges& edges_;
  const Faces& faces_;
  std::vector<double> sharpness_;
  FoldedMesh result_;
};

}  // namespace

std::optional<FoldedMesh> fold(const SoundMesh& mesh, const std::vector<double>& distances) {
  const HalfEdges edges(mesh);
  std::vector<double> sharpness = FoldFinder(mesh, edges, distances).run();
  const auto folds =
      std::count_if(sharpness.begin(), sharpness.end(), [](double s) { return s > 0; });
  if (folds == 0 || folds > most_folds) return {};
  return FoldedMeshMaker(mesh, edges, std::move(sharpness)).run();
}

}  // namespace illustrate
