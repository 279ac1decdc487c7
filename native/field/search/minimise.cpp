#include "field/search/minimise.h"

#include <nlopt.h>

#include <exception>
#include <memory>

namespace illustrate {
namespace {

// NLopt's default storage takes hundreds of vectors on small graphs and is eight times slower.
constexpr unsigned stored_vectors = 8;

// A relative change of the energy below this ends the search: less is not seen in a drawing.
constexpr double energy_tolerance = 1e-6;

struct Search {
  const FieldGraph* graph;
  int threads;
  int max_evaluations;
  const Progress* progress;
  nlopt_opt optimizer;
  std::vector<double> best;
  double best_energy;
  int evaluations = 0;
  std::exception_ptr failure;  // carried past NLopt, which is C
};

double evaluate(unsigned n, const double* u, double* gradient, void* data) {
  Search& search = *static_cast<Search*>(data);
  try {
    search.progress->report(double(search.evaluations) / search.max_evaluations);
    const double value = energy(*search.graph, u, gradient, search.threads);
    ++search.evaluations;
    if (value < search.best_energy) {
      search.best_energy = value;
      search.best.assign(u, u + n);
    }
    return value;
  } catch (...) {
    search.failure = std::current_exception();
    nlopt_force_stop(search.optimizer);
    return search.best_energy;
  }
}

// Whether a step down the gradient, of the length that suits each vertex, gains less than is seen:
// line searches that start at a minimum may fail.
bool is_minimum(const FieldGraph& graph, const std::vector<double>& u, int threads) {
  std::vector<double> gradient(u.size());
  const double value = energy(graph, u.data(), gradient.data(), threads);
  double gain = 0;
  for (std::size_t i = 0; i < u.size(); ++i) {
    if (graph.weights[i] > 0) gain += gradient[i] * gradient[i] / (2 * graph.weights[i]);
  }
  return gain <= energy_tolerance * std::abs(value);
}

}  // namespace

MinimiseResult minimise(const FieldGraph& graph, int max_evaluations, int threads, CrossNumbers& z,
                        const Progress& progress) {
  if (graph.size() == 0 || max_evaluations <= 0) return {graph.size() == 0, 0};
  std::vector<double> u(graph.size());
  for (std::size_t i = 0; i < u.size(); ++i) u[i] = std::arg(z[i]);
  const std::unique_ptr<nlopt_opt_s, decltype(&nlopt_destroy)> optimizer(
      nlopt_create(NLOPT_LD_LBFGS, static_cast<unsigned>(u.size())), &nlopt_destroy);
  if (!optimizer) throw std::bad_alloc();
  const double initial = energy(graph, u.data(), nullptr, threads);
  Search search{&graph, threads, max_evaluations, &progress, optimizer.get(), u, initial, 0, {}};
  nlopt_set_min_objective(optimizer.get(), evaluate, &search);
  nlopt_set_vector_storage(optimizer.get(), stored_vectors);
  nlopt_set_ftol_rel(optimizer.get(), energy_tolerance);
  nlopt_set_maxeval(optimizer.get(), max_evaluations);
  double last = 0;
  const nlopt_result result = nlopt_optimize(optimizer.get(), u.data(), &last);
  if (search.failure) std::rethrow_exception(search.failure);
  if (search.best_energy < initial) {
    for (std::size_t i = 0; i < z.size(); ++i) {
      z[i] = {std::cos(search.best[i]), std::sin(search.best[i])};
    }
  }
  const bool has_ended = result > 0 && result != NLOPT_MAXEVAL_REACHED;
  const bool has_failed = result < 0;
  return {has_ended || (has_failed && is_minimum(graph, search.best, threads)), search.evaluations};
}

}  // namespace illustrate
