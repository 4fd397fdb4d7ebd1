#include "arrays.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "faults.hpp"
#include "units.hpp"

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

Numbers numbersOf(const py::object& given, const char* name)
{
    try {
        const py::object array = py::module_::import("numpy").attr("asarray")(given);
        const auto kind = py::cast<std::string>(array.attr("dtype").attr("kind"));
        if (std::string("biufO").find(kind) != std::string::npos) {
            return Numbers(array.attr("astype")("float64", py::arg("copy") = false));
        }
    } catch (py::error_already_set& error) {
        if (!error.matches(PyExc_TypeError) && !error.matches(PyExc_ValueError) &&
            !error.matches(PyExc_OverflowError)) {
            throw;
        }
    }
    const py::object shown = py::module_::import("reprlib").attr("repr")(given);
    throw py::type_error(
        fmt::format("{} = {}: allowed real numbers", name, py::cast<std::string>(shown)));
}

const std::vector<const Option*>& optionsNamed(std::string_view argument)
{
    static std::map<std::string, std::vector<const Option*>, std::less<>> all;
    const auto known = all.find(argument);
    if (known != all.end()) {
        return known->second;
    }
    std::string option = (argument.starts_with("--") ? "" : "--") + std::string(argument);
    std::replace(option.begin(), option.end(), '_', '-');
    std::vector<const Option*>& rows = all[std::string(argument)];
    for (const Option& row : options()) {
        if (row.name == option && row.takes != Takes::file) {
            rows.push_back(&row);
        }
    }
    return rows;
}

std::string unitOfOption(std::string_view name)
{
    const auto& rows = optionsNamed(name);
    return rows.empty() ? "-" : std::string(rows.front()->unit);
}

double quantityOf(const std::string& name, const Quantity& given, const std::string& unit)
{
    if (const auto* plain = std::get_if<double>(&given)) {
        return *plain;
    }
    const auto& text = std::get<std::string>(given);
    const auto value = numberIn(text, unit);
    if (!value) {
        throwFault(name, text, fmt::format("finite numbers [{}]", unit));
    }
    return *value;
}

}  // namespace signorini::python
