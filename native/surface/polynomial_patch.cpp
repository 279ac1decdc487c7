#include "surface/polynomial_patch.h"

#include <algorithm>

namespace illustrate {
namespace {

using Mat4x4 = std::array<std::array<double, 4>, 4>;

// From values and slopes at 0 and 1 to the coefficients of a cubic.
constexpr Mat4x4 hermite{{{1, 0, 0, 0}, {0, 0, 1, 0}, {-3, 3, -2, -1}, {2, -2, 1, 1}}};

const std::array<Vec2, 15>& quartic_places() {
  static const std::array<Vec2, 15> places = [] {
    std::array<Vec2, 15> result;
    std::size_t filled = 0;
    for (int i = 0; i < 5; ++i) {
      for (int j = 0; i + j < 5; ++j) result[filled++] = Vec2(i, j) / 4;
    }
    return result;
  }();
  return places;
}

using Mat15 = Eigen::Matrix<double, 15, 15>;

Mat15 inverse_vandermonde() {
  Mat15 values;
  const std::array<Vec2, 15>& places = quartic_places();
  for (int p = 0; p < 15; ++p) {
    const Vec2& at = places[idx(p)];
    int column = 0;
    double u = 1;
    for (int i = 0; i < 5; ++i, u *= at.x()) {
      double v = 1;
      for (int j = 0; i + j < 5; ++j, v *= at.y()) values(p, column++) = u * v;
    }
  }
  return values.inverse();
}

}  // namespace

PolynomialPatch PolynomialPatch::bicubic(const std::array<LimitPoint, 4>& c) {
  // Rows: at u = 0, at u = 1, du there; columns the same of v.
  const std::array<std::array<Vec3, 4>, 4> data{{{c[0].position, c[2].position, c[0].dv, c[2].dv},
                                                 {c[1].position, c[3].position, c[1].dv, c[3].dv},
                                                 {c[0].du, c[2].du, c[0].duv, c[2].duv},
                                                 {c[1].du, c[3].du, c[1].duv, c[3].duv}}};
  PolynomialPatch patch;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 4; ++j) {
      Vec3 sum = Vec3::Zero();
      for (std::size_t a = 0; a < 4; ++a) {
        for (std::size_t b = 0; b < 4; ++b) sum += hermite[i][a] * hermite[j][b] * data[a][b];
      }
      patch.coefficients_[4 * i + j] = sum;
    }
  }
  return patch;
}

PolynomialPatch PolynomialPatch::quartic(const std::function<Vec3(const Vec2& uv)>& position) {
  std::array<Vec3, 15> values;
  std::transform(quartic_places().begin(), quartic_places().end(), values.begin(), position);
  static const Mat15 inverse = inverse_vandermonde();
  PolynomialPatch patch;
  patch.triangular_ = true;
  patch.coefficients_.fill(Vec3::Zero());
  for (int c = 0; c < 15; ++c) {
    for (int p = 0; p < 15; ++p) patch.coefficients_[idx(c)] += inverse(c, p) * values[idx(p)];
  }
  return patch;
}

template <int rows, bool triangular>
LimitPoint PolynomialPatch::evaluate_rows(double u, double v) const {
  LimitPoint p{Vec3::Zero(), Vec3::Zero(), Vec3::Zero(), Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};
  const Vec3* end = coefficients_.data() + (triangular ? 15 : 16);
  for (int i = rows - 1; i >= 0; --i) {  // Horner's rule in u, of Horner's rule in v
    const int length = triangular ? rows - i : rows;
    end -= length;
    Vec3 f = Vec3::Zero(), fv = Vec3::Zero(), fvv = Vec3::Zero();
    for (int j = length - 1; j >= 0; --j) {
      fvv = v * fvv + 2 * fv;
      fv = v * fv + f;
      f = v * f + end[j];
    }
    p.duu = u * p.duu + 2 * p.du;
    p.du = u * p.du + p.position;
    p.position = u * p.position + f;
    p.duv = u * p.duv + p.dv;
    p.dv = u * p.dv + fv;
    p.dvv = u * p.dvv + fvv;
  }
  return p;
}

LimitPoint PolynomialPatch::evaluate(const Vec2& uv) const {
  return triangular_ ? evaluate_rows<5, true>(uv.x(), uv.y())
                     : evaluate_rows<4, false>(uv.x(), uv.y());
}

}  // namespace illustrate
