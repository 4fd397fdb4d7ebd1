#include "stepped_route.hpp"
#include "signorini/motion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "backend_choice.hpp"
#include "faults.hpp"
#include "infeasibility.hpp"
#include "request.hpp"
#include "stepped_check.hpp"
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

/// One request, on its way to an answer.
class SteppedSearch {
public:
    SteppedSearch(const Schedule& schedule, const FindOptions& options)
        : options_(options),
          bar_(steppedBar(options.scene.segments)),
          blocks_(blocksOf(bar_, schedule, options.tipFloor, true)),
          simplex_(makeSolver(choose({.duals = true})))
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
        const SteppedExistence there = decide();
        result_.how.solver.iterations = there.iterations;
        if (there.status == Status::found) {
            enterMotion(there);
        } else if (there.status == Status::none) {
            enterAbsence(there);
        } else {
            result_.detail = fmt::format("{}: {}", simplex_->name(), there.detail);
        }
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

    /// The program of a request: in kernel coordinates where they can be had.
    [[nodiscard]] std::optional<SteppedProgram> pose(const SteppedBlocks& blocks)
    {
        isKernel_ = false;
        if (options_.formulation != Formulation::joints) {
            if (auto kernel = kernelOf(blocks)) {
                isKernel_ = true;
                result_.set.kernelDimension = kernel->dimension;
                return kernelForm(blocks, *kernel);
            }
            if (options_.formulation == Formulation::kernel) {
                return std::nullopt;
            }
        }
        return jointsForm(blocks);
    }

    [[nodiscard]] SteppedExistence decide()
    {
        posed_ = pose(blocks_);
        result_.how.solver.name = simplex_->name();
        result_.how.route = fmt::format("{} on the {} formulation", simplex_->name(),
                                        isKernel_ ? "kernel" : "joints");
        if (!posed_) {
            return {.detail = fmt::format("the kernel of W - 1 is out of reach: more than {} waves "
                                          "in a block, or rounding hides its dimension",
                                          mostKernelState)};
        }
        if (isRequested(options_.cancel)) {
            return {.detail = "cancelled"};
        }
        if (!isKernel_ && proofOf({}, blocks_)) {
            // Rounding hides whether W - 1 has a kernel; in rationals it has none that counts.
            return {.status = Status::none};
        }
        SteppedExistence there = existence(*posed_, *simplex_, settings());
        if (there.status == Status::undecided && isKernel_ &&
            options_.formulation == Formulation::automatic) {
            posed_ = jointsForm(blocks_);
            there = existence(*posed_, *simplex_, settings());
        }
        return there;
    }

    /// What one form says, the other confirms if it can: a conflict that proves nothing may be one
    /// that rounding made up.
    void enterAbsence(const SteppedExistence& there)
    {
        // Demands relaxed by the tolerance are what has to be impossible.
        const SteppedBlocks relaxed =
            blocksOf(bar_, result_.schedule, options_.tipFloor - options_.tolerance, true);
        auto conflict = there.conflict;
        auto proof = proofOf(conflict, relaxed);
        if (!proof && isKernel_) {
            const SteppedExistence other = existence(jointsForm(blocks_), *simplex_, settings());
            if (other.status == Status::none) {
                conflict = other.conflict;
                proof = proofOf(conflict, relaxed);
            }
        }
        if (!proof) {
            result_.detail = fmt::format(
                "{} finds no motion, but no exact proof came of it{}", simplex_->name(),
                blocks_.stateSize() * static_cast<std::int64_t>(blocks_.types.size()) >
                        mostExactRows
                    ? fmt::format(": more than {} waves close upon themselves", mostExactRows)
                    : "");
            return;
        }
        result_.status = Status::none;
        result_.set.kind = SetKind::empty;
        result_.absence =
            Absence{reasonOf(conflict, blocks_, result_.set.kernelDimension),
                    SteppedProof{std::move(*proof), options_.tipFloor, options_.tolerance}};
    }

    void enterMotion(const SteppedExistence& there)
    {
        const Objective objective = objectiveOf(options_);
        SteppedPoint point;
        SteppedBlocks single;
        const SteppedBlocks* used = &blocks_;
        if (options_.energyRatio) {
            // Motions of more than the least energy have different waves in a block.
            single = blocksOf(bar_, result_.schedule, options_.tipFloor, false);
            used = &single;
            posed_ = pose(single);
            point = pointOfEnergy(*posed_, options_);
        } else if (objective == Objective::any) {
            point.x = there.x;
            point.solver = simplex_->name();
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
        Bar bar = firstMaterial(options_.scene);
        const double unit = scales(bar).energy;
        bar.young.reset();  // it is known of the first segment only
        result_.status = Status::found;
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
    std::unique_ptr<Solver> simplex_;
    std::optional<SteppedProgram> posed_;
    bool isKernel_ = false;
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

bool holds(const SteppedProof& proof, const Schedule& schedule, const Scene& scene)
{
    const double relaxed = proof.tipFloor - proof.tolerance;
    const SteppedBlocks blocks = blocksOf(steppedBar(scene.segments), schedule, relaxed, true);
    return proof.tolerance >= 0.0 && isProof(proof.multipliers, jointsForm(blocks).program);
}

}  // namespace signorini
