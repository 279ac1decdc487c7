#include "hatch/streamlines/surface_seeds.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "hatch/streamlines/edge_seeds.h"
#include "hatch/streamlines/grow_streamlines.h"
#include "hatch/view/image_lattice.h"

namespace illustrate {
namespace {

// Seeds on the whole surface for each square of a spacing, seen face on.
constexpr double seeds_per_square = 3;

// Of the lattice of the image that helps where seeds on the surface are too few, in spacings.
constexpr double surface_lattice_step = 0.5;

constexpr double infinite = std::numeric_limits<double>::infinity();

std::size_t seed_count(double area, double spacing) {
  const double count = spacing > 0 ? seeds_per_square * area / (spacing * spacing) : 0;
  return static_cast<std::size_t>(std::min(count, 1e9));
}

// (objects) the scales below which each has fewer places on its surface than this view wants; 0
// where it wants no more anywhere.
std::vector<double> near_scales(const CurvesOfObjects& curves, const ObjectSpacings& spacings) {
  std::vector<double> scales(curves.size(), 0);
  for (std::size_t i = 0; i < curves.size(); ++i) {
    const std::size_t count = curves[i] ? curves[i].shared->seeds.size() : 0;
    if (count == 0 || seed_count(curves[i].area(), spacings.least[i]) <= count) continue;
    const double served = std::sqrt(seeds_per_square * curves[i].area() / double(count));
    scales[i] = served / spacings.plain[i];
  }
  return scales;
}

// What is seen of objects under a lattice of the image, where the spacing is scaled by less than
// theirs.
std::vector<SurfacePoint> lattice_places(const HatchScene& scene, const HatchView& view,
                                         const std::vector<double>& below) {
  std::vector<SurfacePoint> places;
  if (std::all_of(below.begin(), below.end(), [](double scale) { return scale == 0; })) {
    return places;
  }
  const auto is_asked = [&](int triangle) {
    return triangle != none &&
           scene.scale_on(triangle) < below[idx(scene.surface.object_of(triangle))];
  };
  visit_lattice(scene.camera.width_px(), scene.camera.height_px(),
                surface_lattice_step * view.spacing_px(), [&](std::int64_t, const Vec2& image) {
                  if (!is_asked(view.triangle_at(image))) return;
                  const SurfacePoint on = view.area.visible_point(image);
                  if (is_asked(on.triangle)) places.push_back(on);
                });
  return places;
}

// The first places on an object, everywhere as many as its spacing there asks for, where hatches
// may pass.
std::vector<SurfacePoint> wanted_places(const HatchView& view, const CurvesOfObject& curves,
                                        double plain_spacing,
                                        const std::vector<std::uint8_t>& passable) {
  const std::vector<SurfacePoint>& seeds = curves.shared->seeds;
  std::vector<SurfacePoint> wanted;
  for (std::size_t i = 0; i < seeds.size(); ++i) {
    const SurfacePoint seed = curves.placed(seeds[i]);
    if (!passable[idx(seed.triangle)]) continue;
    const double spacing = plain_spacing * view.scale_on(seed.triangle);
    if (i < seed_count(curves.area(), spacing)) wanted.push_back(seed);
  }
  return wanted;
}

void append(std::vector<StreamlineNode>& seeds, const std::vector<StreamlineNode>& more) {
  seeds.insert(seeds.end(), more.begin(), more.end());
}

}  // namespace

ObjectSpacings object_spacings(const HatchScene& scene, double spacing_px) {
  const std::size_t objects = scene.surface.object_is_smooth.size();
  std::vector<double> sums(objects, 0), counts(objects, 0), scales(objects, infinite);
  int last = none;
  double spacing = 0;
  for (const int triangle : scene.visible.triangle) {
    if (triangle == none) continue;
    const std::size_t object = idx(scene.surface.object_of(triangle));
    if (!scene.is_hatched(static_cast<int>(object))) continue;
    if (triangle != last) {
      const Vec3& p = scene.surface.positions[idx(scene.surface.triangles[idx(triangle)][0])];
      spacing = scene.camera.pixel_size(p) * spacing_px;
      scales[object] = std::min(scales[object], scene.scale_on(triangle));
      last = triangle;
    }
    sums[object] += spacing;
    counts[object] += 1;
  }
  ObjectSpacings spacings;
  for (std::size_t i = 0; i < objects; ++i) {
    spacings.plain.push_back(sums[i] / std::max(1.0, counts[i]));
    spacings.least.push_back(counts[i] > 0 ? scales[i] * spacings.plain[i] : 0);
  }
  return spacings;
}

SeedPlaces seed_places(const HatchScene& scene, const HatchView& view,
                       const CurvesOfObjects& curves) {
  ObjectSpacings spacings = object_spacings(scene, view.spacing_px());
  SeedPlaces places;
  places.lattice = lattice_places(scene, view, near_scales(curves, spacings));
  places.spacings = std::move(spacings.plain);
  places.strips = edge_places(view);
  return places;
}

std::vector<StreamlineNode> surface_seeds(const HatchView& view, const CurvesOfObjects& curves,
                                          const SeedPlaces& places,
                                          const std::vector<std::uint8_t>& passable) {
  std::vector<StreamlineNode> seeds;
  for (std::size_t i = 0; i < curves.size(); ++i) {
    if (!curves[i]) continue;
    append(seeds, seed_nodes(view, wanted_places(view, curves[i], places.spacings[i], passable)));
  }
  append(seeds, seed_nodes(view, places.lattice));
  return seeds;
}

}  // namespace illustrate
