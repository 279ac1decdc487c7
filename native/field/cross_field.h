// Stage `field`: a smooth cross field for hatching (paper section 5).
//
// The cross at vertex i is an angle theta_i against a reference direction in its tangent plane,
// phi_ij the direction of edge ij projected at i. The energy
//   E = - sum over edges of cos 4((theta_i - phi_ij) - (theta_j - phi_ji))
// does not change when a theta turns by pi/2. Vertices where the curvature directions can be relied
// on keep them; the rest is found by NLopt's LD_LBFGS from a start by a hierarchy of graphs. Guides
// add terms of their own; prescribed singularities adjust the angles phi.
#pragma once

#include "core/progress.h"
#include "field/problem/guidance.h"
#include "mesh/bvh.h"
#include "surface/surface.h"

namespace illustrate {

enum class FieldStart {
  search,     // the best of many fields of a smaller graph
  principal,  // the paper's: principal directions (figure 8)
};

struct FieldOptions {
  // A vertex is reliable where |k2| <= parabolic_ratio |k1| (quasi-parabolic; 0: nowhere), where
  // |k1| >= least_curvature / the diagonal of the object, and where the mean of 1 + e over its
  // edges, in [0, 2], is at most largest_energy. 1, 0 and 2: wherever there is a curvature.
  double parabolic_ratio = 0.2;
  double least_curvature = 1;
  double largest_energy = 0.05;
  // Soft pull of creases and boundaries, for each hundredth of the object's diagonal of their
  // length; no part of the reported energies.
  double alignment_weight = 0.1;
  // Edges count in inverse proportion to their length, 1 in the mean (section 5, for irregular
  // meshes); false: alike.
  bool inverse_length_weights = false;
  FieldStart start = FieldStart::search;
  Vec3 default_direction = Vec3::UnitZ();  // projected, where nothing is reliable
  std::vector<Guide> guides;
  double guide_radius = 0.05;  // no vertex so near a guide is reliable; of the object's diagonal
  // No vertex of a connected part where some are prescribed is reliable, and it has no others.
  PrescribedSingularities singularities;
  int max_evaluations = 500;
  int threads = 0;
};
void validate(const FieldOptions& options);  // throws InvalidInput naming the field

// Whether points have to be found on the surface.
inline bool needs_tree(const FieldOptions& options) {
  return !options.guides.empty() || !options.singularities.empty();
}

struct CrossField {
  std::vector<double> theta;           // (n) radians against `reference`
  Points reference;                    // (n) unit tangent
  Points directions;                   // (n) one unit tangent of the cross
  std::vector<std::uint8_t> reliable;  // (n)
  // What was minimised: E over all edges of the triangles and the terms of the guides, without soft
  // alignments; by the adjusted connection where singularities are prescribed.
  double energy = 0;
  double energy_initial = 0;
  std::vector<double> object_energies;          // (objects) their shares of both
  std::vector<double> object_energies_initial;  // (objects)
  bool converged = false;
  int evaluations = 0;
  std::vector<int> singular_triangles;  // (s)
  std::vector<int> singular_indices;    // (s) quarter turns; closed: sum is 4 chi
  Points singular_positions;            // (s) middle of the triangle
};

// What is at hand already, each null where it is not.
struct FieldAids {
  const Bvh* bvh = nullptr;  // of the surface; made where `needs_tree`
  // The last frame's, or that of other options: on objects that are the same the search starts and
  // ends near this field, moved along with the surface; without guides and prescribed
  // singularities what has not been stretched keeps it.
  const Surface* last_surface = nullptr;
  const CrossField* last_field = nullptr;
  // (objects) which object of the last surface each may be, or none (surface/same_objects.h).
  std::vector<int> last_objects = {};
  // False: each object stands in a space of its own, and has no neighbours.
  bool objects_share_space = true;
};

// Never NaN, and an error for prescribed singularities only: InvalidInput where they do not sum to
// 4 chi or the mesh is too coarse for them. A connected part without a reliable vertex starts from
// the default direction, turned as a whole towards its features, and keeps that start unless there
// is a field of less energy (a plane: there is none). No part ends with more energy than it started
// with. Throws Cancelled through `progress`.
CrossField solve_cross_field(const Surface& surface, const Curvature& curvature,
                             const FieldOptions& options, const FieldAids& aids = {},
                             const Progress& progress = {});

// The field turned by an eighth of a circle. Energy and singularities are the same.
CrossField diagonals(const Surface& surface, CrossField field);

// The branch of the cross at a point that is nearest to `towards` (a world direction), as a unit
// tangent of the triangle's sheet at that point; the three corners' crosses are combed to agree
// before they are interpolated.
Vec3 cross_direction(const Surface& surface, const CrossField& field, const SurfacePoint& at,
                     const Vec3& towards);

}  // namespace illustrate
