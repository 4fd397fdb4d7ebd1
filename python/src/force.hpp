#pragma once
/// \file
/// Words for excitations, and forced motions as Python has them.

#include <string>

#include "faults.hpp"
#include "forced_answer.hpp"
#include "names.hpp"
#include "scene.hpp"
#include "signorini/response.hpp"
#include "signorini/simulation.hpp"

namespace signorini::python {

/// One of the names of a table. \throws std::invalid_argument naming the argument.
template <typename Table>
auto valueOf(const char* argument, const std::string& word, const Table& table)
{
    const auto value = valueIn(table, word);
    if (!value) {
        Faults faults;
        faults.add(argument, word, namesIn(table));
        faults.throwIfAny();
    }
    return *value;
}

/// "tip" or "base". \throws std::invalid_argument for another word.
[[nodiscard]] Excited placeOf(const std::string& force);

/// [N] or [m], of an amplitude of the base's velocity or acceleration at a frequency.
[[nodiscard]] double displaced(double amplitude, int derivative, double frequencyRatio,
                               const Bar& bar);

using MotionOf = answers::ForcedMotionOf;
template <>
struct Members<MotionOf> {
    static constexpr auto list =
        std::tuple{&MotionOf::value, &MotionOf::bar, &MotionOf::isOfResponse, &MotionOf::segments};
};

}  // namespace signorini::python
