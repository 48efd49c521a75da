#include "app/python/arrays.hpp"

namespace jointwise::python {

Numbers numbers_of(const py::handle& value, const char* what) {
    Numbers numbers = Numbers::ensure(value);
    if (!numbers) {
        throw py::value_error(std::string("jointwise: ") + what + " is not an array of numbers");
    }
    return numbers;
}

std::vector<double> list_of(const py::handle& value, const char* what) {
    const Numbers numbers = numbers_of(value, what);
    if (numbers.ndim() != 1) {
        throw py::value_error(std::string("jointwise: ") + what + " is not a list of numbers");
    }
    return {numbers.data(), numbers.data() + numbers.size()};
}

std::optional<Vector3> optional_vector_of(const py::handle& value, const char* what) {
    if (value.is_none()) { return std::nullopt; }
    return vector_of<3>(value, what);
}

Matrix3 matrix_of(const py::handle& value, const char* what) {
    const Numbers numbers = numbers_of(value, what);
    if (numbers.ndim() != 2 || numbers.shape(0) != 3 || numbers.shape(1) != 3) {
        throw py::value_error(std::string("jointwise: ") + what + " is not a 3 x 3 matrix");
    }
    return Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(numbers.data());
}

py::array view_of(
    const double* data, const std::vector<py::ssize_t>& shape, const std::vector<py::ssize_t>& strides,
    const py::handle& owner, Access access) {
    constexpr auto kSize = static_cast<py::ssize_t>(sizeof(double));
    std::vector<py::ssize_t> bytes;
    bytes.reserve(strides.size());
    for (const py::ssize_t stride : strides) { bytes.push_back(stride * kSize); }
    py::array array(py::dtype::of<double>(), shape, bytes, data, owner);
    if (access == Access::read) {
        py::detail::array_proxy(array.ptr())->flags &= ~py::detail::npy_api::NPY_ARRAY_WRITEABLE_;
    }
    return array;
}

py::array view_of(const Eigen::VectorXd& v, const py::handle& owner) {
    return view_of(v.data(), {v.size()}, {1}, owner, Access::read);
}

py::array view_of(const Eigen::MatrixXd& m, const py::handle& owner) {
    return view_of(m.data(), {m.rows(), m.cols()}, {1, m.rows()}, owner, Access::read);
}

py::array view_of(const Table& m, const py::handle& owner) {
    return view_of(m.data(), {m.rows(), m.cols()}, {m.cols(), 1}, owner, Access::read);
}

py::array view_of(const Vector3& v, const py::handle& owner) {
    return view_of(v.data(), {3}, {1}, owner, Access::read);
}

py::array view_of(std::vector<double>& numbers, const py::handle& owner) {
    return view_of(numbers.data(), {static_cast<py::ssize_t>(numbers.size())}, {1}, owner, Access::write);
}

}  // namespace jointwise::python
