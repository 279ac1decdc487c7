#include "field/problem/prescribed.h"

#include <Eigen/Sparse>
#include <Eigen/SparseCholesky>
#include <limits>

#include "core/errors.h"
#include "field/problem/energy.h"
#include "field/singularities.h"

namespace illustrate {
namespace {

constexpr double quarter_turn = 1.57079632679489661923;

// A turn above 45 degrees is a turn of less to the other side: the sum of squares gives way to
// smaller weights until all turns are clearly below, or this often.
constexpr double largest_turn = 0.7;
constexpr int most_rounds = 12;

// The Laplacian of a closed part leaves a constant open; this share of it closes it.
constexpr double regularisation = 1e-9;

std::size_t part_of(const Surface& surface, const FieldParts& parts, int triangle) {
  return idx(parts.of_vertex[idx(surface.triangles[idx(triangle)][0])]);
}

// How far apart single singularities have to be.
enum class Apart { by_edges, by_vertices };

// Finds triangles for single singularities, none of which shares an edge with another.
class Placer {
 public:
  Placer(const Surface& surface, const TriangleEdges& edges, const FieldParts& parts)
      : surface_(surface),
        edges_(edges),
        parts_(parts),
        has_vertex_(surface.positions.size(), 0),
        has_edge_(edges.size(), 0),
        seen_in_(surface.triangles.size(), 0) {}

  // The nearest triangle in steps over edges from `start`, none where there is no room.
  int place_near(int start, Apart apart) {
    ++search_;
    std::vector<int> queue{start};
    seen_in_[idx(start)] = search_;
    for (std::size_t k = 0; k < queue.size(); ++k) {
      if (is_free(queue[k], apart)) {
        for (const int vertex : surface_.triangles[idx(queue[k])]) has_vertex_[idx(vertex)] = 1;
        for (const int edge : edges_.of_triangle[idx(queue[k])]) has_edge_[idx(edge)] = 1;
        return queue[k];
      }
      for (const int next : surface_.neighbours[idx(queue[k])]) {
        if (next == none || seen_in_[idx(next)] == search_ ||
            part_of(surface_, parts_, next) != part_of(surface_, parts_, start)) {
          continue;
        }
        seen_in_[idx(next)] = search_;
        queue.push_back(next);
      }
    }
    return none;
  }

 private:
  bool is_free(int triangle, Apart apart) const {
    const Triangle& t = surface_.triangles[idx(triangle)];
    const auto& sides = edges_.of_triangle[idx(triangle)];
    const auto is_taken_edge = [&](int edge) { return edge == none || has_edge_[idx(edge)]; };
    const auto is_taken_vertex = [&](int vertex) { return has_vertex_[idx(vertex)] != 0; };
    return std::none_of(sides.begin(), sides.end(), is_taken_edge) &&
           (apart == Apart::by_edges || std::none_of(t.begin(), t.end(), is_taken_vertex));
  }

  const Surface& surface_;
  const TriangleEdges& edges_;
  const FieldParts& parts_;
  std::vector<std::uint8_t> has_vertex_, has_edge_;
  std::vector<int> seen_in_;
  int search_ = 0;
};

// Throws for closed parts whose wanted indices do not sum to what their triangles' excess asks for.
void check_sums(const Surface& surface, const TriangleEdges& edges, const FieldParts& parts,
                const std::vector<double>& excess, const PlacedSingularities& placed) {
  std::vector<double> sums(idx(parts.count), 0), needed(idx(parts.count), 0);
  std::vector<int> meshes(idx(parts.count), 0);
  std::vector<std::uint8_t> is_closed = placed.has_parts;
  for (std::size_t t = 0; t < excess.size(); ++t) {
    const std::size_t part = part_of(surface, parts, static_cast<int>(t));
    sums[part] += placed.index_of_triangle[t];
    needed[part] += excess[t] / quarter_turn;
    meshes[part] = surface.triangle_objects[t];
  }
  for (std::size_t e = 0; e < edges.size(); ++e) {
    if (edges.faces[e] == 1) is_closed[idx(parts.of_vertex[idx(edges.vertices[e][0])])] = 0;
  }
  std::string wrong;
  for (std::size_t part = 0; part < sums.size(); ++part) {
    const auto sum = std::lround(sums[part]), four_chi = std::lround(needed[part]);
    if (!is_closed[part] || sum == four_chi) continue;
    wrong += (wrong.empty() ? "" : "; ") + std::string("part ") + std::to_string(part) +
             " (closed, of mesh " + std::to_string(meshes[part]) + ") has " + std::to_string(sum) +
             ", but must have 4 chi = " + std::to_string(four_chi);
  }
  if (!wrong.empty()) {
    throw InvalidInput("singularities: the indices of a part do not sum to 4 chi: " + wrong);
  }
}

// The triangles at an edge and how its turn counts in each.
struct EdgeSides {
  std::array<int, 2> unknowns{none, none};
  std::array<double, 2> signs{0, 0};
};

// (m) of the chosen triangles; `unknowns` (t) numbers them.
std::vector<EdgeSides> sides_of_edges(const Surface& surface, const TriangleEdges& edges,
                                      const std::vector<int>& unknowns) {
  std::vector<EdgeSides> sides(edges.size());
  for (std::size_t t = 0; t < unknowns.size(); ++t) {
    if (unknowns[t] == none) continue;
    for (int k = 0; k < 3; ++k) {
      EdgeSides& edge = sides[idx(edges.of_triangle[t][idx(k)])];
      const std::size_t side = edge.unknowns[0] == none ? 0 : 1;
      edge.unknowns[side] = unknowns[t];
      edge.signs[side] = side_sign(surface, t, k);
    }
  }
  return sides;
}

using Matrix = Eigen::SparseMatrix<double>;

Matrix laplacian(const std::vector<EdgeSides>& sides, const std::vector<double>& weights,
                 Eigen::Index size) {
  std::vector<Eigen::Triplet<double>> entries;
  for (Eigen::Index i = 0; i < size; ++i) entries.emplace_back(i, i, regularisation);
  for (std::size_t e = 0; e < sides.size(); ++e) {
    for (std::size_t a = 0; a < 2; ++a) {
      for (std::size_t b = 0; b <= a; ++b) {
        const int row = sides[e].unknowns[a], column = sides[e].unknowns[b];
        if (row == none || column == none) continue;
        entries.emplace_back(std::max(row, column), std::min(row, column),
                             weights[e] * sides[e].signs[a] * sides[e].signs[b]);
      }
    }
  }
  Matrix matrix(size, size);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

// Lowers the weights of edges that turn too much; false where there is none.
bool relax(const std::vector<double>& turns, std::vector<double>& weights) {
  bool any = false;
  for (std::size_t e = 0; e < turns.size(); ++e) {
    const double share = largest_turn / std::abs(turns[e]);
    if (!(share < 1)) continue;
    weights[e] *= share * share;
    any = true;
  }
  return any;
}

}  // namespace

PlacedSingularities place_singularities(const Surface& surface, const TriangleEdges& edges,
                                        const FieldParts& parts, const Bvh& bvh,
                                        const std::vector<double>& excess,
                                        const PrescribedSingularities& prescribed) {
  PlacedSingularities placed{std::vector<int>(surface.triangles.size(), 0),
                             std::vector<std::uint8_t>(idx(parts.count), 0)};
  Placer placer(surface, edges, parts);
  for (std::size_t k = 0; k < prescribed.positions.size(); ++k) {
    const SurfacePoint foot =
        bvh.nearest(prescribed.positions[k], std::numeric_limits<double>::max());
    for (int left = prescribed.indices[k]; left != 0; left -= left > 0 ? 1 : -1) {
      const Apart apart = left == prescribed.indices[k] ? Apart::by_edges : Apart::by_vertices;
      const int triangle = foot.triangle == none ? none : placer.place_near(foot.triangle, apart);
      if (triangle == none) {
        throw InvalidInput("singularities: there is no room for singularities[" +
                           std::to_string(k) + "]: its part of the surface has too few triangles");
      }
      placed.index_of_triangle[idx(triangle)] = left > 0 ? 1 : -1;
      placed.has_parts[part_of(surface, parts, triangle)] = 1;
    }
  }
  check_sums(surface, edges, parts, excess, placed);
  return placed;
}

std::vector<double> least_turns(const Surface& surface, const TriangleEdges& edges,
                                const std::vector<double>& excess, const FieldParts& parts,
                                const PlacedSingularities& placed) {
  std::vector<int> unknowns(surface.triangles.size(), none);
  std::vector<double> wanted;
  for (std::size_t t = 0; t < unknowns.size(); ++t) {
    const auto& sides = edges.of_triangle[t];
    const bool is_repeated = std::find(sides.begin(), sides.end(), none) != sides.end();
    if (is_repeated || !placed.has_parts[part_of(surface, parts, static_cast<int>(t))]) continue;
    unknowns[t] = static_cast<int>(wanted.size());
    wanted.push_back(quarter_turn * placed.index_of_triangle[t] - excess[t]);
  }
  const std::vector<EdgeSides> sides = sides_of_edges(surface, edges, unknowns);
  std::vector<double> weights(edges.size(), 1), turns(edges.size(), 0);
  const auto size = static_cast<Eigen::Index>(wanted.size());
  const Eigen::Map<const Eigen::VectorXd> target(wanted.data(), size);
  Eigen::SimplicialLDLT<Matrix> solver;
  for (int round = 0; round < most_rounds; ++round) {
    const Matrix matrix = laplacian(sides, weights, size);
    // From round to round only the weights change.
    if (round == 0) solver.analyzePattern(matrix);
    solver.factorize(matrix);
    const Eigen::VectorXd potential = solver.solve(target);
    for (std::size_t e = 0; e < turns.size(); ++e) {
      turns[e] = 0;
      for (std::size_t s = 0; s < 2; ++s) {
        const int unknown = sides[e].unknowns[s];
        if (unknown != none) turns[e] += weights[e] * sides[e].signs[s] * potential[unknown];
      }
    }
    if (!relax(turns, weights)) break;
  }
  return turns;
}

void comb_along_tree(const std::vector<FieldEdge>& edges, const FieldParts& parts,
                     const std::vector<std::uint8_t>& chosen_parts, CrossNumbers& z) {
  std::vector<std::uint8_t> is_done(z.size());
  for (std::size_t i = 0; i < z.size(); ++i) is_done[i] = !chosen_parts[idx(parts.of_vertex[i])];
  std::vector<int> vertices;
  const FieldGraph graph = free_graph(edges, CrossNumbers(z.size(), 0), is_done, z, vertices);
  const auto of_graph = [&](std::size_t i) { return idx(vertices[i]); };
  std::vector<std::size_t> queue;
  for (std::size_t root = 0; root < graph.size(); ++root) {
    if (is_done[of_graph(root)]) continue;
    is_done[of_graph(root)] = 1;
    queue.assign(1, root);
    for (std::size_t k = 0; k < queue.size(); ++k) {
      for (const Link& link : graph.links[queue[k]]) {
        const std::size_t other = of_graph(idx(link.vertex));
        if (is_done[other]) continue;
        is_done[other] = 1;
        const CrossNumber back = normalized(mirrored_if(!link.mirrored, link.transport), 1);
        z[other] = product(back, mirrored_if(link.mirrored, z[of_graph(queue[k])]));
        queue.push_back(idx(link.vertex));
      }
    }
  }
}

}  // namespace illustrate
