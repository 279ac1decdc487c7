#include "hatch/crumbs.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/disjoint_sets.h"
#include "hatch/greedy/neighbour_grid.h"
#include "hatch/view/hatch_area.h"

namespace illustrate {
namespace {

// In spacings: the shortest hatch, of which strokes lose a little; how far beyond an end the edge
// of its tone is looked for.
constexpr double least_new_length = 2.05;
constexpr double end_reach = 0.75;

// So far from the end of a crumb another hatch ends it, in spacings.
constexpr double rung_reach = 1.2;

// What a hatch fills between others, in spacings: where these are as near to all of a crumb, a hand
// would have left it out.
constexpr double filled_reach = 0.9;

// A hatch shorter than this, in spacings, needs so many others beside it, so near.
constexpr double short_length = 4;
constexpr double company_reach = 2.2;
constexpr std::size_t company = 2;

// Undercuts that together are no longer than this, in their spacings, and away from all other
// hatches by so many of those are a speck.
constexpr double speck_length = 20;
constexpr double speck_reach = 1.5;

class Sweeper {
 public:
  Sweeper(const Hatches& hatches, const HatchScene& scene, const HatchOptions& options)
      : hatches_(hatches),
        scene_(scene),
        options_(options),
        grid_(scene.camera.width_px(), scene.camera.height_px(), options.spacing_px),
        is_kept_(hatches.kinds.size(), 0) {}

  Hatches run() {
    for (int h = 0; h < static_cast<int>(is_kept_.size()); ++h) {
      const bool is_crumb =
          length(h) < (has_lived(h) ? least_lived : least_new_length) * spacing(h);
      if (!is_crumb || !(starts_with_tone(h) || ends_with_tone(h))) keep(h);
    }
    leave_out(least_new_length, [&](int h) { return is_filled(h); });
    leave_out(least_new_length, [&](int h) { return !is_undercut(h) && is_rung(h); });
    leave_out(short_length, [&](int h) { return !is_undercut(h) && !has_company(h); });
    leave_out_specks();
    return kept();
  }

 private:
  double spacing(int hatch) const {
    const bool is_dense = hatches_.kinds[idx(hatch)] == Kind::undercut;
    return scene_.spacing_on(curve(hatch)[0].on.triangle,
                             is_dense ? options_.undercut_spacing_px : options_.spacing_px);
  }

  Span<const HatchPoint> curve(int hatch) const { return hatches_.curves[idx(hatch)]; }
  double length(int hatch) const { return length_px(curve(hatch)); }

  Vec3 tangent(int hatch, std::size_t i) const {
    const Span<const HatchPoint> points = curve(hatch);
    const std::size_t from = i == 0 ? 0 : i - 1, to = std::min(i + 1, points.size() - 1);
    return (points[to].position - points[from].position).normalized();
  }

  bool has_lived(int hatch) const {
    return scene_.last && hatches_.kinds[idx(hatch)] != Kind::undercut &&
           scene_.last->was_along(curve(hatch), spacing(hatch));
  }

  void keep(int hatch) {
    is_kept_[idx(hatch)] = 1;
    for (std::size_t i = 0; i < curve(hatch).size(); ++i) {
      grid_.add({curve(hatch)[i].image, tangent(hatch, i), hatch});
    }
  }

  // Whether a hatch starts, or ends, where the tone for its kind does.
  bool starts_with_tone(int hatch) const { return ends_with_tone(hatch, 1, 0); }
  bool ends_with_tone(int hatch) const {
    const std::size_t last = curve(hatch).size() - 1;
    return ends_with_tone(hatch, last - 1, last);
  }
  bool ends_with_tone(int hatch, std::size_t before, std::size_t last) const {
    const Span<const HatchPoint> points = curve(hatch);
    const std::optional<Region> beyond =
        region_beyond(scene_, points[before].image, points[last].image, end_reach * spacing(hatch));
    return beyond && !suits(*beyond, hatches_.kinds[idx(hatch)]);
  }

  static bool suits(Region region, Kind kind) {
    if (region == Region::undercut) return true;
    return region == Region::shadow ? kind != Kind::undercut
                                    : region == Region::single && kind == Kind::hatch;
  }

  // Shorter than `longest`, in spacings, and not of the frame before.
  bool is_new(int hatch, double longest) const {
    return length(hatch) < longest * spacing(hatch) && !has_lived(hatch);
  }

  // Of those that there are now, all at once: one that goes takes no other with it, whatever their
  // order.
  template <class Goes>
  void leave_out(double longest, const Goes& goes) {
    std::vector<int> gone;
    for (int h = 0; h < static_cast<int>(is_kept_.size()); ++h) {
      if (is_kept_[idx(h)] && is_new(h, longest) && goes(h)) gone.push_back(h);
    }
    for (const int h : gone) is_kept_[idx(h)] = 0;
  }

  // Whether longer hatches run along all of a crumb.
  bool is_filled(int hatch) const {
    for (std::size_t i = 0; i < curve(hatch).size(); ++i) {
      const HatchPoint& at = curve(hatch)[i];
      const Vec3 along = tangent(hatch, i), normal = normal_at(scene_.surface, at.on);
      const bool is_near =
          grid_.any_within(at.image, filled_reach * spacing(hatch), [&](const HatchNode& node) {
            return node.point != hatch && is_kept_[idx(node.point)] &&
                   are_parallel(along, normal, node.tangent) &&
                   !scene_.curves.separate(at.image, node.image) &&
                   !is_new(node.point, least_new_length);
          });
      if (!is_near) return false;
    }
    return true;
  }

  // Where there is one family, whether a hatch across ends this one.
  bool is_rung(int hatch) const {
    const std::size_t last = curve(hatch).size() - 1;
    return region_of(scene_.tone, curve(hatch)[last / 2].image) == Region::single &&
           (is_crossed_at(hatch, 0) || is_crossed_at(hatch, last));
  }

  bool is_crossed_at(int hatch, std::size_t end) const {
    const HatchPoint& at = curve(hatch)[end];
    const Vec3 along = tangent(hatch, end), normal = normal_at(scene_.surface, at.on);
    return grid_.any_within(at.image, rung_reach * spacing(hatch), [&](const HatchNode& node) {
      return node.point != hatch && is_kept_[idx(node.point)] &&
             !are_parallel(along, normal, node.tangent) &&
             !scene_.curves.separate(at.image, node.image);
    });
  }

  bool has_company(int hatch) const {
    const std::size_t middle = curve(hatch).size() / 2;
    const HatchPoint& at = curve(hatch)[middle];
    const Vec3 along = tangent(hatch, middle), normal = normal_at(scene_.surface, at.on);
    std::vector<int> others;
    return grid_.any_within(at.image, company_reach * spacing(hatch), [&](const HatchNode& node) {
      const bool is_met =
          node.point == hatch || std::count(others.begin(), others.end(), node.point) > 0;
      if (!is_met && are_parallel(along, normal, node.tangent) &&
          !scene_.curves.separate(at.image, node.image)) {
        others.push_back(node.point);
      }
      return others.size() >= company;
    });
  }

  bool is_undercut(int hatch) const { return hatches_.kinds[idx(hatch)] == Kind::undercut; }

  // Of undercuts beside each other: their length in spacings, infinite where another hatch is near.
  std::vector<double> lengths_of_patches(DisjointSets& patches) const {
    std::vector<double> lengths(is_kept_.size(), 0);
    const auto count = static_cast<int>(is_kept_.size());
    for (int h = 0; h < count; ++h) {
      if (!is_kept_[idx(h)] || !is_undercut(h)) continue;
      lengths[idx(h)] = length(h) / spacing(h);
      const auto is_known = [&](int other) {
        return is_undercut(other) ? patches.root(h) == patches.root(other)
                                  : std::isinf(lengths[idx(h)]);
      };
      visit_near(h, is_known, [&](int other) {
        if (is_undercut(other))
          patches.join(h, other);
        else
          lengths[idx(h)] = std::numeric_limits<double>::infinity();
      });
    }
    for (int h = 0; h < count; ++h) {
      if (patches.root(h) != h) lengths[idx(patches.root(h))] += lengths[idx(h)];
    }
    return lengths;
  }

  // Hatches that are kept, on the same side of all critical curves; not those already known.
  template <class Known, class Visit>
  void visit_near(int hatch, const Known& is_known, const Visit& visit) const {
    const double reach =
        speck_reach * scene_.spacing_on(curve(hatch)[0].on.triangle, options_.spacing_px);
    for (const HatchPoint& point : curve(hatch)) {
      grid_.any_within(point.image, reach, [&](const HatchNode& node) {
        if (node.point != hatch && is_kept_[idx(node.point)] && !is_known(node.point) &&
            !scene_.curves.separate(point.image, node.image))
          visit(node.point);
        return false;
      });
    }
  }

  void leave_out_specks() {
    DisjointSets patches(is_kept_.size());
    const std::vector<double> lengths = lengths_of_patches(patches);
    for (int h = 0; h < static_cast<int>(is_kept_.size()); ++h) {
      if (is_undercut(h) && lengths[idx(patches.root(h))] < speck_length) is_kept_[idx(h)] = 0;
    }
  }

  Hatches kept() const {
    Hatches result;
    for (std::size_t h = 0; h < is_kept_.size(); ++h) {
      if (is_kept_[h]) result.add(hatches_, h);
    }
    return result;
  }

  const Hatches& hatches_;
  const HatchScene& scene_;
  const HatchOptions& options_;
  NeighbourGrid grid_;  // HatchNode::point: the hatch
  std::vector<std::uint8_t> is_kept_;
};

}  // namespace

Hatches without_crumbs(const Hatches& hatches, const HatchScene& scene,
                       const HatchOptions& options) {
  return Sweeper(hatches, scene, options).run();
}

void mark_undercuts(Hatches& hatches, const ToneMap& tone) {
  const Ragged<HatchPoint>& curves = hatches.curves;
  for (std::size_t h = 0; h < hatches.kinds.size(); ++h) {
    const Span<const HatchPoint> curve = curves[h];
    double inside = 0;
    for (std::size_t i = 1; i < curve.size(); ++i) {
      const Vec2 middle = (curve[i - 1].image + curve[i].image) / 2;
      const bool is_inside = region_of(tone, middle) == Region::undercut;
      inside += is_inside ? (curve[i].image - curve[i - 1].image).norm() : 0;
    }
    if (2 * inside > length_px(curve)) hatches.kinds[h] = Kind::undercut;
  }
}

}  // namespace illustrate
