// Styles of materials, as what they say of each triangle.
#pragma once

#include <vector>

#include "mesh/polygon_mesh.h"
#include "occlusion/visible_image.h"
#include "pipeline/options.h"
#include "surface/surface.h"
#include "tone/tone_regions.h"

namespace illustrate {

// (t) all of them, or empty where no style has materials.
struct MaterialMarks {
  std::vector<double> line_widths;  // factors; 0: lines there are not drawn
  std::vector<double> hatch_widths;
  std::vector<std::uint8_t> unhatched;
  // What is hatched by itself, at a spacing or with a pen of its own, as numbers from 0; empty
  // where all is hatched alike.
  std::vector<int> groups;
  std::vector<double> group_spacings;  // (groups) factors

  bool empty() const { return line_widths.empty(); }
};

// meshes: of the objects, in order, each with its style.
MaterialMarks material_marks(const Surface& surface,
                             const std::vector<std::shared_ptr<const PolygonMesh>>& meshes,
                             const std::vector<ObjectStyle>& styles);

// (t) the pen of each triangle: its material's, or its object's where that is 0; empty where no
// style has one.
std::vector<int> pens_of(const Surface& surface,
                         const std::vector<std::shared_ptr<const PolygonMesh>>& meshes,
                         const std::vector<ObjectStyle>& styles);

// Leaves the cells of these triangles (t) white. Empty: none.
void blank_unhatched(const VisibleImage& visible, const std::vector<std::uint8_t>& unhatched,
                     ToneMap& tone);

// The tones of one group; all else is white.
ToneMap tones_of_group(const VisibleImage& visible, const MaterialMarks& marks, int group,
                       ToneMap tone);

// Multiplies the weights of lines (line_weights.h), of which there are none where all are 1.
void weigh_by_material(const LabelledGraph& graph, const MaterialMarks& marks,
                       Ragged<double>& weights);

}  // namespace illustrate
