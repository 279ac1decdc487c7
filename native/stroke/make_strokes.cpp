#include "stroke/make_strokes.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/errors.h"
#include "stroke/chains.h"
#include "stroke/continued_ends.h"
#include "stroke/crowded_lines.h"
#include "stroke/even_widths.h"
#include "stroke/pen_parts.h"
#include "stroke/specks.h"
#include "stroke/stroke_path.h"

namespace illustrate {
namespace {

// A stroke with what it says of itself.
struct Stroke {
  StrokePath path;
  Kind kind;
  int object;
  int invisibility;
  int pen = 0;
};

// How far round a place lines crowd it: so many of their widths, or units of the paper.
constexpr double crowding_reach = 6;

// Length over which a line that goes on grows from one weight to another.
constexpr double weight_blend_units = 16;

double scale_of(const std::vector<double>& width_scale, int object) {
  return width_scale.empty() || object == none ? 1.0 : width_scale[idx(object)];
}

double line_width(const GraphArc& arc, const std::vector<double>& width_scale,
                  const StrokeOptions& options) {
  const bool is_outline = arc.kind == Kind::silhouette || arc.kind == Kind::boundary;
  const double width = is_outline ? options.line_width_px : options.feature_width_px;
  const double hidden = layers_over(arc) > 0 ? options.hidden_width_scale : 1.0;
  return width * hidden * scale_of(width_scale, arc.object);
}

// The points of the chain's arcs, those that arcs share at a node once, or with weights for each of
// them. weights: of the arcs' points, empty: all 1.
std::vector<StrokePoint> points_of(const LabelledGraph& graph, const Chain& chain, double width,
                                   const Ragged<double>& weights) {
  std::vector<StrokePoint> points;
  for (std::size_t i = 0; i < chain.arcs.size(); ++i) {
    const Span<const CurvePoint> curve = graph.points[idx(chain.arcs[i])];
    const Span<const Vec2> image = graph.image[idx(chain.arcs[i])];
    for (std::size_t k = 0; k < curve.size(); ++k) {
      const std::size_t p = chain.reversed[i] ? curve.size() - 1 - k : k;
      const bool is_shared = i > 0 && k == 0 && points.back().image == image[p];
      if (is_shared && weights.empty()) continue;
      const double weight = weights.empty() ? 1 : weights[idx(chain.arcs[i])][p];
      points.push_back({curve[p].position, curve[p].on, image[p], width * weight});
    }
  }
  const bool repeats_first = chain.closed && points.front().image == points.back().image;
  if (repeats_first) points.pop_back();
  return points;
}

// An end is free where no other line that is drawn comes to its node. A loose edge that ends at a
// joint goes on behind what hides it.
bool is_free(const LabelledGraph& graph, const Ragged<ArcEnd>& ends, const Chain& chain, int node) {
  if (chain.closed || ends[idx(node)].size() != 1) return false;
  const bool is_loose = graph.arcs[idx(chain.arcs[0])].kind == Kind::loose;
  return !is_loose || graph.nodes[idx(node)].kind == NodeKind::end;
}

// What lines become beside each other. Visible lines, and hidden ones, run on in each other, and
// crowd each other, alone.
void finish_together(std::vector<Stroke>& strokes, const StrokeOptions& options, double unit_px,
                     const Camera& camera) {
  const double reach = crowding_reach * std::max(options.line_width_px, unit_px);
  for (const bool hidden : {false, true}) {
    std::vector<StrokePath> paths;
    std::vector<Stroke*> owners;
    for (Stroke& stroke : strokes) {
      if ((stroke.invisibility > 0) != hidden) continue;
      paths.push_back(std::move(stroke.path));
      owners.push_back(&stroke);
    }
    keep_continued_ends(paths, options.taper_px, unit_px);
    thin_where_crowded(paths, reach, options.width_by_crowding, camera);
    for (std::size_t i = 0; i < owners.size(); ++i) owners[i]->path = std::move(paths[i]);
  }
}

std::vector<Stroke> line_strokes(const LabelledGraph& graph, const Ragged<double>& weights,
                                 const std::vector<double>& width_scale,
                                 const std::vector<std::uint8_t>& undrawn, const Camera& camera,
                                 const StrokeOptions& options) {
  const std::vector<std::uint8_t> drawn = drawn_arcs(graph, undrawn, options);
  const Ragged<ArcEnd> ends = ends_at_nodes(graph, drawn);
  const std::vector<Chain> chains = chain_arcs(graph, drawn, ends, options.speck_px);
  const auto kept = chains_without_specks(graph, chains, ends, options.speck_px);
  std::vector<Stroke> strokes;
  for (std::size_t c = 0; c < chains.size(); ++c) {
    if (!kept[c]) continue;
    const Chain& chain = chains[c];
    const GraphArc& arc = graph.arcs[idx(chain.arcs[0])];
    StrokePath path;
    path.points = points_of(graph, chain, line_width(arc, width_scale, options), weights);
    path.closed = chain.closed;
    path.free_start = is_free(graph, ends, chain, chain.start_node);
    path.free_end = is_free(graph, ends, chain, chain.end_node);
    if (weights.empty()) {
      strokes.push_back({std::move(path), arc.kind, arc.object, layers_over(arc)});
      continue;
    }
    for (const StrokePath& part : parts_with_width(path, options.speck_px)) {
      strokes.push_back({with_even_widths(part, weight_blend_units * graph.unit_px, camera),
                         arc.kind, arc.object, layers_over(arc)});
    }
  }
  finish_together(strokes, options, graph.unit_px, camera);
  return strokes;
}

// How much thicker (1, in the dark) or thinner (-1, at the highlights) than usual a hatch is: it
// changes evenly with the light within either level, and is 0 where shadow and midtone meet.
double swelling(double light, const ToneMap& tone) {
  const double shadow = tone.shadow_threshold, highlight = tone.highlight_threshold;
  if (light <= shadow) return shadow > 0 ? 1 - light / shadow : 1;
  return highlight > shadow ? -std::min(1.0, (light - shadow) / (highlight - shadow)) : -1;
}

// Width by light; where the tone map sees nothing, the light of the point before counts on.
// Undercuts, which are to be dark, do not thin out in the light.
class HatchWidth {
 public:
  HatchWidth(const ToneMap& tone, double width, double by_light, Kind kind)
      : tone_(tone), width_(width), by_light_(by_light), least_(kind == Kind::undercut ? 0 : -1) {}

  double operator()(const Vec2& image) {
    const int cell = tone_.cell_of(image);
    if (cell != none && tone_.level[idx(cell)] != Tone::nothing) {
      swelling_ =
          std::max(least_, swelling(static_cast<double>(tone_.brightness[idx(cell)]), tone_));
    }
    return width_ * (1 + by_light_ * swelling_);
  }

 private:
  const ToneMap& tone_;
  double width_;
  double by_light_;
  double least_;
  double swelling_ = 0;
};

std::vector<Stroke> hatch_strokes(const Hatches& hatches, const ToneMap& tone,
                                  const std::vector<double>& width_scale,
                                  const std::vector<double>& triangle_widths,
                                  const StrokeOptions& options) {
  const auto factor = [&](const SurfacePoint& on) {
    return triangle_widths.empty() || on.triangle == none ? 1 : triangle_widths[idx(on.triangle)];
  };
  std::vector<Stroke> strokes;
  for (std::size_t h = 0; h < hatches.curves.size(); ++h) {
    const double width = options.hatch_width_px * scale_of(width_scale, hatches.objects[h]);
    HatchWidth width_at(tone, width, options.hatch_width_by_light, hatches.kinds[h]);
    StrokePath path;
    path.free_start = path.free_end = true;
    for (const HatchPoint& p : hatches.curves[h]) {
      path.points.push_back({p.position, p.on, p.image, width_at(p.image) * factor(p.on)});
    }
    strokes.push_back({std::move(path), hatches.kinds[h], hatches.objects[h], 0});
  }
  return strokes;
}

std::vector<Stroke> with_one_pen_each(std::vector<Stroke> strokes, const std::vector<int>& pens,
                                      double speck_px) {
  if (pens.empty()) return strokes;
  std::vector<Stroke> parts;
  for (const Stroke& s : strokes) {
    for (PenPart& part : parts_by_pen(s.path, pens, speck_px)) {
      parts.push_back({std::move(part.path), s.kind, s.object, s.invisibility, part.pen});
    }
  }
  return parts;
}

void append(Drawing& drawing, const StrokePath& path, const Stroke& stroke) {
  for (const StrokePoint& p : path.points) {
    drawing.points.push_back(p.position);
    drawing.image.push_back(p.image);
    drawing.widths.push_back(static_cast<float>(p.width));
    drawing.on.push_back(p.on);
  }
  drawing.offsets.push_back(static_cast<int>(drawing.points.size()));
  drawing.kinds.push_back(stroke.kind);
  drawing.closed.push_back(path.closed ? 1 : 0);
  drawing.objects.push_back(stroke.object);
  drawing.invisibility.push_back(stroke.invisibility);
  drawing.pens.push_back(stroke.pen);
}

void require(bool holds, const char* message) {
  if (!holds) throw InvalidInput(message);
}

bool is_size(double value) { return value >= 0 && std::isfinite(value); }
bool is_share(double value) { return value >= 0 && value <= 1; }

}  // namespace

void validate(const StrokeOptions& options) {
  const std::array<std::pair<const char*, double>, 8> sizes{{
      {"line_width_px", options.line_width_px},
      {"feature_width_px", options.feature_width_px},
      {"hatch_width_px", options.hatch_width_px},
      {"hidden_width_scale", options.hidden_width_scale},
      {"taper_px", options.taper_px},
      {"speck_px", options.speck_px},
      {"simplify_px", options.simplify_px},
      {"inner_width_scale", options.line_weight.inner_scale},
  }};
  for (const auto& [name, value] : sizes) {
    if (!is_size(value)) throw InvalidInput(std::string(name) + " must be at least 0 and finite");
  }
  require(is_share(options.line_weight.by_light), "line_width_by_light must be in [0, 1]");
  require(is_share(options.line_weight.by_depth), "line_width_by_depth must be in [0, 1]");
  require(is_share(options.width_by_crowding), "line_width_by_crowding must be in [0, 1]");
  require(is_share(options.hatch_width_by_light), "hatch_width_by_light must be in [0, 1]");
  if (options.hidden_lines) {
    require((*options.hidden_lines)[0] <= (*options.hidden_lines)[1],
            "hidden_lines must be (low, high) with low <= high");
  }
}

Drawing make_strokes(const LabelledGraph& graph, const Hatches& hatches, const ToneMap& tone,
                     const Camera& camera, const std::vector<double>& width_scale,
                     const std::vector<std::uint8_t>& undrawn, const StrokeOptions& options,
                     const StrokeStyles& places) {
  validate(options);
  std::vector<Stroke> strokes =
      line_strokes(graph, places.line_widths, width_scale, undrawn, camera, options);
  for (Stroke& s : hatch_strokes(hatches, tone, width_scale, places.hatch_widths, options))
    strokes.push_back(std::move(s));
  strokes = with_one_pen_each(std::move(strokes), places.pens, options.speck_px);
  std::stable_sort(strokes.begin(), strokes.end(),
                   [](const Stroke& a, const Stroke& b) { return a.kind < b.kind; });
  Drawing drawing;
  for (const Stroke& stroke : strokes) {
    for (const StrokePath& part : clip_at_frame(stroke.path, camera)) {
      const double pixel_size = camera.pixel_size(part.points.front().position);
      const StrokePath path = simplify(part, options.simplify_px, pixel_size);
      append(drawing, taper(path, options.taper_px, camera), stroke);
    }
  }
  return drawing;
}

}  // namespace illustrate
