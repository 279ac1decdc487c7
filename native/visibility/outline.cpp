#include "visibility/outline.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace illustrate {
namespace {

constexpr int directions = 8;
constexpr double half_turn = 3.141592653589793;
constexpr double row_px = 0.5;
constexpr int most_rows = 8192;  // a drawing that reaches far out of the frame gets wider rows
constexpr double clear_px =
    0.05;  // nearer curves on a scan line are one line: neither is certain to be first

// The nearest two curves to one end of a scan line.
struct RowEnd {
  double first = std::numeric_limits<double>::infinity();
  double second = std::numeric_limits<double>::infinity();
  int segment = none;
  double fraction = 0;

  void offer(double distance, int candidate, double at) {
    if (distance < first) {
      second = first;
      first = distance;
      segment = candidate;
      fraction = at;
    } else {
      second = std::min(second, distance);
    }
  }
};

struct Segment {
  int strand;
  int index;
  Vec2 a;
  Vec2 b;
};

std::vector<Segment> image_segments(const CurveNetwork& network, const ImageStrands& strands) {
  std::vector<Segment> result;
  for (std::size_t s = 0; s < network.strands.size(); ++s) {
    const int begin = network.points.offsets[s];
    const int count = network.points.offsets[s + 1] - begin;
    const int last = network.strands[s].closed() ? count : count - 1;
    for (int i = 0; i < last; ++i) {
      result.push_back({static_cast<int>(s), i, strands.image[idx(begin + i)],
                        strands.image[idx(begin + (i + 1) % count)]});
    }
  }
  return result;
}

class OutlineScan {
 public:
  explicit OutlineScan(const std::vector<Segment>& segments)
      : segments_(segments), hits_(segments.size(), -1) {}

  void scan(double angle) {
    across_ = Vec2(std::cos(angle), std::sin(angle));
    set_rows();
    for (std::size_t i = 0; i < segments_.size(); ++i) cross_rows(static_cast<int>(i));
    for (const std::vector<RowEnd>* ends : {&lower_, &upper_}) {
      for (const RowEnd& e : *ends) {
        if (e.segment != none && e.second - e.first > clear_px) hits_[idx(e.segment)] = e.fraction;
      }
    }
  }

  // Fraction along each segment at which it was first or last, -1 where it never was.
  const std::vector<double>& hits() const { return hits_; }

 private:
  void set_rows() {
    low_ = std::numeric_limits<double>::infinity();
    double high = -low_;
    for (const Segment& s : segments_) {
      low_ = std::min({low_, s.a.dot(across_), s.b.dot(across_)});
      high = std::max({high, s.a.dot(across_), s.b.dot(across_)});
    }
    row_ = std::max(row_px, (high - low_) / most_rows);
    low_ = (std::floor(low_ / row_) - 0.5) * row_;
    lower_.assign(static_cast<std::size_t>((high - low_) / row_) + 2, {});
    upper_.assign(lower_.size(), {});
  }

  // Scan lines run through the middle of rows, at multiples of a row's width; a segment that ends
  // on one belongs to it at its lower end only.
  void cross_rows(int i) {
    const Segment& s = segments_[idx(i)];
    const Vec2 along(-across_.y(), across_.x());
    const double a = (s.a.dot(across_) - low_) / row_, b = (s.b.dot(across_) - low_) / row_;
    const double end = std::ceil(std::max(a, b) - 0.5);
    for (double row = std::ceil(std::min(a, b) - 0.5); row < end; ++row) {
      const double fraction = (row + 0.5 - a) / (b - a);
      const double v = (s.a + fraction * (s.b - s.a)).dot(along);
      lower_[static_cast<std::size_t>(row)].offer(v, i, fraction);
      upper_[static_cast<std::size_t>(row)].offer(-v, i, fraction);
    }
  }

  const std::vector<Segment>& segments_;
  std::vector<double> hits_;
  Vec2 across_ = Vec2::UnitX();
  double low_ = 0;
  double row_ = 1;
  std::vector<RowEnd> lower_;  // the first curve of each row
  std::vector<RowEnd> upper_;  // the last one
};

bool is_cut_open(const CurveNetwork& network) {
  return std::any_of(network.strands.begin(), network.strands.end(), [&](const Strand& s) {
    const auto is_end = [&](int node) { return network.nodes[idx(node)].kind == NodeKind::end; };
    return s.kind == Kind::silhouette && !s.closed() &&
           (is_end(s.start_node) || is_end(s.end_node));
  });
}

}  // namespace

std::vector<std::vector<StrandPlace>> outline_places(const CurveNetwork& network,
                                                     const ImageStrands& strands) {
  std::vector<std::vector<StrandPlace>> result(network.strands.size());
  const std::vector<Segment> segments = image_segments(network, strands);
  if (segments.empty() || is_cut_open(network)) return result;
  OutlineScan scan(segments);
  for (int d = 0; d < directions; ++d) scan.scan(half_turn * (d + 0.137) / directions);
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const double fraction = scan.hits()[i];
    if (fraction < 0) continue;
    const Segment& s = segments[i];
    result[idx(s.strand)].push_back({s.strand, s.index, std::clamp(fraction, 0.0, 1.0)});
  }
  return result;
}

}  // namespace illustrate
