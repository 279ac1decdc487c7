#include "hatch/reduce_hatches.h"

#include <algorithm>
#include <cstdlib>
#include <utility>

#include "hatch/choose_family.h"
#include "hatch/critical_curves.h"
#include "hatch/hatch_runs.h"
#include "hatch/neighbour_grid.h"

namespace illustrate {
namespace {

// In spacings: shorter strokes are specks where no longer one runs parallel within `company`,
// unless they lie in an undercut; still shorter ones are nowhere worth a stroke.
constexpr double speck = 1.5;
constexpr double shadow_speck = 3;  // the same for what a shadow leaves of a hatch
constexpr double company = 2;
constexpr double least_stroke = 0.5;

// In spacings: a hatch that is shorter in a shadow, and goes on outside, is no cross-hatch there.
constexpr double least_shadow = 1.5;

// Hatches cross from about 42 degrees on (squared cosine), also a little farther away: what lies
// between their points counts too.
constexpr double most_crossing = 0.55;
constexpr double crossing_margin = 0.2;

// How often parts of a hatch are clipped where it bends.
constexpr int most_rounds = 4;

// Spacings in depth between the two sides of a silhouette that are sheets of their own.
constexpr double most_step = 3.2;

// Pieces vote with one point in so many spacings.
constexpr double vote_step = 0.8;

// What joins two pieces of a hatch across a shadow, in votes.
constexpr int shadow_link = 6;

// Radians per spacing: less bend says little about the form. Where it bends in neither direction
// the longer strokes are to be kept: what each spacing of length is worth.
constexpr double slight_bend = 0.005;
constexpr double worth_of_length = 1e-6;

class Reducer {
 public:
  Reducer(const Hatches& hatches, const HatchScene& scene, const HatchOptions& options)
      : hatches_(hatches),
        points_(hatches.curves.values),
        scene_(scene),
        surface_(scene.surface),
        options_(options),
        curves_(scene.curves),
        grid_(empty_grid()),
        owner_(points_.size()),
        region_(points_.size(), Region::neither),
        kept_(points_.size(), 1),
        piece_of_(points_.size(), none) {
    for (int h = 0; h < count(); ++h) enter(h);
  }

  // The kept parts of all hatches, in their order.
  Hatches reduce() {
    const Ragged<FamilyLink> links = this->links();
    const FamilyChoice choice = choose_family(links, preferences(links));
    for (const int piece : choice.order) {
      if (choice.is_kept[piece]) keep_uncrossed(pieces_[piece]);
    }
    for (const Run& run : longest_uncrossed()) keep_uncrossed(run);
    for (int round = 0; round < most_rounds && clip_bends(); ++round) continue;
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
    return length_px({&points_[run.from], static_cast<std::size_t>(run.to - run.from)});
  }

  // A hatch's regions, and its pieces: what is in single-hatch regions, deleted at first.
  void enter(int hatch) {
    for (int i = begin(hatch); i < end(hatch); ++i) {
      owner_[i] = hatch;
      region_[i] = region_of(scene_.tone, points_[i].image);
      if (region_[i] == Region::neither && i > begin(hatch)) region_[i] = region_[i - 1];
    }
    if (is_undercut(hatch)) return;
    pass_slight_shadows(hatch);
    const auto is_single = [&](int i) { return region_[i] == Region::single; };
    for (const Run& run : runs({begin(hatch), end(hatch)}, is_single)) {
      for (int i = run.from; i < run.to; ++i) {
        kept_[i] = 0;
        piece_of_[i] = static_cast<int>(pieces_.size());
        grid_.add({points_[i].image, tangent_at(i), i});
      }
      pieces_.push_back(run);
    }
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

  Vec3 tangent_at(int point) const {
    const int before = std::max(point - 1, begin(owner_[point]));
    const int after = std::min(point + 1, end(owner_[point]) - 1);
    return (points_[after].position - points_[before].position).normalized();
  }

  // The points that a piece votes with.
  std::vector<int> voters(const Run& run) const {
    const int count = run.to - run.from;
    const double gap = length_of(run) / std::max(1, count - 1);
    const double wanted = vote_step * spacing_of(owner_[run.from]);
    const int stride = wanted < count * gap ? std::max(1, static_cast<int>(wanted / gap)) : count;
    std::vector<int> chosen;
    for (int i = run.from + (run.to - run.from - 1) % stride / 2; i < run.to; i += stride) {
      chosen.push_back(i);
    }
    return chosen;
  }

  Ragged<FamilyLink> links() const {
    Ragged<FamilyLink> result;
    NeighbourGrid all_voters = empty_grid();
    for (const Run& piece : pieces_) {
      for (const int i : voters(piece)) all_voters.add({points_[i].image, tangent_at(i), i});
    }
    std::vector<int> weight(pieces_.size(), 0), others;
    const auto link = [&](int other, int by) {
      if (weight[other] == 0) others.push_back(other);
      weight[other] += by;
    };
    for (int piece = 0; piece < static_cast<int>(pieces_.size()); ++piece) {
      others.clear();
      link_neighbours(all_voters, piece, link);
      for (const int other : {piece - 1, piece + 1}) {
        if (is_same_hatch(piece, other)) link(other, shadow_link);
      }
      for (const int other : others) {
        if (weight[other] != 0) result.push({other, weight[other]});
        weight[other] = 0;
      }
      result.close_list();
    }
    return result;
  }

  bool is_same_hatch(int piece, int other) const {
    return other >= 0 && other < static_cast<int>(pieces_.size()) &&
           owner_[pieces_[other].from] == owner_[pieces_[piece].from];
  }

  template <class Link>
  void link_neighbours(const NeighbourGrid& all_voters, int piece, const Link& link) const {
    for (const int i : voters(pieces_[piece])) {
      any_neighbour(all_voters, i, reach(i), [&](int other, bool parallel) {
        if (is_same_sheet(i, other)) {
          link(piece_of_[other], parallel ? 1 : -1);
        }
        return false;
      });
    }
  }

  // How far the form bends along a piece, in radians.
  double bend_of(const Run& piece) const {
    double bend = 0;
    for (int i = piece.from + 1; i < piece.to; ++i) {
      const Vec3 a = normal_at(surface_, points_[i - 1].on), b = normal_at(surface_, points_[i].on);
      bend += std::abs((a.dot(b) < 0 ? Vec3(a + b) : Vec3(a - b)).dot(tangent_at(i)));
    }
    return bend;
  }

  // Strokes show a form best that run round it, where it bends more than across them.
  std::vector<double> preferences(const Ragged<FamilyLink>& links) const {
    std::vector<double> curvature, result;
    for (const Run& piece : pieces_) {
      const double length = std::max(1.0, length_of(piece) / spacing_of(owner_[piece.from]));
      curvature.push_back(bend_of(piece) / length + slight_bend + worth_of_length * length);
    }
    for (std::size_t piece = 0; piece < pieces_.size(); ++piece) {
      double across = 0, weight = 0;
      for (const FamilyLink& link : links[piece]) {
        across -= std::min(link.weight, 0) * curvature[link.other];
        weight -= std::min(link.weight, 0);
      }
      const double other = weight > 0 ? across / weight : curvature[piece];
      result.push_back((curvature[piece] - other) / (curvature[piece] + other));
    }
    return result;
  }

  void keep_uncrossed(const Run& within) {
    for (const Run& run : runs(within, [&](int i) { return !kept_[i] && !is_crossed_at(i); })) {
      if (run.to - run.from >= 2) std::fill(&kept_[run.from], &kept_[run.to - 1] + 1, 1);
    }
  }

  // Parts of deleted pieces that cross nothing that is kept and are worth a stroke.
  std::vector<Run> longest_uncrossed() const {
    std::vector<std::pair<double, int>> order;
    std::vector<Run> found, result;
    for (const Run& piece : pieces_) {
      for (const Run& run : runs(piece, [&](int i) { return !kept_[i] && !is_crossed_at(i); })) {
        const double length = length_of(run);
        if (length < speck * spacing_of(owner_[run.from])) continue;
        order.push_back({-length, static_cast<int>(found.size())});
        found.push_back(run);
      }
    }
    std::sort(order.begin(), order.end());
    for (const auto& entry : order) result.push_back(found[entry.second]);
    return result;
  }

  // A hatch that bends and is cut there may be left with parts across each other: the shorter one
  // is clipped. Whether any was.
  bool clip_bends() {
    std::vector<std::pair<double, int>> order;
    std::vector<Run> all;
    std::vector<int> run_of(points_.size(), none);
    for (int h = 0; h < count(); ++h) {
      for (const Run& run : runs({begin(h), end(h)}, [&](int i) { return kept_[i] != 0; })) {
        std::fill(run_of.begin() + run.from, run_of.begin() + run.to, static_cast<int>(all.size()));
        order.push_back({length_of(run), static_cast<int>(all.size())});
        all.push_back(run);
      }
    }
    std::sort(order.begin(), order.end());
    bool any = false;
    for (const auto& entry : order) {
      for (int i = all[entry.second].from; i < all[entry.second].to; ++i) {
        if (piece_of_[i] == none || !is_across_other_part(i, run_of)) continue;
        kept_[i] = 0;
        any = true;
      }
    }
    return any;
  }

  bool is_across_other_part(int point, const std::vector<int>& run_of) const {
    const Vec3 tangent = tangent_at(point);
    const double radius = crossing_reach(point);
    return grid_.any_within(points_[point].image, radius, [&](const HatchNode& node) {
      const bool is_other_part =
          owner_[node.point] == owner_[point] && run_of[node.point] != run_of[point];
      if (!is_other_part || !kept_[node.point]) return false;
      const double along = tangent.dot(node.tangent);
      return along * along < most_crossing && is_same_sheet(point, node.point);
    });
  }

  double crossing_reach(int point) const {
    return reach(point) + crossing_margin * spacing_of(owner_[point]);
  }

  // How near hatches are neighbours.
  double reach(int point) const { return 2 * spacing_of(owner_[point]); }

  NeighbourGrid empty_grid() const {
    return {double(scene_.camera.width_px()), double(scene_.camera.height_px()),
            options_.spacing_px};
  }

  // Whether use(point, parallel) accepts a point of another hatch in `grid` within `radius`.
  template <class Use>
  bool any_neighbour(const NeighbourGrid& grid, int point, double radius, const Use& use) const {
    const Vec3 tangent = tangent_at(point), normal = normal_at(surface_, points_[point].on);
    return grid.any_within(points_[point].image, radius, [&](const HatchNode& node) {
      if (owner_[node.point] == owner_[point]) return false;
      return use(node.point, are_parallel(tangent, normal, node.tangent));
    });
  }

  bool is_crossed_at(int point) const {
    const Vec3 tangent = tangent_at(point), normal = normal_at(surface_, points_[point].on);
    return grid_.any_within(
        points_[point].image, crossing_reach(point), [&](const HatchNode& node) {
          if (!kept_[node.point] || owner_[node.point] == owner_[point]) return false;
          const double along = tangent.dot(node.tangent);
          return (along * along < most_crossing || !are_parallel(tangent, normal, node.tangent)) &&
                 is_same_sheet(point, node.point);
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

  bool in_shadow(const Run& run) const {
    return std::all_of(&region_[run.from], &region_[run.to - 1] + 1,
                       [](Region region) { return region == Region::shadow; });
  }

  // Whether a run, or a parallel one of another hatch near its middle, is in `grid`.
  bool is_beside(const NeighbourGrid& longer, const Run& run) const {
    const int hatch = owner_[run.from];
    const double spacing = spacing_of(hatch);
    const bool is_clipped = run.from > begin(hatch) || run.to < end(hatch);
    if (length_of(run) >= (is_clipped && in_shadow(run) ? shadow_speck : speck) * spacing)
      return true;
    return any_neighbour(longer, (run.from + run.to) / 2, company * spacing,
                         [&](int, bool parallel) { return parallel; });
  }

  void add(Hatches& result, const Run& run) const {
    const int hatch = owner_[run.from];
    const Region* last = &region_[run.to - 1] + 1;
    const bool in_single = std::find(&region_[run.from], last, Region::single) != last;
    result.curves.add(
        Span<const HatchPoint>{&points_[run.from], static_cast<std::size_t>(run.to - run.from)});
    result.kinds.push_back(is_undercut(hatch) ? Kind::undercut
                           : in_single        ? Kind::hatch
                                              : Kind::cross_hatch);
    result.objects.push_back(hatches_.objects[hatch]);
  }

  const Hatches& hatches_;
  const std::vector<HatchPoint>& points_;
  const HatchScene& scene_;
  const Surface& surface_;
  const HatchOptions& options_;
  const CriticalCurves& curves_;
  NeighbourGrid grid_;              // points of pieces
  std::vector<int> owner_;          // hatch of each point
  std::vector<Region> region_;      // of each point
  std::vector<std::uint8_t> kept_;  // of each point
  std::vector<int> piece_of_;       // of each point, none elsewhere
  std::vector<Run> pieces_;         // in single-hatch regions
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
