#include "signorini/continuum.hpp"

#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <numbers>
#include <random>

#include "faults.hpp"
#include "signorini/closed_form.hpp"
#include "signorini/demands.hpp"
#include "signorini/solver.hpp"
#include "signorini/sphere_section.hpp"

namespace signorini {

namespace {

using Rational = boost::multiprecision::cpp_rational;

constexpr std::int64_t maxPoints = 1'000'000;

void validate(const Schedule& schedule, double energyRatio, const ContinuumOptions& options)
{
    signorini::validate(schedule);
    signorini::validate(options.bar);
    Faults faults;
    if (!(energyRatio > 0.0 && std::isfinite(energyRatio))) {
        faults.add("energyRatio", energyRatio, "finite numbers > 0");
    }
    if (options.points < 2 || options.points > maxPoints) {
        faults.add("points", options.points, fmt::format("2..{}", maxPoints));
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
    if (!(options.tolerance >= 1e-12 && options.tolerance <= 1e-2)) {
        faults.add("tolerance", options.tolerance, "1e-12..1e-2");
    }
    faults.throwIfAny();
}

/// Distance of two states in the norm of the energy.
double distance(const State& first, const State& second)
{
    return std::sqrt(2.0 / static_cast<double>(first.cells()) *
                     ((first.a - second.a).squaredNorm() + (first.b - second.b).squaredNorm()));
}

/// sum z^2 of the amplitudes of an energy.
double squaresAt(const Reduction& reduction, double energyRatio)
{
    return energyRatio * static_cast<double>(reduction.schedule.cells) /
           (2.0 * static_cast<double>(reduction.window));
}

SphereSection sectionAt(const Reduction& reduction, double energyRatio)
{
    const double sum = reduction.set.sum;
    return {reduction.set.count, squaresAt(reduction, energyRatio) / (sum * sum)};
}

std::vector<double> scaled(std::vector<double> z, double factor)
{
    for (double& value : z) {
        value *= factor;
    }
    return z;
}

std::string_view backendOf(Engine engine)
{
    return engine == Engine::ipopt ? "ipopt" : "nlopt-auglag";
}

/// The nonlinear programs of a trace: the motion of the energy nearest to given unknowns.
class Corrector {
public:
    /// `demands`: nearest to a target, without an energy.
    Corrector(const Schedule& schedule, const Demands& demands, double energyRatio, Engine engine,
              double tolerance, Cancel cancel)
        : formulated_(pose(schedule, demands, Formulation::reduced)),
          solver_(makeSolver(backendOf(engine)))
    {
        formulated_.program.energy = EnergyEquality{energyWeights(formulated_), energyRatio};
        settings_.tolerance = 0.01 * tolerance;
        if (solver_->capabilities().cancel) {
            settings_.cancel = std::move(cancel);
        }
    }

    /// The unknowns that the objective of a posed program aims at.
    [[nodiscard]] Eigen::VectorXd target() const
    {
        const Program& program = formulated_.program;
        Eigen::VectorXd x = Eigen::VectorXd::Zero(program.variables());
        for (Eigen::Index i = 0; i < x.size(); ++i) {
            x[i] = program.quadratic[i] > 0.0 ? -program.linear[i] / program.quadratic[i] : 0.0;
        }
        return x;
    }

    [[nodiscard]] SolverResult land(const Eigen::VectorXd& predicted)
    {
        Program& program = formulated_.program;
        program.linear = -program.quadratic.cwiseProduct(predicted);
        settings_.start = predicted.cwiseMax(program.lower).cwiseMin(program.upper);
        return solver_->solve(program, settings_);
    }

    [[nodiscard]] State stateOf(const Eigen::VectorXd& x) const
    {
        return signorini::stateOf(formulated_, x);
    }

private:
    Formulated formulated_;
    std::unique_ptr<Solver> solver_;
    SolverOptions settings_;
};

/// One call of traceContinuum on its way to an answer.
class Trace {
public:
    Trace(const Schedule& schedule, double energyRatio, const ContinuumOptions& options)
        : options_(options)
    {
        demands_.strainLimit = options.strainLimit / scales(options.bar).strain;
        demands_.energyRatio = energyRatio;
        signorini::validate(demands_, schedule);
        result_.schedule = schedule;
        result_.bar = options.bar;
        result_.energyRatio = energyRatio;
        result_.detail.clear();
    }

    Continuum run()
    {
        requireMotion("from", options_.from);
        requireMotion("to", options_.to);
        if (result_.schedule.phases.size() == 1) {
            reduce(result_.schedule, reduction_);
            describeSet();
        }
        result_.engine = chooseEngine();
        if (!hasMotion()) {
            return std::move(result_);
        }
        if (result_.engine == Engine::geometric) {
            traceGeometrically();
        } else {
            traceWithPrograms();
        }
        return std::move(result_);
    }

private:
    [[nodiscard]] double energy() const { return result_.energyRatio; }

    /// An end that a user gave must be a motion of this schedule, energy and limit.
    void requireMotion(const char* field, const std::optional<State>& state) const
    {
        if (!state) {
            return;
        }
        const double residual =
            state->cells() == result_.schedule.cells && state->b.size() == state->a.size()
                ? verify(*state, result_.schedule, options_.tolerance).residuals.worst()
                : std::numeric_limits<double>::infinity();
        if (!(residual <= options_.tolerance)) {
            throw std::invalid_argument(
                fmt::format("{} = a state with residual {:.3g} is out of range: allowed motions of "
                            "{}, residual at most {:.3g}",
                            field, residual, describe(result_.schedule), options_.tolerance));
        }
        if (!(violation(demands_, *state, result_.schedule) <= options_.tolerance)) {
            throw std::invalid_argument(
                fmt::format("{} = a motion with E/E_1 = {}, peak strain {} is out of range: "
                            "allowed E/E_1 = {}, peak strain at most {}",
                            field, signorini::energyRatio(*state), peakStrainOf(*state), energy(),
                            options_.strainLimit));
        }
    }

    [[nodiscard]] double peakStrainOf(const State& state) const
    {
        return extremesOf(state, result_.schedule).peakStrain * scales(options_.bar).strain;
    }

    void describeSet()
    {
        if (reduction_.reason) {
            return;
        }
        result_.energyRange = energyRange(reduction_);
        if (std::isinf(options_.strainLimit)) {
            result_.components = componentsAt(reduction_, energy());
            const EnergyRange range = *result_.energyRange;
            const bool isInside = range.least < energy() && energy() < range.most;
            result_.dimension = isInside ? reduction_.set.count - 2 : 0;
            if (result_.components && *result_.components > 0 && !options_.from) {
                result_.connected = *result_.components == 1;
            }
        }
    }

    /// Amplitudes of one sign are a simplex, whatever the set.
    [[nodiscard]] bool isOneSigned(const std::optional<State>& state) const
    {
        if (!state) {
            return true;
        }
        const std::vector<double> z = amplitudesOf(reduction_, *state);
        const double rounding = 1e-12 * std::abs(reduction_.set.sum);
        const double sign = std::copysign(1.0, reduction_.set.sum);
        return std::all_of(z.begin(), z.end(),
                           [&](double value) { return sign * value >= -rounding; });
    }

    [[nodiscard]] bool isGeometric() const
    {
        if (result_.schedule.phases.size() != 1 || !std::isinf(options_.strainLimit)) {
            return false;
        }
        if (reduction_.reason || reduction_.set.kind != SetKind::box) {
            return true;
        }
        // Of a box, the sphere section inside its simplex of one sign.
        return options_.sample || (sectionAt(reduction_, energy()).ratio <= 0.5 &&
                                   isOneSigned(options_.from) && isOneSigned(options_.to));
    }

    [[nodiscard]] Engine chooseEngine() const
    {
        const auto available = [](Engine engine) {
            return findBackend(backendOf(engine)).available();
        };
        const bool needsGeometry = options_.sample || options_.direction.has_value();
        if (needsGeometry && (!isGeometric() || options_.engine == Engine::ipopt ||
                              options_.engine == Engine::nlopt)) {
            throw std::invalid_argument(
                "sample or direction: allowed with engine auto|geometric, one contact phase, no "
                "strain limit");
        }
        if (options_.engine == Engine::geometric && !isGeometric()) {
            throw std::invalid_argument(
                "engine = geometric is out of range: allowed ipopt|nlopt for several contact "
                "phases, strain limits, and grazing motions of both signs");
        }
        if (options_.engine != Engine::automatic) {
            return options_.engine;
        }
        if (isGeometric()) {
            return Engine::geometric;
        }
        return available(Engine::ipopt) || !available(Engine::nlopt) ? Engine::ipopt
                                                                     : Engine::nlopt;
    }

    /// Asks findPeriodic whether any motion has this energy; keeps it as a first member.
    bool hasMotion()
    {
        FindOptions find;
        find.bar = options_.bar;
        find.strainLimit = options_.strainLimit;
        find.energyRatio = energy();
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

    void stop(std::string why)
    {
        result_.status = Status::undecided;
        result_.detail = std::move(why);
    }

    /// Verifies a motion and keeps it; false if the trace ends here.
    bool keep(double lambda, State state)
    {
        const std::size_t number = result_.points.size() + 1;
        Residuals residuals = verify(state, result_.schedule, options_.tolerance).residuals;
        residuals.demands = violation(demands_, state, result_.schedule);
        if (!(residuals.worst() <= options_.tolerance)) {
            stop(
                fmt::format("point {} at lambda = {} has a residual of {:.3g}, more than the "
                            "tolerance {:.3g}",
                            number, lambda, residuals.worst(), options_.tolerance));
            return false;
        }
        result_.points.push_back({lambda, std::move(state), 0.0, residuals.worst(), 0.0});
        ContinuumPoint& point = result_.points.back();
        point.energyRatio = signorini::energyRatio(point.state);
        point.peakStrain = peakStrainOf(point.state);
        return true;
    }

    bool isCancelled()
    {
        if (!isRequested(options_.cancel)) {
            return false;
        }
        stop(fmt::format("interrupted after {} of {} points", result_.points.size(),
                         options_.points));
        return true;
    }

    void finish()
    {
        result_.status = Status::found;
        result_.detail.clear();
        if (options_.from) {
            result_.connected = true;
        }
    }

    void traceGeometrically()
    {
        const SphereSection section = sectionAt(reduction_, energy());
        if (options_.sample) {
            sampleMembers();
        } else if (options_.direction) {
            walk(section);
        } else if (options_.from) {
            tracePath(section, amplitudesOf(reduction_, *options_.from),
                      amplitudesOf(reduction_, *options_.to), "path between two given motions");
        } else if (options_.seed) {
            AmplitudeSet simplex = reduction_.set;
            simplex.kind = simplex.count > 1 ? SetKind::simplex : SetKind::point;
            SectionSampler sampler(simplex, squaresAt(reduction_, energy()), *options_.seed);
            const std::vector<double> from = sampler.next(200);
            tracePath(section, from, sampler.next(200), "path between two random members");
        } else {
            traceBlock(section);
        }
    }

    void sampleMembers()
    {
        SectionSampler sampler(reduction_.set, squaresAt(reduction_, energy()),
                               options_.seed.value_or(1));
        result_.parameter = Parameter::number;
        result_.family = "members drawn evenly";
        const std::int64_t points = result_.dimension > 0 ? options_.points : 1;
        for (std::int64_t k = 1; k <= points; ++k) {
            if (isCancelled() ||
                !keep(static_cast<double>(k), motionOf(reduction_, sampler.next()))) {
                return;
            }
        }
        finish();
    }

    /// From one end in a direction, for half a turn of the sphere about equal amplitudes.
    void walk(const SphereSection& section)
    {
        const double sum = reduction_.set.sum;
        SlidingWalk walker(section, scaled(amplitudesOf(reduction_, *options_.from), 1.0 / sum),
                           scaled(amplitudesOf(reduction_, *options_.direction), 1.0 / sum));
        const double unit = std::sqrt(energy() / section.ratio);
        const double radius =
            std::sqrt(std::max(0.0, section.ratio - 1.0 / static_cast<double>(section.count)));
        const double step = std::numbers::pi * radius / static_cast<double>(options_.points - 1);
        result_.family = "walk in a given direction";
        for (std::int64_t k = 0; k < options_.points; ++k) {
            const std::vector<double> z = walker.advance(k == 0 ? 0.0 : step);
            if (isCancelled() || !keepAmplitudes(static_cast<double>(k) * step * unit, z)) {
                return;
            }
            if (!walker.canMove()) {
                result_.detail = "the direction ends in a corner of the set";
                result_.status = Status::found;
                return;
            }
        }
        result_.status = Status::found;
        result_.detail.clear();
    }

    bool keepAmplitudes(double lambda, std::vector<double> unit)
    {
        return keep(lambda, motionOf(reduction_, scaled(std::move(unit), reduction_.set.sum)));
    }

    void traceBlock(const SphereSection& section)
    {
        const TravellingBlock block(section);
        result_.parameter = Parameter::position;
        result_.family =
            section.ratio <= 0.5 ? "travelling block" : "companion of a dominant amplitude";
        const double range = block.last() - block.first();
        const std::int64_t points = result_.dimension > 0 ? options_.points : 1;
        for (std::int64_t k = 0; k < points; ++k) {
            const double share =
                points == 1 ? 0.0 : static_cast<double>(k) / static_cast<double>(points - 1);
            const double position = block.first() + share * range;
            if (isCancelled() || !keepAmplitudes(position, block.at(position))) {
                return;
            }
        }
        finish();
    }

    void tracePath(const SphereSection& section, const std::vector<double>& from,
                   const std::vector<double>& to, const char* family)
    {
        const double sum = reduction_.set.sum;
        const std::vector<double> start = scaled(from, 1.0 / sum);
        const std::vector<double> end = scaled(to, 1.0 / sum);
        const bool isSplit = result_.components.value_or(1) > 1;
        if (isSplit && dominant(start) != dominant(end)) {
            result_.status = Status::none;
            result_.connected = false;
            result_.detail = fmt::format(
                "the two motions lie in different components: at this energy one amplitude exceeds "
                "half of the sum, the {}. in one motion and the {}. in the other, and no curve of "
                "motions can exchange them ({} components)",
                dominant(start) + 1, dominant(end) + 1, *result_.components);
            return;
        }
        const SectionPath path(section, start, end);
        const Spacing spacing = equalSpacing(path, options_.points);
        const double unit = std::sqrt(energy() / section.ratio);
        const std::size_t points = result_.dimension > 0 ? spacing.lengths.size() : 1;
        result_.family = family;
        for (std::size_t k = 0; k < points; ++k) {
            if (isCancelled() ||
                !keepAmplitudes(unit * spacing.lengths[k], path.at(spacing.parameters[k]))) {
                return;
            }
        }
        finish();
    }

    [[nodiscard]] Corrector correctorTo(const State& target) const
    {
        Demands demands = demands_;
        demands.energyRatio.reset();
        demands.objective = Objective::nearest;
        demands.target = target;
        return {result_.schedule,   demands,        energy(), result_.engine,
                options_.tolerance, options_.cancel};
    }

    /// Without ends: the first of a few members nearest to shuffled unknowns that is not the start.
    [[nodiscard]] SolverResult farEnd(Corrector& corrector, const Eigen::VectorXd& start) const
    {
        constexpr int attempts = 20;
        std::mt19937_64 generator(options_.seed.value_or(1));
        Eigen::VectorXd x = start;
        SolverResult landed;
        for (int k = 0; k < attempts && !isRequested(options_.cancel); ++k) {
            std::shuffle(x.begin(), x.end(), generator);
            landed = corrector.land(x);
            if (landed.status == SolverStatus::optimal &&
                distance(corrector.stateOf(landed.x), corrector.stateOf(start)) >
                    1e-3 * std::sqrt(energy())) {
                break;
            }
        }
        return landed;
    }

    void traceWithPrograms()
    {
        Corrector corrector = correctorTo(options_.from.value_or(member_));
        Eigen::VectorXd x = corrector.target();
        SolverResult landed = corrector.land(x);
        if (landed.status != SolverStatus::optimal) {
            stop(fmt::format("the first point: {}", landed.detail));
            return;
        }
        x = landed.x;
        if (options_.to) {
            landed = corrector.land(correctorTo(*options_.to).target());
        } else {
            landed = farEnd(corrector, x);
        }
        result_.family =
            options_.to ? "path between two given motions" : "path between two members";
        if (landed.status != SolverStatus::optimal) {
            stop(fmt::format("the last point: {}", landed.detail));
            return;
        }
        march(corrector, std::move(x), landed.x);
    }

    /// Predictor-corrector from x to the end. A corrector that lands much further away than the
    /// predictor went has left the curve.
    void march(Corrector& corrector, Eigen::VectorXd x, const Eigen::VectorXd& end)
    {
        constexpr double longestStep = 10.0;
        if (!keep(0.0, corrector.stateOf(x))) {
            return;
        }
        for (std::int64_t k = 1; k < options_.points && !isCancelled(); ++k) {
            const Eigen::VectorXd predicted =
                x + (end - x) / static_cast<double>(options_.points - k);
            SolverResult landed = corrector.land(predicted);
            if (landed.status != SolverStatus::optimal) {
                if (!isCancelled()) {
                    stop(fmt::format("the corrector failed at point {} of {}: {}", k + 1,
                                     options_.points, landed.detail));
                }
                return;
            }
            State state = corrector.stateOf(landed.x);
            const ContinuumPoint& last = result_.points.back();
            const double step = distance(last.state, state);
            const double planned =
                distance(last.state, corrector.stateOf(predicted)) + options_.tolerance;
            if (step > longestStep * planned) {
                stop(
                    fmt::format("the trace broke at point {} of {}: the nearest motion is {:.3g} "
                                "times as far as the predicted one",
                                k + 1, options_.points, step / planned));
                return;
            }
            if (!keep(last.lambda + step, std::move(state))) {
                return;
            }
            x = std::move(landed.x);
        }
        if (static_cast<std::int64_t>(result_.points.size()) == options_.points) {
            finish();
        }
    }

    const ContinuumOptions& options_;
    Demands demands_;
    Reduction reduction_;
    State member_;
    Continuum result_;
};

}  // namespace

std::string_view name(Engine engine)
{
    switch (engine) {
        case Engine::automatic:
            return "auto";
        case Engine::geometric:
            return "geometric";
        case Engine::ipopt:
            return "ipopt";
        case Engine::nlopt:
            return "nlopt";
    }
    throw std::logic_error("unnamed Engine");
}

std::string_view name(Parameter parameter)
{
    switch (parameter) {
        case Parameter::arcLength:
            return "arc length";
        case Parameter::position:
            return "position";
        case Parameter::number:
            return "number";
    }
    throw std::logic_error("unnamed Parameter");
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
    if (count < 1 || count > maxPoints || !(energyRatio > 0.0)) {
        Faults faults;
        faults.add("count and energyRatio", fmt::format("{} and {}", count, energyRatio),
                   fmt::format("1..{} and finite numbers > 0", maxPoints));
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
    SectionSampler sampler(reduction.set, squaresAt(reduction, energyRatio), seed);
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
    if (reduction.set.kind == SetKind::box) {
        return std::nullopt;
    }
    const EnergyRange range = energyRange(reduction);
    if (!(energyRatio >= range.least && energyRatio <= range.most)) {
        return 0;
    }
    // rho = E win^2/(2 w N) <= 1/2 ?
    const Rational windowSum = reduction.windowSum;
    const Rational half = Rational(reduction.window) * Rational(reduction.schedule.cells);
    const bool isOne = Rational(energyRatio) * windowSum * windowSum <= half;
    return isOne ? 1 : reduction.set.count;
}

}  // namespace signorini
