#include "visibility/labels.h"

#include <algorithm>

#include "visibility/bases.h"
#include "visibility/least_contradiction.h"

namespace illustrate {
namespace {

// A path whose changes sum to zero hardly needs a break. Any other one needs one, at the price of
// ten: where rays mislead along the rest of it the rules are still right.
constexpr double balanced_factor = 1e5;
constexpr double broken_factor = 10;

bool any_free(const PathLabels& labels) {
  return std::any_of(labels.arcs.begin(), labels.arcs.end(),
                     [](const PathArc& arc) { return arc.starts_free; });
}

}  // namespace

LabelledPath label_path(const Arrangement& arrangement, const Path& path, bool trusts_rules,
                        LayerRays& rays, KnownEvidence& known) {
  LabelledPath result;
  result.labels = relative_labels(arrangement, path);
  const std::vector<PathArc>& arcs = result.labels.arcs;
  const bool balanced = trusts_rules && (!path.cyclic || result.labels.residual == 0);
  const bool has_base = balanced && !any_free(result.labels);
  std::vector<Evidence> evidence = outline_evidence(arrangement, arcs);
  const bool is_outer =
      std::any_of(evidence.begin(), evidence.end(), [](const Evidence& e) { return e.weight > 0; });
  if (has_base && is_outer && choose_base(evidence, result)) return result;
  ask_rays(arrangement, arcs, rays, known, evidence);
  if (has_base && choose_base(evidence, result)) return result;
  const double dear = !trusts_rules ? 1 : path.cyclic && balanced ? balanced_factor : broken_factor;
  label_with_breaks(result, evidence, path.cyclic, dear);
  return result;
}

}  // namespace illustrate
