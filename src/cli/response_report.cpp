#include "response_report.hpp"

#include "force_report.hpp"
#include "report.hpp"
#include "segments_text.hpp"
#include "signorini/output.hpp"
#include "text.hpp"

namespace signorini::cli {

namespace {

std::string_view word(const ForcedMotion& motion)
{
    return motion.stability ? name(*motion.stability) : std::string_view();
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
              {"motions", Json::array()}};
    for (const ForcedMotion& motion : response.motions) {
        Json one = cli::asJson(motion, bar);
        one["stable"] = nullptr;
        if (motion.stability.value_or(Stability::unclear) != Stability::unclear) {
            one["stable"] = *motion.stability == Stability::attracts;
        }
        json["motions"].push_back(std::move(one));
    }
    return json;
}

}  // namespace

std::string asText(const ResponseAnswer& answer)
{
    const ResponseRange& range = answer.range;
    const char* unit = range.place == Excited::tip ? "N" : "m";
    const std::size_t wide = range.contacts > 1 ? 24 : 14;
    Text text;
    print(
        text,
        "{} motions with {}{} at {} frequencies: N = {}, ζ = {}, {} of amplitude {} {}{}{}{}\n",
        answer.motions(), range.contacts > 1 ? "one or two contacts" : "one contact phase",
        range.stops.left ? " on each stop that is touched" : "", answer.frequencies.size(),
        range.cells, range.damping.ratio, range.place == Excited::tip ? "force on the tip" : "base",
        answer.amplitude, unit,
        range.contacts > 1 ? fmt::format(", for two contacts ± {:.3g} %", 100.0 * range.band) : "",
        range.cycles > 1 ? fmt::format(", {} cycles in a period", range.cycles) : "",
        answer.isComplete ? "" : ": interrupted, the list is not complete");
    if (!answer.scene.segments.empty()) {
        print(text, "segments    {}\n", textOf(answer.scene.segments));
    }
    if (answer.undecided() > 0) {
        print(text, "undecided   {} schedules\n", answer.undecided());
    }
    print(text, "\n{:<8}{:<12}{:<14}{:<{}}{:<14}{:<12}{:<14}{:<14}{}\n", "n", "ω/ω₁", "linear u/g",
          "(n_c, n_f)", wide, fmt::format("amplitude {}", unit), "phase", "impulse N s", "peak N",
          "stability");
    for (const FrequencyResponse& response : answer.frequencies) {
        const std::string begin = fmt::format("{:<8}{:<12.6g}{:<14.6g}", response.steps,
                                              response.frequencyRatio, response.linearPeak);
        if (response.motions.empty()) {
            print(text, "{}{}\n", begin, response.touches ? "none" : "none: stays clear");
        }
        for (const ForcedMotion& motion : response.motions) {
            print(text, "{}{:<{}}{:<14.6g}{:<12.5f}{:<14.6g}{:<14.6g}{}\n", begin,
                  describe(motion.schedule.phases), wide,
                  motion.amplitude * amplitudeUnit(range.place, answer.bar), motion.phase,
                  motion.extremes.impulse * impulseUnit(answer.bar),
                  motion.extremes.peakForce * forceUnit(answer.bar), word(motion));
        }
    }
    return fmt::to_string(text);
}

std::string asJson(const ResponseAnswer& answer)
{
    const ResponseRange& range = answer.range;
    Json json = newAnswer();
    json.update(
        Json{{"status", name(answer.status())},
             {"cells", range.cells},
             {"damping", dampingAsJson(range.damping, answer.bar)},
             {"force", name(range.place)},
             {"amplitude", answer.amplitude},
             {"cycles", range.cycles},
             {"contacts", range.contacts},
             {"band", range.contacts > 1 ? Json(range.band) : Json()},
             {"frequency_ratio_range", {range.leastFrequencyRatio, range.mostFrequencyRatio}},
             {"complete", answer.isComplete},
             {"frequencies", Json::array()}});
    addScene(answer.scene, json);
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
        "peak_force,tip_lowest,stability,amplitude,second_contact,second_free,stop\n");
    for (const FrequencyResponse& response : answer.frequencies) {
        const std::string begin =
            fmt::format("{},{},{},{},{}", response.steps, response.frequencyRatio,
                        response.frequencyRatio / 4.0 / unit.time, response.touches ? 1 : 0,
                        response.linearPeak * unit.displacement);
        if (response.motions.empty()) {
            file.write(begin + ",,,,,,,,,,,\n");
        }
        for (const ForcedMotion& motion : response.motions) {
            const std::vector<Phase>& phases = motion.schedule.phases;
            const Phase& first = phases.front();
            const bool isOnBoth = first.stop != phases.back().stop;
            file.write(fmt::format(
                "{},{},{},{},{},{},{},{},{},{},{}\n", begin, first.contact, first.free,
                motion.phase, motion.extremes.impulse * impulseUnit(answer.bar),
                motion.extremes.peakForce * forceUnit(answer.bar),
                motion.extremes.lowestTip * unit.displacement, word(motion),
                motion.amplitude * amplitudeUnit(answer.range.place, answer.bar),
                phases.size() > 1 ? fmt::format("{},{}", phases[1].contact, phases[1].free)
                                  : std::string(","),
                isOnBoth ? "both" : name(first.stop)));
        }
    }
    file.close();
}

}  // namespace signorini::cli
