#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>

#include "bare.hpp"
#include "formulation.hpp"
#include "judge.hpp"
#include "signorini/find_periodic.hpp"
#include "signorini/one_phase_set.hpp"
#include "solving.hpp"
#include "suites.hpp"
#include "timing.hpp"

namespace signorini::bench {

namespace {

class Extremes {
public:
    explicit Extremes(Extent extent) : isFull_(extent == Extent::full) {}

    std::vector<Case> build()
    {
        addMainBranch();
        addNearlyHeld();
        addSizes();
        addNeighbours();
        addGrazing();
        addTightLimits();
        addEndsOfEnergy();
        addUnits();
        addMarch();
        return std::move(cases_);
    }

private:
    static constexpr const char* suite = "extremes";

    void addOurs(const Problem& problem, const std::string& what)
    {
        cases_.push_back(libraryCase({suite, "", what}, problem, usualTolerance));
    }

    void addRivals(const Problem& problem, const std::string& what,
                   const std::vector<std::string_view>& backEnds,
                   const std::vector<const char*>& forms, double tolerance = usualTolerance)
    {
        for (const std::string_view backEnd : backEnds) {
            for (const char* form : forms) {
                cases_.push_back(programCase({suite, "", what}, problem, backEnd, form, tolerance));
            }
        }
    }

    /// n_c -> N: E_min/E_1 = (N/(N - n_c))^2 = N^2.
    void addMainBranch()
    {
        for (const std::int64_t cells : isFull_ ? std::vector<std::int64_t>{30, 300, 3000, 100'000}
                                                : std::vector<std::int64_t>{30, 100'000}) {
            const auto n = static_cast<double>(cells);
            const Problem any{
                .name = fmt::format("n_c = N - 1: E_min = {:g} E_1 N={}", n * n, cells),
                .schedule = {cells, {{cells - 1, 2 * cells + 2}}},
                .exists = true};
            const Problem least = leastEnergyOf(any, n * n);
            addOurs(least, "least energy");
            if (cells <= 3000) {
                addRivals(any, "any", linearBackEnds(), {"sy", "ky", "lumped"});
                addRivals(least, "least energy", quadraticBackEnds(), {"sy", "ky", "lumped"});
            } else if (isFull_) {
                addRivals(any, "any", {"glpk-simplex", "clp-simplex"}, {"sy", "lumped"});
                addRivals(least, "least energy", {"ipopt"}, {"sy", "lumped"});
            } else {
                addRivals(any, "any", {"glpk-simplex", "clp-simplex"}, {"lumped"});
            }
        }
    }

    /// The same with room to search: G = N/30 amplitudes, E_min/E_1 = 900 whatever N.
    void addNearlyHeld()
    {
        for (const std::int64_t cells :
             isFull_ ? std::vector<std::int64_t>{300, 3000} : std::vector<std::int64_t>{60}) {
            const std::int64_t contact = 29 * cells / 30;
            const Problem any{.name = fmt::format("n_c = 29 N/30: E_min = 900 E_1 N={}", cells),
                              .schedule = {cells, {{contact, 4 * cells - 2 * contact}}},
                              .exists = true};
            const Problem least = leastEnergyOf(any, 900.0);
            addOurs(least, "least energy");
            addRivals(any, "any", linearBackEnds(), {"sy", "ky", "reduced"});
            addRivals(least, "least energy", quadraticBackEnds(), {"sy", "ky", "reduced"});
        }
    }

    /// From one cell to ten million, from short flights to 2^61 steps.
    void addSizes()
    {
        const Problem one{.name = "one cell 1:3", .schedule = {1, {{1, 3}}}, .exists = true};
        addOurs(leastEnergyOf(one, 2.0), "least energy");
        addRivals(one, "any", linearBackEnds(), {"sy", "ky"});
        const std::int64_t many = isFull_ ? 10'000'000 : 100'000;
        addOurs(leastEnergyOf(familyA(many), 4.0), "least energy");
        addOurs(familyC(many), "any");
        for (const std::int64_t turns : {std::int64_t{1'000'000}, std::int64_t{1} << 49}) {
            // Whole free oscillations more: only motions that graze stand them, and all of those.
            Problem problem = familyB(1000);
            problem.schedule.phases.front().free += 4000 * turns;
            problem.name = fmt::format("flight of {:.2g} steps N=1000",
                                       static_cast<double>(problem.schedule.phases[0].free));
            addOurs(leastEnergyOf(problem, 4.0 / 3.0), "least energy");
            addRivals(problem, "any", {"glpk-simplex", "clp-simplex"}, {"reduced", "lumped"});
        }
        const std::int64_t unit = isFull_ ? 125'000 : 1'250;
        Problem phases{
            .name = fmt::format("three phases N={}", 8 * unit),
            .schedule = {8 * unit, {{2 * unit, 24 * unit}, {unit, 26 * unit}, {unit, 2 * unit}}},
            .exists = true};
        addOurs(phases, "any");
        addRivals(phases, "any", {"glpk-simplex", "clp-simplex"}, {"lumped"});
    }

    /// Feasible, or infeasible, by one step only: neighbours of the paper's case.
    void addNeighbours()
    {
        for (const auto& [contact, free] :
             {std::pair{150, 899}, {150, 901}, {149, 900}, {151, 900}, {149, 902}, {151, 898}}) {
            Problem problem{.name = fmt::format("one step off: {}:{} N=300", contact, free),
                            .schedule = {300, {{contact, free}}}};
            problem.exists = !onePhaseSet(problem.schedule).reason;
            addOurs(problem, "any");
            if (isFull_ || contact == 150) {
                addRivals(problem, "any", linearBackEnds(),
                          isFull_ ? std::vector<const char*>{"sy", "ky"}
                                  : std::vector<const char*>{"ky"});
            }
        }
    }

    /// A box of 2N - 1 amplitudes: E_min/E_1 = 2N/(2N - 1).
    void addGrazing()
    {
        const std::int64_t cells = isFull_ ? 300 : 30;
        const Problem any{.name = fmt::format("grazing d = 2N - 1 N={}", cells),
                          .schedule = {cells, {{1, 4 * cells - 1}}},
                          .exists = true};
        const auto d = static_cast<double>(2 * cells - 1);
        const Problem least = leastEnergyOf(any, (d + 1.0) / d);
        addOurs(least, "least energy");
        addRivals(any, "any", linearBackEnds(), {"sy", "ky", "reduced"});
        addRivals(least, "least energy", quadraticBackEnds(), {"sy", "ky", "reduced"});
    }

    /// A strain limit that the motion of least strain meets, or misses, by a small share.
    void addTightLimits()
    {
        const Problem base = familyA(isFull_ ? 100 : 30);
        const double least =
            extremesOf(leastEnergyMotion(onePhaseSet(base.schedule)), base.schedule)
                .peakCompression;
        for (const double margin : {1e-3, 1e-6, 1e-9}) {
            for (const bool exists : {true, false}) {
                Problem problem = base;
                problem.name = fmt::format("strain limit {} by {:g}: {}", exists ? "met" : "missed",
                                           margin, base.name);
                problem.exists = exists;
                problem.demands.strainLimit = least * (exists ? 1.0 + margin : 1.0 - margin);
                const double tolerance = std::min(usualTolerance, 0.01 * margin);
                cases_.push_back(libraryCase({suite, "", "any"}, problem, tolerance));
                addRivals(problem, "any", linearBackEnds(), {"reduced", "lumped"}, tolerance);
            }
        }
    }

    /// E held at an end of its range, and beyond it by one unit in the last place.
    void addEndsOfEnergy()
    {
        const Problem base = familyA(30);
        const EnergyRange range = energyRange(onePhaseSet(base.schedule));
        const auto add = [&](const char* where, double energy, bool exists, bool withRivals) {
            Problem problem = withEnergy(base, energy);
            problem.name = fmt::format("energy {}: {}", where, base.name);
            problem.exists = exists;
            addOurs(problem, "energy");
            if (withRivals) {
                addRivals(problem, "energy", energyBackEnds(), {"sy", "ky", "reduced"});
            }
        };
        add("at E_min", range.least, true, true);
        // Nearer than the tolerance the end itself is the answer.
        add("just below E_min", range.least * (1.0 - 1e-5), false, false);
        add("2 % below E_min", 0.98 * range.least, false, true);
        add("at E_max", range.most, true, true);
        add("just above E_max", range.most * (1.0 + 1e-5), false, false);
        add("2 % above E_max", 1.02 * range.most, false, true);
    }

    /// (31) as it stands in SI units, by the libraries alone and through our interface.
    void addUnits()
    {
        const auto add = [this](std::string_view library, bool isBare, const char* form) {
            const Ask ask{std::string(library), form, isBare};
            Record record = identified(suite, "every schedule of a steel bar with g = 1e-6 m",
                                       (isBare ? "bare " : "") + ask.library, form,
                                       isBare ? "library alone" : "through signorini");
            cases_.push_back({record, "", [ask, cells = isFull_ ? 6 : 3](Record& row) {
                                  sweepSchedules(ask, cells, row);
                              }});
            record.problem = "c from 1e-6 to 1e9 m/s and g from 1e-12 to 1e3 m: A and C N=12";
            cases_.push_back({record, "", [ask](Record& row) { sweepUnits(ask, row); }});
        };
        for (const std::string_view library : bareLibraries()) {
            for (const char* form : {"sy", "ky"}) {
                add(library, true, form);
                add(library, false, form);
            }
        }
        cases_.push_back(
            {identified(suite, "bars with c from 1e-6 to 1e9 m/s and g from 1e-12 to 1e3 m",
                        "signorini", "auto", "least energy"),
             "", sweepBars});
    }

    /// Whom, and in which form.
    struct Ask {
        std::string library;
        std::string form;
        bool isBare;
    };

    /// What a sweep saw.
    struct Sweep {
        int checked = 0;
        int wrong = 0;
        int undecided = 0;
        double worst = 0.0;  ///< error of the points that were claimed
    };

    /// One verdict in the units of the paper: dx/sqrt(c^2 + 1) sum(b - a) = g.
    static void check(const Problem& problem, const Ask& ask, double speed, double gap,
                      Sweep& sweep)
    {
        Formulated formulated = poseForm(problem.schedule, problem.demands, ask.form);
        Program& program = formulated.program;
        const auto cells = static_cast<double>(problem.schedule.cells);
        const double root = std::hypot(speed, 1.0);
        for (int row = 0; row < program.equalities.rows(); ++row) {
            if (program.equalityRhs[row] != 0.0) {
                program.equalities.row(row) *= 1.0 / (cells * root);
                program.equalityRhs[row] *= gap / cells;
            }
        }
        SolverStatus status = SolverStatus::notRun;
        Eigen::VectorXd x;
        if (ask.isBare) {
            BareAnswer answer = solveBare(ask.library, program);
            status = answer.status;
            x = std::move(answer.x);
        } else {
            SolverResult result = makeRival(ask.library)->solve(program);
            status = result.status;
            x = std::move(result.x);
        }
        ++sweep.checked;
        if (status == SolverStatus::infeasible) {
            sweep.wrong += problem.exists ? 1 : 0;
        } else if (status == SolverStatus::optimal) {
            Record judged;
            judgeFound(problem, stateOf(formulated, x / (gap * root)), usualTolerance, judged);
            sweep.worst = std::max(sweep.worst, judged.figure("error"));
            sweep.wrong += judged.outcome == "wrong" ? 1 : 0;
        } else {
            ++sweep.undecided;
        }
    }

    static void recordSweep(const Sweep& sweep, Record& record)
    {
        record.figures["checked"] = sweep.checked;
        record.figures["wrong"] = sweep.wrong;
        record.figures["error"] = sweep.worst;
        record.claim = "found, none";
        record.outcome = sweep.wrong > 0 ? "wrong" : sweep.undecided == 0 ? "right" : "undecided";
        record.detail = fmt::format("{} schedules: {} wrong, {} undecided", sweep.checked,
                                    sweep.wrong, sweep.undecided);
    }

    static void sweepSchedules(const Ask& ask, std::int64_t cells, Record& record)
    {
        Sweep sweep;
        record.figures["cells"] = static_cast<double>(cells);
        for (std::int64_t contact = 1; contact <= 2 * cells; ++contact) {
            for (std::int64_t free = 1; free <= 6 * cells; ++free) {
                Problem problem{.name = "", .schedule = {cells, {{contact, free}}}};
                problem.exists = !onePhaseSet(problem.schedule).reason;
                check(problem, ask, 5188.0, 1e-6, sweep);
            }
        }
        recordSweep(sweep, record);
    }

    static void sweepUnits(const Ask& ask, Record& record)
    {
        Sweep sweep;
        for (int speed = -6; speed <= 9; speed += 3) {
            for (int gap = -12; gap <= 3; gap += 3) {
                for (const Problem& problem : {familyA(12), familyC(12)}) {
                    check(problem, ask, std::pow(10.0, speed), std::pow(10.0, gap), sweep);
                }
            }
        }
        recordSweep(sweep, record);
    }

    static void sweepBars(Record& record)
    {
        Sweep sweep;
        for (int speed = -6; speed <= 9; speed += 3) {
            for (int gap = -12; gap <= 3; gap += 3) {
                const Bar bar{.waveSpeed = std::pow(10.0, speed), .gap = std::pow(10.0, gap)};
                const PeriodicResult found = findPeriodic(150, 900, 300, {.scene = bar});
                const PeriodicResult none = findPeriodic(150, 1200, 300, {.scene = bar});
                const double energy = 2.0 * bar.axialStiffness * bar.gap * bar.gap / bar.length;
                const double error = std::abs(found.motion->energy / energy - 1.0);
                sweep.worst = std::max({sweep.worst, error, found.motion->residuals.worst()});
                sweep.checked += 2;
                sweep.wrong += found.status != Status::found || error > 1e-12 ? 1 : 0;
                sweep.wrong += none.status != Status::none ? 1 : 0;
            }
        }
        recordSweep(sweep, record);
    }

    /// A million periods: steps are signed shifts, so the state is back bit for bit.
    void addMarch()
    {
        const int periods = isFull_ ? 1'000'000 : 10'000;
        const Record record = identified(suite, fmt::format("march of {} periods N=300", periods),
                                         "signorini", "-", "march");
        cases_.push_back({record, "", [periods](Record& row) {
                              const Schedule schedule = familyA(300).schedule;
                              const State state = leastEnergyMotion(onePhaseSet(schedule));
                              March seen;
                              bench::record(
                                  timeOf([&] { seen = march(state, periods * steps(schedule)); }),
                                  row);
                              row.figures["checked"] = periods;
                              row.figures["error"] = seen.residual;
                              row.claim = "found";
                              row.outcome = seen.residual == 0.0 ? "right" : "wrong";
                          }});
    }

    bool isFull_;
    std::vector<Case> cases_;
};

}  // namespace

std::vector<Case> extremesSuite(Extent extent)
{
    return Extremes(extent).build();
}

}  // namespace signorini::bench
