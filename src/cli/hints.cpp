#include "hints.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "options.hpp"

namespace signorini::cli {

namespace {

/// Letters that differ, lack, are too many or change places (optimal string alignment).
std::size_t distance(std::string_view one, std::string_view two)
{
    std::vector<std::size_t> before;
    std::vector<std::size_t> last(two.size() + 1);
    std::vector<std::size_t> row(two.size() + 1);
    std::iota(last.begin(), last.end(), std::size_t{0});
    for (std::size_t i = 1; i <= one.size(); ++i) {
        row[0] = i;
        for (std::size_t j = 1; j <= two.size(); ++j) {
            const bool isSame = one[i - 1] == two[j - 1];
            row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (isSame ? 0 : 1)});
            if (i > 1 && j > 1 && one[i - 1] == two[j - 2] && one[i - 2] == two[j - 1]) {
                row[j] = std::min(row[j], before[j - 2] + 1);
            }
        }
        before = last;
        last = row;
    }
    return last.back();
}

}  // namespace

std::string nearestName(std::string_view word, const std::vector<std::string>& names)
{
    constexpr std::size_t longest = 60;
    std::string plain(word.substr(0, word.find('=')));
    if (plain.size() > longest) {
        return {};
    }
    std::replace(plain.begin(), plain.end(), '_', '-');
    // Two dashes are no letters.
    const std::size_t letters = plain.size() - (plain.starts_with("--") ? 2 : 0);
    std::size_t least = letters >= 6 ? 3 : letters >= 3 ? 2 : 1;
    std::string nearest;
    for (const std::string& name : names) {
        if (const std::size_t here = distance(plain, name); here < least) {
            least = here;
            nearest = name;
        }
    }
    // The beginning of a single name.
    const auto begins = [&plain](const std::string& name) { return name.starts_with(plain); };
    const auto first = std::find_if(names.begin(), names.end(), begins);
    if (letters >= 4 && first != names.end() &&
        std::none_of(first, names.end(),
                     [&](const std::string& name) { return begins(name) && name != *first; })) {
        nearest = *first;
    }
    return nearest;
}

std::string didYouMean(std::string_view word, const std::vector<std::string>& names)
{
    const std::string nearest = nearestName(word, names);
    return nearest.empty() ? "" : fmt::format("; did you mean {}?", nearest);
}

std::string youngNote(const std::optional<double>& young)
{
    return young && *young < answers::softestModulus
               ? fmt::format(
                     "note        E = {0:.6g} Pa is softer than rubber: {0:.6g} GPa are "
                     "--young {1:.6g}\n",
                     *young, *young * 1e9)
               : "";
}

}  // namespace signorini::cli
