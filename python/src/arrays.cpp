#include "arrays.hpp"

namespace signorini::python {

py::array_t<double> view(const double* first, std::size_t count, std::shared_ptr<const void> owner,
                         std::size_t stride)
{
    using Owner = std::shared_ptr<const void>;
    if (count == 0) {
        return py::array_t<double>(0);
    }
    const py::capsule keeper(new Owner(std::move(owner)),
                             [](void* held) { delete static_cast<Owner*>(held); });
    py::array_t<double> array({static_cast<py::ssize_t>(count)}, {static_cast<py::ssize_t>(stride)},
                              first, keeper);
    py::detail::array_proxy(array.ptr())->flags &= ~py::detail::npy_api::NPY_ARRAY_WRITEABLE_;
    return array;
}

Grid::Grid(const py::object& x, const py::object& t)
{
    using Numbers = py::array_t<double, py::array::forcecast>;
    const py::tuple both = py::cast<py::tuple>(
        py::module_::import("numpy").attr("broadcast_arrays")(Numbers(x), Numbers(t)));
    x_ = py::cast<py::array_t<double>>(both[0]);
    t_ = py::cast<py::array_t<double>>(both[1]);
    shape_.assign(x_.shape(), x_.shape() + x_.ndim());
    xStrides_.assign(x_.strides(), x_.strides() + x_.ndim());
    tStrides_.assign(t_.strides(), t_.strides() + t_.ndim());
}

}  // namespace signorini::python
