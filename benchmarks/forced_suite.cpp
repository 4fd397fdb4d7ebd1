// Forced and damped: the response against marching from rest. One motion of it is a case of the
// rivals (rival_cases.hpp).

#include <fmt/format.h>

#include "rival_cases.hpp"
#include "signorini/response.hpp"
#include "signorini/settling.hpp"
#include "suites.hpp"
#include "timing.hpp"

namespace signorini::bench {

namespace {

ResponseRange responseRange(std::int64_t cells)
{
    ResponseRange range;
    range.cells = cells;
    range.damping = dampingOfRho(drivenRho);
    range.amplitude = drivenForce;
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
