#include "surface/same_vertices.h"

#include <algorithm>

namespace illustrate {
namespace {

// A number for the way from a to b, the opposite for the way back (the finaliser of SplitMix64).
std::uint64_t way(int a, int b) {
  const auto mixed = [](std::uint64_t z) {
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9U;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebU;
    return z ^ (z >> 31);
  };
  const auto both = [&](int from, int to) {
    return mixed((std::uint64_t{static_cast<std::uint32_t>(from)} << 32) +
                 static_cast<std::uint32_t>(to));
  };
  return both(a, b) - both(b, a);
}

// For each face of the input meshes the sum over the edges of its triangles: diagonals, which are
// there once each way, cancel.
std::vector<std::uint64_t> outlines(const Surface& surface) {
  const std::vector<int>& faces = surface.triangle_faces;
  const int last = faces.empty() ? none : *std::max_element(faces.begin(), faces.end());
  std::vector<std::uint64_t> sums(static_cast<std::size_t>(last + 1), 0);
  for (std::size_t t = 0; t < faces.size(); ++t) {
    const Triangle& corners = surface.triangles[t];
    for (int k = 0; k < 3; ++k) {
      sums[idx(faces[t])] += way(corners[idx(k)], corners[idx(next_corner(k))]);
    }
  }
  return sums;
}

}  // namespace

bool has_same_vertices(const Surface& a, const Surface& b) {
  if (a.objects != b.objects || a.places != b.places || a.base_faces != b.base_faces ||
      a.base_uv != b.base_uv || a.triangle_objects != b.triangle_objects) {
    return false;
  }
  if (a.triangles == b.triangles) return true;
  return !a.triangle_faces.empty() && a.triangle_faces == b.triangle_faces &&
         outlines(a) == outlines(b);
}

}  // namespace illustrate
