#include "force_range.hpp"

#include <algorithm>
#include <cmath>

#include "faults.hpp"
#include "interval.hpp"
#include "network_sweep.hpp"

namespace signorini {

namespace {

constexpr double noWave = 1e-300;
constexpr double touching = 1e-9;     // relative to the gap
constexpr double wholeWithin = 1e-9;  // [h], a duration so near to whole steps is that

/// What a force of each step so long ago does: enclosures, step by step.
struct Response {
    std::vector<Interval> velocity;
    std::vector<Interval> displacement;  ///< K: of all steps until then
};

/// The sum of what a contact's velocity is made of.
auto relative(const NetworkContact& contact, const auto& of)
{
    return contact.kind == ContactKind::gap ? of(contact.node) - of(contact.node + 1)
                                            : of(contact.node);
}

std::vector<Response> responsesOf(Network network, std::int64_t steps)
{
    for (NetworkNode& node : network.nodes) {
        node.force = 0.0;  // what is constant is part of the rest
    }
    const NetworkLaw<Interval> law(network, 0);
    NetworkWaves<Interval> waves(network, std::vector<Interval>(network.waves()));
    std::vector<Response> responses(network.contacts.size());
    for (std::int64_t m = 0; m < steps; ++m) {
        const Interval force(m == 0 ? 1.0 : 0.0);
        for (std::size_t j = 0; j < responses.size(); ++j) {
            Response& response = responses[j];
            const Interval velocity = relative(network.contacts[j], [&](std::size_t node) {
                return law.velocity(node).at(waves.arriving(), force, Interval());
            });
            // A wave that is not there is 0, whatever intervals were widened by.
            const bool isNone = velocity.magnitude().high < noWave;
            response.velocity.push_back(isNone ? Interval() : velocity);
            response.displacement.push_back(m == 0 ? response.velocity.back()
                                                   : response.displacement.back() +
                                                         response.velocity.back());
        }
        waves.step(law, force);
    }
    return responses;
}

/// Largest product of a response and a force that may be chosen.
Interval largestProduct(const Interval& response, double low, double high)
{
    const Interval one = response * Interval(low);
    const Interval other = response * Interval(high);
    return {std::max(one.low, other.low), std::max(one.high, other.high)};
}

/// Sums of the largest products, at the ends of steps: entry m is that of the first m.
std::vector<Interval> sumsOf(const std::vector<Interval>& responses, double low, double high,
                             double sign)
{
    std::vector<Interval> sums(1);
    for (const Interval& response : responses) {
        sums.push_back(sums.back() + largestProduct(Interval(sign) * response, low, high));
    }
    return sums;
}

/// One question: sign 1 for the most, -1 for the least.
struct Asked {
    std::size_t contact;
    bool isVelocity;
    double sign;
};

class Reach {
public:
    Reach(const Network& network, double low, double high, double duration)
        : network_(network), low_(low), high_(high), start_(startAtRest(network))
    {
        for (std::size_t j = 0; j < network_.contacts.size(); ++j) {
            const double distance = distanceOf(j);
            if (distance <= touching * std::abs(network_.contacts[j].gap)) {
                throwFault(fmt::format("distance of contact {} at rest", j + 1),
                           distance * network_.scales.displacement, "> 0 [m]");
            }
        }
        const double steps = std::round(duration);
        duration_ = std::abs(duration - steps) <= wholeWithin ? steps : duration;
        responses_ = responsesOf(network, static_cast<std::int64_t>(std::floor(duration_)) + 1);
    }

    ForceReach answer()
    {
        ForceReach reach;
        for (std::size_t j = 0; j < network_.contacts.size(); ++j) {
            findClosing(j, reach);
        }
        reach.duration = duration_;
        for (std::size_t j = 0; j < network_.contacts.size(); ++j) {
            reach.contacts.push_back({peakOf({j, true, -1.0}), peakOf({j, true, 1.0}),
                                      peakOf({j, false, -1.0}), peakOf({j, false, 1.0})});
        }
        return reach;
    }

private:
    [[nodiscard]] double startOf(std::size_t contact) const
    {
        return relative(network_.contacts[contact],
                        [this](std::size_t node) { return start_.displacements[node]; });
    }

    /// At rest.
    [[nodiscard]] double distanceOf(std::size_t contact) const
    {
        const NetworkContact& one = network_.contacts[contact];
        return one.gap - (one.kind == ContactKind::stopLeft ? -1.0 : 1.0) * startOf(contact);
    }

    /// Cuts the duration where the contact can first close.
    void findClosing(std::size_t j, ForceReach& reach)
    {
        const NetworkContact& contact = network_.contacts[j];
        const double sign = contact.kind == ContactKind::stopLeft ? -1.0 : 1.0;
        const double gap = distanceOf(j);
        const std::vector<Interval> sums = sumsOf(responses_[j].displacement, low_, high_, sign);
        for (std::size_t m = 0; m + 1 < sums.size(); ++m) {
            if (sums[m + 1].high >= gap) {
                const double left = gap - sums[m].high;
                const double time = static_cast<double>(m) +
                                    (left > 0.0 ? left / (sums[m + 1].high - sums[m].high) : 0.0);
                if (time < duration_) {
                    duration_ = time;
                    reach.closes = j;
                }
                return;
            }
        }
    }

    [[nodiscard]] ForcePeak peakOf(const Asked& asked) const
    {
        const Response& response = responses_[asked.contact];
        const std::vector<Interval> sums = sumsOf(
            asked.isVelocity ? response.velocity : response.displacement, low_, high_, asked.sign);
        // At rest both are 0. Sums that differ by rounding alone are reached by the first of them.
        ForcePeak peak;
        double bound = 0.0;
        double reached = 0.0;
        const auto see = [&](const Interval& sum, double time) {
            bound = std::max(bound, sum.high);
            if (sum.low > reached) {
                reached = sum.low;
                peak.time = time;
            }
        };
        for (std::size_t m = 0; static_cast<double>(m) < duration_; ++m) {
            if (asked.isVelocity) {
                see(sums[m + 1], static_cast<double>(m));
            } else {
                const double end = std::min(duration_, static_cast<double>(m) + 1.0);
                const double part = end - static_cast<double>(m);
                see({std::lerp(sums[m].low, sums[m + 1].low, part),
                     std::lerp(sums[m].high, sums[m + 1].high, part)},
                    end);
            }
        }
        const double from = asked.isVelocity ? 0.0 : startOf(asked.contact);
        peak.bound = bound > noWave ? from + asked.sign * bound : from;
        peak.reached = follow(asked, peak.time);
        return peak;
    }

    /// The same by a simulation under the force that the signs of the response name.
    [[nodiscard]] double follow(const Asked& asked, double time) const
    {
        const Response& response = responses_[asked.contact];
        const std::vector<Interval>& chosen =
            asked.isVelocity ? response.velocity : response.displacement;
        const double end = asked.isVelocity ? time + 1.0 : time;
        const auto steps = static_cast<std::size_t>(std::ceil(end));
        NetworkDrive drive;
        drive.past = static_cast<double>(steps) - end;
        for (std::size_t k = steps; k-- > 0;) {
            const bool isMost = asked.sign * (chosen[k].low + chosen[k].high) >= 0.0;
            drive.forces.push_back(isMost ? high_ : low_);
        }
        drive.forces.push_back(0.0);
        NetworkSimulation simulation(network_, start_, drive);
        // A velocity lasts for a step, or until a contact can close.
        simulation.advance(asked.isVelocity ? 0.5 * (time + std::min(time + 1.0, duration_))
                                            : time);
        return relative(network_.contacts[asked.contact], [&](std::size_t node) {
            return asked.isVelocity ? simulation.velocity(node) : simulation.displacement(node);
        });
    }

    const Network& network_;
    double low_;
    double high_;
    double duration_ = 0.0;
    NetworkStart start_;
    std::vector<Response> responses_;
};

}  // namespace

ForceReach reachUnder(const Network& network, double low, double high, double duration)
{
    if (!isExcitable(network, Excited::tip)) {
        throw std::invalid_argument("scene: allowed one with the word driven, where the force is");
    }
    return Reach(network, low, high, duration).answer();
}

}  // namespace signorini
