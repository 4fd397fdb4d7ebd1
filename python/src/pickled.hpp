#pragma once
/// \file
/// What a pickle holds: the bytes of a value (bytes.hpp), checked as they are read. Two objects are
/// equal if these are.

#include <pybind11/pybind11.h>

#include <algorithm>
#include <string>
#include <vector>

#include "bytes.hpp"
#include "signorini/signorini.hpp"

namespace signorini::answers {

template <>
inline constexpr std::tuple membersOf<Scene>{&Scene::bar, &Scene::secondStop, &Scene::segments};

}  // namespace signorini::answers

namespace signorini::python {

namespace py = pybind11;
using namespace answers;

/// An answer, and what Python has of it beside its keys.
template <typename Answer, typename More>
struct With : Answer {
    More more;
};
template <typename D, typename Answer, typename More>
void describe(D& d, Type<With<Answer, More>>)
{
    describe(d, Type<Answer>());
}

struct Pickler : Writer {};

struct Unpickler : Reader {
    /// \throws std::invalid_argument on what is none of the library's values.
    template <typename T>
    static void check(const T& value)
    {
        bool isReal = true;
        if constexpr (std::is_same_v<T, State>) {
            isReal = value.a.size() == value.b.size();
        } else if constexpr (std::is_same_v<T, Mode>) {
            isReal = findMode(value.a, value.b, value.gapSign) == value;
        } else if constexpr (std::is_same_v<T, ModePolytope>) {
            const std::vector<ModePolytope> real = polytopesOf(value.chains);
            isReal = std::find(real.begin(), real.end(), value) != real.end();
        } else if constexpr (std::is_enum_v<T> && requires { name(value); }) {
            (void)name(value);  // throws where there is none
        } else if constexpr (requires { validate(value); }) {
            validate(value);
        }
        if (!isReal) {
            refuse();
        }
    }
};

template <typename Bytes, typename T>
requires isA<std::remove_const_t<T>, With>
void pass(Bytes& at, T& value)
{
    [&]<typename Answer, typename More>(const With<Answer, More>&) {
        pass(at, static_cast<std::conditional_t<std::is_const_v<T>, const Answer, Answer>&>(value));
    }(value);
    pass(at, value.more);
}

/// What a set was decided with is solved for anew.
template <typename Bytes, typename T>
requires std::is_same_v<std::remove_const_t<T>, std::shared_ptr<const NetworkForced>>
void pass(Bytes&, T&) {}

template <typename T>
[[nodiscard]] std::string bytesOf(const T& value, bool isCompared)
{
    Pickler to{isCompared};
    pass(to, value);
    return to.bytes;
}

}  // namespace signorini::python
