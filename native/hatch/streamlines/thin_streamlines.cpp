#include "hatch/streamlines/thin_streamlines.h"

#include <algorithm>

namespace illustrate {
namespace {

// In spacings: the longest streamlines that may go, and how near others pass them; places beside
// them that are looked at too.
constexpr double most_length = 6;
constexpr double least_reach = 0.85;
constexpr double probe_step = 0.5;

// Streamlines that end so near to critical curves at both ends, in spacings, are as long as can be.
constexpr double end_reach = 0.75;

class Thinner {
 public:
  Thinner(StreamlineSet& set, const HatchView& view, double reach)
      : set_(set), view_(view), reach_(reach), stays_(set.streamlines.size(), 1) {}

  void thin() {
    for (const auto& [length, number] : short_ones()) {
      const double share = length / most_length;
      if (is_needless(number, (1 - share) * reach_ + share * least_reach)) stays_[idx(number)] = 0;
    }
    for (std::size_t s = 0; s < stays_.size(); ++s) {
      if (!stays_[s]) set_.streamlines[s].nodes.clear();
    }
    set_.rebuild();
  }

 private:
  // Lengths in spacings, with numbers.
  std::vector<std::pair<double, int>> short_ones() const {
    std::vector<std::pair<double, int>> result;
    for (std::size_t s = 0; s < set_.streamlines.size(); ++s) {
      const Streamline& streamline = set_.streamlines[s];
      const double length = length_of(streamline.nodes) / streamline.spacing;
      if (length < most_length && !is_whole(streamline) && !any_is_held(streamline.nodes))
        result.emplace_back(length, static_cast<int>(s));
    }
    std::sort(result.begin(), result.end());
    return result;
  }

  bool is_whole(const Streamline& streamline) const {
    const auto ends = [&](const StreamlineNode& node, double way) {
      const Vec2 outward = way * end_reach * streamline.spacing * node.heading;
      return view_.curves.separate(node.image, node.image + outward);
    };
    return ends(streamline.nodes.front(), -1) && ends(streamline.nodes.back(), 1);
  }

  bool is_needless(int number, double reach) const {
    const Streamline& streamline = set_.streamlines[idx(number)];
    return std::all_of(
        streamline.nodes.begin(), streamline.nodes.end(), [&](const StreamlineNode& node) {
          const Vec2 aside = probe_step * streamline.spacing * node.left();
          return is_covered(node, Vec2::Zero(), number, reach) &&
                 is_covered(node, aside, number, reach) && is_covered(node, -aside, number, reach);
        });
  }

  // Whether another streamline passes near a place beside the node, on its side of all critical
  // curves.
  bool is_covered(StreamlineNode node, const Vec2& aside, int number, double reach) const {
    const Vec2 image = node.image;
    const double spacing = set_.streamlines[idx(number)].spacing, radius = reach * spacing;
    node.image += std::min(1.0, view_.curves.first_crossing(image, image + aside)) * aside;
    return set_.grid.any_near(node.image, radius, [&](const GridNode& other) {
      return other.streamline != number && stays_[idx(other.streamline)] &&
             HatchView::distance(node, other, spacing, radius) < radius &&
             !view_.curves.separate(image, other.image);
    });
  }

  StreamlineSet& set_;
  const HatchView& view_;
  double reach_;
  std::vector<std::uint8_t> stays_;
};

}  // namespace

void thin_streamlines(StreamlineSet& set, const HatchView& view, double reach) {
  Thinner(set, view, reach).thin();
}

}  // namespace illustrate
