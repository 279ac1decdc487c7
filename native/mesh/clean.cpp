#include "mesh/clean.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <tuple>

#include "core/tolerances.h"
#include "mesh/mesh_size.h"
#include "mesh/split_polygon.h"

namespace illustrate {
namespace {

// So many looks at corners are spent on the faces of a mesh that come to a vertex twice: about a
// second, a thousand holes.
constexpr std::size_t max_looks = 20'000'000;

bool is_usable(const Vec3& position) { return (position.array().abs() <= max_coordinate).all(); }

// Adds faces without corners that repeat the one before, in parts where a vertex comes twice even
// so. What has fewer than three or too many corners is not added.
class FaceCleaner {
 public:
  FaceCleaner(const Points& positions, Counts& report)
      : positions_(positions), last_seen_(positions.size(), none), report_(report) {}

  void add(Span<const int> corners, int source, Faces& faces) {
    const int faces_before = faces.size();
    set_distinct(corners);
    if (!has_repeated_vertex()) {
      add_sound({distinct_.data(), distinct_.size()}, source, faces);
    } else {
      const Ragged<int> parts =
          split_polygon({distinct_.data(), distinct_.size()}, positions_, looks_);
      for (std::size_t i = 0; i < parts.size(); ++i) add_sound(parts[i], source, faces);
      report_["split_faces"] += faces.size() > faces_before;
    }
    if (faces.size() > faces_before && distinct_.size() < corners.size())
      report_["repeated_corners"] += static_cast<std::int64_t>(corners.size() - distinct_.size());
  }

 private:
  void set_distinct(Span<const int> corners) {
    distinct_.clear();
    for (const int vertex : corners)
      if (distinct_.empty() || distinct_.back() != vertex) distinct_.push_back(vertex);
    while (distinct_.size() > 1 && distinct_.back() == distinct_.front()) distinct_.pop_back();
  }

  bool has_repeated_vertex() {
    ++stamp_;
    for (const int vertex : distinct_) {
      int& seen = last_seen_[vertex];
      if (seen == stamp_) return true;
      seen = stamp_;
    }
    return false;
  }

  static void add_sound(Span<const int> corners, int source, Faces& faces) {
    if (corners.size() < 3 || corners.size() > max_valence) return;
    faces.corners.insert(faces.corners.end(), corners.begin(), corners.end());
    faces.close_face(source);
  }

  const Points& positions_;
  std::vector<int> distinct_;  // corners of the face at hand
  std::vector<int> last_seen_;
  int stamp_ = 0;
  std::size_t looks_ = max_looks;
  Counts& report_;
};

// Faces of the input that are there, also in parts.
std::int64_t count_sources(const Faces& faces) {
  std::int64_t count = 0;
  for (int f = 0; f < faces.size(); ++f)
    count += f == 0 || faces.sources[f] != faces.sources[f - 1];
  return count;
}

// Reads faces from their lowest vertex towards its lower neighbour, so that equal polygons read the
// same.
class CanonicalFaces {
 public:
  explicit CanonicalFaces(const Faces& faces) : faces_(faces) {
    for (int f = 0; f < faces.size(); ++f) {
      const auto face = faces[f];
      const int k = static_cast<int>(std::min_element(face.begin(), face.end()) - face.begin());
      const int h = faces.offsets[f] + k;
      starts_.push_back(h);
      runs_forward_.push_back(faces.head(h) < faces.corners[faces.previous(h)]);
    }
  }

  int lowest(int face) const { return faces_.corners[starts_[face]]; }

  // Negative, zero or positive as face a reads before, like or after b.
  int compare(int a, int b) const {
    const auto size = faces_[a].size();
    if (size != faces_[b].size()) return size < faces_[b].size() ? -1 : 1;
    int i = starts_[a], j = starts_[b];
    for (std::size_t k = 0; k < size; ++k, i = after(a, i), j = after(b, j))
      if (faces_.corners[i] != faces_.corners[j])
        return faces_.corners[i] < faces_.corners[j] ? -1 : 1;
    return 0;
  }

 private:
  int after(int face, int corner) const {
    return runs_forward_[face] ? faces_.next(corner) : faces_.previous(corner);
  }

  const Faces& faces_;
  std::vector<int> starts_;
  std::vector<std::uint8_t> runs_forward_;
};

// 1 for every face that an earlier one equals.
std::vector<std::uint8_t> find_duplicates(const Faces& faces, std::size_t vertex_count) {
  const CanonicalFaces canonical(faces);
  std::vector<int> ends(vertex_count + 1, 0), order(faces.sources.size());
  for (int f = 0; f < faces.size(); ++f) ++ends[canonical.lowest(f) + 1];
  std::partial_sum(ends.begin(), ends.end(), ends.begin());
  const std::vector<int> starts = ends;
  for (int f = 0; f < faces.size(); ++f) order[ends[canonical.lowest(f)]++] = f;

  std::vector<std::uint8_t> is_duplicate(faces.sources.size(), 0);
  for (std::size_t v = 0; v < vertex_count; ++v) {
    const auto begin = order.begin() + starts[v], end = order.begin() + starts[v + 1];
    // Stable: of equal faces the first of the input comes first, and stays.
    std::stable_sort(begin, end, [&](int a, int b) { return canonical.compare(a, b) < 0; });
    for (auto face = begin; face != end; ++face)
      if (face != begin && canonical.compare(face[-1], *face) == 0) is_duplicate[*face] = 1;
  }
  return is_duplicate;
}

Faces without_duplicates(const Faces& faces, std::size_t vertex_count, Counts& report) {
  const std::vector<std::uint8_t> is_duplicate = find_duplicates(faces, vertex_count);
  if (std::count(is_duplicate.begin(), is_duplicate.end(), 1) == 0) return faces;
  Faces unique;
  for (int f = 0; f < faces.size(); ++f) {
    if (is_duplicate[f]) continue;
    for (const int vertex : faces[f]) unique.push_corner(vertex);
    unique.close_face(faces.sources[f]);
  }
  report["duplicate_faces"] += count_sources(faces) - count_sources(unique);
  return unique;
}

void count_isolated(const Faces& faces, const std::vector<std::uint8_t>& usable, Counts& report) {
  std::vector<std::uint8_t> is_isolated = usable;
  for (const int vertex : faces.corners) is_isolated[vertex] = 0;
  report["isolated_vertices"] += std::count(is_isolated.begin(), is_isolated.end(), 1);
}

struct PlacedVertex {
  std::array<int, 3> place;  // ranks of the coordinates
  int vertex;

  bool operator<(const PlacedVertex& other) const {
    return std::tie(place, vertex) < std::tie(other.place, other.vertex);
  }
};

struct OpenEdges {
  std::vector<int> vertices;  // ascending
  double usual_length = 0;    // the median, which single outliers do not move
};

OpenEdges find_open_edges(const Faces& faces, const Points& positions) {
  const Ragged<int> edges = half_edges_by_edge(faces, positions.size());
  std::vector<std::uint8_t> is_open(positions.size(), 0);
  std::vector<double> lengths;
  for (std::size_t e = 0; e < edges.size(); ++e) {
    if (edges[e].size() != 1) continue;
    const int tail = faces.corners[edges[e][0]], head = faces.head(edges[e][0]);
    is_open[tail] = is_open[head] = 1;
    lengths.push_back((positions[head] - positions[tail]).stableNorm());
  }
  OpenEdges open;
  for (std::size_t v = 0; v < positions.size(); ++v)
    if (is_open[v]) open.vertices.push_back(static_cast<int>(v));
  const auto middle = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2);
  std::nth_element(lengths.begin(), middle, lengths.end());
  if (middle != lengths.end()) open.usual_length = *middle;
  return open;
}

// Numbers the different coordinates along one axis, ascending: what is no farther than `rounding`
// from the next lower one has its number.
void rank_along(int axis, const Points& positions, double rounding,
                std::vector<PlacedVertex>& vertices) {
  const auto at = [&](const PlacedVertex& v) { return positions[v.vertex][axis]; };
  std::sort(vertices.begin(), vertices.end(),
            [&](const PlacedVertex& a, const PlacedVertex& b) { return at(a) < at(b); });
  // By gaps, not by a grid, whose lines could run between two that only rounding parts.
  for (std::size_t i = 1; i < vertices.size(); ++i) {
    const bool differs = at(vertices[i]) - at(vertices[i - 1]) > rounding;
    vertices[i].place[axis] = vertices[i - 1].place[axis] + (differs ? 1 : 0);
  }
}

// The vertices of open edges, those at the same position side by side, lowest first.
std::vector<PlacedVertex> open_vertices_by_position(const Faces& faces, const Points& positions) {
  const OpenEdges open = find_open_edges(faces, positions);
  std::vector<PlacedVertex> vertices;
  for (const int v : open.vertices) vertices.push_back({{0, 0, 0}, v});
  const double rounding = tolerance::same_place * open.usual_length;
  for (int axis = 0; axis < 3; ++axis) rank_along(axis, positions, rounding, vertices);
  std::sort(vertices.begin(), vertices.end());
  return vertices;
}

}  // namespace

Faces clean_faces(const PolygonMesh& mesh, Counts& report) {
  std::vector<std::uint8_t> usable;
  for (const Vec3& position : mesh.positions) usable.push_back(is_usable(position));
  report["nan_vertices"] += std::count(usable.begin(), usable.end(), 0);

  Faces faces;
  FaceCleaner cleaner(mesh.positions, report);
  const int* corner = mesh.corner_vertices.data();
  for (std::size_t f = 0; f < mesh.face_sizes.size(); ++f) {
    const Span<const int> face{corner, idx(mesh.face_sizes[f])};
    corner += face.size();
    if (!std::all_of(face.begin(), face.end(), [&](int v) { return usable[v] != 0; })) {
      ++report["nan_faces"];
      continue;
    }
    const int before = faces.size();
    cleaner.add(face, static_cast<int>(f), faces);
    if (faces.size() == before)
      ++report[face.size() > max_valence ? "huge_faces" : "degenerate_faces"];
  }
  faces = without_duplicates(faces, mesh.positions.size(), report);
  count_isolated(faces, usable, report);
  return faces;
}

void weld(DisjointSets& sets, const Points& positions, Faces& faces, std::vector<int>& numbers,
          Counts& report) {
  std::int64_t welded = 0;
  for (std::size_t v = 0; v < positions.size(); ++v)
    welded += sets.root(static_cast<int>(v)) != static_cast<int>(v);
  if (welded == 0) return;
  report["welded_vertices"] += welded;
  for (int& number : numbers) number = sets.root(number);

  // Two corners of a face may now be one vertex, and two faces the same face.
  for (int& vertex : faces.corners) vertex = sets.root(vertex);
  Faces cleaned;
  FaceCleaner cleaner(positions, report);
  for (int f = 0; f < faces.size(); ++f) cleaner.add(faces[f], faces.sources[f], cleaned);
  report["degenerate_faces"] += count_sources(faces) - count_sources(cleaned);
  faces = without_duplicates(cleaned, positions.size(), report);
}

std::vector<int> weld_open_edges(Faces& faces, const Points& positions, Counts& report) {
  const std::vector<PlacedVertex> open = open_vertices_by_position(faces, positions);
  DisjointSets sets(positions.size());
  for (std::size_t i = 1; i < open.size(); ++i) {
    if (open[i].place == open[i - 1].place) sets.join(open[i - 1].vertex, open[i].vertex);
  }
  std::vector<int> numbers(positions.size());
  std::iota(numbers.begin(), numbers.end(), 0);
  weld(sets, positions, faces, numbers, report);
  return numbers;
}

void collapse_edges(const Points& positions, Faces& faces, std::vector<int>& numbers,
                    Counts& report) {
  const double rounding = tolerance::same_place * diagonal(faces, positions);
  DisjointSets sets(positions.size());
  for (int h = 0; h < faces.corner_count(); ++h) {
    const int tail = faces.corners[idx(h)], head = faces.head(h);
    const Vec3 along = positions[idx(head)] - positions[idx(tail)];
    if ((along.array().abs() <= rounding).all()) sets.join(tail, head);
  }
  weld(sets, positions, faces, numbers, report);
}

}  // namespace illustrate
