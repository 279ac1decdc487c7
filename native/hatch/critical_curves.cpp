#include "hatch/critical_curves.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "tone/step_along.h"

namespace illustrate {
namespace {

constexpr double cell_units = 8;  // of the graph

// Clearance is not told apart beyond so many cells.
constexpr int most_clearance = 4;

// Squared cosine between what runs along each other.
constexpr double least_alignment = 0.75;

}  // namespace

bool is_critical(Kind kind) {
  return kind == Kind::silhouette || kind == Kind::boundary || kind == Kind::crease ||
         kind == Kind::intersection;
}

CriticalCurves::CriticalCurves(const LabelledGraph& graph, double width_px, double height_px)
    : width_(width_px),
      height_(height_px),
      unit_px_(graph.unit_px),
      cell_px_(cell_units * graph.unit_px),
      columns_(static_cast<int>(std::ceil(width_px / cell_px_))),
      rows_(static_cast<int>(std::ceil(height_px / cell_px_))) {
  for (int arc = 0; arc < static_cast<int>(graph.arcs.size()); ++arc) {
    if (graph.arcs[arc].invisibility == 0 && is_critical(graph.arcs[arc].kind)) add_arc(graph, arc);
  }
  fill_grid();
  measure_clearance();
}

int CriticalCurves::column_of(double x) const {
  return static_cast<int>(std::clamp(std::floor(x / cell_px_), 0.0, columns_ - 1.0));
}

int CriticalCurves::row_of(double y) const {
  return static_cast<int>(std::clamp(std::floor(y / cell_px_), 0.0, rows_ - 1.0));
}

void CriticalCurves::add_arc(const LabelledGraph& graph, int arc) {
  const Span<const Vec2> line = graph.image[arc];
  const bool is_silhouette = graph.arcs[arc].kind == Kind::silhouette;
  for (std::size_t i = 1; i < line.size(); ++i) add_pieces(line[i - 1], line[i], is_silhouette);
  if (graph.arcs[arc].start_node == none && line.size() > 1) {
    add_pieces(line.back(), line.front(), is_silhouette);
  }
}

void CriticalCurves::add_pieces(const Vec2& a, const Vec2& b, bool is_silhouette) {
  const Frame frame{Vec2::Constant(-cell_px_), Vec2(width_ + cell_px_, height_ + cell_px_)};
  double from, to;
  if (!clip_to_frame(frame, a, b, from, to)) return;
  const auto at = [&](double t) { return t >= 1 ? b : Vec2(a + t * (b - a)); };
  const int count =
      std::max(1, static_cast<int>(std::ceil((to - from) * (b - a).norm() / cell_px_)));
  Vec2 start = at(from);
  for (int i = 1; i <= count; ++i) {
    const Vec2 end = at(from + (to - from) * i / count);
    pieces_.push_back({start, end, is_silhouette});
    start = end;
  }
}

void CriticalCurves::fill_grid() {
  const auto visit = [&](const Piece& piece, const auto& use) {
    const Vec2 low = piece.a.cwiseMin(piece.b), high = piece.a.cwiseMax(piece.b);
    for (int row = row_of(low.y()); row <= row_of(high.y()); ++row) {
      for (int i = column_of(low.x()); i <= column_of(high.x()); ++i) use(row * columns_ + i);
    }
  };
  cells_.offsets.assign(static_cast<std::size_t>(columns_) * rows_ + 1, 0);
  for (const Piece& piece : pieces_) visit(piece, [&](int cell) { ++cells_.offsets[cell + 1]; });
  for (std::size_t i = 1; i < cells_.offsets.size(); ++i)
    cells_.offsets[i] += cells_.offsets[i - 1];
  cells_.values.resize(cells_.offsets.back());
  std::vector<int> next(cells_.offsets.begin(), cells_.offsets.end() - 1);
  for (int i = 0; i < static_cast<int>(pieces_.size()); ++i) {
    visit(pieces_[i], [&](int cell) { cells_.values[next[cell]++] = i; });
  }
}

// Two sweeps over the cells, each with the neighbours that it has passed.
void CriticalCurves::measure_clearance() {
  const int count = rows_ * columns_;
  clearance_.assign(idx(count), most_clearance);
  const auto lower = [&](int cell, int way) {
    const int row = cell / columns_, column = cell % columns_;
    int least = cells_[idx(cell)].empty() ? clearance_[idx(cell)] : 0;
    const auto pass = [&](int i, int j) {
      if (i < 0 || j < 0 || i >= columns_ || j >= rows_) return;
      least = std::min(least, clearance_[idx(j * columns_ + i)] + 1);
    };
    pass(column - way, row);
    for (int i = column - 1; i <= column + 1; ++i) pass(i, row - way);
    clearance_[idx(cell)] = static_cast<std::uint8_t>(least);
  };
  for (int cell = 0; cell < count; ++cell) lower(cell, 1);
  for (int cell = count - 1; cell >= 0; --cell) lower(cell, -1);
}

bool CriticalCurves::is_clear(const Vec2& p, double reach) const {
  return reach < cell_px_ * (clearance_[row_of(p.y()) * columns_ + column_of(p.x())] - 1);
}

double CriticalCurves::first_crossing(const Vec2& a, const Vec2& b, bool with_silhouettes) const {
  double first = std::numeric_limits<double>::infinity();
  const Vec2 run = b - a;
  if (is_clear(a, run.cwiseAbs().maxCoeff())) return first;
  const int row_end = row_of(std::max(a.y(), b.y())),
            column_end = column_of(std::max(a.x(), b.x()));
  for (int row = row_of(std::min(a.y(), b.y())); row <= row_end; ++row) {
    for (int i = column_of(std::min(a.x(), b.x())); i <= column_end; ++i) {
      for (const int index : cells_[row * columns_ + i]) {
        const Piece& piece = pieces_[index];
        if (piece.is_silhouette && !with_silhouettes) continue;
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
  for (int row = row_of(p.y() - radius); row <= row_of(p.y() + radius); ++row) {
    for (int i = column_of(p.x() - radius); i <= column_of(p.x() + radius); ++i) {
      for (const int index : cells_[row * columns_ + i]) {
        const Vec2 &a = pieces_[index].a, run = pieces_[index].b - a;
        const double square = run.squaredNorm();
        if (!(square > 0) || !test(run)) continue;
        const double t = std::clamp(run.dot(p - a) / square, 0.0, 1.0);
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
