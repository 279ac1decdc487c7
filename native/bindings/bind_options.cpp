// The options of all stages, flattened into attributes.
#include <pybind11/stl.h>

#include "bindings/arrays.h"
#include "bindings/bind.h"
#include "bindings/draw_options.h"
#include "bindings/names.h"
#include "bindings/options.h"

// One attribute that is a member of the bound options, or a member of a member.
#define OPTION(name, member, doc) \
  option(                         \
      bound, name, [](auto& options) -> auto& { return options.member; }, doc)

namespace illustrate::bindings {
namespace {

constexpr std::array<const char*, 2> start_names{"search", "principal"};

FieldStart start_named(const std::string& name) {
  for (std::size_t i = 0; i < start_names.size(); ++i) {
    if (name == start_names[i]) return static_cast<FieldStart>(i);
  }
  throw InvalidInput("field_start is '" + name + "', expected 'search' or 'principal'");
}

void bind_guide(py::module_& m) {
  using namespace py::literals;
  py::class_<Guide>(m, "Guide", "A stroke for the field to follow. Immutable.")
      .def(py::init([](const py::object& points, const py::object& weight) {
             return Guide{read_points(points, "guide.points"), read_number(weight, "guide.weight")};
           }),
           "points"_a, "weight"_a = Guide{}.weight)
      .def_property_readonly("points", [](const Guide& guide) { return array_of(guide.points); })
      .def_readonly("weight", &Guide::weight);
}

std::vector<Guide> read_guides(const py::object& value) {
  std::vector<Guide> guides;
  if (value.is_none()) return guides;
  if (!py::isinstance<py::sequence>(value)) throw InvalidInput("guides must be a list of Guide");
  for (const py::handle guide : py::sequence(value)) {
    if (!py::isinstance<Guide>(guide)) {
      throw InvalidInput("guides[" + std::to_string(guides.size()) + "] is not a Guide");
    }
    guides.push_back(guide.cast<Guide>());
  }
  return guides;
}

PrescribedSingularities read_singularities(const py::object& value) {
  if (value.is_none()) return {};
  if (!py::isinstance<py::sequence>(value) || py::len(value) != 2) {
    throw InvalidInput("singularities must be (positions, quarter turns) or None");
  }
  const py::sequence pair(value);
  PrescribedSingularities read{read_points(pair[0], "singularities: positions"),
                               read_indices(pair[1], "singularities: quarter turns")};
  if (read.positions.size() != read.indices.size()) {
    throw InvalidInput("singularities has " + std::to_string(read.positions.size()) +
                       " positions but " + std::to_string(read.indices.size()) + " quarter turns");
  }
  return read;
}

void bind_guidance(py::class_<PrepareOptions>& bound) {
  bound.def_property(
      "guides", [](const PrepareOptions& options) { return py::cast(options.cross_field.guides); },
      [](PrepareOptions& options, const py::object& value) {
        options.cross_field.guides = read_guides(value);
      },
      "Strokes for the field to follow");
  OPTION("guide_radius", cross_field.guide_radius,
         "No vertex so near a guide is reliable; share of the object's diagonal");
  bound.def_property(
      "singularities",
      [](const PrepareOptions& options) -> py::object {
        const PrescribedSingularities& s = options.cross_field.singularities;
        if (s.empty()) return py::none();
        return py::make_tuple(array_of(s.positions), array_of(s.indices));
      },
      [](PrepareOptions& options, const py::object& value) {
        options.cross_field.singularities = read_singularities(value);
      },
      "(positions (k, 3), quarter turns (k,)) that the field is to have, or None");
}

void bind_prepare_options(py::module_& m) {
  py::class_<PrepareOptions> bound(m, "PrepareOptions", "How meshes are prepared.");
  bound.def(py::init(&from_keywords<PrepareOptions>));
  bound.def_property(
      "scheme", [](const PrepareOptions& options) { return name_of(options.surface.scheme); },
      [](PrepareOptions& options, const py::object& value) {
        options.surface.scheme = read_scheme(value, "scheme");
      },
      "'auto', 'catmull-clark', 'loop' or 'none'");
  OPTION("level", surface.level, "-1: the first whose median edge is at most edge_length");
  OPTION("edge_length", surface.edge_length, "World units; 0: 1/600 of the scene's diagonal");
  OPTION("triangle_budget", surface.triangle_budget, "Binds automatic levels, all meshes together");
  OPTION("threads", threads, "0: all cores");
  OPTION("field", field, "False: what hatching needs waits until it is first asked for");
  OPTION("rings", jet.rings, "Neighbours that the hatching curvature is fitted to");
  OPTION("parabolic_ratio", cross_field.parabolic_ratio,
         "Reliable where |k2| <= ratio |k1|; 0: no vertex is");
  OPTION("least_curvature", cross_field.least_curvature,
         "Reliable where |k1| >= this / the object's diagonal");
  OPTION("largest_energy", cross_field.largest_energy,
         "Reliable where the mean of 1 + e over the edges is at most this, in [0, 2]");
  OPTION("alignment_weight", cross_field.alignment_weight, "Soft pull of creases and boundaries");
  OPTION("inverse_length_weights", cross_field.inverse_length_weights,
         "Edges count in inverse proportion to their length");
  bound.def_property(
      "field_start",
      [](const PrepareOptions& options) {
        return start_names[static_cast<std::size_t>(options.cross_field.start)];
      },
      [](PrepareOptions& options, const std::string& name) {
        options.cross_field.start = start_named(name);
      },
      "'search': the best of many fields; 'principal': near the principal directions");
  bind_guidance(bound);
  OPTION("most_intersections", most_intersections,
         "Pairs of crossing triangles, beyond which no curves are drawn where objects cross");
  OPTION("max_evaluations", cross_field.max_evaluations, "Of the field's energy");
  bound.def_property(
      "default_direction",
      [](const PrepareOptions& options) {
        const Vec3& d = options.cross_field.default_direction;
        return py::make_tuple(d.x(), d.y(), d.z());
      },
      [](PrepareOptions& options, const py::object& value) {
        options.cross_field.default_direction = read_vector(value, "default_direction");
      },
      "World direction of the field where nothing is reliable");
}

void bind_material_style(py::module_& m) {
  py::class_<MaterialStyle> bound(m, "MaterialStyle", "What is drawn of one material of a mesh.");
  bound.def(py::init(&from_keywords<MaterialStyle>));
  OPTION("lines", lines, "Whether lines on it are drawn");
  OPTION("hatching", hatching, "Whether it is hatched");
  OPTION("spacing_scale", spacing_scale, "Of the hatches on it");
  OPTION("width_scale", width_scale, "Of all strokes on it");
  OPTION("pen", pen, "Of all strokes on it, which end where it changes; 0: the object's");
}

void bind_object_style(py::module_& m) {
  bind_material_style(m);
  py::class_<ObjectStyle> bound(m, "ObjectStyle", "What is drawn of one mesh.");
  bound.def(py::init(&from_keywords<ObjectStyle>));
  OPTION("ignore", ignore, "Left out entirely: neither drawn nor in front of anything");
  OPTION("occlude_only", occlude_only, "Hides what is behind it, but is not drawn");
  OPTION("see_through", see_through, "Hides nothing and is not hatched, as glass");
  OPTION("shadow_only", shadow_only, "Left out, but keeps the light from others");
  OPTION("shadow_catcher", shadow_catcher,
         "Without lines, and hatched only where others keep the light away");
  OPTION("lines", lines, "Whether its lines are drawn");
  OPTION("hatching", hatching, "Whether it is hatched");
  OPTION("loose_edges", loose_edges, "Its edges of no face are drawn in any case");
  OPTION("spacing_scale", spacing_scale, "Of its hatches");
  OPTION("width_scale", width_scale, "Of all its strokes");
  OPTION("pen", pen, "Of all its strokes, as Drawing.pens has it");
  OPTION("materials", materials,
         "A MaterialStyle for each number in face_materials; those beyond are as the object");
}

template <class Class>
void bind_tone_options(Class& bound) {
  OPTION("highlight_threshold", values.tone.highlight_threshold, "Brighter: not hatched");
  OPTION("shadow_threshold", values.tone.shadow_threshold, "At most as bright: two directions");
  OPTION("highlight_share", values.tone.highlight_share,
         "Share of the visible area that is highlight, in place of the threshold; or None");
  OPTION("shadow_share", values.tone.shadow_share,
         "Share of the visible area that is shadow, in place of the threshold; or None");
  OPTION("extra_levels", values.tone.extra_levels,
         "Into which shadows are divided further, [0, 3]");
  OPTION("reflectance", values.tone.reflectance,
         "How much the meshes' own reflectance counts, [0, 1]; 0: all are white");
  OPTION("exposure", values.tone.exposure, "The light is multiplied by it");
  OPTION("auto_exposure", values.tone.auto_exposure,
         "Whether the light is also multiplied by what suits the view");
  OPTION("cast_shadows", values.tone.cast_shadows, "Whether surfaces keep the light from others");
  OPTION("smallest_tone", values.smallest_tone,
         "Patches of one tone smaller than a square of so many spacings join their neighbour");
  bound.def_readwrite("tone_image", &PythonDrawOptions::tone_image,
                      "(h, w) light that comes back, linear, rows downwards, in place of lights "
                      "and reflectance: stretched over the view; or None");
  OPTION("mach_bands", values.tone.mach_bands, "Blank bands on the near side of folds");
  OPTION("undercuts", values.tone.undercuts, "Dense hatching beyond folds");
  OPTION("mach_band_px", values.tone.mach_band_px, "Width of Mach bands");
  OPTION("undercut_px", values.tone.undercut_px, "Width of undercuts");
  OPTION("undercut_contact", values.tone.undercut_contact,
         "How near what lies beyond a fold must be for an undercut: 0: anywhere, 1: touching");
  OPTION("cell_px", values.cell_px, "Largest cells of the tone map, [0.25, 64]");
}

template <class Class>
void bind_hatch_options(Class& bound) {
  OPTION("hatching", values.hatching, "False: lines only, no tone");
  bound.def_property(
      "hatch_seeding",
      [](const PythonDrawOptions& options) { return name_of(options.values.hatch.seeding); },
      [](PythonDrawOptions& options, const py::object& value) {
        options.values.hatch.seeding = read_seeding(value, "hatch_seeding");
      },
      "'surface-curves' or 'critical-curves'");
  OPTION("spacing_px", values.hatch.spacing_px, "Between hatches");
  OPTION("undercut_spacing_px", values.hatch.undercut_spacing_px, "Between hatches in undercuts");
  OPTION("least_spacing_px", values.hatch.least_spacing_px,
         "Parts smaller than sixteen spacings are hatched finer, until their spacing is this, "
         "undercuts in proportion; as large as spacing_px: no finer");
  OPTION("test_factor", values.hatch.test_factor, "A hatch ends this share of the spacing away");
  OPTION("step_px", values.hatch.step_px, "Length of a tracing step of the paper's seeding");
  OPTION("max_turn_deg", values.hatch.max_turn_deg, "How far a hatch may turn in the world");
  OPTION("max_length_px", values.hatch.max_length_px, "Length of a hatch");
  OPTION("min_length_px", values.hatch.min_length_px, "Shorter hatches are dropped");
}

template <class Class>
void bind_stroke_options(Class& bound) {
  OPTION("line_width_px", values.stroke.line_width_px, "Silhouettes and boundaries");
  OPTION("feature_width_px", values.stroke.feature_width_px, "All other lines");
  OPTION("hatch_width_px", values.stroke.hatch_width_px, "At the border of shadow and midtone");
  OPTION("hatch_width_by_light", values.stroke.hatch_width_by_light,
         "Share by which hatches swell towards the dark and thin towards highlights, [0, 1]");
  OPTION("line_width_by_light", values.stroke.line_weight.by_light,
         "Share by which lines swell on the side of a form that is turned from the light, [0, 1]");
  OPTION("line_width_by_depth", values.stroke.line_weight.by_depth,
         "Share by which the nearest lines swell and the farthest thin out, [0, 1]");
  OPTION("inner_width_scale", values.stroke.line_weight.inner_scale,
         "Of lines that have the same object on both sides");
  OPTION("line_width_by_crowding", values.stroke.width_by_crowding,
         "How far lines thin out where gaps between them would close, [0, 1]");
  OPTION("hidden_width_scale", values.stroke.hidden_width_scale, "Of hidden lines");
  OPTION("taper_px", values.stroke.taper_px, "Length over which free ends thin out");
  OPTION("speck_px", values.stroke.speck_px, "Shorter lines are dropped unless they close a gap");
  OPTION("simplify_px", values.stroke.simplify_px, "How far a stroke may be from its curve");
  OPTION("marks", values.stroke.marks, "Draw marked edges");
  OPTION("materials", values.stroke.materials, "Draw borders between materials");
  OPTION("flat_outlines", values.stroke.flat_outlines, "Draw outlines of flat areas");
  OPTION("loose_edges", values.loose_edges, "Draw edges of no face");
}

template <class Class>
void bind_curvature_curve_options(Class& bound) {
  OPTION("suggestive_contours", values.curvature_curves.suggestive_contours,
         "Draw where contours would appear in near views");
  OPTION("ridges", values.curvature_curves.ridges, "Draw ridges of smooth surfaces");
  OPTION("valleys", values.curvature_curves.valleys, "Draw valleys of smooth surfaces");
  OPTION("suggestive_threshold", values.curvature_curves.suggestive_threshold,
         "Weaker suggestive contours are left out");
  OPTION("ridge_threshold", values.curvature_curves.ridge_threshold, "Weaker ridges are left out");
  OPTION("valley_threshold", values.curvature_curves.valley_threshold,
         "Weaker valleys are left out");
}

template <class Class>
void bind_light_contour_options(Class& bound) {
  OPTION("terminators", values.light_contours.terminators,
         "Draw where forms turn away from the lights");
  OPTION("shadow_outlines", values.light_contours.shadow_outlines,
         "Draw the outlines of cast shadows on what receives them");
}

std::optional<std::array<int, 2>> read_range(const py::object& value) {
  if (value.is_none()) return std::nullopt;
  const std::vector<int> range = read_indices(value, "hidden_lines");
  if (range.size() != 2) throw InvalidInput("hidden_lines must be (low, high) or None");
  return std::array<int, 2>{range[0], range[1]};
}

py::object range_object(const std::optional<std::array<int, 2>>& range) {
  if (!range) return py::none();
  return py::make_tuple((*range)[0], (*range)[1]);
}

void bind_draw_options(py::module_& m) {
  py::class_<PythonDrawOptions> bound(m, "DrawOptions", "How a view is drawn.");
  bound.def(py::init(&from_keywords<PythonDrawOptions>));
  bind_hatch_options(bound);
  bind_tone_options(bound);
  bind_stroke_options(bound);
  OPTION("scan_silhouettes", values.scan_silhouettes,
         "Look at every triangle for silhouettes instead of searching: slower, the same drawing");
  bind_curvature_curve_options(bound);
  bind_light_contour_options(bound);
  OPTION("threads", values.threads, "0: all cores");
  bound.def_property(
      "visibility",
      [](const PythonDrawOptions& options) { return name_of(options.values.visibility); },
      [](PythonDrawOptions& options, const py::object& value) {
        options.values.visibility = read_visibility(value, "visibility");
      },
      "'labels': they cannot contradict each other; 'vote': that of the paper, for comparison");
  bound.def_readwrite("styles", &PythonDrawOptions::styles, "One ObjectStyle per mesh, or None");
  bound.def_property(
      "hidden_lines",
      [](const PythonDrawOptions& options) {
        return range_object(options.values.stroke.hidden_lines);
      },
      [](PythonDrawOptions& options, const py::object& value) {
        options.values.stroke.hidden_lines = read_range(value);
      },
      "(low, high): also lines with so many layers in front, inclusive; None: visible lines only");
}

// None where the object is None. Rows of textures are upwards.
std::shared_ptr<const Texture> read_tone_image(const py::object& image) {
  if (image.is_none()) return nullptr;
  using Rows = py::array_t<float, py::array::c_style | py::array::forcecast>;
  const Rows rows = Rows::ensure(image);
  if (!rows || rows.ndim() != 2 || rows.size() == 0) {
    PyErr_Clear();
    throw InvalidInput("tone_image must be (h, w) numbers, or None");
  }
  constexpr py::ssize_t most = 1 << 20;
  if (rows.shape(0) > most || rows.shape(1) > most) throw InvalidInput("tone_image is too large");
  const auto width = static_cast<std::size_t>(rows.shape(1));
  std::vector<float> upwards;
  upwards.reserve(static_cast<std::size_t>(rows.size()));
  for (py::ssize_t row = rows.shape(0) - 1; row >= 0; --row) {
    const float* first = rows.data(row, 0);
    upwards.insert(upwards.end(), first, first + width);
  }
  return std::make_shared<const Texture>(static_cast<int>(width), static_cast<int>(rows.shape(0)),
                                         std::move(upwards), Wrap::extend);
}

}  // namespace

DrawOptions read_draw_options(const PythonDrawOptions& options) {
  DrawOptions read = options.values;
  read.tone.image = read_tone_image(options.tone_image);
  if (options.styles.is_none()) return read;
  if (!py::isinstance<py::sequence>(options.styles)) {
    throw InvalidInput("styles must be a list of ObjectStyle, or None");
  }
  for (const py::handle style : py::sequence(options.styles)) {
    if (!py::isinstance<ObjectStyle>(style)) {
      throw InvalidInput("styles[" + std::to_string(read.styles.size()) +
                         "] is not an ObjectStyle");
    }
    read.styles.push_back(style.cast<ObjectStyle>());
  }
  return read;
}

void bind_options(py::module_& m) {
  bind_object_style(m);
  bind_guide(m);
  bind_prepare_options(m);
  bind_draw_options(m);
}

}  // namespace illustrate::bindings
