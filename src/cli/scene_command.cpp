#include "scene_command.hpp"

#include "files.hpp"
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

void SceneCommand::addTo(CLI::App& command)
{
    addWords(command, "words", "TEXT", words, "TEXT or FILE.json: the words of the scene");
    addFigure(command, "--figure", figureFile, "draw it");
    common.addTo(command, false);
    addFooter(command,
              "Elements, from left to right, separated by blanks: clamp, free, N[:Z[:C]] cells, "
              "gap=G, stop=G "
              "(to the right), stop=-G\n(to the left), dash=D, spring=K, mass=M, force=F, driven, "
              "shaken. "
              "Example: signorini scene clamp 150 gap=1e-3 200:1.3 clamp");
}

ExitStatus SceneCommand::run() const
{
    CommonOptions given = common;
    for (const std::string& word : words) {
        given.sceneText += (given.hasScene() ? " " : "") + word;
    }
    const Assembly& assembly = given.assembly();
    const Network network = networkOf(assembly);
    Outputs outputs({{"--figure", figureFile}});
    outputs.put("--figure", [&](const std::string& path) {
        drawFigure(sceneFigure(assembly), figureFormat(figureFile), path);
    });
    outputs.commit();
    if (common.wantsJson) {
        Json json = newAnswer();
        json.update(Json{{"status", "done"},
                         {"text", textOf(assembly.parts)},
                         {"scene", cli::asJson(assembly)},
                         {"contacts", contactsAsJson(network, assembly.length)},
                         {"reference", referenceAsJson(network)}});
        writeOut(asLine(json));
    } else {
        writeOut(asText(assembly, network));
    }
    common.useOneThread("scene");
    return exitFound;
}

}  // namespace signorini::cli
