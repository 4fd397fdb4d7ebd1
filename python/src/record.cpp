#include "record.hpp"

#include <cmath>

namespace signorini::python {

py::object plain(const py::handle& value)
{
    if (py::hasattr(value, "to_dict")) {
        return value.attr("to_dict")();
    }
    if (py::isinstance<py::float_>(value) && !std::isfinite(py::cast<double>(value))) {
        return py::none();
    }
    if (py::isinstance<py::list>(value) || py::isinstance<py::tuple>(value)) {
        py::list list;
        for (const py::handle& item : value) {
            list.append(plain(item));
        }
        return list;
    }
    return py::reinterpret_borrow<py::object>(value);
}

py::dict dictOf(const py::handle& record)
{
    py::dict dict;
    for (const py::handle& key : record.attr("_keys")) {
        const auto tuple = py::cast<py::tuple>(key);
        const py::object isLeftOut = tuple[2];
        if (py::isinstance<py::function>(isLeftOut) && py::cast<bool>(isLeftOut(record))) {
            continue;
        }
        const py::object value = plain(record.attr(tuple[1]));
        if (!(isLeftOut.is(py::bool_(true)) && value.is_none())) {
            dict[tuple[0]] = value;
        }
    }
    return dict;
}

std::string represent(const py::handle& record)
{
    constexpr std::size_t longest = 60;
    std::string text = py::cast<std::string>(py::type::of(record).attr("__name__")) + "(";
    bool isFirst = true;
    for (const py::handle& key : record.attr("_keys")) {
        const py::object attribute = py::cast<py::tuple>(key)[1];
        const py::object value = record.attr(attribute);
        if (value.is_none()) {
            continue;
        }
        const auto word = py::cast<std::string>(py::repr(value));
        text += (isFirst ? "" : ", ") + py::cast<std::string>(attribute) + "=" +
                (word.size() > longest ? "…" : word);
        isFirst = false;
    }
    return text + ")";
}

py::tuple boundsOf(const EnergyRange& range, double unit)
{
    const auto bound = [unit](double value) {
        return std::isfinite(value) ? py::object(py::float_(value * unit)) : py::none();
    };
    return py::make_tuple(bound(range.least), bound(range.most));
}

py::list pairsOf(const std::vector<Phase>& phases)
{
    py::list list;
    for (const Phase& phase : phases) {
        list.append(phase.stop == Stop::right
                        ? py::make_tuple(phase.contact, phase.free)
                        : py::make_tuple(phase.contact, phase.free, nameOf(phase.stop)));
    }
    return list;
}

}  // namespace signorini::python
