#include "mesh/shading.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "core/angles.h"
#include "mesh/mesh_size.h"
#include "mesh/polygons.h"
#include "mesh/source_corners.h"

namespace illustrate {
namespace {

// What coordinates may be off by, as a share of their size: files in print have six digits, and
// single precision after a few transformations has no more.
constexpr double coordinate_noise = 1e-6;

// A face is a sliver where noise at its tips turns its plane by more than what counts as flat...
const double noisy_height = 2 * coordinate_noise / radians(flat_shading_deg);
// ...and whose shape is that of a needle: small faces of good shape are detail.
constexpr double needle_aspect = 0.01;

// Cosines between its normal and its neighbours' are compared in steps of one millionth, so that
// rounding does not choose.
constexpr double cosine_steps = 1e6;

// Of a sliver's edges those count as its long sides that have this share of the longest.
constexpr double long_side = 1.0 / 3;

// Half of the diagonal, which is as far as faces reach from their middle, however they are turned.
double coordinate_size(const Faces& faces, const Points& positions) {
  double farthest = 0;
  for (const int v : faces.corners) farthest = std::max(farthest, positions[v].stableNorm());
  const double size = diagonal(faces, positions) / 2;
  return size > 0 ? rounding_size(size, farthest) : 0;
}

std::vector<int> half_edge_mates(const Faces& faces, const Ragged<int>& edges) {
  std::vector<int> mates(faces.corners.size(), none);
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const auto edge = edges[e];
    if (edge.size() != 2) continue;
    mates[edge[0]] = edge[1];
    mates[edge[1]] = edge[0];
  }
  return mates;
}

// Gives slivers the normals of their neighbours, inwards from those that have one.
class SliverNormals {
 public:
  SliverNormals(const Faces& faces, const Points& positions, const Ragged<int>& edges)
      : faces_(faces), positions_(positions), normals_(unit_normals(faces, positions)) {
    find_slivers();
    all_ = slivers_;
    if (slivers_.empty()) return;
    mates_ = half_edge_mates(faces, edges);
    // Across its long sides a sliver lies along its neighbour; only where none of those is known
    // does it take what it meets at its tips.
    resolve(long_side);
    resolve(0);
  }

  Points take() { return std::move(normals_); }
  const std::vector<int>& all() const { return all_; }

 private:
  double edge_length(int h) const {
    return (positions_[faces_.head(h)] - positions_[faces_.corners[h]]).stableNorm();
  }

  double longest_edge(int face) const {
    double longest = 0;
    for (int h = faces_.offsets[face]; h < faces_.offsets[face + 1]; ++h)
      longest = std::max(longest, edge_length(h));
    return longest;
  }

  // Height of the face over its longest edge, as if it were a triangle.
  double height(int face, double longest) const {
    const auto corners = faces_[face];
    const Vec3& origin = positions_[corners[0]];
    Vec3 area = Vec3::Zero();
    for (std::size_t k = 1; k + 1 < corners.size(); ++k)
      area += ((positions_[corners[k]] - origin) / longest)
                  .cross((positions_[corners[k + 1]] - origin) / longest);
    return area.norm() * longest;
  }

  void find_slivers() {
    is_open_.assign(faces_.sources.size(), 0);
    const double thin = noisy_height * coordinate_size(faces_, positions_);
    for (int f = 0; f < faces_.size(); ++f) {
      const double longest = longest_edge(f);
      if (longest > 0) {
        const double h = height(f, longest);
        if (h >= thin || h >= needle_aspect * longest) continue;
      }
      is_open_[f] = 1;
      slivers_.push_back(f);
    }
  }

  // The face across a side of at least a share of the face's longest edge whose normal is known: of
  // several the one that the face's own normal, noisy as it is, lies nearest to, whichever side of
  // it is up; else the one across the longest side.
  int best_neighbour(int face, double share) const {
    const double least = share * longest_edge(face);
    double best_cosine = -1, best_length = 0;
    int found = none;
    for (int h = faces_.offsets[face]; h < faces_.offsets[face + 1]; ++h) {
      const int other = mates_[h] == none ? none : faces_.corner_faces[mates_[h]];
      if (other == none || is_open_[other]) continue;
      const double length = edge_length(h);
      const double cosine =
          std::round(cosine_steps * std::abs(normals_[face].dot(normals_[other])));
      // Of sides that are equally long the first.
      if (length < least || std::tie(cosine, length) <= std::tie(best_cosine, best_length))
        continue;
      best_cosine = cosine;
      best_length = length;
      found = other;
    }
    return found;
  }

  // In rounds, so that the order of the faces does not matter.
  void resolve(double share) {
    std::vector<Edge> found;  // sliver, neighbour
    do {
      found.clear();
      for (const int f : slivers_) {
        const int other = is_open_[f] ? best_neighbour(f, share) : none;
        if (other != none) found.push_back({f, other});
      }
      for (const auto& [f, other] : found) {
        normals_[f] = normals_[other];
        is_open_[f] = 0;
      }
      const auto is_known = [&](int f) { return is_open_[f] == 0; };
      slivers_.erase(std::remove_if(slivers_.begin(), slivers_.end(), is_known), slivers_.end());
    } while (!found.empty());
  }

  const Faces& faces_;
  const Points& positions_;
  Points normals_;
  std::vector<std::uint8_t> is_open_;  // (f) 1: a sliver whose normal is not known yet
  std::vector<int> slivers_;           // those, ascending
  std::vector<int> all_;               // all slivers
  std::vector<int> mates_;
};

// Whether most steps from corner to corner go backwards in the input. Not all: where a face was
// taken apart, or lost corners, a step may jump either way. Corners that are none of the input's
// have no say.
bool runs_backwards(std::vector<int> input_corners, int size) {
  int balance = 0;
  input_corners.erase(std::remove(input_corners.begin(), input_corners.end(), none),
                      input_corners.end());
  for (std::size_t k = 0; k < input_corners.size(); ++k) {
    const int here = input_corners[k], next = input_corners[(k + 1) % input_corners.size()];
    const int step = ((next - here) % size + size) % size;
    balance += 2 * step < size ? 1 : 2 * step > size ? -1 : 0;
  }
  return balance < 0;
}

class ShadingReader {
 public:
  ShadingReader(const PolygonMesh& mesh, const Faces& faces, const std::vector<int>& numbers,
                const SoundMesh& sound, Shading& shading)
      : mesh_(mesh), faces_(faces), sound_(sound), corners_(mesh, numbers), shading_(shading) {}

  void run() {
    shading_.corner_normals.resize(faces_.corners.size());
    shading_.is_flat.assign(faces_.sources.size(), 1);
    shading_.is_reversed.assign(faces_.sources.size(), 0);
    for (int f = 0; f < faces_.size(); ++f) {
      if (sound_.kept[f] == 0)
        shading_.face_normals[f] = -shading_.face_normals[sound_.twin_faces[f]];
    }
    for (int f = 0; f < faces_.size(); ++f) {
      if (sound_.kept[f]) {
        read_face(f);
      } else {
        read_twin(f, sound_.twin_faces[f]);  // which comes before
      }
    }
    for (int f = 0; f < faces_.size(); ++f) shading_.is_flat[f] = is_flat(f);
  }

  // What is shaded with the noise of its own plane, like no face beside it, is shaded flat.
  void mend_slivers(const std::vector<int>& slivers, const std::vector<int>& mates) {
    std::vector<int> noisy;
    for (const int f : slivers) {
      if (!shading_.is_flat[f] && !agrees_with_neighbour(f, mates)) noisy.push_back(f);
    }
    for (const int f : noisy) {
      std::fill(shading_.corner_normals.begin() + faces_.offsets[f],
                shading_.corner_normals.begin() + faces_.offsets[f + 1], shading_.face_normals[f]);
      shading_.is_flat[f] = 1;
    }
  }

 private:
  // A twin reads its partner's corners backwards.
  void read_twin(int f, int partner) {
    shading_.is_reversed[f] = !shading_.is_reversed[partner];
    const int first = faces_.offsets[f], last = faces_.offsets[f + 1] - 1;
    for (int c = first; c <= last; ++c)
      shading_.corner_normals[c] = -shading_.corner_normals[faces_.offsets[partner] + last - c];
  }

  void read_face(int f) {
    const int first = faces_.offsets[f], source = faces_.sources[f];
    input_corners_.clear();
    for (const int v : faces_[f])
      input_corners_.push_back(corners_.find(source, sound_.source_vertices[v]));
    const bool reversed = runs_backwards(input_corners_, mesh_.face_sizes[source]);
    shading_.is_reversed[f] = reversed;
    for (std::size_t k = 0; k < input_corners_.size(); ++k) {
      Vec3& normal = shading_.corner_normals[first + static_cast<int>(k)];
      normal = input_corners_[k] == none ? between(f, first + static_cast<int>(k))
                                         : given_normal(mesh_, input_corners_[k]);
      if (reversed) normal = -normal;
      if (normal.isZero()) normal = shading_.face_normals[f];
    }
  }

  // At a corner of a face where an edge of the input was divided (mesh/junctions.h): as shading has
  // it, linear between the ends of that edge.
  Vec3 between(int f, int corner) const {
    int before = corner, after = corner;
    const auto input = [&](int c) { return input_corners_[idx(c - faces_.offsets[f])]; };
    do before = faces_.previous(before);
    while (input(before) == none && before != corner);
    do after = faces_.next(after);
    while (input(after) == none && after != corner);
    const auto place = [&](int c) -> const Vec3& {
      return sound_.positions[idx(faces_.corners[c])];
    };
    const double from = (place(corner) - place(before)).stableNorm();
    const double to = (place(after) - place(corner)).stableNorm();
    return unit_or_zero(to * given_normal(mesh_, input(before)) +
                        from * given_normal(mesh_, input(after)));
  }

  bool agrees_with_neighbour(int f, const std::vector<int>& mates) const {
    const Points& normals = shading_.corner_normals;
    for (int h = faces_.offsets[f]; h < faces_.offsets[f + 1]; ++h) {
      const int mate = mates[h];
      if (mate == none) continue;
      if (std::abs(normals[h].dot(normals[faces_.next(mate)])) >= crease_normals_cosine &&
          std::abs(normals[faces_.next(h)].dot(normals[mate])) >= crease_normals_cosine)
        return true;
    }
    return false;
  }

  // Whichever side its normal is seen from.
  bool is_flat(int f) const {
    for (int h = faces_.offsets[f]; h < faces_.offsets[f + 1]; ++h) {
      if (!(std::abs(shading_.corner_normals[h].dot(shading_.face_normals[f])) >=
            flat_shading_cosine))
        return false;
    }
    return true;
  }

  const PolygonMesh& mesh_;
  const Faces& faces_;
  const SoundMesh& sound_;
  SourceCorners corners_;
  Shading& shading_;
  std::vector<int> input_corners_;
};

bool differ(const Faces& faces, int corner, int other, const Shading& shading) {
  const double cosine = shading.corner_normals[corner].dot(shading.corner_normals[other]);
  const bool same_winding = shading.is_reversed[faces.corner_faces[corner]] ==
                            shading.is_reversed[faces.corner_faces[other]];
  return (same_winding ? cosine : std::abs(cosine)) < crease_normals_cosine;
}

}  // namespace

bool are_flat(const Faces& faces, Span<const int> edge, const Shading& shading) {
  return shading.is_flat[faces.corner_faces[edge[0]]] &&
         shading.is_flat[faces.corner_faces[edge[1]]];
}

EndsDiffer ends_differ(const Faces& faces, Span<const int> edge, const Shading& shading) {
  if (edge.size() != 2 || are_flat(faces, edge, shading)) return {};
  const int a = edge[0], b = edge[1];
  if (shading.corner_normals[a].isZero() || shading.corner_normals[b].isZero()) return {};
  return {differ(faces, a, faces.next(b), shading), differ(faces, faces.next(a), b, shading)};
}

Shading read_shading(const PolygonMesh& mesh, const Faces& faces, const Ragged<int>& edges,
                     const std::vector<int>& numbers, const SoundMesh& sound) {
  Shading shading;
  SliverNormals normals(faces, sound.positions, edges);
  shading.face_normals = normals.take();
  ShadingReader reader(mesh, faces, numbers, sound, shading);
  reader.run();
  if (!mesh.corner_normals.empty() && !normals.all().empty())
    reader.mend_slivers(normals.all(), half_edge_mates(faces, edges));
  return shading;
}

}  // namespace illustrate
