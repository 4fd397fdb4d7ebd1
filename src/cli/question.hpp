#pragma once
/// \file
/// A question in physics: all motions of a period, whatever their schedules.
///
/// A period T = n/N names w = 2N/G and nu = n/G, G = gcd(2N, n), and these the families: every
/// orbit with one contact in a period that presses the wall belongs to one of them. Where nu = 2
/// (an odd multiple w of omega_1) linear motions have this period, too: those that touch the wall
/// without force are one more set.

#include <cstdint>
#include <optional>
#include <string>

#include "question_answer.hpp"
#include "scene_harmonic_answer.hpp"

namespace signorini::cli {

class Given;

/// --period | --frequency | --hertz.
struct PeriodQuestion {
    std::string period;           ///< [L/c], a whole number, a fraction or a decimal
    std::string frequency;        ///< [omega_1], the same
    std::optional<double> hertz;  ///< [Hz]

    explicit PeriodQuestion(const Given& given);

    [[nodiscard]] bool isAsked() const;

    /// The period in steps of L/(Nc): the one asked for, exactly, or for hertz the nearest.
    /// \throws std::invalid_argument if more than one is given, or it is not on the grid.
    [[nodiscard]] answers::AskedPeriod on(std::int64_t cells, const Bar& bar) const;
    /// The period of a motion on no grid, in which an excitation goes through so many cycles; the
    /// frequency is that of the excitation, of hertz the nearest of the grid.
    /// \throws std::invalid_argument as above, or if it takes more than 9 digits above or below, or
    /// more cells than harmonicContacts allows.
    [[nodiscard]] ExactPeriod exactly(std::int64_t cells, const Bar& bar,
                                      std::int64_t cycles) const;

    /// The same of bars in a row. \throws std::invalid_argument unless one is given.
    [[nodiscard]] answers::AskedSteps ofBars() const;

    /// \throws std::invalid_argument unless one is given.
    void requireOne() const;
};

}  // namespace signorini::cli
