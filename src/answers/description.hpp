#pragma once
/// \file
/// How an answer is described: each key once, with its unit, a sentence, and how it is got.
///
/// `describe(d, Type<T>{})` tells a describer d what a T is:
///
///     d.record("Residuals", "Relative violations.");
///     d.key("gap", "- >= 0", "Of (31).", &Residuals::gap);
///
/// A describer writes JSON (src/cli/json.hpp), gives a Python class its properties
/// (python/src/record.hpp), or lists what there is (tests/answers/descriptions.cpp), of which
/// tools/describe makes schemas and stubs. A unit may end in "> 0", ">= 0" or ">= 1"; "-" is none.
/// Getters return numbers, truth values, text, enumerators with a name, other described records,
/// references to whole answers, and optionals, vectors, tuples or variants of these.

#include <cmath>
#include <functional>
#include <optional>
#include <tuple>
#include <type_traits>
#include <variant>
#include <vector>

#include "signorini/certificate.hpp"
#include "signorini/modes.hpp"
#include "signorini/motion.hpp"

namespace signorini::answers {

/// Which record is described.
template <typename T>
struct Type {
};

/// When a key is there.
enum class When {
    always,
    found,      ///< null unless the status is "found"
    none,       ///< null unless the status is "none"
    any,        ///< left out where the getter has nothing
    undecided,  ///< the same, but there is something where the status is "undecided"
    program,    ///< the same as `any`, in JSON only
    python,     ///< as `always`, but not in JSON
    attribute   ///< of Python's object alone: no key
};

/// May the key be left out?
constexpr bool mayBeLeftOut(When when)
{
    return when == When::any || when == When::undecided || when == When::program;
}

/// Is T an optional, a tuple, a variant ...?
template <typename T, template <typename...> class Kind>
inline constexpr bool isA = false;
template <template <typename...> class Kind, typename... Ts>
inline constexpr bool isA<Kind<Ts...>, Kind> = true;

/// A describer that only asks whether there is a description.
struct Nobody {
    template <typename... Words>
    void record(const Words&...);
    template <typename... Words>
    void key(const Words&...);
};

template <typename T>
concept Described = requires(Nobody& nobody, Type<T> type)
{
    describe(nobody, type);
};

/// Has Python a described record as a dictionary, not as a class?
template <typename T>
inline constexpr bool isDictionary = requires
{
    T::isDictionary;
};

/// A value that means something in SI units only together with a bar.
template <typename T>
struct Of {
    T value;
    Bar bar;
};

/// Each with what gives it units.
template <typename Row, typename T, typename Units>
[[nodiscard]] std::vector<Row> rowsOf(const std::vector<T>& list, const Units& units)
{
    std::vector<Row> all;
    all.reserve(list.size());
    for (const T& one : list) {
        all.push_back({one, units});
    }
    return all;
}
template <typename T>
[[nodiscard]] std::vector<Of<T>> withUnits(const std::vector<T>& list, const Bar& bar)
{
    return rowsOf<Of<T>>(list, bar);
}

/// Gets what the `value` of a record says, in SI units if one of its bar is given.
[[nodiscard]] auto ofValue(auto get)
{
    return [get](const auto& of) { return std::invoke(get, of.value); };
}
[[nodiscard]] auto ofValue(auto get, double (*unit)(const Bar& bar))
{
    return [=](const auto& of) { return std::invoke(get, of.value) * unit(of.bar); };
}
[[nodiscard]] auto ofValue(auto get, double Scales::*unit)
{
    return [=](const auto& of) { return std::invoke(get, of.value) * scales(of.bar).*unit; };
}

/// Gets of a part of a record: with `const auto range = partOf(&T::range)` the getter
/// `range(&Range::cycles)` gets the cycles of a record's range. The part may be a pointer to it.
[[nodiscard]] auto partOf(auto part)
{
    return [part](auto get) {
        return [=](const auto& of) { return std::invoke(get, std::invoke(part, of)); };
    };
}
/// The same of a part that may be missing: then nothing.
[[nodiscard]] auto ifThere(auto part)
{
    return [part](auto get) {
        return [=](const auto& of) {
            const auto& held = std::invoke(part, of);
            using Value = std::remove_cvref_t<decltype(std::invoke(get, *held))>;
            return held ? std::optional<Value>(std::invoke(get, *held)) : std::optional<Value>();
        };
    };
}

/// Nothing in place of what is not finite.
[[nodiscard]] inline std::optional<double> known(double value)
{
    return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

/// Small structs as the tuples that all surfaces show.
inline auto listed(const ExactPeriod& f)
{
    return std::tuple(f.numerator, f.denominator);
}
inline auto listed(const ExactEnergy& e)
{
    return std::tuple(e.numerator, e.denominator);
}
inline auto listed(const EnergyRange& r)
{
    return std::tuple(known(r.least), known(r.most));
}
inline auto listed(const Multiplier& m)
{
    return std::tuple(m.row, m.value);
}
inline auto listed(const RationalMultiplier& m)
{
    return std::tuple(m.row, m.value);
}
/// Contacts count from 1.
inline auto listed(const ContactMultiplier& m)
{
    return std::tuple(m.contact + 1, m.step, m.value);
}
/// So do rows of cells.
inline auto listed(const StrainMultiplier& m)
{
    return std::tuple(m.row + 1, m.right, m.left, m.value);
}
/// (n_c, n_f), on the second stop (n_c, n_f, "left").
inline auto listed(const Phase& phase)
{
    using Right = std::tuple<std::int64_t, std::int64_t>;
    using Left = std::tuple<std::int64_t, std::int64_t, Stop>;
    return phase.stop == Stop::right
               ? std::variant<Right, Left>(Right{phase.contact, phase.free})
               : std::variant<Right, Left>(Left{phase.contact, phase.free, phase.stop});
}

template <typename T>
concept Listed = requires(const T& value)
{
    listed(value);
};

}  // namespace signorini::answers
