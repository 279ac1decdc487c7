#include "surface/planes/flat_faces.h"

#include <algorithm>

#include "core/parallel.h"
#include "core/tolerances.h"
#include "mesh/polygons.h"
#include "surface/planes/mean_value.h"
#include "surface/planes/untangle.h"
#include "surface/shading.h"

namespace illustrate {
namespace {

// Coordinates in a plane, seen from where its normal points to.
class Plane {
 public:
  // ahead: somewhere else in the plane, so that coordinates turn with the plane.
  Plane(const Vec3& normal, const Vec3& origin, const Vec3& ahead)
      : origin_(origin), up_(unit_or_zero(normal.cross(ahead - origin))) {
    if (up_.isZero()) up_ = normal.unitOrthogonal();
    right_ = up_.cross(normal);
  }

  Vec2 flat(const Vec3& p) const { return {right_.dot(p - origin_), up_.dot(p - origin_)}; }
  Vec3 along(const Vec2& move) const { return move.x() * right_ + move.y() * up_; }

 private:
  Vec3 origin_, up_, right_;
};

// Connected by smooth edges, all in one plane.
struct FlatPart {
  std::vector<int> faces;
  Vec3 normal;
};

// The faces that smooth edges connect with this one, which are marked as found.
std::vector<int> smooth_part(const RefinedMesh& mesh, int face, std::vector<std::uint8_t>& found) {
  std::vector<int> faces{face};
  found[idx(face)] = 1;
  for (std::size_t i = 0; i < faces.size(); ++i) {
    for (int c = mesh.first(faces[i]); c < mesh.first(faces[i] + 1); ++c) {
      if (mesh.is_sharp(c)) continue;
      const int other = mesh.face(mesh.mate(c));
      if (found[idx(other)]) continue;
      found[idx(other)] = 1;
      faces.push_back(other);
    }
  }
  return faces;
}

// Unit; zero where the faces are not flat.
Vec3 plane_normal(const RefinedMesh& mesh, const std::vector<int>& faces) {
  Vec3 sum = Vec3::Zero();
  for (const int f : faces) sum += mesh.twice_area(f);
  const Vec3 normal = unit_or_zero(sum);
  Eigen::AlignedBox3d box;
  Eigen::AlignedBox1d heights;
  const Vec3& origin = mesh.point(mesh.first(faces[0]));
  for (const int f : faces) {
    for (int c = mesh.first(f); c < mesh.first(f + 1); ++c) {
      box.extend(mesh.point(c));
      heights.extend(Eigen::Matrix<double, 1, 1>(normal.dot(mesh.point(c) - origin)));
    }
    if (heights.sizes()[0] > tolerance::flat_rad * box.sizes().stableNorm()) return Vec3::Zero();
  }
  return normal;
}

std::vector<FlatPart> flat_parts(const RefinedMesh& mesh) {
  std::vector<FlatPart> parts;
  std::vector<std::uint8_t> found(mesh.face_count(), 0);
  for (int f = 0; f < static_cast<int>(mesh.face_count()); ++f) {
    if (found[idx(f)]) continue;
    FlatPart part{smooth_part(mesh, f, found), {}};
    part.normal = plane_normal(mesh, part.faces);
    if (!part.normal.isZero()) parts.push_back(std::move(part));
  }
  return parts;
}

using PlacedSectors = std::vector<std::pair<int, Vec2>>;

// One ptex face: its sectors on a grid of `steps` by `steps` cells, for a triangle half of it.
// Sides run from corner k to k + 1.
class Patch {
 public:
  // corners: where they are on the control mesh.
  Patch(const RefinedMesh& mesh, const std::vector<int>& corner_sectors, Span<const int> faces,
        const std::array<Vec3, 4>& corners)
      : sides_(mesh.corners_per_face),
        cell_(std::abs(mesh.domains[idx(faces[0])].size)),
        steps_(FaceDomain::steps / cell_),
        sectors_(idx((steps_ + 1) * (steps_ + 1)), none),
        corners_(corners) {
    for (const int f : faces) {
      for (int c = mesh.first(f); c < mesh.first(f + 1); ++c) {
        const std::array<int, 2> at = place(mesh, c);
        sectors_[number(at)] = corner_sectors[idx(c)];
        for (int k = 0; mesh.is_sharp(c) && k < sides_; ++k) {
          if (lies_on(k, at) && lies_on(k, place(mesh, mesh.next(c)))) is_border_[idx(k)] = true;
        }
      }
    }
  }

  // The border along the patch, and how far the limit lies from the control mesh there.
  void add_border(const Points& limit, const Plane& plane, std::vector<BorderPiece>& border) const {
    for (int k = 0; k < sides_; ++k) {
      for (int step = 0; is_border_[idx(k)] && step < steps_; ++step) {
        const std::array<int, 2> from = on_side(k, step), to = on_side(k, step + 1);
        const Vec2 start = plane.flat(on_control(from)), end = plane.flat(on_control(to));
        border.push_back({start, end, plane.flat(on_limit(limit, from)) - start,
                          plane.flat(on_limit(limit, to)) - end});
      }
    }
  }

  // Sectors off the border, and where they are: on the control mesh, moved on as the border is.
  PlacedSectors inside(const Plane& plane, const std::vector<BorderPiece>& border) const {
    PlacedSectors result;
    for (int j = 0; j <= steps_; ++j) {
      for (int i = 0; i <= (sides_ == 3 ? steps_ - j : steps_); ++i) {
        const int sector = sectors_[number({i, j})];
        if (sector == none || is_on_border({i, j})) continue;
        const Vec2 at = plane.flat(on_control({i, j}));
        result.emplace_back(sector, at + mean_value(border, at));
      }
    }
    return result;
  }

 private:
  std::array<int, 2> place(const RefinedMesh& mesh, int corner) const {
    const int f = mesh.face(corner);
    const auto at =
        place_on_domain(mesh.domains[idx(f)], mesh.face_size(f), corner - mesh.first(f));
    return {at[0] / cell_, at[1] / cell_};
  }

  std::size_t number(const std::array<int, 2>& at) const {
    return idx(at[1] * (steps_ + 1) + at[0]);
  }

  // The place `step` steps along a side.
  std::array<int, 2> on_side(int side, int step) const {
    const int rest = steps_ - step;
    if (side == 0) return {step, 0};
    if (side == 1) return {sides_ == 3 ? rest : steps_, step};
    return side == 2 && sides_ == 4 ? std::array<int, 2>{rest, steps_}
                                    : std::array<int, 2>{0, rest};
  }

  bool lies_on(int side, const std::array<int, 2>& at) const {
    if (side == 0) return at[1] == 0;
    if (side == 1) return at[0] + (sides_ == 3 ? at[1] : 0) == steps_;
    return side == 2 && sides_ == 4 ? at[1] == steps_ : at[0] == 0;
  }

  bool is_on_border(const std::array<int, 2>& at) const {
    for (int k = 0; k < sides_; ++k) {
      if (is_border_[idx(k)] && lies_on(k, at)) return true;
    }
    return false;
  }

  Vec3 on_control(const std::array<int, 2>& at) const {
    const double u = static_cast<double>(at[0]) / steps_, v = static_cast<double>(at[1]) / steps_;
    const auto& c = corners_;
    if (sides_ == 3) return (1 - u - v) * c[0] + u * c[1] + v * c[2];
    return (1 - v) * ((1 - u) * c[0] + u * c[1]) + v * (u * c[2] + (1 - u) * c[3]);
  }

  const Vec3& on_limit(const Points& limit, const std::array<int, 2>& at) const {
    return limit[idx(sectors_[number(at)])];
  }

  int sides_, cell_, steps_;
  std::vector<int> sectors_;  // none: no point of the grid
  std::array<Vec3, 4> corners_;
  std::array<bool, 4> is_border_{};  // sides
};

// The limit of a flat part as a mesh of its plane. Its points are sectors.
struct PlaneMesh {
  std::vector<int> sectors;         // ascending
  std::vector<Vec2> points;         // of the sectors
  std::vector<std::uint8_t> fixed;  // 1: on the part's border
  // Of points; of quads those at their corners, of dented ones the two that they are split into.
  std::vector<Triangle> triangles;

  int point(int sector) const {
    return static_cast<int>(std::lower_bound(sectors.begin(), sectors.end(), sector) -
                            sectors.begin());
  }
};

class Unfolder {
 public:
  Unfolder(const RefinedMesh& control, const RefinedMesh& mesh,
           const std::vector<int>& corner_sectors, int threads, SectorLimits& limits)
      : control_(control),
        mesh_(mesh),
        corner_sectors_(corner_sectors),
        threads_(threads),
        limits_(limits) {}

  // faces: of the refined mesh. Whether they were folded.
  bool unfold(const std::vector<int>& faces, const Vec3& normal) {
    if (!is_folded(faces, normal)) return false;
    if (is_shared_.empty()) find_shared_places();
    const int c = mesh_.first(faces[0]);
    const Plane plane(normal, position(c), position(mesh_.next(c)));
    const PlaneMesh limit = plane_mesh(faces, plane);
    PlaneMesh flat = limit;
    const std::size_t folds = count_clockwise(limit.triangles, limit.points);
    spread(faces, plane, flat);
    if (untangle(flat.triangles, flat.fixed, flat.points) > folds) flat = limit;
    for (std::size_t i = 0; i < flat.sectors.size(); ++i) {
      const std::size_t s = idx(flat.sectors[i]);
      limits_.normals[s] = normal;
      limits_.curvature[s] = {0, 0, plane.along({1, 0}), plane.along({0, 1})};
      limits_.needs_jet[s] = 0;
      if (flat.points[i] == limit.points[i]) continue;
      limits_.positions[s] += plane.along(flat.points[i] - limit.points[i]);
    }
    return true;
  }

 private:
  int sector(int corner) const { return corner_sectors_[idx(corner)]; }
  const Vec3& position(int corner) const { return limits_.positions[idx(sector(corner))]; }

  // Whether a face or a normal is turned round.
  bool is_folded(const std::vector<int>& faces, const Vec3& normal) const {
    for (const int f : faces) {
      for (int c = mesh_.first(f); c < mesh_.first(f + 1); ++c) {
        const Vec3& at = position(c);
        const Vec3 next = position(mesh_.next(c)) - at, previous = position(mesh_.previous(c)) - at;
        const double longest = std::max(next.squaredNorm(), previous.squaredNorm());
        const double area = next.cross(previous).dot(normal) / 2;
        if (area < -tolerance::degenerate_area * longest) return true;
        if (limits_.normals[idx(sector(c))].dot(normal) < 0) return true;
      }
    }
    return false;
  }

  // Those of several sectors, which are not to part.
  void find_shared_places() {
    std::vector<int> first(mesh_.points.size(), none);
    is_shared_.assign(first.size(), 0);
    for (int c = 0; c < static_cast<int>(mesh_.corner_count()); ++c) {
      const std::size_t place = idx(place_of(mesh_, mesh_.vertex(c)));
      if (place >= first.size()) first.resize(place + 1, none);
      if (place >= is_shared_.size()) is_shared_.resize(place + 1, 0);
      if (first[place] == none) first[place] = sector(c);
      is_shared_[place] |= first[place] != sector(c);
    }
  }

  PlaneMesh plane_mesh(const std::vector<int>& faces, const Plane& plane) const {
    PlaneMesh flat;
    for (const int f : faces) {
      for (int c = mesh_.first(f); c < mesh_.first(f + 1); ++c) flat.sectors.push_back(sector(c));
    }
    std::sort(flat.sectors.begin(), flat.sectors.end());
    flat.sectors.erase(std::unique(flat.sectors.begin(), flat.sectors.end()), flat.sectors.end());
    for (const int s : flat.sectors) flat.points.push_back(plane.flat(limits_.positions[idx(s)]));
    flat.fixed.assign(flat.sectors.size(), 0);
    for (const int f : faces) add_face(f, flat);
    return flat;
  }

  void add_face(int face, PlaneMesh& flat) const {
    const auto point = [&](int c) { return flat.point(sector(c)); };
    const int first = mesh_.first(face), size = mesh_.face_size(face);
    const int dent = size == 4 ? dented_corner(face, flat) : none;
    for (int c = first; c < first + size; ++c) {
      const int at = point(c), next = point(mesh_.next(c));
      if (mesh_.is_sharp(c)) flat.fixed[idx(at)] = flat.fixed[idx(next)] = 1;
      if (is_shared_[idx(place_of(mesh_, mesh_.vertex(c)))]) flat.fixed[idx(at)] = 1;
      const bool is_split = dent != none && (c - dent) % 2 == 0;
      if (is_split || (size == 3 && c != first)) continue;
      flat.triangles.push_back({at, next, point(mesh_.previous(c))});
    }
  }

  // Where the border turns by more than 180 degrees within one quad no move makes the triangle of
  // that corner right; those at its neighbours are the halves of the quad, split there.
  int dented_corner(int face, const PlaneMesh& flat) const {
    for (int c = mesh_.first(face); c < mesh_.first(face + 1); ++c) {
      const auto at = [&](int corner) { return flat.points[idx(flat.point(sector(corner)))]; };
      const int previous = mesh_.previous(c);
      if (!mesh_.is_sharp(c) || !mesh_.is_sharp(previous)) continue;
      if (cross(at(mesh_.next(c)) - at(c), at(previous) - at(c)) < 0) return c;
    }
    return none;
  }

  // Points to where the control mesh has them, moved on as the border is.
  void spread(const std::vector<int>& faces, const Plane& plane, PlaneMesh& flat) const {
    const std::vector<Patch> patches = patches_of(faces);
    std::vector<BorderPiece> border;
    for (const Patch& patch : patches) patch.add_border(limits_.positions, plane, border);
    std::vector<PlacedSectors> placed(patches.size());
    parallel_for(patches.size(), threads_, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) placed[i] = patches[i].inside(plane, border);
    });
    for (const PlacedSectors& of_patch : placed) {  // what patches share is the last one's
      for (const auto& [sector, at] : of_patch) {
        const std::size_t point = idx(flat.point(sector));
        if (!flat.fixed[point]) flat.points[point] = at;
      }
    }
  }

  std::vector<Patch> patches_of(std::vector<int> faces) const {
    const auto ptex = [&](int f) { return mesh_.domains[idx(f)].ptex_face; };
    std::stable_sort(faces.begin(), faces.end(), [&](int a, int b) { return ptex(a) < ptex(b); });
    std::vector<Patch> patches;
    for (std::size_t begin = 0, end = 0; begin < faces.size(); begin = end) {
      while (end < faces.size() && ptex(faces[end]) == ptex(faces[begin])) ++end;
      const Span<const int> patch{faces.data() + begin, end - begin};
      patches.emplace_back(mesh_, corner_sectors_, patch, corners_of_patch(faces[begin]));
    }
    return patches;
  }

  // Of the patch on which a face lies, on the control mesh. A face that is no patch itself has one
  // for each of its corners, round its middle.
  std::array<Vec3, 4> corners_of_patch(int face) const {
    const int base = mesh_.base_faces[idx(face)], first = control_.first(base);
    const int size = control_.face_size(base);
    std::array<Vec3, 4> corners{};
    if (size == mesh_.corners_per_face) {
      for (int k = 0; k < size; ++k) corners[idx(k)] = control_.point(first + k);
      return corners;
    }
    const int c =
        first + mesh_.domains[idx(face)].ptex_face - control_.domains[idx(base)].ptex_face;
    Vec3 middle = Vec3::Zero();
    for (int k = 0; k < size; ++k) middle += control_.point(first + k) / size;
    const Vec3& at = control_.point(c);
    return {at, (at + control_.point(control_.next(c))) / 2, middle,
            (at + control_.point(control_.previous(c))) / 2};
  }

  const RefinedMesh& control_;
  const RefinedMesh& mesh_;
  const std::vector<int>& corner_sectors_;
  int threads_;
  SectorLimits& limits_;
  std::vector<std::uint8_t> is_shared_;  // places; empty until they are asked for
};

}  // namespace

std::vector<std::uint8_t> unfold_flat_faces(const RefinedMesh& control, const RefinedMesh& mesh,
                                            const std::vector<int>& corner_sectors, int threads,
                                            SectorLimits& limits) {
  if (mesh.domains.empty() || mesh.corners_per_face == 0 || !mesh.twin_faces.empty()) return {};
  const std::vector<FlatPart> parts = flat_parts(control);
  if (parts.empty()) return {};
  std::vector<int> part_of(control.face_count(), none);
  for (std::size_t p = 0; p < parts.size(); ++p) {
    for (const int f : parts[p].faces) part_of[idx(f)] = static_cast<int>(p);
  }
  std::vector<std::vector<int>> refined(parts.size());
  for (int f = 0; f < static_cast<int>(mesh.face_count()); ++f) {
    const int part = part_of[idx(mesh.base_faces[idx(f)])];
    if (part != none) refined[idx(part)].push_back(f);
  }
  Unfolder unfolder(control, mesh, corner_sectors, threads, limits);
  std::vector<std::uint8_t> changed;
  for (std::size_t p = 0; p < parts.size(); ++p) {
    if (!unfolder.unfold(refined[p], parts[p].normal)) continue;
    changed.resize(control.face_count(), 0);
    for (const int f : parts[p].faces) changed[idx(f)] = 1;
  }
  return changed;
}

}  // namespace illustrate
