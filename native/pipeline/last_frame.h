// What was found in an earlier frame, or with other options, for results that are not made yet.
#pragma once

#include <memory>
#include <mutex>

#include "core/lazy.h"
#include "field/joined_field.h"

namespace illustrate {

// What an original has of an earlier frame.
struct Earlier {
  int object = none;     // of the surface then: the one that it may be
  bool is_kept = false;  // it is that one, and has moved as a rigid body
  Similarity step;       // so
};
using EarlierObjects = std::vector<Earlier>;  // (originals)

// Of an earlier frame, from what the frame between has of it.
EarlierObjects composed(const EarlierObjects& now, const EarlierObjects& between);

bool keeps_any(const EarlierObjects& earlier);

// Surface 0: that of the earlier frame; 1: that of what is not kept.
ObjectSources sources_of(const EarlierObjects& earlier);

struct LastFrame {
  std::shared_ptr<const Surface> surface;  // of the originals then; a guided field: of all objects
  EarlierObjects earlier;                  // empty: the objects may be those of the same numbers
  // What is kept has the results that it had; else they are at most where a search may start.
  bool holds = false;
  std::shared_ptr<Lazy<Curvature>> curvature;
  std::shared_ptr<Lazy<CrossField>> field;  // solved where it is not null
  // By the time that they are wanted here, the frame has them, or does without.
  std::shared_ptr<Lazy<Families>> families, diagonal_families;

  // Which originals results have to be found for: those that are not kept, or all where nothing
  // holds; and what each of those may have been.
  std::vector<int> fresh_originals() const;
  std::vector<int> last_objects() const;

  // The surface of those that are not kept, from that of all; made once.
  const Surface& fresh_surface(const Surface& originals) const;

  // Of those that are not kept, from that of all.
  template <class Result>
  Result of_fresh(const Result& result, const Surface& originals) const {
    const std::vector<const Result*> all{&result};
    return joined(all, {&originals}, objects_as_they_are(fresh_originals()));
  }
  // Of all, from that of the frame and that of what is not kept.
  template <class Result>
  Result renewed(const Result& last, const Result& fresh, const Surface& originals) const {
    const std::vector<const Result*> both{&last, &fresh};
    return joined(both, {surface.get(), &fresh_surface(originals)}, sources_of(earlier));
  }

 private:
  mutable Lazy<Surface> fresh_;
};

// A frame that is held until what is wanted of it is made. Safe between threads.
class HeldFrame {
 public:
  std::shared_ptr<const LastFrame> get() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return frame_;
  }
  void hold(std::shared_ptr<const LastFrame> frame) {
    const std::lock_guard<std::mutex> lock(mutex_);
    frame_ = std::move(frame);
  }
  void release() { hold(nullptr); }

 private:
  mutable std::mutex mutex_;
  std::shared_ptr<const LastFrame> frame_;
};

}  // namespace illustrate
