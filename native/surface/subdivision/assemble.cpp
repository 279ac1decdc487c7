#include "surface/subdivision/assemble.h"

#include <algorithm>

#include "core/parallel.h"
#include "mesh/polygons.h"
#include "surface/shading.h"

namespace illustrate {
namespace {

// What the triangles of one face are made with, kept from face to face.
struct FaceWork {
  Points polygon;
  std::vector<Triangle> split;
  std::vector<std::array<int, 3>> diagonals;  // corners, slot
};

// Everything that belongs to one face, vertex or corner alone is made in parallel; the order of the
// vertices, which is that of the triangles, in between.
class Assembler {
 public:
  Assembler(RefinedObject& object, int threads, Surface& surface)
      : object_(object),
        mesh_(object.mesh),
        threads_(threads),
        surface_(surface),
        first_vertex_(surface.positions.size()),
        sector_corners_(object.limits.positions.size(), none),
        slots_(object.mesh.corner_count(), none) {}

  void run(std::vector<int>& needs_jet) {
    find_drawn_corners();
    make_room_for_triangles();
    for_each(first_triangles_.size(), [&](int begin, int end) {
      FaceWork work;
      for (int f = begin; f < end; ++f) {
        if (first_triangles_[idx(f)] != none) add_face(f, work);
      }
    });
    number_vertices();
    add_vertices();
    find_places(needs_jet);
    find_tips();
    for_each(slots_.size(), [&](int begin, int end) {
      for (int c = begin; c < end; ++c) {
        if (slots_[idx(c)] != none) connect_edge(c);
      }
    });
  }

 private:
  template <class Body>
  void for_each(std::size_t count, const Body& body) const {
    parallel_for(count, threads_, [&](std::size_t begin, std::size_t end) {
      body(static_cast<int>(begin), static_cast<int>(end));
    });
  }

  int faces() const { return static_cast<int>(mesh_.face_count()); }
  int sector(int corner) const { return object_.corner_sectors[idx(corner)]; }
  const Vec3& position(int corner) const { return object_.limits.positions[idx(sector(corner))]; }
  bool is_hole(int face) const {
    return !object_.base.holes.empty() && object_.base.holes[idx(mesh_.base_faces[idx(face)])];
  }
  bool is_without_patch(int face) const {
    const std::vector<std::uint8_t>& without = object_.without_patch;
    return !without.empty() && without[idx(mesh_.base_faces[idx(face)])];
  }
  bool is_drawn(int face) const {
    const std::vector<std::uint8_t>& kept = object_.base.kept;
    return !is_hole(face) && (kept.empty() || kept[idx(mesh_.base_faces[idx(face)])]);
  }

  int plane_of(int face) const {
    const std::vector<int>& planes = object_.base.face_planes;
    return planes.empty() ? none : planes[idx(mesh_.base_faces[idx(face)])];
  }

  int input_face(int face) const {
    const std::vector<int>& sources = object_.base.source_faces;
    return sources.empty() ? none : sources[idx(mesh_.base_faces[idx(face)])];
  }

  void find_drawn_corners() {
    for (int f = 0; f < faces(); ++f) {
      if (!is_drawn(f)) continue;
      for (int c = mesh_.first(f); c < mesh_.first(f + 1); ++c) {
        int& corner = sector_corners_[idx(sector(c))];
        if (corner == none) corner = c;
      }
    }
  }

  void make_room_for_triangles() {
    const std::size_t before = surface_.triangles.size();
    std::size_t count = before;
    first_triangles_.assign(mesh_.face_count(), none);
    for (int f = 0; f < faces(); ++f) {
      if (!is_drawn(f)) continue;
      first_triangles_[idx(f)] = static_cast<int>(count);
      count += idx(mesh_.face_size(f) - 2);
    }
    first_triangle_ = before;
    surface_.triangles.resize(count);
    surface_.flips.resize(count, 0);
    surface_.triangle_objects.resize(count, object_.object);
    surface_.neighbours.resize(count, {none, none, none});
    surface_.edge_kinds.resize(count);
    surface_.patches.resize(count);
    surface_.triangle_planes.resize(count, none);
    surface_.triangle_faces.resize(count, none);
  }

  // The sector that stands for this corner's on both sheets.
  int representative(int corner) const {
    if (mesh_.twin_faces.empty()) return sector(corner);
    const int twin = twin_corner(mesh_, corner);
    if (twin == none || sector_corners_[idx(sector(twin))] == none) return sector(corner);
    return std::min(sector(corner), sector(twin));
  }

  // Corner numbers of the triangles of a face.
  const std::vector<Triangle>& split(int face, FaceWork& work) const {
    const int c = mesh_.first(face), size = mesh_.face_size(face);
    work.polygon.clear();
    for (int k = 0; k < size; ++k) work.polygon.push_back(position(c + k));
    work.split = triangulate({work.polygon.data(), work.polygon.size()});
    return work.split;
  }

  // The triangle of these corners of a face on the limit surface.
  PatchTriangle patch_triangle(int face, const Triangle& local) const {
    const int size = mesh_.face_size(face);
    const bool is_patch = size == 4 || (size == 3 && mesh_.triangles_are_patches);
    if (mesh_.domains.empty() || !is_patch || is_without_patch(face)) return {};
    const FaceDomain& domain = mesh_.domains[idx(face)];
    PatchTriangle result;
    result.ptex_face = domain.ptex_face + object_.first_ptex_face;
    for (std::size_t k = 0; k < 3; ++k) {
      result.corners[k] = place_on_domain(domain, size, local[k]);
    }
    return result;
  }

  // Corners of triangles are sectors until the vertices are numbered.
  void add_face(int face, FaceWork& work) {
    int number = first_triangles_[idx(face)];
    work.diagonals.clear();
    for (const Triangle& local : split(face, work)) {
      for (int k = 0; k < 3; ++k) add_corner(face, local, 3 * number + k, work);
      surface_.triangle_planes[idx(number)] = plane_of(face);
      surface_.triangle_faces[idx(number)] = input_face(face);
      surface_.patches[idx(number++)] = patch_triangle(face, local);
    }
    connect_diagonals(work.diagonals);
  }

  void add_corner(int face, const Triangle& local, int slot, FaceWork& work) {
    const int triangle = slot / 3, k = slot % 3;
    const int a = local[idx(k)], b = local[idx(next_corner(k))];
    const int corner = mesh_.first(face) + a, chosen = representative(corner);
    surface_.triangles[idx(triangle)][idx(k)] = chosen;
    if (chosen != sector(corner)) {
      surface_.flips[idx(triangle)] =
          static_cast<std::uint8_t>(surface_.flips[idx(triangle)] | 1 << k);
    }
    if (b == a + 1 || (b == 0 && a + 1 == mesh_.face_size(face))) {
      slots_[idx(corner)] = slot;
      surface_.edge_kinds[idx(triangle)][idx(k)] = mesh_.kind(corner);
    } else {
      work.diagonals.push_back({std::min(a, b), std::max(a, b), slot});
    }
  }

  void connect_diagonals(std::vector<std::array<int, 3>>& diagonals) {
    std::sort(diagonals.begin(), diagonals.end());
    for (std::size_t i = 0; i + 1 < diagonals.size(); i += 2) {
      neighbour(diagonals[i][2]) = diagonals[i + 1][2] / 3;
      neighbour(diagonals[i + 1][2]) = diagonals[i][2] / 3;
    }
  }

  int& neighbour(int slot) { return surface_.neighbours[idx(slot / 3)][idx(slot % 3)]; }

  // In the order of the faces' corners, whichever diagonals split them.
  void number_vertices() {
    std::vector<int> vertices(sector_corners_.size(), none);
    vertex_sectors_.reserve(vertices.size());
    for (int f = 0; f < static_cast<int>(first_triangles_.size()); ++f) {
      if (!is_drawn(f)) continue;
      for (int k = 0; k < mesh_.face_size(f); ++k) {
        const int sector = representative(mesh_.first(f) + k);
        int& vertex = vertices[idx(sector)];
        if (vertex != none) continue;
        vertex = static_cast<int>(first_vertex_ + vertex_sectors_.size());
        vertex_sectors_.push_back(sector);
      }
    }
    for (std::size_t t = first_triangle_; t < surface_.triangles.size(); ++t) {
      for (int& corner : surface_.triangles[t]) corner = vertices[idx(corner)];
    }
  }

  // Moves the values of the sectors that became vertices to the end of `values`.
  template <class Values>
  void move_to_vertices(Values& of_sectors, Values& values) const {
    const Values from = std::move(of_sectors);
    values.resize(first_vertex_ + vertex_sectors_.size());
    for_each(vertex_sectors_.size(), [&](int begin, int end) {
      for (int i = begin; i < end; ++i) {
        values[first_vertex_ + idx(i)] = from[idx(vertex_sectors_[idx(i)])];
      }
    });
  }

  void add_vertices() {
    SectorLimits& limits = object_.limits;
    move_to_vertices(limits.positions, surface_.positions);
    move_to_vertices(limits.normals, surface_.normals);
    move_to_vertices(limits.curvature, surface_.curvature);
    const std::size_t count = surface_.positions.size();
    surface_.objects.resize(count, object_.object);
    surface_.base_faces.resize(count, none);
    surface_.base_uv.resize(count);
    for_each(vertex_sectors_.size(), [&](int begin, int end) {
      for (int i = begin; i < end; ++i) set_base_place(first_vertex_ + idx(i), corner_of(i));
    });
  }

  // The first drawn corner of the i-th vertex that is added.
  int corner_of(int i) const { return sector_corners_[idx(vertex_sectors_[idx(i)])]; }

  void set_base_place(std::size_t vertex, int corner) {
    const BasePlace base = base_place(mesh_, corner);
    const std::vector<std::uint8_t>& off = object_.off_limit;
    const bool is_off = !off.empty() && off[idx(mesh_.base_faces[idx(mesh_.face(corner))])];
    if (base.ptex_face != none && !is_off) {
      surface_.base_faces[vertex] = base.ptex_face + object_.first_ptex_face;
    }
    surface_.base_uv[vertex] = base.uv;
  }

  void find_places(std::vector<int>& needs_jet) {
    std::vector<int> first_at_place(mesh_.points.size(), none);
    surface_.places.reserve(surface_.positions.size());
    for (int i = 0; i < static_cast<int>(vertex_sectors_.size()); ++i) {
      const int added = static_cast<int>(first_vertex_) + i,
                key = place_key(mesh_.vertex(corner_of(i)));
      if (idx(key) >= first_at_place.size()) first_at_place.resize(idx(key) + 1, none);
      int& first = first_at_place[idx(key)];
      if (first == none) first = added;
      surface_.places.push_back(first);
      if (object_.limits.needs_jet[idx(vertex_sectors_[idx(i)])]) needs_jet.push_back(added);
    }
  }

  void find_tips() {
    if (mesh_.domains.empty()) return;
    std::vector<std::uint8_t> is_tip = mesh_.sharp_vertices;
    if (std::none_of(is_tip.begin(), is_tip.end(), [](std::uint8_t sharp) { return sharp; }))
      return;
    for (int c = 0; c < static_cast<int>(mesh_.corner_count()); ++c) {
      if (!mesh_.is_sharp(c)) continue;
      is_tip[idx(mesh_.vertex(c))] = 0;
      is_tip[idx(mesh_.vertex(mesh_.next(c)))] = 0;
    }
    for (int i = 0; i < static_cast<int>(vertex_sectors_.size()); ++i) {
      if (is_tip[idx(mesh_.vertex(corner_of(i)))])
        surface_.tips.push_back(static_cast<int>(first_vertex_) + i);
    }
  }

  // The same for all vertices at one point, of both sheets.
  int place_key(int mesh_vertex) const {
    const int place = place_of(mesh_, mesh_vertex);
    const int twin = mesh_.twin_vertices.empty() ? none : mesh_.twin_vertices[idx(mesh_vertex)];
    return twin == none ? place : std::min(place, place_of(mesh_, twin));
  }

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

  RefinedObject& object_;
  const RefinedMesh& mesh_;
  int threads_;
  Surface& surface_;
  std::size_t first_vertex_, first_triangle_ = 0;  // of the surface
  std::vector<int> sector_corners_;                // the first drawn corner of each sector
  std::vector<int> first_triangles_;               // of each face, none where it is not drawn
  std::vector<int> vertex_sectors_;                // of each vertex that is added
  std::vector<int> slots_;                         // 3 * triangle + edge of each corner's half-edge
};

}  // namespace

void assemble(RefinedObject object, int threads, Surface& surface, std::vector<int>& needs_jet) {
  Assembler(object, threads, surface).run(needs_jet);
}

}  // namespace illustrate
