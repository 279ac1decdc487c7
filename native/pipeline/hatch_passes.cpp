#include "pipeline/hatch_passes.h"

#include <algorithm>
#include <utility>

namespace illustrate {
namespace {

std::vector<std::uint8_t> seen_groups(const VisibleImage& visible, const MaterialMarks& marks) {
  std::vector<std::uint8_t> seen(marks.group_spacings.size(), 0);
  for (const int triangle : visible.triangle) {
    if (triangle != none) seen[idx(marks.groups[idx(triangle)])] = 1;
  }
  return seen;
}

HatchPass pass_of(int group, const HatchScene& whole, const MaterialMarks& marks,
                  std::vector<float> spacing_scale) {
  HatchPass pass{tones_of_group(whole.visible, marks, group, whole.tone), std::move(spacing_scale),
                 Mask(whole.unhatched.size(), 1),
                 std::vector<std::uint8_t>(marks.groups.size(), 0)};
  for (std::size_t t = 0; t < marks.groups.size(); ++t) {
    if (marks.groups[t] != group) continue;
    pass.own[t] = 1;
    const auto object = idx(whole.surface.triangle_objects[t]);
    pass.unhatched[object] = whole.unhatched[object];
  }
  return pass;
}

}  // namespace

std::vector<HatchPass> hatch_passes(
    const HatchScene& whole, const MaterialMarks& marks,
    const std::function<std::vector<float>(double)>& spacing_scale) {
  std::vector<HatchPass> passes;
  if (marks.groups.empty()) return passes;
  const std::vector<std::uint8_t> seen = seen_groups(whole.visible, marks);
  for (std::size_t group = 0; group < seen.size(); ++group) {
    if (seen[group]) {
      passes.push_back(pass_of(static_cast<int>(group), whole, marks,
                               spacing_scale(marks.group_spacings[group])));
    }
  }
  return passes;
}

HatchScene scene_of(const HatchPass& pass, const HatchScene& whole) {
  return {whole.surface, whole.field,  whole.families,     whole.camera,   whole.visible, pass.tone,
          whole.graph,   whole.curves, pass.spacing_scale, pass.unhatched, whole.last};
}

std::vector<double> finest_radii(const std::vector<HatchScene>& scenes,
                                 const HatchOptions& options) {
  std::vector<double> finest = wanted_radii(scenes.front(), options);
  for (std::size_t i = 1; i < scenes.size(); ++i) {
    const std::vector<double> radii = wanted_radii(scenes[i], options);
    std::transform(finest.begin(), finest.end(), radii.begin(), finest.begin(),
                   [](double a, double b) { return std::min(a, b); });
  }
  return finest;
}

Ragged<SurfacePoint> lines_of_pass(const Ragged<SurfacePoint>& lines, const HatchPass& pass) {
  Ragged<SurfacePoint> own;
  for (std::size_t c = 0; c < lines.size(); ++c) {
    const Span<const SurfacePoint> line = lines[c];
    const auto count = std::count_if(line.begin(), line.end(), [&](const SurfacePoint& on) {
      return pass.own[idx(on.triangle)] != 0;
    });
    if (2 * count > line.end() - line.begin()) own.add(line);
  }
  return own;
}

}  // namespace illustrate
