#pragma once
/// \file
/// A struct of the library as a Python class whose attributes are the keys of the program's JSON.
///
/// Each key is said once: it becomes a read-only property with its docstring, a line of `to_dict`
/// and a word of `repr`, which the package makes of `_keys`. Structs whose members are listed
/// (bytes.hpp) can be compared, hashed, copied and pickled.

#include <pybind11/stl.h>

#include <array>
#include <cstring>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

#include "parts.hpp"
#include "pickled.hpp"
#include "signorini/assembly.hpp"
#include "signorini/figure_data.hpp"

/// Figures are their JSON.
template <>
struct pybind11::detail::type_caster<signorini::FigureData> {
    static constexpr auto name = const_name("str");
    static handle cast(const signorini::FigureData& figure, return_value_policy, handle)
    {
        return str(asJson(figure)).release();
    }
};

namespace signorini::python {

/// A bar with its stops; or several in a row, in words, for which the bar gives the scales.
using SceneOf = With<Scene, std::string>;
void describe(auto& d, Type<SceneOf>)
{
    d.record("Scene", "A bar, its stops, and what it is made of; or several bars, in words.");
    d.key(
        "words", "-", "Several bars in a row, whose scales are those of `bar`.",
        [](const SceneOf& of) { return of.more.empty() ? std::nullopt : std::optional(of.more); },
        When::any);
    const auto of = [](auto get) {
        return [get](const SceneOf& scene) {
            using Value = std::remove_cvref_t<decltype(std::invoke(get, scene))>;
            const bool isThere = scene.more.empty() || std::is_same_v<Value, Bar>;
            return isThere ? std::optional<Value>(std::invoke(get, scene)) : std::nullopt;
        };
    };
    describeKeysOfScene(d, of, When::any);
}

}  // namespace signorini::python

/// A Scene of Python's where the library takes one: not in words.
template <>
struct pybind11::detail::type_caster<signorini::Scene>
    : type_caster_base<signorini::python::SceneOf> {
    using Base = type_caster_base<signorini::python::SceneOf>;
    static handle cast(const signorini::Scene& scene, return_value_policy, handle parent)
    {
        return Base::cast(signorini::python::SceneOf{scene, {}}, return_value_policy::move, parent);
    }
    bool load(handle given, bool converts)
    {
        return Base::load(given, converts) && value != nullptr && held()->more.empty();
    }
    operator signorini::Scene&() { return *held(); }  // NOLINT: as pybind11 has them
    operator signorini::Scene*() { return held(); }   // NOLINT

private:
    signorini::python::SceneOf* held() { return static_cast<signorini::python::SceneOf*>(value); }
};

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

/// A value of an answer as Python has it.
template <typename T>
[[nodiscard]] py::object asPython(const T& value);

/// What a class has whatever its struct: compiled once.
class ClassOfRecord {
public:
    explicit ClassOfRecord(py::object type) : type_(std::move(type)) {}
    ClassOfRecord(const ClassOfRecord&) = delete;
    ClassOfRecord& operator=(const ClassOfRecord&) = delete;
    ~ClassOfRecord();

    void addKey(std::string_view name, std::string_view unit, const char* sentence,
                const Getter& get, bool mayBeLeftOut);
    void addProperty(const char* name, const std::string& doc,
                     const std::function<py::object(py::handle)>& get);
    /// Numbers without a unit as "name_ratio", and times a unit of the bar as "name".
    void addBoth(const std::string& name, const char* unit, const char* doc, const char* ratioDoc,
                 const Getter& get);
    /// All that an object is, for pickles and comparing; and an object of that.
    using BytesOf = std::string (*)(py::handle value, bool isCompared);
    using MadeOf = void* (*)(std::string_view bytes);
    void addBytes(BytesOf bytes, MadeOf made);

private:
    py::object type_;
    py::list keys_;
};

/// A class with keys: a describer that makes it of what is described.
template <typename T>
class Record {
public:
    using Class = py::class_<T, std::shared_ptr<T>>;

    explicit Record(py::handle scope) : scope_(scope) { describe(*this, Type<T>()); }
    /// Of what is not described.
    Record(py::handle scope, const char* name, const char* doc) : scope_(scope)
    {
        record(name, doc);
    }

    void record(const char* name, const char* sentence)
    {
        class_.emplace(scope_, name, sentence);
        of_.emplace(*class_);
        if constexpr (isKept<T>) {
            of_->addBytes(
                [](py::handle value, bool isCompared) {
                    return bytesOf(py::cast<const T&>(value), isCompared);
                },
                [](std::string_view bytes) -> void* {
                    Unpickler from{bytes};
                    auto value = std::make_unique<T>(take<T>(from));
                    if (!from.bytes.empty()) {
                        Reader::refuse();
                    }
                    return value.release();
                });
        }
    }
    /// Bars in a row that it has are drawn; of a status that may be "found" comes `found`.
    template <typename Get>
    void key(const char* name, std::string_view unit, const char* sentence, const Get& get,
             When when = When::always)
    {
        if (when == When::attribute) {
            of_->addProperty(name, sentence, erased(get));
        } else if (when != When::program) {
            of_->addKey(name, unit, sentence, erased(get), mayBeLeftOut(when));
        }
        using Value = std::remove_cvref_t<std::invoke_result_t<Get, const T&>>;
        if constexpr (std::is_same_v<Value, Assembly>) {
            drawsScene(get);
        } else if constexpr (std::is_same_v<Value, Status>) {
            const auto isFound = [get](const T& of) {
                return std::invoke(get, of) == Status::found;
            };
            has("found", "Was a motion found?", isFound).more().def("__bool__", isFound);
        }
    }

    /// A property that is no key.
    template <typename Get>
    Record& has(const char* name, const char* doc, const Get& get)
    {
        of_->addProperty(name, doc, erased(get));
        return *this;
    }

    /// Numbers without a unit as "name_ratio", and times a unit of the bar as "name".
    template <typename Get>
    Record& both(const std::string& name, const char* unit, const char* doc, const char* ratioDoc,
                 const Get& get)
    {
        of_->addBoth(name, unit, doc, ratioDoc, erased(get));
        return *this;
    }

    /// A method, and the names of its arguments.
    template <std::size_t count, typename Function>
    Record& can(const char* name, const char* const (&names)[count], const char* doc, Function does)
    {
        std::apply([&](auto... argument) { class_->def(name, does, py::arg(argument)..., doc); },
                   std::to_array(names));
        return *this;
    }
    template <typename Function>
    Record& can(const char* name, const char* doc, Function does)
    {
        class_->def(name, does, doc);
        return *this;
    }

    /// What signorini.plot draws: a picture of it, or of the k-th of its motions.
    template <typename Figure>
    Record& draws(Figure figure, const char* name = "_figure")
    {
        class_->def(name, figure);
        return *this;
    }
    /// Its pictures over one period, or those of the k-th of its motions, at most so many > 0.
    template <typename Frames>
    Record& moves(Frames frames)
    {
        return draws(frames, "_frames");
    }
    /// The bars in a row that are asked about.
    template <typename Get>
    Record& drawsScene(Get assembly)
    {
        return draws([assembly](const T& of) { return sceneFigure(std::invoke(assembly, of)); },
                     "_scene");
    }

    /// The class, for all else.
    Class& more() { return *class_; }

private:
    template <typename Get>
    static Getter erased(const Get& get)
    {
        return Getter(get, [](const void* held, py::handle of) -> py::object {
            using Value = std::conditional_t<std::is_invocable_v<Get, const T&>, const T&,
                                             std::shared_ptr<T>>;
            const auto& got = std::invoke(*static_cast<const Get*>(held), py::cast<Value>(of));
            if constexpr (isA<std::remove_cvref_t<decltype(got)>, std::optional>) {
                return got ? asPython(*got) : py::object();
            } else {
                return asPython(got);
            }
        });
    }

    py::handle scope_;
    std::optional<Class> class_ = {};
    std::optional<ClassOfRecord> of_ = {};
};

/// The keys of a described record in a dictionary.
template <typename T>
struct KeysInDictionary {
    const T& value;
    py::dict dict = {};

    static void record(const char*, const char*) {}
    template <typename Get>
    void key(const char* name, const char*, const char*, Get get, When when = When::always)
    {
        const py::object held = asPython(std::invoke(get, value));
        if (!(held.is_none() && mayBeLeftOut(when))) {
            dict[name] = held;
        }
    }
};

/// The same, of a record that need not be a class.
template <typename T>
[[nodiscard]] py::dict dictionaryOf(const T& value)
{
    KeysInDictionary<T> keys{value};
    describe(keys, Type<T>());
    return keys.dict;
}

/// Enumerators are text, small structs tuples, records objects of their class.
template <typename T>
py::object asPython(const T& value)
{
    if constexpr (std::is_base_of_v<py::handle, T>) {
        return value;
    } else if constexpr (std::is_enum_v<T>) {
        return py::str(std::string_view(name(value)));
    } else if constexpr (isA<T, std::reference_wrapper>) {
        return asPython(value.get());
    } else if constexpr (isA<T, std::optional>) {
        return value ? asPython(*value) : py::none();
    } else if constexpr (isA<T, std::variant>) {
        return std::visit([](const auto& held) { return asPython(held); }, value);
    } else if constexpr (isA<T, std::tuple>) {
        return std::apply([](const auto&... item) { return py::make_tuple(asPython(item)...); },
                          value);
    } else if constexpr (isA<T, std::vector>) {
        py::list list;
        for (const auto& item : value) {
            list.append(asPython(item));
        }
        return list;
    } else if constexpr (Listed<T>) {
        return asPython(listed(value));
    } else if constexpr (isDictionary<T>) {
        return dictionaryOf(value);
    } else {
        return py::cast(value);
    }
}

/// Classes of records that have no more than their keys.
template <typename... T>
void addClasses(py::module_& module)
{
    (Record<T>(module), ...);
}

}  // namespace signorini::python
