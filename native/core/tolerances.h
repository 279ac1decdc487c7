// Every tolerance that more than one stage relies on, each relative, each with its reason.
#pragma once

namespace illustrate::tolerance {

// Normals of a flat area agree within this angle (paper section 4): far above the rounding of limit
// normals (1e-12), far below the turn between neighbouring triangles of any drawn curve.
constexpr double flat_rad = 1e-4;

// Image coordinates are rounded to this many pixels before crossings are decided: 2^-16. Coarser
// grids twist strands that run close together near cusps, finer ones gain nothing.
constexpr double image_grid_px = 1.0 / 65536;

// A triangle whose area is below this share of its longest edge squared has no usable normal.
constexpr double degenerate_area = 1e-12;

// |g| below this share of |p - c| is rounding noise of a face seen exactly edge-on and counts as
// zero.
constexpr double facing_noise = 1e-9;

// A placement whose lengths along different directions differ by a smaller share is a rigid motion
// with one scale: a product of a few matrices in single precision is off by 1e-6; over a page of
// 1400 px this moves nothing by a hundredth of a pixel.
constexpr double similarity = 5e-6;

// Squared lengths that differ by less than this share are the same, and turns of less than this
// (radians) are straight: rounding must not choose between diagonals or ears of a square or a
// regular polygon, which is turned with the scene by such a placement.
constexpr double same_length = 1e-5, straight_rad = 5e-6;

// Positions apart by less than this share of a mesh's usual edge are one: a matrix applied to them
// in double precision is off by 1e-15 of the mesh's size, vertices in single precision differ by
// 1e-8 of it.
constexpr double same_place = 1e-10;

}  // namespace illustrate::tolerance
