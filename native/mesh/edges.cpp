#include "mesh/edges.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/pi.h"
#include "mesh/breaks.h"
#include "mesh/creases.h"
#include "mesh/held_places.h"

namespace illustrate {
namespace {

// A value on an edge between two vertices of the input, and whether the sound mesh has the edge.
struct Tag {
  Edge edge;  // lower vertex first
  double value;
  bool is_found = false;
};

bool edge_before(const Tag& a, const Tag& b) { return a.edge < b.edge; }

// Values by edge; of several on one edge the largest.
class Tags {
 public:
  explicit Tags(const std::vector<int>& numbers) : numbers_(numbers) {}

  void add(const Edge& edge, double value) {
    const auto [low, high] = std::minmax(numbers_[edge[0]], numbers_[edge[1]]);
    tags_.push_back({{low, high}, value});
  }

  void sort() { std::stable_sort(tags_.begin(), tags_.end(), edge_before); }

  // 0 where the edge has none.
  double take(int a, int b) {
    const Tag key{{std::min(a, b), std::max(a, b)}, 0};
    const auto [begin, end] = std::equal_range(tags_.begin(), tags_.end(), key, edge_before);
    double largest = 0;
    for (auto tag = begin; tag != end; ++tag) {
      largest = std::max(largest, tag->value);
      tag->is_found = true;
    }
    return largest;
  }

  std::int64_t count_unused() const {
    return std::count_if(tags_.begin(), tags_.end(), [](const Tag& tag) { return !tag.is_found; });
  }

 private:
  const std::vector<int>& numbers_;
  std::vector<Tag> tags_;
};

Tags sharpness_tags(const PolygonMesh& mesh, const std::vector<int>& numbers, Counts& report) {
  Tags tags(numbers);
  for (std::size_t e = 0; e < mesh.edge_vertices.size(); ++e) {
    const double sharpness = mesh.edge_sharpness[e];
    if (std::isnan(sharpness)) ++report["ignored_creases"];
    if (sharpness > 0) tags.add(mesh.edge_vertices[e], std::min(sharpness, infinitely_sharp));
  }
  tags.sort();
  return tags;
}

Tags mark_tags(const PolygonMesh& mesh, const std::vector<int>& numbers) {
  Tags tags(numbers);
  for (const Edge& edge : mesh.marked_edges) tags.add(edge, 1);
  tags.sort();
  return tags;
}

// Edges whose faces' normals turn more than an angle.
class CreaseAngle {
 public:
  // Twins have their partner's normal, turned: both sheets are told the same.
  CreaseAngle(const Faces& faces, const SoundMesh& sound, double angle_deg)
      : faces_(faces), angle_deg_(angle_deg) {
    if (angle_deg >= 180) return;
    normals_ = unit_normals(faces, sound.positions);
    for (std::size_t f = 0; f < normals_.size(); ++f)
      if (sound.kept[f] == 0) normals_[f] = -normals_[sound.twin_faces[f]];
  }

  bool is_exceeded(Span<const int> edge) const {
    if (normals_.empty() || edge.size() != 2) return false;
    return turns_more(normals_[faces_.corner_faces[edge[0]]],
                      normals_[faces_.corner_faces[edge[1]]], angle_deg_);
  }

 private:
  const Faces& faces_;
  Points normals_;
  double angle_deg_;
};

// Welded vertices share the largest sharpness.
void carry_vertex_sharpness(const PolygonMesh& mesh, const std::vector<int>& numbers,
                            SoundMesh& sound, Counts& report) {
  std::vector<double> largest(mesh.positions.size(), 0);
  for (std::size_t v = 0; v < mesh.vertex_sharpness.size(); ++v) {
    const double sharpness = mesh.vertex_sharpness[v];
    if (std::isnan(sharpness)) ++report["ignored_creases"];
    if (!(sharpness > 0)) continue;
    double& value = largest[numbers[v]];
    value = std::max(value, std::min(sharpness, infinitely_sharp));
  }
  for (const int source : sound.source_vertices) sound.vertex_sharpness.push_back(largest[source]);
}

// Raises the sharpness of edges by the crease angle alone.
std::vector<std::uint8_t> sharpen_by_angle(const PolygonMesh& mesh, const Faces& faces,
                                           const Ragged<int>& edges, std::vector<double>& sharpness,
                                           const SoundMesh& sound, Counts& report) {
  const CreaseAngle angle(faces, sound, mesh.crease_angle_deg);
  for (std::size_t e = 0; e < edges.size(); ++e) {
    if (sharpness[e] >= infinitely_sharp || !angle.is_exceeded(edges[e])) continue;
    sharpness[e] = infinitely_sharp;
    ++report["angle_creases"];
  }
  return {};
}

// On the side of their faces.
Points turned_to_faces(const Shading& shading, const Faces& faces) {
  Points normals = shading.corner_normals;
  for (int c = 0; c < faces.corner_count(); ++c)
    if (normals[c].dot(shading.face_normals[faces.corner_faces[c]]) < 0) normals[c] = -normals[c];
  return normals;
}

// Raises the sharpness of edges by how the mesh is shaded, and keeps its normals. Returns 1 for
// vertices that become sharp.
std::vector<std::uint8_t> sharpen_as_shaded(const PolygonMesh& mesh, const Faces& faces,
                                            const Ragged<int>& edges,
                                            const std::vector<std::uint8_t>& is_cut,
                                            const std::vector<int>& numbers,
                                            std::vector<double>& sharpness, SoundMesh& sound,
                                            Counts& report) {
  Shading shading = read_shading(mesh, faces, edges, numbers, sound);
  std::vector<std::uint8_t> is_sharp;
  for (const double value : sharpness) is_sharp.push_back(value >= infinitely_sharp);
  report["breaks"] += shade_breaks(mesh, faces, edges, is_sharp, sound, shading);
  Creases creases =
      find_creases(mesh, faces, edges, is_cut, std::move(is_sharp), shading, sound, report);
  for (std::size_t e = 0; e < edges.size(); ++e)
    if (creases.sharp_edges[e]) sharpness[e] = infinitely_sharp;
  sound.corner_normals = turned_to_faces(shading, faces);
  return std::move(creases.sharp_vertices);
}

}  // namespace

void carry_edges(const PolygonMesh& mesh, const Faces& faces,
                 const std::vector<std::uint8_t>& is_cut, const std::vector<int>& numbers,
                 SoundMesh& sound, Counts& report) {
  Tags creases = sharpness_tags(mesh, numbers, report), marks = mark_tags(mesh, numbers);
  const Ragged<int> edges = half_edges_by_edge(faces, sound.positions.size());
  std::vector<double> values;
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const int h = edges[e][0];
    values.push_back(creases.take(sound.source_vertices[faces.corners[h]],
                                  sound.source_vertices[faces.head(h)]));
  }
  HeldPlaces held;
  if (mesh.cage) held = find_held_places(faces, edges, is_cut, sound);
  for (std::size_t e = 0; e < held.edges.size(); ++e)
    if (held.edges[e]) values[e] = infinitely_sharp;
  const bool is_shaded = !mesh.cage || !mesh.corner_normals.empty();
  const std::vector<std::uint8_t> sharp_vertices =
      is_shaded ? sharpen_as_shaded(mesh, faces, edges, is_cut, numbers, values, sound, report)
                : sharpen_by_angle(mesh, faces, edges, values, sound, report);
  std::int64_t open_edges = 0;
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const int h = edges[e][0], a = faces.corners[h], b = faces.head(h);
    const int source_a = sound.source_vertices[a], source_b = sound.source_vertices[b];
    const double sharpness = values[e];
    if (sharpness > 0) {
      sound.edge_vertices.push_back({a, b});
      sound.edge_sharpness.push_back(sharpness);
    }
    if (marks.take(source_a, source_b) > 0) sound.marked_edges.push_back({a, b});
    if (edges[e].size() > 1) continue;
    if (is_cut[h])
      sound.seams.push_back({a, b});
    else
      open_edges += sound.kept[faces.corner_faces[h]];
  }
  report["open_edges"] += open_edges;
  report["ignored_creases"] += creases.count_unused();
  report["ignored_marks"] += marks.count_unused();
  carry_vertex_sharpness(mesh, numbers, sound, report);
  for (std::size_t v = 0; v < sharp_vertices.size(); ++v)
    if (sharp_vertices[v]) sound.vertex_sharpness[v] = infinitely_sharp;
  for (std::size_t v = 0; v < held.vertices.size(); ++v)
    if (held.vertices[v]) sound.vertex_sharpness[v] = infinitely_sharp;
}

}  // namespace illustrate
