#pragma once
/// \file
/// The march of the bar that detects contact, a piece of the way at a time.

#include <vector>

#include "arrivals.hpp"
#include "compensated_sum.hpp"
#include "signorini/verification.hpp"

namespace signorini {

/// What every check of a state starts from. O(N).
struct Measures {
    Measures(const State& state, const Stops& stops);

    double size = 0.0;       ///< max |x|; infinite if a value is not finite
    double halfCells = 0.0;  ///< N/2
    /// N (place of the wall - u(L)) / 2: how far the tip is from the wall, in units in which a free
    /// step with arriving wave p brings it nearer by p.
    CompensatedSum opening;
    double crossing = 0.0;  ///< from the wall to the second stop, in the same units; infinite: none

    /// A distance relative to the size.
    [[nodiscard]] double relative(double distance) const;
};

/// Steps in a row that the bar takes in the same way.
struct Turn {
    bool isHeld;
    std::int64_t count;
};

/// Runs of pressed and unpressed steps over one period, as seen from its first step.
class ContactRuns {
public:
    void press(Stop stop, std::int64_t count);
    void rest(std::int64_t count);
    /// The same period from the start of a pressed run.
    [[nodiscard]] std::vector<Phase> phases() const;

private:
    std::int64_t lead_ = 0;
    std::vector<Phase> runs_;
};

/// Knows what arrives and where the tip is, and no schedule.
class Marcher {
public:
    Marcher(const Measures& measures, double tolerance);

    /// Decides the next steps by the Signorini rule, in turns; ends early at a fault.
    [[nodiscard]] const std::vector<Turn>& take(const Arrivals& arrivals);
    /// Takes `count` steps from where the echo is, or those up to a fault.
    void run(Echo& echo, std::int64_t count);
    /// No step may lead further: the tip has entered the wall.
    [[nodiscard]] bool isAtFault() const { return march_.firstFault >= 0; }
    /// What was seen; `distance` is that of the bar from its start.
    [[nodiscard]] March seen(double distance) const;

private:
    void fly(std::int64_t count);
    void hold(Stop stop, std::int64_t count, bool pressed);
    void takeAll(const Arrivals& arrivals);
    void takeEach(const Arrivals& arrivals);
    [[nodiscard]] bool isPressedThroughout(double room, double weakest) const;
    void add(bool isHeld, std::int64_t count);

    Measures measures_;
    double atWall_;
    double pressing_;
    CompensatedSum opening_;
    ContactRuns runs_;
    March march_;
    std::int64_t step_ = 0;
    std::int64_t flight_ = 0;
    std::vector<Turn> turns_;
};

}  // namespace signorini
