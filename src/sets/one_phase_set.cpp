#include "signorini/one_phase_set.hpp"

#include <numeric>

#include "echo.hpp"
#include "faults.hpp"
#include "solution_set.hpp"

namespace signorini {

namespace {

/// Splits the steps into classes and finds the live ones.
void findLiveClasses(std::int64_t cells, const Phase& phase, int gapSign, Verdict& v)
{
    const std::int64_t n = phase.contact + phase.free;
    v.cells = cells;
    v.gapSign = gapSign;
    v.classes = std::gcd(2 * cells, n);
    v.members = n / v.classes;
    v.window = 2 * cells / v.classes;

    // Classes j < remainder hold quotient + 1 contact steps, the others quotient.
    const std::int64_t quotient = phase.contact / v.classes;
    const std::int64_t remainder = phase.contact % v.classes;
    const auto isLive = [&v](std::int64_t contacts) {
        return flightsFactor(v.members - contacts) == 1;
    };
    if (remainder > 0 && isLive(quotient + 1)) {
        v.firstLive = 0;
        v.kernelDimension = remainder;
        v.contactMembers = quotient + 1;
    } else if (isLive(quotient)) {
        v.firstLive = remainder;
        v.kernelDimension = v.classes - remainder;
        v.contactMembers = quotient;
    } else {
        v.firstLive = 0;
        v.kernelDimension = 0;
        v.contactMembers = 0;
    }
    v.contact = v.contactMembers > 0 ? Contact::pressing : Contact::grazing;
}

/// epsilon along the orbit alpha, alpha + w, alpha + 2w, ... (mod nu), from epsilon_0 = 1, into the
/// first nu of `signs`. Returns whether every contact epsilon is +1; if `stops`, the walk ends at
/// the first that is not.
bool findSigns(const Verdict& v, bool stops, std::vector<std::int8_t>& signs)
{
    if (signs.size() < static_cast<std::size_t>(v.members)) {
        signs.resize(static_cast<std::size_t>(v.members));
    }
    const std::int64_t stride = v.window % v.members;
    std::int64_t alpha = 0;
    std::int8_t sign = 1;
    bool agree = true;
    for (std::int64_t visited = 0; visited < v.members; ++visited) {
        signs[static_cast<std::size_t>(alpha)] = sign;
        if (alpha >= v.contactMembers) {
            sign = static_cast<std::int8_t>(flightFactor * sign);
        } else if (sign < 0) {
            agree = false;
            if (stops) {
                return false;
            }
        }
        alpha += stride;
        alpha -= alpha >= v.members ? v.members : 0;
    }
    return agree;
}

/// Sum of epsilon over blocks 0..w-1, epsilon being nu-periodic.
std::int64_t windowSumOf(const Verdict& v, const std::vector<std::int8_t>& signs)
{
    const auto sum = [&signs](std::int64_t end) {
        return std::accumulate(signs.data(), signs.data() + end, std::int64_t{0});
    };
    const std::int64_t turns = v.window / v.members;
    const std::int64_t rest = sum(v.window % v.members);
    return turns == 0 ? rest : rest + turns * sum(v.members);
}

/// The largest prefix sum of epsilon over the free blocks, if it is positive, and where.
struct WorstPrefix {
    std::int64_t block = -1;
    std::int64_t sum = 0;
};

WorstPrefix findWorstPrefix(const Verdict& v, bool stops, const std::vector<std::int8_t>& signs)
{
    WorstPrefix worst;
    std::int64_t prefix = 0;
    for (std::int64_t alpha = v.contactMembers; alpha < v.members; ++alpha) {
        prefix += signs[static_cast<std::size_t>(alpha)];
        if (prefix > worst.sum) {
            worst = {alpha, prefix};
            if (stops) {
                break;
            }
        }
    }
    return worst;
}

/// The first reason that applies. `contactsAgree`, `worstPrefix` and `windowSum` are asked in this
/// order, and only as far as needed.
template <typename Agreement, typename Prefix, typename Sum>
std::optional<Reason> firstReason(const Verdict& v, Agreement contactsAgree, Prefix worstPrefix,
                                  Sum windowSum)
{
    if (v.kernelDimension == 0) {
        return Reason::noLiveClass;
    }
    if (v.contact == Contact::grazing) {
        // u(L) goes to and fro around 0: beyond the wall unless that has a gap.
        return v.gapSign > 0 ? std::nullopt : std::optional(Reason::penetration);
    }
    if (!contactsAgree()) {
        return Reason::contactSign;
    }
    if (worstPrefix() > 0) {
        return Reason::penetration;
    }
    const std::int64_t window = windowSum();
    const bool fits = v.gapSign == 0 ? window == 0 : window * v.gapSign < 0;
    return fits ? std::nullopt : std::optional(Reason::gap);
}

}  // namespace

void onePhaseSet(const Schedule& schedule, OnePhaseSet& result)
{
    validate(schedule);
    if (schedule.phases.size() != 1) {
        throw std::invalid_argument(
            fmt::format("phases: {} given: allowed 1 (the closed form knows one contact phase)",
                        schedule.phases.size()));
    }
    if (schedule.stops.left) {
        throw std::invalid_argument("stops: two given: allowed 1 (the closed form knows one)");
    }
    result.schedule = schedule;
    fold(result.schedule);
    findLiveClasses(schedule.cells, result.schedule.phases.front(), schedule.stops.right, result);
    result.signs.clear();
    result.windowSum = result.worstPrefix = 0;
    result.worstBlock = -1;
    bool contactsAgree = true;
    if (result.kernelDimension > 0) {
        contactsAgree = findSigns(result, false, result.signs);
        const WorstPrefix worst = findWorstPrefix(result, false, result.signs);
        result.worstBlock = worst.block;
        result.worstPrefix = worst.sum;
        result.windowSum = windowSumOf(result, result.signs);
    }
    result.reason = firstReason(
        result, [&] { return contactsAgree; }, [&] { return result.worstPrefix; },
        [&] { return result.windowSum; });
    result.set = solutionSet(result);
}

OnePhaseSet onePhaseSet(const Schedule& schedule)
{
    OnePhaseSet result;
    onePhaseSet(schedule, result);
    return result;
}

AmplitudeSet solutionSet(const Verdict& v)
{
    if (v.reason) {
        return {};
    }
    AmplitudeSet set;
    set.count = v.kernelDimension;
    if (v.gapSign == 0) {
        // Any size: that of the row of size (certificate.hpp), an impulse of sum p = N.
        set.kind = SetKind::cone;
        set.sum = static_cast<double>(v.cells) / static_cast<double>(v.contactMembers);
        return set;
    }
    set.sum = static_cast<double>(gapSum(v.cells, v.gapSign)) / static_cast<double>(v.windowSum);
    set.kind = v.contact == Contact::pressing ? SetKind::simplex : SetKind::box;
    if (set.kind == SetKind::box) {
        set.lower = set.sum;
        set.upper = 0.0;
    }
    if (set.count == 1) {
        set.kind = SetKind::point;
    }
    return set;
}

bool Verdict::isCanonical() const
{
    // Dead classes beside live ones with c contact steps hold c + 1 if they come first, else c - 1.
    const bool allLive = kernelDimension == classes;
    const bool deadTouch = firstLive > 0 || contactMembers > 1;
    return !reason && contact == Contact::pressing && (allLive || !deadTouch);
}

Verdict decide(std::int64_t cells, Phase phase, std::vector<std::int8_t>& signs, int gapSign)
{
    fold(cells, phase);
    Verdict v;
    findLiveClasses(cells, phase, gapSign, v);
    v.reason = firstReason(
        v, [&] { return findSigns(v, true, signs); },
        [&] { return findWorstPrefix(v, true, signs).sum; },
        [&] { return v.windowSum = windowSumOf(v, signs); });
    if (!v.reason && v.contact == Contact::grazing) {
        v.windowSum = 1;  // epsilon alternates
    }
    v.set = solutionSet(v);
    return v;
}

}  // namespace signorini
