#pragma once
/// \file
/// JSON pieces that several commands print. Numbers that are not finite print as null.

#include <nlohmann/json.hpp>
#include <vector>

#include "signorini/schedule.hpp"

namespace signorini::cli {

using Json = nlohmann::ordered_json;

/// [[n_c, n_f], ...].
inline Json phasesAsJson(const std::vector<Phase>& phases)
{
    Json list = Json::array();
    for (const Phase& phase : phases) {
        list.push_back({phase.contact, phase.free});
    }
    return list;
}

}  // namespace signorini::cli
