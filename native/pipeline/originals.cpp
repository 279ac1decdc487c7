#include "pipeline/originals.h"

#include <algorithm>
#include <unordered_map>

namespace illustrate {

OriginalMeshes find_originals(const std::vector<MeshPointer>& meshes) {
  OriginalMeshes found;
  std::unordered_map<const PolygonMesh*, int> numbers;
  for (const MeshPointer& mesh : meshes) {
    const PolygonMesh* original = mesh->original ? mesh->original.get() : mesh.get();
    const auto next = static_cast<int>(found.meshes.size());
    const auto [it, is_new] = numbers.try_emplace(original, next);
    if (is_new) found.meshes.push_back(original);
    found.instances.originals.push_back(it->second);
    found.instances.placements.push_back(mesh->placement);
    if (!is_new || mesh->original) found.instances.are_trivial = false;
  }
  return found;
}

void set_placements(const std::vector<MeshPointer>& meshes, const Instances& instances,
                    std::vector<SoundMesh>& originals) {
  if (instances.are_trivial) return;
  std::vector<std::optional<double>> finest(originals.size());  // in units of the original
  std::vector<double> largest(originals.size(), 0);
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    const std::size_t original = idx(instances.originals[i]);
    const Similarity& placement = instances.placements[i];
    originals[original].placements.push_back(placement);
    largest[original] = std::max(largest[original], placement.scale);
    if (!meshes[i]->edge_length) continue;
    const double length = *meshes[i]->edge_length / placement.scale;
    finest[original] = std::min(length, finest[original].value_or(length));
  }
  for (std::size_t o = 0; o < originals.size(); ++o) {
    originals[o].edge_length = finest[o];
    if (finest[o]) *originals[o].edge_length *= largest[o];
  }
}

}  // namespace illustrate
