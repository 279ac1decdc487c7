#include "contour/intersection/meetings.h"

#include <algorithm>

#include "contour/contour_functions.h"
#include "contour/exact/steady_signs.h"

namespace illustrate {
namespace {

// Of a chain whose triangles tell another nearer side than they did before: a pinch point lies
// between, less is noise.
constexpr double pinch_px = 5;

// -1 where two triangles side by side belong to different sheets of a double cover: their normals
// are opposite.
int turn_between(const Surface& surface, int s, int t) {
  for (int j = 0; j < 3; ++j) {
    for (int k = 0; k < 3; ++k) {
      if (surface.triangles[idx(s)][idx(j)] != surface.triangles[idx(t)][idx(k)]) continue;
      return surface.corner_sign(s, j) == surface.corner_sign(t, k) ? 1 : -1;
    }
  }
  return 1;
}

// Whether the front of a chain's surface is its nearer strand, segment by segment: another one
// behind each cusp, and behind a pinch point, which is known by nothing else.
std::vector<std::uint8_t> nearness_along(const Surface& surface, const Camera& camera,
                                         const Silhouettes& silhouettes, int number) {
  const Span<const ChainPoint> chain = silhouettes.chains[idx(number)];
  auto passed = std::lower_bound(silhouettes.passed.begin(), silhouettes.passed.end(), number,
                                 [](const PassedEdge& p, int n) { return p.chain < n; });
  int turn = 1, here = chain[0].on.triangle;
  const auto enter = [&](int triangle) {
    turn *= turn_between(surface, here, triangle);
    here = triangle;
  };
  std::vector<int> turns;
  std::vector<double> sides_px;
  for (std::size_t i = 0; i < chain.size(); ++i) {
    enter(chain[i].on.triangle);
    if (i > 0 && chain[i].cusp_jump != 0) turn = -turn;
    turns.push_back(turn);
    // The image of the contour runs as that of n x r, r the line of sight, if the front is near.
    const Vec3& from = chain[i].position;
    const Vec3 along = chain[(i + 1) % chain.size()].position - from;
    const Vec3 across = camera.to_eye(from).normalized().cross(face_normal(surface, here));
    sides_px.push_back(turn * along.dot(across) / camera.pixel_size(from));
    for (;
         passed != silhouettes.passed.end() && passed->chain == number && idx(passed->segment) == i;
         ++passed) {
      enter(passed->point.on.triangle);
    }
  }
  const std::vector<int> signs = steady_signs(sides_px, pinch_px);
  std::vector<std::uint8_t> front_is_near;
  for (std::size_t i = 0; i < turns.size(); ++i) front_is_near.push_back(turns[i] * signs[i] > 0);
  return front_is_near;
}

// Whether the segments a b and c d cross, at f and h of their ways. What lies on a line counts as
// on its left, so that polylines cross as often as they must also at each other's points.
bool cross_evenly(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d, double& f,
                  double& h) {
  const double ca = cross(b - a, c - a), da = cross(b - a, d - a);
  const double ac = cross(d - c, a - c), bc = cross(d - c, b - c);
  if ((ca >= 0) == (da >= 0) || (ac >= 0) == (bc >= 0)) return false;
  f = ac / (ac - bc);
  h = ca / (ca - da);
  return true;
}

// Where a chain crosses an intersection curve on one of the curve's two sheets.
struct Pass {
  Meeting meeting;
  int sheet;      // 0 or 1
  bool to_front;  // the curve runs to the left of the chain, where the sheet is a front
};

class CurveMeetings {
 public:
  CurveMeetings(const Surface& surface, const Silhouettes& silhouettes,
                const PiecesByTriangle& pieces, const IntersectionCurves& intersections, int curve,
                const Camera& camera)
      : surface_(surface),
        silhouettes_(silhouettes),
        pieces_(pieces),
        intersections_(intersections),
        curve_(curve),
        points_(intersections.curves[idx(curve)]),
        sheets_(intersections.segment_triangles.data() + intersections.curves.offsets[idx(curve)]),
        segments_(static_cast<int>(points_.size()) - (intersections.closed[idx(curve)] ? 0 : 1)),
        camera_(camera) {}

  // `near` keeps what `nearness_along` tells of the chains that were met.
  void run(std::vector<std::vector<std::uint8_t>>& near, std::vector<Meeting>& result) {
    for (int i = 0; i < segments_; ++i) {
      for (int sheet = 0; sheet < 2; ++sheet) pass_segment(i, sheet);
    }
    if (passes_.empty()) return;
    follow_sheets();
    for (Pass& pass : passes_) {
      std::vector<std::uint8_t>& front_is_near = near[idx(pass.meeting.chain)];
      if (front_is_near.empty()) {
        front_is_near = nearness_along(surface_, camera_, silhouettes_, pass.meeting.chain);
      }
      const bool is_near = front_is_near[idx(pass.meeting.chain_segment)];
      pass.meeting.curve_change = pass.to_front == is_near ? -1 : 1;
      pass.meeting.chain_change = change_through(pass);
      result.push_back(pass.meeting);
    }
  }

 private:
  int triangle(int i, int sheet) const { return sheets_[i][idx(sheet)]; }
  const Vec3& start(int i) const { return points_[idx(i)].position; }
  const Vec3& end(int i) const { return points_[(idx(i) + 1) % points_.size()].position; }

  void pass_segment(int i, int sheet) {
    const int t = triangle(i, sheet);
    const Span<const CurvePiece> pieces = pieces_[t];
    if (pieces.empty()) return;
    const auto [from, to] = ends_on_sheet(surface_, intersections_, curve_, i, sheet);
    for (const CurvePiece& p : pieces) {
      double f, h;
      if (!cross_evenly(from, to, p.start, p.end, f, h)) continue;
      h = p.from + h * (p.to - p.from);
      const Span<const ChainPoint> chain = silhouettes_.chains[idx(p.curve)];
      const Vec3& a = chain[idx(p.segment)].position;
      const Vec3& b = chain[(idx(p.segment) + 1) % chain.size()].position;
      const bool to_front = cross(p.end - p.start, to - from) > 0;
      passes_.push_back(
          {{p.curve, p.segment, h, curve_, i, f, a + h * (b - a), 0, 0}, sheet, to_front});
    }
  }

  // How the sheets' windings turn over along the curve, and which way the curve runs between them.
  void follow_sheets() {
    std::array<double, 2> facings{0, 0};
    double handedness = 0;
    turns_.assign(idx(segments_), {1, 1});
    for (int i = 0; i < segments_; ++i) {
      std::array<Vec3, 2> normals;
      for (const std::size_t k : {0U, 1U}) {
        const int t = sheets_[i][k];
        if (i > 0)
          turns_[idx(i)][k] = turns_[idx(i - 1)][k] * turn_between(surface_, sheets_[i - 1][k], t);
        normals[k] = turns_[idx(i)][k] * face_normal(surface_, t);
        facings[k] += normals[k].dot(camera_.to_eye(start(i))) * (end(i) - start(i)).norm();
      }
      handedness += normals[0].cross(normals[1]).dot(end(i) - start(i));
    }
    is_front_as_a_whole_ = {facings[0] >= 0, facings[1] >= 0};
    is_right_handed_ = handedness >= 0;
    for (const int sheet : {0, 1}) {
      for (const Pass& pass : passes_) {
        if (pass.sheet == sheet) by_sheet_[idx(sheet)].push_back(&pass);
      }
      std::sort(by_sheet_[idx(sheet)].begin(), by_sheet_[idx(sheet)].end(), runs_before);
    }
  }

  static bool runs_before(const Pass* a, const Pass* b) {
    const Meeting &m = a->meeting, &n = b->meeting;
    return m.curve_segment != n.curve_segment ? m.curve_segment < n.curve_segment
                                              : m.curve_fraction < n.curve_fraction;
  }

  // Whether a sheet is front-facing, as it was wound where the curve starts, at a pass over the
  // other one.
  bool is_front(int sheet, const Pass& at) const {
    const std::vector<const Pass*>& passes = by_sheet_[idx(sheet)];
    if (passes.empty()) return is_front_as_a_whole_[idx(sheet)];
    const auto next = std::upper_bound(passes.begin(), passes.end(), &at, runs_before);
    const Pass& known = next == passes.begin() ? **next : **(next - 1);
    const bool turned = turns_[idx(known.meeting.curve_segment)][idx(sheet)] < 0;
    return (known.to_front == (next != passes.begin())) != turned;
  }

  // The chain crosses the curve from its left to its right if the curve runs to the front.
  int change_through(const Pass& pass) const {
    const int other = 1 - pass.sheet;
    const bool turned = turns_[idx(pass.meeting.curve_segment)][idx(pass.sheet)] < 0;
    const bool along_normal = (pass.to_front != turned) == (is_right_handed_ == (pass.sheet == 0));
    return is_front(other, pass) == along_normal ? -1 : 1;
  }

  const Surface& surface_;
  const Silhouettes& silhouettes_;
  const PiecesByTriangle& pieces_;
  const IntersectionCurves& intersections_;
  int curve_;
  Span<const IntersectionPoint> points_;
  const std::array<int, 2>* sheets_;  // (segments)
  int segments_;
  const Camera& camera_;
  std::vector<Pass> passes_;
  std::array<std::vector<const Pass*>, 2> by_sheet_;  // in the order of the curve
  std::vector<std::array<int, 2>> turns_;             // (segments)
  std::array<bool, 2> is_front_as_a_whole_{};
  bool is_right_handed_ = true;
};

}  // namespace

std::vector<Meeting> find_meetings(const Surface& surface, const Silhouettes& silhouettes,
                                   const PiecesByTriangle& pieces,
                                   const IntersectionCurves& intersections, const Camera& camera) {
  std::vector<std::vector<std::uint8_t>> near(silhouettes.chains.size());
  std::vector<Meeting> result;
  for (int c = 0; c < static_cast<int>(intersections.curves.size()); ++c) {
    CurveMeetings(surface, silhouettes, pieces, intersections, c, camera).run(near, result);
  }
  return result;
}

}  // namespace illustrate
