#include "hatch/greedy/place_hatches.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

#include "core/errors.h"
#include "hatch/greedy/trace_hatch.h"
#include "hatch/view/image_lattice.h"
#include "tone/step_along.h"

namespace illustrate {
namespace {

// Clearance that a new hatch's seed needs from parallel ones, in spacings: seeds of the queue lie
// beside a hatch at exactly one, the fill pass closes what is left, and undercuts are filled
// between hatches that are there already.
constexpr double queue_clearance = 0.95;
constexpr double fill_clearance = 0.75;
constexpr double undercut_clearance = 0.65;

// Seeds beside a critical curve start so far from it that they surely lie on the side they are
// meant for. In units of the graph.
constexpr double curve_offset = 2;

// Sine of the least angle between a critical curve and hatches that are seeded along it. Others, as
// near outlines of round forms, only slip along the curve.
constexpr double least_slant = 0.5;

// Places for seeds along critical curves, and points of the fill pass, lie this many spacings
// apart.
constexpr double seed_step = 0.25;

constexpr double infinite = std::numeric_limits<double>::infinity();

// No drawing needs more; beyond it placement stops.
constexpr std::size_t most_points = 20'000'000;

void require(bool good, const char* message) {
  if (!good) throw InvalidInput(message);
}

class Placer {
 public:
  Placer(const HatchScene& scene, const HatchOptions& options, const Progress& progress)
      : scene_(scene),
        surface_(scene.surface),
        camera_(scene.camera),
        visible_(scene.visible),
        options_(options),
        progress_(progress),
        area_(scene),
        walker_(surface_, scene.field, camera_),
        curves_(scene.curves),
        grid_(camera_.width_px(), camera_.height_px(), options.spacing_px),
        tracer_(surface_, walker_, area_, curves_, grid_, options) {}

  Hatches place(Counts& counts) {
    expected_px_ = std::max(1.0, 2 * covered_px() / options_.spacing_px);
    seed_along_curves();
    seed_along_hatches();
    fill(Area::hatched);
    fill(Area::undercut);
    counts["hatch_steps"] += tracer_.steps();
    counts["hatches"] += static_cast<std::int64_t>(hatches_.kinds.size());
    return std::move(hatches_);
  }

 private:
  // One area's spacing, rules and shortest hatch on one object.
  struct Style {
    double spacing_px;
    double min_length_px;
    HatchRules rules;
  };

  Style style_of(int triangle, Area area) const {
    const bool dense = area == Area::undercut;
    const double spacing =
        scene_.spacing_on(triangle, dense ? options_.undercut_spacing_px : options_.spacing_px);
    const double step = dense ? spacing / 4 : std::min(options_.step_px, spacing / 4);
    return {spacing,
            dense ? options_.min_length_px / 2 : options_.min_length_px,
            {area, options_.test_factor * spacing, step, next_max_length_px()}};
  }

  // Neighbours that start in a row must not end in a row: golden-ratio steps between .6 and 1 of
  // the greatest length.
  double next_max_length_px() const {
    const double turns = 0.6180339887498949 * static_cast<double>(hatches_.kinds.size());
    return options_.max_length_px * (0.6 + 0.4 * (turns - std::floor(turns)));
  }

  double covered_px() const {
    const auto cells = std::count_if(visible_.triangle.begin(), visible_.triangle.end(),
                                     [](int triangle) { return triangle != none; });
    return static_cast<double>(cells) * visible_.cell_px * visible_.cell_px;
  }

  // The seed under an image point, `none` where no hatch is wanted.
  SurfacePoint seed_at(const Vec2& image, Area area) const {
    const int cell = visible_.cell_of(image);
    if (cell == none || !area_.wanted(cell, area) || visible_.triangle[idx(cell)] == none)
      return {};
    const int object = surface_.object_of(visible_.triangle[idx(cell)]);
    return scene_.is_hatched(object) ? area_.visible_point(image) : SurfacePoint{};
  }

  // A new hatch, where it is clear of parallel ones and long enough; whether there is one.
  bool grow(const SurfacePoint& seed, const Vec3& towards, double clearance, Area area) {
    if (hatches_.curves.values.size() > most_points) return false;
    const int object = surface_.object_of(seed.triangle);
    const Style style = style_of(seed.triangle, area);
    const HatchSample first{walker_.point(seed), walker_.start(seed, towards).tangent};
    if (!area_.may_pass(first.point, area) || !area_.suits(first.point, first.tangent))
      return false;
    if (tracer_.is_near_parallel(first, clearance * style.spacing_px)) return false;
    const HatchLine line = tracer_.trace(seed, towards, style.rules);
    double length = 0;
    for (std::size_t i = 1; i < line.size(); ++i) {
      length += (line[i].point.image - line[i - 1].point.image).norm();
    }
    if (line.size() < 2 || length < style.min_length_px) return false;
    add(line, object, area, length);
    return true;
  }

  void add(const HatchLine& line, int object, Area area, double length) {
    const int hatch = static_cast<int>(hatches_.kinds.size());
    for (const HatchSample& sample : line) {
      grid_.add({sample.point.image, sample.tangent, static_cast<int>(tangents_.size())});
      hatches_.curves.push(sample.point);
      tangents_.push_back(sample.tangent);
    }
    hatches_.curves.close_list();
    hatches_.kinds.push_back(area == Area::undercut ? Kind::undercut : Kind::hatch);
    hatches_.objects.push_back(object);
    placed_px_ += length;
    if (hatch % 32 == 0) progress_.report(std::min(0.95, placed_px_ / expected_px_));
  }

  // Hatches leave critical curves as nearly at right angles as the cross allows.
  void seed_along_curves() {
    const Vec2 size(camera_.width_px(), camera_.height_px());
    const double step = seed_step * options_.spacing_px;
    const LabelledGraph& graph = scene_.graph;
    const double offset = curve_offset * graph.unit_px;
    for (int arc = 0; arc < static_cast<int>(graph.arcs.size()); ++arc) {
      if (layers_over(graph.arcs[idx(arc)]) != 0 || !is_critical(graph.arcs[idx(arc)].kind))
        continue;
      progress_.report(0);
      std::array<double, 2> apart{infinite, infinite};  // from the last hatch on either side
      step_along(graph.image[idx(arc)], graph.arcs[idx(arc)].start_node == none, step,
                 Frame{Vec2::Zero(), size}, [&](const CurveSample& at) {
                   const Vec2 across(-at.heading.y(), at.heading.x());
                   seed_across(at.image + offset * across, across, step, apart[0]);
                   seed_across(at.image - offset * across, across, step, apart[1]);
                 });
    }
  }

  // `apart` grows by how far `step` along the curve leads away from hatches that leave it at a
  // slant.
  void seed_across(const Vec2& image, const Vec2& across, double step, double& apart) {
    const SurfacePoint seed = seed_at(image, Area::hatched);
    if (seed.triangle == none) return;
    const Vec3 position = position_at(surface_, seed), normal = normal_at(surface_, seed);
    const Vec3 one = walker_.start(seed, normal.unitOrthogonal()).tangent;
    const Vec3 other = normal.cross(one);
    const auto alignment = [&](const Vec3& direction) {
      return std::abs(walker_.image_direction(position, direction).normalized().dot(across));
    };
    const double of_one = alignment(one), of_other = alignment(other);
    const double slant = std::max(of_one, of_other);
    apart += step * slant;
    const double spacing = style_of(surface_.object_of(seed.triangle), Area::hatched).spacing_px;
    if (apart < spacing || slant < least_slant) return;
    const Vec3& towards = of_one >= of_other ? one : other;
    if (grow(seed, towards, queue_clearance, Area::hatched)) apart = 0;
  }

  // First come, first served: beside every hatch at one spacing, and across it.
  void seed_along_hatches() {
    for (; next_ < hatches_.kinds.size(); ++next_) {
      const double spacing = style_of(hatches_.objects[next_], Area::hatched).spacing_px;
      const auto begin = idx(hatches_.curves.offsets[next_]);
      const auto end = idx(hatches_.curves.offsets[next_ + 1]);
      double walked = spacing / 2;
      for (std::size_t i = begin; i + 1 < end; ++i) {
        const Vec2 from = hatches_.curves.values[i].image;
        const Vec2 run = hatches_.curves.values[i + 1].image - from;
        walked += run.norm();
        if (walked < spacing || !(run.norm() > 0)) continue;
        walked = 0;
        seed_beside(i, run.normalized() * spacing);
      }
    }
  }

  void seed_beside(std::size_t point, const Vec2& run) {
    const HatchPoint from = hatches_.curves.values[point];
    const Vec3 tangent = tangents_[point];
    const Vec2 aside(-run.y(), run.x());
    for (const Vec2& image : {Vec2(from.image + aside), Vec2(from.image - aside)}) {
      const SurfacePoint seed = seed_at(image, Area::hatched);
      if (seed.triangle == none || curves_.separate(from.image, image)) continue;
      grow(seed, tangent, queue_clearance, Area::hatched);
    }
    const Vec3 across = normal_at(surface_, from.on).cross(tangent);
    grow(from.on, across, queue_clearance, Area::hatched);
  }

  // From points of a fine lattice over the image.
  void fill(Area area) {
    const double base = area == Area::undercut ? options_.undercut_spacing_px : options_.spacing_px;
    visit_lattice(camera_.width_px(), camera_.height_px(), std::max(0.25, seed_step * base),
                  [&](std::int64_t i, const Vec2& image) {
                    if (i % 4096 == 0) {
                      progress_.report(std::min(0.95, placed_px_ / expected_px_));
                    }
                    fill_at(image, area);
                  });
  }

  // Both families where none of their hatches is near; what grows here seeds its neighbours first.
  void fill_at(const Vec2& image, Area area) {
    const SurfacePoint seed = seed_at(image, area);
    if (seed.triangle == none) return;
    const double clearance = area == Area::undercut ? undercut_clearance : fill_clearance;
    const Vec3 normal = normal_at(surface_, seed);
    const Vec3 one = walker_.start(seed, normal.unitOrthogonal()).tangent;
    for (const Vec3& towards : {one, Vec3(normal.cross(one))}) grow(seed, towards, clearance, area);
    if (area == Area::hatched) seed_along_hatches();
  }

  const HatchScene& scene_;
  const Surface& surface_;
  const Camera& camera_;
  const VisibleImage& visible_;
  const HatchOptions& options_;
  const Progress& progress_;
  HatchArea area_;
  Walker walker_;
  const CriticalCurves& curves_;
  NeighbourGrid grid_;
  Tracer tracer_;
  Hatches hatches_;
  std::vector<Vec3> tangents_;  // of hatches_.curves.values
  std::size_t next_ = 0;        // hatch whose seeds come next
  double placed_px_ = 0;
  double expected_px_ = 1;
};

}  // namespace

void validate(const HatchOptions& options) {
  const auto between = [](double value, double low, double high) {
    return value >= low && value <= high;
  };
  require(between(options.spacing_px, 1, 1e4), "spacing_px must be in [1, 10000]");
  require(between(options.undercut_spacing_px, 1, 1e4),
          "undercut_spacing_px must be in [1, 10000]");
  require(between(options.least_spacing_px, 1, 1e4), "least_spacing_px must be in [1, 10000]");
  require(between(options.test_factor, 0.1, 1), "test_factor must be in [0.1, 1]");
  require(between(options.step_px, 0.25, 20), "step_px must be in [0.25, 20]");
  require(between(options.max_turn_deg, 1, 360), "max_turn_deg must be in [1, 360]");
  require(between(options.max_length_px, 1, 2e4), "max_length_px must be in [1, 20000]");
  require(between(options.min_length_px, 0, 1e6), "min_length_px must be in [0, 1000000]");
}

void validate(const HatchScene& scene) {
  const std::size_t objects = scene.surface.object_is_smooth.size();
  require(
      scene.spacing_scale.empty() || scene.spacing_scale.size() == scene.surface.triangles.size(),
      "spacing_scale must have one entry per triangle");
  for (const float scale : scene.spacing_scale) {
    require(scale > 0 && std::isfinite(scale), "spacing_scale must be finite and positive");
  }
  require(scene.unhatched.empty() || scene.unhatched.size() == objects,
          "unhatched must have one entry per object");
  require(scene.families.size() == scene.surface.positions.size(),
          "families must have one entry per vertex");
}

Hatches place_hatches(const HatchScene& scene, const HatchOptions& options, Counts& counts,
                      const Progress& progress) {
  validate(options);
  validate(scene);
  Hatches hatches = Placer(scene, options, progress).place(counts);
  progress.report(1);
  return hatches;
}

}  // namespace illustrate
