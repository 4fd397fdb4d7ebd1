#pragma once
/// \file
/// A scene in words.

#include <string>

#include "arguments.hpp"
#include "json.hpp"
#include "network.hpp"
#include "scene_answer.hpp"

namespace signorini::cli {

using answers::contactsOf;

/// The line that restates the bars.
[[nodiscard]] std::string headline(const Assembly& assembly, const Network& network);

/// Writes an answer about bars to standard output: JSON, or that line and the words.
void report(const CommonOptions& common, const auto& answer, const Assembly& assembly,
            const std::string& words)
{
    writeOut(common.wantsJson ? asLine(wholeJsonOf(answer))
                              : headline(assembly, networkOf(assembly)) + words);
}

}  // namespace signorini::cli
