#include "response_report.hpp"

#include <fmt/format.h>

#include "json.hpp"
#include "report.hpp"
#include "signorini/output.hpp"

namespace signorini::cli {

namespace {

std::string_view word(const ForcedMotion& motion)
{
    return motion.stability ? name(*motion.stability) : std::string_view();
}

}  // namespace

std::string asJson(const ResponseAnswer& answer)
{
    return asLine(wholeJsonOf(answer));
}

void writeResponseCsv(const std::string& path, const ResponseAnswer& answer)
{
    const Scales unit = scales(answer.bar);
    TextFile file(path);
    file.write(
        "steps,frequency_ratio,frequency,touches,linear_peak,contact,free,phase,impulse,"
        "peak_force,tip_lowest,stability,amplitude,second_contact,second_free,stop,undecided,"
        "contact_time,approach_speed,peak_compression,peak_tension,peak_stress,cells\n");
    for (const answers::FrequencyOf& at : answer.listed()) {
        const FrequencyResponse& response = at.value;
        const std::string begin =
            fmt::format("{},{},{},{},{}", response.steps, response.frequencyRatio,
                        response.frequencyRatio / 4.0 / unit.time, response.touches ? 1 : 0,
                        response.linearPeak * unit.displacement);
        const auto end = [&](const Physical* p) {
            return p == nullptr
                       ? fmt::format(",{},,,,,,{}\n", response.undecided, at.cells())
                       : fmt::format(",{},{},{},{},{},{},{}\n", response.undecided, p->contactTime,
                                     p->approachSpeed, p->peakCompression, p->peakTension,
                                     p->peakStress ? fmt::format("{}", *p->peakStress) : "",
                                     at.cells());
        };
        if (const auto& held = response.permanent) {
            const Physical p = physicalOf(held->extremes, answer.bar);
            file.write(fmt::format("{},{},0,0,{},{},{},,{},,,right{}", begin, response.steps,
                                   p.impulse, p.peakForce, p.tipLowest,
                                   answer.amplitudeAt(response), end(&p)));
        } else if (response.motions.empty()) {
            file.write(fmt::format("{},,,,,,,,,,,{}", begin, end(nullptr)));
        }
        for (const ForcedMotion& motion : response.motions) {
            const std::vector<Phase>& phases = motion.schedule.phases;
            const Phase& first = phases.front();
            const bool isOnBoth = first.stop != phases.back().stop;
            const Physical p = physicalOf(motion.extremes, answer.bar);
            file.write(fmt::format(
                "{},{},{},{},{},{},{},{},{},{},{}{}", begin, first.contact, first.free,
                motion.phase, p.impulse, p.peakForce, p.tipLowest, word(motion),
                motion.amplitude * amplitudeUnit(answer.range.place, answer.bar),
                phases.size() > 1 ? fmt::format("{},{}", phases[1].contact, phases[1].free)
                                  : std::string(","),
                isOnBoth ? "both" : name(first.stop), end(&p)));
        }
    }
    file.close();
}

}  // namespace signorini::cli
