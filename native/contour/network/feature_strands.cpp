#include "contour/network/feature_strands.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "core/angles.h"
#include "surface/edge_kinds.h"
#include "surface/locate.h"

namespace illustrate {
namespace {

// A straight part of an edge on which nothing changes. It runs so that left_layers >= right_layers.
struct Piece {
  std::array<CurvePoint, 2> points;
  std::array<int, 2> places;  // of the two ends, none at a node
  std::array<int, 2> nodes;   // none at a place
  Strand strand;
  bool from_polygons;

  bool symmetric() const { return strand.left_layers == strand.right_layers; }
};

class PieceMaker {
 public:
  PieceMaker(const Surface& surface, const ContourFunctions& functions, const Camera& camera,
             const std::vector<NetworkNode>& nodes)
      : surface_(surface), functions_(functions), camera_(camera), nodes_(nodes) {}

  // The pieces of an edge between its cuts; those within `flush`, stretches that are apart, are.
  void add(const FeatureEdge& edge, Span<const EdgeCut> cuts, Span<const FlushStretch> flush,
           std::vector<Piece>& pieces) const {
    double from = 0;
    int start_node = none;
    std::size_t next_flush = 0;
    for (std::size_t i = 0; i <= cuts.size(); ++i) {
      const bool last = i == cuts.size();
      const double to = last ? 1 : cuts[i].fraction;
      const int end_node = last ? none : cuts[i].node;
      pieces.push_back(piece(edge, cuts, from, to, start_node, end_node));
      const double middle = (from + to) / 2;
      while (next_flush < flush.size() && flush[next_flush].to <= middle) ++next_flush;
      pieces.back().strand.is_flush = next_flush < flush.size() && flush[next_flush].from < middle;
      from = to;
      start_node = end_node;
    }
  }

 private:
  Piece piece(const FeatureEdge& edge, Span<const EdgeCut> cuts, double from, double to,
              int start_node, int end_node) const {
    const EdgeSide& first = edge.sides[0];
    Piece result;
    result.points = {point(first, from, start_node), point(first, to, end_node)};
    result.places = {start_node == none ? place(first, 0) : none,
                     end_node == none ? place(first, 1) : none};
    result.nodes = {start_node, end_node};
    result.strand.kind = line_kind(edge.kind);
    result.strand.object = surface_.object_of(first.triangle);
    result.from_polygons = is_polygonal(first);
    set_layers(edge, cuts, (from + to) / 2, result.strand);
    if (result.strand.left_layers < result.strand.right_layers) reverse(result);
    return result;
  }

  static void reverse(Piece& piece) {
    std::swap(piece.points[0], piece.points[1]);
    std::swap(piece.places[0], piece.places[1]);
    std::swap(piece.nodes[0], piece.nodes[1]);
    std::swap(piece.strand.left_layers, piece.strand.right_layers);
  }

  // A front-facing triangle lies to the left of its edges as they run, a back-facing one to the
  // right.
  void set_layers(const FeatureEdge& edge, Span<const EdgeCut> cuts, double fraction,
                  Strand& strand) const {
    for (const EdgeSide& side : edge.sides) {
      if (side.triangle == none) continue;
      const bool along = place(side, 0) == place(edge.sides[0], 0);
      const bool front = is_polygonal(side) ? is_front_face(surface_, camera_, side.triangle)
                                            : is_front(side, along, cuts, fraction);
      ++(front == along ? strand.left_layers : strand.right_layers);
    }
  }

  bool is_polygonal(const EdgeSide& side) const { return !surface_.is_smooth_at(side.triangle); }

  // `fraction` runs along the edge's first side, as the cuts do.
  bool is_front(const EdgeSide& side, bool along, Span<const EdgeCut> cuts, double fraction) const {
    const int t = side.triangle, k = side.corner;
    const bool here = functions_.front(t, k), there = functions_.front(t, next_corner(k));
    if (here == there) return here;
    const double zero = functions_.zero_fraction(t, k);
    const bool before_zero = fraction < turn(side, cuts, along ? zero : 1 - zero);
    return before_zero == along ? here : there;
  }

  // Where a side turns: at its own cut, else at the one nearest to where g vanishes, else there.
  static double turn(const EdgeSide& side, Span<const EdgeCut> cuts, double zero) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const EdgeCut& cut : cuts) {
      if (cut.side.triangle == none) continue;
      if (cut.side.triangle == side.triangle && cut.side.corner == side.corner) return cut.fraction;
      if (std::abs(cut.fraction - zero) < std::abs(nearest - zero)) nearest = cut.fraction;
    }
    return std::isfinite(nearest) ? nearest : zero;
  }

  int vertex(const EdgeSide& side, int end) const {
    const int corner = end == 0 ? side.corner : next_corner(side.corner);
    return surface_.triangles[idx(side.triangle)][idx(corner)];
  }
  int place(const EdgeSide& side, int end) const { return surface_.places[idx(vertex(side, end))]; }

  CurvePoint point(const EdgeSide& side, double fraction, int node) const {
    const Vec3& a = surface_.positions[idx(vertex(side, 0))];
    const Vec3& b = surface_.positions[idx(vertex(side, 1))];
    const Vec3 position =
        node == none ? Vec3((1 - fraction) * a + fraction * b) : nodes_[idx(node)].position;
    return {position, on_edge(side.triangle, side.corner, fraction)};
  }

  const Surface& surface_;
  const ContourFunctions& functions_;
  const Camera& camera_;
  const std::vector<NetworkNode>& nodes_;
};

// Where a crease seen as a fold turns by over 100 degrees, as at the tip of a dart, the surface may
// fold too, within a triangle and unnoticed: what is hidden on one side of the tip need not be on
// the other.
const double tip_cosine = std::cos(radians(80));

// Joins pieces that meet two by two at a place and agree, and puts nodes everywhere else.
class Linker {
 public:
  Linker(std::vector<Piece>& pieces, CurveNetwork& network) : pieces_(pieces), network_(network) {}

  void run() {
    meet_at_places();
    used_.resize(pieces_.size(), 0);
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
      if (used_[i]) continue;
      if (pieces_[i].nodes[0] != none)
        follow({static_cast<int>(i), 0});
      else if (pieces_[i].nodes[1] != none && pieces_[i].symmetric())
        follow({static_cast<int>(i), 1});
    }
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
      if (!used_[i]) follow({static_cast<int>(i), 0});
    }
  }

 private:
  // One end of a piece.
  struct End {
    int piece;
    int end;
  };

  void meet_at_places() {
    std::map<int, std::vector<End>> meetings;
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
      for (int e = 0; e < 2; ++e) {
        if (pieces_[i].places[idx(e)] != none) {
          meetings[pieces_[i].places[idx(e)]].push_back({static_cast<int>(i), e});
        }
      }
    }
    next_.resize(pieces_.size(), {End{none, 0}, End{none, 0}});
    for (const auto& [place, ends] : meetings) settle(ends);
  }

  void settle(const std::vector<End>& ends) {
    if (ends.size() == 2 && agree(ends[0], ends[1])) {
      next_[idx(ends[0].piece)][idx(ends[0].end)] = ends[1];
      next_[idx(ends[1].piece)][idx(ends[1].end)] = ends[0];
      return;
    }
    const int node = static_cast<int>(network_.nodes.size());
    const End& any = ends.front();
    network_.nodes.push_back({ends.size() > 1 ? NodeKind::joint : NodeKind::end,
                              pieces_[idx(any.piece)].points[idx(any.end)].position});
    for (const End& e : ends) pieces_[idx(e.piece)].nodes[idx(e.end)] = node;
  }

  bool agree(const End& a, const End& b) const {
    const Piece& p = pieces_[idx(a.piece)];
    const Piece& q = pieces_[idx(b.piece)];
    const bool same = p.strand.kind == q.strand.kind && p.strand.object == q.strand.object &&
                      p.strand.left_layers == q.strand.left_layers &&
                      p.strand.right_layers == q.strand.right_layers &&
                      p.strand.is_flush == q.strand.is_flush;
    const bool in_line = p.symmetric() || a.end != b.end;
    return same && in_line && !p.from_polygons && !q.from_polygons && a.piece != b.piece &&
           (p.symmetric() || !turns_back(a, b));
  }

  bool turns_back(const End& a, const End& b) const {
    const Vec3 one = along(a), other = along(b);
    return one.dot(other) > tip_cosine * one.norm() * other.norm();
  }

  // From an end of a piece to its other end.
  Vec3 along(const End& end) const {
    const auto& points = pieces_[idx(end.piece)].points;
    return points[idx(1 - end.end)].position - points[idx(end.end)].position;
  }

  // Follows from the start at `first` to a node or back to where it began.
  void follow(End first) {
    Strand strand = pieces_[idx(first.piece)].strand;
    strand.start_node = pieces_[idx(first.piece)].nodes[idx(first.end)];
    for (End at = first;;) {
      used_[idx(at.piece)] = 1;
      const Piece& piece = pieces_[idx(at.piece)];
      const int far = 1 - at.end;
      network_.points.push(piece.points[idx(at.end)]);
      if (piece.nodes[idx(far)] != none) {
        network_.points.push(piece.points[idx(far)]);
        strand.end_node = piece.nodes[idx(far)];
        break;
      }
      const End next = next_[idx(at.piece)][idx(far)];
      if (used_[idx(next.piece)]) break;
      at = next;
    }
    network_.points.close_list();
    network_.strands.push_back(strand);
  }

  std::vector<Piece>& pieces_;
  CurveNetwork& network_;
  std::vector<std::array<End, 2>> next_;
  std::vector<std::uint8_t> used_;
};

// The entries of a feature, which begin at `next`; `next` moves past them.
template <class Entry>
Span<const Entry> run_of(int feature, const std::vector<Entry>& entries, std::size_t& next) {
  const std::size_t begin = next;
  while (next < entries.size() && entries[next].feature == feature) ++next;
  return {entries.data() + begin, next - begin};
}

}  // namespace

void add_feature_strands(const Surface& surface, const std::vector<FeatureEdge>& features,
                         const std::vector<FeatureEdge>& polygon_silhouettes,
                         const ContourFunctions& functions, const Camera& camera,
                         const Joints& joints, CurveNetwork& network) {
  const PieceMaker maker(surface, functions, camera, joints.nodes);
  std::vector<Piece> pieces;
  std::size_t next_cut = 0, next_flush = 0;
  for (std::size_t f = 0; f < features.size(); ++f) {
    const int feature = static_cast<int>(f);
    maker.add(features[f], run_of(feature, joints.edges, next_cut),
              run_of(feature, joints.flush, next_flush), pieces);
  }
  for (const FeatureEdge& edge : polygon_silhouettes) maker.add(edge, {}, {}, pieces);
  Linker(pieces, network).run();
}

}  // namespace illustrate
