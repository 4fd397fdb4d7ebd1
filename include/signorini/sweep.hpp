#pragma once
/// \file
/// What a driven bar settles on while one number is varied slowly, upward or downward, the state
/// carried over from each value to the next. docs/theory.md, section 16.
///
/// Nothing jumps where the value changes: the excitation begins at sin(0) each time, and a base
/// stands at 0 then. With another gap g the waves are carried in units of g/L: the bar keeps the
/// shape of its motion, and only F L/(EA g), or Y/g, is another.
///
/// The steps of the excitation divide L/c: frequencies are rounded for that, by 1e-5 at most (more
/// for a bar of several segments), and each point tells its own.
///
/// Units L = c = g = 1 with the gap of the range; forces in EA g/L.

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string_view>
#include <vector>

#include "signorini/settling.hpp"

namespace signorini {

/// What is varied.
enum class Swept {
    frequency,  ///< omega/omega_1 of the excitation
    amplitude,  ///< [EA g/L] (tip) or [g] (base)
    gap,        ///< in units of the range's g > 0
    damping     ///< zeta
};
/// "frequency", "amplitude", "gap", "damping".
[[nodiscard]] std::string_view name(Swept swept);

/// The order of the values.
enum class SweepDirection { up, down };
/// "up", "down".
[[nodiscard]] std::string_view name(SweepDirection direction);

/// What is asked.
struct SweepRange {
    Swept over = Swept::frequency;
    double least = 0.5;           ///< of what is varied
    double most = 2.0;            ///< of what is varied
    std::int64_t points = 101;    ///< [-], values at equal distances, both ends among them
    std::int64_t periods = 1000;  ///< [-], of the excitation, at most, at each value
    bool isCarried = true;        ///< false: each value starts at rest
    double cells = 300.0;         ///< [-], steps of the excitation in L/c, nearly
    Excited place = Excited::tip;
    double amplitude = 0.0;  ///< [EA g/L] or [g]
    int derivative = 0;      ///< as ResponseRange::derivative; not of an amplitude that is varied
    double frequencyRatio = 1.0;  ///< omega/omega_1
    Damping damping = {};
    Stops stops = {};
    std::vector<Segment> segments = {};  ///< of a bar that is not uniform
    double resolution = 0.0;             ///< [L/c], SimulationOptions::resolution; 0: one step
};

/// Most values of a sweep, and periods at each.
inline constexpr std::int64_t maxSweepPoints = 1'000'000;
inline constexpr std::int64_t maxSweepPeriods = 10'000'000;

/// What was seen at one value: least and most of the last 16 periods of the excitation, or of the
/// periods after which the motion repeats itself.
struct SweepPoint {
    double value = 0.0;
    double frequencyRatio = 1.0;  ///< omega/omega_1, by 1e-5 at most from what was asked for
    SweepDirection direction = SweepDirection::up;
    Settling settling = {};
    std::int64_t watched = 0;                   ///< [-], periods that were simulated
    std::array<std::int64_t, 2> contacts = {};  ///< in a period of the excitation
    std::array<double, 2> impulse = {};         ///< in a period of the excitation [EA g/c]
    double meanContacts = 0.0;                  ///< in a period of the excitation
    double meanImpulse = 0.0;                   ///< in a period of the excitation [EA g/c]
    std::vector<double> impulses = {};          ///< of single contacts, in their order [EA g/c]
    double meanForce = 0.0;                     ///< largest over the resolution [EA g/L]
    std::array<double, 2> tip = {};             ///< u(L) [g]
    double strain = 0.0;                        ///< max |s| over all x and t [g/L]
};

/// The values, in ascending order. \throws std::invalid_argument on a range that is none.
[[nodiscard]] std::vector<double> valuesOf(const SweepRange& range);

/// Follows the bar at one value from `waves`, which are the state at the end afterwards. After 50,
/// 100, 200, ... periods it looks whether the motion repeats itself. Nothing if it was cancelled.
[[nodiscard]] std::optional<SweepPoint> settleAt(const SweepRange& range, double value,
                                                 SweepDirection direction, Waves& waves,
                                                 const Cancel& cancel = {});

/// Hears of each point; one at a time.
using SweepListener = std::function<void(double done, double total)>;

/// Calls serve(0), ..., serve(count - 1) in any order, perhaps side by side, until one is false.
using Sharing =
    std::function<void(std::size_t count, const std::function<bool(std::size_t)>& serve)>;

/// A point, and the state in which it leaves the bar.
struct SweepStep {
    SweepPoint point;
    Waves waves;
};

/// What a call may do beside its work.
struct SweepControl {
    Cancel cancel = {};
    SweepListener show = {};
    Sharing share = {};
    /// What an earlier call kept of the same sweep; of a direction that is carried in its order.
    std::vector<SweepStep> known = {};
    std::function<void(const SweepStep&)> keep = {};  ///< hears of each other one, one at a time
};

/// What a sweep follows: a bar, or a network (network_sweep.hpp).
struct SweepBody {
    std::function<Waves()> atRest;
    /// As `settleAt`.
    std::function<std::optional<SweepPoint>(double value, SweepDirection direction, Waves& waves,
                                            const Cancel& cancel)>
        settle;
};

/// The sweeps in these directions, each in the order in which it went. With `share` carried ones
/// may go side by side, others value by value; without, one after the other. Those points that were
/// done where it was cancelled. \throws std::invalid_argument on a range that is none.
[[nodiscard]] std::vector<SweepPoint> sweep(const SweepRange& range,
                                            const std::vector<SweepDirection>& directions,
                                            const SweepControl& control = {});
[[nodiscard]] std::vector<SweepPoint> sweep(const SweepRange& range, const SweepBody& body,
                                            const std::vector<SweepDirection>& directions,
                                            const SweepControl& control);

}  // namespace signorini
