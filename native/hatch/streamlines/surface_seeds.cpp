#include "hatch/streamlines/surface_seeds.h"

#include <algorithm>
#include <cmath>

#include "hatch/streamlines/grow_streamlines.h"
#include "hatch/view/image_lattice.h"

namespace illustrate {
namespace {

// Seeds on the whole surface for each square of a spacing, seen face on.
constexpr double seeds_per_square = 3;

// Of the lattice of the image that helps where seeds on the surface are too few, in spacings.
constexpr double surface_lattice_step = 0.5;

std::size_t seed_count(double area, double spacing) {
  const double count = spacing > 0 ? seeds_per_square * area / (spacing * spacing) : 0;
  return static_cast<std::size_t>(std::min(count, 1e9));
}

// What is seen under a lattice of the image.
std::vector<SurfacePoint> lattice_places(const HatchScene& scene, const HatchView& view,
                                         double step_px) {
  std::vector<SurfacePoint> places;
  visit_lattice(scene.camera.width_px(), scene.camera.height_px(), step_px,
                [&](std::int64_t, const Vec2& image) {
                  const SurfacePoint on = view.area.visible_point(image);
                  if (on.triangle != none) places.push_back(on);
                });
  return places;
}

void append(std::vector<StreamlineNode>& seeds, const std::vector<StreamlineNode>& more) {
  seeds.insert(seeds.end(), more.begin(), more.end());
}

}  // namespace

std::vector<double> mean_spacings(const HatchScene& scene, double spacing_px) {
  const std::size_t objects = scene.surface.object_is_smooth.size();
  std::vector<double> sums(objects, 0), counts(objects, 0);
  int last = none;
  double spacing = 0;
  for (const int triangle : scene.visible.triangle) {
    if (triangle == none) continue;
    const int object = scene.surface.triangle_objects[idx(triangle)];
    if (!scene.is_hatched(object)) continue;
    if (triangle != last) {
      const Vec3& p = scene.surface.positions[idx(scene.surface.triangles[idx(triangle)][0])];
      spacing = scene.camera.pixel_size(p) * scene.spacing_on(object, spacing_px);
      last = triangle;
    }
    sums[idx(object)] += spacing;
    counts[idx(object)] += 1;
  }
  for (std::size_t i = 0; i < objects; ++i) sums[i] /= std::max(1.0, counts[i]);
  return sums;
}

std::vector<StreamlineNode> surface_seeds(const HatchScene& scene, const HatchView& view,
                                          const CurvesOfObjects& curves) {
  const double spacing_px = view.spacing_px();
  const std::vector<double> spacings = mean_spacings(scene, spacing_px);
  std::vector<StreamlineNode> seeds;
  std::vector<std::uint8_t> is_near(curves.size(), 0);
  for (std::size_t i = 0; i < curves.size(); ++i) {
    if (!curves[i]) continue;
    const std::size_t count = seed_count(curves[i].area(), spacings[i]);
    append(seeds, seed_nodes(view, curves[i].seeds(), count));
    is_near[i] = count > curves[i].shared->seeds.size();
  }
  if (std::find(is_near.begin(), is_near.end(), 1) == is_near.end()) return seeds;
  std::vector<SurfacePoint> places = lattice_places(scene, view, surface_lattice_step * spacing_px);
  const auto is_far = [&](const SurfacePoint& on) {
    return !is_near[idx(scene.surface.triangle_objects[idx(on.triangle)])];
  };
  places.erase(std::remove_if(places.begin(), places.end(), is_far), places.end());
  append(seeds, seed_nodes(view, places, places.size()));
  return seeds;
}

}  // namespace illustrate
