#pragma once
/// \file
/// What is said of motions under an exact harmonic over a range of frequencies.

#include "exact_response.hpp"
#include "harmonic_answer.hpp"

namespace signorini::answers {

using ExactFrequencyOf = Of<ExactFrequency>;
using BranchMarkOf = Of<BranchMark>;
using ExactBranchOf = Of<ExactBranch>;

/// A point of a curve.
struct BranchPointOf {
    BranchPoint value;
    Bar bar;
    ExactStability stability;

    [[nodiscard]] Physical physical() const { return physicalOf(value.motion.extremes, bar); }
};

/// What each holds, and its units.
[[nodiscard]] std::vector<HarmonicMotionOf> motionsOf(const ExactFrequencyOf& at);
[[nodiscard]] std::vector<BranchPointOf> pointsOf(const ExactBranchOf& branch);

/// The outcome of one call.
struct ExactAnswer {
    ResponseRange range;
    Scene scene;
    Bar bar;
    double amplitude = 0.0;  ///< [N or m]
    std::vector<ExactFrequency> frequencies;
    std::vector<ExactBranch> branches;
    bool isComplete = true;
    std::optional<double> yieldStress = {};  ///< [Pa], the stress is compared with it

    [[nodiscard]] Status status() const { return isComplete ? Status::found : Status::undecided; }
};

/// In Hz.
[[nodiscard]] inline double hertzOf(double frequencyRatio, const Bar& bar)
{
    return frequencyRatio / 4.0 / scales(bar).time;
}

void describe(auto& d, Type<ExactFrequencyOf>)
{
    d.record("ExactFrequency", "All motions under an exact harmonic at one frequency.");
    d.key("steps", "- >= 1", "T in L/(N c).", ofValue(&ExactFrequency::steps));
    describeFrequency(d, &ExactFrequency::frequencyRatio);
    describeLinear(d, &ExactFrequency::touches, &ExactFrequency::linearPeak);
    d.key("motions", "-",
          "All with one contact; where none of them is known to attract, what a bar at rest "
          "settles on.",
          &motionsOf);
}

void describe(auto& d, Type<BranchPointOf>)
{
    using T = BranchPointOf;
    const auto physical = partOf(&T::physical);
    const auto stability = partOf(&T::stability);
    d.record("BranchPoint", "A motion on a curve of motions.");
    describeFrequency(d, &BranchPoint::frequencyRatio);
    d.key("contacts", "- >= 1", "In a period.",
          [](const T& p) { return std::ssize(p.value.motion.contacts); });
    d.key("phase", "rad", "Of the excitation at the start of the first contact.",
          [](const T& p) { return p.value.motion.phase; });
    d.key("impulse", "N s >= 0", "In a period.", physical(&Physical::impulse));
    d.key("peak_force", "N >= 0", "Of the tip on the stops.", physical(&Physical::peakForce));
    d.key("tip_lowest", "m", "min u(L, t).", physical(&Physical::tipLowest));
    d.key("growth", "- > 0", "Of a small disturbance in a period; nothing where it is not known.",
          stability(&ExactStability::growth));
    d.key("attracts", "-", "Does the bar come back? Nothing where it is not known.",
          stability(&ExactStability::attracts));
}

void describe(auto& d, Type<BranchMarkOf>)
{
    using T = BranchMarkOf;
    d.record("BranchMark", "A named point of a curve of motions.");
    d.key("event", "-", R"("fold", "grazing", "new contact", "lost contact", "pin" or "end".)",
          [](const T& m) { return name(m.value.event); });
    d.key("after", "- >= 0", "The point of the curve before it.",
          [](const T& m) { return static_cast<std::int64_t>(m.value.after); });
    describeFrequency(d, &BranchMark::frequencyRatio);
}

void describe(auto& d, Type<ExactBranchOf>)
{
    d.record("Branch", "A curve of motions along the frequency.");
    d.key("points", "-", "As they follow each other.", &pointsOf);
    d.key("marks", "-", "Named points.", [](const ExactBranchOf& branch) {
        return withUnits(branch.value.curve.marks, branch.bar);
    });
}

void describe(auto& d, Type<ExactAnswer>)
{
    using T = ExactAnswer;
    const auto range = partOf(&T::range);
    d.record("ExactResponse", "Motions under an exact harmonic over a range of frequencies.");
    d.key("status", "-", R"("found", or "undecided": it was interrupted.)", &T::status);
    d.key("cells", "- >= 1", "N: periods are whole numbers of L/(N c).",
          range(&ResponseRange::cells));
    describeScene(d, &T::scene);
    d.key("damping", "-", "A dashpot.", [](const T& a) {
        return Of<Damping>{a.range.damping, a.bar};
    });
    d.key("force", "-", R"(What is excited: "tip" or "base".)", range(&ResponseRange::place));
    d.key("amplitude", "N or m > 0", "Of the excitation.", &T::amplitude);
    d.key("cycles", "- >= 1", "K, of the excitation in a period.", range(&ResponseRange::cycles));
    d.key("yield_stress", "Pa > 0", "The stress is compared with it.", &T::yieldStress,
          When::program);
    d.key("complete", "-", "Or interrupted?", &T::isComplete);
    d.key("frequencies", "-", "By ascending steps.",
          [](const T& a) { return withUnits(a.frequencies, a.bar); });
    d.key("branches", "-", "Curves of motions.",
          [](const T& a) { return withUnits(a.branches, a.bar); });
}

}  // namespace signorini::answers
