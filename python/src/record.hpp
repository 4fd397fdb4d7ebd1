#pragma once
/// \file
/// A struct of the library as a Python class whose attributes are the keys of the program's JSON.
///
/// Each key is said once: it becomes a read-only property with its docstring, a line of `to_dict`
/// and a word of `repr`, which the package makes of `_keys`. Structs whose members are listed
/// (members.hpp) can be compared, hashed, copied and pickled.

#include <pybind11/pybind11.h>

#include <memory>
#include <string>
#include <string_view>
#include <utility>

#include "description.hpp"
#include "pickled.hpp"

namespace signorini::python {

/// A class with keys.
template <typename T>
class Record {
public:
    using Class = py::class_<T, std::shared_ptr<T>>;

    Record(py::handle scope, const char* name, const char* doc) : class_(scope, name, doc)
    {
        if constexpr (isKept<T>) {
            class_.def(pickling<T>());
        }
    }
    Record(const Record&) = delete;
    Record& operator=(const Record&) = delete;

    /// What the class does not have of its own by now.
    ~Record()
    {
        class_.attr("_keys") = py::tuple(keys_);
        if constexpr (isKept<T>) {
            if (!class_.attr("__dict__").contains("__eq__")) {
                class_.def("__eq__", [](const T& one, const py::object& other) -> py::object {
                    if (!py::isinstance<T>(other)) {
                        return py::reinterpret_borrow<py::object>(Py_NotImplemented);
                    }
                    return py::bool_(bytesOf(one, true) ==
                                     bytesOf(py::cast<const T&>(other), true));
                });
            }
            class_.def("__hash__",
                       [](const T& value) { return py::hash(py::bytes(bytesOf(value, true))); });
        }
    }

    /// A key that is always there, None where there is no value.
    template <typename Get>
    Record& key(const char* name, Get get, const char* doc)
    {
        return keyUnless(name, get, py::none(), doc);
    }

    /// A key that some values do not have: a function tells which.
    template <typename Get>
    Record& keyUnless(const char* name, Get get, const py::object& lacksIt, const char* doc)
    {
        // Words of Python's own get an underscore.
        const bool isTaken = std::string_view(name) == "lambda";
        const std::string attribute = std::string(name) + (isTaken ? "_" : "");
        class_.def_property_readonly(attribute.c_str(), get, doc);
        keys_.append(py::make_tuple(name, attribute, lacksIt));
        return *this;
    }

    /// A property that is no key.
    template <typename Get>
    Record& has(const char* name, const char* doc, Get get)
    {
        class_.def_property_readonly(name, get, doc);
        return *this;
    }

    /// Numbers without a unit as "name_ratio", and times a unit of the bar as "name".
    template <typename Get>
    Record& both(const std::string& name, const char* unit, const char* doc, const char* ratioDoc,
                 Get get)
    {
        const std::string ratio = name + "_ratio";
        has(ratio.c_str(), ratioDoc, get);
        return has(name.c_str(), doc, [ratio, unit](const py::object& self) {
            return self.attr(ratio.c_str()) * self.attr("bar").attr(unit);
        });
    }

    /// A method, and the names of its arguments.
    template <std::size_t count, typename Function>
    Record& can(const char* name, const char* const (&names)[count], const char* doc, Function does)
    {
        const auto define = [&]<std::size_t... k>(std::index_sequence<k...>)
        {
            class_.def(name, does, py::arg(names[k])..., doc);
        };
        define(std::make_index_sequence<count>());
        return *this;
    }

    /// The class, for all else.
    Class& more() { return class_; }

private:
    Class class_;
    py::list keys_;
};

using answers::Of;

/// The name of an enumerator, as Python's text.
template <typename Enum>
[[nodiscard]] py::str nameOf(Enum value)
{
    const std::string_view text = name(value);
    return {text.data(), text.size()};
}

}  // namespace signorini::python
