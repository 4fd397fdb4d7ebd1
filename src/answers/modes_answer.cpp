#include "modes_answer.hpp"

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
