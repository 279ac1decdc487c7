// Between numpy arrays and the core's vectors.
//
// Reading accepts what numpy.asarray accepts: lists, any dtype, strides and order; integers are
// never read from floating-point numbers. Wrong shapes and types throw InvalidInput that names the
// argument. Arrays that are handed out are read-only views, which keep their owner alive.
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <memory>
#include <optional>
#include <string>

#include "core/types.h"

namespace illustrate::bindings {

namespace py = pybind11;

std::vector<double> read_numbers(const py::object& value, const std::string& name);
std::vector<int> read_indices(const py::object& value, const std::string& name);
std::vector<Edge> read_edges(const py::object& value, const std::string& name);
Points read_points(const py::object& value, const std::string& name);
ImagePoints read_pairs(const py::object& value, const std::string& name);
Vec3 read_vector(const py::object& value, const std::string& name);
Mat4 read_matrix(const py::object& value, const std::string& name);
int read_integer(const py::object& value, const std::string& name);
double read_number(const py::object& value, const std::string& name);

using Owner = std::shared_ptr<const void>;
using Shape = std::vector<py::ssize_t>;

// `data` of this dtype, kept alive by `owner`. row_bytes: from row to row; 0: they are packed.
py::array view_of(const Owner& owner, const void* data, const py::dtype& dtype, const Shape& shape,
                  std::size_t row_bytes = 0);

inline py::ssize_t length(std::size_t size) { return static_cast<py::ssize_t>(size); }

template <class T>
py::array view_of(const Owner& owner, const std::vector<T>& values) {
  return view_of(owner, values.data(), py::dtype::of<T>(), {length(values.size())});
}

template <class T, std::size_t columns>
py::array view_of(const Owner& owner, const std::vector<std::array<T, columns>>& rows) {
  return view_of(owner, rows.data(), py::dtype::of<T>(),
                 {length(rows.size()), static_cast<py::ssize_t>(columns)});
}

template <int columns>
py::array view_of(const Owner& owner, const std::vector<Eigen::Matrix<double, columns, 1>>& rows) {
  using Row = Eigen::Matrix<double, columns, 1>;
  static_assert(sizeof(Row) == columns * sizeof(double), "rows must be packed");
  return view_of(owner, rows.data(), py::dtype::of<double>(), {length(rows.size()), columns});
}

// One number of each row.
template <class Row>
py::array view_of(const Owner& owner, const std::vector<Row>& rows, double Row::*member) {
  return view_of(owner, rows.empty() ? nullptr : &(rows[0].*member), py::dtype::of<double>(),
                 {length(rows.size())}, sizeof(Row));
}

// One vector of each row.
template <class Row>
py::array view_of(const Owner& owner, const std::vector<Row>& rows, Vec3 Row::*member) {
  return view_of(owner, rows.empty() ? nullptr : &(rows[0].*member), py::dtype::of<double>(),
                 {length(rows.size()), 3}, sizeof(Row));
}

// Of bytes that are 0 or 1.
inline py::array view_of_flags(const Owner& owner, const std::vector<std::uint8_t>& flags) {
  return view_of(owner, flags.data(), py::dtype::of<bool>(), {length(flags.size())});
}

// A vector that nobody else owns.
template <class Vector>
py::array array_of(Vector values) {
  const auto owner = std::make_shared<const Vector>(std::move(values));
  return view_of(owner, *owner);
}

}  // namespace illustrate::bindings
