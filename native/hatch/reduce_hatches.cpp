#include "hatch/reduce_hatches.h"

#include <algorithm>
#include <numeric>

#include "hatch/critical_curves.h"
#include "hatch/neighbour_grid.h"

namespace illustrate {
namespace {

// Pieces shorter than this share of the least length are not worth a stroke.
constexpr double least_piece = 0.5;

// The region a point of a hatch lies in. Beyond both, where a cell at the outline is empty, a point
// goes with the one before it.
enum class Region : std::uint8_t { neither, single, crossed };

double length_px(Span<const HatchPoint> curve) {
  double length = 0;
  for (std::size_t i = 1; i < curve.size(); ++i) {
    length += (curve[i].image - curve[i - 1].image).norm();
  }
  return length;
}

class Reducer {
 public:
  Reducer(const Hatches& hatches, const Surface& surface, const ToneMap& tone,
          const LabelledGraph& graph, const HatchOptions& options,
          const std::vector<double>& spacing_scale)
      : hatches_(hatches),
        points_(hatches.curves.values),
        surface_(surface),
        options_(options),
        spacing_scale_(spacing_scale),
        curves_(graph, tone.width * tone.cell_px, tone.height * tone.cell_px),
        grid_(tone.width * tone.cell_px, tone.height * tone.cell_px, options.spacing_px),
        owner_(points_.size()),
        region_(points_.size(), Region::neither),
        kept_(points_.size(), 1),
        visited_(hatches.kinds.size(), 0) {
    for (int h = 0; h < count(); ++h) enter(h, tone);
  }

  // The kept pieces of all hatches, in their order.
  Hatches reduce() {
    const std::vector<int> order = longest_first();
    for (const int hatch : order) delete_from(hatch);
    restore_beside_kept(order);
    Hatches result;
    for (int h = 0; h < count(); ++h) {
      const bool is_whole = std::all_of(kept_.begin() + begin(h), kept_.begin() + end(h),
                                        [](std::uint8_t kept) { return kept != 0; });
      runs(
          h, [&](int i) { return kept_[i] != 0; },
          [&](int from, int to) {
            const double length = length_px({&points_[from], static_cast<std::size_t>(to - from)});
            if (is_whole || length >= least_piece * options_.min_length_px)
              add(result, h, from, to);
          });
    }
    return result;
  }

 private:
  int count() const { return static_cast<int>(hatches_.kinds.size()); }
  int begin(int hatch) const { return hatches_.curves.offsets[hatch]; }
  int end(int hatch) const { return hatches_.curves.offsets[hatch + 1]; }
  bool is_undercut(int hatch) const { return hatches_.kinds[hatch] == Kind::undercut; }

  static Region region_of(const ToneMap& tone, const Vec2& image) {
    const int cell = tone.cell_of(image);
    if (cell == none || tone.band[cell] == Band::mach_band) return Region::neither;
    if (tone.band[cell] == Band::undercut) return Region::crossed;
    if (tone.level[cell] == Tone::midtone) return Region::single;
    return tone.level[cell] == Tone::shadow ? Region::crossed : Region::neither;
  }

  void enter(int hatch, const ToneMap& tone) {
    for (int i = begin(hatch); i < end(hatch); ++i) {
      owner_[i] = hatch;
      region_[i] = region_of(tone, points_[i].image);
      if (region_[i] == Region::neither && i > begin(hatch)) region_[i] = region_[i - 1];
      if (region_[i] != Region::single || is_undercut(hatch)) continue;
      grid_.add({points_[i].image, tangent_at(i), i});
    }
  }

  Vec3 tangent_at(int point) const {
    const int before = std::max(point - 1, begin(owner_[point]));
    const int after = std::min(point + 1, end(owner_[point]) - 1);
    return (points_[after].position - points_[before].position).normalized();
  }

  // Of the hatches of a region the longest is visited first, and so is the first to go: the family
  // that runs straight along a limb gives way to the one that bends round it.
  std::vector<int> longest_first() const {
    std::vector<double> length;
    for (int h = 0; h < count(); ++h) length.push_back(length_px(hatches_.curves[h]));
    std::vector<int> order(length.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(),
                     [&](int a, int b) { return length[a] > length[b]; });
    return order;
  }

  // Breadth-first over parallel neighbours of deleted hatches.
  void delete_from(int first) {
    if (visited_[first] || is_undercut(first)) return;
    std::vector<int> queue{first};
    visited_[first] = 1;
    for (std::size_t next = 0; next < queue.size(); ++next) {
      const int hatch = queue[next];
      if (!is_crossed(hatch)) continue;
      for (int i = begin(hatch); i < end(hatch); ++i) kept_[i] = region_[i] == Region::crossed;
      add_parallel_neighbours(hatch, false, queue);
    }
  }

  // Departure from section 6.5: where both directions were deleted, each because of what it met
  // elsewhere, pieces that now cross nothing come back. Breadth-first beside what is kept, so that
  // regions grow and no new ones start between them.
  void restore_beside_kept(const std::vector<int>& order) {
    visited_.assign(visited_.size(), 0);
    for (const bool from_kept : {true, false}) {
      std::vector<int> queue;
      for (const int hatch : order) {
        if (visited_[hatch] || is_undercut(hatch) || (from_kept && !is_kept_in_single(hatch)))
          continue;
        visited_[hatch] = 1;
        queue.push_back(hatch);
      }
      for (std::size_t next = 0; next < queue.size(); ++next) {
        restore(queue[next]);
        add_parallel_neighbours(queue[next], true, queue);
      }
    }
  }

  bool is_kept_in_single(int hatch) const {
    for (int i = begin(hatch); i < end(hatch); ++i) {
      if (kept_[i] && region_[i] == Region::single) return true;
    }
    return false;
  }

  void restore(int hatch) {
    const auto is_free = [&](int i) { return !kept_[i] && !is_crossed_at(i); };
    runs(hatch, is_free, [&](int from, int to) {
      const double length = length_px({&points_[from], static_cast<std::size_t>(to - from)});
      if (length >= options_.min_length_px) std::fill(&kept_[from], &kept_[to - 1] + 1, 1);
    });
  }

  // Whether use(point, parallel) accepts a point of another hatch that is near this one in a
  // single-hatch region, no critical curve between.
  template <class Use>
  bool any_neighbour(int point, const Use& use) const {
    const double scale =
        spacing_scale_.empty() ? 1 : spacing_scale_[hatches_.objects[owner_[point]]];
    const double radius = 2 * std::max(1.0, options_.spacing_px * scale);
    const Vec3 tangent = tangent_at(point), normal = normal_at(surface_, points_[point].on);
    const Vec2& image = points_[point].image;
    return grid_.any_within(image, radius, [&](const HatchNode& node) {
      if (owner_[node.point] == owner_[point]) return false;
      return use(node.point, are_parallel(tangent, normal, node.tangent));
    });
  }

  bool is_crossed_at(int point) const {
    return any_neighbour(point, [&](int other, bool parallel) {
      return !parallel && kept_[other] &&
             !curves_.separate(points_[point].image, points_[other].image);
    });
  }

  bool is_crossed(int hatch) const {
    for (int i = begin(hatch); i < end(hatch); ++i) {
      if (region_[i] == Region::single && is_crossed_at(i)) return true;
    }
    return false;
  }

  // Of the points of a hatch that are kept, or of those that are not.
  void add_parallel_neighbours(int hatch, bool of_kept, std::vector<int>& queue) {
    for (int i = begin(hatch); i < end(hatch); ++i) {
      if (region_[i] != Region::single || (kept_[i] != 0) != of_kept) continue;
      any_neighbour(i, [&](int other, bool parallel) {
        if (!parallel || visited_[owner_[other]]) return false;
        if (curves_.separate(points_[i].image, points_[other].image)) return false;
        visited_[owner_[other]] = 1;
        queue.push_back(owner_[other]);
        return false;
      });
    }
  }

  // Calls use(from, to) for the longest runs [from, to) of at least two points of a hatch that are
  // `chosen`.
  template <class Chosen, class Use>
  void runs(int hatch, const Chosen& chosen, const Use& use) const {
    for (int from = begin(hatch), to; from < end(hatch); from = to + 1) {
      for (to = from; to < end(hatch) && chosen(to);) ++to;
      if (to - from >= 2) use(from, to);
    }
  }

  void add(Hatches& result, int hatch, int from, int to) const {
    const bool in_single =
        std::find(&region_[from], &region_[to - 1] + 1, Region::single) != &region_[to - 1] + 1;
    result.curves.add(Span<const HatchPoint>{&points_[from], static_cast<std::size_t>(to - from)});
    result.kinds.push_back(is_undercut(hatch) ? Kind::undercut
                           : in_single        ? Kind::hatch
                                              : Kind::cross_hatch);
    result.objects.push_back(hatches_.objects[hatch]);
  }

  const Hatches& hatches_;
  const std::vector<HatchPoint>& points_;
  const Surface& surface_;
  const HatchOptions& options_;
  const std::vector<double>& spacing_scale_;
  CriticalCurves curves_;
  NeighbourGrid grid_;                 // points in single-hatch regions
  std::vector<int> owner_;             // hatch of each point
  std::vector<Region> region_;         // of each point
  std::vector<std::uint8_t> kept_;     // of each point
  std::vector<std::uint8_t> visited_;  // of each hatch
};

}  // namespace

Hatches reduce_hatches(const Hatches& hatches, const Surface& surface, const ToneMap& tone,
                       const LabelledGraph& graph, const HatchOptions& options, Counts& counts,
                       const std::vector<double>& spacing_scale) {
  validate(options);
  Hatches result = Reducer(hatches, surface, tone, graph, options, spacing_scale).reduce();
  counts["hatches_after_reduction"] += static_cast<std::int64_t>(result.kinds.size());
  return result;
}

}  // namespace illustrate
