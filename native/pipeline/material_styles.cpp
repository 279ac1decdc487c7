#include "pipeline/material_styles.h"

#include <algorithm>
#include <map>

namespace illustrate {
namespace {

// That of the material of a face; null: as the object.
const MaterialStyle* style_of(const PolygonMesh& mesh, const ObjectStyle& style, int face) {
  if (face == none || idx(face) >= mesh.face_materials.size()) return nullptr;
  const int material = mesh.face_materials[idx(face)];
  const bool is_listed = material >= 0 && idx(material) < style.materials.size();
  return is_listed ? &style.materials[idx(material)] : nullptr;
}

// Calls visit(triangle, its material's style or null).
template <class Visit>
void each_triangle(const Surface& surface,
                   const std::vector<std::shared_ptr<const PolygonMesh>>& meshes,
                   const std::vector<ObjectStyle>& styles, const Visit& visit) {
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    const auto object = idx(surface.triangle_objects[t]);
    visit(t, style_of(*meshes[object], styles[object], surface.triangle_faces[t]));
  }
}

// Numbers for what is hatched alike. A single group at the objects' own spacing is none.
class Groups {
 public:
  int number(const MaterialStyle* style) {
    const std::pair<double, int> key =
        style ? std::pair(style->spacing_scale, style->pen) : std::pair(1.0, 0);
    return numbers_.try_emplace(key, static_cast<int>(numbers_.size())).first->second;
  }

  std::vector<double> spacings() const {
    std::vector<double> spacings(numbers_.size());
    for (const auto& [key, number] : numbers_) spacings[idx(number)] = key.first;
    return spacings;
  }

 private:
  std::map<std::pair<double, int>, int> numbers_;
};

void blank(std::size_t cell, ToneMap& tone) {
  tone.level[cell] = Tone::highlight;
  tone.band[cell] = Band::nothing;
  if (!tone.extra.empty()) tone.extra[cell] = 0;
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
  marks.groups.assign(count, 0);
  Groups groups;
  each_triangle(surface, meshes, styles, [&](std::size_t t, const MaterialStyle* style) {
    marks.groups[t] = groups.number(style);
    if (!style) return;
    marks.line_widths[t] = style->lines ? style->width_scale : 0;
    marks.hatch_widths[t] = style->width_scale;
    marks.unhatched[t] = !style->hatching;
  });
  marks.group_spacings = groups.spacings();
  if (marks.group_spacings == std::vector<double>{1}) marks.groups.clear();
  return marks;
}

std::vector<int> pens_of(const Surface& surface,
                         const std::vector<std::shared_ptr<const PolygonMesh>>& meshes,
                         const std::vector<ObjectStyle>& styles) {
  const auto has_pen = [](const auto& style) { return style.pen != 0; };
  const bool any = std::any_of(styles.begin(), styles.end(), [&](const ObjectStyle& s) {
    return has_pen(s) || std::any_of(s.materials.begin(), s.materials.end(), has_pen);
  });
  std::vector<int> pens;
  if (!any) return pens;
  pens.resize(surface.triangles.size());
  each_triangle(surface, meshes, styles, [&](std::size_t t, const MaterialStyle* style) {
    const int own = style ? style->pen : 0;
    pens[t] = own != 0 ? own : styles[idx(surface.triangle_objects[t])].pen;
  });
  return pens;
}

void blank_unhatched(const VisibleImage& visible, const std::vector<std::uint8_t>& unhatched,
                     ToneMap& tone) {
  if (unhatched.empty()) return;
  for (std::size_t cell = 0; cell < tone.level.size(); ++cell) {
    const int triangle = visible.triangle[cell];
    if (triangle != none && unhatched[idx(triangle)]) blank(cell, tone);
  }
}

ToneMap tones_of_group(const VisibleImage& visible, const MaterialMarks& marks, int group,
                       ToneMap tone) {
  for (std::size_t cell = 0; cell < tone.level.size(); ++cell) {
    const int triangle = visible.triangle[cell];
    if (triangle != none && marks.groups[idx(triangle)] != group) blank(cell, tone);
  }
  return tone;
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
