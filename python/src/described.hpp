#pragma once
/// \file
/// Classes whose properties are the keys of a description (src/answers/description.hpp).

#include <fmt/format.h>

#include "description.hpp"
#include "record.hpp"
#include "signorini/assembly.hpp"

namespace signorini::python {

/// The keys of a described record in a dictionary.
template <typename T>
struct KeysInDictionary {
    const T& value;
    py::dict dict = {};

    static void record(const char*, const char*) {}
    template <typename Get>
    void key(const char* name, const char*, const char*, Get get,
             answers::When when = answers::When::always)
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
    describe(keys, answers::Type<T>());
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
    } else if constexpr (answers::isA<T, std::reference_wrapper>) {
        return asPython(value.get());
    } else if constexpr (answers::isA<T, std::optional>) {
        return value ? asPython(*value) : py::none();
    } else if constexpr (answers::isA<T, std::variant>) {
        return std::visit([](const auto& held) { return asPython(held); }, value);
    } else if constexpr (answers::isA<T, std::tuple>) {
        return std::apply([](const auto&... item) { return py::make_tuple(asPython(item)...); },
                          value);
    } else if constexpr (answers::isA<T, std::vector>) {
        py::list list;
        for (const auto& item : value) {
            list.append(asPython(item));
        }
        return list;
    } else if constexpr (answers::Listed<T>) {
        return asPython(answers::listed(value));
    } else if constexpr (answers::isDictionary<T>) {
        return dictionaryOf(value);
    } else {
        return py::cast(value);
    }
}

/// Makes a class and its keys of what is described; bars in a row that it has are drawn.
template <typename T>
struct ClassOfKeys {
    py::handle scope;
    const char* doc;  ///< in place of the sentence of the description
    std::unique_ptr<Record<T>> made = {};

    void record(const char* name, const char* sentence)
    {
        made = std::make_unique<Record<T>>(scope, name, doc != nullptr ? doc : sentence);
    }
    template <typename Get>
    void key(const char* name, std::string_view unit, const char* sentence, Get get,
             answers::When when = answers::When::always)
    {
        if (when == answers::When::program) {
            return;
        }
        unit = unit.substr(0, unit.find_first_of(">"));
        unit = unit.substr(0, unit.find_last_not_of(' ') + 1);
        const std::string text = unit == "-" ? sentence : fmt::format("[{}] {}", unit, sentence);
        made->key(name, get, text, mayBeLeftOut(when));
        if constexpr (std::is_same_v<std::remove_cvref_t<std::invoke_result_t<Get, const T&>>,
                                     Assembly>) {
            made->drawsScene(get);
        }
    }
};

/// The class of a described record; what has a longer text of its own than the description says so.
template <typename T>
std::unique_ptr<Record<T>> classOf(py::handle scope, const char* doc = nullptr)
{
    ClassOfKeys<T> keys{scope, doc};
    describe(keys, answers::Type<T>());
    return std::move(keys.made);
}

/// Classes of records that have no more than their keys.
template <typename... T>
void addClasses(py::module_& module)
{
    (classOf<T>(module), ...);
}

}  // namespace signorini::python
