#include "tests/fuzz/run_case.h"

#include <cmath>

#include "core/errors.h"
#include "pipeline/draw.h"
#include "surface/refine.h"
#include "tests/cpp/cameras.h"
#include "tests/cpp/check_graph.h"
#include "tests/cpp/check_sound.h"
#include "tests/cpp/check_surface.h"
#include "tests/fuzz/nasty_mesh.h"

namespace illustrate::fuzz {
namespace {

constexpr int image_px = 64;
constexpr std::size_t max_triangles_to_draw = 300;

std::string describe(std::uint64_t seed, const PolygonMesh& mesh) {
  return "seed " + std::to_string(seed) + ": " + std::to_string(mesh.positions.size()) +
         " vertices, " + std::to_string(mesh.face_sizes.size()) + " faces, scheme " +
         std::to_string(static_cast<int>(*mesh.scheme)) + ", level " + std::to_string(*mesh.level);
}

// Somewhere round the middle of the surface, now and then inside it.
Camera any_camera(const Surface& surface, Random& random) {
  Eigen::AlignedBox3d box(Vec3::Zero());
  for (const Vec3& p : surface.positions) box.extend(p);
  const double size = std::max(box.sizes().maxCoeff(), 1e-300);
  Vec3 direction{random.between(-1, 1), random.between(-1, 1), random.between(0.1, 1)};
  if (random.one_in(4)) direction = Vec3::UnitZ();
  if (random.one_in(2)) return cameras::orthographic(direction, size, image_px);
  const double distance = size * random.between(0.1, 3);
  const Vec3 middle = box.min() / 2 + box.max() / 2;
  return cameras::perspective(middle + distance * direction, middle, size * 1e-3, 50, image_px);
}

void check_strokes(const Drawing& drawing) {
  const std::size_t points = drawing.points.size(), strokes = drawing.kinds.size();
  ASSERT_EQ(drawing.offsets.size(), strokes + 1);
  ASSERT_EQ(static_cast<std::size_t>(drawing.offsets.back()), points);
  ASSERT_EQ(drawing.image.size(), points);
  for (std::size_t s = 0; s < strokes; ++s) {
    EXPECT_GE(drawing.offsets[s + 1] - drawing.offsets[s], 2);
    EXPECT_NE(drawing.kinds[s], Kind::seam);
    EXPECT_GE(drawing.invisibility[s], 0);
  }
  for (std::size_t p = 0; p < points; ++p) {
    EXPECT_TRUE(drawing.points[p].allFinite() && drawing.image[p].allFinite());
    EXPECT_TRUE((drawing.image[p].array() >= 0).all() &&
                (drawing.image[p].array() <= image_px).all());
    EXPECT_GE(drawing.widths[p], 0);
  }
}

void draw_case(const PolygonMesh& mesh, const SurfaceOptions& surface_options, Random& random) {
  PrepareOptions options;
  options.surface = surface_options;
  options.threads = 1;
  options.field = random.one_in(2);
  const auto prepared = prepare({std::make_shared<PolygonMesh>(mesh)}, options);
  try {
    const Camera camera = any_camera(prepared->surface(), random);
    DrawOptions draw_options;
    draw_options.threads = 1;
    const DrawResult result = draw(*prepared, camera, draw_options);
    check_strokes(result.drawing);
    check_graph(result.graph);
    for (const Vec2& p : result.graph.image.values) EXPECT_TRUE(p.allFinite());
  } catch (const InvalidInput& error) {  // a scene too large or too small for any camera
    EXPECT_NE(std::string(error.what()).find("camera"), std::string::npos) << error.what();
  }
}

}  // namespace

std::string run_case(std::uint64_t seed) {
  Random random(seed);
  const PolygonMesh mesh = nasty_mesh(random);
  const std::string description = describe(seed, mesh);
  SCOPED_TRACE(description);
  const Mended mended = mend(mesh);
  SurfaceOptions options;
  options.triangle_budget = 2000;
  options.threads = 1;
  Counts report;
  const Surface surface = refine({mended.mesh}, options, report);
  check_surface(surface);
  if (random.one_in(4) && surface.triangles.size() <= max_triangles_to_draw)
    draw_case(mesh, options, random);
  return description;
}

}  // namespace illustrate::fuzz
