#include "mesh/polygon_mesh.h"

#include <cmath>
#include <limits>

#include "core/errors.h"

namespace illustrate {
namespace {

// Twice this many corners (a double cover) still have int indices.
constexpr std::size_t max_corners = std::numeric_limits<int>::max() / 2;

std::string entry(const char* argument, std::size_t index, long long value) {
  return std::string(argument) + "[" + std::to_string(index) + "] = " + std::to_string(value);
}

void check_length(const char* argument, std::size_t length, const char* of, std::size_t expected) {
  if (length == expected) return;
  throw InvalidInput("Length of " + std::string(argument) + " (" + std::to_string(length) +
                     ") must match the number of " + of + " (" + std::to_string(expected) + ")");
}

void check_index(const char* argument, std::size_t position, int index, const char* of,
                 std::size_t count) {
  if (index >= 0 && idx(index) < count) return;
  throw InvalidInput(entry(argument, position, index) + " is out of range: there are " +
                     std::to_string(count) + " " + of);
}

void check_edges(const char* argument, const std::vector<Edge>& edges, std::size_t vertices) {
  for (std::size_t i = 0; i < edges.size(); ++i)
    for (const int vertex : edges[i]) check_index(argument, i, vertex, "positions", vertices);
}

void check_faces(const PolygonMesh& mesh) {
  std::size_t corners = 0;
  for (std::size_t f = 0; f < mesh.face_sizes.size(); ++f) {
    if (mesh.face_sizes[f] < 0)
      throw InvalidInput(entry("face_sizes", f, mesh.face_sizes[f]) + " is negative");
    corners += idx(mesh.face_sizes[f]);
  }
  check_length("corner_vertices", mesh.corner_vertices.size(), "corners that face_sizes adds up to",
               corners);
  if (corners > max_corners || mesh.positions.size() > max_corners)
    throw InvalidInput("positions, corner_vertices: more than " + std::to_string(max_corners));
  for (std::size_t c = 0; c < corners; ++c)
    check_index("corner_vertices", c, mesh.corner_vertices[c], "positions", mesh.positions.size());
}

void check_reflectance(const Reflectance& given, std::size_t faces, std::size_t corners) {
  if (!given.faces.empty()) check_length("reflectance", given.faces.size(), "faces", faces);
  if (!given.corners.empty()) {
    check_length("reflectance", given.corners.size(), "corners", corners);
  }
  if (!given.uv.empty()) check_length("uv", given.uv.size(), "corners", corners);
  if (given.face_textures.empty()) return;
  check_length("face_textures", given.face_textures.size(), "faces", faces);
  if (given.uv.empty()) throw InvalidInput("face_textures need uv");
  for (std::size_t f = 0; f < faces; ++f) {
    if (given.face_textures[f] == none) continue;
    check_index("face_textures", f, given.face_textures[f], "textures", given.textures.size());
  }
}

void check_settings(const PolygonMesh& mesh) {
  if (!(mesh.crease_angle_deg >= 0 && mesh.crease_angle_deg <= 180))
    throw InvalidInput("crease_angle_deg = " + std::to_string(mesh.crease_angle_deg) +
                       " must be between 0 and 180");
  if (mesh.level && *mesh.level < -1)
    throw InvalidInput("level = " + std::to_string(*mesh.level) +
                       " must be -1 (automatic) or more");
  if (mesh.edge_length && !(*mesh.edge_length >= 0 && std::isfinite(*mesh.edge_length)))
    throw InvalidInput("edge_length = " + std::to_string(*mesh.edge_length) +
                       " must be 0 (automatic) or a positive length");
}

}  // namespace

void validate(const PolygonMesh& mesh) {
  const std::size_t vertices = mesh.positions.size(), faces = mesh.face_sizes.size();
  check_faces(mesh);
  check_edges("edge_vertices", mesh.edge_vertices, vertices);
  check_edges("marked_edges", mesh.marked_edges, vertices);
  check_edges("loose_edges", mesh.loose_edges, vertices);
  check_length("edge_sharpness", mesh.edge_sharpness.size(), "rows of edge_vertices",
               mesh.edge_vertices.size());
  if (!mesh.vertex_sharpness.empty())
    check_length("vertex_sharpness", mesh.vertex_sharpness.size(), "positions", vertices);
  if (!mesh.face_materials.empty())
    check_length("face_materials", mesh.face_materials.size(), "faces", faces);
  if (!mesh.corner_normals.empty())
    check_length("corner_normals", mesh.corner_normals.size(), "corners",
                 mesh.corner_vertices.size());
  check_reflectance(mesh.reflectance, faces, mesh.corner_vertices.size());
  for (std::size_t i = 0; i < mesh.hole_faces.size(); ++i)
    check_index("hole_faces", i, mesh.hole_faces[i], "faces", faces);
  check_settings(mesh);
}

}  // namespace illustrate
