// The visible critical curves of a view: what ends hatches and separates neighbours (paper
// section 6.4).
#pragma once

#include "hatch/view/image_cells.h"
#include "visibility/labelled_graph.h"

namespace illustrate {

// Whether arcs of this kind are critical: silhouettes, boundaries, creases and self-intersections.
bool is_critical(Kind kind);

// Pieces of the visible critical arcs in a grid over the frame, each no longer than a cell.
class CriticalCurves {
 public:
  CriticalCurves(const LabelledGraph& graph, double width_px, double height_px);

  double unit_px() const { return unit_px_; }  // of the graph

  // The least t in [0, 1] where a + t (b - a) meets a curve; infinite where none does.
  double first_crossing(const Vec2& a, const Vec2& b) const {
    return first_crossing(a, b, Parting::any);
  }
  bool separate(const Vec2& a, const Vec2& b) const { return first_crossing(a, b) <= 1; }
  // The same for all but silhouettes, which at their ends part one sheet only.
  bool is_edge_between(const Vec2& a, const Vec2& b) const {
    return first_crossing(a, b, Parting::edges) <= 1;
  }

  // Whether a curve passes p nearer than `radius`, within about 30 degrees of the unit `heading`.
  bool run_along(const Vec2& p, const Vec2& heading, double radius) const;
  // Whether any passes p nearer than `radius`.
  bool pass(const Vec2& p, double radius) const;

 private:
  // What parts two points: any curve, or one that is no silhouette.
  enum class Parting : std::uint8_t { any, edges };
  struct Piece {
    Vec2 a;
    Vec2 b;
    bool is_silhouette;
  };
  template <class Test>
  bool any_near(const Vec2& p, double radius, const Test& test) const;
  double first_crossing(const Vec2& a, const Vec2& b, Parting parting) const;
  using Pieces = std::vector<Piece>;
  void add_arc(const LabelledGraph& graph, int arc, Pieces& pieces) const;
  void add_pieces(const Vec2& a, const Vec2& b, bool is_silhouette, Pieces& pieces) const;
  void fill_grid(const Pieces& pieces);
  void measure_clearance(const Pieces& pieces);
  // Whether no piece is nearer to p than `reach`, as far as the cells tell.
  bool is_clear(const Vec2& p, double reach) const {
    return reach < clearance_units * unit_px_ * (clearance_[idx(clearance_cells_.of(p))] - 1);
  }

  static constexpr double cell_units = 8, clearance_units = 4;  // of the graph

  double width_, height_, unit_px_;
  ImageCells grid_cells_;
  Ragged<Piece> cells_;  // pieces whose bounding boxes touch each cell
  ImageCells clearance_cells_;
  std::vector<std::uint8_t> clearance_;  // so many of its cells all around each hold no piece
};

}  // namespace illustrate
