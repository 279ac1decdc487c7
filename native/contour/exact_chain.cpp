#include "contour/exact_chain.h"

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

// Of the angle between a chord and the contour that only a triangle with too much in it has: 50
// degrees.
constexpr double troubled_cos = 0.643;

int sign(double x) { return x < 0 ? -1 : 1; }

}  // namespace

Vec2 patch_uv(const PatchTriangle& patch, int corner, double fraction) {
  return (1 - fraction) * patch.uv(corner) + fraction * patch.uv(next_corner(corner));
}

SurfacePoint on_triangle(const PatchTriangle& patch, int triangle, const Vec2& uv) {
  const Vec2 a = patch.uv(1) - patch.uv(0), b = patch.uv(2) - patch.uv(0), p = uv - patch.uv(0);
  const double area = cross(a, b);
  const double b1 = std::clamp(cross(p, b) / area, 0., 1.);
  const double b2 = std::clamp(cross(a, p) / area, 0., 1. - b1);
  return {triangle, b1, b2};
}

void ExactChain::solve(Span<const ChainPoint> linear, bool closed, bool everywhere) {
  closed_ = closed;
  read(linear);
  if (everywhere) {
    for (std::size_t i = 0; i < stations_.size(); ++i) solve_station(i);
  } else {
    for (const std::size_t i : near_suspects()) solve_station(i);
    spread();
  }
}

void ExactChain::make_finer(int segment, double longest_px) {
  double& longest = stations_[idx(segment)].longest_px;
  longest = std::min(longest, longest_px);
  solve_station(idx(segment));
  solve_station((idx(segment) + 1) % stations_.size());
}

std::vector<int> ExactChain::troubled() const {
  std::vector<int> triangles;
  for (std::size_t i = 0; i < segments(); ++i) {
    const Station &a = stations_[i], &b = stations_[(i + 1) % stations_.size()];
    if (!a.sample || !b.sample) continue;
    const Vec3 chord = (b.sample->position - a.sample->position).normalized();
    const double least = std::min(chord.dot(a.sample->tangent), chord.dot(b.sample->tangent));
    if (least < troubled_cos) triangles.push_back(a.point.on.triangle);
  }
  return triangles;
}

std::vector<ExactPoint> ExactChain::points() {
  std::vector<ExactPoint> result;
  Vec2 arrival = Vec2::Zero();
  for (std::size_t i = 0; i < segments(); ++i) {
    result.push_back(station_point(stations_[i]));
    result.back().arrival = arrival;
    const std::size_t first = result.size() - 1;
    arrival = emit(i, result);
    for (std::size_t k = first; k < result.size(); ++k) result[k].segment = static_cast<int>(i);
  }
  if (!closed_) result.push_back(station_point(stations_.back()));
  (closed_ ? result.front() : result.back()).arrival = arrival;
  return result;
}

void ExactChain::read(Span<const ChainPoint> linear) {
  stations_.clear();
  for (const ChainPoint& p : linear) {
    if (p.edge == none) continue;
    Station s;
    s.point = p;
    s.sign = -sign(functions_.cusp_function(p.on.triangle, p.edge, p.fraction));
    stations_.push_back(s);
  }
  for (std::size_t i = 0; i < segments(); ++i) link(stations_[i], next(i));
}

// Where `to` lies on the far edge of the triangle that `from` enters.
void ExactChain::link(Station& from, const Station& to) const {
  const int t = from.point.on.triangle;
  for (int k = 0; k < 3; ++k) {
    const bool crossed = functions_.front(t, k) != functions_.front(t, next_corner(k));
    if (k != from.point.edge && crossed) from.out = k;
  }
  const auto place = [&](int triangle, int corner) {
    return surface_.places[idx(surface_.triangles[idx(triangle)][idx(corner)])];
  };
  const bool same_way =
      from.out != none && place(t, from.out) == place(to.point.on.triangle, to.point.edge);
  from.next_fraction = same_way ? to.point.fraction : 1 - to.point.fraction;
}

bool ExactChain::has_both_signs(int triangle) const {
  int positive = 0;
  for (int k = 0; k < 3; ++k) positive += functions_.cusp_function(triangle, k, 0) >= 0;
  return positive == 1 || positive == 2;
}

bool ExactChain::is_suspect(std::size_t i) {
  if (!closed_ && (i == 0 || i + 1 == segments())) return true;
  return stations_[i].sign != next(i).sign || has_both_signs(stations_[i].point.on.triangle);
}

double ExactChain::dilation_reach(const Station& station) const {
  const Triangle& t = surface_.triangles[idx(station.point.on.triangle)];
  const Vec3& a = surface_.positions[idx(t[idx(station.point.edge)])];
  const Vec3& b = surface_.positions[idx(t[idx(next_corner(station.point.edge))])];
  const double edge_px = (b - a).norm() / camera_.pixel_size(station.point.position);
  return std::min(dilation_edges * edge_px, most_dilation_px);
}

void ExactChain::want_around(std::size_t i, bool forward, std::vector<std::uint8_t>& wanted) const {
  const std::size_t count = stations_.size();
  const Vec2 centre = camera_.project(stations_[i].point.position).xy;
  const double reach = dilation_reach(stations_[i]);
  wanted[i] = 1;
  for (std::size_t step = 1; step < count; ++step) {
    if (!closed_ && i == (forward ? count - 1 : 0)) return;
    i = forward ? (i + 1) % count : (i + count - 1) % count;
    const Vec2 image = camera_.project(stations_[i].point.position).xy;
    if (step > dilation && !((image - centre).norm() < reach)) return;
    wanted[i] = 1;
  }
}

std::vector<std::size_t> ExactChain::near_suspects() {
  std::vector<std::uint8_t> wanted(stations_.size(), 0);
  for (std::size_t i = 0; i < segments(); ++i) {
    if (!is_suspect(i)) continue;
    want_around(i, false, wanted);
    want_around((i + 1) % stations_.size(), true, wanted);
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
  const PatchTriangle& patch = surface_.patches[idx(station.point.on.triangle)];
  if (patch.ptex_face == none || !(camera_.near_distance(station.point.position) > 0)) return;
  const SolvedEdge& found = solved_edge(station);
  if (!found.sample) return;
  station.sample = found.sample;
  station.point.position = found.sample->position;
  const int t = station.point.on.triangle, k = station.point.edge;
  station.point.fraction = ascends(t, k) ? found.fraction : 1 - found.fraction;
  station.point.on = on_edge(t, k, station.point.fraction);
  if (i == 0 && !closed_) return;
  link(stations_[(i + stations_.size() - 1) % stations_.size()], station);
}

bool ExactChain::ascends(int triangle, int corner) const {
  const Triangle& t = surface_.triangles[idx(triangle)];
  return t[idx(corner)] < t[idx(next_corner(corner))];
}

const SolvedEdge& ExactChain::solved_edge(const Station& station) {
  const Triangle& t = surface_.triangles[idx(station.point.on.triangle)];
  const auto [low, high] =
      std::minmax(t[idx(station.point.edge)], t[idx(next_corner(station.point.edge))]);
  const std::uint64_t key =
      static_cast<std::uint64_t>(low) << 32 | static_cast<std::uint32_t>(high);
  const auto [found, is_new] = solved_.try_emplace(key);
  if (is_new) found->second = solve_edge(station);
  return found->second;
}

// Newton's method along the edge, kept between the last points found on either side of the zero.
SolvedEdge ExactChain::solve_edge(const Station& station) {
  constexpr int most_steps = 30;
  constexpr double end = 1e-5, flat = 1e-3;
  const int t = station.point.on.triangle, k = station.point.edge;
  const PatchTriangle& patch = surface_.patches[idx(t)];
  const Vec2 along = patch.uv(next_corner(k)) - patch.uv(k);
  const bool low_front = functions_.front(t, k);
  double low = end, high = 1 - end, f = station.point.fraction;
  std::optional<ContourSample> sample;
  for (int i = 0; i < most_steps; ++i) {
    sample = contour_.at({patch.ptex_face, patch_uv(patch, k, f)});
    if (!sample) return {};
    if (std::abs(sample->g) < on_contour || high - low < 1e-12) break;
    ((sample->g >= 0) == low_front ? low : high) = f;
    f -= sample->g / sample->gradient.dot(along);
    if (!(f > low && f < high)) f = (low + high) / 2;
  }
  if (std::abs(sample->g) > flat || sample->tangent.isZero()) return {};
  return {ascends(t, k) ? f : 1 - f, sample};
}

// Where an exact point and a linear one beside it disagree, the linear one must become exact too.
void ExactChain::spread() {
  for (bool again = true; again;) {
    again = false;
    for (std::size_t i = 0; i < segments(); ++i) {
      Station &a = stations_[i], &b = next(i);
      if (a.is_tried == b.is_tried || a.exact_sign() == b.exact_sign()) continue;
      const std::size_t linear = a.is_tried ? (i + 1) % stations_.size() : i;
      solve_station(linear);
      again = true;
    }
  }
}

ExactPoint ExactChain::station_point(const Station& station) const {
  ExactPoint result{station.point, camera_.project(station.point.position).xy, {}};
  if (station.sample) {
    const PatchTriangle& patch = surface_.patches[idx(station.point.on.triangle)];
    const Vec2 uv = patch_uv(patch, station.point.edge, station.point.fraction);
    result.knot = segment_.knot(uv, *station.sample);
  }
  return result;
}

Vec2 ExactChain::emit(std::size_t i, std::vector<ExactPoint>& result) {
  const Station &from = stations_[i], &to = next(i);
  const PatchTriangle& patch = surface_.patches[idx(from.point.on.triangle)];
  const bool on_patch = from.out != none && patch.ptex_face != none;
  const Vec2 end = on_patch ? patch_uv(patch, from.out, from.next_fraction) : Vec2(0, 0);
  if (on_patch && from.sample && to.sample)
    emit_exact(from, to, end, result);
  else
    emit_linear(from, to, result);
  return end;
}

void ExactChain::emit_linear(const Station& from, const Station& to,
                             std::vector<ExactPoint>& result) {
  if (from.exact_sign() == to.exact_sign()) return;
  const int t = from.point.on.triangle;
  const double c0 = functions_.cusp_function(t, from.point.edge, from.point.fraction);
  const double c1 =
      from.out == none ? -c0 : functions_.cusp_function(t, from.out, from.next_fraction);
  const double f = (c0 >= 0) != (c1 >= 0) ? c0 / (c0 - c1) : .5;
  const Vec3 step = to.point.position - from.point.position;
  ExactPoint cusp;
  cusp.point.position = from.point.position + f * step;
  cusp.point.on = locate(surface_, t, cusp.point.position);
  cusp.point.cusp_jump = step.dot(camera_.to_eye(cusp.point.position)) < 0 ? 1 : -1;
  cusp.image = camera_.project(cusp.point.position).xy;
  result.push_back(cusp);
}

void ExactChain::emit_exact(const Station& from, const Station& to, const Vec2& end,
                            std::vector<ExactPoint>& result) {
  const int t = from.point.on.triangle;
  const PatchTriangle& patch = surface_.patches[idx(t)];
  std::vector<ContourKnot> knots;
  segment_.refine(patch.ptex_face, *result.back().knot, segment_.knot(end, *to.sample),
                  from.longest_px, knots);
  for (const ContourKnot& knot : knots) {
    ExactPoint inside;
    inside.point.position = knot.sample.position;
    inside.point.on = on_triangle(patch, t, knot.uv);
    inside.point.cusp_jump = knot.cusp_jump();
    inside.image = knot.image;
    inside.knot = knot;
    inside.arrival = knot.uv;
    result.push_back(inside);
  }
}

}  // namespace illustrate
