#pragma once
/// \file
/// A study: sweeps of frequency for gaps, damping ratios and amplitudes, of each its worst.

#include <string>

#include "sweep_answer.hpp"

namespace signorini::answers {

/// The worst of one sweep of frequency, all directions. SI units; frequencies in Hz.
struct StudyPoint {
    double gap = 0.0;
    double damping = 0.0;
    double amplitude = 0.0;
    double impulse = 0.0;    ///< largest in a period; 0: it never touches
    double frequency = 0.0;  ///< where
    double meanForce = 0.0;  ///< averaged over the resolution
    std::optional<double> strain = {};
    std::optional<double> stress = {};
    std::optional<double> from = {};  ///< lowest frequency with contact, if there is any
    std::optional<double> to = {};    ///< highest
    double irregular = 0.0;  ///< share of values and directions at which no repetition was seen
};

/// One sweep of a study: a question without points, and its amplitude [N, m ...] as it was given.
struct StudyCase {
    SweepAnswer sweep;
    double amplitude = 0.0;
};

/// The columns of a table of points.
inline constexpr const char* studyHeader =
    "gap,damping,amplitude,impulse,frequency,mean_force,peak_strain,peak_stress,rattles_from,"
    "rattles_to,irregular";
/// The worst of sweeps up and down as a row without a newline, in which what is unknown is empty;
/// nothing if it was cancelled. \throws as `sweep`.
[[nodiscard]] std::optional<std::string> studyRow(const StudyCase& of, const Cancel& cancel = {});
/// With which the row of a case begins.
[[nodiscard]] std::string keyOf(const StudyCase& of);
/// Of all rows that are not empty. \throws std::invalid_argument on one that is none.
[[nodiscard]] std::vector<StudyPoint> studyPointsOf(const std::vector<std::string>& rows);

/// The outcome of one call.
struct StudyAnswer {
    Scene scene = {};        ///< of the first sweep
    std::int64_t cells = 0;  ///< N
    Excited place = Excited::tip;
    int derivative = 0;
    std::vector<StudyPoint> points;  ///< by gap, damping and amplitude, the last fastest
    bool isComplete = true;

    [[nodiscard]] Ending status() const { return isComplete ? Ending::done : Ending::interrupted; }
};

void describe(auto& d, Type<StudyPoint>)
{
    using T = StudyPoint;
    d.record("StudyPoint", "The worst of one sweep of frequency, both directions.");
    d.key("gap", "m", "From the tip at rest to the wall.", &T::gap);
    d.key("damping", "- >= 0", "zeta of the first linear mode.", &T::damping);
    d.key("amplitude", "N, m, m/s or m/s^2 > 0", "Of the excitation.", &T::amplitude);
    d.key("impulse", "N s >= 0", "Largest in a period of the excitation; 0: it never touches.",
          &T::impulse);
    d.key("frequency", "Hz > 0", "Where.", &T::frequency);
    d.key("mean_force", "N >= 0", "Largest mean over the resolution.", &T::meanForce);
    d.key("peak_strain", "- >= 0", "Largest over all x and t, where it is known.", &T::strain);
    d.key("peak_stress", "Pa >= 0", "Largest, where Young's modulus is known.", &T::stress);
    d.key("rattles_from", "Hz > 0", "Lowest frequency with contact, if there is any.", &T::from);
    d.key("rattles_to", "Hz > 0", "Highest frequency with contact.", &T::to);
    d.key("irregular", "- >= 0", "Share of values and directions at which no repetition was seen.",
          &T::irregular);
}

void describe(auto& d, Type<StudyAnswer>)
{
    using T = StudyAnswer;
    d.record("Study",
             "Sweeps of frequency for gaps, damping ratios and amplitudes. The bar is that of "
             "the first sweep, points have their own gaps.");
    d.key("status", "-", R"("done", or "interrupted".)", &T::status);
    d.key("cells", "- >= 1", "N.", &T::cells);
    describeScene(d, &T::scene);
    d.key("force", "-", R"(What is excited: "tip" or "base".)", &T::place);
    d.key("amplitude_of", "-",
          R"(Whose: "force", or of the base "displacement", "velocity" or "acceleration".)",
          [](const T& s) { return amplitudeOf(s.place, s.derivative); });
    d.key("points", "-", "[StudyPoint, ...] by gap, damping and amplitude, the last fastest.",
          &T::points);
}

}  // namespace signorini::answers
