// The energy of a cross field and its gradient (paper section 5).
//
// With u = 4 theta and z = exp(i u) the paper's -cos 4((theta_i - phi_ij) - (theta_j - phi_ji)) is
// -Re(conj(z_i) r_ij z_j), r_ij = exp(i c_ij): one constant complex number for each edge.
#pragma once

#include "core/progress.h"
#include "core/ragged.h"
#include "field/problem/edges.h"

namespace illustrate {

// An edge as one of its ends sees it.
struct Link {
  CrossNumber transport = 1;
  int vertex = 0;
  bool mirrored = false;
};

// The crosses that may move. Those that are held fixed, and whatever else attracts a cross, are in
// `pulls`. E = - sum over edges of Re(conj(z_i) r_ij z_j) - sum over vertices of Re(conj(z_i)
// pull_i).
struct FieldGraph {
  Ragged<Link> links;           // (n) of each vertex; every edge stands at both of its ends
  CrossNumbers pulls;           // (n)
  std::vector<double> weights;  // (n) sum of the weights of the edges and pulls of each vertex

  std::size_t size() const { return pulls.size(); }

  // Sum of everything that attracts vertex i; the energy of i alone is -Re(conj(z_i) attraction).
  CrossNumber attraction(std::size_t i, const CrossNumbers& z) const {
    CrossNumber sum = pulls[i];
    for (const Link& link : links[i]) {
      const CrossNumber& other = z[static_cast<std::size_t>(link.vertex)];
      sum += product(link.transport, mirrored_if(link.mirrored, other));
    }
    return sum;
  }
};

// edges: between n vertices; pulls: (n); held: (n) 1 where z is fixed. `free_vertices` gets the
// vertex that each vertex of the graph stands for.
FieldGraph free_graph(const std::vector<FieldEdge>& edges, const CrossNumbers& pulls,
                      const std::vector<std::uint8_t>& held, const CrossNumbers& z,
                      std::vector<int>& free_vertices, const Progress& progress = {});

// E at u (n) radians; dE/du into `gradient` (n) unless null. Terms are added in a fixed order.
double energy(const FieldGraph& graph, const double* u, double* gradient, int threads);

// E of crosses over edges alone.
double energy(const std::vector<FieldEdge>& edges, const CrossNumbers& z);

// -Re(conj(z_from) r z_to) of one edge.
double edge_energy(const FieldEdge& edge, const CrossNumbers& z);

}  // namespace illustrate
