// Which of two families of hatches stays in a single-hatch region (paper section 6.5).
#pragma once

#include <cstdint>
#include <vector>

#include "core/ragged.h"

namespace illustrate {

// How strongly a piece of a hatch goes with another: weight > 0 where they run side by side, < 0
// where they are perpendicular. Given from both sides.
struct FamilyLink {
  int other;
  int weight;
};

struct FamilyChoice {
  std::vector<std::uint8_t> is_kept;  // of each piece
  std::vector<int> order;             // in which the pieces were decided
};

// Two families of pieces, kept and deleted, such that pieces side by side are of the same family
// and perpendicular ones of different families, as far as that can be. `preference` is what the
// form asks for, from -1, to delete the piece, to 1, to keep it; its average over the pieces around
// speaks like one more neighbour.
//
// Outwards from the piece that the form speaks clearest on, next always the piece on which what is
// decided around it and the form agree best. A new first piece is taken only where nothing links to
// what is decided. In the end pieces change over that most of this wants in the other family.
FamilyChoice choose_family(const Ragged<FamilyLink>& links, const std::vector<double>& preference);

}  // namespace illustrate
