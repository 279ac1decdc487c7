#include "surface/subdivision/sectors.h"

namespace illustrate {
namespace {

std::vector<int> count_sharp_edges(const RefinedMesh& mesh) {
  std::vector<int> counts(mesh.points.size(), 0);
  for (int c = 0; c < static_cast<int>(mesh.mates.size()); ++c) {
    if (!mesh.is_sharp(c) || (mesh.mate(c) != none && mesh.mate(c) < c)) continue;
    ++counts[idx(mesh.vertex(c))];
    ++counts[idx(mesh.vertex(mesh.next(c)))];
  }
  return counts;
}

// Walks over sectors; at the end of a single sharp edge it does not stop at that edge.
class SectorWalker {
 public:
  SectorWalker(const RefinedMesh& mesh, Sectors& sectors) : mesh_(mesh), sectors_(sectors) {}

  void add(int corner) {
    const int sharp = sectors_.sharp_edges[idx(mesh_.vertex(corner))];
    passes_all_ = sharp == 0;
    passes_creases_ = sharp <= 1;
    const int first = first_clockwise(corner);
    const int sector = static_cast<int>(sectors_.count());
    int size = 0, c = first;
    do {
      sectors_.corner_sectors[idx(c)] = sector;
      ++size;
      const int border = mesh_.previous(c);
      c = ends_at(border) ? none : mesh_.mate(border);
    } while (c != none && c != first);
    sectors_.first_corners.push_back(first);
    sectors_.sizes.push_back(size);
    sectors_.closed.push_back(c == first);
  }

 private:
  // Whether a sector of the vertex at hand ends at this half-edge.
  bool ends_at(int half_edge) const {
    if (passes_all_) return false;
    if (mesh_.mate(half_edge) == none) return true;
    return !passes_creases_ && mesh_.kind(half_edge) == EdgeKind::crease;
  }

  int first_clockwise(int corner) const {
    int c = corner;
    while (!passes_all_ && !ends_at(c)) {
      c = mesh_.next(mesh_.mate(c));
      if (c == corner) break;
    }
    return c;
  }

  const RefinedMesh& mesh_;
  Sectors& sectors_;
  bool passes_all_ = false, passes_creases_ = false;  // at the vertex at hand
};

}  // namespace

Sectors smooth_sectors(const RefinedMesh& mesh, const std::vector<std::uint8_t>& wanted) {
  Sectors sectors;
  sectors.corner_sectors.assign(mesh.corner_count(), none);
  sectors.sharp_edges = count_sharp_edges(mesh);
  const auto most = wanted.empty() ? mesh.points.size() : idx(0);
  sectors.first_corners.reserve(most);
  sectors.sizes.reserve(most);
  sectors.closed.reserve(most);
  SectorWalker walker(mesh, sectors);
  for (int c = 0; c < static_cast<int>(mesh.corner_count()); ++c) {
    if (sectors.corner_sectors[idx(c)] != none) continue;
    if (wanted.empty() || wanted[idx(mesh.vertex(c))]) walker.add(c);
  }
  return sectors;
}

}  // namespace illustrate
