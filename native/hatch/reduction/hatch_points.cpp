#include "hatch/reduction/hatch_points.h"

#include <algorithm>

namespace illustrate {
namespace {

// In spacings: a hatch that is shorter in a shadow, and goes on outside, is no cross-hatch there.
constexpr double least_shadow = 1.5;

}  // namespace

HatchPoints::HatchPoints(const Hatches& hatches, const HatchScene& scene, double spacing_px)
    : hatches_(hatches),
      scene_(scene),
      spacing_px_(spacing_px),
      owner_(hatches.curves.values.size()),
      region_(owner_.size(), Region::neither),
      to_end_(owner_.size(), 0) {
  for (int h = 0; h < this->hatches(); ++h) {
    find_regions(h);
    if (is_undercut(h)) continue;
    pass_slight_shadows(h);
    measure_ends(h);
  }
}

void HatchPoints::find_regions(int hatch) {
  const Run run = whole(hatch);
  for (int i = run.from; i < run.to; ++i) {
    owner_[idx(i)] = hatch;
    const Region region = region_of(scene_.tone, (*this)[i].image);
    const bool is_beyond = region == Region::neither && i > run.from;
    region_[idx(i)] = is_beyond ? region_[idx(i - 1)] : region;
  }
}

void HatchPoints::pass_slight_shadows(int hatch) {
  const Run all = whole(hatch);
  const auto is_single = [&](int i) {
    return i >= all.from && i < all.to && region(i) == Region::single;
  };
  for (const Run& run : runs(all, [&](int i) { return region(i) == Region::shadow; })) {
    const bool goes_on = is_single(run.from - 1) || is_single(run.to);
    if (!goes_on || length(run) >= least_shadow * spacing(hatch)) continue;
    std::fill_n(region_.begin() + run.from, run.to - run.from, Region::single);
  }
}

// From one end, then the less of it and what the other end gives.
void HatchPoints::measure_ends(int hatch) {
  const Run run = whole(hatch);
  const auto step = [&](int i) {
    return ((*this)[i].image - (*this)[i - 1].image).norm() / spacing(hatch);
  };
  for (int i = run.from + 1; i < run.to; ++i) to_end_[idx(i)] = to_end_[idx(i - 1)] + step(i);
  double rest = 0;
  for (int i = run.to - 1; i > run.from; --i) {
    to_end_[idx(i)] = std::min(to_end_[idx(i)], rest);
    rest += step(i);
  }
}

Vec3 HatchPoints::tangent(int point) const {
  const Run run = whole(owner(point));
  const int before = std::max(point - 1, run.from), after = std::min(point + 1, run.to - 1);
  return ((*this)[after].position - (*this)[before].position).normalized();
}

bool HatchPoints::any_in(const Run& run, Region region) const {
  const auto end = region_.begin() + run.to;
  return std::find(region_.begin() + run.from, end, region) != end;
}

bool HatchPoints::all_in(const Run& run, Region region) const {
  return std::count(region_.begin() + run.from, region_.begin() + run.to, region) ==
         run.to - run.from;
}

}  // namespace illustrate
