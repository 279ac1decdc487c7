#include "surface/planes/plane_faces.h"

#include <algorithm>
#include <cmath>

#include "core/parallel.h"
#include "mesh/mesh_size.h"
#include "mesh/polygons.h"
#include "surface/planes/plane_rim.h"
#include "surface/subdivision/base_edges.h"
#include "surface/subdivision/refined_mesh.h"

namespace illustrate {
namespace {

// What lies this near a plane, as a share of the diagonal, lies in it: coordinates of single
// precision or of six digits are no better.
constexpr double near_plane = 2e-6;
// Faces that turn less are in one plane; strips of the finest fillets turn ten times as much.
constexpr double least_turn = 1e-3;
// A plane is fitted anew to what was found by the last one: that of a sliver misses much of it.
constexpr int most_fits = 4;

// At slivers pieces that turn by 30 degrees meet sharply.
constexpr double sharp_cosine = 0.8660254037844387;

// So much of a rim that ends sharply may not: a crease that a mesh has lost at a corner.
constexpr double sharp_share = 0.99;
// A flat face is this many times as thick as most of what it goes on into smoothly...
constexpr double thickness_ratio = 3, thin_share = 0.5;
// A rounding this narrow beside it, up to a crease amid the rounding (mesh/fine_bends.h), is no
// more than the crease.
constexpr double rounding_share = 0.05;
// Edges across a rounding run this much the same way; so many strips are crossed.
constexpr double along_strip = 0.86;
constexpr int most_strips = 32;
// ... and this much of the mesh. A dense scan has no triangle so large.
constexpr double least_area = 1e-3;

// Faces in one plane.
struct Piece {
  Vec3 twice_area;
  int seed;
  double rim = 0;         // length
  double smooth_rim = 0;  // of it

  // The width of a strip, half the side of a square.
  double thickness() const { return rim > 0 ? twice_area.norm() / rim : 0; }
};

class PlaneFinder {
 public:
  PlaneFinder(const SoundMesh& mesh, int threads)
      : base_(mesh), mesh_(polygonal_mesh(mesh, threads)), tolerance_(near_plane * diagonal(mesh)) {
    measure_faces(threads);
    find_lone_faces(threads);
  }

  // (f) pieces. They grow from their largest faces, the largest of all first. Most faces of a scan
  // are pieces of their own, and stand behind the others.
  void divide() {
    pieces_of_.assign(mesh_.face_count(), none);
    std::vector<int> seeds;
    for (int f = 0; f < static_cast<int>(is_lone_.size()); ++f) {
      if (!is_lone_[idx(f)] && !is_hole(f)) seeds.push_back(f);
    }
    std::sort(seeds.begin(), seeds.end(), [&](int a, int b) { return grows_before(a, b); });
    for (const int seed : seeds) {
      if (pieces_of_[idx(seed)] == none) grow(seed);
    }
    for (int f = 0; f < static_cast<int>(is_lone_.size()); ++f) {
      if (pieces_of_[idx(f)] == none && !is_hole(f)) start_piece(f);
    }
  }

  // Whether to go on: a scan without sharp edges, all of whose pieces are small, has no flat face.
  bool may_have_flat_faces() const {
    for (int c = 0; c < static_cast<int>(mesh_.corner_count()); ++c) {
      if (mesh_.is_sharp(c)) return true;
    }
    double whole = 0, largest = 0;
    for (const Piece& piece : pieces_) {
      whole += piece.twice_area.norm();
      largest = std::max(largest, piece.twice_area.norm());
    }
    return largest >= least_area * whole;
  }

  void measure_rims() {
    for_each_rim_edge([&](int corner, int, double length) {
      Piece& piece = pieces_[idx(pieces_of_[idx(mesh_.face(corner))])];
      piece.rim += length;
      if (is_smooth(corner)) piece.smooth_rim += length;
    });
    if (has_creases()) forget_fine_roundings();
  }

  // Numbers the flat faces among the pieces from `first`; (f) the number of each face.
  std::vector<PlaneFace> flat_faces(int object, int first, std::vector<int>& numbers) const {
    std::vector<int> of_piece(pieces_.size(), none);
    std::vector<PlaneFace> planes;
    for (const int p : flat_pieces()) {
      of_piece[idx(p)] = first + static_cast<int>(planes.size());
      PlaneFace plane;
      plane.object = object;
      plane.normal = unit_or_zero(pieces_[idx(p)].twice_area);
      plane.ends_sharply = is_sharp(pieces_[idx(p)]);
      planes.push_back(plane);
    }
    numbers.assign(mesh_.face_count(), none);
    for (std::size_t f = 0; f < numbers.size(); ++f) {
      if (pieces_of_[f] != none) numbers[f] = of_piece[idx(pieces_of_[f])];
    }
    add_rims(first, numbers, planes);
    return planes;
  }

 private:
  bool is_hole(int face) const { return !base_.holes.empty() && base_.holes[idx(face)]; }

  void measure_faces(int threads) {
    twice_areas_.resize(mesh_.face_count());
    normals_.resize(mesh_.face_count());
    sizes_.resize(mesh_.face_count());
    thicknesses_.resize(mesh_.face_count());
    parallel_for(mesh_.face_count(), threads, [&](std::size_t begin, std::size_t end) {
      for (int f = static_cast<int>(begin); f < static_cast<int>(end); ++f) {
        const Vec3 sum = mesh_.twice_area(f);
        const double longest = mesh_.longest_edge(f);
        twice_areas_[idx(f)] = sum;
        normals_[idx(f)] = unit_or_zero(sum);
        sizes_[idx(f)] = std::max(0., sum.norm());  // not a number where coordinates are huge
        thicknesses_[idx(f)] = longest > 0 ? sizes_[idx(f)] / longest : 0;
      }
    });
  }

  // Faces in whose plane no neighbour lies, and that lie in the plane of none.
  void find_lone_faces(int threads) {
    is_lone_.assign(mesh_.face_count(), 1);
    parallel_for(mesh_.face_count(), threads, [&](std::size_t begin, std::size_t end) {
      for (int f = static_cast<int>(begin); f < static_cast<int>(end); ++f) {
        for (int c = mesh_.first(f); c < mesh_.first(f + 1) && is_lone_[idx(f)]; ++c) {
          const int other = mesh_.mate(c) == none ? none : mesh_.face(mesh_.mate(c));
          if (other != none && (extends(f, other) || extends(other, f))) is_lone_[idx(f)] = 0;
        }
      }
    });
  }

  bool extends(int face, int other) const {
    const Vec3& normal = normals_[idx(face)];
    return lies_in_plane(other, normal, height_of(mesh_.point(mesh_.first(face)), normal));
  }

  bool grows_before(int a, int b) const {
    const double of_a = sizes_[idx(a)], of_b = sizes_[idx(b)];
    return of_a != of_b ? of_a > of_b : a < b;
  }

  int start_piece(int seed) {
    const int number = static_cast<int>(pieces_.size());
    pieces_.push_back({twice_areas_[idx(seed)], seed});
    pieces_of_[idx(seed)] = number;
    return number;
  }

  void grow(int seed) {
    const int number = start_piece(seed);
    Piece& piece = pieces_.back();
    members_.assign(1, seed);
    Vec3 normal = normals_[idx(seed)];
    double height = height_of(mesh_.point(mesh_.first(seed)), normal);
    for (int fit = 0; fit < most_fits && !normal.isZero(); ++fit) {
      const std::size_t before = members_.size();
      add_neighbours(normal, height, number, piece);
      if (members_.size() == before) break;
      normal = unit_or_zero(piece.twice_area);
      height = mean_height(normal);
    }
  }

  void add_neighbours(const Vec3& normal, double height, int number, Piece& piece) {
    for (std::size_t i = 0; i < members_.size(); ++i) {
      for (int c = mesh_.first(members_[i]); c < mesh_.first(members_[i] + 1); ++c) {
        const int other = mesh_.mate(c) == none ? none : mesh_.face(mesh_.mate(c));
        if (other == none || is_taken(other, piece.seed) || is_hole(other)) continue;
        if (!lies_in_plane(other, normal, height)) continue;
        pieces_of_[idx(other)] = number;
        piece.twice_area += twice_areas_[idx(other)];
        members_.push_back(other);
      }
    }
  }

  // Of another piece, or a lone face that had its turn before the seed.
  bool is_taken(int face, int seed) const {
    return pieces_of_[idx(face)] != none || (is_lone_[idx(face)] && grows_before(face, seed));
  }

  double height_of(const Vec3& point, const Vec3& normal) const {
    return normal.dot(point - base_.positions[0]);
  }

  double mean_height(const Vec3& normal) const {
    double sum = 0;
    int count = 0;
    for (const int f : members_) {
      for (int c = mesh_.first(f); c < mesh_.first(f + 1); ++c, ++count) {
        sum += height_of(mesh_.point(c), normal);
      }
    }
    return sum / count;
  }

  // The normal of a sliver is rounding, the more the thinner it is.
  bool lies_in_plane(int face, const Vec3& normal, double height) const {
    if (!is_sliver(face)) {
      const double turn = (normals_[idx(face)] - normal).norm();
      if (!(turn <= least_turn || (turn < 1 && thicknesses_[idx(face)] * turn <= tolerance_))) {
        return false;
      }
    }
    for (int c = mesh_.first(face); c < mesh_.first(face + 1); ++c) {
      if (!(std::abs(height_of(mesh_.point(c), normal) - height) <= tolerance_)) return false;
    }
    return true;
  }

  bool is_sliver(int face) const { return !(thicknesses_[idx(face)] > tolerance_); }

  // Whether the surface goes on smoothly from one piece to the next. At a sliver the mesh cannot
  // tell, but the pieces can.
  bool is_smooth(int corner) const {
    const int face = mesh_.face(corner), mate = mesh_.mate(corner);
    if (mesh_.is_sharp(corner) || is_hole(mesh_.face(mate))) return false;
    const int other = mesh_.face(mate);
    if (!is_sliver(face) && !is_sliver(other)) return true;
    const auto normal = [&](int f) {
      return unit_or_zero(pieces_[idx(pieces_of_[idx(f)])].twice_area);
    };
    return !(normal(face).dot(normal(other)) < sharp_cosine);
  }

  // visit(corner, piece beyond or none, length) for each edge that ends a piece.
  template <class Visit>
  void for_each_rim_edge(const Visit& visit) const {
    for (int c = 0; c < static_cast<int>(mesh_.corner_count()); ++c) {
      const int own = pieces_of_[idx(mesh_.face(c))], mate = mesh_.mate(c);
      const int other = mate == none ? none : pieces_of_[idx(mesh_.face(mate))];
      if (own == none || own == other) continue;
      visit(c, other, (mesh_.point(mesh_.next(c)) - mesh_.point(c)).norm());
    }
  }

  bool has_creases() const {
    return std::any_of(pieces_.begin(), pieces_.end(),
                       [](const Piece& piece) { return piece.smooth_rim < piece.rim; });
  }

  // What ends at a crease within a narrow rounding ends sharply.
  void forget_fine_roundings() {
    std::vector<double> forgotten(pieces_.size(), 0);
    for_each_rim_edge([&](int corner, int, double length) {
      const int own = pieces_of_[idx(mesh_.face(corner))];
      const double reach = rounding_share * pieces_[idx(own)].thickness();
      if (mesh_.mate(corner) == none || !is_smooth(corner)) return;
      if (ends_within(corner, reach)) forgotten[idx(own)] += length;
    });
    for (std::size_t p = 0; p < pieces_.size(); ++p) pieces_[p].smooth_rim -= forgotten[p];
  }

  // Whether the strips beyond an edge end at a sharp one.
  bool ends_within(int corner, double reach) const {
    const Vec3 way = unit_or_zero(along(corner)), from = middle(corner);
    int in = mesh_.mate(corner);
    for (int strip = 0; strip < most_strips; ++strip) {
      const int out = way_on(in, way);
      if (out == none || !(way.cross(middle(out) - from).norm() <= reach)) return false;
      if (mesh_.is_sharp(out)) return true;
      in = mesh_.mate(out);
    }
    return false;
  }

  // The other edge of the face that runs the way; none: no other does.
  int way_on(int in, const Vec3& way) const {
    int best = none;
    double most = along_strip;
    for (int c = mesh_.next(in); c != in; c = mesh_.next(c)) {
      const double cosine = std::abs(unit_or_zero(along(c)).dot(way));
      if (!(cosine > most)) continue;
      most = cosine;
      best = c;
    }
    return best;
  }

  Vec3 along(int corner) const { return mesh_.point(mesh_.next(corner)) - mesh_.point(corner); }
  Vec3 middle(int corner) const {
    return (mesh_.point(mesh_.next(corner)) + mesh_.point(corner)) / 2;
  }

  static bool is_sharp(const Piece& piece) {
    return piece.smooth_rim <= (1 - sharp_share) * piece.rim;
  }

  // In the order in which they grew.
  std::vector<int> flat_pieces() const {
    std::vector<double> thin_rim(pieces_.size(), 0);
    for_each_rim_edge([&](int corner, int other, double length) {
      const int own = pieces_of_[idx(mesh_.face(corner))];
      if (!is_smooth(corner) || other == none) return;
      const double thickness = pieces_[idx(other)].thickness();
      if (thickness * thickness_ratio <= pieces_[idx(own)].thickness()) {
        thin_rim[idx(own)] += length;
      }
    });
    double whole = 0;
    for (const Piece& piece : pieces_) whole += piece.twice_area.norm();
    std::vector<int> result;
    for (int p = 0; p < static_cast<int>(pieces_.size()); ++p) {
      const Piece& piece = pieces_[idx(p)];
      const double size = piece.twice_area.norm();
      if (!(size > 0) || !std::isfinite(size)) continue;
      const bool is_large =
          size >= least_area * whole && thin_rim[idx(p)] >= thin_share * piece.smooth_rim;
      if (is_sharp(piece) || is_large) result.push_back(p);
    }
    std::sort(result.begin(), result.end(), [&](int a, int b) {
      return grows_before(pieces_[idx(a)].seed, pieces_[idx(b)].seed);
    });
    return result;
  }

  void add_rims(int first, const std::vector<int>& numbers, std::vector<PlaneFace>& planes) const {
    std::vector<std::vector<RimEdge>> rims(planes.size());
    for_each_rim_edge([&](int corner, int, double) {
      const int number = numbers[idx(mesh_.face(corner))];
      if (number == none) return;
      rims[idx(number - first)].push_back({mesh_.point(corner), mesh_.point(mesh_.next(corner))});
    });
    for (std::size_t p = 0; p < planes.size(); ++p) measure_rim(rims[p], planes[p]);
  }

  const SoundMesh& base_;
  const RefinedMesh mesh_;
  double tolerance_;
  std::vector<Vec3> twice_areas_;  // (f) along the normals
  std::vector<Vec3> normals_;
  std::vector<double> sizes_, thicknesses_;  // (f) twice the area, and that by the longest edge
  std::vector<std::uint8_t> is_lone_;        // (f)
  std::vector<int> pieces_of_;               // (f)
  std::vector<int> members_;                 // faces of the piece that grows
  std::vector<Piece> pieces_;
};

}  // namespace

std::vector<PlaneFace> find_plane_faces(SoundMesh& mesh, int object, int first, int threads) {
  mesh.face_planes.clear();
  if (mesh.face_sizes.empty() || has_double_cover(mesh)) return {};
  PlaneFinder finder(mesh, threads);
  finder.divide();
  if (!finder.may_have_flat_faces()) return {};
  finder.measure_rims();
  return finder.flat_faces(object, first, mesh.face_planes);
}

}  // namespace illustrate
