#include "contour/exact/steady_signs.h"

#include <algorithm>
#include <array>

namespace illustrate {

std::vector<int> steady_signs(const std::vector<double>& numbers, double price) {
  std::vector<std::array<bool, 2>> changes;  // before each number, to - and to +
  std::array<double, 2> cost{0, 0};          // of the best ways that end with - and with +
  for (const double number : numbers) {
    changes.push_back({cost[1] + price < cost[0], cost[0] + price < cost[1]});
    cost = {std::min(cost[0], cost[1] + price) + std::max(number, 0.0),
            std::min(cost[1], cost[0] + price) + std::max(-number, 0.0)};
  }
  std::vector<int> signs(numbers.size());
  std::size_t sign = cost[1] <= cost[0] ? 1 : 0;
  for (std::size_t i = numbers.size(); i-- > 0;) {
    signs[i] = sign == 1 ? 1 : -1;
    if (changes[i][sign]) sign = 1 - sign;
  }
  return signs;
}

}  // namespace illustrate
