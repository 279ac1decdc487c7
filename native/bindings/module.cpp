// The Python module `illustrate_native._core`.
#include "bindings/bind.h"

PYBIND11_MODULE(_core, m) {
  namespace py = pybind11;
  using namespace illustrate;
  m.doc() = "Line illustrations of smooth surfaces: the native core.";
  py::register_exception<InvalidInput>(m, "InvalidInput", PyExc_ValueError);
  py::register_exception<Cancelled>(m, "Cancelled", PyExc_RuntimeError);
  // Types before the functions that take them: pybind11 writes signatures when it binds.
  bindings::bind_jobs(m);
  bindings::bind_mesh(m);
  bindings::bind_options(m);
  bindings::bind_prepare(m);
  bindings::bind_draw(m);
  bindings::bind_picture(m);
}
