#include "field/search/portfolio.h"

#include <algorithm>
#include <numeric>

#include "field/search/diffusion.h"
#include "field/search/hierarchy.h"

namespace illustrate {
namespace {

// The coarsest graph: few enough vertices for many starts, enough for a singularity of every bump
// of an organic mesh; aggregates of too many vertices mislead about the energy of their fields.
constexpr std::size_t vertices_per_aggregate = 10;
// A symmetric mesh with many bumps needs 8000; which size is best varies from mesh to mesh, so that
// several starts do more than one large graph.
constexpr std::size_t least_coarse_size = 300, most_coarse_size = 8000;

// No more starts than touch so many crosses, more where the whole graph is large and all else takes
// longer, fewer where it is small, since it may be one of many; one in three is shaken.
constexpr std::size_t least_pool_crosses = 100000;
constexpr std::size_t pool_crosses_per_vertex = 4;
constexpr std::size_t vertices_per_pool_cross = 4;
constexpr std::size_t most_random_starts = 40;
constexpr std::size_t starts_per_shake = 3;
constexpr std::size_t kept_starts = 6;
constexpr std::uint64_t seed = 2;

// Lengths of the heat flow for starts: across the whole coarse graph, and over some of its
// vertices.
constexpr double eigenvector_tau = 1e5;
constexpr double far_tau = 3000;
constexpr double middle_tau = 300;
constexpr double near_tau = 60;

// Disturbances that move singularities without making new ones.
constexpr double shaking_heat = 0.5;
constexpr int shaking_sweeps = 60;

// On the way down: sweeps for each level; how many crosses all the fields that are carried on may
// have together; the largest graph that they are diffused on once more. Less on small graphs.
constexpr int sweeps_per_level = 6;
constexpr int final_coarse_sweeps = 20;
constexpr std::size_t carried_crosses = 120000;
constexpr std::size_t diffused_size = 8000;
constexpr std::size_t carried_crosses_per_vertex = 3;
constexpr std::size_t vertices_per_diffused = 4;

// Fields whose energies above the least possible differ by a smaller share found the same minimum.
constexpr double same_energy = 1e-4;

using Pool = std::vector<CrossNumbers>;

double energy_of(const FieldGraph& graph, const CrossNumbers& z) {
  double sum = 0;
  for (std::size_t i = 0; i < z.size(); ++i) {
    const CrossNumber attraction = graph.attraction(i, z) + graph.pulls[i];
    sum -= 0.5 * product(std::conj(z[i]), attraction).real();
  }
  return sum;
}

// The places in `energies` of the best of them, each clearly different from the others, best first;
// at most `kept`. `least`: the energy of crosses that agree everywhere.
std::vector<std::size_t> distinct_best(const std::vector<double>& energies, double least,
                                       std::size_t kept) {
  std::vector<std::size_t> order(energies.size()), chosen;
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return energies[a] < energies[b]; });
  for (const std::size_t k : order) {
    if (chosen.size() == kept) break;
    const bool is_new = chosen.empty() ||
                        energies[k] - energies[chosen.back()] > same_energy * (energies[k] - least);
    if (is_new) chosen.push_back(k);
  }
  return chosen;
}

// The best fields of the pool, best first; only `kept` stay, and of those that found the same
// minimum one.
Pool ranked(const FieldGraph& graph, Pool pool, std::size_t kept) {
  std::vector<double> energies;
  for (const CrossNumbers& z : pool) energies.push_back(energy_of(graph, z));
  double least = 0;
  for (std::size_t i = 0; i < graph.size(); ++i) {
    least -= 0.5 * (graph.weights[i] + std::abs(graph.pulls[i]));
  }
  Pool result;
  for (const std::size_t k : distinct_best(energies, least, kept)) {
    result.push_back(std::move(pool[k]));
  }
  return result;
}

CrossNumbers random_field(std::size_t size, SeededNumbers& numbers) {
  CrossNumbers z(size);
  for (CrossNumber& cross : z) cross = normalized(numbers.number(), 1);
  return z;
}

// The pool of the coarsest graph: given starts, random ones, then the best of them shaken.
Pool coarse_pool(const FieldGraph& graph, const Pool& given, std::size_t pool_crosses,
                 const Progress& progress) {
  SeededNumbers numbers(seed);
  Pool pool;
  const auto diffused = [&](CrossNumbers z, double tau) {
    diffuse(graph, tau, z);
    sweep(graph, final_coarse_sweeps, z);
    return z;
  };
  for (const CrossNumbers& z : given) {
    for (const double tau : {far_tau, middle_tau}) {
      progress.report(0);
      pool.push_back(diffused(z, tau));
    }
  }
  const std::size_t room = pool_crosses / std::max<std::size_t>(1, graph.size());
  const std::size_t random_starts = std::min(most_random_starts, room);
  for (std::size_t k = 0; k < random_starts; ++k) {
    progress.report(0.7 * static_cast<double>(k) / static_cast<double>(random_starts));
    CrossNumbers z = random_field(graph.size(), numbers);
    diffuse_once(graph, eigenvector_tau, z);
    pool.push_back(diffused(std::move(z), far_tau));
  }
  pool = ranked(graph, std::move(pool), kept_starts);
  const std::size_t shakes = random_starts / starts_per_shake;
  for (std::size_t k = 0; k < shakes; ++k) {
    progress.report(0.7 + 0.3 * static_cast<double>(k) / static_cast<double>(shakes));
    CrossNumbers& shaken = pool[k % pool.size()];
    CrossNumbers z = shaken;
    anneal(graph, shaking_heat, shaking_sweeps, numbers, z);
    shaken = ranked(graph, {shaken, diffused(std::move(z), near_tau)}, 1)[0];
  }
  return ranked(graph, std::move(pool), kept_starts);
}

std::size_t pool_crosses(std::size_t vertices) {
  const std::size_t large = std::max(least_pool_crosses, vertices / vertices_per_pool_cross);
  return std::min(large, pool_crosses_per_vertex * vertices);
}

}  // namespace

CrossNumbers portfolio_start(const FieldGraph& graph, const std::vector<CrossNumbers>& starts,
                             const Progress& progress) {
  const std::size_t coarse_size =
      std::clamp(graph.size() / vertices_per_aggregate, least_coarse_size, most_coarse_size);
  const Hierarchy hierarchy(graph, coarse_size, Pairing::parallel, progress.part(0, 0.2));
  const FieldGraph& coarsest = hierarchy.graph(hierarchy.coarsest());
  Pool given;
  for (const CrossNumbers& start : starts) {
    progress.report(0.2);
    given.push_back(hierarchy.restricted(start));
  }
  progress.report(0.2);
  Pool pool = coarse_pool(coarsest, given, pool_crosses(graph.size()), progress.part(0.2, 0.6));
  const Progress way_down = progress.part(0.6, 1);
  const std::size_t carried = std::min(carried_crosses, carried_crosses_per_vertex * graph.size());
  const std::size_t diffused = std::min(diffused_size, graph.size() / vertices_per_diffused);
  for (std::size_t level = hierarchy.coarsest(); level-- > 0;) {
    const FieldGraph& finer = hierarchy.graph(level);
    const double done = static_cast<double>(finer.size()) / static_cast<double>(2 * graph.size());
    way_down.report(done);
    for (CrossNumbers& z : pool) {
      z = hierarchy.prolonged(z, level);
      if (finer.size() <= diffused) diffuse(finer, near_tau, z);
      sweep(finer, sweeps_per_level, z, way_down.part(done, done));
    }
    const std::size_t kept = std::max<std::size_t>(1, carried / finer.size());
    if (pool.size() > 1) pool = ranked(finer, std::move(pool), kept);
  }
  return std::move(pool[0]);
}

}  // namespace illustrate
