#include "hatch/curves/object_curves.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/parallel.h"

namespace illustrate {

Ragged<SurfacePoint> CurvesOfObject::curves() const {
  Ragged<SurfacePoint> own = shared->curves;
  for (SurfacePoint& on : own.values) on = placed(on);
  return own;
}

std::vector<SurfacePoint> CurvesOfObject::seeds() const {
  std::vector<SurfacePoint> own = shared->seeds;
  for (SurfacePoint& on : own) on = placed(on);
  return own;
}

void ObjectCurves::rank(const Surface& surface, const CrossField& field,
                        const std::vector<double>& areas) {
  std::vector<std::vector<int>> triangles(surface.object_is_smooth.size());
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    triangles[idx(surface.triangle_objects[t])].push_back(static_cast<int>(t));
  }
  for (std::vector<int>& of_object : triangles) {
    originals_.push_back(
        std::make_unique<RankedCurves>(surface, field, std::move(of_object), areas));
  }
}

ObjectCurves::ObjectCurves(const Surface& surface, const CrossField& field,
                           const std::vector<double>& areas) {
  rank(surface, field, areas);
  for (std::size_t o = 0; o < originals_.size(); ++o) objects_.push_back({o, 0, 1});
}

ObjectCurves::ObjectCurves(const Surface& originals, const CrossField& field,
                           const Instances& instances, const std::vector<double>& areas) {
  const std::vector<int> first = first_triangles(originals);
  std::vector<double> of_originals(areas.empty() ? 0 : originals.triangles.size(), 0);
  int next = 0;
  for (std::size_t o = 0; o < instances.originals.size(); ++o) {
    const std::size_t original = idx(instances.originals[o]);
    const double scale = instances.placements[o].scale;
    for (int t = first[original]; !areas.empty() && t < first[original + 1]; ++t) {
      double& area = of_originals[idx(t)];
      if (area == 0) area = areas[idx(next + t - first[original])] / (scale * scale);
    }
    objects_.push_back({original, next - first[original], scale});
    next += first[original + 1] - first[original];
  }
  rank(originals, field, of_originals);
}

CurvesOfObjects ObjectCurves::down_to(const std::vector<double>& radii,
                                      const std::vector<std::uint8_t>& seeds_only, int threads,
                                      const Progress& progress) {
  const auto has_curves = [&](std::size_t o) { return seeds_only.empty() || !seeds_only[o]; };
  std::vector<double> finest(originals_.size(), std::numeric_limits<double>::infinity());
  for (std::size_t o = 0; o < objects_.size(); ++o) {
    double& of_original = finest[objects_[o].original];
    if (has_curves(o)) of_original = std::min(of_original, radii[o] / objects_[o].scale);
  }
  progress.report(0);
  make(finest, threads, progress);
  CurvesOfObjects curves(objects_.size());
  for (std::size_t o = 0; o < objects_.size(); ++o) {
    if (std::isfinite(radii[o])) curves[o] = of_object(objects_[o], radii[o], has_curves(o));
  }
  progress.report(1);
  return curves;
}

CurvesOfObject ObjectCurves::of_object(const Placed& object, double radius, bool has_curves) {
  RankedCurves& ranked = *originals_[object.original];
  const double of_original = radius / object.scale;
  return {has_curves ? &ranked.down_to(of_original) : &ranked.seeds_to(of_original),
          object.first_triangle, object.scale};
}

void ObjectCurves::make(const std::vector<double>& finest, int threads, const Progress& progress) {
  std::vector<std::size_t> wanted;
  for (std::size_t i = 0; i < finest.size(); ++i) {
    if (std::isfinite(finest[i])) wanted.push_back(i);
  }
  parallel_parts(std::vector<std::size_t>(wanted.size(), 1), {}, threads, progress,
                 [&](std::size_t k, int, const Progress& part) {
                   originals_[wanted[k]]->down_to(finest[wanted[k]], part);
                 });
}

}  // namespace illustrate
