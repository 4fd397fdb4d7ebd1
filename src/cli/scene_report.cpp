#include "scene_report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "scene_options.hpp"

namespace signorini::cli {

namespace {

/// [m], as it stands at rest.
double gapOf(const Network& network, const NetworkContact& contact)
{
    return contact.gap * network.scales.displacement;
}

}  // namespace

std::string_view name(ContactKind kind)
{
    switch (kind) {
        case ContactKind::stopRight:
            return "right stop";
        case ContactKind::stopLeft:
            return "left stop";
        case ContactKind::gap:
            return "gap";
    }
    return "";
}

std::vector<double> placesOf(const Network& network, double length)
{
    double cells = 0.0;
    for (const CellRow& row : network.rows) {
        cells += static_cast<double>(row.cells) * row.speed;
    }
    std::vector<double> places(network.nodes.size(), 0.0);
    std::size_t row = 0;
    for (std::size_t node = 0; node < places.size(); ++node) {
        if (row < network.rows.size() && network.rows[row].right == node) {
            const CellRow& here = network.rows[row++];
            places[node] =
                places[node - 1] + length * static_cast<double>(here.cells) * here.speed / cells;
        } else if (node > 0) {
            places[node] = places[node - 1];
        }
    }
    return places;
}

Json contactsAsJson(const Network& network, double length)
{
    Json list = Json::array();
    const std::vector<double> places = placesOf(network, length);
    for (const NetworkContact& contact : network.contacts) {
        list.push_back({{"number", list.size() + 1},
                        {"kind", name(contact.kind)},
                        {"place", places[contact.node]},
                        {"gap", gapOf(network, contact)}});
    }
    return list;
}

Json referenceAsJson(const Network& network)
{
    const SceneReference reference = referenceOf(network);
    const bool hasMode = reference.frequency > 0.0;
    const bool hasEnergy = reference.energy && *reference.energy > 0.0;
    return {{"frequency", hasMode ? Json(reference.frequency / (2.0 * std::numbers::pi)) : Json()},
            {"damping", reference.damping ? Json(*reference.damping) : Json()},
            {"energy", hasEnergy ? Json(*reference.energy) : Json()},
            {"compliance", reference.compliance ? Json(*reference.compliance) : Json()}};
}

std::optional<double> firstEnergy(const Network& network)
{
    const SceneReference reference = referenceOf(network);
    return reference.energy && *reference.energy > 0.0
               ? std::optional(*reference.energy / network.scales.energy())
               : std::nullopt;
}

double usualEnergy(const Network& network, const std::vector<ContactSpan>& schedule)
{
    double force = 0.0;
    for (const NetworkNode& node : network.nodes) {
        force += std::abs(node.force);
    }
    const auto cells = static_cast<double>(network.cells());
    const double impulse = force * periodOf(network, schedule) / network.scales.time;
    return firstEnergy(network).value_or(std::max(cells, impulse * impulse / cells));
}

double periodOf(const Network& network, const std::vector<ContactSpan>& schedule)
{
    double steps = 0.0;
    for (const ContactSpan& span : schedule) {
        steps += static_cast<double>(span.steps);
    }
    return steps * network.scales.time;
}

namespace {

/// Numbers of contacts.
std::vector<std::size_t> numbersOf(ContactSet closed)
{
    std::vector<std::size_t> numbers;
    for (std::size_t j = 0; j < maxContacts; ++j) {
        if (contains(closed, j)) {
            numbers.push_back(j + 1);
        }
    }
    return numbers;
}

Json listed(const std::vector<ContactMultiplier>& list)
{
    Json json = Json::array();
    for (const ContactMultiplier& m : list) {
        json.push_back({m.contact + 1, m.step, m.value});
    }
    return json;
}

}  // namespace

std::string textOf(const std::vector<ContactSpan>& schedule)
{
    std::string text;
    for (const ContactSpan& span : schedule) {
        const std::vector<std::size_t> numbers = numbersOf(span.closed);
        text += fmt::format("{}{}:{}", text.empty() ? "" : " ",
                            numbers.empty() ? "-" : fmt::format("{}", fmt::join(numbers, "+")),
                            span.steps);
    }
    return text;
}

Json scheduleAsJson(const std::vector<ContactSpan>& schedule)
{
    Json list = Json::array();
    for (const ContactSpan& span : schedule) {
        list.push_back({{"closed", numbersOf(span.closed)}, {"steps", span.steps}});
    }
    return list;
}

Json multipliersAsJson(const EnergyFloor& multipliers)
{
    return {{"periodicity", multipliers.periodicity},
            {"places", listed(multipliers.places)},
            {"pushes", listed(multipliers.pushes)}};
}

void addForces(Json& contacts, const Network& network, const std::vector<ContactSpan>& schedule,
               const NetworkResiduals& residuals)
{
    const NetworkScales& scales = network.scales;
    for (std::size_t j = 0; j < network.contacts.size(); ++j) {
        double steps = 0.0;
        for (const ContactSpan& span : schedule) {
            steps += contains(span.closed, j) ? static_cast<double>(span.steps) : 0.0;
        }
        contacts[j]["peak_force"] = residuals.peakForces[j] * scales.force();
        contacts[j]["impulse"] = residuals.impulses[j] * scales.force() * scales.time;
        contacts[j]["contact_time"] = scales.time * steps;
    }
}

std::string forcesAsText(const Network& network, const NetworkResiduals& residuals)
{
    const NetworkScales& scales = network.scales;
    std::string text;
    for (std::size_t j = 0; j < network.contacts.size(); ++j) {
        text += fmt::format("contact {:<4}force at most {:.6g} N, impulse {:.6g} N s per period\n",
                            j + 1, residuals.peakForces[j] * scales.force(),
                            residuals.impulses[j] * scales.force() * scales.time);
    }
    return text;
}

Json withScene(const Json& answer, const Assembly& assembly, const Network& network)
{
    Json all;
    for (const auto& [key, value] : answer.items()) {
        if (key == "bar") {
            all["scene"] = asJson(assembly);
            all["reference"] = referenceAsJson(network);
            all["contacts"] = contactsAsJson(network, assembly.length);
        } else if (key != "stops" && key != "segments" && key != "static_force" &&
                   key != "damping") {
            all[key] = value;
        }
    }
    return all;
}

std::string headline(const Assembly& assembly, const Network& network)
{
    const SceneReference reference = referenceOf(network);
    std::string text = fmt::format("scene       {} bar{}, {} cells, {:.6g} m; c = {:.6g} m/s",
                                   network.bars.size(), network.bars.size() == 1 ? "" : "s",
                                   network.cells(), assembly.length, assembly.waveSpeed);
    if (reference.frequency > 0.0) {
        text += fmt::format(", ω₁ = {:.6g} Hz", reference.frequency / (2.0 * std::numbers::pi));
    }
    if (reference.damping && *reference.damping > 0.0) {
        text += fmt::format(", ζ = {:.4g}", *reference.damping);
    }
    if (reference.energy && *reference.energy > 0.0) {
        text += fmt::format(", E₁ = {:.6g} J", *reference.energy);
    }
    return text + "\n";
}

}  // namespace signorini::cli
