// Stage `control`: a control mesh whose limit surface keeps to the artist's mesh (not in the paper,
// which starts from cages).
//
// A mesh without a Subdivision modifier is seen with its vertices where they are, and shaded by its
// normals. Taken as a cage its limit shrinks: wheels become eggs. Its creases are repaired before
// (mesh/creases.h), which is most of it. Here the rest:
// 0. Edges shaded smooth that turn too far to be curves become semi-sharp (control/folds.h).
// 1. The mesh is split once (control/split_once.h). The vertices stay, the new points lie on arcs
//    through them (control/bent_points.h).
// 2. The limit of that is still inside. So each point takes one step by how far its limit is off,
//    along the normal, no farther than its smooth neighbours on average, so that noise is not
//    sharpened; or across the crease. No step is more than a fifth of the point's shortest edge.
// 3. Where the cage's limit is at its vertices anyway, all that would only sharpen noise. So each
//    patch between creases has a weight, by which its points fade to those of the cage's own first
//    level, whose limit is the cage's. The weight is smoothstep(.75, 2.25) of the median distance
//    from a corner of a face to its limit, weighed by the face's area, in pixels of a drawing in
//    which the object's diagonal has 1400: lines a pixel wide do not show less than .75, and
//    clearly show 2.25.
// 4. Beside flat faces whose edges are far longer than those of their roundings the limit slides
//    within itself, farther than the roundings are wide (control/slides.h). There the surface is
//    not the limit, but made of the arcs (control/arc_faces.h).
//
// What was tried and failed, on trucks, rifles, spiders and scans:
// - c <- c + (p - limit c) until the limit goes through all vertices: it converges to a wrong
//   surface. Parameters are uniform, so a long edge beside a short bevel overshoots by many short
//   edges: roofs explode, legs grow hooks; with fairness too, and with motion along normals only.
// - PN midpoints from shading normals alone: roofs become pillows.
// - The fade by a weight of each vertex: it ripples more than no fade at all.
// - Against slides: semi-sharp creases round flat faces, and between unlike faces: the roundings
//   themselves fold. Arcs as the control mesh of a finer level: its edges are as unlike.
#pragma once

#include <optional>

#include "control/arc_faces.h"
#include "core/progress.h"
#include "mesh/sanitize.h"

namespace illustrate {

// (f) how much of the kept mesh each face's patch gets, 0 the cage's limit .. 1. A function of the
// mesh that is continuous in its positions; the weights of a rest pose suit every other position of
// the same topology.
// scheme: catmull_clark, or loop for triangles.
std::vector<double> kept_weights(const SoundMesh& mesh, Scheme scheme);

struct KeptMesh {
  SoundMesh mesh;  // split once, a cage
  ArcFaces arcs;   // of its faces; empty where nothing slides
};

// None where all weights are 0 and nothing folds: the mesh is its own
// cage. Weights not given are kept_weights'. Twins of a double cover stay at the same place, to the
// bit.
// Throws Cancelled through `progress`.
std::optional<KeptMesh> keep_to_mesh(const SoundMesh& mesh, Scheme scheme,
                                     const std::optional<std::vector<double>>& weights = {},
                                     const Progress& progress = {});

}  // namespace illustrate
