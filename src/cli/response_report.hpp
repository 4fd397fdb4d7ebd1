#pragma once
/// \file
/// A response in words, as JSON and as a table.

#include <optional>
#include <string>
#include <vector>

#include "signorini/bar.hpp"
#include "signorini/response.hpp"

namespace signorini::cli {

/// The outcome of one call.
struct ResponseAnswer {
    ResponseRange range;
    Scene scene;
    Bar bar;                                     ///< what units mean: of the first material
    double amplitude = 0.0;                      ///< [N] or [m]
    std::vector<FrequencyResponse> frequencies;  ///< motions without their states
    bool isComplete = true;                      ///< false: interrupted
    std::optional<double> yieldStress = {};      ///< [Pa], the stress is compared with it

    [[nodiscard]] std::size_t motions() const
    {
        std::size_t count = 0;
        for (const FrequencyResponse& response : frequencies) {
            count += response.motions.size();
        }
        return count;
    }
    [[nodiscard]] std::int64_t undecided() const
    {
        std::int64_t count = 0;
        for (const FrequencyResponse& response : frequencies) {
            count += response.undecided;
        }
        return count;
    }
    /// Found, also if there is no motion: the list is whole. Undecided if it is not.
    [[nodiscard]] Status status() const
    {
        return isComplete && undecided() == 0 ? Status::found : Status::undecided;
    }
};

/// Several lines for people, with a final newline: where it rattles, the worst values and where.
[[nodiscard]] std::string asText(const ResponseAnswer& answer);

/// The JSON of the contract, with a final newline.
[[nodiscard]] std::string asJson(const ResponseAnswer& answer);

/// A row for each motion, and one for each frequency without any. \throws FileError.
void writeResponseCsv(const std::string& path, const ResponseAnswer& answer);

}  // namespace signorini::cli
