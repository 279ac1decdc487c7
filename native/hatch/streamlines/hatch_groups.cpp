#include "hatch/streamlines/hatch_groups.h"

#include <algorithm>
#include <numeric>

namespace illustrate {
namespace {

// Enough to keep the cores of an artist's machine busy; each costs a little memory.
constexpr std::size_t most_groups = 8;

// (objects) cells in which each is seen and hatched.
std::vector<std::size_t> seen_cells(const HatchScene& scene) {
  std::vector<std::size_t> cells(scene.surface.object_is_smooth.size(), 0);
  for (const int triangle : scene.visible.triangle) {
    if (triangle == none) continue;
    const int object = scene.surface.object_of(triangle);
    if (scene.is_hatched(object)) ++cells[idx(object)];
  }
  return cells;
}

// (objects) the group of each, 0 where nothing is seen: the largest object first, each to the group
// that has least.
std::vector<std::size_t> divided(const std::vector<std::size_t>& cells) {
  std::vector<std::size_t> order(cells.size()), groups(cells.size(), 0);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return cells[a] > cells[b]; });
  std::vector<std::size_t> sums(most_groups, 0);
  for (const std::size_t object : order) {
    if (cells[object] == 0) break;  // nor has any that follows
    const auto least = std::min_element(sums.begin(), sums.end());
    *least += cells[object];
    groups[object] = static_cast<std::size_t>(least - sums.begin());
  }
  return groups;
}

// Hands what lies on the surface to the groups of its objects.
class Divider {
 public:
  explicit Divider(const HatchScene& scene)
      : objects_(scene.surface.triangle_objects),
        group_of_(divided(seen_cells(scene))),
        groups_(1 + *std::max_element(group_of_.begin(), group_of_.end())) {}

  void divide(const CurvesOfObjects& curves) {
    for (HatchGroup& group : groups_) group.curves.resize(curves.size());
    for (std::size_t o = 0; o < curves.size(); ++o) groups_[group_of_[o]].curves[o] = curves[o];
  }

  void divide(const Ragged<SurfacePoint>& streamlines) {
    for (std::size_t i = 0; i < streamlines.size(); ++i) {
      if (!streamlines[i].empty()) group(streamlines[i][0]).first.add(streamlines[i]);
    }
  }

  void divide(const SeedPlaces& places, SeedPlaces HatchGroup::*const area) {
    for (HatchGroup& group : groups_) (group.*area).spacings = places.spacings;
    for (const SurfacePoint& on : places.lattice) (group(on).*area).lattice.push_back(on);
    for (const SurfacePoint& on : places.strips) (group(on).*area).strips.push_back(on);
  }

  std::vector<HatchGroup> take() { return std::move(groups_); }

 private:
  HatchGroup& group(const SurfacePoint& on) {
    return groups_[group_of_[idx(objects_[idx(on.triangle)])]];
  }

  const std::vector<int>& objects_;
  const std::vector<std::size_t> group_of_;  // (objects)
  std::vector<HatchGroup> groups_;
};

}  // namespace

std::vector<HatchGroup> hatch_groups(const HatchScene& scene, HatchGroup all) {
  if (all.curves.size() <= 1) return {std::move(all)};
  Divider divider(scene);
  divider.divide(all.curves);
  divider.divide(all.first);
  divider.divide(all.hatched, &HatchGroup::hatched);
  divider.divide(all.undercuts, &HatchGroup::undercuts);
  return divider.take();
}

Hatches joined(std::vector<Hatches> groups) {
  if (groups.size() == 1) return std::move(groups[0]);
  Hatches all, result;
  for (const Hatches& hatches : groups) {
    all.add(hatches);
    for (std::size_t i = 0; i < hatches.placed.size(); ++i) result.placed.add(hatches.placed[i]);
  }
  std::vector<std::size_t> order(all.objects.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return all.objects[a] < all.objects[b]; });
  for (const std::size_t h : order) result.add(all, h);
  return result;
}

}  // namespace illustrate
