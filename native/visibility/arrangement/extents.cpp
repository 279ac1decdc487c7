#include "visibility/arrangement/extents.h"

#include <algorithm>
#include <limits>
#include <tuple>

namespace illustrate {
namespace {

constexpr double endless = std::numeric_limits<double>::infinity();

// A place on a path: a crossing with the path `other`, or a cusp, or where it goes under cover.
struct Mark {
  int other;   // `cusps` for a cusp
  double way;  // from the path's start, px
  int index;   // of the crossing, or of the path's step; none under cover
};
constexpr int cusps = -2;

class PathExtents {
 public:
  PathExtents(const Arrangement& arrangement, const std::vector<int>& path_of, Extents& result)
      : arrangement_(arrangement),
        path_of_(path_of),
        covered_nodes_(nodes_under_cover(arrangement.network())),
        result_(result) {}

  void measure(const Path& path, const std::vector<PathArc>& arcs, std::vector<double>& of_cusps) {
    mark(path, arcs);
    // One kind after another, each along the path; at one place by index, for the order of marks
    // decides which extent is nothing.
    std::sort(marks_.begin(), marks_.end(), [](const Mark& a, const Mark& b) {
      return std::tie(a.other, a.way, a.index) < std::tie(b.other, b.way, b.index);
    });
    for (auto first = marks_.begin(); first != marks_.end();) {
      const auto last =
          std::find_if(first, marks_.end(), [&](const Mark& m) { return m.other != first->other; });
      measure(first, last, path.cyclic, of_cusps);
      first = last;
    }
  }

 private:
  using Iterator = std::vector<Mark>::const_iterator;

  // Marks of one kind, along the path.
  void measure(Iterator first, Iterator last, bool cyclic, std::vector<double>& of_cusps) {
    for (auto next = first + 1; next != last; ++next) {
      shorten(*(next - 1), *next, next->way - (next - 1)->way, of_cusps);
    }
    if (!cyclic || last - first < 2) return;
    shorten(*(last - 1), *first, length_ - (last - 1)->way + first->way, of_cusps);
  }

  void mark(const Path& path, const std::vector<PathArc>& arcs) {
    marks_.clear();
    length_ = 0;
    const auto strand = [&](int s) -> const Strand& { return arrangement_.strand(s); };
    if (!path.cyclic) mark_cover(strand(path.strands.front()).start_node);
    for (const PathArc& arc : arcs) {
      const bool enters = arc.begin == none && (arc.step > 0 || path.cyclic);
      if (enters && path.jumps[idx(arc.step)] != 0) marks_.push_back({cusps, length_, arc.step});
      if (arc.begin != none) {
        const Visit& visit = arrangement_.visits(arc.strand)[idx(arc.begin)];
        const Crossing& x = arrangement_.crossing(visit.crossing);
        const int other = (visit.front ? x.back : x.front).strand;
        marks_.push_back({path_of_[idx(other)], length_, visit.crossing});
      }
      length_ += arc.length_px;
    }
    if (!path.cyclic) mark_cover(strand(path.strands.back()).end_node);
  }

  // An end of the path, which bounds like a cusp.
  void mark_cover(int node) {
    if (covered_nodes_[idx(node)]) marks_.push_back({cusps, length_, none});
  }

  void shorten(const Mark& a, const Mark& b, double way, std::vector<double>& of_cusps) {
    for (const Mark& m : {a, b}) {
      if (m.index == none) continue;
      double& extent = m.other == cusps ? of_cusps[idx(m.index)] : result_.crossings[idx(m.index)];
      extent = std::min(extent, way);
    }
  }

  const Arrangement& arrangement_;
  const std::vector<int>& path_of_;
  std::vector<std::uint8_t> covered_nodes_;
  Extents& result_;
  std::vector<Mark> marks_;
  double length_ = 0;
};

}  // namespace

Extents extents(const Arrangement& arrangement, const std::vector<std::vector<PathArc>>& arcs) {
  const std::vector<int> path_of = paths_of_strands(arrangement);
  Extents result;
  result.crossings.assign(arrangement.crossings().size(), endless);
  PathExtents paths(arrangement, path_of, result);
  for (std::size_t p = 0; p < arcs.size(); ++p) {
    const Path& path = arrangement.paths()[p];
    result.cusps.emplace_back(path.strands.size(), endless);
    paths.measure(path, arcs[p], result.cusps.back());
  }
  return result;
}

}  // namespace illustrate
