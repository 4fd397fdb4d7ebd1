#include "network_route.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "backend_choice.hpp"
#include "energy_floor.hpp"
#include "faults.hpp"
#include "infeasibility.hpp"
#include "infinity.hpp"
#include "network_points.hpp"
#include "stepped_bar.hpp"
#include "stepped_form.hpp"
#include "stops.hpp"

namespace signorini {

namespace {

/// The bar with its stops, its largest strain [g/L] and, contact number three or last, the floor
/// that its tip keeps above [g].
Network networkOf(const Schedule& schedule, const Scene& scene, double tipFloor, double strainLimit)
{
    Network network = networkOf(scene, schedule.cells);
    network.strainLimit = strainLimit;
    if (std::isfinite(tipFloor)) {
        network.contacts.push_back({ContactKind::stopLeft, network.nodes.size() - 1,
                                    -tipFloor * static_cast<double>(schedule.cells)});
    }
    return network;
}

/// E_1 in units of the network.
double firstEnergy(const Schedule& schedule)
{
    return 0.5 * static_cast<double>(schedule.cells);
}

/// Does what is proved exclude what was asked for?
bool isExcluded(const EnergyFloorProof& proof)
{
    return proof.held ? proof.energyRatio > *proof.held * (1.0 + proof.tolerance)
                      : proof.energyRatio >= hugeEnergyRatio;
}

/// E/E_1, rounded downwards.
double ratioOf(double energy, const Schedule& schedule)
{
    constexpr double downwards = 1.0 - 1e-12;
    return energy / firstEnergy(schedule) * downwards;
}

SteppedBlocks exactBlocks(const Schedule& schedule, const Scene& scene, double tipFloor)
{
    return blocksOf(steppedBar(scene.segments), schedule, tipFloor);
}

/// The same conditions as bounds of prefix sums; those that are equalities are not named.
std::vector<SteppedCondition> namedExactly(const LeastMotion& motion, const SteppedBlocks& blocks)
{
    std::vector<SteppedCondition> named;
    for (const BlockCondition& condition : motion.conditions) {
        const auto at = std::find_if(
            blocks.blocks.begin(), blocks.blocks.end(), [&condition](const StepBlock& block) {
                return block.type == condition.type && block.turn == condition.turn;
            });
        const auto number = static_cast<std::size_t>(at - blocks.blocks.begin());
        if (condition.kind == BlockCondition::Kind::push) {
            named.push_back({SteppedRule::push, number});
            continue;
        }
        const std::size_t before = (number > 0 ? number : blocks.blocks.size()) - 1;
        if (!blocks.blocks[before].isFlightEnd) {
            named.push_back(
                {condition.contact == 0 ? SteppedRule::bound : SteppedRule::floor, before});
        }
    }
    return named;
}

/// One request, on its way to an answer.
class NetworkSearch {
public:
    explicit NetworkSearch(Request& request)
        : request_(request),
          options_(request.options),
          blocks_(
              networkOf(request.schedule, options_.scene, options_.tipFloor, options_.strainLimit),
              spansOf(request.schedule)),
          relaxed_(networkOf(request.schedule, options_.scene,
                             options_.tipFloor - options_.tolerance,
                             options_.strainLimit * (1.0 + options_.tolerance)))
    {
    }

    Claim answer()
    {
        const Stopwatch watch;
        how_ = howOf(blocks_,
                     fmt::format("{} segments: no closed form", options_.scene.segments.size()));
        Claim claim{{}, std::string()};
        claim.answer = decide();
        claim.how = std::move(how_);
        claim.how.solver.seconds = watch.seconds();
        return claim;
    }

private:
    using Answer = std::variant<State, Absence, std::string>;

    [[nodiscard]] LeastDemands demands() const
    {
        return {.absent = hugeEnergyRatio * firstEnergy(request_.schedule),
                .tolerance = options_.tolerance,
                .relaxed = &relaxed_,
                .asksSet = !std::isfinite(options_.tipFloor),
                .cancel = options_.cancel};
    }

    Answer decide()
    {
        LeastMotion least = leastMotion(blocks_, demands());
        how_.solver.iterations = least.how.solver.iterations;
        MotionSet& set = request_.known.set;
        set.kernelDimension = least.kernelDimension;
        if (least.status == Status::found) {
            const bool isSingle = least.kernelDimension == 1;
            set.kind = isSingle ? SetKind::point : least.kind;
            set.dimension = isSingle ? 0 : least.dimension;
        }
        if (least.isEmpty && least.status == Status::undecided &&
            options_.strainLimit == infinity) {
            // Doubles cannot say it. Demands relaxed by the tolerance are what has to be
            // impossible.
            const SteppedBlocks relaxed = exactBlocks(request_.schedule, options_.scene,
                                                      options_.tipFloor - options_.tolerance);
            if (auto exact = proofOf(namedExactly(least, relaxed), relaxed)) {
                set.kind = SetKind::empty;
                return Absence{reasonFor(least), SteppedProof{std::move(*exact), options_.tipFloor,
                                                              options_.tolerance}};
            }
        }
        if (least.status == Status::undecided) {
            return fmt::format("active-set: {}", least.detail);
        }
        if (least.status == Status::none) {
            const Reason reason = reasonFor(least);
            if (reason != Reason::constraints) {
                set.kind = SetKind::empty;
            }
            return absenceOf(least, reason);
        }
        return motionFrom(least);
    }

    /// Where a floor under the tip is among what contradicts itself, motions may be there without.
    [[nodiscard]] Reason reasonFor(const LeastMotion& least) const
    {
        const std::size_t floor = blocks_.network().contacts.size() - 1;
        const bool isFloor =
            std::isfinite(options_.tipFloor) &&
            std::any_of(least.conditions.begin(), least.conditions.end(),
                        [floor](const BlockCondition& of) {
                            return of.kind == BlockCondition::Kind::place && of.contact == floor;
                        });
        if (isFloor) {
            LeastDemands any = demands();
            any.relaxed = nullptr;
            const NetworkBlocks without(
                networkOf(request_.schedule, options_.scene, -infinity, infinity),
                blocks_.schedule());
            if (leastMotion(without, any).status == Status::found) {
                return Reason::constraints;
            }
        }
        return reasonOf(least, blocks_);
    }

    [[nodiscard]] Absence absenceOf(LeastMotion& least, Reason reason) const
    {
        return {reason, EnergyFloorProof{std::move(least.multipliers),
                                         ratioOf(least.provedEnergy, request_.schedule),
                                         options_.tipFloor,
                                         options_.tolerance,
                                         {},
                                         options_.strainLimit}};
    }

    Answer motionFrom(LeastMotion& least)
    {
        if (options_.energyRatio) {
            return motionOfEnergy(least);
        }
        how_.objective =
            options_.objective == Objective::automatic ? Objective::minEnergy : options_.objective;
        if (options_.objective == Objective::nearest) {
            return nearestMotion();
        }
        if (options_.objective == Objective::maxEnergy) {
            const NetworkBlocks single(blocks_.network(), blocks_.schedule(), false);
            NetworkPoints points(single, options_);
            return entered(points.ofMostEnergy(demands().absent), points);
        }
        const bool isOfStrain = options_.objective == Objective::minPeakStrain;
        const bool isOther =
            isOfStrain || options_.objective == Objective::maxImpulse ||
            (options_.objective == Objective::minEnergy && options_.solver != automaticChoice);
        if (isOther) {
            const NetworkBlocks blocks(blocks_.network(), blocks_.schedule(), !isOfStrain);
            NetworkPoints points(blocks, options_);
            return entered(points.extreme(options_.objective), points);
        }
        State state = stateOf(blocks_.network(), least.motion->waves);
        if (how_.objective == Objective::minEnergy) {
            enterEnergies(energyRatio(state, options_.scene.segments));
        }
        return state;
    }

    void enterEnergies(double energy)
    {
        MotionSet& set = request_.known.set;
        set.energy = {energy, std::nan("")};
        if (set.kernelDimension == 1) {
            set.energy->most = energy;
        }
    }

    /// Where the energy to hold is less than all, none; else between least and more.
    Answer motionOfEnergy(LeastMotion& least)
    {
        how_.objective = Objective::any;
        prove(least, blocks_, relaxed_, options_.cancel);
        Absence absence = absenceOf(least, Reason::constraints);
        auto& proof = std::get<EnergyFloorProof>(absence.proof);
        proof.held = options_.energyRatio;
        if (isExcluded(proof)) {
            return absence;
        }
        // Motions of more than the least energy have different waves in a block.
        const NetworkBlocks single(blocks_.network(), blocks_.schedule(), false);
        NetworkPoints points(single, options_);
        return entered(points.ofEnergy(*options_.energyRatio * firstEnergy(request_.schedule),
                                       least.motion->waves),
                       points);
    }

    Answer nearestMotion()
    {
        LeastDemands wanted = demands();
        wanted.target = wavesOf(blocks_.network(), *options_.target);
        const NetworkBlocks single(blocks_.network(), blocks_.schedule(), false);
        const LeastMotion near = leastMotion(single, wanted);
        how_.solver.iterations += near.how.solver.iterations;
        if (near.status != Status::found) {
            return fmt::format("active-set: {}", near.detail);
        }
        return stateOf(single.network(), near.motion->waves);
    }

    Answer entered(NetworkPoint point, const NetworkPoints& points)
    {
        how_.solver.iterations += point.iterations;
        if (!point.solver.empty()) {
            enterSolver(how_, point.solver);
        }
        if (!point.detail.empty()) {
            return std::move(point.detail);
        }
        return stateOf(blocks_.network(), points.motion(point).waves);
    }

    Request& request_;
    const FindOptions& options_;
    NetworkBlocks blocks_;
    Network relaxed_;
    Provenance how_;
};

}  // namespace

bool asksOfJoints(const FindOptions& options)
{
    return !options.scene.segments.empty() &&
           (!isUniform(options.scene.segments) || options.formulation == Formulation::joints ||
            options.formulation == Formulation::kernel);
}

void requireKnownOfJoints(const Schedule& schedule, const FindOptions& options)
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
    if (options.energyRatio && objective != Objective::automatic && objective != Objective::any) {
        refuse("objective", name(objective), "auto|any when an energy is held,");
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
    const double highest = placeOf(schedule.stops, schedule.phases.front().stop).value();
    if (!(options.tipFloor < highest)) {
        faults.add("tipFloor", options.tipFloor, fmt::format("below {} [g]", highest));
    }
    if (const std::int64_t n = steps(schedule); n > maxNetworkSteps) {
        faults.add("steps of the schedule", n, fmt::format("at most {}{}", maxNetworkSteps, where));
    }
    faults.throwIfAny();
    requireCells(steppedBar(options.scene.segments), schedule.cells);
}

Claim networkRoute(Request& request)
{
    return NetworkSearch(request).answer();
}

std::optional<EnergyFloorProof> leastEnergyFloor(const Schedule& schedule,
                                                 const FindOptions& options)
{
    const NetworkBlocks blocks(
        networkOf(schedule, options.scene, options.tipFloor, options.strainLimit),
        spansOf(schedule));
    LeastMotion least = leastMotion(blocks, {.absent = hugeEnergyRatio * firstEnergy(schedule),
                                             .tolerance = options.tolerance,
                                             .cancel = options.cancel});
    if (least.status != Status::found) {
        return std::nullopt;
    }
    prove(least, blocks, blocks.network(), options.cancel);
    EnergyFloorProof proof{std::move(least.multipliers),
                           ratioOf(least.provedEnergy, schedule),
                           options.tipFloor,
                           0.0,
                           {},
                           options.strainLimit};
    return proof.energyRatio > 0.0 ? std::optional(std::move(proof)) : std::nullopt;
}

bool holds(const SteppedProof& proof, const Schedule& schedule, const Scene& scene)
{
    return proof.tolerance >= 0.0 &&
           isProof(
               proof.multipliers,
               jointsForm(exactBlocks(schedule, scene, proof.tipFloor - proof.tolerance)).program);
}

bool holds(const EnergyFloorProof& proof, const Schedule& schedule, const Scene& scene)
{
    const Network network = networkOf(schedule, scene, proof.tipFloor - proof.tolerance,
                                      proof.strainLimit * (1.0 + proof.tolerance));
    return proof.tolerance >= 0.0 && isExcluded(proof) &&
           ratioOf(provedEnergy(proof.multipliers, network, spansOf(schedule)), schedule) >=
               proof.energyRatio;
}

}  // namespace signorini
