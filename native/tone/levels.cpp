#include "tone/levels.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "tone/tone_regions.h"

namespace illustrate {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// Brightness ends at 1, so at a threshold of 1 nothing is brighter.
double cut_at_white(double threshold) { return threshold >= 1 ? infinity : threshold; }

// Light that differs by less, relative to itself, is the same: flat faces are not torn apart by
// rounding.
constexpr double same_light = 1e-6;

// The threshold that a share of the values, as near as can be, lies above. Reorders them.
double threshold_below(double share, std::vector<double>& values) {
  const auto count = static_cast<double>(values.size());
  const auto above = static_cast<std::size_t>(std::lround(share * count));
  if (above == 0) return infinity;
  if (above >= values.size()) return -infinity;
  const auto border = values.begin() + static_cast<std::ptrdiff_t>(above);
  std::nth_element(values.begin(), border, values.end(), std::greater<>());
  const double slack = same_light * std::max(std::abs(*border), same_light);
  const double over = *border + slack, under = *border - slack;
  const auto count_above = [&](double threshold) {
    return std::size_t(std::count_if(values.begin(), values.end(),
                                     [threshold](double value) { return value > threshold; }));
  };
  return above - count_above(over) <= count_above(under) - above ? over : under;
}

}  // namespace

Thresholds find_thresholds(const ToneOptions& options, std::vector<double> light) {
  Thresholds found{};
  found.highlight = options.highlight_share ? threshold_below(*options.highlight_share, light)
                                            : cut_at_white(options.highlight_threshold);
  const auto darkest = [&](double part) {  // of the shadows
    return options.shadow_share ? threshold_below(1 - part * *options.shadow_share, light)
                                : part * options.shadow_threshold;
  };
  found.shadow = options.shadow_share ? darkest(1) : cut_at_white(options.shadow_threshold);
  for (int i = 0; i < 3; ++i) {
    const bool is_asked = i < options.extra_levels;
    const double part = double(options.extra_levels - i) / (options.extra_levels + 1);
    found.extra[std::size_t(i)] = is_asked ? darkest(part) : -infinity;
  }
  return found;
}

}  // namespace illustrate
