#include "hatch/streamlines/place_curves.h"

#include <algorithm>
#include <cmath>

namespace illustrate {
namespace {

// In node steps: nearer points of a curve are left out, farther ones get others between.
constexpr double least_gap = 0.7;
constexpr double most_curve_gap = 1.6;

// No drawing needs more between two points of a curve.
constexpr double most_between = 1000;

class CurvePlacer {
 public:
  CurvePlacer(StreamlineSet& set, const HatchView& view, const PlaceRules& rules)
      : set_(set), view_(view), surface_(view.walker.on_surface().surface()), rules_(rules) {}

  void place(Span<const SurfacePoint> curve) {
    if (curve.size() < 2) return;
    object_ = surface_.object_of(curve[0].triangle);
    if (!view_.is_hatched(object_)) return;
    spacing_ = view_.spacing_on(curve[0].triangle);
    run_.clear();
    for (std::size_t i = 0; i < curve.size(); ++i) {
      view_.walker.fetch_ahead(curve, i);
      const bool is_last = i + 1 == curve.size();
      if (!enter(curve[i], is_last ? nullptr : &curve[i + 1])) place_run();
    }
    place_run();
  }

 private:
  // A point with where it is seen.
  struct Place {
    SurfacePoint on;
    Vec3 position;
    Vec2 image;
    double facing;
    bool is_held;
    bool is_seen = false;  // known when its run is placed
  };

  static HatchPoint point(const Place& p) { return {p.position, p.on, p.image}; }

  bool project(const SurfacePoint& on, Place& place) const {
    place.on = on;
    place.position = position_at(surface_, on);
    const Vec3 h = apply(view_.walker.map(), place.position);
    if (!(h[2] > 0)) return false;
    place.image = h.head<2>() / h[2];
    place.facing = view_.walker.facing_at(on);
    place.is_held = rules_.holds && view_.rests(place.image);
    if (place.is_held) return true;
    return view_.area.is_in_frame({place.position, on, place.image}) && place.facing != 0;
  }

  // Takes a point into the run; false where the run ends before it or with it.
  bool enter(const SurfacePoint& on, const SurfacePoint* next) {
    Place place;
    if (!project(on, place)) return false;
    if (!run_.empty()) {
      const double gap = (place.image - run_.back().image).norm() / (spacing_ * node_step);
      if (gap < least_gap && next && !place.is_held) return true;
      if (gap > most_curve_gap && !(place.is_held && run_.back().is_held)) {
        add_between(place, std::min(std::ceil(gap), most_between));
      }
      if (!run_.empty() && !joins(place)) place_run();
    }
    run_.push_back(place);
    return true;
  }

  bool joins(const Place& place) const {
    if (place.is_held && run_.back().is_held) return true;
    return place.facing * run_.back().facing > 0 &&
           !view_.curves.separate(run_.back().image, place.image);
  }

  void add_between(const Place& end, double parts) {
    SurfacePoint on = run_.back().on;
    Vec3 tangent = end.position - run_.back().position;
    const double step = tangent.norm() / parts;
    for (double k = 1; k < parts; ++k) {
      const Vec3 rest = end.position - position_at(surface_, on);
      const FieldWalker& walker = view_.walker.on_surface();
      const bool goes_on = rules_.straight ? walker.slide(on, rest / (parts - k + 1))
                                           : walker.advance(on, tangent, step) == 0;
      Place place;
      if (!goes_on) return;
      if (!project(on, place)) return place_run();
      if (!run_.empty() && !joins(place)) place_run();
      run_.push_back(place);
    }
  }

  // What lies between two critical curves is seen or hidden as a whole.
  void place_run() {
    std::size_t seen = 0;
    for (Place& place : run_)
      seen += place.is_seen = place.is_held || view_.area.is_seen(point(place));
    if (run_.size() > 1 && 2 * seen > run_.size()) {
      for (std::size_t i = 0; i < run_.size(); ++i) {
        const std::size_t other = i + 1 < run_.size() ? i + 1 : i - 1;
        const double way = i + 1 < run_.size() ? 1 : -1;
        try_node(run_[i], way * (run_[other].position - run_[i].position));
      }
      finish();
    }
    run_.clear();
  }

  void try_node(const Place& place, const Vec3& towards) {
    if (!place.is_seen) return finish();
    StreamlineNode node = view_.node(place.on, towards);
    node.is_held = place.is_held;
    if (!node.is_held && !has_room(place, node)) return finish();
    is_clear_ = is_clear_ || node.is_held;
    streamline_.nodes.push_back(node);
  }

  // Takes note where it is clear, too.
  bool has_room(const Place& place, const StreamlineNode& node) {
    if (!view_.is_wanted(point(place)) || !view_.runs_well(node, spacing_)) return false;
    const double distance = view_.nearest(set_.grid, node, spacing_, rules_.clear * spacing_);
    is_clear_ = is_clear_ || distance >= std::max(rules_.clear, rules_.test) * spacing_;
    return distance >= rules_.test * spacing_;
  }

  void finish() {
    const std::vector<StreamlineNode>& nodes = streamline_.nodes;
    const bool is_long = length_of(nodes) >= rules_.least_length * spacing_;
    if (is_clear_ && (is_long || any_is_held(nodes))) {
      streamline_.object = object_;
      streamline_.spacing = spacing_;
      set_.add(std::move(streamline_));
    }
    streamline_ = {};
    is_clear_ = false;
  }

  StreamlineSet& set_;
  const HatchView& view_;
  const Surface& surface_;
  const PlaceRules& rules_;
  int object_ = none;
  double spacing_ = 1;
  std::vector<Place> run_;
  Streamline streamline_;
  bool is_clear_ = false;
};

}  // namespace

void place_curves(StreamlineSet& set, const HatchView& view, const Ragged<SurfacePoint>& curves,
                  const PlaceRules& rules, const Progress& progress) {
  CurvePlacer placer(set, view, rules);
  for (std::size_t c = 0; c < curves.size(); ++c) {
    if (c % 128 == 0) progress.report(static_cast<double>(c) / static_cast<double>(curves.size()));
    placer.place(curves[c]);
  }
}

}  // namespace illustrate
