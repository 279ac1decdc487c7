#include "mesh/sanitize.h"

#include <algorithm>

#include "mesh/clean.h"
#include "mesh/edges.h"
#include "mesh/faces.h"
#include "mesh/gaps.h"
#include "mesh/junctions.h"
#include "mesh/memory_order.h"
#include "mesh/orient.h"
#include "mesh/split.h"

namespace illustrate {
namespace {

void name_counts(Counts& report) {
  for (const char* name : {"input_faces",      "kept_faces",      "nan_faces",
                           "degenerate_faces", "huge_faces",      "nan_vertices",
                           "repeated_corners", "duplicate_faces", "split_faces",
                           "junctions",        "welded_vertices", "closed_gaps",
                           "split_edges",      "flipped_faces",   "isolated_vertices",
                           "split_vertices",   "turned_parts",    "covered_parts",
                           "ignored_creases",  "ignored_marks",   "angle_creases",
                           "breaks",           "normal_creases",  "lone_bends",
                           "crease_tails",     "fine_bends",      "tips",
                           "corners",          "empty_meshes",    "parts",
                           "polygons",         "open_edges"})
    report[name] += 0;
}

void set_vertices(const PolygonMesh& mesh, std::vector<int> sources, SoundMesh& sound) {
  sound.source_vertices = std::move(sources);
  sound.positions.reserve(sound.source_vertices.size());
  for (const int source : sound.source_vertices) sound.positions.push_back(mesh.positions[source]);
}

void set_faces(const PolygonMesh& mesh, const Faces& faces, SoundMesh& sound) {
  std::vector<std::uint8_t> is_hole(mesh.face_sizes.size(), 0);
  for (const int face : mesh.hole_faces) is_hole[face] = 1;
  for (int f = 0; f < faces.size(); ++f) {
    const int source = faces.sources[f];
    sound.face_sizes.push_back(static_cast<int>(faces[f].size()));
    sound.face_materials.push_back(mesh.face_materials.empty() ? 0 : mesh.face_materials[source]);
    sound.holes.push_back(is_hole[source]);
  }
  sound.corner_vertices = faces.corners;
  sound.source_faces = faces.sources;
}

// Twins follow the faces they are made of, and those are drawn.
void set_twins(const Faces& faces, std::vector<int> twins, SoundMesh& sound) {
  sound.twin_faces = std::move(twins);
  sound.twin_vertices.assign(sound.positions.size(), none);
  for (int f = 0; f < faces.size(); ++f) {
    const int twin = sound.twin_faces[f];
    sound.kept.push_back(twin == none || f < twin);
    if (twin == none) continue;
    const auto face = faces[f], other = faces[twin];
    for (std::size_t k = 0; k < face.size(); ++k)
      sound.twin_vertices[face[k]] = other[face.size() - 1 - k];
  }
}

// What is left, on one sheet.
void count_faces(const SoundMesh& sound, Counts& report) {
  std::int64_t kept = 0, polygons = 0;
  int last_source = none;
  for (std::size_t f = 0; f < sound.face_sizes.size(); ++f) {
    if (sound.kept[f] == 0) continue;
    kept += sound.source_faces[f] != last_source;
    polygons += sound.face_sizes[f] > 4;
    last_source = sound.source_faces[f];
  }
  report["kept_faces"] += kept;
  report["polygons"] += polygons;
  report["empty_meshes"] += sound.face_sizes.empty();
}

// Copies beyond one for each vertex, on one sheet.
std::int64_t count_split(const SoundMesh& sound) {
  std::int64_t copies = 0;
  for (std::size_t v = 1; v < sound.source_vertices.size(); ++v)
    copies += sound.source_vertices[v] == sound.source_vertices[v - 1];
  const auto on_both_sheets =
      static_cast<std::ptrdiff_t>(sound.twin_vertices.size()) -
      std::count(sound.twin_vertices.begin(), sound.twin_vertices.end(), none);
  return copies - on_both_sheets / 2;
}

// Those of a surface that was triangulated patch by patch.
void join_patches(const PolygonMesh& mesh, Faces& faces, std::vector<int>& numbers,
                  Counts& report) {
  BorderEdges open(mesh, faces, numbers);
  if (divide_at_junctions(mesh.positions, open, faces, report))
    open = BorderEdges(mesh, faces, numbers);
  close_gaps(mesh.positions, open, faces, numbers, report);
}

}  // namespace

SoundMesh sanitize(const PolygonMesh& mesh, Counts& report, const Progress& progress) {
  validate(mesh);
  name_counts(report);
  report["input_faces"] += static_cast<std::int64_t>(mesh.face_sizes.size());
  progress.report(0);
  Faces faces = clean_faces(mesh, report);
  // Before faces are joined, so that what is welded is joined like any other edge.
  std::vector<int> numbers = weld_open_edges(faces, mesh.positions, report);
  if (!mesh.cage) {
    join_patches(mesh, faces, numbers, report);
    collapse_edges(mesh.positions, faces, numbers, report);
  }
  progress.report(0.25);
  FaceAdjacency adjacency = join_faces(faces, mesh.positions, report);
  progress.report(0.5);
  const std::vector<std::uint8_t> is_covered = orient(faces, adjacency, mesh.positions, report);
  std::vector<int> twins = add_double_cover(faces, adjacency, is_covered);

  progress.report(0.75);
  SoundMesh sound;
  // Only now: fans can be walked round where windings agree, which the double cover sees to.
  set_vertices(mesh, split_vertices(faces, adjacency, mesh.positions.size()), sound);
  set_faces(mesh, faces, sound);
  set_twins(faces, std::move(twins), sound);
  count_faces(sound, report);
  report["split_vertices"] += count_split(sound);
  carry_edges(mesh, faces, adjacency.is_cut, numbers, sound, report);
  sound.cage = mesh.cage;
  // The corners of what is no cage were found by their angles; OpenSubdiv is not to add those where
  // a single face ends.
  sound.boundary = mesh.cage ? mesh.boundary : BoundaryRule::edges;
  sound.scheme = mesh.scheme;
  sound.level = mesh.level;
  sound.edge_length = mesh.edge_length;
  sound.name = mesh.name;
  order_for_memory(sound);
  return sound;
}

}  // namespace illustrate
