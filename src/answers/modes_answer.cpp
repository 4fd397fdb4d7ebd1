#include "modes_answer.hpp"

#include <algorithm>
#include <array>

#include "faults.hpp"

namespace signorini::answers {

int gapSignOfModes(const Bar& bar)
{
    if (bar.gap == 0.0) {
        throwFault("gap", 0.0,
                   "a gap > 0 or < 0 [m]: without one modes have a single period each, which "
                   "families lists");
    }
    return bar.gap > 0.0 ? 1 : -1;
}

namespace {

/// The families, or those found until a signal came or the list was full.
void fill(FamilyList& list, const FamilyBounds& bounds, const Stops& stops, const Watch& watch)
{
    const auto last = static_cast<double>(list.maxOrder);
    std::int64_t order = 0;
    const bool isWhole = forEachFamily(list.maxOrder, bounds, [&](const Family& family) {
        if (family.order > order) {
            order = family.order;
            // The work up to an order grows with its square.
            const auto done = static_cast<double>(order - 1);
            watch.show(done * done, last * last);
        }
        if (!staysClear(family, stops)) {
            return true;
        }
        if (list.families.size() == FamilyList::most) {
            list.ended = fmt::format("{} families are the most in a list", FamilyList::most);
            return false;
        }
        list.families.push_back(family);
        return true;
    });
    if (!isWhole && list.ended.empty()) {
        // Who interrupts it does not wait until millions are printed.
        constexpr std::size_t shown = 10'000;
        const std::size_t found = list.families.size();
        list.ended = found > shown
                         ? fmt::format("interrupted, the first {} of {} found", shown, found)
                         : "interrupted";
        list.families.resize(std::min(found, shown));
    }
}

ModeBounds boundsAsked(const Call& call, std::int64_t phases, const Bar& bar)
{
    constexpr std::array<std::int64_t, maxPolytopePhases> orders{25, 25, 9, 5, 3};
    const auto index = std::clamp<std::int64_t>(phases, 1, maxPolytopePhases) - 1;
    ModeBounds bounds{.maxOrder = orders.at(static_cast<std::size_t>(index)),
                      .maxPeriod = std::max(8.0, 4.0 * static_cast<double>(phases)),
                      .gapSign = phases == 1 ? gapSignOfModes(bar) : stopsOf(bar).right};
    call.read("--max-order", bounds.maxOrder);
    if (phases > 1 && bounds.maxOrder > maxPolytopeOrder) {
        refuse("--max-order", fmt::format("{}", bounds.maxOrder),
               fmt::format("whole numbers 1..{} with several contacts", maxPolytopeOrder));
    }
    call.read("--max-period", bounds.maxPeriod);
    call.read("--max-energy-ratio", bounds.maxEnergyRatio);
    return bounds;
}

}  // namespace

Question<FamilyList> familiesAsked(const Call& call, const Scene& scene, double gravity)
{
    const Stops stops = stopsOf(scene);
    FamilyBounds bounds{.gapSign = stops.right};
    call.read("--max-energy-ratio", bounds.maxEnergyRatio);
    const std::int64_t maxOrder = call.whole("--max-order").value_or(12);
    return [=](const Watch& watch) {
        FamilyList list{maxOrder, bounds.maxEnergyRatio, scene.bar, {},
                        {},       scene.secondStop,      gravity};
        fill(list, watch.on(bounds), stops, watch);
        return list;
    };
}

Question<ModeList> modesAsked(const Call& call, const Bar& bar, double gravity)
{
    return [=, bounds = boundsAsked(call, 1, bar)](const Watch& watch) {
        std::vector<Mode> modes = findModes(watch.on(bounds));
        return ModeList{bounds, bar, std::move(modes), !isRequested(watch.cancel), gravity};
    };
}

Question<PolytopeList> polytopesAsked(const Call& call, std::int64_t phases, const Bar& bar,
                                      double gravity)
{
    return [=, bounds = boundsAsked(call, phases, bar)](const Watch& watch) {
        std::vector<ModePolytope> found = findPolytopes(phases, watch.on(bounds));
        const bool isComplete = !isRequested(watch.cancel);
        return PolytopeList{phases, bounds, bar, std::move(found), isComplete, gravity};
    };
}

ModeAnswer motionOf(const Mode& mode, const Bar& bar, double period, double gravity)
{
    const double sag = tipSag(bar, gravity) / scales(bar).displacement;
    return {mode, bar, ModeMotion(mode, period, sag), gravity};
}

std::tuple<std::int64_t, std::int64_t> contactOf(const Mode& mode)
{
    return {4 * mode.a, mode.b};
}

std::tuple<std::int64_t, std::int64_t> contactOf(const ModePolytope& polytope)
{
    std::int64_t sum = 0;
    for (const ModeChain& chain : polytope.chains) {
        sum += 2 * chain.k;
    }
    return {sum, -polytope.order};
}

std::optional<std::string> knownName(const Mode& mode)
{
    std::string name = familyName(mode);
    return name.empty() ? std::nullopt : std::optional(std::move(name));
}

}  // namespace signorini::answers
