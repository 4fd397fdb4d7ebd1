#include "periodic_multipliers.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <vector>

namespace signorini {

namespace {

constexpr double noLength = 1e-14;          // of a vector of length 1
constexpr std::int64_t mostKept = 1 << 24;  // numbers, of vectors that are kept orthogonal

/// W - 1 and its transpose, in the norm of the energy.
class PeriodOperator {
public:
    PeriodOperator(const Network& network, std::span<const ContactSpan> schedule)
        : network_(network), scale_(static_cast<Eigen::Index>(network.waves()))
    {
        Eigen::Index next = 0;
        for (const CellRow& row : network.rows) {
            scale_.segment(next, 2 * row.cells).setConstant(std::sqrt(row.impedance));
            next += 2 * row.cells;
        }
        for (const Stub& stub : network.stubs) {
            scale_[next++] = std::sqrt(stub.impedance);
        }
        for (const ContactSpan& span : schedule) {
            laws_.try_emplace(span.closed, network, span.closed);
        }
        for (const ContactSpan& span : schedule) {
            spans_.push_back({&laws_.at(span.closed), span.steps});
            steps_ += span.steps;
        }
    }

    [[nodiscard]] const Eigen::VectorXd& scale() const { return scale_; }

    [[nodiscard]] Eigen::VectorXd forwards(const Eigen::VectorXd& x) const
    {
        const Eigen::VectorXd start = x.cwiseQuotient(scale_);
        NetworkWaves<double> waves = wavesOf(start);
        for (const auto& [law, steps] : spans_) {
            for (std::int64_t m = 0; m < steps; ++m) {
                waves.step(*law);
            }
        }
        return (vectorOf(waves) - start).cwiseProduct(scale_);
    }

    [[nodiscard]] Eigen::VectorXd backwards(const Eigen::VectorXd& y) const
    {
        const Eigen::VectorXd end = y.cwiseProduct(scale_);
        NetworkWaves<double> waves = wavesOf(end);
        for (std::size_t i = spans_.size(); i-- > 0;) {
            const auto& [law, steps] = spans_[i];
            for (std::int64_t m = 0; m < steps; ++m) {
                waves.stepBack(*law);
            }
        }
        return (vectorOf(waves) - end).cwiseQuotient(scale_);
    }

    /// What the conditions add up to.
    [[nodiscard]] Eigen::VectorXd conditions(const EnergyFloor& floor) const
    {
        std::map<std::int64_t, std::vector<ContactMultiplier>> places;
        std::map<std::int64_t, std::vector<ContactMultiplier>> pushes;
        for (const ContactMultiplier& m : floor.places) {
            places[m.step].push_back(m);
        }
        for (const ContactMultiplier& m : floor.pushes) {
            pushes[m.step].push_back(m);
        }
        NetworkWaves<double> waves = wavesOf(Eigen::VectorXd::Zero(scale_.size()));
        std::int64_t step = steps_;
        for (std::size_t i = spans_.size(); i-- > 0;) {
            const auto& [law, steps] = spans_[i];
            for (std::int64_t m = 0; m < steps; ++m) {
                waves.stepBack(*law);
                --step;
                for (const ContactMultiplier& push : pushes[step]) {
                    for (const auto& term : law->push(push.contact).terms) {
                        waves.add(term.channel, push.value * term.coefficient);
                    }
                }
                for (const ContactMultiplier& place : places[step]) {
                    addPlace(waves, place);
                }
            }
        }
        return vectorOf(waves).cwiseQuotient(scale_);
    }

private:
    struct Span {
        const NetworkLaw<double>* law;
        std::int64_t steps;
    };

    [[nodiscard]] NetworkWaves<double> wavesOf(const Eigen::VectorXd& x) const
    {
        return {network_, std::span(x.data(), static_cast<std::size_t>(x.size()))};
    }
    [[nodiscard]] static Eigen::VectorXd vectorOf(const NetworkWaves<double>& waves)
    {
        const std::vector<double> all = waves.waves();
        return Eigen::Map<const Eigen::VectorXd>(all.data(), static_cast<Eigen::Index>(all.size()));
    }

    void addPlace(NetworkWaves<double>& waves, const ContactMultiplier& m) const
    {
        std::vector<double> all = waves.waves();
        addDistance(all, network_, m.contact, m.value);
        waves = NetworkWaves<double>(network_, all);
    }

    const Network& network_;
    Eigen::VectorXd scale_;
    std::map<ContactSet, NetworkLaw<double>> laws_;
    std::vector<Span> spans_;
    std::int64_t steps_ = 0;
};

/// Vectors at right angles, as many as memory is meant for.
class Basis {
public:
    /// Takes away what earlier vectors make, and gives it length 1. Returns the length it had.
    double enter(Eigen::VectorXd& vector)
    {
        for (int twice = 0; twice < 2; ++twice) {
            for (const Eigen::VectorXd& other : vectors_) {
                vector -= other.dot(vector) * other;
            }
        }
        const double length = vector.norm();
        if (length > 0.0) {
            vector /= length;
        }
        if (static_cast<std::int64_t>(vectors_.size() + 1) * vector.size() <= mostKept) {
            vectors_.push_back(vector);
        }
        return length;
    }

private:
    std::vector<Eigen::VectorXd> vectors_;
};

/// x that makes |A x - b| least, A the backwards operator.
Eigen::VectorXd leastSquares(const PeriodOperator& period, Eigen::VectorXd u, const Cancel& cancel)
{
    Eigen::VectorXd x = Eigen::VectorXd::Zero(u.size());
    Basis left;
    Basis right;
    const double size = left.enter(u);
    Eigen::VectorXd v = period.forwards(u);
    double alpha = right.enter(v);
    Eigen::VectorXd way = v;
    double rest = size;
    double rho = alpha;
    for (Eigen::Index step = 0; step < 2 * u.size() + 10 && alpha > noLength; ++step) {
        if (isRequested(cancel)) {
            break;
        }
        u = period.backwards(v) - alpha * u;
        const double beta = left.enter(u);
        const double length = std::hypot(rho, beta);
        const double cosine = rho / length;
        const double sine = beta / length;
        x += (cosine * rest / length) * way;
        rest *= sine;
        if (beta <= noLength || rest <= 0.1 * noLength * size) {
            break;
        }
        v = period.forwards(u) - beta * v;
        alpha = right.enter(v);
        if (std::abs(cosine) * alpha <= noLength) {
            break;  // what is left is at right angles to all that A makes
        }
        way = v - (sine * alpha / length) * way;
        rho = -cosine * alpha;
    }
    return x;
}

}  // namespace

void completeFloor(EnergyFloor& floor, const Network& network,
                   std::span<const ContactSpan> schedule, const Cancel& cancel)
{
    const PeriodOperator period(network, schedule);
    const Eigen::VectorXd y = leastSquares(period, -period.conditions(floor), cancel);
    Eigen::VectorXd multipliers = y.cwiseProduct(period.scale());
    if (floor.periodicity.size() == network.waves()) {
        multipliers += Eigen::Map<const Eigen::VectorXd>(floor.periodicity.data(), y.size());
    }
    floor.periodicity.assign(multipliers.begin(), multipliers.end());
}

}  // namespace signorini
