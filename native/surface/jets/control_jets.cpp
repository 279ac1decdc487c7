#include "surface/jets/control_jets.h"

#include <algorithm>
#include <cmath>

#include "core/parallel.h"
#include "mesh/polygons.h"
#include "surface/jets/control_nodes.h"
#include "surface/jets/local_jet.h"

namespace illustrate {
namespace {

// Enough for three rings of control edges at half their spacing; beyond it points are taken by
// stride.
constexpr std::size_t most_jet_vertices = 256;
// No more rings are added beyond so many points; of a node with very many links only some are
// followed, by stride.
constexpr std::size_t most_gathered = 1024, most_links = 48;
// Where the normal has turned by 60 degrees from the node's the surface is no longer a graph that a
// polynomial follows: a coarse control mesh is gone round in three rings.
constexpr double least_cosine = .5;
// Points at the rim come and go from one node to the next: they weigh little.
constexpr double control_falloff = .9;

// On boundaries, creases and the rims of flat faces.
std::vector<std::uint8_t> border_vertices(const Surface& surface) {
  std::vector<std::uint8_t> result(surface.positions.size(), 0);
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    for (int k = 0; k < 3; ++k) {
      const int other = surface.neighbours[t][idx(k)];
      const bool ends_plane = other != none && lies_on_plane(surface, other) !=
                                                   lies_on_plane(surface, static_cast<int>(t));
      const bool is_crease = surface.edge_kinds[t][idx(k)] == EdgeKind::crease;
      if (other != none && !is_crease && !ends_plane) continue;
      result[idx(surface.triangles[t][idx(k)])] = 1;
      result[idx(surface.triangles[t][idx(next_corner(k))])] = 1;
    }
  }
  return result;
}

// The vertices round nodes.
class Gatherer {
 public:
  Gatherer(const Surface& surface, const ControlNodes& nodes,
           const std::vector<std::uint8_t>& border_vertices)
      : surface_(surface),
        nodes_(nodes),
        border_vertices_(border_vertices),
        visited_(nodes.vertices().size(), none) {}

  // The node's vertex first, then those of so many rings of control edges round it, as far as the
  // surface does not turn away.
  const std::vector<int>& gather(int node, int rings) {
    const int links_per_edge = nodes_.links_per_edge(node);
    found_.assign(1, {node, 1});
    visited_[idx(node)] = node;
    is_near_border_ = is_at_border(node);
    std::size_t from = 0;
    for (int ring = 1; ring <= rings * links_per_edge && found_.size() < most_gathered; ++ring) {
      const std::size_t to = found_.size();
      for (; from < to; ++from) add_neighbours(found_[from]);
      if (ring >= links_per_edge || is_near_border_) continue;
      is_near_border_ = std::any_of(found_.begin(), found_.end(),
                                    [&](const auto& link) { return is_at_border(link.node); });
    }
    vertices_.clear();
    for (const ControlNodes::Link& link : found_) {
      vertices_.push_back(nodes_.vertices()[idx(link.node)]);
    }
    thin(vertices_, most_jet_vertices);
    return vertices_;
  }

  // Less than a control edge away from a border of the last node: what bends there
  // belongs to the strip along it, and a higher degree follows it.
  bool is_near_border() const { return is_near_border_; }

 private:
  bool is_at_border(int node) const {
    return border_vertices_[idx(nodes_.vertices()[idx(node)])] != 0;
  }
  const Vec3& normal(int node) const { return surface_.normals[idx(nodes_.vertices()[idx(node)])]; }

  void add_neighbours(const ControlNodes::Link from) {
    const int centre = found_.front().node;
    const Span<const ControlNodes::Link> links = nodes_.links(from.node);
    const std::size_t stride = (links.size() + most_links - 1) / most_links;
    for (std::size_t k = 0; k < links.size(); k += stride) {
      const auto& [node, sign] = links[k];
      if (visited_[idx(node)] == centre) continue;
      if (from.sign * sign * normal(node).dot(normal(centre)) < least_cosine) continue;
      visited_[idx(node)] = centre;
      found_.push_back({node, from.sign * sign});
    }
  }

  const Surface& surface_;
  const ControlNodes& nodes_;
  const std::vector<std::uint8_t>& border_vertices_;  // (n)
  bool is_near_border_ = false;
  std::vector<int> visited_;               // (nodes) last node that came by here
  std::vector<ControlNodes::Link> found_;  // with the sign against the node in the middle
  std::vector<int> vertices_;
};

std::vector<PrincipalCurvature> jets_at_nodes(const Surface& surface, const ControlNodes& nodes,
                                              const JetOptions& options, const Progress& progress) {
  const std::vector<std::uint8_t> at_border = border_vertices(surface);
  std::vector<PrincipalCurvature> jets(nodes.vertices().size());
  parallel_for(jets.size(), options.threads, progress, [&](std::size_t begin, std::size_t end) {
    Gatherer gatherer(surface, nodes, at_border);
    LocalJet jet;
    for (std::size_t i = begin; i < end; ++i) {
      const int node = static_cast<int>(i);
      jet.take(surface, gatherer.gather(node, options.rings));
      jets[i] = jet.fit(gatherer.is_near_border() ? 2 : 4, true, control_falloff);
    }
  });
  return jets;
}

// A tangent w of the plane across `from`, turned with the plane the short way to lie across `to`.
Vec3 turned_across(const Vec3& w, const Vec3& from, const Vec3& to) {
  constexpr double opposite = 1e-6;
  const double scale = 1 + from.dot(to);
  // Between opposite normals no way is the shortest.
  if (scale < opposite) return w;
  return w - w.dot(to) / scale * (from + to);
}

// Sum of the shape operators at the nodes of `place`, each turned into the tangent plane of
// `normal`.
PrincipalCurvature interpolate(const Surface& surface, const ControlNodes& nodes,
                               const std::vector<PrincipalCurvature>& jets,
                               const ControlNodes::Place& place, const Vec3& normal) {
  const Vec3 x = any_tangent(normal), y = normal.cross(x);
  double xx = 0, xy = 0, yy = 0;
  for (const auto& [node, weight, sign] : place) {
    if (node == none) continue;
    // Operators are added, not directions: where k1 and k2 are nearly equal those of two nodes may
    // lie a quarter turn apart, and mean the same.
    const PrincipalCurvature& k = jets[idx(node)];
    const Vec3 from = sign * surface.normals[idx(nodes.vertices()[idx(node)])];
    const Vec3 w = turned_across(k.w1, from, normal);
    const double a = w.dot(x), b = w.dot(y), k1 = sign * weight * k.k1, k2 = sign * weight * k.k2;
    xx += k1 * a * a + k2 * b * b;
    xy += (k1 - k2) * a * b;
    yy += k1 * b * b + k2 * a * a;
  }
  return principal_curvature(x, y, xx * normal, xy * normal, yy * normal, normal);
}

}  // namespace

std::vector<int> control_jets(const Surface& surface, const JetOptions& options,
                              const Progress& progress, Curvature& result) {
  const ControlNodes nodes(surface);
  const auto jets = jets_at_nodes(surface, nodes, options, progress.part(0, .9));
  const std::size_t n = surface.positions.size();
  std::vector<std::uint8_t> is_left(n, 0);
  parallel_for(n, options.threads, progress.part(.9, 1), [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) {
      const ControlNodes::Place place = nodes.place(static_cast<int>(v));
      is_left[v] = std::all_of(place.begin(), place.end(),
                               [](const ControlNodes::Weight& w) { return w.node == none; });
      if (is_left[v]) continue;
      const bool is_node = place[0].weight == 1;
      result[v] = is_node ? jets[idx(place[0].node)]
                          : interpolate(surface, nodes, jets, place, surface.normals[v]);
    }
  });
  std::vector<int> left;
  for (std::size_t v = 0; v < n; ++v) {
    if (is_left[v]) left.push_back(static_cast<int>(v));
  }
  return left;
}

}  // namespace illustrate
