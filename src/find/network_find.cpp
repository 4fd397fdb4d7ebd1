#include "network_find.hpp"

#include <algorithm>
#include <cmath>

#include "backend_choice.hpp"
#include "faults.hpp"
#include "network_points.hpp"

namespace signorini {

std::optional<double> firstEnergy(const Network& network)
{
    const SceneReference reference = referenceOf(network);
    return reference.energy && *reference.energy > 0.0
               ? std::optional(*reference.energy / network.scales.energy())
               : std::nullopt;
}

std::optional<double> heldEnergy(const Network& network, const std::optional<double>& joules,
                                 const std::optional<double>& energyRatio)
{
    if (joules) {
        return *joules / network.scales.energy();
    }
    if (!energyRatio) {
        return std::nullopt;
    }
    const auto unit = firstEnergy(network);
    if (!unit) {
        throwFault("energyRatio", *energyRatio,
                   "none where no energy E₁ is needed to reach contact 1: joules in its place");
    }
    return *energyRatio * *unit;
}

double usualEnergy(const Network& network, const std::vector<ContactSpan>& schedule)
{
    double force = 0.0;
    for (const NetworkNode& node : network.nodes) {
        force += std::abs(node.force);
    }
    const auto cells = static_cast<double>(network.cells());
    const double impulse = force * static_cast<double>(stepsOf(schedule));
    return firstEnergy(network).value_or(std::max(cells, impulse * impulse / cells));
}

namespace {

/// Is there something that rest has to give way to, or may lean on anywhere?
bool isMoved(const Network& network)
{
    return !driftingBars(network).empty() || !(withoutForces(network) == network);
}

}  // namespace

void requireKnown(const Network& network, const std::vector<ContactSpan>& schedule)
{
    validate(network);
    constexpr std::size_t mostWaves = 2'000'000;
    Faults faults;
    if (network.waves() > mostWaves) {
        faults.add("waves", network.waves(), fmt::format("at most {}", mostWaves));
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
        faults.add("schedule", textOf(schedule),
                   "those whose first set has a contact that the last one leaves open");
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

LeastMotion leastMotion(const Network& network, const std::vector<ContactSpan>& schedule,
                        double largest, const Cancel& cancel)
{
    requireKnown(network, schedule);
    const NetworkBlocks blocks(network, schedule);
    LeastMotion least =
        leastMotion(blocks, {.absent = largest, .tolerance = networkTolerance, .cancel = cancel});
    if (least.status == Status::found) {
        prove(least, blocks, network, cancel);
    }
    return least;
}

namespace {

/// Enters that no motion is compressed by hardly less.
void proveStrain(LeastMotion& motion, Network network, const std::vector<ContactSpan>& schedule,
                 double largest, const Cancel& cancel)
{
    constexpr double near = 1e-6;
    network.strainLimit = -motion.residuals.extremes.leastStrain * (1.0 - near);
    if (network.strainLimit > 0.0 &&
        leastMotion(network, schedule, largest, cancel).status == Status::none) {
        motion.provedStrain = network.strainLimit;
    }
}

/// Of a schedule whose least motion is known: the one of a wish in its place.
void enterWish(LeastMotion& least, const NetworkBlocks& blocks, double largest,
               const NetworkWish& wish, const FindOptions& options)
{
    if (wish.isOfLeast() && options.solver == automaticChoice) {
        return;
    }
    const Network& network = blocks.network();
    const std::vector<double> leastWaves = std::move(least.motion->waves);
    least.motion.reset();
    if (wish.energy && least.provedEnergy > *wish.energy) {
        least.status = Status::none;
        return;
    }
    least.status = Status::undecided;
    // But for that of least energy, motions have different waves in a block.
    const NetworkBlocks single(network, blocks.schedule(), wish.isOfLeast());
    if (wish.target) {
        LeastMotion near = leastMotion(single, {.absent = largest,
                                                .tolerance = networkTolerance,
                                                .target = wish.target,
                                                .cancel = options.cancel});
        near.multipliers = std::move(least.multipliers);
        near.provedEnergy = least.provedEnergy;
        near.kind = least.kind;
        near.dimension = least.dimension;
        least.how.solver.iterations += near.how.solver.iterations;
        near.how = std::move(least.how);
        least = std::move(near);
        return;
    }
    NetworkPoints points(single, options);
    const NetworkPoint point = wish.energy ? points.ofEnergy(*wish.energy, leastWaves)
                               : wish.objective == Objective::maxEnergy
                                   ? points.ofMostEnergy(largest)
                               : wish.isOfLeast() ? points.extreme(Objective::minEnergy)
                                                  : points.extreme(wish.objective);
    least.detail = point.detail;
    least.how.solver.iterations += point.iterations;
    if (!point.solver.empty()) {
        enterSolver(least.how, point.solver);
    }
    if (point.detail.empty() &&
        enterMotion(least, single, points.motion(point), options.tolerance) &&
        wish.objective == Objective::minPeakStrain) {
        proveStrain(least, network, blocks.schedule(), largest, options.cancel);
    }
}

}  // namespace

LeastMotion wishedMotion(const Network& network, const std::vector<ContactSpan>& schedule,
                         double largest, const NetworkWish& wish, const FindOptions& options)
{
    if (wish.energy && wish.objective != Objective::automatic && wish.objective != Objective::any) {
        throwFault("objective", name(wish.objective), "auto|any when an energy is held");
    }
    requireBackend(options.solver);
    if (options.solver == closedForm) {
        throwFault("solver", options.solver, "auto or a back end for programs");
    }
    requireKnown(network, schedule);
    const Stopwatch watch;
    const NetworkBlocks blocks(network, schedule);
    LeastMotion least = leastMotion(blocks, {.absent = largest,
                                             .tolerance = networkTolerance,
                                             .asksSet = true,
                                             .cancel = options.cancel});
    const std::int64_t iterations = least.how.solver.iterations;
    least.how = howOf(blocks, "bars in a row: no closed form");
    least.how.solver.iterations = iterations;
    if (least.status == Status::found) {
        prove(least, blocks, network, options.cancel);
        enterWish(least, blocks, largest, wish, options);
    }
    least.how.solver.seconds = watch.seconds();
    return least;
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
                if (!contains(touched, j) || isIdle[j]) {
                    continue;
                }
                forEachSide(network.contacts[j], [&](std::size_t node, int sign) {
                    if (network.nodes[node].bar == bar) {
                        (sign > 0 ? other : one).push_back(j);
                    }
                });
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
