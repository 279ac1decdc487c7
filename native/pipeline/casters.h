// What keeps the light from others.
#pragma once

#include <memory>
#include <vector>

#include "mesh/bvh.h"
#include "pipeline/options.h"
#include "surface/surface.h"

namespace illustrate {

struct Casters {
  std::vector<Triangle> triangles;
  Bvh bvh;  // of these, and of the positions that they were made of
};

bool any_is_shadow_only(const std::vector<ObjectStyle>& styles);

// All but what is ignored. Refers to the positions of `whole`.
std::unique_ptr<Casters> casters_of(const Surface& whole, const std::vector<ObjectStyle>& styles,
                                    int threads);

// With those that only cast shadows ignored.
DrawOptions without_unseen(DrawOptions options);

}  // namespace illustrate
