#include "surface/shading.h"

#include <algorithm>
#include <cmath>

#include "core/parallel.h"
#include "core/pi.h"
#include "core/tolerances.h"
#include "mesh/polygons.h"

namespace illustrate {
namespace {

// 60 degrees: sheets that meet more steeply make an edge that one expects to see.
constexpr double seam_smooth_cos = .5;

// Angle-weighted normal of one corner of a polygon. A corner that does not turn the way its polygon
// does is dented, and its angle is larger than 180 degrees.
Vec3 corner_normal(const RefinedMesh& mesh, const std::vector<Vec3>& face_normals, int corner) {
  const Vec3& normal = face_normals[idx(mesh.face(corner))];
  const Vec3 a = unit_or_zero(mesh.point(mesh.next(corner)) - mesh.point(corner));
  const Vec3 b = unit_or_zero(mesh.point(mesh.previous(corner)) - mesh.point(corner));
  const Vec3 across = a.cross(b);
  const double angle = std::atan2(across.norm(), a.dot(b));
  return (across.dot(normal) < 0 ? 2 * pi - angle : angle) * normal;
}

Points face_normals(const RefinedMesh& mesh, int threads) {
  Points normals(mesh.face_count());
  parallel_for(normals.size(), threads, [&](std::size_t begin, std::size_t end) {
    Points polygon;
    for (std::size_t f = begin; f < end; ++f) {
      polygon.clear();
      const int face = static_cast<int>(f);
      for (int c = mesh.first(face); c < mesh.first(face + 1); ++c)
        polygon.push_back(mesh.point(c));
      normals[f] = unit_or_zero(newell_normal({polygon.data(), polygon.size()}));
    }
  });
  return normals;
}

template <class Visit>
void for_each_corner(const RefinedMesh& mesh, const Sectors& sectors, std::size_t sector,
                     const Visit& visit) {
  int c = sectors.first_corners[sector];
  for (int i = 0; i < sectors.sizes[sector]; ++i) {
    visit(c);
    if (i + 1 < sectors.sizes[sector]) c = next_round_vertex(mesh, c);
  }
}

// From the limit positions of the vertices around, edges no longer than `least` having no
// direction; of faces that cancel out, that of the first. Zero where none has an area.
Vec3 normal_around(const RefinedMesh& mesh, const Sectors& sectors, const Points& positions,
                   double least, std::size_t sector) {
  const auto position = [&](int corner) {
    return positions[idx(sectors.corner_sectors[idx(corner)])];
  };
  Vec3 sum = Vec3::Zero(), first = Vec3::Zero();
  for_each_corner(mesh, sectors, sector, [&](int c) {
    const Vec3 p = position(c);
    const Vec3 normal =
        spanned_normal(position(mesh.next(c)) - p, position(mesh.previous(c)) - p, 0, least);
    if (first.isZero()) first = normal;
    sum += normal;
  });
  const Vec3 mean = unit_of_sum(sum);
  return mean.isZero() ? first : mean;
}

// Of those at the other ends of its edges that have one.
Vec3 mean_beside(const RefinedMesh& mesh, const Sectors& sectors, const Points& normals,
                 std::size_t sector) {
  Vec3 sum = Vec3::Zero();
  for_each_corner(mesh, sectors, sector, [&](int c) {
    for (const int other : {mesh.next(c), mesh.previous(c)})
      sum += normals[idx(sectors.corner_sectors[idx(other)])];
  });
  return unit_of_sum(sum);
}

// Normals that are zero spread from where there are some, ring by ring. Nothing better than an axis
// is left where a whole part has none.
void spread_normals(const RefinedMesh& mesh, const Sectors& sectors, Points& normals) {
  std::vector<std::size_t> open;
  for (std::size_t s = 0; s < normals.size(); ++s) {
    if (normals[s].isZero()) open.push_back(s);
  }
  for (std::size_t before = open.size() + 1; open.size() < before;) {
    before = open.size();
    Points found;
    for (const std::size_t s : open) found.push_back(mean_beside(mesh, sectors, normals, s));
    std::vector<std::size_t> left;
    for (std::size_t i = 0; i < open.size(); ++i) {
      normals[open[i]] = found[i];
      if (found[i].isZero()) left.push_back(open[i]);
    }
    open = std::move(left);
  }
  for (const std::size_t s : open) normals[s] = Vec3::UnitZ();
}

// Sectors at seams, ordered by place.
std::vector<std::array<int, 2>> sectors_at_seams(const RefinedMesh& mesh, const Sectors& sectors) {
  const std::vector<EdgeKind>& kinds = mesh.corner_kinds;
  if (std::find(kinds.begin(), kinds.end(), EdgeKind::seam) == kinds.end()) return {};
  int places = static_cast<int>(mesh.points.size());
  for (const int place : mesh.places) places = std::max(places, place + 1);
  std::vector<std::uint8_t> at_seam(idx(places), 0);
  for (int c = 0; c < static_cast<int>(mesh.mates.size()); ++c) {
    if (mesh.kind(c) != EdgeKind::seam) continue;
    at_seam[idx(place_of(mesh, mesh.vertex(c)))] = 1;
    at_seam[idx(place_of(mesh, mesh.vertex(mesh.next(c))))] = 1;
  }
  std::vector<std::array<int, 2>> found;
  for (std::size_t s = 0; s < sectors.count(); ++s) {
    const int place = place_of(mesh, mesh.vertex(sectors.first_corners[s]));
    if (at_seam[idx(place)]) found.push_back({place, static_cast<int>(s)});
  }
  std::sort(found.begin(), found.end());
  return found;
}

// Each normal becomes the mean of those that turn little from it; where very many meet, which would
// take the square of their number, the mean of all if it turns little.
void join_normals(const std::vector<std::array<int, 2>>& group, Points& normals) {
  constexpr std::size_t many = 64;
  Points before, all(1, Vec3::Zero());
  for (const auto& g : group) {
    before.push_back(normals[idx(g[1])]);
    all[0] += before.back();
  }
  all[0] = unit_or_zero(all[0]);
  const Points& others = group.size() > many ? all : before;
  for (std::size_t i = 0; i < group.size(); ++i) {
    Vec3 sum = Vec3::Zero();
    for (const Vec3& other : others) {
      if (before[i].dot(other) > seam_smooth_cos) sum += other;
    }
    if (!sum.isZero()) normals[idx(group[i][1])] = sum.normalized();
  }
}

}  // namespace

void polygon_normals(const RefinedMesh& mesh, const Sectors& sectors, int threads,
                     Points& normals) {
  const Points of_faces = face_normals(mesh, threads);
  normals.resize(sectors.count());
  parallel_for(normals.size(), threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t s = begin; s < end; ++s) {
      Vec3 sum = Vec3::Zero();
      for_each_corner(mesh, sectors, s, [&](int c) { sum += corner_normal(mesh, of_faces, c); });
      normals[s] = unit_of_sum(sum);
    }
  });
}

void mend_normals(const RefinedMesh& mesh, const Sectors& sectors, int threads,
                  SectorLimits& limits) {
  const double least = tolerance::same_place * mean_edge(mesh);
  parallel_for(sectors.count(), threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t s = begin; s < end; ++s) {
      if (!limits.normals[s].isZero()) continue;
      limits.normals[s] = normal_around(mesh, sectors, limits.positions, least, s);
    }
  });
  spread_normals(mesh, sectors, limits.normals);
  const std::vector<std::array<int, 2>> seams = sectors_at_seams(mesh, sectors);
  for (std::size_t from = 0, to = 0; from < seams.size(); from = to) {
    while (to < seams.size() && seams[to][0] == seams[from][0]) ++to;
    join_normals({seams.begin() + static_cast<std::ptrdiff_t>(from),
                  seams.begin() + static_cast<std::ptrdiff_t>(to)},
                 limits.normals);
  }
}

double mean_edge(const RefinedMesh& mesh) {
  double sum = 0;
  const int corners = static_cast<int>(mesh.mates.size());
  for (int c = 0; c < corners; ++c)
    sum += (mesh.point(mesh.next(c)) - mesh.point(c)).stableNorm() / corners;
  return sum;
}

int place_of(const RefinedMesh& mesh, int vertex) {
  return mesh.places.empty() ? vertex : mesh.places[idx(vertex)];
}

void share_positions(const RefinedMesh& mesh, const Sectors& sectors, Points& positions) {
  const std::vector<std::uint8_t>& closed = sectors.closed;
  const bool all_closed = std::find(closed.begin(), closed.end(), 0) == closed.end();
  if (all_closed && mesh.places.empty()) return;  // a place has one sector
  std::vector<int> chosen(mesh.points.size(), none);
  // The sheets of a double cover lie on each other.
  const auto place = [&](std::size_t s) {
    const int vertex = mesh.vertex(sectors.first_corners[s]), own = place_of(mesh, vertex);
    const int twin = mesh.twin_vertices.empty() ? none : mesh.twin_vertices[idx(vertex)];
    return idx(twin == none ? own : std::min(own, place_of(mesh, twin)));
  };
  for (std::size_t s = 0; s < sectors.count(); ++s) {
    int& sector = chosen[place(s)];
    const bool better = sector == none || (sectors.closed[s] && !sectors.closed[idx(sector)]);
    if (better) sector = static_cast<int>(s);
  }
  for (std::size_t s = 0; s < sectors.count(); ++s) {
    positions[s] = positions[idx(chosen[place(s)])];
  }
}

}  // namespace illustrate
