#include "record.hpp"

#include <fmt/format.h>

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

}  // namespace

ClassOfRecord::~ClassOfRecord()
{
    type_.attr("_keys") = py::tuple(keys_);
}

void ClassOfRecord::addKey(std::string_view name, std::string_view unit, const char* sentence,
                           const Getter& get, bool mayBeLeftOut)
{
    unit = unit.substr(0, unit.find_first_of(">"));
    unit = unit.substr(0, unit.find_last_not_of(' ') + 1);
    const std::string doc = unit == "-" ? sentence : fmt::format("[{}] {}", unit, sentence);
    // Words of Python's own get an underscore.
    const std::string attribute = std::string(name) + (name == "lambda" ? "_" : "");
    addProperty(attribute.c_str(), doc, get);
    const auto lacks = [get, type = py::handle(type_)](py::handle value) {
        return !get(valued(value, type));
    };
    keys_.append(py::make_tuple(name, attribute,
                                mayBeLeftOut ? py::object(py::cpp_function(lacks)) : py::none()));
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
    type_.attr("_bytes") = py::cpp_function(
        [bytes, type = py::handle(type_)](py::handle value, bool isCompared) {
            return py::bytes(bytes(valued(value, type), isCompared));
        },
        method);
    type_.attr("_take") =
        py::cpp_function([made](py::detail::value_and_holder& place,
                                const py::bytes& content) { place.value_ptr() = made(content); },
                         py::name("__setstate__"), method, py::detail::is_new_style_constructor());
}

}  // namespace signorini::python
