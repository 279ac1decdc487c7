// Polynomials fitted to the points round a vertex.
#pragma once

#include "surface/jets/local_jet.h"

namespace illustrate {

// Curvature from jets at some vertices of a surface.
class JetFitter {
 public:
  JetFitter(const Surface& surface, int rings);

  // Memory that one thread reuses from vertex to vertex.
  struct Workspace {
    std::vector<int> found;    // vertices around, the vertex itself first
    std::vector<int> visited;  // (n) last vertex that came by here
    LocalJet jet;              // of them
  };

  PrincipalCurvature fit(int vertex, Workspace& work) const;

 private:
  void gather(int vertex, Workspace& work) const;

  const Surface& surface_;
  int rings_;
  std::vector<int> offsets_, neighbours_;  // vertices joined to each vertex by an edge, sorted
  std::vector<std::uint8_t> at_border_;    // (n) 1: on a boundary or on one side of a crease
};

// Writes the curvature of some vertices, and no other, into `result`. `surface` may own it.
void fit_jets(const Surface& surface, const std::vector<int>& vertices, const JetOptions& options,
              const Progress& progress, Curvature& result);

}  // namespace illustrate
