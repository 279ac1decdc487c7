// Strokes as pixels.
#include "bindings/arrays.h"
#include "bindings/bind.h"
#include "stroke/rasterise.h"

namespace illustrate::bindings {
namespace {

constexpr int most_pixels_across = 1 << 15;

std::vector<Colour> read_colours(const py::object& value, const std::string& name) {
  using Rows = py::array_t<std::uint8_t, py::array::c_style | py::array::forcecast>;
  const Rows rows = Rows::ensure(value);
  if (!rows || rows.ndim() != 2 || rows.shape(1) != 4) {
    throw InvalidInput(name + " must be (n, 4), red, green, blue, alpha in [0, 255]");
  }
  std::vector<Colour> colours(static_cast<std::size_t>(rows.shape(0)));
  for (std::size_t i = 0; i < colours.size(); ++i) {
    std::copy_n(rows.data() + 4 * i, 4, colours[i].begin());
  }
  return colours;
}

void require(bool good, const std::string& message) {
  if (!good) throw InvalidInput(message);
}

void check(const RoundStrokes& strokes) {
  const std::size_t count = strokes.closed.size();
  require(strokes.widths.size() == strokes.image.size(), "widths must be one for each point");
  require(strokes.offsets.size() == count + 1, "offsets must be one more than strokes");
  require(strokes.colours.size() == count, "colours must be one for each stroke");
  require(strokes.offsets.front() == 0 &&
              strokes.offsets.back() == static_cast<int>(strokes.image.size()) &&
              std::is_sorted(strokes.offsets.begin(), strokes.offsets.end()),
          "offsets must ascend from 0 to the number of points");
}

py::array picture(const py::object& image, const py::object& widths, const py::object& offsets,
                  const py::object& closed, const py::object& colours, int width_px, int height_px,
                  const py::object& paper, int threads) {
  const ImagePoints points = read_pairs(image, "image");
  const std::vector<double> wide = read_numbers(widths, "widths");
  const std::vector<int> starts = read_indices(offsets, "offsets");
  std::vector<std::uint8_t> is_closed;
  for (const double value : read_numbers(closed, "closed")) is_closed.push_back(value != 0);
  const std::vector<Colour> inks = read_colours(colours, "colours");
  const std::vector<float> widths_px(wide.begin(), wide.end());
  const auto is_size = [](int px) { return px > 0 && px <= most_pixels_across; };
  require(is_size(width_px) && is_size(height_px), "width_px and height_px must be in [1, 32768]");
  const std::vector<Colour> sheet = read_colours(py::make_tuple(paper), "paper");
  const RoundStrokes strokes{points, widths_px, starts, is_closed, inks};
  check(strokes);
  auto pixels = std::make_shared<std::vector<Colour>>();
  {
    const py::gil_scoped_release release;
    *pixels = rasterise(strokes, width_px, height_px, sheet[0], threads);
  }
  return view_of(pixels, pixels->data(), py::dtype::of<std::uint8_t>(), {height_px, width_px, 4});
}

}  // namespace

void bind_picture(py::module_& m) {
  using namespace py::literals;
  m.def("rasterise", &picture, "image"_a, "widths"_a, "offsets"_a, "closed"_a, "colours"_a,
        "width_px"_a, "height_px"_a, "paper"_a = py::make_tuple(255, 255, 255, 255),
        "threads"_a = 0, "Strokes as pixels.");
}

}  // namespace illustrate::bindings
