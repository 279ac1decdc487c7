#include "hatch/view/critical_curves.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/segments.h"
#include "tone/step_along.h"

namespace illustrate {
namespace {

// Clearance is not told apart beyond so many cells.
constexpr int most_clearance = 8;

// Squared cosine between what runs along each other.
constexpr double least_alignment = 0.75;

template <class Piece, class Use>
void visit_cells(const ImageCells& cells, const Piece& piece, const Use& use) {
  cells.visit(piece.a.cwiseMin(piece.b), piece.a.cwiseMax(piece.b), use);
}

}  // namespace

bool is_critical(Kind kind) {
  return kind == Kind::silhouette || kind == Kind::boundary || kind == Kind::crease ||
         kind == Kind::intersection;
}

CriticalCurves::CriticalCurves(const LabelledGraph& graph, double width_px, double height_px)
    : width_(width_px),
      height_(height_px),
      unit_px_(graph.unit_px),
      grid_cells_(width_px, height_px, cell_units * unit_px_),
      clearance_cells_(width_px, height_px, clearance_units * unit_px_) {
  Pieces pieces;
  for (int arc = 0; arc < static_cast<int>(graph.arcs.size()); ++arc) {
    const GraphArc& data = graph.arcs[idx(arc)];
    if (layers_over(data) == 0 && is_critical(data.kind)) add_arc(graph, arc, pieces);
  }
  fill_grid(pieces);
  measure_clearance(pieces);
}

void CriticalCurves::add_arc(const LabelledGraph& graph, int arc, Pieces& pieces) const {
  const Span<const Vec2> line = graph.image[idx(arc)];
  const bool is_silhouette = graph.arcs[idx(arc)].kind == Kind::silhouette;
  for (std::size_t i = 1; i < line.size(); ++i) {
    add_pieces(line[i - 1], line[i], is_silhouette, pieces);
  }
  if (graph.arcs[idx(arc)].start_node == none && line.size() > 1) {
    add_pieces(line.back(), line.front(), is_silhouette, pieces);
  }
}

void CriticalCurves::add_pieces(const Vec2& a, const Vec2& b, bool is_silhouette,
                                Pieces& pieces) const {
  const double cell_px = cell_units * unit_px_;
  const Frame frame{Vec2::Constant(-cell_px), Vec2(width_ + cell_px, height_ + cell_px)};
  double from, to;
  if (!clip_to_frame(frame, a, b, from, to)) return;
  const auto at = [&](double t) { return t >= 1 ? b : Vec2(a + t * (b - a)); };
  const int count =
      std::max(1, static_cast<int>(std::ceil((to - from) * (b - a).norm() / cell_px)));
  Vec2 start = at(from);
  for (int i = 1; i <= count; ++i) {
    const Vec2 end = at(from + (to - from) * i / count);
    pieces.push_back({start, end, is_silhouette});
    start = end;
  }
}

void CriticalCurves::fill_grid(const Pieces& pieces) {
  cells_ = sorted_into<Piece>(idx(grid_cells_.count()), [&](const auto& put) {
    for (const Piece& piece : pieces) {
      visit_cells(grid_cells_, piece, [&](int cell) { put(cell, piece); });
    }
  });
}

// Two sweeps over the cells, each with the neighbours that it has passed.
void CriticalCurves::measure_clearance(const Pieces& pieces) {
  const int rows = clearance_cells_.rows, columns = clearance_cells_.columns;
  clearance_.assign(idx(rows * columns), most_clearance);
  for (const Piece& piece : pieces) {
    visit_cells(clearance_cells_, piece, [&](int cell) { clearance_[idx(cell)] = 0; });
  }
  const auto lower = [&](int row, int column, int way) {
    std::uint8_t& clearance = clearance_[idx(row * columns + column)];
    int least = clearance;
    const auto pass = [&](int i, int j) {
      if (i < 0 || j < 0 || i >= columns || j >= rows) return;
      least = std::min(least, clearance_[idx(j * columns + i)] + 1);
    };
    pass(column - way, row);
    for (int i = column - 1; i <= column + 1; ++i) pass(i, row - way);
    clearance = static_cast<std::uint8_t>(least);
  };
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) lower(row, column, 1);
  }
  for (int row = rows; row-- > 0;) {
    for (int column = columns; column-- > 0;) lower(row, column, -1);
  }
}

double CriticalCurves::first_crossing(const Vec2& a, const Vec2& b, Parting parting) const {
  double first = std::numeric_limits<double>::infinity();
  const Vec2 run = b - a;
  if (is_clear(a, run.cwiseAbs().maxCoeff())) return first;
  const int row_end = grid_cells_.row_of(std::max(a.y(), b.y())),
            column_end = grid_cells_.column_of(std::max(a.x(), b.x()));
  for (int row = grid_cells_.row_of(std::min(a.y(), b.y())); row <= row_end; ++row) {
    for (int i = grid_cells_.column_of(std::min(a.x(), b.x())); i <= column_end; ++i) {
      for (const Piece& piece : cells_[idx(row * grid_cells_.columns + i)]) {
        if (piece.is_silhouette && parting == Parting::edges) continue;
        const double side_c = cross(run, piece.a - a), side_d = cross(run, piece.b - a);
        if ((side_c > 0) == (side_d > 0)) continue;
        const double side_a = cross(piece.b - piece.a, a - piece.a);
        const double side_b = cross(piece.b - piece.a, b - piece.a);
        if ((side_a > 0) == (side_b > 0)) continue;
        first = std::min(first, std::clamp(side_a / (side_a - side_b), 0.0, 1.0));
      }
    }
  }
  return first;
}

// Whether `test` accepts the direction of a piece that passes p nearer than `radius`.
template <class Test>
bool CriticalCurves::any_near(const Vec2& p, double radius, const Test& test) const {
  if (is_clear(p, radius)) return false;
  for (int row = grid_cells_.row_of(p.y() - radius); row <= grid_cells_.row_of(p.y() + radius);
       ++row) {
    for (int i = grid_cells_.column_of(p.x() - radius); i <= grid_cells_.column_of(p.x() + radius);
         ++i) {
      for (const Piece& piece : cells_[idx(row * grid_cells_.columns + i)]) {
        const Vec2 &a = piece.a, run = piece.b - a;
        if (!(run.squaredNorm() > 0) || !test(run)) continue;
        const double t = nearest_share(a, piece.b, p);
        if ((p - a - t * run).squaredNorm() < radius * radius) return true;
      }
    }
  }
  return false;
}

bool CriticalCurves::run_along(const Vec2& p, const Vec2& heading, double radius) const {
  return any_near(p, radius, [&](const Vec2& run) {
    const double along = run.dot(heading);
    return along * along >= least_alignment * run.squaredNorm();
  });
}

bool CriticalCurves::pass(const Vec2& p, double radius) const {
  return any_near(p, radius, [](const Vec2&) { return true; });
}

}  // namespace illustrate
