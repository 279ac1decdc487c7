#include "tests/fuzz/nasty_mesh.h"

#include <cmath>

#include "tests/cpp/shapes.h"
#include "tests/fuzz/mutations.h"

namespace illustrate::fuzz {
namespace {

PolygonMesh soup(Random& random) {
  PolygonMesh mesh;
  for (int v = random.below(40); v >= 0; --v)
    mesh.positions.push_back(Vec3{std::floor(random.between(0, 4)),
                                  std::floor(random.between(0, 4)),
                                  std::floor(random.between(0, 3))});
  for (int f = random.below(60); f > 0; --f) {
    std::vector<int> face(static_cast<std::size_t>(random.below(7)));
    for (int& v : face) v = random.below(mesh.positions.size());
    shapes::add_face(mesh, face);
  }
  return mesh;
}

// A polygon of any number of corners, and its prism.
PolygonMesh prism(Random& random) {
  const int n = 3 + random.below(random.one_in(4) ? 400 : 20);
  const double dent = random.one_in(2) ? 0 : random.between(0.2, 0.9);
  PolygonMesh mesh;
  std::vector<int> bottom, top;
  for (int i = 0; i < n; ++i) {
    const double radius = 1 - (i % 2) * dent, angle = 2 * pi * i / n;
    for (const double z : {0.0, 1.0})
      mesh.positions.emplace_back(radius * std::cos(angle), radius * std::sin(angle), z);
    const int next = (i + 1) % n;
    shapes::add_face(mesh, {2 * i, 2 * next, 2 * next + 1, 2 * i + 1});
    bottom.insert(bottom.begin(), 2 * i);
    top.push_back(2 * i + 1);
  }
  shapes::add_face(mesh, bottom);
  shapes::add_face(mesh, top);
  return mesh;
}

// Faces of their own, next to each other nearly.
PolygonMesh patches(const PolygonMesh& mesh, Random& random) {
  PolygonMesh loose = shapes::unwelded(mesh);
  for (Vec3& position : loose.positions) position += Vec3::Constant(random.between(0, 1e-4));
  return loose;
}

PolygonMesh any_shape(Random& random) {
  const int m = random.below(9), n = random.below(7);
  switch (random.below(15)) {
    case 0:
      return {};
    case 1:
      return soup(random);
    case 2:
      return prism(random);
    case 3:
      return shapes::cube();
    case 4:
      return shapes::tetrahedron();
    case 5:
      return shapes::octahedron();
    case 6:
      return shapes::icosphere_mesh(1, n / 3);
    case 7:
      return shapes::uv_sphere_mesh(1, 3 + m, 2 + n);
    case 8:
      return shapes::torus_mesh(2, 0.7, 3 + m, 3 + n);
    case 9:
      return shapes::plane(1 + m, 1 + n);
    case 10:
      return shapes::moebius_mesh(3 + m, 1 + n / 2);
    case 11:
      return shapes::klein_mesh(4 + m, 4 + n);
    case 12:
      return shapes::split_triangles(shapes::torus_mesh(2, 0.7, 3 + m, 3 + n));
    case 13:
      return patches(shapes::plane(1 + m, 1 + n), random);
    default:
      return shapes::unwelded(shapes::cube());
  }
}

LooseMesh loosened(const PolygonMesh& mesh) {
  LooseMesh loose{mesh.positions, {}};
  const int* corner = mesh.corner_vertices.data();
  for (const int size : mesh.face_sizes) {
    loose.faces.emplace_back(corner, corner + size);
    corner += size;
  }
  return loose;
}

double any_sharpness(Random& random) {
  return random.one_in(3) ? nasty_number(random) : random.between(-1, 12);
}

// Edges of faces mostly, else any two vertices.
Edge any_edge(const PolygonMesh& mesh, Random& random) {
  const int c = random.below(mesh.corner_vertices.size());
  const bool is_known = !mesh.corner_vertices.empty() && !random.one_in(5);
  if (!is_known) return {random.below(mesh.positions.size()), random.below(mesh.positions.size())};
  const std::size_t next = (static_cast<std::size_t>(c) + 1) % mesh.corner_vertices.size();
  return {mesh.corner_vertices[static_cast<std::size_t>(c)], mesh.corner_vertices[next]};
}

void add_creases(PolygonMesh& mesh, Random& random) {
  const bool all_same = random.one_in(3);
  const double sharpness = any_sharpness(random);
  for (int e = random.below(random.one_in(4) ? 200 : 12); e > 0; --e) {
    mesh.edge_vertices.push_back(any_edge(mesh, random));
    mesh.edge_sharpness.push_back(all_same ? sharpness : any_sharpness(random));
  }
}

void add_corners(PolygonMesh& mesh, Random& random) {
  for (std::size_t v = 0; v < mesh.positions.size(); ++v)
    mesh.vertex_sharpness.push_back(random.one_in(4) ? any_sharpness(random) : 0);
}

// What edges, vertices and faces carry.
void add_attributes(PolygonMesh& mesh, Random& random) {
  if (!mesh.positions.empty() && random.one_in(2)) add_creases(mesh, random);
  if (random.one_in(4)) add_corners(mesh, random);
  if (!mesh.positions.empty() && random.one_in(4))
    for (int e = random.below(12); e > 0; --e) mesh.marked_edges.push_back(any_edge(mesh, random));
  const std::size_t faces = mesh.face_sizes.size();
  if (random.one_in(4))
    for (std::size_t f = 0; f < faces; ++f) mesh.face_materials.push_back(random.below(3) - 1);
  if (faces > 0 && random.one_in(4))
    for (int h = random.below(random.one_in(4) ? 2 * faces : 4); h > 0; --h)
      mesh.hole_faces.push_back(random.below(faces));
}

// Any directions, some of them none; or one direction, as a flat surface has it.
void add_normals(PolygonMesh& mesh, Random& random) {
  if (random.one_in(4)) {
    mesh.corner_normals.assign(mesh.corner_vertices.size(), Vec3(0, 0, 1));
    return;
  }
  const double odd = random.one_in(2) ? std::nan("") : 0;
  for (std::size_t c = 0; c < mesh.corner_vertices.size(); ++c) {
    const double x = random.one_in(20) ? odd : random.between(-1, 1);
    mesh.corner_normals.emplace_back(x, random.below(3) - 1, random.below(3) - 1);
  }
}

void choose_settings(PolygonMesh& mesh, Random& random) {
  mesh.cage = random.one_in(2);
  if (random.one_in(3)) add_normals(mesh, random);
  mesh.boundary = random.one_in(2) ? BoundaryRule::corners : BoundaryRule::edges;
  if (random.one_in(3)) mesh.crease_angle_deg = random.below(181);
  mesh.scheme = random.of(std::vector<Scheme>{Scheme::automatic, Scheme::catmull_clark,
                                              Scheme::loop, Scheme::polygons});
  mesh.level = random.below(random.one_in(8) ? 3 : 2);
  if (random.one_in(8)) mesh.level = -1;
  if (random.one_in(8)) mesh.edge_length = random.between(0, 1);
}

}  // namespace

PolygonMesh nasty_mesh(Random& random) {
  PolygonMesh shape = any_shape(random);
  if (random.one_in(4)) {
    const Vec3 offset(random.between(-2, 2), 0, 0);
    shape = shapes::joined(shape, shapes::moved(any_shape(random), offset));
  }
  LooseMesh loose = loosened(shape);
  for (int i = random.below(7); i > 0; --i) random.of(mutations())(loose, random);
  PolygonMesh mesh = shapes::polygon_mesh(std::move(loose.positions), loose.faces);
  add_attributes(mesh, random);
  choose_settings(mesh, random);
  return mesh;
}

}  // namespace illustrate::fuzz
