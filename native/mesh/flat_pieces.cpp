#include "mesh/flat_pieces.h"

#include "core/angles.h"
#include "core/disjoint_sets.h"
#include "mesh/polygons.h"

namespace illustrate {
namespace {

// Above what single precision leaves of a plane, below what a curved surface turns from one piece
// to the next where its pieces are few.
constexpr double level_deg = 2;

std::vector<int> join_level_faces(const Faces& faces, const EdgeTurns& turns) {
  DisjointSets sets(faces.sources.size());
  for (int h = 0; h < faces.corner_count(); ++h) {
    const double turn = turns.at(h);
    if (turn == EdgeTurns::sharp_edge || turn > level_deg) continue;
    sets.join(faces.corner_faces[h], faces.corner_faces[turns.mate(h)]);
  }
  std::vector<int> pieces;
  for (int f = 0; f < faces.size(); ++f) pieces.push_back(sets.root(f));
  return pieces;
}

}  // namespace

FlatPieces find_flat_pieces(const Faces& faces, const Points& positions, const EdgeTurns& turns,
                            const Shading& shading) {
  FlatPieces found{join_level_faces(faces, turns), Points(faces.sources.size(), Vec3::Zero()),
                   std::vector<std::uint8_t>(faces.sources.size(), 1)};
  for (int c = 0; c < faces.corner_count(); ++c) {
    const int f = faces.corner_faces[c];
    found.normals[found.pieces[f]] += corner_angle(faces, positions, c) * shading.face_normals[f];
  }
  for (Vec3& normal : found.normals) normal = unit_of_sum(normal);
  for (int f = 0; f < faces.size(); ++f) {
    const int piece = found.pieces[f];
    found.is_flat[piece] &=
        degrees_between(shading.face_normals[f], found.normals[piece]) <= level_deg;
  }
  return found;
}

}  // namespace illustrate
