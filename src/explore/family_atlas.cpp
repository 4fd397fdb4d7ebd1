#include "signorini/atlas.hpp"

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <numeric>
#include <stdexcept>

#include "family_chains.hpp"
#include "faults.hpp"
#include "solution_set.hpp"

namespace signorini {

namespace {

/// One pass over a range.
class Walk {
public:
    Walk(const AtlasRange& range, const ScheduleVisitor& visitor, const Cancel& cancel)
        : range_(range), visitor_(visitor), cancel_(cancel)
    {
        twos_ = 2;
        while (2 * range.cells % twos_ == 0) {
            twos_ *= 2;
        }
    }

    bool run()
    {
        const std::int64_t last = range_.maxContact + range_.maxFree;
        const std::int64_t pressing = std::min(last, 4 * range_.cells - 1);  // T < 4
        for (std::int64_t n = 2; n <= pressing; ++n) {
            if (isRequested(cancel_) || !visitSteps(n)) {
                return false;
            }
        }
        for (std::int64_t n = (pressing / twos_ + 1) * twos_; n <= last; n += twos_) {
            if (isRequested(cancel_) || !visitGrazing(n, std::gcd(2 * range_.cells, n))) {
                return false;
            }
        }
        return true;
    }

private:
    bool visitSteps(std::int64_t n)
    {
        const std::int64_t classes = std::gcd(2 * range_.cells, n);
        if (n % twos_ == 0 && !visitGrazing(n, classes)) {
            return false;
        }
        return forEachContact(2 * range_.cells / classes, n / classes, 1,
                              [&](const Family& family) { return visitTent(n, classes, family); });
    }

    /// The schedules with |n_c - kG| < G.
    bool visitTent(std::int64_t n, std::int64_t classes, const Family& family)
    {
        Verdict v;
        v.cells = range_.cells;
        v.classes = classes;
        v.members = family.blocks;
        v.window = family.order;
        v.contactMembers = family.contactBlocks;
        v.windowSum = family.windowSum;
        setDimension(v, classes);
        if (!isLowEnough(v)) {  // the top has the least energy of the tent
            return true;
        }
        const std::int64_t top = family.contactBlocks * classes;
        const std::int64_t end = std::min(range_.maxContact, top + classes - 1);
        for (std::int64_t contact = std::max(n - range_.maxFree, top - classes + 1); contact <= end;
             ++contact) {
            v.firstLive = std::max<std::int64_t>(0, contact - top);
            setDimension(v, classes - std::abs(contact - top));
            if (isLowEnough(v) && !visitor_({contact, n - contact}, v)) {
                return false;
            }
        }
        return true;
    }

    /// The schedules with n_c < G, nu being even: epsilon alternates.
    bool visitGrazing(std::int64_t n, std::int64_t classes)
    {
        const std::int64_t end = std::min(range_.maxContact, classes - 1);
        Verdict v;
        v.cells = range_.cells;
        v.classes = classes;
        v.window = 2 * range_.cells / classes;
        v.windowSum = 1;
        v.contact = Contact::grazing;
        for (std::int64_t contact = std::max<std::int64_t>(1, n - range_.maxFree); contact <= end;
             ++contact) {
            Phase folded{contact, n - contact};
            fold(range_.cells, folded);
            v.members = (folded.contact + folded.free) / classes;
            v.firstLive = contact;
            setDimension(v, classes - contact);
            if (isLowEnough(v) && !visitor_({contact, n - contact}, v)) {
                return false;
            }
        }
        return true;
    }

    static void setDimension(Verdict& v, std::int64_t count)
    {
        v.kernelDimension = count;
        v.set = solutionSet(v);
    }

    [[nodiscard]] bool isLowEnough(const Verdict& v) const
    {
        return range_.maxEnergyRatio == std::numeric_limits<double>::infinity() ||
               energyRange(v).least <= range_.maxEnergyRatio;
    }

    const AtlasRange& range_;
    const ScheduleVisitor& visitor_;
    const Cancel& cancel_;
    std::int64_t twos_;  ///< the power of 2 that n has when epsilon alternates: nu is even
};

}  // namespace

bool forEachSchedule(const AtlasRange& range, const ScheduleVisitor& visitor, const Cancel& cancel)
{
    validate(range);
    if (range.maxPhases != 1) {
        Faults faults;
        faults.add("phases", range.maxPhases, "1 (families have one contact phase)");
        faults.throwIfAny();
    }
    return Walk(range, visitor, cancel).run();
}

std::int64_t ownSteps(const Phase& phase, const Verdict& verdict)
{
    if (verdict.reason) {
        throw std::invalid_argument("verdict: the schedule has no motion");
    }
    return verdict.contact == Contact::grazing ? 2 * verdict.classes : phase.contact + phase.free;
}

}  // namespace signorini
