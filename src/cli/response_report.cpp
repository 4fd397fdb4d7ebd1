#include "reports.hpp"

#include <fmt/format.h>

#include "printing.hpp"

namespace signorini::cli {

namespace {

std::string_view word(const ForcedMotion& motion)
{
    return motion.stability ? name(*motion.stability) : std::string_view();
}

}  // namespace

void writeResponseCsv(const std::string& path, const ResponseAnswer& answer)
{
    constexpr std::string_view header =
        "steps,frequency_ratio,frequency,touches,linear_peak,contact,free,phase,impulse,"
        "peak_force,tip_lowest,stability,amplitude,second_contact,second_free,stop,undecided,"
        "contact_time,approach_speed,peak_compression,peak_tension,peak_stress,cells";
    const Scales unit = scales(answer.bar);
    writeCsv(path, header, [&](CsvRows& row) {
        for (const answers::FrequencyOf& at : answer.listed()) {
            const FrequencyResponse& response = at.value;
            const std::string begin =
                fmt::format("{},{},{},{:d},{}", response.steps, response.frequencyRatio,
                            answers::hertzOf(response.frequencyRatio, answer.bar), response.touches,
                            response.linearPeak * unit.displacement);
            // Contact and flight, phase, amplitude, second contact and flight, stop.
            const auto put = [&](const auto& first, const auto& phase, std::string_view stability,
                                 double amplitude, const auto& second, std::string_view stop,
                                 const Physical& p) {
                row(begin, first, phase, p.impulse, p.peakForce, p.tipLowest, stability, amplitude,
                    second, stop, response.undecided, p.contactTime, p.approachSpeed,
                    p.peakCompression, p.peakTension, p.peakStress, at.cells());
            };
            if (const auto& held = response.permanent) {
                put(fmt::format("{},0", response.steps), 0, "", answer.amplitudeAt(response), ",",
                    "right", physicalOf(held->extremes, answer.bar));
            } else if (response.motions.empty()) {
                row(begin, ",,,,,,,,,,", response.undecided, ",,,,", at.cells());
            }
            for (const ForcedMotion& motion : response.motions) {
                const std::vector<Phase>& phases = motion.schedule.phases;
                const Phase& first = phases.front();
                put(fmt::format("{},{}", first.contact, first.free), motion.phase, word(motion),
                    motion.amplitude * amplitudeUnit(answer.range.place, answer.bar),
                    phases.size() > 1 ? fmt::format("{},{}", phases[1].contact, phases[1].free)
                                      : ",",
                    first.stop != phases.back().stop ? "both" : name(first.stop),
                    physicalOf(motion.extremes, answer.bar));
            }
        }
    });
}

}  // namespace signorini::cli
