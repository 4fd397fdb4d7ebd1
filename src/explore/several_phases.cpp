#include "several_phases.hpp"

#include <algorithm>
#include <compare>
#include <numeric>
#include <stdexcept>

#include "signorini/lumped_set.hpp"

namespace signorini {

namespace {

/// The steps after which all motions of several phases repeat: where no live class touches the wall
/// p is antiperiodic after 2N; a list of phases that repeats a shorter one with as large a kernel
/// has the same motions.
std::int64_t ownSteps(const Schedule& schedule, std::size_t length, const ClassTypes& classes)
{
    const std::int64_t n = steps(schedule);
    if (std::none_of(classes.types.begin(), classes.types.end(), [](const ClassType& type) {
            return type.isLive() && type.contactMembers > 0;
        })) {
        return std::gcd(4 * schedule.cells, n);
    }
    if (length == schedule.phases.size()) {
        return n;
    }
    Schedule once{
        schedule.cells,
        {schedule.phases.begin(), schedule.phases.begin() + static_cast<std::ptrdiff_t>(length)},
        schedule.stops};
    return classTypes(once).kernelDimension == classes.kernelDimension ? steps(once) : n;
}

}  // namespace

Rotation rotationOf(const std::vector<Phase>& phases)
{
    const std::size_t count = phases.size();
    Rotation result{.length = count};
    for (std::size_t shift = count - 1; shift > 0; --shift) {
        std::size_t k = 0;
        auto order = std::strong_ordering::equal;
        while (k < count && order == std::strong_ordering::equal) {
            order = phases[(k + shift) % count] <=> phases[k];
            ++k;
        }
        result.isFirst = result.isFirst && order != std::strong_ordering::less;
        result.length = order == std::strong_ordering::equal ? shift : result.length;
    }
    return result;
}

AtlasRow decideSeveral(const Schedule& schedule, std::size_t length, std::int64_t number)
{
    AtlasRow row;
    row.number = number;
    row.steps = steps(schedule);
    LumpedSet set;
    try {
        set = lumpedSet(schedule);
    } catch (const std::overflow_error&) {
        return row;
    } catch (const std::invalid_argument&) {
        return row;
    }
    row.kernelDimension = set.classes.kernelDimension;
    if (set.absence) {
        row.status = Status::none;
        row.reason = absenceReason(set.classes);
        return row;
    }
    const LumpedShape shape = shapeOf(set);
    row.status = Status::found;
    row.kind = shape.kind;
    row.dimension = shape.dimension;
    row.energy = shape.energy;
    row.steps = ownSteps(schedule, length, set.classes);

    // In the motion of least energy a type presses where it has contact steps and a positive sum.
    row.contact = Contact::grazing;
    row.isCanonical = length == schedule.phases.size();
    std::size_t place = 0;
    for (const ClassType& type : set.classes.types) {
        const bool isPressed = type.isLive() && set.leastSums[place] > 0.0;
        place += type.isLive() ? 1 : 0;
        if (type.contactMembers > 0 && isPressed) {
            row.contact = Contact::pressing;
        } else if (type.contactMembers > 0) {
            row.isCanonical = false;
        }
    }
    return row;
}

}  // namespace signorini
