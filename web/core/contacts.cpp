// Two contacts in a period, between the grids: polygons of motions in period and first contact, and
// the motions at their points.

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "reports.hpp"
#include "views.hpp"

namespace signorini::web {

namespace {

constexpr int samplesOfPolygon = 48;
constexpr std::int64_t mostJumps = 200;  // of a chain of the page

/// The motions of one period, from the shortest first contact to the longest.
struct Slice {
    std::vector<ModePoint> ends;
    std::vector<double> contacts;

    Slice(const ModePolytope& polytope, double period) : ends(slice(polytope, period))
    {
        const auto first = [&](const ModePoint& point) {
            return std::max(0.0, stretches(polytope, point).front());
        };
        std::sort(ends.begin(), ends.end(),
                  [&](const ModePoint& x, const ModePoint& y) { return first(x) < first(y); });
        for (const ModePoint* end : {&ends.front(), &ends.back()}) {
            contacts.push_back(first(*end));
        }
    }
    [[nodiscard]] ModePoint at(double split) const
    {
        ModePoint point = ends.front();
        for (std::size_t k = 0; k < point.arrivals.size(); ++k) {
            point.arrivals[k] = std::lerp(point.arrivals[k], ends.back().arrivals[k], split);
        }
        return point;
    }
};

/// The polygon of "chains", [[k, turns, release], ...], that has motions of "period".
ModePolytope polygonOf(const Request& request, double period)
{
    std::vector<ModeChain> chains;
    for (const auto& [k, turns, release] : request.triples("chains", mostJumps)) {
        chains.push_back(
            {static_cast<std::size_t>(std::max<std::int64_t>(release, 1) - 1), k, turns});
    }
    const std::vector<ModePolytope> all = polytopesOf(chains);
    for (const ModePolytope& polytope : all) {
        if (polytope.lowest.value() < period && period < polytope.highest.value()) {
            return polytope;
        }
    }
    throw std::invalid_argument(all.empty()
                                    ? "chains: no motion has contacts connected like that"
                                    : "period = " + std::to_string(period) + ": allowed above " +
                                          cli::fractionAsText(all.front().lowest) + " and below " +
                                          cli::fractionAsText(all.back().highest) + " L/c");
}

ModePoint pointOf(const Request& request, const ModePolytope& polytope, double period)
{
    return Slice(polytope, period).at(request.number("split", 0.001, 0.999));
}

/// The grid points of the polygon with this period, as nearly as steps can have it: the one whose
/// first contact is nearest.
std::optional<Schedule> nearestSchedule(const ModePolytope& polytope, const ModeMotion& motion,
                                        std::int64_t cells)
{
    const auto perCrossing = static_cast<double>(cells);
    const std::int64_t steps = std::llround(motion.period() * perCrossing);
    const std::vector<Schedule> all = schedulesOf(polytope, cells, steps);
    const double wanted = motion.contacts().front().second * perCrossing;
    const auto distance = [wanted](const Schedule& schedule) {
        return std::abs(static_cast<double>(schedule.phases.front().contact) - wanted);
    };
    const auto best = std::min_element(
        all.begin(), all.end(),
        [&](const Schedule& x, const Schedule& y) { return distance(x) < distance(y); });
    return best == all.end() ? std::nullopt : std::optional(*best);
}

}  // namespace

answers::PolytopeList polygonsOf(const Request& request)
{
    ModeBounds bounds;
    bounds.maxOrder = request.whole("order", 1, 25);
    bounds.maxPeriod = 8.0;
    return {2, bounds, bar, findPolytopes(2, bounds)};
}

Reply showPolygons(const Request& request)
{
    Reply reply;
    reply.json["polygons"] = Json::array();
    std::vector<double> samples;  // T, E/E_1, least and most first contact
    for (const ModePolytope& polytope : polygonsOf(request).polytopes) {
        Json one = cli::jsonOf(answers::PolytopeOf{polytope, bar});
        one["lowest"] = polytope.lowest.value();
        one["highest"] = polytope.highest.value();
        reply.json["polygons"].push_back(std::move(one));
        for (int k = 0; k < samplesOfPolygon; ++k) {
            const double share = std::clamp(k / (samplesOfPolygon - 1.0), 1e-6, 1.0 - 1e-6);
            const double period =
                std::lerp(polytope.lowest.value(), polytope.highest.value(), share);
            const Slice motions(polytope, period);
            samples.insert(samples.end(), {period, energyRatio(polytope, period),
                                           motions.contacts.front(), motions.contacts.back()});
        }
    }
    reply.json["samples"] = samplesOfPolygon;
    reply.add("bands", samples);
    return reply;
}

Reply showPolygon(const Request& request)
{
    Reply reply;
    const double period = request.number("period", 0.0, 8.0);
    const ModePolytope polytope = polygonOf(request, period);
    const Slice motions(polytope, period);
    const ModePoint point = pointOf(request, polytope, period);
    const ModeMotion motion(polytope, point);
    const std::int64_t cells = request.whole("cells", 2, mostCells);
    reply.json["answer"] = {{"polytope", cli::jsonOf(answers::PolytopeOf{polytope, bar})},
                            {"text", cli::chainsAsText(polytope.chains)},
                            {"period_ratio", period},
                            {"frequency_ratio", 4.0 / period},
                            {"contact_time_ratio", motion.contactTime()},
                            {"energy_ratio", energyRatio(polytope, period)},
                            {"stretches", stretches(polytope, point)},
                            {"first_contact_range", motions.contacts},
                            {"physical", cli::jsonOf(physicalOf(motion.extremes(), bar))}};
    reply.json["nearest"] = nullptr;
    if (const auto schedule = nearestSchedule(polytope, motion, cells)) {
        reply.json["nearest"] = cli::jsonOf(schedule->phases);
    }
    addMode(reply, motion, cells);
    return reply;
}

ModeMotion polygonMotion(const Request& request)
{
    const double period = request.number("period", 0.0, 8.0);
    const ModePolytope polytope = polygonOf(request, period);
    return {polytope, pointOf(request, polytope, period)};
}

}  // namespace signorini::web
