#include "hatch/curves/surface_curves.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>

#include "hatch/curves/curve_cells.h"
#include "hatch/curves/field_walk.h"

namespace illustrate {
namespace {

// So many squares of the finest radius cover the object; radii grow by sqrt(2) a level.
constexpr double finest_squares = 60'000;
constexpr int levels = 9;

// No curve needs more points.
constexpr std::size_t most_points = 200'000;

// In radii of the level: where a curve ends before another, and the shortest that is kept.
constexpr double end_distance = 0.7;
constexpr double least_length = 1.5;

// In finest radii: between points of a curve.
constexpr double point_step = 0.6;

// An object's area may change so much, as a factor, before its seeds are spread anew.
constexpr double most_change = 2;

// Seeds for each square of a level's radius.
constexpr double seeds_per_square = 2.5;

// What seed i takes from the generalised golden ratios of three dimensions.
constexpr std::array<double, 3> seed_steps{0.6180339887498949, 0.7548776662466927,
                                           0.5698402909980532};

double fraction(double value) { return value - std::floor(value); }

struct CurvePlace {
  SurfacePoint on;
  CurveNode node;
};
using CurveLine = std::vector<CurvePlace>;

// Where curves may start: along the cross and across it.
struct CurveSeed {
  SurfacePoint on;
  Vec3 along, across;
};

// Of each seed, for both directions: a parallel curve is known to be so near, in finest radii.
using SeedBounds = std::vector<std::array<float, 2>>;

double area_of(const Surface& surface, const Triangle& corners) {
  const Vec3& origin = surface.positions[idx(corners[0])];
  const Vec3 u = surface.positions[idx(corners[1])] - origin;
  const Vec3 v = surface.positions[idx(corners[2])] - origin;
  const double area = u.cross(v).norm() / 2;
  return std::isfinite(area) ? area : 0;
}

// The areas that the seeds of these triangles are spread by. first: of all triangles, or empty.
std::vector<double> areas_for_seeds(const Surface& surface, const std::vector<int>& triangles,
                                    const std::vector<double>& first) {
  std::vector<double> now, then;
  for (const int t : triangles) {
    now.push_back(area_of(surface, surface.triangles[idx(t)]));
    if (!first.empty()) then.push_back(first[idx(t)]);
  }
  const auto sum = [](const std::vector<double>& a) {
    return std::accumulate(a.begin(), a.end(), 0.0);
  };
  const double before = sum(then), after = sum(now);
  return before > after / most_change && before < after * most_change ? then : now;
}

// Places spread evenly over the surface by area.
class EvenPlaces {
 public:
  EvenPlaces(std::vector<int> triangles, const std::vector<double>& areas)
      : triangles_(std::move(triangles)), area_to_(areas.size()) {
    std::partial_sum(areas.begin(), areas.end(), area_to_.begin());
    const auto count = static_cast<double>(areas.size());
    std::size_t at = 0;
    for (std::size_t k = 0; k <= areas.size(); ++k) {
      const double share_end = area() * (static_cast<double>(k) / count);
      while (at + 1 < areas.size() && area_to_[at] <= share_end) ++at;
      firsts_.push_back(at);
    }
  }

  double area() const { return area_to_.empty() ? 0 : area_to_.back(); }

  SurfacePoint place(std::size_t i) const {
    const auto turn = [&](std::size_t k) {
      return fraction(0.5 + seed_steps[k] * static_cast<double>(i));
    };
    const std::size_t found = triangle_at(turn(0));
    double b1 = turn(1), b2 = turn(2);
    if (b1 + b2 > 1) b1 = 1 - b1, b2 = 1 - b2;
    return {triangles_[found], b1, b2};
  }

 private:
  // Where a share of the area ends. A step to both sides is for the rounding of shares.
  std::size_t triangle_at(double share) const {
    const std::size_t last = area_to_.size() - 1;
    const auto k = static_cast<std::size_t>(share * static_cast<double>(area_to_.size()));
    const auto at = [&](std::size_t i) {
      return area_to_.begin() + static_cast<std::ptrdiff_t>(firsts_[std::min(i, last + 1)]);
    };
    const auto found = std::upper_bound(at(k > 0 ? k - 1 : 0), at(k + 2), share * area());
    return static_cast<std::size_t>(found - area_to_.begin());
  }

  std::vector<int> triangles_;
  std::vector<double> area_to_;      // of all triangles up to and with each one
  std::vector<std::size_t> firsts_;  // where equal shares of the area begin, as many as triangles
};

// The curves of one radius between those of all greater ones. Radius, steps and nodes are in finest
// radii, nodes from the box's corner: small numbers, whatever the surface's place and size.
class LevelBuilder {
 public:
  LevelBuilder(const FieldWalker& walker, const Eigen::AlignedBox3d& box, double finest,
               double radius, const std::vector<CurveLine>& coarser)
      : walker_(walker),
        surface_(walker.surface()),
        low_(box.min()),
        finest_(finest),
        radius_(static_cast<float>(radius)),
        stride_(std::max(1, static_cast<int>(radius / (3 * point_step)))),
        count_(coarser.size()),
        cells_(box.sizes() / finest, radius) {
    for (const CurveLine& line : coarser) {
      for (const CurvePlace& place : line) {
        if (place.node.index % stride_ == 0) cells_.add(place.node);
      }
    }
  }

  void grow(const CurveSeed& seed, std::array<float, 2>& bounds) {
    for (std::size_t k = 0; k < 2; ++k) {
      if (bounds[k] < radius_) continue;
      const Vec3& tangent = k == 0 ? seed.along : seed.across;
      const CurveNode first = node_at(seed.on, tangent, 0);
      bounds[k] = distance(first, radius_);
      if (bounds[k] < radius_) continue;
      if (grow({seed.on, first}, tangent)) bounds[k] = 0;
    }
  }

  std::vector<CurveLine> take() { return std::move(lines_); }

 private:
  CurveNode node_at(const SurfacePoint& on, const Vec3& tangent, int index) const {
    const Vec3 position = (position_at(surface_, on) - low_) / finest_;
    return {position.cast<float>(),
            tangent.cast<float>(),
            normal_at(surface_, on).cast<float>(),
            surface_.object_of(on.triangle),
            static_cast<int>(count_ + lines_.size()),
            index};
  }

  // To some parallel curve, or a far part of the same one, that is nearer than `reach`; infinite
  // where none is.
  float distance(const CurveNode& node, float reach) const {
    const float half = static_cast<float>(0.5 * point_step * stride_);
    const int own_reach = 1 + static_cast<int>(2 * radius_ / point_step);
    float found = std::numeric_limits<float>::infinity();
    cells_.any_near(node.position, reach + half, [&](const CurveNode& other) {
      const Eigen::Vector3f offset = node.position - other.position;
      const float along = offset.dot(other.tangent);
      const float beyond = std::max(std::abs(along) - half, 0.0F);
      const float square = offset.squaredNorm() - along * along + beyond * beyond;
      if (!(square < reach * reach) || other.object != node.object) return false;
      const float cosine = node.tangent.dot(other.tangent);
      if (2 * cosine * cosine < 1 || node.normal.dot(other.normal) < 0) return false;
      if (other.curve == node.curve && std::abs(other.index - node.index) <= own_reach) {
        return false;
      }
      found = std::sqrt(std::max(square, 0.0F));
      return true;
    });
    return found;
  }

  bool grow(const CurvePlace& first, const Vec3& tangent) {
    const std::size_t before = cells_.size();
    cells_.add(first.node);
    CurveLine line{first};
    extend(line, tangent, 1);
    std::reverse(line.begin(), line.end());
    extend(line, -tangent, -1);
    if (static_cast<double>(line.size() - 1) * point_step < least_length * radius_) {
      cells_.shrink(before);
      return false;
    }
    lines_.push_back(std::move(line));
    return true;
  }

  void extend(CurveLine& line, Vec3 tangent, int way) {
    SurfacePoint on = line.back().on;
    const double step = point_step * finest_;
    const float least = static_cast<float>(end_distance) * radius_;
    for (int index = way; line.size() < most_points; index += way) {
      const double rest = walker_.advance(on, tangent, step);
      if (rest >= step) return;
      const CurveNode node = node_at(on, tangent, index);
      if (distance(node, least) < least) return;
      line.push_back({on, node});
      if (index % stride_ == 0) cells_.add(node);
      if (rest > 0) return;
    }
  }

  const FieldWalker& walker_;
  const Surface& surface_;
  Vec3 low_;
  double finest_;  // world units
  float radius_;
  int stride_;
  std::size_t count_;  // of coarser curves
  CurveCells cells_;
  std::vector<CurveLine> lines_;
};

}  // namespace

class RankedCurves::Builder {
 public:
  Builder(const Surface& surface, const CrossField& field, std::vector<int> triangles,
          const std::vector<double>& areas)
      : surface_(surface), walker_(surface, field) {
    for (const int t : triangles) {
      for (const int vertex : surface.triangles[idx(t)]) {
        const Vec3& p = surface.positions[idx(vertex)];
        if (p.allFinite()) box_.extend(p);
      }
    }
    const std::vector<double> of_object = areas_for_seeds(surface, triangles, areas);
    places_.emplace(std::move(triangles), of_object);
    const double area = places_->area();
    finest_ = area > 0 && std::isfinite(area) ? std::sqrt(area / finest_squares) : 0;
  }

  // Levels count from the coarsest.
  int level_of(double radius) const {
    int level = 0;
    while (level + 1 < levels && radius_of(level) > radius) ++level;
    return level;
  }

  SurfaceCurves curves_to(int level, const Progress& progress) {
    if (!(finest_ > 0)) return {};
    // Each level has about twice the work of the one before.
    double work = 0, done = 0;
    for (int k = made(); k <= level; ++k) work += std::ldexp(1, k);
    for (int k = made(); k <= level; ++k) {
      const double share = std::ldexp(1, k) / work;
      make(k, progress.part(done, done + share));
      done += share;
    }
    SurfaceCurves result = seeds_to(level);
    int own_level = 0;
    for (std::size_t c = 0; c < ends_[idx(level)]; ++c) {
      while (c >= ends_[idx(own_level)]) ++own_level;
      for (const CurvePlace& place : lines_[c]) result.curves.push(place.on);
      result.curves.close_list();
      result.needed_below.push_back(own_level == 0 ? infinite : radius_of(own_level - 1));
    }
    return result;
  }

  SurfaceCurves seeds_to(int level) const {
    SurfaceCurves result;
    if (!(finest_ > 0)) return result;
    result.area = places_->area();
    result.step = step();
    for (std::size_t i = 0; i < seed_count(level); ++i) result.seeds.push_back(places_->place(i));
    return result;
  }

 private:
  double step() const { return point_step * finest_; }
  double radius_of(int level) const { return finest_ * std::pow(2, (levels - 1 - level) / 2.0); }
  int made() const { return static_cast<int>(ends_.size()); }
  std::size_t seed_count(int level) const {
    const double radius = radius_of(level) / finest_;
    return static_cast<std::size_t>(seeds_per_square * finest_squares / (radius * radius));
  }

  // Keeps nothing of a level that is not finished, or that was made meanwhile by a report's
  // receiver.
  void make(int level, const Progress& progress) {
    LevelBuilder builder(walker_, box_, finest_, radius_of(level) / finest_, lines_);
    SeedBounds bounds = bounds_;
    const std::size_t count = seed_count(level);
    bounds.resize(count, {infinite, infinite});
    for (std::size_t i = 0; i < count; ++i) {
      if (i % 512 == 0) progress.report(static_cast<double>(i) / static_cast<double>(count));
      if (i == seeds_.size()) seeds_.push_back(seed(i));
      builder.grow(seeds_[i], bounds[i]);
    }
    if (made() != level) return;
    bounds_ = std::move(bounds);
    for (CurveLine& line : builder.take()) lines_.push_back(std::move(line));
    ends_.push_back(lines_.size());
  }

  CurveSeed seed(std::size_t i) const {
    const SurfacePoint on = places_->place(i);
    const Vec3 normal = normal_at(surface_, on);
    const Vec3 along = cross_direction(surface_, walker_.field(), on, normal.unitOrthogonal());
    return {on, along, normal.cross(along)};
  }

  static constexpr float infinite = std::numeric_limits<float>::infinity();

  const Surface& surface_;
  FieldWalker walker_;
  std::optional<EvenPlaces> places_;
  Eigen::AlignedBox3d box_;
  double finest_ = 0;
  std::vector<CurveSeed> seeds_;
  SeedBounds bounds_;
  std::vector<CurveLine> lines_;   // of all levels that are made
  std::vector<std::size_t> ends_;  // of each of them, in `lines_`
};

std::vector<double> triangle_areas(const Surface& surface) {
  std::vector<double> areas;
  areas.reserve(surface.triangles.size());
  for (const Triangle& corners : surface.triangles) areas.push_back(area_of(surface, corners));
  return areas;
}

RankedCurves::RankedCurves(const Surface& surface, const CrossField& field,
                           std::vector<int> triangles, const std::vector<double>& areas)
    : builder_(std::make_unique<Builder>(surface, field, std::move(triangles), areas)),
      made_(levels),
      seeds_(levels) {}

RankedCurves::~RankedCurves() = default;

const SurfaceCurves& RankedCurves::down_to(double radius, const Progress& progress) {
  const std::lock_guard<std::recursive_mutex> lock(mutex_);
  progress.report(0);
  const int level = builder_->level_of(radius);
  if (!made_[idx(level)]) {
    auto curves = std::make_unique<const SurfaceCurves>(builder_->curves_to(level, progress));
    if (!made_[idx(level)]) made_[idx(level)] = std::move(curves);
  }
  progress.report(1);
  return *made_[idx(level)];
}

const SurfaceCurves& RankedCurves::seeds_to(double radius) {
  const std::lock_guard<std::recursive_mutex> lock(mutex_);
  const int level = builder_->level_of(radius);
  if (!seeds_[idx(level)]) {
    seeds_[idx(level)] = std::make_unique<const SurfaceCurves>(builder_->seeds_to(level));
  }
  return *seeds_[idx(level)];
}

}  // namespace illustrate
