#include "signorini/lumped_set.hpp"

#include <algorithm>
#include <numeric>

#include "echo.hpp"
#include "stops.hpp"

namespace signorini {

namespace {

/// First classes of the types, and G at the end.
std::vector<std::int64_t> cuts(const std::vector<std::int64_t>& boundaries, std::int64_t classes)
{
    std::vector<std::int64_t> result{0, classes};
    for (const std::int64_t step : boundaries) {
        result.push_back(step % classes);
    }
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
}

/// The sign that p has where it pushes in step m; 0 in flight. Stretches alternate, contact first.
int pushSignAt(const ClassTypes& all, const std::vector<std::int64_t>& boundaries,
               std::int64_t step)
{
    const auto after = std::upper_bound(boundaries.begin(), boundaries.end(), step);
    const auto stretch = static_cast<std::size_t>(after - boundaries.begin()) - 1;
    return stretch % 2 == 0 ? pushSign(all.schedule.phases[stretch / 2].stop) : 0;
}

void findKind(ClassType& type, const ClassTypes& all, const std::vector<std::int64_t>& boundaries)
{
    std::vector<int> push(static_cast<std::size_t>(all.members));
    for (std::int64_t alpha = 0; alpha < all.members; ++alpha) {
        push[static_cast<std::size_t>(alpha)] =
            pushSignAt(all, boundaries, alpha * all.classes + type.first);
    }
    type.contactMembers = all.members - std::count(push.begin(), push.end(), 0);
    if (flightsFactor(all.members - type.contactMembers) != 1) {
        type.kind = TypeKind::dead;
        return;
    }
    type.signs.resize(static_cast<std::size_t>(all.members));
    const std::int64_t stride = all.window % all.members;
    std::size_t alpha = 0;
    std::int8_t sign = 1;
    for (std::int64_t visited = 0; visited < all.members; ++visited) {
        type.signs[alpha] = sign;
        sign = static_cast<std::int8_t>(echoFactor(push[alpha] != 0) * sign);
        alpha = static_cast<std::size_t>((static_cast<std::int64_t>(alpha) + stride) % all.members);
    }
    int pushing = 0;
    int pulling = 0;
    for (std::size_t k = 0; k < push.size(); ++k) {
        pushing += push[k] * type.signs[k] > 0 ? 1 : 0;
        pulling += push[k] * type.signs[k] < 0 ? 1 : 0;
    }
    if (pushing > 0 && pulling > 0) {
        type.kind = TypeKind::blocked;
        return;
    }
    type.kind = pushing + pulling > 0 ? TypeKind::pressing : TypeKind::grazing;
    if (pulling > 0) {
        for (std::int8_t& s : type.signs) {
            s = static_cast<std::int8_t>(-s);
        }
    }
    for (std::int64_t block = 0; block < all.window; ++block) {
        type.windowSum += type.signs[static_cast<std::size_t>(block % all.members)];
    }
}

}  // namespace

ClassTypes classTypes(const Schedule& schedule)
{
    validate(schedule);
    ClassTypes all;
    all.schedule = schedule;
    fold(all.schedule);
    const std::int64_t n = steps(all.schedule);
    all.classes = std::gcd(2 * all.schedule.cells, n);
    all.members = n / all.classes;
    all.window = 2 * all.schedule.cells / all.classes;
    const std::vector<std::int64_t> stretches = stretchesOf(all.schedule);
    const std::vector<std::int64_t> firsts = cuts(stretches, all.classes);
    for (std::size_t k = 0; k + 1 < firsts.size(); ++k) {
        ClassType type;
        type.first = firsts[k];
        type.count = firsts[k + 1] - firsts[k];
        findKind(type, all, stretches);
        all.kernelDimension += type.kind == TypeKind::dead ? 0 : type.count;
        all.types.push_back(std::move(type));
    }
    return all;
}

std::vector<std::int64_t> stretchesOf(const Schedule& schedule)
{
    std::vector<std::int64_t> steps{0};
    for (const Phase& phase : schedule.phases) {
        steps.push_back(steps.back() + phase.contact);
        steps.push_back(steps.back() + phase.free);
    }
    return steps;
}

std::vector<Block> blocksOf(const ClassTypes& classes)
{
    std::vector<Block> blocks;
    blocks.reserve(static_cast<std::size_t>(classes.members) * classes.types.size());
    forEachBlock(classes, [&blocks](const Block& block) { blocks.push_back(block); });
    return blocks;
}

}  // namespace signorini
