#include "tests/fuzz/mutations.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace illustrate::fuzz {
namespace {

using Face = std::vector<int>;

Face no_face;

Face& any_face(LooseMesh& mesh, Random& random) {
  if (mesh.faces.empty()) return no_face = {};
  return mesh.faces[static_cast<std::size_t>(random.below(mesh.faces.size()))];
}

int any_vertex(const LooseMesh& mesh, Random& random) {
  return random.below(mesh.positions.size());
}

int add_vertex(LooseMesh& mesh, const Vec3& position) {
  mesh.positions.push_back(position);
  return static_cast<int>(mesh.positions.size()) - 1;
}

Vec3 any_point(Random& random) {
  return {random.between(-2, 2), random.between(-2, 2), random.between(-2, 2)};
}

Face any_polygon(const LooseMesh& mesh, std::size_t corners, Random& random) {
  Face face;
  for (std::size_t k = 0; k < corners && !mesh.positions.empty(); ++k)
    face.push_back(any_vertex(mesh, random));
  return face;
}

// An edge of a face, as its corner k and the next.
struct Side {
  Face& face;
  std::size_t k;
  int from() const { return face[k]; }
  int to() const { return face[(k + 1) % face.size()]; }
};

Side any_side(LooseMesh& mesh, Random& random) {
  Face& face = any_face(mesh, random);
  return {face, static_cast<std::size_t>(random.below(face.size()))};
}

// --- faces

void repeat_corner(LooseMesh& mesh, Random& random) {
  Face& face = any_face(mesh, random);
  if (face.empty()) return;
  const int vertex = random.of(face);
  face.insert(face.begin() + random.below(face.size()), vertex);
}

void change_corner(LooseMesh& mesh, Random& random) {
  Face& face = any_face(mesh, random);
  if (!face.empty())
    face[static_cast<std::size_t>(random.below(face.size()))] = any_vertex(mesh, random);
}

void drop_corner(LooseMesh& mesh, Random& random) {
  Face& face = any_face(mesh, random);
  if (!face.empty()) face.erase(face.begin() + random.below(face.size()));
}

void swap_corners(LooseMesh& mesh, Random& random) {
  Face& face = any_face(mesh, random);
  if (!face.empty())
    std::swap(face[static_cast<std::size_t>(random.below(face.size()))], face.front());
}

void flip_face(LooseMesh& mesh, Random& random) {
  Face& face = any_face(mesh, random);
  std::reverse(face.begin(), face.end());
}

void flip_all(LooseMesh& mesh, Random&) {
  for (Face& face : mesh.faces) std::reverse(face.begin(), face.end());
}

void duplicate_face(LooseMesh& mesh, Random& random) {
  Face face = any_face(mesh, random);
  if (face.empty()) return;
  std::rotate(face.begin(), face.begin() + random.below(face.size()), face.end());
  if (random.one_in(2)) std::reverse(face.begin(), face.end());
  mesh.faces.push_back(std::move(face));
}

void drop_faces(LooseMesh& mesh, Random& random) {
  for (int i = random.below(4); i >= 0 && !mesh.faces.empty(); --i)
    mesh.faces.erase(mesh.faces.begin() + random.below(mesh.faces.size()));
}

void add_tiny_face(LooseMesh& mesh, Random& random) {
  mesh.faces.push_back(any_polygon(mesh, static_cast<std::size_t>(random.below(3)), random));
}

void add_polygon(LooseMesh& mesh, Random& random) {
  const int corners = 3 + random.below(random.one_in(8) ? 300 : 9);
  mesh.faces.push_back(any_polygon(mesh, static_cast<std::size_t>(corners), random));
}

// Two faces over a common edge become one.
void merge_faces(LooseMesh& mesh, Random& random) {
  const Side side = any_side(mesh, random);
  if (side.face.empty()) return;
  for (Face& other : mesh.faces) {
    const auto found = std::find(other.begin(), other.end(), side.to());
    if (&other == &side.face || found == other.end()) continue;
    std::rotate(other.begin(), found, other.end());
    const Face more(other.begin() + 1, other.end());
    other.clear();
    side.face.insert(side.face.begin() + static_cast<std::ptrdiff_t>(side.k) + 1, more.begin(),
                     more.end());
    return;
  }
}

// A hole in a face, joined to its first corner by a bridge.
void bridge_hole(LooseMesh& mesh, Random& random) {
  Face& face = any_face(mesh, random);
  if (face.size() < 3) return;
  Vec3 middle = Vec3::Zero();
  for (const int v : face) middle += mesh.positions[static_cast<std::size_t>(v)] / face.size();
  const double size = random.between(0.1, 1.2);
  Face hole;
  for (std::size_t k = face.size(); k-- > 0;)
    hole.push_back(add_vertex(
        mesh, middle + size * (mesh.positions[static_cast<std::size_t>(face[k])] - middle)));
  hole.push_back(hole.front());
  face.push_back(face.front());
  face.insert(face.end(), hole.begin(), hole.end());
}

// --- how faces meet

void add_fin(LooseMesh& mesh, Random& random) {
  const Side side = any_side(mesh, random);
  if (side.face.empty()) return;
  const int a = side.from(), b = side.to();
  for (int i = random.below(5); i >= 0; --i)
    mesh.faces.push_back({a, b, add_vertex(mesh, any_point(random))});
}

void add_cone(LooseMesh& mesh, Random& random) {
  if (mesh.positions.empty()) return;
  const int apex = any_vertex(mesh, random), count = 3 + random.below(random.one_in(6) ? 400 : 12);
  const int first = static_cast<int>(mesh.positions.size());
  for (int i = 0; i < count; ++i)
    mesh.positions.emplace_back(std::cos(6.283185307 * i / count),
                                std::sin(6.283185307 * i / count), random.between(-0.2, 0.2));
  for (int i = 0; i < count; ++i) mesh.faces.push_back({apex, first + i, first + (i + 1) % count});
}

// Only one of the faces at an edge knows of the vertex in its middle.
void add_t_junction(LooseMesh& mesh, Random& random) {
  const Side side = any_side(mesh, random);
  if (side.face.empty()) return;
  const Vec3 middle = (mesh.positions[static_cast<std::size_t>(side.from())] +
                       mesh.positions[static_cast<std::size_t>(side.to())]) /
                      2;
  side.face.insert(side.face.begin() + static_cast<std::ptrdiff_t>(side.k) + 1,
                   add_vertex(mesh, middle));
}

// Two vertices become one: pinches, edges of many faces, collapsed faces.
void merge_vertices(LooseMesh& mesh, Random& random) {
  const int from = any_vertex(mesh, random), to = any_vertex(mesh, random);
  for (Face& face : mesh.faces) std::replace(face.begin(), face.end(), from, to);
}

void tear_face(LooseMesh& mesh, Random& random) {
  for (int& v : any_face(mesh, random))
    v = add_vertex(mesh, Vec3(mesh.positions[static_cast<std::size_t>(v)]));
}

void tear_all(LooseMesh& mesh, Random&) {
  for (Face& face : mesh.faces)
    for (int& v : face) v = add_vertex(mesh, Vec3(mesh.positions[static_cast<std::size_t>(v)]));
}

void twist(LooseMesh& mesh, Random& random) {
  const Side a = any_side(mesh, random), b = any_side(mesh, random);
  if (a.face.empty() || b.face.empty()) return;
  mesh.faces.push_back({a.from(), a.to(), b.from(), b.to()});
}

// --- where vertices are

void spoil_coordinate(LooseMesh& mesh, Random& random) {
  if (mesh.positions.empty()) return;
  mesh.positions[static_cast<std::size_t>(any_vertex(mesh, random))][random.below(3)] =
      nasty_number(random);
}

void move_onto_another(LooseMesh& mesh, Random& random) {
  if (mesh.positions.empty()) return;
  mesh.positions[static_cast<std::size_t>(any_vertex(mesh, random))] =
      Vec3(mesh.positions[static_cast<std::size_t>(any_vertex(mesh, random))]);
}

void flatten(LooseMesh& mesh, Random& random) {
  const int axis = random.below(3);
  const double height = random.one_in(2) ? 0 : random.between(-1, 1);
  for (Vec3& p : mesh.positions) p[axis] = height;
}

void collapse(LooseMesh& mesh, Random& random) {
  if (mesh.positions.empty()) return;
  const Vec3 point = random.of(mesh.positions);
  for (Vec3& p : mesh.positions)
    if (random.one_in(3)) p = point;
}

void scale(LooseMesh& mesh, Random& random) {
  const double factor = std::pow(10.0, random.between(-170, 150));
  for (Vec3& p : mesh.positions) p *= factor;
}

void squeeze(LooseMesh& mesh, Random& random) {
  const int axis = random.below(3);
  const double factor = std::pow(10.0, random.between(-20, 20));
  for (Vec3& p : mesh.positions) p[axis] *= factor;
}

void move_far(LooseMesh& mesh, Random& random) {
  const Vec3 offset = any_point(random) * std::pow(10.0, random.between(0, 20));
  for (Vec3& p : mesh.positions) p += offset;
}

void jitter(LooseMesh& mesh, Random& random) {
  const double size = std::pow(10.0, random.between(-16, 0));
  for (Vec3& p : mesh.positions) p += size * any_point(random);
}

void snap(LooseMesh& mesh, Random&) {
  for (Vec3& p : mesh.positions) p = p.array().round();
}

void add_isolated_vertices(LooseMesh& mesh, Random& random) {
  for (int i = random.below(5); i >= 0; --i) add_vertex(mesh, any_point(random));
}

}  // namespace

const std::vector<Mutation>& mutations() {
  static const std::vector<Mutation> all{repeat_corner,
                                         change_corner,
                                         drop_corner,
                                         swap_corners,
                                         flip_face,
                                         flip_all,
                                         duplicate_face,
                                         drop_faces,
                                         add_tiny_face,
                                         add_polygon,
                                         merge_faces,
                                         bridge_hole,
                                         add_fin,
                                         add_cone,
                                         add_t_junction,
                                         merge_vertices,
                                         tear_face,
                                         tear_all,
                                         twist,
                                         spoil_coordinate,
                                         move_onto_another,
                                         flatten,
                                         collapse,
                                         scale,
                                         squeeze,
                                         move_far,
                                         jitter,
                                         snap,
                                         add_isolated_vertices};
  return all;
}

double nasty_number(Random& random) {
  using Limits = std::numeric_limits<double>;
  return random.of(std::vector<double>{
      Limits::quiet_NaN(), Limits::infinity(), -Limits::infinity(), Limits::max(), -1e151, 1e149,
      1e100, -1e20, 1e-20, 1e-100, -1e-200, Limits::min(), Limits::denorm_min(), 0.0, -0.0, -1});
}

}  // namespace illustrate::fuzz
