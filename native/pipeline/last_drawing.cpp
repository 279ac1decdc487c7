#include "pipeline/last_drawing.h"

namespace illustrate {

Ragged<SurfacePoint> placed_of(const Drawing& drawing) {
  if (!drawing.placed.empty()) return drawing.placed;
  Ragged<SurfacePoint> hatches;
  for (std::size_t s = 0; s < drawing.kinds.size(); ++s) {
    if (drawing.kinds[s] != Kind::hatch && drawing.kinds[s] != Kind::cross_hatch) continue;
    for (int i = drawing.offsets[s]; i < drawing.offsets[s + 1]; ++i) {
      hatches.push(drawing.on[idx(i)]);
    }
    hatches.close_list();
  }
  return hatches;
}

Ragged<SurfacePoint> moved_lines(const Ragged<SurfacePoint>& lines, const SameObjects& same) {
  Ragged<SurfacePoint> moved;
  for (std::size_t c = 0; c < lines.size(); ++c) {
    if (lines[c].empty() || !same.has(lines[c][0])) continue;
    for (const SurfacePoint& on : lines[c]) moved.push(same.point(on));
    moved.close_list();
  }
  return moved;
}

Ragged<Vec3> drawn_hatches(const Drawing& drawing, const SameObjects& same) {
  Ragged<Vec3> strokes;
  for (std::size_t s = 0; s < drawing.kinds.size(); ++s) {
    if (drawing.kinds[s] != Kind::hatch && drawing.kinds[s] != Kind::cross_hatch) continue;
    if (!same.has(drawing.on[idx(drawing.offsets[s])])) continue;
    for (int i = drawing.offsets[s]; i < drawing.offsets[s + 1]; ++i) {
      strokes.push(same.position(drawing.on[idx(i)]));
    }
    strokes.close_list();
  }
  return strokes;
}

}  // namespace illustrate
