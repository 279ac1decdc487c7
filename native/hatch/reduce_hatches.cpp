#include "hatch/reduce_hatches.h"

#include <algorithm>
#include <cstdlib>
#include <tuple>

#include "hatch/greedy/neighbour_grid.h"
#include "hatch/view/critical_curves.h"
#include "hatch/view/hatch_runs.h"

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

// In spacings: a hatch that is shorter in a shadow, and goes on outside, is no cross-hatch there.
constexpr double least_shadow = 1.5;

// In spacings, of hatches at seams; a little more than one: what lies between points counts too.
constexpr double seam_clearance = 1.05;

// Hatches cross from about 42 degrees on (squared cosine).
constexpr double most_crossing = 0.55;

// Spacings in depth between the two sides of a silhouette that are sheets of their own.
constexpr double most_step = 3.2;

class Reducer {
 public:
  Reducer(const Hatches& hatches, const HatchScene& scene, const HatchOptions& options)
      : hatches_(hatches),
        points_(hatches.curves.values),
        scene_(scene),
        surface_(scene.surface),
        options_(options),
        curves_(scene.curves),
        owner_(points_.size()),
        region_(points_.size(), Region::neither),
        to_end_(points_.size(), 0),
        kept_(points_.size(), 1) {
    for (int h = 0; h < count(); ++h) enter(h);
  }

  // The kept parts of all hatches, in their order.
  Hatches reduce() {
    clip_at_seams();
    return strokes();
  }

 private:
  int count() const { return static_cast<int>(hatches_.kinds.size()); }
  int begin(int hatch) const { return hatches_.curves.offsets[hatch]; }
  int end(int hatch) const { return hatches_.curves.offsets[hatch + 1]; }
  bool is_undercut(int hatch) const { return hatches_.kinds[hatch] == Kind::undercut; }

  double spacing_of(int hatch) const {
    return scene_.spacing_on(hatches_.objects[hatch], options_.spacing_px);
  }

  double length_of(const Run& run) const {
    return length_px({&points_[run.from], idx(run.to - run.from)});
  }

  void enter(int hatch) {
    for (int i = begin(hatch); i < end(hatch); ++i) {
      owner_[i] = hatch;
      region_[i] = region_of(scene_.tone, points_[i].image);
      if (region_[i] == Region::neither && i > begin(hatch)) region_[i] = region_[i - 1];
    }
    if (is_undercut(hatch)) return;
    pass_slight_shadows(hatch);
    measure_ends(hatch);
  }

  // A patch of shadow that a hatch hardly touches is too small to cross anything in.
  void pass_slight_shadows(int hatch) {
    const auto is_single = [&](int i) {
      return i >= begin(hatch) && i < end(hatch) && region_[i] == Region::single;
    };
    const auto is_shadow = [&](int i) { return region_[i] == Region::shadow; };
    for (const Run& run : runs({begin(hatch), end(hatch)}, is_shadow)) {
      const bool goes_on = is_single(run.from - 1) || is_single(run.to);
      if (!goes_on || length_of(run) >= least_shadow * spacing_of(hatch)) continue;
      std::fill(&region_[run.from], &region_[run.to - 1] + 1, Region::single);
    }
  }

  // How far each point is from the nearer end, in spacings.
  void measure_ends(int hatch) {
    const auto step = [&](int i) {
      return (points_[i].image - points_[i - 1].image).norm() / spacing_of(hatch);
    };
    for (int i = begin(hatch) + 1; i < end(hatch); ++i) to_end_[i] = to_end_[i - 1] + step(i);
    double rest = 0;
    for (int i = end(hatch) - 1; i > begin(hatch); --i) {
      to_end_[i] = std::min(to_end_[i], rest);
      rest += step(i);
    }
  }

  Vec3 tangent_at(int point) const {
    const int before = std::max(point - 1, begin(owner_[point]));
    const int after = std::min(point + 1, end(owner_[point]) - 1);
    return (points_[after].position - points_[before].position).normalized();
  }

  bool is_at_stake(int point) const {
    return region_[point] == Region::single && !is_undercut(owner_[point]);
  }

  bool was_drawn(int point) const {
    return scene_.last &&
           scene_.last->was_at(points_[point], tangent_at(point), spacing_of(owner_[point]));
  }

  // What was drawn, and farthest from the ends, first: each point stays that crosses none before.
  void clip_at_seams() {
    NeighbourGrid all = empty_grid(), kept = empty_grid();
    const auto node = [&](int i) { return HatchNode{points_[i].image, tangent_at(i), i}; };
    const int size = static_cast<int>(points_.size());
    for (int i = 0; i < size; ++i) {
      if (is_at_stake(i)) all.add(node(i));
    }
    std::vector<std::tuple<bool, double, int>> order;
    for (int i = 0; i < size; ++i) {
      if (is_at_stake(i) && is_crossed_at(i, all)) order.push_back({!was_drawn(i), -to_end_[i], i});
    }
    std::sort(order.begin(), order.end());
    for (const auto& [is_new, depth, i] : order) {
      kept_[i] = !is_crossed_at(i, kept);
      if (kept_[i]) kept.add(node(i));
    }
  }

  bool is_crossed_at(int point, const NeighbourGrid& grid) const {
    const Vec3 tangent = tangent_at(point);
    const double radius = seam_clearance * spacing_of(owner_[point]);
    return grid.any_within(points_[point].image, radius, [&](const HatchNode& node) {
      if (owner_[node.point] == owner_[point]) return false;
      const double along = tangent.dot(node.tangent);
      return along * along < most_crossing && is_same_sheet(point, node.point);
    });
  }

  bool is_same_sheet(int a, int b) const {
    const Vec2 &from = points_[a].image, &to = points_[b].image;
    if (!curves_.separate(from, to)) return true;
    if (curves_.is_edge_between(from, to)) return false;
    const Vec3 &p = points_[a].position, &q = points_[b].position;
    const double depth = std::abs(scene_.camera.project(p).depth - scene_.camera.project(q).depth);
    return depth < most_step * spacing_of(owner_[a]) * scene_.camera.pixel_size(p);
  }

  NeighbourGrid empty_grid() const {
    return {double(scene_.camera.width_px()), double(scene_.camera.height_px()),
            options_.spacing_px};
  }

  // What is kept, without specks.
  Hatches strokes() const {
    std::vector<Run> kept;
    NeighbourGrid longer = empty_grid();
    for (int h = 0; h < count(); ++h) {
      for (const Run& run : runs({begin(h), end(h)}, [&](int i) { return kept_[i] != 0; })) {
        if (run.to - run.from < 2 || length_of(run) < least_stroke * spacing_of(h)) continue;
        kept.push_back(run);
        if (length_of(run) < speck * spacing_of(h)) continue;
        for (int i = run.from; i < run.to; ++i) longer.add({points_[i].image, tangent_at(i), i});
      }
    }
    Hatches result;
    for (const Run& run : kept) {
      if (is_in_undercut(run) || is_beside(longer, run)) add(result, run);
    }
    return result;
  }

  bool is_in_undercut(const Run& run) const {
    return std::find(&region_[run.from], &region_[run.to - 1] + 1, Region::undercut) !=
           &region_[run.to - 1] + 1;
  }

  // Whether a run is where it is, and as short as it is, because a shadow has both families.
  bool is_second(const Run& run) const {
    const int middle = (run.from + run.to) / 2;
    const bool in_shadow = std::all_of(&region_[run.from], &region_[run.to - 1] + 1,
                                       [](Region region) { return region == Region::shadow; });
    return in_shadow &&
           kept_share(surface_, scene_.field, scene_.families, points_[middle].on,
                      tangent_at(middle)) < 0 &&
           (ends_with_shadow(run.from, run.from + 1) || ends_with_shadow(run.to - 1, run.to - 2));
  }

  bool ends_with_shadow(int last, int before) const {
    const Vec2& end = points_[last].image;
    const Vec2 way = (end - points_[before].image).normalized();
    const Vec2 beyond = end + edge_reach * spacing_of(owner_[last]) * way;
    return region_of(scene_.tone, beyond) != Region::shadow && !curves_.separate(end, beyond);
  }

  // Whether a run is long, or a parallel one of another hatch near its middle is in `longer`.
  bool is_beside(const NeighbourGrid& longer, const Run& run) const {
    const int hatch = owner_[run.from], middle = (run.from + run.to) / 2;
    const double spacing = spacing_of(hatch);
    const double length = length_of(run) / spacing;
    const Span<const HatchPoint> points{&points_[run.from], idx(run.to - run.from)};
    if (length >= least_lived && scene_.last && scene_.last->was_along(points, spacing))
      return true;
    const bool second = is_second(run);
    if (length >= (second ? second_speck : speck)) return true;
    if (second && length < least_second) return false;
    const Vec3 tangent = tangent_at(middle), normal = normal_at(surface_, points_[middle].on);
    return longer.any_within(points_[middle].image, company * spacing, [&](const HatchNode& node) {
      return owner_[node.point] != hatch && are_parallel(tangent, normal, node.tangent);
    });
  }

  void add(Hatches& result, const Run& run) const {
    const int hatch = owner_[run.from];
    const Region* last = &region_[run.to - 1] + 1;
    const bool in_single = std::find(&region_[run.from], last, Region::single) != last;
    const Kind kind = is_undercut(hatch) ? Kind::undercut
                      : in_single        ? Kind::hatch
                                         : Kind::cross_hatch;
    result.add({&points_[run.from], idx(run.to - run.from)}, kind, hatches_.objects[hatch]);
  }

  const Hatches& hatches_;
  const std::vector<HatchPoint>& points_;
  const HatchScene& scene_;
  const Surface& surface_;
  const HatchOptions& options_;
  const CriticalCurves& curves_;
  std::vector<int> owner_;          // hatch of each point
  std::vector<Region> region_;      // of each point
  std::vector<double> to_end_;      // of each point: to the nearer end of its hatch, spacings
  std::vector<std::uint8_t> kept_;  // of each point
};

}  // namespace

Hatches reduce_hatches(const Hatches& hatches, const HatchScene& scene, const HatchOptions& options,
                       Counts& counts) {
  validate(options);
  Hatches result = Reducer(hatches, scene, options).reduce();
  counts["hatches_after_reduction"] += static_cast<std::int64_t>(result.kinds.size());
  return result;
}

}  // namespace illustrate
