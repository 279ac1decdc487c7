#include "hatch/streamlines/surface_seeds.h"

#include <algorithm>
#include <cmath>

#include "hatch/streamlines/edge_seeds.h"
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

// (objects) whether each has fewer places on its surface than this view wants.
std::vector<std::uint8_t> near_objects(const CurvesOfObjects& curves,
                                       const std::vector<double>& spacings) {
  std::vector<std::uint8_t> is_near(curves.size(), 0);
  for (std::size_t i = 0; i < curves.size(); ++i) {
    is_near[i] =
        curves[i] && seed_count(curves[i].area(), spacings[i]) > curves[i].shared->seeds.size();
  }
  return is_near;
}

// What is seen of these objects under a lattice of the image.
std::vector<SurfacePoint> lattice_places(const HatchScene& scene, const HatchView& view,
                                         const std::vector<std::uint8_t>& objects) {
  std::vector<SurfacePoint> places;
  if (std::find(objects.begin(), objects.end(), 1) == objects.end()) return places;
  const auto is_asked = [&](int triangle) {
    return triangle != none && objects[idx(scene.surface.triangle_objects[idx(triangle)])] != 0;
  };
  visit_lattice(scene.camera.width_px(), scene.camera.height_px(),
                surface_lattice_step * view.spacing_px(), [&](std::int64_t, const Vec2& image) {
                  if (!is_asked(view.triangle_at(image))) return;
                  const SurfacePoint on = view.area.visible_point(image);
                  if (is_asked(on.triangle)) places.push_back(on);
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

SeedPlaces seed_places(const HatchScene& scene, const HatchView& view,
                       const CurvesOfObjects& curves) {
  SeedPlaces places;
  places.spacings = mean_spacings(scene, view.spacing_px());
  places.lattice = lattice_places(scene, view, near_objects(curves, places.spacings));
  places.strips = edge_places(view);
  return places;
}

std::vector<StreamlineNode> surface_seeds(const HatchView& view, const CurvesOfObjects& curves,
                                          const SeedPlaces& places) {
  std::vector<StreamlineNode> seeds;
  for (std::size_t i = 0; i < curves.size(); ++i) {
    if (!curves[i]) continue;
    const std::size_t count = seed_count(curves[i].area(), places.spacings[i]);
    append(seeds, seed_nodes(view, curves[i].seeds(), count));
  }
  append(seeds, seed_nodes(view, places.lattice, places.lattice.size()));
  return seeds;
}

}  // namespace illustrate
