// What runs beside a node of a streamline.
#pragma once

#include <array>
#include <limits>

#include "hatch/streamlines/streamline_set.h"

namespace illustrate {

// Nodes of one streamline so near along it are not its own neighbours.
constexpr int own_nodes = 6;

// In spacings: beyond, a critical curve is nobody's neighbour.
constexpr double curve_reach = 1.5;

struct Neighbour {
  double distance = std::numeric_limits<double>::infinity();  // px
  int streamline = none;
};

// The nearest parallel streamlines to the left and the right of a node of streamline `number`, none
// beyond two spacings. The same one where it comes round again.
std::array<Neighbour, 2> neighbours(const StreamlineSet& set, int number, int index);

// How far a critical curve is from a node on one side of its streamline, `side` being a unit vector
// of the image; infinite beyond `reach` px.
double curve_beside(const HatchView& view, const StreamlineNode& node, const Vec2& side,
                    double reach);

}  // namespace illustrate
