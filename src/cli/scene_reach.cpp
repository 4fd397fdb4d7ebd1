#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "files.hpp"
#include "scene_report.hpp"
#include "simulate_command.hpp"

namespace signorini::cli {

namespace {

std::string asText(const std::array<answers::Peak, 2>& peaks, const char* what, const char* unit)
{
    const auto& [least, most] = peaks;
    return fmt::format("{} from {:.6g} to {:.6g} {} (reached {:.6g}, {:.6g})", what,
                       least.value.bound * least.unit, most.value.bound * most.unit, unit,
                       least.value.reached * least.unit, most.value.reached * most.unit);
}

}  // namespace

ExitStatus reportReach(const SimulateCommand& command)
{
    const auto isGiven = [&command](const char* option) { return command.given.has(option); };
    constexpr std::array others{"--force-file", "--from", "--velocity", "--events",
                                "--statistics", "--tip",  "--figure",   "--state"};
    refuseIf(!command.time || command.force.amplitude || !command.common.hasScene() ||
                 std::any_of(others.begin(), others.end(), isGiven),
             "--force-range: allowed only with --scene, --time and what the scene is made of");
    const auto [low, high] = *command.forceRange;
    const Assembly assembly = command.common.assembly();
    const answers::ForceRange answer = answers::forceRangeOf(assembly, low, high, *command.time);
    std::string text =
        fmt::format("force       any from {:g} to {:g} N, for {:.6g} s\n", low, high, answer.time);
    for (const answers::ContactPeaks& one : answer.contacts) {
        text += fmt::format("contact {:<4}{}\n            {}\n", one.contact.number,
                            asText(one.velocity, "v", "m/s"), asText(one.displacement, "u", "m"));
    }
    text += answer.closes ? fmt::format("closes      contact {} can, then\n", *answer.closes)
                          : "closes      no contact, under no such force: proved\n";
    report(command.common, answer, assembly, text);
    command.common.useOneThread();
    return exitFound;
}

}  // namespace signorini::cli
