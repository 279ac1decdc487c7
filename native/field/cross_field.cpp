#include "field/cross_field.h"

#include "core/errors.h"
#include "core/parallel.h"
#include "field/last_field.h"
#include "field/problem/problem.h"
#include "field/search/search.h"
#include "field/singularities.h"

namespace illustrate {
namespace {

// A part leaves its start only for a share of energy that rounding cannot explain.
constexpr double least_gain = 1e-9;

enum class Pulls { all, guides, none };  // all: of features, too

// (n) 1: held, or nothing is to be gained, since the part is parallel and follows its guides.
std::vector<std::uint8_t> settled_vertices(const FieldProblem& p) {
  const std::vector<double> energies = part_energies(p, p.initial), least = least_energies(p);
  std::vector<std::uint8_t> is_settled(p.reliable.size());
  for (std::size_t i = 0; i < is_settled.size(); ++i) {
    const std::size_t part = idx(p.parts.of_vertex[i]);
    is_settled[i] = p.is_held(i) || energies[part] <= least[part] * (1 - least_gain);
  }
  return is_settled;
}

FieldGraph graph_of(const FieldProblem& p, Pulls used, const std::vector<std::uint8_t>& is_held,
                    const CrossNumbers& z, std::vector<int>& vertices, const Progress& progress) {
  std::vector<FieldEdge> edges;
  CrossNumbers pulls(z.size(), 0);
  if (used != Pulls::none) pulls = p.guide_pulls;
  if (used != Pulls::all) return free_graph(p.edges, pulls, is_held, z, vertices, progress);
  for (std::size_t i = 0; i < pulls.size(); ++i) pulls[i] += p.alignment.pulls[i];
  if (p.alignment.couplings.empty())
    return free_graph(p.edges, pulls, is_held, z, vertices, progress);
  edges = p.edges;
  edges.insert(edges.end(), p.alignment.couplings.begin(), p.alignment.couplings.end());
  return free_graph(edges, pulls, is_held, z, vertices, progress);
}

// A minimum near `nearby` (n), or where that is empty, the best that the search finds. Settled
// vertices stay as they are at the start.
SearchResult solve(const FieldProblem& p, Pulls pulls, const CrossNumbers& nearby,
                   const std::vector<std::uint8_t>& is_settled, const FieldOptions& options,
                   const Progress& progress) {
  progress.report(0);
  std::vector<int> vertices;
  const FieldGraph graph =
      graph_of(p, pulls, is_settled, p.initial, vertices, progress.part(0, 0.02));
  const auto of_free = [&](const CrossNumbers& z) {
    CrossNumbers result;
    if (z.empty()) return result;
    for (const int vertex : vertices) result.push_back(z[idx(vertex)]);
    return result;
  };
  const SearchStarts starts{of_free(p.initial), of_free(p.principal.z), of_free(nearby)};
  const SearchResult found = search_crosses(graph, starts, options, progress.part(0.02, 1));
  SearchResult whole{p.initial, found.minimise};
  for (std::size_t i = 0; i < vertices.size(); ++i) whole.z[idx(vertices[i])] = found.z[i];
  return whole;
}

// Takes over into z the parts in which the solution has clearly less energy, and marks them.
void keep_better_parts(const FieldProblem& p, const CrossNumbers& solution, CrossNumbers& z,
                       std::vector<std::uint8_t>& improved) {
  const std::vector<double> before = part_energies(p, z), after = part_energies(p, solution);
  std::vector<std::uint8_t> better(before.size());
  for (std::size_t part = 0; part < before.size(); ++part) {
    better[part] = after[part] < before[part] - least_gain * std::abs(before[part]);
    if (better[part]) improved[part] = 1;
  }
  for (std::size_t i = 0; i < z.size(); ++i) {
    if (better[idx(p.parts.of_vertex[i])]) z[i] = solution[i];
  }
}

// (n) 0: in a part that features have kept from improving, although it is not parallel.
std::vector<std::uint8_t> settled_or_improved(const FieldProblem& p, const CrossNumbers& z,
                                              const std::vector<std::uint8_t>& is_settled,
                                              const std::vector<std::uint8_t>& improved) {
  const std::vector<std::uint8_t> has_features = parts_with_features(p);
  const std::vector<double> energies = part_energies(p, z), least = least_energies(p);
  std::vector<std::uint8_t> is_done = is_settled;
  for (std::size_t i = 0; i < is_done.size(); ++i) {
    const std::size_t part = idx(p.parts.of_vertex[i]);
    const bool is_parallel = energies[part] <= least[part] * (1 - least_gain);
    if (!has_features[part] || improved[part] || is_parallel) is_done[i] = 1;
  }
  return is_done;
}

// A part that has more energy than at the start goes back there.
void keep_initial_where_better(const FieldProblem& p, CrossNumbers& z) {
  const std::vector<double> initial = part_energies(p, p.initial), energies = part_energies(p, z);
  for (std::size_t i = 0; i < z.size(); ++i) {
    const std::size_t part = idx(p.parts.of_vertex[i]);
    if (energies[part] > initial[part]) z[i] = p.initial[i];
  }
}

// Where the energy leaves the angle of a whole part open, features decide, else the principal
// directions.
void turn_improved_parts(const FieldProblem& p, const Curvature& curvature,
                         std::vector<std::uint8_t> improved, CrossNumbers& z) {
  const std::vector<std::uint8_t> may_turn = parts_that_may_turn(p);
  const std::vector<std::uint8_t> has_features = parts_with_features(p);
  for (std::size_t part = 0; part < improved.size(); ++part) improved[part] &= may_turn[part];
  CrossNumbers wanted = p.alignment.pulls;
  for (std::size_t i = 0; i < z.size(); ++i) {
    const std::size_t part = idx(p.parts.of_vertex[i]);
    if (p.guide_pulls[i] != CrossNumber(0)) improved[part] = 0;
    if (has_features[part]) continue;
    const double anisotropy = std::abs(curvature[i].k1) - std::abs(curvature[i].k2);
    wanted[i] = p.principal.defined[i] ? anisotropy * p.principal.z[i] : CrossNumber(0);
  }
  turn_parts(p.parts, improved, wanted, z);
}

// (parts) 1: where the singularities are not those that are prescribed; `triangle` becomes one of
// those that differ, or none.
std::vector<std::uint8_t> disobedient_parts(const Surface& surface, const FieldProblem& p,
                                            const std::vector<int>& indices, int& triangle) {
  std::vector<std::uint8_t> disobedient(idx(p.parts.count), 0);
  triangle = none;
  for (std::size_t t = 0; t < indices.size(); ++t) {
    const std::size_t part = idx(p.parts.of_vertex[idx(surface.triangles[t][0])]);
    if (!p.prescribed.has_parts[part] || indices[t] == p.prescribed.index_of_triangle[t]) continue;
    disobedient[part] = 1;
    triangle = static_cast<int>(t);
  }
  return disobedient;
}

// Prescribed singularities come before everything that pulls: parts that would have others are
// solved again without features; they get the parallel field that they started from where that has
// the right ones, and else what is parallel without guides.
void obey_prescription(const Surface& surface, const FieldProblem& p, const FieldOptions& options,
                       CrossNumbers& z, const Progress& progress) {
  const std::vector<FieldEdge> plain = plain_edges(p);
  int triangle = none;
  std::vector<std::uint8_t> parts, is_held(z.size());
  const auto obeys = [&] {
    const std::vector<int> indices =
        triangle_indices(surface, p.triangle_edges, plain, p.excess, z, options.threads, progress);
    parts = disobedient_parts(surface, p, indices, triangle);
    for (std::size_t i = 0; i < z.size(); ++i) is_held[i] = !parts[idx(p.parts.of_vertex[i])];
    return triangle == none;
  };
  const auto take_over = [&](const CrossNumbers& other) {
    for (std::size_t i = 0; i < z.size(); ++i) {
      if (!is_held[i]) z[i] = other[i];
    }
  };
  const auto solved = [&](Pulls pulls) {
    CrossNumbers again = solve(p, pulls, p.initial, is_held, options, progress).z;
    if (pulls == Pulls::guides) return again;
    std::vector<std::uint8_t> may_turn = parts_that_may_turn(p);
    for (std::size_t part = 0; part < parts.size(); ++part) may_turn[part] &= parts[part];
    turn_parts(p.parts, may_turn, p.guide_pulls, again);
    return again;
  };
  if (obeys()) return;
  take_over(solved(Pulls::guides));
  if (obeys()) return;
  take_over(p.initial);
  if (obeys()) return;
  take_over(solved(Pulls::none));
  if (obeys()) return;
  const Vec3 at = position_at(surface, {triangle, 1.0 / 3, 1.0 / 3});
  throw InvalidInput("singularities: the mesh is too coarse for them near (" +
                     std::to_string(at.x()) + ", " + std::to_string(at.y()) + ", " +
                     std::to_string(at.z()) + "): subdivide it, or move them apart");
}

double total(const std::vector<double>& energies) {
  double sum = 0;
  for (const double energy : energies) sum += energy;
  return sum;
}

// (objects) what their parts have of the energy.
std::vector<double> energies_of_objects(const Surface& surface, const FieldProblem& p,
                                        const CrossNumbers& z) {
  std::vector<int> objects(idx(p.parts.count), 0);
  for (std::size_t v = 0; v < z.size(); ++v) {
    objects[idx(p.parts.of_vertex[v])] = surface.objects[v];
  }
  const std::vector<double> energies = part_energies(p, z);
  std::vector<double> result(surface.object_is_smooth.size(), 0);
  for (std::size_t part = 0; part < objects.size(); ++part) {
    result[idx(objects[part])] += energies[part];
  }
  return result;
}

// The branch that is a principal direction where the vertex is reliable.
void describe(const Surface& surface, const FieldProblem& p, const CrossNumbers& z, int threads,
              const Progress& progress, CrossField& field) {
  field.reference = p.frames.x;
  field.reliable = p.reliable;
  field.theta.resize(z.size());
  field.directions.resize(z.size());
  parallel_for(z.size(), threads, progress.part(0, 0.3), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const bool is_kept = field.reliable[i] != 0;
      // arg(z) / 4 knows the cross, not which of its four directions the principal one is.
      field.theta[i] = is_kept ? std::arg(p.principal.directions[i]) : std::arg(z[i]) / 4;
      field.directions[i] = p.frames.direction(i, field.theta[i]);
    }
  });
  const std::vector<FieldEdge> plain = p.turns.empty() ? std::vector<FieldEdge>() : plain_edges(p);
  const std::vector<int> indices =
      triangle_indices(surface, p.triangle_edges, plain.empty() ? p.edges : plain, p.excess, z,
                       threads, progress.part(0.3, 1));
  for (std::size_t t = 0; t < indices.size(); ++t) {
    if (indices[t] == 0) continue;
    field.singular_triangles.push_back(static_cast<int>(t));
    field.singular_indices.push_back(indices[t]);
    field.singular_positions.push_back(
        position_at(surface, {static_cast<int>(t), 1.0 / 3, 1.0 / 3}));
  }
}

// Parts of a mesh that deforms in which no guide or prescribed singularity asks for another field.
std::vector<std::uint8_t> parts_that_go_on(const FieldProblem& p, bool deforms) {
  std::vector<std::uint8_t> go_on(idx(p.parts.count), deforms && p.turns.empty());
  for (std::size_t i = 0; i < p.guide_pulls.size(); ++i) {
    if (p.guide_pulls[i] != CrossNumber(0)) go_on[idx(p.parts.of_vertex[i])] = 0;
  }
  return go_on;
}

// What rests in them keeps its cross of the frame before.
void hold_resting(const std::vector<std::uint8_t>& go_on, const std::vector<std::uint8_t>& rests,
                  const CrossNumbers& last, FieldProblem& p,
                  std::vector<std::uint8_t>& is_settled) {
  for (std::size_t i = 0; i < rests.size(); ++i) {
    if (!rests[i] || !go_on[idx(p.parts.of_vertex[i])] || p.is_held(i)) continue;
    p.initial[i] = last[i];
    is_settled[i] = 1;
  }
}

// Near which field the search is to stay; empty: anywhere.
CrossNumbers start_of(const Surface& surface, const FieldProblem& p, const FieldOptions& options,
                      const FieldAids& aids, const Progress& progress) {
  CrossNumbers last = last_crosses(surface, p.frames, p.triangle_edges, aids, progress);
  if (!last.empty() || options.start == FieldStart::search) return last;
  return p.initial;
}

}  // namespace

void validate(const FieldOptions& options) {
  const auto require = [](bool holds, const std::string& message) {
    if (!holds) throw InvalidInput(message);
  };
  const auto is_share = [](double value) { return std::isfinite(value) && value >= 0; };
  const auto are_finite = [](const Points& points) {
    return std::all_of(points.begin(), points.end(), [](const Vec3& p) { return p.allFinite(); });
  };
  require(is_share(options.parabolic_ratio), "parabolic_ratio must be finite and not negative");
  require(is_share(options.least_curvature), "least_curvature must be finite and not negative");
  require(is_share(options.largest_energy), "largest_energy must be finite and not negative");
  require(is_share(options.alignment_weight), "alignment_weight must be finite and not negative");
  const double length = options.default_direction.norm();
  require(std::isfinite(length) && length > 0, "default_direction must be finite and not zero");
  for (std::size_t g = 0; g < options.guides.size(); ++g) {
    const Guide& guide = options.guides[g];
    const std::string name = "guides[" + std::to_string(g) + "]";
    require(is_share(guide.weight), name + ".weight must be finite and not negative");
    require(are_finite(guide.points), name + ".points must be finite");
  }
  require(is_share(options.guide_radius), "guide_radius must be finite and not negative");
  require(options.singularities.positions.size() == options.singularities.indices.size(),
          "singularities must have as many indices as positions");
  require(are_finite(options.singularities.positions), "singularities: positions must be finite");
  require(options.max_evaluations >= 0, "max_evaluations must not be negative");
  require(options.threads >= 0, "threads must not be negative");
}

CrossField solve_cross_field(const Surface& surface, const Curvature& curvature,
                             const FieldOptions& options, const FieldAids& aids,
                             const Progress& progress) {
  validate(options);
  progress.report(0);
  FieldProblem p = state_problem(surface, curvature, options, aids, progress.part(0, 0.15));
  const CrossNumbers nearby = start_of(surface, p, options, aids, progress.part(0.15, 0.2));
  std::vector<std::uint8_t> is_settled = settled_vertices(p);
  const std::vector<std::uint8_t> rests = resting_vertices(surface, p.triangle_edges, aids);
  const std::vector<std::uint8_t> go_on = parts_that_go_on(p, !rests.empty());
  hold_resting(go_on, rests, nearby, p, is_settled);
  CrossNumbers z = p.initial;
  std::vector<std::uint8_t> improved(idx(p.parts.count), 0);
  CrossField field;
  const auto improve = [&](Pulls pulls, const std::vector<std::uint8_t>& is_done,
                           const Progress& part) {
    if (std::find(is_done.begin(), is_done.end(), 0) == is_done.end()) return;
    const SearchResult found = solve(p, pulls, nearby, is_done, options, part);
    keep_better_parts(p, found.z, z, improved);
    field.converged = field.converged && found.minimise.converged;
    field.evaluations += found.minimise.evaluations;
  };
  field.converged = true;
  // With the pulls of features first. The energy that counts is without them: where they have kept
  // a part from less of it, once more without.
  improve(Pulls::all, is_settled, progress.part(0.2, 0.7));
  progress.report(0.7);
  if (options.alignment_weight > 0) {
    improve(Pulls::guides, settled_or_improved(p, z, is_settled, improved),
            progress.part(0.7, 0.85));
  }
  progress.report(0.85);
  for (std::size_t part = 0; part < go_on.size(); ++part) improved[part] &= !go_on[part];
  turn_improved_parts(p, curvature, improved, z);
  keep_initial_where_better(p, z);
  field.energy_initial = total(part_energies(p, p.initial));
  progress.report(0.87);
  if (!p.turns.empty()) obey_prescription(surface, p, options, z, progress.part(0.87, 0.9));
  field.energy = total(part_energies(p, z));
  field.object_energies = energies_of_objects(surface, p, z);
  field.object_energies_initial = energies_of_objects(surface, p, p.initial);
  describe(surface, p, z, options.threads, progress.part(0.9, 1), field);
  return field;
}

CrossField diagonals(const Surface& surface, CrossField field) {
  constexpr double eighth = 0.78539816339744831;
  for (std::size_t v = 0; v < field.directions.size(); ++v) {
    field.theta[v] += eighth;
    Vec3& direction = field.directions[v];
    direction = std::sqrt(0.5) * (direction + surface.normals[v].cross(direction));
  }
  return field;
}

}  // namespace illustrate
