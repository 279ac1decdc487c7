#include "control/folds.h"

#include <algorithm>
#include <cmath>

#include "control/smoothstep.h"
#include "core/angles.h"
#include "mesh/edge_table.h"
#include "mesh/mesh_size.h"
#include "mesh/polygons.h"

namespace illustrate {
namespace {

// Each fold has a sharpness of its own, so that no two patches beside folds are alike: with more of
// them a view takes minutes.
constexpr std::ptrdiff_t most_folds = 20'000;

constexpr double rounding_px = 0.5;
// Sharpness that the last of eight levels still shows.
constexpr double sharpest_fold = 8;

constexpr double fold_deg = 76;
// A triangle that is so pointed opposite an edge is a piece of a strip that comes to that edge.
constexpr double strip_deg = 30;

// What turns less is a curve or hardly seen; from here on it is a corner where it stands alone.
constexpr double bend_deg = 35, corner_bend_deg = 50;
// An arc's first and last edge turn half as much as the others, which is two fifths and more. What
// turns by less than a fifth of its neighbour, or by twice as much, is of another curve.
constexpr double least_share = 0.2, less_share = 0.4;
constexpr double more_share = 1.7, most_share = 2;

// Shading turns 72 degrees over a face of a pentagonal prism, 90 across a chamfer.
constexpr double bent_face_deg = 72, folded_face_deg = 84;

// What is missed by less is near enough, and what turns by less makes no corner.
constexpr double near_px = 2, missed_px = 5;
constexpr double flat_deg = 20, missed_fold_deg = 40;

struct Turn {
  double degrees = 0;
  Vec3 axis = Vec3::Zero();  // of any length
};

const Turn& greater(const Turn& a, const Turn& b) { return a.degrees < b.degrees ? b : a; }

Turn turn_between(const Vec3& from, const Vec3& to) {
  return {degrees_between(from, to), from.cross(to)};
}

class FoldFinder {
 public:
  FoldFinder(const SoundMesh& mesh, const HalfEdges& edges, const std::vector<double>& distances)
      : mesh_(mesh), edges_(edges), faces_(edges.faces), distances_(distances) {}

  std::vector<double> run() {
    px_ = diagonal_px / diagonal(mesh_);
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

  // How the surface turns on its way across an edge, from the face of the half-edge to its mate's:
  // as the faces do, or the strips that they are pieces of.
  Turn turn_at(int h, int mate) const {
    return greater(turn_of_faces(h, mate), mitred_turn(h, mate));
  }

  Turn turn_of_faces(int h, int mate) const {
    return turn_between(normals_[idx(faces_.corner_faces[idx(h)])],
                        normals_[idx(faces_.corner_faces[idx(mate)])]);
  }

  // Of two strips that meet in a mitre, as mouldings and the bevels of letters do: at both ends of
  // the edge, and as much where they lie nearly in one plane, so that their faces hardly turn.
  Turn mitred_turn(int h, int mate) const {
    if (!is_strip(h) || !is_strip(mate)) return {};
    Turn turn = turn_past(faces_.previous(h), faces_.next(mate));
    turn.degrees = std::min(turn.degrees, turn_past(faces_.previous(mate), faces_.next(h)).degrees);
    return turn;
  }

  std::size_t corners_of(int h) const { return faces_[faces_.corner_faces[idx(h)]].size(); }

  bool is_strip(int h) const {
    if (corners_of(h) != 3) return corners_of(h) == 4;
    const Vec3& apex = mesh_.positions[idx(faces_.head(faces_.next(h)))];
    const Vec3& a = mesh_.positions[idx(faces_.corners[idx(h)])];
    const Vec3& b = mesh_.positions[idx(faces_.head(h))];
    return degrees_between(a - apex, b - apex) < strip_deg;
  }

  // From half-edge `before`, which ends where `after` begins.
  Turn turn_past(int before, int after) const {
    const Vec3& from = mesh_.positions[idx(faces_.corners[idx(before)])];
    const Vec3& here = mesh_.positions[idx(faces_.head(before))];
    return turn_between(here - from, mesh_.positions[idx(faces_.head(after))] - here);
  }

  // Of an edge between two quadrilaterals: how differently the edges before and after it in their
  // strip turn. No curve goes on through it then, whatever its angle.
  double lone_share(int h, int mate, const Turn& turn) const {
    const double share = smoothstep(bend_deg, corner_bend_deg, turn.degrees);
    if (share == 0) return 0;
    return share * std::min(difference(h, turn), difference(mate, {turn.degrees, -turn.axis}));
  }

  // 0 .. 1: between an edge's turn, on the way out of a face, and that of the edge where the way
  // comes into it. 0 where that one says nothing.
  double difference(int h, const Turn& turn) const {
    const int across = faces_.next(faces_.next(h)), before = edges_.mates[idx(across)];
    if (corners_of(h) != 4 || before == none || edges_.is_sharp(across)) return 0;
    const Turn last = turn_at(before, across);
    const double share = last.axis.dot(turn.axis) > 0 ? last.degrees / turn.degrees : 0;
    return share < 1 ? 1 - smoothstep(least_share, less_share, share)
                     : smoothstep(more_share, most_share, share);
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
    const Turn of_faces = turn_of_faces(h, mate), turn = greater(of_faces, mitred_turn(h, mate));
    const double share =
        std::max({smoothstep(curve_deg, fold_deg, turn.degrees), lone_share(h, mate, turn),
                  missed_share(h, of_faces.degrees), folded_share(h), folded_share(mate)});
    if (share == 0) return 0;
    // A cubic spline's limit is a sixth of its control polygon's second difference inside it.
    const double height = std::min(reach_of_face(edges_.faces, mesh_.positions, h),
                                   reach_of_face(edges_.faces, mesh_.positions, mate));
    const double rounding = px_ * height * std::sin(radians(std::min(turn.degrees, 90.))) / 6;
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
