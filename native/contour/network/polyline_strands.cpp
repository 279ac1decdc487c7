#include "contour/network/polyline_strands.h"

#include <algorithm>

#include "surface/locate.h"

namespace illustrate {
namespace {

// What a curvature line may stick out beyond its meeting with another curve is as long as this
// share of its object's diagonal: about an edge of the triangles, a fifth of the shortest line.
constexpr double longest_stub = 0.004;

struct Polyline {
  std::vector<CurvePoint> points;
  bool closed;
};

// A polyline with the nodes of its cuts inserted; nodes[i] is none at plain points.
struct CutPolyline {
  std::vector<CurvePoint> points;
  std::vector<int> nodes;
  std::vector<int> sources;  // original point each one stands at or behind
};

Span<const CurveCut> cuts_of(const std::vector<CurveCut>& cuts, int curve) {
  const auto range =
      std::equal_range(cuts.begin(), cuts.end(), CurveCut{curve, 0, 0, 0, {}},
                       [](const CurveCut& a, const CurveCut& b) { return a.curve < b.curve; });
  const auto first = static_cast<std::size_t>(range.first - cuts.begin());
  return {cuts.data() + first, static_cast<std::size_t>(range.second - range.first)};
}

CutPolyline insert_cuts(const Surface& surface, const Polyline& line, Span<const CurveCut> cuts,
                        const std::vector<NetworkNode>& nodes) {
  CutPolyline result;
  result.points.reserve(line.points.size() + cuts.size() + 1);
  result.nodes.reserve(result.points.capacity());
  result.sources.reserve(result.points.capacity());
  std::size_t next = 0;
  for (std::size_t i = 0; i < line.points.size(); ++i) {
    const std::size_t begin = next;
    while (next < cuts.size() && cuts[next].segment == static_cast<int>(i)) ++next;
    const bool at_point = begin < next && cuts[begin].fraction == 0;
    if (!at_point) {
      result.points.push_back(line.points[i]);
      result.nodes.push_back(none);
      result.sources.push_back(static_cast<int>(i));
    }
    for (std::size_t k = begin; k < next; ++k) {
      const Vec3& position = nodes[idx(cuts[k].node)].position;
      const int triangle = line.points[i].on.triangle;
      result.points.push_back({position, cuts[k].fraction == 0
                                             ? line.points[i].on
                                             : locate(surface, triangle, position)});
      result.nodes.push_back(cuts[k].node);
      result.sources.push_back(static_cast<int>(i));
    }
  }
  return result;
}

void rotate_to_first_node(CutPolyline& line) {
  const auto first =
      std::find_if(line.nodes.begin(), line.nodes.end(), [](int node) { return node != none; });
  const auto shift = first - line.nodes.begin();
  std::rotate(line.points.begin(), line.points.begin() + shift, line.points.end());
  std::rotate(line.nodes.begin(), line.nodes.begin() + shift, line.nodes.end());
  std::rotate(line.sources.begin(), line.sources.begin() + shift, line.sources.end());
  line.points.push_back(line.points.front());
  line.nodes.push_back(line.nodes.front());
  line.sources.push_back(line.sources.front());
}

// Adds the strands between nodes in order; returns the original point that each strand starts at.
std::vector<int> add_strands(const CutPolyline& line, Strand strand, CurveNetwork& network) {
  std::vector<int> sources;
  for (std::size_t i = 0; i + 1 < line.points.size(); ++i) {
    if (line.nodes[i] != none) {
      strand.start_node = line.nodes[i];
      sources.push_back(line.sources[i]);
    }
    network.points.push(line.points[i]);
    if (line.nodes[i + 1] == none) continue;
    strand.end_node = line.nodes[i + 1];
    network.points.push(line.points[i + 1]);
    network.points.close_list();
    network.strands.push_back(strand);
  }
  return sources;
}

// Returns the original points that the strands start at; empty for a closed strand without nodes.
std::vector<int> add_polyline(const Surface& surface, const Polyline& line,
                              Span<const CurveCut> cuts, Strand strand, CurveNetwork& network) {
  if (line.points.size() < 2) return {};
  strand.object = surface.object_of(line.points.front().on.triangle);
  if (cuts.empty()) {
    network.points.add(line.points);
    network.strands.push_back(strand);
    return {};
  }
  CutPolyline cut = insert_cuts(surface, line, cuts, network.nodes);
  if (line.closed) rotate_to_first_node(cut);
  return add_strands(cut, strand, network);
}

// Strands first .. first + count follow each other, one behind each cut (but the last cut of an
// open curve); where the change between two of them is known they are tied.
void add_ties(Span<const CurveCut> cuts, bool closed, int first, CurveNetwork& network) {
  const int count = static_cast<int>(network.strands.size()) - first;
  for (int i = closed ? 0 : 1; i < count && !cuts.empty(); ++i) {
    const CurveCut& cut = cuts[idx(i)];
    const int strand = first + i, previous = first + (i + count - 1) % count;
    if (cut.jump) network.ties.push_back({cut.node, previous, strand, *cut.jump});
  }
}

// Whether most of the points between two cuts of a line are; the cuts are told by the points that
// they stand at or behind.
bool most_are(Span<const ZeroPoint> line, int from, int to, bool ZeroPoint::*is) {
  const int count = static_cast<int>(line.size());
  int votes = 0;
  for (int i = from + 1; i <= to; ++i) votes += line[idx(i % count)].*is ? 1 : -1;
  return votes != 0 ? votes > 0 : line[idx(from % count)].*is;
}

// Where and as what a line between two cuts is drawn, if at all.
struct Stretch {
  Kind kind;
  bool unseen;
};

bool is_wanted(Kind kind, const CurvatureCurveOptions& options) {
  return !is_curvature_line(kind) || options.wants(kind);
}

// Whether a strand is what sticks out of a line beyond its meeting with another curve.
bool is_stub(const CurveNetwork& network, std::size_t s, double shortest) {
  const Strand& strand = network.strands[s];
  if (strand.closed()) return false;
  const NodeKind start = network.nodes[idx(strand.start_node)].kind;
  const NodeKind end = network.nodes[idx(strand.end_node)].kind;
  if ((start == NodeKind::end) == (end == NodeKind::end)) return false;
  const Span<const CurvePoint> points = network.points[s];
  double length = 0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    length += (points[i].position - points[i - 1].position).norm();
  }
  return length < shortest;
}

// Of the strands that a line is cut into at these points; one where it is not cut.
std::vector<Stretch> stretches(Span<const ZeroPoint> line, bool closed, Kind kind,
                               const std::vector<int>& sources) {
  const int count = static_cast<int>(line.size());
  std::vector<Stretch> result;
  for (std::size_t s = 0; s < std::max<std::size_t>(sources.size(), 1); ++s) {
    const int from = sources.empty() ? 0 : sources[s];
    int to = closed ? from + count : count - 1;
    if (s + 1 < sources.size())
      to = sources[s + 1];
    else if (closed && !sources.empty())
      to = sources[0] + count;
    const bool ridge = most_are(line, from, to, &ZeroPoint::ridge);
    const bool unseen = most_are(line, from, to, &ZeroPoint::unseen);
    result.push_back({kind == Kind::ridge && !ridge ? Kind::valley : kind, unseen});
  }
  return result;
}

Polyline polyline_of(Span<const ChainPoint> chain, bool closed) {
  Polyline line{{}, closed};
  line.points.reserve(chain.size());
  for (const ChainPoint& p : chain) line.points.push_back({p.position, p.on});
  return line;
}

}  // namespace

void add_silhouette_strands(const Surface& surface, const Silhouettes& silhouettes,
                            const Joints& joints, CurveNetwork& network) {
  Strand strand;
  strand.kind = Kind::silhouette;
  strand.left_layers = 2;
  network.points.values.reserve(network.points.values.size() + silhouettes.chains.values.size() +
                                2 * joints.chains.size());
  for (std::size_t c = 0; c < silhouettes.chains.size(); ++c) {
    const Span<const ChainPoint> chain = silhouettes.chains[c];
    const bool closed = silhouettes.closed[c];
    const Span<const CurveCut> cuts = cuts_of(joints.chains, static_cast<int>(c));
    const int first = static_cast<int>(network.strands.size());
    add_polyline(surface, polyline_of(chain, closed), cuts, strand, network);
    add_ties(cuts, closed, first, network);
  }
}

void add_intersection_strands(const Surface& surface, const IntersectionCurves& intersections,
                              const Joints& joints, CurveNetwork& network) {
  Strand strand;
  strand.kind = Kind::intersection;
  for (std::size_t c = 0; c < intersections.curves.size(); ++c) {
    Polyline line{{}, intersections.closed[c] != 0};
    for (const IntersectionPoint& p : intersections.curves[c]) {
      line.points.push_back({p.position, p.a});
    }
    const Span<const CurveCut> cuts = cuts_of(joints.intersections, static_cast<int>(c));
    const std::size_t first = network.strands.size();
    std::vector<int> sources = add_polyline(surface, line, cuts, strand, network);
    if (sources.empty()) sources.push_back(0);
    for (std::size_t s = first; s < network.strands.size(); ++s) {
      const auto start = idx(intersections.curves.offsets[c] + sources[s - first]);
      network.strands[s].is_flush = intersections.flush_segments[start] != 0;
    }
    add_ties(cuts, line.closed, static_cast<int>(first), network);
  }
}

void add_free_strands(const Surface& surface, const FreeLines& free_lines,
                      const CurvatureCurveOptions& options, const Joints& joints,
                      CurveNetwork& network) {
  if (free_lines.lines.curves.size() == 0) return;  // the sizes need a look at the whole surface
  Strand strand;
  strand.left_layers = strand.right_layers = 1;
  CurveNetwork all;
  all.nodes = network.nodes;
  const std::vector<double>& sizes = surface.object_diagonals;
  std::vector<Stretch> found;
  for (std::size_t c = 0; c < free_lines.lines.curves.size(); ++c) {
    const Span<const ZeroPoint> line = free_lines.lines.curves[c];
    const bool closed = free_lines.lines.closed[c];
    Polyline polyline{{}, closed};
    for (const ZeroPoint& p : line) polyline.points.push_back({p.position, p.on});
    const std::vector<int> sources =
        add_polyline(surface, polyline, cuts_of(joints.lines, static_cast<int>(c)), strand, all);
    for (const Stretch& s : stretches(line, closed, free_lines.kinds[c], sources)) {
      found.push_back(s);
    }
  }
  for (std::size_t s = 0; s < all.strands.size(); ++s) {
    const double size = sizes[idx(all.strands[s].object)];
    if (found[s].unseen || !is_wanted(found[s].kind, options)) continue;
    if (is_curvature_line(found[s].kind) && is_stub(all, s, longest_stub * size)) continue;
    all.strands[s].kind = found[s].kind;
    network.points.add(all.points[s]);
    network.strands.push_back(all.strands[s]);
  }
}

}  // namespace illustrate
