#include "field/families/signed_labels.h"

#include <algorithm>
#include <cmath>
#include <queue>

#include "core/parallel.h"
#include "core/types.h"

namespace illustrate {
namespace {

// Searches compete on a graph of at most so many nodes, each from its own start and in so many
// rounds down to a few nodes and back; the more the fewer nodes there are.
constexpr std::size_t middle_size = 4000;
constexpr int fewest_searches = 4;
constexpr int most_searches = 24;
constexpr int searches_in_vain = 10;  // in a row: no more follow
constexpr int rounds_of_search = 3;
constexpr std::size_t fewest_nodes = 16;

// Coarsening that saves less is not worth a level.
constexpr double least_saving = 0.05;

// Moves in a row that may leave a place worse than it was, and passes over all places.
constexpr int patience = 12;
constexpr int most_passes = 4;

// A gain, of the weights around, that rounding does not explain.
constexpr double least_gain = 1e-9;

// A part of more nodes is searched by itself and reports; of others each thread takes so many nodes
// at a time.
constexpr std::size_t large_part = 100000;
constexpr std::size_t nodes_at_a_time = 1000;

// Flips of single labels from node to node, taken back as far as they did not pay.
class Refiner {
 public:
  Refiner(const SignedGraph& graph, Labels& labels)
      : graph_(graph),
        labels_(labels),
        wishes_(graph.pulls),
        is_moved_(graph.size(), 0),
        is_fresh_(graph.size(), 1) {
    for (std::size_t i = 0; i < graph.size(); ++i) {
      double sum = std::abs(graph.pulls[i]);
      for (const SignedLink& link : graph.links[i]) {
        wishes_[i] += link.weight * labels[idx(link.node)];
        sum += std::abs(link.weight);
      }
      scale_ = std::max(scale_, sum);
    }
  }

  void refine() {
    bool any = true;
    for (int pass = 0; any && pass < most_passes; ++pass) {
      any = false;
      for (std::size_t i = 0; i < graph_.size(); ++i) {
        if (!is_fresh_[i] || !is_at_border(i)) continue;
        is_fresh_[i] = 0;
        if (search_from(static_cast<int>(i))) any = true;
      }
    }
  }

 private:
  // What flipping a label costs.
  double price(int node) const { return 2 * labels_[idx(node)] * wishes_[idx(node)]; }

  bool is_at_border(std::size_t i) const {
    if (labels_[i] * wishes_[i] < 0) return true;
    const auto links = graph_.links[i];
    return std::any_of(links.begin(), links.end(), [&](const SignedLink& link) {
      return link.weight * labels_[i] * labels_[idx(link.node)] < 0;
    });
  }

  void flip(int node) {
    std::int8_t& label = labels_[idx(node)];
    label = static_cast<std::int8_t>(-label);
    for (const SignedLink& link : graph_.links[idx(node)]) {
      wishes_[idx(link.node)] += 2 * label * link.weight;
    }
  }

  // The cheapest flips one after another, each beside those before; whether anything was gained.
  // The queue holds old prices too, and takes the lower node of two at one price.
  bool search_from(int first) {
    Queue queue;
    std::vector<int> moved;
    std::size_t kept = 0;
    double change = 0, best = -least_gain * scale_;
    queue.push({price(first), first});
    while (!queue.empty() && moved.size() - kept < patience) {
      const auto [at, node] = queue.top();
      queue.pop();
      if (is_moved_[idx(node)] || at != price(node)) continue;
      change += at;
      flip(node);
      is_moved_[idx(node)] = 1;
      moved.push_back(node);
      if (change < best) {
        best = change;
        kept = moved.size();
      }
      for (const SignedLink& link : graph_.links[idx(node)]) {
        if (!is_moved_[idx(link.node)]) queue.push({price(link.node), link.node});
      }
    }
    for (const int node : moved) is_moved_[idx(node)] = 0;
    for (std::size_t k = moved.size(); k > kept; --k) flip(moved[k - 1]);
    for (std::size_t k = 0; k < kept; ++k) {
      is_fresh_[idx(moved[k])] = 1;
      for (const SignedLink& link : graph_.links[idx(moved[k])]) is_fresh_[idx(link.node)] = 1;
    }
    return kept > 0;
  }

  using Entry = std::pair<double, int>;
  using Queue = std::priority_queue<Entry, std::vector<Entry>, std::greater<>>;

  const SignedGraph& graph_;
  Labels& labels_;
  std::vector<double> wishes_;  // of each node: what pulls and ties ask for
  std::vector<std::uint8_t> is_moved_;
  std::vector<std::uint8_t> is_fresh_;  // not looked at since something changed there
  double scale_ = 0;
};

bool is_worth_a_level(const SignedGraph& coarse, const SignedGraph& fine) {
  return static_cast<double>(coarse.size()) <=
         (1 - least_saving) * static_cast<double>(fine.size());
}

// Down to few nodes, aggregates all of nodes that agree now, and back with moves at every level:
// the cost never rises.
void search_once(const SignedGraph& graph, SeededNumbers& numbers, Labels& labels) {
  if (graph.size() > fewest_nodes) {
    std::vector<Membership> members;
    const SignedGraph coarse = coarsen(graph, labels, &numbers, members);
    if (is_worth_a_level(coarse, graph)) {
      Labels of_coarse = restricted(labels, members, coarse.size());
      search_once(coarse, numbers, of_coarse);
      labels = prolonged(of_coarse, members);
    }
  }
  Refiner(graph, labels).refine();
}

// What a flip of nodes that hang together costs, all else as it is.
double price_of(const SignedGraph& graph, const Labels& labels, const std::vector<int>& nodes,
                const std::vector<std::uint8_t>& is_one) {
  double price = 0;
  for (const int node : nodes) {
    double wish = graph.pulls[idx(node)];
    for (const SignedLink& link : graph.links[idx(node)]) {
      if (!is_one[idx(link.node)]) wish += link.weight * labels[idx(link.node)];
    }
    price += 2 * labels[idx(node)] * wish;
  }
  return price;
}

// Each region in which the others differ from the labels changes over if that pays; whether any
// did.
bool take_better(const SignedGraph& graph, const Labels& others, Labels& labels) {
  std::vector<std::uint8_t> is_met(graph.size(), 0), is_one(graph.size(), 0);
  bool any = false;
  for (std::size_t first = 0; first < graph.size(); ++first) {
    if (is_met[first] || labels[first] == others[first]) continue;
    std::vector<int> region{static_cast<int>(first)};
    is_met[first] = 1;
    for (std::size_t i = 0; i < region.size(); ++i) {
      is_one[idx(region[i])] = 1;
      for (const SignedLink& link : graph.links[idx(region[i])]) {
        const std::size_t next = idx(link.node);
        if (!is_met[next] && labels[next] != others[next]) {
          is_met[next] = 1;
          region.push_back(link.node);
        }
      }
    }
    const bool pays = price_of(graph, labels, region, is_one) < 0;
    any = any || pays;
    for (const int node : region) {
      is_one[idx(node)] = 0;
      if (pays) labels[idx(node)] = others[idx(node)];
    }
  }
  return any;
}

// Whether labels are as every tie and every pull asks: none cost less.
bool satisfies_all(const SignedGraph& graph, const Labels& labels) {
  for (std::size_t i = 0; i < graph.size(); ++i) {
    if (graph.pulls[i] * labels[i] < 0) return false;
    for (const SignedLink& link : graph.links[i]) {
      if (link.weight * labels[i] * labels[idx(link.node)] < 0) return false;
    }
  }
  return true;
}

// As the pulls ask for, then by chance: against them or not, so that nothing depends on which of
// two labels is called 1.
Labels first_labels(const SignedGraph& graph, int search, SeededNumbers& numbers) {
  Labels labels;
  for (const double pull : graph.pulls) {
    const bool turns = search > 0 && numbers.uniform() < 0;
    labels.push_back((pull < 0) != turns ? -1 : 1);
  }
  return labels;
}

Labels best_of_searches(const SignedGraph& graph, const Progress& progress) {
  Labels best;
  const int wanted = static_cast<int>(middle_size / std::max<std::size_t>(graph.size(), 1));
  const int count = std::clamp(wanted, fewest_searches, most_searches);
  int in_vain = 0;
  for (int search = 0; search < count && in_vain < searches_in_vain; ++search) {
    progress.report(static_cast<double>(search) / count);
    SeededNumbers numbers(static_cast<std::uint64_t>(search));
    Labels labels = first_labels(graph, search, numbers);
    for (int round = 0; round < rounds_of_search; ++round) search_once(graph, numbers, labels);
    if (best.empty()) best = labels;
    in_vain = take_better(graph, labels, best) ? 0 : in_vain + 1;
    if (satisfies_all(graph, best)) return best;
  }
  Refiner(graph, best).refine();
  return best;
}

Labels search_part(const SignedGraph& graph, const Progress& progress) {
  progress.report(0);
  if (graph.size() > middle_size) {
    std::vector<Membership> members;
    const SignedGraph coarse = coarsen(graph, {}, nullptr, members);
    if (is_worth_a_level(coarse, graph)) {
      Labels labels = prolonged(search_part(coarse, progress.part(0, 0.6)), members);
      Refiner(graph, labels).refine();
      return labels;
    }
  }
  return best_of_searches(graph, progress);
}

// The connected parts of a graph that have no labels yet, each searched by itself.
class Searcher {
 public:
  Searcher(const SignedGraph& graph, Labels known)
      : graph_(graph),
        parts_(connected_nodes(graph)),
        labels_(std::move(known)),
        numbers_(graph.size(), none) {
    labels_.resize(graph.size(), 0);
  }

  Labels search(int threads, const Progress& progress) {
    std::vector<std::size_t> open, sizes;
    for (std::size_t p = 0; p < parts_.size(); ++p) {
      if (labels_[idx(nodes(p)[0])] != 0) continue;
      open.push_back(p);
      sizes.push_back(nodes(p).size());
    }
    parallel_parts(sizes, {large_part, nodes_at_a_time}, threads, progress,
                   [&](std::size_t k, int, const Progress& part) { search(open[k], part); });
    return std::move(labels_);
  }

 private:
  Span<const int> nodes(std::size_t part) const { return parts_[part]; }

  void search(std::size_t part, const Progress& progress) {
    const Labels found = search_part(graph_of(nodes(part)), progress);
    for (std::size_t i = 0; i < found.size(); ++i) labels_[idx(nodes(part)[i])] = found[i];
  }

  SignedGraph graph_of(Span<const int> nodes) {
    SignedGraph part;
    for (std::size_t i = 0; i < nodes.size(); ++i) numbers_[idx(nodes[i])] = static_cast<int>(i);
    for (const int node : nodes) {
      part.pulls.push_back(graph_.pulls[idx(node)]);
      for (const SignedLink& link : graph_.links[idx(node)]) {
        part.links.push({numbers_[idx(link.node)], link.weight});
      }
      part.links.close_list();
    }
    return part;
  }

  const SignedGraph& graph_;
  const Ragged<int> parts_;
  Labels labels_;
  std::vector<int> numbers_;  // (n) of each node within its part
};

}  // namespace

Labels nearby_labels(const SignedGraph& graph, Labels labels) {
  Refiner(graph, labels).refine();
  return labels;
}

Labels cheap_labels(const SignedGraph& graph, int threads, const Progress& progress, Labels known) {
  return Searcher(graph, std::move(known)).search(threads, progress);
}

}  // namespace illustrate
