#include "field/cross_field.h"

#include "core/errors.h"
#include "field/minimise.h"
#include "field/portfolio.h"
#include "field/singularities.h"
#include "field/starts.h"

namespace illustrate {
namespace {

// A part leaves its start only for a share of energy that rounding cannot explain.
constexpr double least_gain = 1e-9;

// Everything the stages of the solution share.
struct Problem {
  TangentFrames frames;
  TriangleEdges triangle_edges;
  std::vector<FieldEdge> edges;
  std::vector<double> diagonals;
  Alignment alignment;
  FieldParts parts;
  CrossNumbers by_default;
  PrincipalCrosses principal;
  std::vector<std::uint8_t> reliable;  // (n)
  CrossNumbers initial;
};

Problem state_problem(const Surface& surface, const Curvature& curvature,
                      const FieldOptions& options, const Progress& progress) {
  Problem p;
  p.frames = tangent_frames(surface.normals, options.threads);
  progress.report(0.1);
  p.triangle_edges = triangle_edges(surface);
  progress.report(0.4);
  p.edges = field_edges(surface, p.triangle_edges, p.frames, options.threads);
  progress.report(0.5);
  p.diagonals = object_diagonals(surface);
  p.alignment = align_to_features(surface, p.frames, p.diagonals, options.alignment_weight);
  p.parts = connected_parts(p.frames.size(), p.edges);
  progress.report(0.8);
  p.by_default = default_crosses(p.frames, options.default_direction);
  p.principal = principal_crosses(p.frames, curvature, p.by_default);
  p.reliable = reliable_vertices(curvature, p.edges, p.principal, p.diagonals, options);
  return p;
}

// (parts) 1: nothing is held, and all crosses may turn by one angle without a change of energy.
std::vector<std::uint8_t> parts_that_may_turn(const Problem& p) {
  std::vector<std::uint8_t> may_turn(static_cast<std::size_t>(p.parts.count), 1);
  const auto part_of = [&](int vertex) {
    return static_cast<std::size_t>(p.parts.of_vertex[static_cast<std::size_t>(vertex)]);
  };
  for (std::size_t i = 0; i < p.reliable.size(); ++i) {
    if (p.reliable[i]) may_turn[part_of(static_cast<int>(i))] = 0;
  }
  for (const FieldEdge& edge : p.edges) {
    if (edge.mirrored) may_turn[part_of(edge.from)] = 0;
  }
  return may_turn;
}

// Principal directions; in a part without a reliable vertex the default direction, turned towards
// its features.
CrossNumbers initial_field(const Problem& p) {
  std::vector<std::uint8_t> has_reliable(static_cast<std::size_t>(p.parts.count), 0);
  for (std::size_t i = 0; i < p.reliable.size(); ++i) {
    if (p.reliable[i]) has_reliable[static_cast<std::size_t>(p.parts.of_vertex[i])] = 1;
  }
  CrossNumbers z = p.principal.z;
  for (std::size_t i = 0; i < z.size(); ++i) {
    if (!has_reliable[static_cast<std::size_t>(p.parts.of_vertex[i])]) z[i] = p.by_default[i];
  }
  turn_parts(p.parts, parts_that_may_turn(p), p.alignment.pulls, z);
  return z;
}

struct Solution {
  CrossNumbers z;
  MinimiseResult result;
};

Solution solve(const Problem& p, bool aligned, const FieldOptions& options,
               const Progress& progress) {
  std::vector<FieldEdge> edges = p.edges;
  CrossNumbers pulls(p.initial.size(), 0);
  if (aligned) {
    edges.insert(edges.end(), p.alignment.couplings.begin(), p.alignment.couplings.end());
    pulls = p.alignment.pulls;
  }
  std::vector<int> vertices;
  progress.report(0);
  const FieldGraph graph = free_graph(edges, pulls, p.reliable, p.initial, vertices);
  progress.report(0.02);
  const auto of_free = [&](const CrossNumbers& z) {
    CrossNumbers result;
    for (const int vertex : vertices) result.push_back(z[static_cast<std::size_t>(vertex)]);
    return result;
  };
  const std::vector<CrossNumbers> starts{of_free(p.principal.z), of_free(p.initial)};
  CrossNumbers z = portfolio_start(graph, starts, progress.part(0.02, 0.7));
  Solution solution{p.initial, {}};
  solution.result =
      minimise(graph, options.max_evaluations, options.threads, z, progress.part(0.7, 1));
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    solution.z[static_cast<std::size_t>(vertices[i])] = z[i];
  }
  return solution;
}

// Takes over into z the parts in which the solution has clearly less energy, and marks them.
void keep_better_parts(const Problem& p, const CrossNumbers& solution, CrossNumbers& z,
                       std::vector<std::uint8_t>& improved) {
  const std::vector<double> before = part_energies(p.parts, p.edges, z);
  const std::vector<double> after = part_energies(p.parts, p.edges, solution);
  std::vector<std::uint8_t> better(before.size());
  for (std::size_t part = 0; part < before.size(); ++part) {
    better[part] = after[part] < before[part] - least_gain * std::abs(before[part]);
    if (better[part]) improved[part] = 1;
  }
  for (std::size_t i = 0; i < z.size(); ++i) {
    if (better[static_cast<std::size_t>(p.parts.of_vertex[i])]) z[i] = solution[i];
  }
}

// (parts) 1: some crosses are pulled or coupled by creases, boundaries or seams.
std::vector<std::uint8_t> parts_with_features(const Problem& p) {
  std::vector<std::uint8_t> has_features(static_cast<std::size_t>(p.parts.count), 0);
  const auto mark = [&](std::size_t vertex) {
    has_features[static_cast<std::size_t>(p.parts.of_vertex[vertex])] = 1;
  };
  for (std::size_t i = 0; i < p.alignment.pulls.size(); ++i) {
    if (std::norm(p.alignment.pulls[i]) > 0) mark(i);
  }
  for (const FieldEdge& edge : p.alignment.couplings) {
    mark(static_cast<std::size_t>(edge.from));
    mark(static_cast<std::size_t>(edge.to));
  }
  return has_features;
}

// Parts that features have kept from improving, although they are not parallel.
bool features_are_in_the_way(const Problem& p, const CrossNumbers& z,
                             const std::vector<std::uint8_t>& improved) {
  const std::vector<double> energies = part_energies(p.parts, p.edges, z);
  const std::vector<std::uint8_t> has_features = parts_with_features(p);
  std::vector<double> least(energies.size(), 0);
  for (const FieldEdge& edge : p.edges) {
    least[static_cast<std::size_t>(p.parts.of_vertex[static_cast<std::size_t>(edge.from)])] -= 1;
  }
  for (std::size_t part = 0; part < energies.size(); ++part) {
    const bool is_parallel = energies[part] <= least[part] * (1 - least_gain);
    if (has_features[part] && !improved[part] && !is_parallel) return true;
  }
  return false;
}

// Where the energy leaves the angle of a whole part open, features decide, else the principal
// directions.
void turn_improved_parts(const Problem& p, const Curvature& curvature,
                         std::vector<std::uint8_t> improved, CrossNumbers& z) {
  const std::vector<std::uint8_t> may_turn = parts_that_may_turn(p);
  const std::vector<std::uint8_t> has_features = parts_with_features(p);
  for (std::size_t part = 0; part < improved.size(); ++part) improved[part] &= may_turn[part];
  CrossNumbers wanted = p.alignment.pulls;
  for (std::size_t i = 0; i < z.size(); ++i) {
    if (has_features[static_cast<std::size_t>(p.parts.of_vertex[i])]) continue;
    const double anisotropy = std::abs(curvature.k1[i]) - std::abs(curvature.k2[i]);
    wanted[i] = p.principal.defined[i] ? anisotropy * p.principal.z[i] : CrossNumber(0);
  }
  turn_parts(p.parts, improved, wanted, z);
}

void describe(const Surface& surface, const Problem& p, const CrossNumbers& z, int threads,
              CrossField& field) {
  field.reference = p.frames.x;
  field.reliable = p.reliable;
  field.theta.resize(z.size());
  field.directions.resize(z.size());
  for (std::size_t i = 0; i < z.size(); ++i) {
    field.theta[i] = std::arg(z[i]) / 4;
    field.directions[i] = p.frames.direction(i, field.theta[i]);
  }
  find_singularities(surface, p.triangle_edges, p.frames, threads, field);
}

}  // namespace

void validate(const FieldOptions& options) {
  const auto require = [](bool holds, const char* message) {
    if (!holds) throw InvalidInput(message);
  };
  const auto is_share = [](double value) { return std::isfinite(value) && value >= 0; };
  require(is_share(options.parabolic_ratio), "parabolic_ratio must be finite and not negative");
  require(is_share(options.least_curvature), "least_curvature must be finite and not negative");
  require(is_share(options.largest_energy), "largest_energy must be finite and not negative");
  require(is_share(options.alignment_weight), "alignment_weight must be finite and not negative");
  const double length = options.default_direction.norm();
  require(std::isfinite(length) && length > 0, "default_direction must be finite and not zero");
  require(options.max_evaluations >= 0, "max_evaluations must not be negative");
  require(options.threads >= 0, "threads must not be negative");
}

CrossField solve_cross_field(const Surface& surface, const Curvature& curvature,
                             const FieldOptions& options, const Progress& progress) {
  validate(options);
  progress.report(0);
  Problem p = state_problem(surface, curvature, options, progress.part(0, 0.1));
  p.initial = initial_field(p);
  CrossNumbers z = p.initial;
  std::vector<std::uint8_t> improved(static_cast<std::size_t>(p.parts.count), 0);
  Solution solution = solve(p, true, options, progress.part(0.1, 0.7));
  keep_better_parts(p, solution.z, z, improved);
  CrossField field;
  field.evaluations = solution.result.evaluations;
  if (options.alignment_weight > 0 && features_are_in_the_way(p, z, improved)) {
    solution = solve(p, false, options, progress.part(0.7, 0.9));
    keep_better_parts(p, solution.z, z, improved);
    field.evaluations += solution.result.evaluations;
  }
  field.converged = solution.result.converged;
  progress.report(0.95);
  turn_improved_parts(p, curvature, improved, z);
  field.energy_initial = energy(p.edges, p.initial);
  if (energy(p.edges, z) > field.energy_initial) z = p.initial;
  field.energy = energy(p.edges, z);
  describe(surface, p, z, options.threads, field);
  return field;
}

}  // namespace illustrate
