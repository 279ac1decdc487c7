// The words that stand for enumerations in options.
#pragma once

#include "bindings/arrays.h"
#include "hatch/greedy/place_hatches.h"
#include "mesh/polygon_mesh.h"
#include "pipeline/draw.h"

namespace illustrate::bindings {

// 'auto', 'catmull-clark', 'loop' or 'none'; throws InvalidInput for anything else.
Scheme read_scheme(const py::object& value, const std::string& name);
const char* name_of(Scheme scheme);

// 'labels' or 'vote'; throws InvalidInput for anything else.
VisibilityMethod read_visibility(const py::object& value, const std::string& name);
const char* name_of(VisibilityMethod method);

// 'surface-curves' or 'critical-curves'; throws InvalidInput for anything else.
HatchSeeding read_seeding(const py::object& value, const std::string& name);
const char* name_of(HatchSeeding seeding);

// 'lines', 'draft' or 'whole'; throws InvalidInput for anything else.
Detail read_detail(const py::object& value);

}  // namespace illustrate::bindings
