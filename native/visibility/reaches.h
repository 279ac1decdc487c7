// How near in the image things are one, or may be: every distance by which visibility decides, in
// units of paper, 1/1024 of the larger side (docs/README.md), which are pixels here.
//
// One table, so that they can be weighed against each other and changed one by one.
// docs/sensitivity.md tells what drawings make of half and double of each.
#pragma once

namespace illustrate {

struct Reaches {
  // --- Crossings that only the interpolation of the contour has made (labels/repairs.h). As small
  // as what is to be mended allows: thinner things that the surface does have are lost. ---

  // All of a loop in which a path crosses itself. A smaller one is a thicker spot of its line. Half
  // leaves half of all repairs to the labels' prices, double takes little more.
  double twist = 1;
  // The same where the loop alone unbalances its path: the size is the only doubt. The contour of a
  // Roman surface curls by a little more than a pixel beside its pinch point; were the loop to
  // stay, two cusps elsewhere would go in its place, and hundreds of pixels of line with them.
  double wide_twist = 2;
  // Between the two curves of a lens. Less than a twist: of two lines beside each other both are
  // drawn, and a third of a pixel between them cannot be seen.
  double lens = 0.3;
  // The same next to a joint, where both curves meet for certain. Half leaves three times as many
  // loops that do not balance, double moves two pixels of line in a thousand.
  double joint_lens = 1;
  // A cusp nearer to where its chain ends is not told from the end, nor two nodes from each other.
  double end = 0.1;
  // The strand between two cusps that are none.
  double swallowtail = 1;
  // From a joint to a crossing that is none, past other nodes; of the strands between such nodes.
  double touch = 1;
  // Points are drawn on the curve that they touch. What stands out farther is not the noise of two
  // polylines of one fold: a hook of the contour beyond the joint, say.
  double touching_move = 0.1;

  // --- Where what is decided on moved points is drawn (arrangement/image_strands.h) ---

  // Points are moved by no more, so that arcs end where their nodes are within a thousandth.
  double decided_move = 1. / 2048;
  // A crossing is drawn so near to where it was decided: nearly parallel curves, moved by as
  // little, cross elsewhere, and farther off another thing may have come between.
  double crossing_move = 1. / 16;

  // --- Rays (evidence/layer_rays.h). What is left out must be left out: each is as large as the
  // distance between the smooth surface and its triangles. ---

  // How far beside a fold rays start: the nearest passes no sheet that ends in between. The
  // interpolated contour of a rim narrower than the triangles runs up to a pixel inside their
  // outline; a farther ray then finds fewer layers, in front and behind. Fewer in front alone:
  // another curve runs between.
  double aside_first = 0.2, aside_second = 0.7, aside_last = 2;
  // Hits nearer than this may be the curve's own surface: the contour lies on the smooth surface,
  // not on its triangles. They leave the count open; counted as nothing they let the far branch of
  // a shallow fold look as free as the near one. Half changes little, double nothing.
  double blind = 3;
  // But creases, borders and intersections lie on the triangles, and contours not on other parts
  // than their own: what lies farther than this from them hides them for certain. A rail a few
  // millimetres within a picket is not seen through it.
  double blind_on_mesh = 0.3;
  // Hits nearer than this do not hide a curve that lies on no surface, so that one drawn on a
  // surface is seen; shorter parts of it go with the part before.
  double loose_blind = 1, least_loose = 0.5;

  // --- The outside of the drawing (evidence/outline.h) ---

  // From scan line to scan line: finer ones are for where curves are near each other. Half finds no
  // more of the outside, double loses a pixel of line in a thousand.
  double outline_row = 0.5;
  // Nearer curves on a scan line are one line: neither is certain to be first. Half changes
  // nothing; double leaves more of the outline uncertain and moves two pixels in a thousand.
  double outline_clear = 0.05;
};

inline constexpr Reaches reaches;

}  // namespace illustrate
