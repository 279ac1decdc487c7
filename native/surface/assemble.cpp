#include "surface/assemble.h"

#include <algorithm>

#include "surface/polygons.h"
#include "surface/shading.h"

namespace illustrate {
namespace {

class Assembler {
 public:
  Assembler(const RefinedObject& object, Surface& surface, std::vector<int>& needs_jet)
      : object_(object),
        mesh_(object.mesh),
        surface_(surface),
        needs_jet_(needs_jet),
        sector_corners_(object.limits.positions.size(), none),
        vertices_(object.limits.positions.size(), none),
        first_at_place_(object.mesh.points.size(), none),
        slots_(object.mesh.corner_vertices.size(), none) {}

  void run() {
    for (int f = 0; f < faces(); ++f) {
      if (!is_drawn(f)) continue;
      for (int c = mesh_.first(f); c < mesh_.first(f + 1); ++c) {
        int& corner = sector_corners_[idx(sector(c))];
        if (corner == none) corner = c;
      }
    }
    for (int f = 0; f < faces(); ++f) {
      if (is_drawn(f)) add_face(f);
    }
    surface_.triangle_objects.resize(surface_.triangles.size(), object_.object);
    for (int c = 0; c < static_cast<int>(slots_.size()); ++c) {
      if (slots_[idx(c)] != none) connect_edge(c);
    }
  }

 private:
  int faces() const { return static_cast<int>(mesh_.face_count()); }
  int sector(int corner) const { return object_.corner_sectors[idx(corner)]; }
  const Vec3& position(int corner) const { return object_.limits.positions[idx(sector(corner))]; }
  bool is_hole(int face) const {
    return !object_.base.holes.empty() && object_.base.holes[idx(mesh_.base_faces[idx(face)])];
  }
  bool is_drawn(int face) const {
    const std::vector<std::uint8_t>& kept = object_.base.kept;
    return !is_hole(face) && (kept.empty() || kept[idx(mesh_.base_faces[idx(face)])]);
  }

  // The sector that stands for this corner's on both sheets.
  int representative(int corner) const {
    if (mesh_.twin_faces.empty()) return sector(corner);
    const int twin = twin_corner(mesh_, corner);
    if (twin == none || sector_corners_[idx(sector(twin))] == none) return sector(corner);
    return std::min(sector(corner), sector(twin));
  }

  int vertex(int sector) {
    int& vertex = vertices_[idx(sector)];
    if (vertex == none) vertex = add_vertex(sector);
    return vertex;
  }

  int add_vertex(int sector) {
    const int corner = sector_corners_[idx(sector)];
    const int added = static_cast<int>(surface_.positions.size());
    const std::size_t s = idx(sector);
    surface_.positions.push_back(object_.limits.positions[s]);
    surface_.normals.push_back(object_.limits.normals[s]);
    surface_.objects.push_back(object_.object);
    surface_.places.push_back(place(mesh_.vertex(corner), added));
    const BasePlace base = base_place(mesh_, corner);
    const bool smooth = base.ptex_face != none;
    surface_.base_faces.push_back(smooth ? base.ptex_face + object_.first_ptex_face : none);
    surface_.base_uv.push_back(base.uv);
    surface_.curvature.k1.push_back(object_.limits.curvature.k1[s]);
    surface_.curvature.k2.push_back(object_.limits.curvature.k2[s]);
    surface_.curvature.w1.push_back(object_.limits.curvature.w1[s]);
    surface_.curvature.w2.push_back(object_.limits.curvature.w2[s]);
    if (object_.limits.needs_jet[s]) needs_jet_.push_back(added);
    return added;
  }

  // The first surface vertex at the same point.
  int place(int mesh_vertex, int added) {
    int key = place_of(mesh_, mesh_vertex);
    const int twin = mesh_.twin_vertices.empty() ? none : mesh_.twin_vertices[idx(mesh_vertex)];
    if (twin != none) key = std::min(key, place_of(mesh_, twin));
    if (idx(key) >= first_at_place_.size()) first_at_place_.resize(idx(key) + 1, none);
    int& first = first_at_place_[idx(key)];
    if (first == none) first = added;
    return first;
  }

  // Corner numbers of the triangles of a face.
  const std::vector<Triangle>& split(int face) {
    static const std::vector<Triangle> first{{0, 1, 2}, {0, 2, 3}}, second{{1, 2, 3}, {1, 3, 0}};
    const int c = mesh_.first(face), size = mesh_.face_size(face);
    if (size == 4 && !mesh_.domains.empty()) {
      const double a = (position(c + 2) - position(c)).squaredNorm();
      return a <= (position(c + 3) - position(c + 1)).squaredNorm() ? first : second;
    }
    polygon_.clear();
    for (int k = 0; k < size; ++k) polygon_.push_back(position(c + k));
    split_ = triangulate({polygon_.data(), polygon_.size()});
    return split_;
  }

  // The triangle of these corners of a face on the limit surface.
  PatchTriangle patch_triangle(int face, const Triangle& local) const {
    PatchTriangle result;
    const int size = mesh_.face_size(face);
    const bool is_patch = size == 4 || (size == 3 && mesh_.triangles_are_patches);
    if (mesh_.domains.empty() || !is_patch) return result;
    for (int k = 0; k < 3; ++k) {
      const BasePlace place = base_place(mesh_, mesh_.first(face) + local[idx(k)]);
      result.ptex_face = place.ptex_face + object_.first_ptex_face;
      for (int i = 0; i < 2; ++i) {
        result.corners[idx(k)][idx(i)] = static_cast<std::uint16_t>(32768 * place.uv[i]);
      }
    }
    return result;
  }

  void add_face(int face) {
    const int first = mesh_.first(face), size = mesh_.face_size(face);
    diagonals_.clear();
    for (const Triangle& local : split(face)) {
      const int number = static_cast<int>(surface_.triangles.size());
      Triangle triangle{};
      int flips = 0;
      std::array<EdgeKind, 3> kinds{};
      for (int k = 0; k < 3; ++k) {
        const int a = local[idx(k)], b = local[idx(next_corner(k))], corner = first + a;
        const int chosen = representative(corner);
        triangle[idx(k)] = vertex(chosen);
        if (chosen != sector(corner)) flips |= 1 << k;
        if (b == (a + 1) % size) {
          slots_[idx(corner)] = 3 * number + k;
          kinds[idx(k)] = mesh_.kind(corner);
        } else {
          diagonals_.push_back({std::min(a, b), std::max(a, b), 3 * number + k});
        }
      }
      surface_.triangles.push_back(triangle);
      surface_.patches.push_back(patch_triangle(face, local));
      surface_.flips.push_back(static_cast<std::uint8_t>(flips));
      surface_.neighbours.push_back({none, none, none});
      surface_.edge_kinds.push_back(kinds);
    }
    connect_diagonals();
  }

  void connect_diagonals() {
    std::sort(diagonals_.begin(), diagonals_.end());
    for (std::size_t i = 0; i + 1 < diagonals_.size(); i += 2) {
      neighbour(diagonals_[i][2]) = diagonals_[i + 1][2] / 3;
      neighbour(diagonals_[i + 1][2]) = diagonals_[i][2] / 3;
    }
  }

  int& neighbour(int slot) { return surface_.neighbours[idx(slot / 3)][idx(slot % 3)]; }

  void connect_edge(int corner) {
    const int mate = mesh_.mate(corner);
    if (mate == none) return;
    int other = slots_[idx(mate)];
    if (other == none && !mesh_.twin_faces.empty()) {  // on the other sheet
      const int twin = twin_corner(mesh_, mesh_.next(mate));
      if (twin != none) other = slots_[idx(twin)];
    }
    const int slot = slots_[idx(corner)];
    if (other != none) {
      neighbour(slot) = other / 3;
    } else {
      surface_.edge_kinds[idx(slot / 3)][idx(slot % 3)] = EdgeKind::boundary;
    }
  }

  const RefinedObject& object_;
  const RefinedMesh& mesh_;
  Surface& surface_;
  std::vector<int>& needs_jet_;
  std::vector<int> sector_corners_;  // a drawn corner of each sector
  std::vector<int> vertices_;        // of the surface, for each sector
  std::vector<int> first_at_place_;
  std::vector<int> slots_;  // 3 * triangle + edge of each corner's half-edge
  Points polygon_;
  std::vector<Triangle> split_;
  std::vector<std::array<int, 3>> diagonals_;  // corners, slot
};

}  // namespace

void assemble(const RefinedObject& object, Surface& surface, std::vector<int>& needs_jet) {
  Assembler(object, surface, needs_jet).run();
}

}  // namespace illustrate
