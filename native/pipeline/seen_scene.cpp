#include "pipeline/seen_scene.h"

#include <algorithm>

#include "core/keep_elements.h"

namespace illustrate {
namespace {

// (triangles) the number of each triangle once those of ignored objects are gone; none for these.
std::vector<int> numbers_without_ignored(const Surface& whole,
                                         const std::vector<ObjectStyle>& styles) {
  std::vector<int> numbers;
  int next = 0;
  for (const int object : whole.triangle_objects) {
    numbers.push_back(styles[idx(object)].ignore ? none : next++);
  }
  return numbers;
}

Surface surface_of(const Surface& whole, const std::vector<int>& sources,
                   const std::vector<int>& numbers, const std::vector<ObjectStyle>& styles) {
  Surface part = whole;
  keep_elements(part.triangles, sources);
  keep_elements(part.flips, sources);
  keep_elements(part.patches, sources);
  keep_elements(part.neighbours, sources);
  keep_elements(part.edge_kinds, sources);
  keep_elements(part.triangle_objects, sources);
  keep_elements(part.triangle_planes, sources);
  keep_elements(part.triangle_faces, sources);
  for (auto& neighbours : part.neighbours) {
    for (int& n : neighbours) n = n == none ? none : numbers[idx(n)];
  }
  part.feature_edges.clear();
  part.feature_kinds.clear();
  for (std::size_t e = 0; e < whole.feature_edges.size(); ++e) {
    if (styles[idx(whole.objects[idx(whole.feature_edges[e][0])])].ignore) continue;
    part.feature_edges.push_back(whole.feature_edges[e]);
    part.feature_kinds.push_back(whole.feature_kinds[e]);
  }
  return part;
}

// A curve stays while both surfaces that meet in it do, and so do flush triangles.
IntersectionCurves intersections_of(const IntersectionCurves& whole,
                                    const std::vector<int>& numbers,
                                    const std::vector<ObjectStyle>& styles) {
  IntersectionCurves part;
  part.insets = whole.insets;
  for (const ObjectPair& pair : whole.left_out) {
    if (!styles[idx(pair[0])].ignore && !styles[idx(pair[1])].ignore) part.left_out.push_back(pair);
  }
  const auto number = [&](int t) { return t == none ? none : numbers[idx(t)]; };
  part.reach = whole.reach;
  part.one_plane = whole.one_plane;
  for (FlushTriangles pair : whole.flush_triangles) {
    for (int& triangle : pair.triangles) triangle = number(triangle);
    if (pair.triangles[0] != none && pair.triangles[1] != none)
      part.flush_triangles.push_back(pair);
  }
  for (std::size_t c = 0; c < whole.curves.size(); ++c) {
    const Span<const IntersectionPoint> curve = whole.curves[c];
    const bool stays = std::all_of(curve.begin(), curve.end(), [&](const auto& p) {
      return number(p.a.triangle) != none && number(p.b.triangle) != none;
    });
    if (!stays) continue;
    const auto first = idx(whole.curves.offsets[c]);
    for (std::size_t i = 0; i < curve.size(); ++i) {
      IntersectionPoint p = curve[i];
      p.a.triangle = number(p.a.triangle);
      p.b.triangle = number(p.b.triangle);
      part.curves.push(p);
      const auto& pair = whole.segment_triangles[first + i];
      part.segment_triangles.push_back({number(pair[0]), number(pair[1])});
    }
    part.curves.close_list();
    part.closed.push_back(whole.closed[c]);
  }
  return part;
}

}  // namespace

SeenScene::SeenScene(const Prepared& prepared, const std::vector<ObjectStyle>& styles, int threads,
                     const Progress& progress)
    : prepared_(prepared), threads_(threads) {
  const IntersectionCurves& whole_intersections = prepared.intersections(progress);
  const bool is_whole = std::none_of(styles.begin(), styles.end(),
                                     [](const ObjectStyle& style) { return style.ignore; });
  if (is_whole) return;
  std::vector<int> numbers = numbers_without_ignored(prepared.surface(), styles);
  part_ = std::make_unique<Part>();
  for (std::size_t t = 0; t < numbers.size(); ++t) {
    if (numbers[t] != none) part_->sources.push_back(static_cast<int>(t));
  }
  part_->surface = surface_of(prepared.surface(), part_->sources, numbers, styles);
  part_->bvh = Bvh(part_->surface.positions, part_->surface.triangles, threads);
  part_->features = feature_edges(part_->surface);
  part_->intersections = intersections_of(whole_intersections, numbers, styles);
  complete(part_->surface, part_->intersections, progress);
  part_->numbers = std::move(numbers);
}

// Of an object that is seen.
SurfaceCurves SeenScene::renumbered(const CurvesOfObject& whole) const {
  SurfaceCurves part{whole.curves(), whole.scale * whole.shared->step, whole.seeds(), whole.area(),
                     whole.shared->needed_below};
  for (double& radius : part.needed_below) radius *= whole.scale;
  for (SurfacePoint& on : part.curves.values) on.triangle = part_->numbers[idx(on.triangle)];
  for (SurfacePoint& on : part.seeds) on.triangle = part_->numbers[idx(on.triangle)];
  return part;
}

SeenCurves SeenScene::hatch_curves(const std::vector<double>& radii,
                                   const std::vector<std::uint8_t>& seeds_only,
                                   const Progress& progress) const {
  SeenCurves curves;
  curves.of_objects = prepared_.hatch_curves(radii, seeds_only, progress);
  if (!part_) return curves;
  for (const CurvesOfObject& whole : curves.of_objects) {
    curves.own.push_back(whole ? renumbered(whole) : SurfaceCurves{});
  }
  for (std::size_t i = 0; i < curves.own.size(); ++i) {
    if (curves.of_objects[i]) curves.of_objects[i] = {&curves.own[i]};
  }
  return curves;
}

Ragged<SurfacePoint> SeenScene::seen_parts(const Ragged<SurfacePoint>& curves) const {
  if (!part_) return curves;
  Ragged<SurfacePoint> parts;
  const auto close = [&] {
    if (static_cast<int>(parts.values.size()) > parts.offsets.back()) parts.close_list();
  };
  for (std::size_t c = 0; c < curves.size(); ++c) {
    for (const SurfacePoint& on : curves[c]) {
      const int triangle = part_->numbers[idx(on.triangle)];
      // A curve comes apart where it runs over what is ignored.
      if (triangle == none) close();
      if (triangle != none) parts.push({triangle, on.b1, on.b2});
    }
    close();
  }
  return parts;
}

std::vector<int> SeenScene::triangles_in(const SeenScene& other) const {
  std::vector<int> numbers(surface().triangles.size());
  for (std::size_t t = 0; t < numbers.size(); ++t) {
    const int whole = part_ ? part_->sources[t] : static_cast<int>(t);
    numbers[t] = other.part_ ? other.part_->numbers[idx(whole)] : whole;
  }
  return numbers;
}

void SeenScene::restore_triangles(std::vector<SurfacePoint>& points) const {
  if (!part_) return;
  for (SurfacePoint& p : points) {
    if (p.triangle != none) p.triangle = part_->sources[idx(p.triangle)];
  }
}

}  // namespace illustrate
