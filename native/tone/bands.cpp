#include "tone/bands.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "contour/contour_functions.h"
#include "tone/fold_extents.h"
#include "tone/fold_sides.h"
#include "tone/step_along.h"

namespace illustrate {
namespace {

// In cells, as depths are compared. The triangles stand out from the smooth outline by less than
// `behind`; a fold that recedes from its own edge does so by less than `recession` of depth for
// each cell of the image. Curves are sampled once a cell.
constexpr double behind = 3;
constexpr double recession = 3;

// A fold that is an edge has a face of its own, which may go on beside the end of the edge: what
// lies in the face's plane, by as much, is no other surface. Of a face seen this steeply nothing is
// known.
constexpr double least_face_facing = 0.2;

constexpr double usual_gap = 0.25;   // of a part's diagonal, at which undercuts end
constexpr double whole_share = 0.2;  // of that, up to which they are whole
constexpr double fade_slope = 0.7;   // how fast they widen from where their fold ends

enum class Side : std::uint8_t { left, right };

struct FoldSample {
  Vec2 image;
  Vec2 beyond;  // unit, across the curve, away from the fold
  Vec3 position;
  double depth;
  double cell;                      // world length of a cell there
  double along;                     // px along the curve
  int triangle;                     // on the fold
  double undercut_px = 0;           // how wide the undercut is
  double mach_band_px = 0;          // and the Mach band
  Vec3 face_normal = Vec3::Zero();  // of the near face of an edge; zero: not known
};

// Between two faces that both are seen.
bool is_visible_crease(const GraphArc& arc) {
  return layers_over(arc) == 0 && arc.kind == Kind::crease && arc.left_layers == arc.right_layers;
}

// To the left of a curve as the viewer sees it run, y pointing down.
Vec2 left_of(const Vec2& heading) { return {heading.y(), -heading.x()}; }

class BandMarker {
 public:
  BandMarker(const ToneScene& scene, const LabelledGraph& graph, const ToneOptions& options,
             const std::vector<float>& brightness, std::vector<Band>& band)
      : surface_(scene.surface),
        visible_(scene.visible),
        graph_(graph),
        camera_(scene.camera),
        lights_(scene.lights),
        options_(options),
        brightness_(brightness),
        band_(band),
        map_(image_map(camera_)),
        is_anywhere_(!options.undercuts || options.undercut_contact == 0),
        own_parts_(is_anywhere_ || scene.parts ? SurfaceParts{} : surface_parts(surface_)),
        parts_(scene.parts ? *scene.parts : own_parts_),
        extents_(is_anywhere_ ? FoldExtents{} : fold_extents(graph_, camera_)),
        nearest_(band.size(), std::numeric_limits<float>::infinity()) {}

  void mark(int arc) {
    const GraphArc& data = graph_.arcs[arc];
    if (!is_visible_fold(data)) return;
    const bool meets = data.kind == Kind::intersection;
    const std::vector<FoldSample> samples = samples_of(arc);
    const Side beyond = meets ? side_turned_away(samples) : side_beyond(data);
    for (FoldSample sample : samples) {
      if (beyond == Side::right) sample.beyond = -sample.beyond;
      const double gap = meets ? depth_at(sample, 2) - sample.depth : gap_beyond(sample);
      if (!std::isfinite(gap)) continue;
      sample.undercut_px = undercut_width(arc, sample, meets ? 0 : gap);
      sample.mach_band_px = mach_band_width(sample);
      if (data.kind == Kind::crease || data.kind == Kind::boundary) {
        sample.face_normal = near_face_normal(sample);
      }
      mark_round(sample, meets ? -std::numeric_limits<double>::infinity() : behind);
    }
  }

  // Once all folds are marked.
  void clear_beside_crease(int arc) {
    if (!is_visible_crease(graph_.arcs[arc])) return;
    for (const FoldSample& sample : samples_of(arc)) {
      each_row_round(sample, options_.undercut_px, [&](int row, int column, int end) {
        for (int i = next_undercut(row, column, end); i < end; i = next_undercut(row, i + 1, end))
          clear_cell(sample, i, row);
      });
    }
  }

 private:
  static Side side_beyond(const GraphArc& arc) {
    return arc.left_layers > arc.right_layers ? Side::right : Side::left;
  }

  // `beyond` of the samples is the left side until the fold is known.
  std::vector<FoldSample> samples_of(int arc) const {
    const double margin = std::max(options_.mach_band_px, options_.undercut_px);
    const Vec2 size(camera_.width_px(), camera_.height_px());
    const Frame frame{Vec2::Constant(-margin), size + Vec2::Constant(margin)};
    const Span<const CurvePoint> points = graph_.points[arc];
    std::vector<FoldSample> samples;
    std::size_t segment = 0;
    double passed = 0;  // px up to its start
    step_along(graph_.image[arc], graph_.arcs[arc].start_node == none, visible_.cell_px, frame,
               [&](const CurveSample& at) {
                 const std::size_t next = at.segment + 1 == points.size() ? 0 : at.segment + 1;
                 const Vec3& a = points[at.segment].position;
                 const Vec3 p = a + at.fraction * (points[next].position - a);
                 for (; segment < at.segment; ++segment)
                   passed += (graph_.image[arc][segment + 1] - graph_.image[arc][segment]).norm();
                 samples.push_back({at.image, left_of(at.heading), p, camera_.project(p).depth,
                                    visible_.cell_px * camera_.pixel_size(p),
                                    passed + (at.image - graph_.image[arc][segment]).norm(),
                                    points[at.segment].on.triangle});
               });
    return samples;
  }

  // Depth of what is seen `cells` cells beyond the curve; infinite where nothing is.
  double depth_at(const FoldSample& sample, double cells) const {
    const double reach = cells * visible_.cell_px;
    const int cell = visible_.cell_of(sample.image + reach * sample.beyond);
    return cell == none ? std::numeric_limits<double>::infinity() : visible_.depth[cell];
  }

  // How far another surface is behind the fold, just beyond it; infinite where there is none.
  double gap_beyond(const FoldSample& sample) const {
    for (const double cells : {2.0, 3.5}) {
      const double gap = depth_at(sample, cells) - sample.depth;
      if (std::isfinite(gap) && gap > behind * sample.cell) return gap;
    }
    return std::numeric_limits<double>::infinity();
  }

  // Of the face that is seen just before the edge.
  Vec3 near_face_normal(const FoldSample& sample) const {
    const int cell = visible_.cell_of(sample.image - 2 * visible_.cell_px * sample.beyond);
    if (cell == none || visible_.triangle[cell] == none) return Vec3::Zero();
    const Vec3 normal = face_normal(surface_, visible_.triangle[cell]);
    const Vec3 to_eye = camera_.to_eye(sample.position);
    return std::abs(normal.dot(to_eye)) < least_face_facing * to_eye.norm() ? Vec3::Zero() : normal;
  }

  // Whether what is seen at a cell lies in the plane of the face that ends at the edge.
  bool is_of_face(const FoldSample& sample, const Vec2& centre, int cell) const {
    if (sample.face_normal.isZero()) return false;
    const SurfacePoint at = surface_point_under(surface_, map_, visible_.triangle[cell], centre);
    const Vec3 off = position_at(surface_, at) - sample.position;
    return std::abs(sample.face_normal.dot(off)) <= behind * sample.cell;
  }

  // gap: to what lies beyond the fold, which `beyond` of the sample points to.
  double undercut_width(int arc, const FoldSample& sample, double gap) const {
    if (is_anywhere_) return options_.undercut_px;
    const double fade = fade_slope * extents_.to_end(arc, sample.along);
    return std::min(options_.undercut_px * closeness(sample, gap), fade);
  }

  double mach_band_width(const FoldSample& sample) const {
    const double px = options_.mach_band_px, step = (behind + recession) * sample.cell;
    const FoldSides sides = fold_sides(surface_, visible_, brightness_, sample.image, sample.beyond,
                                       wide_part * px, step);
    return px * kept_mach_band(sides, px);
  }

  // 1 where what lies beyond a fold is so near that its undercut is whole, 0 where it has none.
  double closeness(const FoldSample& sample, double gap) const {
    const double contact = options_.undercut_contact;
    if (sample.triangle == none || gap <= 0) return 1;
    const double size = parts_.diagonals[idx(parts_.of_triangle[idx(sample.triangle)])];
    const double end = usual_gap * size * (1 - contact) / contact * (1 - light_beyond(sample));
    return end > 0 ? std::clamp((1 - gap / end) / (1 - whole_share), 0.0, 1.0) : 0;
  }

  // How far the light comes from the side beyond the fold: 1: all, -1: all comes from the fold's.
  double light_beyond(const FoldSample& sample) const {
    const Vec3 in_view(sample.beyond.x(), -sample.beyond.y(), 0);
    const Vec3 outward = camera_.view().topLeftCorner<3, 3>().transpose() * in_view;
    return light_side(lights_, camera_, sample.position).dot(outward);
  }

  // |n . view| of what is seen at an image point, 1 where nothing is.
  double facing_at(const Vec2& image) const {
    const int cell = visible_.cell_of(image);
    if (cell == none || visible_.triangle[cell] == none) return 1;
    const SurfacePoint at = surface_point_under(surface_, map_, visible_.triangle[cell], image);
    const Vec3 to_eye = camera_.to_eye(position_at(surface_, at));
    return std::abs(normal_at(surface_, at).dot(to_eye)) / to_eye.norm();
  }

  Side side_turned_away(const std::vector<FoldSample>& samples) const {
    const double reach = 2 * visible_.cell_px;
    double left = 0, right = 0;
    for (const FoldSample& sample : samples) {
      left += facing_at(sample.image + reach * sample.beyond);
      right += facing_at(sample.image - reach * sample.beyond);
    }
    return left < right ? Side::left : Side::right;
  }

  void mark_round(const FoldSample& sample, double least_depth) {
    const double reach = std::max(sample.mach_band_px, sample.undercut_px);
    each_row_round(sample, reach, [&](int row, int column, int end) {
      for (int i = column; i < end; ++i) mark_cell(sample, least_depth, i, row);
    });
  }

  // Calls use(row, first column, end) for the rows of the square round a sample.
  template <class Use>
  void each_row_round(const FoldSample& sample, double reach, const Use& use) const {
    const double cell_px = visible_.cell_px;
    const auto cells = [cell_px](double px, int end) {
      return static_cast<int>(std::clamp(std::floor(px / cell_px), 0.0, end - 1.0));
    };
    const int row_end = cells(sample.image.y() + reach, visible_.height);
    const int column = cells(sample.image.x() - reach, visible_.width);
    const int column_end = cells(sample.image.x() + reach, visible_.width);
    for (int row = cells(sample.image.y() - reach, visible_.height); row <= row_end; ++row) {
      use(row, column, column_end + 1);
    }
  }

  Vec2 middle_of(int column, int row) const {
    return Vec2(column + 0.5, row + 0.5) * visible_.cell_px;
  }

  void mark_cell(const FoldSample& sample, double least_depth, int column, int row) {
    const int cell = visible_.index(column, row);
    if (visible_.triangle[cell] == none) return;
    const Vec2 centre = middle_of(column, row), offset = centre - sample.image;
    const bool is_beyond = offset.dot(sample.beyond) > 0;
    const double reach = is_beyond ? sample.undercut_px : sample.mach_band_px;
    const double distance = offset.norm();
    if (distance > reach || distance >= nearest_[cell]) return;
    const double deeper = (visible_.depth[cell] - sample.depth) / sample.cell;
    const bool is_fold = !is_beyond && deeper < behind + recession * distance / visible_.cell_px;
    const bool is_undercut = is_beyond && deeper > least_depth && !is_of_face(sample, centre, cell);
    if (!is_fold && !is_undercut) return;
    band_[cell] = is_fold ? Band::mach_band : Band::undercut;
    nearest_[cell] = static_cast<float>(distance);
  }

  // The first undercut in columns [column, end) of a row, or the end.
  int next_undercut(int row, int column, int end) const {
    const Band* const first = band_.data() + visible_.index(column, row);
    const void* found = std::memchr(first, int(Band::undercut), idx(end - column));
    return found ? column + static_cast<int>(static_cast<const Band*>(found) - first) : end;
  }

  void clear_cell(const FoldSample& sample, int column, int row) {
    const int cell = visible_.index(column, row);
    const double distance = (middle_of(column, row) - sample.image).norm();
    const double apart = std::abs(visible_.depth[cell] - sample.depth) / sample.cell;
    const bool is_beside = apart < behind + recession * distance / visible_.cell_px;
    if (is_beside && distance < nearest_[cell]) band_[cell] = Band::nothing;
  }

  const Surface& surface_;
  const VisibleImage& visible_;
  const LabelledGraph& graph_;
  const Camera& camera_;
  const std::vector<Light>& lights_;
  const ToneOptions& options_;
  const std::vector<float>& brightness_;
  std::vector<Band>& band_;
  ImageMap map_;
  bool is_anywhere_;              // undercuts are the same beyond all folds
  const SurfaceParts own_parts_;  // empty then, and where they are known
  const SurfaceParts& parts_;
  FoldExtents extents_;         // empty where undercuts are the same anywhere
  std::vector<float> nearest_;  // distance to the curve that marked a cell
};

}  // namespace

void mark_bands(const ToneScene& scene, const LabelledGraph& graph, const ToneOptions& options,
                const std::vector<float>& brightness, std::vector<Band>& band) {
  BandMarker marker(scene, graph, options, brightness, band);
  const int count = static_cast<int>(graph.arcs.size());
  for (int arc = 0; arc < count; ++arc) marker.mark(arc);
  for (int arc = 0; arc < count; ++arc) marker.clear_beside_crease(arc);
  for (Band& mark : band) {
    const bool wanted = mark == Band::mach_band ? options.mach_bands : options.undercuts;
    if (!wanted) mark = Band::nothing;
  }
}

}  // namespace illustrate
