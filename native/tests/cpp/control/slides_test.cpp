// Where the limit slides.
#include "control/slides.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "control/bent_points.h"
#include "control/split_once.h"
#include "mesh/mesh_size.h"
#include "surface/planes/plane_faces.h"
#include "tests/cpp/rounded_box.h"

namespace illustrate {
namespace {

using shapes::mesh_of;

std::vector<double> slides_of(const PolygonMesh& source, bool with_planes = true) {
  Counts report;
  SoundMesh mesh = sanitize(source, report);
  if (with_planes) find_plane_faces(mesh, 0, 0, 1);
  const HalfEdges edges(mesh);
  const SoundMesh child = split_once(mesh, edges, Scheme::catmull_clark);
  const HalfEdges child_edges(child);
  const Points points =
      bent_points(mesh, edges, find_sectors(edges, mesh.positions.size()), Scheme::catmull_clark);
  const LimitPlaces limits =
      limit_places(child, child_edges, find_sectors(child_edges, child.positions.size()), points,
                   Scheme::catmull_clark);
  return slides(mesh, edges, limits, diagonal(mesh));
}

double largest(const std::vector<double>& values) {
  return *std::max_element(values.begin(), values.end());
}

TEST(Slides, AreBesideLargeFacesWithNarrowRoundings) {
  for (const double r : {.1, .01, .001}) {
    const std::vector<double> all = slides_of(mesh_of({{2, 1, .5}, r, 3}));
    EXPECT_EQ(*std::min_element(all.begin(), all.end()), 1) << r;
  }
}

TEST(Slides, AreNoneWhereEdgesAreAlike) {
  EXPECT_EQ(largest(slides_of(shapes::uv_sphere_mesh(1, 24, 12))), 0);
  EXPECT_EQ(largest(slides_of(mesh_of({{1, 1, 1}, .9, 3}))), 0);
  EXPECT_EQ(largest(slides_of(mesh_of({{2, 1, .5}, .01, 3}), false)), 0) << "no flat faces";
}

TEST(Slides, ComeWithoutAJump) {
  double last = largest(slides_of(mesh_of({{1, 1, 1}, .9, 3})));
  for (double r = .9; r > .05; r -= .001) {
    const double here = largest(slides_of(mesh_of({{1, 1, 1}, r, 3})));
    EXPECT_NEAR(here, last, .05) << r;
    last = here;
  }
  EXPECT_EQ(last, 1);
}

}  // namespace
}  // namespace illustrate
