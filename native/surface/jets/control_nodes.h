// The vertices of a coarse level of the limit surface among those of a finer one, and how they are
// joined.
#pragma once

#include "core/ragged.h"
#include "surface/surface.h"

namespace illustrate {

// Whether a triangle is of a flat face that stands alone.
bool lies_on_plane(const Surface& surface, int triangle);

// Nodes are the vertices of the surface that stand at the vertices of level 1 of their control mesh
// (level 2 of coarse meshes), for all meshes that are refined at least so far. Level 1 is the first
// that has a vertex in the middle of faces of more than four corners. A point of a crease has a
// node on each side.
class ControlNodes {
 public:
  explicit ControlNodes(const Surface& surface);

  // An edge to another node.
  struct Link {
    int node = none;
    int sign = 1;  // -1: the normals of the two ends belong to different sheets
  };
  // Share of a node in a place between nodes.
  struct Weight {
    int node = none;  // none: nothing
    double weight = 0;
    double sign = 1;  // -1: the normals of node and place belong to different sheets
  };
  using Place = std::array<Weight, 4>;

  // Vertices of the surface, ascending.
  const std::vector<int>& vertices() const { return vertices_; }
  // Not within flat faces: those say nothing of how the surface bends beside them, and are so much
  // larger than the strips of a rounding that nothing else would count.
  Span<const Link> links(int node) const { return links_[idx(node)]; }
  // Edges between nodes that one edge of the control mesh has at this node.
  int links_per_edge(int node) const;
  // Where a vertex of the surface lies among the nodes: (bi)linear in the parameters of its base
  // face. No node at all for vertices of meshes that have none.
  Place place(int vertex) const;

 private:
  // Nodes at the corners of the cells of one ptex face.
  struct Grid {
    int first_slot = 0;
    int cells = 0;  // along a side; 0: nothing is there
    bool is_triangle = false;
    bool is_plane = false;  // of a flat face

    int side() const { return cells + 1; }
    int slot(int i, int j) const { return first_slot + j * side() + i; }
  };

  void choose_levels();
  void lay_grids();
  void fill_slots();
  void number_nodes();
  void link_nodes();

  template <class Visit>  // visit(slot, slot) of every edge of a grid
  static void for_each_edge(const Grid& grid, Visit&& visit);

  int level_of_triangle(int triangle) const { return levels_[idx(surface_.object_of(triangle))]; }
  int vertex_of(int corner) const { return surface_.triangles[idx(corner / 3)][idx(corner % 3)]; }
  int node_of(int corner) const { return nodes_[idx(vertex_of(corner))]; }
  double sign_of(int corner) const { return surface_.corner_sign(corner / 3, corner % 3); }
  Weight share(int slot, double weight, double sign) const;

  const Surface& surface_;
  std::vector<int> levels_;   // (objects) of the nodes; 0: none
  std::vector<Grid> grids_;   // (ptex faces)
  std::vector<int> slots_;    // corner (3 * triangle + corner) of the surface at each node of grids
  std::vector<int> corners_;  // (n) some corner of each vertex of the surface
  std::vector<int> nodes_;    // (n) none: no node
  std::vector<int> vertices_;  // (nodes)
  Ragged<Link> links_;         // (nodes)
};

}  // namespace illustrate
