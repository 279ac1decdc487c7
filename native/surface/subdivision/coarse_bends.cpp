#include "surface/subdivision/coarse_bends.h"

#include <algorithm>
#include <cmath>

#include "control/folds.h"
#include "core/angles.h"

namespace illustrate {
namespace {

// Of the longest edge, which the add-on asks to be three pixels: .4 pixels.
constexpr double chord_share = 1.0 / 8;
constexpr double curve_rad = radians(curve_deg);
// Faces that turn by less lie in one plane, where it does not show how the limit slides.
constexpr double straight_rad = radians(1);

class CoarseBends {
 public:
  CoarseBends(const SoundMesh& mesh, double median, double nearest, int highest)
      : mesh_(mesh),
        edges_(mesh),
        normals_(unit_normals(edges_.faces, mesh.positions)),
        median_(median),
        nearest_(nearest),
        highest_(highest) {}

  int level() const {
    std::vector<double> lengths(idx(highest_) + 1, 0);  // of the edges that need each level
    double all = 0;
    for (const int h : edges_.first) {
      const double length = (head(h) - start(h)).norm();
      lengths[idx(level_of(h))] += length;
      all += length;
    }
    double finer = 0;
    for (int level = highest_; level > 0; --level) {
      finer += lengths[idx(level)];
      if (finer > ignored_coarse_share * all) return level;
    }
    return 0;
  }

 private:
  const Vec3& start(int h) const { return mesh_.positions[idx(edges_.faces.corners[idx(h)])]; }
  const Vec3& head(int h) const { return mesh_.positions[idx(edges_.faces.head(h))]; }

  int level_of(int h) const {
    const int mate = edges_.mates[idx(h)];
    if (mate == none || edges_.is_sharp(h)) return 0;
    return std::max(level_across(h, mate), level_along(h, mate));
  }

  double turn(int h, int mate) const {
    const std::vector<int>& faces = edges_.faces.corner_faces;
    return angle_between(normals_[idx(faces[idx(h)])], normals_[idx(faces[idx(mate)])]);
  }

  // A long edge along a bend draws the limit of its ends along, away from the mesh.
  int level_along(int h, int mate) const {
    const double length = (head(h) - start(h)).norm();
    const bool is_long = is_coarse(length, median_) && length * chord_share > nearest_;
    return !mesh_.cage && is_long && turn(h, mate) > straight_rad ? 1 : 0;
  }

  int level_across(int h, int mate) const {
    const double reach = (reach_of_face(edges_.faces, mesh_.positions, h) +
                          reach_of_face(edges_.faces, mesh_.positions, mate)) /
                         2;
    if (!is_coarse(reach, median_)) return 0;
    const double turned = turn(h, mate), sagitta = reach * turned / 8;
    if (!(sagitta > nearest_)) return 0;
    if (!mesh_.cage && turned > curve_rad) return 1;
    // A level halves chords, and quarters how far they are from their arcs.
    return std::min(highest_,
                    static_cast<int>(std::ceil(std::log(sagitta / nearest_) / std::log(4))));
  }

  const SoundMesh& mesh_;
  const HalfEdges edges_;
  const Points normals_;  // (f)
  double median_, nearest_;
  int highest_;
};

}  // namespace

int level_for_coarse_bends(const SoundMesh& mesh, double median, double longest, int highest) {
  return CoarseBends(mesh, median, chord_share * longest, highest).level();
}

}  // namespace illustrate
