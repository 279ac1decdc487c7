// What each file of the bindings adds to the module, and how they call the core.
#pragma once

#include <pybind11/pybind11.h>

#include <algorithm>
#include <memory>

#include "core/errors.h"
#include "core/progress.h"

namespace illustrate::bindings {

namespace py = pybind11;

void bind_jobs(py::module_& m);     // Job, stop_jobs
void bind_mesh(py::module_& m);     // Kind, Node, PolygonMesh, Camera, Light
void bind_options(py::module_& m);  // PrepareOptions, DrawOptions, ObjectStyle
void bind_prepare(py::module_& m);  // Surface, CrossField, Prepared, prepare, solve_cross_field
void bind_draw(py::module_& m);     // Drawing and its parts, draw, silhouettes
void bind_picture(py::module_& m);  // rasterise

// Calls `callback(fraction, stage)` with the GIL taken; it must outlive what is returned. None:
// nothing is called. A callback that returns None goes on. The fractions it is told never fall,
// though stages estimate theirs.
inline Progress progress_of(const py::object& callback) {
  if (callback.is_none()) return {};
  if (!PyCallable_Check(callback.ptr())) {
    throw InvalidInput("progress must be a function of (fraction, stage)");
  }
  const py::handle function = callback;
  return {
      [function, highest = std::make_shared<double>(0)](double fraction, const std::string& stage) {
        const py::gil_scoped_acquire gil;
        *highest = std::max(*highest, fraction);
        const py::object answer = function(*highest, stage);
        const int goes_on = answer.is_none() ? 1 : PyObject_IsTrue(answer.ptr());
        if (goes_on < 0) throw py::error_already_set();
        return goes_on == 1;
      },
      ""};
}

}  // namespace illustrate::bindings
