#include "pipeline/last_frame.h"

#include <algorithm>

namespace illustrate {

EarlierObjects composed(const EarlierObjects& now, const EarlierObjects& between) {
  EarlierObjects result;
  for (const Earlier& original : now) {
    if (original.object == none) {
      result.emplace_back();
      continue;
    }
    const Earlier& before = between[idx(original.object)];
    const bool rests = original.step == Similarity();
    result.push_back({before.object, original.is_kept && before.is_kept,
                      rests ? before.step : original.step * before.step});
  }
  return result;
}

bool keeps_any(const EarlierObjects& earlier) {
  return std::any_of(earlier.begin(), earlier.end(),
                     [](const Earlier& original) { return original.is_kept; });
}

ObjectSources sources_of(const EarlierObjects& earlier) {
  ObjectSources result;
  int fresh = 0;
  for (const Earlier& original : earlier) {
    if (original.is_kept) {
      result.push_back({0, original.object, original.step});
    } else {
      result.push_back({1, fresh++, {}});
    }
  }
  return result;
}

std::vector<int> LastFrame::fresh_originals() const {
  std::vector<int> result;
  for (std::size_t o = 0; o < earlier.size(); ++o) {
    if (!holds || !earlier[o].is_kept) result.push_back(static_cast<int>(o));
  }
  return result;
}

std::vector<int> LastFrame::last_objects() const {
  std::vector<int> result;
  for (const int original : fresh_originals()) result.push_back(earlier[idx(original)].object);
  return result;
}

const Surface& LastFrame::fresh_surface(const Surface& originals) const {
  return fresh_.get([&] { return joined({&originals}, objects_as_they_are(fresh_originals())); });
}

}  // namespace illustrate
