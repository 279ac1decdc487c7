#include "hatch/streamlines/streamline.h"

#include <algorithm>

namespace illustrate {

void turn(std::vector<StreamlineNode>& nodes) {
  std::reverse(nodes.begin(), nodes.end());
  for (StreamlineNode& node : nodes) turn(node);
}

double length_of(const std::vector<StreamlineNode>& nodes) {
  double length = 0;
  for (std::size_t i = 1; i < nodes.size(); ++i) {
    length += (nodes[i].image - nodes[i - 1].image).norm();
  }
  return length;
}

bool any_is_held(const std::vector<StreamlineNode>& nodes) {
  return std::any_of(nodes.begin(), nodes.end(),
                     [](const StreamlineNode& node) { return node.is_held; });
}

}  // namespace illustrate
