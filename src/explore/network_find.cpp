#include "network_find.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "energy_floor.hpp"
#include "faults.hpp"
#include "least_norm.hpp"
#include "network_forced.hpp"

namespace signorini {

namespace {

constexpr double broken = 1e-10;  // a row, relative to waves of the motion's size

/// Is there something that rest has to give way to, or may lean on anywhere?
bool isMoved(const Network& network)
{
    return !driftingBars(network).empty() || !(withoutForces(network) == network);
}

RowSystem systemOf(const NetworkForced& waves)
{
    const std::vector<ForcedRow>& rows = waves.rows();
    const Eigen::Index unknowns = waves.freeWaves();
    const auto count = static_cast<Eigen::Index>(rows.size());
    RowSystem system{Eigen::MatrixXd::Zero(count, unknowns), Eigen::VectorXd(count), 0};
    Eigen::Index next = 0;
    for (const bool isEquality : {true, false}) {
        for (const ForcedRow& row : rows) {
            if (row.isEquality != isEquality) {
                continue;
            }
            for (const auto& [wave, factor] : row.free) {
                system.rows(next, static_cast<Eigen::Index>(wave)) = factor;
            }
            system.rhs[next++] = row.limit;
            system.equalities += isEquality ? 1 : 0;
        }
    }
    return system;
}

/// In the order of the rows.
std::vector<double> inOrder(const NetworkForced& waves, const Eigen::VectorXd& multipliers)
{
    std::vector<double> all;
    Eigen::Index equal = 0;
    Eigen::Index other = std::count_if(waves.rows().begin(), waves.rows().end(),
                                       [](const ForcedRow& row) { return row.isEquality; });
    for (const ForcedRow& row : waves.rows()) {
        all.push_back(multipliers[row.isEquality ? equal++ : other++]);
    }
    return all;
}

}  // namespace

void requireKnown(const Network& network, const std::vector<ContactSpan>& schedule)
{
    validate(network);
    Faults faults;
    if (network.waves() > mostForcedWaves) {
        faults.add("waves", network.waves(), fmt::format("at most {}", mostForcedWaves));
    }
    std::int64_t steps = 0;
    for (const ContactSpan& span : schedule) {
        faults.requireWhole("steps", span.steps, std::int64_t{1'000'000});
        if (network.contacts.size() < maxContacts && span.closed >> network.contacts.size() != 0) {
            faults.add("closed contacts", fmt::format("{:#x}", span.closed),
                       fmt::format("sets of contacts 1..{}", network.contacts.size()));
        }
        steps += span.steps;
    }
    faults.requireWhole("steps of a period", steps, std::int64_t{1'000'000});
    faults.throwIfAny();
    if ((schedule.front().closed & ~schedule.back().closed) == 0) {
        faults.add("first set", fmt::format("{:#x}", schedule.front().closed),
                   "sets with a contact that the last one leaves open");
    }
    // Distances are 0 where contacts close; without gaps the bars at rest meet every row.
    ContactSet touched = 0;
    bool isAtRest = !isMoved(network);
    for (const ContactSpan& span : schedule) {
        touched |= span.closed;
    }
    for (std::size_t j = 0; j < network.contacts.size(); ++j) {
        const double gap = network.contacts[j].gap;
        isAtRest = isAtRest && (contains(touched, j) ? gap == 0.0 : gap >= 0.0);
    }
    if (isAtRest) {
        faults.add(
            "gaps", 0,
            "one that is not 0 at a contact that closes: else the bars at rest are a motion");
    }
    faults.throwIfAny();
}

NetworkMotions leastMotion(const Network& network, const std::vector<ContactSpan>& schedule,
                           double largest, const Cancel& cancel)
{
    requireKnown(network, schedule);
    const NetworkForced waves(network, schedule, {});
    NetworkMotions answer;
    if (!waves.isClear()) {
        answer.detail = "rounding hides which waves a period leaves as they are";
        return answer;
    }
    answer.kernelDimension = waves.freeWaves();
    std::vector<std::size_t> numbers(waves.rows().size());
    for (std::size_t k = 0; k < numbers.size(); ++k) {
        numbers[k] = k;
    }
    const LeastNorm least = leastNorm(systemOf(waves), broken, std::sqrt(largest), cancel);
    if (least.end == LeastNormEnd::stopped) {
        answer.detail = isRequested(cancel)
                            ? "cancelled"
                            : "rounding does not tell which conditions are in force";
        return answer;
    }
    std::vector<double> multipliers = inOrder(waves, least.multipliers);
    answer.multipliers = waves.floor(numbers, multipliers, least.end == LeastNormEnd::found);
    answer.provedEnergy = provedEnergy(answer.multipliers, network, schedule);
    if (least.end == LeastNormEnd::empty) {
        answer.status = answer.provedEnergy >= largest ? Status::none : Status::undecided;
        answer.detail = answer.status == Status::none
                            ? ""
                            : "conditions exclude each other by no more than rounding can do";
        return answer;
    }
    const std::vector<double> z(least.z.begin(), least.z.end());
    NetworkClaim claim{.waves = waves.waves({}, z), .displacements = waves.displacements({}, z)};
    for (const ContactSpan& span : schedule) {
        claim.schedule.push_back({span.closed, span.steps});
    }
    answer.residuals = walk(network, claim);
    if (!(answer.residuals.worst() <= networkTolerance)) {
        answer.detail = fmt::format("the motion that was found leaves a residual of {:.3g}",
                                    answer.residuals.worst());
        return answer;
    }
    answer.status = Status::found;
    answer.energy = least.z.squaredNorm() + waves.steadyEnergy();
    answer.motion = std::move(claim);
    return answer;
}

bool pushesBalance(const Network& network, const std::vector<ContactSpan>& schedule)
{
    ContactSet touched = 0;
    for (const ContactSpan& span : schedule) {
        touched |= span.closed;
    }
    // Contacts that cannot press, as theirs would be the only push on a bar without forces.
    std::vector<bool> isIdle(network.contacts.size(), false);
    for (bool goesOn = true; goesOn;) {
        goesOn = false;
        for (const std::size_t bar : driftingBars(network)) {
            double force = 0.0;
            for (const NetworkNode& node : network.nodes) {
                force += node.bar == bar ? std::abs(node.force) : 0.0;
            }
            std::vector<std::size_t> one;
            std::vector<std::size_t> other;
            for (std::size_t j = 0; j < network.contacts.size(); ++j) {
                const NetworkContact& contact = network.contacts[j];
                const bool isGap = contact.kind == ContactKind::gap;
                if (!contains(touched, j) || isIdle[j]) {
                    continue;
                }
                if (network.nodes[contact.node].bar == bar) {
                    (contact.kind == ContactKind::stopLeft ? other : one).push_back(j);
                }
                if (isGap && network.nodes[contact.node + 1].bar == bar) {
                    other.push_back(j);
                }
            }
            if (force == 0.0 && one.empty() != other.empty()) {
                for (const std::size_t j : one.empty() ? other : one) {
                    isIdle[j] = goesOn = true;
                }
            }
        }
    }
    for (std::size_t j = 0; j < isIdle.size(); ++j) {
        if (contains(touched, j) && !isIdle[j]) {
            return false;
        }
    }
    return true;
}

}  // namespace signorini
