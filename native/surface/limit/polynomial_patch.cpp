#include "surface/limit/polynomial_patch.h"

#include <algorithm>

namespace illustrate {
namespace {

using Mat4x4 = std::array<std::array<double, 4>, 4>;

// From values and slopes at 0 and 1 to the coefficients of a cubic.
constexpr Mat4x4 hermite{{{1, 0, 0, 0}, {0, 0, 1, 0}, {-3, 3, -2, -1}, {2, -2, 1, 1}}};

// From four control points of a uniform B-spline, six times.
constexpr Mat4x4 spline{{{1, 4, 1, 0}, {-3, 0, 3, 0}, {3, -6, 3, 0}, {-1, 3, -3, 1}}};

// From the twelve control points of Loop's box spline (Stam 1998, "Evaluation of Loop subdivision
// surfaces") to the coefficients of its quartic, twelve times.
constexpr std::array<std::array<double, 12>, 15> box{{
    {1, 1, 0, 1, 6, 1, 0, 1, 1, 0, 0, 0},
    {-4, -2, 0, -2, 0, 2, 0, 2, 4, 0, 0, 0},
    {6, 0, 0, 0, -12, 0, 0, 0, 6, 0, 0, 0},
    {-4, 2, 0, 2, 8, -4, 0, -4, -4, 2, 2, 0},
    {1, -1, 0, -1, -1, 2, 0, 2, -1, -1, -1, 1},
    {-2, 2, 0, -4, 0, 4, 0, -2, 2, 0, 0, 0},
    {6, -6, 0, 6, -12, 6, 0, -6, 6, 0, 0, 0},
    {-6, 6, 0, 0, 12, -12, 0, 0, -6, 6, 0, 0},
    {2, -2, 0, -2, -2, 4, 0, 4, -2, -2, -2, 2},
    {0, 0, 0, 6, -12, 6, 0, 0, 0, 0, 0, 0},
    {0, 0, 0, -6, 12, -6, 0, 6, -12, 6, 0, 0},
    {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0},
    {2, -4, 2, -4, 8, -4, 0, 2, -4, 2, 0, 0},
    {-2, 4, -2, 2, -2, -2, 2, -2, 4, -2, 0, 0},
    {-1, 2, -1, 1, -1, -1, 1, -1, 2, -1, 0, 0},
}};

// The coefficients of a cubic from four points that lie `step` apart.
std::array<Vec3, 4> spline_cubic(const Vec3* controls, std::size_t step) {
  std::array<Vec3, 4> cubic;
  for (std::size_t i = 0; i < 4; ++i) {
    cubic[i] = spline[i][0] / 6 * controls[0];
    for (std::size_t a = 1; a < 4; ++a) cubic[i] += spline[i][a] / 6 * controls[a * step];
  }
  return cubic;
}

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

// The rows of a polynomial, those of the powers of u, at one v, with their derivatives.
template <int count>
struct Rows {
  using Block = Eigen::Matrix<double, 3, count>;
  Block f, fv, fvv;
};

// Horner's rule in v, of all rows of a bicubic at once; c: coefficients of v^0, v^1, ...
Rows<4> cubic_rows(const Vec3* c, double v) {
  using Block = Rows<4>::Block;
  const auto power = [c](int j) {
    return Eigen::Map<const Block, Eigen::Aligned16>(c[4 * j].data());
  };
  Rows<4> rows;
  rows.f = v * power(3) + power(2);
  rows.fv = v * power(3) + rows.f;
  rows.fvv = v * (2 * power(3)) + 2 * rows.fv;
  rows.f = v * rows.f + power(1);
  rows.fv = v * rows.fv + rows.f;
  rows.f = v * rows.f + power(0);
  return rows;
}

// Horner's rule in v, without the products with what is still zero; c: of row i the coefficients of
// u^i v^0 to u^i v^(4 - i), and then those of the next row.
Rows<5> quartic_rows(const Vec3* c, double v) {
  Rows<5> rows;
  for (int i = 0; i < 5; c += 5 - i, ++i) {
    Vec3 f = c[4 - i], fv = Vec3::Zero(), fvv = Vec3::Zero();
    for (int j = 3 - i; j >= 0; --j) {
      const int done = 4 - i - j;
      if (done > 2) fvv = v * fvv + 2 * fv;
      if (done == 2) fvv = 2 * fv;
      fv = done > 1 ? Vec3(v * fv + f) : f;
      f = v * f + c[j];
    }
    rows.f.col(i) = f;
    rows.fv.col(i) = fv;
    rows.fvv.col(i) = fvv;
  }
  return rows;
}

// Horner's rule in u.
template <int count>
LimitPoint join(const Rows<count>& rows, double u) {
  const Vec3 zero = Vec3::Zero();
  const int top = count - 1;
  LimitPoint p{rows.f.col(top), zero, rows.fv.col(top), zero, zero, rows.fvv.col(top)};
  for (int i = top - 1; i >= 0; --i) {
    const int done = top - i;
    if (done > 2) p.duu = u * p.duu + 2 * p.du;
    if (done == 2) p.duu = 2 * p.du;
    p.du = done > 1 ? Vec3(u * p.du + p.position) : p.position;
    p.position = u * p.position + rows.f.col(i);
    p.duv = done > 1 ? Vec3(u * p.duv + p.dv) : p.dv;
    p.dv = u * p.dv + rows.fv.col(i);
    p.dvv = u * p.dvv + rows.fvv.col(i);
  }
  return p;
}

}  // namespace

PolynomialPatch PolynomialPatch::b_spline(const std::array<Vec3, 16>& controls) {
  std::array<Vec3, 16> rows;  // row j: of v^j, at the four columns
  for (std::size_t column = 0; column < 4; ++column) {
    const std::array<Vec3, 4> cubic = spline_cubic(controls.data() + column, 4);
    for (std::size_t j = 0; j < 4; ++j) rows[4 * j + column] = cubic[j];
  }
  PolynomialPatch patch;
  for (std::size_t j = 0; j < 4; ++j) {
    const std::array<Vec3, 4> cubic = spline_cubic(rows.data() + 4 * j, 1);
    std::copy(cubic.begin(), cubic.end(), patch.coefficients_.begin() + static_cast<int>(4 * j));
  }
  return patch;
}

PolynomialPatch PolynomialPatch::box_spline(const std::array<Vec3, 12>& controls) {
  PolynomialPatch patch;
  patch.triangular_ = true;
  patch.coefficients_.fill(Vec3::Zero());
  for (std::size_t c = 0; c < box.size(); ++c) {
    for (std::size_t p = 0; p < controls.size(); ++p) {
      patch.coefficients_[c] += box[c][p] * controls[p];
    }
    patch.coefficients_[c] /= 12;
  }
  return patch;
}

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
      patch.coefficients_[4 * j + i] = sum;
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

LimitPoint PolynomialPatch::evaluate(const Vec2& uv) const {
  const Vec3* c = coefficients_.data();
  return triangular_ ? join(quartic_rows(c, uv.y()), uv.x()) : join(cubic_rows(c, uv.y()), uv.x());
}

}  // namespace illustrate
