// The contour of a limit surface found by brute force: every triangle that a silhouette passes, and
// those around it, cut into 100, with g and II(r, r) evaluated at every vertex of these and linear
// between.
#pragma once

#include <algorithm>
#include <map>
#include <set>

#include "contour/silhouettes.h"
#include "surface/limit/limit_surface.h"

namespace illustrate::dense {

struct Segment {
  Vec2 a, b;  // px
};

struct Contour {
  std::vector<Segment> segments;
  std::vector<Vec2> cusps;
};

struct Sample {
  Vec3 position;
  double g, bend;
};

inline Sample sample(const LimitSurface& limit, const Camera& camera, const BasePlace& place) {
  const LimitPoint p = *limit.evaluate(place);
  const Vec3 n = p.du.cross(p.dv).normalized(), view = camera.to_eye(p.position);
  // II(r, r) of the part of the view in the tangent plane, through its coordinates (x, y).
  Eigen::Matrix2d first;
  first << p.du.dot(p.du), p.du.dot(p.dv), p.du.dot(p.dv), p.dv.dot(p.dv);
  const Vec2 xy = first.inverse() * Vec2(p.du.dot(view), p.dv.dot(view));
  const double bend = xy.x() * xy.x() * p.duu.dot(n) + 2 * xy.x() * xy.y() * p.duv.dot(n) +
                      xy.y() * xy.y() * p.dvv.dot(n);
  return {p.position, n.dot(view), bend};
}

class Finder {
 public:
  Finder(const Surface& surface, const Camera& camera)
      : surface_(surface), limit_(surface), camera_(camera) {}

  Contour run(const std::vector<int>& triangles) {
    std::set<int> wanted(triangles.begin(), triangles.end());
    for (const int t : triangles) {
      for (const int n : surface_.neighbours[idx(t)]) {
        if (n != none) wanted.insert(n);
      }
    }
    for (const int t : wanted) cut(t);
    return std::move(contour_);
  }

 private:
  static constexpr int parts = 10;

  void cut(int triangle) {
    const PatchTriangle& patch = surface_.patches[idx(triangle)];
    const auto at = [&](int i, int j) {
      const Vec2 uv = patch.uv(0) + i * (patch.uv(1) - patch.uv(0)) / parts +
                      j * (patch.uv(2) - patch.uv(0)) / parts;
      return sample(limit_, camera_, {patch.ptex_face, uv});
    };
    for (int i = 0; i < parts; ++i) {
      for (int j = 0; i + j < parts; ++j) {
        march({at(i, j), at(i + 1, j), at(i, j + 1)});
        if (i + j + 2 <= parts) march({at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
      }
    }
  }

  void march(const std::array<Sample, 3>& corners) {
    std::vector<Sample> ends;
    for (std::size_t k = 0; k < 3; ++k) {
      const Sample &a = corners[k], &b = corners[(k + 1) % 3];
      if ((a.g >= 0) == (b.g >= 0)) continue;
      const double f = a.g / (a.g - b.g);
      ends.push_back(
          {a.position + f * (b.position - a.position), 0, a.bend + f * (b.bend - a.bend)});
    }
    if (ends.size() != 2) return;
    const Vec2 a = camera_.project(ends[0].position).xy, b = camera_.project(ends[1].position).xy;
    contour_.segments.push_back({a, b});
    if ((ends[0].bend >= 0) == (ends[1].bend >= 0)) return;
    contour_.cusps.push_back(a + ends[0].bend / (ends[0].bend - ends[1].bend) * (b - a));
  }

  const Surface& surface_;
  LimitSurface limit_;
  const Camera& camera_;
  Contour contour_;
};

inline Contour contour(const Surface& surface, const Camera& camera,
                       const std::vector<int>& silhouette_triangles) {
  return Finder(surface, camera).run(silhouette_triangles);
}

inline double distance(const Vec2& p, const Segment& s) {
  const Vec2 along = s.b - s.a;
  const double square = along.squaredNorm();
  const double t = square > 0 ? std::clamp((p - s.a).dot(along) / square, 0., 1.) : 0;
  return (p - s.a - t * along).norm();
}

// Distances to many segments, those within 8 px of a point found through a grid.
class Nearest {
 public:
  explicit Nearest(const std::vector<Segment>& segments) : segments_(segments) {
    for (std::size_t i = 0; i < segments.size(); ++i) {
      for (const Vec2& end : {segments[i].a, segments[i].b}) cells_[cell(end)].push_back(i);
    }
  }

  double operator()(const Vec2& p) const {
    double nearest = 1e3;
    const auto [x, y] = cell(p);
    for (int i = x - 1; i <= x + 1; ++i) {
      for (int j = y - 1; j <= y + 1; ++j) {
        const auto found = cells_.find({i, j});
        if (found == cells_.end()) continue;
        for (const std::size_t s : found->second) {
          nearest = std::min(nearest, distance(p, segments_[s]));
        }
      }
    }
    return nearest;
  }

 private:
  static std::pair<int, int> cell(const Vec2& p) {
    return {static_cast<int>(std::floor(p.x() / 8)), static_cast<int>(std::floor(p.y() / 8))};
  }
  const std::vector<Segment>& segments_;
  std::map<std::pair<int, int>, std::vector<std::size_t>> cells_;
};

}  // namespace illustrate::dense
