// Some elements of a list, in another order.
#pragma once

#include <utility>
#include <vector>

#include "core/types.h"

namespace illustrate {

// values[i] becomes what values[sources[i]] was; an empty list, which nobody has filled, stays.
template <class T>
void keep_elements(std::vector<T>& values, const std::vector<int>& sources) {
  if (values.empty()) return;
  std::vector<T> kept;
  kept.reserve(sources.size());
  for (const int source : sources) kept.push_back(values[idx(source)]);
  values = std::move(kept);
}

}  // namespace illustrate
