// DrawOptions as Python sees them.
#pragma once

#include "bindings/arrays.h"
#include "pipeline/options.h"

namespace illustrate::bindings {

// Keeps the caller's own list of styles, so that changes to the list and its members count.
struct PythonDrawOptions {
  DrawOptions values;
  py::object styles = py::none();
};

// With the styles read from the list. Throws InvalidInput for a member that is no ObjectStyle.
DrawOptions read_draw_options(const PythonDrawOptions& options);

}  // namespace illustrate::bindings
