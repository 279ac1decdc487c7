#include "pipeline/view.h"

#include <gtest/gtest.h>

#include "core/errors.h"
#include "pipeline/draw.h"
#include "tests/cpp/cameras.h"
#include "tests/cpp/shapes.h"

namespace illustrate {
namespace {

// Two crossing tori, the first of which the styles may say something of.
std::shared_ptr<const Prepared> two_tori() {
  PolygonMesh first = shapes::torus_mesh(1, 0.4, 24, 12), second = first;
  for (Vec3& p : second.positions) p = Vec3(p.z() + 0.8, p.y(), p.x());
  PrepareOptions options;
  options.surface.level = 1;
  return prepare({std::make_shared<PolygonMesh>(std::move(first)),
                  std::make_shared<PolygonMesh>(std::move(second))},
                 options);
}

Camera eye(double x) { return cameras::perspective({x, -5, 3}, Vec3::Zero()); }

void expect_same(const DrawResult& a, const DrawResult& b) {
  EXPECT_EQ(a.drawing.image, b.drawing.image);
  EXPECT_EQ(a.drawing.widths, b.drawing.widths);
  EXPECT_EQ(a.drawing.offsets, b.drawing.offsets);
  EXPECT_EQ(a.drawing.kinds, b.drawing.kinds);
  EXPECT_EQ(a.drawing.tracks.ids, b.drawing.tracks.ids);
  EXPECT_EQ(a.tone.brightness, b.tone.brightness);
  EXPECT_EQ(a.counts, b.counts);
}

// How the styles show the first torus.
ObjectStyle plain() { return {}; }
ObjectStyle glass() {
  ObjectStyle style;
  style.see_through = true;
  return style;
}
ObjectStyle shadow_only() {
  ObjectStyle style;
  style.shadow_only = true;
  return style;
}
ObjectStyle ignored() {
  ObjectStyle style;
  style.ignore = true;
  return style;
}

class Views : public testing::TestWithParam<ObjectStyle> {};

TEST_P(Views, AreDrawnAsAtOnceAsOftenAsAsked) {
  const auto prepared = two_tori();
  DrawOptions options;
  options.styles = {GetParam(), plain()};
  const DrawResult first = draw(*prepared, eye(0), options);
  const View view = view_of(*prepared, eye(0.1), options);
  for (const Drawing* previous : {static_cast<const Drawing*>(nullptr), &first.drawing}) {
    const DrawResult at_once = draw(*prepared, eye(0.1), options, {}, {}, previous);
    EXPECT_GT(at_once.drawing.kinds.size(), 10U);
    expect_same(draw(view, {}, previous), at_once);
    expect_same(draw(view, {}, previous), at_once);
  }
}

INSTANTIATE_TEST_SUITE_P(Styles, Views,
                         testing::Values(plain(), glass(), shadow_only(), ignored()));

TEST(View, HasNoTonesWhereNothingIsHatched) {
  DrawOptions options;
  options.hatching = false;
  const View view = view_of(*two_tori(), eye(0), options);
  EXPECT_TRUE(view.tone.level.empty());
  EXPECT_TRUE(view.visible.triangle.empty());
  EXPECT_FALSE(view.graph.nodes.empty());
}

TEST(View, RefusesWhatADrawingRefuses) {
  DrawOptions options;
  options.styles = {plain()};
  EXPECT_THROW(view_of(*two_tori(), eye(0), options), InvalidInput);
}

}  // namespace
}  // namespace illustrate
