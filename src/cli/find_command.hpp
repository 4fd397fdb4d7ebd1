#pragma once
/// \file
/// signorini find NC NF [NC NF ...], or --period|--frequency|--hertz in place of the steps.
///
/// A period is a question in physics: all motions of it, whatever their schedules. T = n/N names
/// w = 2N/G and nu = n/G, G = gcd(2N, n), and these the families: every orbit with one contact in a
/// period that presses the wall belongs to one of them. Where nu = 2 (an odd multiple w of omega_1)
/// linear motions have this period, too: those that touch the wall without force are one more set.

#include <string>
#include <utility>

#include "arguments.hpp"
#include "find_outputs.hpp"
#include "given.hpp"
#include "interrupt.hpp"
#include "question_answer.hpp"
#include "signorini/output.hpp"
#include "state_table.hpp"

namespace signorini::cli {

struct FindRequest;

/// One call.
struct FindCommand {
    const Given& given;
    CommonOptions common;
    ForceOptions force;
    std::int64_t cycles;                ///< of the force in a period
    std::optional<double> yieldStress;  ///< [Pa]

    explicit FindCommand(const Given& words);

    [[nodiscard]] ExitStatus run() const;
    [[nodiscard]] bool isForced() const { return force.ratio || force.place || force.amplitude; }
    /// Is a period asked for?
    [[nodiscard]] bool hasPeriod() const
    {
        return given.has("--period") || given.has("--frequency") || given.has("--hertz");
    }
    /// Says on stderr where a motion is not what a bar could do.
    void warn(const Physical& physical) const;

    [[nodiscard]] bool triesStability() const { return given.has("--stability"); }
    /// \throws std::invalid_argument if --stability is asked for and a period has too many steps.
    void requireTried(std::int64_t steps) const;
    /// Starts beside the motions of an answer, if --stability is asked for.
    void tryIfAsked(auto& answer) const
    {
        if (triesStability()) {
            const Interrupt interrupt;
            tryStability(answer, interrupt.cancel());
        }
    }

private:
    /// answers::asks::..., of a bar.
    [[nodiscard]] unsigned kind() const;
    /// Of a scene of several bars.
    [[nodiscard]] ExitStatus findInBars() const;
    [[nodiscard]] ExitStatus answerSchedule(const Schedule& schedule,
                                            const FindRequest& request) const;
    [[nodiscard]] ExitStatus answerQuestion(const answers::AskedPeriod& asked,
                                            const FindRequest& request) const;
};

/// The forced motions of a schedule: those of one amplitude if it is given, else the one of least
/// amplitude; the last motion, which has the largest impulse, goes to the files of the call, or the
/// answer "none" to its certificate. With a limit on strain [-], s >= -limit, only those within it.
[[nodiscard]] ExitStatus answerForced(const FindCommand& call, const Schedule& schedule);

/// All motions with one contact in a period under an exact harmonic of the amplitude given.
[[nodiscard]] ExitStatus answerHarmonic(const FindCommand& call);

/// All motions of a period of several bars, or of a bar of several segments.
[[nodiscard]] ExitStatus findPeriodInBars(const FindCommand& call, const Assembly& assembly);

/// The same under an exact harmonic; their words say what is damped.
[[nodiscard]] ExitStatus findHarmonicInBars(const FindCommand& call, const Assembly& assembly);

/// Free motions of a schedule of a network, in SI.
[[nodiscard]] ExitStatus findInScene(const FindCommand& command);

/// The same as answerForced of any bars: `driven` and `shaken` are words of the scene, its dashpots
/// its damping.
[[nodiscard]] ExitStatus findForcedInScene(const FindCommand& command);

}  // namespace signorini::cli
