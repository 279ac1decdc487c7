// How far faces turn at their edges, and where strips of faces go on turning.
#pragma once

#include <array>

#include "mesh/shading.h"

namespace illustrate {

// Below Blender's own angle between sharp and smooth nothing is a corner.
constexpr double steep_deg = 30;
// The sides of a pentagon turn by 72 and are samples of a circle.
constexpr double break_deg = 76;
// The sides of an octagon, which is a circle, turn by 45.
constexpr double octagon_deg = 50;

class EdgeTurns {
 public:
  static constexpr double sharp_edge = -1;

  // edges: half_edges_by_edge's. is_sharp (edges): 1 where nothing is to be told. All must outlive
  // this.
  EdgeTurns(const Faces& faces, const Points& positions, const Ragged<int>& edges,
            const std::vector<std::uint8_t>& is_sharp, const Shading& shading);

  // Degrees; sharp_edge where it is one, or open.
  double of_edge(std::size_t edge) const { return turns_[edge]; }
  double at(int half_edge) const { return turns_[idx(edge_of(half_edge))]; }
  // The same of an edge that is sharp; 0 where it is open.
  double of_faces(int half_edge) const;

  int edge_of(int half_edge) const { return half_edge_edges_[idx(half_edge)]; }
  // The other half-edge of an edge; none: there is not just one.
  int mate(int half_edge) const;
  // The vertices of an edge, and that of its two which is not this one.
  std::array<int, 2> ends(int edge) const;
  int other_end(int edge, int vertex) const;
  // Whether the two faces of an edge lie behind each other's planes.
  bool is_convex(int half_edge) const;

  // These edges (edges) are sharp from now on, too.
  void sharpen(const std::vector<std::uint8_t>& more);

  // Whether the strip of faces across an edge is as that round a tube of few sides: to both sides
  // the next edge turns the same way, at least half as far.
  bool is_round(std::size_t edge) const;
  // The same, and the two sides are alike: one is at most twice as wide as the other.
  bool is_round_of_like_sides(std::size_t edge) const;

 private:
  int across(int h) const;
  bool is_diagonal(int side, int h) const;
  bool turns_alike(int across, int h) const;
  double width(int h) const;
  const Vec3& normal(int h) const { return shading_.face_normals[faces_.corner_faces[h]]; }
  Vec3 middle(int h) const;

  const Faces& faces_;
  const Points& p_;
  const Ragged<int>& edges_;
  const Shading& shading_;
  std::vector<int> half_edge_edges_;  // (c)
  std::vector<double> turns_;         // (edges)
};

}  // namespace illustrate
