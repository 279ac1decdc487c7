// Scenes of blocks with sharp edges, and their lines.
#pragma once

#include "pipeline/draw.h"
#include "tests/cpp/shapes.h"

namespace illustrate::blocks {

inline PolygonMesh sharp(PolygonMesh mesh) {
  mesh.cage = false;
  mesh.crease_angle_deg = 30;
  return mesh;
}

inline PolygonMesh block(const Vec3& low, const Vec3& high) {
  PolygonMesh mesh = shapes::cube();
  for (Vec3& p : mesh.positions) {
    p = (low + high) / 2 + (p.array() * (high - low).array() / 2).matrix();
  }
  return sharp(mesh);
}

inline std::shared_ptr<const Prepared> prepared(const std::vector<PolygonMesh>& meshes,
                                                int triangle_budget = 5000) {
  std::vector<MeshPointer> pointers;
  for (const PolygonMesh& mesh : meshes) {
    pointers.push_back(std::make_shared<const PolygonMesh>(mesh));
  }
  PrepareOptions options;
  options.field = false;
  options.surface.triangle_budget = triangle_budget;
  return prepare(pointers, options);
}

// All lines, however short, without hatches.
inline Drawing drawn(const std::vector<PolygonMesh>& meshes, const Camera& camera,
                     int triangle_budget = 5000) {
  DrawOptions options;
  options.hatching = false;
  options.stroke.speck_px = 0;
  return draw(*prepared(meshes, triangle_budget), camera, options, {}).drawing;
}

}  // namespace illustrate::blocks
