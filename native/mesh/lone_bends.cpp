#include "mesh/lone_bends.h"

#include <algorithm>
#include <map>

#include "core/angles.h"
#include "mesh/flat_pieces.h"
#include "mesh/mesh_size.h"
#include "mesh/polygons.h"

namespace illustrate {
namespace {

// A render hardly shows what turns by less.
constexpr double least_lone_deg = 8;
constexpr double px_of_diagonal = 1400;
// A quad of a grid has a quarter at the grid's border, and a facet of a ball has none.
constexpr double least_sharp_share = 0.3;
// Of the line's own turn: what turns less is no part of the same curve.
constexpr double least_turn_share = 0.2;
// Cosines between the ways out of a piece. The next edge of a strip runs within 37 degrees of the
// last, and the hips of a roof at 45 to its ridge; but a strip of triangles runs to and fro.
constexpr double across_strip = -0.8;
constexpr double across_triangles = -0.3;

// Where two flat pieces meet.
struct BendLine {
  std::vector<int> half_edges;  // of the first piece
  double length = 0, turn_deg = 0;
  bool is_lone = false;
};

class BendFinder {
 public:
  BendFinder(const Faces& faces, const Points& positions, const Ragged<int>& edges,
             const EdgeTurns& turns, const Shading& shading)
      : faces_(faces),
        p_(positions),
        edges_(edges),
        turns_(turns),
        shading_(shading),
        flat_(find_flat_pieces(faces, positions, turns, shading)) {}

  std::vector<std::uint8_t> run() {
    measure_pieces();
    gather_lines();
    gather_borders();
    const double least = diagonal(faces_, p_) / px_of_diagonal;
    for (auto& [pieces, line] : lines_) line.is_lone = height(line) >= least && is_alone(line);
    find_ends();
    while (drop_loose_ends()) {
    }
    std::vector<std::uint8_t> is_lone(edges_.size(), 0);
    for (const auto& [pieces, line] : lines_)
      for (const int h : line.half_edges) is_lone[turns_.edge_of(h)] = line.is_lone;
    return is_lone;
  }

 private:
  int piece(int h) const { return flat_.pieces[faces_.corner_faces[h]]; }
  Vec3 along(int h) const { return p_[faces_.head(h)] - p_[faces_.corners[h]]; }
  Vec3 way_out(int h) const { return along(h).cross(flat_.normals[piece(h)]).stableNormalized(); }
  bool is_border(int h) const {
    return turns_.mate(h) == none || piece(h) != piece(turns_.mate(h));
  }

  void measure_pieces() {
    areas_.assign(faces_.sources.size(), 0);
    borders_.assign(faces_.sources.size(), 0);
    sharp_borders_.assign(faces_.sources.size(), 0);
    std::vector<Vec3> polygon;
    for (int f = 0; f < faces_.size(); ++f) {
      polygon.clear();
      for (const int v : faces_[f]) polygon.push_back(p_[v]);
      areas_[flat_.pieces[f]] += newell_normal({polygon.data(), polygon.size()}).stableNorm() / 2;
    }
    for (int h = 0; h < faces_.corner_count(); ++h) {
      if (!is_border(h)) continue;
      const double length = along(h).stableNorm();
      borders_[piece(h)] += length;
      if (turns_.at(h) == EdgeTurns::sharp_edge) sharp_borders_[piece(h)] += length;
    }
  }

  bool ends_sharply(int piece) const {
    return flat_.is_flat[piece] && sharp_borders_[piece] >= least_sharp_share * borders_[piece];
  }

  void gather_lines() {
    for (std::size_t e = 0; e < edges_.size(); ++e) {
      const double turn = turns_.of_edge(e);
      if (turn < least_lone_deg || !are_flat(faces_, edges_[e], shading_)) continue;
      int h = edges_[e][0], mate = edges_[e][1];
      if (piece(h) > piece(mate)) std::swap(h, mate);
      if (piece(h) == piece(mate) || !ends_sharply(piece(h)) || !ends_sharply(piece(mate)))
        continue;
      BendLine& line = lines_[{piece(h), piece(mate)}];
      line.half_edges.push_back(h);
      line.length += along(h).stableNorm();
      line.turn_deg = std::max(line.turn_deg, turn);
    }
  }

  // Of the pieces that have lines.
  void gather_borders() {
    for (const auto& [pieces, line] : lines_)
      for (const int piece : pieces) border_half_edges_[piece];
    for (int h = 0; h < faces_.corner_count(); ++h) {
      const auto found = border_half_edges_.find(piece(h));
      if (found != border_half_edges_.end() && is_border(h)) found->second.push_back(h);
    }
  }

  // How far a smooth surface would leave the line.
  double height(const BendLine& line) const {
    const int h = line.half_edges[0];
    const double area = std::min(areas_[piece(h)], areas_[piece(turns_.mate(h))]);
    return line.length > 0 ? area / line.length * radians(line.turn_deg) / 8 : 0;
  }

  bool is_alone(const BendLine& line) const {
    const int h = line.half_edges[0];
    return !goes_on(h, line.turn_deg) && !goes_on(turns_.mate(h), line.turn_deg);
  }

  // Across the piece of a half-edge, from a line that turns so far there.
  bool goes_on(int h, double turn_deg) const {
    const std::vector<int>& border = border_half_edges_.at(piece(h));
    const double across = border.size() == 3 ? across_triangles : across_strip;
    const Vec3 way = way_out(h);
    return std::any_of(border.begin(), border.end(), [&](int other) {
      return turns_.at(other) >= least_turn_share * turn_deg && way_out(other).dot(way) < across &&
             is_convex(other) == is_convex(h);
    });
  }

  bool is_convex(int h) const {
    return flat_.normals[piece(h)].cross(flat_.normals[piece(turns_.mate(h))]).dot(along(h)) > 0;
  }

  // How many sharp or open edges and how many lines' ends there are at each vertex.
  void find_ends() {
    for (auto& [pieces, line] : lines_) {
      std::map<int, int> counts;
      for (const int h : line.half_edges) {
        ++counts[faces_.corners[h]];
        ++counts[faces_.head(h)];
      }
      for (const auto& [v, count] : counts)
        if (count == 1) ends_[pieces].push_back(v);
    }
    held_.assign(p_.size(), 0);
    for (std::size_t e = 0; e < edges_.size(); ++e) {
      if (turns_.of_edge(e) != EdgeTurns::sharp_edge) continue;
      const int h = edges_[e][0];
      held_[faces_.corners[h]] = held_[faces_.head(h)] = 2;
    }
    for (const auto& [pieces, line] : lines_)
      if (line.is_lone) add_ends(pieces, 1);
  }

  void add_ends(const std::array<int, 2>& pieces, int count) {
    for (const int v : ends_[pieces]) held_[v] += count;
  }

  // Whether there were any.
  bool drop_loose_ends() {
    bool dropped = false;
    for (auto& [pieces, line] : lines_) {
      const auto is_loose = [&](int v) { return held_[v] < 2; };
      const std::vector<int>& ends = ends_[pieces];
      if (!line.is_lone || std::none_of(ends.begin(), ends.end(), is_loose)) continue;
      line.is_lone = false;
      add_ends(pieces, -1);
      dropped = true;
    }
    return dropped;
  }

  const Faces& faces_;
  const Points& p_;
  const Ragged<int>& edges_;
  const EdgeTurns& turns_;
  const Shading& shading_;
  const FlatPieces flat_;
  std::vector<double> areas_, borders_, sharp_borders_;  // (f) by pieces; borders: lengths
  std::map<std::array<int, 2>, BendLine> lines_;         // by their pieces, the lower first
  std::map<int, std::vector<int>> border_half_edges_;    // by pieces
  std::map<std::array<int, 2>, std::vector<int>> ends_;  // vertices of lines
  std::vector<int> held_;                                // (n) below 2: what ends there is loose
};

}  // namespace

std::vector<std::uint8_t> find_lone_bends(const Faces& faces, const Points& positions,
                                          const Ragged<int>& edges, const EdgeTurns& turns,
                                          const Shading& shading) {
  return BendFinder(faces, positions, edges, turns, shading).run();
}

}  // namespace illustrate
