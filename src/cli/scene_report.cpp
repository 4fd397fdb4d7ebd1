#include "scene_report.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

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
