#pragma once
/// \file
/// What is said of bars in a row under a harmonic over a range of frequencies.

#include "response_answer.hpp"
#include "scene_harmonic_answer.hpp"
#include "signorini/control.hpp"
#include "signorini/response.hpp"

namespace signorini::answers {

/// Which frequencies of which excitation.
struct SceneRange {
    Excited place;
    double amplitude;  ///< [N] or [m], or of a derivative [m/s], [m/s^2]
    int derivative = 0;
    std::int64_t cycles = 1;  ///< of the excitation in a period
    double leastHertz = 0.0;  ///< [Hz], of the excitation
    double mostHertz = 0.0;
    bool isExact = true;          ///< else the harmonic goes in steps
    bool triesStability = false;  ///< of motions in steps
    /// Most contacts in a period; two in steps as `ResponseRange` has them, at any two contacts, or
    /// else the motion on which bars at rest settle.
    std::int64_t contacts = 1;
    double band = 0.05;
};

/// Motions of one contact, one for each amplitude of an interval [N or m]. Closed in all steps: the
/// contact never opens.
struct SceneBranch {
    std::size_t contact = 0;
    AmplitudeBranch ofSteps = {};
};
/// What bars do in steps of any amplitude.
struct SceneAmplitudes {
    std::optional<double> open;  ///< [N or m], at which a first contact closes, where it is known
    std::vector<SceneBranch> closed = {};  ///< by contact
    std::vector<TwoContactBranch> pairs = {};
};

/// The motions at one frequency with as many contacts as were asked for; that none is left out is
/// computed, not proved, where the harmonic is exact.
struct SceneFrequency {
    std::int64_t steps = 0;  ///< n, of the period
    double hertz = 0.0;      ///< [Hz], of the excitation
    std::optional<double> ratio;
    double amplitude = 0.0;  ///< [N] or [m]
    /// [m], least of each contact while none closes; none where waves are not damped.
    std::optional<std::vector<double>> distance;
    std::vector<SceneHarmonicMotion> motions;
    std::int64_t undecided = 0;                      ///< schedules, of a staircase
    std::optional<std::string> reason;               ///< why it is not known
    std::optional<SceneAmplitudes> amplitudes = {};  ///< of a staircase

    /// Would a contact close, as far as is known?
    [[nodiscard]] bool touches() const;
};

/// The outcome of one call.
struct SceneResponse {
    SceneRange range;
    NetworkScales scales;
    SeveralBars bars;
    std::vector<SceneFrequency> frequencies = {};  ///< by descending frequency
    bool isComplete = true;                        ///< false: interrupted
    std::optional<double> yieldStress = {};        ///< [Pa], the stress is compared with it

    /// Found, also if there is no motion.
    [[nodiscard]] Status status() const;
};

/// The periods of a range in steps, ascending. \throws std::invalid_argument if there is none, or
/// they are too long for `harmonicContacts` or `contactResponses`, or have too many schedules with
/// two contacts.
[[nodiscard]] std::vector<std::int64_t> stepsOf(const SceneResponse& asked);

/// What is asked, without frequencies; of options \throws std::invalid_argument where some are
/// missing or do not go together, and as `stepsOf`.
[[nodiscard]] SceneResponse responseAsked(const Call& call, const Assembly& assembly);
[[nodiscard]] SceneResponse responseOf(const Assembly& assembly, const SceneRange& range);

/// One frequency of what is asked; waves that resonate are its reason. O(n^2) for each contact,
/// with two as addTwoContacts (two_contacts.hpp) or settledHarmonic (harmonic_network_settled.hpp);
/// none if it was cancelled. \throws as
/// harmonicContacts (harmonic_network_contact.hpp), or as contactResponses (contact_response.hpp).
[[nodiscard]] std::optional<SceneFrequency> frequencyAt(const SceneResponse& asked,
                                                        std::int64_t steps, const Cancel& cancel);

void describe(auto& d, Type<SceneFrequency>)
{
    using T = SceneFrequency;
    d.record("SceneFrequency",
             "Motions of bars with one contact or two in a period, at one frequency.");
    d.key("steps", "- >= 2", "Of the period.", &T::steps);
    d.key("frequency", "Hz > 0", "Of the excitation.", &T::hertz);
    d.key("frequency_ratio", "- > 0", "The same in omega_1 of these bars, if they vibrate.",
          &T::ratio);
    d.key("amplitude", "N or m > 0", "Of the force, or of the displacement of the base.",
          &T::amplitude);
    d.key("touches", "-", "Would bars that pass through each other meet?", &T::touches);
    d.key("distance", "m", "Least, of each contact, of bars that pass through each other.",
          &T::distance);
    d.key("motions", "-",
          "By ascending impulse, under a staircase by contact and its steps; those with two "
          "contacts last.",
          &T::motions);
    d.key(
        "undecided", "- >= 1", "Schedules of a staircase that were not decided.",
        [](const T& f) { return f.undecided > 0 ? std::optional(f.undecided) : std::nullopt; },
        When::any);
    d.key("reason", "-", "Why they are not known.", &T::reason);
}

void describe(auto& d, Type<SceneResponse>)
{
    using T = SceneResponse;
    const auto range = partOf(&T::range);
    d.record("SceneResponse",
             "Motions of bars in a row with one contact or two in a period, under a harmonic over "
             "a range "
             "of frequencies.");
    d.key("status", "-", R"("found", or "undecided": the list may lack motions.)", &T::status);
    d.key("force", "-", "What is excited: driven nodes (tip), or shaken clamps (base).",
          range(&SceneRange::place));
    d.key("exact", "-", "Is the excitation the harmonic itself, not a staircase?",
          range(&SceneRange::isExact));
    d.key("cycles", "- >= 1", "Of the excitation in a period.", range(&SceneRange::cycles));
    d.key("most_contacts", "- >= 1", "In a period.", range(&SceneRange::contacts));
    d.key("band", "- > 0",
          "How far amplitudes of two contacts may lie from the amplitude, relative.",
          [](const T& a) {
              return a.range.contacts > 1 && !a.range.isExact ? std::optional(a.range.band)
                                                              : std::nullopt;
          });
    d.key("amplitude", "N, m, m/s or m/s^2 > 0", "Of the excitation.",
          range(&SceneRange::amplitude));
    d.key("amplitude_of", "-",
          R"(Whose: "force", or of the base "displacement", "velocity" or "acceleration".)",
          [](const T& a) { return amplitudeOf(a.range.place, a.range.derivative); });
    d.key("frequency_range", "Hz > 0", "(least, most), of the excitation.",
          [](const T& a) { return std::tuple(a.range.leastHertz, a.range.mostHertz); });
    d.key("complete", "-",
          "Not interrupted, and no frequency at which waves resonate or schedules are undecided; "
          "that "
          "no motion is left out is computed, not proved.",
          [](const T& a) { return a.status() == Status::found; });
    d.key("yield_stress", "Pa > 0", "The stress is compared with it.", &T::yieldStress,
          When::program);
    d.key("frequencies", "-", "By descending frequency.", &T::frequencies);
    describeBarsAndContacts(d, &T::bars);
}

}  // namespace signorini::answers
