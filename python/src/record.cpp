#include "record.hpp"

#include <cmath>

#include "signorini/config.hpp"

namespace signorini::python {

namespace {

/// Changes with what is held, the class, and the version of the library.
py::object sumOf(const py::handle& type, const py::object& content)
{
    // Format 2 writes equal values equally, shared or not.
    const py::object bytes = py::module_::import("marshal").attr("dumps")(content, 2);
    const py::object sum = py::module_::import("zlib").attr("crc32");
    const py::str maker = py::str(SIGNORINI_VERSION " {}").format(type.attr("__name__"));
    return sum(bytes, sum(maker.attr("encode")()));
}

}  // namespace

py::tuple sealed(const py::handle& type, const std::string& content)
{
    const py::bytes bytes(content);
    return py::make_tuple(bytes, sumOf(type, bytes));
}

std::string opened(const py::handle& type, const py::object& state)
{
    const auto tuple = py::cast<py::tuple>(state);
    if (tuple.size() != 2 || !sumOf(type, tuple[0]).equal(tuple[1])) {
        refusePickle();
    }
    return py::cast<py::bytes>(tuple[0]);
}

void refusePickle()
{
    throw py::value_error("a pickle that was damaged, or is of another version of signorini");
}

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
    if (py::isinstance<py::dict>(value)) {
        py::dict dict;
        for (const auto& [key, held] : py::cast<py::dict>(value)) {
            dict[key] = plain(held);
        }
        return dict;
    }
    return py::reinterpret_borrow<py::object>(value);
}

py::dict dictOf(const py::handle& record)
{
    py::dict dict;
    for (const py::handle& key : record.attr("_keys")) {
        const auto tuple = py::cast<py::tuple>(key);
        const py::object isLeftOut = tuple[2];
        if (isLeftOut.is_none() || !py::cast<bool>(isLeftOut(record))) {
            dict[tuple[0]] = plain(record.attr(tuple[1]));
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

}  // namespace signorini::python
