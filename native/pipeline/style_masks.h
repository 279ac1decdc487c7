// What the styles of objects say, one list for each question.
#pragma once

#include "pipeline/options.h"

namespace illustrate {

using Mask = std::vector<std::uint8_t>;  // (objects); empty where no styles are given: all 0

Mask unhatched_objects(const std::vector<ObjectStyle>& styles);
Mask undrawn_objects(const std::vector<ObjectStyle>& styles);  // without lines
Mask shadow_catchers(const std::vector<ObjectStyle>& styles);

// Of which the loose edges are drawn; count: of the objects.
Mask loose_objects(const DrawOptions& options, std::size_t count);

// (objects) factors; empty where no styles are given: all 1.
std::vector<double> spacing_scales(const std::vector<ObjectStyle>& styles);
std::vector<double> width_scales(const std::vector<ObjectStyle>& styles);

bool anything_is_hatched(const DrawOptions& options);

}  // namespace illustrate
