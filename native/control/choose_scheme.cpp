#include "control/choose_scheme.h"

#include <algorithm>

namespace illustrate {

Scheme choose_scheme(const SoundMesh& mesh, Scheme usual) {
  const Scheme scheme = mesh.scheme.value_or(usual);
  if (mesh.face_sizes.empty()) return Scheme::polygons;
  if (scheme != Scheme::automatic) return scheme;
  const auto quads = std::count(mesh.face_sizes.begin(), mesh.face_sizes.end(), 4);
  return 2 * static_cast<std::size_t>(quads) > mesh.face_sizes.size() ? Scheme::catmull_clark
                                                                      : Scheme::loop;
}

}  // namespace illustrate
