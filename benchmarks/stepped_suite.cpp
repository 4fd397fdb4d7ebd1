// Family F: a stepped bar of two halves, impedances 1 and 1.3. There is no closed form; the
// reference is the same motion on two cells, where everything is a handful of numbers.

#include <fmt/format.h>

#include <cmath>

#include "signorini/find_periodic.hpp"
#include "suites.hpp"
#include "timing.hpp"

namespace signorini::bench {

namespace {

constexpr double impedance = 1.3;

std::vector<Segment> halves(std::int64_t cells)
{
    return {{.cells = cells / 2}, {.cells = cells / 2, .impedance = impedance}};
}

PeriodicResult find(std::int64_t cells, const Phase& phase, FindOptions options)
{
    options.scene.segments = halves(cells);
    return findPeriodic({cells, {phase}}, options);
}

/// E/E_1 of the motion of least energy with contact N and flight 3N, the same for every N.
double leastEnergy()
{
    const PeriodicResult coarse = find(2, {2, 6}, {.tolerance = 1e-10});
    return coarse.motion ? coarse.motion->energyRatio : std::nan("");
}

void judge(const PeriodicResult& result, double energy, Record& row)
{
    row.claim = name(result.status);
    row.detail = result.status == Status::undecided ? result.detail : result.how.route;
    if (result.status == Status::undecided) {
        row.outcome = "undecided";
        return;
    }
    if (!result.motion) {
        row.outcome = isProof(result) && std::isnan(energy) ? "right" : "wrong";
        return;
    }
    const Residuals& seen = result.motion->residuals;
    row.figures["periodicity"] = seen.periodicity;
    row.figures["gap"] = seen.gap;
    row.figures["pressure"] = seen.pressure;
    row.figures["penetration"] = seen.penetration;
    row.figures["march"] = seen.march;
    row.figures["energy_ratio"] = result.motion->energyRatio;
    double error = seen.worst();
    if (!std::isnan(energy)) {
        row.figures["energy_error"] = std::abs(result.motion->energyRatio / energy - 1.0);
        error = std::max(error, row.figures["energy_error"]);
    }
    row.figures["error"] = error;
    row.outcome = error < 1e-5 ? "right" : "inaccurate";
}

class Stepped {
public:
    explicit Stepped(Extent extent) : isFull_(extent == Extent::full) {}

    std::vector<Case> build()
    {
        for (const std::int64_t cells : isFull_ ? std::vector<std::int64_t>{8, 30, 100, 300, 1'000}
                                                : std::vector<std::int64_t>{8, 300}) {
            const Phase whole{cells, 3 * cells};
            add("F", cells, whole, {.objective = Objective::any});
            for (const double tolerance : isFull_ ? std::vector<double>{1e-4, 1e-6, 1e-8, 1e-10}
                                                  : std::vector<double>{1e-8}) {
                for (const char* solver : {"ipopt", "nlopt-slsqp"}) {
                    add("F", cells, whole,
                        {.solver = solver,
                         .formulation = Formulation::kernel,
                         .objective = Objective::minEnergy,
                         .tolerance = tolerance});
                }
            }
            // Hardly anything in common with the cells: no blocks to speak of.
            add("F, n + 1", cells, {cells, 3 * cells + 1}, {.objective = Objective::any});
        }
        // What the house promises: N = 300, n = 1050.
        for (const std::int64_t contact : {150, 151, 177}) {
            add("F, n = 7N/2", 300, {contact, 1050 - contact}, {.objective = Objective::any});
            add("F, n = 7N/2", 300, {contact, 1050 - contact}, {});
        }
        return std::move(cases_);
    }

private:
    void add(const char* family, std::int64_t cells, const Phase& phase, const FindOptions& options)
    {
        const std::string setting =
            fmt::format("{}, {:g}", name(options.objective), options.tolerance);
        Record record = identified(
            "stepped", fmt::format("{} N={} ({}, {})", family, cells, phase.contact, phase.free),
            options.solver, std::string(name(options.formulation)), setting);
        record.figures["cells"] = static_cast<double>(cells);
        record.figures["tolerance"] = options.tolerance;
        const bool isKnown = phase.contact == cells && phase.free == 3 * cells &&
                             options.objective == Objective::minEnergy;
        cases_.push_back({record, family, [=](Record& row) {
                              PeriodicResult result;
                              signorini::bench::record(
                                  timeOf([&] { result = find(cells, phase, options); }), row);
                              judge(result, isKnown ? leastEnergy() : std::nan(""), row);
                          }});
    }

    bool isFull_;
    std::vector<Case> cases_;
};

}  // namespace

std::vector<Case> steppedSuite(Extent extent)
{
    return Stepped(extent).build();
}

}  // namespace signorini::bench
