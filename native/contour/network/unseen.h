// Parts of a view's curves that no drawing can show but one of hidden lines: beyond the frame, or
// behind the surfaces for certain.
//
// Where a curve crosses a buried one in the image and lies behind it, it is covered there. So
// buried parts can be left out of all crossings, and what is known of the other parts stays true
// but for covered ones, of which nothing is known but that they are: work then grows with what is
// seen.
#pragma once

#include "contour/network/curve_network.h"
#include "contour/silhouettes.h"
#include "occlusion/occlusion_map.h"

namespace illustrate {

class Unseen {
 public:
  // certain: as above. likely: whatever is behind the nearest surface at its very place, to within
  // a pixel; all of it counts as buried then.
  enum class Evidence : std::uint8_t { certain, likely };

  // threads: 0 = all cores.
  Unseen(const Surface& surface, const Camera& camera, Evidence evidence, int threads);

  Sight triangle(int triangle) const;
  Sight segment(const Vec3& a, const Vec3& b) const;
  const Camera& camera() const { return camera_; }
  const Surface& surface() const { return surface_; }
  Evidence evidence() const { return evidence_; }

 private:
  Sight box(Span<const Vec3> points) const;

  const Surface& surface_;
  Camera camera_;
  Evidence evidence_;
  OcclusionMap covered_, buried_;
};

// Leaves out the chains that no other curve need cross, all of whose triangles are buried or beyond
// the frame; returns how many.
int leave_out_unseen_chains(const Unseen& unseen, LinearSilhouettes& silhouettes);

// Marks the segments of stretches that `cut_at_unseen` will cut off, as far as their triangles
// tell.
void mark_unseen_segments(const Unseen& unseen, LinearSilhouettes& silhouettes);

// The same curves, cut where what is known of their sight changes, to within a few pixels; the cuts
// are joints.
CurveNetwork cut_at_unseen(const Unseen& unseen, const CurveNetwork& network);

}  // namespace illustrate
