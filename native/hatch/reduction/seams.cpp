#include "hatch/reduction/seams.h"

#include <algorithm>
#include <cstdlib>
#include <tuple>

#include "hatch/greedy/neighbour_grid.h"

namespace illustrate {
namespace {

// In spacings, of hatches at seams; a little more than one: what lies between points counts too.
constexpr double seam_clearance = 1.05;

// Hatches cross from about 42 degrees on (squared cosine).
constexpr double most_crossing = 0.55;

// Spacings in depth between the two sides of a silhouette that are sheets of their own.
constexpr double most_step = 3.2;

class SeamClipper {
 public:
  SeamClipper(const HatchPoints& points, const HatchScene& scene, double spacing_px)
      : points_(points), scene_(scene), spacing_px_(spacing_px) {}

  // In the order in which they are wanted each point stays that crosses none that does. The index
  // settles ties: hatches that were placed first are the better ones.
  std::vector<std::uint8_t> run() const {
    std::vector<std::uint8_t> is_kept(idx(points_.count()), 1);
    NeighbourGrid kept = empty_grid();
    for (const auto& [is_new, depth, i] : crossed_points()) {
      is_kept[idx(i)] = !is_crossed_at(i, kept);
      if (is_kept[idx(i)]) kept.add(node(i));
    }
    return is_kept;
  }

 private:
  using Wanted = std::tuple<bool, double, int>;  // not drawn before, - to_end, the point

  NeighbourGrid empty_grid() const {
    return {double(scene_.camera.width_px()), double(scene_.camera.height_px()), spacing_px_};
  }

  HatchNode node(int i) const { return {points_[i].image, points_.tangent(i), i}; }

  bool is_at_stake(int i) const {
    return points_.region(i) == Region::single && !points_.is_undercut(points_.owner(i));
  }

  bool was_drawn(int i) const {
    return scene_.last &&
           scene_.last->was_at(points_[i], points_.tangent(i), points_.spacing(points_.owner(i)));
  }

  std::vector<Wanted> crossed_points() const {
    NeighbourGrid all = empty_grid();
    for (int i = 0; i < points_.count(); ++i) {
      if (is_at_stake(i)) all.add(node(i));
    }
    std::vector<Wanted> crossed;
    for (int i = 0; i < points_.count(); ++i) {
      if (!is_at_stake(i) || !is_crossed_at(i, all)) continue;
      crossed.emplace_back(!was_drawn(i), -points_.to_end(i), i);
    }
    std::sort(crossed.begin(), crossed.end());
    return crossed;
  }

  bool is_crossed_at(int i, const NeighbourGrid& grid) const {
    const Vec3 tangent = points_.tangent(i);
    const double radius = seam_clearance * points_.spacing(points_.owner(i));
    return grid.any_within(points_[i].image, radius, [&](const HatchNode& other) {
      if (points_.owner(other.point) == points_.owner(i)) return false;
      const double along = tangent.dot(other.tangent);
      return along * along < most_crossing && are_on_one_sheet(i, other.point);
    });
  }

  bool are_on_one_sheet(int a, int b) const {
    const Vec2 &from = points_[a].image, &to = points_[b].image;
    if (!scene_.curves.separate(from, to)) return true;
    if (scene_.curves.is_edge_between(from, to)) return false;
    const Vec3 &p = points_[a].position, &q = points_[b].position;
    const double depth = std::abs(scene_.camera.project(p).depth - scene_.camera.project(q).depth);
    return depth < most_step * points_.spacing(points_.owner(a)) * scene_.camera.pixel_size(p);
  }

  const HatchPoints& points_;
  const HatchScene& scene_;
  const double spacing_px_;
};

}  // namespace

std::vector<std::uint8_t> kept_at_seams(const HatchPoints& points, const HatchScene& scene,
                                        double spacing_px) {
  return SeamClipper(points, scene, spacing_px).run();
}

}  // namespace illustrate
