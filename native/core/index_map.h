// From indices to indices, where an ordinary table would be far too large for the few that are set.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/types.h"

namespace illustrate {

// A hash table that is at most half full, with linear probing. Keys are >= 0.
class IndexMap {
 public:
  explicit IndexMap(std::size_t expected = 0) {
    while (size() < 2 * expected) --shift_;
    entries_.resize(size());
  }

  // none where nothing was set.
  int operator[](int key) const { return entries_[place_of(key)].value; }

  // To read and to set; none at first. Stays valid until the next call.
  int& at(int key) {
    std::size_t place = place_of(key);
    if (entries_[place].key == none) {
      if (2 * ++used_ > entries_.size()) {
        double_size();
        place = place_of(key);
      }
      entries_[place].key = key;
    }
    return entries_[place].value;
  }

 private:
  struct Entry {
    int key = none;
    int value = none;
  };

  // Of the entry that holds the key, or of a free one.
  std::size_t place_of(int key) const {
    std::size_t place = (static_cast<std::uint32_t>(key) * 2654435769U) >> shift_;
    while (entries_[place].key != none && entries_[place].key != key) {
      place = (place + 1) & (entries_.size() - 1);
    }
    return place;
  }

  std::size_t size() const { return std::size_t{1} << (hash_bits - shift_); }

  void double_size() {
    --shift_;
    std::vector<Entry> old(size());
    old.swap(entries_);
    for (const Entry& entry : old) {
      if (entry.key != none) entries_[place_of(entry.key)] = entry;
    }
  }

  static constexpr int hash_bits = 32;

  std::vector<Entry> entries_;
  int shift_ = 28;  // of the hash
  std::size_t used_ = 0;
};

}  // namespace illustrate
