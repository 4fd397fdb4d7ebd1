#include "response_report.hpp"

#include <fmt/format.h>

#include "forced_answer.hpp"
#include "json.hpp"
#include "report.hpp"
#include "signorini/output.hpp"

namespace signorini::cli {

namespace {

std::string_view word(const ForcedMotion& motion)
{
    return motion.stability ? name(*motion.stability) : std::string_view();
}

Json asJson(const PermanentContact& contact, const Bar& bar)
{
    const Physical physical = physicalOf(contact.extremes, bar);
    return {{"least_force", contact.leastForce * answers::forceUnit(bar)},
            {"peak_force", physical.peakForce},
            {"impulse", physical.impulse},
            {"physical", jsonOf(physical)},
            {"admissible", physical.isAdmissible()},
            {"residual", contact.residual}};
}

Json asJson(const FrequencyResponse& response, const Bar& bar)
{
    const Scales unit = scales(bar);
    Json json{{"steps", response.steps},
              {"frequency_ratio", response.frequencyRatio},
              {"frequency", response.frequencyRatio / 4.0 / unit.time},
              {"touches", response.touches},
              {"linear_peak", response.linearPeak * unit.displacement},
              {"undecided", response.undecided},
              {"reason", response.undecided > 0 ? Json(response.detail) : Json()},
              {"permanent_contact", response.permanent ? asJson(*response.permanent, bar) : Json()},
              {"motions", Json::array()}};
    for (const ForcedMotion& motion : response.motions) {
        json["motions"].push_back(jsonOf(answers::ForcedMotionOf{motion, bar, true}));
    }
    return json;
}

}  // namespace

std::string asJson(const ResponseAnswer& answer)
{
    const ResponseRange& range = answer.range;
    Json json = newAnswer();
    json.update(
        Json{{"status", name(answer.status())},
             {"cells", range.cells},
             {"damping", jsonOf(answers::Of<Damping>{range.damping, answer.bar})},
             {"force", name(range.place)},
             {"amplitude", answer.amplitude},
             {"cycles", range.cycles},
             {"contacts", range.contacts},
             {"band", range.contacts > 1 ? Json(range.band) : Json()},
             {"frequency_ratio_range", {range.leastFrequencyRatio, range.mostFrequencyRatio}},
             {"complete", answer.isComplete && answer.undecided() == 0},
             {"frequencies", Json::array()}});
    json.update(jsonOf(answer.scene));
    for (const FrequencyResponse& response : answer.frequencies) {
        json["frequencies"].push_back(asJson(response, answer.bar));
    }
    return asLine(json);
}

void writeResponseCsv(const std::string& path, const ResponseAnswer& answer)
{
    const Scales unit = scales(answer.bar);
    TextFile file(path);
    file.write(
        "steps,frequency_ratio,frequency,touches,linear_peak,contact,free,phase,impulse,"
        "peak_force,tip_lowest,stability,amplitude,second_contact,second_free,stop,undecided,"
        "contact_time,approach_speed,peak_compression,peak_tension,peak_stress\n");
    for (const FrequencyResponse& response : answer.frequencies) {
        const std::string begin =
            fmt::format("{},{},{},{},{}", response.steps, response.frequencyRatio,
                        response.frequencyRatio / 4.0 / unit.time, response.touches ? 1 : 0,
                        response.linearPeak * unit.displacement);
        const auto end = [&response](const Physical* p) {
            return p == nullptr
                       ? fmt::format(",{},,,,,\n", response.undecided)
                       : fmt::format(",{},{},{},{},{},{}\n", response.undecided, p->contactTime,
                                     p->approachSpeed, p->peakCompression, p->peakTension,
                                     p->peakStress ? fmt::format("{}", *p->peakStress) : "");
        };
        if (const auto& held = response.permanent) {
            const Physical p = physicalOf(held->extremes, answer.bar);
            file.write(fmt::format("{},{},0,0,{},{},{},,{},,,right{}", begin, response.steps,
                                   p.impulse, p.peakForce, p.tipLowest, answer.amplitude, end(&p)));
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
                motion.amplitude * answers::amplitudeUnit(answer.range.place, answer.bar),
                phases.size() > 1 ? fmt::format("{},{}", phases[1].contact, phases[1].free)
                                  : std::string(","),
                isOnBoth ? "both" : name(first.stop), end(&p)));
        }
    }
    file.close();
}

}  // namespace signorini::cli
