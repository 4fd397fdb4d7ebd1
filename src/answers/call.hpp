#pragma once
/// \file
/// What a call gave of the options, whether on a command line or in Python; and what several
/// questions read of it: damping, force, frequencies. SI in, scaled units out.

#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "asked_period.hpp"
#include "excited_amplitude.hpp"
#include "faults.hpp"
#include "names.hpp"
#include "signorini/simulation.hpp"

namespace signorini::answers {

/// Says that a value cannot be. \throws std::invalid_argument naming option, value and range.
[[noreturn]] void refuse(std::string_view name, std::string_view text, std::string_view allowed);
/// The same if it is so.
void refuseIf(bool isWrong, std::string_view name, std::string_view text, std::string_view allowed);
/// Says that a call cannot be, in a sentence, if it is so. \throws std::invalid_argument.
void refuseIf(bool isWrong, std::string_view sentence);

/// The options of one call, by their names in the table (options.hpp).
class Call {
public:
    /// A flag is given where it is set.
    [[nodiscard]] virtual bool has(std::string_view option) const = 0;
    /// As it was given; empty: not given.
    [[nodiscard]] virtual std::string text(std::string_view option) const = 0;
    /// In the unit of the table.
    [[nodiscard]] virtual std::optional<double> number(std::string_view option) const = 0;
    [[nodiscard]] virtual std::optional<std::int64_t> whole(std::string_view option) const = 0;
    /// What it calls an option: --to, or to.
    [[nodiscard]] virtual std::string called(std::string_view option) const = 0;

    /// How it is given a value: --to 530Hz, or to="530Hz".
    [[nodiscard]] virtual std::string with(std::string_view option,
                                           const std::string& value) const = 0;

    /// Which of --period, --frequency and --hertz, as it is called, and its number as text: none,
    /// one without the unit. \throws std::invalid_argument if several are given.
    [[nodiscard]] std::pair<std::string, std::string> period() const;

    /// One of the values of an enumeration, by the name that a table (names.hpp) has for it.
    /// \throws std::invalid_argument where it has none.
    [[nodiscard]] auto named(std::string_view option, const auto& table) const
    {
        const std::string word = text(option);
        const auto value = valueIn(table, word);
        refuseIf(!value && !word.empty(), option, word, namesIn(table));
        return value;
    }
    /// Into its place, which keeps what is there where none is given.
    void read(std::string_view option, double& place) const
    {
        place = number(option).value_or(place);
    }
    void read(std::string_view option, std::int64_t& place) const
    {
        place = whole(option).value_or(place);
    }

protected:
    Call() = default;
    Call(const Call&) = default;
    Call& operator=(const Call&) = default;
    ~Call() = default;
};

/// --length, --gap, and what the bar is made of: --wave-speed and --axial-stiffness, or --young,
/// --density and --area or --diameter; perhaps --young beside the former. \throws
/// std::invalid_argument on a clash, or a bar that is none.
[[nodiscard]] Bar barAsked(const Call& call, bool mayHaveModulusAlone);

/// ω₁/2π of a bar [Hz].
[[nodiscard]] double firstHertz(const Bar& bar);

/// "; 530 looks like Hz: ω₁ is 494 Hz (L = 3 m, ...), so it is --to 530Hz, or --to 1.07", of a
/// ratio that was given of an option; nothing where it is none of those that are mistaken.
[[nodiscard]] std::string looksLikeHertz(const Call& call, std::string_view option, double ratio,
                                         double hertz, const std::string& size);

/// Does what may refuse such a ratio; a refusal says whether it looks like Hz.
auto hinting(const Call& call, std::string_view option, const std::optional<double>& ratio,
             double hertz, const Bar& bar, auto does)
{
    try {
        return does();
    } catch (const std::invalid_argument& error) {
        throw std::invalid_argument(
            error.what() + (ratio ? looksLikeHertz(call, option, *ratio, hertz, sizeOf(bar)) : ""));
    }
}

/// A frequency of the excitation: "1.1" in ω₁, "530Hz", or in Hz by an option of its own.
struct FrequencyOption {
    std::optional<double> ratio;  ///< ω/ω₁
    std::optional<double> hertz;

    /// `name` and its twin in Hz.
    FrequencyOption(const Call& call, const char* name, const char* twin);
    [[nodiscard]] bool isGiven() const { return ratio || hertz; }
    /// ω/ω₁, ω₁ being so many Hz; what is meant where nothing is given.
    [[nodiscard]] double ratioFor(double firstHertz, double otherwise = 0.0) const;
};

/// What was given of --from or --to, in ω₁ or in Hz: the option and its value, "" if neither.
[[nodiscard]] std::pair<std::string, std::string> givenEnd(const Call& call, const char* name);
/// --from up to --to. \throws std::invalid_argument naming them as they were given.
void requireOrder(const Call& call, double least, double most);

struct ForceOptions {
    std::optional<double> ratio;
    std::optional<Excited> place;
    std::optional<double> amplitude;  ///< [N], [m], or of a derivative [m/s], [m/s²]
    int derivative = 0;               ///< of the base's displacement: 1 velocity, 2 acceleration

    explicit ForceOptions(const Call& call);

    /// \throws std::invalid_argument naming the option that is missing.
    void requireDamping() const;
    void requirePlace() const;      ///< see requireDamping
    void requireAmplitude() const;  ///< see requireDamping
    /// None without --damping.
    [[nodiscard]] Damping damping() const { return {ratio.value_or(0.0)}; }
    /// In units of EA g/L (tip) or g (c/L)^derivative (base). \pre place and amplitude were given.
    [[nodiscard]] double scaledAmplitude(const Bar& bar) const;
    /// The same options with the base's displacement at so many Hz.
    [[nodiscard]] ForceOptions at(double hertz) const;
};

/// Of --energy and --energy-ratio at most one. \throws std::invalid_argument
void requireOneEnergy(const Call& call);

/// --yield-stress [Pa]. \throws std::invalid_argument where strains are not known as stresses.
[[nodiscard]] std::optional<double> yieldStressOf(const Call& call, const Bar& bar);

}  // namespace signorini::answers
