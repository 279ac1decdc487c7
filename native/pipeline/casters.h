// What keeps the light from others without being seen.
#pragma once

#include <vector>

#include "pipeline/options.h"

namespace illustrate {

bool any_is_shadow_only(const std::vector<ObjectStyle>& styles);

// With those that only cast shadows ignored.
DrawOptions without_unseen(DrawOptions options);

}  // namespace illustrate
