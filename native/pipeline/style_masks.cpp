#include "pipeline/style_masks.h"

#include <algorithm>

namespace illustrate {
namespace {

template <class Value>
std::vector<Value> of_each(const std::vector<ObjectStyle>& styles,
                           Value (*value)(const ObjectStyle&)) {
  std::vector<Value> values;
  for (const ObjectStyle& style : styles) values.push_back(value(style));
  return values;
}

}  // namespace

Mask unhatched_objects(const std::vector<ObjectStyle>& styles) {
  return of_each<std::uint8_t>(styles, [](const ObjectStyle& s) -> std::uint8_t {
    return s.ignore || s.occlude_only || !s.hatching;
  });
}

Mask undrawn_objects(const std::vector<ObjectStyle>& styles) {
  return of_each<std::uint8_t>(styles, [](const ObjectStyle& s) -> std::uint8_t {
    return s.ignore || s.occlude_only || s.shadow_catcher || !s.lines;
  });
}

Mask shadow_catchers(const std::vector<ObjectStyle>& styles) {
  return of_each<std::uint8_t>(
      styles, [](const ObjectStyle& s) -> std::uint8_t { return s.shadow_catcher; });
}

// Of which the loose edges are drawn.
Mask loose_objects(const DrawOptions& options, std::size_t count) {
  Mask wanted(count, options.loose_edges);
  const Mask undrawn = undrawn_objects(options.styles);
  for (std::size_t i = 0; i < options.styles.size(); ++i)
    wanted[i] = !undrawn[i] && (wanted[i] || options.styles[i].loose_edges);
  return wanted;
}

std::vector<double> spacing_scales(const std::vector<ObjectStyle>& styles) {
  return of_each<double>(styles, [](const ObjectStyle& s) { return s.spacing_scale; });
}

std::vector<double> width_scales(const std::vector<ObjectStyle>& styles) {
  return of_each<double>(styles, [](const ObjectStyle& s) { return s.width_scale; });
}

bool anything_is_hatched(const DrawOptions& options) {
  const Mask unhatched = unhatched_objects(options.styles);
  return options.hatching &&
         (unhatched.empty() || std::find(unhatched.begin(), unhatched.end(), 0) != unhatched.end());
}

}  // namespace illustrate
