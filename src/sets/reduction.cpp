#include "signorini/reduction.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "faults.hpp"
#include "signorini/amplitude_set.hpp"

namespace signorini {

namespace {

/// How far given amplitudes may lie outside the set, relative to |S|.
constexpr double amplitudeTolerance = 1e-9;

/// Splits the steps into classes and finds the live ones.
void findLiveClasses(std::int64_t cells, const Phase& phase, Verdict& v)
{
    const std::int64_t n = phase.contact + phase.free;
    v.cells = cells;
    v.classes = std::gcd(2 * cells, n);
    v.members = n / v.classes;
    v.window = 2 * cells / v.classes;

    // Classes j < remainder hold quotient + 1 contact steps, the others quotient.
    const std::int64_t quotient = phase.contact / v.classes;
    const std::int64_t remainder = phase.contact % v.classes;
    const auto isLive = [&v](std::int64_t contacts) { return (v.members - contacts) % 2 == 0; };
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
            sign = static_cast<std::int8_t>(-sign);
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

AmplitudeSet solutionSet(const Verdict& v)
{
    if (v.reason) {
        return {};
    }
    AmplitudeSet set;
    set.count = v.kernelDimension;
    set.sum = -static_cast<double>(v.cells) / static_cast<double>(v.windowSum);
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

void requireMotion(const Verdict& verdict)
{
    if (verdict.reason || verdict.set.kind == SetKind::empty) {
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
    findLiveClasses(schedule.cells, result.schedule.phases.front(), result);
    result.signs.clear();
    result.windowSum = result.worstPrefix = 0;
    result.worstBlock = -1;
    result.reason = Reason::noLiveClass;
    if (result.kernelDimension > 0) {
        const bool contactsAgree = findSigns(result, false, result.signs);
        const WorstPrefix worst = findWorstPrefix(result, false, result.signs);
        result.worstBlock = worst.block;
        result.worstPrefix = worst.sum;
        result.windowSum = windowSumOf(result, result.signs);
        result.reason = result.contact == Contact::grazing ? std::optional<Reason>()
                        : !contactsAgree                   ? Reason::contactSign
                        : worst.sum > 0                    ? Reason::penetration
                        : result.windowSum >= 0            ? Reason::gap
                                                           : std::optional<Reason>();
    }
    result.set = solutionSet(result);
}

Reduction reduce(const Schedule& schedule)
{
    Reduction result;
    reduce(schedule, result);
    return result;
}

bool Verdict::isCanonical() const
{
    // Dead classes beside live ones with c contact steps hold c + 1 if they come first, else c - 1.
    const bool allLive = kernelDimension == classes;
    const bool deadTouch = firstLive > 0 || contactMembers > 1;
    return !reason && contact == Contact::pressing && (allLive || !deadTouch);
}

Verdict decide(std::int64_t cells, Phase phase, std::vector<std::int8_t>& signs)
{
    fold(cells, phase);
    Verdict v;
    findLiveClasses(cells, phase, v);
    if (v.kernelDimension == 0) {
        v.reason = Reason::noLiveClass;
    } else if (v.contact == Contact::grazing) {
        v.windowSum = 1;  // epsilon alternates
    } else if (!findSigns(v, true, signs)) {
        v.reason = Reason::contactSign;
    } else if (findWorstPrefix(v, true, signs).sum > 0) {
        v.reason = Reason::penetration;
    } else {
        v.windowSum = windowSumOf(v, signs);
        if (v.windowSum >= 0) {
            v.reason = Reason::gap;
        }
    }
    v.set = solutionSet(v);
    return v;
}

EnergyRange energyRange(const Verdict& verdict)
{
    requireMotion(verdict);
    // With S = -N/win both ends are rational; integers below 2^53 make their quotient the double
    // nearest to it.
    const auto sum = static_cast<double>(verdict.windowSum);
    const auto count = static_cast<double>(verdict.set.count);
    const double whole =
        2.0 * static_cast<double>(verdict.window) * static_cast<double>(verdict.cells);
    const double squares = verdict.set.sum * verdict.set.sum;
    const double most = std::round(mostSquares(verdict.set) / squares);  // 1 on a simplex
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
            z[j] += sign * p;
        }
    }
    for (double& value : z) {
        value /= static_cast<double>(reduction.window);  // last: equal terms cancel without a rest
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
