#pragma once
/// \file
/// A period as people ask for it: in L/c, as a frequency in omega_1, or in Hz.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "signorini/bar.hpp"
#include "signorini/modes.hpp"

namespace signorini::answers {

/// A number > 0 as people give it: 22/7, 3.14, 3.
struct GivenNumber {
    double value = 0.0;
    std::optional<ExactPeriod> exact;  ///< unless it needs more than 18 digits, or has an exponent
};

/// A finite number > 0, plain or with its unit (units.hpp). \throws std::invalid_argument naming
/// argument, value and range.
[[nodiscard]] double parsePositive(std::string_view name, std::string_view text,
                                   std::string_view unit);
/// \throws the same.
[[nodiscard]] GivenNumber parseNumber(std::string_view name, std::string_view text,
                                      std::string_view unit);
/// The same as an exact fraction of at most 9 digits above and below, in lowest terms.
/// \throws the same.
[[nodiscard]] ExactPeriod parseFraction(std::string_view name, std::string_view text,
                                        std::string_view unit);
/// A number > 0, or such a fraction. \throws the same.
[[nodiscard]] double parseRatio(std::string_view name, std::string_view text,
                                std::string_view unit);
/// "7/2" or "4".
[[nodiscard]] std::string fractionAsText(const ExactPeriod& fraction);

/// What a frequency in Hz depends on: "L = 1 m, c = 1 m/s by default" or, of a bar that was
/// described, "L = 3 m, c = 5000 m/s".
[[nodiscard]] std::string sizeOf(const Bar& bar);

/// A period as it was asked for, and on the grid.
struct AskedPeriod {
    /// Periods of so many steps are within exact arithmetic on every grid.
    static constexpr std::int64_t leastSteps = 2;
    static constexpr std::int64_t mostSteps = 1'000'000'000'000'000;

    std::string option;      ///< period, frequency, hertz
    std::string word;        ///< what was given
    std::int64_t steps = 0;  ///< [steps], n
};

/// In steps of L/(Nc): the one asked for, exactly, or for hertz the nearest. `option`: period,
/// frequency or hertz as it was typed, "--period" too.
/// \throws std::invalid_argument naming it, if it is no number or not on the grid.
[[nodiscard]] AskedPeriod periodOnGrid(const std::string& option, const std::string& word,
                                       std::int64_t cells, const Bar& bar);

/// The period [L/c] of a motion on no grid, in which an excitation goes through so many cycles; the
/// frequency is that of the excitation, of hertz the nearest of the grid.
/// \throws std::invalid_argument as above, or if it takes more than 9 digits above or below, or
/// more cells than harmonicContacts allows.
[[nodiscard]] ExactPeriod periodExactly(const std::string& option, const std::string& word,
                                        std::int64_t cells, const Bar& bar, std::int64_t cycles);

}  // namespace signorini::answers
