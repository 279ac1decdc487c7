// Edges shaded smooth that turn too far to be samples of a curve.
//
// Rounding takes the vertices of a mesh for samples of a smooth surface. They are not where two
// faces meet at nearly a right angle, as those of a cube that is shaded smooth; where two strips of
// faces meet so in a mitre, as the bevels of a letter do, however flat; where the normals turn as
// far within one face, as across a chamfer whose normals continue the flat faces on either side;
// nor where an edge turns and those before and after it in its strip do not. An arc there would
// leave the artist's mesh far, and so would the limit of a cage. Such edges are *folds*: semi-sharp
// creases, so sharp that the surface keeps within half a pixel of the mesh, of a drawing in which
// the object's diagonal has 1400. They are shaded smooth and drawn as smooth: no line runs along
// them but the silhouette. A fold is a line: an edge is no sharper than the fold that goes on at
// either of its ends, so a single edge that turns far counts as noise.
#pragma once

#include <optional>

#include "control/half_edges.h"

namespace illustrate {

// Edges of hexagons are curves, those of squares are none: what turns by less is samples of a
// curve, as far as its angle tells.
constexpr double curve_deg = 64;

// A mesh with folds, as two meshes.
struct FoldedMesh {
  SoundMesh soft;              // with its folds as semi-sharp edges
  SoundMesh hard;              // with its folds as creases, shaded as its faces lie beside them
  std::vector<double> shares;  // (n) how far a vertex belongs to the hard one: 0 smooth .. 1
};

// distances (n): how far the limit of the mesh as it is kept with the folds known so far is from
// each vertex, in pixels of such a drawing; empty: not known. Where both ends of an edge are missed
// by more than two pixels and it turns more than 20 degrees, it folds too, up to wholly at 5 pixels
// and 40 degrees.
// None without folds, nor with more than 20,000: a crumpled mesh, which is rounded as others are.
// Sharpness and shares are continuous in positions, normals and distances.
std::optional<FoldedMesh> fold(const SoundMesh& mesh, const std::vector<double>& distances = {});

}  // namespace illustrate
