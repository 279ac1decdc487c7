// Strands, their crossings in order, and the paths along which quantitative invisibility is a
// potential.
#pragma once

#include "core/direction.h"
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
  double decided;  // fraction of the segment where that was decided: visits are in this order
};

// Strands tied one after another, each by a known change: a potential runs along them.
struct Path {
  std::vector<int> strands;
  std::vector<int>
      jumps;  // change of invisibility on entering strands[i]; [0] only counts when cyclic
  bool cyclic = false;                 // also a single closed strand
  std::vector<std::uint8_t> is_joint;  // 1: no cusp any more at the start of strands[i]
};

// Made by `arrange`. What repairs and labels take back later is taken back everywhere at once:
// whoever holds a visit's number must not do so between.
class Arrangement {
 public:
  const CurveNetwork& network() const { return *network_; }
  const ImageStrands& image() const { return image_; }
  const std::vector<Crossing>& crossings() const { return crossings_; }
  const std::vector<Path>& paths() const { return paths_; }
  const Strand& strand(int strand) const { return network_->strands[idx(strand)]; }
  const Crossing& crossing(int crossing) const { return crossings_[idx(crossing)]; }
  CrossingState state(int crossing) const { return states_[idx(crossing)]; }
  bool is_live(int crossing) const { return state(crossing) == CrossingState::live; }
  // Of a strand, in order, of what is left.
  const std::vector<Visit>& visits(int strand) const { return visits_[idx(strand)]; }
  // Of a strand: outline.h.
  const std::vector<StrandPlace>& outline(int strand) const { return outline_[idx(strand)]; }

  // Image and world points of a strand's place.
  Vec2 image_at(const StrandPlace& place) const;
  Vec3 world_at(const StrandPlace& place) const;
  Vec3 decided_at(const StrandPlace& place) const;  // of ImageStrands::decided
  // Index into network().points.values of point i of a strand, cyclic for closed ones.
  std::size_t point(int strand, int i) const;
  int point_count(int strand) const;
  const Vec2& image_of(int strand, int i) const { return image_.image[point(strand, i)]; }
  // How far in the image a strand gets from where it starts.
  double reach_px(int strand) const;
  std::int64_t live_crossings() const;
  std::int64_t loops() const;  // closed paths

  // Crossings that are none: their visits go.
  void drop(const std::vector<int>& crossings);
  // Crossings that become joints of their back strands: the visits of the front strands go.
  void demote(const std::vector<int>& crossings);
  // At the start of a path's strand: nothing changes there any more; the contrary does; no cusp is
  // there any more.
  void drop_jump(int path, int step);
  void turn_jump(int path, int step);
  void make_joint(int path, int step);
  // Draws point i of a strand elsewhere; what is decided stays decided.
  void move_point(int strand, int i, const Vec2& image);

 private:
  explicit Arrangement(const CurveNetwork& network) : network_(&network) {}
  friend Arrangement arrange_apart(const CurveNetwork& network, const Camera& camera);
  friend std::optional<Arrangement> arrange(const CurveNetwork& network, const Camera& camera,
                                            std::size_t most, Points decided,
                                            const std::vector<ImageSegment>& cuts);

  void forget_visits(const std::vector<int>& crossings);

  const CurveNetwork* network_;
  ImageStrands image_;
  std::vector<Crossing> crossings_;
  std::vector<CrossingState> states_;  // (crossings)
  std::vector<Path> paths_;
  std::vector<std::vector<StrandPlace>> outline_;  // (strands)
  std::vector<std::vector<Visit>> visits_;         // (strands)
};

// `network` must outlive the result.
Arrangement arrange(const CurveNetwork& network, const Camera& camera);
// Nothing where there are more crossings than `most`. `decided`: as of project_strands, `cuts`: as
// of outline_places.
std::optional<Arrangement> arrange(const CurveNetwork& network, const Camera& camera,
                                   std::size_t most, Points decided = {},
                                   const std::vector<ImageSegment>& cuts = {});
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
