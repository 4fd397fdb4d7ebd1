#include "bridge.hpp"

#include <map>
#include <new>
#include <stdexcept>

#include "views.hpp"

namespace signorini::web {

namespace {

const std::map<std::string, Reply (*)(const Request&)>& views()
{
    static const std::map<std::string, Reply (*)(const Request&)> table{
        {"schedule", showSchedule},     {"mode", showMode},   {"forced", showForced},
        {"simulation", showSimulation}, {"map", showMap},     {"family", showFamily},
        {"response", showResponse},     {"file", download},   {"polygons", showPolygons},
        {"polygon", showPolygon},       {"scene", showScene}, {"sweep", showSweep},
    };
    return table;
}

Reply refusal(const char* why)
{
    Reply reply;
    reply.json["error"] = why;
    return reply;
}

}  // namespace

Reply answer(const std::string& question)
{
    try {
        const Request request = requestOf(question);
        const auto view = views().find(request.word("show"));
        if (view == views().end()) {
            throw std::invalid_argument("show = " + request.word("show") +
                                        ": there is no such view");
        }
        return view->second(request);
    } catch (const std::bad_alloc&) {
        return refusal(
            "A page has not the memory for that: fewer cells, or a shorter time; the "
            "command line has no such limit");
    } catch (const std::exception& fault) {
        return refusal(fault.what());
    }
}

}  // namespace signorini::web
