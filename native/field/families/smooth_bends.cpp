#include "field/families/smooth_bends.h"

#include <algorithm>
#include <cmath>

namespace illustrate {
namespace {

// Of the heat flow, in diagonals of a piece.
constexpr double radius = 0.02;

// Sharper bends than this, over the diagonal, are no sharper form.
constexpr double most_bend = 100;

// Of the equations' solution: the bends are compared, no more.
constexpr double tolerance = 0.05;
constexpr int most_iterations = 60;

// A symmetric tensor: xx, yy, zz, xy, yz, zx.
using Tensor = Eigen::Matrix<double, 6, 1>;
using Tensors = std::vector<Tensor, Eigen::aligned_allocator<Tensor>>;

Tensor tensor(const Vec3& w, double k) {
  Tensor t;
  t << w.x() * w.x(), w.y() * w.y(), w.z() * w.z(), w.x() * w.y(), w.y() * w.z(), w.z() * w.x();
  return k * t;
}

double along(const Tensor& t, const Vec3& d) {
  return t[0] * d.x() * d.x() + t[1] * d.y() * d.y() + t[2] * d.z() * d.z() +
         2 * (t[3] * d.x() * d.y() + t[4] * d.y() * d.z() + t[5] * d.z() * d.x());
}

// One implicit step of the heat flow on a piece, (A + h L) S' = A S, by conjugate gradients with
// the diagonal as preconditioner. A: areas, L: the Laplacian of the links, across the seam of a
// double cover with the other sign.
class HeatStep {
 public:
  HeatStep(const Ragged<DualLink>& links, const DualCells& cells, Tensors& tensors)
      : links_(links),
        areas_(cells.areas),
        tensors_(tensors),
        residual_(tensors.size()),
        step_(tensors.size()),
        image_(tensors.size()),
        diagonal_(tensors.size()) {}

  void solve(Span<const int> piece, double h) {
    h_ = h;
    start(piece);
    double size = residual_size(piece);
    const double enough = size * tolerance * tolerance;
    for (int k = 0; k < most_iterations && size > enough; ++k) {
      const double length = size / apply(piece);
      for (const int v : piece) {
        tensors_[idx(v)] += length * step_[idx(v)];
        residual_[idx(v)] -= length * image_[idx(v)];
      }
      const double last = size;
      size = residual_size(piece);
      for (const int v : piece) {
        step_[idx(v)] = residual_[idx(v)] / diagonal_[idx(v)] + size / last * step_[idx(v)];
      }
    }
  }

 private:
  // The old tensors are the first guess, so A S cancels.
  void start(Span<const int> piece) {
    for (const int v : piece) {
      diagonal_[idx(v)] = areas_[idx(v)];
      for (const DualLink& link : links_[idx(v)]) diagonal_[idx(v)] += h_ * link.weight;
      if (!(diagonal_[idx(v)] > 0)) diagonal_[idx(v)] = 1;
      residual_[idx(v)] = -h_ * laplacian(tensors_, v);
      step_[idx(v)] = residual_[idx(v)] / diagonal_[idx(v)];
    }
  }

  Tensor laplacian(const Tensors& of, int v) const {
    Tensor sum = Tensor::Zero();
    for (const DualLink& link : links_[idx(v)]) {
      const Tensor& other = of[idx(link.vertex)];
      sum += link.weight * (link.mirrored ? Tensor(of[idx(v)] + other) : of[idx(v)] - other);
    }
    return sum;
  }

  double residual_size(Span<const int> piece) const {
    double sum = 0;
    for (const int v : piece) sum += residual_[idx(v)].squaredNorm() / diagonal_[idx(v)];
    return sum;
  }

  // The image of the step under the matrix; returns their dot product.
  double apply(Span<const int> piece) {
    double sum = 0;
    for (const int v : piece) {
      image_[idx(v)] = areas_[idx(v)] * step_[idx(v)] + h_ * laplacian(step_, v);
      sum += image_[idx(v)].dot(step_[idx(v)]);
    }
    return sum;
  }

  const Ragged<DualLink>& links_;
  const std::vector<double>& areas_;
  Tensors& tensors_;
  double h_ = 0;
  Tensors residual_, step_, image_;
  std::vector<double> diagonal_;
};

}  // namespace

DualCells dual_cells(const Surface& surface, const TriangleEdges& edges) {
  DualCells cells{std::vector<double>(surface.positions.size(), 0),
                  std::vector<double>(edges.size(), 0)};
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    const Triangle& v = surface.triangles[t];
    const Vec3 &a = surface.positions[idx(v[0])], &b = surface.positions[idx(v[1])],
               &c = surface.positions[idx(v[2])];
    const Vec3 centroid = (a + b + c) / 3;
    const double share = (b - a).cross(c - a).norm() / 6;
    for (int k = 0; k < 3; ++k) {
      const int edge = edges.of_triangle[t][idx(k)];
      cells.areas[idx(v[idx(k)])] += share;
      if (edge == none) continue;
      const Vec3 middle =
          (surface.positions[idx(v[idx(k)])] + surface.positions[idx(v[idx(next_corner(k))])]) / 2;
      cells.lengths[idx(edge)] += (middle - centroid).norm();
    }
  }
  return cells;
}

Ragged<DualLink> dual_links(const Surface& surface, const TriangleEdges& edges,
                            const DualCells& cells) {
  return sorted_into<DualLink>(surface.positions.size(), [&](const auto& put) {
    for (std::size_t e = 0; e < edges.size(); ++e) {
      const auto [a, b] = edges.vertices[e];
      const double size = (surface.positions[idx(a)] - surface.positions[idx(b)]).norm();
      const double weight = size > 0 ? cells.lengths[e] / size : 0;
      const bool is_mirrored = edges.mirrored[e] != 0;
      put(a, {b, cells.lengths[e], weight, is_mirrored});
      put(b, {a, cells.lengths[e], weight, is_mirrored});
    }
  });
}

std::vector<Vec2> smooth_bends(const Surface& surface, const Curvature& curvature,
                               const CrossField& field, const Ragged<DualLink>& links,
                               const DualCells& cells, const Ragged<int>& pieces,
                               const std::vector<double>& diagonals, const Progress& progress) {
  Tensors tensors(curvature.size());
  HeatStep step(links, cells, tensors);
  for (std::size_t p = 0; p < pieces.size(); ++p) {
    progress.report(static_cast<double>(p) / static_cast<double>(pieces.size()));
    const double most = diagonals[p] > 0 ? most_bend / diagonals[p] : 0;
    for (const int v : pieces[p]) {
      const PrincipalCurvature& k = curvature[idx(v)];
      tensors[idx(v)] =
          tensor(k.w1, std::clamp(k.k1, -most, most)) + tensor(k.w2, std::clamp(k.k2, -most, most));
    }
    step.solve(pieces[p], std::pow(radius * diagonals[p], 2) / 2);
  }
  std::vector<Vec2> bends;
  for (std::size_t v = 0; v < curvature.size(); ++v) {
    const Vec3& d = field.directions[v];
    bends.push_back(
        {std::abs(along(tensors[v], d)), std::abs(along(tensors[v], surface.normals[v].cross(d)))});
  }
  return bends;
}

}  // namespace illustrate
