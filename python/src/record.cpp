#include "record.hpp"

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

}  // namespace signorini::python
