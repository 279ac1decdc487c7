// How long work tells its caller how far it is, and learns that it should stop.
//
// A Progress covers a part [from, to] of the whole; a stage divides its own part further with
// `part`. Only the calling thread may call it. `report` throws Cancelled when the caller's function
// returns false; whatever that function throws passes through. Call it every few milliseconds of
// work.
#pragma once

#include <functional>
#include <string>

namespace illustrate {

class Progress {
 public:
  using Callback = std::function<bool(double fraction, const std::string& stage)>;

  Progress() = default;
  Progress(Callback callback, std::string stage)
      : callback_(std::move(callback)), stage_(std::move(stage)) {}

  // fraction: of this part, in [0, 1].
  void report(double fraction) const;

  // The part [from, to] of this part, in [0, 1]; an empty name keeps the stage's name.
  Progress part(double from, double to, const std::string& stage = "") const;

 private:
  Callback callback_;
  std::string stage_;
  double from_ = 0;
  double to_ = 1;
};

}  // namespace illustrate
