// Scenes of hatches, and what is measured of them.
#pragma once

#include <numeric>
#include <optional>

#include <gtest/gtest.h>

#include "field/cross_direction.h"
#include "hatch/even_hatches.h"
#include "hatch/reduce_hatches.h"
#include "hatch/view/hatch_runs.h"
#include "tests/cpp/cameras.h"
#include "tests/cpp/shapes.h"

namespace illustrate::hatching {

// A cross field with the given unit tangent at every vertex.
template <class Direction>
CrossField field_of(const Surface& surface, const Direction& direction) {
  CrossField field;
  for (std::size_t v = 0; v < surface.positions.size(); ++v) {
    const Vec3 d = direction(surface.positions[v]), n = surface.normals[v];
    field.directions.push_back((d - d.dot(n) * n).normalized());
  }
  return field;
}

// Of a surface that is one object.
inline std::vector<int> all_triangles(const Surface& surface) {
  std::vector<int> triangles(surface.triangles.size());
  std::iota(triangles.begin(), triangles.end(), 0);
  return triangles;
}
inline SurfaceCurves surface_curves(const Surface& surface, const CrossField& field,
                                    const Progress& progress = {}) {
  return RankedCurves(surface, field, all_triangles(surface)).down_to(0, progress);
}

// Whether curves and seeds are the first of others, to the bit.
inline bool is_start_of(const SurfaceCurves& some, const SurfaceCurves& all) {
  const auto is_same = [](const SurfacePoint& a, const SurfacePoint& b) {
    return a.triangle == b.triangle && a.b1 == b.b1 && a.b2 == b.b2;
  };
  return some.curves.size() <= all.curves.size() && some.seeds.size() <= all.seeds.size() &&
         std::equal(some.curves.offsets.begin(), some.curves.offsets.end(),
                    all.curves.offsets.begin()) &&
         std::equal(some.curves.values.begin(), some.curves.values.end(), all.curves.values.begin(),
                    is_same) &&
         std::equal(some.seeds.begin(), some.seeds.end(), all.seeds.begin(), is_same);
}

inline Vec3 round_z(const Vec3& p) { return Vec3::UnitZ().cross(p) + Vec3(1e-9, 0, 0); }

inline ToneMap uniform_tone(const VisibleImage& visible, Tone level) {
  ToneMap tone;
  tone.width = visible.width;
  tone.height = visible.height;
  tone.cell_px = visible.cell_px;
  tone.band.assign(visible.triangle.size(), Band::nothing);
  tone.brightness.assign(visible.triangle.size(), 0.5F);
  for (const int triangle : visible.triangle) {
    tone.level.push_back(triangle == none ? Tone::nothing : level);
  }
  return tone;
}

// Everything that placement needs, and what it gives.
struct Scene {
  Surface surface;
  Camera camera;
  CrossField field;
  Families families;
  VisibleImage visible;
  ToneMap tone;
  LabelledGraph graph;
  HatchOptions options;
  std::vector<float> spacing_scale;  // (t)
  std::vector<std::uint8_t> unhatched;
  Counts counts;
  mutable std::optional<CriticalCurves> curves = std::nullopt;  // of the graph, of the last view

  HatchScene view() const {
    curves.emplace(graph, camera.width_px(), camera.height_px());
    return {surface, field, families, camera,        visible,
            tone,    graph, *curves,  spacing_scale, unhatched};
  }
  Hatches place() { return place_hatches(view(), options, counts); }
  Hatches even(const Ragged<SurfacePoint>& first = {}, int threads = 1) {
    return made_by(even_hatches, first, threads);
  }
  Hatches draft(const Ragged<SurfacePoint>& first = {}, int threads = 1) {
    return made_by(draft_hatches, first, threads);
  }
  Hatches made_by(decltype(even_hatches)& make, const Ragged<SurfacePoint>& first, int threads) {
    ObjectCurves curves_of_objects(surface, field);
    const std::vector<double> finest(surface.object_is_smooth.size(), 0);
    return make(view(), curves_of_objects.down_to(finest), first, options, threads, counts, {});
  }
  Hatches reduce(const Hatches& hatches) {
    return reduce_hatches(hatches, view(), options, counts);
  }
  int cell(const HatchPoint& point) const { return visible.cell_of(point.image); }
  // A visible arc through world points.
  void add_arc(Kind kind, const Points& line) {
    GraphArc arc{kind, 0, 0};
    arc.start_node = arc.end_node = 0;
    graph.arcs.push_back(arc);
    for (const Vec3& p : line) {
      graph.points.push({p, {}});
      graph.image.push(camera.project(p).xy);
    }
    graph.points.close_list();
    graph.image.close_list();
  }
};

template <class Direction>
inline Scene scene_of(Surface surface, const Camera& camera, const Direction& direction) {
  CrossField field = field_of(surface, direction);
  Families families = find_families(surface, surface.curvature, field);
  VisibleImage visible = render_visible(surface, camera, 1, {}, 1);
  ToneMap tone = uniform_tone(visible, Tone::shadow);
  return {std::move(surface),
          camera,
          std::move(field),
          std::move(families),
          std::move(visible),
          std::move(tone),
          {},
          {},
          {},
          {},
          {}};
}

// The square [-1, 1]^2 at z = 0, 100 px per unit, with a cross 20 degrees off the axes.
inline Scene plane_scene() {
  return scene_of(shapes::plain_surface(shapes::plane(13, 11)),
                  cameras::orthographic(Vec3::UnitZ(), 1.2, 240),
                  [](const Vec3&) { return Vec3(std::cos(0.35), std::sin(0.35), 0); });
}

inline Scene torus_scene() {
  return scene_of(shapes::torus_surface(1, 0.4, 90, 40),
                  cameras::perspective(Vec3(0, -3, 4), Vec3::Zero(), 0.1, 40, 400), round_z);
}

// On a scene with one upright crease at `column`: hatches end there, on both sides, and cross
// nowhere.
inline void check_ends_at_column(const Hatches& hatches, double column) {
  int ends_on_curve = 0;
  for (std::size_t h = 0; h < hatches.curves.size(); ++h) {
    const auto curve = hatches.curves[h];
    const bool left = curve[curve.size() / 2].image.x() < column;
    for (const HatchPoint& point : curve) {
      EXPECT_LT((point.image.x() - column) * (left ? 1 : -1), 1e-6) << "no hatch crosses";
    }
    ends_on_curve += std::abs(curve.front().image.x() - column) < 0.03;
    ends_on_curve += std::abs(curve.back().image.x() - column) < 0.03;
  }
  EXPECT_GT(ends_on_curve, 35);
}

// Two drawings are the same to the bit.
inline void expect_same_hatches(const Hatches& a, const Hatches& b) {
  ASSERT_EQ(a.curves.offsets, b.curves.offsets);
  for (std::size_t i = 0; i < a.curves.values.size(); ++i) {
    EXPECT_EQ(a.curves.values[i].position, b.curves.values[i].position);
  }
}

// What holds for any placement.
inline void check_hatches(const Scene& scene, const Hatches& hatches) {
  ASSERT_EQ(hatches.kinds.size(), hatches.curves.size());
  ASSERT_EQ(hatches.objects.size(), hatches.curves.size());
  for (std::size_t h = 0; h < hatches.curves.size(); ++h) {
    ASSERT_GE(hatches.curves[h].size(), 2U);
    for (const HatchPoint& point : hatches.curves[h]) {
      ASSERT_TRUE(point.position.allFinite() && point.image.allFinite());
      EXPECT_GE(std::min({point.on.b1, point.on.b2, 1 - point.on.b1 - point.on.b2}), -1e-12);
      EXPECT_LT((position_at(scene.surface, point.on) - point.position).norm(), 1e-12);
      EXPECT_LT((scene.camera.project(point.position).xy - point.image).norm(), 1e-9);
      EXPECT_EQ(scene.surface.triangle_objects[point.on.triangle], hatches.objects[h]);
      EXPECT_NE(scene.cell(point), none);
    }
  }
}

inline Vec3 tangent_at(Span<const HatchPoint> curve, std::size_t i) {
  const std::size_t a = i == 0 ? 0 : i - 1, b = std::min(i + 1, curve.size() - 1);
  return (curve[b].position - curve[a].position).normalized();
}

// The least image distance between points of different hatches that satisfy `pair(tangent,
// tangent)`.
template <class Pair>
inline double least_distance(const Hatches& hatches, const Pair& pair) {
  double least = 1e9;
  for (std::size_t a = 0; a < hatches.curves.size(); ++a) {
    for (std::size_t b = a + 1; b < hatches.curves.size(); ++b) {
      const auto one = hatches.curves[a], other = hatches.curves[b];
      for (std::size_t i = 0; i < one.size(); ++i) {
        for (std::size_t j = 0; j < other.size(); ++j) {
          const double distance = (one[i].image - other[j].image).norm();
          if (distance < least && pair(tangent_at(one, i), tangent_at(other, j))) least = distance;
        }
      }
    }
  }
  return least;
}

// The branch of the cross along which a hatch runs at a point.
inline Vec3 field_tangent(const Scene& scene, Span<const HatchPoint> curve, std::size_t i) {
  const SurfacePoint& on = curve[i].on;
  return cross_direction(scene.surface, scene.field, on, normal_at(scene.surface, on),
                         tangent_at(curve, i));
}

// No hatch is longer than `most_px` where max_length_px is 60, none turns more than max_turn_deg
// each way. `place` hatches the scene with the options it finds there.
template <class Place>
inline void check_limits(Scene& scene, double most_px, const Place& place) {
  scene.options.max_length_px = 60;
  const Hatches shorter = place();
  for (std::size_t h = 0; h < shorter.curves.size(); ++h) {
    EXPECT_LT(length_px(shorter.curves[h]), most_px);
  }
  scene.options = {};
  scene.options.max_turn_deg = 30;
  const Hatches hatches = place();
  for (std::size_t h = 0; h < hatches.curves.size(); ++h) {
    const auto curve = hatches.curves[h];
    const Vec3 last = field_tangent(scene, curve, curve.size() - 1);
    EXPECT_GT(field_tangent(scene, curve, 0).dot(last), std::cos(63 * pi / 180))
        << "30 degrees each way, and a step";
  }
}

inline bool parallel(const Vec3& a, const Vec3& b) { return std::abs(a.dot(b)) > 0.75; }
inline bool perpendicular(const Vec3& a, const Vec3& b) { return std::abs(a.dot(b)) < 0.6; }

// The greatest distance of a covered cell to the nearest hatch along `direction`, away from the
// outline.
inline double worst_gap(const Scene& scene, const Hatches& hatches, const Vec3& direction) {
  double worst = 0;
  for (double x = -0.85; x < 0.86; x += 0.05) {
    for (double y = -0.85; y < 0.86; y += 0.05) {
      const Vec2 p = scene.camera.project(Vec3(x, y, 0)).xy;
      double nearest = 1e9;
      for (std::size_t h = 0; h < hatches.curves.size(); ++h) {
        const auto curve = hatches.curves[h];
        if (!parallel(tangent_at(curve, curve.size() / 2), direction)) continue;
        for (const HatchPoint& q : curve) nearest = std::min(nearest, (q.image - p).norm());
      }
      worst = std::max(worst, nearest);
    }
  }
  return worst;
}

}  // namespace illustrate::hatching
