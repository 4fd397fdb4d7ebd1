#pragma once
/// \file
/// signorini scene TEXT|FILE.json: what a scene is, converted and drawn.

#include <string>
#include <vector>

#include "scene_options.hpp"

namespace signorini::cli {

/// One call.
struct SceneCommand {
    CommonOptions common;
    std::vector<std::string> words;  ///< of the scene
    std::string figureFile;

    void addTo(CLI::App& command);

    /// Does the work; the report goes to stdout. Exceptions are for `main` to translate.
    [[nodiscard]] ExitStatus run() const;
};

}  // namespace signorini::cli
