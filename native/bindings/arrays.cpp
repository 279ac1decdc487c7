#include "bindings/arrays.h"

#include <limits>

#include "core/errors.h"

namespace illustrate::bindings {
namespace {

constexpr py::ssize_t any_length = -1;

py::array array_like(const py::object& value, const std::string& name) {
  try {
    return py::module_::import("numpy").attr("asarray")(value).cast<py::array>();
  } catch (const py::error_already_set& error) {
    // What numpy itself says of a value; a lack of memory, or an object's own errors, pass through.
    if (!error.matches(PyExc_ValueError) && !error.matches(PyExc_TypeError)) throw;
    throw InvalidInput(name + " cannot be read as an array");
  }
}

std::string in_words(const Shape& shape, const char* free_name) {
  std::string words = "(";
  for (std::size_t i = 0; i < shape.size(); ++i) {
    words += shape[i] == any_length ? free_name : std::to_string(shape[i]);
    if (i + 1 < shape.size() || shape.size() == 1) words += i + 1 < shape.size() ? ", " : ",";
  }
  return words + ")";
}

// An empty list has no columns to be wrong about.
bool fits(const py::array& array, const Shape& expected) {
  if (array.size() == 0 && array.ndim() == 1 && expected[0] == any_length) return true;
  if (array.ndim() != length(expected.size())) return false;
  for (std::size_t i = 0; i < expected.size(); ++i) {
    if (expected[i] != any_length && array.shape(length(i)) != expected[i]) return false;
  }
  return true;
}

void require_shape(const py::array& array, const Shape& expected, const std::string& name) {
  if (fits(array, expected)) return;
  const Shape shape(array.shape(), array.shape() + array.ndim());
  throw InvalidInput(name + " has shape " + in_words(shape, "") + ", expected " +
                     in_words(expected, "n"));
}

std::string dtype_name(const py::array& array) { return py::str(py::object(array.dtype())); }

using Doubles = py::array_t<double, py::array::c_style | py::array::forcecast>;
using Integers = py::array_t<std::int64_t, py::array::c_style | py::array::forcecast>;

Doubles doubles(const py::object& value, const Shape& shape, const std::string& name) {
  const py::array array = array_like(value, name);
  require_shape(array, shape, name);
  const char kind = array.dtype().kind();
  // Floats, signed and unsigned integers, booleans.
  if (std::string("fiub").find(kind) == std::string::npos) {
    throw InvalidInput(name + " must hold numbers, but holds " + dtype_name(array));
  }
  return Doubles(array);
}

std::vector<int> integers(const py::object& value, const Shape& shape, const std::string& name) {
  const py::array array = array_like(value, name);
  require_shape(array, shape, name);
  const char kind = array.dtype().kind();
  const bool is_empty = array.size() == 0;
  // True is no index, and an empty list has numpy's usual type, which is a float.
  if (!is_empty && kind != 'i' && kind != 'u') {
    throw InvalidInput(name + " must hold integers, but holds " + dtype_name(array));
  }
  const Integers wide(array);
  std::vector<int> narrow(static_cast<std::size_t>(wide.size()));
  for (std::size_t i = 0; i < narrow.size(); ++i) {
    const std::int64_t number = wide.data()[i];
    if (number < std::numeric_limits<int>::min() || number > std::numeric_limits<int>::max()) {
      throw InvalidInput(name + "[" + std::to_string(i) + "] is out of range");
    }
    narrow[i] = static_cast<int>(number);
  }
  return narrow;
}

}  // namespace

std::vector<double> read_numbers(const py::object& value, const std::string& name) {
  const Doubles array = doubles(value, {any_length}, name);
  return {array.data(), array.data() + array.size()};
}

std::vector<int> read_indices(const py::object& value, const std::string& name) {
  return integers(value, {any_length}, name);
}

std::vector<Edge> read_edges(const py::object& value, const std::string& name) {
  const std::vector<int> flat = integers(value, {any_length, 2}, name);
  std::vector<Edge> edges(flat.size() / 2);
  for (std::size_t i = 0; i < edges.size(); ++i) edges[i] = {flat[2 * i], flat[2 * i + 1]};
  return edges;
}

Points read_points(const py::object& value, const std::string& name) {
  const Doubles array = doubles(value, {any_length, 3}, name);
  Points points(static_cast<std::size_t>(array.size()) / 3);
  for (std::size_t i = 0; i < points.size(); ++i) points[i] = Vec3(array.data() + 3 * i);
  return points;
}

ImagePoints read_pairs(const py::object& value, const std::string& name) {
  const Doubles array = doubles(value, {any_length, 2}, name);
  ImagePoints pairs(static_cast<std::size_t>(array.size()) / 2);
  for (std::size_t i = 0; i < pairs.size(); ++i) pairs[i] = Vec2(array.data() + 2 * i);
  return pairs;
}

Vec3 read_vector(const py::object& value, const std::string& name) {
  return Vec3(doubles(value, {3}, name).data());
}

Mat4 read_matrix(const py::object& value, const std::string& name) {
  const Doubles array = doubles(value, {4, 4}, name);
  return Eigen::Map<const Eigen::Matrix<double, 4, 4, Eigen::RowMajor>>(array.data());
}

int read_integer(const py::object& value, const std::string& name) {
  if (!PyIndex_Check(value.ptr())) throw InvalidInput(name + " must be an integer");
  // As Python's own indices: numpy's integers too, but no floats, not even whole ones.
  const auto whole = py::reinterpret_steal<py::object>(PyNumber_Index(value.ptr()));
  if (!whole) throw py::error_already_set();
  int overflow = 0;
  const long number = PyLong_AsLongAndOverflow(whole.ptr(), &overflow);
  if (overflow != 0 || number < std::numeric_limits<int>::min() ||
      number > std::numeric_limits<int>::max()) {
    throw InvalidInput(name + " is out of range");
  }
  return static_cast<int>(number);
}

double read_number(const py::object& value, const std::string& name) {
  return *doubles(value, {}, name).data();
}

py::array view_of(const Owner& owner, const void* data, const py::dtype& dtype, const Shape& shape,
                  std::size_t row_bytes) {
  Shape strides;
  if (row_bytes > 0) strides.push_back(length(row_bytes));
  if (row_bytes > 0 && shape.size() > 1) strides.push_back(dtype.itemsize());
  const py::capsule keeper(new Owner(owner), [](void* held) { delete static_cast<Owner*>(held); });
  py::array view(dtype, shape, strides, data, keeper);
  // Results are shared: by other views, by threads that draw, by the drawing of the next frame.
  view.attr("setflags")(py::arg("write") = false);
  return view;
}

}  // namespace illustrate::bindings
