#include "bindings/names.h"

#include "core/errors.h"

namespace illustrate::bindings {
namespace {

// In the order of Scheme.
constexpr std::array<const char*, 4> scheme_names{"auto", "catmull-clark", "loop", "none"};
// In the order of HatchSeeding.
constexpr std::array<const char*, 2> seeding_names{"surface-curves", "critical-curves"};

}  // namespace

Scheme read_scheme(const py::object& value, const std::string& name) {
  const std::string word = py::str(value);
  for (std::size_t i = 0; i < scheme_names.size(); ++i) {
    if (word == scheme_names[i]) return static_cast<Scheme>(i);
  }
  throw InvalidInput(name + " is '" + word +
                     "', expected 'auto', 'catmull-clark', 'loop' or 'none'");
}

const char* name_of(Scheme scheme) { return scheme_names[static_cast<std::size_t>(scheme)]; }

HatchSeeding read_seeding(const py::object& value, const std::string& name) {
  const std::string word = py::str(value);
  for (std::size_t i = 0; i < seeding_names.size(); ++i) {
    if (word == seeding_names[i]) return static_cast<HatchSeeding>(i);
  }
  throw InvalidInput(name + " is '" + word + "', expected 'surface-curves' or 'critical-curves'");
}

const char* name_of(HatchSeeding seeding) {
  return seeding_names[static_cast<std::size_t>(seeding)];
}

}  // namespace illustrate::bindings
