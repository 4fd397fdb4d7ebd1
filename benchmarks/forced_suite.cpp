// Forced and damped: the simulation and codes of time steps against the motion under a harmonic
// that is not sampled, the response against marching from rest.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "harmonic_march.hpp"
#include "moreau_jean.hpp"
#include "signorini/response.hpp"
#include "signorini/settling.hpp"
#include "suites.hpp"
#include "timing.hpp"

namespace signorini::bench {

namespace {

/// The bar of theory.md, section 15: rho = 0.9, a force of 0.25 EA g/L with a period of 3.6 L/c.
constexpr double rho = 0.9;
constexpr double forceAmplitude = 0.25;
constexpr double forcePeriod = 3.6;

/// The motion of larger impulse, (12, 96) on 30 cells; the same on any grid but for the sampling.
ForcedMotion forcedMotionOn(std::int64_t cells)
{
    const Schedule schedule{cells, {{12 * cells / 30, 96 * cells / 30}}};
    std::vector<ForcedMotion> motions =
        motionsOfAmplitude(forcedMotions(schedule, dampingOfRho(rho), {}), forceAmplitude);
    if (motions.empty()) {
        throw std::runtime_error("the motion to be followed is not there");
    }
    return motions.back();
}

/// The path of the tip from a state, with a harmonic in so many steps of L/c.
std::vector<TipPoint> pathOf(const ForcedMotion& motion, std::int64_t perCrossing, int periods)
{
    const auto steps =
        static_cast<std::int64_t>(std::llround(forcePeriod * static_cast<double>(perCrossing)));
    BarSimulation simulation(wavesOf(motion.state), motion.damping,
                             excitationOf({.amplitude = forceAmplitude,
                                           .phase = motion.phase,
                                           .steps = steps,
                                           .stepsPerCrossing = static_cast<double>(perCrossing)}),
                             {.mergeBelow = {}, .recordsTip = true});
    simulation.advance(static_cast<double>(motion.state.cells()) * forcePeriod * periods);
    return simulation.tipPath();
}

double tipAt(const std::vector<TipPoint>& path, double time)
{
    const auto after =
        std::lower_bound(path.begin() + 1, path.end() - 1, time,
                         [](const TipPoint& point, double t) { return point.time < t; });
    const TipPoint& from = *(after - 1);
    const double share =
        after->time > from.time ? (time - from.time) / (after->time - from.time) : 0.0;
    return std::lerp(from.displacement, after->displacement, std::clamp(share, 0.0, 1.0));
}

/// The state of 30 cells is the start of all.
constexpr std::int64_t startCells = 30;
constexpr int followed = 5;  // periods

/// What time steps miss of the motion under the harmonic as it is.
void compare(const std::vector<Sample>& samples, const ForcedMotion& motion, Record& record)
{
    const HarmonicMarch truth(motion.state,
                              {.dashpot = motion.damping.eta(),
                               .amplitude = forceAmplitude,
                               .phase = motion.phase,
                               .period = forcePeriod},
                              forcePeriod * followed);
    double squares = 0.0;
    double worst = 0.0;
    double low = 1.0;
    for (const Sample& sample : samples) {
        const double tip = truth.tip(sample.time);
        squares += (sample.tip - tip) * (sample.tip - tip);
        worst = std::max(worst, std::abs(sample.tip - tip));
        low = std::min(low, tip);
    }
    record.figures["tip_error"] =
        std::sqrt(squares / static_cast<double>(samples.size())) / (1.0 - low);
    record.figures["error"] = worst / (1.0 - low);
    record.claim = "found";
    record.outcome = record.figures["tip_error"] < 0.1 ? "approximate" : "wrong";
}

SiconosRun runOf(const ForcedMotion& motion, const State& nodes, int elements)
{
    return {.state = nodes,
            .elements = elements,
            .steps = static_cast<int>(forcePeriod * elements),
            .period = forcePeriod,
            .periods = followed,
            .dashpot = motion.damping.eta(),
            .amplitude = forceAmplitude,
            .phase = motion.phase};
}

void marchWithSiconos(int elements, Record& record)
{
    const ForcedMotion motion = forcedMotionOn(startCells);
    const TimeSteps steps = runSiconos(runOf(motion, refined(motion.state, 20), elements));
    record.figures["seconds_median"] = steps.seconds;
    record.figures["seconds_best"] = steps.seconds;
    record.figures["repeats"] = 0;
    compare(steps.samples, motion, record);
}

void marchWithElements(int elements, Record& record)
{
    const ForcedMotion motion = forcedMotionOn(startCells);
    const State nodes = refined(motion.state, 20);
    TimeSteps steps;
    bench::record(timeOf([&] { steps = runMoreauJean(runOf(motion, nodes, elements)); }), record);
    compare(steps.samples, motion, record);
}

void marchOurs(std::int64_t perCrossing, Record& record)
{
    const ForcedMotion motion = forcedMotionOn(startCells);
    std::vector<TipPoint> path;
    bench::record(timeOf([&] { path = pathOf(motion, perCrossing, followed); }), record);
    std::vector<Sample> samples;
    const auto count = static_cast<int>(forcePeriod * static_cast<double>(perCrossing)) * followed;
    for (int k = 1; k <= count; ++k) {
        const double time = static_cast<double>(k) / static_cast<double>(perCrossing);
        samples.push_back({time, tipAt(path, time), 0.0});
    }
    compare(samples, motion, record);
}

ResponseRange responseRange(std::int64_t cells)
{
    ResponseRange range;
    range.cells = cells;
    range.damping = dampingOfRho(rho);
    range.amplitude = forceAmplitude;
    range.leastFrequencyRatio = 0.95;
    range.mostFrequencyRatio = 1.25;
    return range;
}

/// All motions of one contact, exactly.
void listMotions(std::int64_t cells, Record& record)
{
    std::vector<FrequencyResponse> all;
    bench::record(timeOf([&] { all = frequencyResponse(responseRange(cells)); }), record);
    double motions = 0.0;
    for (const FrequencyResponse& response : all) {
        motions += static_cast<double>(response.motions.size());
    }
    record.figures["checked"] = static_cast<double>(all.size());
    record.figures["found"] = motions;
    record.claim = "found";
    record.outcome = "right";
    record.detail = "every motion of one contact, stable or not";
}

/// What is usually done: from rest, 500 periods at each frequency, and see whether it repeats.
void marchToRest(std::int64_t cells, Record& record)
{
    const ResponseRange range = responseRange(cells);
    double settled = 0.0;
    double contacts = 0.0;
    bench::record(timeOf([&] {
                      settled = 0.0;
                      contacts = 0.0;
                      for (const std::int64_t n : stepsOf(range)) {
                          const auto perCrossing = static_cast<double>(cells);
                          BarSimulation simulation(wavesAtRest(perCrossing), range.damping,
                                                   excitationOf({.amplitude = range.amplitude,
                                                                 .steps = n,
                                                                 .stepsPerCrossing = perCrossing}));
                          constexpr std::int64_t periods = 500;
                          SettlingWatch watch(periods);
                          for (std::int64_t k = 0; k < periods; ++k) {
                              simulation.advance(static_cast<double>(n));
                              watch.see(simulation);
                          }
                          const auto end =
                              watch.settling(simulation, static_cast<double>(n)).settled;
                          settled += end ? 1.0 : 0.0;
                          contacts += end && end->periods == 1 && end->contacts == 1 ? 1.0 : 0.0;
                      }
                  }),
                  record);
    record.figures["checked"] = static_cast<double>(stepsOf(range).size());
    record.figures["found"] = contacts;
    record.claim = "found";
    record.outcome = "right";
    record.detail = fmt::format("settled at {} frequencies; one motion at most of each", settled);
}

}  // namespace

std::vector<Case> forcedSuite(Extent extent)
{
    const bool isFull = extent == Extent::full;
    std::vector<Case> cases;
    for (const int elements : isFull ? std::vector<int>{50, 100, 200, 400} : std::vector<int>{50}) {
        Record siconos = identified("rivals", "forced, damped, T=3.6", "siconos", "-",
                                    fmt::format("{} cells {} periods", elements, followed));
        siconos.figures["cells"] = elements;
        cases.push_back({siconos, "siconos forced",
                         [elements](Record& row) { marchWithSiconos(elements, row); }});
    }
    for (const int elements :
         isFull ? std::vector<int>{50, 100, 200, 400, 800, 1600} : std::vector<int>{50}) {
        Record stepped = identified("rivals", "forced, damped, T=3.6", "Moreau-Jean", "-",
                                    fmt::format("{} cells {} periods", elements, followed));
        stepped.figures["cells"] = elements;
        cases.push_back(
            {stepped, "", [elements](Record& row) { marchWithElements(elements, row); }});
    }
    for (const int perCrossing :
         isFull ? std::vector<int>{30, 60, 150, 300, 1200} : std::vector<int>{30}) {
        Record ours = identified("rivals", "forced, damped, T=3.6", "signorini", "-",
                                 fmt::format("{} cells {} periods", perCrossing, followed));
        ours.figures["cells"] = perCrossing;
        cases.push_back({ours, "", [perCrossing](Record& row) { marchOurs(perCrossing, row); }});
    }
    for (const int cells : isFull ? std::vector<int>{30, 100, 300} : std::vector<int>{30}) {
        const std::string setting = fmt::format("N={}", cells);
        Record exact = identified("rivals", "response, 0.95..1.25", "signorini", "-", setting);
        exact.figures["cells"] = cells;
        cases.push_back({exact, "", [cells](Record& row) { listMotions(cells, row); }});
        Record rest = identified("rivals", "response, 0.95..1.25", "march from rest", "-", setting);
        rest.figures["cells"] = cells;
        cases.push_back({rest, "rest", [cells](Record& row) { marchToRest(cells, row); }});
    }
    return cases;
}

}  // namespace signorini::bench
