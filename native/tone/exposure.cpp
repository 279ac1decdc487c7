#include "tone/exposure.h"

#include <algorithm>
#include <cmath>

#include "tone/tone_regions.h"

namespace illustrate {
namespace {

// Brighter places than this share of the area has may be more than white: lamps, glints.
constexpr double white_share = 0.05;
// How far beyond a threshold a place is to be: rounding shall not decide.
constexpr double clear_of = 1e-6;

double quantile(std::vector<double>& values, double share) {
  const auto last = static_cast<double>(values.size() - 1);
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(share * last);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace

double suitable_exposure(const ToneOptions& options, std::vector<double> light) {
  if (light.empty()) return 1;
  const double white = quantile(light, 1 - white_share);
  const double brightest = white > 0 ? white : *std::max_element(light.begin(), light.end());
  if (!(brightest > 0) || !std::isfinite(brightest)) return 1;
  double factor = 1 / brightest;
  const double darkest = quantile(light, most_of_one_tone);
  if (darkest > 0 && darkest * factor <= options.shadow_threshold) {
    factor = options.shadow_threshold / darkest * (1 + clear_of);
  }
  const double lightest = quantile(light, 1 - most_of_one_tone);
  if (lightest * factor > options.highlight_threshold) {
    const double weaker = options.highlight_threshold / lightest * (1 - clear_of);
    const bool has_lighter = white * weaker > options.highlight_threshold;
    if (has_lighter && darkest * weaker > options.shadow_threshold) factor = weaker;
  }
  return std::isfinite(factor) && factor > 0 ? factor : 1;
}

}  // namespace illustrate
