#include "surface/jets/curvature_derivative.h"

#include <algorithm>
#include <cmath>

#include "core/parallel.h"
#include "core/radix_sort.h"
#include "core/ragged.h"

namespace illustrate {

namespace {

using Vec4d = Eigen::Vector4d;

// The second fundamental form in the frame of a vertex: II(w1, w1), II(w1, w2), II(w2, w2).
using Form = Eigen::Vector3d;

// A vertex joined by an edge, as seen from another one.
struct Neighbour {
  int vertex;
  double sign;  // -1 where its normal belongs to the other sheet
  // The first direction of the one that looks, turned into the neighbour's tangent plane, in the
  // neighbour's frame.
  double cosine, sine;

  // A form of the neighbour, in the frame and on the sheet of the one that looks.
  Form seen(const Form& f) const {
    const double cc = cosine * cosine, ss = sine * sine, cs = cosine * sine;
    const double across = cs * (f[2] - f[0]) + (cc - ss) * f[1];
    return Form(sign * (cc * f[0] + 2 * cs * f[1] + ss * f[2]), across,
                sign * (ss * f[0] - 2 * cs * f[1] + cc * f[2]));
  }
};

// The tangent t at normal n, turned with n into m by the shortest way.
Vec3 turned(const Vec3& t, const Vec3& n, const Vec3& m) {
  const double cosine = n.dot(m);
  // Between nearly opposite normals the way is none, or rounding.
  return cosine < -0.99 ? t : Vec3(t - t.dot(m) / (1 + cosine) * (n + m));
}

// A vertex, its neighbour, and whether they are on one sheet, as they are sorted.
class Links {
 public:
  explicit Links(const Surface& surface) {
    while (surface.positions.size() >> vertex_bits_) ++vertex_bits_;
    keys_.reserve(6 * surface.triangles.size());
    for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
      for (int k = 0; k < 3; ++k) {
        const int triangle = static_cast<int>(t), next = next_corner(k);
        const int a = surface.triangles[t][idx(k)], b = surface.triangles[t][idx(next)];
        const bool same = surface.corner_sign(triangle, k) == surface.corner_sign(triangle, next);
        add(a, b, same);
        add(b, a, same);
      }
    }
    radix_sort(keys_, 2 * vertex_bits_ + 1, [](std::uint64_t key) { return key; });
    keys_.erase(std::unique(keys_.begin(), keys_.end()), keys_.end());
  }

  std::size_t size() const { return keys_.size(); }
  std::size_t vertex(std::size_t i) const { return keys_[i] >> (vertex_bits_ + 1); }
  int neighbour(std::size_t i) const {
    return static_cast<int>(keys_[i] >> 1 & ((std::uint64_t{1} << vertex_bits_) - 1));
  }
  double sign(std::size_t i) const { return (keys_[i] & 1) != 0 ? 1 : -1; }

 private:
  void add(int vertex, int neighbour, bool same) {
    const auto v = static_cast<std::uint64_t>(vertex), n = static_cast<std::uint64_t>(neighbour);
    keys_.push_back((v << vertex_bits_ | n) << 1 | static_cast<std::uint64_t>(same));
  }

  int vertex_bits_ = 0;
  std::vector<std::uint64_t> keys_;
};

// The neighbours of all vertices; frames are w1 and the normal times w1.
Ragged<Neighbour> find_neighbours(const Surface& surface, const Curvature& curvature) {
  const Links links(surface);
  Ragged<Neighbour> result;
  std::size_t next = 0;
  for (std::size_t v = 0; v < surface.positions.size(); ++v) {
    for (; next < links.size() && links.vertex(next) == v; ++next) {
      const std::size_t j = idx(links.neighbour(next));
      const double sign = links.sign(next);
      const Vec3 x = turned(curvature[v].w1, surface.normals[v], sign * surface.normals[j]);
      result.push({links.neighbour(next), sign, x.dot(curvature[j].w1),
                   x.dot(surface.normals[j].cross(curvature[j].w1))});
    }
    result.close_list();
  }
  return result;
}

class CubicFit {
 public:
  void add(const Vec2& step, const Form& change) {
    const double x = step.x(), y = step.y();
    add_row(Vec4d(x, y, 0, 0), change[0], 1);
    // II(w1, w2) stands twice in the form.
    add_row(Vec4d(0, x, y, 0), change[1], 2);
    add_row(Vec4d(0, 0, x, y), change[2], 1);
  }

  CubicForm solve() const {
    const double trace = matrix_.trace();
    if (!(trace > 0) || !right_.allFinite()) return {};
    // Neighbours on one line leave a part of C open: that becomes 0.
    const Eigen::Matrix4d regular = matrix_ + 1e-9 * trace * Eigen::Matrix4d::Identity();
    const Vec4d c = regular.ldlt().solve(right_);
    if (!c.allFinite()) return {};
    return {c[0], c[1], c[2], c[3]};
  }

 private:
  void add_row(const Vec4d& row, double value, double weight) {
    matrix_ += weight * row * row.transpose();
    right_ += weight * value * row;
  }

  Eigen::Matrix4d matrix_ = Eigen::Matrix4d::Zero();
  Vec4d right_ = Vec4d::Zero();
};

CubicForm fit(const Surface& surface, Span<const Neighbour> around, const std::vector<Form>& forms,
              const Vec3& w1, std::size_t v) {
  CubicFit result;
  const Vec3 w2 = surface.normals[v].cross(w1);
  for (const Neighbour& n : around) {
    const Vec3 d = surface.positions[idx(n.vertex)] - surface.positions[v];
    result.add(Vec2(d.dot(w1), d.dot(w2)), n.seen(forms[idx(n.vertex)]) - forms[v]);
  }
  return result.solve();
}

// Derivative of C(w1, w1, w1) along w1, w1 of the neighbours turned to agree with that of v.
double second_derivative(const Surface& surface, Span<const Neighbour> around,
                         const CurvatureDerivative& d, std::size_t v) {
  Eigen::Matrix2d matrix = Eigen::Matrix2d::Zero();
  Vec2 right = Vec2::Zero();
  for (const Neighbour& n : around) {
    const std::size_t j = idx(n.vertex);
    const Vec3 step = surface.positions[j] - surface.positions[v];
    const Vec2 flat(step.dot(d.curvature[v].w1), step.dot(d.curvature[v].w2));
    const double there = (n.cosine < 0 ? -n.sign : n.sign) * d.cubics[j][0];
    matrix += flat * flat.transpose();
    right += (there - d.cubics[v][0]) * flat;
  }
  const double determinant = matrix.determinant();
  if (!(determinant > 1e-9 * matrix.squaredNorm())) return 0;
  return (matrix.inverse() * right)[0];
}

// How far noise of the mesh is smoothed away, as share of an object's diagonal: below what is drawn
// as a line of its own.
constexpr double smoothing = 0.009;
// Where the mesh is much finer than in the middle less is smoothed, so that the work is bounded.
// most_time is 128 passes over the mesh (see `diffuse`).
constexpr double finest = 4;
constexpr double most_time = 2000;

// (n) how long each vertex has to diffuse, 1: until it is the mean of its neighbours.
std::vector<double> diffusion_times(const Surface& surface, const Ragged<Neighbour>& neighbours) {
  const std::vector<double>& sizes = surface.object_diagonals;
  std::vector<double> times(surface.positions.size(), 0);
  std::vector<std::vector<double>> of_object(sizes.size());
  for (std::size_t v = 0; v < times.size(); ++v) {
    double squares = 0;
    for (const Neighbour& n : neighbours[v]) {
      squares += (surface.positions[idx(n.vertex)] - surface.positions[v]).squaredNorm();
    }
    const double reach = smoothing * sizes[idx(surface.objects[v])];
    if (squares > 0) {
      times[v] = 2 * reach * reach * static_cast<double>(neighbours[v].size()) / squares;
    }
    of_object[idx(surface.objects[v])].push_back(times[v]);
  }
  for (auto& list : of_object) {
    if (list.empty()) list.push_back(0);
    const auto middle = list.begin() + static_cast<std::ptrdiff_t>(list.size() / 2);
    std::nth_element(list.begin(), middle, list.end());
    list[0] = std::min(finest * *middle, most_time);
  }
  for (std::size_t v = 0; v < times.size(); ++v) {
    times[v] = std::min(times[v], of_object[idx(surface.objects[v])][0]);
  }
  return times;
}

// One stage: what a form becomes, weights of what it is now and was before.
struct Stage {
  double now, before, change;
};

void run_stage(const Ragged<Neighbour>& neighbours, const std::vector<double>& times,
               const Stage& stage, int threads, std::vector<Form>& forms,
               std::vector<Form>& before) {
  std::vector<Form> next(forms.size());
  parallel_for(forms.size(), threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) {
      Form sum = Form::Zero();
      for (const Neighbour& n : neighbours[v]) sum += n.seen(forms[idx(n.vertex)]);
      const auto count = static_cast<double>(neighbours[v].size());
      const Form change = count > 0 ? Form(sum / count - forms[v]) : Form(Form::Zero());
      next[v] = stage.now * forms[v] + stage.before * before[v] + stage.change * times[v] * change;
    }
  });
  before.swap(forms);
  forms.swap(next);
}

// Runge-Kutta-Legendre steps (Meyer, Balsara, Aslam 2012), whose s stages go as far as
// (s^2 + s) / 2 explicit ones; a few of them, since one hardly damps what is finest.
void diffuse(const Ragged<Neighbour>& neighbours, const std::vector<double>& times, int threads,
             const Progress& progress, std::vector<Form>& forms) {
  constexpr int steps = 4;
  const double longest = *std::max_element(times.begin(), times.end()) / steps;
  const int stages = std::max(2, static_cast<int>(std::ceil(std::sqrt(2 * longest))));
  std::vector<Form> before = forms;
  for (int step = 0; step < steps; ++step) {
    for (int j = 1; j <= stages; ++j) {
      progress.report((step + double(j) / stages) / steps);
      const double now = (2.0 * j - 1) / j;
      const Stage stage{now, 1 - now, 2 * now / (stages * (stages + 1.0)) / steps};
      run_stage(neighbours, times, stage, threads, forms, before);
    }
  }
}

// The curvature of smoothed forms, which are brought into its frames.
Curvature smoothed(const Surface& surface, const Curvature& rough, int threads,
                   const Progress& progress, std::vector<Form>& forms) {
  progress.report(0);
  const Ragged<Neighbour> neighbours = find_neighbours(surface, rough);
  diffuse(neighbours, diffusion_times(surface, neighbours), threads, progress, forms);
  Curvature result = rough;
  for (std::size_t v = 0; v < forms.size(); ++v) {
    const Vec3& n = surface.normals[v];
    const Vec3 &w1 = rough[v].w1, w2 = n.cross(w1);
    result[v] = principal_curvature(w1, w2, forms[v][0] * n, forms[v][1] * n, forms[v][2] * n, n);
    forms[v] = Form(result[v].k1, 0, result[v].k2);
  }
  return result;
}

}  // namespace

CurvatureDerivative curvature_derivative(const Surface& surface, const Curvature& curvature,
                                         int threads, const Progress& progress) {
  const std::size_t count = surface.positions.size();
  CurvatureDerivative result{curvature, std::vector<CubicForm>(count), std::vector<double>(count)};
  if (count == 0) return result;
  std::vector<Form> forms;
  for (std::size_t v = 0; v < count; ++v) forms.emplace_back(curvature[v].k1, 0, curvature[v].k2);
  result.curvature = smoothed(surface, curvature, threads, progress.part(0, 0.6), forms);
  const Ragged<Neighbour> neighbours = find_neighbours(surface, result.curvature);
  parallel_for(count, threads, progress.part(0.6, 0.9), [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) {
      result.cubics[v] = fit(surface, neighbours[v], forms, result.curvature[v].w1, v);
    }
  });
  parallel_for(count, threads, progress.part(0.9, 1), [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) {
      result.second[v] = second_derivative(surface, neighbours[v], result, v);
    }
  });
  progress.report(1);
  return result;
}

}  // namespace illustrate
