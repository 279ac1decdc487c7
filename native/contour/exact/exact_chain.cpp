#include "contour/exact/exact_chain.h"

#include <algorithm>
#include <cmath>

#include "surface/locate.h"

namespace illustrate {
namespace {

// Points to each side of a suspected cusp that are made exact with it, and how far from it in the
// image, in edges of its triangle: strands leave a cusp close together, and the finer the triangles
// are the nearer to each other linear points can follow them.
constexpr int dilation = 3;
constexpr double dilation_edges = 1;
constexpr double most_dilation_px = 3;

// Where the image of a linear chain bends by more than the angle with this tangent, its segments
// are to run no farther than this off the contour's direction.
constexpr double least_bend = 0.2, most_drift_px = 0.5;

// Of the angle between a chord and the contour that only a triangle with too much in it has: 50
// degrees.
constexpr double troubled_cos = 0.643;

// A cusp that was found has a smaller |kappa|, and lies no farther beyond its triangle's edges.
constexpr double lost_kappa = 0.1, beyond_edge = 0.01;

Vec2 patch_uv(const PatchTriangle& patch, int corner, double fraction) {
  return (1 - fraction) * patch.uv(corner) + fraction * patch.uv(next_corner(corner));
}

// A little beyond its edges too.
bool is_within(const PatchTriangle& patch, const Vec2& uv) {
  const Vec2 a = patch.uv(1) - patch.uv(0), b = patch.uv(2) - patch.uv(0), p = uv - patch.uv(0);
  const double area = cross(a, b), b1 = cross(p, b) / area, b2 = cross(a, p) / area;
  return std::min({b1, b2, 1 - b1 - b2}) > -beyond_edge;
}

// The same point of the contour on the other sheet of a double cover.
void turn_over(ContourSample& sample) {
  sample.g = -sample.g;
  sample.across = -sample.across;
  sample.kappa = -sample.kappa;
}

}  // namespace

SurfacePoint on_triangle(const PatchTriangle& patch, int triangle, const Vec2& uv) {
  const Vec2 a = patch.uv(1) - patch.uv(0), b = patch.uv(2) - patch.uv(0), p = uv - patch.uv(0);
  const double area = cross(a, b);
  const double b1 = std::clamp(cross(p, b) / area, 0., 1.);
  const double b2 = std::clamp(cross(a, p) / area, 0., 1. - b1);
  return {triangle, b1, b2};
}

void ExactChain::solve(Span<const EdgePoint> linear, bool closed, Exactness exactness) {
  linear_ = linear;
  closed_ = closed;
  exact_.clear();
  inside_.clear();
  stations_.assign(linear.size(), {});
  for (std::size_t i = 0; i < segments(); ++i) {
    stations_[i].turns_over = turns_over(linear[i], linear[after(i)]);
  }
  if (exactness == Exactness::everywhere) {
    for (std::size_t i = 0; i < stations_.size(); ++i) solve_station(i);
    return;
  }
  images_.clear();
  for (const EdgePoint& p : linear) images_.push_back(camera_.project(p.position).xy);
  for (const std::size_t i : near_suspects()) solve_station(i);
  spread();
}

// Triangles of one sheet run along their edge in opposite directions.
bool ExactChain::turns_over(const EdgePoint& from, const EdgePoint& to) const {
  const Triangle& here = surface_.triangles[idx(from.on.triangle)];
  const Triangle& there = surface_.triangles[idx(to.on.triangle)];
  const int start = here[idx(from.out)];
  if (&here == &there || start == there[idx(next_corner(to.edge))]) return false;
  return surface_.places[idx(start)] == surface_.places[idx(there[idx(to.edge)])];
}

const EdgePoint& ExactChain::point(std::size_t i) const {
  const int exact = stations_[i].exact;
  return exact == none ? linear_[i] : exact_[idx(exact)].point;
}

bool ExactChain::is_suspect(std::size_t i) const {
  if (linear_[i].is_unseen) return false;
  if (!closed_ && (i == 0 || i + 1 == segments())) return true;
  const EdgePoint &from = linear_[i], &to = linear_[after(i)];
  const bool changes_sign = (from.cusp_function >= 0) != (to.cusp_function >= 0);
  return from.has_both_signs || changes_sign != stations_[i].turns_over || turns_off(i);
}

// Whether the image turns back where the segment ends, as if at a cusp that nothing else tells of,
// or bends there to or from a segment that drifts.
bool ExactChain::turns_off(std::size_t i) const {
  if (!closed_ && i + 1 == segments()) return false;
  const std::size_t next = after(i);
  const Vec2 in = images_[next] - images_[i], out = images_[after(next)] - images_[next];
  const double ahead = in.dot(out);
  if (ahead < 0) return true;
  return std::abs(cross(in, out)) > least_bend * ahead && (drifts(i) || drifts(next));
}

// Whether the segment leaves the contour's direction, that of the tangent planes: where the surface
// is nearly edge-on far and wide, a zero that is a little wrong lies far from the contour, in the
// image too, inside the outline.
bool ExactChain::drifts(std::size_t i) const {
  const EdgePoint &from = linear_[i], &to = linear_[after(i)];
  const double sheet = stations_[i].turns_over ? -1 : 1;
  const Vec3 normal = (normal_at(surface_, from.on) + sheet * normal_at(surface_, to.on)) / 2;
  const double off = normal.dot(to.position - from.position);
  return std::abs(off) > most_drift_px * camera_.pixel_size(from.position);
}

double ExactChain::dilation_reach(const EdgePoint& p) const {
  const Triangle& t = surface_.triangles[idx(p.on.triangle)];
  const Vec3& a = surface_.positions[idx(t[idx(p.edge)])];
  const Vec3& b = surface_.positions[idx(t[idx(next_corner(p.edge))])];
  const double edge_px = (b - a).norm() / camera_.pixel_size(p.position);
  return std::min(dilation_edges * edge_px, most_dilation_px);
}

void ExactChain::want_around(std::size_t i, Direction direction,
                             std::vector<std::uint8_t>& wanted) const {
  const bool forward = direction == Direction::forward;
  const std::size_t count = stations_.size();
  const Vec2& centre = images_[i];
  const double reach = dilation_reach(linear_[i]);
  wanted[i] = 1;
  for (std::size_t step = 1; step < count; ++step) {
    if (!closed_ && i == (forward ? count - 1 : 0)) return;
    i = forward ? after(i) : (i == 0 ? count : i) - 1;
    if (step > dilation && !((images_[i] - centre).norm() < reach)) return;
    wanted[i] = 1;
  }
}

std::vector<std::size_t> ExactChain::near_suspects() const {
  std::vector<std::uint8_t> wanted(stations_.size(), 0);
  for (std::size_t i = 0; i < segments(); ++i) {
    if (!is_suspect(i)) continue;
    want_around(i, Direction::backward, wanted);
    want_around(after(i), Direction::forward, wanted);
  }
  std::vector<std::size_t> result;
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    if (wanted[i]) result.push_back(i);
  }
  return result;
}

void ExactChain::solve_station(std::size_t i) {
  Station& station = stations_[i];
  if (station.is_tried) return;
  station.is_tried = true;
  const EdgePoint& p = linear_[i];
  const int t = p.on.triangle;
  if (surface_.patches[idx(t)].ptex_face == none) return;
  if (!(camera_.near_distance(p.position) > 0)) return;
  const SolvedEdge found = solved_edge(p);
  station.at_pinch = found.at_pinch;
  if (!found.sample) return;
  station.exact = static_cast<int>(exact_.size());
  Exact exact{p, *found.sample};
  if (found.sheet != sheet_of(p)) turn_over(exact.sample);
  exact.point.position = found.sample->position;
  exact.point.fraction = ascends(p) ? found.fraction : 1 - found.fraction;
  exact.point.on = on_edge(t, p.edge, exact.point.fraction);
  exact_.push_back(exact);
}

// Whether the point's edge runs from its lower vertex to the higher one.
bool ExactChain::ascends(const EdgePoint& p) const {
  const Triangle& t = surface_.triangles[idx(p.on.triangle)];
  return t[idx(p.edge)] < t[idx(next_corner(p.edge))];
}

double ExactChain::sheet_of(const EdgePoint& p) const {
  return surface_.corner_sign(p.on.triangle, ascends(p) ? p.edge : next_corner(p.edge));
}

SolvedEdge ExactChain::solved_edge(const EdgePoint& p) {
  if (!solved_) return solve_edge(p);
  const Triangle& t = surface_.triangles[idx(p.on.triangle)];
  const auto [low, high] = std::minmax(t[idx(p.edge)], t[idx(next_corner(p.edge))]);
  const std::uint64_t key =
      static_cast<std::uint64_t>(low) << 32 | static_cast<std::uint32_t>(high);
  const auto [found, is_new] = solved_->try_emplace(key);
  if (is_new) found->second = solve_edge(p);
  return found->second;
}

// Newton's method along the edge, kept between the last points found on either side of the zero.
SolvedEdge ExactChain::solve_edge(const EdgePoint& p) {
  constexpr int most_steps = 30;
  constexpr double end = 1e-5, flat = 1e-3;
  const int t = p.on.triangle, k = p.edge;
  const PatchTriangle& patch = surface_.patches[idx(t)];
  const Vec2 along = patch.uv(next_corner(k)) - patch.uv(k);
  const bool low_front = functions_.front(t, k);
  double low = end, high = 1 - end, f = p.fraction;
  for (int i = 1;; ++i) {
    const std::optional<ContourValue> value = contour_.at({patch.ptex_face, patch_uv(patch, k, f)});
    if (!value) return {};
    if (std::abs(value->g) < on_contour || high - low < 1e-12 || i == most_steps) {
      if (std::abs(value->g) > flat) return {0, 1, {}, value->spread() < pinch_spread};
      return solved_at(f, *value, p);
    }
    ((value->g >= 0) == low_front ? low : high) = f;
    f -= value->g / value->gradient.dot(along);
    if (!(f > low && f < high)) f = (low + high) / 2;
  }
}

SolvedEdge ExactChain::solved_at(double fraction, const ContourValue& value,
                                 const EdgePoint& p) const {
  const ContourSample sample = LimitContour::sample(value);
  if (sample.tangent.isZero()) return {};
  return {ascends(p) ? fraction : 1 - fraction, sheet_of(p), sample, false};
}

// Where an exact point and a linear one beside it disagree, the linear one must become exact too.
void ExactChain::spread() {
  for (bool again = true; again;) {
    again = false;
    for (std::size_t i = 0; i < segments(); ++i) {
      const Station &a = stations_[i], &b = stations_[after(i)];
      if (linear_[i].is_unseen) continue;
      if (a.is_tried == b.is_tried || sign(i) == sign_at_end(i)) continue;
      solve_station(a.is_tried ? after(i) : i);
      again = true;
    }
  }
}

// Whether the cusp that the signs at the ends of the segment refined last tell of was not found
// within its triangle: the contour makes an excursion over an edge.
bool ExactChain::is_cusp_lost(std::size_t i) const {
  const std::optional<ContourKnot>& cusp = segment_.cusp();
  if (!cusp) return false;
  const PatchTriangle& patch = surface_.patches[idx(linear_[i].on.triangle)];
  return std::abs(cusp->sample.kappa) > lost_kappa || !is_within(patch, cusp->uv);
}

std::vector<int> ExactChain::troubled() const {
  std::vector<int> triangles;
  for (std::size_t i = 0; i < segments(); ++i) {
    const Station &a = stations_[i], &b = stations_[after(i)];
    if (linear_[i].is_unseen || a.exact == none || b.exact == none) continue;
    const ContourSample &from = exact_[idx(a.exact)].sample, &to = exact_[idx(b.exact)].sample;
    const Vec3 chord = (to.position - from.position).normalized();
    const double least = std::min(chord.dot(from.tangent), chord.dot(to.tangent));
    if (least < troubled_cos || a.has_lost_cusp) triangles.push_back(linear_[i].on.triangle);
  }
  return triangles;
}

void ExactChain::make_finer(int segment, double longest_px) {
  double& longest = stations_[idx(segment)].longest_px;
  longest = std::min(longest, longest_px);
  stations_[idx(segment)].first_inside = none;
  solve_station(idx(segment));
  solve_station(after(idx(segment)));
}

ExactPolyline ExactChain::polyline() {
  ExactPolyline line;
  line.closed = closed_;
  line.edges = static_cast<int>(stations_.size());
  line.points.reserve(stations_.size() + exact_.size());
  line.knots.reserve(3 * exact_.size());
  std::optional<ExactKnot> here = knot_of(0);
  for (std::size_t i = 0; i < segments(); ++i) {
    std::optional<ExactKnot> next = knot_of(after(i));
    add_station(i, here, line);
    if (here && next) {
      if (stations_[i].first_inside == none) refine(i, *here, *next);
      add_between(i, line);
    } else if (!linear_[i].is_unseen && sign(i) != sign_at_end(i)) {
      add_linear_cusp(i, line);
    }
    here = std::move(next);
  }
  if (!closed_) add_station(stations_.size() - 1, here, line);
  return line;
}

std::vector<LeftOutPoint> ExactChain::left_out(const ExactPolyline& line) const {
  std::vector<LeftOutPoint> result;
  const std::size_t count = line.points.size();
  for (std::size_t i = 0; i + (closed_ ? 0 : 1) < count; ++i) {
    const ExactPoint& next = line.points[(i + 1) % count];
    const std::size_t first = after(idx(line.points[i].segment));
    const std::size_t end = next.edge == none ? after(idx(next.segment)) : idx(next.segment);
    for (std::size_t k = first; k != end; k = after(k)) {
      result.push_back({static_cast<int>(i), point(k)});
    }
  }
  return result;
}

// Where the next station lies on the patch of a segment's triangle.
Vec2 ExactChain::uv_at_end(std::size_t i) const {
  const EdgePoint &from = point(i), &to = point(after(i));
  const bool is_tip = from.on.triangle == to.on.triangle;
  const bool same_way = is_tip || stations_[i].turns_over;
  return patch_uv(surface_.patches[idx(from.on.triangle)], from.out,
                  same_way ? to.fraction : 1 - to.fraction);
}

std::optional<ExactKnot> ExactChain::knot_of(std::size_t i) const {
  if (!is_exact(i)) return {};
  const auto& [p, sample] = exact_[idx(stations_[i].exact)];
  const PatchTriangle& patch = surface_.patches[idx(p.on.triangle)];
  const ContourKnot leaving = segment_.knot(patch_uv(patch, p.edge, p.fraction), sample);
  ExactKnot knot{leaving, leaving};
  if (i == 0 && !closed_) return knot;
  const std::size_t before = (i == 0 ? stations_.size() : i) - 1;
  ContourSample seen = sample;
  if (stations_[before].turns_over) turn_over(seen);
  knot.arriving = segment_.knot(uv_at_end(before), seen);
  return knot;
}

void ExactChain::add_station(std::size_t i, const std::optional<ExactKnot>& knot,
                             ExactPolyline& line) const {
  line.points.push_back({point(i), none, static_cast<int>(i)});
  if (!knot) return;
  line.points.back().knot = static_cast<int>(line.knots.size());
  line.knots.push_back(*knot);
}

// Of a segment between exact points, whose ends stay as they are from then on.
void ExactChain::refine(std::size_t i, const ExactKnot& start, const ExactKnot& end) {
  Station& station = stations_[i];
  const PatchTriangle& patch = surface_.patches[idx(linear_[i].on.triangle)];
  station.first_inside = static_cast<int>(inside_.size());
  segment_.refine(patch.ptex_face, start.leaving, end.arriving, station.longest_px, inside_);
  station.end_inside = static_cast<int>(inside_.size());
  station.has_lost_cusp = is_cusp_lost(i);
}

void ExactChain::add_between(std::size_t i, ExactPolyline& line) const {
  const int t = linear_[i].on.triangle;
  const PatchTriangle& patch = surface_.patches[idx(t)];
  for (int k = stations_[i].first_inside; k < stations_[i].end_inside; ++k) {
    const ContourKnot& knot = inside_[idx(k)];
    ExactPoint inside;
    inside.position = knot.sample.position;
    inside.on = on_triangle(patch, t, knot.uv);
    inside.cusp_jump = knot.cusp_jump();
    inside.segment = static_cast<int>(i);
    inside.knot = static_cast<int>(line.knots.size());
    line.knots.push_back({knot, knot});
    line.points.push_back(inside);
  }
}

// Where the signs at the ends of a segment differ, at least one of which is not exact.
void ExactChain::add_linear_cusp(std::size_t i, ExactPolyline& line) const {
  if (stations_[i].at_pinch || stations_[after(i)].at_pinch) return;
  const EdgePoint &from = point(i), &to = point(after(i));
  const double at_end = stations_[i].turns_over ? -to.cusp_function : to.cusp_function;
  const double span = from.cusp_function - at_end;
  const bool changes = (from.cusp_function >= 0) != (at_end >= 0);
  const double fraction = changes ? from.cusp_function / span : .5;
  const Vec3 step = to.position - from.position;
  ExactPoint cusp;
  cusp.position = from.position + fraction * step;
  cusp.on = nearest_on(surface_, from.on.triangle, cusp.position);
  cusp.cusp_jump = step.dot(camera_.to_eye(cusp.position)) < 0 ? 1 : -1;
  cusp.segment = static_cast<int>(i);
  line.points.push_back(cusp);
}

}  // namespace illustrate
