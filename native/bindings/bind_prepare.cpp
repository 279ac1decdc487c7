// Prepared scenes: the surface, the field, what was mended.
#include <pybind11/stl.h>

#include "bindings/arrays.h"
#include "bindings/bind.h"
#include "bindings/draw_options.h"
#include "bindings/jobs.h"
#include "pipeline/prepare.h"
#include "surface/edge_kinds.h"

namespace illustrate::bindings {
namespace {

using PreparedPointer = std::shared_ptr<const Prepared>;

struct SurfaceHandle {
  PreparedPointer prepared;
  const Surface& surface() const { return prepared->surface(); }
};

struct FieldHandle {
  std::shared_ptr<const CrossField> field;
};

const Curvature& hatch_curvature(const SurfaceHandle& handle) {
  const py::gil_scoped_release release;
  return handle.prepared->hatch_curvature();
}

// Line curvature; objects of scheme none have only the hatching curvature.
template <class Value>
py::array line_curvature(const SurfaceHandle& handle, Value PrincipalCurvature::*member) {
  const Surface& surface = handle.surface();
  const auto& smooth = surface.object_is_smooth;
  if (std::find(smooth.begin(), smooth.end(), 0) == smooth.end()) {
    return view_of(handle.prepared, surface.curvature, member);
  }
  std::vector<Value> values;
  const Curvature& fitted = hatch_curvature(handle);
  for (std::size_t i = 0; i < fitted.size(); ++i) {
    const bool is_smooth = smooth[static_cast<std::size_t>(surface.objects[i])] != 0;
    values.push_back((is_smooth ? surface.curvature : fitted)[i].*member);
  }
  return array_of(std::move(values));
}

py::array feature_kinds(const SurfaceHandle& handle) {
  std::vector<std::uint8_t> kinds;
  for (const EdgeKind kind : handle.surface().feature_kinds) {
    kinds.push_back(static_cast<std::uint8_t>(line_kind(kind)));
  }
  return array_of(std::move(kinds));
}

BasePlace checked_place(const LimitSurface& surface, int face, const Vec2& uv) {
  // Callers compute places themselves, and round.
  constexpr double slack = 1e-9;
  if (face < 0 || face >= surface.ptex_faces()) {
    const std::string faces = std::to_string(surface.ptex_faces());
    throw InvalidInput("base_faces: " + std::to_string(face) + " is none of the " + faces +
                       " faces of the limit surface (meshes of scheme 'none' have none, and "
                       "with cage=False vertices may have none)");
  }
  const double most = surface.is_triangle(face) ? uv.sum() : uv.maxCoeff();
  if (!uv.allFinite() || uv.minCoeff() < -slack || most > 1 + slack) {
    throw InvalidInput("base_uv: (" + std::to_string(uv.x()) + ", " + std::to_string(uv.y()) +
                       ") lies outside face " + std::to_string(face));
  }
  return {face, uv};
}

py::tuple evaluate(const SurfaceHandle& handle, const py::object& base_faces,
                   const py::object& base_uv) {
  const std::vector<int> faces = read_indices(base_faces, "base_faces");
  const ImagePoints uv = read_pairs(base_uv, "base_uv");
  if (uv.size() != faces.size()) {
    throw InvalidInput("base_faces and base_uv must have the same length");
  }
  std::array<Points, 6> results;
  {
    const py::gil_scoped_release release;
    const LimitSurface& surface = handle.prepared->limit_surface();
    for (Points& result : results) result.reserve(faces.size());
    for (std::size_t i = 0; i < faces.size(); ++i) {
      const auto p = surface.evaluate(checked_place(surface, faces[i], uv[i]));
      if (!p)
        throw InvalidInput("base_faces: face " + std::to_string(faces[i]) +
                           " has more than 100 corners or edges at a corner, or the surface leaves "
                           "the limit there to keep to its mesh (not with cage=True)");
      const std::array<Vec3, 6> parts{p->position, p->du, p->dv, p->duu, p->duv, p->dvv};
      for (std::size_t k = 0; k < parts.size(); ++k) results[k].push_back(parts[k]);
    }
  }
  py::tuple tuple(results.size());
  for (std::size_t k = 0; k < results.size(); ++k) tuple[k] = array_of(std::move(results[k]));
  return tuple;
}

void bind_surface(py::module_& m) {
  py::class_<SurfaceHandle> bound(m, "Surface", "The triangulated limit surface.");
  const auto part = [&](const char* name, auto member) {
    bound.def_property_readonly(name, [member](const SurfaceHandle& handle) {
      return view_of(handle.prepared, handle.surface().*member);
    });
  };
  part("positions", &Surface::positions);
  part("normals", &Surface::normals);
  part("triangles", &Surface::triangles);
  part("objects", &Surface::objects);
  part("base_faces", &Surface::base_faces);
  part("base_uv", &Surface::base_uv);
  part("triangle_faces", &Surface::triangle_faces);
  part("feature_edges", &Surface::feature_edges);
  bound.def_property_readonly("feature_kinds", &feature_kinds);
  bound.def("evaluate", &evaluate, py::arg("base_faces"), py::arg("base_uv"),
            "The limit surface and its derivatives at any of its points.");
  const auto curvature = [&](const char* line_name, const char* hatch_name, auto member) {
    bound.def_property_readonly(line_name, [member](const SurfaceHandle& handle) {
      return line_curvature(handle, member);
    });
    bound.def_property_readonly(hatch_name, [member](const SurfaceHandle& handle) {
      return view_of(handle.prepared, hatch_curvature(handle), member);
    });
  };
  curvature("k1", "hatch_k1", &PrincipalCurvature::k1);
  curvature("k2", "hatch_k2", &PrincipalCurvature::k2);
  curvature("w1", "hatch_w1", &PrincipalCurvature::w1);
  curvature("w2", "hatch_w2", &PrincipalCurvature::w2);
}

void bind_field(py::module_& m) {
  py::class_<FieldHandle> bound(m, "CrossField", "A smooth field of crosses for hatching.");
  const auto part = [&](const char* name, auto member) {
    bound.def_property_readonly(name, [member](const FieldHandle& handle) {
      return view_of(handle.field, (*handle.field).*member);
    });
  };
  const auto number = [&](const char* name, auto member) {
    bound.def_property_readonly(
        name, [member](const FieldHandle& handle) { return (*handle.field).*member; });
  };
  part("theta", &CrossField::theta);
  part("reference", &CrossField::reference);
  part("directions", &CrossField::directions);
  part("singular_triangles", &CrossField::singular_triangles);
  part("singular_indices", &CrossField::singular_indices);
  part("singular_positions", &CrossField::singular_positions);
  bound.def_property_readonly("reliable", [](const FieldHandle& handle) {
    return view_of_flags(handle.field, handle.field->reliable);
  });
  number("energy", &CrossField::energy);
  number("energy_initial", &CrossField::energy_initial);
  number("converged", &CrossField::converged);
  number("evaluations", &CrossField::evaluations);
}

struct HatchCurvesHandle {
  std::shared_ptr<const Ragged<SurfacePoint>> curves;
  PreparedPointer prepared;
};

HatchCurvesHandle hatch_curves_of(const PreparedPointer& prepared) {
  const py::gil_scoped_release release;
  auto curves = std::make_shared<Ragged<SurfacePoint>>();
  const std::vector<double> finest(prepared->object_count(), 0);
  for (const CurvesOfObject& of_object : prepared->hatch_curves(finest)) {
    const Ragged<SurfacePoint> own = of_object.curves();
    for (std::size_t c = 0; c < own.size(); ++c) curves->add(own[c]);
  }
  return {curves, prepared};
}

void bind_hatch_curves(py::module_& m) {
  py::class_<HatchCurvesHandle>(m, "HatchCurves", "Ranked curves on the surface, object by object.")
      .def_property_readonly(
          "offsets",
          [](const HatchCurvesHandle& h) { return view_of(h.curves, h.curves->offsets); })
      .def_property_readonly("points",
                             [](const HatchCurvesHandle& h) {
                               Points points;
                               for (const SurfacePoint& on : h.curves->values) {
                                 points.push_back(position_at(h.prepared->surface(), on));
                               }
                               return array_of(std::move(points));
                             })
      .def_property_readonly("triangles",
                             [](const HatchCurvesHandle& h) {
                               std::vector<int> triangles;
                               for (const SurfacePoint& on : h.curves->values) {
                                 triangles.push_back(on.triangle);
                               }
                               return array_of(std::move(triangles));
                             })
      .def_property_readonly("barycentrics", [](const HatchCurvesHandle& h) {
        ImagePoints weights;
        for (const SurfacePoint& on : h.curves->values) weights.emplace_back(on.b1, on.b2);
        return array_of(std::move(weights));
      });
}

FieldHandle field_of(const PreparedPointer& prepared) {
  const py::gil_scoped_release release;
  // A pointer to the field that keeps the whole scene, which the field is a part of.
  return {{prepared, &prepared->field()}};
}

Counts report_of(const Prepared& prepared) {
  const py::gil_scoped_release release;
  return prepared.report();
}

py::list reports_of(const Prepared& prepared) {
  py::list reports;
  for (const MeshReport& report : prepared.mesh_reports()) {
    py::dict entry;
    entry["name"] = report.name;
    for (const auto& [name, count] : report.counts) entry[py::str(name)] = count;
    reports.append(entry);
  }
  return reports;
}

py::list left_out_intersections_of(const Prepared& prepared) {
  const std::vector<ObjectPair>* pairs = nullptr;
  {
    const py::gil_scoped_release release;
    pairs = &prepared.intersections().left_out;
  }
  py::list result;
  for (const ObjectPair& pair : *pairs) result.append(py::make_tuple(pair[0], pair[1]));
  return result;
}

std::vector<MeshPointer> read_meshes(const py::iterable& meshes) {
  std::vector<MeshPointer> pointers;
  for (const py::handle mesh : meshes) {
    if (!py::isinstance<PolygonMesh>(mesh)) {
      throw InvalidInput("meshes[" + std::to_string(pointers.size()) + "] is not a PolygonMesh");
    }
    pointers.push_back(mesh.cast<std::shared_ptr<PolygonMesh>>());
  }
  return pointers;
}

// All that a scene is prepared from, without a Python object.
struct Preparation {
  std::vector<MeshPointer> meshes;
  PrepareOptions options;
  std::shared_ptr<Prepared> previous;

  std::shared_ptr<Prepared> operator()(const Progress& progress) const {
    // pybind11 holds no pointers to const; nothing that it is told of changes a scene.
    return std::const_pointer_cast<Prepared>(prepare(meshes, options, previous.get(), progress));
  }
};

Preparation preparation_of(const py::iterable& meshes, const std::optional<PrepareOptions>& options,
                           const std::shared_ptr<Prepared>& previous) {
  return {read_meshes(meshes), options.value_or(PrepareOptions{}), previous};
}

std::shared_ptr<Prepared> prepare_meshes(const py::iterable& meshes,
                                         const std::optional<PrepareOptions>& options,
                                         const py::object& progress,
                                         const std::shared_ptr<Prepared>& previous) {
  const Preparation preparation = preparation_of(meshes, options, previous);
  const Progress reported = progress_of(progress);
  const py::gil_scoped_release release;
  return preparation(reported);
}

JobPointer start_preparing(const py::iterable& meshes, const std::optional<PrepareOptions>& options,
                           const std::shared_ptr<Prepared>& previous) {
  return start_job(preparation_of(meshes, options, previous));
}

FieldHandle solve(const Prepared& prepared, const std::optional<PrepareOptions>& options,
                  const py::object& progress) {
  const Progress reported = progress_of(progress);
  const py::gil_scoped_release release;
  const PrepareOptions used = options.value_or(PrepareOptions{});
  validate(used);
  FieldOptions field_options = used.cross_field;
  field_options.threads = used.threads;
  const Curvature& curvature = prepared.hatch_curvature(reported.part(0, 0.2));
  FieldAids aids;
  if (needs_tree(field_options)) aids.bvh = &prepared.bvh();
  return {std::make_shared<const CrossField>(solve_cross_field(
      prepared.surface(), curvature, field_options, aids, reported.part(0.2, 1, "field")))};
}

}  // namespace

void bind_prepare(py::module_& m) {
  using namespace py::literals;
  bind_surface(m);
  bind_field(m);
  bind_hatch_curves(m);
  py::class_<Prepared, std::shared_ptr<Prepared>>(
      m, "Prepared", "Everything of a scene that does not depend on the view. Immutable.")
      .def_property_readonly("surface",
                             [](const std::shared_ptr<Prepared>& p) { return SurfaceHandle{p}; })
      .def_property_readonly("field",
                             [](const std::shared_ptr<Prepared>& p) { return field_of(p); })
      .def_property_readonly("left_out_intersections", &left_out_intersections_of)
      .def_property_readonly("hatch_curves", &hatch_curves_of)
      .def_property_readonly("report", &report_of)
      .def_property_readonly("reports", &reports_of)
      .def_property_readonly("timings", &Prepared::timings);
  const py::none none;
  m.def("prepare", &prepare_meshes, "meshes"_a, "options"_a = none, "progress"_a = none,
        "previous"_a = none, "Meshes to what every view of them needs.");
  m.def("start_prepare", &start_preparing, "meshes"_a, "options"_a = none, "previous"_a = none,
        "The same as a Job.");
  m.def("solve_cross_field", &solve, "prepared"_a, "options"_a = none, "progress"_a = none,
        "The cross field of a prepared surface, with the field's own options.");
}

}  // namespace illustrate::bindings
