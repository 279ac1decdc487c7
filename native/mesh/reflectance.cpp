#include "mesh/reflectance.h"

#include <algorithm>
#include <cmath>

#include "core/errors.h"

namespace illustrate {
namespace {

// The number of a texel that lies outside; none: black.
int wrapped(int i, int count, Wrap wrap) {
  const auto remainder = [](int a, int b) { return (a % b + b) % b; };
  switch (wrap) {
    case Wrap::repeat:
      return remainder(i, count);
    case Wrap::mirror: {
      const int twice = remainder(i, 2 * count);
      return std::min(twice, 2 * count - 1 - twice);
    }
    case Wrap::extend:
      return std::clamp(i, 0, count - 1);
    default:
      return i >= 0 && i < count ? i : none;
  }
}

// Beyond this many times round a texture nothing is told apart.
constexpr double farthest_uv = 1e4;

}  // namespace

Texture::Texture(int width, int height, std::vector<float> luminance, Wrap wrap) : wrap_(wrap) {
  if (width < 1 || height < 1 || luminance.size() != idx(width) * idx(height)) {
    throw InvalidInput("luminance must have at least one row and one column");
  }
  for (float& value : luminance) value = value > 0 && std::isfinite(value) ? value : 0.0F;
  levels_.push_back({width, height, std::move(luminance)});
  while (levels_.back().width > 1 || levels_.back().height > 1) {
    const Level& fine = levels_.back();
    Level coarse{std::max(1, fine.width / 2), std::max(1, fine.height / 2), {}};
    for (int row = 0; row < coarse.height; ++row) {
      for (int column = 0; column < coarse.width; ++column) {
        // A side of one texel counts twice, of an odd side the last texel is lost: neither shows in
        // a mean over so many.
        const int right = std::min(2 * column + 1, fine.width - 1);
        const int above = std::min(2 * row + 1, fine.height - 1);
        const double sum = texel(fine, 2 * column, 2 * row) + texel(fine, right, 2 * row) +
                           texel(fine, 2 * column, above) + texel(fine, right, above);
        coarse.values.push_back(static_cast<float>(sum / 4));
      }
    }
    levels_.push_back(std::move(coarse));
  }
}

double Texture::texel(const Level& level, int column, int row) const {
  const int x = wrapped(column, level.width, wrap_), y = wrapped(row, level.height, wrap_);
  if (x == none || y == none) return 0;
  return level.values[idx(y) * idx(level.width) + idx(x)];
}

double Texture::at(const Level& level, const Vec2& uv) const {
  const Vec2 place = uv.cwiseProduct(Vec2(level.width, level.height)) - Vec2(0.5, 0.5);
  const Vec2 low = place.array().floor(), share = place - low;
  const int column = static_cast<int>(low.x()), row = static_cast<int>(low.y());
  const auto along = [&](int y) {
    return (1 - share.x()) * texel(level, column, y) + share.x() * texel(level, column + 1, y);
  };
  return (1 - share.y()) * along(row) + share.y() * along(row + 1);
}

double Texture::mean_at(const Vec2& uv, double texels) const {
  if (!uv.allFinite() || uv.cwiseAbs().maxCoeff() > farthest_uv) return 0;
  const double highest = static_cast<double>(levels_.size() - 1);
  const double halvings = std::log(std::max(texels, 1.0)) / std::log(2.0);
  const double level = std::clamp(halvings, 0.0, highest);
  const auto fine = static_cast<std::size_t>(level);
  const double share = level - std::floor(level);
  const double value = at(levels_[fine], uv);
  // On the highest level, which has none above it, share is 0.
  return share > 0 ? (1 - share) * value + share * at(levels_[fine + 1], uv) : value;
}

double Texture::size() const {
  return std::sqrt(static_cast<double>(levels_[0].width) * levels_[0].height);
}

}  // namespace illustrate
