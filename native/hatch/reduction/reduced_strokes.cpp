#include "hatch/reduction/reduced_strokes.h"

#include "hatch/greedy/neighbour_grid.h"
#include "hatch/view/hatch_area.h"

namespace illustrate {
namespace {

// In spacings: shorter strokes are specks where no longer one runs parallel within `company`,
// unless they lie in an undercut; still shorter ones are nowhere worth a stroke.
constexpr double speck = 1.5;
constexpr double company = 2;
constexpr double least_stroke = 0.5;

// The same for the family that is in a shadow alone and ends at its edge: where no shadow lies this
// far on.
constexpr double second_speck = 3;
constexpr double least_second = 2;
constexpr double edge_reach = 0.5;

class StrokeSelector {
 public:
  StrokeSelector(const HatchPoints& points, const HatchScene& scene, double spacing_px)
      : points_(points),
        scene_(scene),
        longer_(scene.camera.width_px(), scene.camera.height_px(), spacing_px) {}

  Hatches run(const std::vector<std::uint8_t>& is_kept) {
    const std::vector<Run> strokes = kept_strokes(is_kept);
    for (const Run& run : strokes) {
      if (points_.length(run) < speck * spacing(run)) continue;
      for (int i = run.from; i < run.to; ++i) {
        longer_.add({points_[i].image, points_.tangent(i), i});
      }
    }
    Hatches result;
    for (const Run& run : strokes) {
      if (points_.any_in(run, Region::undercut) || is_worth_it(run)) add(result, run);
    }
    return result;
  }

 private:
  double spacing(const Run& run) const { return points_.spacing(points_.owner(run.from)); }

  std::vector<Run> kept_strokes(const std::vector<std::uint8_t>& is_kept) const {
    std::vector<Run> strokes;
    for (int h = 0; h < points_.hatches(); ++h) {
      for (const Run& run : runs(points_.whole(h), [&](int i) { return is_kept[idx(i)] != 0; })) {
        if (run.to - run.from < 2 || points_.length(run) < least_stroke * points_.spacing(h))
          continue;
        strokes.push_back(run);
      }
    }
    return strokes;
  }

  bool is_worth_it(const Run& run) const {
    const double length = points_.length(run) / spacing(run);
    if (length >= least_lived && was_drawn(run)) return true;
    const bool second = is_second(run);
    if (length >= (second ? second_speck : speck)) return true;
    return !(second && length < least_second) && has_company(run);
  }

  bool was_drawn(const Run& run) const {
    return scene_.last && scene_.last->was_along(points_.part(run), spacing(run));
  }

  // Whether a run is where it is, and as short as it is, because a shadow has both families.
  bool is_second(const Run& run) const {
    const int middle = (run.from + run.to) / 2;
    return points_.all_in(run, Region::shadow) &&
           kept_share(scene_.surface, scene_.field, scene_.families, points_[middle].on,
                      points_.tangent(middle)) < 0 &&
           (ends_with_shadow(run.from + 1, run.from) || ends_with_shadow(run.to - 2, run.to - 1));
  }

  bool ends_with_shadow(int before, int last) const {
    const double reach = edge_reach * points_.spacing(points_.owner(last));
    const std::optional<Region> beyond =
        region_beyond(scene_, points_[before].image, points_[last].image, reach);
    return beyond && *beyond != Region::shadow;
  }

  // Whether a longer parallel stroke of another hatch is near the middle.
  bool has_company(const Run& run) const {
    const int hatch = points_.owner(run.from), middle = (run.from + run.to) / 2;
    const Vec3 tangent = points_.tangent(middle);
    const Vec3 normal = normal_at(scene_.surface, points_[middle].on);
    return longer_.any_within(
        points_[middle].image, company * spacing(run), [&](const HatchNode& node) {
          return points_.owner(node.point) != hatch && are_parallel(tangent, normal, node.tangent);
        });
  }

  void add(Hatches& result, const Run& run) const {
    const int hatch = points_.owner(run.from);
    const Kind kind = points_.is_undercut(hatch)            ? Kind::undercut
                      : points_.any_in(run, Region::single) ? Kind::hatch
                                                            : Kind::cross_hatch;
    result.add(points_.part(run), kind, points_.object(hatch));
  }

  const HatchPoints& points_;
  const HatchScene& scene_;
  NeighbourGrid longer_;  // points of strokes that are no specks
};

}  // namespace

Hatches reduced_strokes(const HatchPoints& points, const std::vector<std::uint8_t>& is_kept,
                        const HatchScene& scene, double spacing_px) {
  return StrokeSelector(points, scene, spacing_px).run(is_kept);
}

}  // namespace illustrate
