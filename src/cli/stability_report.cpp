#include "stability_report.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "force_report.hpp"

namespace signorini::cli {

std::string asText(const StabilityReport& report, const Bar& bar)
{
    double least = 1e300;
    double most = 0.0;
    for (const StabilityTrial& trial : report.result.trials) {
        const double times = trial.start > 0.0 ? trial.end / trial.start : 0.0;
        least = std::min(least, times);
        most = std::max(most, times);
    }
    std::string text = fmt::format(
        "stability   ζ = {}: {}; {} disturbances of 0.01 to 0.1 % became {:.3g} to {:.3g} times as "
        "large in {} periods",
        report.damping.ratio, name(report.result.stability), report.result.trials.size(), least,
        most, report.options.periods);
    if (report.result.drift > 1e-9) {
        text += fmt::format("; undisturbed it moved by up to {:.3g} m, with {} contacts",
                            report.result.drift * scales(bar).displacement, report.result.contacts);
    }
    return text + "\n";
}

Json asJson(const StabilityReport& report, const Bar& bar)
{
    Json trials = Json::array();
    for (const StabilityTrial& trial : report.result.trials) {
        trials.push_back({{"size", trial.size},
                          {"start", trial.start * scales(bar).displacement},
                          {"end", trial.end * scales(bar).displacement}});
    }
    return {{"damping", dampingAsJson(report.damping, bar)},
            {"verdict", name(report.result.stability)},
            {"periods", report.options.periods},
            {"drift", report.result.drift * scales(bar).displacement},
            {"contacts", report.result.contacts},
            {"trials", trials}};
}

}  // namespace signorini::cli
