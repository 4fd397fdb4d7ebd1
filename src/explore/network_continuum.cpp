#include "network_continuum.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "backend_choice.hpp"
#include "curve_march.hpp"
#include "curve_points.hpp"
#include "faults.hpp"
#include "network_section.hpp"

namespace signorini {

namespace {

void validate(const Network& network, double energy, const NetworkCurveOptions& options)
{
    Faults faults;
    if (!(energy > 0.0 && std::isfinite(energy))) {
        faults.add("energy", energy, "finite numbers > 0");
    }
    requireCurve(faults, options.points, options.resolution, options.tolerance);
    const auto requireWaves = [&](const char* field, const auto& state) {
        if (state && state->size() != network.waves()) {
            faults.add(field, fmt::format("a state of {} waves", state->size()),
                       fmt::format("those of this network, {}", network.waves()));
        }
    };
    requireWaves("from", options.from);
    requireWaves("to", options.to);
    requireWaves("direction", options.direction);
    if (options.isSample && options.solver != automaticChoice && options.solver != closedForm) {
        faults.add("solver", options.solver, "auto|closed-form (engine geometric) of a sample");
    }
    if (!options.isSample && options.solver != automaticChoice &&
        !covers(findBackend(options.solver).can, continuumNeeds)) {
        faults.add("solver", options.solver,
                   "auto or a back end that holds an energy, of a curve of several bars");
    }
    faults.throwIfAny();
}

/// A curve in the unknowns of a section, and the answer that it becomes.
class SectionCurve : public CurveOfMotions {
public:
    SectionCurve(const Network& network, NetworkSection& section,
                 const NetworkCurveOptions& options, NetworkContinuum& result)
        : network_(network), section_(section), options_(options), result_(result)
    {
    }

    /// With which curves are landed on.
    void solveWith(const Solver& solver)
    {
        solver_ = &solver;
        settings_.tolerance = landingTolerance(options_.tolerance);
        if (solver.capabilities().cancel) {
            settings_.cancel = options_.cancel;
        }
        enterProgram();
    }

    [[nodiscard]] SolverResult land(const Eigen::VectorXd& predicted) override
    {
        for (;;) {
            program_.linear = -2.0 * predicted;
            settings_.start = predicted;
            SolverResult landed = solver_->solve(program_, settings_);
            if (landed.status != SolverStatus::optimal || !section_.addBroken(landed.x)) {
                return landed;
            }
            enterProgram();
        }
    }
    [[nodiscard]] double distance(const Eigen::VectorXd& x, const Eigen::VectorXd& y) const override
    {
        return (x - y).norm() / std::sqrt(result_.unit);
    }

    [[nodiscard]] bool keep(const Eigen::VectorXd& x) override
    {
        const double step = result_.points.empty() ? 0.0 : distance(last_, x);
        return keepAt(reached() + step, x);
    }
    [[nodiscard]] bool keepAt(double lambda, const Eigen::VectorXd& x)
    {
        if (!result_.points.empty()) {
            longest_ = std::max(longest_, distance(last_, x));
        }
        last_ = x;
        isInside_ = isInside_ || isStrict(x);
        return keepAt(lambda, section_.motionOf(x));
    }
    [[nodiscard]] bool keepAt(double lambda, NetworkClaim motion)
    {
        NetworkCurvePoint point{lambda, std::move(motion)};
        const double off = measure(point);
        const std::size_t number = result_.points.size() + 1;
        if (!(off <= options_.tolerance)) {
            stop(
                fmt::format("point {} at lambda = {} has a residual of {:.3g}, more than the "
                            "tolerance {:.3g}",
                            number, lambda, off, options_.tolerance));
            return false;
        }
        result_.points.push_back(std::move(point));
        if (options_.progress) {
            options_.progress(static_cast<double>(number), static_cast<double>(options_.points));
        }
        return true;
    }

    void restart() override
    {
        result_.points.clear();
        longest_ = 0.0;
    }
    [[nodiscard]] double reached() const override
    {
        return result_.points.empty() ? 0.0 : result_.points.back().lambda;
    }
    [[nodiscard]] bool isCancelled() override
    {
        if (!isRequested(options_.cancel)) {
            return false;
        }
        stop(fmt::format("interrupted after {} of {} points", result_.points.size(),
                         options_.points));
        return true;
    }
    void stop(std::string why) override
    {
        result_.status = Status::undecided;
        result_.detail = std::move(why);
    }
    void finish() override
    {
        result_.status = Status::found;
        result_.detail.clear();
        if (result_.parameter == Parameter::arcLength && result_.points.size() > 1) {
            result_.resolution = longest_ / norm();
        }
        if (isInside_ && section_.isClear()) {
            result_.dimension = section_.unknowns() - 1;
        }
    }
    [[nodiscard]] bool isFinished() const override { return result_.status == Status::found; }
    /// Of all motions.
    [[nodiscard]] double norm() const { return section_.norm() / std::sqrt(result_.unit); }

    /// Fills in what is recomputed. How far is it from a motion of this energy?
    double measure(NetworkCurvePoint& point) const
    {
        point.residuals = walk(network_, point.motion);
        point.energy = energyOf(network_, point.motion.waves);
        return std::max({point.residuals.worst(), std::abs(point.energy / result_.energy - 1.0),
                         strainExcess(network_, point.motion, point.residuals.extremes)});
    }

private:
    void enterProgram()
    {
        program_ = emptyProgram(section_.unknowns());
        program_.quadratic = Eigen::VectorXd::Constant(section_.unknowns(), 2.0);
        program_.inequalities = (-section_.rows()).sparseView();
        program_.inequalityRhs = -section_.rhs();
        program_.energy = EnergyEquality{Eigen::VectorXd::Ones(section_.unknowns()),
                                         section_.radius() * section_.radius()};
    }

    /// Does it meet all rows with room to spare?
    [[nodiscard]] bool isStrict(const Eigen::VectorXd& x) const
    {
        constexpr double clear = 1e-6;
        const Eigen::ArrayXd room = (section_.rows() * x - section_.rhs()).array();
        return (room > clear * section_.norm() * section_.rows().rowwise().norm().array()).all();
    }

    const Network& network_;
    NetworkSection& section_;
    const NetworkCurveOptions& options_;
    NetworkContinuum& result_;
    const Solver* solver_ = nullptr;
    SolverOptions settings_;
    Program program_;
    Eigen::VectorXd last_;
    double longest_ = 0.0;
    bool isInside_ = false;
};

/// One call.
class NetworkTracing {
public:
    NetworkTracing(const Network& network, const std::vector<ContactSpan>& schedule, double energy,
                   const NetworkCurveOptions& options)
        : network_(network), schedule_(schedule), options_(options)
    {
        result_.energy = energy;
        result_.unit = firstEnergy(network).value_or(energy);
    }

    NetworkContinuum run()
    {
        const bool isFound = findMember();
        if (!isFound && !options_.from) {
            return std::move(result_);
        }
        NetworkSection section(network_, schedule_, result_.energy);
        if (!section.isWithinReach()) {
            result_.detail = "the kernel of W - 1 is out of reach";
            return std::move(result_);
        }
        SectionCurve curve(network_, section, options_, result_);
        requireMotion("from", options_.from, section, curve);
        requireMotion("to", options_.to, section, curve);
        const Eigen::VectorXd start =
            section.unknownsOf(options_.from ? *options_.from : member_.waves);
        if (section.unknowns() < 2) {
            listIsolated(section, curve, start);
        } else if (result_.known.provedEnergy >= result_.energy * (1.0 - options_.tolerance)) {
            keepLeast(section, curve);
        } else if (options_.isSample) {
            sample(section, curve, start);
        } else {
            const auto solver =
                makeSolver(options_.solver == automaticChoice ? choose(continuumNeeds)
                                                              : findBackend(options_.solver));
            result_.solver = solver->name();
            curve.solveWith(*solver);
            trace(section, curve, start);
        }
        return std::move(result_);
    }

private:
    /// Is there a motion of this energy? It is a first member, unless one is given.
    bool findMember()
    {
        FindOptions find;
        find.tolerance = options_.tolerance;
        find.cancel = options_.cancel;
        NetworkWish wish;
        if (!options_.from) {
            wish.energy = result_.energy;
        }
        result_.known = wishedMotion(
            network_, schedule_,
            std::max(hugeEnergyRatio * usualEnergy(network_, schedule_), 2.0 * result_.energy),
            wish, find);
        if (!result_.known.motion) {
            result_.status = result_.known.status;
            result_.detail = result_.status == Status::none
                                 ? "every motion of the schedule has more energy"
                                 : result_.known.detail;
            if (result_.status == Status::none && result_.known.isEmpty) {
                result_.detail = "no motion follows the schedule";
            }
            return false;
        }
        member_ = *result_.known.motion;
        return true;
    }

    /// An end that a user gave is one of this schedule, energy and limit.
    void requireMotion(const char* field, const std::optional<std::vector<double>>& waves,
                       const NetworkSection& section, const SectionCurve& curve) const
    {
        if (!waves) {
            return;
        }
        NetworkCurvePoint point{0.0, section.motionOf(*waves)};
        const double off = curve.measure(point);
        if (!(off <= options_.tolerance)) {
            throw std::invalid_argument(fmt::format(
                "{} = a state of {:.9g} times the energy, residual {:.3g}, is out of range: "
                "allowed motions of this schedule, energy and limit on strain, to {:.3g}",
                field, point.energy / result_.energy, off, options_.tolerance));
        }
    }

    /// In a convex set points x are at most √(|x|² - |x*|²) from that of least norm, x*.
    void keepLeast(const NetworkSection& section, SectionCurve& curve)
    {
        result_.parameter = Parameter::number;
        result_.family = "the motion of least energy";
        if (curve.keepAt(1.0, options_.from ? section.motionOf(*options_.from) : member_)) {
            curve.finish();
            const double above = std::max(0.0, 1.0 - result_.known.provedEnergy / result_.energy);
            result_.detail = fmt::format(
                "the energy is the least there is, to within the tolerance: no two motions of it "
                "are more than {:.2g} √E apart",
                2.0 * std::sqrt(above));
        }
    }

    /// No unknown is left, or one that can be of two values. That rests on ranks which nothing else
    /// checked, so it is a note and no claim.
    void listIsolated(const NetworkSection& section, SectionCurve& curve,
                      const Eigen::VectorXd& start)
    {
        constexpr const char* finite =
            "as far as rounding tells only finitely many motions have this energy, and no curve "
            "joins two";
        result_.parameter = Parameter::number;
        result_.family = "isolated motions";
        if (options_.to && curve.distance(start, section.unknownsOf(*options_.to)) >
                               options_.tolerance * curve.norm()) {
            result_.detail = finite;
            return;
        }
        if (!curve.keepAt(1.0, options_.from ? section.motionOf(*options_.from) : member_)) {
            return;
        }
        if (!options_.from && section.unknowns() == 1) {
            NetworkCurvePoint other{2.0, section.motionOf(Eigen::VectorXd(-start))};
            if (curve.measure(other) <= options_.tolerance) {
                result_.points.push_back(std::move(other));
            }
        }
        curve.finish();
        result_.detail = finite;
        if (section.isClear()) {
            result_.dimension = 0;
        }
    }

    void sample(NetworkSection& section, SectionCurve& curve, const Eigen::VectorXd& start)
    {
        result_.parameter = Parameter::number;
        result_.family = "members drawn evenly";
        const auto moves = static_cast<int>(std::clamp<Eigen::Index>(section.unknowns(), 20, 200));
        GreatCircles circles(start, options_.seed);
        for (std::int64_t k = 1; k <= options_.points; ++k) {
            Eigen::VectorXd drawn;
            do {
                GreatCircles before = circles;
                drawn = circles.next(section, moves);
                if (!section.addBroken(drawn)) {
                    break;
                }
                circles = before;  // under the rows that are known now
            } while (!curve.isCancelled());
            if (curve.isCancelled() || !curve.keepAt(static_cast<double>(k), drawn)) {
                return;
            }
        }
        curve.finish();
    }

    void trace(NetworkSection& section, SectionCurve& curve, const Eigen::VectorXd& start)
    {
        const MarchOptions march{options_.points, options_.resolution, options_.tolerance,
                                 curve.norm()};
        if (options_.direction) {
            result_.family = "walk in a given direction";
            walkAlong(section, curve, start);
        } else if (options_.to) {
            result_.family = "path between two given motions";
            marchTo(curve, march, start, section.unknownsOf(*options_.to));
            if (curve.isFinished()) {
                result_.connected = true;
            }
        } else {
            result_.family = "path between two members";
            joinMembers(curve, march, start, options_.seed);
        }
    }

    /// Half a turn of the sphere: each step along the great circle of the direction, which is
    /// carried along, to the motion nearest to it.
    void walkAlong(const NetworkSection& section, SectionCurve& curve, Eigen::VectorXd t)
    {
        const auto turnedFrom = [](const Eigen::VectorXd& way, const Eigen::VectorXd& at) {
            return Eigen::VectorXd(way - way.dot(at) / at.squaredNorm() * at);
        };
        Eigen::VectorXd way =
            turnedFrom(section.unknownsOf(*options_.direction) -
                           section.unknownsOf(std::vector<double>(network_.waves(), 0.0)),
                       t);
        if (!(way.norm() > options_.tolerance * section.norm())) {
            throw std::invalid_argument(
                "direction = one that leads to no other motion is out of range: allowed states "
                "with a part along the set");
        }
        const double step = std::numbers::pi / static_cast<double>(options_.points - 1);
        const double length = step * section.radius() * curve.norm() / section.norm();
        for (std::int64_t k = 0; !curve.isCancelled() && curve.keep(t); ++k) {
            if (k + 1 == options_.points) {
                curve.finish();
                return;
            }
            way *= section.radius() / way.norm();
            SolverResult landed = curve.land(std::cos(step) * t + std::sin(step) * way);
            if (landed.status != SolverStatus::optimal) {
                curve.stop(fmt::format("point {}: {}", k + 2, landed.detail));
                return;
            }
            const double moved = curve.distance(t, landed.x);
            if (moved < 1e-3 * length) {
                curve.finish();
                result_.detail = "the direction ends in a corner of the set";
                return;
            }
            if (moved > 1.5 * length) {
                curve.stop(fmt::format("the walk jumped by {:.3g} √E after lambda = {:.6g}",
                                       moved / curve.norm(), curve.reached()));
                return;
            }
            way = turnedFrom(std::cos(step) * way - std::sin(step) * t, landed.x);
            t = std::move(landed.x);
        }
    }

    const Network& network_;
    const std::vector<ContactSpan>& schedule_;
    const NetworkCurveOptions& options_;
    NetworkContinuum result_;
    NetworkClaim member_;
};

}  // namespace

NetworkContinuum traceContinuum(const Network& network, const std::vector<ContactSpan>& schedule,
                                double energy, const NetworkCurveOptions& options)
{
    validate(network, energy, options);
    return NetworkTracing(network, schedule, energy, options).run();
}

std::size_t pointAt(const NetworkContinuum& curve, double lambda)
{
    const std::vector<double> lambdas = lambdasOf(curve.points);
    requireWithin(lambda, lambdas);
    return nearestTo(lambda, lambdas);
}

}  // namespace signorini
