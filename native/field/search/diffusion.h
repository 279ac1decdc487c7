// Ways to lead a cross field out of a bad basin: the heat flow of crosses, and shaking.
#pragma once

#include <cstdint>

#include "core/progress.h"
#include "field/problem/energy.h"

namespace illustrate {

// SplitMix64: numbers that look random and are the same everywhere.
class SeededNumbers {
 public:
  explicit SeededNumbers(std::uint64_t seed) : state_(seed) {}

  double uniform();      // in [-1, 1)
  CrossNumber number();  // in the square of half side 1

 private:
  std::uint64_t state_;
};

// Implicit steps of the heat flow, of shrinking length from tau down, after each of which every
// cross gets length 1 again: while the steps are long, singularities wander and cancel. tau: in
// units in which 1 reaches the next vertex.
void diffuse(const FieldGraph& graph, double tau, CrossNumbers& z);

// One such step, lengths left as they come: few long ones leave the smoothest fields of the graph.
void diffuse_once(const FieldGraph& graph, double tau, CrossNumbers& z);

// Gauss-Seidel sweeps in which every cross is disturbed by up to `heat` times its weight, less and
// less.
void anneal(const FieldGraph& graph, double heat, int sweeps, SeededNumbers& numbers,
            CrossNumbers& z);

// Nonlinear Gauss-Seidel: `count` times each vertex in order takes the cross that everything around
// it asks for. The energy never rises.
void sweep(const FieldGraph& graph, int count, CrossNumbers& z, const Progress& progress = {});

}  // namespace illustrate
