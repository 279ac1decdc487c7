// DrawOptions as Python sees them.
#pragma once

#include "bindings/arrays.h"
#include "pipeline/options.h"

namespace illustrate::bindings {

// Keeps the caller's own list of styles and image, so that changes to what they hold count.
struct PythonDrawOptions {
  DrawOptions values;
  py::object styles = py::none();
  py::object tone_image = py::none();
};

// With styles and image read. Throws InvalidInput for a member of the list that is no ObjectStyle,
// and an image that is none.
DrawOptions read_draw_options(const PythonDrawOptions& options);

}  // namespace illustrate::bindings
