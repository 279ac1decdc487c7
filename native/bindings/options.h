// Options as Python objects with attributes and a constructor by keyword.
#pragma once

#include <pybind11/pybind11.h>

namespace illustrate::bindings {

namespace py = pybind11;

// Options made with their defaults and then the keywords set as attributes; TypeError for a name
// that is none.
template <class Options>
Options from_keywords(const py::kwargs& keywords) {
  Options options;
  // A view of `options` that is gone before they are: by its properties a keyword is read and
  // refused like an attribute.
  const py::object object = py::cast(&options, py::return_value_policy::reference);
  const py::object type = py::type::of(object);
  for (const auto& [name, value] : keywords) {
    if (!py::hasattr(type, name)) {
      throw py::type_error(std::string(py::str(type.attr("__name__"))) + " has no option '" +
                           std::string(py::str(name)) + "'");
    }
    py::setattr(object, name, value);
  }
  return options;
}

// A property for a member reached by `get(options)`, which returns a reference.
template <class Class, class Get>
void option(Class& bound, const char* name, Get get, const char* doc) {
  using Options = typename Class::type;
  using Value = std::decay_t<decltype(get(std::declval<Options&>()))>;
  bound.def_property(
      name, [get](Options& options) -> Value { return get(options); },
      [get](Options& options, const Value& value) { get(options) = value; }, doc);
}

}  // namespace illustrate::bindings
