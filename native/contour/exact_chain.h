// One silhouette chain made exact where it matters (exact_silhouettes.h).
#pragma once

#include <unordered_map>

#include "contour/exact_segment.h"
#include "contour/silhouettes.h"

namespace illustrate {

// A point of the chain that is being made.
struct ExactPoint {
  ChainPoint point;
  Vec2 image;
  // The point's place on the patch of on.triangle, where it is exact.
  std::optional<ContourKnot> knot;
  Vec2 arrival = Vec2::Zero();  // its place on the patch of the triangle before it
  int segment = none;           // of the linear chain, that the point starts or lies on

  bool is_cusp() const { return point.cusp_jump != 0; }
};

// What was found on the edges of a surface, by their lower and higher vertices; `fraction` runs
// from the lower one. Stays true as long as the vertices keep their numbers.
struct SolvedEdge {
  double fraction = 0;
  std::optional<ContourSample> sample;
};
using SolvedEdges = std::unordered_map<std::uint64_t, SolvedEdge>;

class ExactChain {
 public:
  // `solved` is read and filled.
  ExactChain(const Surface& surface, LimitContour& contour, const ContourFunctions& functions,
             const Camera& camera, SolvedEdges& solved)
      : surface_(surface),
        contour_(contour),
        functions_(functions),
        camera_(camera),
        solved_(solved),
        segment_(contour, camera) {}

  // Finds the exact points of a chain of silhouettes.h; everywhere: all of them.
  void solve(Span<const ChainPoint> linear, bool closed, bool everywhere);

  // Triangles whose segment runs far from the contour's direction at an end: they hold more of the
  // contour than the signs at their corners tell.
  std::vector<int> troubled() const;

  // The chain that was solved, with what lies within its triangles.
  std::vector<ExactPoint> points();

  // Makes a segment exact, and its points no farther apart than that.
  void make_finer(int segment, double longest_px);

 private:
  // A point of the chain on an edge.
  struct Station {
    ChainPoint point;
    int sign = 0;           // of the interpolated kappa
    bool is_tried = false;  // whether it was asked to be exact
    std::optional<ContourSample> sample;
    double next_fraction = 0;  // of the next station on the edge where this one's triangle ends
    int out = none;            // that edge
    double longest_px = std::numeric_limits<double>::infinity();  // between points up to the next

    int exact_sign() const { return !sample ? sign : sample->kappa < 0 ? -1 : 1; }
  };

  void read(Span<const ChainPoint> linear);
  void link(Station& from, const Station& to) const;
  std::size_t segments() const { return stations_.size() - (closed_ ? 0 : 1); }
  Station& next(std::size_t i) { return stations_[(i + 1) % stations_.size()]; }

  bool is_suspect(std::size_t segment);
  bool has_both_signs(int triangle) const;
  double dilation_reach(const Station& station) const;
  void want_around(std::size_t station, bool forward, std::vector<std::uint8_t>& wanted) const;
  std::vector<std::size_t> near_suspects();
  void solve_station(std::size_t station);
  bool ascends(int triangle, int corner) const;
  SolvedEdge solve_edge(const Station& station);
  const SolvedEdge& solved_edge(const Station& station);
  void spread();

  // Returns where the segment arrives on its patch.
  Vec2 emit(std::size_t segment, std::vector<ExactPoint>& result);
  void emit_linear(const Station& from, const Station& to, std::vector<ExactPoint>& result);
  void emit_exact(const Station& from, const Station& to, const Vec2& end,
                  std::vector<ExactPoint>& result);
  ExactPoint station_point(const Station& station) const;

  const Surface& surface_;
  LimitContour& contour_;
  const ContourFunctions& functions_;
  const Camera& camera_;
  SolvedEdges& solved_;
  ExactSegment segment_;
  bool closed_ = false;
  std::vector<Station> stations_;
};

// The place of a triangle's edge point on its patch, and back from a place to the triangle.
Vec2 patch_uv(const PatchTriangle& patch, int corner, double fraction);
SurfacePoint on_triangle(const PatchTriangle& patch, int triangle, const Vec2& uv);

}  // namespace illustrate
