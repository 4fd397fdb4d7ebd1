#include "response_tables.hpp"

#include <fmt/format.h>

#include <cmath>

#include "report.hpp"
#include "signorini/output.hpp"

namespace signorini::cli {

void writeResponseMapCsv(const std::string& path, const ResponseAnswer& answer)
{
    const Scales unit = scales(answer.bar);
    const double force = amplitudeUnit(answer.range.place, answer.bar);
    TextFile file(path);
    file.write(
        "steps,frequency_ratio,frequency,contacts,contact,free,second_contact,second_free,"
        "least_amplitude,most_amplitude\n");
    for (const FrequencyResponse& response : answer.frequencies) {
        const std::string begin = fmt::format("{},{},{}", response.steps, response.frequencyRatio,
                                              response.frequencyRatio / 4.0 / unit.time);
        const auto put = [&](const std::string& phases, double least, double most) {
            file.write(fmt::format("{},{},{},{}\n", begin, phases, least * force,
                                   std::isfinite(most) ? fmt::format("{}", most * force) : ""));
        };
        put("0,,,,", 0.0, answer.amplitudeAt(response) / force / response.linearPeak);
        for (const AmplitudeBranch& branch : response.branches) {
            put(fmt::format("1,{},{},,", branch.contact, response.steps - branch.contact),
                branch.least, branch.most);
        }
        for (const TwoContactBranch& branch : response.twoContacts) {
            const auto& [first, second] = branch.phases;
            put(fmt::format("2,{},{},{},{}", first.contact, first.free, second.contact,
                            second.free),
                branch.least, branch.most);
        }
    }
    file.close();
}

void writeBackboneCsv(const std::string& path, const ResponseAnswer& answer)
{
    const Scales unit = scales(answer.bar);
    const ResponseRange& range = answer.range;
    TextFile file(path);
    file.write(
        "a4,b,family,frequency_ratio,frequency,period_ratio,energy_ratio,impulse,peak_force,"
        "tip_lowest\n");
    for (const Backbone& backbone : backbonesOf(range.leastFrequencyRatio, range.mostFrequencyRatio,
                                                range.cycles, range.stops)) {
        for (const BackbonePoint& point : backbone.points) {
            file.write(fmt::format("{},{},{},{},{},{},{},{},{},{}\n", 4 * backbone.mode.a,
                                   backbone.mode.b, familyName(backbone.mode), point.frequencyRatio,
                                   point.frequencyRatio / 4.0 / unit.time, point.extremes.period,
                                   point.energyRatio,
                                   point.extremes.impulse * answers::impulseUnit(answer.bar),
                                   point.extremes.peakForce * answers::forceUnit(answer.bar),
                                   point.extremes.lowestTip * unit.displacement));
        }
    }
    file.close();
}

}  // namespace signorini::cli
