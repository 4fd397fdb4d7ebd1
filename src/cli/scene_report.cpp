#include "scene_report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "scene_options.hpp"

namespace signorini::cli {

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

namespace {

/// What is rounded below 0 where nothing presses is 0.
double impulseOf(const NetworkResiduals& residuals, std::size_t contact)
{
    return std::max(0.0, residuals.impulses[contact]);
}

}  // namespace

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
        contacts[j]["impulse"] = impulseOf(residuals, j) * scales.force() * scales.time;
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
                            impulseOf(residuals, j) * scales.force() * scales.time);
    }
    return text;
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
