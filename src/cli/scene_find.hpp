#pragma once
/// \file
/// find of a schedule of the bars of a scene.

#include <string>
#include <vector>

#include "find_command.hpp"
#include "reports.hpp"
#include "scene_figures.hpp"
#include "scene_find_answer.hpp"

namespace signorini::cli {

/// What is asked, and the files of the call.
struct SceneFind {
    const FindCommand& call;
    answers::BarsAsked bars;
    FindOutputs files;

    /// \throws std::invalid_argument as spansOf; FileError.
    explicit SceneFind(const FindCommand& of);

    /// With which an answer begins.
    [[nodiscard]] std::string lines(Status status) const;
    /// Writes the files of the motion, if there is one, a proof, if the answer is one, and the
    /// answer.
    [[nodiscard]] ExitStatus finish(const auto& answer, const NetworkClaim* motion, bool isProof,
                                    const std::string& text)
    {
        const std::string json = asLine(wholeJsonOf(answer));
        write(motion, isProof, json);
        writeOut(call.common.wantsJson ? json : text);
        return exitStatusOf(answer.status());
    }

private:
    void write(const NetworkClaim* motion, bool isProof, const std::string& json);
};

/// The waves in the files that a call names. It must outlive them.
[[nodiscard]] answers::WavesOf wavesIn(const Given& given);
/// Is any word SET:STEPS?
[[nodiscard]] bool hasSets(const Given& given);
/// SET:STEPS; of a bar by its options NC NF [L:NC NF ...], too.
/// \throws std::invalid_argument
[[nodiscard]] std::vector<ContactSpan> spansOf(const Given& given, const CommonOptions& common,
                                               std::size_t contacts);
/// "2 E₁", or in joules.
[[nodiscard]] std::string inWords(const answers::SceneSchedule& schedule, double energy,
                                  int digits = 6);
/// The line of what was tried, or none.
[[nodiscard]] std::string asText(const std::optional<answers::SceneStability>& tried);
[[nodiscard]] std::string asText(const answers::SceneStrains& strains);
/// Says on stderr where bars do not bear them.
void warnOf(const answers::SceneStrains& strains, const FindCommand& call);
/// \throws std::invalid_argument on --yield-stress of bars whose stress is not known, and on files
/// that show one bar only.
void requireOfBars(const FindCommand& call, const Assembly& assembly);
/// A line for each contact of a motion.
[[nodiscard]] std::string asText(const std::vector<answers::ContactInPeriod>& contacts);

}  // namespace signorini::cli
