#include "visibility/evidence/outline.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/pi.h"
#include "visibility/reaches.h"

namespace illustrate {
namespace {

constexpr int directions = 4;
constexpr int most_rows = 8192;  // a larger frame gets wider rows
constexpr int finer_rows = 16;   // in a row where they are

// The nearest two curves to one end of a scan line.
struct RowEnd {
  double first = std::numeric_limits<double>::infinity();
  double second = std::numeric_limits<double>::infinity();
  int segment = none;
  double fraction = 0;

  void offer(double distance, int candidate, double at) {
    if (!(distance < second)) return;  // most are neither
    second = std::max(first, distance);
    if (!(distance < first)) return;
    first = distance;
    segment = candidate;
    fraction = at;
  }
};

class OutlineScan {
 public:
  OutlineScan(const std::vector<StrandSegment>& segments, const std::vector<Vec2>& points,
              const Eigen::AlignedBox2d& frame)
      : segments_(segments),
        points_(points),
        frame_(frame),
        rows_(points.size()),
        along_(points.size()),
        next_line_(points.size()),
        hits_(segments.size(), -1) {}

  void scan(double angle) {
    across_ = Vec2(std::cos(angle), std::sin(angle));
    set_rows();
    for (std::size_t i = 0; i < segments_.size(); ++i) cross_rows(static_cast<int>(i));
    note_hits();
    if (find_unclear_rows()) scan_finer();
  }

  // Fraction along each segment at which it was first or last, -1 where it never was.
  const std::vector<double>& hits() const { return hits_; }

 private:
  // Scan lines run through the middle of rows, at multiples of a row's width, as far as both the
  // frame and the drawing reach.
  void set_rows() {
    const auto [low, high] = span();
    const double row = std::max(reaches.outline_row, (high - low) / most_rows);
    const double start = (std::floor(low / row) - 0.5) * row;
    const std::size_t count = static_cast<std::size_t>(std::max(0.0, high - start) / row) + 2;
    for (std::size_t p = 0; p < points_.size(); ++p) {
      rows_[p] = (rows_[p] - start) / row;
      next_line_[p] =
          static_cast<int>(std::ceil(std::clamp(rows_[p] - 0.5, 0.0, static_cast<double>(count))));
    }
    lower_.assign(count, {});
    upper_.assign(count, {});
  }

  // Of rows_, which are px here.
  std::pair<double, double> span() {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (std::size_t p = 0; p < points_.size(); ++p) {
      rows_[p] = points_[p].dot(across_);
      along_[p] = cross(across_, points_[p]);
      low = std::min(low, rows_[p]);
      high = std::max(high, rows_[p]);
    }
    const double middle = frame_.center().dot(across_);
    const double half = frame_.sizes().dot(across_.cwiseAbs()) / 2;
    return {std::max(low, middle - half), std::min(high, middle + half)};
  }

  // A segment that ends on a scan line belongs to it at its lower end only.
  void cross_rows(int i) {
    const StrandSegment& s = segments_[idx(i)];
    const auto [first, end] = std::minmax(next_line_[idx(s.a)], next_line_[idx(s.b)]);
    const double a = rows_[idx(s.a)], per_row = 1 / (rows_[idx(s.b)] - a);
    for (int row = first; row < end; ++row) offer(i, (row + 0.5 - a) * per_row, idx(row));
  }

  void note_hits() {
    for (const std::vector<RowEnd>* ends : {&lower_, &upper_}) {
      for (const RowEnd& e : *ends) {
        if (e.segment != none && e.second - e.first > reaches.outline_clear)
          hits_[idx(e.segment)] = e.fraction;
      }
    }
  }

  // Curves that run close together on the outside change places between two rows. Whether there
  // are any; numbers the rows where they may.
  bool find_unclear_rows() {
    const auto is_unclear = [](const RowEnd& e) {
      return e.second - e.first <= reaches.outline_clear;
    };
    const std::size_t count = lower_.size();
    finer_.assign(count + 1, 0);
    for (std::size_t row = 0; row < count; ++row) {
      if (!is_unclear(lower_[row]) && !is_unclear(upper_[row])) continue;
      for (std::size_t k = row == 0 ? 0 : row - 1; k <= std::min(row + 1, count - 1); ++k)
        finer_[k] = 1;
    }
    int next = 0;
    for (int& number : finer_) next += std::exchange(number, next);
    return next > 0;
  }

  // finer_[row + 1] - finer_[row] tells whether a row is scanned again.
  void scan_finer() {
    const std::size_t count = idx(finer_.back()) * finer_rows;
    lower_.assign(count, {});
    upper_.assign(count, {});
    for (std::size_t i = 0; i < segments_.size(); ++i) cross_finer_rows(static_cast<int>(i));
    note_hits();
  }

  void cross_finer_rows(int i) {
    const StrandSegment& s = segments_[idx(i)];
    const double a = rows_[idx(s.a)], b = rows_[idx(s.b)];
    const double end = static_cast<double>(finer_.size() - 2);
    const auto first = static_cast<std::size_t>(std::clamp(std::min(a, b), 0.0, end));
    const auto last = static_cast<std::size_t>(std::clamp(std::max(a, b), 0.0, end));
    if (finer_[first] == finer_[last + 1]) return;
    const double width = 1.0 / finer_rows;
    for (std::size_t row = first; row <= last; ++row) {
      if (finer_[row] == finer_[row + 1]) continue;
      for (int k = 0; k < finer_rows; ++k) {
        const double at = static_cast<double>(row) + (k + 0.5) * width;
        if ((at < a) == (at < b)) continue;
        offer(i, (at - a) / (b - a), idx(finer_[row]) * finer_rows + idx(k));
      }
    }
  }

  void offer(int i, double fraction, std::size_t row) {
    const StrandSegment& s = segments_[idx(i)];
    const double a = along_[idx(s.a)], v = a + fraction * (along_[idx(s.b)] - a);
    lower_[row].offer(v, i, fraction);
    upper_[row].offer(-v, i, fraction);
  }

  const std::vector<StrandSegment>& segments_;
  const std::vector<Vec2>& points_;
  Eigen::AlignedBox2d frame_;
  Vec2 across_ = Vec2::UnitX();
  std::vector<double> rows_;    // (points) where each one is, in rows
  std::vector<double> along_;   // (points) and along them, px
  std::vector<int> next_line_;  // (points) the first scan line that is not below
  std::vector<double> hits_;
  std::vector<RowEnd> lower_;  // the first curve of each row
  std::vector<RowEnd> upper_;  // the last one
  std::vector<int> finer_;     // (rows + 1) how many of the rows before are scanned again
};

// The points of a triangle's edges on the near plane.
std::vector<Vec3> near_points(const Surface& surface, int triangle, const Camera& camera) {
  std::vector<Vec3> points;
  for (int k = 0; k < 3; ++k) {
    const Vec3& a = surface.positions[idx(surface.triangles[idx(triangle)][idx(k)])];
    const Vec3& b = surface.positions[idx(surface.triangles[idx(triangle)][idx(next_corner(k))])];
    const double at_a = camera.near_distance(a), at_b = camera.near_distance(b);
    if ((at_a > 0) != (at_b > 0)) points.push_back(a + at_a / (at_a - at_b) * (b - a));
  }
  return points;
}

}  // namespace

bool has_open_silhouette(const CurveNetwork& network, const Camera& camera) {
  constexpr double rounding = 1e-9;
  const auto is_cut = [&](const Vec3& p) {
    const double size = camera.near_plane().cwiseAbs().dot(p.homogeneous().cwiseAbs());
    return std::abs(camera.near_distance(p)) <= rounding * size;
  };
  const auto is_open = [&](int node) {
    const NetworkNode& n = network.nodes[idx(node)];
    return n.kind == NodeKind::end && !is_cut(n.position);
  };
  return std::any_of(network.strands.begin(), network.strands.end(), [&](const Strand& s) {
    return s.kind == Kind::silhouette && !s.closed() &&
           (is_open(s.start_node) || is_open(s.end_node));
  });
}

std::vector<ImageSegment> near_cuts(const Surface& surface, const Bvh& bvh, const Camera& camera) {
  std::vector<ImageSegment> cuts;
  bvh.met_by_plane(camera.near_plane(), [&](int triangle) {
    const std::vector<Vec3> ends = near_points(surface, triangle, camera);
    if (ends.size() != 2) return;
    const ImageSegment cut{camera.project(ends[0]).xy, camera.project(ends[1]).xy};
    if (cut[0].allFinite() && cut[1].allFinite()) cuts.push_back(cut);
  });
  return cuts;
}

std::vector<std::vector<StrandPlace>> outline_places(const CurveNetwork& network,
                                                     const ImageStrands& strands,
                                                     const Eigen::AlignedBox2d& frame,
                                                     const std::vector<ImageSegment>& cuts) {
  std::vector<std::vector<StrandPlace>> result(network.strands.size());
  std::vector<StrandSegment> segments = all_segments(network);
  const std::size_t of_strands = segments.size();
  if (segments.empty()) return result;
  std::vector<Vec2> points = strands.image;
  for (const ImageSegment& cut : cuts) {
    const int first = static_cast<int>(points.size());
    segments.push_back({none, none, first, first + 1});
    points.insert(points.end(), cut.begin(), cut.end());
  }
  OutlineScan scan(segments, points, frame);
  for (int d = 0; d < directions; ++d) scan.scan(pi * (d + 0.137) / directions);
  for (std::size_t i = 0; i < of_strands; ++i) {
    const double fraction = scan.hits()[i];
    if (fraction < 0) continue;
    const StrandSegment& s = segments[i];
    result[idx(s.strand)].push_back({s.strand, s.segment, std::clamp(fraction, 0.0, 1.0)});
  }
  return result;
}

}  // namespace illustrate
