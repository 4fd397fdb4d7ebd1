#include "stepped_route.hpp"
#include "signorini/motion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "backend_choice.hpp"
#include "energy_floor.hpp"
#include "faults.hpp"
#include "infeasibility.hpp"
#include "one_material.hpp"
#include "request.hpp"
#include "stepped_check.hpp"
#include "stepped_existence.hpp"
#include "stepped_motions.hpp"
#include "stepped_proof.hpp"
#include "stops.hpp"

namespace signorini {

namespace {

/// What is known for such bars, and nothing else.
void requireKnown(const Schedule& schedule, const FindOptions& options)
{
    Faults faults;
    const char* where = " for a bar of several segments";
    const auto refuse = [&](const char* field, auto value, const std::string& allowed) {
        faults.add(field, value, allowed + where);
    };
    if (options.solver == closedForm) {
        refuse("solver", options.solver, "auto or a back end for programs");
    }
    const Formulation form = options.formulation;
    if (form != Formulation::automatic && form != Formulation::joints &&
        form != Formulation::kernel) {
        refuse("formulation", name(form), "auto|joints|kernel");
    }
    const Objective objective = options.objective;
    if (objective != Objective::automatic && objective != Objective::any &&
        objective != Objective::minEnergy && objective != Objective::maxImpulse) {
        refuse("objective", name(objective), "auto|any|min-energy|max-impulse");
    }
    if (options.energyRatio &&
        (objective == Objective::minEnergy || objective == Objective::maxImpulse)) {
        refuse("objective", name(objective), "auto|any when an energy is held,");
    }
    if (std::isfinite(options.strainLimit)) {
        refuse("strainLimit", options.strainLimit, "none");
    }
    if (!options.fixed.empty()) {
        refuse("fixed values", options.fixed.size(), "none");
    }
    const bool isTouchedLeft =
        std::any_of(schedule.phases.begin(), schedule.phases.end(),
                    [](const Phase& phase) { return phase.stop == Stop::left; });
    if (schedule.stops.right == 0 && !isTouchedLeft) {
        refuse("gap", 0.0, "numbers other than 0, or a contact on a second stop,");
    }
    const double floor = options.tipFloor;
    const double highest = placeOf(schedule.stops, schedule.phases.front().stop).value();
    if (!(floor < highest)) {
        faults.add("tipFloor", floor, fmt::format("below {} [g]", highest));
    }
    faults.throwIfAny();
}

/// E/E_1 that multipliers prove, rounded downwards.
double provedRatio(const EnergyFloor& floor, const SteppedBlocks& blocks, const Scene& scene,
                   double tipFloor)
{
    const double energy =
        provedEnergy(floor, networkOf(blocks, scene, tipFloor), spansOf(blocks.schedule));
    constexpr double downwards = 1.0 - 1e-12;
    return 2.0 * energy / static_cast<double>(blocks.bar.cells) * downwards;
}

/// What multipliers prove of the motions with the tip above a floor.
EnergyFloorProof floorProof(const std::vector<SteppedMultiplier>& multipliers,
                            const SteppedBlocks& blocks, const FindOptions& options,
                            double tolerance)
{
    EnergyFloorProof proof{{}, 0.0, options.tipFloor, tolerance, {}};
    const double floor = options.tipFloor - tolerance;
    proof.multipliers =
        floorOf(multipliers, blocks, networkOf(blocks, options.scene, floor), options.cancel);
    proof.energyRatio = provedRatio(proof.multipliers, blocks, options.scene, floor);
    return proof;
}

/// Those that matter.
std::vector<SteppedCondition> conditionsOf(const std::vector<SteppedMultiplier>& multipliers)
{
    constexpr double negligible = 1e-9;  // of the largest
    double size = 0.0;
    for (const SteppedMultiplier& m : multipliers) {
        size = std::max(size, std::abs(m.value));
    }
    std::vector<SteppedCondition> conditions;
    for (const SteppedMultiplier& m : multipliers) {
        if (m.of.rule != SteppedRule::gap && std::abs(m.value) > negligible * size) {
            conditions.push_back(m.of);
        }
    }
    return conditions;
}

/// Does what is proved exclude what was asked for?
bool isExcluded(const EnergyFloorProof& proof)
{
    return proof.held ? proof.energyRatio > *proof.held * (1.0 + proof.tolerance)
                      : proof.energyRatio >= hugeEnergyRatio;
}

/// One request, on its way to an answer.
class SteppedSearch {
public:
    SteppedSearch(const Schedule& schedule, const FindOptions& options)
        : options_(options),
          bar_(steppedBar(options.scene.segments)),
          blocks_(blocksOf(bar_, schedule, options.tipFloor, true))
    {
        result_.schedule = schedule;
        result_.scene = options.scene;
        result_.detail.clear();
        result_.period = period(schedule) * scales(firstMaterial(options.scene)).time;
        result_.frequencyRatio = frequencyRatio(schedule);
        result_.how.reason =
            fmt::format("{} segments: no closed form", options.scene.segments.size());
        if (blocks_.unit > 1) {
            result_.how.leftOut.push_back(
                fmt::format("all but {} of the {} steps: residues mod {} obey equations of their "
                            "own, alike in blocks",
                            blocks_.turns * static_cast<std::int64_t>(blocks_.types.size()),
                            blocks_.turns * blocks_.unit, blocks_.unit));
        }
        result_.how.leftOut.emplace_back("closure of the last flight: periodicity implies it");
    }

    PeriodicResult answer()
    {
        const Stopwatch watch;
        decide();
        result_.how.solver.seconds = watch.seconds();
        return std::move(result_);
    }

private:
    [[nodiscard]] SolverOptions settings() const
    {
        return {.tolerance = std::min(options_.tolerance, 1e-9),
                .iterationLimit = options_.iterationLimit,
                .timeLimit = options_.timeLimit};
    }

    /// In kernel coordinates where they can be had, twice where rounding hides how many there are.
    void decide()
    {
        if (options_.formulation != Formulation::joints) {
            for (const double zero : {noPivot, clearPivot}) {
                const auto kernel = kernelOf(blocks_, zero);
                if (!kernel) {
                    result_.detail = fmt::format(
                        "the kernel of W - 1 is out of reach: more than "
                        "{} waves in a block",
                        mostKernelState);
                    break;
                }
                if (kernel->isClear) {
                    result_.set.kernelDimension = kernel->dimension;
                }
                posed_ = kernelForm(blocks_, *kernel);
                enter(leastMotion(*posed_, options_.cancel), "active-set");
                if (result_.status != Status::undecided || kernel->isClear ||
                    isRequested(options_.cancel)) {
                    break;
                }
            }
        }
        const bool isWorthMore = result_.status == Status::undecided && !knowsMotions_ &&
                                 !isRequested(options_.cancel) &&
                                 options_.formulation != Formulation::kernel;
        if (isWorthMore && (options_.formulation == Formulation::joints ||
                            preferred({.duals = true}) != nullptr)) {
            const auto simplex = makeSolver(choose({.duals = true}));
            isKernel_ = false;
            posed_ = jointsForm(blocks_);
            enter(existence(*posed_, *simplex, settings()), simplex->name());
        }
    }

    void enter(const SteppedExistence& there, std::string_view method)
    {
        result_.how.solver.name = method;
        result_.how.solver.iterations += there.iterations;
        result_.how.route =
            fmt::format("{} on the {} formulation", method, isKernel_ ? "kernel" : "joints");
        if (there.status == Status::found) {
            enterMotion(there);
        } else if (there.status == Status::none) {
            enterAbsence(there);
        } else {
            result_.detail = fmt::format("{}: {}", method, there.detail);
        }
    }

    /// Demands relaxed by the tolerance are what has to be impossible.
    void enterAbsence(const SteppedExistence& there)
    {
        const Reason reason = reasonOf(there.multipliers, blocks_, result_.set.kernelDimension);
        const SteppedBlocks relaxed =
            blocksOf(bar_, result_.schedule, options_.tipFloor - options_.tolerance, true);
        if (auto exact = proofOf(conditionsOf(there.multipliers), relaxed)) {
            enterProof(SteppedProof{std::move(*exact), options_.tipFloor, options_.tolerance},
                       reason);
            result_.set.kind = SetKind::empty;
            return;
        }
        EnergyFloorProof proof =
            floorProof(there.multipliers, blocks_, options_, options_.tolerance);
        if (!(proof.energyRatio >= hugeEnergyRatio)) {
            result_.detail = fmt::format(
                "{} finds no motion, but its multipliers only prove that none has less than "
                "{:.3g} E_1",
                result_.how.route, proof.energyRatio);
            return;
        }
        enterProof(std::move(proof), reason);
        result_.set.kind = SetKind::empty;
    }

    template <typename Proof>
    void enterProof(Proof proof, Reason reason)
    {
        result_.status = Status::none;
        result_.detail.clear();
        result_.absence = Absence{reason, std::move(proof)};
    }

    /// Where the energy to hold is less than all.
    bool enterExclusion(const SteppedExistence& least)
    {
        EnergyFloorProof proof =
            floorProof(least.multipliers, blocks_, options_, options_.tolerance);
        proof.held = options_.energyRatio;
        if (!isExcluded(proof)) {
            return false;
        }
        enterProof(std::move(proof), Reason::constraints);
        return true;
    }

    void enterMotion(const SteppedExistence& there)
    {
        knowsMotions_ = true;
        Objective objective = objectiveOf(options_);
        if (isKernel_ && options_.solver == automaticChoice &&
            options_.objective == Objective::automatic && !options_.energyRatio) {
            objective = Objective::minEnergy;
        }
        SteppedPoint point;
        SteppedBlocks single;
        const SteppedBlocks* used = &blocks_;
        if (options_.energyRatio) {
            if (isKernel_ && enterExclusion(there)) {
                return;
            }
            // Motions of more than the least energy have different waves in a block.
            single = blocksOf(bar_, result_.schedule, options_.tipFloor, false);
            used = &single;
            const auto kernel = isKernel_ ? kernelOf(single) : std::nullopt;
            isKernel_ = kernel.has_value();
            posed_ = kernel ? kernelForm(single, *kernel) : jointsForm(single);
            point = pointOfEnergy(*posed_, options_);
        } else if (objective == Objective::any || (isKernel_ && objective == Objective::minEnergy &&
                                                   options_.solver == automaticChoice)) {
            point.x = there.x;
        } else {
            point = extremePoint(*posed_, objective, options_);
        }
        result_.how.objective = objective;
        if (!point.solver.empty()) {
            result_.how.solver.name = point.solver;
            result_.how.route = fmt::format("{} on the {} formulation", point.solver,
                                            isKernel_ ? "kernel" : "joints");
        }
        result_.how.solver.iterations += point.iterations;
        if (!point.isFound()) {
            result_.detail = std::move(point.detail);
            return;
        }
        enterState(stateOf(*used, sumsOf(*posed_, *used, point.x)));
        if (result_.motion && objective == Objective::minEnergy) {
            result_.set.energy = {result_.motion->energyRatio, std::nan("")};
            if (result_.set.kernelDimension == 1) {
                result_.set.kind = SetKind::point;
                result_.set.dimension = 0;
                result_.set.energy->most = result_.motion->energyRatio;
            }
        }
    }

    void enterState(State state)
    {
        SteppedVerification all =
            verifyStepped(state, result_.schedule, options_.scene.segments, options_.tolerance);
        Verification& seen = all.seen;
        const double energy = energyRatio(state, options_.scene.segments);
        if (std::isfinite(options_.tipFloor)) {
            seen.residuals.demands = std::max(0.0, options_.tipFloor - all.extremes.lowestTip);
        }
        if (options_.energyRatio) {
            seen.residuals.demands =
                std::max(seen.residuals.demands, std::abs(energy / *options_.energyRatio - 1.0));
        }
        if (!(seen.residuals.worst() <= options_.tolerance)) {
            result_.detail = fmt::format(
                "{} returned a motion with a residual of {:.3g}, more than the tolerance {:.3g}",
                result_.how.route, seen.residuals.worst(), options_.tolerance);
            return;
        }
        const Bar bar = unitsOfBar(options_.scene);
        const double unit = scales(bar).energy;
        result_.status = Status::found;
        result_.detail.clear();
        result_.motion =
            FoundMotion{.state = std::move(state),
                        .contact = seen.canonical.empty() ? Contact::grazing : Contact::pressing,
                        .canonical = std::move(seen.canonical),
                        .repetitions = seen.repetitions,
                        .pressing = std::move(seen.pressing),
                        .energy = energy * unit,
                        .energyRatio = energy,
                        .physical = physicalOf(all.extremes, bar),
                        .residuals = seen.residuals};
    }

    const FindOptions& options_;
    SteppedBar bar_;
    SteppedBlocks blocks_;
    std::optional<SteppedProgram> posed_;
    bool isKernel_ = true;
    bool knowsMotions_ = false;
    PeriodicResult result_;
};

}  // namespace

bool isStepped(const FindOptions& options)
{
    return !options.scene.segments.empty() &&
           (!isUniform(options.scene.segments) || options.formulation == Formulation::joints ||
            options.formulation == Formulation::kernel);
}

PeriodicResult findStepped(const Schedule& schedule, const FindOptions& options)
{
    checkOptions(options);
    Schedule placed = schedule;
    placed.stops = stopsOf(options.scene);
    validate(placed);
    requireKnown(placed, options);
    return SteppedSearch(placed, options).answer();
}

std::optional<SteppedEnergyProof> leastSteppedEnergy(const Schedule& schedule,
                                                     const FindOptions& options)
{
    return leastEnergyProof(
        blocksOf(steppedBar(options.scene.segments), schedule, options.tipFloor, true));
}

std::optional<EnergyFloorProof> leastEnergyFloor(const Schedule& schedule,
                                                 const FindOptions& options)
{
    const SteppedBlocks blocks =
        blocksOf(steppedBar(options.scene.segments), schedule, options.tipFloor, true);
    const auto kernel = kernelOf(blocks);
    if (!kernel) {
        return std::nullopt;
    }
    const SteppedExistence least = leastMotion(kernelForm(blocks, *kernel), options.cancel);
    if (least.status != Status::found) {
        return std::nullopt;
    }
    EnergyFloorProof proof = floorProof(least.multipliers, blocks, options, 0.0);
    return proof.energyRatio > 0.0 ? std::optional(std::move(proof)) : std::nullopt;
}

bool holds(const SteppedProof& proof, const Schedule& schedule, const Scene& scene)
{
    const double relaxed = proof.tipFloor - proof.tolerance;
    const SteppedBlocks blocks = blocksOf(steppedBar(scene.segments), schedule, relaxed, true);
    return proof.tolerance >= 0.0 && isProof(proof.multipliers, jointsForm(blocks).program);
}

bool holds(const EnergyFloorProof& proof, const Schedule& schedule, const Scene& scene)
{
    const double relaxed = proof.tipFloor - proof.tolerance;
    const SteppedBlocks blocks = blocksOf(steppedBar(scene.segments), schedule, relaxed, true);
    return proof.tolerance >= 0.0 && isExcluded(proof) &&
           provedRatio(proof.multipliers, blocks, scene, relaxed) >= proof.energyRatio;
}

}  // namespace signorini
