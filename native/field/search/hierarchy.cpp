#include "field/search/hierarchy.h"

namespace illustrate {
namespace {

// Coarsening that saves less than this share of the vertices is not worth a level (only parts
// without edges remain).
constexpr double least_saving = 0.05;

constexpr std::size_t vertices_per_report = 65536;

// The strongest edge to a vertex that has no aggregate yet; null if there is none.
const Link* strongest_open_link(const FieldGraph& graph, std::size_t i,
                                const std::vector<Gauge>& gauges) {
  const Link* best = nullptr;
  double best_strength = 0;
  for (const Link& link : graph.links[i]) {
    const double strength = std::norm(link.transport);
    // Of links that are equally strong the first.
    if (gauges[idx(link.vertex)].aggregate != none || idx(link.vertex) == i ||
        strength <= best_strength) {
      continue;
    }
    best = &link;
    best_strength = strength;
  }
  return best;
}

// Returns the vertices of each aggregate, the second `none` for a single one.
std::vector<std::array<int, 2>> match(const FieldGraph& graph, Pairing pairing,
                                      std::vector<Gauge>& gauges, const Progress& progress) {
  std::vector<std::array<int, 2>> members;
  gauges.assign(graph.size(), {none, false, 1});
  for (std::size_t i = 0; i < graph.size(); ++i) {
    if (i % vertices_per_report == 0) {
      progress.report(static_cast<double>(i) / static_cast<double>(graph.size()));
    }
    if (gauges[i].aggregate != none) continue;
    const int aggregate = static_cast<int>(members.size());
    gauges[i].aggregate = aggregate;
    members.push_back({static_cast<int>(i), none});
    const Link* link = strongest_open_link(graph, i, gauges);
    if (!link) continue;
    // z_i = r z_j, solved for z_j.
    const CrossNumber back = mirrored_if(!link->mirrored, link->transport);
    const CrossNumber turn = pairing == Pairing::parallel ? normalized(back, 1) : CrossNumber(1);
    gauges[idx(link->vertex)] = {aggregate, link->mirrored, turn};
    members.back()[1] = link->vertex;
  }
  return members;
}

// The links of one aggregate: those of its members in its own gauge, added up where they lead to
// the same place.
class LinkCollector {
 public:
  explicit LinkCollector(std::size_t aggregates) : slots_(2 * aggregates, none) {}

  void add(const Link& link) {
    int& slot = slots_[key(link)];
    if (slot == none) {
      slot = static_cast<int>(links_.size());
      links_.push_back(link);
    } else {
      links_[idx(slot)].transport += link.transport;
    }
  }

  void flush(Ragged<Link>& into) {
    into.add(links_);
    for (const Link& link : links_) slots_[key(link)] = none;
    links_.clear();
  }

 private:
  static std::size_t key(const Link& link) {
    return 2 * idx(link.vertex) + (link.mirrored ? 1 : 0);
  }

  std::vector<int> slots_;  // (2 aggregates) place in links_ of a link to there
  std::vector<Link> links_;
};

// Re(conj(z_i) r z_j) written in the crosses of the two aggregates.
Link in_gauge(const Link& link, const Gauge& here, const Gauge& there) {
  const CrossNumber turned = product(link.transport, mirrored_if(link.mirrored, there.turn));
  return {mirrored_if(here.mirrored, product(std::conj(here.turn), turned)), there.aggregate,
          link.mirrored != (here.mirrored != there.mirrored)};
}

}  // namespace

FieldGraph coarsen(const FieldGraph& fine, Pairing pairing, std::vector<Gauge>& gauges,
                   const Progress& progress) {
  const std::vector<std::array<int, 2>> members =
      match(fine, pairing, gauges, progress.part(0, 0.3));
  FieldGraph coarse;
  coarse.pulls.assign(members.size(), 0);
  coarse.weights.assign(members.size(), 0);
  coarse.links.values.reserve(fine.links.values.size() * 2 / 3);
  LinkCollector collector(members.size());
  const Progress collecting = progress.part(0.3, 1);
  for (std::size_t a = 0; a < members.size(); ++a) {
    if (a % vertices_per_report == 0) {
      collecting.report(static_cast<double>(a) / static_cast<double>(members.size()));
    }
    for (const int member : members[a]) {
      if (member == none) continue;
      const auto i = idx(member);
      coarse.pulls[a] +=
          mirrored_if(gauges[i].mirrored, product(std::conj(gauges[i].turn), fine.pulls[i]));
      coarse.weights[a] += fine.weights[i];
      for (const Link& link : fine.links[i]) {
        const Link moved = in_gauge(link, gauges[i], gauges[idx(link.vertex)]);
        if (moved.vertex != static_cast<int>(a)) {
          collector.add(moved);
        } else {
          coarse.weights[a] -= moved.mirrored ? 0 : moved.transport.real();
        }
      }
    }
    collector.flush(coarse.links);
  }
  return coarse;
}

Hierarchy::Hierarchy(const FieldGraph& finest, std::size_t coarse_size, Pairing pairing,
                     const Progress& progress)
    : finest_(&finest) {
  const double all = static_cast<double>(finest.size());
  while (graph(coarsest()).size() > coarse_size) {
    const double size = static_cast<double>(graph(coarsest()).size());
    const Progress step = progress.part(1 - size / all, 1 - size / all / 2);
    std::vector<Gauge> gauges;
    FieldGraph coarse = coarsen(graph(coarsest()), pairing, gauges, step);
    if (static_cast<double>(coarse.size()) > (1 - least_saving) * size) break;
    coarser_.push_back(std::move(coarse));
    gauges_.push_back(std::move(gauges));
  }
}

CrossNumbers Hierarchy::restricted(CrossNumbers z) const {
  for (std::size_t level = 0; level < coarsest(); ++level) {
    CrossNumbers sums(graph(level + 1).size(), 0);
    for (std::size_t i = 0; i < z.size(); ++i) {
      const Gauge& gauge = gauges_[level][i];
      sums[idx(gauge.aggregate)] +=
          mirrored_if(gauge.mirrored, product(std::conj(gauge.turn), z[i]));
    }
    z = std::move(sums);
  }
  for (CrossNumber& cross : z) cross = normalized(cross, 1);
  return z;
}

CrossNumbers Hierarchy::prolonged(const CrossNumbers& z, std::size_t level) const {
  CrossNumbers finer;
  finer.reserve(gauges_[level].size());
  for (const Gauge& gauge : gauges_[level]) {
    const CrossNumber& coarse = z[idx(gauge.aggregate)];
    finer.push_back(product(gauge.turn, mirrored_if(gauge.mirrored, coarse)));
  }
  return finer;
}

}  // namespace illustrate
