#pragma once
/// \file
/// What is said of forced motions over a range of frequencies.

#include "call.hpp"
#include "forced_answer.hpp"

namespace signorini::answers {

using PermanentOf = Of<PermanentContact>;

/// All motions at one frequency.
struct FrequencyOf {
    FrequencyResponse value;
    Bar bar;
    std::vector<Segment> segments;
    std::int64_t cycles = 1;

    /// N, of the grid that has this frequency.
    [[nodiscard]] std::int64_t cells() const;
    [[nodiscard]] std::optional<PermanentOf> permanent() const;
    [[nodiscard]] std::vector<ForcedMotionOf> motions() const;
};

/// The outcome of one call.
struct ResponseAnswer {
    ResponseRange range;
    Scene scene;
    Bar bar;                                     ///< what units mean: of the first material
    double amplitude = 0.0;                      ///< [N], [m], or of a derivative [m/s], [m/s^2]
    std::vector<FrequencyResponse> frequencies;  ///< the program's have motions without states
    bool isComplete = true;                      ///< false: interrupted
    std::optional<double> yieldStress = {};      ///< [Pa], the stress is compared with it

    [[nodiscard]] std::size_t motions() const;
    [[nodiscard]] std::int64_t undecided() const;
    /// Of the force [N] or the base's displacement [m] at one of the frequencies.
    [[nodiscard]] double amplitudeAt(const FrequencyResponse& response) const;
    /// Found, also if there is no motion: the list is whole. Undecided if it is not.
    [[nodiscard]] Status status() const
    {
        return isComplete && undecided() == 0 ? Status::found : Status::undecided;
    }
    /// The frequencies and their units.
    [[nodiscard]] std::vector<FrequencyOf> listed() const;
};

/// What is asked of a bar of so many cells, without frequencies; whether a grid has some, `stepsOf`
/// says. \throws std::invalid_argument on options that are missing or do not go together.
[[nodiscard]] ResponseAnswer responseAsked(const Call& call, const Scene& scene,
                                           std::int64_t cells);

/// --contacts and --band, the latter of two alone. \throws std::invalid_argument
void takeContacts(const Call& call, auto& range)
{
    call.read("--contacts", range.contacts);
    call.read("--band", range.band);
    refuseIf(range.contacts < 2 && call.has("--band"), "--band", call.text("--band"),
             "only together with " + call.with("--contacts", "2"));
}

/// One n of a range, its motions tried if that is asked for. \throws as responseAt.
[[nodiscard]] std::optional<FrequencyResponse> frequencyAt(const ResponseRange& range,
                                                           std::int64_t steps, bool triesStability,
                                                           const Cancel& cancel);

void describe(auto& d, Type<PermanentOf>)
{
    using P = PermanentContact;
    const auto physical = [](const PermanentOf& p) { return physicalOf(p.value.extremes, p.bar); };
    d.record("PermanentContact", "The tip that never leaves the wall.");
    d.key("least_force", "N >= 0", "Of the tip on the wall, whatever the phase.",
          ofValue(&P::leastForce, &forceUnit));
    d.key("peak_force", "N >= 0", "Of the tip on the wall.",
          [physical](const PermanentOf& p) { return physical(p).peakForce; });
    d.key("impulse", "N s >= 0", "In a period.",
          [physical](const PermanentOf& p) { return physical(p).impulse; });
    describePhysical(d, physical);
    d.key("residual", "- >= 0", "The worst that was seen walking along it; relative.",
          ofValue(&P::residual));
}

void describe(auto& d, Type<FrequencyOf>)
{
    using T = FrequencyOf;
    d.record("ForcedFrequency", "All motions at one frequency.");
    d.key("steps", "- >= 2", "n, of the period of the motions.",
          ofValue(&FrequencyResponse::steps));
    d.key("cells", "- >= 1", "N of the grid, where it is chosen.", &T::cells);
    describeFrequency(d, &FrequencyResponse::frequencyRatio);
    describeLinear(d, &FrequencyResponse::touches, &FrequencyResponse::linearPeak);
    d.key("undecided", "- >= 0", "Schedules that were not decided.",
          ofValue(&FrequencyResponse::undecided));
    d.key("reason", "-", "Why the first of them was not.", [](const T& f) {
        return f.value.undecided > 0 ? std::optional(f.value.detail) : std::nullopt;
    });
    d.key("permanent_contact", "-",
          "The tip that never leaves the wall, where the bar presses on it at rest.",
          &T::permanent);
    d.key("motions", "-", "By ascending contact steps, then impulse.", &T::motions);
}

void describe(auto& d, Type<ResponseAnswer>)
{
    using T = ResponseAnswer;
    const auto range = partOf(&T::range);
    d.record("ResponseData", "Forced motions over a range of frequencies.");
    d.key("status", "-", R"("found", or "undecided": the list may lack motions.)", &T::status);
    d.key("cells", "- >= 1", "N; of the finest grid, where it is chosen.",
          range(&ResponseRange::cells));
    describeScene(d, &T::scene);
    d.key("damping", "-", "A dashpot.", [](const T& a) {
        return Of<Damping>{a.range.damping, a.bar};
    });
    d.key("force", "-", R"(What is excited: "tip" or "base".)", range(&ResponseRange::place));
    d.key("amplitude", "N, m, m/s or m/s^2 > 0", "Of the excitation.", &T::amplitude);
    d.key("amplitude_of", "-",
          R"(Whose: "force", or of the base "displacement", "velocity" or "acceleration".)",
          [](const T& a) { return amplitudeOf(a.range.place, a.range.derivative); });
    d.key("cycles", "- >= 1", "K, of the excitation in a period of the motions.",
          range(&ResponseRange::cycles));
    d.key("contacts", "- >= 1", "Most contacts in a period.", range(&ResponseRange::contacts));
    d.key("band", "- > 0",
          "How far amplitudes of two contacts may lie from the amplitude, relative.",
          [](const T& a) {
              return a.range.contacts > 1 ? std::optional(a.range.band) : std::nullopt;
          });
    d.key("frequency_ratio_range", "- > 0", "(least, most) omega/omega_1.", [](const T& a) {
        return std::tuple(a.range.leastFrequencyRatio, a.range.mostFrequencyRatio);
    });
    d.key("complete", "-", "Not interrupted, and no schedule undecided.",
          [](const T& a) { return a.status() == Status::found; });
    d.key("yield_stress", "Pa > 0", "The stress is compared with it.", &T::yieldStress,
          When::program);
    d.key("frequencies", "-", "By descending frequency.", &T::listed);
}

}  // namespace signorini::answers
