#include "pipeline/material_styles.h"

#include <algorithm>

namespace illustrate {
namespace {

// That of the material of a face; null: as the object.
const MaterialStyle* style_of(const PolygonMesh& mesh, const ObjectStyle& style, int face) {
  if (face == none || idx(face) >= mesh.face_materials.size()) return nullptr;
  const int material = mesh.face_materials[idx(face)];
  const bool is_listed = material >= 0 && idx(material) < style.materials.size();
  return is_listed ? &style.materials[idx(material)] : nullptr;
}

}  // namespace

MaterialMarks material_marks(const Surface& surface,
                             const std::vector<std::shared_ptr<const PolygonMesh>>& meshes,
                             const std::vector<ObjectStyle>& styles) {
  MaterialMarks marks;
  const bool none_has_any = std::all_of(styles.begin(), styles.end(),
                                        [](const ObjectStyle& s) { return s.materials.empty(); });
  if (none_has_any) return marks;
  const std::size_t count = surface.triangles.size();
  marks.line_widths.assign(count, 1);
  marks.hatch_widths.assign(count, 1);
  marks.unhatched.assign(count, 0);
  for (std::size_t t = 0; t < count; ++t) {
    const auto object = idx(surface.triangle_objects[t]);
    const MaterialStyle* style =
        style_of(*meshes[object], styles[object], surface.triangle_faces[t]);
    if (!style) continue;
    marks.line_widths[t] = style->lines ? style->width_scale : 0;
    marks.hatch_widths[t] = style->width_scale;
    marks.unhatched[t] = !style->hatching;
  }
  return marks;
}

void blank_unhatched(const VisibleImage& visible, const MaterialMarks& marks, ToneMap& tone) {
  if (marks.empty()) return;
  for (std::size_t cell = 0; cell < tone.level.size(); ++cell) {
    const int triangle = visible.triangle[cell];
    if (triangle == none || !marks.unhatched[idx(triangle)]) continue;
    tone.level[cell] = Tone::highlight;
    tone.band[cell] = Band::nothing;
    if (!tone.extra.empty()) tone.extra[cell] = 0;
  }
}

void weigh_by_material(const LabelledGraph& graph, const MaterialMarks& marks,
                       Ragged<double>& weights) {
  if (marks.empty()) return;
  if (weights.empty()) {
    weights.offsets = graph.points.offsets;
    weights.values.assign(graph.points.values.size(), 1);
  }
  for (std::size_t i = 0; i < weights.values.size(); ++i) {
    const int triangle = graph.points.values[i].on.triangle;
    if (triangle != none) weights.values[i] *= marks.line_widths[idx(triangle)];
  }
}

}  // namespace illustrate
