#include "surface/subdivision/child_corners.h"

#include "core/parallel.h"

namespace illustrate {
namespace {

// A half-edge of the child and what it inherits.
struct ChildEdge {
  int corner, mate;
  EdgeKind kind;
};

// The quads of Catmull-Clark's. Their half-edges by where they run: 0 from the vertex to the middle
// of the edge, 1 on to the middle of the face, 2 on to the middle of the edge before, 3 back.
struct QuadChildren {
  const RefinedMesh& parent;

  int count() const { return 4 * static_cast<int>(parent.corner_count()); }

  int child(int corner, int role) const {
    const int f = parent.face(corner);
    const int turn = parent.face_size(f) == 4 ? corner - parent.first(f) : 0;
    return 4 * corner + ((role + turn) & 3);
  }

  template <class Set>
  void visit(int corner, const Set& set) const {
    const int next = parent.next(corner), previous = parent.previous(corner);
    const int mate = parent.mate(corner), before = parent.mate(previous);
    const int across = mate == none ? none : child(parent.next(mate), 3);
    set({child(corner, 0), across, parent.kind(corner)});
    set({child(corner, 1), child(next, 2), EdgeKind::smooth});
    set({child(corner, 2), child(previous, 1), EdgeKind::smooth});
    set({child(corner, 3), before == none ? none : child(before, 0), parent.kind(previous)});
  }
};

// Loop's triangles. Half-edges of those at corners: 0 from the vertex to the middle of the edge, 1
// on to the middle of the edge before, 2 back.
struct TriangleChildren {
  const RefinedMesh& parent;

  int count() const { return 4 * static_cast<int>(parent.corner_count()); }

  int child(int corner, int role) const {
    const int f = corner / 3, k = corner % 3;
    return 3 * (4 * f + k) + (role + k) % 3;
  }

  // The half-edge of the middle triangle along the one at this corner.
  int middle(int corner) const { return 3 * (4 * (corner / 3) + 3) + (corner + 1) % 3; }

  template <class Set>
  void visit(int corner, const Set& set) const {
    const int previous = parent.previous(corner);
    const int mate = parent.mate(corner), before = parent.mate(previous);
    const int across = mate == none ? none : child(parent.next(mate), 2);
    set({child(corner, 0), across, parent.kind(corner)});
    set({child(corner, 1), middle(corner), EdgeKind::smooth});
    set({child(corner, 2), before == none ? none : child(before, 0), parent.kind(previous)});
    set({middle(corner), child(corner, 1), EdgeKind::smooth});
  }
};

template <class Children>
void divide(const Children& children, int threads, RefinedMesh& child) {
  child.mates.resize(idx(children.count()));
  child.corner_kinds.resize(child.mates.size());
  const auto set = [&](const ChildEdge& edge) {
    child.mates[idx(edge.corner)] = edge.mate;
    child.corner_kinds[idx(edge.corner)] = edge.kind;
  };
  parallel_for(children.parent.corner_count(), threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t c = begin; c < end; ++c) children.visit(static_cast<int>(c), set);
  });
}

}  // namespace

void divide_corners(const RefinedMesh& parent, int threads, RefinedMesh& child) {
  child.corners_per_face = parent.triangles_are_patches ? 3 : 4;
  if (parent.triangles_are_patches) {
    divide(TriangleChildren{parent}, threads, child);
  } else {
    divide(QuadChildren{parent}, threads, child);
  }
}

int child_corner(const RefinedMesh& parent, int corner) {
  return parent.triangles_are_patches ? TriangleChildren{parent}.child(corner, 0)
                                      : QuadChildren{parent}.child(corner, 0);
}

}  // namespace illustrate
