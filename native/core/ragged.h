// Many lists in two arrays: list i is values[offsets[i] .. offsets[i+1]).
#pragma once

#include <cstddef>
#include <numeric>
#include <vector>

namespace illustrate {

// A view of consecutive elements that somebody else owns.
template <class T>
struct Span {
  T* first = nullptr;
  std::size_t count = 0;

  T* begin() const { return first; }
  T* end() const { return first + count; }
  std::size_t size() const { return count; }
  bool empty() const { return count == 0; }
  T& operator[](std::size_t i) const { return first[i]; }
  T& front() const { return first[0]; }
  T& back() const { return first[count - 1]; }
};

template <class T>
struct Ragged {
  std::vector<T> values;
  std::vector<int> offsets{0};

  std::size_t size() const { return offsets.size() - 1; }
  bool empty() const { return size() == 0; }

  Span<const T> operator[](std::size_t i) const {
    const auto start = static_cast<std::size_t>(offsets[i]);
    return {values.data() + start, static_cast<std::size_t>(offsets[i + 1]) - start};
  }
  Span<T> operator[](std::size_t i) {
    const auto start = static_cast<std::size_t>(offsets[i]);
    return {values.data() + start, static_cast<std::size_t>(offsets[i + 1]) - start};
  }

  // Appends one value to the list that is being built; `close_list` ends that list.
  void push(const T& value) { values.push_back(value); }
  void close_list() { offsets.push_back(static_cast<int>(values.size())); }

  template <class Container>
  void add(const Container& list) {
    values.insert(values.end(), list.begin(), list.end());
    close_list();
  }
};

// Lists of values that come in any order; within a list they stay in it. put_all(put) calls
// put(list, value) for each of them, list in [0, count), and is called twice.
template <class T, class PutAll>
Ragged<T> sorted_into(std::size_t count, const PutAll& put_all) {
  Ragged<T> lists;
  std::vector<int>& offsets = lists.offsets;
  offsets.assign(count + 1, 0);
  put_all([&](int list, const T&) { ++offsets[static_cast<std::size_t>(list) + 1]; });
  std::partial_sum(offsets.begin(), offsets.end(), offsets.begin());
  lists.values.resize(static_cast<std::size_t>(offsets.back()));
  std::vector<int> next = offsets;
  put_all([&](int list, const T& value) {
    lists.values[static_cast<std::size_t>(next[static_cast<std::size_t>(list)]++)] = value;
  });
  return lists;
}

}  // namespace illustrate
