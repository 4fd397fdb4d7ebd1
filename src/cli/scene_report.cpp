#include "scene_report.hpp"

#include <fmt/format.h>

#include "hints.hpp"

namespace signorini::cli {

std::string headline(const Assembly& assembly, const Network& network)
{
    const SceneReference reference = referenceOf(network);
    std::string text = fmt::format("scene       {} bar{}, {} cells, {:.6g} m; c = {:.6g} m/s",
                                   network.bars.size(), network.bars.size() == 1 ? "" : "s",
                                   network.cells(), assembly.length, assembly.waveSpeed);
    if (assembly.gravity != 0.0) {
        text += fmt::format(", gravity {:.6g} m/s²", assembly.gravity);
    }
    if (reference.frequency > 0.0) {
        text += fmt::format(", ω₁ = {:.6g} Hz", answers::firstHertz(reference));
    }
    if (reference.damping && *reference.damping > 0.0) {
        text += fmt::format(", ζ = {:.4g}", *reference.damping);
    }
    if (reference.energy && *reference.energy > 0.0) {
        text += fmt::format(", E₁ = {:.6g} J", *reference.energy);
    }
    return text + "\n" + youngNote(assembly.young);
}

}  // namespace signorini::cli
