#pragma once
/// \file
/// JSON pieces that several commands print. Numbers that are not finite print as null.

#include <functional>
#include <nlohmann/json.hpp>
#include <string>

#include "parts.hpp"
#include "signorini/config.hpp"

namespace signorini::cli {

using Json = nlohmann::ordered_json;

/// The beginning of every answer: which form it has, and who gave it.
inline Json newAnswer()
{
    return {{"schema", 2}, {"version", SIGNORINI_VERSION}};
}

/// A value of an answer, or what `answers::describe` says of it. Of a described record the key
/// `leftNull` stays null: it may be long, and written piece by piece. A whole answer has a head,
/// also where another refers to it.
template <typename T>
[[nodiscard]] Json jsonOf(const T& value, std::string_view leftNull = {});
template <typename T>
[[nodiscard]] Json wholeJsonOf(const T& answer, std::string_view leftNull = {});

/// Collects the keys of a described record.
template <typename T>
struct JsonKeys {
    const T& value;
    std::string_view leftNull;
    Json json = Json::object();

    static void record(const char*, const char*) {}
    template <typename Get>
    void key(const char* name, const char*, const char*, Get get,
             answers::When when = answers::When::always)
    {
        using Value = std::remove_cvref_t<std::invoke_result_t<Get, const T&>>;
        if (when == answers::When::python || when == answers::When::attribute) {
            return;
        }
        if (name == leftNull) {
            json[name] = nullptr;
            return;
        }
        if constexpr (answers::isA<Value, std::optional>) {
            if (const Value& held = std::invoke(get, value); answers::mayBeLeftOut(when)) {
                if (held) {
                    json[name] = jsonOf(*held);
                }
                return;
            }
        }
        json[name] = jsonOf(std::invoke(get, value));
    }
};

template <typename T>
Json jsonOf(const T& value, std::string_view leftNull)
{
    if constexpr (std::is_enum_v<T>) {
        return name(value);
    } else if constexpr (std::is_arithmetic_v<T> || std::is_convertible_v<T, std::string>) {
        return value;
    } else if constexpr (answers::isA<T, std::reference_wrapper>) {
        return wholeJsonOf(value.get());
    } else if constexpr (answers::isA<T, std::optional>) {
        return value ? jsonOf(*value) : Json();
    } else if constexpr (answers::isA<T, std::variant>) {
        return std::visit([](const auto& held) { return jsonOf(held); }, value);
    } else if constexpr (answers::isA<T, std::tuple>) {
        return std::apply([](const auto&... item) { return Json::array({jsonOf(item)...}); },
                          value);
    } else if constexpr (std::is_same_v<T, Schedule>) {
        return jsonOf(value.phases);
    } else if constexpr (answers::Listed<T>) {
        return jsonOf(answers::listed(value));
    } else if constexpr (answers::Described<T>) {
        JsonKeys<T> keys{value, leftNull};
        describe(keys, answers::Type<T>());
        return std::move(keys.json);
    } else {
        Json list = Json::array();
        for (const typename T::value_type& item : value) {  // also of a vector<bool>
            list.push_back(jsonOf(item));
        }
        return list;
    }
}

template <typename T>
Json wholeJsonOf(const T& answer, std::string_view leftNull)
{
    Json json = newAnswer();
    json.update(jsonOf(answer, leftNull));
    return json;
}

/// One line. Bytes of a file name that are not UTF-8 become U+FFFD: JSON has no other way. DEL, the
/// one control character that JSON lets stand in a string, is escaped like the others.
inline std::string asLine(const Json& json)
{
    std::string line = json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
    for (auto at = line.find('\x7f'); at != std::string::npos; at = line.find('\x7f', at)) {
        line.replace(at, 1, "\\u007f");
    }
    return line;
}

}  // namespace signorini::cli
