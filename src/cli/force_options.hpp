#pragma once
/// \file
/// Damping and force, as `response` and `simulate` take them: SI in, scaled units out.

#include <optional>
#include <string>
#include <utility>

#include "arguments.hpp"
#include "signorini/simulation.hpp"

namespace signorini::cli {

/// ω₁/2π of a bar [Hz].
[[nodiscard]] double firstHertz(const Bar& bar);

/// A frequency of the excitation: "1.1" in ω₁, "530Hz", or in Hz by an option of its own.
struct FrequencyOption {
    std::optional<double> ratio;  ///< ω/ω₁
    std::optional<double> hertz;

    /// `name` and its twin in Hz.
    FrequencyOption(const Given& given, const char* name, const char* twin);
    [[nodiscard]] bool isGiven() const { return ratio || hertz; }
    /// ω/ω₁, ω₁ being so many Hz; what is meant where nothing is given.
    [[nodiscard]] double ratioFor(double firstHertz, double otherwise = 0.0) const;
};

/// What was typed of --from or --to, in ω₁ or in Hz: the option and its value, "" if neither.
[[nodiscard]] std::pair<std::string, std::string> typedEnd(const Given& given, const char* name);
/// --from up to --to. \throws std::invalid_argument naming them as they were typed.
void requireOrder(const Given& given, double least, double most);

struct ForceOptions {
    std::optional<double> ratio;
    std::optional<Excited> place;
    std::optional<double> amplitude;  ///< [N], [m], or of a derivative [m/s], [m/s²]
    int derivative = 0;               ///< of the base's displacement: 1 velocity, 2 acceleration

    explicit ForceOptions(const Given& given);

    /// \throws std::invalid_argument naming the option that is missing.
    void requirePlace() const;
    void requireAmplitude() const;  ///< see requirePlace
    /// None without --damping.
    [[nodiscard]] Damping damping() const { return {ratio.value_or(0.0)}; }
    /// In units of EA g/L (tip) or g (c/L)^derivative (base). \pre place and amplitude were given.
    [[nodiscard]] double scaledAmplitude(const Bar& bar) const;
    /// The same options with the base's displacement at so many Hz.
    [[nodiscard]] ForceOptions at(double hertz) const;
};

/// --yield-stress [Pa]. \throws std::invalid_argument where strains are not known as stresses.
[[nodiscard]] std::optional<double> yieldStressOf(const Given& given, const Bar& bar);

}  // namespace signorini::cli
