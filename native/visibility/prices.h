// What contradicts a label, and how much: every weight of the problem that view_labels.h states, in
// units of paper of line drawn wrong.
//
// Only their proportions count, and only where rays and rules contradict each other.
// docs/sensitivity.md tells what drawings make of half and double of each.
#pragma once

namespace illustrate {

struct Prices {
  // --- Rules that are broken (labels/view_labels.h) ---

  // For each unit that hangs on a rule. In proportion, for a lens that only the mesh has made is to
  // give way and an outline is not: with one price for all nodes half of the lines that came out
  // otherwise were wrong, with this one in twenty.
  double per_px = 5;
  // Of a change at a cusp or behind a crossing: as if a unit hung on it at least, so that no rule
  // is broken for nothing, and not without end, for rays along a whole path are right against it.
  // Half and double of the greatest move one and two pixels of line in a thousand.
  double least_change = 5, greatest_change = 120;
  // Of a side with fewer layers than the front curve gives it. Less than a change: the front
  // curve's own label may be the wrong one.
  double least_cover = 0.5, greatest_cover = 40;

  // --- What rays say (evidence/evidence.h): the length of the arc, and ---

  // The outside of the drawing is certain: more than anything could weigh against it.
  double outline = 1e6;
  // Of the weight, against a label with more layers than the ray met. With .75 outlines went with
  // the rules of a crossing near by that was none; of 243 scenes and files of others missed edges
  // and creases are .5 and 1 % fewer.
  double missed_share = 1.25;
  // Of the weight besides, against a label that shows what the ray says is hidden: a ray that
  // starts beside the curve rather misses a layer than that it meets one too many, and where rules
  // that contradict each other leave the choice, one hidden line less is hardly seen, and one
  // through what hides it is. Without it false lines of 84 scenes and CAD files are 2 % more,
  // missed ones 1 in 1000 fewer.
  double shown_share = 1.75;
  // An arc next to the empty background is nearly certain; but a sliver may hide a short one, which
  // therefore gains so many times its length at most.
  double beside_nothing = 100, beside_nothing_share = 3;
  // An arc without length still prefers its ray.
  double least = 1e-6;
};

inline constexpr Prices prices;

}  // namespace illustrate
