#include "signorini/find_periodic.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>

#include "energy_bound.hpp"
#include "faults.hpp"
#include "formulation.hpp"
#include "known_motions.hpp"
#include "lumped_proof.hpp"
#include "minimum_error.hpp"
#include "nearest_motion.hpp"
#include "signorini/amplitude_set.hpp"
#include "signorini/lumped_set.hpp"
#include "solver.hpp"
#include "tolerated.hpp"

namespace signorini {

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::string_view closedForm = "closed-form";

double secondsSince(Clock::time_point start)
{
    return std::chrono::duration<double>(Clock::now() - start).count();
}

Demands demandsOf(const FindOptions& options)
{
    return {.objective = options.objective,
            .target = options.target,
            .strainLimit = options.strainLimit / scales(options.bar).strain,
            .tipFloor = options.tipFloor / options.bar.gap,
            .fixed = options.fixed,
            .energyRatio = options.energyRatio};
}

void validate(const Schedule& schedule, const FindOptions& options)
{
    signorini::validate(schedule);
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
    if (!(options.strainLimit > 0.0)) {
        faults.add("strainLimit", options.strainLimit, "> 0");
    }
    if (!(options.tipFloor < options.bar.gap)) {
        faults.add("tipFloor", options.tipFloor, "below the gap [m]");
    }
    if (options.solver != "auto") {
        const Backend& backend = findBackend(options.solver);
        if (!backend.available()) {
            (void)makeSolver(options.solver);  // throws, and says how to get it
        }
    }
    if (options.solver == closedForm) {
        if (schedule.phases.size() != 1) {
            faults.add("phases", schedule.phases.size(), "1 with solver closed-form");
        }
        if (options.formulation == Formulation::state) {
            faults.add("formulation", name(options.formulation),
                       "auto|reduced with solver closed-form");
        }
    }
    faults.throwIfAny();
}

/// One call of findPeriodic on its way to an answer.
class Search {
public:
    Search(const Schedule& schedule, const FindOptions& options)
        : options_(options), demands_(demandsOf(options))
    {
        signorini::validate(demands_, schedule);
        result_.schedule = schedule;
        result_.bar = options.bar;
        result_.period = period(schedule) * scales(options.bar).time;
        result_.frequencyRatio = frequencyRatio(schedule);
    }

    PeriodicResult run()
    {
        const bool mayUseClosedForm =
            options_.solver == closedForm ||
            (options_.solver == "auto" && options_.formulation != Formulation::state);
        if (isOnePhase()) {
            reduce(result_.schedule, reduction_);
            describeSet();
        } else if (!lump()) {
            return std::move(result_);
        }
        if (isOnePhase() && mayUseClosedForm && solveInClosedForm()) {
            return std::move(result_);
        }
        if (lumped_ && mayUseLumpedSet() && solveInSums()) {
            return std::move(result_);
        }
        if (options_.solver == closedForm) {
            setUndecided(
                "the closed form knows no motion that meets these demands, and no proof "
                "that there is none: try solver auto");
            return std::move(result_);
        }
        const bool mayHoldEnergy = lumped_ && mayUseLumpedSet() && demands_.energyRatio &&
                                   std::isfinite(shape_.energy.most);
        if (!mayHoldEnergy || hasAny({"ipopt", "nlopt-auglag"})) {
            solveAsProgram();
        }
        if (mayHoldEnergy && result_.status == Status::undecided) {
            holdEnergyInSums();
        }
        return std::move(result_);
    }

private:
    [[nodiscard]] bool isOnePhase() const { return result_.schedule.phases.size() == 1; }

    /// What the exact reduction says of the schedule as a whole, whichever solver looks for a
    /// motion.
    void describeSet()
    {
        result_.kernelDimension = reduction_.kernelDimension;
        result_.solutionSet = reduction_.set;
        result_.setSummary = {reduction_.set.kind, reduction_.set.dimension()};
        if (!reduction_.reason) {
            result_.energyRange = energyRange(reduction_);
        }
    }

    /// Several phases: finds the sums that decide the schedule and, if their number is within
    /// reach, decides it. False if the schedule is out of reach of every route.
    bool lump()
    {
        const auto start = Clock::now();
        const std::int64_t blocks = blockCount(result_.schedule);
        if (blocks > maxBlocks) {
            setUndecided(fmt::format("a period of {} sign blocks: at most {} are walked", blocks,
                                     maxBlocks));
            return false;
        }
        ClassTypes classes = classTypes(result_.schedule);
        result_.kernelDimension = classes.kernelDimension;
        const std::size_t live = liveTypeCount(classes);
        if (live > maxLiveTypes) {
            if (blocks * static_cast<std::int64_t>(live) > maxBlocks) {
                setUndecided(
                    fmt::format("{} live types on {} sign blocks: exact arithmetic takes "
                                "at most {} types, a program at most {} entries",
                                live, blocks, maxLiveTypes, maxBlocks));
                return false;
            }
            return true;
        }
        try {
            lumped_ = lumpedSetOf(std::move(classes));
        } catch (const std::overflow_error&) {
            return true;  // no proof in 64 bits: a program may find a shorter one
        }
        shape_ = shapeOf(*lumped_);
        result_.setSummary = {shape_.kind, shape_.dimension};
        if (!lumped_->absence) {
            result_.energyRange = shape_.energy;
        }
        result_.solver.seconds = secondsSince(start);
        return true;
    }

    [[nodiscard]] bool mayUseLumpedSet() const
    {
        return options_.solver == "auto" && (options_.formulation == Formulation::automatic ||
                                             options_.formulation == Formulation::lumped);
    }

    /// Answers from the exact sums; false if the request wants another motion than theirs.
    bool solveInSums()
    {
        const auto start = Clock::now();
        if (lumped_->absence) {
            nameLumpedRoute();
            acceptAbsenceOfSums();
            result_.solver.seconds += secondsSince(start);
            return true;
        }
        if (demands_.energyRatio && energyIsOutOfRange()) {
            nameLumpedRoute();
            return true;
        }
        std::optional<State> state = extremeOfSums();
        if (!state || violation(demands_, *state, result_.schedule) > options_.tolerance) {
            return false;
        }
        nameLumpedRoute();
        result_.solver.seconds += secondsSince(start);
        acceptMotion(std::move(*state));
        return true;
    }

    /// Where no solver finds a motion of a held energy: one between the least and the most.
    void holdEnergyInSums()
    {
        State state = motionOfEnergy(equalMotion(*lumped_, lumped_->leastSums),
                                     mostEnergyMotion(*lumped_, shape_), *demands_.energyRatio);
        if (violation(demands_, state, result_.schedule) <= options_.tolerance) {
            nameLumpedRoute();
            acceptMotion(std::move(state));
        }
    }

    /// The motion that the objective asks for, if the sums know it.
    [[nodiscard]] std::optional<State> extremeOfSums() const
    {
        switch (demands_.objective) {
            case Objective::automatic:
            case Objective::any:
            case Objective::minEnergy: {
                State least = equalMotion(*lumped_, lumped_->leastSums);
                const bool isHeldAtMost =
                    demands_.energyRatio && std::isfinite(shape_.energy.most) &&
                    *demands_.energyRatio >= shape_.energy.most * (1.0 - options_.tolerance);
                return isHeldAtMost ? mostEnergyMotion(*lumped_, shape_) : least;
            }
            case Objective::maxEnergy:
                if (std::isfinite(shape_.energy.most)) {
                    return mostEnergyMotion(*lumped_, shape_);
                }
                return std::nullopt;
            case Objective::nearest:
                return nearestMotion(*lumped_, shape_, *demands_.target);
            default:
                return std::nullopt;
        }
    }

    /// Motions to hold against a solver's claim.
    [[nodiscard]] std::vector<State> knownMotions() const
    {
        std::vector<State> known;
        if (isOnePhase() && !reduction_.reason) {
            known.push_back(leastEnergyMotion(reduction_));
            known.push_back(motionOf(reduction_, mostAmplitudes(reduction_.set)));
        } else if (lumped_ && !lumped_->absence) {
            known.push_back(equalMotion(*lumped_, lumped_->leastSums));
        }
        if (known.empty()) {
            return known;
        }
        if (!isOnePhase() && std::isfinite(shape_.energy.most)) {
            known.push_back(mostEnergyMotion(*lumped_, shape_));
        }
        if (demands_.target) {
            auto nearest = isOnePhase() ? nearestMotion(reduction_, *demands_.target)
                                        : nearestMotion(*lumped_, shape_, *demands_.target);
            if (nearest) {
                known.push_back(std::move(*nearest));
            }
        }
        return known;
    }

    void nameLumpedRoute()
    {
        result_.solver.name = "lumped";
        result_.route = "lumped";
        result_.routeReason = fmt::format(
            "several contact phases: exact, {} sums of amplitudes decide", lumped_->live.size());
        result_.leftOut = {"matrices of (27)-(32): steps are signed shifts",
                           "solver libraries: so few sums are decided in rational arithmetic",
                           "single amplitudes: equal ones reach every sum at least energy",
                           "rows of (32) inside sign blocks: prefix sums are monotone there",
                           "closure of the last flight: periodicity implies it"};
        if (lumped_->classes.schedule != result_.schedule) {
            result_.leftOut.emplace_back(
                "steps beyond 2N in contact and 4N in flight: they repeat");
        }
    }

    void setUndecided(std::string why)
    {
        result_.status = Status::undecided;
        result_.detail = std::move(why);
        result_.state = {};
    }

    /// Accepts a state only if every residual is within the tolerance.
    void acceptMotion(State state)
    {
        Verification verified = verify(state, result_.schedule, options_.tolerance);
        result_.residuals = verified.residuals;
        result_.residuals.demands = violation(demands_, state, result_.schedule);
        if (!(result_.residuals.worst() <= options_.tolerance)) {
            setUndecided(
                fmt::format("{} returned a motion with a residual of {:.3g}, more than the "
                            "tolerance {:.3g}",
                            result_.route, result_.residuals.worst(), options_.tolerance));
            return;
        }
        const Scales unit = scales(options_.bar);
        result_.status = Status::found;
        result_.detail.clear();
        result_.canonical = std::move(verified.canonical);
        result_.repetitions = verified.repetitions;
        result_.pressing = std::move(verified.pressing);
        result_.contact = result_.canonical.empty() ? Contact::grazing : Contact::pressing;
        result_.energyRatio = energyRatio(state);
        result_.energy = result_.energyRatio * unit.energy;
        result_.peakStrain = extremesOf(state, result_.schedule).peakStrain * unit.strain;
        result_.state = std::move(state);
    }

    /// Absence by the closed form: only with a certificate that holds in integers.
    void acceptAbsence()
    {
        FarkasCertificate certificate = proveAbsence(reduction_);
        if (!isProof(certificate, result_.schedule)) {
            setUndecided("the certificate of absence does not hold in 64-bit integers");
            return;
        }
        result_.status = Status::none;
        result_.detail.clear();
        result_.reason = reduction_.reason;
        result_.certificate = std::move(certificate);
    }

    /// Absence by an exact proof over the rows of a program.
    void acceptAbsence(InfeasibilityProof proof, Formulation rows)
    {
        result_.status = Status::none;
        result_.detail.clear();
        result_.reason = reasonOfProgram();
        result_.programProof = std::move(proof);
        result_.proofRows = rows;
    }

    /// Absence by the exact sums.
    void acceptAbsenceOfSums()
    {
        const Program program = formulate(result_.schedule, Formulation::lumped).program;
        InfeasibilityProof proof = proofOf(*lumped_, program);
        if (!isProof(proof, program)) {
            setUndecided("the proof of absence does not hold");
            return;
        }
        acceptAbsence(std::move(proof), Formulation::lumped);
    }

    /// Why a program without solution has none.
    [[nodiscard]] Reason reasonOfProgram() const
    {
        if (isOnePhase()) {
            return reduction_.reason.value_or(Reason::constraints);
        }
        const Reason reason = absenceReason(classTypes(result_.schedule));
        if (reason != Reason::penetration) {
            return reason;
        }
        const bool isEmpty = lumped_ ? lumped_->absence.has_value()
                                     : proofFor(Demands{}, Formulation::lumped).has_value();
        if (demands_.areLimits() && !isEmpty) {
            return Reason::constraints;
        }
        return Reason::penetration;
    }

    /// Tries the closed form; false if it cannot answer the request.
    bool solveInClosedForm()
    {
        result_.solver.name = closedForm;
        result_.route = closedForm;
        result_.routeReason = "one contact phase: exact, and without iteration";
        result_.leftOut = {
            "matrices of (27)-(32): steps are signed shifts",
            "solver libraries: the solution set is known in closed form",
            "all but one row of (32) per sign block: prefix sums are monotone inside"};
        const auto start = Clock::now();
        if (reduction_.schedule != result_.schedule) {
            result_.leftOut.emplace_back(
                "steps beyond 2N in contact and 4N in flight: they repeat");
        }
        if (reduction_.reason) {
            acceptAbsence();
            result_.solver.seconds = secondsSince(start);
            return true;
        }
        if (demands_.energyRatio && energyIsOutOfRange()) {
            return true;
        }
        // Timed as one piece with the verdict, as a user would see it.
        reduce(result_.schedule, reduction_);
        std::optional<State> known = candidate();
        result_.solver.seconds = secondsSince(start);
        if (!known) {
            return false;
        }
        State state = std::move(*known);
        if (violation(demands_, state, result_.schedule) > options_.tolerance) {
            return limitsExcludeAll();
        }
        acceptMotion(std::move(state));
        return true;
    }

    /// Limits on strain and tip are met by equal amplitudes or by none: claims absence if they are
    /// not, with a proof over the lumped rows.
    bool limitsExcludeAll()
    {
        if (!demands_.fixed.empty() || demands_.energyRatio ||
            violation(demands_, leastEnergyMotion(reduction_), result_.schedule) <=
                options_.tolerance) {
            return false;
        }
        auto proof = proofFor(demands_, Formulation::lumped);
        if (!proof) {
            return false;
        }
        acceptAbsence(std::move(*proof), Formulation::lumped);
        return true;
    }

    /// Claims absence if every motion's energy misses the one to hold by more than the tolerance.
    bool energyIsOutOfRange()
    {
        const EnergyRange range = *result_.energyRange;
        const double wanted = *demands_.energyRatio;
        if (!isOutOfRange(wanted, range, options_.tolerance)) {
            return false;
        }
        result_.isRangeVerified =
            wanted < range.least
                ? exceedEnergy(result_.schedule, wanted * (1.0 + options_.tolerance))
                : stayBelowEnergy(result_.schedule, wanted * (1.0 - options_.tolerance));
        result_.status = Status::none;
        result_.detail = fmt::format("E/E_1 = {} is outside the range [{}, {}] of the schedule",
                                     wanted, range.least, range.most);
        result_.reason = Reason::constraints;
        return true;
    }

    /// The motion of the closed form that fits the objective. Equal amplitudes have the least
    /// energy and the least peak strain, and the impulse is the same for all amplitudes.
    /// Empty where rounding spoils it.
    [[nodiscard]] std::optional<State> candidate() const
    {
        if (demands_.objective == Objective::maxEnergy) {
            return motionOf(reduction_, mostAmplitudes(reduction_.set));
        }
        if (demands_.objective == Objective::nearest) {
            return nearestMotion(reduction_, *demands_.target);
        }
        if (demands_.energyRatio) {
            const double squares = *demands_.energyRatio *
                                   static_cast<double>(reduction_.schedule.cells) /
                                   (2.0 * static_cast<double>(reduction_.window));
            // Within the tolerance an energy beyond an end is met by the end.
            return motionOf(reduction_,
                            amplitudesWithSquares(reduction_.set,
                                                  std::clamp(squares, leastSquares(reduction_.set),
                                                             mostSquares(reduction_.set))));
        }
        return leastEnergyMotion(reduction_);
    }

    /// The objective that a program gets: several phases answer with least energy if they can.
    [[nodiscard]] Objective effectiveObjective() const
    {
        const bool least = demands_.objective == Objective::automatic &&
                           options_.solver == "auto" && !demands_.energyRatio &&
                           hasAny({"ipopt", "nlopt-slsqp"});
        return least ? Objective::minEnergy : demands_.objective;
    }

    static bool hasAny(std::initializer_list<std::string_view> names)
    {
        return std::any_of(names.begin(), names.end(), [](std::string_view solver) {
            const auto table = backends();
            return std::any_of(table.begin(), table.end(), [solver](const Backend& backend) {
                return backend.name == solver && backend.available();
            });
        });
    }

    /// The first of the solvers suited to a program that this build contains.
    [[nodiscard]] std::string solverFor(const Program& program) const
    {
        if (options_.solver != "auto") {
            return options_.solver;
        }
        const std::array<std::string_view, 2> candidates =
            program.energy ? std::array<std::string_view, 2>{"ipopt", "nlopt-auglag"}
            : program.quadratic.size() > 0
                ? std::array<std::string_view, 2>{"ipopt", "nlopt-slsqp"}
                : std::array<std::string_view, 2>{"glpk-simplex", "ipopt"};
        for (const std::string_view solver : candidates) {
            if (hasAny({solver})) {
                return std::string(solver);
            }
        }
        throw BackendUnavailable(
            fmt::format("this request needs one of the solvers {}: none is in "
                        "this build",
                        fmt::join(candidates, ", ")));
    }

    /// Why this solver, and why not the closed form.
    [[nodiscard]] std::string reasonForProgram(const Program& program) const
    {
        const char* kind = program.energy                 ? "a nonlinear program (held energy)"
                           : program.quadratic.size() > 0 ? "a quadratic program"
                                                          : "a linear program";
        const char* cause = options_.solver != "auto" ? "as asked for"
                            : !isOnePhase()           ? "several contact phases"
                            : options_.formulation == Formulation::state
                                ? "state asked for"
                                : "demands beyond the closed form";
        if (demands_.objective == Objective::maxEnergy) {
            return fmt::format(
                "{}: a convex maximum, climbed from vertex to vertex: the most found, "
                "not proved the most",
                cause);
        }
        return fmt::format("{}: {}", cause, kind);
    }

    void solveAsProgram()
    {
        const auto start = Clock::now();
        Demands posed = demands_;
        posed.objective = effectiveObjective();
        const Formulation formulation = options_.formulation == Formulation::automatic
                                            ? cheapestFormulation(posed)
                                            : options_.formulation;
        Formulated formulated = pose(result_.schedule, posed, formulation);
        result_.solver.name = solverFor(formulated.program);
        result_.route =
            fmt::format("{} on the {} formulation", result_.solver.name, name(formulation));
        result_.routeReason = reasonForProgram(formulated.program);
        SolverResult answer = solve(formulated, posed);
        if ((answer.status == SolverStatus::infeasible || answer.status == SolverStatus::failed) &&
            (std::isfinite(posed.strainLimit) || std::isfinite(posed.tipFloor))) {
            // A limit that a motion misses by no more than the tolerance is met (tolerated.hpp);
            // a tenth of it is left to the solver.
            formulated =
                pose(result_.schedule, relaxed(posed, 0.9 * options_.tolerance), formulation);
            answer = solve(formulated, posed);
        }
        result_.solver.seconds = secondsSince(start);
        result_.solver.iterations = answer.iterations;
        result_.leftOut = formulated.leftOut;
        if (answer.status == SolverStatus::optimal) {
            State state = stateOf(formulated, answer.x);
            if (holdsAgainstKnown(state, posed) && isNearMinimum(formulated.program, answer.x)) {
                acceptMotion(std::move(state));
            }
            return;
        }
        if (answer.status == SolverStatus::infeasible || answer.status == SolverStatus::failed) {
            if (provesAbsence(formulation)) {
                return;
            }
        }
        setUndecided(fmt::format("{}: {}; no exact proof of absence was found either{}",
                                 result_.solver.name, answer.detail,
                                 knowsMotion() ? ", and there is none: solver auto knows a motion "
                                                 "that meets the demands"
                                               : ""));
    }

    /// A solver says that there is no motion: claims absence if that is proved.
    bool provesAbsence(Formulation formulation)
    {
        if (isOnePhase() && reduction_.reason) {
            acceptAbsence();
            return true;
        }
        if (lumped_ && lumped_->absence) {
            acceptAbsenceOfSums();
            return true;
        }
        if (demands_.energyRatio && result_.energyRange && energyIsOutOfRange()) {
            return true;
        }
        if (knowsMotion()) {
            return false;  // no proof to be looked for
        }
        auto proof = proofFor(demands_, formulation);
        if (proof) {
            acceptAbsence(std::move(*proof), formulation);
        }
        return proof.has_value();
    }

    [[nodiscard]] bool knowsMotion() const
    {
        const std::vector<State> known = knownMotions();
        return std::any_of(known.begin(), known.end(), [this](const State& state) {
            return violation(demands_, state, result_.schedule) <= options_.tolerance;
        });
    }

    /// Local methods stop at motions that are not extreme and call them so: what is known of the
    /// set is held against them.
    bool holdsAgainstKnown(const State& state, const Demands& posed)
    {
        if (posed.objective == Objective::maxEnergy && !posed.areLimits() && result_.energyRange &&
            std::isinf(result_.energyRange->most)) {
            setUndecided("the energies of the schedule have no bound: no motion has the most");
            return false;
        }
        const auto why =
            refutation(posed, result_.schedule, state, knownMotions(), options_.tolerance);
        if (why) {
            setUndecided(fmt::format("{} returned a motion {}", result_.route, *why));
        }
        return !why;
    }

    /// Where no known motion judges the nearest, its distance from the true one is bounded by
    /// linear programming.
    bool isNearMinimum(const Program& program, const Eigen::VectorXd& x)
    {
        if (demands_.objective != Objective::nearest || !hasAny({"glpk-simplex"})) {
            return true;
        }
        const auto error =
            minimumError(program, x, *makeSolver("glpk-simplex"),
                         {.tolerance = options_.tolerance, .timeLimit = options_.timeLimit});
        const bool isNear = error && *error <= std::sqrt(options_.tolerance);
        if (!isNear) {
            setUndecided(fmt::format(
                "{} returned a motion that is not shown to be the nearest: {}", result_.route,
                error ? fmt::format("it may be off by {:.3g} of its size", *error)
                      : std::string("its error could not be bounded")));
        } else {
            result_.routeReason +=
                fmt::format("; amplitudes off by at most {:.2g} of their root mean square", *error);
        }
        return isNear;
    }

    [[nodiscard]] SolverOptions solverOptions(const Solver& solver) const
    {
        return {.tolerance = options_.tolerance,
                .iterationLimit = options_.iterationLimit,
                .timeLimit = options_.timeLimit,
                .cancel = solver.capabilities().cancel ? options_.cancel : Cancel()};
    }

    [[nodiscard]] SolverResult solve(Formulated& formulated, const Demands& posed) const
    {
        const auto solver = makeSolver(result_.solver.name);
        if (posed.objective == Objective::maxEnergy) {
            return climb(formulated, *solver);
        }
        SolverOptions settings = solverOptions(*solver);
        if (posed.energyRatio && solver->capabilities().start) {
            settings.start = startWithEnergy(formulated);
        }
        return solver->solve(formulated.program, settings);
    }

    /// Where to start for a held energy: equal amplitudes, where a solver would otherwise start,
    /// are a stationary point of the energy on the set. This takes them apart, the same way in
    /// every run.
    [[nodiscard]] static Eigen::VectorXd startWithEnergy(const Formulated& formulated)
    {
        const EnergyEquality& energy = *formulated.program.energy;
        Eigen::VectorXd x = Eigen::VectorXd::Zero(formulated.program.variables());
        for (Eigen::Index i = 0; i < x.size(); ++i) {
            const double wave = 1.0 + 0.5 * std::cos(2.4 * static_cast<double>(i));
            x[i] = energy.weights[i] > 0.0 ? wave : 0.0;
        }
        x *= std::sqrt(energy.value / energy.weights.dot(x.cwiseAbs2()));
        return x.cwiseMax(formulated.program.lower).cwiseMin(formulated.program.upper);
    }

    /// Most energy is a convex maximum: from several directions, follow its linearisation from
    /// vertex to vertex while the energy grows. The best vertex found is no proof of the most.
    [[nodiscard]] SolverResult climb(Formulated& formulated, const Solver& solver) const
    {
        constexpr int directions = 8;
        const Eigen::VectorXd weights = energyWeights(formulated);
        const auto energy = [&weights](const Eigen::VectorXd& x) {
            return weights.dot(x.cwiseAbs2());
        };
        SolverResult best;
        for (int k = 0; k < directions; ++k) {
            // Directions spread over the unknowns, the same in every run.
            Eigen::VectorXd& cost = formulated.program.linear;
            for (Eigen::Index i = 0; i < cost.size(); ++i) {
                cost[i] = std::cos(static_cast<double>((i + 1) * (k + 1)));
            }
            double reached = -1.0;
            while (true) {
                SolverResult next = solver.solve(formulated.program, solverOptions(solver));
                if (next.status != SolverStatus::optimal) {
                    return best.status == SolverStatus::optimal ? best : next;
                }
                const double found = energy(next.x);
                if (!(found > reached * (1.0 + 1e-9))) {
                    break;
                }
                reached = found;
                cost = -2.0 * weights.cwiseProduct(next.x);
                if (best.status != SolverStatus::optimal || found > energy(best.x)) {
                    best = std::move(next);
                }
            }
        }
        return best;
    }

    /// An exact proof that no motion meets the linear demands, if one can be had.
    [[nodiscard]] std::optional<InfeasibilityProof> proofFor(const Demands& demands,
                                                             Formulation formulation) const
    {
        const auto simplex =
            hasAny({"glpk-simplex"}) ? makeSolver("glpk-simplex") : std::unique_ptr<Solver>();
        return proveUnmet(result_.schedule, demands, formulation, simplex.get(),
                          {.tolerance = options_.tolerance, .timeLimit = options_.timeLimit});
    }

    const FindOptions& options_;
    Demands demands_;
    PeriodicResult result_;
    Reduction reduction_;              ///< one phase
    std::optional<LumpedSet> lumped_;  ///< several phases, if within its limits
    LumpedShape shape_;                ///< of that set
};

}  // namespace

PeriodicResult findPeriodic(const Schedule& schedule, const FindOptions& options)
{
    validate(schedule, options);
    return Search(schedule, options).run();
}

PeriodicResult findPeriodic(std::int64_t contactSteps, std::int64_t freeSteps, std::int64_t cells,
                            const FindOptions& options)
{
    return findPeriodic(Schedule{cells, {{contactSteps, freeSteps}}}, options);
}

}  // namespace signorini
