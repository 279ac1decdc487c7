// Drawings: strokes, the labelled graph, tone, counts.
#include <pybind11/stl.h>

#include "bindings/arrays.h"
#include "bindings/bind.h"
#include "bindings/draw_options.h"
#include "bindings/drawing_arrays.h"
#include "bindings/jobs.h"
#include "bindings/names.h"
#include "pipeline/rough_lines.h"

namespace illustrate::bindings {
namespace {

using DrawingPointer = std::shared_ptr<const DrawingArrays>;

struct GraphHandle {
  DrawingPointer drawing;
};

struct ToneHandle {
  DrawingPointer drawing;
};

// `member` of `part(arrays)` as a read-only array attribute.
template <class Handle, class Class, class Part>
auto array_attributes(Class& bound, Part part) {
  return [&bound, part](const char* name, auto member) {
    bound.def_property_readonly(name, [member, part](const Handle& handle) {
      return view_of(handle.drawing, part(*handle.drawing).*member);
    });
  };
}

// An enumeration of one byte as numbers.
template <class Enumeration>
py::array codes(const DrawingPointer& owner, const std::vector<Enumeration>& values,
                const Shape& shape) {
  static_assert(sizeof(Enumeration) == 1);
  return view_of(owner, values.data(), py::dtype::of<std::uint8_t>(), shape);
}

void bind_graph(py::module_& m) {
  py::class_<GraphHandle> bound(m, "Graph", "The labelled curve network of a view.");
  const auto own = array_attributes<GraphHandle>(
      bound, [](const DrawingArrays& d) -> const DrawingArrays& { return d; });
  own("node_kind", &DrawingArrays::node_kind);
  own("node_image", &DrawingArrays::node_image);
  own("node_arcs", &DrawingArrays::node_arcs);
  own("arc_nodes", &DrawingArrays::arc_nodes);
  own("arc_kind", &DrawingArrays::arc_kind);
  own("arc_object", &DrawingArrays::arc_object);
  own("arc_invisibility", &DrawingArrays::arc_invisibility);
  own("arc_flush", &DrawingArrays::arc_flush);
  own("arc_layers_over", &DrawingArrays::arc_layers_over);
  own("arc_points", &DrawingArrays::arc_points);
  const auto image = array_attributes<GraphHandle>(
      bound, [](const DrawingArrays& d) -> const Ragged<Vec2>& { return d.result.graph.image; });
  image("arc_offsets", &Ragged<Vec2>::offsets);
  image("arc_image", &Ragged<Vec2>::values);
}

void bind_tone(py::module_& m) {
  py::class_<ToneHandle> bound(m, "ToneMap", "Light and shadow on a grid over the image.");
  const auto grid = [](const ToneMap& tone) { return Shape{tone.height, tone.width}; };
  const auto tone_of = [](const ToneHandle& handle) -> const ToneMap& {
    return handle.drawing->result.tone;
  };
  bound.def_property_readonly("level", [=](const ToneHandle& handle) {
    return codes(handle.drawing, tone_of(handle).level, grid(tone_of(handle)));
  });
  bound.def_property_readonly("band", [=](const ToneHandle& handle) {
    return codes(handle.drawing, tone_of(handle).band, grid(tone_of(handle)));
  });
  bound.def_property_readonly("brightness", [=](const ToneHandle& handle) {
    return view_of(handle.drawing, tone_of(handle).brightness.data(), py::dtype::of<float>(),
                   grid(tone_of(handle)));
  });
  bound.def_property_readonly("extra", [=](const ToneHandle& handle) {
    const ToneMap& tone = tone_of(handle);
    return codes(handle.drawing, tone.extra, tone.extra.empty() ? Shape{0, 0} : grid(tone));
  });
  bound.def_property_readonly("highlight_threshold", [=](const ToneHandle& handle) {
    return tone_of(handle).highlight_threshold;
  });
  bound.def_property_readonly("shadow_threshold", [=](const ToneHandle& handle) {
    return tone_of(handle).shadow_threshold;
  });
  bound.def_property_readonly("exposure",
                              [=](const ToneHandle& handle) { return tone_of(handle).exposure; });
  bound.def_property_readonly("cell_px",
                              [=](const ToneHandle& handle) { return tone_of(handle).cell_px; });
}

struct DrawingHandle {
  DrawingPointer drawing;
};

void bind_drawing(py::module_& m) {
  py::class_<DrawingHandle, std::shared_ptr<DrawingHandle>> bound(m, "Drawing",
                                                                  "One finished view.");
  const auto stroke = array_attributes<DrawingHandle>(
      bound, [](const DrawingArrays& d) -> const Drawing& { return d.result.drawing; });
  stroke("points", &Drawing::points);
  stroke("image", &Drawing::image);
  stroke("widths", &Drawing::widths);
  stroke("offsets", &Drawing::offsets);
  stroke("objects", &Drawing::objects);
  stroke("invisibility", &Drawing::invisibility);
  stroke("pens", &Drawing::pens);
  const auto own = array_attributes<DrawingHandle>(
      bound, [](const DrawingArrays& d) -> const DrawingArrays& { return d; });
  const auto track = array_attributes<DrawingHandle>(
      bound, [](const DrawingArrays& d) -> const StrokeTracks& { return d.result.drawing.tracks; });
  track("stroke_ids", &StrokeTracks::ids);
  track("stroke_births", &StrokeTracks::births);
  track("stroke_starts", &StrokeTracks::starts);
  track("stroke_deaths", &StrokeTracks::deaths);
  bound.def_property_readonly(
      "frame", [](const DrawingHandle& h) { return h.drawing->result.drawing.tracks.frame; });
  own("triangles", &DrawingArrays::triangles);
  own("barycentrics", &DrawingArrays::barycentrics);
  bound
      .def_property_readonly("kinds",
                             [](const DrawingHandle& h) {
                               const auto& kinds = h.drawing->result.drawing.kinds;
                               return codes(h.drawing, kinds, {length(kinds.size())});
                             })
      .def_property_readonly("closed",
                             [](const DrawingHandle& h) {
                               return view_of_flags(h.drawing, h.drawing->result.drawing.closed);
                             })
      .def_property_readonly("graph", [](const DrawingHandle& h) { return GraphHandle{h.drawing}; })
      .def_property_readonly("tone", [](const DrawingHandle& h) { return ToneHandle{h.drawing}; })
      .def_property_readonly(
          "repair_max_px",
          [](const DrawingHandle& h) { return h.drawing->result.graph.repair_max_px; })
      .def_property_readonly("counts",
                             [](const DrawingHandle& h) { return h.drawing->result.counts; })
      .def_property_readonly("timings",
                             [](const DrawingHandle& h) { return h.drawing->result.timings; });
}

std::vector<Light> read_lights(const py::object& lights) {
  std::vector<Light> read;
  if (lights.is_none()) return read;
  for (const py::handle light : py::iterable(lights)) {
    if (!py::isinstance<Light>(light)) {
      throw InvalidInput("lights[" + std::to_string(read.size()) + "] is not a Light");
    }
    read.push_back(light.cast<Light>());
  }
  return read;
}

std::shared_ptr<DrawingHandle> handle_of(DrawResult drawing) {
  return std::make_shared<DrawingHandle>(
      DrawingHandle{std::make_shared<const DrawingArrays>(std::move(drawing))});
}

// Null: none.
const Drawing* drawn(const DrawingPointer& drawing) {
  return drawing ? &drawing->result.drawing : nullptr;
}

DrawingPointer drawing_of(const DrawingHandle* handle) {
  return handle ? handle->drawing : nullptr;
}

// A view, and what it refers to.
struct ViewHandle {
  std::shared_ptr<Prepared> prepared;
  std::shared_ptr<const View> view;
};

// All that a view is made from, without a Python object.
struct ViewInput {
  std::shared_ptr<Prepared> prepared;
  Camera camera;
  DrawOptions options;
  std::vector<Light> lights;

  ViewHandle operator()(const Progress& progress) const {
    return {prepared,
            std::make_shared<const View>(view_of(*prepared, camera, options, lights, progress))};
  }
};

// The same of a drawing.
struct DrawingInput {
  ViewInput view;
  DrawingPointer previous;

  std::shared_ptr<DrawingHandle> operator()(const Progress& progress) const {
    return handle_of(
        draw(*view.prepared, view.camera, view.options, view.lights, progress, drawn(previous)));
  }
};

// Of a drawing of a view that is there.
struct ViewDrawingInput {
  ViewHandle view;
  DrawingPointer previous;
  Detail detail;

  std::shared_ptr<DrawingHandle> operator()(const Progress& progress) const {
    return handle_of(draw(*view.view, progress, drawn(previous), detail));
  }
};

template <class Input>
auto made_from(const Input& input, const py::object& progress) {
  const Progress reported = progress_of(progress);
  const py::gil_scoped_release release;
  return input(reported);
}

ViewInput input_from(const std::shared_ptr<Prepared>& prepared, const Camera& camera,
                     const PythonDrawOptions* options, const py::object& lights) {
  return {prepared, camera, options ? read_draw_options(*options) : DrawOptions{},
          read_lights(lights)};
}

std::shared_ptr<DrawingHandle> draw_view(const std::shared_ptr<Prepared>& prepared,
                                         const Camera& camera, const PythonDrawOptions* options,
                                         const py::object& lights, const py::object& progress,
                                         const DrawingHandle* previous) {
  const ViewInput view = input_from(prepared, camera, options, lights);
  return made_from(DrawingInput{view, drawing_of(previous)}, progress);
}

JobPointer start_drawing(const std::shared_ptr<Prepared>& prepared, const Camera& camera,
                         const PythonDrawOptions* options, const py::object& lights,
                         const DrawingHandle* previous) {
  const ViewInput view = input_from(prepared, camera, options, lights);
  return start_job(DrawingInput{view, drawing_of(previous)});
}

void bind_view(py::module_& m) {
  using namespace py::literals;
  const py::none none;
  py::class_<ViewHandle>(m, "View", "A view before it is hatched: its lines and tones.")
      .def_property_readonly("exposure",
                             [](const ViewHandle& handle) { return handle.view->tone.exposure; })
      .def(
          "draw",
          [](const ViewHandle& view, const py::object& progress, const DrawingHandle* previous,
             const py::object& detail) {
            return made_from(ViewDrawingInput{view, drawing_of(previous), read_detail(detail)},
                             progress);
          },
          "progress"_a = none, "previous"_a = none, "detail"_a = "whole",
          "The drawing of the view.")
      .def(
          "start_draw",
          [](const ViewHandle& view, const DrawingHandle* previous, const py::object& detail) {
            return start_job(ViewDrawingInput{view, drawing_of(previous), read_detail(detail)});
          },
          "previous"_a = none, "detail"_a = "whole", "The same as a Job.");
  m.def(
      "view",
      [](const std::shared_ptr<Prepared>& prepared, const Camera& camera,
         const PythonDrawOptions* options, const py::object& lights, const py::object& progress) {
        return made_from(input_from(prepared, camera, options, lights), progress);
      },
      "prepared"_a.none(false), "camera"_a, "options"_a = none, "lights"_a = none,
      "progress"_a = none, "Lines and tones of a view.");
  m.def(
      "start_view",
      [](const std::shared_ptr<Prepared>& prepared, const Camera& camera,
         const PythonDrawOptions* options, const py::object& lights) {
        return start_job(input_from(prepared, camera, options, lights));
      },
      "prepared"_a.none(false), "camera"_a, "options"_a = none, "lights"_a = none,
      "The same as a Job.");
}

struct SilhouetteTriangles {
  std::shared_ptr<const std::vector<int>> triangles;
};

SilhouetteTriangles find_silhouettes(const Prepared& prepared, const Camera& camera,
                                     bool brute_force) {
  const py::gil_scoped_release release;
  return {std::make_shared<const std::vector<int>>(
      silhouette_triangles(prepared, camera, brute_force))};
}

py::array ends_of(std::vector<Segment> segments) {
  static_assert(sizeof(Segment) == 6 * sizeof(float), "segments must be packed");
  const auto owner = std::make_shared<const std::vector<Segment>>(std::move(segments));
  return view_of(owner, owner->data(), py::dtype::of<float>(), {length(2 * owner->size()), 3});
}

py::array find_rough_silhouettes(const Prepared& prepared, const Camera& camera) {
  std::vector<Segment> segments;
  {
    const py::gil_scoped_release release;
    segments = rough_silhouettes(prepared, camera);
  }
  return ends_of(std::move(segments));
}

py::array find_rough_features(const Prepared& prepared) {
  std::vector<Segment> segments;
  {
    const py::gil_scoped_release release;
    segments = rough_features(prepared);
  }
  return ends_of(std::move(segments));
}

}  // namespace

void bind_draw(py::module_& m) {
  using namespace py::literals;
  bind_graph(m);
  bind_tone(m);
  bind_drawing(m);
  bind_view(m);
  py::class_<SilhouetteTriangles>(m, "Silhouettes", "Where the surface turns away from the eye.")
      .def_property_readonly("triangles", [](const SilhouetteTriangles& found) {
        return view_of(found.triangles, *found.triangles);
      });
  const py::none none;
  // None as a shared pointer would be null; what is taken by reference refuses it without a word
  // here.
  m.def("draw", &draw_view, "prepared"_a.none(false), "camera"_a, "options"_a = none,
        "lights"_a = none, "progress"_a = none, "previous"_a = none,
        "One view of a prepared scene.");
  m.def("start_draw", &start_drawing, "prepared"_a.none(false), "camera"_a, "options"_a = none,
        "lights"_a = none, "previous"_a = none, "The same as a Job.");
  m.def("silhouettes", &find_silhouettes, "prepared"_a, "camera"_a, "brute_force"_a = false,
        "The triangles that carry silhouettes.");
  m.def("rough_silhouettes", &find_rough_silhouettes, "prepared"_a, "camera"_a,
        "Silhouettes for a viewer that redraws while it moves.");
  m.def("rough_features", &find_rough_features, "prepared"_a,
        "Lines that every view has, for the same.");
}

}  // namespace illustrate::bindings
