#include "scene_answer.hpp"

#include <algorithm>
#include <cmath>

#include "faults.hpp"
#include "network_field.hpp"

namespace signorini {

std::string_view name(PartKind kind)
{
    return nameIn(partNames, kind);
}

std::string_view name(ContactKind kind)
{
    constexpr std::array<Named<ContactKind>, 3> names{{{ContactKind::stopRight, "right stop"},
                                                       {ContactKind::stopLeft, "left stop"},
                                                       {ContactKind::gap, "gap"}}};
    return nameIn(names, kind);
}

namespace answers {

namespace {

/// Is it more of the same bar?
bool isContinued(const Segment& one, const Segment& next)
{
    return one.impedance == next.impedance && one.speed == next.speed && one.dashpot == 0.0;
}

}  // namespace

std::string_view entryOf(PartKind kind)
{
    return std::find_if(partNames.begin(), partNames.end(),
                        [kind](const PartName& row) { return row.value == kind; })
        ->entry;
}

Assembly assemblyIn(const std::string& words, const Bar& bar, double gravity)
{
    Assembly assembly{.parts = partsOf(words),
                      .length = bar.length,
                      .waveSpeed = bar.waveSpeed,
                      .axialStiffness = bar.axialStiffness,
                      .gravity = gravity,
                      .young = bar.young};
    validate(assembly);
    return assembly;
}

std::optional<Scene> barOf(const Assembly& assembly)
{
    Scene scene(Bar{.length = assembly.length,
                    .waveSpeed = assembly.waveSpeed,
                    .axialStiffness = assembly.axialStiffness,
                    .young = assembly.young});
    std::vector<Segment>& segments = scene.segments;
    std::vector<double> walls;
    bool isPastTip = false;
    bool isBar = assembly.gravity == 0.0 && assembly.parts.front().kind == PartKind::clamp;
    for (const AssemblyPart& part : assembly.parts) {
        const bool isAtBase = segments.empty();
        isPastTip = isPastTip || part.kind == PartKind::free || part.kind == PartKind::driven ||
                    part.kind == PartKind::rightStop || part.kind == PartKind::leftStop;
        switch (part.kind) {
            case PartKind::clamp:
            case PartKind::shaken:
                isBar = isBar && isAtBase;
                break;
            case PartKind::cells:
                isBar = isBar && !isPastTip;
                segments.push_back({part.cells, part.impedance, part.speed});
                if (segments.size() > 1 && isContinued(segments.end()[-2], segments.back())) {
                    segments.end()[-2].cells += part.cells;
                    segments.pop_back();
                }
                break;
            case PartKind::dash:
                isBar = isBar && !isAtBase;
                if (isBar) {
                    segments.back().dashpot = part.value;
                }
                break;
            case PartKind::rightStop:
                walls.push_back(part.value);
                break;
            case PartKind::leftStop:
                scene.secondStop = part.value;
                break;
            case PartKind::free:
            case PartKind::driven:
                isBar = isBar && !isAtBase;
                break;
            default:
                return std::nullopt;
        }
    }
    // A dashpot at the tip is the damping of a question, not of a scene.
    isBar = isBar && walls.size() == 1 && segments.front().impedance == 1.0 &&
            segments.front().speed == 1.0 && segments.back().dashpot == 0.0;
    if (!isBar) {
        return std::nullopt;
    }
    scene.bar.gap = walls.front();
    if (segments.size() == 1) {
        segments.clear();
    }
    return scene;
}

Assembly assemblyOf(const Scene& scene, std::int64_t cells, const Damping& damping)
{
    Assembly assembly{.length = scene.bar.length,
                      .waveSpeed = scene.bar.waveSpeed,
                      .axialStiffness = scene.bar.axialStiffness,
                      .young = scene.bar.young};
    std::vector<AssemblyPart>& parts = assembly.parts;
    parts = {{.kind = PartKind::clamp}, {.kind = PartKind::shaken}};
    const std::vector<Segment> uniform{{.cells = cells}};
    const std::vector<Segment>& segments = scene.segments.empty() ? uniform : scene.segments;
    for (const Segment& segment : segments) {
        const Segment& first = segments.front();
        parts.push_back({.kind = PartKind::cells,
                         .cells = segment.cells,
                         .impedance = segment.impedance / first.impedance,
                         .speed = segment.speed / first.speed});
        if (segment.dashpot > 0.0) {
            parts.push_back({.kind = PartKind::dash, .value = segment.dashpot / first.impedance});
        }
    }
    if (damping.ratio > 0.0) {
        parts.push_back({.kind = PartKind::dash, .value = damping.eta()});
    }
    parts.push_back({.kind = PartKind::driven});
    parts.push_back({.kind = PartKind::rightStop, .value = scene.bar.gap});
    if (scene.secondStop) {
        parts.push_back({.kind = PartKind::leftStop, .value = *scene.secondStop});
    }
    return assembly;
}

std::vector<SceneContact> contactsOf(const Network& network, double length)
{
    const std::vector<double> places = placesOf(network, length);
    std::vector<SceneContact> list;
    for (const NetworkContact& contact : network.contacts) {
        list.push_back({list.size() + 1, contact.kind, places[contact.node],
                        contact.gap * network.scales.displacement});
    }
    return list;
}

SeveralBars severalOf(const Assembly& assembly, const Network& network)
{
    return {assembly, referenceOf(network), contactsOf(network, assembly.length)};
}

std::optional<double> modulusOf(const Assembly& assembly)
{
    const auto isOther = [](const AssemblyPart& part) {
        return part.kind == PartKind::cells && part.speed != 1.0;
    };
    const bool isOne = std::none_of(assembly.parts.begin(), assembly.parts.end(), isOther);
    return isOne ? assembly.young : std::nullopt;
}

Bar unitsOf(const Assembly& assembly, const Network& network)
{
    const double gap = std::abs(network.contacts.front().gap) * network.scales.displacement;
    return {.length = assembly.length,
            .waveSpeed = 2.0 * assembly.length * referenceOf(network).frequency / std::numbers::pi,
            .axialStiffness = assembly.axialStiffness,
            .gap = gap > 0.0 ? gap : assembly.length,
            .young = modulusOf(assembly)};
}

ForceRange forceRangeOf(const Assembly& assembly, double low, double high, double time)
{
    const Network network = networkOf(assembly);
    const NetworkScales& scales = network.scales;
    const double duration = time / scales.time;
    if (!(duration <= static_cast<double>(maxReachSteps))) {
        throwFault("time", time,
                   fmt::format("at most {} steps of {:.6g} s", maxReachSteps, scales.time));
    }
    const ForceReach reach =
        reachUnder(network, low / scales.force(), high / scales.force(), duration);
    ForceRange answer{assembly, {low, high}, reach.duration * scales.time, {}, {}};
    if (reach.closes) {
        answer.closes = static_cast<std::int64_t>(*reach.closes) + 1;
    }
    const auto both = [&scales](const ForcePeak& least, const ForcePeak& most, double unit) {
        return std::array{Peak{least, unit, scales.time}, Peak{most, unit, scales.time}};
    };
    const std::vector<SceneContact> contacts = contactsOf(network, assembly.length);
    for (std::size_t j = 0; j < contacts.size(); ++j) {
        const ContactReach& one = reach.contacts[j];
        answer.contacts.push_back(
            {contacts[j], both(one.leastVelocity, one.mostVelocity, scales.velocity()),
             both(one.leastDisplacement, one.mostDisplacement, scales.displacement)});
    }
    return answer;
}

}  // namespace answers

}  // namespace signorini
