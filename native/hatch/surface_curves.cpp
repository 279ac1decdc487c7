#include "hatch/surface_curves.h"

#include <algorithm>
#include <cmath>

#include "hatch/curve_cells.h"
#include "hatch/field_walk.h"

namespace illustrate {
namespace {

// So many squares of the finest radius cover the surface; radii grow by sqrt(2) a level.
constexpr double finest_squares = 60'000;
constexpr int levels = 9;

// In radii of the level: where a curve ends before another, and the shortest that is kept.
constexpr double end_distance = 0.7;
constexpr double least_length = 1.5;

// In finest radii: between points of a curve.
constexpr double point_step = 0.6;

// All seeds there are.
constexpr std::size_t seed_total = 150'000;

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

// Places spread evenly over the surface by area.
class EvenPlaces {
 public:
  explicit EvenPlaces(const Surface& surface) {
    double sum = 0;
    for (const Triangle& corner : surface.triangles) {
      const Vec3& origin = surface.positions[idx(corner[0])];
      const Vec3 u = surface.positions[idx(corner[1])] - origin;
      const Vec3 v = surface.positions[idx(corner[2])] - origin;
      const double area = u.cross(v).norm() / 2;
      sum += std::isfinite(area) ? area : 0;
      area_to_.push_back(sum);
    }
  }

  double area() const { return area_to_.empty() ? 0 : area_to_.back(); }

  SurfacePoint place(std::size_t i) const {
    const auto turn = [&](std::size_t k) {
      return fraction(0.5 + seed_steps[k] * static_cast<double>(i));
    };
    const auto found = std::upper_bound(area_to_.begin(), area_to_.end() - 1, turn(0) * area());
    double b1 = turn(1), b2 = turn(2);
    if (b1 + b2 > 1) b1 = 1 - b1, b2 = 1 - b2;
    return {static_cast<int>(found - area_to_.begin()), b1, b2};
  }

 private:
  std::vector<double> area_to_;  // (t) of all triangles up to and with each one
};

class CurveBuilder {
 public:
  CurveBuilder(const Surface& surface, const CrossField& field, const Progress& progress)
      : surface_(surface), walker_(surface, field), progress_(progress) {
    for (const Vec3& p : surface.positions) {
      if (p.allFinite()) box_.extend(p);
    }
  }

  SurfaceCurves build() {
    const EvenPlaces places(surface_);
    const double area = result_.area = places.area();
    if (!(area > 0) || !std::isfinite(area)) return {};
    for (std::size_t i = 0; i < seed_total; ++i) result_.seeds.push_back(places.place(i));
    const double finest = std::sqrt(area / finest_squares);
    result_.step = point_step * finest;
    double done = 0;
    for (int level = levels - 1; level >= 0; --level) {
      const double radius = finest * std::pow(2, level / 2.0);
      const double share = std::pow(0.5, level + 1);
      const double seeds = seeds_per_square * area / (radius * radius);
      add_level(radius, std::min(seed_total, static_cast<std::size_t>(seeds)),
                progress_.part(done, done + share));
      done += share;
    }
    return std::move(result_);
  }

 private:
  void add_level(double radius, std::size_t seed_count, const Progress& progress) {
    radius_ = static_cast<float>(radius);
    stride_ = std::max(1, static_cast<int>(radius / (3 * result_.step)));
    CurveCells cells(box_, radius);
    for (const auto& line : lines_) add_to_cells(cells, line);
    for (std::size_t i = 0; i < seed_count; ++i) {
      if (i % 512 == 0) progress.report(static_cast<double>(i) / static_cast<double>(seed_count));
      const SurfacePoint& seed = result_.seeds[i];
      const Vec3 normal = normal_at(surface_, seed);
      const Vec3 one = cross_direction(surface_, walker_.field(), seed, normal.unitOrthogonal());
      for (const Vec3& towards : {one, Vec3(normal.cross(one))}) grow(cells, seed, towards);
    }
  }

  CurveNode node_at(const SurfacePoint& on, const Vec3& tangent, int index) const {
    return {position_at(surface_, on).cast<float>(), tangent.cast<float>(),
            normal_at(surface_, on).cast<float>(),   surface_.triangle_objects[idx(on.triangle)],
            static_cast<int>(lines_.size()),         index};
  }

  // Whether a parallel curve, or a far part of the same one, passes nearer than `distance`.
  bool is_near(const CurveCells& cells, const CurveNode& node, float distance) const {
    const float half = 0.5F * static_cast<float>(stride_ * result_.step);
    const int own_reach = 1 + static_cast<int>(2 * radius_ / result_.step);
    return cells.any_near(node.position, distance + half, [&](const CurveNode& other) {
      const Eigen::Vector3f offset = node.position - other.position;
      const float along = offset.dot(other.tangent);
      const float beyond = std::max(std::abs(along) - half, 0.0F);
      const float square = offset.squaredNorm() - along * along + beyond * beyond;
      if (!(square < distance * distance) || other.object != node.object) return false;
      const float cosine = node.tangent.dot(other.tangent);
      if (2 * cosine * cosine < 1 || node.normal.dot(other.normal) < 0) return false;
      return other.curve != node.curve || std::abs(other.index - node.index) > own_reach;
    });
  }

  void grow(CurveCells& cells, const SurfacePoint& seed, const Vec3& tangent) {
    const CurveNode first = node_at(seed, tangent, 0);
    if (is_near(cells, first, radius_)) return;
    const std::size_t before = cells.size();
    cells.add(first);
    std::vector<CurvePlace> line{{seed, first}};
    extend(cells, line, tangent, 1);
    std::reverse(line.begin(), line.end());
    extend(cells, line, -tangent, -1);
    if (static_cast<double>(line.size() - 1) * result_.step < least_length * radius_) {
      cells.shrink(before);
      return;
    }
    for (const CurvePlace& place : line) result_.curves.push(place.on);
    result_.curves.close_list();
    lines_.push_back(std::move(line));
  }

  void extend(CurveCells& cells, std::vector<CurvePlace>& line, Vec3 tangent, int way) {
    SurfacePoint on = line.back().on;
    const std::size_t most = 200'000;
    for (int index = way; line.size() < most; index += way) {
      const double rest = walker_.advance(on, tangent, result_.step);
      if (rest >= result_.step) return;
      const CurveNode node = node_at(on, tangent, index);
      if (is_near(cells, node, static_cast<float>(end_distance) * radius_)) return;
      line.push_back({on, node});
      if (index % stride_ == 0) cells.add(node);
      if (rest > 0) return;
    }
  }

  void add_to_cells(CurveCells& cells, const std::vector<CurvePlace>& line) const {
    for (const CurvePlace& place : line) {
      if (place.node.index % stride_ == 0) cells.add(place.node);
    }
  }

  const Surface& surface_;
  FieldWalker walker_;
  const Progress& progress_;
  Eigen::AlignedBox3d box_;
  SurfaceCurves result_;
  std::vector<std::vector<CurvePlace>> lines_;
  float radius_ = 0;
  int stride_ = 1;
};

}  // namespace

SurfaceCurves surface_curves(const Surface& surface, const CrossField& field,
                             const Progress& progress) {
  progress.report(0);
  SurfaceCurves curves = CurveBuilder(surface, field, progress).build();
  progress.report(1);
  return curves;
}

}  // namespace illustrate
