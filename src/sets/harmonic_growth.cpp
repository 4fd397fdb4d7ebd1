#include "harmonic_growth.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "harmonic_pattern.hpp"
#include "late_contacts.hpp"
#include "portable.hpp"

namespace signorini {

namespace {

constexpr double sameInstant = 1e-9;  // L/c

class Fronts {
public:
    Fronts(const HarmonicCase& given, const HarmonicMotion& motion)
        : given_(given), motion_(motion), contacts_(motion.contacts)
    {
        for (const HarmonicContact& one : contacts_) {
            if (one.isPinned) {
                pinned_.push_back(pushAt(one));
            } else {
                pinned_.emplace_back(1.0, -1.0);
            }
        }
    }

    [[nodiscard]] std::optional<double> growth(const FrontOrders& orders)
    {
        const std::size_t count = contacts_.size();
        setFactors(orders);
        std::vector<std::vector<double>> ways(count);
        std::size_t terms = 1;
        for (std::size_t j = 0; j < count; ++j) {
            const auto way = wayOf(j, orders);
            if (!way) {
                return std::nullopt;
            }
            ways[j] = *way;
            const double last = 2.0 * static_cast<double>(way->size()) / given_.period();
            terms = std::max(terms, static_cast<std::size_t>(last) + 2);
        }
        // pi of each pair and period.
        std::vector<double> weights(terms * count * count, 0.0);
        for (std::size_t s = 0; s < terms; ++s) {
            for (std::size_t k = 0; k < count; ++k) {
                for (std::size_t j = 0; j < count; ++j) {
                    const double apart = contacts_[k].begin - contacts_[j].begin +
                                         static_cast<double>(s) * given_.period();
                    const auto i =
                        static_cast<std::size_t>(std::max(0.0, 0.5 * apart + sameInstant));
                    if (apart > -sameInstant && i < ways[j].size()) {
                        weights[(s * count + k) * count + j] = ways[j][i];
                    }
                }
            }
        }
        const auto growth = growthOfLate(weights, terms, count);
        return growth ? std::optional(std::max(*growth, fading())) : std::nullopt;
    }

private:
    /// Push before and after a release, times the sign of its stop.
    [[nodiscard]] std::pair<double, double> pushAt(const HarmonicContact& contact) const
    {
        const std::complex<double> turn = given_.at(contact.end);
        const auto next =
            std::find_if(motion_.pieces.begin(), motion_.pieces.end(),
                         [&](const auto& piece) { return piece.end > contact.end + sameInstant; });
        const double force =
            given_.force() * given_.amplitude * (turn * turned(-motion_.phase)).real();
        const double sign = contact.stop == Stop::right ? 1.0 : -1.0;
        return {sign * (force + 2.0 * (std::prev(next)->wave * turn).real()),
                sign * (force + 2.0 * (next->wave * turn).real())};
    }

    /// mu of each pinned release, from the newest front alone.
    void setFactors(const FrontOrders& orders)
    {
        factors_.assign(contacts_.size(), 0.0);
        // A front may pin one release on its way to another.
        for (std::size_t pass = 0; pass < contacts_.size(); ++pass) {
            for (std::size_t k = 0; k < contacts_.size(); ++k) {
                const HarmonicContact& contact = contacts_[k];
                if (!contact.isPinned) {
                    continue;
                }
                const HarmonicContact& from = contacts_[contact.front];
                double jump = 2.0 * from.speed * (from.stop == contact.stop ? 1.0 : -1.0);
                const std::int64_t visits = returnOf(given_, contact);
                for (std::int64_t i = 1; i < visits; ++i) {
                    jump *= factorAt(contact.front, i, orders);
                }
                const auto [first, last] = pinned_[k];
                const double before = orders.isLateAtRelease ? first : last - jump;
                const double after = std::abs(orders.isLateAtRelease ? first + jump : last);
                factors_[k] = (before - given_.rho * after) / (before + after);
            }
        }
    }

    /// What becomes of the front of contact j on its i-th return.
    [[nodiscard]] double factorAt(std::size_t j, std::int64_t i, const FrontOrders& orders) const
    {
        const double period = given_.period();
        double time = std::fmod(contacts_[j].begin + 2.0 * static_cast<double>(i), period);
        for (std::size_t k = 0; k < contacts_.size(); ++k) {
            const HarmonicContact& one = contacts_[k];
            if (std::abs(std::remainder(time - one.begin, period)) < sameInstant) {
                return orders.isLateAtContact ? 1.0 : -given_.rho;
            }
            if (one.isPinned && std::abs(std::remainder(time - one.end, period)) < sameInstant) {
                return one.front == j && i == returnOf(given_, one) ? factors_[k]
                       : orders.isLateAtRelease                     ? -given_.rho
                                                                    : 1.0;
            }
            if (time > one.begin && time < one.end) {
                return 1.0;
            }
        }
        return -given_.rho;
    }

    /// pi_1, pi_2, ... until nothing is left.
    [[nodiscard]] std::optional<std::vector<double>> wayOf(std::size_t j,
                                                           const FrontOrders& orders) const
    {
        std::vector<double> way{1.0};
        while (std::abs(way.back()) > faded) {
            const auto i = static_cast<std::int64_t>(way.size());
            if (static_cast<double>(i) > 0.5 * given_.period() * mostTerms) {
                return std::nullopt;
            }
            way.push_back(way.back() * factorAt(j, i, orders));
        }
        return way;
    }

    /// Beside contacts, waves fade by themselves, by rho in each flight.
    [[nodiscard]] double fading() const
    {
        std::vector<double> parts{0.0, given_.step};
        for (const HarmonicContact& one : contacts_) {
            parts.push_back(std::fmod(one.begin, given_.step));
            parts.push_back(std::fmod(one.end, given_.step));
        }
        std::sort(parts.begin(), parts.end());
        std::int64_t least = given_.cells;
        for (std::size_t p = 1; p < parts.size(); ++p) {
            if (parts[p] - parts[p - 1] < sameInstant) {
                continue;
            }
            const double middle = 0.5 * (parts[p] + parts[p - 1]);
            std::int64_t flights = given_.cells;
            for (const HarmonicContact& one : contacts_) {
                flights -= static_cast<std::int64_t>(std::ceil((one.end - middle) / given_.step) -
                                                     std::ceil((one.begin - middle) / given_.step));
            }
            least = std::min(least, flights);
        }
        return portable::pow(given_.rho,
                             static_cast<double>(least) / static_cast<double>(given_.back));
    }

    const HarmonicCase& given_;
    const HarmonicMotion& motion_;
    const std::vector<HarmonicContact>& contacts_;
    std::vector<std::pair<double, double>> pinned_;
    std::vector<double> factors_;
};

}  // namespace

std::optional<double> growthOf(const HarmonicCase& given, const HarmonicMotion& motion)
{
    Fronts fronts(given, motion);
    return growthOfOrders(
        true, [&](const FrontOrders& orders) { return OrderedGrowth{fronts.growth(orders)}; });
}

}  // namespace signorini
