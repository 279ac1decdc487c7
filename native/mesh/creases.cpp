#include "mesh/creases.h"

#include <algorithm>
#include <cmath>

#include "core/angles.h"
#include "mesh/crease_tails.h"
#include "mesh/fine_bends.h"
#include "mesh/lone_bends.h"

namespace illustrate {
namespace {

// Where a crease fades out one edge differs, where two meet two do: three are a cone's. Not all of
// a cone's edges need to differ, since its sides may be cut into triangles that agree.
constexpr int fewest_edges_of_tip = 3;
constexpr double share_of_edges_of_tip = 0.6;
// A smooth cube's corner has 55.
constexpr double tip_deg = 60;
// The rim of an octagon turns by 45 and is taken for a circle, that of a hexagon by 60 and keeps
// its corners; so does a plane's, by 90. As a crease a hexagon is round: the faces on both sides
// say so.
constexpr double boundary_corner_deg = 50;
constexpr double crease_corner_deg = 80;
// What single precision leaves of a whole angle between faces 1/1000 as wide as their place is far
// from the origin is a tenth of this.
constexpr double tie_deg = 0.1;
// Of the edges that a drawing asks for, which are about three units of paper long.
constexpr double line_share = 0.5;

class CreaseFinder {
 public:
  CreaseFinder(const PolygonMesh& mesh, const Faces& faces, const Ragged<int>& edges,
               const std::vector<std::uint8_t>& is_cut, const Shading& shading,
               const SoundMesh& sound, Creases& creases, Counts& report)
      : mesh_(mesh),
        faces_(faces),
        edges_(edges),
        is_cut_(is_cut),
        shading_(shading),
        sound_(sound),
        creases_(creases),
        report_(report) {}

  void run() {
    // Each step leaves alone what the ones before have settled: the edges of a cone are no creases,
    // corners lie between sharp edges, and a point is pointed only where nothing is sharp.
    creases_.sharp_vertices.assign(sound_.positions.size(), 0);
    find_split_tips();
    sharpen_edges();
    if (!mesh_.cage && mesh_.crease_angle_deg <= steep_deg && !is_covered()) sharpen_bends();
    find_flat_vertices();
    gather_sharp_edges();
    if (!mesh_.cage) find_corners();
    find_pointed_tips();
    treat_twins_alike();
  }

 private:
  // The vertex where the edge's faces differ while they agree at its other end; none: no such end.
  int lone_end(Span<const int> edge) const {
    const EndsDiffer ends = ends_differ(faces_, edge, shading_);
    if (ends.start == ends.end) return none;
    return ends.start ? faces_.corners[edge[0]] : faces_.head(edge[0]);
  }

  void find_split_tips() {
    std::vector<int> all(sound_.positions.size(), 0), lone(sound_.positions.size(), 0);
    for (std::size_t e = 0; e < edges_.size(); ++e) {
      ++all[faces_.corners[edges_[e][0]]];
      ++all[faces_.head(edges_[e][0])];
      const int end = lone_end(edges_[e]);
      if (end != none) ++lone[end];
    }
    for (std::size_t v = 0; v < all.size(); ++v) {
      if (lone[v] >= fewest_edges_of_tip && lone[v] >= share_of_edges_of_tip * all[v]) add_tip(v);
    }
  }

  void add_tip(std::size_t vertex) {
    creases_.sharp_vertices[vertex] = 1;
    report_["tips"] += is_counted(static_cast<int>(vertex));
  }

  // Vertices of a double cover are counted on one sheet.
  bool is_counted(int vertex) const {
    return sound_.twin_vertices[vertex] == none || vertex < sound_.twin_vertices[vertex];
  }

  bool turns_too_much(Span<const int> edge) const {
    const Vec3& a = shading_.face_normals[faces_.corner_faces[edge[0]]];
    const Vec3& b = shading_.face_normals[faces_.corner_faces[edge[1]]];
    return turns_more(a, b, mesh_.crease_angle_deg);
  }

  void sharpen_edges() {
    for (std::size_t e = 0; e < edges_.size(); ++e) {
      const auto edge = edges_[e];
      if (edge.size() != 2 || creases_.sharp_edges[e]) continue;
      if (are_flat(faces_, edge, shading_)) {
        if (mesh_.crease_angle_deg >= 180 || !turns_too_much(edge)) continue;
        ++report_["angle_creases"];
      } else {
        const EndsDiffer ends = ends_differ(faces_, edge, shading_);
        if (!ends.start && !ends.end) continue;
        const int lone = lone_end(edge);
        if (lone != none && creases_.sharp_vertices[lone]) continue;
        ++report_["normal_creases"];
      }
      creases_.sharp_edges[e] = 1;
    }
  }

  bool is_covered() const {
    return std::find(sound_.kept.begin(), sound_.kept.end(), 0) != sound_.kept.end();
  }

  // Each kind is found with what is sharp by then.
  void sharpen_bends() {
    const Points& p = sound_.positions;
    EdgeTurns turns(faces_, p, edges_, creases_.sharp_edges, shading_);
    const auto sharpen = [&](const char* name, const std::vector<std::uint8_t>& found) {
      for (std::size_t e = 0; e < edges_.size(); ++e) {
        creases_.sharp_edges[e] |= found[e];
        report_[name] += found[e];
      }
      turns.sharpen(found);
    };
    sharpen("lone_bends", find_lone_bends(faces_, p, edges_, turns, shading_));
    sharpen("crease_tails", find_crease_tails(faces_, p, edges_, turns, shading_));
    if (!mesh_.edge_length) return;
    const double reach = *mesh_.edge_length * line_share;
    sharpen("fine_bends", find_fine_bends(faces_, p, edges_, turns, reach, steep_deg));
  }

  // The sharp and open edges at each vertex: how many, and the first two.
  struct SharpEdges {
    int count = 0;
    bool is_boundary = false, is_seam = false;
    std::array<int, 2> ends{none, none};

    void add(int end, bool open, bool cut) {
      if (count < 2) ends[idx(count)] = end;
      ++count;
      is_boundary |= open;
      is_seam |= cut;
    }
  };

  void find_flat_vertices() {
    is_all_flat_.assign(sound_.positions.size(), 1);
    for (int c = 0; c < faces_.corner_count(); ++c) {
      is_all_flat_[faces_.corners[c]] &= shading_.is_flat[faces_.corner_faces[c]];
    }
  }

  void gather_sharp_edges() {
    sharp_.resize(sound_.positions.size());
    for (std::size_t e = 0; e < edges_.size(); ++e) {
      const int h = edges_[e][0], a = faces_.corners[h], b = faces_.head(h);
      const bool open = edges_[e].size() == 1;
      if (!open && !creases_.sharp_edges[e]) continue;
      sharp_[a].add(b, open, open && is_cut_[h]);
      sharp_[b].add(a, open, open && is_cut_[h]);
    }
  }

  bool is_corner(std::size_t v) const {
    // Splitting opened that edge; the artist's surface goes on across it.
    if (sharp_[v].is_seam) return is_flat_corner_of_seam(v);
    return is_touch(v) || turns_at(v) || is_loose_end(v);
  }

  // Of a crease between flat faces: the surface turns at once there from two sides to one.
  bool is_loose_end(std::size_t v) const {
    return sharp_[v].count == 1 && !sharp_[v].is_boundary && is_all_flat_[v];
  }

  bool turns_at(std::size_t v) const {
    const SharpEdges& sharp = sharp_[v];
    if (sharp.count != 2) return false;
    const Points& p = sound_.positions;
    const double turn = angle_between(p[v] - p[sharp.ends[0]], p[sharp.ends[1]] - p[v]);
    return turn > radians(sharp.is_boundary ? boundary_corner_deg : crease_corner_deg);
  }

  // Where blocks stand on each other their edges have four faces: flat sides on both keep their
  // corners there, and all copies of one stay together.
  bool is_flat_corner_of_seam(std::size_t v) const {
    const std::vector<int>& sources = sound_.source_vertices;
    std::size_t first = v;
    while (first > 0 && sources[first - 1] == sources[v]) --first;
    for (std::size_t copy = first; copy < sources.size() && sources[copy] == sources[v]; ++copy) {
      if (sharp_[copy].is_seam && is_all_flat_[copy] && turns_at(copy)) return true;
    }
    return false;
  }

  // Copies of a vertex stand side by side.
  bool is_touch(std::size_t v) const {
    if (sound_.twin_vertices[v] != none) return false;
    const std::vector<int>& sources = sound_.source_vertices;
    return (v > 0 && sources[v - 1] == sources[v]) ||
           (v + 1 < sources.size() && sources[v + 1] == sources[v]);
  }

  void find_corners() {
    for (std::size_t v = 0; v < sharp_.size(); ++v) {
      if (creases_.sharp_vertices[v] || !is_corner(v)) continue;
      creases_.sharp_vertices[v] = 1;
      report_["corners"] += is_counted(static_cast<int>(v));
    }
  }

  // By the faces' normals, weighted by their corners' angles: a side counts the same however it is
  // cut into triangles.
  void find_pointed_tips() {
    Points means(sound_.positions.size(), Vec3::Zero());
    for (int c = 0; c < faces_.corner_count(); ++c) {
      const double angle = corner_angle(faces_, sound_.positions, c);
      means[faces_.corners[c]] += angle * shading_.face_normals[faces_.corner_faces[c]];
    }
    std::vector<double> least(means.size(), pi);
    for (int c = 0; c < faces_.corner_count(); ++c) {
      const int v = faces_.corners[c], f = faces_.corner_faces[c];
      least[v] = std::min(least[v], angle_between(shading_.face_normals[f], means[v]));
    }
    for (std::size_t v = 0; v < means.size(); ++v) {
      if (sharp_[v].count > 0 || creases_.sharp_vertices[v]) continue;
      const double limit = is_all_flat_[v] ? std::min(tip_deg, mesh_.crease_angle_deg) : tip_deg;
      if (least[v] > radians(limit)) add_tip(v);
    }
  }

  // Rounding decides the same for both sheets of a double cover.
  void treat_twins_alike() {
    for (std::size_t v = 0; v < creases_.sharp_vertices.size(); ++v) {
      const int twin = sound_.twin_vertices[v];
      if (twin > static_cast<int>(v)) creases_.sharp_vertices[twin] = creases_.sharp_vertices[v];
    }
  }

  const PolygonMesh& mesh_;
  const Faces& faces_;
  const Ragged<int>& edges_;
  const std::vector<std::uint8_t>& is_cut_;
  const Shading& shading_;
  const SoundMesh& sound_;
  Creases& creases_;
  Counts& report_;
  std::vector<SharpEdges> sharp_;          // (n)
  std::vector<std::uint8_t> is_all_flat_;  // (n) 1: all faces around are shaded flat
};

}  // namespace

bool turns_more(const Vec3& a, const Vec3& b, double angle_deg) {
  return angle_deg < 180 && angle_between(a, b) > radians(std::max(0.0, angle_deg - tie_deg));
}

Creases find_creases(const PolygonMesh& mesh, const Faces& faces, const Ragged<int>& edges,
                     const std::vector<std::uint8_t>& is_cut, std::vector<std::uint8_t> is_sharp,
                     const Shading& shading, const SoundMesh& sound, Counts& report) {
  Creases creases{std::move(is_sharp), {}};
  CreaseFinder(mesh, faces, edges, is_cut, shading, sound, creases, report).run();
  return creases;
}

}  // namespace illustrate
