// Bits of a number, so mixed that numbers close to each other have nothing in common: the finaliser
// of SplitMix64.
#pragma once

#include <cstdint>

namespace illustrate {

// One to one; 0 stays 0.
inline std::uint64_t mixed_bits(std::uint64_t z) {
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9U;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebU;
  return z ^ (z >> 31);
}

// What is added before mixing where 0 must not stay 0: odd, near 2^64 by the golden ratio.
constexpr std::uint64_t mixing_step = 0x9e3779b97f4a7c15U;

}  // namespace illustrate
