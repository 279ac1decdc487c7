#include "hatch/streamlines/even_planes.h"

#include <Eigen/Sparse>
#include <Eigen/SparseCholesky>
#include <cmath>
#include <optional>

#include "hatch/streamlines/neighbours.h"

namespace illustrate {
namespace {

// Neighbours are found anew after each: streamlines that end amid others come to lie elsewhere.
constexpr int rounds = 4;
// In spacings: a streamline moves no further in a round.
constexpr double most_move = 2;
// Where no streamline is nearer, a critical curve within curve_reach is half a spacing away as well
// as it can be. Twice as many of the gaps between streamlines are counted, once from each, and a
// curve is half as far away: it takes four times the weight to be heard alike.
constexpr double curve_weight = 4;
// Of staying: what has no neighbour does not move, and two alone find their spacing.
constexpr double staying_weight = 1e-3;

using Triplets = std::vector<Eigen::Triplet<double>>;

class PlaneEvener {
 public:
  PlaneEvener(const StreamlineSet& set, const HatchView& view) : set_(set), view_(view) {
    for (const Streamline& streamline : set_.streamlines) ways_.push_back(way_of(streamline));
  }

  // Moves of all streamlines, in world units along their ways.
  std::vector<double> moves() {
    const auto count = static_cast<Eigen::Index>(ways_.size());
    right_ = Eigen::VectorXd::Zero(count);
    for (std::size_t s = 0; s < ways_.size(); ++s) add_terms(static_cast<int>(s));
    Eigen::SparseMatrix<double> matrix(count, count);
    matrix.setFromTriplets(terms_.begin(), terms_.end());
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(matrix);
    Eigen::VectorXd moves = solver.solve(right_);
    // A plane seen edge-on has rates that no number holds.
    if (solver.info() != Eigen::Success || !moves.allFinite()) moves.setZero();
    return {moves.data(), moves.data() + count};
  }

  // The nodes of a streamline that moves so far; its own where it cannot.
  std::vector<StreamlineNode> moved(int number, double move) const {
    const Streamline& streamline = set_.streamlines[idx(number)];
    if (!ways_[idx(number)] || move == 0) return streamline.nodes;
    double px = 0;
    for (const StreamlineNode& node : streamline.nodes)
      px = std::max(px, std::abs(move * px_per_move(number, node)));
    const double share = std::min(1., most_move * streamline.spacing / px);
    std::vector<StreamlineNode> nodes;
    bool has_ended = false;
    for (const StreamlineNode& node : streamline.nodes) {
      const std::optional<StreamlineNode> next = moved(node, share * move * *ways_[idx(number)]);
      if (next && has_ended) return streamline.nodes;
      if (next) nodes.push_back(*next);
      has_ended = !next && !nodes.empty();
    }
    return nodes.size() < 2 ? streamline.nodes : nodes;
  }

 private:
  const Surface& surface() const { return view_.walker.on_surface().surface(); }

  // The unit direction in its plane that a streamline may move along, to its left; none where it is
  // on no flat face, or on two.
  std::optional<Vec3> way_of(const Streamline& streamline) const {
    if (streamline.is_fixed) return {};
    const int plane = view_.plane_of(streamline.nodes.front());
    if (plane == none) return {};
    for (const StreamlineNode& node : streamline.nodes) {
      if (view_.plane_of(node) != plane) return {};
    }
    const StreamlineNode& middle = streamline.nodes[streamline.nodes.size() / 2];
    const Vec3 way = surface().planes[idx(plane)].normal.cross(middle.tangent);
    return way.dot(middle.aside) < 0 ? Vec3(-way) : way;
  }

  // How many px to the left of its heading a node goes with a unit of the move.
  double px_per_move(int number, const StreamlineNode& node) const {
    const double world = node.aside.dot(*ways_[idx(number)]);
    return world > 0 ? 1 / world : 0;
  }

  void add_terms(int number) {
    terms_.emplace_back(number, number, 1e-12);
    if (!ways_[idx(number)]) return;
    const Streamline& streamline = set_.streamlines[idx(number)];
    for (int i = 0; i < static_cast<int>(streamline.nodes.size()); ++i) {
      const StreamlineNode& node = streamline.nodes[idx(i)];
      const double rate = px_per_move(number, node);
      if (rate == 0) continue;
      terms_.emplace_back(number, number, staying_weight * rate * rate);
      const auto beside = neighbours(set_, number, i);
      for (const int side : {0, 1}) add_gap(number, node, beside[idx(side)], side, rate);
    }
  }

  // The square of (gap + its change) - what is wanted of it.
  void add_gap(int number, const StreamlineNode& node, const Neighbour& neighbour, int side,
               double rate) {
    const double spacing = set_.streamlines[idx(number)].spacing;
    const double to_left = side == 0 ? 1 : -1;
    const double far = std::min(neighbour.distance, curve_reach * spacing);
    const double curve = curve_beside(view_, node, to_left * node.left(), far);
    if (curve <= far) {
      add_square(number, none, -to_left * rate, 0, curve - spacing / 2, curve_weight);
    } else if (neighbour.streamline != none && neighbour.streamline != number) {
      const std::optional<Vec3>& other = ways_[idx(neighbour.streamline)];
      const double along = other ? other->dot(*ways_[idx(number)]) : 0;
      add_square(number, neighbour.streamline, -to_left * rate, to_left * rate * along,
                 neighbour.distance - spacing, 1);
    }
  }

  // weight (constant + a x_s + b x_t)^2, to the normal equations.
  void add_square(int s, int t, double a, double b, double constant, double weight) {
    terms_.emplace_back(s, s, weight * a * a);
    right_[s] -= weight * a * constant;
    if (t == none || b == 0) return;
    terms_.emplace_back(t, t, weight * b * b);
    terms_.emplace_back(s, t, weight * a * b);
    terms_.emplace_back(t, s, weight * a * b);
    right_[t] -= weight * b * constant;
  }

  std::optional<StreamlineNode> moved(const StreamlineNode& node, const Vec3& by) const {
    SurfacePoint on = node.on;
    if (!view_.walker.on_surface().slide(on, by)) return {};
    const StreamlineNode next = view_.node(on, node.tangent);
    if (view_.plane_of(next) != view_.plane_of(node) ||
        view_.curves.separate(node.image, next.image))
      return {};
    return next;
  }

  const StreamlineSet& set_;
  const HatchView& view_;
  std::vector<std::optional<Vec3>> ways_;  // of the streamlines
  Triplets terms_;
  Eigen::VectorXd right_;
};

}  // namespace

void even_planes(StreamlineSet& set, const HatchView& view) {
  if (view.walker.on_surface().surface().planes.empty()) return;
  for (int round = 0; round < rounds; ++round) {
    if (set.grid.has_additions()) set.rebuild();
    PlaneEvener evener(set, view);
    const std::vector<double> moves = evener.moves();
    std::vector<std::vector<StreamlineNode>> nodes;
    for (std::size_t s = 0; s < moves.size(); ++s)
      nodes.push_back(evener.moved(static_cast<int>(s), moves[s]));
    for (std::size_t s = 0; s < moves.size(); ++s) set.streamlines[s].nodes = std::move(nodes[s]);
    set.rebuild();
  }
}

}  // namespace illustrate
