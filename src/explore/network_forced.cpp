#include "network_forced.hpp"

#include <algorithm>
#include <numeric>

#include "faults.hpp"
#include "forced_case.hpp"
#include "forced_cut.hpp"
#include "infinity.hpp"
#include "largest.hpp"
#include "network_find.hpp"
#include "network_sweep.hpp"
#include "signorini/find_periodic.hpp"
#include "stops.hpp"

namespace signorini {

namespace {

constexpr double noEnd = 1e9;  // times what meets the first row

SteppedBar checkedBar(const ForcedSet& set)
{
    const std::vector<Segment> one{{.cells = set.schedule.cells}};
    SteppedBar bar = steppedBar(set.segments.empty() ? one : set.segments);
    requireCells(bar, set.schedule.cells);
    Faults faults;
    const char* where = set.segments.empty() ? " for a limit on strain beside a moving base"
                                             : " for a bar of several segments";
    if (!set.forcing.shape.empty()) {
        faults.add("shape", set.forcing.shape.size(), std::string("a harmonic") + where);
    }
    if (steps(set.schedule) > maxNetworkSteps) {
        faults.add("steps", steps(set.schedule),
                   fmt::format("at most {}{}", maxNetworkSteps, where));
    }
    faults.throwIfAny();
    return bar;
}

Network networkOf(const ForcedSet& set)
{
    Network network = networkOf(set.schedule.stops, set.segments, set.schedule.cells, set.damping);
    network.strainLimit = set.limits.strain;
    return network;
}

/// Of a period. \throws as the constructor says.
std::int64_t checkedSteps(const Network& network, const std::vector<ContactSpan>& spans,
                          const Forcing& forcing)
{
    requireKnown(network, spans);
    Faults faults;
    const std::int64_t steps = stepsOf(spans);
    if (const std::int64_t most = (steps - 1) / 2; forcing.cycles < 1 || forcing.cycles > most) {
        faults.add("cycles", forcing.cycles,
                   fmt::format("whole numbers 1..{}, below half of the steps", most));
    }
    requireExcitable(faults, network, forcing.place);
    for (const NetworkBar& bar : network.bars) {
        bool isShaken = false;
        for (std::size_t node = bar.firstNode; node <= bar.lastNode; ++node) {
            isShaken = isShaken || network.nodes[node].isShaken;
        }
        if (forcing.place == Excited::base && isShaken && bar.clamps + bar.springs > 1) {
            faults.add("force", "base", "a shaken bar that is held nowhere else");
        }
    }
    faults.throwIfAny();
    return steps;
}

std::vector<StepDrive> drivesOf(std::span<const Excitation> shapes)
{
    std::vector<StepDrive> drives;
    for (const Excitation& shape : shapes) {
        drives.push_back(driveOf(shape));
    }
    return drives;
}

}  // namespace

NetworkClaim claimOf(std::span<const ContactSpan> schedule, const ForcedMotion& motion)
{
    NetworkClaim claim;
    claim.waves.assign(motion.state.a.begin(), motion.state.a.end());
    claim.displacements.assign(motion.state.b.begin(), motion.state.b.end());
    claim.schedule.assign(schedule.begin(), schedule.end());
    StepDrive drive = driveOf(motion.excitation);
    claim.forces = std::move(drive.forces);
    claim.velocities = std::move(drive.velocities);
    return claim;
}

void enterWalk(ForcedMotion& motion, const Network& network, std::span<const ContactSpan> schedule,
               const NetworkStart& state)
{
    const auto vectorOf = [](const std::vector<double>& values) {
        return Eigen::Map<const Eigen::VectorXd>(values.data(),
                                                 static_cast<Eigen::Index>(values.size()));
    };
    motion.state.a = vectorOf(state.waves);
    motion.state.b = vectorOf(state.displacements);
    const NetworkClaim claim = claimOf(schedule, motion);
    const NetworkResiduals residuals = walk(network, claim);
    motion.residual = std::max(residuals.worst(), strainExcess(network, claim, residuals.extremes));
    motion.extremes.impulse =
        std::accumulate(residuals.impulses.begin(), residuals.impulses.end(), 0.0);
    for (const ContactExtremes& contact : residuals.extremes.contacts) {
        motion.extremes.approachSpeed = std::max(motion.extremes.approachSpeed, contact.approach);
    }
}

NetworkForced::NetworkForced(const ForcedSet& set)
    : schedule_(set.schedule),
      damping_(set.damping),
      bar_(checkedBar(set)),
      shapes_(shapesOf(set.forcing, bar_->cells, steps(schedule_))),
      waves_(networkOf(set), spansOf(schedule_), drivesOf(shapes_)),
      canRest_(canRest(set)),
      mostEnergy_(hugeEnergyRatio * 0.5 * static_cast<double>(bar_->cells))
{
    limitStrain();
}

NetworkForced::NetworkForced(Network network, std::vector<ContactSpan> spans,
                             const Forcing& forcing, double usualEnergy)
    : shapes_(shapesOf(forcing, 1, checkedSteps(network, spans, forcing))),
      waves_(std::move(network), std::move(spans), drivesOf(shapes_)),
      canRest_(false),
      mostEnergy_(hugeEnergyRatio * usualEnergy)
{
    limitStrain();
}

void NetworkForced::limitStrain()
{
    if (waves_.network().strainLimit == infinity || !waves_.isClear()) {
        return;
    }
    constexpr std::size_t mostRows = 500;  // that were added
    const std::size_t first = waves_.rows().size();
    for (bool isBroken = true; isBroken;) {
        isBroken = false;
        if (waves_.rows().size() > first + mostRows) {
            isLimited_ = false;
            return;
        }
        if (waves_.freeWaves() > 0) {
            const std::size_t before = waves_.rows().size();
            for (const ForcedCorner& corner :
                 forcedPolytope(waves_.rows(), {true, waves_.freeWaves()}).corners) {
                isBroken |= waves_.limitStrain({corner.place[0], corner.place[1]}, corner.free);
                if (waves_.rows().size() > before + mostRows / 10) {
                    break;  // the other corners are no longer there
                }
            }
            continue;
        }
        const ForcedLine line = this->line();
        if (line.hasLine && !line.isEmpty()) {
            const double far = noEnd * (1.0 + size(line.foot));
            for (const double end : {std::max(line.low, -far), std::min(line.high, far)}) {
                isBroken |= waves_.limitStrain(line.at(end), {});
            }
        }
    }
}

MotionAt NetworkForced::motionAt() const
{
    return [this](Plane place, std::span<const double> free) {
        const std::vector<double> all = waves_.waves(place, free);
        ForcedMotion motion = drivenMotion(schedule_, damping_, shapes_, place);
        if (!bar_) {
            enterWalk(motion, waves_.network(), schedule(),
                      {all, waves_.displacements(place, all)});
            return motion;
        }
        enterState(motion, bar_->segments, stateOf(waves_.network(), all));
        const double excess = motion.extremes.peakCompression / waves_.network().strainLimit - 1.0;
        motion.residual = std::max(motion.residual, excess);
        return motion;
    };
}

ForcedCondition NetworkForced::named(std::size_t row) const
{
    const ForcedRule rule = waves_.rows()[row].condition.rule;
    const bool isAfter =
        waves_.kindOf(row) == BlockCondition::Kind::place && rule != ForcedRule::gap;
    const std::int64_t n = shapes_.front().steps();
    const std::int64_t step = waves_.stepOf(row);
    return {rule, isAfter ? (step + n - 1) % n : step};
}

std::vector<ForcedCondition> NetworkForced::named(std::span<const std::size_t> rows) const
{
    std::vector<ForcedCondition> all;
    for (const std::size_t row : rows) {
        if (waves_.rows()[row].condition.rule != ForcedRule::gap) {
            all.push_back(named(row));
        }
    }
    return all;
}

/// Where every wave is damped. Conditions carry the numbers of rows.
ForcedLine NetworkForced::line() const
{
    const std::vector<ForcedRow>& rows = waves_.rows();
    const double scale = largestOf(rows, [](const ForcedRow& row) { return size(row.plane); });
    ForcedCut cut(rows.front().plane, rows.front().limit, scale, true, canRest_);
    if (cut.isEmpty()) {
        return cut.result();
    }
    const Plane direction = cut.result().direction;
    for (const ForcedRow& row : rows) {
        // Flights that close by themselves leave a row along the line.
        if (cut.holdsAll(row.plane, row.limit)) {
            continue;
        }
        const double along = cut.isParallel(row.plane) ? row.plane.dot(direction) : 0.0;
        const Plane plane = row.plane - along * direction;
        row.isEquality ? cut.to(plane, row.condition, row.limit)
                       : cut.by(plane, row.condition, row.limit);
    }
    return cut.result();
}

void NetworkForced::explainAbsence(ForcedSet& set, const std::vector<std::size_t>& conflict,
                                   std::span<const double> start) const
{
    set.detail = "conditions exclude each other by no more than rounding can do";
    std::vector<EnergyFloor> cuts;
    if (canRest_) {
        cuts = floorsOf(conflict);
    } else if (const auto multipliers = waves_.contradiction(conflict, start);
               !multipliers.empty()) {
        cuts.push_back(waves_.floor(conflict, multipliers));
    }
    if (isCertain(cuts)) {
        enterProof(set, conflict, std::move(cuts));
    }
}

void NetworkForced::decide(ForcedSet& set) const
{
    if (!waves_.isClear()) {
        set.detail =
            waves_.isWithinReach()
                ? "hardly anything damps some waves: 1 - W is singular but for rounding"
                : fmt::format("out of reach: more than {} waves in a block", mostDrivenState);
        return;
    }
    set.freeWaves = waves_.freeWaves();
    if (!isLimited_) {
        set.detail = "out of reach: too many pairs of waves break the limit on strain";
        return;
    }
    if (set.freeWaves > 0) {
        decidePolytope(set);
        return;
    }
    const ForcedLine line = this->line();
    if (!line.hasLine) {
        explainAbsence(set, {0});
        if (set.status != Status::none) {
            set.detail = "the excitation leaves u(L, 0) at 0, but for rounding";
        }
        return;
    }
    if (line.isEmpty()) {
        std::vector<std::size_t> conflict{0};
        const bool crosses = line.low > line.high;
        for (const auto& row : {line.blocking, line.lowRow, line.highRow}) {
            if (row && (line.blocking && !crosses ? row == line.blocking : row != line.blocking)) {
                conflict.push_back(static_cast<std::size_t>(row->step));
            }
        }
        explainAbsence(set, conflict);
        if (set.status == Status::none || !describeTouch(set, line)) {
            return;
        }
    } else {
        describeLine(set, line);
    }
    believe(set, motionAt());
}

void NetworkForced::enterProof(ForcedSet& set, std::span<const std::size_t> conflict,
                               std::vector<EnergyFloor> cuts) const
{
    set.detail.clear();
    set.status = Status::none;
    set.conflict = named(conflict);
    set.reason = reasonOf(set.conflict);
    set.cuts = std::move(cuts);
}

void NetworkForced::decidePolytope(ForcedSet& set) const
{
    ForcedPolytope polytope = forcedPolytope(waves_.rows(), {true, waves_.freeWaves()});
    set.detail = polytope.detail;
    if (polytope.conflict) {
        std::vector<std::size_t> conflict{0};
        for (const ForcedCondition& row : *polytope.conflict) {
            conflict.push_back(static_cast<std::size_t>(row.step));
        }
        explainAbsence(set, conflict, polytope.multipliers);
    }
    if (polytope.corners.empty()) {
        return;
    }
    describePolytope(set, std::move(polytope));
    if (canRest_ && set.mostAmplitude <= leastOfCone) {
        set.kind = ForcedKind::empty;
        set.corners.clear();
        explainRest(set);
        return;
    }
    believe(set, motionAt());
}

ForcedSet forcedScene(const Network& network, const std::vector<ContactSpan>& schedule,
                      const Forcing& forcing, double usualEnergy)
{
    ForcedSet set;
    set.forcing = forcing;
    set.waves = std::make_shared<const NetworkForced>(network, schedule, forcing, usualEnergy);
    set.waves->decide(set);
    return set;
}

NetworkClaim claimOf(const ForcedSet& set, const ForcedMotion& motion)
{
    return claimOf(set.waves->schedule(), motion);
}

}  // namespace signorini
