#include "hatch/crumbs.h"

#include <algorithm>

#include "hatch/hatch_runs.h"
#include "hatch/trace_hatch.h"

namespace illustrate {
namespace {

// In spacings: the shortest hatch, and how far shorter ones are to grow; how far they keep from
// parallel ones; how far beyond their ends edges of tone are looked for.
constexpr double least_length = 2.05;
constexpr double grown_length = 2.25;
constexpr double clearance = 0.6;
constexpr double end_reach = 0.75;

constexpr double step = 0.2;  // of growing, in spacings

// A hatch shorter than this, in spacings, needs so many others beside it, so near.
constexpr double short_length = 4;
constexpr double company_reach = 2.2;
constexpr std::size_t company = 2;

class Sweeper {
 public:
  Sweeper(const Hatches& hatches, const HatchScene& scene, const HatchOptions& options)
      : hatches_(hatches),
        scene_(scene),
        options_(options),
        area_(scene),
        walker_(scene.surface, scene.field, scene.camera),
        grid_(scene.camera.width_px(), scene.camera.height_px(), options.spacing_px),
        tracer_(scene.surface, walker_, area_, scene.curves, grid_, options),
        lines_(hatches.kinds.size()) {}

  Hatches run() {
    std::vector<int> crumbs;
    std::vector<double> lengths;
    for (int h = 0; h < static_cast<int>(lines_.size()); ++h) {
      lengths.push_back(length_px(hatches_.curves[idx(h)]));
      if (lengths.back() < least_length * spacing(h)) {
        crumbs.push_back(h);
      } else {
        keep(h, line_of(h));
      }
    }
    std::stable_sort(crumbs.begin(), crumbs.end(),
                     [&](int a, int b) { return lengths[idx(a)] > lengths[idx(b)]; });
    for (const int h : crumbs) sweep(h, lengths[idx(h)]);
    leave_out_lone();
    return kept();
  }

 private:
  double spacing(int hatch) const {
    const bool is_dense = hatches_.kinds[idx(hatch)] == Kind::undercut;
    return scene_.spacing_on(hatches_.objects[idx(hatch)],
                             is_dense ? options_.undercut_spacing_px : options_.spacing_px);
  }

  HatchLine line_of(int hatch) const {
    const Span<const HatchPoint> curve = hatches_.curves[idx(hatch)];
    HatchLine line;
    for (std::size_t i = 0; i < curve.size(); ++i) {
      const std::size_t from = i == 0 ? 0 : i - 1, to = std::min(i + 1, curve.size() - 1);
      line.push_back({curve[i], (curve[to].position - curve[from].position).normalized()});
    }
    return line;
  }

  void keep(int hatch, HatchLine line) {
    for (const HatchSample& s : line) grid_.add({s.point.image, s.tangent, hatch});
    lines_[idx(hatch)] = std::move(line);
  }

  void sweep(int hatch, double length) {
    HatchLine line = line_of(hatch);
    if (!(length > 0)) return;
    double rest = grown_length * spacing(hatch) - length;
    for (int end = 0; end < 2; ++end) {
      grow(line, hatch, rest);
      line = reversed(std::move(line));
    }
    const bool is_long = rest <= (grown_length - least_length) * spacing(hatch);
    if (is_long || !(meets_tone(line, hatch) || meets_tone(reversed(line), hatch))) {
      keep(hatch, std::move(line));
    }
  }

  // Walks on at the end of a line; `rest` loses what it grew by.
  void grow(HatchLine& line, int hatch, double& rest) const {
    const std::size_t before = line.size();
    const HatchRules rules{Area::hatched, clearance * spacing(hatch), step * spacing(hatch), 0};
    double budget = rest;
    tracer_.extend(line, walker_.start(line.back().point.on, line.back().tangent), rules, budget);
    for (std::size_t i = before; i < line.size(); ++i) {
      rest -= (line[i].point.image - line[i - 1].point.image).norm();
    }
  }

  static HatchLine reversed(HatchLine line) {
    std::reverse(line.begin(), line.end());
    for (HatchSample& s : line) s.tangent = -s.tangent;
    return line;
  }

  // Whether a line ends where the tone for its kind does.
  bool meets_tone(const HatchLine& line, int hatch) const {
    const HatchPoint& p = line.back().point;
    const Vec2 way = walker_.image_direction(p.position, line.back().tangent);
    const Vec2 beyond = p.image + end_reach * spacing(hatch) * way.normalized();
    return !scene_.curves.separate(p.image, beyond) &&
           !suits(region_of(scene_.tone, beyond), hatches_.kinds[idx(hatch)]);
  }

  static bool suits(Region region, Kind kind) {
    if (region == Region::undercut) return true;
    return region == Region::shadow ? kind != Kind::undercut
                                    : region == Region::single && kind == Kind::hatch;
  }

  // Of those that there are now, all at once.
  void leave_out_lone() {
    std::vector<int> lone;
    for (int h = 0; h < static_cast<int>(lines_.size()); ++h) {
      const HatchLine& line = lines_[idx(h)];
      const bool is_short = hatches_.kinds[idx(h)] != Kind::undercut && !line.empty() &&
                            length_of(line) < short_length * spacing(h);
      if (is_short && !has_company(h, line[line.size() / 2])) lone.push_back(h);
    }
    for (const int h : lone) lines_[idx(h)].clear();
  }

  static double length_of(const HatchLine& line) {
    double length = 0;
    for (std::size_t i = 1; i < line.size(); ++i) {
      length += (line[i].point.image - line[i - 1].point.image).norm();
    }
    return length;
  }

  bool has_company(int hatch, const HatchSample& middle) const {
    const Vec2& image = middle.point.image;
    const Vec3 normal = normal_at(scene_.surface, middle.point.on);
    std::vector<int> others;
    return grid_.any_within(image, company_reach * spacing(hatch), [&](const HatchNode& node) {
      const bool is_other = node.point != hatch &&
                            !std::count(others.begin(), others.end(), node.point) &&
                            are_parallel(middle.tangent, normal, node.tangent) &&
                            !scene_.curves.separate(image, node.image);
      if (is_other) others.push_back(node.point);
      return others.size() >= company;
    });
  }

  Hatches kept() const {
    Hatches result;
    for (std::size_t h = 0; h < lines_.size(); ++h) {
      if (lines_[h].empty()) continue;
      for (const HatchSample& s : lines_[h]) result.curves.push(s.point);
      result.curves.close_list();
      result.kinds.push_back(hatches_.kinds[h]);
      result.objects.push_back(hatches_.objects[h]);
    }
    return result;
  }

  const Hatches& hatches_;
  const HatchScene& scene_;
  const HatchOptions& options_;
  HatchArea area_;
  Walker walker_;
  NeighbourGrid grid_;
  Tracer tracer_;
  std::vector<HatchLine> lines_;  // that are kept; empty: left out
};

}  // namespace

Hatches without_crumbs(const Hatches& hatches, const HatchScene& scene,
                       const HatchOptions& options) {
  return Sweeper(hatches, scene, options).run();
}

void mark_undercuts(Hatches& hatches, const ToneMap& tone) {
  const Ragged<HatchPoint>& curves = hatches.curves;
  for (std::size_t h = 0; h < hatches.kinds.size(); ++h) {
    const Span<const HatchPoint> curve = curves[h];
    double inside = 0;
    for (std::size_t i = 1; i < curve.size(); ++i) {
      const Vec2 middle = (curve[i - 1].image + curve[i].image) / 2;
      const bool is_inside = region_of(tone, middle) == Region::undercut;
      inside += is_inside ? (curve[i].image - curve[i - 1].image).norm() : 0;
    }
    if (2 * inside > length_px(curve)) hatches.kinds[h] = Kind::undercut;
  }
}

}  // namespace illustrate
