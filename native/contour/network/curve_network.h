// All curves of one view as strands between nodes, before anything is known of their visibility.
#pragma once

#include "core/ragged.h"
#include "core/report.h"
#include "core/types.h"

namespace illustrate {

// The numbers are public (`illustrate_native.Node`).
enum class NodeKind : std::uint8_t { cusp = 0, crossing = 1, joint = 2, end = 3 };

struct CurvePoint {
  Vec3 position;
  SurfacePoint on;
};

struct NetworkNode {
  NodeKind kind;  // cusp, joint or end
  Vec3 position;
};

// What is known of whether a strand can be seen (unseen.h). Covered: it has one layer at least in
// front all along. Buried: so has all within a few pixels of it at its depth, too. Beyond the
// frame: nobody asks.
enum class Sight : std::uint8_t { possible, covered, buried, beyond_frame };

inline bool takes_part_in_crossings(Sight sight) {
  return sight == Sight::possible || sight == Sight::covered;
}

// One curve between two nodes, or a closed one without nodes (both `none`). A curve behind it
// has `left_layers` more layers in front where it passes on the left side of this one than it has
// without this curve's surface, `right_layers` on the right, left and right as the viewer sees the
// strand run: a silhouette runs with its front-facing side on the left and hides (2, 0), a boundary
// (1, 0) or (0, 1), a crease between two front faces (1, 1).
struct Strand {
  Kind kind = Kind::silhouette;
  int object = none;
  int start_node = none;
  int end_node = none;
  int left_layers = 0;
  int right_layers = 0;
  bool is_flush = false;  // within a face of another part (flush.h): no line
  Sight sight = Sight::possible;

  bool closed() const { return start_node == none; }
};

// At a node where strand `a` ends and strand `b` starts the quantitative invisibility is known to
// change: QI(b) = QI(a) + jump.
struct Tie {
  int node;
  int a;
  int b;
  int jump;
};

// points[i] are the points of strands[i], in its direction; a closed strand does not repeat its
// first point; a strand between nodes has the nodes' positions at its ends.
struct CurveNetwork {
  Ragged<CurvePoint> points;
  std::vector<Strand> strands;
  std::vector<NetworkNode> nodes;
  std::vector<Tie> ties;
  bool is_incomplete = false;  // where surfaces pass through each other, not every curve is there
};

}  // namespace illustrate
