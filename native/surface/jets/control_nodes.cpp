#include "surface/jets/control_nodes.h"

#include <algorithm>

#include "surface/planes/plane_rim.h"

namespace illustrate {
namespace {

constexpr int whole_face = PatchTriangle::steps;  // side of a ptex face
// Control meshes of at most so many ptex faces turn much from one node of level 1 to the next, and
// level 2 costs little.
constexpr int coarse_mesh = 512;

// Steps along the sides of the face that the triangle is half of, or all of.
int size_in_steps(const PatchTriangle& patch) {
  const auto [least, most] =
      std::minmax({patch.corners[0][0], patch.corners[1][0], patch.corners[2][0]});
  return most - least;
}

}  // namespace

bool lies_on_plane(const Surface& surface, int triangle) {
  if (surface.planes.empty()) return false;
  const int plane = surface.triangle_planes[idx(triangle)];
  return plane != none && stands_alone(surface.planes[idx(plane)]);
}

ControlNodes::ControlNodes(const Surface& surface) : surface_(surface) {
  choose_levels();
  lay_grids();
  fill_slots();
  number_nodes();
  link_nodes();
}

void ControlNodes::choose_levels() {
  for (const PlacedControl& placed : surface_.controls) {
    const ControlMesh& control = *placed.mesh;
    const int wanted = control.ptex_faces <= coarse_mesh ? 2 : 1;
    levels_.push_back(control.scheme == Scheme::polygons ? 0 : std::min(control.level, wanted));
  }
}

void ControlNodes::lay_grids() {
  for (std::size_t t = 0; t < surface_.triangles.size(); ++t) {
    const PatchTriangle& patch = surface_.patches[t];
    const int object = surface_.triangle_objects[t], level = levels_[idx(object)];
    if (patch.ptex_face == none || level == 0) continue;
    if (idx(patch.ptex_face) >= grids_.size()) grids_.resize(idx(patch.ptex_face) + 1);
    Grid& grid = grids_[idx(patch.ptex_face)];
    if (grid.cells > 0) continue;
    const ControlMesh& control = *surface_.controls[idx(object)].mesh;
    // A quarter of a pentagon is a ptex face as well: it has fewer cells than a quad.
    grid.cells = std::max(1, whole_face / (size_in_steps(patch) << (control.level - level)));
    grid.is_triangle = control.scheme == Scheme::loop;
    grid.is_plane = lies_on_plane(surface_, static_cast<int>(t));
  }
  int slots = 0;
  for (Grid& grid : grids_) {
    grid.first_slot = slots;
    if (grid.cells > 0) slots += grid.side() * grid.side();
  }
  slots_.assign(idx(slots), none);
}

void ControlNodes::fill_slots() {
  corners_.assign(surface_.positions.size(), none);
  for (int t = 0; t < static_cast<int>(surface_.triangles.size()); ++t) {
    const PatchTriangle& patch = surface_.patches[idx(t)];
    if (patch.ptex_face == none || level_of_triangle(t) == 0) continue;
    const Grid& grid = grids_[idx(patch.ptex_face)];
    const int cell = whole_face / grid.cells;
    for (int k = 0; k < 3; ++k) {
      int& corner = corners_[idx(surface_.triangles[idx(t)][idx(k)])];
      if (corner == none) corner = 3 * t + k;
      const auto [u, v] = patch.corners[idx(k)];
      if (u % cell != 0 || v % cell != 0) continue;
      int& slot = slots_[idx(grid.slot(u / cell, v / cell))];
      if (slot == none) slot = 3 * t + k;
    }
  }
}

void ControlNodes::number_nodes() {
  constexpr int some = 0;
  nodes_.assign(surface_.positions.size(), none);
  for (const int corner : slots_) {
    if (corner != none) nodes_[idx(vertex_of(corner))] = some;
  }
  for (std::size_t v = 0; v < nodes_.size(); ++v) {
    if (nodes_[v] == none) continue;
    nodes_[v] = static_cast<int>(vertices_.size());
    vertices_.push_back(static_cast<int>(v));
  }
}

template <class Visit>
void ControlNodes::for_each_edge(const Grid& grid, Visit&& visit) {
  for (int j = 0; grid.cells > 0 && j <= grid.cells; ++j) {
    for (int i = 0; i <= (grid.is_triangle ? grid.cells - j : grid.cells); ++i) {
      if (i > 0) visit(grid.slot(i, j), grid.slot(i - 1, j));
      if (j > 0) visit(grid.slot(i, j), grid.slot(i, j - 1));
      if (grid.is_triangle && i > 0) visit(grid.slot(i, j), grid.slot(i - 1, j + 1));
    }
  }
}

void ControlNodes::link_nodes() {
  std::vector<std::array<int, 3>> ways;  // from, to, sign
  for (const Grid& grid : grids_) {
    if (grid.is_plane) continue;
    for_each_edge(grid, [&](int s0, int s1) {
      const int c0 = slots_[idx(s0)], c1 = slots_[idx(s1)];
      if (c0 == none || c1 == none) return;
      const int sign = sign_of(c0) == sign_of(c1) ? 1 : -1, a = node_of(c0), b = node_of(c1);
      ways.push_back({a, b, sign});
      ways.push_back({b, a, sign});
    });
  }
  std::vector<int> cursor(vertices_.size() + 1, 0);
  for (const auto& way : ways) ++cursor[idx(way[0]) + 1];
  for (std::size_t i = 1; i < cursor.size(); ++i) cursor[i] += cursor[i - 1];
  Ragged<Link> all;
  all.values.resize(ways.size());
  all.offsets = cursor;
  for (const auto& [from, to, sign] : ways) all.values[idx(cursor[idx(from)]++)] = {to, sign};
  // An inner edge is one of two faces.
  const auto before = [](const Link& a, const Link& b) {
    return a.node != b.node ? a.node < b.node : a.sign > b.sign;
  };
  const auto same = [](const Link& a, const Link& b) {
    return a.node == b.node && a.sign == b.sign;
  };
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Span<Link> list = all[i];
    std::sort(list.begin(), list.end(), before);
    links_.values.insert(links_.values.end(), list.begin(),
                         std::unique(list.begin(), list.end(), same));
    links_.close_list();
  }
}

int ControlNodes::links_per_edge(int node) const {
  return 1 << levels_[idx(surface_.objects[idx(vertices_[idx(node)])])];
}

ControlNodes::Weight ControlNodes::share(int slot, double weight, double sign) const {
  const int corner = slots_[idx(slot)];
  if (corner == none || weight == 0) return {};
  return {node_of(corner), weight, sign * sign_of(corner)};
}

ControlNodes::Place ControlNodes::place(int vertex) const {
  if (nodes_[idx(vertex)] != none) return {{{nodes_[idx(vertex)], 1, 1}, {}, {}, {}}};
  const int corner = corners_[idx(vertex)];
  if (corner == none) return {};
  const PatchTriangle& patch = surface_.patches[idx(corner / 3)];
  const Grid& grid = grids_[idx(patch.ptex_face)];
  const Vec2 at = grid.cells * patch.uv(corner % 3);
  const int i = std::min(static_cast<int>(at.x()), grid.cells - 1);
  const int j = std::min(static_cast<int>(at.y()), grid.cells - 1);
  const double a = at.x() - i, b = at.y() - j, sign = sign_of(corner);
  const int s00 = grid.slot(i, j), s10 = grid.slot(i + 1, j);
  const int s01 = grid.slot(i, j + 1), s11 = grid.slot(i + 1, j + 1);
  if (!grid.is_triangle) {
    return {{share(s00, (1 - a) * (1 - b), sign), share(s10, a * (1 - b), sign),
             share(s01, (1 - a) * b, sign), share(s11, a * b, sign)}};
  }
  if (a + b <= 1) {
    return {{share(s00, 1 - a - b, sign), share(s10, a, sign), share(s01, b, sign), {}}};
  }
  return {{share(s11, a + b - 1, sign), share(s10, 1 - b, sign), share(s01, 1 - a, sign), {}}};
}

}  // namespace illustrate
