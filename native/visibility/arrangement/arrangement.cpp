#include "visibility/arrangement/arrangement.h"

#include <algorithm>
#include <tuple>

#include "visibility/evidence/outline.h"

namespace illustrate {
namespace {

bool runs_before(const Visit& a, const Visit& b) {
  return std::tie(a.place.segment, a.place.fraction, a.crossing, a.front) <
         std::tie(b.place.segment, b.place.fraction, b.crossing, b.front);
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
    for (const bool open : {true, false}) {
      for (std::size_t s = 0; s < network_.strands.size(); ++s) {
        if (!used_[s] && (!open || previous_[s] == none))
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

std::vector<std::vector<Visit>> sorted_visits(const Arrangement& arrangement) {
  std::vector<std::vector<Visit>> visits(arrangement.network->strands.size());
  for (std::size_t c = 0; c < arrangement.crossings.size(); ++c) {
    const Crossing& x = arrangement.crossings[c];
    visits[idx(x.front.strand)].push_back({static_cast<int>(c), true, x.front});
    visits[idx(x.back.strand)].push_back({static_cast<int>(c), false, x.back});
  }
  for (std::vector<Visit>& list : visits) std::sort(list.begin(), list.end(), runs_before);
  return visits;
}

}  // namespace

void Arrangement::forget_visits() {
  const auto is_gone = [&](const Visit& visit) {
    const CrossingState state = states[idx(visit.crossing)];
    return state == CrossingState::dropped || (state == CrossingState::demoted && visit.front);
  };
  for (std::vector<Visit>& list : visits) {
    list.erase(std::remove_if(list.begin(), list.end(), is_gone), list.end());
  }
}

std::int64_t Arrangement::live_crossings() const {
  return std::count(states.begin(), states.end(), CrossingState::live);
}

std::int64_t Arrangement::loops() const {
  return std::count_if(paths.begin(), paths.end(), [](const Path& path) { return path.cyclic; });
}

int Arrangement::point_count(int strand) const {
  return network->points.offsets[idx(strand) + 1] - network->points.offsets[idx(strand)];
}

std::size_t Arrangement::point(int strand, int i) const {
  return idx(network->points.offsets[idx(strand)] + i % point_count(strand));
}

double Arrangement::reach_px(int strand) const {
  const Vec2& start = image.image[point(strand, 0)];
  double reach = 0;
  for (int i = 1; i < point_count(strand); ++i) {
    reach = std::max(reach, (image.image[point(strand, i)] - start).norm());
  }
  return reach;
}

Vec2 Arrangement::image_at(const StrandPlace& place) const {
  const Vec2& a = image.image[point(place.strand, place.segment)];
  const Vec2& b = image.image[point(place.strand, place.segment + 1)];
  return a + place.fraction * (b - a);
}

Vec3 Arrangement::decided_at(const StrandPlace& place) const {
  if (image.decided.empty()) return world_at(place);
  const std::size_t i = point(place.strand, place.segment);
  const std::size_t j = point(place.strand, place.segment + 1);
  const double f =
      world_fraction(place.fraction, image.depth[i], image.depth[j], image.perspective);
  return image.decided[i] + f * (image.decided[j] - image.decided[i]);
}

Vec3 Arrangement::world_at(const StrandPlace& place) const {
  const std::size_t i = point(place.strand, place.segment);
  const std::size_t j = point(place.strand, place.segment + 1);
  const Vec3 &a = network->points.values[i].position, &b = network->points.values[j].position;
  const double f =
      world_fraction(place.fraction, image.depth[i], image.depth[j], image.perspective);
  return a + f * (b - a);
}

Arrangement arrange(const CurveNetwork& network, const Camera& camera) {
  return *arrange(network, camera, std::numeric_limits<std::size_t>::max());
}

std::optional<Arrangement> arrange(const CurveNetwork& network, const Camera& camera,
                                   std::size_t most, Points decided) {
  Arrangement result;
  result.network = &network;
  result.image = project_strands(network, camera, std::move(decided));
  std::optional<std::vector<Crossing>> crossings = find_crossings(network, result.image, most);
  if (!crossings) return {};
  result.crossings = std::move(*crossings);
  result.states.assign(result.crossings.size(), CrossingState::live);
  result.paths = PathFinder(network).run();
  result.outline = outline_places(network, result.image);
  result.visits = sorted_visits(result);
  return result;
}

Arrangement arrange_apart(const CurveNetwork& network, const Camera& camera) {
  Arrangement result;
  result.network = &network;
  result.image = project_strands(network, camera);
  for (int s = 0; s < static_cast<int>(network.strands.size()); ++s) {
    result.paths.push_back({{s}, {0}, network.strands[idx(s)].closed(), {0}});
  }
  result.visits.resize(network.strands.size());
  return result;
}

std::vector<int> paths_of_strands(const Arrangement& arrangement) {
  std::vector<int> paths(arrangement.visits.size(), none);
  for (std::size_t p = 0; p < arrangement.paths.size(); ++p) {
    for (const int strand : arrangement.paths[p].strands) paths[idx(strand)] = static_cast<int>(p);
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
  const Strand& front = arrangement.network->strands[idx(crossing.front.strand)];
  const int to_left = front.left_layers - front.right_layers;
  return crossing.enters_left ? to_left : -to_left;
}

}  // namespace illustrate
