// A small surface of the triangles that silhouettes pass, some of them cut finer.
//
// Where the contour enters and leaves a triangle more than once, or turns sharply within it, the
// signs at three corners do not tell how it runs. Such triangles are cut in four, their neighbours
// in two or three so that nothing gapes, and the silhouette is traced again.
#pragma once

#include <map>
#include <utility>

#include "contour/shape/feature_edges.h"
#include "core/index_map.h"
#include "surface/limit/limit_surface.h"

namespace illustrate {

class Patchwork {
 public:
  // `expected`: about how many triangles it will have.
  Patchwork(const Surface& whole, const LimitSurface& limit, std::size_t expected = 0);

  // Adds those of these triangles of the whole that are not there yet, uncut, in this order.
  void add(const std::vector<int>& triangles);

  // Cuts those of these triangles of surface() that lie on a patch, and what is beside them. New
  // vertices lie on the limit surface, with its normal and curvature; beside a crease with those of
  // the other side, where the limit surface has none. False where none could be cut. What was cut
  // has other numbers afterwards.
  bool cut(const std::vector<int>& triangles);

  // Triangles of the whole that `cut` had to add since this was asked last.
  std::vector<int> take_added() { return std::exchange(added_, {}); }

  // With the fields that tracing needs; the patchwork's rim has no neighbours.
  const Surface& surface();

  // Triangles of the whole that were added, in this order.
  const std::vector<int>& wholes() const { return wholes_; }

  // A triangle of the whole that is not cut yet.
  int number_of(int whole_triangle) const { return numbers_[whole_triangle]; }

  // A point of surface() on the whole, and the edge there that it lies on (none: inside).
  struct Place {
    SurfacePoint on;
    int edge = none;
    double fraction = 0;  // of that edge
  };
  Place on_whole(const SurfacePoint& on, int edge) const;

 private:
  struct Piece {
    Triangle vertices{};
    int flips = 0;
    std::array<int, 3> neighbours{none, none, none};
    std::array<int, 3> mates{none, none, none};   // edge of each neighbour
    std::array<int, 3> beyond{none, none, none};  // 3 triangle + edge of the whole, at the rim
    std::array<EdgeKind, 3> kinds{};
    PatchTriangle patch;
    int source = none;
    std::array<Vec2, 3> weights{Vec2(0, 0), Vec2(1, 0), Vec2(0, 1)};  // of corners 1 and 2 there
  };
  // A new vertex in the middle of an edge, as one side sees it.
  struct Middle {
    int vertex = none;
    bool flipped = false;
  };
  using Middles = std::array<Middle, 3>;

  int add_whole(int triangle);
  int add_vertex_of(int whole_vertex);
  void join(int piece, int edge, int other, int other_edge);
  bool can_cut(int piece) const;
  std::vector<Middles> mark(const std::vector<int>& triangles);
  void mark_edge(int piece, int edge, std::vector<Middles>& middles);
  std::optional<LimitPoint> middle_of(const Piece& piece, int edge) const;
  Middle new_middle(const LimitPoint& p, int place);
  // Pieces that have middles, before and while their parts take their places.
  struct Cutting {
    std::vector<Middles> middles;               // (pieces)
    std::map<std::array<int, 4>, int> waiting;  // sides that have not met the other one yet

    bool is_cut(int piece) const;
  };
  void replace(int piece, Cutting& cutting);
  void place_side(int piece, const Piece& parent, const std::array<int, 2>& points,
                  const EdgeSide& part, Cutting& cutting);
  Piece part(const Piece& parent, const Middles& middles, const std::array<int, 3>& points) const;
  void publish();

  const Surface& whole_;
  const LimitSurface& limit_;
  Surface surface_;
  std::vector<Piece> pieces_;
  bool is_published_ = false;  // whether surface_ has the triangles of pieces_
  IndexMap numbers_;           // of triangles of the whole; once cut that of one part
  std::vector<int> wholes_, added_;
  IndexMap vertices_;  // of vertices of the whole
  IndexMap places_;    // of places of the whole
  IndexMap rim_;       // side of the whole beyond the rim -> 3 piece + edge here
};

}  // namespace illustrate
