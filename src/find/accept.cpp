#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "bar_check.hpp"
#include "energy_bound.hpp"
#include "energy_section.hpp"
#include "network_route.hpp"
#include "routes.hpp"
#include "stepped_bar.hpp"
#include "stops.hpp"
#include "tolerated.hpp"

namespace signorini {

namespace {

/// Its stops, but for one that small motions do not reach where each may be as small.
Schedule withStopsInReach(Schedule schedule)
{
    if (canRest(schedule.phases, schedule.stops)) {
        schedule.stops.left.reset();
    }
    return schedule;
}

bool holds(const FarkasCertificate& proof, const Schedule& schedule, const Scene&)
{
    return isProof(proof, withStopsInReach(schedule));
}

bool holds(const ProgramProof& proof, const Schedule& schedule, const Scene&)
{
    return isUnmet(proof.multipliers,
                   proof.demands.areLimits() ? schedule : withStopsInReach(schedule), proof.demands,
                   proof.rows, proof.tolerance);
}

bool holds(const EnergyExclusion& proof, const Schedule& schedule, const Scene&)
{
    const double wanted = proof.energyRatio;
    return std::isfinite(wanted) && proof.tolerance >= 0.0 &&
           isOutOfRange(wanted, proof.range, proof.tolerance) &&
           (wanted < proof.range.least
                ? exceedEnergy(schedule, wanted * (1.0 + proof.tolerance))
                : stayBelowEnergy(schedule, wanted * (1.0 - proof.tolerance),
                                  proof.strainLimit * (1.0 + proof.tolerance)));
}

/// The motions of the energy to hold; one beyond an end, within the tolerance, is met by the end.
HeldEnergy heldEnergyOf(const Request& request)
{
    if (request.isOfAnySize()) {
        return {request.known.set.dimension - 1, true, 1};
    }
    const EnergyRange& range = *request.known.set.energy;
    const auto section = sectionOfOnePhase(
        request.schedule, std::clamp(*request.demands.energyRatio, range.least, range.most));
    const SectionFacts& facts = section->facts();
    return {facts.dimension, facts.isConnected.value(), facts.components};
}

/// Enters an answer into the result.
class Entry {
public:
    Entry(const Request& request, PeriodicResult& result) : request_(request), result_(result) {}

    void operator()(std::string& why) const
    {
        result_.status = Status::undecided;
        result_.detail = std::move(why);
    }

    void operator()(State& state) const
    {
        const double tolerance = request_.options.tolerance;
        const Scene& scene = request_.options.scene;
        const Demands& demands = request_.demands;
        Verification seen;
        Extremes extremes;
        if (isNetwork_) {
            auto all = verifyBar(state, request_.schedule, scene.segments, tolerance);
            seen = std::move(all.seen);
            extremes = all.extremes;
        } else {
            seen = verify(state, request_.schedule, tolerance);
        }
        const double energy = energyRatio(state, scene.segments);
        seen.residuals.demands = isNetwork_ ? violation(demands, state, extremes, energy)
                                            : violation(demands, state, request_.schedule);
        if (!(seen.residuals.worst() <= tolerance)) {
            result_.detail = fmt::format(
                "{} returned a motion with a residual of {:.3g}, more than the tolerance {:.3g}",
                result_.how.route, seen.residuals.worst(), tolerance);
            return;
        }
        const Bar bar = unitsOfBar(scene);
        const Scales unit = scales(bar);
        if (!isNetwork_) {
            extremes = extremesOf(state, request_.schedule, seen.repetitions);
        }
        result_.status = Status::found;
        if (request_.demands.energyRatio && request_.known.onePhase) {
            result_.set.held = heldEnergyOf(request_);
        }
        result_.motion =
            FoundMotion{.state = std::move(state),
                        .contact = seen.canonical.empty() ? Contact::grazing : Contact::pressing,
                        .canonical = std::move(seen.canonical),
                        .repetitions = seen.repetitions,
                        .pressing = std::move(seen.pressing),
                        .isSymmetric = seen.isSymmetric,
                        .energy = energy * unit.energy,
                        .energyRatio = energy,
                        .physical = physicalOf(extremes, bar),
                        .residuals = seen.residuals};
    }

    void operator()(Absence& absence) const
    {
        const bool isVerified = std::visit(
            [this](const auto& proof) {
                return holds(proof, request_.schedule, request_.options.scene);
            },
            absence.proof);
        auto* energies = std::get_if<EnergyExclusion>(&absence.proof);
        if (energies != nullptr) {
            energies->isVerified = isVerified;
        }
        if (!isVerified && (energies == nullptr || std::isfinite(energies->strainLimit))) {
            result_.detail = std::holds_alternative<FarkasCertificate>(absence.proof)
                                 ? "the certificate of absence does not hold in 64-bit integers"
                                 : "the proof of absence does not hold";
            return;
        }
        result_.status = Status::none;
        result_.absence = std::move(absence);
    }

private:
    const Request& request_;
    PeriodicResult& result_;
    bool isNetwork_ = asksOfJoints(request_.options);
};

}  // namespace

PeriodicResult accept(const Request& request, Claim claim)
{
    PeriodicResult result;
    result.detail.clear();
    result.schedule = request.schedule;
    result.scene = request.options.scene;
    result.period = period(request.schedule) * scales(firstMaterial(result.scene)).time;
    result.frequencyRatio = frequencyRatio(request.schedule);
    result.set = request.known.set;
    result.how = std::move(claim.how);
    std::visit(Entry(request, result), claim.answer);
    return result;
}

bool isProof(const PeriodicResult& result)
{
    if (result.status != Status::none || !result.absence) {
        return false;
    }
    try {
        return std::visit(
            [&](const auto& proof) { return holds(proof, result.schedule, result.scene); },
            result.absence->proof);
    } catch (const std::invalid_argument&) {
        return false;  // no rows can be made of what it says
    }
}

}  // namespace signorini
