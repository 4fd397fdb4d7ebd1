#include <fmt/format.h>

#include <Eigen/SVD>
#include <algorithm>
#include <cmath>

#include "common/stopwatch.hpp"
#include "equations.hpp"
#include "judge.hpp"
#include "siconos.hpp"
#include "signorini/motion.hpp"
#include "signorini/one_phase_set.hpp"
#include "solving.hpp"
#include "suites.hpp"
#include "timing.hpp"

namespace signorini::bench {

namespace {

/// The first step of the paper: a null space of the dense W - 1.
void findNullSpace(std::int64_t cells, Record& record)
{
    const Schedule schedule = familyA(cells).schedule;
    const Eigen::MatrixXd matrix =
        Eigen::MatrixXd(periodMap(schedule)) - Eigen::MatrixXd::Identity(2 * cells, 2 * cells);
    Eigen::Index dimension = 0;
    bench::record(timeOf([&] {
                      const Eigen::BDCSVD<Eigen::MatrixXd> svd(matrix, Eigen::ComputeFullV);
                      dimension = 2 * cells - svd.rank();
                  }),
                  record);
    const std::int64_t exact = onePhaseSet(schedule).kernelDimension;
    record.figures["checked"] = static_cast<double>(exact);
    record.figures["wrong"] = std::abs(static_cast<double>(dimension - exact));
    record.claim = "found";
    record.outcome = dimension == exact ? "right" : "wrong";
    record.detail = fmt::format("null space of {} dimensions, no motion yet", dimension);
}

/// The exact displacement of the tip at any time: linear between the steps of our grid.
class ExactTip {
public:
    ExactTip(const State& state, const Schedule& schedule) : motion_(state, schedule) {}

    [[nodiscard]] double at(double time) const
    {
        const double steps = static_cast<double>(motion_.steps());
        const double m = std::fmod(time * static_cast<double>(motion_.cells()), steps);
        const auto before = static_cast<std::int64_t>(m);
        const double share = m - static_cast<double>(before);
        return (1.0 - share) * motion_.displacement(motion_.cells(), before) +
               share * motion_.displacement(motion_.cells(),
                                            before + 1 > motion_.steps() ? 0 : before + 1);
    }

    [[nodiscard]] double reach() const
    {
        double low = 1.0;
        for (std::int64_t m = 0; m <= motion_.steps(); ++m) {
            low = std::min(low, motion_.displacement(motion_.cells(), m));
        }
        return 1.0 - low;
    }

private:
    Motion motion_;
};

void compareWithExact(const TimeSteps& steps, const State& state, const Schedule& schedule,
                      Record& record)
{
    const ExactTip exact(state, schedule);
    double squares = 0.0;
    double worst = 0.0;
    for (const Sample& sample : steps.samples) {
        const double error = sample.tip - exact.at(sample.time);
        squares += error * error;
        worst = std::max(worst, std::abs(error));
    }
    const double reach = exact.reach();
    record.figures["tip_error"] =
        std::sqrt(squares / static_cast<double>(steps.samples.size())) / reach;
    record.figures["error"] = worst / reach;
    const double energy = 0.5 * energyRatio(state);
    record.figures["energy_error"] = std::abs(steps.samples.back().energy / energy - 1.0);
    record.figures["energy_ratio"] = 2.0 * steps.samples.back().energy;
    record.figures["seconds_median"] = steps.seconds;
    record.figures["seconds_best"] = steps.seconds;
    record.figures["repeats"] = 0;
    record.claim = "found";
    // A discretisation is judged by its error, not by a threshold; wrong is wrong, though.
    record.outcome = record.figures["tip_error"] < 0.1 ? "approximate" : "wrong";
}

/// Ours: verdict, state, and the tip at each step.
void marchOurs(std::int64_t cells, int periods, Record& record)
{
    const Schedule schedule = familyA(cells).schedule;
    const State state = leastEnergyMotion(onePhaseSet(schedule));
    TimeSteps steps;
    bench::record(
        timeOf([&] {
            const State fresh = leastEnergyMotion(onePhaseSet(schedule));
            const Motion motion(fresh, schedule);
            const double energy = 0.5 * energyRatio(fresh);
            steps.samples.clear();
            for (std::int64_t m = 1; m <= periods * motion.steps(); ++m) {
                steps.samples.push_back({static_cast<double>(m) / static_cast<double>(cells),
                                         motion.displacement(cells, m % motion.steps()), energy});
            }
        }),
        record);
    const Timing timing{record.figure("seconds_median"), record.figure("seconds_best"),
                        static_cast<int>(record.figure("repeats"))};
    // Against the motion on 300 cells, which is the same for every N.
    const Schedule reference = familyA(300).schedule;
    compareWithExact(steps, leastEnergyMotion(onePhaseSet(reference)), reference, record);
    bench::record(timing, record);
    judgeFound(leastEnergyOf(familyA(cells), 4.0), state, 1e-6, record);
}

}  // namespace

std::vector<Case> rivalsSuite(Extent extent)
{
    const bool isFull = extent == Extent::full;
    std::vector<Case> cases;
    for (const std::int64_t cells :
         isFull ? std::vector<std::int64_t>{30, 100, 300, 1000} : std::vector<std::int64_t>{30}) {
        Record record = identified("rivals", "null space of W - 1: A", "Eigen BDCSVD", "-",
                                   fmt::format("N={}", cells));
        record.figures["cells"] = static_cast<double>(cells);
        cases.push_back({record, "svd", [cells](Record& row) { findNullSpace(cells, row); }});
    }
    for (const int periods : {1, 5}) {
        for (const int cells :
             isFull ? std::vector<int>{50, 100, 200, 400} : std::vector<int>{50}) {
            const std::string setting = fmt::format("{} cells {} periods", cells, periods);
            Record siconos = identified("rivals", "main mode T=3.5", "siconos", "-", setting);
            siconos.figures["cells"] = cells;
            cases.push_back(
                {siconos, fmt::format("siconos {}", periods), [cells, periods](Record& row) {
                     const Schedule schedule = familyA(300).schedule;
                     const State state = leastEnergyMotion(onePhaseSet(schedule));
                     const TimeSteps steps = runSiconos({.state = state,
                                                         .elements = cells,
                                                         .steps = 7 * cells / 2,
                                                         .period = 3.5,
                                                         .periods = periods});
                     compareWithExact(steps, state, schedule, row);
                 }});
            Record ours = identified("rivals", "main mode T=3.5", "signorini", "-", setting);
            ours.figures["cells"] = cells;
            cases.push_back(
                {ours, "", [cells, periods](Record& row) { marchOurs(cells, periods, row); }});
        }
    }
    return cases;
}

}  // namespace signorini::bench
