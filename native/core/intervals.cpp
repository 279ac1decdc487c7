#include "core/intervals.h"

#include <algorithm>

namespace illustrate {

Intervals joined(Intervals parts, double gap) {
  std::sort(parts.begin(), parts.end(),
            [](const Interval& a, const Interval& b) { return a.from < b.from; });
  Intervals result;
  for (const Interval& part : parts) {
    if (result.empty() || part.from > result.back().to + gap) {
      result.push_back(part);
    } else {
      result.back().to = std::max(result.back().to, part.to);
    }
  }
  return result;
}

Intervals common(const Intervals& a, const Intervals& b) {
  Intervals result;
  for (std::size_t i = 0, j = 0; i < a.size() && j < b.size();) {
    const Interval both{std::max(a[i].from, b[j].from), std::min(a[i].to, b[j].to)};
    if (both.from < both.to) result.push_back(both);
    ++(a[i].to < b[j].to ? i : j);
  }
  return result;
}

Intervals without(const Interval& whole, const Intervals& parts) {
  Intervals result;
  double from = whole.from;
  const auto add_until = [&](double to) {
    if (from < to) result.push_back({from, to});
  };
  for (const Interval& part : parts) {
    add_until(std::min(part.from, whole.to));
    from = std::max(from, part.to);
  }
  add_until(whole.to);
  return result;
}

}  // namespace illustrate
