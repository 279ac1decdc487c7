// How strong the light has to be for a view to show its form.
#pragma once

#include <vector>

namespace illustrate {

struct ToneOptions;

// What `light` is to be multiplied by, the light that comes back from the visible places (any
// order). As a photographer does it: the lightest places become white, but a few. Where more than
// most_of_one_tone of the area would then be shadow, or highlight, the light is made stronger, or
// weaker, until it is not. Where that cannot be, because so much of the area is equally light (or
// without any), it stays. 1 where there is no light at all.
double suitable_exposure(const ToneOptions& options, std::vector<double> light);

// The share of the area that may be shadow, and that may be highlight.
constexpr double most_of_one_tone = 0.6;

}  // namespace illustrate
