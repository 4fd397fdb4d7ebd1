#pragma once
/// \file
/// What a wrong word was probably meant to be: an option that is spelt otherwise.

#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "asked_period.hpp"

namespace signorini::cli {

/// The name nearest to a word: a letter or two (of six and more) that differ, lack, are too many or
/// change places, "_" and "-" being one. Empty if none is as near.
[[nodiscard]] std::string nearestName(std::string_view word, const std::vector<std::string>& names);

/// "; did you mean NAME?", or nothing where no name is near.
[[nodiscard]] std::string didYouMean(std::string_view word, const std::vector<std::string>& names);

/// "; 530 looks like Hz: ω₁ is 494 Hz (L = 3 m, ...), so it is --to 530Hz, or --to 1.07", of a
/// ratio that was typed after an option; nothing where it is none of those that are mistaken.
[[nodiscard]] std::string looksLikeHertz(std::string_view option, double ratio, double hertz,
                                         const std::string& size);

using answers::sizeOf;

/// A line on a modulus that no bar has: GPa was meant. Empty of others.
[[nodiscard]] std::string youngNote(const std::optional<double>& young);

/// Does what may refuse such a ratio; a refusal says whether it looks like Hz.
auto hinting(std::string_view option, const std::optional<double>& ratio, double hertz,
             const Bar& bar, auto does)
{
    try {
        return does();
    } catch (const std::invalid_argument& error) {
        throw std::invalid_argument(
            error.what() + (ratio ? looksLikeHertz(option, *ratio, hertz, sizeOf(bar)) : ""));
    }
}

}  // namespace signorini::cli
