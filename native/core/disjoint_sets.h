// Numbers 0 .. n - 1 that are joined into sets (union-find with path halving).
#pragma once

#include <algorithm>
#include <numeric>

#include "core/types.h"

namespace illustrate {

// The root of a set is its lowest number, whatever was joined first.
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t count) : parents_(count) {
    std::iota(parents_.begin(), parents_.end(), 0);
  }

  int root(int i) {
    while (parents_[idx(i)] != i) i = parents_[idx(i)] = parents_[idx(parents_[idx(i)])];
    return i;
  }
  void join(int a, int b) {
    a = root(a), b = root(b);
    parents_[idx(std::max(a, b))] = std::min(a, b);
  }

 private:
  std::vector<int> parents_;
};

}  // namespace illustrate
