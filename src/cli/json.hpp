#pragma once
/// \file
/// JSON pieces that several commands print. Numbers that are not finite print as null.

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "signorini/bar.hpp"
#include "signorini/config.hpp"
#include "signorini/schedule.hpp"

namespace signorini::cli {

using Json = nlohmann::ordered_json;

/// [[n_c, n_f], ...]; a phase on the second stop is [n_c, n_f, "left"].
inline Json phasesAsJson(const std::vector<Phase>& phases)
{
    Json list = Json::array();
    for (const Phase& phase : phases) {
        list.push_back({phase.contact, phase.free});
        if (phase.stop == Stop::left) {
            list.back().push_back(name(phase.stop));
        }
    }
    return list;
}

/// The beginning of every answer: which form it has, and who gave it.
inline Json newAnswer()
{
    return {{"schema", 2}, {"version", SIGNORINI_VERSION}};
}

/// The bar asked about, in SI.
inline Json barAsJson(const Bar& bar)
{
    return {{"length", bar.length},
            {"wave_speed", bar.waveSpeed},
            {"axial_stiffness", bar.axialStiffness},
            {"gap", bar.gap},
            {"young", bar.young ? Json(*bar.young) : Json()}};
}

/// Adds bar, stops and segments to an answer.
inline void addScene(const Scene& scene, Json& json)
{
    json["bar"] = barAsJson(scene.bar);
    json["stops"] = Json::array({{{"side", name(Stop::right)}, {"place", scene.bar.gap}}});
    if (scene.secondStop) {
        json["stops"].push_back({{"side", name(Stop::left)}, {"place", -*scene.secondStop}});
    }
    json["segments"] = Json::array();
    for (const Segment& segment : scene.segments) {
        json["segments"].push_back({{"cells", segment.cells},
                                    {"impedance", segment.impedance},
                                    {"speed", segment.speed},
                                    {"dashpot", segment.dashpot}});
    }
    json["static_force"] = staticForce(scene);
}

/// One line. Bytes of a file name that are not UTF-8 become U+FFFD: JSON has no other way. DEL, the
/// one control character that JSON lets stand in a string, is escaped like the others.
inline std::string asLine(const Json& json)
{
    std::string line = json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
    for (auto at = line.find('\x7f'); at != std::string::npos; at = line.find('\x7f', at)) {
        line.replace(at, 1, "\\u007f");
    }
    return line;
}

}  // namespace signorini::cli
