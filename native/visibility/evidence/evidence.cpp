#include "visibility/evidence/evidence.h"

#include <algorithm>
#include <tuple>

#include "core/parallel.h"
#include "visibility/prices.h"

namespace illustrate {
namespace {

// Longer arcs are asked at three places, of which the middle one decides.
constexpr double asked_thrice_px = 30;
// Of a path: they tell the others, by the rules.
constexpr std::size_t most_asked = 5;
constexpr std::size_t least_share = 64;  // arcs that are worth a turn on another thread

bool is_before(const StrandPlace& a, const StrandPlace& b) {
  return std::tie(a.segment, a.fraction) < std::tie(b.segment, b.fraction);
}

bool is_outline(const Arrangement& arrangement, const PathArc& arc) {
  const std::vector<Visit>& visits = arrangement.visits(arc.strand);
  const bool closed = arrangement.strand(arc.strand).closed();
  const bool wraps = closed && arc.begin != none && arc.end <= arc.begin;
  const auto contains = [&](const StrandPlace& place) {
    const bool behind = arc.begin == none || is_before(visits[idx(arc.begin)].place, place);
    const bool before = arc.end == none || is_before(place, visits[idx(arc.end)].place);
    return wraps ? behind || before : behind && before;
  };
  const std::vector<StrandPlace>& places = arrangement.outline(arc.strand);
  return std::any_of(places.begin(), places.end(), contains);
}

bool is_under_cover(const CurveNetwork& network, const std::vector<std::uint8_t>& nodes,
                    const PathArc& arc) {
  const Strand& s = network.strands[idx(arc.strand)];
  if (is_under_cover(s.sight)) return true;
  if (s.closed()) return false;
  return (arc.begin == none && nodes[idx(s.start_node)]) ||
         (arc.end == none && nodes[idx(s.end_node)]);
}

// What is known of an arc that nobody asked.
Evidence known(const Arrangement& arrangement, const std::vector<std::uint8_t>& covered_nodes,
               const PathArc& arc) {
  if (is_under_cover(arrangement.network(), covered_nodes, arc)) {
    return {1, any_more, arc.length_px + prices.least, false};
  }
  if (is_outline(arrangement, arc)) return {0, 0, prices.outline, true};
  return {};
}

// The arcs of a path that are asked. Of equally long ones the first: a closed path of equal arcs
// must not be asked elsewhere on another system.
std::vector<std::size_t> longest_arcs(const std::vector<PathArc>& arcs,
                                      const std::vector<Evidence>& evidence) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < arcs.size(); ++i) {
    if (evidence[i].weight == 0) order.push_back(i);
  }
  const auto count = static_cast<std::ptrdiff_t>(std::min(most_asked, order.size()));
  std::partial_sort(
      order.begin(), order.begin() + count, order.end(), [&](std::size_t i, std::size_t j) {
        return arcs[i].length_px != arcs[j].length_px ? arcs[i].length_px > arcs[j].length_px
                                                      : i < j;
      });
  order.resize(static_cast<std::size_t>(count));
  return order;
}

// The middle one of three counts; one on the outline counts for more than its length. So a ray that
// meets nothing is not believed alone: the mesh may end before the contour does.
Evidence ask(const Arrangement& arrangement, const PathArc& arc, LayerRays& rays) {
  std::array<LayerCount, 3> counts{rays.count(arrangement, arc.samples[1])};
  counts[1] = counts[2] = counts[0];
  const bool is_long = arc.length_px >= asked_thrice_px;
  if (is_long || counts[0].beside_nothing) counts[1] = rays.count(arrangement, arc.samples[0]);
  if (counts[1].layers != counts[0].layers) counts[2] = rays.count(arrangement, arc.samples[2]);
  std::sort(counts.begin(), counts.end(), [](const LayerCount& a, const LayerCount& b) {
    return std::tie(a.layers, b.beside_nothing) < std::tie(b.layers, a.beside_nothing);
  });
  const double sure = std::min(prices.beside_nothing, prices.beside_nothing_share * arc.length_px);
  const LayerCount& middle = counts[1];
  const double weight = arc.length_px + (middle.beside_nothing ? sure : 0) + prices.least;
  return {middle.layers, middle.unsure, weight, middle.beside_nothing};
}

// Calls work(i, rays) for all i, with rays of its own for each share of the sizes.
template <class Work>
void each_share(const std::vector<std::size_t>& sizes, LayerRays& rays, int threads,
                const Progress& progress, const Work& work) {
  const std::vector<std::size_t> starts = shares_of(sizes, least_share);
  std::vector<LayerRays> shares(starts.size() - 1, rays);
  parallel_each(shares.size(), threads, progress, [&](std::size_t s) {
    for (std::size_t i = starts[s]; i < starts[s + 1]; ++i) work(i, shares[s]);
  });
  for (const LayerRays& share : shares) rays.add_count(share);
}

}  // namespace

double missed_share(const Evidence& evidence) {
  return evidence.beside_nothing ? 1 : prices.missed_share;
}

std::vector<std::vector<Evidence>> gather_evidence(const Arrangement& arrangement,
                                                   const std::vector<std::vector<PathArc>>& arcs,
                                                   LayerRays& rays, int threads,
                                                   const Progress& progress) {
  const CurveNetwork& network = arrangement.network();
  const std::vector<std::uint8_t> covered_nodes = nodes_under_cover(network);
  std::vector<std::size_t> sizes;
  for (const std::vector<PathArc>& path : arcs) sizes.push_back(path.size());
  std::vector<std::vector<Evidence>> evidence(arcs.size());
  each_share(sizes, rays, threads, progress, [&](std::size_t p, LayerRays& share) {
    std::vector<Evidence>& of_arcs = evidence[p];
    of_arcs.resize(arcs[p].size());
    for (std::size_t i = 0; i < of_arcs.size(); ++i) {
      of_arcs[i] = known(arrangement, covered_nodes, arcs[p][i]);
    }
    for (const std::size_t i : longest_arcs(arcs[p], of_arcs)) {
      of_arcs[i] = ask(arrangement, arcs[p][i], share);
    }
  });
  return evidence;
}

void ask_all_arcs(const std::vector<int>& paths, const Arrangement& arrangement,
                  const std::vector<std::vector<PathArc>>& arcs, LayerRays& rays, int threads,
                  const Progress& progress, std::vector<std::vector<Evidence>>& evidence) {
  std::vector<std::size_t> sizes;
  for (const int p : paths) sizes.push_back(arcs[idx(p)].size());
  each_share(sizes, rays, threads, progress, [&](std::size_t of_paths, LayerRays& share) {
    const std::size_t p = idx(paths[of_paths]);
    for (std::size_t i = 0; i < arcs[p].size(); ++i) {
      if (evidence[p][i].weight == 0) evidence[p][i] = ask(arrangement, arcs[p][i], share);
    }
  });
}

}  // namespace illustrate
