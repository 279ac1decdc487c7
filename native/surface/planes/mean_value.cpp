#include "surface/planes/mean_value.h"

namespace illustrate {
namespace {

// Of an angle with this sine and cosine, each times `size`. Of two ways that are equal but for
// rounding the one that takes no difference of near numbers: seen along its line, a piece fills
// next to nothing.
double tan_of_half(double sine, double cosine, double size) {
  return cosine > 0 ? sine / (size + cosine) : (size - cosine) / sine;
}

}  // namespace

Vec2 mean_value(const std::vector<BorderPiece>& border, const Vec2& at) {
  Vec2 sum = Vec2::Zero();
  double weights = 0;
  for (const BorderPiece& piece : border) {
    const Vec2 a = piece.from - at, b = piece.to - at;
    const double from = a.norm(), to = b.norm(), ahead = a.dot(b), aside = cross(a, b);
    if (from == 0) return piece.value_from;
    if (to == 0) return piece.value_to;
    if (aside == 0) {
      if (ahead > 0) continue;
      return (to * piece.value_from + from * piece.value_to) / (from + to);
    }
    const double half_tan = tan_of_half(aside, ahead, from * to);  // the angle that it fills
    sum += half_tan / from * piece.value_from + half_tan / to * piece.value_to;
    weights += half_tan / from + half_tan / to;
  }
  return weights != 0 ? Vec2(sum / weights) : Vec2::Zero();
}

}  // namespace illustrate
