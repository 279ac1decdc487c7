// A value that is made by the first who asks for it.
#pragma once

#include <memory>
#include <mutex>

namespace illustrate {

// Safe between threads, and for a maker that asks for the same value again. A maker that throws
// leaves nothing behind.
template <class T>
class Lazy {
 public:
  template <class Maker>
  const T& get(Maker&& make) {
    const std::lock_guard<std::recursive_mutex> lock(mutex_);
    if (!value_) {
      auto made = std::make_unique<const T>(make());
      if (!value_) value_ = std::move(made);
    }
    return *value_;
  }

  // Null where nobody has asked yet.
  const T* peek() {
    const std::lock_guard<std::recursive_mutex> lock(mutex_);
    return value_.get();
  }

 private:
  std::recursive_mutex mutex_;
  std::unique_ptr<const T> value_;
};

}  // namespace illustrate
