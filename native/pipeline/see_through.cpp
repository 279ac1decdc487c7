#include "pipeline/see_through.h"

#include <algorithm>

namespace illustrate {
namespace {

template <class T>
void append(std::vector<T>& values, const std::vector<T>& more) {
  values.insert(values.end(), more.begin(), more.end());
}

void append(Drawing& drawing, const Drawing& more) {
  const int points = drawing.offsets.back();
  for (std::size_t s = 1; s < more.offsets.size(); ++s) {
    drawing.offsets.push_back(points + more.offsets[s]);
  }
  append(drawing.points, more.points);
  append(drawing.image, more.image);
  append(drawing.widths, more.widths);
  append(drawing.on, more.on);
  append(drawing.kinds, more.kinds);
  append(drawing.closed, more.closed);
  append(drawing.objects, more.objects);
  append(drawing.invisibility, more.invisibility);
  append(drawing.pens, more.pens);
}

}  // namespace

bool any_is_seen_through(const std::vector<ObjectStyle>& styles) {
  return std::any_of(styles.begin(), styles.end(),
                     [](const ObjectStyle& s) { return s.see_through && !s.ignore; });
}

DrawOptions without_glass(DrawOptions options) {
  for (ObjectStyle& style : options.styles) {
    style.ignore |= style.see_through;
    style.see_through = false;
  }
  return options;
}

DrawOptions glass_alone(DrawOptions options) {
  options.hatching = false;
  for (ObjectStyle& style : options.styles) {
    style.occlude_only |= !style.see_through;
    style.see_through = false;
  }
  return options;
}

void add_glass(DrawResult& result, const DrawResult& glass) {
  append(result.drawing, glass.drawing);
  for (const auto& [name, count] : glass.counts) result.counts[name] += count;
  for (const auto& [name, seconds] : glass.timings) result.timings[name] += seconds;
}

}  // namespace illustrate
