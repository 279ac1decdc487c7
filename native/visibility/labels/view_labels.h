// Labels of all arcs of a view at once: what rays say and what the rules ask, as one convex problem
// (label_problem.h).
//
// Unknown is the number of layers in front of each stretch of a path between two places where it
// passes behind another curve, or has a cusp. Asked are
// - the layers that rays count, by length of line;
// - at a cusp and behind a crossing, that the label changes as it must;
// - behind a crossing, that no side has fewer layers than the front curve and its surface give it:
//   not where both curves end there, as at a beam's corner in a wall's face, which is between them
//   or is not, nor where the front curve is under cover and only a least number is known of it.
// What a node asks has a price in proportion to what hangs on it (extents.h): a lens that only the
// interpolation of the contour has made gives way, an outline does not.
#pragma once

#include "visibility/arrangement/extents.h"
#include "visibility/evidence/evidence.h"
#include "visibility/labels/label_problem.h"
#include "visibility/labels/labelled_path.h"

namespace illustrate {

struct ViewProblem {
  LabelProblem problem;
  std::vector<std::vector<int>> unknowns;  // (paths)(arcs)
  std::vector<int> start;                  // (unknowns) labels near what rays say
  // (unknowns) 1: under cover, so that its label is only a least one, and says nothing of what it
  // hides.
  std::vector<std::uint8_t> at_least;
};

ViewProblem state_labels(const Arrangement& arrangement,
                         const std::vector<std::vector<PathArc>>& arcs,
                         const std::vector<std::vector<Evidence>>& evidence);

// Paths, ascending, with a cusp or a crossing behind which labels do not change as they must.
std::vector<int> contradicted_paths(const Arrangement& arrangement,
                                    const std::vector<std::vector<PathArc>>& arcs,
                                    const ViewProblem& view, const std::vector<int>& labels);

// (paths) The labels of all arcs. Crossings whose rules they break are demoted to joints of their
// back strand, cusps that they contradict become joints: `repairs` counts them. No rule is broken
// anywhere else.
std::vector<LabelledPath> settle_labels(Arrangement& arrangement,
                                        const std::vector<std::vector<PathArc>>& arcs,
                                        const ViewProblem& view, const std::vector<int>& labels,
                                        std::int64_t& repairs);

}  // namespace illustrate
