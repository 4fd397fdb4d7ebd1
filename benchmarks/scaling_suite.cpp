#include <fmt/format.h>

#include "judge.hpp"
#include "signorini/continuum.hpp"
#include "signorini/find_periodic.hpp"
#include "signorini/lumped_set.hpp"
#include "signorini/verification.hpp"
#include "solving.hpp"
#include "suites.hpp"
#include "timing.hpp"

namespace signorini::bench {

namespace {

constexpr double usualTolerance = 1e-6;

/// 1/2 + a third: gcd(2N, n) = 1 on family-like grids, the longest walk of a verdict.
Schedule longestWalk(std::int64_t cells)
{
    return {cells, {{cells / 2 + 1, 3 * cells + cells % 2}}};
}

class Scaling {
public:
    explicit Scaling(Extent extent) : isFull_(extent == Extent::full) {}

    std::vector<Case> build()
    {
        const std::vector<std::int64_t> large =
            isFull_ ? std::vector<std::int64_t>{300, 3'000, 30'000, 300'000, 3'000'000}
                    : std::vector<std::int64_t>{300, 3'000, 30'000};
        for (const std::int64_t cells : large) {
            addOwn(cells);
        }
        for (const std::int64_t cells :
             isFull_ ? std::vector<std::int64_t>{300, 1'000, 3'000, 10'000, 30'000}
                     : std::vector<std::int64_t>{100, 300}) {
            addContinuum(cells);
        }
        for (const std::int64_t cells : isFull_ ? std::vector<std::int64_t>{10, 30, 100, 300}
                                                : std::vector<std::int64_t>{10, 30}) {
            addAtlas(cells);
        }
        for (const std::int64_t cells :
             isFull_ ? std::vector<std::int64_t>{100, 300, 1'000, 3'000, 10'000}
                     : std::vector<std::int64_t>{30, 60}) {
            addPrograms(cells);
        }
        return std::move(cases_);
    }

private:
    template <typename Action>
    void add(const std::string& what, std::int64_t cells, Action action)
    {
        Record record =
            identified("scaling", fmt::format("{} N={}", what, cells), "signorini", "-", what);
        record.figures["cells"] = static_cast<double>(cells);
        cases_.push_back({record, what, [cells, action](Record& row) { action(cells, row); }});
    }

    static void setOutcome(bool isRight, Record& row) { row.outcome = isRight ? "right" : "wrong"; }

    void addOwn(std::int64_t cells)
    {
        add("verdict", cells, [](std::int64_t n, Record& row) {
            const Schedule schedule = familyA(n).schedule;
            OnePhaseSet workspace;
            record(timeOf([&] {
                       onePhaseSet(schedule, workspace);
                       keep(&workspace);
                   }),
                   row);
            setOutcome(!workspace.reason && energyRange(workspace).least == 4.0, row);
        });
        add("longest verdict", cells, [](std::int64_t n, Record& row) {
            const Schedule schedule = longestWalk(n);
            OnePhaseSet workspace;
            record(timeOf([&] {
                       onePhaseSet(schedule, workspace);
                       keep(&workspace);
                   }),
                   row);
            row.figures["checked"] = static_cast<double>(workspace.members);
            // Right if the motion holds, or the proof does.
            setOutcome(
                workspace.reason
                    ? isProof(proveAbsence(workspace), schedule)
                    : verify(leastEnergyMotion(workspace), schedule).residuals.worst() < 1e-9,
                row);
        });
        add("verdict and state", cells, [](std::int64_t n, Record& row) {
            const Schedule schedule = familyA(n).schedule;
            OnePhaseSet workspace;
            State state;
            record(timeOf([&] {
                       onePhaseSet(schedule, workspace);
                       state = leastEnergyMotion(workspace);
                       keep(state.a.data());
                   }),
                   row);
            judgeFound(leastEnergyOf(familyA(n), 4.0), state, usualTolerance, row);
        });
        add("writing 2N doubles", cells, [](std::int64_t n, Record& row) {
            record(timeOf([&] {
                       const Eigen::VectorXd a = Eigen::VectorXd::Constant(n, 1.0);
                       const Eigen::VectorXd b = Eigen::VectorXd::Constant(n, -1.0);
                       keep(a.data());
                       keep(b.data());
                   }),
                   row);
            row.outcome = "reference";
        });
        add("verification", cells, [](std::int64_t n, Record& row) {
            const Schedule schedule = familyA(n).schedule;
            const State state = leastEnergyMotion(onePhaseSet(schedule));
            Verification seen;
            record(timeOf([&] { seen = verify(state, schedule); }), row);
            setOutcome(seen.residuals.worst() < 1e-12, row);
        });
        add("findPeriodic in full", cells, [](std::int64_t n, Record& row) {
            PeriodicResult result;
            record(timeOf([&] { result = findPeriodic(familyA(n).schedule); }), row);
            judgeFound(leastEnergyOf(familyA(n), 4.0), result.motion->state, usualTolerance, row);
        });
        if (cells % 300 == 0) {
            add("verdict on three phases", cells, [](std::int64_t n, Record& row) {
                const std::int64_t unit = n / 12;
                const Schedule schedule{
                    8 * unit, {{2 * unit, 24 * unit}, {unit, 26 * unit}, {unit, 2 * unit}}};
                bool exists = false;
                record(timeOf([&] { exists = !lumpedSet(schedule).absence; }), row);
                row.figures["cells"] = static_cast<double>(8 * unit);
                setOutcome(exists && findPeriodic(schedule).motion->residuals.worst() < 1e-9, row);
            });
        }
    }

    void addContinuum(std::int64_t cells)
    {
        add("a point of a continuum", cells, [](std::int64_t n, Record& row) {
            constexpr std::int64_t points = 21;
            Continuum curve;
            Timing timing = timeOf(
                [&] { curve = traceContinuum(familyA(n).schedule, 20.0, {.points = points}); });
            timing.median /= points;
            timing.best /= points;
            record(timing, row);
            double worst = 0.0;
            for (const ContinuumPoint& point : curve.points) {
                worst = std::max({worst, verify(point.state, familyA(n).schedule).residuals.worst(),
                                  std::abs(energyRatio(point.state) / 20.0 - 1.0)});
            }
            row.figures["checked"] = static_cast<double>(curve.points.size());
            row.figures["error"] = worst;
            setOutcome(curve.status == Status::found && worst < 1e-9, row);
        });
    }

    /// Every schedule n_c <= 2N, n_f <= 6N, one `decide` each.
    void addAtlas(std::int64_t cells)
    {
        add("a schedule of an atlas", cells, [](std::int64_t n, Record& row) {
            const auto total = static_cast<double>(2 * n * 6 * n);
            std::vector<bool> exists;
            Timing timing = timeOf([&] { exists = decideAll(n); });
            timing.median /= total;
            timing.best /= total;
            record(timing, row);
            row.figures["checked"] = total;
            row.figures["wrong"] = wrongAmong(exists, n);
            setOutcome(row.figures["wrong"] == 0.0, row);
        });
    }

    static std::vector<bool> decideAll(std::int64_t cells)
    {
        std::vector<bool> exists;
        std::vector<std::int8_t> signs;
        for (std::int64_t contact = 1; contact <= 2 * cells; ++contact) {
            for (std::int64_t free = 1; free <= 6 * cells; ++free) {
                exists.push_back(!decide(cells, {contact, free}, signs).reason);
            }
        }
        return exists;
    }

    /// Asks the code for several phases about some 500 of the verdicts.
    static double wrongAmong(const std::vector<bool>& exists, std::int64_t cells)
    {
        double wrong = 0.0;
        const std::size_t stride = 1 + exists.size() / 500;
        for (std::size_t k = 0; k < exists.size(); k += stride) {
            const auto index = static_cast<std::int64_t>(k);
            const Schedule schedule{cells, {{1 + index / (6 * cells), 1 + index % (6 * cells)}}};
            wrong += !lumpedSet(schedule).absence == exists[k] ? 0.0 : 1.0;
        }
        return wrong;
    }

    void addPrograms(std::int64_t cells)
    {
        const CaseName name{"scaling", "program", "any"};
        const Problem any = familyA(cells);
        for (const char* solver : {"glpk-simplex", "clp-simplex"}) {
            for (const char* form : {"lumped", "reduced", "ky", "sy", "sd"}) {
                cases_.push_back(programCase(name, any, solver, form, usualTolerance));
            }
        }
        const CaseName least{"scaling", "least energy", "least energy"};
        for (const char* form : {"reduced", "sy"}) {
            cases_.push_back(
                programCase(least, leastEnergyOf(any, 4.0), "ipopt", form, usualTolerance));
        }
    }

    bool isFull_;
    std::vector<Case> cases_;
};

}  // namespace

std::vector<Case> scalingSuite(Extent extent)
{
    return Scaling(extent).build();
}

}  // namespace signorini::bench
