// Objects that have their surface in common: it is made once, and placed for each of them.
#pragma once

#include "surface/joined.h"

namespace illustrate {

// Which of the surfaces that were made, the originals, each object has, and where.
struct Instances {
  std::vector<int> originals;          // (objects)
  std::vector<Similarity> placements;  // (objects) from the original to the object
  // Every object is its own original, where it is: nothing has to be placed.
  bool are_trivial = true;

  // In a surface whose objects are the originals.
  ObjectSources sources() const {
    ObjectSources result;
    for (std::size_t o = 0; o < originals.size(); ++o) {
      result.push_back({0, originals[o], placements[o]});
    }
    return result;
  }
};

}  // namespace illustrate
