#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "files.hpp"
#include "force_range.hpp"
#include "scene_options.hpp"
#include "scene_report.hpp"
#include "simulate_command.hpp"

namespace signorini::cli {

namespace {

Json asJson(const ForcePeak& peak, double unit, double second)
{
    return {{"bound", peak.bound * unit},
            {"reached", peak.reached * unit},
            {"time", peak.time * second}};
}

std::string asText(const ForcePeak& least, const ForcePeak& most, double unit, const char* name)
{
    return fmt::format("{} from {:.6g} to {:.6g} {} (reached {:.6g}, {:.6g})", name,
                       least.bound * unit, most.bound * unit, name[0] == 'v' ? "m/s" : "m",
                       least.reached * unit, most.reached * unit);
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
    const Network network = networkOf(assembly);
    const NetworkScales& scales = network.scales;
    const double duration = *command.time / scales.time;
    if (!(duration <= static_cast<double>(maxReachSteps))) {
        refuse("--time", fmt::format("{}", *command.time),
               fmt::format("at most {} steps of {:.6g} s", maxReachSteps, scales.time));
    }
    const ForceReach reach =
        reachUnder(network, low / scales.force(), high / scales.force(), duration);
    Json contacts = contactsAsJson(network, assembly.length);
    std::string text = headline(assembly, network) +
                       fmt::format("force       any from {:g} to {:g} N, for {:.6g} s\n", low, high,
                                   reach.duration * scales.time);
    for (std::size_t j = 0; j < reach.contacts.size(); ++j) {
        const ContactReach& one = reach.contacts[j];
        const double v = scales.velocity();
        const double u = scales.displacement;
        contacts[j]["velocity"] = {asJson(one.leastVelocity, v, scales.time),
                                   asJson(one.mostVelocity, v, scales.time)};
        contacts[j]["displacement"] = {asJson(one.leastDisplacement, u, scales.time),
                                       asJson(one.mostDisplacement, u, scales.time)};
        text += fmt::format("contact {:<4}{}\n            {}\n", j + 1,
                            asText(one.leastVelocity, one.mostVelocity, v, "v"),
                            asText(one.leastDisplacement, one.mostDisplacement, u, "u"));
    }
    text += reach.closes ? fmt::format("closes      contact {} can, then\n", *reach.closes + 1)
                         : "closes      no contact, under no such force: proved\n";
    Json json = newAnswer();
    json.update(Json{{"status", "done"},
                     {"scene", cli::asJson(assembly)},
                     {"force_range", {low, high}},
                     {"time", reach.duration * scales.time},
                     {"closes", nullptr},
                     {"contacts", std::move(contacts)}});
    if (reach.closes) {
        json["closes"] = *reach.closes + 1;
    }
    writeOut(command.common.wantsJson ? asLine(json) : text);
    command.common.useOneThread();
    return exitFound;
}

}  // namespace signorini::cli
