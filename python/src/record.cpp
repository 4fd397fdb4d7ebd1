#include "record.hpp"

#include <new>

#include "mapped.hpp"
#include "signorini/config.hpp"

namespace signorini::python {

namespace {

/// \throws TypeError unless it is an object of the class that was made, and not by __new__ alone.
py::handle valued(py::handle object, const py::handle& type)
{
    if (!py::isinstance(object, type) || !reinterpret_cast<py::detail::instance*>(object.ptr())
                                              ->get_value_and_holder()
                                              .holder_constructed()) {
        throw py::type_error("allowed an object of its class that was made");
    }
    return object;
}

/// Changes with what is held, the class, and the version of the library.
py::object sumOf(const py::handle& type, const py::object& content)
{
    // Format 2 writes equal values equally, shared or not.
    const py::object bytes = py::module_::import("marshal").attr("dumps")(content, 2);
    const py::object sum = py::module_::import("zlib").attr("crc32");
    const py::str maker = py::str(SIGNORINI_VERSION " {}").format(type.attr("__name__"));
    return sum(bytes, sum(maker.attr("encode")()));
}

/// The state of a pickle of this class: what it holds, and a sum over it, the class and the
/// version.
py::tuple sealed(const py::handle& type, const std::string& content)
{
    const py::bytes bytes(content);
    return py::make_tuple(bytes, sumOf(type, bytes));
}

/// The value in it. \throws ValueError if it was changed on its way, or is not of this version and
/// class.
void* opened(const py::handle& type, const py::object& state, MadeOf made)
{
    try {
        const auto tuple = py::cast<py::tuple>(state);
        if (tuple.size() == 2 && sumOf(type, tuple[0]).equal(tuple[1])) {
            const auto bytes = py::cast<std::string>(py::cast<py::bytes>(tuple[0]));
            Reader from{bytes};
            if (void* value = made(from)) {
                return value;
            }
        }
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const std::exception&) {
        refusePickle();
    }
    refusePickle();
}

}  // namespace

std::vector<std::string> eachAsJson(const std::vector<FigureData>& figures)
{
    return mapped(figures, plot::asJson);
}

ClassOfRecord::~ClassOfRecord()
{
    type_.attr("_keys") = py::tuple(keys_);
}

void ClassOfRecord::addKey(std::string_view name, const std::string& doc, const Getter& get,
                           bool leftOut)
{
    // Words of Python's own get an underscore.
    const std::string attribute = std::string(name) + (name == "lambda" ? "_" : "");
    addProperty(attribute.c_str(), doc, get);
    const auto lacks = [get, type = py::handle(type_)](py::handle value) {
        return !get(valued(value, type));
    };
    keys_.append(py::make_tuple(name, attribute,
                                leftOut ? py::object(py::cpp_function(lacks)) : py::none()));
}

void ClassOfRecord::addProperty(const char* name, const std::string& doc,
                                const std::function<py::object(py::handle)>& get)
{
    const auto valueOf = [get, type = py::handle(type_)](py::handle value) {
        const py::object held = get(valued(value, type));
        return held ? held : py::none();
    };
    const py::handle property(reinterpret_cast<PyObject*>(&PyProperty_Type));
    type_.attr(name) =
        property(py::cpp_function(valueOf, py::is_method(type_)), py::none(), py::none(), doc);
}

void ClassOfRecord::addBoth(const std::string& name, const char* unit, const char* doc,
                            const char* ratioDoc, const Getter& get)
{
    addProperty((name + "_ratio").c_str(), ratioDoc, get);
    addProperty(name.c_str(), doc,
                [=](py::handle of) -> py::object { return get(of) * of.attr("bar").attr(unit); });
}

void ClassOfRecord::addBytes(BytesOf bytes, MadeOf made)
{
    const py::is_method method(type_);
    const py::handle type = type_;
    type_.attr("__getstate__") = py::cpp_function(
        [bytes, type](py::handle value) { return sealed(type, bytes(valued(value, type), false)); },
        method);
    type_.attr("__setstate__") = py::cpp_function(
        [made, type](py::detail::value_and_holder& place, const py::object& state) {
            place.value_ptr() = opened(type, state, made);
        },
        py::name("__setstate__"), method, py::detail::is_new_style_constructor());
    type_.attr("__eq__") = py::cpp_function(
        [bytes, type](py::handle one, py::handle other) -> py::object {
            if (!py::isinstance(other, type)) {
                return py::reinterpret_borrow<py::object>(Py_NotImplemented);
            }
            return py::bool_(bytes(valued(one, type), true) == bytes(valued(other, type), true));
        },
        method);
    type_.attr("__hash__") = py::cpp_function(
        [bytes, type](py::handle value) {
            return py::hash(py::bytes(bytes(valued(value, type), true)));
        },
        method);
}

void refusePickle()
{
    throw py::value_error("a pickle that was damaged, or is of another version of signorini");
}

}  // namespace signorini::python
