#include "pipeline/casters.h"

#include <algorithm>

namespace illustrate {

bool any_is_shadow_only(const std::vector<ObjectStyle>& styles) {
  return std::any_of(styles.begin(), styles.end(),
                     [](const ObjectStyle& s) { return s.shadow_only && !s.ignore; });
}

std::unique_ptr<Casters> casters_of(const Surface& whole, const std::vector<ObjectStyle>& styles,
                                    int threads) {
  auto casters = std::make_unique<Casters>();
  for (std::size_t t = 0; t < whole.triangles.size(); ++t) {
    if (!styles[idx(whole.triangle_objects[t])].ignore)
      casters->triangles.push_back(whole.triangles[t]);
  }
  casters->bvh = Bvh(whole.positions, casters->triangles, threads);
  return casters;
}

DrawOptions without_unseen(DrawOptions options) {
  for (ObjectStyle& style : options.styles) {
    style.ignore |= style.shadow_only;
    style.shadow_only = false;
  }
  return options;
}

}  // namespace illustrate
