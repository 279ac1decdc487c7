#include "stroke/specks.h"

#include <algorithm>

namespace illustrate {
namespace {

double image_length(const LabelledGraph& graph, const Chain& chain) {
  double length = 0;
  for (const int arc : chain.arcs) length += image_length(graph, arc);
  return length;
}

// Drops dangling specks one after another: dropping one may leave the next dangling.
class SpeckFilter {
 public:
  SpeckFilter(const LabelledGraph& graph, const std::vector<Chain>& chains,
              const Ragged<ArcEnd>& ends)
      : graph_(graph),
        chains_(chains),
        ends_(ends),
        chain_of_(graph.arcs.size(), none),
        kept_(chains.size(), 1) {
    for (std::size_t c = 0; c < chains.size(); ++c) {
      for (const int arc : chains[c].arcs) chain_of_[idx(arc)] = static_cast<int>(c);
    }
  }

  std::vector<std::uint8_t> drop(double speck_px) {
    std::vector<std::size_t> specks;
    for (std::size_t c = 0; c < chains_.size(); ++c) {
      if (image_length(graph_, chains_[c]) < speck_px) specks.push_back(c);
    }
    for (bool changed = true; changed;) {
      changed = false;
      for (const std::size_t c : specks) {
        if (!kept_[c] || closes_a_gap(c)) continue;
        kept_[c] = 0;
        changed = true;
      }
    }
    return kept_;
  }

 private:
  static constexpr double slit_units = 1;

  bool closes_a_gap(std::size_t c) const {
    const Chain& chain = chains_[c];
    if (!chain.closed) {
      return meets_another(c, chain.start_node) && meets_another(c, chain.end_node) &&
             !is_in_a_slit(chain);
    }
    return std::any_of(chain.arcs.begin(), chain.arcs.end(), [&](int arc) {
      const int node = graph_.arcs[idx(arc)].start_node;
      return node != none && meets_another(c, node);
    });
  }

  // Whether it shows between two curves that pass in front of it, hardly apart.
  bool is_in_a_slit(const Chain& chain) const {
    const auto passes_behind = [&](int arc, int at) {
      const GraphNode& n = graph_.nodes[idx(at)];
      return n.kind == NodeKind::crossing && (n.arcs[2] == arc || n.arcs[3] == arc);
    };
    return image_length(graph_, chain) < slit_units * graph_.unit_px &&
           passes_behind(chain.arcs.front(), chain.start_node) &&
           passes_behind(chain.arcs.back(), chain.end_node);
  }

  bool meets_another(std::size_t c, int node) const {
    const int layers = layers_over(graph_.arcs[idx(chains_[c].arcs[0])]);
    for (const ArcEnd& end : ends_[idx(node)]) {
      const int other = chain_of_[idx(end.arc)];
      const bool is_kept = other != static_cast<int>(c) && kept_[idx(other)];
      if (is_kept && layers_over(graph_.arcs[idx(end.arc)]) <= layers) return true;
    }
    return false;
  }

  const LabelledGraph& graph_;
  const std::vector<Chain>& chains_;
  const Ragged<ArcEnd>& ends_;
  std::vector<int> chain_of_;
  std::vector<std::uint8_t> kept_;
};

}  // namespace

std::vector<std::uint8_t> chains_without_specks(const LabelledGraph& graph,
                                                const std::vector<Chain>& chains,
                                                const Ragged<ArcEnd>& ends, double speck_px) {
  return SpeckFilter(graph, chains, ends).drop(speck_px);
}

}  // namespace illustrate
