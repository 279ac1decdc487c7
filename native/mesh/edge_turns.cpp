#include "mesh/edge_turns.h"

#include "core/angles.h"

namespace illustrate {
namespace {

// Of an edge: what turns less is not of the same curve.
constexpr double alike = 0.5;
// Of an edge: what turns less is the diagonal of a quad.
constexpr double diagonal_share = 0.4;
// A flat bar has sides that are less alike; rounding shall not decide of a bar of two squares.
constexpr double most_unlike = 2 + 1e-4;

}  // namespace

EdgeTurns::EdgeTurns(const Faces& faces, const Points& positions, const Ragged<int>& edges,
                     const std::vector<std::uint8_t>& is_sharp, const Shading& shading)
    : faces_(faces),
      p_(positions),
      edges_(edges),
      shading_(shading),
      half_edge_edges_(faces.corners.size(), none) {
  for (std::size_t e = 0; e < edges.size(); ++e) {
    for (const int h : edges[e]) half_edge_edges_[h] = static_cast<int>(e);
    const bool is_open = edges[e].size() != 2;
    turns_.push_back(is_open || is_sharp[e] ? sharp_edge : of_faces(edges[e][0]));
  }
}

double EdgeTurns::of_faces(int h) const {
  const int other = mate(h);
  return other == none ? 0 : degrees_between(normal(h), normal(other));
}

int EdgeTurns::mate(int h) const {
  const auto edge = edges_[idx(edge_of(h))];
  if (edge.size() != 2) return none;
  return edge[0] == h ? edge[1] : edge[0];
}

std::array<int, 2> EdgeTurns::ends(int edge) const {
  const int h = edges_[idx(edge)][0];
  return {faces_.corners[idx(h)], faces_.head(h)};
}

int EdgeTurns::other_end(int edge, int vertex) const {
  const auto [a, b] = ends(edge);
  return a == vertex ? b : a;
}

bool EdgeTurns::is_convex(int h) const {
  const Vec3 along = p_[idx(faces_.head(h))] - p_[idx(faces_.corners[idx(h)])];
  return normal(h).cross(normal(mate(h))).dot(along) > 0;
}

void EdgeTurns::sharpen(const std::vector<std::uint8_t>& more) {
  for (std::size_t e = 0; e < more.size(); ++e)
    if (more[e]) turns_[e] = sharp_edge;
}

bool EdgeTurns::is_round(std::size_t edge) const {
  return turns_[edge] != sharp_edge && across(edges_[edge][0]) != none &&
         across(edges_[edge][1]) != none;
}

bool EdgeTurns::is_round_of_like_sides(std::size_t edge) const {
  if (!is_round(edge)) return false;
  const double a = width(edges_[edge][0]), b = width(edges_[edge][1]);
  return std::max(a, b) <= most_unlike * std::min(a, b);
}

// Where the strip that the half-edge's face is of comes into that face, if it turns as far there
// and the same way: across a quad, or two triangles that are one but for a diagonal.
int EdgeTurns::across(int h) const {
  const int after = faces_.next(h), before = faces_.previous(h);
  const std::size_t size = faces_[faces_.corner_faces[h]].size();
  if (size == 4) return turns_alike(faces_.next(after), h) ? faces_.next(after) : none;
  if (size != 3) return none;
  if (is_diagonal(after, h)) {
    const int far = faces_.previous(mate(after));
    if (turns_alike(far, h)) return far;
  }
  if (!is_diagonal(before, h)) return none;
  const int far = faces_.next(mate(before));
  return turns_alike(far, h) ? far : none;
}

bool EdgeTurns::is_diagonal(int side, int h) const {
  const double turn = at(side);
  return turn != sharp_edge && turn < diagonal_share * at(h) &&
         faces_[faces_.corner_faces[mate(side)]].size() == 3;
}

bool EdgeTurns::turns_alike(int across, int h) const {
  if (at(across) < alike * at(h)) return false;
  return normal(mate(across)).cross(normal(across)).dot(normal(h).cross(normal(mate(h)))) > 0;
}

// Of the strip's piece between the half-edge and where it goes on.
double EdgeTurns::width(int h) const { return (middle(across(h)) - middle(h)).stableNorm(); }

Vec3 EdgeTurns::middle(int h) const { return (p_[faces_.corners[h]] + p_[faces_.head(h)]) / 2; }

}  // namespace illustrate
