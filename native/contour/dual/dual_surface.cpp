#include "contour/dual/dual_surface.h"

#include <algorithm>

#include "contour/contour_functions.h"
#include "contour/polygon_silhouettes.h"
#include "core/parallel.h"
#include "core/sort_unique.h"
#include "core/tolerances.h"

namespace illustrate {
namespace {

// How often an item that no face holds is cut. Once suffices for planes at a right angle; what is
// left after two cuts has nearly opposite normals, or none.
constexpr int most_cuts = 2;

// Both the duals and g are computed to a few units in the last place of the distance to the eye:
// far less than this share of the noise that counts as zero.
constexpr double rounding = 1e-3;

struct Frame {
  Vec3 origin = Vec3::Zero();
  double unit = 1;

  Vec4 dual(const Vec3& normal, const Vec3& p) const {
    Vec4 result;
    result << normal, -normal.dot((p - origin) / unit);
    return result;
  }
};

std::vector<Frame> frames_of(const Surface& surface) {
  const std::vector<Eigen::AlignedBox3d> boxes = object_boxes(surface);
  std::vector<Frame> frames(boxes.size());
  for (std::size_t o = 0; o < boxes.size(); ++o) {
    if (boxes[o].isEmpty()) continue;
    frames[o].origin = boxes[o].center();
    const double half = boxes[o].diagonal().norm() / 2;
    if (half > 0) frames[o].unit = half;
  }
  return frames;
}

using Corners = std::array<Vec4, 3>;

// What goes into the tree of one object.
struct Items {
  std::vector<DualItem> placed;
  std::vector<int> always;
};

// Places the quarters of an item between its corners and the middles of its sides, each cut again
// up to `cuts` times where no face holds it. Where the plane has corners of the whole on both
// sides, it has corners of a quarter on both sides.
void place_quarters(int id, const Corners& corners, int cuts, Items& items) {
  const auto& [a, b, c] = corners;
  const Vec4 ab = (a + b) / 2, bc = (b + c) / 2, ca = (c + a) / 2;
  for (const Corners& quarter : {Corners{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}}) {
    if (const auto item = dual_item(id, quarter)) {
      items.placed.push_back(*item);
    } else if (cuts > 0) {
      place_quarters(id, quarter, cuts - 1, items);
    } else {
      items.always.push_back(id);
    }
  }
}

template <class CornersOf>
Items items_of(const std::vector<int>& ids, const CornersOf& corners_of, int threads,
               const Progress& progress) {
  Items items;
  items.placed.resize(ids.size());
  parallel_for(ids.size(), threads, progress, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      items.placed[i] =
          dual_item(ids[i], corners_of(ids[i])).value_or(DualItem{ids[i], none, {}, {}});
    }
  });
  const auto rest = std::stable_partition(items.placed.begin(), items.placed.end(),
                                          [](const DualItem& item) { return item.face != none; });
  const std::vector<DualItem> homeless(rest, items.placed.end());
  items.placed.erase(rest, items.placed.end());
  for (const DualItem& item : homeless) {
    place_quarters(item.id, corners_of(item.id), most_cuts - 1, items);
  }
  return items;
}

// Triangles of a smooth object, or edges of a polygon object as 3 t + corner.
std::vector<std::vector<int>> ids_of(const Surface& surface) {
  std::vector<std::vector<int>> ids(surface.object_is_smooth.size());
  for (int t = 0; t < static_cast<int>(surface.triangles.size()); ++t) {
    const auto object = idx(surface.object_of(t));
    if (surface.object_is_smooth[object]) {
      ids[object].push_back(t);
      continue;
    }
    for (int k = 0; k < 3; ++k) {
      if (polygon_edge(surface, {t, k})) ids[object].push_back(3 * t + k);
    }
  }
  return ids;
}

template <class DualOf>
std::vector<Vec4> duals_of(std::size_t count, const DualOf& dual, int threads,
                           const Progress& progress) {
  std::vector<Vec4> duals(count);
  parallel_for(count, threads, progress, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) duals[i] = dual(static_cast<int>(i));
  });
  return duals;
}

DualTree tree_of_triangles(const Surface& surface, const std::vector<int>& triangles,
                           const std::vector<Vec4>& duals, int threads, const Progress& progress) {
  const auto corners = [&](int t) {
    Corners result;
    for (int k = 0; k < 3; ++k) {
      result[idx(k)] = surface.corner_sign(t, k) * duals[idx(surface.triangles[idx(t)][idx(k)])];
    }
    return result;
  };
  Items items = items_of(triangles, corners, threads, progress.part(0, 0.5));
  progress.report(0.5);
  return DualTree(items.placed, std::move(items.always), threads);
}

DualTree tree_of_edges(const Surface& surface, const std::vector<int>& edges, const Frame& frame,
                       int threads, const Progress& progress) {
  const auto plane = [&](int t) {
    return frame.dual(face_normal(surface, t),
                      surface.positions[idx(surface.triangles[idx(t)][0])]);
  };
  const auto corners = [&](int edge) {
    const Vec4 here = plane(edge / 3);
    return Corners{here, plane(opposite_side(surface, {edge / 3, edge % 3}).triangle), here};
  };
  Items items = items_of(edges, corners, threads, progress.part(0, 0.5));
  progress.report(0.5);
  return DualTree(items.placed, std::move(items.always), threads);
}

}  // namespace

DualSurface::DualSurface(const Surface& surface, int threads, const Progress& progress) {
  const std::vector<Frame> frames = frames_of(surface);
  const std::vector<Vec4> duals = duals_of(
      surface.positions.size(),
      [&](int v) {
        return frames[idx(surface.objects[idx(v)])].dual(surface.normals[idx(v)],
                                                         surface.positions[idx(v)]);
      },
      threads, progress.part(0, 0.2));
  const std::vector<std::vector<int>> ids = ids_of(surface);
  triangles_ = surface.triangles.size();
  const auto count = static_cast<double>(ids.size());
  for (std::size_t o = 0; o < ids.size(); ++o) {
    if (ids[o].empty()) continue;
    const bool is_smooth = surface.object_is_smooth[o];
    const Progress part = progress.part(0.2 + 0.8 * static_cast<double>(o) / count,
                                        0.2 + 0.8 * static_cast<double>(o + 1) / count);
    parts_.push_back({frames[o].origin, frames[o].unit, is_smooth ? Sort::smooth : Sort::faceted,
                      is_smooth ? tree_of_triangles(surface, ids[o], duals, threads, part)
                                : tree_of_edges(surface, ids[o], frames[o], threads, part)});
  }
}

std::vector<int> DualSurface::find(const Camera& camera, Sort sort) const {
  std::vector<int> found;
  for (const Part& part : parts_) {
    if (part.sort != sort) continue;
    Vec4 viewpoint = camera.viewpoint();
    if (camera.is_perspective()) {
      viewpoint.head<3>() = (viewpoint.head<3>() - part.origin) / part.unit;
    }
    const double farthest = viewpoint.head<3>().norm() + viewpoint[3];
    part.tree.find(viewpoint, tolerance::facing_noise * farthest * (1 + rounding), found);
  }
  sort_unique(found, sort == Sort::smooth ? triangles_ : 3 * triangles_);
  return found;
}

std::vector<int> DualSurface::triangles(const Camera& camera) const {
  return find(camera, Sort::smooth);
}

std::vector<EdgeSide> DualSurface::edges(const Camera& camera) const {
  std::vector<EdgeSide> sides;
  for (const int edge : find(camera, Sort::faceted)) sides.push_back({edge / 3, edge % 3});
  return sides;
}

std::size_t DualSurface::always_count() const {
  std::size_t count = 0;
  for (const Part& part : parts_) count += part.tree.always_count();
  return count;
}

}  // namespace illustrate
