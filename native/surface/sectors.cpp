#include "surface/sectors.h"

namespace illustrate {
namespace {

std::vector<int> count_sharp_edges(const RefinedMesh& mesh) {
  std::vector<int> counts(mesh.points.size(), 0);
  for (int c = 0; c < static_cast<int>(mesh.mates.size()); ++c) {
    if (!mesh.is_sharp(c) || (mesh.mate(c) != none && mesh.mate(c) < c)) continue;
    ++counts[static_cast<std::size_t>(mesh.vertex(c))];
    ++counts[static_cast<std::size_t>(mesh.vertex(mesh.next(c)))];
  }
  return counts;
}

// Walks over sectors; at the end of a single sharp edge it does not stop at that edge.
class SectorWalker {
 public:
  SectorWalker(const RefinedMesh& mesh, Sectors& sectors) : mesh_(mesh), sectors_(sectors) {}

  void add(int corner) {
    const int first = first_clockwise(corner);
    const int sector = static_cast<int>(sectors_.count());
    int size = 0, c = first;
    do {
      sectors_.corner_sectors[static_cast<std::size_t>(c)] = sector;
      ++size;
      c = ends_at(mesh_.previous(c)) ? none : next_round_vertex(mesh_, c);
    } while (c != none && c != first);
    sectors_.first_corners.push_back(first);
    sectors_.sizes.push_back(size);
    sectors_.closed.push_back(c == first);
  }

 private:
  // Whether a sector of the vertex at hand ends at this half-edge.
  bool ends_at(int half_edge) const {
    if (mesh_.mate(half_edge) == none) return true;
    return !dart_ && mesh_.kind(half_edge) == EdgeKind::crease;
  }

  int first_clockwise(int corner) {
    dart_ = sectors_.sharp_edges[static_cast<std::size_t>(mesh_.vertex(corner))] == 1;
    int c = corner;
    while (!ends_at(c)) {
      c = mesh_.next(mesh_.mate(c));
      if (c == corner) break;
    }
    return c;
  }

  const RefinedMesh& mesh_;
  Sectors& sectors_;
  bool dart_ = false;
};

}  // namespace

Sectors smooth_sectors(const RefinedMesh& mesh) {
  Sectors sectors;
  sectors.corner_sectors.assign(mesh.corner_vertices.size(), none);
  sectors.sharp_edges = count_sharp_edges(mesh);
  SectorWalker walker(mesh, sectors);
  for (int c = 0; c < static_cast<int>(mesh.corner_vertices.size()); ++c) {
    if (sectors.corner_sectors[static_cast<std::size_t>(c)] == none) walker.add(c);
  }
  return sectors;
}

}  // namespace illustrate
