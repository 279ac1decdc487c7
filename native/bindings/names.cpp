#include "bindings/names.h"

#include "core/errors.h"

namespace illustrate::bindings {
namespace {

// In the order of the enumerations.
constexpr std::array<const char*, 4> scheme_names{"auto", "catmull-clark", "loop", "none"};
constexpr std::array<const char*, 2> seeding_names{"surface-curves", "critical-curves"};
constexpr std::array<const char*, 2> visibility_names{"labels", "vote"};
constexpr std::array<const char*, 3> detail_names{"lines", "draft", "whole"};

template <class Enumeration, std::size_t count>
Enumeration read_word(const py::object& value, const std::string& name,
                      const std::array<const char*, count>& words) {
  const std::string word = py::str(value);
  std::string expected;
  for (std::size_t i = 0; i < count; ++i) {
    if (word == words[i]) return static_cast<Enumeration>(i);
    expected += (i == 0 ? "'" : i + 1 == count ? " or '" : ", '") + std::string(words[i]) + "'";
  }
  throw InvalidInput(name + " is '" + word + "', expected " + expected);
}

}  // namespace

Scheme read_scheme(const py::object& value, const std::string& name) {
  return read_word<Scheme>(value, name, scheme_names);
}

const char* name_of(Scheme scheme) { return scheme_names[static_cast<std::size_t>(scheme)]; }

VisibilityMethod read_visibility(const py::object& value, const std::string& name) {
  return read_word<VisibilityMethod>(value, name, visibility_names);
}

const char* name_of(VisibilityMethod method) {
  return visibility_names[static_cast<std::size_t>(method)];
}

HatchSeeding read_seeding(const py::object& value, const std::string& name) {
  return read_word<HatchSeeding>(value, name, seeding_names);
}

const char* name_of(HatchSeeding seeding) {
  return seeding_names[static_cast<std::size_t>(seeding)];
}

Detail read_detail(const py::object& value) {
  return read_word<Detail>(value, "detail", detail_names);
}

}  // namespace illustrate::bindings
