#include "mesh/held_places.h"

#include <map>
#include <set>

namespace illustrate {
namespace {

// What meets at a vertex of the input.
struct Meeting {
  int corners = 0, open_edges = 0;
  std::set<int> ends, cut_ends;  // of its edges; of those of more than two faces

  // Where such edges run on through the vertex there is one face more than edges for each wall.
  bool is_held() const {
    return cut_ends.size() != 2 || open_edges > 0 || corners <= static_cast<int>(ends.size());
  }
};

class HeldPlaceFinder {
 public:
  HeldPlaceFinder(const Faces& faces, const Ragged<int>& edges,
                  const std::vector<std::uint8_t>& is_cut, const SoundMesh& sound)
      : faces_(faces), edges_(edges), is_cut_(is_cut), sound_(sound) {}

  HeldPlaces run() {
    HeldPlaces held;
    for (std::size_t e = 0; e < edges_.size(); ++e) held.edges.push_back(is_held(e));
    find_split_vertices();
    for (std::size_t e = 0; e < edges_.size(); ++e) add_edge(e);
    for (const int v : faces_.corners)
      if (is_split_[v]) ++meetings_[source(v)].corners;
    for (std::size_t v = 0; v < is_split_.size(); ++v)
      held.vertices.push_back(is_split_[v] && meetings_[source(static_cast<int>(v))].is_held());
    return held;
  }

 private:
  int source(int v) const { return sound_.source_vertices[v]; }
  // The two sheets of a double cover are copies too, which do not touch.
  bool is_covered(int v) const { return sound_.twin_vertices[v] != none; }
  bool is_held(std::size_t e) const {
    const int h = edges_[e][0];
    return is_cut_[h] && !is_covered(faces_.corners[h]);
  }

  void find_split_vertices() {
    is_split_.assign(sound_.positions.size(), 0);
    for (int v = 1; v < static_cast<int>(is_split_.size()); ++v)
      if (source(v) == source(v - 1) && !is_covered(v)) is_split_[v] = is_split_[v - 1] = 1;
    for (std::size_t e = 0; e < edges_.size(); ++e) {
      const int h = edges_[e][0];
      if (is_held(e)) is_split_[faces_.corners[h]] = is_split_[faces_.head(h)] = 1;
    }
  }

  void add_edge(std::size_t e) {
    const int h = edges_[e][0], a = faces_.corners[h], b = faces_.head(h);
    for (const auto& [here, other] : {Edge{a, b}, Edge{b, a}}) {
      if (!is_split_[here]) continue;
      Meeting& meeting = meetings_[source(here)];
      meeting.ends.insert(source(other));
      if (is_cut_[h])
        meeting.cut_ends.insert(source(other));
      else
        meeting.open_edges += edges_[e].size() == 1;
    }
  }

  const Faces& faces_;
  const Ragged<int>& edges_;
  const std::vector<std::uint8_t>& is_cut_;
  const SoundMesh& sound_;
  std::vector<std::uint8_t> is_split_;  // (n)
  std::map<int, Meeting> meetings_;     // by vertices of the input
};

}  // namespace

HeldPlaces find_held_places(const Faces& faces, const Ragged<int>& edges,
                            const std::vector<std::uint8_t>& is_cut, const SoundMesh& sound) {
  return HeldPlaceFinder(faces, edges, is_cut, sound).run();
}

}  // namespace illustrate
