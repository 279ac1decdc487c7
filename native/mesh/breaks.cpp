#include "mesh/breaks.h"

#include <algorithm>

#include "core/angles.h"
#include "core/disjoint_sets.h"
#include "mesh/creases.h"
#include "mesh/polygons.h"

namespace illustrate {
namespace {

// Below Blender's own angle between sharp and smooth nothing is a corner.
constexpr double steep_deg = 30;
// The sides of a pentagon turn by 72 and are samples of a circle.
constexpr double break_deg = 76;
// Between breaks at both ends: those of an octagon, which is a circle, turn by 45.
constexpr double held_deg = 50;
// Where a line bends by more, or a third edge turns by more, there is a corner: a hexagon has none.
constexpr double corner_deg = 64;
// Of the lesser of two edges: what turns less is no third line that meets them.
constexpr double branch = 2.0 / 3;
// Of an edge: what turns less is not of the same curve.
constexpr double alike = 0.5;
// The rim of a hole of twelve sides bends by 30 at each, that of an octagon by 45.
constexpr double fine_deg = 32;
// Of an edge: what turns less is as flat as a face beside it.
constexpr double calm = 0.4;
constexpr std::size_t fewest_edges = 6;
constexpr double least_bend_deg = 60;

// The steepest edges at a vertex of those that are not sharp, in descending order.
struct Steepest {
  std::array<int, 4> edges{none, none, none, none};
  std::array<double, 4> degrees{0, 0, 0, 0};
  bool has_sharp = false, has_break = false;

  // Three walls of a block meet, which are flat beside it.
  bool is_corner() const {
    return degrees[1] >= break_deg && degrees[2] > corner_deg && degrees[3] <= calm * degrees[2];
  }

  void add(int edge, double turn) {
    for (std::size_t k = 0; k < degrees.size(); ++k) {
      if (!(turn > degrees[k])) continue;
      std::swap(turn, degrees[k]);
      std::swap(edge, edges[k]);
    }
  }
};

struct Line {
  std::vector<int> edges;
  int passed = 0;                       // vertices
  double turn_deg = 0;                  // sum over edges
  double bend_deg = 0, beside_deg = 0;  // sums over passed vertices; beside: of the third edges
  std::size_t rounds = 0;               // edges with a curve that goes on to both sides
  std::vector<std::size_t> ends;        // vertices; of a closed line none

  double mean_turn() const {
    return edges.empty() ? 0 : turn_deg / static_cast<double>(edges.size());
  }
  bool is_round() const { return 2 * rounds >= edges.size(); }
  bool is_fine() const {
    return edges.size() >= fewest_edges && bend_deg >= least_bend_deg &&
           bend_deg < fine_deg * passed && beside_deg < calm * mean_turn() * passed;
  }
};

class BreakFinder {
 public:
  BreakFinder(const Faces& faces, const Points& positions, const Ragged<int>& edges,
              const std::vector<std::uint8_t>& is_sharp, const Shading& shading)
      : faces_(faces),
        p_(positions),
        edges_(edges),
        shading_(shading),
        half_edge_edges_(faces.corners.size(), none) {
    for (std::size_t e = 0; e < edges.size(); ++e) {
      const bool is_open = edges[e].size() != 2;
      turns_.push_back(is_open || is_sharp[e] ? sharp_edge : turn(edges[e]));
      for (const int h : edges[e]) half_edge_edges_[h] = static_cast<int>(e);
    }
  }

  std::vector<std::uint8_t> run() {
    survey_vertices();
    gather_lines();
    return choose();
  }

 private:
  static constexpr double sharp_edge = -1;

  bool is_steep(std::size_t e) const { return turns_[e] >= steep_deg; }
  std::array<std::size_t, 2> ends(std::size_t e) const {
    const int h = edges_[e][0];
    return {idx(faces_.corners[h]), idx(faces_.head(h))};
  }

  const Vec3& face_normal(int h) const { return shading_.face_normals[faces_.corner_faces[h]]; }

  double turn(Span<const int> edge) const {
    return degrees_between(face_normal(edge[0]), face_normal(edge[1]));
  }

  int mate(int h) const {
    const auto edge = edges_[idx(half_edge_edges_[h])];
    return edge[0] == h ? edge[1] : edge[0];
  }

  // Whether the strip that the half-edge's face is of turns as far, and the same way, where it
  // comes into that face: across a quad, or two triangles that are one but for a diagonal.
  bool goes_on(int h) const {
    const std::size_t size = faces_[faces_.corner_faces[h]].size();
    if (size == 4) return turns_alike(faces_.next(faces_.next(h)), h);
    if (size != 3) return false;
    const int after = faces_.next(h), before = faces_.previous(h);
    return (is_diagonal(after, h) && turns_alike(faces_.previous(mate(after)), h)) ||
           (is_diagonal(before, h) && turns_alike(faces_.next(mate(before)), h));
  }

  bool is_diagonal(int side, int h) const {
    const double turn = turn_at(side);
    return turn != sharp_edge && turn < calm * turn_at(h) &&
           faces_[faces_.corner_faces[mate(side)]].size() == 3;
  }

  bool turns_alike(int across, int h) const {
    if (turn_at(across) < alike * turn_at(h)) return false;
    return face_normal(mate(across))
               .cross(face_normal(across))
               .dot(face_normal(h).cross(face_normal(mate(h)))) > 0;
  }

  double turn_at(int h) const { return turns_[idx(half_edge_edges_[h])]; }

  void survey_vertices() {
    vertices_.resize(p_.size());
    for (std::size_t e = 0; e < edges_.size(); ++e) {
      for (const std::size_t v : ends(e)) {
        if (turns_[e] == sharp_edge) vertices_[v].has_sharp |= edges_[e].size() == 2;
        vertices_[v].add(static_cast<int>(e), turns_[e]);
      }
    }
  }

  Vec3 direction_from(std::size_t vertex, int edge) const {
    const auto [a, b] = ends(idx(edge));
    return p_[a == vertex ? b : a] - p_[vertex];
  }

  double bend(std::size_t v) const {
    return degrees_between(-direction_from(v, vertices_[v].edges[0]),
                           direction_from(v, vertices_[v].edges[1]));
  }

  bool passes(std::size_t v) const {
    const Steepest& at = vertices_[v];
    return !at.has_sharp && at.degrees[1] >= steep_deg && at.degrees[2] <= branch * at.degrees[1] &&
           bend(v) <= corner_deg;
  }

  void gather_lines() {
    DisjointSets sets(edges_.size());
    std::vector<std::uint8_t> passed(p_.size(), 0);
    for (std::size_t v = 0; v < p_.size(); ++v) {
      passed[v] = passes(v);
      if (passed[v]) sets.join(vertices_[v].edges[0], vertices_[v].edges[1]);
    }
    lines_.resize(edges_.size());
    for (std::size_t e = 0; e < edges_.size(); ++e) {
      roots_.push_back(idx(sets.root(static_cast<int>(e))));
      if (is_steep(e)) add_edge(e, passed, lines_[roots_[e]]);
    }
    for (std::size_t v = 0; v < p_.size(); ++v) {
      if (!passed[v]) continue;
      Line& line = lines_[roots_[idx(vertices_[v].edges[0])]];
      ++line.passed;
      line.bend_deg += bend(v);
      line.beside_deg += vertices_[v].degrees[2];
    }
  }

  void add_edge(std::size_t e, const std::vector<std::uint8_t>& passed, Line& line) const {
    line.edges.push_back(static_cast<int>(e));
    line.turn_deg += turns_[e];
    line.rounds += goes_on(edges_[e][0]) && goes_on(edges_[e][1]);
    for (const std::size_t v : ends(e))
      if (!passed[v]) line.ends.push_back(v);
  }

  // Fine lines first, then what is held at both ends.
  std::vector<std::uint8_t> choose() {
    std::vector<std::uint8_t> chosen(lines_.size(), 0);
    choose_where([](const Line& line) { return !line.is_round() && line.is_fine(); }, break_deg,
                 chosen);
    const auto is_held = [&](const Line& line) { return ends_at_corners(line); };
    const auto is_between = [&](const Line& line) { return ends_at_breaks(line); };
    while (choose_where(is_held, break_deg, chosen) || choose_where(is_between, held_deg, chosen)) {
    }
    std::vector<std::uint8_t> breaks;
    for (std::size_t e = 0; e < edges_.size(); ++e)
      breaks.push_back(is_steep(e) && chosen[roots_[e]]);
    return breaks;
  }

  template <class Test>
  bool ends(const Line& line, const Test& test) const {
    return !line.ends.empty() && std::all_of(line.ends.begin(), line.ends.end(),
                                             [&](auto v) { return test(vertices_[v]); });
  }

  bool ends_at_corners(const Line& line) const {
    return !line.is_round() && ends(line, [](const Steepest& end) {
      return end.has_break || end.has_sharp || end.is_corner();
    });
  }

  // What may be round there only where it turns as far as nothing round does.
  bool ends_at_breaks(const Line& line) const {
    return (!line.is_round() || line.mean_turn() >= break_deg) &&
           ends(line, [](const Steepest& end) { return end.has_break; });
  }

  // Whether there were any.
  template <class Test>
  bool choose_where(const Test& test, double least_deg, std::vector<std::uint8_t>& chosen) {
    bool found = false;
    for (std::size_t i = 0; i < lines_.size(); ++i) {
      const Line& line = lines_[i];
      if (chosen[i] || line.mean_turn() < least_deg || !test(line)) continue;
      found = true;
      chosen[i] = 1;
      for (const int e : line.edges)
        for (const std::size_t v : ends(idx(e))) vertices_[v].has_break = true;
    }
    return found;
  }

  const Faces& faces_;
  const Points& p_;
  const Ragged<int>& edges_;
  const Shading& shading_;
  std::vector<int> half_edge_edges_;  // (c)
  std::vector<double> turns_;         // (e) degrees; sharp_edge where it is one, or open
  std::vector<Steepest> vertices_;    // (n)
  std::vector<std::size_t> roots_;    // (e) its line
  std::vector<Line> lines_;           // by their roots; others are empty
};

// Shades the corners of a vertex alike from one sharp edge to the next.
class SectorShader {
 public:
  SectorShader(const Faces& faces, const Points& positions, const Ragged<int>& edges,
               const std::vector<std::uint8_t>& sharp, Shading& shading)
      : faces_(faces), p_(positions), shading_(shading), mates_(faces.corners.size(), none) {
    for (std::size_t e = 0; e < edges.size(); ++e) {
      if (sharp[e] || edges[e].size() != 2) continue;
      mates_[edges[e][0]] = edges[e][1];
      mates_[edges[e][1]] = edges[e][0];
    }
  }

  // At all corners of the vertices that are asked for.
  void run(const std::vector<std::uint8_t>& is_asked) {
    std::vector<std::uint8_t> is_done(faces_.corners.size(), 0);
    for (int c = 0; c < faces_.corner_count(); ++c) {
      if (!is_asked[faces_.corners[c]] || is_done[c]) continue;
      find_sector(c);
      shade_sector();
      for (const int other : sector_) is_done[other] = 1;
    }
  }

 private:
  void find_sector(int corner) {
    int first = corner;
    for (int before = back(first); before != none && before != corner; before = back(first))
      first = before;
    sector_.clear();
    int c = first;
    do {
      sector_.push_back(c);
      c = mates_[faces_.previous(c)];
    } while (c != none && c != first);
  }

  int back(int corner) const { return mates_[corner] == none ? none : faces_.next(mates_[corner]); }

  void shade_sector() {
    Vec3 sum = Vec3::Zero();
    for (const int c : sector_)
      sum += corner_angle(faces_, p_, c) * shading_.face_normals[faces_.corner_faces[c]];
    const Vec3 normal = unit_of_sum(sum);
    if (normal.isZero()) return;
    for (const int c : sector_) {
      if (!shading_.is_flat[faces_.corner_faces[c]]) shading_.corner_normals[c] = normal;
    }
  }

  const Faces& faces_;
  const Points& p_;
  Shading& shading_;
  std::vector<int> mates_;  // (c) across edges that are not sharp
  std::vector<int> sector_;
};

// (edges) 1: sharp by the input, or as it is shaded; open edges are not.
std::vector<std::uint8_t> sharp_as_shaded(const PolygonMesh& mesh, const Faces& faces,
                                          const Ragged<int>& edges,
                                          std::vector<std::uint8_t> is_sharp,
                                          const Shading& shading) {
  for (std::size_t e = 0; e < edges.size(); ++e) {
    if (edges[e].size() != 2 || is_sharp[e]) continue;
    const Vec3& a = shading.face_normals[faces.corner_faces[edges[e][0]]];
    const Vec3& b = shading.face_normals[faces.corner_faces[edges[e][1]]];
    const EndsDiffer ends = ends_differ(faces, edges[e], shading);
    is_sharp[e] = are_flat(faces, edges[e], shading) ? turns_more(a, b, mesh.crease_angle_deg)
                                                     : ends.start || ends.end;
  }
  return is_sharp;
}

}  // namespace

int shade_breaks(const PolygonMesh& mesh, const Faces& faces, const Ragged<int>& edges,
                 const std::vector<std::uint8_t>& is_sharp, const SoundMesh& sound,
                 Shading& shading) {
  const bool is_covered = std::find(sound.kept.begin(), sound.kept.end(), 0) != sound.kept.end();
  if (mesh.cage || mesh.corner_normals.empty() || is_covered) return 0;
  std::vector<std::uint8_t> sharp = sharp_as_shaded(mesh, faces, edges, is_sharp, shading);
  const std::vector<std::uint8_t> breaks =
      BreakFinder(faces, sound.positions, edges, sharp, shading).run();
  std::vector<std::uint8_t> is_broken(sound.positions.size(), 0);
  for (std::size_t e = 0; e < edges.size(); ++e) {
    if (!breaks[e]) continue;
    sharp[e] = 1;
    is_broken[faces.corners[edges[e][0]]] = is_broken[faces.head(edges[e][0])] = 1;
  }
  SectorShader(faces, sound.positions, edges, sharp, shading).run(is_broken);
  return static_cast<int>(std::count(breaks.begin(), breaks.end(), 1));
}

}  // namespace illustrate
