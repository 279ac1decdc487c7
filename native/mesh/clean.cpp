#include "mesh/clean.h"

#include <algorithm>
#include <numeric>

namespace illustrate {
namespace {

bool is_usable(const Vec3& position) { return (position.array().abs() <= max_coordinate).all(); }

// Adds a face without corners that repeat the one before; says whether any vertex comes twice even
// so.
class FaceCleaner {
 public:
  FaceCleaner(std::size_t vertex_count, Counts& report)
      : last_seen_(vertex_count, none), report_(report) {}

  void add(Span<const int> corners, int source, Faces& faces) {
    const std::size_t first = faces.corners.size();
    for (const int vertex : corners)
      if (faces.corners.size() == first || faces.corners.back() != vertex)
        faces.push_corner(vertex);
    while (faces.corners.size() > first + 1 && faces.corners.back() == faces.corners[first])
      faces.corners.pop_back();
    const std::size_t size = faces.corners.size() - first;
    if (size < 3 || has_repeated_vertex(faces, first)) {
      ++report_["degenerate_faces"];
      faces.drop_face();
    } else if (size > max_valence) {
      ++report_["huge_faces"];
      faces.drop_face();
    } else {
      if (size < corners.size())
        report_["repeated_corners"] += static_cast<std::int64_t>(corners.size() - size);
      faces.close_face(source);
    }
  }

 private:
  bool has_repeated_vertex(const Faces& faces, std::size_t first) {
    ++stamp_;
    for (std::size_t c = first; c < faces.corners.size(); ++c) {
      int& seen = last_seen_[faces.corners[c]];
      if (seen == stamp_) return true;
      seen = stamp_;
    }
    return false;
  }

  std::vector<int> last_seen_;
  int stamp_ = 0;
  Counts& report_;
};

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
    std::stable_sort(begin, end, [&](int a, int b) { return canonical.compare(a, b) < 0; });
    for (auto face = begin; face != end; ++face)
      if (face != begin && canonical.compare(face[-1], *face) == 0) is_duplicate[*face] = 1;
  }
  return is_duplicate;
}

Faces without_duplicates(const Faces& faces, std::size_t vertex_count, Counts& report) {
  const std::vector<std::uint8_t> is_duplicate = find_duplicates(faces, vertex_count);
  const auto count = std::count(is_duplicate.begin(), is_duplicate.end(), 1);
  if (count == 0) return faces;
  report["duplicate_faces"] += count;
  Faces unique;
  for (int f = 0; f < faces.size(); ++f) {
    if (is_duplicate[f]) continue;
    for (const int vertex : faces[f]) unique.push_corner(vertex);
    unique.close_face(faces.sources[f]);
  }
  return unique;
}

void count_isolated(const Faces& faces, const std::vector<std::uint8_t>& usable, Counts& report) {
  std::vector<std::uint8_t> is_isolated = usable;
  for (const int vertex : faces.corners) is_isolated[vertex] = 0;
  report["isolated_vertices"] += std::count(is_isolated.begin(), is_isolated.end(), 1);
}

struct PlacedVertex {
  Vec3 position;
  int vertex;

  bool operator<(const PlacedVertex& other) const {
    for (int k = 0; k < 3; ++k)
      if (position[k] != other.position[k]) return position[k] < other.position[k];
    return vertex < other.vertex;
  }
};

// The vertices of open edges, those at the same position side by side, lowest first.
std::vector<PlacedVertex> open_vertices_by_position(const Faces& faces, const Points& positions) {
  const Ragged<int> edges = half_edges_by_edge(faces, positions.size());
  std::vector<std::uint8_t> is_open(positions.size(), 0);
  for (std::size_t e = 0; e < edges.size(); ++e)
    if (edges[e].size() == 1)
      is_open[faces.corners[edges[e][0]]] = is_open[faces.head(edges[e][0])] = 1;
  std::vector<PlacedVertex> vertices;
  for (std::size_t v = 0; v < positions.size(); ++v)
    if (is_open[v]) vertices.push_back({positions[v], static_cast<int>(v)});
  std::sort(vertices.begin(), vertices.end());
  return vertices;
}

}  // namespace

Faces clean_faces(const PolygonMesh& mesh, Counts& report) {
  std::vector<std::uint8_t> usable;
  for (const Vec3& position : mesh.positions) usable.push_back(is_usable(position));
  report["nan_vertices"] += std::count(usable.begin(), usable.end(), 0);

  Faces faces;
  FaceCleaner cleaner(mesh.positions.size(), report);
  const int* corner = mesh.corner_vertices.data();
  for (std::size_t f = 0; f < mesh.face_sizes.size(); ++f) {
    const Span<const int> face{corner, static_cast<std::size_t>(mesh.face_sizes[f])};
    corner += face.size();
    if (std::all_of(face.begin(), face.end(), [&](int v) { return usable[v] != 0; }))
      cleaner.add(face, static_cast<int>(f), faces);
    else
      ++report["nan_faces"];
  }
  faces = without_duplicates(faces, mesh.positions.size(), report);
  count_isolated(faces, usable, report);
  return faces;
}

std::vector<int> weld_open_edges(Faces& faces, const Points& positions, Counts& report) {
  std::vector<int> numbers(positions.size());
  std::iota(numbers.begin(), numbers.end(), 0);
  const std::vector<PlacedVertex> open = open_vertices_by_position(faces, positions);
  std::int64_t welded = 0;
  for (std::size_t i = 1; i < open.size(); ++i) {
    if (open[i].position != open[i - 1].position) continue;
    numbers[open[i].vertex] = numbers[open[i - 1].vertex];
    ++welded;
  }
  if (welded == 0) return numbers;
  report["welded_vertices"] += welded;

  for (int& vertex : faces.corners) vertex = numbers[vertex];
  Faces cleaned;
  FaceCleaner cleaner(positions.size(), report);
  for (int f = 0; f < faces.size(); ++f) cleaner.add(faces[f], faces.sources[f], cleaned);
  faces = without_duplicates(cleaned, positions.size(), report);
  return numbers;
}

}  // namespace illustrate
