// What rays say of the arcs of a view.
#pragma once

#include "core/progress.h"
#include "visibility/evidence/layer_rays.h"
#include "visibility/labels/path_arcs.h"

namespace illustrate {

// Evidence::unsure where nothing is known but that there are `layers` at least.
constexpr int any_more = 1 << 20;

// What rays say of an arc: so many layers, or up to `unsure` more, worth so many pixels of line.
// Weight 0: nothing.
struct Evidence {
  int layers = 0;
  int unsure = 0;
  double weight = 0;
  bool beside_nothing = false;
};

// What a label with more layers than the ray met contradicts of its weight (prices.h).
double missed_share(const Evidence& evidence);

// (paths)(arcs) Arcs at the outside of the drawing have 0 layers for certain, those on covered or
// buried strands, or next to them on one path of the surface, one at least. Of each path the
// longest of the others are asked, whatever the size of the view: a path that nobody asks would be
// taken for visible. The same for any number of threads (0: all cores). Throws Cancelled through
// `progress`.
std::vector<std::vector<Evidence>> gather_evidence(const Arrangement& arrangement,
                                                   const std::vector<std::vector<PathArc>>& arcs,
                                                   LayerRays& rays, int threads,
                                                   const Progress& progress);

// Asks all arcs of these paths of which nothing is known yet: where labels break a rule of a path,
// what is known of five of its arcs does not tell the others.
void ask_all_arcs(const std::vector<int>& paths, const Arrangement& arrangement,
                  const std::vector<std::vector<PathArc>>& arcs, LayerRays& rays, int threads,
                  const Progress& progress, std::vector<std::vector<Evidence>>& evidence);

}  // namespace illustrate
