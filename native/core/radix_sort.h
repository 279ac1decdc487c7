// Sorting by whole numbers in linear time.
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace illustrate {

// Sorts by key(value), a std::uint64_t of at most `bits` bits; values with equal keys stay in the
// order they came.
template <class T, class Key>
void radix_sort(std::vector<T>& values, int bits, const Key& key) {
  constexpr int digit_bits = 11;
  constexpr std::size_t digits = std::size_t{1} << digit_bits;
  std::vector<T> sorted(values.size());
  std::vector<std::size_t> places(digits);
  for (int shift = 0; shift < bits; shift += digit_bits) {
    const auto digit = [&](const T& value) {
      return static_cast<std::size_t>(key(value) >> shift & (digits - 1));
    };
    places.assign(digits, 0);
    for (const T& value : values) ++places[digit(value)];
    std::size_t next = 0;
    for (std::size_t& place : places) next += std::exchange(place, next);
    for (const T& value : values) sorted[places[digit(value)]++] = value;
    std::swap(values, sorted);
  }
}

}  // namespace illustrate
