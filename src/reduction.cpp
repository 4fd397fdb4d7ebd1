#include "signorini/reduction.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "faults.hpp"
#include "signorini/closed_form.hpp"

namespace signorini {

namespace {

/// How far given amplitudes may lie outside the set, relative to |S|.
constexpr double amplitudeTolerance = 1e-9;

/// Splits the steps into classes and finds the live ones.
void findLiveClasses(const Phase& phase, Reduction& r)
{
    const std::int64_t window = 2 * r.schedule.cells;
    const std::int64_t n = phase.contact + phase.free;
    r.classes = std::gcd(window, n);
    r.members = n / r.classes;
    r.window = window / r.classes;

    // Classes j < remainder hold quotient + 1 contact steps, the others quotient.
    const std::int64_t quotient = phase.contact / r.classes;
    const std::int64_t remainder = phase.contact % r.classes;
    const auto isLive = [&r](std::int64_t contacts) { return (r.members - contacts) % 2 == 0; };
    if (remainder > 0 && isLive(quotient + 1)) {
        r.firstLive = 0;
        r.kernelDimension = remainder;
        r.contactMembers = quotient + 1;
    } else if (isLive(quotient)) {
        r.firstLive = remainder;
        r.kernelDimension = r.classes - remainder;
        r.contactMembers = quotient;
    } else {
        r.firstLive = 0;
        r.kernelDimension = 0;
        r.contactMembers = 0;
    }
}

/// epsilon along the orbit alpha, alpha + w, alpha + 2w, ... (mod nu), from epsilon_0 = 1.
void findSigns(Reduction& r)
{
    r.signs.resize(static_cast<std::size_t>(r.members));
    const std::int64_t stride = r.window % r.members;
    std::int64_t alpha = 0;
    std::int8_t sign = 1;
    for (std::int64_t visited = 0; visited < r.members; ++visited) {
        r.signs[static_cast<std::size_t>(alpha)] = sign;
        if (alpha >= r.contactMembers) {
            sign = static_cast<std::int8_t>(-sign);
        }
        alpha += stride;
        alpha -= alpha >= r.members ? r.members : 0;
    }
}

/// Sum of epsilon over blocks 0..w-1, epsilon being nu-periodic, and the largest prefix sum over
/// the free blocks.
void findSums(Reduction& r)
{
    const auto sum = [&r](std::int64_t begin, std::int64_t end) {
        return std::accumulate(r.signs.begin() + begin, r.signs.begin() + end, std::int64_t{0});
    };
    const std::int64_t turns = r.window / r.members;
    const std::int64_t rest = sum(0, r.window % r.members);
    r.windowSum = turns == 0 ? rest : rest + turns * sum(0, r.members);

    std::int64_t prefix = 0;
    r.worstPrefix = 0;
    r.worstBlock = -1;
    for (std::int64_t alpha = r.contactMembers; alpha < r.members; ++alpha) {
        prefix += r.signs[static_cast<std::size_t>(alpha)];
        if (prefix > r.worstPrefix) {
            r.worstPrefix = prefix;
            r.worstBlock = alpha;
        }
    }
}

/// The conditions in the order of Reason.
std::optional<Reason> findReason(const Reduction& r)
{
    if (r.kernelDimension == 0) {
        return Reason::noLiveClass;
    }
    if (r.contactMembers == 0) {
        return std::nullopt;  // grazing motions always exist
    }
    const auto contactEnd = r.signs.begin() + r.contactMembers;
    if (std::find(r.signs.begin(), contactEnd, std::int8_t{-1}) != contactEnd) {
        return Reason::contactSign;
    }
    if (r.worstPrefix > 0) {
        return Reason::penetration;
    }
    if (r.windowSum >= 0) {
        return Reason::gap;
    }
    return std::nullopt;
}

AmplitudeSet solutionSet(const Reduction& r)
{
    if (r.reason) {
        return {};
    }
    AmplitudeSet set;
    set.count = r.kernelDimension;
    set.sum = -static_cast<double>(r.schedule.cells) / static_cast<double>(r.windowSum);
    set.kind = r.contact == Contact::pressing ? SetKind::simplex : SetKind::box;
    if (set.kind == SetKind::box) {
        set.lower = set.sum;
        set.upper = 0.0;
    }
    if (set.count == 1) {
        set.kind = SetKind::point;
    }
    return set;
}

void requireMotion(const Reduction& reduction)
{
    if (reduction.reason || reduction.set.kind == SetKind::empty) {
        throw std::invalid_argument("reduction: the schedule has no motion");
    }
}

/// Writes a and b from p_m = value(alpha, j) * epsilon_alpha on live classes and 0 elsewhere.
/// `fill(segment, sign, firstClass)` writes one run of neighbouring classes inside a segment of
/// `a` (reversed: a_i = p_{N-i}) or `b` (b_i = -p_{N+i-1}).
template <typename Fill>
State writeState(const Reduction& r, Fill fill)
{
    const std::int64_t cells = r.schedule.cells;
    State state{Eigen::VectorXd(cells), Eigen::VectorXd(cells)};
    auto forward = state.a.reverse();
    if (r.kernelDimension < r.classes) {
        state.a.setZero();
        state.b.setZero();
    }
    for (std::int64_t block = 0, alpha = 0; block < r.window; ++block, ++alpha) {
        alpha -= alpha == r.members ? r.members : 0;
        const double sign = r.signs[static_cast<std::size_t>(alpha)];
        const std::int64_t begin = block * r.classes + r.firstLive;
        const std::int64_t end = begin + r.kernelDimension;
        const std::int64_t split = std::clamp(cells, begin, end);
        if (begin < split) {
            auto run = forward.segment(begin, split - begin);
            fill(run, sign, std::int64_t{0});
        }
        if (split < end) {
            auto run = state.b.segment(split - cells, end - split);
            fill(run, -sign, split - begin);
        }
    }
    return state;
}

}  // namespace

std::string_view name(Reason reason)
{
    switch (reason) {
        case Reason::noLiveClass:
            return "no-live-class";
        case Reason::contactSign:
            return "contact-sign";
        case Reason::penetration:
            return "penetration";
        case Reason::gap:
            return "gap";
        case Reason::constraints:
            return "constraints";
    }
    throw std::logic_error("unnamed Reason");
}

std::string_view name(Contact contact)
{
    switch (contact) {
        case Contact::pressing:
            return "pressing";
        case Contact::grazing:
            return "grazing";
    }
    throw std::logic_error("unnamed Contact");
}

void reduce(const Schedule& schedule, Reduction& result)
{
    validate(schedule);
    if (schedule.phases.size() != 1) {
        throw std::invalid_argument(
            fmt::format("phases: {} given: allowed 1 (the closed form knows one contact phase)",
                        schedule.phases.size()));
    }
    result.schedule = schedule;
    fold(result.schedule);
    findLiveClasses(result.schedule.phases.front(), result);
    result.signs.clear();
    result.windowSum = result.worstPrefix = 0;
    result.worstBlock = -1;
    if (result.kernelDimension > 0) {
        findSigns(result);
        findSums(result);
    }
    result.reason = findReason(result);
    result.contact = result.contactMembers > 0 ? Contact::pressing : Contact::grazing;
    result.set = solutionSet(result);
}

Reduction reduce(const Schedule& schedule)
{
    Reduction result;
    reduce(schedule, result);
    return result;
}

EnergyRange energyRange(const Reduction& reduction)
{
    requireMotion(reduction);
    // With S = -N/win both ends are rational; integers below 2^53 make their quotient the double
    // nearest to it.
    const auto sum = static_cast<double>(reduction.windowSum);
    const auto count = static_cast<double>(reduction.set.count);
    const double whole =
        2.0 * static_cast<double>(reduction.window) * static_cast<double>(reduction.schedule.cells);
    const double squares = reduction.set.sum * reduction.set.sum;
    const double most = std::round(mostSquares(reduction.set) / squares);  // 1 on a simplex
    return {whole / (sum * sum * count), whole * most / (sum * sum)};
}

State motionOf(const Reduction& reduction, std::span<const double> amplitudes)
{
    requireMotion(reduction);
    const double outside = distanceOutside(reduction.set, amplitudes);
    if (!(outside <= amplitudeTolerance)) {
        throw std::invalid_argument(
            fmt::format("amplitudes: outside the solution set by {} |S|: allowed at most {}",
                        outside, amplitudeTolerance));
    }
    const Eigen::Map<const Eigen::VectorXd> z(amplitudes.data(),
                                              static_cast<Eigen::Index>(amplitudes.size()));
    return writeState(reduction, [&z](auto& run, double sign, std::int64_t first) {
        run = sign * z.segment(first, run.size());
    });
}

std::vector<double> amplitudesOf(const Reduction& reduction, const State& state)
{
    requireMotion(reduction);
    const std::int64_t cells = reduction.schedule.cells;
    if (state.a.size() != cells || state.b.size() != cells) {
        throw std::invalid_argument(
            fmt::format("state: {} cells: allowed {}, as in the schedule", state.a.size(), cells));
    }
    std::vector<double> z(static_cast<std::size_t>(reduction.kernelDimension), 0.0);
    for (std::int64_t block = 0; block < reduction.window; ++block) {
        const double sign = reduction.signs[static_cast<std::size_t>(block % reduction.members)];
        for (std::size_t j = 0; j < z.size(); ++j) {
            const std::int64_t m =
                block * reduction.classes + reduction.firstLive + static_cast<std::int64_t>(j);
            const double p = m < cells ? state.a[cells - 1 - m] : -state.b[m - cells];
            z[j] += sign * p / static_cast<double>(reduction.window);
        }
    }
    return z;
}

State leastEnergyMotion(const Reduction& reduction)
{
    requireMotion(reduction);
    const double z = reduction.set.sum / static_cast<double>(reduction.set.count);
    return writeState(reduction,
                      [z](auto& run, double sign, std::int64_t) { run.setConstant(sign * z); });
}

}  // namespace signorini
