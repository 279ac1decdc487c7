// Aggregated vertices: smaller and smaller graphs with the same energy up to a constant, for
// crosses that agree within each aggregate. A departure from section 5: minimising from the
// principal directions ends in a bad basin.
#pragma once

#include "core/progress.h"
#include "field/problem/energy.h"

namespace illustrate {

// How the cross of a vertex follows from its aggregate's: z = turn z_aggregate, mirrored first
// where asked for.
struct Gauge {
  int aggregate = 0;
  bool mirrored = false;
  CrossNumber turn = 1;
};

// How the crosses of a pair are held together.
enum class Pairing {
  parallel,   // as their edge asks for
  unchanged,  // as they are where all crosses are 1: what is coarse then is a change
};

// Pairs of vertices, greedily in order along the strongest edge, become the vertices of the next
// graph. gauges: (n) of the finer graph.
FieldGraph coarsen(const FieldGraph& fine, Pairing pairing, std::vector<Gauge>& gauges,
                   const Progress& progress);

// A graph and its coarser ones. Level 0 is the given graph, which has to live as long.
class Hierarchy {
 public:
  // Coarsens until at most `coarse_size` vertices are left, or nothing more can be joined.
  Hierarchy(const FieldGraph& finest, std::size_t coarse_size, Pairing pairing,
            const Progress& progress);

  std::size_t coarsest() const { return coarser_.size(); }
  const FieldGraph& graph(std::size_t level) const {
    return level == 0 ? *finest_ : coarser_[level - 1];
  }

  // Crosses of level 0 to the coarsest level.
  CrossNumbers restricted(CrossNumbers z) const;
  // Crosses of level + 1 to this level.
  CrossNumbers prolonged(const CrossNumbers& z, std::size_t level) const;

 private:
  const FieldGraph* finest_;
  std::vector<FieldGraph> coarser_;
  std::vector<std::vector<Gauge>> gauges_;  // of each level but the coarsest
};

}  // namespace illustrate
