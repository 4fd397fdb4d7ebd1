#pragma once
/// \file
/// Numbers to and from NumPy: arrays on our own memory, and functions on arrays of any shape.

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "numbers.hpp"

namespace signorini::python {

namespace py = pybind11;

/// A read-only array on memory that `owner` keeps alive; `stride` in bytes.
[[nodiscard]] py::array_t<double> view(const double* first, std::size_t count,
                                       std::shared_ptr<const void> owner,
                                       std::size_t stride = sizeof(double));

/// The same for one member of each struct in a list.
template <typename T>
[[nodiscard]] py::array_t<double> view(const std::vector<T>& list, double T::*member,
                                       std::shared_ptr<const void> owner)
{
    const double* first = list.empty() ? nullptr : &(list.front().*member);
    return view(first, list.size(), std::move(owner), sizeof(T));
}

/// A fresh array with f(0), f(1), ...
template <typename F>
[[nodiscard]] py::array_t<double> filled(std::int64_t count, F f)
{
    py::array_t<double> array(static_cast<py::ssize_t>(count));
    double* to = array.mutable_data();
    const py::gil_scoped_release release;
    for (std::int64_t k = 0; k < count; ++k) {
        to[k] = f(k);
    }
    return array;
}

/// Two arrays of numbers stretched to one shape, as NumPy does it.
class Grid {
public:
    Grid(const py::object& x, const py::object& t);

    /// f(x, t) on all of them: an array of that shape, or a number if both are.
    template <typename F>
    [[nodiscard]] py::object of(F f) const
    {
        return py::vectorize(f)(x_, t_);
    }

private:
    py::array_t<double> x_;
    py::array_t<double> t_;
};

/// A function of the period [L/c] on an array of them.
template <typename F>
[[nodiscard]] py::object onPeriods(const py::object& periods, F f)
{
    return Grid(py::float_(0.0), periods).of([f](double, double period) { return f(period); });
}

}  // namespace signorini::python
