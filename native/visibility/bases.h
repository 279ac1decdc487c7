// The bases of balanced paths: one number fixes all labels of each.
#pragma once

#include "visibility/evidence.h"
#include "visibility/labelled_path.h"

namespace illustrate {

// Gives a path whose changes sum to zero the base that contradicts the rays least, and with it its
// labels. None is negative: where rays are much surer of a lower base, at which some would be, the
// path gets that, those labels are 0, and it breaks beside them. False, and nothing done, where the
// outside of the drawing has no one label.
bool choose_base(const std::vector<Evidence>& evidence, bool cyclic, LabelledPath& path);

// Crossings tie only the back path to itself: gives balanced paths other bases where, all in all,
// fewer crossings contradict their labels at little price in rays. Returns the crossings whose back
// strand has fewer layers in front than the front strand even so, ascending.
std::vector<int> settle_bases(const Arrangement& arrangement, std::vector<LabelledPath>& paths);

}  // namespace illustrate
