#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include "jointwise/trajectory.hpp"

/// Numbers between Python and the library. Arguments may be anything that numpy accepts as numbers; results
/// are viewed in place, without a copy.
namespace jointwise::python {

namespace py = pybind11;

using Numbers = py::array_t<double, py::array::c_style | py::array::forcecast>;

/// Numbers of an argument, in rows. @throws py::value_error that names the argument if it has no numbers
Numbers numbers_of(const py::handle& value, const char* what);
std::vector<double> list_of(const py::handle& value, const char* what);

/// One vector of N numbers. @throws py::value_error if there are more or fewer
template <int N>
Eigen::Matrix<double, N, 1> vector_of(const py::handle& value, const char* what) {
    const Numbers numbers = numbers_of(value, what);
    if (numbers.ndim() != 1 || numbers.size() != N) {
        throw py::value_error(
            std::string("jointwise: ") + what + " has " + std::to_string(numbers.size()) +
            " numbers; expected " + std::to_string(N) + " in a row");
    }
    return Eigen::Map<const Eigen::Matrix<double, N, 1>>(numbers.data());
}

std::optional<Vector3> optional_vector_of(const py::handle& value, const char* what);
Matrix3 matrix_of(const py::handle& value, const char* what);

/// Rows of N numbers, each as a vector.
template <int N>
std::vector<Eigen::Matrix<double, N, 1>> rows_of(const py::handle& value, const char* what) {
    const Numbers numbers = numbers_of(value, what);
    if (numbers.ndim() != 2 || numbers.shape(1) != N) {
        throw py::value_error(
            std::string("jointwise: ") + what + " is not a table of " + std::to_string(N) + " columns");
    }
    std::vector<Eigen::Matrix<double, N, 1>> rows;
    for (py::ssize_t k = 0; k < numbers.shape(0); ++k) { rows.emplace_back(numbers.data(k, 0)); }
    return rows;
}

/// An array with its own copy, for few numbers.
inline Numbers copied(const Eigen::VectorXd& v) { return Numbers(v.size(), v.data()); }

inline Numbers copied_list(const std::vector<double>& v) {
    return Numbers(static_cast<py::ssize_t>(v.size()), v.data());
}

enum class Access { read, write };

/// A view of the numbers of `owner`, which the array keeps alive. Strides count numbers, not bytes.
py::array view_of(
    const double* data, const std::vector<py::ssize_t>& shape, const std::vector<py::ssize_t>& strides,
    const py::handle& owner, Access access);

py::array view_of(const Eigen::VectorXd& v, const py::handle& owner);
py::array view_of(const Eigen::MatrixXd& m, const py::handle& owner);  ///< column-major
py::array view_of(const Table& m, const py::handle& owner);            ///< row-major
py::array view_of(const Vector3& v, const py::handle& owner);

/// Vectors of N numbers as a writable array with rows of N.
template <int N>
py::array view_of(std::vector<Eigen::Matrix<double, N, 1>>& rows, const py::handle& owner) {
    const double* data = rows.empty() ? nullptr : rows.front().data();
    return view_of(data, {static_cast<py::ssize_t>(rows.size()), N}, {N, 1}, owner, Access::write);
}
py::array view_of(std::vector<double>& numbers, const py::handle& owner);

/// Adds a property that is a view of a part of the object. @param part  a member, or a function of the object
template <class T, class Part>
void add_view(py::class_<T>& type, const char* name, Part part, const char* doc) {
    type.def_property_readonly(
        name,
        [part](const py::object& self) { return view_of(std::invoke(part, self.cast<const T&>()), self); },
        doc);
}

/// Copies `from` into `to`, which views may show. @throws py::value_error if their sizes differ
template <class T>
void assign(std::vector<T>& to, std::vector<T> from, const char* what) {
    if (to.size() != from.size()) {
        throw py::value_error(
            std::string("jointwise: ") + what + " has " + std::to_string(from.size()) +
            " entries; expected " + std::to_string(to.size()));
    }
    std::copy(from.begin(), from.end(), to.begin());
}

}  // namespace jointwise::python
