#include "control/split_once.h"

#include <algorithm>
#include <cmath>

#include "control/limit_masks.h"
#include "core/pi.h"
#include "mesh/edge_table.h"

namespace illustrate {
namespace {

class Splitter {
 public:
  Splitter(const SoundMesh& parent, const HalfEdges& edges, Scheme scheme)
      : parent_(parent),
        edges_(edges),
        faces_(edges.faces),
        quads_(scheme == Scheme::catmull_clark),
        vertices_(static_cast<int>(parent.positions.size())) {}

  SoundMesh run() {
    child_.scheme = quads_ ? Scheme::catmull_clark : Scheme::loop;
    child_.cage = parent_.cage;
    child_.boundary = parent_.boundary;
    child_.level = parent_.level;
    child_.edge_length = parent_.edge_length;
    child_.name = parent_.name;
    child_.positions.assign(idx(vertices_ + edges_.edge_count() + (quads_ ? faces_.size() : 0)),
                            Vec3::Zero());
    set_twin_vertices();
    set_sources();
    for (int f = 0; f < faces_.size(); ++f) add_children(f);
    set_twin_faces();
    split_edges();
    soften_vertices();
    return std::move(child_);
  }

 private:
  int on_edge(int half_edge) const { return vertices_ + edges_.edges[idx(half_edge)]; }
  int in_face(int face) const { return vertices_ + edges_.edge_count() + face; }
  int twin_face(int face) const {
    return parent_.twin_faces.empty() ? none : parent_.twin_faces[idx(face)];
  }
  // The corner of the face's twin at the twin of a vertex.
  int corner_on_twin(int face, int vertex) const {
    const int twin = twin_face(face), other = parent_.twin_vertices[idx(vertex)];
    int c = faces_.offsets[idx(twin)];
    while (c + 1 < faces_.offsets[idx(twin) + 1] && faces_.corners[idx(c)] != other) ++c;
    return c;
  }
  // The same half-edge on the other sheet, where it runs the other way.
  int twin_half_edge(int h) const {
    const int face = faces_.corner_faces[idx(h)];
    return twin_face(face) == none ? none : corner_on_twin(face, faces_.head(h));
  }

  void set_twin_vertices() {
    child_.twin_vertices = parent_.twin_vertices;
    child_.twin_vertices.resize(child_.positions.size(), none);
    for (int h = 0; h < faces_.corner_count(); ++h) {
      const int twin = twin_half_edge(h);
      if (twin != none) child_.twin_vertices[idx(on_edge(h))] = on_edge(twin);
    }
    for (int f = 0; quads_ && f < faces_.size(); ++f) {
      const int twin = twin_face(f);
      if (twin != none) child_.twin_vertices[idx(in_face(f))] = in_face(twin);
    }
  }

  // Edges between the same places have one number.
  void set_sources() {
    child_.source_vertices = parent_.source_vertices;
    int next = 1;
    for (const int source : parent_.source_vertices) next = std::max(next, source + 1);
    std::vector<std::array<int, 3>> ends;  // of each edge: both sources, its number
    for (int e = 0; e < edges_.edge_count(); ++e) {
      const int h = edges_.first[idx(e)];
      const auto [a, b] = std::minmax(parent_.source_vertices[idx(faces_.corners[idx(h)])],
                                      parent_.source_vertices[idx(faces_.head(h))]);
      ends.push_back({a, b, e});
    }
    std::sort(ends.begin(), ends.end());
    child_.source_vertices.resize(child_.positions.size(), none);
    for (std::size_t i = 0; i < ends.size(); ++i) {
      const bool same = i > 0 && ends[i][0] != none && ends[i][0] == ends[i - 1][0] &&
                        ends[i][1] == ends[i - 1][1];
      child_.source_vertices[idx(vertices_ + ends[i][2])] = same ? next - 1 : next++;
    }
    for (int f = 0; quads_ && f < faces_.size(); ++f) {
      const int twin = twin_face(f);
      const bool second = twin != none && twin < f;
      child_.source_vertices[idx(in_face(f))] =
          second ? child_.source_vertices[idx(in_face(twin))] : next++;
    }
  }

  template <class T>
  void repeat(const std::vector<T>& values, int face, std::vector<T>& result) const {
    if (!values.empty()) result.push_back(values[idx(face)]);
  }

  void add_face(int parent, std::initializer_list<int> corners) {
    child_.face_sizes.push_back(static_cast<int>(corners.size()));
    child_.corner_vertices.insert(child_.corner_vertices.end(), corners);
    repeat(parent_.source_faces, parent, child_.source_faces);
    repeat(parent_.face_materials, parent, child_.face_materials);
    repeat(parent_.face_planes, parent, child_.face_planes);
    repeat(parent_.holes, parent, child_.holes);
    repeat(parent_.kept, parent, child_.kept);
  }

  void add_children(int f) {
    first_children_.push_back(static_cast<int>(child_.face_sizes.size()));
    const int first = faces_.offsets[idx(f)], end = faces_.offsets[idx(f) + 1];
    for (int c = first; c < end; ++c) {
      const int vertex = faces_.corners[idx(c)], after = on_edge(c);
      const int before = on_edge(faces_.previous(c));
      if (quads_) {
        add_face(f, {vertex, after, in_face(f), before});
      } else {
        add_face(f, {vertex, after, before});
      }
    }
    if (!quads_) add_face(f, {on_edge(first), on_edge(first + 1), on_edge(first + 2)});
  }

  // Child k lies at corner k.
  void set_twin_faces() {
    if (parent_.twin_faces.empty()) return;
    for (int f = 0; f < faces_.size(); ++f) {
      const int twin = twin_face(f);
      for (const int v : faces_[f]) child_.twin_faces.push_back(twin_child(f, twin, v));
      if (!quads_)
        child_.twin_faces.push_back(twin == none ? none : first_children_[idx(twin)] + 3);
    }
  }

  int twin_child(int face, int twin, int vertex) const {
    if (twin == none) return none;
    return first_children_[idx(twin)] + corner_on_twin(face, vertex) - faces_.offsets[idx(twin)];
  }

  void split_edges() {
    for (int e = 0; e < edges_.edge_count(); ++e) {
      const int h = edges_.first[idx(e)], middle = vertices_ + e;
      const double sharpness = edges_.sharpness[idx(e)];
      const double left = sharpness >= infinitely_sharp ? sharpness : sharpness - 1;
      if (edges_.mates[idx(h)] == none || !(left > 0)) continue;
      for (const int end : {faces_.corners[idx(h)], faces_.head(h)}) {
        child_.edge_vertices.push_back({end, middle});
        child_.edge_sharpness.push_back(left);
      }
    }
    std::vector<Edge> ends;
    for (const int h : edges_.first) ends.push_back({faces_.corners[idx(h)], faces_.head(h)});
    const EdgeTable table(parent_.positions.size(), ends);
    const auto halve = [&](const std::vector<Edge>& whole, std::vector<Edge>& halves) {
      for (const auto& [a, b] : whole) {
        const int edge = table.find(a, b);
        if (edge == none) continue;
        halves.push_back({a, vertices_ + edge});
        halves.push_back({vertices_ + edge, b});
      }
    };
    halve(parent_.marked_edges, child_.marked_edges);
    halve(parent_.seams, child_.seams);
  }

  void soften_vertices() {
    for (const double sharpness : parent_.vertex_sharpness)
      child_.vertex_sharpness.push_back(
          sharpness >= infinitely_sharp ? sharpness : std::max(0., sharpness - 1));
    child_.vertex_sharpness.resize(child_.positions.size(), 0);
  }

  const SoundMesh& parent_;
  const HalfEdges& edges_;
  const Faces& faces_;
  const bool quads_;
  const int vertices_;
  SoundMesh child_;
  std::vector<int> first_children_;
};

// How the scheme treats a vertex, or the two extremes between which a semi-sharp one lies.
using Rule = LimitPlaces::Rule;

// What is round a vertex.
struct Surroundings {
  Vec3 edge_ends = Vec3::Zero();     // sum
  Vec3 face_centres = Vec3::Zero();  // sum
  double edges = 0, faces = 0;
  int sharp = 0, sharp_after = 0;  // edges here and one level on
  Vec3 sharp_ends = Vec3::Zero(), sharp_ends_after = Vec3::Zero();
  double fading = 0;  // sum of sharpness of what is sharp here only
  int fading_count = 0;

  void add_sharpness(double sharpness, const Vec3& end) {
    if (!(sharpness > 0)) return;
    ++sharp;
    sharp_ends += end;
    if (sharpness > 1) {
      ++sharp_after;
      sharp_ends_after += end;
    } else {
      fading += sharpness;
      ++fading_count;
    }
  }
};

class CagePoints {
 public:
  CagePoints(const SoundMesh& parent, const HalfEdges& edges, Scheme scheme)
      : p_(parent.positions),
        parent_(parent),
        edges_(edges),
        faces_(edges.faces),
        quads_(scheme == Scheme::catmull_clark) {}

  Points run() {
    for (int f = 0; f < faces_.size(); ++f) centres_.push_back(centre(f));
    survey();
    Points points;
    for (std::size_t v = 0; v < p_.size(); ++v) points.push_back(vertex_point(v));
    for (int e = 0; e < edges_.edge_count(); ++e) points.push_back(edge_point(e));
    if (quads_) points.insert(points.end(), centres_.begin(), centres_.end());
    return points;
  }

 private:
  Vec3 centre(int face) const {
    Vec3 sum = Vec3::Zero();
    for (const int v : faces_[face]) sum += p_[idx(v)];
    return sum / static_cast<double>(faces_[face].size());
  }

  void survey() {
    round_.resize(p_.size());
    for (int e = 0; e < edges_.edge_count(); ++e) {
      const int h = edges_.first[idx(e)], a = faces_.corners[idx(h)], b = faces_.head(h);
      for (const auto& [here, other] : {Edge{a, b}, Edge{b, a}}) {
        Surroundings& round = round_[idx(here)];
        round.edge_ends += p_[idx(other)];
        ++round.edges;
        round.add_sharpness(edges_.sharpness[idx(e)], p_[idx(other)]);
      }
    }
    for (int c = 0; c < faces_.corner_count(); ++c) {
      Surroundings& round = round_[idx(faces_.corners[idx(c)])];
      round.face_centres += centres_[idx(faces_.corner_faces[idx(c)])];
      ++round.faces;
    }
  }

  Vec3 edge_point(int e) const {
    const int h = edges_.first[idx(e)], mate = edges_.mates[idx(h)];
    const Vec3 &a = p_[idx(faces_.corners[idx(h)])], &b = p_[idx(faces_.head(h))];
    const Vec3 sharp = (a + b) / 2;
    const double sharpness = edges_.sharpness[idx(e)];
    if (sharpness >= 1 || mate == none) return sharp;
    Vec3 smooth;
    if (quads_) {
      const Vec3& left = centres_[idx(faces_.corner_faces[idx(h)])];
      const Vec3& right = centres_[idx(faces_.corner_faces[idx(mate)])];
      smooth = (a + b + left + right) / 4;
    } else {
      const Vec3& left = p_[idx(faces_.corners[idx(faces_.previous(h))])];
      const Vec3& right = p_[idx(faces_.corners[idx(faces_.previous(mate))])];
      smooth = (3 * (a + b) + left + right) / 8;
    }
    return sharpness > 0 ? Vec3((1 - sharpness) * smooth + sharpness * sharp) : smooth;
  }

  static Rule rule(int sharp, bool corner) {
    if (corner || sharp > 2) return Rule::corner;
    return sharp == 2 ? Rule::crease : Rule::smooth;
  }

  Vec3 point(Rule rule, std::size_t v, const Vec3& sharp_ends) const {
    if (rule == Rule::corner) return p_[v];
    if (rule == Rule::crease) return (6 * p_[v] + sharp_ends) / 8;
    const Surroundings& round = round_[v];
    const double n = round.edges;
    if (quads_) return (n - 2) / n * p_[v] + (round.edge_ends + round.face_centres) / (n * n);
    const double c = 3. / 8 + std::cos(2 * pi / n) / 4, beta = (5. / 8 - c * c) / n;
    return (1 - n * beta) * p_[v] + beta * round.edge_ends;
  }

  Vec3 vertex_point(std::size_t v) const {
    Surroundings round = round_[v];
    if (round.edges == 0) return p_[v];
    const double corner = parent_.vertex_sharpness.empty() ? 0 : parent_.vertex_sharpness[v];
    if (corner > 0 && corner <= 1) {
      round.fading += corner;
      ++round.fading_count;
    }
    const Rule here = rule(round.sharp, corner > 0), after = rule(round.sharp_after, corner > 1);
    const Vec3 sharp = point(here, v, round.sharp_ends);
    if (here == after || round.fading_count == 0) return sharp;
    const double weight = std::min(1., round.fading / round.fading_count);
    return weight * sharp + (1 - weight) * point(after, v, round.sharp_ends_after);
  }

  const Points& p_;
  const SoundMesh& parent_;
  const HalfEdges& edges_;
  const Faces& faces_;
  const bool quads_;
  Points centres_;
  std::vector<Surroundings> round_;
};

}  // namespace

SoundMesh split_once(const SoundMesh& parent, const HalfEdges& edges, Scheme scheme) {
  return Splitter(parent, edges, scheme).run();
}

Points cage_points(const SoundMesh& parent, const HalfEdges& edges, Scheme scheme) {
  return CagePoints(parent, edges, scheme).run();
}

}  // namespace illustrate
