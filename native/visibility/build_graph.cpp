#include "visibility/build_graph.h"

#include "surface/locate.h"

namespace illustrate {
namespace {

class GraphBuilder {
 public:
  GraphBuilder(const Arrangement& arrangement, const Surface& surface)
      : arrangement_(arrangement), network_(arrangement.network()), surface_(surface) {}

  LabelledGraph run(const std::vector<LabelledPath>& paths) {
    add_network_nodes();
    add_crossing_nodes();
    ends_.resize(network_.strands.size(), {none, none});
    for (const LabelledPath& path : paths) add_path(path);
    for (const Path& path : arrangement_.paths()) join_cusps(path);
    return std::move(graph_);
  }

 private:
  // Node images are those of the strand ends, to the bit.
  void add_network_nodes() {
    for (const NetworkNode& node : network_.nodes) {
      graph_.nodes.push_back({node.kind, Vec2::Zero(), {none, none, none, none}});
    }
    for (std::size_t s = 0; s < network_.strands.size(); ++s) {
      const Strand& strand = network_.strands[s];
      if (strand.closed()) continue;
      const int last = arrangement_.point_count(static_cast<int>(s)) - 1;
      graph_.nodes[idx(strand.start_node)].image = image(static_cast<int>(s), 0);
      graph_.nodes[idx(strand.end_node)].image = image(static_cast<int>(s), last);
    }
  }

  void add_crossing_nodes() {
    crossing_nodes_.resize(arrangement_.crossings().size(), none);
    for (std::size_t c = 0; c < arrangement_.crossings().size(); ++c) {
      const CrossingState state = arrangement_.state(static_cast<int>(c));
      if (state == CrossingState::dropped) continue;
      const bool live = state == CrossingState::live;
      crossing_nodes_[c] = static_cast<int>(graph_.nodes.size());
      graph_.nodes.push_back({live ? NodeKind::crossing : NodeKind::joint,
                              arrangement_.crossings()[c].image,
                              {none, none, none, none}});
    }
  }

  const Vec2& image(int strand, int point) const { return arrangement_.image_of(strand, point); }

  void add_path(const LabelledPath& path) {
    for (std::size_t i = 0; i < path.arcs.size(); ++i) {
      const PathArc& arc = path.arcs[i];
      start(arc, path.layers[i]);
      push_points(arc, begin_place(arc), end_place(arc));
      finish(arc);
    }
  }

  bool closed(const PathArc& arc) const { return network_.strands[idx(arc.strand)].closed(); }
  bool wraps(const PathArc& arc) const {
    return closed(arc) && arc.begin != none && arc.end <= arc.begin;
  }

  StrandPlace begin_place(const PathArc& arc) const {
    if (arc.begin == none) return {arc.strand, 0, 0};
    return arrangement_.visits(arc.strand)[idx(arc.begin)].place;
  }
  // Past the strand's last point where the arc runs on round a closed strand.
  StrandPlace end_place(const PathArc& arc) const {
    const int count = arrangement_.point_count(arc.strand);
    if (arc.end == none) return {arc.strand, count - 1, 0};
    StrandPlace place = arrangement_.visits(arc.strand)[idx(arc.end)].place;
    if (wraps(arc)) place.segment += count;
    return place;
  }

  // The arc that is being built; its points are the open lists of both Ragged.
  GraphArc& current() { return graph_.arcs.back(); }
  int current_index() const { return static_cast<int>(graph_.arcs.size()) - 1; }

  void open(const PathArc& arc, int invisibility) {
    const Strand& strand = network_.strands[idx(arc.strand)];
    graph_.arcs.push_back({strand.kind, strand.object, arc.strand, none, none, invisibility,
                           strand.left_layers, strand.right_layers, strand.is_flush});
  }

  void start(const PathArc& arc, int invisibility) {
    open(arc, invisibility);
    if (arc.begin != none) {
      current().start_node = attach(arc, arc.begin, 1);
    } else if (!closed(arc)) {
      current().start_node = network_.strands[idx(arc.strand)].start_node;
      ends_[idx(arc.strand)][0] = current_index();
    }
  }

  void finish(const PathArc& arc) {
    if (arc.end != none) {
      current().end_node = attach(arc, arc.end, 0);
    } else if (!closed(arc)) {
      current().end_node = network_.strands[idx(arc.strand)].end_node;
      ends_[idx(arc.strand)][1] = current_index();
    }
    graph_.points.close_list();
    graph_.image.close_list();
  }

  // Enters the current arc at its crossing; side 0 where it ends there, 1 where it starts.
  int attach(const PathArc& arc, int visit_index, std::size_t side) {
    const Visit& visit = arrangement_.visits(arc.strand)[idx(visit_index)];
    const int node = crossing_nodes_[idx(visit.crossing)];
    if (arrangement_.is_live(visit.crossing)) {
      graph_.nodes[idx(node)].arcs[(visit.front ? 0 : 2) + side] = current_index();
    }
    return node;
  }

  void push_points(const PathArc& arc, const StrandPlace& from, const StrandPlace& to) {
    push_place(from);
    for (int i = from.segment + 1; i <= to.segment; ++i) {
      if (i == to.segment && to.fraction == 0) break;
      push_point(arc.strand, i);
    }
    push_place(to);
  }

  void push_point(int strand, int i) {
    graph_.points.push(network_.points.values[arrangement_.point(strand, i)]);
    graph_.image.push(image(strand, i));
  }

  void push_place(StrandPlace place) {
    if (place.fraction == 0) return push_point(place.strand, place.segment);
    const CurvePoint& before =
        network_.points.values[arrangement_.point(place.strand, place.segment)];
    const Vec3 position = arrangement_.world_at(place);
    graph_.points.push({position, locate(surface_, before.on.triangle, position)});
    graph_.image.push(arrangement_.image_at(place));
  }

  // A cusp that was repaired away stays as a joint.
  void join_cusps(const Path& path) {
    for (std::size_t i = path.cyclic ? 0 : 1; i < path.strands.size(); ++i) {
      const int n = network_.strands[idx(path.strands[i])].start_node;
      if (n == none || graph_.nodes[idx(n)].kind != NodeKind::cusp) continue;
      GraphNode& node = graph_.nodes[idx(n)];
      const std::size_t count = path.strands.size();
      const int before = ends_[idx(path.strands[(i + count - 1) % count])][1];
      const int behind = ends_[idx(path.strands[i])][0];
      if (path.jumps[i] == 0 || path.is_joint[i]) {
        node.kind = NodeKind::joint;
      } else {
        node.arcs[0] = path.jumps[i] > 0 ? before : behind;
        node.arcs[1] = path.jumps[i] > 0 ? behind : before;
      }
    }
  }

  const Arrangement& arrangement_;
  const CurveNetwork& network_;
  const Surface& surface_;
  std::vector<int> crossing_nodes_;
  std::vector<std::array<int, 2>> ends_;  // first and last arc of each open strand
  LabelledGraph graph_;
};

}  // namespace

LabelledGraph build_graph(const Arrangement& arrangement, const std::vector<LabelledPath>& paths,
                          const Surface& surface) {
  return GraphBuilder(arrangement, surface).run(paths);
}

}  // namespace illustrate
