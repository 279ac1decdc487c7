#include "field/search/diffusion.h"

#include "core/mixed_bits.h"

namespace illustrate {
namespace {

constexpr double step_shrinking = 0.4;
constexpr double shortest_step = 0.5;
constexpr int steps_per_length = 3;

// Crosses get length 1 after each step: a rough solution of its equations is enough.
constexpr double solver_tolerance = 0.03;
constexpr int solver_iterations = 60;

// The equations of one implicit step, (D (1 + 1/tau) - A) z' = D z / tau + pulls, solved by
// conjugate gradients with the diagonal as preconditioner. D: weights, A: links. Linear over the
// real numbers only: mirrored edges conjugate.
class ImplicitStep {
 public:
  ImplicitStep(const FieldGraph& graph, double tau)
      : graph_(graph),
        scale_(1 + 1 / tau),
        residual_(graph.size()),
        step_(graph.size()),
        image_(graph.size()) {}

  void solve(CrossNumbers& z) {
    start(z);
    double size = residual_size();
    const double enough = size * solver_tolerance * solver_tolerance;
    for (int k = 0; k < solver_iterations && size > enough; ++k) {
      const double bending = apply();
      if (!(bending > 0)) return;
      const double length = size / bending;
      for (std::size_t i = 0; i < z.size(); ++i) {
        z[i] += length * step_[i];
        residual_[i] -= length * image_[i];
      }
      const double last = size;
      size = residual_size();
      for (std::size_t i = 0; i < z.size(); ++i) {
        step_[i] = preconditioned(i) + size / last * step_[i];
      }
    }
  }

 private:
  // The old z is the first guess, so D z / tau cancels.
  void start(const CrossNumbers& z) {
    for (std::size_t i = 0; i < z.size(); ++i) {
      residual_[i] = graph_.attraction(i, z) - graph_.weights[i] * z[i];
      step_[i] = preconditioned(i);
    }
  }

  CrossNumber preconditioned(std::size_t i) const {
    return graph_.weights[i] > 0 ? residual_[i] / (scale_ * graph_.weights[i]) : CrossNumber(0);
  }

  double residual_size() const {
    double sum = 0;
    for (std::size_t i = 0; i < residual_.size(); ++i) {
      if (graph_.weights[i] > 0) sum += std::norm(residual_[i]) / (scale_ * graph_.weights[i]);
    }
    return sum;
  }

  // The image of the step under the matrix; returns their dot product.
  double apply() {
    double sum = 0;
    for (std::size_t i = 0; i < step_.size(); ++i) {
      image_[i] =
          scale_ * graph_.weights[i] * step_[i] - (graph_.attraction(i, step_) - graph_.pulls[i]);
      sum += step_[i].real() * image_[i].real() + step_[i].imag() * image_[i].imag();
    }
    return sum;
  }

  const FieldGraph& graph_;
  double scale_;
  CrossNumbers residual_, step_, image_;
};

}  // namespace

double SeededNumbers::uniform() {
  state_ += mixing_step;
  return static_cast<double>(mixed_bits(state_) >> 11U) * 0x1p-52 - 1;
}

CrossNumber SeededNumbers::number() {
  const double real = uniform();
  return {real, uniform()};
}

void diffuse_once(const FieldGraph& graph, double tau, CrossNumbers& z) {
  ImplicitStep(graph, tau).solve(z);
}

void diffuse(const FieldGraph& graph, double tau, CrossNumbers& z) {
  for (; tau > shortest_step; tau *= step_shrinking) {
    for (int k = 0; k < steps_per_length; ++k) {
      const CrossNumbers before = z;
      diffuse_once(graph, tau, z);
      for (std::size_t i = 0; i < z.size(); ++i) z[i] = normalized(z[i], before[i]);
    }
  }
}

void anneal(const FieldGraph& graph, double heat, int sweeps, SeededNumbers& numbers,
            CrossNumbers& z) {
  for (int k = 0; k < sweeps; ++k) {
    const double left = heat * (1 - static_cast<double>(k) / sweeps);
    for (std::size_t i = 0; i < graph.size(); ++i) {
      const CrossNumber disturbance = left * graph.weights[i] * numbers.number();
      z[i] = normalized(graph.attraction(i, z) + disturbance, z[i]);
    }
  }
}

void sweep(const FieldGraph& graph, int count, CrossNumbers& z, const Progress& progress) {
  for (int k = 0; k < count; ++k) {
    progress.report(static_cast<double>(k) / count);
    for (std::size_t i = 0; i < graph.size(); ++i) {
      // No over-relaxation: a factor of 1.8 converged faster, to worse minima.
      z[i] = normalized(graph.attraction(i, z), z[i]);
    }
  }
}

}  // namespace illustrate
