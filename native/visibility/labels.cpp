#include "visibility/labels.h"

#include <algorithm>

#include "visibility/bases.h"
#include "visibility/least_contradiction.h"

namespace illustrate {
namespace {

constexpr double balanced_factor = 1e5;  // a path whose changes sum to zero hardly needs a break

bool any_free(const PathLabels& labels) {
  return std::any_of(labels.arcs.begin(), labels.arcs.end(),
                     [](const PathArc& arc) { return arc.starts_free; });
}

}  // namespace

LabelledPath label_path(const Arrangement& arrangement, const Path& path, bool trusts_rules,
                        LayerRays& rays, KnownEvidence& known) {
  LabelledPath result;
  result.labels = relative_labels(arrangement, path);
  const std::vector<Evidence> evidence =
      gather_evidence(arrangement, result.labels.arcs, rays, known);
  const bool balanced = trusts_rules && path.cyclic && result.labels.residual == 0;
  if (balanced && !any_free(result.labels) && choose_base(evidence, result)) return result;
  label_with_breaks(result, evidence, path.cyclic, balanced ? balanced_factor : 1);
  return result;
}

}  // namespace illustrate
