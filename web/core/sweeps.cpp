// A sweep over the frequency of the excitation, value by value while one watches.

#include "views.hpp"

namespace signorini::web {

namespace {

constexpr std::int64_t mostSweepPoints = 400;
constexpr std::int64_t mostSweepPeriods = 1000;  // at each value

/// The last sweep that was asked for, as far as it was.
struct KeptSweep {
    std::string key;
    SweepDirection direction = SweepDirection::up;
    std::vector<double> values;  ///< in their order
    Waves waves;
    cli::SweepAnswer answer;
};

/// The kept sweep if it answers this question, or a new one.
KeptSweep& sweepFor(const Request& request)
{
    static KeptSweep kept;
    const ResponseRange of = rangeOf(request);
    const SweepRange range{.least = of.leastFrequencyRatio,
                           .most = of.mostFrequencyRatio,
                           .points = request.whole("points", 2, mostSweepPoints),
                           .periods = request.whole("periods", 1, mostSweepPeriods),
                           .cells = static_cast<double>(of.cells),
                           .place = of.place,
                           .amplitude = of.amplitude,
                           .damping = of.damping};
    const bool isDown = request.isOn("down");
    const std::string key = Json({range.least, range.most, range.points, range.periods, range.cells,
                                  name(range.place), range.amplitude, of.damping.ratio, isDown})
                                .dump();
    if (kept.key != key) {
        std::vector<double> values = valuesOf(range);
        if (isDown) {
            values = {values.rbegin(), values.rend()};
        }
        kept = {key,
                isDown ? SweepDirection::down : SweepDirection::up,
                std::move(values),
                wavesAtRest(range.cells),
                {range, bar, bar, {}, false}};
    }
    return kept;
}

}  // namespace

const cli::SweepAnswer& sweepOf(const Request& request)
{
    return sweepFor(request).answer;
}

Reply showSweep(const Request& request)
{
    Reply reply;
    KeptSweep& sweep = sweepFor(request);
    std::vector<SweepPoint>& done = sweep.answer.points;
    const auto wanted = static_cast<std::size_t>(request.whole("wanted", 1, mostSweepPoints));
    while (done.size() < std::min(wanted, sweep.values.size())) {
        done.push_back(
            *settleAt(sweep.answer.range, sweep.values[done.size()], sweep.direction, sweep.waves));
    }
    sweep.answer.isComplete = done.size() == sweep.values.size();
    std::vector<double> rows;  // omega/omega_1, least and most impulse in a period, periods or 0
    for (const SweepPoint& point : done) {
        const auto& settled = point.settling.settled;
        rows.insert(rows.end(), {point.frequencyRatio, point.impulse[0], point.impulse[1],
                                 settled ? static_cast<double>(settled->periods) : 0.0});
    }
    reply.json["all"] = sweep.values.size();
    reply.add("points", rows);
    return reply;
}

}  // namespace signorini::web
