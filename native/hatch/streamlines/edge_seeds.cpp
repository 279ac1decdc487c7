#include "hatch/streamlines/edge_seeds.h"

#include "hatch/streamlines/grow_streamlines.h"
#include "hatch/view/image_lattice.h"

namespace illustrate {
namespace {

// In spacings: of the lattice; how far strips reach from a curve; where streamlines are near.
constexpr double lattice_step = 0.25;
constexpr double strip_width = 0.9;
constexpr double near_streamlines = 0.9;

// Whether streamlines of both families pass near a point of the image, on its sheet and side of
// all critical curves.
bool is_crossed(const StreamlineSet& set, const HatchView& view, const Vec2& image, double depth,
                double spacing_world, double radius) {
  const GridNode* first = nullptr;
  return set.grid.any_in_box(image, Vec2(radius, radius), [&](const GridNode& node) {
    if ((node.image - image).squaredNorm() > radius * radius) return false;
    if (std::abs(depth - double(node.depth)) > 3 * spacing_world) return false;
    const float cosine = first ? first->tangent.dot(node.tangent) : 1;
    if ((first && 2 * cosine * cosine >= 1) || view.curves.separate(image, node.image))
      return false;
    if (!first) first = &node;
    return 2 * cosine * cosine < 1;
  });
}

// Which squares have their middles where hatches are wanted near a critical curve: looked for row
// by row, as they lie in memory.
std::vector<std::uint8_t> strips(const HatchView& view, const ImageLattice& lattice) {
  std::vector<std::uint8_t> is_near(static_cast<std::size_t>(lattice.count()));
  std::size_t square = 0;
  for (std::int64_t row = 0; row < lattice.rows; ++row) {
    for (std::int64_t column = 0; column < lattice.columns; ++column, ++square) {
      const Vec2 image = lattice.middle(row, column);
      const int triangle = view.triangle_at(image);
      is_near[square] =
          triangle != none && view.curves.pass(image, strip_width * view.spacing_on(triangle));
    }
  }
  return is_near;
}

}  // namespace

std::vector<SurfacePoint> edge_places(const HatchView& view) {
  const Camera& camera = view.camera();
  const double spacing = std::max(1.0, view.spacing_px());
  const ImageLattice lattice(camera.width_px(), camera.height_px(), lattice_step * spacing);
  const std::vector<std::uint8_t> is_near = strips(view, lattice);
  std::vector<SurfacePoint> places;
  lattice.visit([&](std::int64_t square) {
    if (!is_near[static_cast<std::size_t>(square)]) return;
    const SurfacePoint on = view.area.visible_point(lattice.middle(square));
    if (on.triangle != none) places.push_back(on);
  });
  return places;
}

std::vector<StreamlineNode> edge_seeds(const StreamlineSet& set, const HatchView& view,
                                       const std::vector<SurfacePoint>& places) {
  const Camera& camera = view.camera();
  const Surface& surface = view.walker.on_surface().surface();
  std::vector<SurfacePoint> open;
  for (const SurfacePoint& on : places) {
    const Vec3 position = position_at(surface, on);
    const ImagePoint seen = camera.project(position);
    const double spacing = view.spacing_on(on.triangle);
    const double world = spacing * camera.pixel_size(position);
    if (!is_crossed(set, view, seen.xy, seen.depth, world, near_streamlines * spacing))
      open.push_back(on);
  }
  return seed_nodes(view, open);
}

}  // namespace illustrate
