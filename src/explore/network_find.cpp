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

void requireKnown(const Network& network, const std::vector<ContactSpan>& schedule)
{
    validate(network);
    if (std::any_of(network.nodes.begin(), network.nodes.end(),
                    [](const NetworkNode& node) { return node.force != 0.0; })) {
        throw std::invalid_argument(
            "constant force: allowed without: no method is known for least energies about a shape "
            "that stands on a contact");
    }
    if (std::any_of(network.bars.begin(), network.bars.end(),
                    [](const NetworkBar& bar) { return bar.drifts(); })) {
        throw std::invalid_argument(
            "a bar that drifts: allowed bars with a clamp or a spring: no method is known for "
            "proofs about the others");
    }
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
    bool isAtRest = true;
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

/// Displacements of all nodes.
std::vector<double> placesOf(const Network& network, const std::vector<double>& waves)
{
    std::vector<double> places;
    for (std::size_t node = 0; node < network.nodes.size(); ++node) {
        const DisplacementForm form = displacementOf(network, node);
        double sum =
            form.spring ? -waves[network.firstWave(network.rows.size()) + *form.spring] : 0.0;
        for (const auto& stretch : form.rows) {
            const auto cells = static_cast<std::size_t>(network.rows[stretch.row].cells);
            const std::size_t first = network.firstWave(stretch.row);
            for (std::size_t k = first; k < first + cells; ++k) {
                sum += stretch.sign * (waves[k + cells] - waves[k]);
            }
        }
        places.push_back(sum);
    }
    return places;
}

}  // namespace

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
    LeastNorm least;
    if (answer.kernelDimension == 0) {
        // Without waves distances are gaps, and one that closes is not 0.
        least.end = LeastNormEnd::empty;
        least.multipliers = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(numbers.size()));
        Eigen::Index equal = 0;
        for (const ForcedRow& row : waves.rows()) {
            least.multipliers[equal] += row.isEquality ? row.limit : 0.0;
            equal += row.isEquality ? 1 : 0;
        }
    } else {
        least = leastNorm(systemOf(waves), broken, std::sqrt(largest), cancel);
    }
    if (least.end == LeastNormEnd::stopped) {
        answer.detail = isRequested(cancel)
                            ? "cancelled"
                            : "rounding does not tell which conditions are in force";
        return answer;
    }
    std::vector<double> multipliers = inOrder(waves, least.multipliers);
    answer.multipliers = waves.floor(numbers, multipliers);
    answer.provedEnergy = provedEnergy(answer.multipliers, network, schedule);
    if (least.end == LeastNormEnd::empty) {
        answer.status = answer.provedEnergy >= largest ? Status::none : Status::undecided;
        answer.detail = answer.status == Status::none
                            ? ""
                            : "conditions exclude each other by no more than rounding can do";
        return answer;
    }
    const std::vector<double> z(least.z.begin(), least.z.end());
    NetworkClaim claim{.waves = waves.waves({}, z)};
    claim.displacements = placesOf(network, claim.waves);
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
    answer.energy = least.z.squaredNorm();
    answer.motion = std::move(claim);
    return answer;
}

}  // namespace signorini
