#include "control/split_faces.h"

#include <algorithm>

#include "mesh/edge_table.h"
#include "mesh/polygons.h"

namespace illustrate {
namespace {

// A diagonal with its smaller vertex first, and its face.
struct Diagonal {
  Edge ends;
  int face;
  bool operator<(const Diagonal& d) const { return ends != d.ends ? ends < d.ends : face < d.face; }
};

class FaceSplitter {
 public:
  explicit FaceSplitter(const SoundMesh& mesh)
      : mesh_(mesh), offsets_(face_offsets(mesh.face_sizes)), triangles_(mesh.face_sizes.size()) {}

  SoundMesh run() {
    for (int f = 0; f < faces(); ++f) triangles_[idx(f)] = split(f);
    const std::vector<std::uint8_t> clash = clashes();
    result_ = mesh_;
    for (int f = 0; f < faces(); ++f) {
      if (clash[idx(f)]) add_star(f);
    }
    link_star_middles();
    set_faces();
    return std::move(result_);
  }

 private:
  int faces() const { return static_cast<int>(mesh_.face_sizes.size()); }
  int vertex(int face, int k) const { return mesh_.corner_vertices[idx(offsets_[idx(face)] + k)]; }
  int twin(int face) const { return mesh_.twin_faces.empty() ? none : mesh_.twin_faces[idx(face)]; }

  // Those of a twin are its partner's, mirrored.
  std::vector<Triangle> split(int face) const {
    const int other = twin(face);
    if (other == none || other > face) return split_itself(face);
    std::vector<Triangle> triangles = triangles_[idx(other)];
    for (Triangle& t : triangles) {
      for (int& v : t) v = mesh_.twin_vertices[idx(v)];
      std::swap(t[1], t[2]);
    }
    return triangles;
  }

  std::vector<Triangle> split_itself(int face) const {
    Points polygon;
    const int size = mesh_.face_sizes[idx(face)];
    for (int k = 0; k < size; ++k) polygon.push_back(mesh_.positions[idx(vertex(face, k))]);
    std::vector<Triangle> triangles = triangulate({polygon.data(), polygon.size()});
    for (Triangle& t : triangles) {
      for (int& corner : t) corner = vertex(face, corner);
    }
    return triangles;
  }

  std::vector<Edge> polygon_edges() const {
    std::vector<Edge> edges;
    for (int f = 0; f < faces(); ++f) {
      const int size = mesh_.face_sizes[idx(f)];
      for (int k = 0; k < size; ++k) edges.push_back({vertex(f, k), vertex(f, (k + 1) % size)});
    }
    return edges;
  }

  // Faces with a diagonal that must not be.
  std::vector<std::uint8_t> clashes() const {
    std::vector<std::uint8_t> clash(mesh_.face_sizes.size(), 0);
    const EdgeTable edges(mesh_.positions.size(), polygon_edges());
    std::vector<Diagonal> diagonals;
    for (int f = 0; f < faces(); ++f) add_diagonals(f, diagonals);
    std::sort(diagonals.begin(), diagonals.end());
    for (std::size_t i = 0; i < diagonals.size(); ++i) {
      const auto& [ends, face] = diagonals[i];
      if (edges.find(ends[0], ends[1]) != none) clash[idx(face)] = 1;
      if (i == 0 || diagonals[i - 1].ends != ends) continue;
      // In its own face a diagonal is there twice, once for each triangle beside it.
      if (diagonals[i - 1].face != face) clash[idx(face)] = clash[idx(diagonals[i - 1].face)] = 1;
    }
    return clash;
  }

  void add_diagonals(int face, std::vector<Diagonal>& diagonals) const {
    const int size = mesh_.face_sizes[idx(face)];
    if (size == 3) return;
    std::vector<Edge> sides;
    for (int k = 0; k < size; ++k) {
      sides.push_back(ordered(vertex(face, k), vertex(face, (k + 1) % size)));
    }
    std::sort(sides.begin(), sides.end());
    for (const Triangle& t : triangles_[idx(face)]) {
      for (int k = 0; k < 3; ++k) {
        const Edge edge = ordered(t[idx(k)], t[idx(next_corner(k))]);
        if (!std::binary_search(sides.begin(), sides.end(), edge))
          diagonals.push_back({edge, face});
      }
    }
  }

  static Edge ordered(int a, int b) { return {std::min(a, b), std::max(a, b)}; }

  void add_star(int face) {
    const int size = mesh_.face_sizes[idx(face)],
              middle = static_cast<int>(result_.positions.size());
    std::vector<Triangle>& triangles = triangles_[idx(face)];
    triangles.clear();
    Vec3 sum = Vec3::Zero();
    for (int k = 0; k < size; ++k) {
      sum += mesh_.positions[idx(vertex(face, k))] / size;
      triangles.push_back({middle, vertex(face, k), vertex(face, (k + 1) % size)});
    }
    result_.positions.push_back(sum);
    result_.source_vertices.push_back(none);
    if (!result_.vertex_sharpness.empty()) result_.vertex_sharpness.push_back(0);
    if (!result_.twin_vertices.empty()) result_.twin_vertices.push_back(none);
    stars_.push_back(face);
  }

  // A twin's star runs the other way round: its triangles are put in the order of its partner's.
  void link_star_middles() {
    for (const int face : stars_) {
      const int other = twin(face);
      if (other == none || other > face) continue;
      const std::vector<Triangle>& partner = triangles_[idx(other)];
      const int middle = triangles_[idx(face)][0][0], other_middle = partner[0][0];
      result_.twin_vertices[idx(middle)] = other_middle;
      result_.twin_vertices[idx(other_middle)] = middle;
      result_.positions[idx(middle)] = result_.positions[idx(other_middle)];
      for (std::size_t i = 0; i < partner.size(); ++i) {
        triangles_[idx(face)][i] = {middle, mesh_.twin_vertices[idx(partner[i][2])],
                                    mesh_.twin_vertices[idx(partner[i][1])]};
      }
    }
  }

  void set_faces() {
    std::vector<int> parents, first;  // face of each triangle, first triangle of each face
    result_.corner_vertices.clear();
    for (int f = 0; f < faces(); ++f) {
      first.push_back(static_cast<int>(parents.size()));
      for (const Triangle& t : triangles_[idx(f)]) {
        result_.corner_vertices.insert(result_.corner_vertices.end(), t.begin(), t.end());
        parents.push_back(f);
      }
    }
    result_.face_sizes.assign(parents.size(), 3);
    repeat(mesh_.source_faces, parents, result_.source_faces);
    repeat(mesh_.face_materials, parents, result_.face_materials);
    repeat(mesh_.holes, parents, result_.holes);
    repeat(mesh_.kept, parents, result_.kept);
    repeat(mesh_.twin_faces, parents, result_.twin_faces);
    set_corner_normals(parents);
    for (std::size_t t = 0; t < result_.twin_faces.size(); ++t) {
      int& other = result_.twin_faces[t];
      if (other != none) other = first[idx(other)] + static_cast<int>(t) - first[idx(parents[t])];
    }
  }

  // Of the triangles' corners; the middle of a star has the mean of the face's.
  void set_corner_normals(const std::vector<int>& parents) {
    if (mesh_.corner_normals.empty()) return;
    Points normals(result_.positions.size(), Vec3::Zero());  // of the face at hand
    result_.corner_normals.clear();
    int last = none;
    for (std::size_t c = 0; c < result_.corner_vertices.size(); ++c) {
      const int face = parents[c / 3];
      if (face != last) read_normals(face, normals);
      last = face;
      result_.corner_normals.push_back(normals[idx(result_.corner_vertices[c])]);
    }
  }

  void read_normals(int face, Points& normals) const {
    const int size = mesh_.face_sizes[idx(face)];
    Vec3 sum = Vec3::Zero();
    for (int k = 0; k < size; ++k) {
      const Vec3& normal = mesh_.corner_normals[idx(offsets_[idx(face)] + k)];
      normals[idx(vertex(face, k))] = normal;
      sum += normal;
    }
    const auto& triangles = triangles_[idx(face)];
    if (static_cast<int>(triangles.size()) == size)
      normals[idx(triangles[0][0])] = unit_or_zero(sum);
  }

  template <class T>
  static void repeat(const std::vector<T>& values, const std::vector<int>& parents,
                     std::vector<T>& result) {
    if (values.empty()) return;
    result.clear();
    for (const int parent : parents) result.push_back(values[idx(parent)]);
  }

  const SoundMesh& mesh_;
  std::vector<int> offsets_;
  std::vector<std::vector<Triangle>> triangles_;  // of each face, vertices
  std::vector<int> stars_;
  SoundMesh result_;
};

}  // namespace

SoundMesh split_into_triangles(SoundMesh mesh) {
  const bool all_triangles = std::all_of(mesh.face_sizes.begin(), mesh.face_sizes.end(),
                                         [](int size) { return size == 3; });
  return all_triangles ? mesh : FaceSplitter(mesh).run();
}

}  // namespace illustrate
