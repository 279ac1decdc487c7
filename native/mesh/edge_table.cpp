#include "mesh/edge_table.h"

#include <algorithm>

namespace illustrate {

EdgeTable::EdgeTable(std::size_t vertex_count, const std::vector<Edge>& edges)
    : offsets_(edges.empty() ? 0 : vertex_count + 1, 0), entries_(edges.size()) {
  const auto smaller = [](const Edge& e) { return idx(std::min(e[0], e[1])); };
  for (const Edge& e : edges) ++offsets_[smaller(e) + 1];
  for (std::size_t v = 1; v < offsets_.size(); ++v) offsets_[v] += offsets_[v - 1];
  std::vector<int> cursor = offsets_;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const auto slot = idx(cursor[smaller(edges[i])]++);
    entries_[slot] = {std::max(edges[i][0], edges[i][1]), static_cast<int>(i)};
  }
  for (std::size_t v = 0; v + 1 < offsets_.size(); ++v) {
    std::sort(entries_.begin() + offsets_[v], entries_.begin() + offsets_[v + 1]);
  }
}

int EdgeTable::find(int a, int b) const {
  if (offsets_.empty()) return none;
  const auto [low, high] = std::minmax(a, b);
  const auto from = entries_.begin() + offsets_[idx(low)];
  const auto to = entries_.begin() + offsets_[idx(low) + 1];
  const auto found = std::lower_bound(from, to, std::array<int, 2>{high, 0});
  return found != to && (*found)[0] == high ? (*found)[1] : none;
}

std::vector<int> face_offsets(const std::vector<int>& face_sizes) {
  std::vector<int> offsets(face_sizes.size() + 1, 0);
  for (std::size_t f = 0; f < face_sizes.size(); ++f) offsets[f + 1] = offsets[f] + face_sizes[f];
  return offsets;
}

}  // namespace illustrate
