// One nasty mesh through the stages, with everything checked that holds for any mesh.
#pragma once

#include <cstdint>
#include <string>

namespace illustrate::fuzz {

// Makes the mesh of this seed, mends and refines it, and draws a part of them; failures are
// GoogleTest's. Returns a line about the mesh.
std::string run_case(std::uint64_t seed);

}  // namespace illustrate::fuzz
