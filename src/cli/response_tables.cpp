#include "reports.hpp"

#include <fmt/format.h>

#include "printing.hpp"

namespace signorini::cli {

void writeResponseMapCsv(const std::string& path, const ResponseAnswer& answer)
{
    constexpr std::string_view header =
        "steps,frequency_ratio,frequency,contacts,contact,free,second_contact,second_free,"
        "least_amplitude,most_amplitude";
    const double force = amplitudeUnit(answer.range.place, answer.bar);
    writeCsv(path, header, [&](CsvRows& row) {
        for (const FrequencyResponse& response : answer.frequencies) {
            const auto put = [&](const std::string& phases, double least, double most) {
                row(response.steps, response.frequencyRatio,
                    answers::hertzOf(response.frequencyRatio, answer.bar), phases, least * force,
                    answers::known(most * force));
            };
            put("0,,,,", 0.0, response.openUpTo);
            if (response.permanentUpTo > 0.0) {
                put(fmt::format("1,{},0,,", response.steps), 0.0, response.permanentUpTo);
            }
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
    });
}

void writeBackboneCsv(const std::string& path, const ResponseAnswer& answer)
{
    constexpr std::string_view header =
        "a4,b,family,frequency_ratio,frequency,period_ratio,energy_ratio,impulse,peak_force,"
        "tip_lowest";
    const ResponseRange& range = answer.range;
    writeCsv(path, header, [&](CsvRows& row) {
        for (const Backbone& backbone : backbonesOf(
                 range.leastFrequencyRatio, range.mostFrequencyRatio, range.cycles, range.stops)) {
            for (const BackbonePoint& point : backbone.points) {
                const Extremes& seen = point.extremes;
                row(4 * backbone.mode.a, backbone.mode.b, familyName(backbone.mode),
                    point.frequencyRatio, answers::hertzOf(point.frequencyRatio, answer.bar),
                    seen.period, point.energyRatio, seen.impulse * answers::impulseUnit(answer.bar),
                    seen.peakForce * answers::forceUnit(answer.bar),
                    seen.lowestTip * scales(answer.bar).displacement);
            }
        }
    });
}

}  // namespace signorini::cli
