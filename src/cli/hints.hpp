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

using answers::sizeOf;

/// A line on a modulus that no bar has: GPa was meant. Empty of others.
[[nodiscard]] std::string youngNote(const std::optional<double>& young);

}  // namespace signorini::cli
