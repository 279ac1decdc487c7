// Strands, their crossings in order, and the paths along which quantitative invisibility is a
// potential.
#pragma once

#include "visibility/arrangement/crossings.h"

namespace illustrate {

// What has become of a crossing: repaired away, or demoted to a joint of its back strand, where
// rays alone say what changes.
enum class CrossingState : std::uint8_t { live, dropped, demoted };

// One passage of a strand through a crossing.
struct Visit {
  int crossing;
  bool front;
  StrandPlace place;
};

// Strands tied one after another, each by a known change: a potential runs along them.
struct Path {
  std::vector<int> strands;
  std::vector<int>
      jumps;  // change of invisibility on entering strands[i]; [0] only counts when cyclic
  bool cyclic = false;                 // also a single closed strand
  std::vector<std::uint8_t> is_joint;  // 1: no cusp any more at the start of strands[i]
};

struct Arrangement {
  const CurveNetwork* network = nullptr;
  ImageStrands image;
  std::vector<Crossing> crossings;
  std::vector<CrossingState> states;  // (crossings)
  std::vector<Path> paths;
  std::vector<std::vector<StrandPlace>> outline;  // per strand: outline.h
  std::vector<std::vector<Visit>> visits;         // per strand, in order, of what is left

  // Must be called after `states` have changed: takes away the visits of what is dropped, and of
  // the front strand of what is demoted.
  void forget_visits();

  // Image and world points of a strand's place.
  Vec2 image_at(const StrandPlace& place) const;
  Vec3 world_at(const StrandPlace& place) const;
  Vec3 decided_at(const StrandPlace& place) const;  // of ImageStrands::decided
  // Index into network->points.values of point i of a strand, cyclic for closed ones.
  std::size_t point(int strand, int i) const;
  int point_count(int strand) const;
  // How far in the image a strand gets from where it starts.
  double reach_px(int strand) const;
  std::int64_t live_crossings() const;
  std::int64_t loops() const;  // closed paths
  bool is_live(int crossing) const { return states[idx(crossing)] == CrossingState::live; }
};

// `network` must outlive the result.
Arrangement arrange(const CurveNetwork& network, const Camera& camera);
// Nothing where there are more crossings than `most`. `decided`: as of project_strands.
std::optional<Arrangement> arrange(const CurveNetwork& network, const Camera& camera,
                                   std::size_t most, Points decided = {});
// Strands that cross nothing and follow nothing.
Arrangement arrange_apart(const CurveNetwork& network, const Camera& camera);

// (strands) the path that each belongs to.
std::vector<int> paths_of_strands(const Arrangement& arrangement);

inline bool is_under_cover(Sight sight) {
  return sight == Sight::covered || sight == Sight::buried;
}

// (nodes) 1 where a strand ends that is under cover: what else ends there is so too.
std::vector<std::uint8_t> nodes_under_cover(const CurveNetwork& network);

// Change of invisibility of the back strand at a crossing, in its direction.
int back_change(const Arrangement& arrangement, const Crossing& crossing);

}  // namespace illustrate
