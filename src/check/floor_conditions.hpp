#pragma once
/// \file
/// The conditions of a schedule with multipliers, as a march backwards meets them
/// (energy_floor.hpp).

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "contact_spans.hpp"
#include "interval.hpp"
#include "largest.hpp"
#include "rational.hpp"
#include "signorini/certificate.hpp"

namespace signorini {

/// The conditions of a schedule, by the step in which they are met on the way back.
class FloorConditions {
public:
    FloorConditions(const EnergyFloor& multipliers, const Network& network,
                    std::span<const ContactSpan> schedule)
        : network_(network), schedule_(schedule)
    {
        for (const ContactSpan& span : schedule) {
            areGood_ = areGood_ && span.steps > 0 && span.steps <= maxNetworkSteps - steps_;
            steps_ += areGood_ ? span.steps : 0;
        }
        areGood_ =
            areGood_ &&
            multipliers.periodicity.size() == network.waves() + driftingBars(network).size() &&
            std::all_of(multipliers.periodicity.begin(), multipliers.periodicity.end(),
                        [](double value) { return std::isfinite(value); });
        for (const ContactMultiplier& m : multipliers.places) {
            takePlace(m);
        }
        for (const ContactMultiplier& m : multipliers.pushes) {
            const bool isGood = isThere(m) && isClosed(m.contact, m.step) && m.value >= 0.0;
            areGood_ = areGood_ && isGood;
            pushes_[m.step].push_back(m);
        }
        for (const StrainMultiplier& m : multipliers.strains) {
            takeStrain(m);
        }
        // What is left of the displacements of bars that drift has to be nothing at all.
        std::map<std::size_t, Rational> drifts;
        for (const auto& [step, list] : places_) {
            for (const ContactMultiplier& m : list) {
                for (const auto& [bar, sign] : driftsOf(network, m.contact)) {
                    drifts[bar] += sign * Rational(m.value);
                }
            }
        }
        areGood_ = areGood_ && std::all_of(drifts.begin(), drifts.end(),
                                           [](const auto& sum) { return sum.second == 0; });
    }

    [[nodiscard]] bool areGood() const { return areGood_; }
    /// delta, but for what constant forces make.
    [[nodiscard]] Interval right() const { return right_; }
    [[nodiscard]] const auto& places() const { return places_; }
    [[nodiscard]] const auto& pushes() const { return pushes_; }
    /// Waves that arrive: (channel, factor).
    [[nodiscard]] const auto& arrivals() const { return arrivals_; }

private:
    [[nodiscard]] bool isThere(const ContactMultiplier& m) const
    {
        return areGood_ && m.contact < network_.contacts.size() && m.step >= 0 && m.step < steps_ &&
               std::isfinite(m.value);
    }

    /// Steps are counted around the period.
    [[nodiscard]] bool isClosed(std::size_t contact, std::int64_t step) const
    {
        std::int64_t left = (step + steps_) % steps_;
        for (const ContactSpan& span : schedule_) {
            if (left < span.steps) {
                return contains(span.closed, contact);
            }
            left -= span.steps;
        }
        return false;
    }

    void takePlace(const ContactMultiplier& m)
    {
        areGood_ =
            areGood_ && isThere(m) &&
            (m.value >= 0.0 || isClosed(m.contact, m.step) || isClosed(m.contact, m.step - 1));
        if (!areGood_) {
            return;
        }
        const NetworkContact& contact = network_.contacts[m.contact];
        // The gap is the simplest fraction that rounds to it.
        right_ = right_ - Interval(m.value) * Interval(contact.gap).widened();
        places_[m.step].push_back(m);
    }

    /// l - r of two waves that pass each other.
    void takeStrain(const StrainMultiplier& m)
    {
        const auto isStep = [this](std::int64_t step) { return step >= 0 && step < steps_; };
        areGood_ = areGood_ && m.row < network_.rows.size() && isStep(m.right) && isStep(m.left) &&
                   m.value >= 0.0 && std::isfinite(m.value);
        const auto least = areGood_ ? leastDifference(network_, network_.strainLimit, m.row,
                                                      m.right, m.left, steps_)
                                    : std::nullopt;
        areGood_ = least && std::isfinite(*least);
        if (!areGood_) {
            return;
        }
        // A sum of three numbers that were computed from those of the scene.
        constexpr double rounding = 32.0 * std::numeric_limits<double>::epsilon();
        const CellRow& row = network_.rows[m.row];
        const double rest = largestSizeOf(network_.nodes, &NetworkNode::rest);
        const double size = network_.strainLimit * row.speed + 2.0 * rest +
                            std::abs(network_.gravity) * static_cast<double>(row.cells);
        const double error = rounding * size;
        right_ = right_ + Interval(m.value) * (Interval(*least) + Interval(-error, error));
        arrivals_[m.right].emplace_back(2 * m.row, -m.value);
        arrivals_[m.left].emplace_back(2 * m.row + 1, m.value);
    }

    const Network& network_;
    std::span<const ContactSpan> schedule_;
    std::int64_t steps_ = 0;
    bool areGood_ = true;
    Interval right_;
    std::map<std::int64_t, std::vector<ContactMultiplier>> places_;
    std::map<std::int64_t, std::vector<ContactMultiplier>> pushes_;
    std::map<std::int64_t, std::vector<std::pair<std::size_t, double>>> arrivals_;
};

}  // namespace signorini
