#pragma once
/// \file
/// A struct of the library as a Python class whose attributes are the keys of the program's JSON.
///
/// Each key is said once: it becomes a read-only property with its docstring, a line of `to_dict`
/// and a word of `repr`, which the package makes of `_keys`. Structs whose members are listed
/// (members.hpp) can be compared, hashed, copied and pickled.

#include <pybind11/pybind11.h>

#include <array>
#include <cstring>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

#include "description.hpp"
#include "pickled.hpp"
#include "signorini/figure_data.hpp"

namespace signorini::python {

/// How a property is got: a function pointer, whose code is all that each key adds. What is not
/// there is no object.
class Getter {
public:
    template <typename Get>
    explicit Getter(const Get& get, py::object (*call)(const void* get, py::handle of))
        : call_(call)
    {
        static_assert(sizeof(Get) <= sizeof held_ && std::is_trivially_copyable_v<Get>);
        std::memcpy(held_.data(), &get, sizeof get);
    }
    py::object operator()(py::handle of) const { return call_(held_.data(), of); }

private:
    alignas(std::max_align_t) std::array<std::byte, 48> held_ = {};
    py::object (*call_)(const void* get, py::handle of);
};

/// A value of an answer as Python has it (described.hpp).
template <typename T>
[[nodiscard]] py::object asPython(const T& value);

/// What a class has whatever its struct: compiled once.
class ClassOfRecord {
public:
    explicit ClassOfRecord(py::object type) : type_(std::move(type)) {}
    ClassOfRecord(const ClassOfRecord&) = delete;
    ClassOfRecord& operator=(const ClassOfRecord&) = delete;
    ~ClassOfRecord();

    /// `leftOut`: where it is not there.
    void addKey(std::string_view name, const std::string& doc, const Getter& get, bool leftOut);
    void addProperty(const char* name, const std::string& doc,
                     const std::function<py::object(py::handle)>& get);
    /// Numbers without a unit as "name_ratio", and times a unit of the bar as "name".
    void addBoth(const std::string& name, const char* unit, const char* doc, const char* ratioDoc,
                 const Getter& get);
    /// Pickles, and comparing: equal are values of the same bytes.
    void addBytes(BytesOf bytes, MadeOf made);

private:
    py::object type_;
    py::list keys_;
};

/// Pictures of an animation, all in JSON.
[[nodiscard]] std::vector<std::string> eachAsJson(const std::vector<FigureData>& figures);

/// A class with keys.
template <typename T>
class Record {
public:
    using Class = py::class_<T, std::shared_ptr<T>>;

    Record(py::handle scope, const char* name, const char* doc)
        : class_(scope, name, doc), of_(class_)
    {
        if constexpr (isKept<T>) {
            of_.addBytes(
                [](py::handle value, bool isCompared) {
                    return bytesOf(py::cast<const T&>(value), isCompared);
                },
                [](Reader& from) -> void* {
                    auto value = std::make_unique<T>(take<T>(from));
                    return from.bytes.empty() ? value.release() : nullptr;
                });
        }
    }

    /// A key that is always there, None where there is no value, or left out.
    template <typename Get>
    Record& key(const char* name, const Get& get, const std::string& doc, bool leftOut = false)
    {
        of_.addKey(name, doc, erased(get), leftOut);
        return *this;
    }

    /// A property that is no key.
    template <typename Get>
    Record& has(const char* name, const char* doc, const Get& get)
    {
        of_.addProperty(name, doc, erased(get));
        return *this;
    }

    /// Numbers without a unit as "name_ratio", and times a unit of the bar as "name".
    template <typename Get>
    Record& both(const std::string& name, const char* unit, const char* doc, const char* ratioDoc,
                 const Get& get)
    {
        of_.addBoth(name, unit, doc, ratioDoc, erased(get));
        return *this;
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

    /// What signorini.plot draws, in JSON: a picture of it, or of the k-th of its motions.
    template <typename Figure>
    Record& draws(Figure figure, const char* name = "_figure")
    {
        if constexpr (std::is_invocable_v<Figure, const T&>) {
            class_.def(name, [figure](const T& of) { return asJson(figure(of)); });
        } else {
            class_.def(name,
                       [figure](const T& of, std::size_t k) { return asJson(figure(of, k)); });
        }
        return *this;
    }
    /// Its pictures over one period, or those of the k-th of its motions, at most so many > 0.
    template <typename Frames>
    Record& moves(Frames frames)
    {
        if constexpr (std::is_invocable_v<Frames, const T&, std::size_t>) {
            class_.def("_frames", [frames](const T& of, std::size_t most) {
                return eachAsJson(frames(of, most));
            });
        } else {
            class_.def("_frames", [frames](const T& of, std::size_t most, std::size_t k) {
                return eachAsJson(frames(of, most, k));
            });
        }
        return *this;
    }
    /// The bars in a row that are asked about.
    template <typename Get>
    Record& drawsScene(Get assembly)
    {
        return draws([assembly](const T& of) { return sceneFigure(std::invoke(assembly, of)); },
                     "_scene");
    }

    /// The class, for all else.
    Class& more() { return class_; }

private:
    template <typename Get>
    static Getter erased(const Get& get)
    {
        return Getter(get, [](const void* held, py::handle of) -> py::object {
            using Value = std::conditional_t<std::is_invocable_v<Get, const T&>, const T&,
                                             std::shared_ptr<T>>;
            const auto& got = std::invoke(*static_cast<const Get*>(held), py::cast<Value>(of));
            if constexpr (answers::isA<std::remove_cvref_t<decltype(got)>, std::optional>) {
                return got ? asPython(*got) : py::object();
            } else {
                return asPython(got);
            }
        });
    }

    Class class_;
    ClassOfRecord of_;
};

using answers::Of;

}  // namespace signorini::python
