#include "mesh/orient.h"

#include <algorithm>

namespace illustrate {
namespace {

// A connected part.
struct Part {
  std::vector<int> faces;  // in the order of the flood fill
  bool is_closed = true;
  bool is_orientable = true;
};

class FloodFill {
 public:
  // Sets is_flipped for the faces to be reversed.
  FloodFill(const Faces& faces, const FaceAdjacency& adjacency,
            std::vector<std::uint8_t>& is_flipped)
      : faces_(faces),
        adjacency_(adjacency),
        is_reached_(faces.sources.size(), 0),
        is_flipped_(is_flipped) {}

  bool is_reached(int face) const { return is_reached_[face] != 0; }

  Part fill(int start) {
    Part part;
    part.faces.push_back(start);
    is_reached_[start] = 1;
    for (std::size_t i = 0; i < part.faces.size(); ++i) {
      const int face = part.faces[i];
      for (int h = faces_.offsets[face]; h < faces_.offsets[face + 1]; ++h) cross(h, part);
    }
    return part;
  }

 private:
  void cross(int half_edge, Part& part) {
    const int partner = adjacency_.partners[half_edge];
    if (partner == none) {
      part.is_closed = false;
      return;
    }
    const int face = faces_.corner_faces[half_edge], other = faces_.corner_faces[partner];
    const bool disagrees = faces_.corners[half_edge] == faces_.corners[partner];
    const std::uint8_t flip = is_flipped_[face] ^ static_cast<std::uint8_t>(disagrees);
    if (is_reached_[other] == 0) {
      is_reached_[other] = 1;
      is_flipped_[other] = flip;
      part.faces.push_back(other);
    } else if (is_flipped_[other] != flip) {
      part.is_orientable = false;
    }
  }

  const Faces& faces_;
  const FaceAdjacency& adjacency_;
  std::vector<std::uint8_t> is_reached_;
  std::vector<std::uint8_t>& is_flipped_;
};

// The sign of the volume is taken about the part's centre, in units of its size: nothing overflows.
double relative_volume(const Part& part, const Faces& faces, const Points& positions,
                       const std::vector<std::uint8_t>& is_flipped) {
  Eigen::AlignedBox3d box;
  for (const int face : part.faces)
    for (const int vertex : faces[face]) box.extend(positions[vertex]);
  const Vec3 centre = box.min() / 2 + box.max() / 2;
  const double extent = box.sizes().maxCoeff();
  if (!(extent > 0)) return 0;
  double volume = 0;
  for (const int f : part.faces) {
    const auto face = faces[f];
    const auto at = [&](std::size_t k) { return Vec3((positions[face[k]] - centre) / extent); };
    double share = 0;
    for (std::size_t k = 1; k + 1 < face.size(); ++k) share += at(0).dot(at(k).cross(at(k + 1)));
    volume += is_flipped[f] ? -share : share;
  }
  return volume;
}

void turn(const Part& part, std::vector<std::uint8_t>& is_flipped) {
  for (const int face : part.faces) is_flipped[face] ^= 1;
}

void reverse_flipped(Faces& faces, FaceAdjacency& adjacency,
                     const std::vector<std::uint8_t>& is_flipped) {
  std::vector<int> places(faces.corners.size());  // of each half-edge, afterwards
  for (int h = 0; h < faces.corner_count(); ++h) {
    const int face = faces.corner_faces[h];
    places[h] = is_flipped[face] ? faces.reversed(h, faces.offsets[face]) : h;
  }
  const FaceAdjacency before = adjacency;
  for (int h = 0; h < faces.corner_count(); ++h) {
    const int partner = before.partners[h];
    adjacency.partners[places[h]] = partner == none ? none : places[partner];
    adjacency.is_cut[places[h]] = before.is_cut[h];
  }
  for (int f = 0; f < faces.size(); ++f)
    if (is_flipped[f])
      std::reverse(faces.corners.begin() + faces.offsets[f],
                   faces.corners.begin() + faces.offsets[f + 1]);
}

}  // namespace

std::vector<std::uint8_t> orient(Faces& faces, FaceAdjacency& adjacency, const Points& positions,
                                 Counts& report) {
  std::vector<std::uint8_t> is_unorientable(faces.sources.size(), 0);
  std::vector<std::uint8_t> is_flipped(faces.sources.size(), 0);
  FloodFill flood(faces, adjacency, is_flipped);
  for (int f = 0; f < faces.size(); ++f) {
    if (flood.is_reached(f)) continue;
    const Part part = flood.fill(f);
    ++report["parts"];
    if (!part.is_orientable) {
      for (const int face : part.faces) is_unorientable[face] = 1;
      ++report["covered_parts"];
      continue;
    }
    auto flips = std::count_if(part.faces.begin(), part.faces.end(),
                               [&](int face) { return is_flipped[face] != 0; });
    const auto others = static_cast<std::ptrdiff_t>(part.faces.size()) - flips;
    // On a tie the part's first face stays as it is.
    if (flips > others) {
      turn(part, is_flipped);
      flips = others;
    }
    report["flipped_faces"] += flips;
    // Counted apart from flipped faces: in a part that is inside out as a whole none is flipped
    // against the others.
    if (part.is_closed && relative_volume(part, faces, positions, is_flipped) < 0) {
      turn(part, is_flipped);
      ++report["turned_parts"];
    }
  }
  reverse_flipped(faces, adjacency, is_flipped);
  return is_unorientable;
}

std::vector<int> add_double_cover(Faces& faces, FaceAdjacency& adjacency,
                                  const std::vector<std::uint8_t>& is_covered) {
  const int face_count = faces.size(), corner_count = faces.corner_count();
  std::vector<int> twins(faces.sources.size(), none);
  for (int f = 0; f < face_count; ++f) {
    if (is_covered[f] == 0) continue;
    twins[f] = faces.size();
    twins.push_back(f);
    for (int c = faces.offsets[f + 1] - 1; c >= faces.offsets[f]; --c)
      faces.push_corner(faces.corners[c]);
    faces.close_face(faces.sources[f]);
  }
  adjacency.partners.resize(faces.corners.size(), none);
  adjacency.is_cut.resize(faces.corners.size(), 0);

  const auto twin = [&](int h) {
    return faces.reversed(h, faces.offsets[twins[faces.corner_faces[h]]]);
  };
  const std::vector<int> before(adjacency.partners.begin(),
                                adjacency.partners.begin() + corner_count);
  for (int h = 0; h < corner_count; ++h) {
    if (is_covered[faces.corner_faces[h]] == 0) continue;
    adjacency.is_cut[twin(h)] = adjacency.is_cut[h];
    const int partner = before[h];
    if (partner == none) continue;
    const bool disagrees = faces.corners[h] == faces.corners[partner];
    adjacency.partners[h] = disagrees ? twin(partner) : partner;
    adjacency.partners[twin(h)] = disagrees ? partner : twin(partner);
  }
  return twins;
}

}  // namespace illustrate
