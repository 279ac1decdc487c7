#include "mesh/breaks.h"

#include <algorithm>

#include "core/angles.h"
#include "core/disjoint_sets.h"
#include "mesh/creases.h"
#include "mesh/flat_rings.h"
#include "mesh/polygons.h"

namespace illustrate {
namespace {

// Where a line bends by more, or a third edge turns by more, there is a corner: a hexagon has none.
constexpr double corner_deg = 64;
// Of the lesser of two edges: what turns less is no third line that meets them.
constexpr double third_share = 2.0 / 3;
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
  bool has_sharp = false, has_break = false, is_angular = false;

  // Three walls of a block meet, which are flat beside it.
  bool is_corner() const {
    return degrees[1] >= break_deg && degrees[2] > corner_deg && degrees[3] <= calm * degrees[2];
  }

  bool is_third(std::size_t edge) const {
    return edges[0] != static_cast<int>(edge) && edges[1] != static_cast<int>(edge);
  }

  // Whether an edge goes up to a rim.
  bool is_upright(std::size_t edge) const { return degrees[1] >= break_deg && is_third(edge); }

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
  std::size_t like_rounds = 0;          // those with sides that are alike
  std::vector<std::size_t> ends;        // vertices; of a closed line none

  double mean_turn() const {
    return edges.empty() ? 0 : turn_deg / static_cast<double>(edges.size());
  }
  bool is_round() const { return 2 * rounds >= edges.size(); }
  bool is_ring() const { return 2 * like_rounds >= edges.size(); }
  bool is_fine() const {
    return !is_ring() && edges.size() >= fewest_edges && bend_deg >= least_bend_deg &&
           bend_deg < fine_deg * passed && beside_deg < calm * mean_turn() * passed;
  }
};

class BreakFinder {
 public:
  BreakFinder(const Faces& faces, const Points& positions, const Ragged<int>& edges,
              const EdgeTurns& turns, const FlatRings& rings)
      : faces_(faces), p_(positions), edges_(edges), turns_(turns), rings_(rings) {}

  std::vector<std::uint8_t> run() {
    survey_vertices();
    spread_corners();
    gather_lines();
    return choose();
  }

 private:
  bool is_sharp(std::size_t e) const { return turns_.of_edge(e) == EdgeTurns::sharp_edge; }
  bool is_rim(std::size_t e) const { return rings_.is_rim[e] && !is_sharp(e); }
  bool is_steep(std::size_t e) const { return turns_.of_edge(e) >= steep_deg; }
  std::array<std::size_t, 2> ends(std::size_t e) const {
    const int h = edges_[e][0];
    return {idx(faces_.corners[h]), idx(faces_.head(h))};
  }

  void survey_vertices() {
    vertices_.resize(p_.size());
    for (std::size_t e = 0; e < edges_.size(); ++e) {
      for (const std::size_t v : ends(e)) {
        if (is_sharp(e)) vertices_[v].has_sharp |= edges_[e].size() == 2;
        vertices_[v].has_break |= is_rim(e);
        vertices_[v].is_angular |= rings_.is_angular[v] != 0;
        vertices_[v].add(static_cast<int>(e), turns_.of_edge(e));
      }
    }
  }

  // Along the upright edges of a polygon beside a circle, to the rim of its other end: the top of a
  // bolt's head.
  void spread_corners() {
    for (std::size_t e = 0; e < edges_.size(); ++e) {
      if (turns_.of_edge(e) < octagon_deg) continue;
      const auto [a, b] = ends(e);
      for (const auto& [from, to] : {std::array{a, b}, std::array{b, a}})
        if (rings_.is_angular[from] && vertices_[to].is_upright(e)) vertices_[to].is_angular = true;
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
    return !at.has_sharp && !at.is_angular && at.degrees[1] >= steep_deg &&
           at.degrees[2] <= third_share * at.degrees[1] && bend(v) <= corner_deg;
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
    line.turn_deg += turns_.of_edge(e);
    line.rounds += turns_.is_round(e);
    line.like_rounds += turns_.is_round_of_like_sides(e);
    for (const std::size_t v : ends(e)) {
      const auto& steepest = vertices_[v].edges;
      const bool is_third =
          steepest[0] != static_cast<int>(e) && steepest[1] != static_cast<int>(e);
      if (!passed[v] || is_third) line.ends.push_back(v);
    }
  }

  // Fine lines first, then what is held at both ends.
  std::vector<std::uint8_t> choose() {
    std::vector<std::uint8_t> chosen(lines_.size(), 0);
    choose_where([](const Line& line) { return line.is_fine(); }, break_deg, chosen);
    const auto is_held = [&](const Line& line) { return ends_at_corners(line); };
    const auto is_between = [&](const Line& line) { return ends_at_breaks(line); };
    while (choose_where(is_held, break_deg, chosen) ||
           choose_where(is_between, octagon_deg, chosen)) {
    }
    std::vector<std::uint8_t> breaks;
    for (std::size_t e = 0; e < edges_.size(); ++e)
      breaks.push_back(is_rim(e) || (is_steep(e) && chosen[roots_[e]]));
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

  // What may be round there only where it turns as far as nothing round does, or ends at corners of
  // polygons beside circles.
  bool ends_at_breaks(const Line& line) const {
    const bool is_corner = !line.is_round() || line.mean_turn() >= break_deg;
    return ends(
        line, [&](const Steepest& end) { return end.is_angular || (end.has_break && is_corner); });
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
  const EdgeTurns& turns_;
  const FlatRings& rings_;
  std::vector<Steepest> vertices_;  // (n)
  std::vector<std::size_t> roots_;  // (e) its line
  std::vector<Line> lines_;         // by their roots; others are empty
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
  const EdgeTurns turns(faces, sound.positions, edges, sharp, shading);
  const FlatRings rings = find_flat_rings(faces, sound.positions, turns, shading, edges.size());
  const std::vector<std::uint8_t> breaks =
      BreakFinder(faces, sound.positions, edges, turns, rings).run();
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
