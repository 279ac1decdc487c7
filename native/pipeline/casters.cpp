#include "pipeline/casters.h"

#include <algorithm>

namespace illustrate {

bool any_is_shadow_only(const std::vector<ObjectStyle>& styles) {
  return std::any_of(styles.begin(), styles.end(),
                     [](const ObjectStyle& s) { return s.shadow_only && !s.ignore; });
}

DrawOptions without_unseen(DrawOptions options) {
  for (ObjectStyle& style : options.styles) {
    style.ignore |= style.shadow_only;
    style.shadow_only = false;
  }
  return options;
}

}  // namespace illustrate
