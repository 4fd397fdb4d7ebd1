#include <fmt/format.h>

#include <functional>
#include <limits>
#include <map>
#include <random>

#include "judge.hpp"
#include "signorini/atlas.hpp"
#include "signorini/continuum.hpp"
#include "signorini/find_periodic.hpp"
#include "signorini/lumped_set.hpp"
#include "signorini/verification.hpp"
#include "solving.hpp"
#include "suites.hpp"
#include "timing.hpp"

namespace signorini::bench {

namespace {

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
            isFull_
                ? std::vector<std::int64_t>{300, 1'000, 3'000, 10'000, 30'000, 300'000, 3'000'000}
                : std::vector<std::int64_t>{300, 3'000, 30'000};
        for (const std::int64_t cells : large) {
            addOwn(cells);
        }
        for (const std::int64_t cells :
             isFull_ ? std::vector<std::int64_t>{300, 1'000, 3'000, 10'000, 30'000}
                     : std::vector<std::int64_t>{100, 300}) {
            addContinuum(cells);
        }
        for (const std::int64_t cells :
             isFull_ ? std::vector<std::int64_t>{300, 1'000, 3'000, 10'000, 30'000, 100'000}
                     : std::vector<std::int64_t>{30, 100, 300}) {
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

    /// Every schedule n_c <= 2N, n_f <= 8N: with all rows, and the families up to 50 E_1 alone.
    void addAtlas(std::int64_t cells)
    {
        for (const bool familiesOnly : {false, true}) {
            add(familiesOnly ? "families of an atlas" : "an atlas", cells,
                [familiesOnly](std::int64_t n, Record& row) {
                    AtlasRange range = usualRange(n);
                    range.maxFree = 8 * n;
                    range.familiesOnly = familiesOnly;
                    range.maxEnergyRatio =
                        familiesOnly ? 50.0 : std::numeric_limits<double>::infinity();
                    record(timeOf([&] {
                               const AtlasTally tally = decideAll(range, {});
                               keep(&tally);
                           }),
                           row);
                    row.figures["wrong"] = wrongAmong(range, row);
                    setOutcome(row.figures["wrong"] == 0.0, row);
                });
        }
    }

    /// Decides a range batch by batch, as a database is filled; `see` gets each.
    static AtlasTally decideAll(const AtlasRange& range,
                                const std::function<void(const AtlasBatch&)>& see)
    {
        AtlasTally tally;
        std::vector<std::int8_t> signs;
        for (std::int64_t number = 0; number < batchesOf(range); ++number) {
            const AtlasBatch batch = decideBatch(range, number, signs).value();
            tally += batch.tally;
            if (see) {
                see(batch);
            }
        }
        return tally;
    }

    /// Asks the code for several phases about some 200 schedules drawn from the range, and about
    /// some 200 of those that were found, or tops of families.
    static double wrongAmong(const AtlasRange& range, Record& row)
    {
        constexpr std::int64_t samples = 200;
        std::mt19937_64 generator(1);
        std::map<std::int64_t, bool> drawn;  // number: was it found
        while (static_cast<std::int64_t>(drawn.size()) < samples) {
            drawn[std::uniform_int_distribution<std::int64_t>(0, numbersOf(range) - 1)(generator)];
        }
        double wrong = 0.0;
        const auto exists = [&range](const Phase& phase) {
            return !lumpedSet({range.cells, {phase}}).absence;
        };
        std::int64_t seen = 0;
        std::int64_t families = 0;
        const AtlasTally tally = decideAll(range, [&](const AtlasBatch& batch) {
            for (const AtlasRow& found : batch.rows) {
                if (const auto it = drawn.find(found.number); it != drawn.end()) {
                    it->second = true;
                }
                if (seen++ % (1 + range.cells * 60 / samples) == 0) {
                    wrong += exists(phasesAt(range, found.number).front()) ? 0.0 : 1.0;
                }
            }
            for (const AtlasFamily& all : batch.families) {
                if (families++ % (1 + range.cells * 5 / samples) == 0) {
                    wrong += exists(all.top) ? 0.0 : 1.0;
                }
            }
        });
        for (const auto& [number, isFound] : drawn) {
            const bool isRight = exists(phasesAt(range, number).front()) == isFound;
            wrong += range.familiesOnly || isRight ? 0.0 : 1.0;
        }
        row.figures["checked"] = static_cast<double>(tally.decided);
        row.figures["found"] = static_cast<double>(tally.pressing + tally.grazing);
        row.figures["families"] = static_cast<double>(families);
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
