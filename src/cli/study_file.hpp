#pragma once
/// \file
/// The question of a study as a TOML file: its keys are the options of `sweep` without their two
/// hyphens, and gap, damping and the amplitude may be lists of values.

#include <string>
#include <string_view>

#include "study_answer.hpp"

namespace signorini::cli {

/// What a study asks.
struct StudyQuestion {
    std::string text;  ///< all on one line but gap, damping and amplitude, whose values may grow
    std::vector<answers::StudyCase> cases;
    std::string restated;  ///< the line of the bar, as it is in the first of them
};

/// Is an option, without its hyphens, one of sweep that such a file may hold?
[[nodiscard]] bool isStudyKey(std::string_view name);

/// \throws std::invalid_argument naming the place or the key, and what is allowed.
[[nodiscard]] StudyQuestion studyQuestionOf(const std::string& toml);

}  // namespace signorini::cli
