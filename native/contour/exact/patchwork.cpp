#include "contour/exact/patchwork.h"

#include <algorithm>

#include "surface/jets/curvature.h"

namespace illustrate {
namespace {

// Corners are points 0, 1, 2, the middle of edge k is point 3 + k.
using Part = std::array<int, 3>;

int turned(int point, int by) { return point < 3 ? (point + by) % 3 : 3 + (point + by) % 3; }

// The parts of a triangle of which these edges have a middle.
std::vector<Part> parts_of(const std::array<bool, 3>& has_middle) {
  const auto count = std::count(has_middle.begin(), has_middle.end(), true);
  if (count == 0) return {{0, 1, 2}};
  if (count == 3) return {{0, 3, 5}, {3, 1, 4}, {5, 4, 2}, {3, 4, 5}};
  int by = 0;  // turns the marked edge to 0, two marked ones to 0 and 1
  while (!has_middle[idx(by)] || (count == 2 && !has_middle[idx((by + 1) % 3)])) ++by;
  std::vector<Part> parts{{0, 3, 2}, {3, 1, 2}};
  if (count == 2) parts = {{3, 1, 4}, {0, 3, 4}, {0, 4, 2}};
  for (Part& part : parts) {
    for (int& point : part) point = turned(point, by);
  }
  return parts;
}

// Which edge of the parent a side of a part lies on (none: inside), and which half (2: all of it).
struct ParentEdge {
  int edge = none;
  int half = 0;
};
ParentEdge parent_edge(int from, int to) {
  for (int k = 0; k < 3; ++k) {
    if (from == k && to == next_corner(k)) return {k, 2};
    if (from == k && to == 3 + k) return {k, 0};
    if (from == 3 + k && to == next_corner(k)) return {k, 1};
  }
  return {};
}

std::uint16_t mean(std::uint16_t a, std::uint16_t b) {
  return static_cast<std::uint16_t>((a + b) / 2);
}

}  // namespace

Patchwork::Patchwork(const Surface& whole, const LimitSurface& limit, std::size_t expected)
    : whole_(whole),
      limit_(limit),
      numbers_(expected),
      vertices_(expected),
      places_(expected),
      rim_(expected) {
  pieces_.reserve(expected);
  surface_.object_is_smooth = whole.object_is_smooth;
  surface_.diagonal = whole.diagonal;
  surface_.object_diagonals = whole.object_diagonals;
}

void Patchwork::add(const std::vector<int>& triangles) {
  for (const int t : triangles) {
    if (numbers_[t] == none) add_whole(t);
  }
}

const Surface& Patchwork::surface() {
  if (!is_published_) publish();
  is_published_ = true;
  return surface_;
}

int Patchwork::add_vertex_of(int whole_vertex) {
  int& number = vertices_.at(whole_vertex);
  if (number != none) return number;
  number = static_cast<int>(surface_.positions.size());
  const std::size_t v = idx(whole_vertex);
  int& place = places_.at(whole_.places[v]);
  if (place == none) place = number;
  if (whole_.is_tip(whole_vertex)) surface_.tips.push_back(number);
  surface_.positions.push_back(whole_.positions[v]);
  surface_.normals.push_back(whole_.normals[v]);
  surface_.places.push_back(place);
  surface_.curvature.push_back(whole_.curvature[v]);
  return number;
}

int Patchwork::add_whole(int triangle) {
  const int number = static_cast<int>(pieces_.size());
  numbers_.at(triangle) = number;
  wholes_.push_back(triangle);
  is_published_ = false;
  Piece piece;
  for (int k = 0; k < 3; ++k) {
    piece.vertices[idx(k)] = add_vertex_of(whole_.triangles[idx(triangle)][idx(k)]);
  }
  piece.flips = whole_.flips[idx(triangle)];
  piece.kinds = whole_.edge_kinds[idx(triangle)];
  piece.patch = whole_.patches[idx(triangle)];
  piece.source = triangle;
  pieces_.push_back(piece);
  for (int k = 0; k < 3; ++k) {
    const int here = std::exchange(rim_.at(3 * triangle + k), none);
    if (here != none) {
      join(number, k, here / 3, here % 3);
      continue;
    }
    const EdgeSide other = opposite_side(whole_, {triangle, k});
    if (other.triangle == none) continue;
    pieces_.back().beyond[idx(k)] = 3 * other.triangle + other.corner;
    rim_.at(3 * other.triangle + other.corner) = 3 * number + k;
  }
  return number;
}

void Patchwork::join(int piece, int edge, int other, int other_edge) {
  const auto link = [&](int a, int i, int b, int j) {
    Piece& p = pieces_[idx(a)];
    p.neighbours[idx(i)] = b;
    p.mates[idx(i)] = j;
    p.beyond[idx(i)] = none;
  };
  link(piece, edge, other, other_edge);
  link(other, other_edge, piece, edge);
}

// There is a limit surface, and the coordinates of the corners on the patch still have a middle.
bool Patchwork::can_cut(int piece) const {
  const PatchTriangle& patch = pieces_[idx(piece)].patch;
  for (const auto& corner : patch.corners) {
    for (const std::uint16_t x : corner) {
      if (x % 2 != 0) return false;
    }
  }
  return middle_of(pieces_[idx(piece)], 0).has_value();
}

bool Patchwork::cut(const std::vector<int>& triangles) {
  std::vector<int> possible;
  for (const int t : triangles) {
    if (can_cut(t)) possible.push_back(t);
  }
  if (possible.empty()) return false;
  Cutting cutting{mark(possible), {}};
  for (int t = 0; t < static_cast<int>(cutting.middles.size()); ++t) {
    if (cutting.is_cut(t)) replace(t, cutting);
  }
  is_published_ = false;
  return true;
}

std::vector<Patchwork::Middles> Patchwork::mark(const std::vector<int>& triangles) {
  for (const int t : triangles) {
    for (int k = 0; k < 3; ++k) {
      const int beyond = pieces_[idx(t)].beyond[idx(k)];
      if (beyond == none) continue;
      add_whole(beyond / 3);
      added_.push_back(beyond / 3);
    }
  }
  std::vector<Middles> middles(pieces_.size());
  for (const int t : triangles) {
    for (int k = 0; k < 3; ++k) mark_edge(t, k, middles);
  }
  return middles;
}

void Patchwork::mark_edge(int piece, int edge, std::vector<Middles>& middles) {
  Middle& middle = middles[idx(piece)][idx(edge)];
  if (middle.vertex != none) return;
  const Piece& here = pieces_[idx(piece)];
  middle = new_middle(*middle_of(here, edge), static_cast<int>(surface_.positions.size()));
  const int other = here.neighbours[idx(edge)];
  if (other == none) return;
  const int mate = here.mates[idx(edge)];
  const Piece& there = pieces_[idx(other)];
  const auto ends = [](const Piece& p, int k) {
    return std::minmax({p.vertices[idx(k)], p.vertices[idx(next_corner(k))]});
  };
  Middle& opposite = middles[idx(other)][idx(mate)];
  const std::optional<LimitPoint> p = middle_of(there, mate);
  if (p && ends(here, edge) != ends(there, mate)) {
    opposite = new_middle(*p, surface_.places[idx(middle.vertex)]);
    return;
  }
  const Vec3& normal = surface_.normals[idx(middle.vertex)];
  opposite = {middle.vertex, p && p->du.cross(p->dv).dot(normal) < 0};
}

// The middle of an edge on the piece's own patch and sheet; nothing where there is none.
std::optional<LimitPoint> Patchwork::middle_of(const Piece& piece, int edge) const {
  const PatchTriangle& patch = piece.patch;
  if (patch.ptex_face == none) return {};
  return limit_.evaluate({patch.ptex_face, (patch.uv(edge) + patch.uv(next_corner(edge))) / 2});
}

Patchwork::Middle Patchwork::new_middle(const LimitPoint& p, int place) {
  const Vec3 normal = p.du.cross(p.dv).normalized();
  surface_.positions.push_back(p.position);
  surface_.normals.push_back(normal);
  surface_.places.push_back(place);
  surface_.curvature.push_back(principal_curvature(p, normal));
  return {static_cast<int>(surface_.positions.size()) - 1, false};
}

Patchwork::Piece Patchwork::part(const Piece& parent, const Middles& middles,
                                 const std::array<int, 3>& points) const {
  Piece result;
  result.source = parent.source;
  result.patch.ptex_face = parent.patch.ptex_face;
  for (std::size_t i = 0; i < 3; ++i) {
    const bool is_corner = points[i] < 3;
    const int k = is_corner ? points[i] : points[i] - 3, n = next_corner(k);
    result.vertices[i] = is_corner ? parent.vertices[idx(k)] : middles[idx(k)].vertex;
    const bool flipped = is_corner ? parent.flips >> k & 1 : middles[idx(k)].flipped;
    result.flips |= flipped ? 1 << i : 0;
    result.weights[i] = is_corner ? parent.weights[idx(k)]
                                  : Vec2((parent.weights[idx(k)] + parent.weights[idx(n)]) / 2);
    const auto &a = parent.patch.corners[idx(k)], &b = parent.patch.corners[idx(n)];
    result.patch.corners[i] =
        is_corner ? a : std::array<std::uint16_t, 2>{mean(a[0], b[0]), mean(a[1], b[1])};
  }
  return result;
}

bool Patchwork::Cutting::is_cut(int piece) const {
  const Middles& m = middles[idx(piece)];
  return std::any_of(m.begin(), m.end(), [](const Middle& edge) { return edge.vertex != none; });
}

// Puts the parts of a piece in its place and at the end, and joins them with what is beside them.
void Patchwork::replace(int piece, Cutting& cutting) {
  const Piece parent = pieces_[idx(piece)];
  const Middles& middles = cutting.middles[idx(piece)];
  std::array<bool, 3> has_middle{};
  for (std::size_t k = 0; k < 3; ++k) has_middle[k] = middles[k].vertex != none;
  int number = piece;
  for (const Part& points : parts_of(has_middle)) {
    pieces_.resize(std::max(pieces_.size(), idx(number) + 1));
    pieces_[idx(number)] = part(parent, middles, points);
    for (int k = 0; k < 3; ++k) {
      place_side(piece, parent, {points[idx(k)], points[idx(next_corner(k))]}, {number, k},
                 cutting);
    }
    number = static_cast<int>(pieces_.size());
  }
}

// The side of a part that runs between these points of the old piece.
void Patchwork::place_side(int piece, const Piece& parent, const std::array<int, 2>& points,
                           const EdgeSide& part, Cutting& cutting) {
  const ParentEdge side = parent_edge(points[0], points[1]);
  std::array<int, 4> key{none, piece, std::min(points[0], points[1]),
                         std::max(points[0], points[1])};
  if (side.edge != none) {
    Piece& placed = pieces_[idx(part.triangle)];
    placed.kinds[idx(part.corner)] = parent.kinds[idx(side.edge)];
    const int beyond = placed.beyond[idx(part.corner)] = parent.beyond[idx(side.edge)];
    if (beyond != none) rim_.at(beyond) = 3 * part.triangle + part.corner;
    const int other = parent.neighbours[idx(side.edge)], mate = parent.mates[idx(side.edge)];
    if (other == none) return;
    if (!cutting.is_cut(other)) return join(part.triangle, part.corner, other, mate);
    // Both pieces name the edge by its two sides, and a half by the place that it touches.
    const int here = 3 * piece + side.edge, there = 3 * other + mate;
    const int end = side.half == 0 ? side.edge : next_corner(side.edge);
    const int touched = side.half == 2 ? none : surface_.places[idx(parent.vertices[idx(end)])];
    key = {std::min(here, there), std::max(here, there), side.half == 2, touched};
  }
  const int here = 3 * part.triangle + part.corner;
  const auto [met, is_first] = cutting.waiting.try_emplace(key, here);
  if (!is_first) join(part.triangle, part.corner, met->second / 3, met->second % 3);
}

void Patchwork::publish() {
  const std::size_t count = pieces_.size();
  surface_.triangles.resize(count);
  surface_.flips.resize(count);
  surface_.neighbours.resize(count);
  surface_.edge_kinds.resize(count);
  surface_.patches.resize(count);
  surface_.triangle_objects.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    const Piece& p = pieces_[i];
    surface_.triangles[i] = p.vertices;
    surface_.flips[i] = static_cast<std::uint8_t>(p.flips);
    surface_.neighbours[i] = p.neighbours;
    surface_.edge_kinds[i] = p.kinds;
    surface_.patches[i] = p.patch;
    surface_.triangle_objects[i] = whole_.object_of(p.source);
  }
}

Patchwork::Place Patchwork::on_whole(const SurfacePoint& on, int edge) const {
  const Piece& piece = pieces_[idx(on.triangle)];
  const auto& w = piece.weights;
  const Vec2 at = (1 - on.b1 - on.b2) * w[0] + on.b1 * w[1] + on.b2 * w[2];
  Place result{{piece.source, at.x(), at.y()}, none, 0};
  if (edge == none) return result;
  const auto weight = [](const Vec2& p, int corner) {
    return corner == 0 ? 1 - p.x() - p.y() : p[corner - 1];
  };
  for (int k = 0; k < 3; ++k) {
    const int opposite = previous_corner(k);
    if (weight(w[idx(edge)], opposite) != 0 || weight(w[idx(next_corner(edge))], opposite) != 0)
      continue;
    result.edge = k;
    result.fraction = weight(at, next_corner(k));
  }
  return result;
}

}  // namespace illustrate
