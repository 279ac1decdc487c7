// One silhouette chain made exact where it matters (exact_silhouettes.h).
#pragma once

#include <limits>
#include <unordered_map>

#include "contour/exact/exact_segment.h"
#include "contour/exact/exactness.h"
#include "contour/silhouettes.h"
#include "core/direction.h"

namespace illustrate {

// A point of a chain that is being made.
struct ExactPoint : ChainPoint {
  int knot = none;     // where it is exact
  int segment = none;  // of the linear chain, that the point starts or lies on

  bool is_cusp() const { return cusp_jump != 0; }
};

// A knot as the segments before and after it see it, each on the patch of its own triangle.
struct ExactKnot {
  ContourKnot arriving, leaving;
};

// A point of the linear chain that its polyline leaves out, and the polyline's point before it.
struct LeftOutPoint {
  int behind;
  ChainPoint point;
};

struct ExactPolyline {
  bool closed = false;
  int edges = 0;  // that the linear chain crosses
  std::vector<ExactPoint> points;
  std::vector<ExactKnot> knots;
  std::vector<LeftOutPoint> left_out;  // in order; only once the points are final
};

// What was found on the edges of a surface, by their lower and higher vertices. Stays true as long
// as the vertices keep their numbers.
struct SolvedEdge {
  double fraction = 0;  // from the lower vertex
  double sheet = 1;     // sign of the lower vertex's normal on the sheet of the sample
  std::optional<ContourSample> sample;
  bool at_pinch = false;  // no root: the normal turns over at a pinch point
};
using SolvedEdges = std::unordered_map<std::uint64_t, SolvedEdge>;

class ExactChain {
 public:
  // `solved` is read and filled; null: nothing is remembered, every edge being asked once.
  ExactChain(const Surface& surface, LimitContour& contour, const ContourFunctions& functions,
             SolvedEdges* solved)
      : surface_(surface),
        contour_(contour),
        functions_(functions),
        camera_(functions.camera()),
        solved_(solved),
        segment_(contour, functions.camera()) {}

  // Finds the exact points of a linear chain, which is to outlive this.
  void solve(Span<const EdgePoint> linear, bool closed, Exactness exactness);

  // The chain that was solved, with what lies within its triangles.
  ExactPolyline polyline();

  // Triangles whose segment runs far from the contour's direction at an end, or missed its cusp in
  // the last polyline: they hold more of the contour than the signs at their corners tell.
  std::vector<int> troubled() const;

  // Of a polyline that was made of this chain and has lost points since.
  std::vector<LeftOutPoint> left_out(const ExactPolyline& line) const;

  // Makes a segment exact, and its points no farther apart than that.
  void make_finer(int segment, double longest_px);

 private:
  // A point of the linear chain, and the segment that starts there.
  struct Station {
    // Beyond the segment: the sheet is the other one of a double cover.
    bool turns_over = false;
    bool is_tried = false;  // whether it was asked to be exact
    bool at_pinch = false;
    bool has_lost_cusp = false;
    int exact = none;
    // Points within the segment, in inside_; none: not worked out.
    int first_inside = none;
    int end_inside = none;
    double longest_px = std::numeric_limits<double>::infinity();  // between points up to the next
  };
  struct Exact {
    EdgePoint point;
    ContourSample sample;
  };

  std::size_t segments() const { return linear_.size() - (closed_ ? 0 : 1); }
  std::size_t after(std::size_t station) const {
    return station + 1 < linear_.size() ? station + 1 : 0;
  }
  bool turns_over(const EdgePoint& from, const EdgePoint& to) const;

  const EdgePoint& point(std::size_t station) const;
  bool is_exact(std::size_t station) const { return stations_[station].exact != none; }

  // Of kappa, as seen from the station's own triangle, and at the end of a segment.
  int sign(std::size_t station) const {
    const int exact = stations_[station].exact;
    if (exact == none) return linear_[station].cusp_function >= 0 ? -1 : 1;
    return exact_[idx(exact)].sample.kappa < 0 ? -1 : 1;
  }
  int sign_at_end(std::size_t segment) const {
    const int at_end = sign(after(segment));
    return stations_[segment].turns_over ? -at_end : at_end;
  }

  bool is_cusp_lost(std::size_t segment) const;
  // As long as nothing is solved.
  bool is_suspect(std::size_t segment) const;
  bool turns_off(std::size_t segment) const;
  bool drifts(std::size_t segment) const;
  double dilation_reach(const EdgePoint& point) const;
  void want_around(std::size_t station, Direction direction,
                   std::vector<std::uint8_t>& wanted) const;
  std::vector<std::size_t> near_suspects() const;

  void solve_station(std::size_t station);
  SolvedEdge solved_edge(const EdgePoint& point);
  SolvedEdge solve_edge(const EdgePoint& point);
  SolvedEdge solved_at(double fraction, const ContourValue& value, const EdgePoint& point) const;
  bool ascends(const EdgePoint& point) const;
  double sheet_of(const EdgePoint& point) const;
  void spread();

  Vec2 uv_at_end(std::size_t segment) const;
  std::optional<ExactKnot> knot_of(std::size_t station) const;
  void add_station(std::size_t station, const std::optional<ExactKnot>& knot,
                   ExactPolyline& line) const;
  void refine(std::size_t segment, const ExactKnot& start, const ExactKnot& end);
  void add_between(std::size_t segment, ExactPolyline& line) const;
  void add_linear_cusp(std::size_t segment, ExactPolyline& line) const;

  const Surface& surface_;
  LimitContour& contour_;
  const ContourFunctions& functions_;
  const Camera& camera_;
  SolvedEdges* solved_;
  ExactSegment segment_;
  bool closed_ = false;
  Span<const EdgePoint> linear_;
  std::vector<Station> stations_;  // (points of the linear chain)
  std::vector<Vec2> images_;       // of the linear points
  std::vector<Exact> exact_;
  std::vector<ContourKnot> inside_;
};

// From a place on a patch to its triangle.
SurfacePoint on_triangle(const PatchTriangle& patch, int triangle, const Vec2& uv);

}  // namespace illustrate
