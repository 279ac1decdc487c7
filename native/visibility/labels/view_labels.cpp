#include "visibility/labels/view_labels.h"

#include <algorithm>
#include <cmath>

#include "visibility/prices.h"
namespace illustrate {
namespace {

std::int64_t as_price(double px) { return std::llround(px * price_of_pixel); }

double change_price(double extent) {
  return std::clamp(prices.per_px * extent, prices.least_change, prices.greatest_change);
}
double cover_price(double extent) {
  return std::clamp(prices.per_px * extent, prices.least_cover, prices.greatest_cover);
}

// Where one arc of a path follows another: what changes there by rule.
struct Transition {
  enum class At : std::uint8_t { nothing, crossing, cusp } at = At::nothing;
  int crossing = none;
  int step = none;  // of the path, for a cusp
  int change = 0;
};

// Whether two labels that follow each other do not change as they must.
bool is_broken(const Transition& t, int before, int behind) {
  return t.at != Transition::At::nothing && behind - before != t.change;
}

Transition transition_into(const Arrangement& arrangement, const Path& path, const PathArc& arc) {
  if (arc.begin != none) {
    const Visit& visit = arrangement.visits(arc.strand)[idx(arc.begin)];
    if (visit.front) return {};
    const Crossing& crossing = arrangement.crossing(visit.crossing);
    return {Transition::At::crossing, visit.crossing, none, back_change(arrangement, crossing)};
  }
  const int jump = path.jumps[idx(arc.step)];
  if (jump == 0 || (arc.step == 0 && !path.cyclic)) return {};
  return {Transition::At::cusp, none, arc.step, jump};
}

// Layers that the front strand of a crossing adds where the back strand comes from and where it
// goes, less those that it adds on both sides.
std::array<int, 2> layers_hidden(const Arrangement& arrangement, const Crossing& crossing) {
  const Strand& front = arrangement.strand(crossing.front.strand);
  std::array<int, 2> layers{front.right_layers, front.left_layers};
  if (!crossing.enters_left) std::swap(layers[0], layers[1]);
  const int both = std::min(layers[0], layers[1]);
  return {layers[0] - both, layers[1] - both};
}

// The unknowns on both sides of every crossing's back strand, and that of its front strand.
struct CrossingUnknowns {
  int front = none, in = none, out = none;
};

// Calls visit(path, arc before, arc, transition) for every two arcs that follow each other.
template <class Visit>
void for_each_transition(const Arrangement& arrangement,
                         const std::vector<std::vector<PathArc>>& arcs, const Visit& visit) {
  for (std::size_t p = 0; p < arcs.size(); ++p) {
    const Path& path = arrangement.paths()[p];
    const std::size_t count = arcs[p].size();
    for (std::size_t i = path.cyclic ? 0 : 1; i < count; ++i) {
      visit(p, i == 0 ? count - 1 : i - 1, i, transition_into(arrangement, path, arcs[p][i]));
    }
  }
}

std::vector<CrossingUnknowns> unknowns_at_crossings(const Arrangement& arrangement,
                                                    const std::vector<std::vector<PathArc>>& arcs,
                                                    const std::vector<std::vector<int>>& unknowns) {
  std::vector<CrossingUnknowns> result(arrangement.crossings().size());
  for (std::size_t p = 0; p < arcs.size(); ++p) {
    for (std::size_t i = 0; i < arcs[p].size(); ++i) {
      const PathArc& arc = arcs[p][i];
      const auto enter = [&](int visit, int CrossingUnknowns::*const behind) {
        if (visit == none) return;
        const Visit& v = arrangement.visits(arc.strand)[idx(visit)];
        result[idx(v.crossing)].*(v.front ? &CrossingUnknowns::front : behind) = unknowns[p][i];
      };
      enter(arc.begin, &CrossingUnknowns::out);
      enter(arc.end, &CrossingUnknowns::in);
    }
  }
  return result;
}

class Statement {
 public:
  Statement(const Arrangement& arrangement, const std::vector<std::vector<PathArc>>& arcs)
      : arrangement_(arrangement), arcs_(arcs), extents_(extents(arrangement, arcs)) {}

  ViewProblem run(const std::vector<std::vector<Evidence>>& evidence) {
    for (std::size_t p = 0; p < arcs_.size(); ++p) number(arrangement_.paths()[p], arcs_[p]);
    for (std::size_t p = 0; p < arcs_.size(); ++p) ask_what_rays_say(p, evidence[p]);
    ask_for_changes();
    ask_for_cover();
    return std::move(view_);
  }

 private:
  // An arc that nothing divides from the one before has its unknown; balanced paths are no one
  // unknown: where false changes cancel, that would lift their outlines.
  void number(const Path& path, const std::vector<PathArc>& arcs) {
    std::vector<int> numbers;
    for (std::size_t i = 0; i < arcs.size(); ++i) {
      const bool goes_on =
          i > 0 && transition_into(arrangement_, path, arcs[i]).at == Transition::At::nothing;
      numbers.push_back(goes_on ? numbers.back() : view_.problem.unknowns++);
    }
    if (path.cyclic && !arcs.empty() && numbers.back() != numbers.front() &&
        transition_into(arrangement_, path, arcs.front()).at == Transition::At::nothing) {
      const int last = numbers.back(), first = numbers.front();
      std::replace(numbers.begin(), numbers.end(), last, first);
      --view_.problem.unknowns;
    }
    view_.unknowns.push_back(std::move(numbers));
  }

  // Labels start at what the last ray said, and change as they must.
  void ask_what_rays_say(std::size_t p, const std::vector<Evidence>& evidence) {
    view_.start.resize(idx(view_.problem.unknowns), 0);
    view_.at_least.resize(idx(view_.problem.unknowns), 0);
    int label = 0;
    for (std::size_t i = 0; i < evidence.size(); ++i) {
      const Evidence& e = evidence[i];
      const int unknown = view_.unknowns[p][i];
      label += transition_into(arrangement_, arrangement_.paths()[p], arcs_[p][i]).change;
      if (e.weight > 0) {
        label = e.layers;
        if (e.unsure == any_more) view_.at_least[idx(unknown)] = 1;
        view_.problem.values.push_back({unknown, e.layers, e.layers + e.unsure, as_price(e.weight),
                                        as_price(missed_share(e) * e.weight)});
        if (e.layers > 0)
          view_.problem.values.push_back(
              {unknown, 1, any_more, as_price(prices.shown_share * e.weight), 0});
      }
      view_.start[idx(unknown)] = label = std::max(label, 0);
    }
  }

  void ask_for_changes() {
    for_each_transition(
        arrangement_, arcs_,
        [&](std::size_t p, std::size_t before, std::size_t i, const Transition& t) {
          if (t.at == Transition::At::nothing) return;
          const double extent = t.at == Transition::At::cusp ? extents_.cusps[p][idx(t.step)]
                                                             : extents_.crossings[idx(t.crossing)];
          const std::int64_t price = as_price(change_price(extent));
          add({view_.unknowns[p][before], view_.unknowns[p][i], t.change, price, price});
        });
  }

  void ask_for_cover() {
    const std::vector<CrossingUnknowns> at =
        unknowns_at_crossings(arrangement_, arcs_, view_.unknowns);
    for (std::size_t c = 0; c < at.size(); ++c) {
      if (!arrangement_.is_live(static_cast<int>(c))) continue;
      if (view_.at_least[idx(at[c].front)] || arrangement_.crossings()[c].at_corner) continue;
      const auto [in, out] = layers_hidden(arrangement_, arrangement_.crossings()[c]);
      const std::int64_t price = as_price(cover_price(extents_.crossings[c]) / 2);
      add({at[c].front, at[c].in, in, price, 0});
      add({at[c].front, at[c].out, out, price, 0});
    }
  }

  // Of one unknown with itself nothing can be asked.
  void add(const DifferenceTerm& term) {
    if (term.from != term.to) view_.problem.differences.push_back(term);
  }

  const Arrangement& arrangement_;
  const std::vector<std::vector<PathArc>>& arcs_;
  Extents extents_;
  ViewProblem view_;
};

// Carries labels over to the arcs that are left when crossings have been demoted: each begins where
// one of the old ones did.
class Relabelling {
 public:
  Relabelling(const Arrangement& arrangement, const std::vector<PathArc>& arcs) {
    for (const PathArc& arc : arcs) begins_.push_back(begin_of(arrangement, arc));
  }

  LabelledPath run(const Arrangement& arrangement, const Path& path,
                   const std::vector<int>& layers) const {
    LabelledPath result{path_arcs(arrangement, path), {}};
    std::size_t old = 0;
    for (const PathArc& arc : result.arcs) {
      const std::size_t found = find(begin_of(arrangement, arc), old);
      if (found < begins_.size()) old = found;
      result.layers.push_back(layers[found < begins_.size() ? found : first_on(arc.strand)]);
    }
    return result;
  }

 private:
  using Begin = std::array<int, 3>;  // strand, crossing or none, whether in front there

  static Begin begin_of(const Arrangement& arrangement, const PathArc& arc) {
    if (arc.begin == none) return {arc.strand, none, 0};
    const Visit& visit = arrangement.visits(arc.strand)[idx(arc.begin)];
    return {arc.strand, visit.crossing, visit.front};
  }

  std::size_t find(const Begin& begin, std::size_t from) const {
    const auto first = begins_.begin() + static_cast<std::ptrdiff_t>(from);
    return static_cast<std::size_t>(std::find(first, begins_.end(), begin) - begins_.begin());
  }

  // A closed strand that has lost all its visits, which were in front: it had one label.
  std::size_t first_on(int strand) const {
    const auto found = std::find_if(begins_.begin(), begins_.end(),
                                    [&](const Begin& begin) { return begin[0] == strand; });
    return static_cast<std::size_t>(found - begins_.begin());
  }

  std::vector<Begin> begins_;
};

// Demotes what labels contradict. How many of these are repairs: not those where it was not asked
// that the back strand has as much in front as the front strand has.
class GiveWay {
 public:
  GiveWay(Arrangement& arrangement, const ViewProblem& view, const std::vector<int>& labels)
      : arrangement_(arrangement),
        view_(view),
        labels_(labels),
        is_demoted_(arrangement.crossings().size(), 0) {}

  std::int64_t run(const std::vector<std::vector<PathArc>>& arcs) {
    check_cover(unknowns_at_crossings(arrangement_, arcs, view_.unknowns));
    check_changes(arcs);
    std::vector<int> demoted;
    for (std::size_t c = 0; c < is_demoted_.size(); ++c) {
      if (is_demoted_[c]) demoted.push_back(static_cast<int>(c));
    }
    arrangement_.demote(demoted);
    return repairs_;
  }

 private:
  int label(int unknown) const { return labels_[idx(unknown)]; }

  void check_cover(const std::vector<CrossingUnknowns>& at) {
    for (int c = 0; c < static_cast<int>(at.size()); ++c) {
      if (!arrangement_.is_live(c)) continue;
      const CrossingUnknowns& unknowns = at[idx(c)];
      const auto [in, out] = layers_hidden(arrangement_, arrangement_.crossing(c));
      const int front = label(unknowns.front);
      if (label(unknowns.in) >= front + in && label(unknowns.out) >= front + out) continue;
      is_demoted_[idx(c)] = 1;
      const bool is_asked =
          !view_.at_least[idx(unknowns.front)] && !arrangement_.crossing(c).at_corner;
      repairs_ += is_asked ? 1 : 0;
    }
  }

  void check_changes(const std::vector<std::vector<PathArc>>& arcs) {
    for_each_transition(arrangement_, arcs,
                        [&](std::size_t p, std::size_t before, std::size_t i, const Transition& t) {
                          const std::vector<int>& unknowns = view_.unknowns[p];
                          if (!is_broken(t, label(unknowns[before]), label(unknowns[i]))) return;
                          if (t.at == Transition::At::cusp) {
                            arrangement_.make_joint(static_cast<int>(p), t.step);
                            ++repairs_;
                          } else if (!is_demoted_[idx(t.crossing)]) {
                            is_demoted_[idx(t.crossing)] = 1;
                            ++repairs_;
                          }
                        });
  }

  Arrangement& arrangement_;
  const ViewProblem& view_;
  const std::vector<int>& labels_;
  std::vector<std::uint8_t> is_demoted_;  // (crossings)
  std::int64_t repairs_ = 0;
};

}  // namespace

ViewProblem state_labels(const Arrangement& arrangement,
                         const std::vector<std::vector<PathArc>>& arcs,
                         const std::vector<std::vector<Evidence>>& evidence) {
  return Statement(arrangement, arcs).run(evidence);
}

std::vector<int> contradicted_paths(const Arrangement& arrangement,
                                    const std::vector<std::vector<PathArc>>& arcs,
                                    const ViewProblem& view, const std::vector<int>& labels) {
  std::vector<int> paths;
  for_each_transition(arrangement, arcs,
                      [&](std::size_t p, std::size_t before, std::size_t i, const Transition& t) {
                        const std::vector<int>& unknowns = view.unknowns[p];
                        if (!is_broken(t, labels[idx(unknowns[before])], labels[idx(unknowns[i])]))
                          return;
                        if (paths.empty() || paths.back() != static_cast<int>(p))
                          paths.push_back(static_cast<int>(p));
                      });
  return paths;
}

std::vector<LabelledPath> settle_labels(Arrangement& arrangement,
                                        const std::vector<std::vector<PathArc>>& arcs,
                                        const ViewProblem& view, const std::vector<int>& labels,
                                        std::int64_t& repairs) {
  std::vector<Relabelling> relabellings;
  for (const std::vector<PathArc>& path : arcs) relabellings.emplace_back(arrangement, path);
  repairs += GiveWay(arrangement, view, labels).run(arcs);
  std::vector<LabelledPath> result;
  for (std::size_t p = 0; p < arcs.size(); ++p) {
    std::vector<int> layers;
    for (const int unknown : view.unknowns[p]) layers.push_back(labels[idx(unknown)]);
    result.push_back(relabellings[p].run(arrangement, arrangement.paths()[p], layers));
  }
  return result;
}

}  // namespace illustrate
