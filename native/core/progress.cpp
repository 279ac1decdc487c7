#include "core/progress.h"

#include <algorithm>

#include "core/errors.h"

namespace illustrate {

void Progress::report(double fraction) const {
  if (!callback_) return;
  const double whole = from_ + (to_ - from_) * std::clamp(fraction, 0.0, 1.0);
  if (!callback_(whole, stage_)) throw Cancelled();
}

Progress Progress::part(double from, double to, const std::string& stage) const {
  Progress result = *this;
  result.from_ = from_ + (to_ - from_) * from;
  result.to_ = from_ + (to_ - from_) * to;
  if (!stage.empty()) result.stage_ = stage;
  return result;
}

}  // namespace illustrate
