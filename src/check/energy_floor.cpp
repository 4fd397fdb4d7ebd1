#include "energy_floor.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>
#include <vector>

#include "floor_conditions.hpp"
#include "rational.hpp"

namespace signorini {

namespace {

constexpr double upwards = 1.0 + 1e-9;  // more than a sum of squares of 10^8 doubles loses

/// sqrt(sum v_i^2/Z_i), rounded upwards.
class DualNorm {
public:
    explicit DualNorm(const Network& network)
    {
        for (const CellRow& row : network.rows) {
            weights_.insert(weights_.end(), 2 * static_cast<std::size_t>(row.cells),
                            1.0 / row.impedance);
        }
        for (const Stub& stub : network.stubs) {
            weights_.push_back(1.0 / stub.impedance);
        }
    }

    [[nodiscard]] double of(std::span<const double> values) const
    {
        double sum = 0.0;
        for (std::size_t k = 0; k < values.size(); ++k) {
            sum += values[k] * values[k] * weights_[k];
        }
        return std::sqrt(sum) * upwards;
    }

    /// Takes away what ties (contact_spans.hpp) make of values: as they are 0 for every motion, any
    /// multiples of them may be, so rounding does no harm.
    void leaveOut(std::vector<std::vector<double>> ties, std::vector<double>& values) const
    {
        const auto dot = [this](const std::vector<double>& x, const std::vector<double>& y) {
            double sum = 0.0;
            for (std::size_t k = 0; k < x.size(); ++k) {
                sum += x[k] * y[k] * weights_[k];
            }
            return sum;
        };
        const auto take = [&](const std::vector<double>& tie, std::vector<double>& from) {
            const double part = dot(tie, from) / dot(tie, tie);
            for (std::size_t k = 0; k < from.size(); ++k) {
                from[k] -= part * tie[k];
            }
        };
        for (std::size_t i = 0; i < ties.size(); ++i) {
            take(ties[i], values);
            for (std::size_t j = i + 1; j < ties.size(); ++j) {
                take(ties[i], ties[j]);
            }
        }
    }

private:
    std::vector<double> weights_;
};

/// `Number`: double, or long double where sums of many steps are to be known well.
template <typename Number>
class BackwardMarch {
public:
    BackwardMarch(const EnergyFloor& multipliers, const Network& network,
                  std::span<const ContactSpan> schedule, const FloorConditions& conditions,
                  std::span<const StepDrive> shapes = {})
        : network_(network),
          conditions_(conditions),
          shapes_(shapes),
          norm_(network),
          bars_(driftingBars(network)),
          end_(multipliers.periodicity.begin(),
               multipliers.periodicity.end() - static_cast<std::ptrdiff_t>(bars_.size())),
          drifts_(multipliers.periodicity.end() - static_cast<std::ptrdiff_t>(bars_.size()),
                  multipliers.periodicity.end()),
          waves_(network, std::vector<Number>(end_.begin(), end_.end())),
          size_(norm_.of(end_)),
          driven_(shapes.size())
    {
        measure();
        for (const ContactSpan& span : schedule) {
            step_ += span.steps;
        }
        NetworkLaws<Number> laws(network);
        for (std::size_t k = schedule.size(); k-- > 0;) {
            const NetworkLaw<Number>& law = laws.of(schedule[k].closed);
            for (std::int64_t m = 0; m < schedule[k].steps; ++m) {
                stepBack(law);
            }
        }
    }

    /// sqrt(sum eta^2/Z), rounded upwards.
    [[nodiscard]] double norm() const
    {
        const std::vector<Number> last = waves_.waves();
        std::vector<double> eta;
        for (std::size_t k = 0; k < last.size(); ++k) {
            eta.push_back(static_cast<double>(last[k] - end_[k]));
        }
        const double rounding = 64.0 * std::numeric_limits<double>::epsilon() * norm_.of(eta);
        norm_.leaveOut(tiesOf(network_), eta);
        return (norm_.of(eta) + rounding + error_) * upwards;
    }

    /// delta.
    [[nodiscard]] Interval right() const
    {
        return conditions_.right() - constant_ - Interval(-constantError_, constantError_);
    }

    /// What is left of the excitation.
    [[nodiscard]] ExcitationCut cut() const
    {
        const auto part = [this](std::size_t k) {
            return k < driven_.size() ? driven_[k] + Interval(-drivenError_, drivenError_)
                                      : Interval();
        };
        return {part(0), part(1), norm(), right().low};
    }

private:
    void measure()
    {
        for (const CellRow& row : network_.rows) {
            impedances_ += 2.0 * row.impedance;
            least_ = std::min(least_, row.impedance);
        }
        for (const Stub& stub : network_.stubs) {
            impedances_ += stub.impedance;
            least_ = std::min(least_, stub.impedance);
        }
        for (const NetworkNode& node : network_.nodes) {
            impedances_ += node.dashpot;
            forces_ += std::abs(node.force);
        }
    }

    /// Adds what constant forces make, and derivatives by force, velocity and place of the base in
    /// this step; `error`: of each, and of the first for forces of 1.
    void drive(double constant, double byForce, double byVelocity, double byPlace, double error)
    {
        constant_ = constant_ + Interval(constant).widened();
        constantError_ = (constantError_ + error * forces_) * upwards;
        const auto at = static_cast<std::size_t>(step_);
        for (std::size_t k = 0; k < shapes_.size(); ++k) {
            const StepDrive& shape = shapes_[k];
            driven_[k] = driven_[k] + Interval(byForce).widened() * Interval(shape.forces[at]) +
                         Interval(byVelocity).widened() * Interval(shape.velocities[at]) +
                         Interval(byPlace) * Interval(shape.places[at]);
            drivenError_ +=
                error * upwards * (std::abs(shape.forces[at]) + std::abs(shape.velocities[at]));
        }
    }

    void stepBack(const NetworkLaw<Number>& law)
    {
        --step_;
        // Sums of a node's waves are at most |lambda| sqrt(sum Z), over sum Z if it moves.
        const double reach = std::sqrt(impedances_) + 1.0 / std::sqrt(least_);
        const double before =
            error_ + (static_cast<double>(network_.channels()) + 8.0) * unitRoundoff * size_;
        const auto driven = waves_.stepBack(law);
        drive(static_cast<double>(driven.constant), static_cast<double>(driven.force),
              static_cast<double>(driven.base), 0.0, before * reach);
        // For a node of impedance sum Z, w(sum g) - g is rounded by less than (2 channels + 8) u
        // (|w| sum |g| + |g|), and the norm of the first term is at most 2 |g|: sum |g| is at most
        // |g| sqrt(sum Z), that of w = 2 Z_k/(sum Z + D) at most 2/sqrt(sum Z).
        const auto channels = static_cast<double>(network_.channels());
        error_ += 3.0 * (2.0 * channels + 8.0) * unitRoundoff * size_;
        for (std::size_t k = 0; k < bars_.size(); ++k) {
            const auto factor = static_cast<Number>(drifts_[k]);
            if (factor != 0.0) {
                add(law.velocity(network_.bars[bars_[k]].firstNode), factor);
            }
        }
        if (const auto now = conditions_.pushes().find(step_); now != conditions_.pushes().end()) {
            for (const ContactMultiplier& m : now->second) {
                add(law.push(m.contact), static_cast<Number>(m.value));
            }
        }
        if (const auto now = conditions_.arrivals().find(step_);
            now != conditions_.arrivals().end()) {
            for (const auto& [channel, factor] : now->second) {
                add({{{channel, Number(1)}}}, static_cast<Number>(factor));
            }
        }
        if (const auto now = conditions_.places().find(step_); now != conditions_.places().end()) {
            for (const ContactMultiplier& m : now->second) {
                place(m);
            }
        }
    }

    /// A push, or the velocity of a node, times a factor.
    void add(const LinearForm<Number>& form, Number factor)
    {
        double square = 0.0;
        for (const auto& term : form.terms) {
            const Number change = factor * term.coefficient;
            waves_.add(term.channel, change);
            const auto value = static_cast<double>(change);
            square += value * value / network_.impedanceOf(term.channel);
        }
        const auto terms = static_cast<double>(form.terms.size());
        const double size = std::sqrt(square) * upwards;
        const double by = std::abs(static_cast<double>(factor));
        // Coefficients are sums and differences of impedances, each at most 4 of their sum, or
        // quotients of them, at most 2.
        error_ += (terms + 4.0) * unitRoundoff *
                  (size_ + size + 16.0 * by * (1.0 + impedances_) * terms / std::sqrt(least_));
        size_ += size;
        drive(static_cast<double>(factor * form.constant),
              static_cast<double>(factor * form.perForce),
              static_cast<double>(factor * form.perBase), 0.0,
              16.0 * unitRoundoff * by * (1.0 + impedances_) * (1.0 + impedances_ / least_));
    }

    void place(const ContactMultiplier& m)
    {
        std::vector<Number> waves = waves_.waves();
        std::vector<double> row(waves.size(), 0.0);
        drive(0.0, 0.0, 0.0, addDistance(row, network_, m.contact, m.value), 0.0);
        for (const auto& [bar, sign] : driftsOf(network_, m.contact)) {
            drifts_[bar] += sign * Rational(m.value);
        }
        for (std::size_t k = 0; k < waves.size(); ++k) {
            waves[k] += row[k];
        }
        waves_ = NetworkWaves<Number>(network_, std::move(waves));
        const double size = norm_.of(row);
        error_ += 2.0 * unitRoundoff * (size_ + size);
        size_ += size;
    }

    static constexpr double unitRoundoff =
        0.5 * static_cast<double>(std::numeric_limits<Number>::epsilon());

    const Network& network_;
    const FloorConditions& conditions_;
    std::span<const StepDrive> shapes_;
    DualNorm norm_;
    std::vector<std::size_t> bars_;  ///< that drift
    std::vector<double> end_;
    std::vector<Rational> drifts_;  ///< lambda of their displacements
    NetworkWaves<Number> waves_;
    std::int64_t step_ = 0;
    double size_;         ///< at least |lambda|
    double error_ = 0.0;  ///< at least |rounding in lambda|
    double impedances_ = 0.0;
    double least_ = infinity;
    double forces_ = 0.0;  ///< constant ones
    Interval constant_;    ///< what they make
    double constantError_ = 0.0;
    std::vector<Interval> driven_;  ///< by shape
    double drivenError_ = 0.0;
};

/// c C + s S >= limit.
struct HalfPlane {
    Interval c;
    Interval s;
    double limit;

    HalfPlane(const ExcitationCut& cut, double energy)
        : c(cut.c), s(cut.s), limit(cut.right - cut.norm * std::sqrt(energy) * upwards)
    {
    }
    [[nodiscard]] double reach() const { return (c * c + s * s).root().high; }
};

}  // namespace

double provedEnergy(const EnergyFloor& multipliers, const Network& network,
                    std::span<const ContactSpan> schedule)
{
    const FloorConditions conditions(multipliers, network, schedule);
    if (!conditions.areGood()) {
        return 0.0;
    }
    const BackwardMarch<double> march(multipliers, network, schedule, conditions);
    const double norm = march.norm();
    const double right = march.right().low;
    if (!std::isfinite(norm) || !(right > 0.0)) {
        return 0.0;
    }
    const double ratio = right / norm / upwards;
    return ratio * ratio / upwards;
}

std::vector<ExcitationCut> cutsOf(std::span<const EnergyFloor> multipliers, const Network& network,
                                  std::span<const ContactSpan> schedule,
                                  std::span<const StepDrive> shapes)
{
    std::vector<ExcitationCut> cuts;
    for (const EnergyFloor& one : multipliers) {
        const FloorConditions conditions(one, network, schedule);
        if (!conditions.areGood()) {
            return {};
        }
        cuts.push_back(
            BackwardMarch<long double>(one, network, schedule, conditions, shapes).cut());
        if (!std::isfinite(cuts.back().norm)) {
            return {};
        }
    }
    return cuts;
}

bool forbidUpTo(std::span<const ExcitationCut> cuts, double amplitude, double energy)
{
    return std::any_of(cuts.begin(), cuts.end(), [&](const ExcitationCut& cut) {
        const HalfPlane half(cut, energy);
        return half.limit > half.reach() * amplitude * upwards;
    });
}

bool forbidJust(std::span<const ExcitationCut> cuts, double amplitude, double energy)
{
    if (forbidUpTo(cuts, amplitude, energy)) {
        return true;
    }
    bool isCut = false;
    for (std::size_t k = 0; k < cuts.size(); ++k) {
        // Ends of its arc: across by +-sqrt(A^2 |c|^2 - limit^2), over |c|^2.
        const HalfPlane half(cuts[k], energy);
        const Interval squares = half.c * half.c + half.s * half.s;
        const Interval limit(half.limit);
        const Interval across = Interval(amplitude) * Interval(amplitude) * squares - limit * limit;
        if (half.limit <= 0.0 && across.isNegative()) {
            continue;  // the whole circle
        }
        if (!squares.isPositive()) {
            return false;
        }
        isCut = true;
        for (const double side : {1.0, -1.0}) {
            const Interval way = Interval(side) * across.root();
            const Interval c = (limit * half.c - way * half.s) / squares;
            const Interval s = (limit * half.s + way * half.c) / squares;
            const bool isOut = std::any_of(cuts.begin(), cuts.end(), [&](const ExcitationCut& cut) {
                const HalfPlane other(cut, energy);
                return &cut != &cuts[k] &&
                       (other.c * c + other.s * s - Interval(other.limit)).isNegative();
            });
            if (!isOut) {
                return false;
            }
        }
    }
    return isCut;
}

}  // namespace signorini
