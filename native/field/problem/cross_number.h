// The number that stands for a cross: z = exp(i u), u = 4 theta. All four directions of a cross at
// angle theta have the same z, so crosses can be compared, added and averaged as complex numbers.
#pragma once

#include <cmath>
#include <complex>
#include <vector>

namespace illustrate {

using CrossNumber = std::complex<double>;
using CrossNumbers = std::vector<CrossNumber>;

// a b without the detour that std::complex makes for infinities.
inline CrossNumber product(const CrossNumber& a, const CrossNumber& b) {
  return {a.real() * b.real() - a.imag() * b.imag(), a.real() * b.imag() + a.imag() * b.real()};
}

// The mirror image of z when asked for: how a cross looks in a frame whose normal is turned over.
inline CrossNumber mirrored_if(bool mirrored, const CrossNumber& z) {
  return {z.real(), mirrored ? -z.imag() : z.imag()};
}

// z of length 1; `otherwise` where z has no usable length.
inline CrossNumber normalized(const CrossNumber& z, const CrossNumber& otherwise) {
  const double length = std::sqrt(std::norm(z));
  return length > 1e-150 && std::isfinite(length) ? z / length : otherwise;
}

inline CrossNumber fourth_power(const CrossNumber& direction) {
  const CrossNumber square = product(direction, direction);
  return product(square, square);
}

}  // namespace illustrate
