#include "visibility/arrangement/arrangement.h"

#include <algorithm>
#include <tuple>

#include "core/sort_unique.h"
#include "visibility/evidence/outline.h"

namespace illustrate {
namespace {

// Of visits at one place that of the earlier crossing, and of a crossing of a strand with itself
// the visit behind: some order, the same whatever the sort.
bool runs_before(const Visit& a, const Visit& b) {
  return std::tie(a.place.segment, a.decided, a.crossing, a.front) <
         std::tie(b.place.segment, b.decided, b.crossing, b.front);
}

// Of two curves at one place, as the borders of sheets that adjoin, a third one is drawn across in
// any order: a visit is drawn no earlier than those before it.
void draw_in_order(std::vector<Visit>& visits) {
  for (std::size_t i = 1; i < visits.size(); ++i) {
    StrandPlace& place = visits[i].place;
    const StrandPlace& before = visits[i - 1].place;
    if (place.segment == before.segment) place.fraction = std::max(place.fraction, before.fraction);
  }
}

class PathFinder {
 public:
  explicit PathFinder(const CurveNetwork& network)
      : network_(network),
        next_(network.strands.size(), none),
        previous_(network.strands.size(), none),
        used_(network.strands.size(), 0) {
    for (std::size_t t = 0; t < network.ties.size(); ++t) {
      next_[idx(network.ties[t].a)] = static_cast<int>(t);
      previous_[idx(network.ties[t].b)] = static_cast<int>(t);
    }
  }

  std::vector<Path> run() {
    std::vector<Path> paths;
    // First those that start at a strand which follows none: open ones, and single closed strands.
    // What nobody has used then are rings of strands, which start at their first.
    for (const bool from_start : {true, false}) {
      for (std::size_t s = 0; s < network_.strands.size(); ++s) {
        if (!used_[s] && (!from_start || previous_[s] == none))
          paths.push_back(follow(static_cast<int>(s)));
      }
    }
    return paths;
  }

 private:
  Path follow(int first) {
    Path path;
    path.cyclic = network_.strands[idx(first)].closed() || previous_[idx(first)] != none;
    const int entry = previous_[idx(first)];
    int jump = entry == none ? 0 : network_.ties[idx(entry)].jump;
    for (int s = first;;) {
      used_[idx(s)] = 1;
      path.strands.push_back(s);
      path.jumps.push_back(jump);
      path.is_joint.push_back(0);
      const int tie = next_[idx(s)];
      if (tie == none) break;
      s = network_.ties[idx(tie)].b;
      jump = network_.ties[idx(tie)].jump;
      if (used_[idx(s)]) break;
    }
    return path;
  }

  const CurveNetwork& network_;
  std::vector<int> next_;
  std::vector<int> previous_;
  std::vector<std::uint8_t> used_;
};

std::vector<std::vector<Visit>> sorted_visits(const std::vector<Crossing>& crossings,
                                              std::size_t strands) {
  std::vector<std::vector<Visit>> visits(strands);
  for (std::size_t c = 0; c < crossings.size(); ++c) {
    const auto enter = [&](const StrandPlace& place, bool is_front) {
      const double decided = crossings[c].decided[is_front ? 0 : 1];
      visits[idx(place.strand)].push_back({static_cast<int>(c), is_front, place, decided});
    };
    enter(crossings[c].front, /*is_front=*/true);
    enter(crossings[c].back, /*is_front=*/false);
  }
  for (std::vector<Visit>& list : visits) {
    std::sort(list.begin(), list.end(), runs_before);
    draw_in_order(list);
  }
  return visits;
}

}  // namespace

void Arrangement::drop(const std::vector<int>& crossings) {
  for (const int c : crossings) states_[idx(c)] = CrossingState::dropped;
  forget_visits(crossings);
}

void Arrangement::demote(const std::vector<int>& crossings) {
  for (const int c : crossings) states_[idx(c)] = CrossingState::demoted;
  forget_visits(crossings);
}

// Those of what is dropped, and of the front strand of what is demoted.
void Arrangement::forget_visits(const std::vector<int>& crossings) {
  const auto is_gone = [&](const Visit& visit) {
    const CrossingState now = state(visit.crossing);
    return now == CrossingState::dropped || (now == CrossingState::demoted && visit.front);
  };
  std::vector<int> strands;
  for (const int c : crossings) {
    strands.insert(strands.end(), {crossing(c).front.strand, crossing(c).back.strand});
  }
  sort_unique(strands, visits_.size());
  for (const int s : strands) {
    std::vector<Visit>& visits = visits_[idx(s)];
    visits.erase(std::remove_if(visits.begin(), visits.end(), is_gone), visits.end());
  }
}

void Arrangement::drop_jump(int path, int step) { paths_[idx(path)].jumps[idx(step)] = 0; }

void Arrangement::turn_jump(int path, int step) {
  int& jump = paths_[idx(path)].jumps[idx(step)];
  jump = -jump;
}

void Arrangement::make_joint(int path, int step) { paths_[idx(path)].is_joint[idx(step)] = 1; }

void Arrangement::move_point(int strand, int i, const Vec2& image) {
  image_.image[point(strand, i)] = image;
}

std::int64_t Arrangement::live_crossings() const {
  return std::count(states_.begin(), states_.end(), CrossingState::live);
}

std::int64_t Arrangement::loops() const {
  return std::count_if(paths_.begin(), paths_.end(), [](const Path& path) { return path.cyclic; });
}

int Arrangement::point_count(int strand) const {
  return network_->points.offsets[idx(strand) + 1] - network_->points.offsets[idx(strand)];
}

std::size_t Arrangement::point(int strand, int i) const {
  return idx(network_->points.offsets[idx(strand)] + i % point_count(strand));
}

double Arrangement::reach_px(int strand) const {
  const Vec2& start = image_of(strand, 0);
  double reach = 0;
  for (int i = 1; i < point_count(strand); ++i) {
    reach = std::max(reach, (image_of(strand, i) - start).norm());
  }
  return reach;
}

Vec2 Arrangement::image_at(const StrandPlace& place) const {
  const Vec2& a = image_of(place.strand, place.segment);
  const Vec2& b = image_of(place.strand, place.segment + 1);
  return a + place.fraction * (b - a);
}

Vec3 Arrangement::decided_at(const StrandPlace& place) const {
  if (image_.decided.empty()) return world_at(place);
  const std::size_t i = point(place.strand, place.segment);
  const std::size_t j = point(place.strand, place.segment + 1);
  const double f =
      world_fraction(place.fraction, image_.depth[i], image_.depth[j], image_.perspective);
  return image_.decided[i] + f * (image_.decided[j] - image_.decided[i]);
}

Vec3 Arrangement::world_at(const StrandPlace& place) const {
  const std::size_t i = point(place.strand, place.segment);
  const std::size_t j = point(place.strand, place.segment + 1);
  const Vec3 &a = network_->points.values[i].position, &b = network_->points.values[j].position;
  const double f =
      world_fraction(place.fraction, image_.depth[i], image_.depth[j], image_.perspective);
  return a + f * (b - a);
}

Arrangement arrange(const CurveNetwork& network, const Camera& camera) {
  return *arrange(network, camera, std::numeric_limits<std::size_t>::max());
}

std::optional<Arrangement> arrange(const CurveNetwork& network, const Camera& camera,
                                   std::size_t most, Points decided,
                                   const std::vector<ImageSegment>& cuts) {
  Arrangement result(network);
  result.image_ = project_strands(network, camera, std::move(decided));
  std::optional<std::vector<Crossing>> crossings = find_crossings(network, result.image_, most);
  if (!crossings) return {};
  result.crossings_ = std::move(*crossings);
  result.states_.assign(result.crossings_.size(), CrossingState::live);
  result.paths_ = PathFinder(network).run();
  const Eigen::AlignedBox2d frame(Vec2::Zero(), Vec2(camera.width_px(), camera.height_px()));
  result.outline_.resize(network.strands.size());
  if (!has_open_silhouette(network, camera)) {
    result.outline_ = outline_places(network, result.image_, frame, cuts);
  }
  result.visits_ = sorted_visits(result.crossings_, network.strands.size());
  return result;
}

Arrangement arrange_apart(const CurveNetwork& network, const Camera& camera) {
  Arrangement result(network);
  result.image_ = project_strands(network, camera);
  for (int s = 0; s < static_cast<int>(network.strands.size()); ++s) {
    result.paths_.push_back({{s}, {0}, network.strands[idx(s)].closed(), {0}});
  }
  result.outline_.resize(network.strands.size());
  result.visits_.resize(network.strands.size());
  return result;
}

std::vector<int> paths_of_strands(const Arrangement& arrangement) {
  std::vector<int> paths(arrangement.network().strands.size(), none);
  for (std::size_t p = 0; p < arrangement.paths().size(); ++p) {
    for (const int strand : arrangement.paths()[p].strands)
      paths[idx(strand)] = static_cast<int>(p);
  }
  return paths;
}

std::vector<std::uint8_t> nodes_under_cover(const CurveNetwork& network) {
  std::vector<std::uint8_t> result(network.nodes.size(), 0);
  for (const Strand& s : network.strands) {
    if (!is_under_cover(s.sight) || s.closed()) continue;
    result[idx(s.start_node)] = result[idx(s.end_node)] = 1;
  }
  return result;
}

int back_change(const Arrangement& arrangement, const Crossing& crossing) {
  const Strand& front = arrangement.strand(crossing.front.strand);
  const int to_left = front.left_layers - front.right_layers;
  return crossing.enters_left ? to_left : -to_left;
}

}  // namespace illustrate
