#include "commands.hpp"

#include "files.hpp"
#include "given.hpp"
#include "network_field.hpp"
#include "scene_figures.hpp"
#include "scene_report.hpp"

namespace signorini::cli {

namespace {

std::string asText(const Assembly& assembly, const Network& network)
{
    std::string text = headline(assembly, network);
    text += fmt::format("words       {}\n", textOf(assembly.parts));
    for (std::size_t k = 0; k < network.bars.size(); ++k) {
        const NetworkBar& bar = network.bars[k];
        std::int64_t cells = 0;
        for (const CellRow& row : network.rows) {
            cells += row.left >= bar.firstNode && row.right <= bar.lastNode ? row.cells : 0;
        }
        text += fmt::format("bar {:<8}{} cells, {}\n", k + 1, cells,
                            bar.drifts() ? "held nowhere: it drifts"
                                         : fmt::format("{} clamp{}, {} spring{}", bar.clamps,
                                                       bar.clamps == 1 ? "" : "s", bar.springs,
                                                       bar.springs == 1 ? "" : "s"));
    }
    const std::vector<double> places = placesOf(network, assembly.length);
    std::size_t number = 0;
    for (const NetworkContact& contact : network.contacts) {
        text +=
            fmt::format("contact {:<4}{} at x = {:.6g} m, {:.6g} m\n", ++number, name(contact.kind),
                        places[contact.node], contact.gap * network.scales.displacement);
    }
    return text;
}

}  // namespace

ExitStatus runScene(const Given& given)
{
    CommonOptions common(given);
    for (const std::string& word : given.words()) {
        common.sceneText += (common.sceneText.empty() ? "" : " ") + word;
    }
    const Assembly& assembly = common.assembly();
    const Network network = networkOf(assembly);
    Outputs outputs(given, {"--figure"});
    outputs.draw("--figure", [&] { return sceneFigure(assembly); });
    outputs.commit();
    if (common.wantsJson) {
        Json json = newAnswer();
        json.update(Json{{"status", "done"},
                         {"text", textOf(assembly.parts)},
                         {"scene", jsonOf(assembly)},
                         {"contacts", jsonOf(contactsOf(network, assembly.length))},
                         {"reference", jsonOf(referenceOf(network))}});
        writeOut(asLine(json));
    } else {
        writeOut(asText(assembly, network));
    }
    common.useOneThread();
    return exitFound;
}

}  // namespace signorini::cli
