#include "pipeline/prepare.h"

#include <utility>

#include "field/joined_field.h"
#include "pipeline/same_input.h"
#include "pipeline/stopwatch.h"
#include "surface/same_objects.h"

namespace illustrate {
namespace {

// Triangles whose search without field takes less than half a second, so that the first drawing
// need not wait for it.
constexpr std::size_t most_searched_at_once = 500000;

PrepareOptions with_threads(PrepareOptions options) {
  options.surface.threads = options.jet.threads = options.cross_field.threads = options.threads;
  return options;
}

}  // namespace

template <class Make>
auto Prepared::timed(const char* stage, Make&& make) const {
  struct Addition {
    const Prepared& prepared;
    const char* stage;
    const Stopwatch watch{};
    // Also where `make` throws: what was cancelled took its time too.
    ~Addition() {
      const std::lock_guard<std::mutex> lock(prepared.timings_mutex_);
      prepared.timings_[stage] += watch.seconds();
    }
  };
  const Addition addition{*this, stage};
  return make();
}

Prepared::Prepared(const std::vector<MeshPointer>& meshes, const PrepareOptions& options,
                   const Prepared* previous, const Progress& progress)
    : options_(with_threads(options)),
      meshes_(meshes),
      curvature_(std::make_shared<Lazy<Curvature>>()),
      placed_curvature_(std::make_shared<Lazy<Curvature>>()),
      field_(std::make_shared<Lazy<CrossField>>()),
      placed_field_(std::make_shared<Lazy<CrossField>>()),
      families_(std::make_shared<Lazy<Families>>()),
      placed_families_(std::make_shared<Lazy<Families>>()),
      diagonal_families_(std::make_shared<Lazy<Families>>()),
      placed_diagonal_families_(std::make_shared<Lazy<Families>>()),
      hatch_curves_(std::make_shared<Lazy<std::unique_ptr<ObjectCurves>>>()),
      derivative_(std::make_shared<Lazy<CurvatureDerivative>>()) {
  timings_ = {{"sanitize", 0}, {"surface", 0},       {"dual_surface", 0}, {"curvature", 0},
              {"field", 0},    {"intersections", 0}, {"hatch_curves", 0}};
  if (previous && previous->has_surface_of(meshes, options)) {
    take_over(*previous);
  } else {
    const bool is_alike = previous && is_same(options.surface, previous->options_.surface);
    make_geometry(meshes, is_alike ? &previous->geometry_->originals : nullptr,
                  progress.part(0, options.field ? 0.4 : 0.7));
  }
  if (previous && previous->field_ != field_) follow(*previous);
  first_areas_ = triangle_areas(surface());
  if (previous) keep_first_areas(*previous);
  const bool searches = options.field || surface().triangles.size() <= most_searched_at_once;
  if (searches) search(progress.part(options.field ? 0.4 : 0.7, options.field ? 0.6 : 1));
  if (options.field) {
    hatch_curvature(progress.part(0.6, 0.7));
    field(progress.part(0.7, 1));
  }
}

bool Prepared::has_surface_of(const std::vector<MeshPointer>& meshes,
                              const PrepareOptions& options) const {
  if (meshes.size() != object_count() || !is_same(options.surface, options_.surface)) return false;
  if (options.most_intersections != options_.most_intersections) return false;
  const std::vector<MeshPointer>& last = geometry_->originals.objects;
  return std::equal(
      meshes.begin(), meshes.end(), last.begin(),
      [](const MeshPointer& mesh, const MeshPointer& before) { return is_same(*mesh, *before); });
}

void Prepared::keep_first_areas(const Prepared& previous) {
  // Seeds of hatches are dealt by area: with those of the first frame they stay where they are on a
  // mesh that stretches.
  if (geometry_ == previous.geometry_) {
    first_areas_ = previous.first_areas_;
    return;
  }
  const SameObjects same(previous.surface(), surface(), geometry_->originals.last_objects);
  for (std::size_t t = 0; t < first_areas_.size(); ++t) {
    const int last = same.last_triangle(t);
    if (last != none) first_areas_[t] = previous.first_areas_[idx(last)];
  }
}

void Prepared::take_over(const Prepared& previous) {
  // What follows depends on what precedes: curvature on the surface, the field on curvature,
  // families and curves on the field.
  geometry_ = previous.geometry_;
  if (!is_same(options_.jet, previous.options_.jet)) return;
  curvature_ = previous.curvature_;
  last_curvature_.hold(previous.last_curvature_.get());
  placed_curvature_ = previous.placed_curvature_;
  derivative_ = previous.derivative_;
  if (!is_same(options_.cross_field, previous.options_.cross_field)) return;
  field_ = previous.field_;
  last_field_.hold(previous.last_field_.get());
  placed_field_ = previous.placed_field_;
  families_ = previous.families_;
  last_families_.hold(previous.last_families_.get());
  placed_families_ = previous.placed_families_;
  diagonal_families_ = previous.diagonal_families_;
  last_diagonal_families_.hold(previous.last_diagonal_families_.get());
  placed_diagonal_families_ = previous.placed_diagonal_families_;
  hatch_curves_ = previous.hatch_curves_;
}

// Of what was solved last, the originals, where both fields are on originals.
EarlierObjects Prepared::earlier_of(const Prepared& previous, const LastFrame* before) const {
  if (needs_tree(options_.cross_field) || needs_tree(previous.options_.cross_field)) return {};
  const bool is_new = geometry_ != previous.geometry_;
  const EarlierObjects& now = geometry_->originals.earlier;
  if (!before) return is_new ? now : EarlierObjects();
  if (!is_new || before->earlier.empty()) return before->earlier;
  return now.empty() ? now : composed(now, before->earlier);
}

// The last frame, or where that one did without a field, the last before it that had one: lines
// alone are drawn while something is dragged.
void Prepared::follow(const Prepared& previous) {
  // In this order: it may be solved meanwhile, and lets go of the frame then.
  std::shared_ptr<const LastFrame> before = previous.last_field_.get();
  const bool is_solved = previous.field_->peek() != nullptr;
  if (is_solved) before = nullptr;
  auto frame = std::make_shared<LastFrame>();
  frame->surface = before ? before->surface : previous.solved_surface();
  frame->curvature = before ? before->curvature : previous.curvature_;
  if (before || is_solved) frame->field = before ? before->field : previous.field_;
  frame->families = before ? before->families : previous.families_;
  frame->diagonal_families = before ? before->diagonal_families : previous.diagonal_families_;
  frame->earlier = earlier_of(previous, before.get());
  frame->holds = keeps_any(frame->earlier) && (!before || before->holds) &&
                 is_same(options_.jet, previous.options_.jet) &&
                 is_same(options_.cross_field, previous.options_.cross_field);
  if (frame->holds && frame->curvature->peek()) last_curvature_.hold(frame);
  if (!frame->field) return;
  last_field_.hold(frame);
  last_families_.hold(frame);
  if (frame->holds) last_diagonal_families_.hold(frame);
}

// The surface of all objects, and its size and levels in the report.
void Prepared::place_originals(Geometry& geometry) {
  const Originals& originals = geometry.originals;
  geometry.surface = originals.surface;
  originals.report(geometry.counts);
  if (originals.instances.are_trivial) return;
  geometry.surface = std::make_shared<const Surface>(
      joined({originals.surface.get()}, originals.instances.sources()));
  const Surface& surface = *geometry.surface;
  geometry.counts["triangles"] = static_cast<std::int64_t>(surface.triangles.size());
  geometry.counts["vertices"] = static_cast<std::int64_t>(surface.positions.size());
  for (std::size_t o = 0; o < surface.controls.size(); ++o) {
    geometry.counts["level_" + std::to_string(o)] =
        originals.each[idx(originals.instances.originals[o])].level;
  }
}

void Prepared::make_geometry(const std::vector<MeshPointer>& meshes, const Originals* last,
                             const Progress& progress) {
  auto geometry = std::make_shared<Geometry>();
  Originals& originals = geometry->originals;
  std::vector<SoundMesh> sound = timed("sanitize", [&] {
    originals = find_originals(meshes, options_.surface, last);
    return sanitize_fresh(originals, progress.part(0, 0.1, "sanitize"));
  });
  const Progress surface_progress = progress.part(0.1, 1, "surface");
  timed("surface", [&] {
    refine_fresh(originals, std::move(sound), options_.surface, last, surface_progress);
    place_originals(*geometry);
    geometry->limit_surface.emplace(*geometry->surface);
    geometry->features = feature_edges(*geometry->surface);
  });
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    const int original = originals.instances.originals[i];
    geometry->mesh_reports.push_back({meshes[i]->name, originals.each[idx(original)].mended});
  }
  surface_progress.report(1);
  geometry_ = std::move(geometry);
}

const Prepared::Search& Prepared::search(const Progress& progress) const {
  return geometry_->search.get([&] {
    const Progress trees = progress.part(0, 0.4, "surface");
    Bvh bvh = timed("surface", [&] {
      return Bvh(surface().positions, surface().triangles, options_.threads, trees.part(0, 0.5));
    });
    DualSurface dual_surface = timed("dual_surface", [&] {
      return DualSurface(surface(), options_.threads, trees.part(0.5, 1));
    });
    Search made{std::move(bvh), std::move(dual_surface), {}, {}};
    timed("intersections", [&] {
      made.intersections = illustrate::intersections(surface(), made.bvh, made.counts,
                                                     progress.part(0.4, 1, "intersections"),
                                                     options_.most_intersections);
    });
    return made;
  });
}

Counts Prepared::report() const {
  Counts report = geometry_->counts;
  for (const auto& [name, count] : search().counts) report[name] += count;
  return report;
}

const Curvature& Prepared::curvature_of_originals(const Progress& progress) const {
  return curvature_->get([&] {
    const auto made_on = [&](const Surface& surface) {
      return jet_curvature(surface, options_.jet, progress.part(0, 1, "curvature"));
    };
    return timed("curvature", [&] {
      const std::shared_ptr<const LastFrame> last = last_curvature_.get();
      if (!last) return made_on(originals());
      const Curvature fresh = made_on(last->fresh_surface(originals()));
      last_curvature_.release();
      return last->renewed(*last->curvature->peek(), fresh, originals());
    });
  });
}

const Curvature& Prepared::hatch_curvature(const Progress& progress) const {
  const Curvature& curvature = curvature_of_originals(progress);
  const Instances& instances = geometry_->originals.instances;
  if (instances.are_trivial) return curvature;
  return placed_curvature_->get(
      [&] { return joined({&curvature}, {&originals()}, instances.sources()); });
}

// What guides the field is in the world, and not the same for two objects that share a surface.
bool Prepared::shares_field() const {
  return !geometry_->originals.instances.are_trivial && !needs_tree(options_.cross_field);
}

const CrossField& Prepared::field(const Progress& progress) const {
  const CrossField& field = field_->get([&] { return solve_field(progress); });
  if (!shares_field()) return field;
  return placed_field_->get(
      [&] { return joined({&field}, {&originals()}, geometry_->originals.instances.sources()); });
}

CrossField Prepared::solve_on(const Surface& surface, const Curvature& curvature, FieldAids aids,
                              const Progress& progress) const {
  const bool is_shared = shares_field();
  aids.objects_share_space = !is_shared;
  if (needs_tree(options_.cross_field)) aids.bvh = &bvh();
  return timed("field", [&] {
    return solve_cross_field(surface, curvature, options_.cross_field, aids, progress);
  });
}

CrossField Prepared::solve_field(const Progress& progress) const {
  const Progress before = progress.part(0, 0.2), search = progress.part(0.2, 1, "field");
  const Curvature& curvature =
      shares_field() ? curvature_of_originals(before) : hatch_curvature(before);
  const std::shared_ptr<const LastFrame> last = last_field_.get();
  FieldAids aids;
  if (last) {
    aids.last_surface = last->surface.get();
    aids.last_field = last->field->peek();
    aids.last_objects = last->last_objects();
  }
  CrossField solved;
  if (last && last->holds) {
    const Surface& fresh_surface = last->fresh_surface(originals());
    const Curvature fresh_curvature = last->of_fresh(curvature, originals());
    const CrossField fresh = solve_on(fresh_surface, fresh_curvature, std::move(aids), search);
    solved = last->renewed(*last->field->peek(), fresh, originals());
    solved.evaluations = fresh.evaluations;
  } else {
    solved = solve_on(*solved_surface(), curvature, std::move(aids), search);
  }
  last_field_.release();
  return solved;
}

Families Prepared::label_on(const Surface& surface, const Curvature& curvature,
                            const CrossField& field, bool of_diagonals, const LastFamilies& last,
                            const Progress& progress) const {
  const int threads = options_.threads;
  if (!of_diagonals) return find_families(surface, curvature, field, last, threads, progress);
  return find_families(surface, curvature, diagonals(surface, field), {}, threads, progress);
}

Families Prepared::label_families(bool of_diagonals, const Progress& progress) const {
  field(progress.part(0, 0.5));
  const Curvature& curvature = shares_field() ? curvature_of_originals({}) : hatch_curvature();
  const CrossField& solved = *field_->peek();
  const Progress labels = progress.part(0.5, 1, "field");
  auto& last_found = of_diagonals ? last_diagonal_families_ : last_families_;
  const std::shared_ptr<const LastFrame> last = last_found.get();
  LastFamilies before;
  if (last) {
    const auto& made = of_diagonals ? last->diagonal_families : last->families;
    before = {last->surface.get(), last->field->peek(), made->peek(), last->last_objects()};
  }
  Families found = timed("field", [&] {
    if (!before.families || !last->holds) {
      return label_on(*solved_surface(), curvature, solved, of_diagonals, before, labels);
    }
    const Families fresh =
        label_on(last->fresh_surface(originals()), last->of_fresh(curvature, originals()),
                 last->of_fresh(solved, originals()), of_diagonals, before, labels);
    return last->renewed(*before.families, fresh, originals());
  });
  last_found.release();
  // What no drawing of the last frame has asked for is seldom wanted of this one.
  if (last && !last->diagonal_families->peek()) last_diagonal_families_.release();
  return found;
}

const Families& Prepared::placed_families(Lazy<Families>& solved, Lazy<Families>& placed_ones,
                                          bool of_diagonals, const Progress& progress) const {
  const Families& found = solved.get([&] { return label_families(of_diagonals, progress); });
  if (!shares_field()) return found;
  return placed_ones.get(
      [&] { return joined({&found}, {&originals()}, geometry_->originals.instances.sources()); });
}

const Families& Prepared::families(const Progress& progress) const {
  return placed_families(*families_, *placed_families_, false, progress);
}

const Families& Prepared::diagonal_families(const Progress& progress) const {
  return placed_families(*diagonal_families_, *placed_diagonal_families_, true, progress);
}

CurvesOfObjects Prepared::hatch_curves(const std::vector<double>& radii,
                                       const std::vector<std::uint8_t>& seeds_only,
                                       const Progress& progress) const {
  const auto& curves = hatch_curves_->get([&] {
    const CrossField& cross_field = field(progress.part(0, 0.5));
    if (shares_field()) {
      return std::make_unique<ObjectCurves>(originals(), *field_->peek(),
                                            geometry_->originals.instances, first_areas_);
    }
    return std::make_unique<ObjectCurves>(surface(), cross_field, first_areas_);
  });
  const Progress curve_progress = progress.part(0.5, 1, "hatch curves");
  return timed("hatch_curves", [&] {
    return curves->down_to(radii, seeds_only, options_.threads, curve_progress);
  });
}

const CurvatureDerivative& Prepared::curvature_derivative(const Progress& progress) const {
  return derivative_->get([&] {
    const Curvature& curvature = hatch_curvature(progress.part(0, 0.7));
    return timed("curvature", [&] {
      return illustrate::curvature_derivative(surface(), curvature, options_.threads,
                                              progress.part(0.7, 1, "curvature"));
    });
  });
}

Timings Prepared::timings() const {
  const std::lock_guard<std::mutex> lock(timings_mutex_);
  return timings_;
}

std::shared_ptr<const Prepared> prepare(const std::vector<MeshPointer>& meshes,
                                        const PrepareOptions& options, const Prepared* previous,
                                        const Progress& progress) {
  validate(options);
  return std::make_shared<const Prepared>(meshes, options, previous, progress);
}

}  // namespace illustrate
