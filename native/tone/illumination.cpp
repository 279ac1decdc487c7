#include "tone/illumination.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "core/parallel.h"
#include "tone/shadows.h"
#include "tone/sparse_cells.h"

namespace illustrate {
namespace {

constexpr std::size_t cells_at_a_time = 1 << 12;
constexpr double least_facing = 0.01;  // of a surface that is seen edge-on

// In cells of the image.
Vec2 middle_of(std::size_t cell, const VisibleImage& visible) {
  const std::size_t row = cell / idx(visible.width), column = cell % idx(visible.width);
  return {static_cast<double>(column) + 0.5, static_cast<double>(row) + 0.5};
}

class Illumination {
 public:
  Illumination(const LitScene& scene, const VisibleImage& visible, const Camera& camera,
               const std::vector<Light>& lights)
      : scene_(scene),
        surface_(scene.surface),
        visible_(visible),
        camera_(camera),
        lights_(lights.empty() ? std::vector<Light>{Light{}} : lights),
        soft_shares_(lights_.size()),
        map_(image_map(camera)) {
    if (scene_.lightness && scene_.lightness->is_white()) scene_.lightness = nullptr;
  }

  void find_soft_shadows(int threads, const Progress& progress) {
    for (std::size_t i = 0; i < lights_.size(); ++i) {
      const Light& light = lights_[i];
      if (!casts_shadows(light) || light.kind != LightKind::area || !light.has_extent()) continue;
      const double count = static_cast<double>(lights_.size());
      const double begin = static_cast<double>(i) / count;
      soft_shares_[i] = ask_sparsely(
          surface_, visible_, camera_,
          [&](std::size_t cell) {
            const Corners corners = corners_of(visible_.triangle[cell]);
            const Place place = place_at(cell, corners);
            return received(light, camera_, place.position, place.normal) > 0
                       ? reaching(light, place)
                       : 0;
          },
          threads, progress.part(begin, begin + 1 / count));
    }
  }

  // Sets the light at the visible ones of the cells [begin, end).
  void light_cells(std::size_t begin, std::size_t end, std::vector<double>& light) const {
    Corners corners;
    for (std::size_t cell = begin; cell < end; ++cell) {
      const int triangle = visible_.triangle[cell];
      if (triangle == none) continue;
      if (triangle != corners.triangle) {
        corners = corners_of(triangle);
        if (scene_.lightness) corners.lightness = scene_.lightness->of_triangle(triangle);
      }
      light[cell] = at(cell, corners);
    }
  }

 private:
  // Of a triangle that several cells in a row see.
  struct Corners {
    int triangle = none;
    std::array<Vec3, 3> mapped, positions, normals;
    std::optional<FaceLightness> lightness;  // none: white
  };

  // The middle of a cell, on the surface; the normal is unit, on the eye's side.
  struct Place {
    SurfacePoint on;
    Vec3 position, normal;
  };

  bool casts_shadows(const Light& light) const { return scene_.casters && light.casts_shadows; }

  Corners corners_of(int triangle) const {
    Corners corners;
    corners.triangle = triangle;
    for (int k = 0; k < 3; ++k) {
      const int vertex = surface_.triangles[triangle][k];
      corners.positions[k] = surface_.positions[vertex];
      corners.mapped[k] = apply(map_, corners.positions[k]);
      corners.normals[k] = surface_.corner_sign(triangle, k) * surface_.normals[vertex];
    }
    return corners;
  }

  static Vec3 between(const std::array<Vec3, 3>& corners, const SurfacePoint& on) {
    return (1 - on.b1 - on.b2) * corners[0] + on.b1 * corners[1] + on.b2 * corners[2];
  }

  Place place_at(std::size_t cell, const Corners& corners) const {
    const Vec2 image = middle_of(cell, visible_) * visible_.cell_px;
    Place place;
    place.on = surface_point_under(corners.mapped, corners.triangle, image);
    place.position = between(corners.positions, place.on);
    const Vec3 mean = between(corners.normals, place.on);
    const double length = mean.norm();
    place.normal = length > 0 ? Vec3(mean / length) : corners.normals[0];
    if (place.normal.dot(camera_.to_eye(place.position)) < 0) place.normal = -place.normal;
    return place;
  }

  double at(std::size_t cell, const Corners& corners) const {
    const Place place = place_at(cell, corners);
    double sum = 0, all = 0;
    for (std::size_t i = 0; i < lights_.size(); ++i) {
      const double share = received(lights_[i], camera_, place.position, place.normal);
      if (!(share > 0)) continue;
      all += share;
      sum += share * (soft_shares_[i].empty() ? reaching(lights_[i], place)
                                              : static_cast<double>(soft_shares_[i][cell]));
    }
    if (surface_.is_of(scene_.catchers, corners.triangle)) return all > 0 ? sum / all : 1;
    return corners.lightness ? sum * thrown_back(*corners.lightness, place) : sum;
  }

  // A texture is seen as far as a cell reaches on the surface.
  double thrown_back(const FaceLightness& lightness, const Place& place) const {
    const Vec3 to_eye = camera_.to_eye(place.position).normalized();
    const double facing = std::max(place.normal.dot(to_eye), least_facing);
    const double size = visible_.cell_px * camera_.pixel_size(place.position) / std::sqrt(facing);
    return 1 - scene_.reflectance * (1 - lightness.at(place.position, size));
  }

  double reaching(const Light& light, const Place& place) const {
    if (!casts_shadows(light)) return 1;
    return share_reaching(light, camera_, *scene_.casters,
                          shadow_origin(surface_, place.on, place.normal), place.normal);
  }

  LitScene scene_;
  const Surface& surface_;
  const VisibleImage& visible_;
  const Camera& camera_;
  const std::vector<Light> lights_;
  std::vector<std::vector<float>> soft_shares_;  // of the lights; empty: asked for at every cell
  const ImageMap map_;
};

void copy_light(const Texture& image, const VisibleImage& visible, const Camera& camera,
                std::size_t begin, std::size_t end, std::vector<double>& light) {
  const Vec2 frame(camera.width_px(), camera.height_px());
  const Vec2 cell_share = visible.cell_px * frame.cwiseInverse();
  const double texels = image.size() * std::sqrt(cell_share.x() * cell_share.y());
  for (std::size_t cell = begin; cell < end; ++cell) {
    if (visible.triangle[cell] == none) continue;
    const Vec2 place = middle_of(cell, visible).cwiseProduct(cell_share);
    light[cell] = image.mean_at(Vec2(place.x(), 1 - place.y()), texels);
  }
}

}  // namespace

std::vector<double> light_of_cells(const LitScene& scene, const VisibleImage& visible,
                                   const Camera& camera, const std::vector<Light>& lights,
                                   int threads, const Progress& progress) {
  Illumination illumination(scene, visible, camera, lights);
  illumination.find_soft_shadows(threads, progress.part(0, 0.5));
  std::vector<double> light(visible.triangle.size(), 0);
  const std::size_t pieces = (light.size() + cells_at_a_time - 1) / cells_at_a_time;
  parallel_each(pieces, threads, progress.part(0.5, 1), [&](std::size_t piece) {
    const std::size_t begin = piece * cells_at_a_time;
    illumination.light_cells(begin, std::min(begin + cells_at_a_time, light.size()), light);
  });
  return light;
}

std::vector<double> light_of_image(const Texture& image, const VisibleImage& visible,
                                   const Camera& camera, int threads, const Progress& progress) {
  std::vector<double> light(visible.triangle.size(), 0);
  parallel_for(light.size(), threads, progress, [&](std::size_t begin, std::size_t end) {
    copy_light(image, visible, camera, begin, end, light);
  });
  return light;
}

}  // namespace illustrate
