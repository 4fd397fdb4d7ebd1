#include "tents.hpp"

#include <cstdlib>
#include <limits>

#include "solution_set.hpp"

namespace signorini {

namespace {

/// How many of 1..most have no factor in common with this number. O(sqrt(number)).
std::int64_t countCoprime(std::int64_t number, std::int64_t most)
{
    // Inclusion and exclusion over the prime factors: there are at most 8 odd ones.
    std::vector<std::int64_t> divisors{1};  // of squarefree ones, negative for an odd number
    const auto addPrime = [&divisors](std::int64_t prime) {
        for (std::size_t k = divisors.size(); k-- > 0;) {
            divisors.push_back(-prime * divisors[k]);
        }
    };
    for (std::int64_t prime = 2; prime * prime <= number; ++prime) {
        if (number % prime == 0) {
            addPrime(prime);
        }
        while (number % prime == 0) {
            number /= prime;
        }
    }
    if (number > 1) {
        addPrime(number);
    }
    std::int64_t count = 0;
    for (const std::int64_t divisor : divisors) {
        count += most / divisor;
    }
    return count;
}

}  // namespace

const Verdict& Tent::at(std::int64_t contact)
{
    if (!family || isHeld(*family)) {
        Phase folded{contact, steps - contact};
        fold(verdict.cells, folded);
        verdict.members = (folded.contact + folded.free) / verdict.classes;
        verdict.contactMembers = family ? verdict.members : 0;
    }
    verdict.firstLive = std::max<std::int64_t>(0, contact - summit);
    verdict.kernelDimension = verdict.classes - std::abs(contact - summit);
    verdict.set = solutionSet(verdict);
    return verdict;
}

Phase Tent::top() const
{
    if (!family) {
        return {1, 2 * verdict.classes - 1};
    }
    return isHeld(*family) ? Phase{verdict.classes - 1, 1} : Phase{summit, steps - summit};
}

Tents::Tents(const AtlasRange& range) : range_(range)
{
    while (2 * range.cells % twos_ == 0) {
        twos_ *= 2;
    }
}

std::int64_t Tents::candidate(std::int64_t n) const
{
    if (range_.gapSign == 0) {
        return n < 4 * range_.cells ? n : std::numeric_limits<std::int64_t>::max();
    }
    if (range_.gapSign < 0) {
        return n;
    }
    return n < 4 * range_.cells ? n : (n + twos_ - 1) / twos_ * twos_;
}

/// Grazing motions swing from the wall to the same distance on the other side.
bool Tents::grazingStaysClear() const
{
    return !range_.secondStop || range_.secondStop->numerator >= range_.secondStop->denominator;
}

Tent Tents::pressing(std::int64_t n, std::int64_t classes, const Family& family) const
{
    Tent tent;
    tent.family = family;
    tent.steps = n;
    tent.summit = family.contactBlocks * classes;
    Verdict& v = tent.verdict;
    v.cells = range_.cells;
    v.gapSign = range_.gapSign;
    v.classes = classes;
    v.members = family.blocks;
    v.window = family.order;
    v.contactMembers = family.contactBlocks;
    v.windowSum = family.windowSum;
    cutDown(tent);
    return tent;
}

Tent Tents::held(std::int64_t n, std::int64_t classes) const
{
    const std::int64_t order = 2 * range_.cells / classes;
    Tent tent = pressing(n, classes, {order, n / classes, n / classes, order});
    tent.family = Family{order, 1, 1, order};  // every n repeats that of n = G
    return tent;
}

Tent Tents::grazing(std::int64_t n, std::int64_t classes) const
{
    Tent tent;
    tent.steps = n;
    Verdict& v = tent.verdict;
    v.cells = range_.cells;
    v.classes = classes;
    v.window = 2 * range_.cells / classes;
    v.windowSum = 1;
    v.contact = Contact::grazing;
    cutDown(tent);
    return tent;
}

/// To the bounds on contact and flight, and then to the energies to keep: the further from the
/// summit, the more has the least motion.
void Tents::cutDown(Tent& tent) const
{
    const std::int64_t classes = tent.verdict.classes;
    const std::int64_t most = classes - 1;
    tent.first = std::max({std::int64_t{1}, tent.steps - range_.maxFree, tent.summit - most});
    tent.last = std::min({range_.maxContact, tent.steps - 1, tent.summit + most});
    tent.firstKept = tent.first;
    tent.lastKept = tent.last;
    if (range_.maxEnergyRatio == std::numeric_limits<double>::infinity()) {
        return;
    }
    std::int64_t low = -1;  // the last offset that is low enough lies in low..high
    std::int64_t high = most;
    while (low < high) {
        const std::int64_t middle = low + (high - low + 1) / 2;
        if (isLowEnough(tent.at(tent.summit + middle))) {
            low = middle;
        } else {
            high = middle - 1;
        }
    }
    tent.firstKept = std::max(tent.first, tent.summit - low);
    tent.lastKept = std::min(tent.last, tent.summit + low);
}

bool Tents::isLowEnough(const Verdict& verdict) const
{
    return energyRange(verdict).least <= range_.maxEnergyRatio;
}

AtlasFamily Tents::familyOf(Tent& tent) const
{
    AtlasFamily all;
    all.cells = range_.cells;
    all.family = tent.family;
    all.top = tent.top();
    all.steps = tent.steps;
    const Verdict& whole = tent.at(all.top.contact);
    all.kind = whole.set.kind;
    all.dimension = whole.set.dimension();
    all.energy = energyRange(whole);
    all.schedules = !tent.family           ? countGrazing(tent)
                    : isHeld(*tent.family) ? countHeld(tent)
                                           : tent.lastKept - tent.firstKept + 1;
    return all;
}

/// The schedules of n = mu G, mu without a factor of w, that are as often free as those kept of
/// n = G: the same motions.
std::int64_t Tents::countHeld(const Tent& tent) const
{
    std::int64_t count = 0;
    for (std::int64_t free = tent.steps - tent.lastKept; free <= tent.steps - tent.firstKept;
         ++free) {
        count += countCoprime(tent.verdict.window, (range_.maxContact + free) / tent.steps);
    }
    return count;
}

/// The schedules n_c <= last of n = 2 mu G, mu without a factor of w, that the range keeps: the
/// motions of n = 2G, repeated. Of n <= flights + 1 all n_c are there, and one n at most is cut.
std::int64_t Tents::countGrazing(const Tent& tent) const
{
    const std::int64_t whole = (range_.maxFree + 1) / tent.steps;
    std::int64_t count = tent.lastKept * countCoprime(tent.verdict.window, whole);
    const std::int64_t n = (whole + 1) * tent.steps;
    if (std::gcd(whole + 1, tent.verdict.window) == 1) {
        count += std::max<std::int64_t>(0, tent.lastKept - (n - range_.maxFree) + 1);
    }
    return count;
}

}  // namespace signorini
