#include "signorini/modes.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numeric>

#include "echo.hpp"
#include "family_chains.hpp"
#include "faults.hpp"
#include "integers.hpp"
#include "rational.hpp"

namespace signorini {

namespace {

void check(Faults& faults, const FamilyBounds& bounds)
{
    faults.requirePositive("maxPeriod", bounds.maxPeriod, "L/c");
    if (!(bounds.maxEnergyRatio > 0.0)) {
        faults.add("maxEnergyRatio", bounds.maxEnergyRatio, "numbers > 0 [E_1]");
    }
}

/// The largest nu with 2 nu/w <= maxPeriod, at most that of T < 4. The sign of a sum rounded once
/// is the sign of the sum.
std::int64_t mostBlocks(std::int64_t order, double maxPeriod)
{
    if (maxPeriod >= 4.0) {
        return 2 * order - 1;
    }
    const auto isWithin = [&](std::int64_t blocks) {
        return std::fma(maxPeriod, static_cast<double>(order),
                        -2.0 * static_cast<double>(blocks)) >= 0.0;
    };
    auto blocks = static_cast<std::int64_t>(maxPeriod * static_cast<double>(order) / 2.0);
    while (isWithin(blocks + 1)) {
        ++blocks;
    }
    while (blocks > 0 && !isWithin(blocks)) {
        --blocks;
    }
    return std::min(blocks, 2 * order - 1);
}

/// All blocks in contact: the tip presses for ever.
Family held(std::int64_t order)
{
    return {order, 1, 1, order};
}

/// The families of one order.
bool forEachOfOrder(std::int64_t order, const FamilyBounds& bounds, const FamilyVisitor& visitor)
{
    const std::int64_t leastWindow = leastWindowSum(order, bounds.maxEnergyRatio);
    const std::int64_t last = mostBlocks(order, bounds.maxPeriod);
    if (bounds.gapSign < 0 && last >= 1 && bounds.maxEnergyRatio >= 1.0 && !visitor(held(order))) {
        return false;
    }
    for (std::int64_t blocks = 1; blocks <= last; ++blocks) {
        if (isRequested(bounds.cancel)) {
            return false;
        }
        if (std::gcd(order, blocks) == 1 &&
            !forEachContact(order, blocks, leastWindow, bounds.gapSign, std::cref(visitor))) {
            return false;
        }
    }
    return true;
}

/// The family, if gcd(w, nu) = 1 and k belongs to one of the chains.
std::optional<Family> familyAt(std::int64_t order, std::int64_t blocks, std::int64_t contactBlocks,
                               int gapSign)
{
    if (gapSign < 0 && blocks == contactBlocks) {
        return held(order);
    }
    if (std::gcd(order, blocks) != 1 || blocks >= 2 * order) {
        return std::nullopt;
    }
    const FamilyChains all(order, blocks, 1, gapSign);
    for (const FamilyChain& chain : all.chains()) {
        const std::int64_t above = contactBlocks - chain.least;
        if (above >= 0 && above % chain.step() == 0 && above / chain.step() < chain.count) {
            return chain.family(order, blocks, above / chain.step());
        }
    }
    return std::nullopt;
}

}  // namespace

ExactPeriod exactPeriod(const Family& family)
{
    return exactPeriod(2 * family.blocks, family.order);
}

ExactPeriod longestContact(const Family& family)
{
    return exactPeriod(2 * family.contactBlocks, family.order);
}

ExactEnergy leastEnergy(const Family& family)
{
    if (family.windowSum == 0) {
        return {0, 1};
    }
    const std::int64_t common = std::gcd(family.order, family.windowSum);
    const std::int64_t root = family.order / common;
    const std::int64_t sum = family.windowSum / common;
    return {root * root, sum * sum};
}

Fraction lowestTip(const Family& family, int gapSign)
{
    if (gapSign == 0 || family.windowSum == 0) {
        throw std::invalid_argument(
            "gap sign = 0: allowed 1 or -1: without a gap motions have any "
            "size");
    }
    // From block 0 on the signs go round by w; a flight between changes them.
    const auto blocks = static_cast<std::size_t>(family.blocks);
    std::vector<std::int8_t> signs(blocks);
    std::int8_t sign = 1;
    std::int64_t at = 0;
    for (std::size_t k = 0; k < blocks; ++k) {
        signs[static_cast<std::size_t>(at)] = sign;
        sign = static_cast<std::int8_t>(at < family.contactBlocks ? sign : -sign);
        at = (at + family.order) % family.blocks;
    }
    std::int64_t prefix = 0;
    std::int64_t lowest = 0;
    for (auto k = static_cast<std::size_t>(family.contactBlocks); k < blocks; ++k) {
        prefix += signs[k];
        lowest = std::min(lowest, prefix);
    }
    const std::int64_t window = std::abs(family.windowSum);
    const std::int64_t numerator = gapSign * window + 2 * lowest;
    const std::int64_t common = std::gcd(numerator, window);
    return {numerator / common, window / common};
}

bool staysClear(const Family& family, const Stops& stops)
{
    if (!stops.left || stops.right == 0) {
        return true;
    }
    const Fraction lowest = lowestTip(family, stops.right);
    return Integer(-lowest.numerator) * stops.left->denominator <=
           Integer(stops.left->numerator) * lowest.denominator;
}

std::optional<Family> findFamily(std::int64_t order, std::int64_t blocks,
                                 std::int64_t contactBlocks, int gapSign)
{
    Faults faults;
    faults.requireWhole("order", order, maxFamilyOrder);
    faults.requireWhole("blocks", blocks, maxSteps);
    faults.requireWhole("contactBlocks", contactBlocks, maxSteps);
    faults.throwIfAny();
    if (blocks == contactBlocks && blocks > 1) {
        return std::nullopt;  // it repeats (w, 1, 1)
    }
    return familyAt(order, blocks, contactBlocks, gapSign);
}

bool forEachFamily(std::int64_t maxOrder, const FamilyBounds& bounds, const FamilyVisitor& visitor)
{
    Faults faults;
    faults.requireWhole("maxOrder", maxOrder, maxFamilyOrder);
    check(faults, bounds);
    faults.throwIfAny();
    for (std::int64_t order = 1; order <= maxOrder; ++order) {
        if (!forEachOfOrder(order, bounds, visitor)) {
            return false;
        }
    }
    return true;
}

std::vector<Family> findFamilies(std::int64_t maxOrder, const FamilyBounds& bounds)
{
    std::vector<Family> families;
    forEachFamily(maxOrder, bounds, [&families](const Family& family) {
        families.push_back(family);
        return true;
    });
    return families;
}

std::vector<Family> familiesAt(std::int64_t order, std::int64_t blocks, int gapSign)
{
    Faults faults;
    faults.requireWhole("order", order, maxFamilyOrder);
    faults.requireWhole("blocks", blocks, maxSteps);
    if (std::gcd(order, blocks) != 1) {
        faults.add("blocks", blocks, fmt::format("those without common factor with {}", order));
    }
    faults.throwIfAny();
    std::vector<Family> families;
    if (blocks == 1 && gapSign < 0) {
        families.push_back(held(order));
    }
    if (blocks < 2 * order) {
        forEachContact(order, blocks, 1, gapSign, [&families](const Family& family) {
            families.push_back(family);
            return true;
        });
    }
    return families;
}

Schedule scheduleOf(const Family& family, std::int64_t cells)
{
    Faults faults;
    faults.requireWhole("cells", cells, maxCells);
    if (family.order < 1 || 2 * cells % family.order != 0) {
        faults.add("cells", cells, fmt::format("multiples of {}/2", family.order));
    }
    faults.throwIfAny();
    const std::int64_t classes = 2 * cells / family.order;
    const std::int64_t free = isHeld(family) ? 1 : (family.blocks - family.contactBlocks) * classes;
    if (isHeld(family) && classes == 1) {
        faults.add("cells", cells, fmt::format("those above {}/2", family.order));
        faults.throwIfAny();
    }
    return {cells,
            {{family.blocks * classes - free, free}},
            {.right = (family.windowSum < 0 ? 1 : 0) - (family.windowSum > 0 ? 1 : 0)}};
}

std::optional<TentPlace> familyOf(const Schedule& schedule)
{
    validate(schedule);
    if (schedule.phases.size() != 1) {
        throw std::invalid_argument(
            fmt::format("phases: {} given: allowed 1 (families have one contact phase)",
                        schedule.phases.size()));
    }
    const std::int64_t contact = schedule.phases.front().contact;
    const std::int64_t n = steps(schedule);
    TentPlace place;
    place.classes = std::gcd(2 * schedule.cells, n);
    const std::int64_t blocks = n / place.classes;
    // The multiple of G next to n_c, k = nu (mod 2): live classes have an even number of free
    // steps.
    std::int64_t contactBlocks = contact / place.classes;
    contactBlocks += flightsFactor(blocks - contactBlocks) == 1 ? 0 : 1;
    place.offset = contact - contactBlocks * place.classes;
    place.amplitudes = place.classes - std::abs(place.offset);
    const auto family = contactBlocks > 0 && place.amplitudes > 0
                            ? familyAt(2 * schedule.cells / place.classes, blocks, contactBlocks,
                                       schedule.stops.right)
                            : std::nullopt;
    if (!family) {
        return std::nullopt;
    }
    place.family = *family;
    return place;
}

Mode modeThrough(const Family& family)
{
    const int gapSign = family.windowSum < 0 ? 1 : -1;
    const auto found = findFamily(family.order, family.blocks, family.contactBlocks, gapSign);
    if (found != family || isHeld(family)) {
        throw std::invalid_argument(
            fmt::format("family: w = {}, nu = {}, k = {}, win = {} is none: allowed what "
                        "findFamily returns",
                        family.order, family.blocks, family.contactBlocks, family.windowSum));
    }
    // 2a = k/w (mod nu), between 0 and nu.
    const std::int64_t count =
        family.contactBlocks * inverseOf(family.order, family.blocks) % family.blocks;
    const std::int64_t b = (family.contactBlocks - count * family.order) / family.blocks;
    return findMode(count / 2, b, gapSign).value();
}

std::vector<Family> familiesOf(const Mode& mode, std::int64_t maxOrder)
{
    Faults faults;
    faults.requireWhole("maxOrder", maxOrder, maxFamilyOrder);
    faults.throwIfAny();
    if (findMode(mode.a, mode.b, mode.gapSign) != mode) {
        throw std::invalid_argument(fmt::format(
            "mode: t_c = {} {:+} T is none: allowed what findMode returns", 4 * mode.a, mode.b));
    }
    std::vector<Family> families;
    for (std::int64_t order = 1; order <= maxOrder; ++order) {
        // lowest < 2 nu/w < highest.
        const std::int64_t after = mode.lowest.numerator * order / (2 * mode.lowest.denominator);
        for (std::int64_t blocks = after + 1;
             2 * blocks * mode.highest.denominator < mode.highest.numerator * order; ++blocks) {
            if (std::gcd(order, blocks) == 1) {
                families.push_back({order, blocks, 2 * mode.a * order + mode.b * blocks,
                                    mode.mu * order - 2 * mode.kappa * blocks});
            }
        }
    }
    return families;
}

}  // namespace signorini
