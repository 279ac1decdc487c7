#include "field/problem/frames.h"

#include "core/parallel.h"

namespace illustrate {
namespace {

// Any tangent will do, but it has to be well away from the normal.
Vec3 some_tangent(const Vec3& normal) {
  // A unit vector with |x| >= .6 has |y| <= .8.
  const Vec3 axis = std::abs(normal.x()) < 0.6 ? Vec3::UnitX() : Vec3::UnitY();
  return (axis - axis.dot(normal) * normal).normalized();
}

Vec3 unit_or_z(const Vec3& v) {
  const double length = v.norm();
  return std::isfinite(length) && length > 1e-150 ? Vec3(v / length) : Vec3::UnitZ();
}

}  // namespace

TangentFrames tangent_frames(const Points& normals, int threads, const Progress& progress) {
  const std::size_t n = normals.size();
  TangentFrames frames{Points(n), Points(n), Points(n)};
  parallel_for(n, threads, progress, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      frames.normals[i] = unit_or_z(normals[i]);
      frames.x[i] = some_tangent(frames.normals[i]);
      frames.y[i] = frames.normals[i].cross(frames.x[i]);
    }
  });
  return frames;
}

CrossNumber direction_in_frame(const TangentFrames& frames, std::size_t vertex, const Vec3& v,
                               const CrossNumber& otherwise, double least) {
  const CrossNumber projected(v.dot(frames.x[vertex]), v.dot(frames.y[vertex]));
  const double length = std::sqrt(std::norm(projected));
  // Written so that NaN and infinity fail, too.
  if (!(length > least * v.norm()) || !std::isfinite(length)) return otherwise;
  return normalized(projected, otherwise);
}

double angle_about(const Vec3& normal, const Vec3& start, const Vec3& end) {
  const double along = start.dot(end) - start.dot(normal) * end.dot(normal);
  const double angle = std::atan2(normal.dot(start.cross(end)), along);
  return std::isfinite(angle) ? angle : 0;
}

}  // namespace illustrate
