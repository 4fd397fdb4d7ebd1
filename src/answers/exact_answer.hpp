#pragma once
/// \file
/// What is said of motions under an exact harmonic over a range of frequencies.

#include "exact_response.hpp"
#include "harmonic_answer.hpp"

namespace signorini::answers {

/// All at one frequency.
struct ExactFrequencyOf {
    ExactFrequency value;
    Bar bar;

    [[nodiscard]] std::vector<HarmonicMotionOf> motions() const;
};

/// A named point of a curve.
struct BranchMarkOf {
    BranchMark value;
    Bar bar;
};

/// A point of a curve.
struct BranchPointOf {
    BranchPoint value;
    Bar bar;
    ExactStability stability;

    [[nodiscard]] Physical physical() const { return physicalOf(value.motion.extremes, bar); }
};

struct ExactBranchOf {
    ExactBranch value;
    Bar bar;

    [[nodiscard]] std::vector<BranchPointOf> points() const;
    [[nodiscard]] std::vector<BranchMarkOf> marks() const;
};

/// The outcome of one call.
struct ExactAnswer {
    ResponseRange range;
    Scene scene;
    Bar bar;
    double amplitude = 0.0;  ///< [N or m]
    std::vector<ExactFrequency> frequencies;
    std::vector<ExactBranch> branches;
    bool isComplete = true;

    [[nodiscard]] Status status() const { return isComplete ? Status::found : Status::undecided; }
    [[nodiscard]] std::vector<ExactFrequencyOf> listed() const;
    [[nodiscard]] std::vector<ExactBranchOf> curves() const;
};

/// In Hz.
[[nodiscard]] inline double hertzOf(double frequencyRatio, const Bar& bar)
{
    return frequencyRatio / 4.0 / scales(bar).time;
}

template <typename D>
void describe(D& d, Type<ExactFrequencyOf>)
{
    using T = ExactFrequencyOf;
    d.record("ExactFrequency", "All motions under an exact harmonic at one frequency.");
    d.key("steps", "- >= 1", "T in L/(N c).", [](const T& f) { return f.value.steps; });
    d.key("frequency_ratio", "- > 0", "omega/omega_1 of the excitation.",
          [](const T& f) { return f.value.frequencyRatio; });
    d.key("frequency", "Hz > 0", "Of the excitation.",
          [](const T& f) { return hertzOf(f.value.frequencyRatio, f.bar); });
    d.key("touches", "-", "Would the bar without a wall go beyond it?",
          [](const T& f) { return f.value.touches; });
    d.key("linear_peak", "m >= 0", "max u(L) without a wall.",
          [](const T& f) { return f.value.linearPeak * scales(f.bar).displacement; });
    d.key("motions", "-",
          "All with one contact; where none of them is known to attract, what a bar at rest "
          "settles on.",
          &T::motions);
}

template <typename D>
void describe(D& d, Type<BranchPointOf>)
{
    using T = BranchPointOf;
    d.record("BranchPoint", "A motion on a curve of motions.");
    d.key("frequency_ratio", "- > 0", "omega/omega_1 of the excitation.",
          [](const T& p) { return p.value.frequencyRatio; });
    d.key("frequency", "Hz > 0", "Of the excitation.",
          [](const T& p) { return hertzOf(p.value.frequencyRatio, p.bar); });
    d.key("contacts", "- >= 1", "In a period.",
          [](const T& p) { return std::ssize(p.value.motion.contacts); });
    d.key("phase", "rad", "Of the excitation at the start of the first contact.",
          [](const T& p) { return p.value.motion.phase; });
    d.key("impulse", "N s >= 0", "In a period.", [](const T& p) { return p.physical().impulse; });
    d.key("peak_force", "N >= 0", "Of the tip on the stops.",
          [](const T& p) { return p.physical().peakForce; });
    d.key("tip_lowest", "m", "min u(L, t).", [](const T& p) { return p.physical().tipLowest; });
    d.key("growth", "- > 0", "Of a small disturbance in a period; nothing where it is not known.",
          [](const T& p) { return p.stability.growth; });
    d.key("attracts", "-", "Does the bar come back? Nothing where it is not known.",
          [](const T& p) { return p.stability.attracts; });
}

template <typename D>
void describe(D& d, Type<BranchMarkOf>)
{
    using T = BranchMarkOf;
    d.record("BranchMark", "A named point of a curve of motions.");
    d.key("event", "-", R"("fold", "new contact", "lost contact", "pin" or "end".)",
          [](const T& m) { return name(m.value.event); });
    d.key("after", "- >= 0", "The point of the curve before it.",
          [](const T& m) { return static_cast<std::int64_t>(m.value.after); });
    d.key("frequency_ratio", "- > 0", "omega/omega_1 of the excitation.",
          [](const T& m) { return m.value.frequencyRatio; });
    d.key("frequency", "Hz > 0", "Of the excitation.",
          [](const T& m) { return hertzOf(m.value.frequencyRatio, m.bar); });
}

template <typename D>
void describe(D& d, Type<ExactBranchOf>)
{
    using T = ExactBranchOf;
    d.record("Branch", "A curve of motions along the frequency.");
    d.key("points", "-", "As they follow each other.", &T::points);
    d.key("marks", "-", "Named points.", &T::marks);
}

template <typename D>
void describe(D& d, Type<ExactAnswer>)
{
    using T = ExactAnswer;
    d.record("ExactResponse", "Motions under an exact harmonic over a range of frequencies.");
    d.key("status", "-", R"("found", or "undecided": it was interrupted.)", &T::status);
    d.key("cells", "- >= 1", "N: periods are whole numbers of L/(N c).",
          [](const T& a) { return a.range.cells; });
    describeScene(d, [](const T& a) -> const Scene& { return a.scene; });
    d.key("damping", "-", "A dashpot.", [](const T& a) {
        return Of<Damping>{a.range.damping, a.bar};
    });
    d.key("force", "-", R"(What is excited: "tip" or "base".)",
          [](const T& a) { return a.range.place; });
    d.key("amplitude", "N or m > 0", "Of the excitation.", &T::amplitude);
    d.key("cycles", "- >= 1", "K, of the excitation in a period.",
          [](const T& a) { return a.range.cycles; });
    d.key("frequencies", "-", "By ascending steps.", &T::listed);
    d.key("branches", "-", "Curves of motions.", &T::curves);
}

}  // namespace signorini::answers
