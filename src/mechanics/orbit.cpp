#include "signorini/motion.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "arrivals.hpp"
#include "echo.hpp"
#include "faults.hpp"
#include "stops.hpp"

namespace signorini {

namespace {

/// One step of a ring, the earlier the greater.
struct Arrival {
    bool startsContact = false;  ///< a step with force after one without
    double p = 0.0;              ///< [g/L]

    friend bool operator==(const Arrival&, const Arrival&) = default;

    [[nodiscard]] bool isBefore(const Arrival& other) const
    {
        return startsContact != other.startsContact ? startsContact : p > other.p;
    }
};

/// Calls visit(p_m, sign of a push) for every step of one period: 1 at the wall, -1 at the second
/// stop, 0 in flight. O(n).
template <typename Visit>
void forEachStep(const State& state, const Schedule& schedule, Visit visit)
{
    Echo echo(state);
    const auto walk = [&](std::int64_t count, bool isContact, int push) {
        forEachPiece(echo, count, isContact, [&](const Arrivals& next) {
            for (std::int64_t k = 0; k < next.count(); ++k) {
                visit(next.at(k), push);
            }
        });
    };
    for (const Phase& phase : schedule.phases) {
        walk(phase.contact, true, pushSign(phase.stop));
        walk(phase.free, false, 0);
    }
}

std::vector<Arrival> ringOf(const State& state, const Schedule& folded)
{
    std::vector<Arrival> ring;
    ring.reserve(static_cast<std::size_t>(steps(folded)));
    // A period ends in flight, so there is no force before its first step.
    bool wasPressed = false;
    forEachStep(state, folded, [&](double p, int push) {
        const bool isPressed = push * p > 0.0;
        ring.push_back({isPressed && !wasPressed, p + 0.0});  // -0 + 0 is +0
        wasPressed = isPressed;
    });
    return ring;
}

/// Where the first rotation of a ring begins. Two candidates are compared; `equal` places after
/// them agree, and the one that loses takes all the places it passed out of the contest.
std::size_t firstRotation(const std::vector<Arrival>& ring)
{
    const std::size_t count = ring.size();
    std::size_t left = 0;
    std::size_t right = 1;
    std::size_t equal = 0;
    while (left < count && right < count && equal < count) {
        const Arrival& ofLeft = ring[(left + equal) % count];
        const Arrival& ofRight = ring[(right + equal) % count];
        if (ofLeft == ofRight) {
            ++equal;
            continue;
        }
        std::size_t& loser = ofLeft.isBefore(ofRight) ? right : left;
        loser += equal + 1;
        right += left == right ? 1 : 0;
        equal = 0;
    }
    return std::min(left, right);
}

std::vector<Arrival> rotated(std::vector<Arrival> ring)
{
    const auto first = static_cast<std::ptrdiff_t>(firstRotation(ring));
    std::rotate(ring.begin(), ring.begin() + first, ring.end());
    return ring;
}

bool isNear(const std::vector<double>& first, const std::vector<double>& second, double distance)
{
    const auto isSmaller = [](double a, double b) { return std::abs(a) < std::abs(b); };
    const auto anchor = std::max_element(second.begin(), second.end(), isSmaller);
    const std::size_t count = first.size();
    const auto offset = static_cast<std::size_t>(anchor - second.begin());
    for (std::size_t shift = 0; shift < count; ++shift) {
        // The anchor first: most shifts fail there.
        std::size_t m = 0;
        while (m < count && std::abs(first[(shift + offset + m) % count] -
                                     second[(offset + m) % count]) <= distance) {
            ++m;
        }
        if (m == count) {
            return true;
        }
    }
    return false;
}

}  // namespace

std::vector<double> arrivals(const State& state, const Schedule& schedule)
{
    const Schedule folded = foldedFor(state, schedule);
    std::vector<double> result;
    result.reserve(static_cast<std::size_t>(steps(folded)));
    forEachStep(state, folded, [&result](double p, int) { result.push_back(p); });
    return result;
}

State orbitRepresentative(const State& state, const Schedule& schedule)
{
    const std::vector<Arrival> ring = rotated(ringOf(state, foldedFor(state, schedule)));
    // A period shorter than 2N repeats in the state.
    State result = stateOfWaves(schedule.cells, [&ring](std::int64_t m) {
        return ring[static_cast<std::size_t>(m) % ring.size()].p;
    });
    result.b.array() += 0.0;  // -0 + 0 is +0
    return result;
}

bool isSameOrbit(const State& first, const State& second, const Schedule& schedule,
                 double tolerance)
{
    if (!(std::isfinite(tolerance) && tolerance >= 0.0)) {
        throwFault("tolerance", tolerance, "finite numbers >= 0");
    }
    const Schedule folded = foldedFor(first, schedule);
    (void)foldedFor(second, schedule);
    if (tolerance == 0.0) {
        return rotated(ringOf(first, folded)) == rotated(ringOf(second, folded));
    }
    const double largest = std::max(amplitude(first), amplitude(second));
    return isNear(arrivals(first, folded), arrivals(second, folded), tolerance * largest);
}

}  // namespace signorini
