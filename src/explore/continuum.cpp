#include "signorini/continuum.hpp"

#include <algorithm>
#include <cmath>
#include <random>

#include "continuum_geometric.hpp"
#include "continuum_programs.hpp"
#include "continuum_record.hpp"
#include "curve_points.hpp"
#include "echo.hpp"
#include "energy_section.hpp"
#include "faults.hpp"
#include "names.hpp"
#include "solver.hpp"
#include "stops.hpp"

namespace signorini {

namespace {

constexpr std::string_view automatic = "auto";
constexpr std::string_view closedForm = "closed-form";

constexpr auto parameterNames = std::to_array<Named<Parameter>>({
    {Parameter::arcLength, "arc length"},
    {Parameter::pause, "pause"},
    {Parameter::number, "number"},
});

void validate(const Schedule& schedule, double energyRatio, const ContinuumOptions& options)
{
    signorini::validate(schedule);
    Faults faults;
    if (!(energyRatio > 0.0 && std::isfinite(energyRatio))) {
        faults.add("energyRatio", energyRatio, "finite numbers > 0");
    }
    if (!options.scene.segments.empty()) {
        faults.add("segments", fmt::format("{} given", options.scene.segments.size()),
                   "none: motions of a stepped bar share no amplitudes of classes");
    }
    requireCurve(faults, options.points, options.resolution, options.tolerance);
    const auto* walk = std::get_if<trace::Walk>(&options.trace);
    if (walk != nullptr && (walk->direction.cells() != schedule.cells ||
                            !walk->direction.a.allFinite() || !walk->direction.b.allFinite())) {
        faults.add("direction", "a malformed state", "finite values on the schedule's cells");
    }
    if (options.solver != automatic && options.solver != closedForm &&
        !covers(findBackend(options.solver).can, continuumNeeds)) {
        faults.add("solver", options.solver,
                   fmt::format("{}|{}|one that holds an energy", automatic, closedForm));
    }
    if (!(options.strainLimit > 0.0)) {
        faults.add("strainLimit", options.strainLimit, "> 0");
    }
    faults.throwIfAny();
}

/// One contact phase, and one stop.
bool isClosedForm(const Schedule& schedule)
{
    return schedule.phases.size() == 1 && !schedule.stops.left;
}

std::unique_ptr<EnergySection> sectionOf(const Schedule& schedule, double energyRatio)
{
    if (isCone(schedule.stops)) {
        return sectionOfCone(schedule, energyRatio);
    }
    return isClosedForm(schedule) ? sectionOfOnePhase(schedule, energyRatio)
                                  : sectionOfPhases(schedule, energyRatio);
}

/// One call of traceContinuum: what theory knows first, then a solver.
class Tracing {
public:
    Tracing(const Schedule& schedule, double energyRatio, const ContinuumOptions& options)
        : options_(options), record_(schedule, energyRatio, options), result_(record_.result)
    {
    }

    Continuum run()
    {
        record_.requireMotion("from", record_.from());
        record_.requireMotion("to", record_.to());
        findSection();
        describeSet();
        result_.solver = chosenSolver();
        if (!hasMotion() || areApart()) {
            return std::move(result_);
        }
        if (isFinite()) {
            listIsolated(record_, *section_);
        } else if (cone_ != nullptr) {
            traceInCone(record_, *cone_);
        } else if (isOfAnySize()) {
            record_.stop("motions of any size, but so many phases that exact arithmetic ends");
        } else if (result_.solver == closedForm) {
            traceGeometrically(record_, *section_);
        } else {
            const auto solver =
                makeSolver(options_.solver == automatic ? choose(continuumNeeds)
                                                        : findBackend(options_.solver));
            traceWithPrograms(record_, section_.get(), member_, *solver);
        }
        return std::move(result_);
    }

private:
    [[nodiscard]] bool isOfAnySize() const { return isCone(result_.schedule.stops); }
    [[nodiscard]] bool isLimited() const { return std::isfinite(record_.demands.strainLimit); }

    /// Some motion has this energy, for certain and without a limit.
    [[nodiscard]] bool isInRange() const { return section_ && section_->facts().components != 0; }
    [[nodiscard]] bool isFinite() const { return isInRange() && section_->facts().isFinite; }

    void findSection()
    {
        if (isOfAnySize()) {
            auto cone = sectionOfCone(result_.schedule, record_.energy());
            cone_ = cone.get();
            section_ = std::move(cone);
        } else {
            section_ = sectionOf(result_.schedule, record_.energy());
        }
    }

    /// Drops a limit that no motion of this energy reaches, and says what holds without a limit.
    void describeSet()
    {
        if (!section_) {
            return;
        }
        const SectionFacts& facts = section_->facts();
        result_.energyRange = facts.range;
        constexpr double rounding = 1e-12;
        if (2.0 * facts.largestWave <= record_.demands.strainLimit * (1.0 + rounding)) {
            record_.demands.strainLimit = std::numeric_limits<double>::infinity();
        }
        if (isLimited()) {
            return;
        }
        result_.dimension = facts.dimension;
        result_.components = facts.components;
        if (isInRange() && record_.from() == nullptr) {
            result_.connected = facts.isConnected;
        }
    }

    /// Amplitudes of one sign in a box are a simplex.
    [[nodiscard]] bool isOneSigned(const State* state) const
    {
        constexpr double rounding = 1e-12;
        const std::vector<double> shares =
            state != nullptr ? section_->sharesOf(*state) : std::vector<double>();
        return std::all_of(shares.begin(), shares.end(),
                           [](double share) { return share >= -rounding; });
    }

    [[nodiscard]] bool isGeometric() const
    {
        if (!section_) {
            return isClosedForm(result_.schedule);
        }
        const SectionFacts& facts = section_->facts();
        if (!isInRange() || facts.isFinite) {
            return true;  // nothing to trace
        }
        if (cone_ != nullptr) {
            return true;
        }
        if (isLimited() || !facts.simplex) {
            return false;
        }
        if (facts.isShared) {
            return std::holds_alternative<trace::SplitPulse>(options_.trace);
        }
        return facts.isWhole || std::holds_alternative<trace::Sample>(options_.trace) ||
               (facts.simplex->ratio <= 0.5 && isOneSigned(record_.from()) &&
                isOneSigned(record_.to()));
    }

    [[nodiscard]] std::string chosenSolver() const
    {
        const bool mayBeGeometric = isGeometric();
        const bool isAutomatic = options_.solver == automatic;
        if (isOfAnySize() && (isLimited() || (!isAutomatic && options_.solver != closedForm))) {
            throw std::invalid_argument(
                "engine or strain limit: allowed only auto|geometric (solver auto|closed-form) and "
                "a limit that no motion of this energy reaches where the gap is 0");
        }
        const bool needsGeometry = std::holds_alternative<trace::Sample>(options_.trace) ||
                                   std::holds_alternative<trace::Walk>(options_.trace);
        const bool wantsPrograms = !isAutomatic && options_.solver != closedForm;
        if (needsGeometry && (!mayBeGeometric || wantsPrograms)) {
            throw std::invalid_argument(
                "sample or direction: allowed with engine auto|geometric (solver auto|closed-form) "
                "where motions differ in one type of classes only, and no strain limit excludes "
                "any");
        }
        if (options_.solver == closedForm && !mayBeGeometric) {
            throw std::invalid_argument(
                "engine = geometric (solver closed-form) is out of range: allowed back ends that "
                "hold an energy where motions differ in several types of classes, where a strain "
                "limit excludes some, and for grazing motions of both signs");
        }
        if (!isAutomatic) {
            return options_.solver;
        }
        const Backend* backend =
            mayBeGeometric ? &findBackend(closedForm) : preferred(continuumNeeds);
        return std::string(backend != nullptr ? backend->name : automatic);
    }

    /// Where theory cannot say, findPeriodic does; its motion is a first member for programs.
    bool hasMotion()
    {
        if (record_.from() != nullptr || isFinite() ||
            (isInRange() && result_.solver == closedForm)) {
            return true;
        }
        FindOptions find;
        find.scene = options_.scene;
        find.strainLimit =
            isOfAnySize() ? std::numeric_limits<double>::infinity() : record_.demands.strainLimit;
        find.energyRatio = record_.energy();
        find.tolerance = options_.tolerance;
        find.cancel = options_.cancel;
        PeriodicResult found = findPeriodic(result_.schedule, find);
        if (found.motion) {
            member_ = std::move(found.motion->state);
            return true;
        }
        result_.status = found.status;
        result_.detail = found.detail;
        if (found.absence) {
            const Absence& absence = *found.absence;
            const auto* exclusion = std::get_if<EnergyExclusion>(&absence.proof);
            result_.reason = absence.reason;
            result_.detail = exclusion != nullptr
                                 ? describe(*exclusion)
                                 : fmt::format("no motion follows {}: {}",
                                               describe(result_.schedule), name(absence.reason));
        }
        return false;
    }

    /// Ends in different components are no matter for a solver, and a limit joins none of them.
    bool areApart()
    {
        if (record_.to() == nullptr || !isInRange()) {
            return false;
        }
        const std::optional<bool> joined = section_->joins(*record_.from(), *record_.to());
        if (joined == true && !isLimited()) {
            result_.connected = true;
        }
        if (joined != false) {
            return false;
        }
        result_.status = Status::none;
        result_.connected = false;
        result_.detail = whyApart();
        return true;
    }

    [[nodiscard]] std::string whyApart() const
    {
        const SectionFacts& facts = section_->facts();
        if (facts.simplex && facts.isWhole && !facts.isFinite) {
            return wordsForApart(*section_, section_->sharesOf(*record_.from()),
                                 section_->sharesOf(*record_.to()));
        }
        return fmt::format("the two motions lie in different components{}: {}",
                           facts.components ? fmt::format(" of {}", *facts.components) : "",
                           facts.isFinite
                               ? "only finitely many motions have this energy"
                               : "every curve from one to the other needs motions of less energy");
    }

    const ContinuumOptions& options_;
    ContinuumRecord record_;
    Continuum& result_;
    std::unique_ptr<EnergySection> section_;
    const ConeSection* cone_ = nullptr;  ///< the section, where motions have any size
    State member_;
};

}  // namespace

std::string_view name(Parameter parameter)
{
    return nameIn(parameterNames, parameter);
}

Continuum traceContinuum(const Schedule& schedule, double energyRatio,
                         const ContinuumOptions& options)
{
    signorini::validate(options.scene);
    Schedule placed = schedule;
    placed.stops = stopsOf(options.scene);
    validate(placed, energyRatio, options);
    Continuum curve = Tracing(placed, energyRatio, options).run();
    curve.orbits = countOrbits(curve);
    return curve;
}

Member memberAt(const Continuum& curve, double lambda)
{
    const std::vector<double> lambdas = lambdasOf(curve.points);
    requireWithin(lambda, lambdas);
    const ContinuumPoint& nearest = curve.points[nearestTo(lambda, lambdas)];
    if (nearest.lambda == lambda || curve.parameter != Parameter::pause) {
        return {nearest, nearest.lambda == lambda};
    }
    ContinuumOptions options;
    options.scene = curve.scene;
    ContinuumRecord record(curve.schedule, curve.energyRatio, options);
    if (!keepSplitPulse(record, *sectionOf(curve.schedule, curve.energyRatio), lambda)) {
        throw std::runtime_error(record.result.detail);
    }
    return {std::move(record.result.points.front()), true};
}

std::vector<State> sampleMotions(const Schedule& schedule, double energyRatio, std::int64_t count,
                                 std::uint64_t seed)
{
    const OnePhaseSet whole = onePhaseSet(schedule);
    if (count < 1 || count > maxContinuumPoints || !(energyRatio > 0.0)) {
        throwFault("count and energyRatio", fmt::format("{} and {}", count, energyRatio),
                   fmt::format("1..{} and finite numbers > 0", maxContinuumPoints));
    }
    std::vector<State> motions;
    if (whole.reason) {
        return motions;
    }
    if (whole.set.kind == SetKind::cone) {
        const auto section = sectionOfCone(schedule, energyRatio);
        std::mt19937_64 generator(seed);
        for (std::int64_t k = 0; k < count; ++k) {
            motions.push_back(section->draw(generator));
        }
        return motions;
    }
    const EnergyRange range = energyRange(whole);
    if (energyRatio < range.least || energyRatio > range.most) {
        return motions;
    }
    const double squares = squaresOf(energyRatio, whole.cells, whole.window);
    SectionSampler sampler(whole.set, squares, seed);
    for (std::int64_t k = 0; k < count; ++k) {
        motions.push_back(motionOf(whole, sampler.next()));
    }
    return motions;
}

}  // namespace signorini
