#include "visibility/labels.h"

#include <algorithm>

#include "visibility/bases.h"
#include "visibility/least_contradiction.h"

namespace illustrate {
namespace {

// A break has the price of ten: where rays mislead along the rest of the path the rules are still
// right.
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
  const bool balanced = !path.cyclic || result.labels.residual == 0;
  const bool has_base = trusts_rules && balanced && !any_free(result.labels);
  std::vector<Evidence> evidence = outline_evidence(arrangement, arcs);
  const bool is_outer =
      std::any_of(evidence.begin(), evidence.end(), [](const Evidence& e) { return e.weight > 0; });
  if (has_base && is_outer && choose_base(evidence, path.cyclic, result)) return result;
  ask_rays(arrangement, arcs, rays, known, evidence);
  if (has_base && choose_base(evidence, path.cyclic, result)) return result;
  label_with_breaks(result, evidence, path.cyclic, trusts_rules ? broken_factor : 1);
  return result;
}

}  // namespace illustrate
