#include "surface/refine.h"

#include <algorithm>

#include "control/choose_scheme.h"
#include "control/keep_to_mesh.h"
#include "control/split_faces.h"
#include "control/straight_creases.h"
#include "surface/edges.h"
#include "surface/jets/curvature.h"
#include "surface/jets/jet.h"
#include "surface/limit/lay_on_arcs.h"
#include "surface/planes/flat_faces.h"
#include "surface/planes/folded_normals.h"
#include "surface/planes/plane_faces.h"
#include "surface/subdivision/assemble.h"
#include "surface/subdivision/child_corners.h"

namespace illustrate {
namespace {

// Sectors of the faces of level 0 that are no patches: those of the same corners on level 1.
std::vector<int> sectors_of_parents(const RefinedMesh& parent, const Sectors& sectors) {
  std::vector<int> result(parent.corner_count());
  for (std::size_t c = 0; c < result.size(); ++c) {
    result[c] = sectors.corner_sectors[idx(child_corner(parent, static_cast<int>(c)))];
  }
  return result;
}

// Appends meshes to one surface.
class Refiner {
 public:
  Refiner(Surface& surface, std::vector<int>& needs_jet, const SurfaceOptions& options)
      : surface_(surface), needs_jet_(needs_jet), options_(options) {}

  // Returns the level that was made.
  int add(SoundMesh mesh, const ArcFaces& arcs, Scheme scheme, int level,
          const Progress& progress) {
    ControlMesh control{std::move(mesh), scheme, level, 0, {}};
    if (scheme == Scheme::polygons || !add_subdivided(control, arcs, progress)) {
      add_polygons(control.mesh, progress);
      control.scheme = Scheme::polygons;
      control.level = 0;
    }
    const auto shared = std::make_shared<const ControlMesh>(std::move(control));
    surface_.controls.push_back({shared, next_ptex_face_, {}});
    next_ptex_face_ += shared->ptex_faces;
    return shared->level;
  }

 private:
  void add_polygons(const SoundMesh& base, const Progress& progress) {
    const RefinedMesh mesh = polygonal_mesh(base, options_.threads);
    progress.report(.3);
    const Sectors sectors = smooth_sectors(mesh);
    SectorLimits limits = polygonal_limits(mesh, sectors, options_.threads);
    progress.report(.6);
    surface_.object_is_smooth.push_back(0);
    assemble({base, mesh, sectors.corner_sectors, std::move(limits), {}, {}, next_object_++, 0},
             options_.threads, surface_, needs_jet_);
  }

  bool add_subdivided(ControlMesh& control, const ArcFaces& arcs, const Progress& progress) {
    const SoundMesh& base = control.mesh;
    const Scheme scheme = control.scheme;
    const int level = control.level;
    const bool all_patches =
        scheme == Scheme::loop || std::all_of(base.face_sizes.begin(), base.face_sizes.end(),
                                              [](int size) { return size == 4; });
    // The masks of Catmull-Clark's limit are those of quads: where there are other faces the limit
    // is taken one level down, where all are quads.
    const int limit_level = level == 0 && !all_patches ? 1 : level;
    const Subdivision subdivision(base, scheme, limit_level, options_.threads,
                                  progress.part(0, .55));
    if (!subdivision.is_valid()) return false;
    const RefinedMesh& mesh = subdivision.level(limit_level);
    progress.report(.55);
    const Sectors sectors = smooth_sectors(mesh);
    progress.report(.6);
    SectorLimits vertices =
        limits(subdivision, mesh, sectors, limit_level, options_.threads, progress.part(.6, .8));
    progress.report(.8);
    surface_.object_is_smooth.push_back(1);
    const int object = next_object_++, ptex = next_ptex_face_;
    control.ptex_faces = subdivision.ptex_faces();
    const RefinedMesh& drawn = subdivision.level(level);
    const std::vector<int> of_parents =
        limit_level == level ? std::vector<int>() : sectors_of_parents(drawn, sectors);
    const std::vector<int>& corner_sectors =
        limit_level == level ? sectors.corner_sectors : of_parents;
    std::vector<std::uint8_t> unfolded;
    if (level > 0) {
      unfolded = unfold_flat_faces(subdivision.level(0), drawn, corner_sectors, options_.threads,
                                   vertices);
      turn_folded_normals(subdivision.level(0), drawn, corner_sectors, vertices.normals);
    }
    control.off_limit = lay_on_arcs(base, arcs, mesh, sectors, options_.threads, vertices);
    assemble({base, drawn, corner_sectors, std::move(vertices), unfolded, control.off_limit, object,
              ptex},
             options_.threads, surface_, needs_jet_);
    return true;
  }

  Surface& surface_;
  std::vector<int>& needs_jet_;
  const SurfaceOptions& options_;
  int next_object_ = 0;
  int next_ptex_face_ = 0;
};

// Puts the control mesh that keeps to it in the place of a mesh that is no cage. That one is split
// once: the level is one less, so that there are as many triangles. What is drawn at level 0 by
// choice of the edge's length has edges so short along bends that the cage's limit is as good.
bool keep_if_no_cage(SoundMesh& mesh, ArcFaces& arcs, Scheme scheme, int& level,
                     const Progress& progress) {
  if (mesh.cage || scheme == Scheme::polygons || level == 0) return false;
  std::optional<KeptMesh> kept = keep_to_mesh(mesh, scheme, {}, progress);
  if (!kept) return false;
  mesh = std::move(kept->mesh);
  arcs = std::move(kept->arcs);
  --level;
  return true;
}

}  // namespace

std::vector<LevelWish> level_wishes(std::vector<SoundMesh>& meshes, const SurfaceOptions& options) {
  std::vector<Scheme> schemes;
  bool is_asked = false;
  for (SoundMesh& mesh : meshes) {
    schemes.push_back(choose_scheme(mesh, options.scheme));
    if (schemes.back() == Scheme::loop) mesh = split_into_triangles(std::move(mesh));
    is_asked = is_asked || goes_by_the_scene(options, mesh.level, mesh.edge_length);
  }
  const double usual = is_asked ? usual_edge_length(meshes) : options.edge_length;
  std::vector<LevelWish> wishes;
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    wishes.push_back(level_wish(meshes[i], schemes[i], options, usual));
  }
  return wishes;
}

Refined refine_to(std::vector<SoundMesh> meshes, const std::vector<LevelWish>& wishes,
                  const std::vector<int>& levels, const SurfaceOptions& options,
                  const Progress& progress) {
  Refined refined;
  Surface& surface = refined.surface;
  std::vector<int> needs_jet;
  Refiner refiner(surface, needs_jet, options);
  const auto count = static_cast<double>(meshes.size());
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    const auto done = static_cast<double>(i);
    const Progress part = progress.part(.9 * done / count, .9 * (done + 1) / count);
    const std::vector<PlaneFace> planes = find_plane_faces(
        meshes[i], static_cast<int>(i), static_cast<int>(surface.planes.size()), options.threads);
    surface.planes.insert(surface.planes.end(), planes.begin(), planes.end());
    if (!meshes[i].cage) hold_straight_creases(meshes[i]);
    ArcFaces arcs;
    int level = levels[i];
    const Scheme scheme = wishes[i].scheme;
    const bool is_split = keep_if_no_cage(meshes[i], arcs, scheme, level, part.part(0, .2));
    refined.levels.push_back(
        refiner.add(std::move(meshes[i]), arcs, scheme, level, part.part(.2, 1)) + is_split);
  }
  progress.report(.9);
  measure_diagonals(surface);
  mark_flat_outlines(surface, options.threads);
  collect_feature_edges(surface);
  fit_jets(surface, needs_jet, {JetOptions().rings, options.threads}, progress.part(.95, 1),
           surface.curvature);
  return refined;
}

void report_refined(const Surface& surface, const std::vector<LevelWish>& wishes,
                    const std::vector<int>& levels, Counts& report) {
  report["not_subdivided"] = 0;
  for (std::size_t i = 0; i < levels.size(); ++i) {
    report["level_" + std::to_string(i)] = levels[i];
    const bool is_wanted = wishes[i].scheme != Scheme::polygons;
    report["not_subdivided"] += is_wanted && !surface.object_is_smooth[i] ? 1 : 0;
  }
  report["triangles"] = static_cast<std::int64_t>(surface.triangles.size());
  report["vertices"] = static_cast<std::int64_t>(surface.positions.size());
}

Surface refine(std::vector<SoundMesh> meshes, const SurfaceOptions& options, Counts& report,
               const Progress& progress) {
  validate(options);
  progress.report(0);
  const std::vector<LevelWish> wishes = level_wishes(meshes, options);
  Refined refined = refine_to(std::move(meshes), wishes,
                              choose_levels(wishes, options.triangle_budget), options, progress);
  report_refined(refined.surface, wishes, refined.levels, report);
  return std::move(refined.surface);
}

}  // namespace illustrate
