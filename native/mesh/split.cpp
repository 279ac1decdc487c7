#include "mesh/split.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

#include "mesh/clean.h"

namespace illustrate {
namespace {

// So many faces on one edge are no surface; they are left apart rather than compared pair by pair.
constexpr std::size_t max_faces_to_match = 64;

// Directions closer than this count as equally straight, so that rounding does not choose.
constexpr double straightness_steps = 1e6;

// One face at an edge that has many.
struct Leaf {
  int half_edge;
  Vec3 inward;  // unit, from the edge into the face
  Vec3 normal;  // unit, by the face's own winding
};

struct Match {
  int winding_differs, straightness, is_concave;
  std::size_t a, b;

  bool operator<(const Match& other) const {
    return std::tie(winding_differs, straightness, is_concave, a, b) <
           std::tie(other.winding_differs, other.straightness, other.is_concave, other.a, other.b);
  }
};

Leaf make_leaf(const Faces& faces, const Points& positions, const Points& normals, int half_edge) {
  const Vec3 along =
      (positions[faces.head(half_edge)] - positions[faces.corners[half_edge]]).stableNormalized();
  const Vec3& normal = normals[faces.corner_faces[half_edge]];
  return {half_edge, normal.cross(along), normal};
}

std::vector<Match> rank_matches(const Faces& faces, const std::vector<Leaf>& leaves) {
  std::vector<Match> matches;
  for (std::size_t a = 0; a < leaves.size(); ++a)
    for (std::size_t b = a + 1; b < leaves.size(); ++b) {
      const int start_a = faces.corners[leaves[a].half_edge];
      const int start_b = faces.corners[leaves[b].half_edge];
      const double cosine = leaves[a].inward.dot(leaves[b].inward);  // -1: straight on
      matches.push_back({start_a == start_b,
                         static_cast<int>(std::lround(cosine * straightness_steps)),
                         leaves[a].normal.dot(leaves[b].inward) > 0, a, b});
    }
  std::sort(matches.begin(), matches.end());
  return matches;
}

void join(int a, int b, FaceAdjacency& adjacency) {
  adjacency.partners[a] = b;
  adjacency.partners[b] = a;
}

void match_leaves(const Faces& faces, const std::vector<Leaf>& leaves, FaceAdjacency& adjacency) {
  for (const Match& match : rank_matches(faces, leaves)) {
    const int a = leaves[match.a].half_edge, b = leaves[match.b].half_edge;
    if (adjacency.partners[a] == none && adjacency.partners[b] == none) join(a, b, adjacency);
  }
}

// Corners at each vertex.
std::vector<int> valences(const Faces& faces, std::size_t vertex_count) {
  std::vector<int> counts(vertex_count, 0);
  for (const int vertex : faces.corners) ++counts[vertex];
  return counts;
}

// Walks round the fan of a corner, from its open end if it has one.
class FanWalk {
 public:
  FanWalk(const Faces& faces, const FaceAdjacency& adjacency)
      : faces_(faces), adjacency_(adjacency) {}

  // The corner at the end of the fan in clockwise direction; of a closed fan, the corner itself.
  int first(int corner) const {
    int current = corner;
    while (adjacency_.partners[current] != none) {
      current = faces_.next(adjacency_.partners[current]);
      if (current == corner) break;
    }
    return current;
  }

  // The next corner in counter-clockwise direction; none at an open end.
  int after(int corner) const { return adjacency_.partners[faces_.previous(corner)]; }

 private:
  const Faces& faces_;
  const FaceAdjacency& adjacency_;
};

// A number for the fan of each corner, in the order of first corners; returns their count.
int number_fans(const Faces& faces, const FaceAdjacency& adjacency, std::vector<int>& fans) {
  const FanWalk walk(faces, adjacency);
  fans.assign(faces.corners.size(), none);
  int count = 0;
  for (int c = 0; c < faces.corner_count(); ++c) {
    if (fans[c] != none) continue;
    for (int current = walk.first(c); current != none && fans[current] == none;
         current = walk.after(current))
      fans[current] = count;
    ++count;
  }
  return count;
}

// Renumbers fans by the vertices they stem from; returns those vertices.
std::vector<int> sort_fans(const Faces& faces, std::vector<int>& fans, int fan_count,
                           std::size_t vertex_count) {
  std::vector<int> vertices(idx(fan_count));
  for (int c = 0; c < faces.corner_count(); ++c) vertices[fans[c]] = faces.corners[c];
  std::vector<int> ends(vertex_count + 1, 0), numbers(vertices.size());
  for (const int vertex : vertices) ++ends[vertex + 1];
  std::partial_sum(ends.begin(), ends.end(), ends.begin());
  for (std::size_t i = 0; i < vertices.size(); ++i) numbers[i] = ends[vertices[i]]++;
  for (int& fan : fans) fan = numbers[fan];
  std::sort(vertices.begin(), vertices.end());
  return vertices;
}

// Opens the edges that have more than two faces when named by their fans. Afterwards none has: at
// each fan at most one open half-edge starts and one ends.
bool open_crowded_edges(const Faces& faces, FaceAdjacency& adjacency, std::size_t fan_count) {
  const Ragged<int> edges = half_edges_by_edge(faces, fan_count);
  bool is_changed = false;
  for (std::size_t e = 0; e < edges.size(); ++e) {
    if (edges[e].size() <= 2) continue;
    is_changed = true;
    for (const int h : edges[e]) {
      adjacency.partners[h] = none;
      adjacency.is_cut[h] = 1;
    }
  }
  return is_changed;
}

}  // namespace

FaceAdjacency join_faces(const Faces& faces, const Points& positions, Counts& report) {
  FaceAdjacency adjacency{std::vector<int>(faces.corners.size(), none),
                          std::vector<std::uint8_t>(faces.corners.size(), 0)};
  const Ragged<int> edges = half_edges_by_edge(faces, positions.size());
  const std::vector<int> valence = valences(faces, positions.size());
  const auto is_crowded = [&](int h) {
    return std::max(valence[faces.corners[h]], valence[faces.head(h)]) > max_valence;
  };
  std::int64_t split_edges = 0;
  Points normals;
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const auto edge = edges[e];
    if (edge.size() == 1) continue;
    const bool stays_open = is_crowded(edge[0]);
    // Whatever their windings: those are made to agree along such edges afterwards.
    if (edge.size() == 2 && !stays_open) {
      join(edge[0], edge[1], adjacency);
      continue;
    }
    ++split_edges;
    for (const int h : edge) adjacency.is_cut[h] = 1;
    if (stays_open || edge.size() > max_faces_to_match) continue;
    if (normals.empty()) normals = unit_normals(faces, positions);
    std::vector<Leaf> leaves;
    for (const int h : edge) leaves.push_back(make_leaf(faces, positions, normals, h));
    match_leaves(faces, leaves, adjacency);
  }
  report["split_edges"] += split_edges;
  return adjacency;
}

std::vector<int> split_vertices(Faces& faces, FaceAdjacency& adjacency, std::size_t vertex_count) {
  const std::vector<int> vertex_corners = faces.corners;
  std::vector<int> fans, vertices;
  const auto number = [&] {
    faces.corners = vertex_corners;
    const int count = number_fans(faces, adjacency, fans);
    vertices = sort_fans(faces, fans, count, vertex_count);
    faces.corners = fans;
  };
  number();
  // What is opened takes fans apart: all are numbered again, from the vertices.
  if (open_crowded_edges(faces, adjacency, vertices.size())) number();
  return vertices;
}

}  // namespace illustrate
