#include <gtest/gtest.h>

#include "stroke/tracks.h"
#include "tests/cpp/cameras.h"
#include "tests/cpp/shapes.h"

namespace illustrate {
namespace {

// A pixel is a unit of the world.
const Camera camera = cameras::orthographic(Vec3::UnitZ(), 500);

using Line = std::vector<Vec2>;

void add(Drawing& drawing, const Line& line, Kind kind = Kind::silhouette, bool closed = false) {
  for (const Vec2& p : line) {
    drawing.points.emplace_back(p.x() - 500, 500 - p.y(), 0);
    drawing.image.push_back(p);
    drawing.widths.push_back(1);
    drawing.on.push_back({});
  }
  drawing.offsets.push_back(static_cast<int>(drawing.points.size()));
  drawing.kinds.push_back(kind);
  drawing.closed.push_back(closed ? 1 : 0);
  drawing.objects.push_back(0);
  drawing.invisibility.push_back(0);
}

Drawing first_of(const std::vector<Line>& lines, Kind kind = Kind::silhouette) {
  Drawing drawing;
  for (const Line& line : lines) add(drawing, line, kind);
  drawing.tracks = first_tracks(drawing);
  return drawing;
}

Drawing after(const Drawing& last, Drawing drawing) {
  follow_strokes(drawing, last, {}, camera, 1);
  return drawing;
}

Drawing next_of(const Drawing& last, const std::vector<Line>& lines, Kind kind = Kind::silhouette) {
  return after(last, first_of(lines, kind));
}

// From x0 to x1 at a height.
Line level(double x0, double x1, double y) { return {{x0, y}, {(x0 + x1) / 2, y}, {x1, y}}; }

using Ids = std::vector<int>;

TEST(StrokeTracks, BeginWithEveryStrokeBorn) {
  const Drawing first = first_of({level(0, 100, 100), level(0, 100, 200)});
  EXPECT_EQ(first.tracks.ids, (Ids{0, 1}));
  EXPECT_EQ(first.tracks.births, (Ids{0, 0}));
  EXPECT_EQ(first.tracks.next_id, 2);
  EXPECT_EQ(first.tracks.frame, 0);
}

TEST(StrokeTracks, GoWithStrokesInAnyOrder) {
  const Drawing first = first_of({level(0, 100, 100), level(0, 100, 200), level(0, 100, 300)});
  const Drawing second = next_of(first, {level(3, 103, 303), level(3, 103, 95)});
  EXPECT_EQ(second.tracks.ids, (Ids{2, 0}));
  EXPECT_EQ(second.tracks.deaths, (Ids{1}));
  EXPECT_EQ(second.tracks.frame, 1);
  const Drawing third = next_of(second, {level(3, 103, 200), level(3, 103, 303)});
  EXPECT_EQ(third.tracks.ids, (Ids{3, 2}));
  EXPECT_EQ(third.tracks.births, (Ids{2, 0}));
  EXPECT_EQ(third.tracks.deaths, (Ids{0}));
}

// What stays where it was counts on from where it did, whatever becomes of the ends.
TEST(StrokeTracks, CountOnWhereStrokesGrowAndShrink) {
  const Drawing first = first_of({level(100, 300, 100)});
  const Drawing longer = next_of(first, {level(60, 400, 100)});
  EXPECT_NEAR(longer.tracks.starts[0], -40, 1e-6);
  const Drawing shorter = next_of(longer, {level(150, 300, 100)});
  EXPECT_NEAR(shorter.tracks.starts[0], 50, 1e-6);
  EXPECT_EQ(shorter.tracks.ids, (Ids{0}));
}

TEST(StrokeTracks, TheLongerPartIsTheHeirAndTheOtherCountsOn) {
  const Drawing whole = first_of({level(100, 400, 100)});
  const Drawing parts = next_of(whole, {level(100, 190, 100), level(200, 400, 100)});
  EXPECT_EQ(parts.tracks.ids, (Ids{1, 0}));
  EXPECT_EQ(parts.tracks.births, (Ids{1, 0}));
  EXPECT_NEAR(parts.tracks.starts[0], 0, 1e-6);
  EXPECT_NEAR(parts.tracks.starts[1], 100, 1e-6);
  const Drawing joined = next_of(parts, {level(100, 400, 100)});
  EXPECT_EQ(joined.tracks.ids, (Ids{0}));
  EXPECT_NEAR(joined.tracks.starts[0], 0, 1e-6);
  EXPECT_EQ(joined.tracks.deaths, (Ids{1}));
}

TEST(StrokeTracks, OfOtherKindsDirectionsOrPlacesAreOthers) {
  const Drawing first = first_of({level(100, 300, 100)});
  EXPECT_EQ(next_of(first, {level(100, 300, 100)}, Kind::crease).tracks.ids, (Ids{1}));
  EXPECT_EQ(next_of(first, {level(300, 100, 100)}).tracks.ids, (Ids{1}));
  EXPECT_EQ(next_of(first, {level(100, 300, 115)}).tracks.ids, (Ids{1}));
  EXPECT_EQ(next_of(first, {{{200, 50}, {200, 150}}}).tracks.ids, (Ids{1}));
  Drawing hidden = first_of({level(100, 300, 100)});
  hidden.invisibility[0] = 1;
  EXPECT_EQ(after(first, hidden).tracks.ids, (Ids{1}));
}

TEST(StrokeTracks, HatchesRunTheWayTheyRan) {
  const Drawing first = first_of({level(100, 300, 100)}, Kind::hatch);
  const Drawing second = next_of(first, {level(320, 100, 101)}, Kind::cross_hatch);
  EXPECT_EQ(second.tracks.ids, (Ids{0}));
  EXPECT_EQ(second.image.front(), Vec2(100, 101));
  EXPECT_EQ(second.points.back(), Vec3(-180, 399, 0));
  EXPECT_NEAR(second.tracks.starts[0], 0, 1e-6);
}

Line circle(double radius, double turn) {
  Line line;
  for (int i = 0; i < 90; ++i) {
    const double u = turn + 2 * pi * i / 90;
    line.emplace_back(500 + radius * std::cos(u), 500 + radius * std::sin(u));
  }
  return line;
}

// Wherever a closed curve happens to be cut open.
TEST(StrokeTracks, ClosedStrokesBeginWhereTheyBegan) {
  Drawing first;
  add(first, circle(200, 0), Kind::silhouette, true);
  first.tracks = first_tracks(first);
  for (const double turn : {0.31, 2.0, 3.1, 5.9}) {
    Drawing second;
    add(second, circle(200, turn), Kind::silhouette, true);
    second = after(first, second);
    const double off = std::atan2(second.image[0].y() - 500, second.image[0].x() - 500);
    EXPECT_LT(std::abs(off), pi / 90 + 0.01) << "the nearest point";
    EXPECT_NEAR(second.tracks.starts[0], 200 * off, 0.1) << turn;
    EXPECT_EQ(second.tracks.ids, (Ids{0}));
  }
}

// Strokes go with the surface that they are on, which may have moved far.
TEST(StrokeTracks, GoWithTheirSurface) {
  const auto triangle = [](double y) {
    Surface surface;
    surface.positions = {Vec3(-400, y, 0), Vec3(400, y, 0), Vec3(-400, y + 400, 0)};
    surface.triangles = {{0, 1, 2}};
    shapes::complete(surface);
    return surface;
  };
  Drawing first = first_of({level(200, 300, 500)});
  for (std::size_t i = 0; i < 3; ++i) first.on[i] = {0, (first.image[i].x() - 100) / 800, 0};
  first.surface = std::make_shared<const Surface>(triangle(0));
  Drawing second = first_of({level(200, 300, 500), level(200, 300, 400)});
  follow_strokes(second, first, triangle(100), camera, 1);
  EXPECT_EQ(second.tracks.ids, (Ids{1, 0}));
}

}  // namespace
}  // namespace illustrate
