#include "request.hpp"

#include "backend_choice.hpp"
#include "faults.hpp"

namespace signorini {

namespace {

void validate(const FindOptions& options)
{
    signorini::validate(options.bar);
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
    requireBackend(options.solver);
    if (options.solver == closedForm && options.formulation == Formulation::state) {
        faults.add("formulation", name(options.formulation),
                   "auto|reduced|lumped with solver closed-form");
    }
    faults.throwIfAny();
}

Demands demandsOf(const FindOptions& options)
{
    return {.objective = options.objective,
            .target = options.target,
            .strainLimit = options.strainLimit,
            .tipFloor = options.tipFloor,
            .fixed = options.fixed,
            .energyRatio = options.energyRatio};
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
        Faults faults;
        faults.add("objective", name(demands.objective),
                   "auto|any when an energy is held, and further ones for one contact phase in "
                   "closed form: min-peak-strain, and nearest where the wall is pressed");
        faults.throwIfAny();
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

/// The sums that decide several phases and, if their number is within reach, what they decide.
Known knownOfSeveralPhases(const Schedule& schedule)
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

bool Request::allowsExact() const
{
    const Formulation asked = options.formulation;
    if (options.solver == closedForm) {
        return true;
    }
    return options.solver == automaticChoice &&
           (schedule.phases.size() == 1
                ? asked != Formulation::state
                : asked == Formulation::automatic || asked == Formulation::lumped);
}

bool Request::isMetBy(const State& state) const
{
    return violation(demands, state, schedule) <= options.tolerance;
}

Request checked(const Schedule& schedule, const FindOptions& options)
{
    signorini::validate(schedule);
    validate(options);
    Request request{schedule, options, demandsOf(options), {}};
    validate(request.demands, schedule);
    const Stopwatch watch;
    request.known =
        schedule.phases.size() == 1 ? knownOfOnePhase(schedule) : knownOfSeveralPhases(schedule);
    request.known.seconds = watch.seconds();
    requireExactRoute(request);
    return request;
}

}  // namespace signorini
