#include "signorini/continuum.hpp"

#include <algorithm>
#include <cmath>

#include "continuum_geometric.hpp"
#include "continuum_programs.hpp"
#include "continuum_record.hpp"
#include "echo.hpp"
#include "energy_section.hpp"
#include "engine_names.hpp"
#include "faults.hpp"
#include "solver.hpp"

namespace signorini {

namespace {

constexpr Named<Parameter> parameterNames[] = {
    {Parameter::arcLength, "arc length"},
    {Parameter::position, "position"},
    {Parameter::number, "number"},
};

void validate(const Schedule& schedule, double energyRatio, const ContinuumOptions& options)
{
    signorini::validate(schedule);
    signorini::validate(options.bar);
    Faults faults;
    if (!(energyRatio > 0.0 && std::isfinite(energyRatio))) {
        faults.add("energyRatio", energyRatio, "finite numbers > 0");
    }
    if (options.points < 2 || options.points > maxContinuumPoints) {
        faults.add("points", options.points, fmt::format("2..{}", maxContinuumPoints));
    }
    const int ends = (options.to ? 1 : 0) + (options.direction ? 1 : 0);
    if ((options.from ? 1 : 0) != ends) {
        faults.add("from with to or direction", "incomplete",
                   "from and one of the others, or none");
    }
    if (options.sample && options.from) {
        faults.add("sample", "with from", "only without ends");
    }
    if (options.direction &&
        (options.direction->cells() != schedule.cells || !options.direction->a.allFinite() ||
         !options.direction->b.allFinite())) {
        faults.add("direction", "a malformed state", "finite values on the schedule's cells");
    }
    if (options.from && options.seed) {
        faults.add("seed", *options.seed, "only without from and to");
    }
    if (!(options.strainLimit > 0.0)) {
        faults.add("strainLimit", options.strainLimit, "> 0");
    }
    if (!(options.resolution >= 1e-6 && options.resolution <= 1.0)) {
        faults.add("resolution", options.resolution, "1e-6..1");
    }
    if (!(options.tolerance >= 1e-12 && options.tolerance <= 1e-2)) {
        faults.add("tolerance", options.tolerance, "1e-12..1e-2");
    }
    faults.throwIfAny();
}

/// One call of traceContinuum: what theory knows first, then an engine.
class Trace {
public:
    Trace(const Schedule& schedule, double energyRatio, const ContinuumOptions& options)
        : options_(options), record_(schedule, energyRatio, options), result_(record_.result)
    {
    }

    Continuum run()
    {
        record_.requireMotion("from", options_.from);
        record_.requireMotion("to", options_.to);
        section_ = isOnePhase() ? sectionOfOnePhase(result_.schedule, record_.energy())
                                : sectionOfPhases(result_.schedule, record_.energy());
        describeSet();
        result_.engine = chooseEngine();
        if (!hasMotion() || areApart()) {
            return std::move(result_);
        }
        if (isFinite()) {
            listIsolated(record_, *section_);
        } else if (result_.engine == Engine::geometric) {
            traceGeometrically(record_, *section_);
        } else {
            traceWithPrograms(record_, section_.get(), member_);
        }
        return std::move(result_);
    }

private:
    [[nodiscard]] bool isOnePhase() const { return result_.schedule.phases.size() == 1; }
    [[nodiscard]] bool isLimited() const { return std::isfinite(record_.demands.strainLimit); }

    /// Some motion has this energy, for certain and without a limit.
    [[nodiscard]] bool isInRange() const { return section_ && section_->facts().components != 0; }
    [[nodiscard]] bool isFinite() const { return isInRange() && section_->facts().isFinite; }

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
        if (isInRange() && !options_.from) {
            result_.connected = facts.isConnected;
        }
    }

    /// Amplitudes of one sign in a box are a simplex.
    [[nodiscard]] bool isOneSigned(const std::optional<State>& state) const
    {
        constexpr double rounding = 1e-12;
        const std::vector<double> shares =
            state ? section_->sharesOf(*state) : std::vector<double>();
        return std::all_of(shares.begin(), shares.end(),
                           [](double share) { return share >= -rounding; });
    }

    [[nodiscard]] bool isGeometric() const
    {
        if (!section_) {
            return isOnePhase();
        }
        const SectionFacts& facts = section_->facts();
        if (!isInRange() || facts.isFinite) {
            return true;  // nothing to trace
        }
        if (isLimited() || !facts.simplex) {
            return false;
        }
        return facts.isWhole || options_.sample ||
               (facts.simplex->ratio <= 0.5 && isOneSigned(options_.from) &&
                isOneSigned(options_.to));
    }

    [[nodiscard]] Engine chooseEngine() const
    {
        const bool mayBeGeometric = isGeometric();
        const bool needsGeometry = options_.sample || options_.direction.has_value();
        if (needsGeometry && (!mayBeGeometric || options_.engine == Engine::ipopt ||
                              options_.engine == Engine::nlopt)) {
            throw std::invalid_argument(
                "sample or direction: allowed with engine auto|geometric where motions differ in "
                "one type of classes only, and no strain limit excludes any");
        }
        if (options_.engine == Engine::geometric && !mayBeGeometric) {
            throw std::invalid_argument(
                "engine = geometric is out of range: allowed ipopt|nlopt where motions differ in "
                "several types of classes, where a strain limit excludes some, and for grazing "
                "motions of both signs");
        }
        if (options_.engine != Engine::automatic) {
            return options_.engine;
        }
        if (mayBeGeometric) {
            return Engine::geometric;
        }
        const auto available = [](const char* backend) { return findBackend(backend).available(); };
        return available("ipopt") || !available("nlopt-auglag") ? Engine::ipopt : Engine::nlopt;
    }

    /// Where theory cannot say, findPeriodic does; its motion is a first member for programs.
    bool hasMotion()
    {
        if (options_.from || isFinite() || (isInRange() && result_.engine == Engine::geometric)) {
            return true;
        }
        FindOptions find;
        find.bar = options_.bar;
        find.strainLimit = record_.demands.strainLimit * scales(options_.bar).strain;
        find.energyRatio = record_.energy();
        find.tolerance = options_.tolerance;
        find.cancel = options_.cancel;
        PeriodicResult motion = findPeriodic(result_.schedule, find);
        if (motion.status == Status::found) {
            member_ = std::move(motion.state);
            return true;
        }
        result_.status = motion.status;
        result_.reason = motion.reason;
        result_.detail = motion.detail;
        if (motion.status == Status::none && result_.detail.empty()) {
            result_.detail = fmt::format("no motion follows {}: {}", describe(result_.schedule),
                                         name(*motion.reason));
        }
        return false;
    }

    /// Ends in different components are no matter for an engine, and a limit joins none of them.
    bool areApart()
    {
        if (!options_.to || !isInRange()) {
            return false;
        }
        const std::optional<bool> joined = section_->joins(*options_.from, *options_.to);
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
            return wordsForApart(*section_, section_->sharesOf(*options_.from),
                                 section_->sharesOf(*options_.to));
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
    State member_;
};

}  // namespace

std::string_view name(Engine engine)
{
    return nameIn(engineNames, engine);
}

std::string_view name(Parameter parameter)
{
    return nameIn(parameterNames, parameter);
}

Continuum traceContinuum(const Schedule& schedule, double energyRatio,
                         const ContinuumOptions& options)
{
    validate(schedule, energyRatio, options);
    return Trace(schedule, energyRatio, options).run();
}

std::vector<State> sampleMotions(const Schedule& schedule, double energyRatio, std::int64_t count,
                                 std::uint64_t seed)
{
    const Reduction reduction = reduce(schedule);
    if (count < 1 || count > maxContinuumPoints || !(energyRatio > 0.0)) {
        Faults faults;
        faults.add("count and energyRatio", fmt::format("{} and {}", count, energyRatio),
                   fmt::format("1..{} and finite numbers > 0", maxContinuumPoints));
        faults.throwIfAny();
    }
    std::vector<State> motions;
    if (reduction.reason) {
        return motions;
    }
    const EnergyRange range = energyRange(reduction);
    if (energyRatio < range.least || energyRatio > range.most) {
        return motions;
    }
    const double squares = squaresOf(energyRatio, reduction.cells, reduction.window);
    SectionSampler sampler(reduction.set, squares, seed);
    for (std::int64_t k = 0; k < count; ++k) {
        motions.push_back(motionOf(reduction, sampler.next()));
    }
    return motions;
}

std::optional<std::int64_t> componentsAt(const Reduction& reduction, double energyRatio)
{
    if (reduction.reason) {
        return 0;
    }
    const EnergyRange range = energyRange(reduction);
    if (!(energyRatio >= range.least && energyRatio <= range.most)) {
        return 0;
    }
    return connectivityOf(reduction, energyRatio).components;
}

}  // namespace signorini
