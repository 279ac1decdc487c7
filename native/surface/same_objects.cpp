#include "surface/same_objects.h"

#include <algorithm>
#include <limits>
#include <map>
#include <numeric>

#include "core/mixed_bits.h"
#include "surface/joined.h"
#include "surface/locate.h"

namespace illustrate {
namespace {

// A number for the way from a to b, the opposite for the way back.
std::uint64_t way(int a, int b) {
  const auto both = [&](int from, int to) {
    return mixed_bits((std::uint64_t{static_cast<std::uint32_t>(from)} << 32) +
                      static_cast<std::uint32_t>(to));
  };
  return both(a, b) - both(b, a);
}

// Numbers of vertices or triangles.
struct Range {
  int first = 0, count = 0;
};

// (objects) from where each begins, and all end.
std::vector<Range> ranges(const std::vector<int>& first) {
  std::vector<Range> result;
  for (std::size_t o = 0; o + 1 < first.size(); ++o) {
    result.push_back({first[o], first[o + 1] - first[o]});
  }
  return result;
}

// One object of a surface.
struct Part {
  const Surface& surface;
  int object;
  Range vertices, triangles;

  const ControlMesh* control() const { return surface.controls[idx(object)].mesh.get(); }

  std::size_t vertex(int i) const { return idx(vertices.first + i); }
  std::size_t triangle(int t) const { return idx(triangles.first + t); }
  int corner(int t, int k) const { return surface.triangles[triangle(t)][idx(k)] - vertices.first; }
  int face(int t) const { return surface.triangle_faces[triangle(t)]; }
  int ptex_face(int i) const {
    const int face = surface.base_faces[vertex(i)];
    return face == none ? none : face - surface.base_faces[vertex(0)];
  }
};

bool has_same_vertices(const Part& a, const Part& b) {
  if (a.vertices.count != b.vertices.count) return false;
  for (int i = 0; i < a.vertices.count; ++i) {
    const std::size_t v = a.vertex(i), w = b.vertex(i);
    if (a.surface.places[v] - a.vertices.first != b.surface.places[w] - b.vertices.first ||
        a.ptex_face(i) != b.ptex_face(i) || a.surface.base_uv[v] != b.surface.base_uv[w]) {
      return false;
    }
  }
  return true;
}

bool has_same_triangles(const Part& a, const Part& b) {
  for (int t = 0; t < a.triangles.count; ++t) {
    for (int k = 0; k < 3; ++k) {
      if (a.corner(t, k) != b.corner(t, k)) return false;
    }
  }
  return true;
}

// For each face of the input mesh the sum over the edges of its triangles: diagonals, which are
// there once each way, cancel.
std::vector<std::uint64_t> outlines(const Part& part) {
  std::vector<std::uint64_t> sums;
  for (int t = 0; t < part.triangles.count; ++t) {
    const std::size_t face = idx(part.face(t));
    if (face >= sums.size()) sums.resize(face + 1, 0);
    for (int k = 0; k < 3; ++k)
      sums[face] += way(part.corner(t, k), part.corner(t, next_corner(k)));
  }
  return sums;
}

bool has_same_faces(const Part& a, const Part& b) {
  if (a.surface.triangle_faces.empty() || b.surface.triangle_faces.empty()) return false;
  for (int t = 0; t < a.triangles.count; ++t) {
    if (a.face(t) != b.face(t)) return false;
  }
  return outlines(a) == outlines(b);
}

bool is_same(const Part& a, const Part& b) {
  // Surfaces that are put together of others (surface/joined.h) share control meshes.
  if (a.control() == b.control()) return true;
  return a.triangles.count == b.triangles.count && has_same_vertices(a, b) &&
         (has_same_triangles(a, b) || has_same_faces(a, b));
}

std::vector<int> by_number(const Surface& last, const Surface& now) {
  const std::size_t count = now.object_is_smooth.size();
  std::vector<int> numbers(count, none);
  if (last.object_is_smooth.size() == count) std::iota(numbers.begin(), numbers.end(), 0);
  return numbers;
}

}  // namespace

std::vector<int> objects_by_name(const std::vector<std::string>& last,
                                 const std::vector<std::string>& now) {
  std::map<std::string, std::vector<int>> numbers;
  for (std::size_t i = last.size(); i-- > 0;) numbers[last[i]].push_back(static_cast<int>(i));
  std::vector<std::uint8_t> is_found(last.size(), 0);
  std::vector<int> result(now.size(), none);
  for (std::size_t i = 0; i < now.size(); ++i) {
    std::vector<int>& left = numbers[now[i]];
    if (left.empty()) continue;
    result[i] = left.back();
    is_found[idx(result[i])] = 1;
    left.pop_back();
  }
  for (std::size_t i = 0; i < now.size() && i < last.size(); ++i) {
    if (result[i] == none && !is_found[i]) result[i] = static_cast<int>(i);
  }
  return result;
}

SameObjects::SameObjects(const Surface& last, const Surface& now,
                         const std::vector<int>& last_objects)
    : last_(last), now_(now) {
  const std::size_t count = now.object_is_smooth.size(), last_count = last.object_is_smooth.size();
  is_same_.assign(count, 0);
  shifts_.assign(count, {0, 0});
  now_objects_.assign(last_count, none);
  const std::vector<int> may_be = last_objects.empty() ? by_number(last, now) : last_objects;
  const std::vector<Range> last_vertices = ranges(first_vertices(last)),
                           vertices = ranges(first_vertices(now)),
                           last_triangles = ranges(first_triangles(last)),
                           triangles = ranges(first_triangles(now));
  for (std::size_t o = 0; o < count; ++o) {
    if (may_be[o] == none) continue;
    const std::size_t l = idx(may_be[o]);
    is_same_[o] = is_same({last, may_be[o], last_vertices[l], last_triangles[l]},
                          {now, static_cast<int>(o), vertices[o], triangles[o]});
    if (is_same_[o]) now_objects_[l] = static_cast<int>(o);
    shifts_[o] = {vertices[o].first - last_vertices[l].first,
                  triangles[o].first - last_triangles[l].first};
  }
}

bool SameObjects::any() const {
  return std::find(is_same_.begin(), is_same_.end(), 1) != is_same_.end();
}

Vec3 SameObjects::position(const SurfacePoint& last) const {
  const Triangle& corners = last_.triangles[idx(last.triangle)];
  const int shift = shifts_of(last)[0];
  const auto at = [&](int k) -> const Vec3& {
    return now_.positions[idx(corners[idx(k)] + shift)];
  };
  return (1 - last.b1 - last.b2) * at(0) + last.b1 * at(1) + last.b2 * at(2);
}

SurfacePoint SameObjects::point(const SurfacePoint& last) const {
  const auto& shift = shifts_of(last);
  const Triangle& before = last_.triangles[idx(last.triangle)];
  SurfacePoint best{last.triangle + shift[1], last.b1, last.b2};
  const Triangle& corners = now_.triangles[idx(best.triangle)];
  const bool is_unsplit = before[0] + shift[0] == corners[0] &&
                          before[1] + shift[0] == corners[1] && before[2] + shift[0] == corners[2];
  if (is_unsplit) return best;
  const Vec3 p = position(last);
  const int middle = best.triangle, count = static_cast<int>(now_.triangles.size());
  double deepest = -std::numeric_limits<double>::infinity();
  // The two triangles of a quad stand side by side.
  for (int t = std::max(0, middle - 1); t <= std::min(count - 1, middle + 1); ++t) {
    if (now_.triangle_faces[idx(t)] != now_.triangle_faces[idx(middle)]) continue;
    const Vec2 weights = barycentrics(now_, t, p);
    const double depth = std::min(weights.minCoeff(), 1 - weights.sum());
    if (depth <= deepest) continue;
    deepest = depth;
    best = nearest_on(now_, t, p);
  }
  return best;
}

}  // namespace illustrate
