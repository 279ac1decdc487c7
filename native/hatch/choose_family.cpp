#include "hatch/choose_family.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numeric>
#include <queue>
#include <utility>

namespace illustrate {
namespace {

// How far the form speaks: over about the square root of so many links.
constexpr int spreading_rounds = 100;

// Each round mends what the last one left; a few are enough.
constexpr int settling_rounds = 8;

class Chooser {
 public:
  Chooser(const Ragged<FamilyLink>& links, const std::vector<double>& preference)
      : links_(links),
        form_(preference),
        side_(links.size(), 0),
        votes_(links.size(), 0),
        all_votes_(links.size(), 0) {
    for (std::size_t piece = 0; piece < links.size(); ++piece) {
      for (const FamilyLink& link : links[piece]) all_votes_[piece] += std::abs(link.weight);
    }
  }

  FamilyChoice choose() {
    spread_form();
    std::vector<int> firsts(side_.size());
    std::iota(firsts.begin(), firsts.end(), 0);
    std::stable_sort(firsts.begin(), firsts.end(),
                     [&](int a, int b) { return std::abs(form_[a]) > std::abs(form_[b]); });
    for (const int first : firsts) {
      if (side_[first] == 0) grow(first);
    }
    settle();
    FamilyChoice choice;
    for (const int side : side_) choice.is_kept.push_back(side > 0);
    choice.order = std::move(order_);
    return choice;
  }

 private:
  // Averages what the form asks for over links, again and again.
  void spread_form() {
    std::vector<double> next(form_.size());
    for (int round = 0; round < spreading_rounds; ++round) {
      for (std::size_t piece = 0; piece < form_.size(); ++piece) {
        const int own_weight = std::max(1, all_votes_[piece]);
        double sum = own_weight * form_[piece];
        for (const FamilyLink& link : links_[piece]) sum += link.weight * form_[link.other];
        next[piece] = sum / (own_weight + all_votes_[piece]);
      }
      form_.swap(next);
    }
  }

  // In [-2, 2]: what decided pieces and the form ask for, > 0 to keep the piece.
  double wish(int piece) const {
    return votes_[piece] / std::max(1.0, double(all_votes_[piece])) + form_[piece];
  }

  void put(int piece, int side) {
    const int change = side - side_[piece];
    side_[piece] = side;
    for (const FamilyLink& link : links_[piece]) votes_[link.other] += change * link.weight;
  }

  // All that links to `first`. Entries of the queue whose wish has changed since are passed over.
  void grow(int first) {
    std::priority_queue<std::pair<double, int>> queue;
    const auto enter = [&](int piece) { queue.push({std::abs(wish(piece)), -piece}); };
    enter(first);
    while (!queue.empty()) {
      const auto [urgency, negative] = queue.top();
      queue.pop();
      const int piece = -negative;
      if (side_[piece] != 0 || urgency != std::abs(wish(piece))) continue;
      put(piece, wish(piece) < 0 ? -1 : 1);
      order_.push_back(piece);
      for (const FamilyLink& link : links_[piece]) {
        if (side_[link.other] == 0) enter(link.other);
      }
    }
  }

  void settle() {
    bool changed = true;
    for (int round = 0; changed && round < settling_rounds; ++round) {
      changed = false;
      for (const int piece : order_) {
        if (wish(piece) * side_[piece] >= 0) continue;
        put(piece, -side_[piece]);
        changed = true;
      }
    }
  }

  const Ragged<FamilyLink>& links_;
  std::vector<double> form_;    // of each piece: what the form asks for, > 0 to keep it
  std::vector<int> side_;       // of each piece: 1 kept, -1 deleted, 0 not decided
  std::vector<int> votes_;      // sum of weight * side over its links
  std::vector<int> all_votes_;  // sum of |weight|
  std::vector<int> order_;
};

}  // namespace

FamilyChoice choose_family(const Ragged<FamilyLink>& links, const std::vector<double>& preference) {
  return Chooser(links, preference).choose();
}

}  // namespace illustrate
