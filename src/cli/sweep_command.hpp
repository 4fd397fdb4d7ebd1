#pragma once
/// \file
/// signorini sweep

#include <string>

#include "files.hpp"
#include "force_options.hpp"
#include "given.hpp"
#include "network.hpp"
#include "sweep_answer.hpp"

namespace signorini::cli {

/// One call.
struct SweepCommand {
    const Given& given;
    CommonOptions common;
    ForceOptions force;
    FrequencyOption frequency;
    Swept over;

    explicit SweepCommand(const Given& words);

    [[nodiscard]] ExitStatus run() const;

    /// What is asked of a bar, without points. \throws std::invalid_argument on options that are
    /// missing or do not go together.
    [[nodiscard]] answers::SweepAnswer question() const;

private:
    /// The same of the bars of a scene: its bar has the units of the answer, and as its first
    /// frequency that of the scene.
    [[nodiscard]] answers::SweepAnswer question(const Network& network) const;
    /// Follows a bar, or what `network` is.
    [[nodiscard]] ExitStatus run(answers::SweepAnswer answer, const Network* network) const;
    static void write(const answers::SweepAnswer& answer, const Network* network, Outputs& outputs);
    /// What a run that is resumed must have asked, on one line.
    [[nodiscard]] std::string questionOf(const answers::SweepAnswer& answer) const;
    /// In units of the bar.
    [[nodiscard]] SweepRange range(const Scene& scene, const Bar& bar) const;
    /// One end of it.
    [[nodiscard]] double end(const char* option, double otherwise, const Bar& bar) const;
};

}  // namespace signorini::cli
