#include "visibility/evidence.h"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace illustrate {
namespace {

constexpr std::int64_t most_rays = 60'000;     // of a view; a dense scan needs some thousands
constexpr std::int64_t pile = 250'000;         // so many crossings, of needles, halve it
constexpr std::size_t most_arcs_asked = 1000;  // of one path, the longest ones
constexpr double asked_thrice_px = 30;         // longer arcs are asked at three places
constexpr double beside_nothing_px = 100;   // an arc next to the empty background is nearly certain
constexpr double beside_nothing_share = 3;  // of its length: a sliver may hide a short one
constexpr double least_weight = 1e-6;       // an arc without length still prefers its ray

bool is_before(const StrandPlace& a, const StrandPlace& b) {
  return std::tie(a.segment, a.fraction) < std::tie(b.segment, b.fraction);
}

bool is_outline(const Arrangement& arrangement, const PathArc& arc) {
  const std::vector<Visit>& visits = arrangement.visits[idx(arc.strand)];
  const bool closed = arrangement.network->strands[idx(arc.strand)].closed();
  const bool wraps = closed && arc.begin != none && arc.end <= arc.begin;
  const auto contains = [&](const StrandPlace& place) {
    const bool behind = arc.begin == none || is_before(visits[idx(arc.begin)].place, place);
    const bool before = arc.end == none || is_before(place, visits[idx(arc.end)].place);
    return wraps ? behind || before : behind && before;
  };
  const std::vector<StrandPlace>& places = arrangement.outline[idx(arc.strand)];
  return std::any_of(places.begin(), places.end(), contains);
}

class Witness {
 public:
  Witness(const Arrangement& arrangement, LayerRays& rays, KnownEvidence& known)
      : arrangement_(arrangement),
        most_rays_(most_rays /
                   (1 + static_cast<std::int64_t>(arrangement.crossings.size()) / pile)),
        rays_(rays),
        known_(known) {}

  void gather(const std::vector<PathArc>& arcs, std::vector<Evidence>& evidence) {
    std::vector<std::size_t> order(arcs.size());
    std::iota(order.begin(), order.end(), 0U);
    std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) {
      return arcs[i].length_px != arcs[j].length_px ? arcs[i].length_px > arcs[j].length_px : i < j;
    });
    order.resize(std::min(most_arcs_asked, order.size()));
    for (const std::size_t i : order) {
      if (evidence[i].weight == 0) evidence[i] = remember(arcs[i]);
    }
  }

 private:
  Evidence remember(const PathArc& arc) {
    const std::vector<Visit>& visits = arrangement_.visits[idx(arc.strand)];
    const auto crossing = [&](int visit) {
      return visit == none ? none : visits[idx(visit)].crossing;
    };
    const std::array<int, 3> key{arc.strand, crossing(arc.begin), crossing(arc.end)};
    const auto found = known_.find(key);
    if (found != known_.end()) return found->second;
    return rays_.rays() < most_rays_ ? known_[key] = ask(arc) : Evidence{0, 0, 0};
  }

  // The middle one of three counts; one on the outline counts for more than its length. So a ray
  // that meets nothing is not believed alone: the mesh may end before the contour does.
  Evidence ask(const PathArc& arc) {
    std::array<LayerCount, 3> counts{rays_.count(arrangement_, arc.samples[2])};
    counts[1] = counts[2] = counts[0];
    const bool is_long = arc.length_px >= asked_thrice_px;
    if (is_long || counts[0].beside_nothing) counts[1] = rays_.count(arrangement_, arc.samples[1]);
    if (counts[1].layers != counts[0].layers) counts[2] = rays_.count(arrangement_, arc.samples[3]);
    std::sort(counts.begin(), counts.end(), [](const LayerCount& a, const LayerCount& b) {
      return std::tie(a.layers, b.beside_nothing) < std::tie(b.layers, a.beside_nothing);
    });
    const double sure = std::min(beside_nothing_px, beside_nothing_share * arc.length_px);
    const LayerCount& middle = counts[1];
    const double weight = arc.length_px + (middle.beside_nothing ? sure : 0) + least_weight;
    return {middle.layers, middle.unsure, weight, middle.beside_nothing};
  }

  const Arrangement& arrangement_;
  std::int64_t most_rays_;
  LayerRays& rays_;
  KnownEvidence& known_;
};

}  // namespace

std::vector<Evidence> outline_evidence(const Arrangement& arrangement,
                                       const std::vector<PathArc>& arcs) {
  std::vector<Evidence> evidence(arcs.size(), {0, 0, 0});
  for (std::size_t i = 0; i < arcs.size(); ++i) {
    if (is_outline(arrangement, arcs[i])) evidence[i] = {0, 0, outline_weight, true};
  }
  return evidence;
}

void ask_rays(const Arrangement& arrangement, const std::vector<PathArc>& arcs, LayerRays& rays,
              KnownEvidence& known, std::vector<Evidence>& evidence) {
  Witness(arrangement, rays, known).gather(arcs, evidence);
}

}  // namespace illustrate
