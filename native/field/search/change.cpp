#include "field/search/change.h"

#include "core/parallel.h"
#include "field/search/diffusion.h"
#include "field/search/hierarchy.h"

namespace illustrate {
namespace {

constexpr std::size_t size_of_coarsest = 500;
constexpr int coarse_sweeps = 100;
constexpr int sweeps_of_change = 3;

// Rounds over all scales, until one gains less than this share of the energy.
constexpr int most_rounds = 4;
constexpr double least_gain = 2e-5;

// Aggregates are stiffer than their vertices: a change that comes from them falls short by such
// factors.
constexpr std::array<double, 2> longer{1.3, 1.7};

// The same graph for the factors w of crosses z w.
FieldGraph graph_of_changes(const FieldGraph& graph, const CrossNumbers& z,
                            const Progress& progress) {
  FieldGraph changes = graph;
  parallel_for(graph.size(), 1, progress, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      changes.pulls[i] = product(std::conj(z[i]), graph.pulls[i]);
      for (Link& link : changes.links[i]) {
        const CrossNumber other = mirrored_if(link.mirrored, z[idx(link.vertex)]);
        link.transport = product(std::conj(z[i]), product(link.transport, other));
      }
    }
  });
  return changes;
}

std::vector<double> angles_of(const CrossNumbers& z) {
  std::vector<double> angles(z.size());
  for (std::size_t i = 0; i < z.size(); ++i) angles[i] = std::arg(z[i]);
  return angles;
}

// Makes all angles of w longer by one factor for as long as that lowers the energy.
void lengthen(const FieldGraph& graph, const Progress& progress, CrossNumbers& w) {
  const std::vector<double> angles = angles_of(w);
  std::vector<double> stretched = angles;
  double least = energy(graph, angles.data(), nullptr, 1);
  for (const double factor : longer) {
    progress.report(0);
    for (std::size_t i = 0; i < angles.size(); ++i) stretched[i] = factor * angles[i];
    const double now = energy(graph, stretched.data(), nullptr, 1);
    if (!(now < least)) return;
    least = now;
    for (std::size_t i = 0; i < w.size(); ++i)
      w[i] = {std::cos(stretched[i]), std::sin(stretched[i])};
  }
}

// The change of z that one round finds.
CrossNumbers change_of(const FieldGraph& graph, const CrossNumbers& z, const Progress& progress) {
  const FieldGraph changes = graph_of_changes(graph, z, progress.part(0, 0.1));
  const Hierarchy hierarchy(changes, size_of_coarsest, Pairing::unchanged, progress.part(0.1, 0.6));
  CrossNumbers w(hierarchy.graph(hierarchy.coarsest()).size(), 1);
  sweep(hierarchy.graph(hierarchy.coarsest()), coarse_sweeps, w);
  const Progress finer = progress.part(0.6, 0.6), finest = progress.part(0.6, 1);
  for (std::size_t level = hierarchy.coarsest(); level-- > 0;) {
    w = hierarchy.prolonged(w, level);
    lengthen(hierarchy.graph(level), finer, w);
    sweep(hierarchy.graph(level), sweeps_of_change, w, level == 0 ? finest : finer);
  }
  return w;
}

}  // namespace

void relax_at_all_scales(const FieldGraph& graph, CrossNumbers& z, const Progress& progress) {
  double last = energy(graph, angles_of(z).data(), nullptr, 1);
  for (int round = 0; round < most_rounds; ++round) {
    const Progress part = progress.part(static_cast<double>(round) / most_rounds,
                                        static_cast<double>(round + 1) / most_rounds);
    const CrossNumbers w = change_of(graph, z, part);
    CrossNumbers changed(z.size());
    for (std::size_t i = 0; i < z.size(); ++i) changed[i] = normalized(product(z[i], w[i]), z[i]);
    const double now = energy(graph, angles_of(changed).data(), nullptr, 1);
    if (!(now < last)) return;
    z = std::move(changed);
    if (last - now < least_gain * std::abs(last)) return;
    last = now;
  }
}

}  // namespace illustrate
