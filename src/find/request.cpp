#include "request.hpp"

#include <algorithm>
#include <cmath>

#include "backend_choice.hpp"
#include "faults.hpp"
#include "network_route.hpp"
#include "stops.hpp"

namespace signorini {

namespace {

Demands demandsOf(const FindOptions& options)
{
    return {.objective = options.objective,
            .target = options.target,
            .strainLimit = options.strainLimit,
            .tipFloor = options.tipFloor,
            .fixed = options.fixed,
            .energyRatio = options.energyRatio};
}

/// Without a gap motions have any size, and 0 is one: only an energy, or a second stop that is
/// touched, says which is meant.
void requireSize(const Request& request)
{
    const Schedule& schedule = request.schedule;
    if (schedule.stops.right != 0) {
        return;
    }
    const FindOptions& options = request.options;
    if (!isCone(schedule.stops)) {
        const bool touchesBoth =
            std::any_of(schedule.phases.begin(), schedule.phases.end(),
                        [](const Phase& phase) { return phase.stop == Stop::left; });
        if (!touchesBoth && !options.energyRatio) {
            throwFault(
                "schedule", describe(schedule),
                "those with a contact on the second stop where the gap is 0 and no energy sets "
                "the size");
        }
        return;
    }
    Faults faults;
    if (!options.energyRatio) {
        faults.add("energyRatio", "not given",
                   "finite and > 0 where the gap is 0: motions have any size");
    }
    if (options.objective != Objective::automatic && options.objective != Objective::any &&
        options.objective != Objective::maxImpulse) {
        faults.add("objective", name(options.objective), "auto|any|max-impulse where the gap is 0");
    }
    if (std::isfinite(options.strainLimit) || std::isfinite(options.tipFloor) ||
        !options.fixed.empty()) {
        faults.add("limits", "strainLimit, tipFloor or fixed values",
                   "none where the gap is 0: the energy sets the size");
    }
    faults.throwIfAny();
}

/// Held energies meet other objectives in the closed form of one contact phase only.
void requireExactRoute(const Request& request)
{
    const Demands& demands = request.demands;
    const Known& known = request.known;
    const bool isExact =
        known.onePhase && request.allowsExact() &&
        !(demands.objective == Objective::nearest && known.set.kind == SetKind::box);
    if (demands.needsExactRoute() && !isExact) {
        throwFault("objective", name(demands.objective),
                   "auto|any when an energy is held, and further ones for one contact phase in "
                   "closed form: min-peak-strain, and nearest where the wall is pressed");
    }
}

Known knownOfOnePhase(const Schedule& schedule)
{
    Known known;
    known.onePhase = onePhaseSet(schedule);
    const OnePhaseSet& r = *known.onePhase;
    known.set = {.kernelDimension = r.kernelDimension,
                 .kind = r.set.kind,
                 .dimension = r.set.dimension(),
                 .amplitudes = r.set};
    if (!r.reason) {
        known.set.energy = energyRange(r);
        known.set.family = familyOf(schedule);
    }
    return known;
}

/// The sums that decide several phases, or two stops, and, if their number is within reach, what
/// they decide.
Known knownByItsSums(const Schedule& schedule)
{
    Known known;
    const std::int64_t blocks = blockCount(schedule);
    if (blocks > maxBlocks) {
        known.outOfReach =
            fmt::format("a period of {} sign blocks: at most {} are walked", blocks, maxBlocks);
        return known;
    }
    ClassTypes classes = classTypes(schedule);
    known.set.kernelDimension = classes.kernelDimension;
    known.reason = absenceReason(classes);
    const std::size_t live = liveTypeCount(classes);
    if (live > maxLiveTypes) {
        if (blocks * static_cast<std::int64_t>(live) > maxBlocks) {
            known.outOfReach = fmt::format(
                "{} live types on {} sign blocks: exact arithmetic takes at most {} types, a "
                "program at most {} entries",
                live, blocks, maxLiveTypes, maxBlocks);
        }
        return known;
    }
    try {
        known.sums = lumpedSetOf(std::move(classes));
    } catch (const std::overflow_error&) {
        return known;  // no proof in 64 bits: a program may find a shorter one
    }
    known.shape = shapeOf(*known.sums);
    known.set.kind = known.shape.kind;
    known.set.dimension = known.shape.dimension;
    if (!known.sums->absence) {
        known.set.energy = known.shape.energy;
    }
    return known;
}

}  // namespace

void checkOptions(const FindOptions& options)
{
    signorini::validate(options.scene);
    Faults faults;
    if (!(options.tolerance >= 1e-12 && options.tolerance <= 1e-2)) {
        faults.add("tolerance", options.tolerance, "1e-12..1e-2");
    }
    if (!(options.timeLimit > 0.0)) {
        faults.add("timeLimit", options.timeLimit, "> 0 [s]");
    }
    if (options.iterationLimit < 0) {
        faults.add("iterationLimit", options.iterationLimit, ">= 0 (0: no limit)");
    }
    const bool isOfSegments =
        options.formulation == Formulation::joints || options.formulation == Formulation::kernel;
    if (isOfSegments && options.scene.segments.empty()) {
        faults.add("formulation", name(options.formulation),
                   "auto|state|reduced|lumped without segments");
    }
    requireBackend(options.solver);
    if (options.solver == closedForm && options.formulation == Formulation::state) {
        faults.add("formulation", name(options.formulation),
                   "auto|reduced|lumped with solver closed-form");
    }
    faults.throwIfAny();
}

bool Request::allowsExact() const
{
    const Formulation asked = options.formulation;
    if (options.solver == closedForm) {
        return true;
    }
    return options.solver == automaticChoice &&
           (known.onePhase ? asked != Formulation::state
                           : asked == Formulation::automatic || asked == Formulation::lumped);
}

bool Request::isOfAnySize() const
{
    return isCone(schedule.stops);
}

State Request::sized(State state) const
{
    if (isOfAnySize()) {
        const double factor = std::sqrt(*demands.energyRatio / energyRatio(state));
        state.a *= factor;
        state.b *= factor;
    }
    return state;
}

bool Request::isMetBy(const State& state) const
{
    return violation(demands, state, schedule) <= options.tolerance;
}

Request checked(const Schedule& schedule, const FindOptions& options)
{
    checkOptions(options);
    Schedule placed = schedule;
    placed.stops = stopsOf(options.scene);
    signorini::validate(placed);
    Request request{std::move(placed), options, demandsOf(options), {}};
    if (asksOfJoints(options)) {
        requireKnownOfJoints(request.schedule, options);
        validate(request.demands, request.schedule);
        return request;
    }
    requireSize(request);
    if (!request.isOfAnySize() || options.objective != Objective::maxImpulse) {
        validate(request.demands, request.schedule);
    }
    const Stopwatch watch;
    request.known = schedule.phases.size() == 1 && !request.schedule.stops.left
                        ? knownOfOnePhase(request.schedule)
                        : knownByItsSums(request.schedule);
    request.known.seconds = watch.seconds();
    requireExactRoute(request);
    return request;
}

}  // namespace signorini
