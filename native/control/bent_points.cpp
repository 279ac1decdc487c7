#include "control/bent_points.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "control/pieces.h"
#include "control/smoothstep.h"
#include "control/split_values.h"
#include "core/pi.h"
#include "mesh/edge_table.h"
#include "mesh/polygons.h"

namespace illustrate {
namespace {

// A quarter of a circle has .207 of its chord: what bends more is no coarse curve.
constexpr double largest_sag = 0.2;

// Of the way to where a piece of a face beside a sharp edge turns over, how much its sag may take
// if nothing of the piece would be left; it is free where half of it is.
constexpr double share_of_room = 0.5, free_from = 0.5;

// What goes on behind an end for less than the first share of an edge turns by itself, and the edge
// stays straight; for more than the second the edge has its part of the turn.
constexpr double turns_itself = 1.0 / 16, turns_with_edge = 0.25;

// The sag of a circular arc over a chord of length 1 that it leaves at an angle with this sine:
// half of the half angle's tangent. `side`: where the arc lies, any length, across the chord.
Vec3 arc_sag(double sine, const Vec3& side) {
  const double cosine = std::sqrt(std::max(0., 1 - sine * sine));
  return sine / (1 + cosine) / 2 * unit_or_zero(side);
}

// At an end with this unit normal, of an edge that leaves it along the unit vector `away`.
Vec3 sag_of_normal(const Vec3& normal, const Vec3& away) {
  const double sine = -away.dot(normal);
  return arc_sag(sine, normal + sine * away);
}

// At an end with this unit tangent, away from it.
Vec3 sag_of_tangent(const Vec3& tangent, const Vec3& away) {
  const double cosine = tangent.dot(away);
  const Vec3 side = tangent - cosine * away;
  return cosine > 0 ? arc_sag(side.norm(), side) : Vec3(Vec3::Zero());
}

// Their mean where they are the same, none where one is none or they point to opposite sides.
Vec3 harmonic_mean(const Vec3& a, const Vec3& b) {
  const double sum = a.norm() + b.norm();
  return sum > 0 ? Vec3((b.norm() * a + a.norm() * b) / sum) : Vec3(Vec3::Zero());
}

Vec3 lesser(const Vec3& a, const Vec3& b) {
  if (!(a.dot(b) > 0)) return Vec3::Zero();
  return a.squaredNorm() <= b.squaredNorm() ? a : b;
}

class Bender {
 public:
  Bender(const SoundMesh& parent, const HalfEdges& edges, const VertexSectors& sectors,
         Scheme scheme)
      : p_(parent.positions),
        parent_(parent),
        edges_(edges),
        faces_(edges.faces),
        sectors_(sectors),
        normals_(fan_normals(parent, edges, sectors)),
        quads_(scheme == Scheme::catmull_clark),
        neighbours_(crease_neighbours(edges, parent.positions.size())) {}

  Points run() {
    for (const int h : edges_.first) sags_.push_back(sag(h));
    leave_room();
    return points();
  }

 private:
  const Vec3& start(int h) const { return p_[idx(faces_.corners[idx(h)])]; }
  const Vec3& end(int h) const { return p_[idx(faces_.head(h))]; }
  bool is_held(int vertex) const {
    return parent_.vertex_sharpness[idx(vertex)] >= infinitely_sharp;
  }
  bool is_tip(int vertex) const {
    return is_held(vertex) && sectors_.sharp_edges[idx(vertex)] == 0;
  }
  // Or on a border.
  bool is_on_crease(int vertex) const { return sectors_.sharp_edges[idx(vertex)] > 0; }

  Points points() const {
    Points points = p_;
    for (std::size_t e = 0; e < sags_.size(); ++e) {
      const int h = edges_.first[e];
      points.push_back((start(h) + end(h)) / 2 + sags_[e]);
    }
    for (int f = 0; quads_ && f < faces_.size(); ++f) points.push_back(face_point(f));
    return points;
  }

  Vec3 sag(int h) const {
    const Vec3 along = end(h) - start(h);
    const double length = along.norm();
    const Vec3 away = unit_or_zero(along);
    Vec3 bend = edges_.is_sharp(h) ? sag_of_crease(h, away) : sag_of_smooth(h, away);
    const double size = bend.norm();
    if (size > largest_sag) bend *= largest_sag / size;
    return length * bend;
  }

  bool is_bent_crease(int h) const {
    return edges_.is_sharp(h) && !sags_[idx(edges_.edges[idx(h)])].isZero();
  }

  // Sags of sharp edges that would turn pieces of the faces beside them over, which the sags of the
  // other edges do not make up for: within these faces they get no longer than there is room. Both
  // sides of a seam have the same sag, and know one face each.
  void leave_room() {
    const auto is_bent = [&](int h) { return is_bent_crease(h); };
    if (std::none_of(edges_.first.begin(), edges_.first.end(), is_bent)) return;
    const std::vector<double> kept = shares_kept();
    const EdgeTable seams(p_.size(), parent_.seams);
    for (std::size_t e = 0; e < sags_.size(); ++e) {
      const int h = edges_.first[e];
      const bool is_seam = seams.find(faces_.corners[idx(h)], faces_.head(h)) != none;
      if (is_seam || !is_bent_crease(h)) continue;
      for (const int side : {h, edges_.mates[idx(h)]}) {
        if (side == none) continue;
        sags_[e] *= share_with_room(side, sags_[e], kept[idx(faces_.corner_faces[idx(side)])]);
      }
    }
  }

  double share_with_room(int h, const Vec3& sag, double kept) const {
    const double crowded = 1 - smoothstep(0, free_from, kept);
    if (crowded == 0) return 1;
    const Vec3 normal = end_normal(normals_.geometric, h, faces_.next(h));
    const double within = (sag - sag.dot(normal) * normal).norm();
    const double most = room(h, unit_or_zero(end(h) - start(h)));
    return within > most ? 1 + crowded * (most / within - 1) : 1;
  }

  // (f) of their area, by the piece that keeps least.
  std::vector<double> shares_kept() const {
    const Points bent = points(), normals = unit_normals(faces_, p_);
    Points level = p_;
    append_means(edges_, bent.size(), level);
    std::vector<double> shares(idx(faces_.size()), 1);
    for (int f = 0; f < faces_.size(); ++f) {
      double& least = shares[idx(f)];
      for_each_piece(edges_, static_cast<int>(p_.size()), quads_, f, [&](int a, int b, int c) {
        least = std::min(least, share_kept(level, bent, normals[idx(f)], a, b, c));
      });
    }
    return shares;
  }

  // How far the middle of an edge, which runs along `away`, may move within its face, so that no
  // triangle that the face is split into turns over: half of the way to the nearest line, which is
  // that of another edge, or the one between the middles of the others.
  double room(int h, const Vec3& away) const {
    const Vec3 middle = (start(h) + end(h)) / 2;
    double farthest = 0, nearest = std::numeric_limits<double>::max();
    for (int other = faces_.next(h); other != h; other = faces_.next(other)) {
      farthest = std::max(farthest, away.cross(end(other) - middle).norm());
      nearest = std::min(
          nearest, unit_or_zero(end(other) - start(other)).cross(middle - start(other)).norm());
    }
    return share_of_room * std::min(nearest, farthest / 2);
  }

  Vec3 sag_of_crease(int h, const Vec3& away) const {
    const int tail = faces_.corners[idx(h)], head = faces_.head(h);
    return (sag_of_crease_at(tail, head, away) + sag_of_crease_at(head, tail, -away)) / 2;
  }

  // At a vertex of a crease's edge, which runs away from it to `other`: none where the crease does
  // not pass.
  Vec3 sag_of_crease_at(int vertex, int other, const Vec3& away) const {
    if (sectors_.sharp_edges[idx(vertex)] != 2 || is_held(vertex)) return Vec3::Zero();
    const auto [first, second] = neighbours_[idx(vertex)];
    const Vec3& behind = p_[idx(first == other ? second : first)];
    const Vec3 &here = p_[idx(vertex)], &there = p_[idx(other)];
    const Vec3 tangent = unit_or_zero(there - behind);
    return share_of_turn((behind - here).norm(), (there - here).norm()) *
           sag_of_tangent(tangent.dot(away) < 0 ? Vec3(-tangent) : tangent, away);
  }

  // Both faces of an edge see the normal of the sector that it lies in, but at the end of a crease.
  Vec3 sag_of_smooth(int h, const Vec3& away) const {
    const int mate = edges_.mates[idx(h)];
    const double share_at_start = share_of_turn(h), share_at_end = share_of_turn(mate);
    const auto bend = [&](const Points& normals) -> Vec3 {
      const Vec3 at_start = end_normal(normals, h, faces_.next(mate));
      const Vec3 at_end = end_normal(normals, mate, faces_.next(h));
      const Vec3 first = share_at_start * sag_of_normal(at_start, away);
      const Vec3 second = share_at_end * sag_of_normal(at_end, -away);
      if (is_tip(faces_.corners[idx(h)])) return second;
      if (is_tip(faces_.head(h))) return first;
      const bool is_inside = !is_on_crease(faces_.corners[idx(h)]) && !is_on_crease(faces_.head(h));
      return is_inside ? harmonic_mean(first, second) : Vec3((first + second) / 2);
    };
    return lesser(bend(normals_.shading), bend(normals_.geometric));
  }

  // How much of a turn at its end an edge takes part in, by how far what is smooth goes on there.
  static double share_of_turn(double behind, double length) {
    return length > 0 ? smoothstep(turns_itself, turns_with_edge, behind / length) : 0;
  }

  // At the start of a half-edge within the smooth surface.
  double share_of_turn(int h) const {
    if (sectors_.sharp_edges[idx(faces_.corners[idx(h)])] > 1) return 1;
    const Vec3 along = end(h) - start(h);
    double reach = 0;
    for (const int corner : sectors_.corners[idx(sectors_.corner_sectors[idx(h)])])
      for (const int vertex : faces_[faces_.corner_faces[idx(corner)]])
        reach = std::max(reach, along.dot(start(h) - p_[idx(vertex)]));
    return share_of_turn(reach, along.squaredNorm());
  }

  static Vec3 end_normal(const Points& normals, int corner, int other) {
    return unit_or_zero(normals[idx(corner)] + normals[idx(other)]);
  }

  // Where the sphere through the edges' arcs has the middle of a regular polygon: the polygon's
  // height of arc is 1 / sin^2(pi / n) times that of its sides. That of a quad is where Coons'
  // patch of its sides has it, also within its plane: a narrow strip bends along with its borders.
  Vec3 face_point(int face) const {
    constexpr double most_sides = 6;  // beyond it sags of sides say little about the middle
    Vec3 mean = Vec3::Zero(), sag = Vec3::Zero(), normal = Vec3::Zero();
    const auto n = static_cast<double>(faces_[face].size());
    for (int h = faces_.offsets[idx(face)]; h < faces_.offsets[idx(face) + 1]; ++h) {
      mean += start(h) / n;
      sag += sags_[idx(edges_.edges[idx(h)])] / n;
      normal += normals_.geometric[idx(h)];
    }
    if (n == 4) return mean + 2 * sag;
    normal = unit_or_zero(normal);
    const double sine = std::sin(pi / std::min(n, most_sides));
    return mean + sag + (1 / (sine * sine) - 1) * normal.dot(sag) * normal;
  }

  const Points& p_;
  const SoundMesh& parent_;
  const HalfEdges& edges_;
  const Faces& faces_;
  const VertexSectors& sectors_;
  const FanNormals normals_;
  const bool quads_;
  const std::vector<Edge> neighbours_;  // (n) crease_neighbours'
  Points sags_;                         // (e)
};

}  // namespace

Points bent_points(const SoundMesh& parent, const HalfEdges& edges, const VertexSectors& sectors,
                   Scheme scheme) {
  return Bender(parent, edges, sectors, scheme).run();
}

}  // namespace illustrate
