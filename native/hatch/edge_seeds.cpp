#include "hatch/edge_seeds.h"

#include "hatch/grow_streamlines.h"
#include "hatch/image_lattice.h"

namespace illustrate {
namespace {

// In spacings: of the lattice; how far strips reach from a curve; where streamlines are near.
constexpr double lattice_step = 0.25;
constexpr double strip_width = 0.9;
constexpr double near = 0.9;

// Whether streamlines of both families pass near a point of the image, on its sheet.
bool is_crossed(const StreamlineGrid& grid, const Vec2& image, double depth, double spacing_world,
                double radius) {
  const GridNode* first = nullptr;
  return grid.any_near(image, radius, [&](const GridNode& node) {
    const Vec2 offset(double(node.x) - image.x(), double(node.y) - image.y());
    if (offset.squaredNorm() > radius * radius) return false;
    if (std::abs(depth - double(node.depth)) > 3 * spacing_world) return false;
    if (!first) first = &node;
    const float cosine = first->tangent.dot(node.tangent);
    return 2 * cosine * cosine < 1;
  });
}

}  // namespace

std::vector<StreamlineNode> edge_seeds(const StreamlineSet& set, const HatchView& view) {
  const Camera& camera = view.camera();
  const Surface& surface = view.walker.on_surface().surface();
  const double spacing = std::max(1.0, view.options.spacing_px);
  std::vector<SurfacePoint> places;
  visit_lattice(camera.width_px(), camera.height_px(), lattice_step * spacing,
                [&](std::int64_t, const Vec2& image) {
                  if (!view.curves.pass(image, strip_width * spacing)) return;
                  const SurfacePoint on = view.area.visible_point(image);
                  if (on.triangle == none) return;
                  const Vec3 position = position_at(surface, on);
                  const double world = spacing * camera.pixel_size(position);
                  const double depth = camera.project(position).depth;
                  if (is_crossed(set.grid, image, depth, world, near * spacing)) return;
                  places.push_back(on);
                });
  return seed_nodes(view, places, places.size());
}

}  // namespace illustrate
