#include "stroke/pen_parts.h"

#include <algorithm>

namespace illustrate {
namespace {

// A part as points [first, last] of a path.
struct Run {
  std::size_t first, last;
  int pen;
};

std::vector<int> pens_at(const StrokePath& path, const std::vector<int>& pens) {
  std::vector<int> found;
  for (const StrokePoint& p : path.points) {
    found.push_back(p.on.triangle == none ? 0 : pens[idx(p.on.triangle)]);
  }
  return found;
}

// With the first point where a pen changes, and again at the end.
StrokePath opened(const StrokePath& path, const std::vector<int>& pens) {
  if (!path.closed) return path;
  StrokePath open = path;
  open.closed = false;
  const std::vector<int> at = pens_at(path, pens);
  const auto change = std::adjacent_find(at.begin(), at.end(), std::not_equal_to<>()) - at.begin();
  std::rotate(open.points.begin(), open.points.begin() + change + 1, open.points.end());
  open.points.push_back(open.points.front());
  return open;
}

double length_of(const StrokePath& path, const Run& run) {
  double length = 0;
  for (std::size_t i = run.first; i < run.last; ++i) {
    length += (path.points[i + 1].image - path.points[i].image).norm();
  }
  return length;
}

std::vector<Run> runs_of(const StrokePath& path, const std::vector<int>& pens, double speck_px) {
  const std::vector<int> at = pens_at(path, pens);
  std::vector<Run> runs;
  for (std::size_t first = 0; first + 1 < at.size();) {
    std::size_t last = first;
    while (last + 1 < at.size() && at[last] == at[first]) ++last;
    const Run run{first, last, at[first]};
    const bool joins =
        !runs.empty() && (run.pen == runs.back().pen || length_of(path, run) <= speck_px);
    if (joins) {
      runs.back().last = last;
    } else {
      runs.push_back(run);
    }
    first = last;
  }
  return runs;
}

}  // namespace

std::vector<PenPart> parts_by_pen(const StrokePath& path, const std::vector<int>& pens,
                                  double speck_px) {
  if (pens.empty() || path.points.empty()) return {{path, 0}};
  const std::vector<int> at = pens_at(path, pens);
  if (std::all_of(at.begin(), at.end(), [&](int pen) { return pen == at[0]; })) {
    return {{path, at[0]}};
  }
  const StrokePath open = opened(path, pens);
  const std::vector<Run> runs = runs_of(open, pens, speck_px);
  std::vector<PenPart> parts;
  for (const Run& run : runs) {
    StrokePath part;
    part.points.assign(open.points.begin() + static_cast<std::ptrdiff_t>(run.first),
                       open.points.begin() + static_cast<std::ptrdiff_t>(run.last) + 1);
    part.free_start = open.free_start && run.first == 0;
    part.free_end = open.free_end && run.last + 1 == open.points.size();
    parts.push_back({std::move(part), run.pen});
  }
  return parts;
}

}  // namespace illustrate
