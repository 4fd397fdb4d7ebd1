#pragma once
/// \file
/// A struct of the library as a Python class whose attributes are the keys of the program's JSON.
///
/// Each key is said once: it becomes a read-only property with its docstring, a line of `to_dict`
/// and a word of `repr`. Structs whose members are listed (members.hpp) can be compared, copied and
/// pickled.

#include <pybind11/pybind11.h>

#include <memory>
#include <string>
#include <string_view>
#include <utility>

#include "description.hpp"
#include "pickled.hpp"

namespace signorini::python {

/// A value as JSON has it: records become dictionaries, tuples lists, numbers that are not finite
/// None.
[[nodiscard]] py::object plain(const py::handle& value);

/// The keys of a record, as `to_dict` gives them.
[[nodiscard]] py::dict dictOf(const py::handle& record);

/// "Name(key=value, ...)" with the first keys that have a value.
[[nodiscard]] std::string represent(const py::handle& record);

/// A class with keys.
template <typename T>
class Record {
public:
    using Class = py::class_<T, std::shared_ptr<T>>;

    Record(py::handle scope, const char* name, const char* doc) : class_(scope, name, doc)
    {
        if constexpr (isKept<T>) {
            class_.def(pickling<T>());
            class_.def("__copy__", [](const T& value) { return std::make_shared<T>(value); });
            class_.def("__deepcopy__",
                       [](const T& value, const py::dict&) { return std::make_shared<T>(value); });
        }
    }
    Record(const Record&) = delete;
    Record& operator=(const Record&) = delete;

    /// What the class does not have of its own by now.
    ~Record()
    {
        class_.attr("_keys") = py::tuple(keys_);
        if (lacks("to_dict")) {
            class_.def(
                "to_dict", [](const py::object& self) { return dictOf(self); },
                "The same as a dictionary, key by key what the program prints as JSON.");
        }
        if (lacks("__repr__")) {
            class_.def("__repr__", [](const py::object& self) { return represent(self); });
        }
        if constexpr (isKept<T>) {
            if (lacks("__eq__")) {
                class_.def("__eq__", [](const T& one, const py::object& other) -> py::object {
                    if (!py::isinstance<T>(other)) {
                        return py::reinterpret_borrow<py::object>(Py_NotImplemented);
                    }
                    return py::bool_(bytesOf(one, true) ==
                                     bytesOf(py::cast<const T&>(other), true));
                });
            }
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

    /// The class, for what is no key.
    Class& more() { return class_; }

private:
    [[nodiscard]] bool lacks(const char* name) const
    {
        return !class_.attr("__dict__").contains(name);
    }

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
