#include "network_walk.hpp"

#include <algorithm>
#include <cmath>

#include "faults.hpp"
#include "infinity.hpp"
#include "largest.hpp"
#include "network_cells.hpp"

namespace signorini {

namespace {

void validate(const Network& network, const NetworkClaim& claim)
{
    validate(network);
    Faults faults;
    std::int64_t steps = 0;
    for (const ContactSpan& part : claim.schedule) {
        faults.requireWhole("steps", part.steps, std::int64_t{1} << 40);
        faults.throwIfAny();
        (void)clustersOf(network, part.closed);
        if (network.contacts.size() < maxContacts && part.closed >> network.contacts.size() != 0) {
            faults.add("closed contacts", part.closed,
                       fmt::format("sets of contacts 1..{}", network.contacts.size()));
        }
        steps += part.steps;
    }
    if (claim.schedule.empty()) {
        faults.add("schedule", 0, "at least one set of contacts and its steps");
    }
    if (claim.waves.size() != network.waves()) {
        faults.add("waves", claim.waves.size(), fmt::format("{}", network.waves()));
    }
    if (claim.displacements.size() != network.nodes.size()) {
        faults.add("displacements", claim.displacements.size(),
                   fmt::format("{}", network.nodes.size()));
    }
    for (const auto* values : {&claim.forces, &claim.velocities}) {
        if (!values->empty() && static_cast<std::int64_t>(values->size()) != steps) {
            faults.add("steps of the excitation", values->size(), fmt::format("{}", steps));
        }
    }
    faults.throwIfAny();
}

bool areFinite(const NetworkClaim& claim)
{
    const auto all = {&claim.waves, &claim.displacements, &claim.forces, &claim.velocities};
    return std::all_of(all.begin(), all.end(), [](const std::vector<double>* values) {
        return std::all_of(values->begin(), values->end(),
                           [](double x) { return std::isfinite(x); });
    });
}

}  // namespace

double NetworkResiduals::worst() const
{
    return std::max({periodicity, tie, gap, pressure, penetration, balance});
}

bool NetworkResiduals::presses() const
{
    return std::any_of(impulses.begin(), impulses.end(), [](double one) { return one > 1e-9; });
}

double strainExcess(const Network& network, const NetworkClaim& claim, const NetworkExtremes& seen)
{
    if (network.strainLimit == infinity) {
        return 0.0;
    }
    double slowest = infinity;
    for (const CellRow& row : network.rows) {
        slowest = std::min(slowest, row.speed);
    }
    const double beyond = -seen.leastStrain - network.strainLimit;
    return std::max(0.0,
                    beyond / std::max(network.strainLimit, largestSizeOf(claim.waves) / slowest));
}

NetworkResiduals walk(const Network& network, const NetworkClaim& claim, double tolerance)
{
    validate(network, claim);
    if (!areFinite(claim)) {
        return {infinity, infinity, infinity, infinity, infinity, infinity, {}, {}, {}, {}};
    }
    NetworkCells cells(network, claim, tolerance);
    NetworkResiduals seen;
    seen.tie = cells.untied();
    std::size_t step = 0;
    ContactSet before = claim.schedule.back().closed;
    for (const ContactSpan& part : claim.schedule) {
        for (std::size_t j = 0; j < network.contacts.size(); ++j) {
            if (contains(part.closed, j) && !contains(before, j)) {
                seen.gap = std::max(seen.gap, std::abs(cells.distance(j)) / cells.length());
            }
        }
        before = part.closed;
        seen.pressed.push_back(0);
        for (std::int64_t k = 0; k < part.steps; ++k) {
            cells.look(step++);
            cells.find(part.closed);
            seen.pressed.back() |= cells.take(part.closed);
        }
    }
    seen.periodicity = std::max(cells.change(), cells.moved());
    seen.pressure = cells.deepestPull();
    seen.penetration = cells.deepestOverlap();
    seen.balance = cells.unbalanced();
    seen.extremes = cells.extremes();
    for (const ContactExtremes& contact : seen.extremes.contacts) {
        seen.impulses.push_back(contact.impulse);
        seen.peakForces.push_back(contact.peakForce);
    }
    return seen;
}

NetworkMarch march(const Network& network, const NetworkClaim& claim, double tolerance)
{
    validate(network, claim);
    NetworkMarch seen;
    if (!areFinite(claim)) {
        seen.residual = infinity;
        return seen;
    }
    NetworkCells cells(network, claim, tolerance);
    const std::int64_t steps = claim.steps();
    for (std::int64_t m = 0; m < steps; ++m) {
        cells.look(static_cast<std::size_t>(m));
        const ContactSet closed = cells.decide();
        if (const double deep = cells.overlap(closed) / cells.length(); deep > tolerance) {
            seen.firstFault = m;
            seen.residual = deep;
            seen.pressed.clear();
            break;
        }
        const ContactSet pressed = cells.take(closed);
        if (seen.pressed.empty() || seen.pressed.back().closed != pressed) {
            seen.pressed.push_back({pressed, 0});
        }
        ++seen.pressed.back().steps;
        if (steps % (m + 1) == 0 && (seen.repeats == 0 || m + 1 == steps)) {
            seen.residual = m + 1 == steps ? cells.change() : cells.change(tolerance);
            seen.repeats = seen.repeats == 0 && seen.residual <= tolerance ? m + 1 : seen.repeats;
        }
    }
    seen.extremes = cells.extremes();
    return seen;
}

}  // namespace signorini
