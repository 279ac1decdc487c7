#include "tone/light_contours.h"

#include <algorithm>

#include "contour/back_sides.h"
#include "contour/silhouettes.h"
#include "surface/locate.h"
#include "tone/light_views.h"
#include "tone/shadow_outlines.h"
#include "tone/shadows.h"

namespace illustrate {
namespace {

// How often a segment that is lit at one end only is halved to find where the light ends.
constexpr int halvings = 8;

class Terminators {
 public:
  // shows_back: (objects) of the camera's view.
  Terminators(const ContourScene& scene, const Bvh& casters, const Light& light,
              const Camera& camera, const std::vector<std::uint8_t>& shows_back, FreeLines& result)
      : scene_(scene),
        casters_(casters),
        light_(light),
        camera_(camera),
        shows_back_(shows_back),
        result_(result) {
    light_.edge_u = light_.edge_v = Vec3::Zero();
  }

  void add(const Camera& light_view) {
    const ContourFunctions functions(scene_.surface, light_view);
    const LinearSilhouettes found = linear_silhouettes(scene_.surface, functions, scene_.dual);
    for (std::size_t c = 0; c < found.chains.size(); ++c) {
      std::vector<ZeroPoint> line;
      for (const EdgePoint& p : found.chains[c]) line.push_back(zero_point(p));
      add_lit(std::move(line), found.closed[c] != 0);
    }
  }

 private:
  ZeroPoint zero_point(const EdgePoint& p) const {
    ZeroPoint result;
    result.position = p.position;
    result.on = p.on;
    result.edge = p.edge;
    result.fraction = p.fraction;
    const int object = scene_.surface.object_of(p.on.triangle);
    result.unseen = !shows_back_[idx(object)] &&
                    normal_at(scene_.surface, p.on).dot(camera_.to_eye(p.position)) < 0;
    return result;
  }

  bool is_lit(const ZeroPoint& p) const {
    if (!shines_at(light_, p.position)) return false;
    if (!light_.casts_shadows) return true;
    Vec3 normal = normal_at(scene_.surface, p.on);
    if (normal.dot(camera_.to_eye(p.position)) < 0) normal = -normal;
    const Vec3 origin = shadow_origin(scene_.surface, p.on, normal);
    return share_reaching(light_, camera_, casters_, origin, normal) > 0;
  }

  // The parts of a chain that the light reaches.
  void add_lit(std::vector<ZeroPoint> chain, bool closed) {
    std::vector<std::uint8_t> lit;
    for (const ZeroPoint& p : chain) lit.push_back(is_lit(p));
    const auto dark = std::find(lit.begin(), lit.end(), 0);
    if (dark == lit.end()) {
      result_.add({chain.data(), chain.size()}, closed, Kind::terminator);
      return;
    }
    if (closed) {
      const auto shift = dark - lit.begin();
      std::rotate(chain.begin(), chain.begin() + shift, chain.end());
      std::rotate(lit.begin(), lit.begin() + shift, lit.end());
      chain.push_back(chain.front());
      lit.push_back(0);
    }
    std::vector<ZeroPoint> line;
    for (std::size_t i = 0; i < chain.size(); ++i) {
      if (i > 0 && lit[i] != lit[i - 1]) line.push_back(border(chain[i - 1], chain[i], lit[i - 1]));
      if (lit[i]) line.push_back(chain[i]);
      if (!lit[i] || i + 1 == chain.size()) end(line);
    }
  }

  // Where the light ends on the segment between two points; it lies in the first one's triangle.
  ZeroPoint border(const ZeroPoint& from, const ZeroPoint& to, bool from_is_lit) const {
    ZeroPoint end = to;
    end.on = locate(scene_.surface, from.on.triangle, to.position);
    double low = 0, high = 1;
    for (int i = 0; i < halvings; ++i) {
      const double middle = (low + high) / 2;
      (is_lit(between(from, end, middle)) == from_is_lit ? low : high) = middle;
    }
    return between(from, end, (low + high) / 2);
  }

  void end(std::vector<ZeroPoint>& line) {
    if (line.size() > 1) result_.add({line.data(), line.size()}, false, Kind::terminator);
    line.clear();
  }

  const ContourScene& scene_;
  const Bvh& casters_;
  Light light_;  // its middle alone
  const Camera& camera_;
  const std::vector<std::uint8_t>& shows_back_;
  FreeLines& result_;
};

Eigen::AlignedBox3d box_of(const Surface& surface) {
  Eigen::AlignedBox3d box;
  for (const Eigen::AlignedBox3d& object : object_boxes(surface)) box.extend(object);
  return box;
}

}  // namespace

FreeLines light_contours(const ContourScene& scene, const LightCasters& casters,
                         const std::vector<Light>& lights, const Camera& camera,
                         const LightContourOptions& options, int threads,
                         const Progress& progress) {
  FreeLines result;
  const Eigen::AlignedBox3d box = box_of(casters.scene.surface);
  std::vector<std::uint8_t> backs;
  if (options.terminators) backs = shows_back(scene.surface, scene.intersections, camera);
  for (std::size_t i = 0; i < lights.size(); ++i) {
    const Light& light = lights[i];
    const double count = static_cast<double>(lights.size());
    const Progress mine =
        progress.part(static_cast<double>(i) / count, static_cast<double>(i + 1) / count, "tone");
    mine.report(0);
    const std::vector<Camera> views = light_views(light, camera, box);
    if (views.empty() || !light.contours || !(light.strength > 0)) continue;
    if (options.terminators) {
      Terminators(scene, casters.bvh, light, camera, backs, result).add(views[0]);
    }
    if (!options.shadow_outlines || !light.casts_shadows) continue;
    for (const Camera& view : views) {
      add_shadow_outlines(scene.surface, casters, light, view, camera, threads, mine, result);
    }
  }
  return result;
}

}  // namespace illustrate
