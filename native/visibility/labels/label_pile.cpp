#include "visibility/labels/label_pile.h"

#include "contour/network/unseen.h"
#include "visibility/build_graph.h"

namespace illustrate {

LabelledGraph label_pile(const CurveNetwork& network, const Surface& surface, const Camera& camera,
                         int threads) {
  // Samples know nothing of each other, so no rule may hold between them: nothing is tied, and a
  // cusp is where two curves meet.
  CurveNetwork loose = network;
  loose.ties.clear();
  for (NetworkNode& node : loose.nodes) {
    if (node.kind == NodeKind::cusp) node.kind = NodeKind::joint;
  }
  const CurveNetwork cut =
      cut_at_unseen(Unseen(surface, camera, Unseen::Evidence::likely, threads), loose);
  const Arrangement apart = arrange_apart(cut, camera);
  std::vector<LabelledPath> labels;
  for (const Path& path : apart.paths()) {
    LabelledPath labelled{path_arcs(apart, path), {}};
    const bool is_hidden = cut.strands[idx(path.strands.front())].sight == Sight::buried;
    labelled.layers.assign(labelled.arcs.size(), is_hidden ? 1 : 0);
    labels.push_back(std::move(labelled));
  }
  return build_graph(apart, labels, surface);
}

}  // namespace illustrate
