#pragma once
/// \file
/// What a wrong word was probably meant to be: an option that is spelt otherwise.

#include <string>
#include <string_view>
#include <vector>

#include "signorini/bar.hpp"

namespace signorini::cli {

/// The name nearest to a word: a letter or two (of six and more) that differ, lack, are too many or
/// change places, "_" and "-" being one. Empty if none is as near.
[[nodiscard]] std::string nearestName(std::string_view word, const std::vector<std::string>& names);

/// "; did you mean NAME?", or nothing where no name is near.
[[nodiscard]] std::string didYouMean(std::string_view word, const std::vector<std::string>& names);

/// "L = 1 m, c = 1 m/s by default" or, of a bar that was described, "L = 3 m, c = 5000 m/s".
[[nodiscard]] std::string sizeOf(const Bar& bar);

}  // namespace signorini::cli
