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
#include <utility>

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

    /// As periodOnGrid (asked_period.hpp). \throws std::invalid_argument also if more than one is
    /// given.
    [[nodiscard]] answers::AskedPeriod on(std::int64_t cells, const Bar& bar) const;
    /// As periodExactly, likewise.
    [[nodiscard]] ExactPeriod exactly(std::int64_t cells, const Bar& bar,
                                      std::int64_t cycles) const;
    /// The same of bars in a row.
    [[nodiscard]] answers::AskedSteps ofBars() const;

private:
    /// The option and its word. \throws std::invalid_argument unless one is given.
    [[nodiscard]] std::pair<std::string, std::string> one() const;
};

}  // namespace signorini::cli
