#include <cmath>
#include <complex>
#include <limits>
#include <numbers>

#include "network.hpp"
#include "statics.hpp"

namespace signorini {

namespace {

/// One bar whose nodes move as e^(i theta m), contacts open. The waves give every branch a dynamic
/// stiffness: a row of n cells Z cot(n theta) at each end and -Z/sin(n theta) between them, a
/// spring Z cot(theta/2), a mass -Z tan(theta/2), a dashpot i D.
class BarModes {
public:
    BarModes(const Network& network, std::size_t bar) : network_(network), bar_(network.bars[bar])
    {
        for (const CellRow& row : network.rows) {
            if (row.left >= bar_.firstNode && row.right <= bar_.lastNode) {
                rows_.push_back(row);
            }
        }
    }

    /// Modes without dashpots below theta in ]0, pi[, by Wittrick and Williams: those of the rows
    /// with both ends held, and the negative pivots.
    [[nodiscard]] std::int64_t countBelow(double theta) const
    {
        std::int64_t count = 0;
        for (const CellRow& row : rows_) {
            count += static_cast<std::int64_t>(
                std::floor(static_cast<double>(row.cells) * theta / std::numbers::pi));
        }
        forEachPivot(theta, 0.0, [&count](double numerator, double denominator) {
            count += (numerator < 0.0) != (denominator < 0.0) ? 1 : 0;
        });
        return count;
    }

    /// The first theta > 0 of a mode; none below pi.
    [[nodiscard]] std::optional<double> first() const
    {
        const std::int64_t target = bar_.drifts() ? 2 : 1;
        double low = 0.0;
        double high = std::nextafter(std::numbers::pi, 0.0);
        if (countBelow(high) < target) {
            return std::nullopt;
        }
        for (int k = 0; k < 200 && std::nextafter(low, high) < high; ++k) {
            const double middle = low + 0.5 * (high - low);
            (countBelow(middle) >= target ? high : low) = middle;
        }
        return high;
    }

    /// The mode that it becomes when its dashpots grow from 0: theta, complex.
    [[nodiscard]] std::optional<std::complex<double>> damped(double undamped) const
    {
        std::complex<double> theta(undamped, 0.0);
        constexpr int stages = 64;
        for (int stage = 1; stage <= stages; ++stage) {
            const double part = static_cast<double>(stage) / stages;
            bool isFound = false;
            for (int k = 0; k < 60 && !isFound; ++k) {
                const double step = 1e-6 * std::abs(theta);
                const auto value = determinant(theta, part);
                const auto slope =
                    (determinant(theta + step, part) - determinant(theta - step, part)) /
                    (2.0 * step);
                const std::complex<double> change = value / slope;
                if (!(std::abs(change) < 0.5 * std::abs(theta))) {
                    return std::nullopt;
                }
                theta -= change;
                isFound = std::abs(change) < 1e-14 * std::abs(theta);
                isFound = isFound || (k > 20 && std::abs(change) < 1e-9 * std::abs(theta));
            }
            if (!isFound || theta.real() < 1e-6 * undamped) {
                return std::nullopt;
            }
        }
        return theta;
    }

private:
    /// Gauss from the left. With s what stands at a node to the left of a row, the pivot is
    /// Z cot + s, and the next node feels Z (s cos - Z sin)/(Z cos + s sin) of all that. Each pivot
    /// is visited as a quotient, so that there are no poles.
    template <typename Number, typename Visit>
    void forEachPivot(Number theta, double dashpots, Visit visit) const
    {
        Number fromLeft(0);
        std::size_t next = 0;  // row to the right of the node
        for (std::size_t node = bar_.firstNode; node <= bar_.lastNode; ++node) {
            const Number here = fromLeft + ground(node, theta, dashpots);
            const bool isClamped = network_.nodes[node].isClamped;
            if (node == bar_.lastNode) {
                if (!isClamped) {
                    visit(here, Number(1.0));
                }
                return;
            }
            const CellRow& row = rows_[next++];
            const Number angle = static_cast<double>(row.cells) * theta;
            const Number cosine = row.impedance * std::cos(angle);
            const Number sine = std::sin(angle);
            if (isClamped) {
                fromLeft = cosine / sine;
            } else {
                const Number pivot = cosine + here * sine;
                visit(pivot, sine);
                fromLeft = (here * cosine - row.impedance * row.impedance * sine) / pivot;
            }
        }
    }

    template <typename Number>
    [[nodiscard]] Number ground(std::size_t node, Number theta, double dashpots) const
    {
        Number sum(0);
        if constexpr (!std::is_same_v<Number, double>) {
            sum += Number(0.0, dashpots * network_.nodes[node].dashpot);
        }
        for (const Stub& stub : network_.stubs) {
            if (stub.node == node) {
                const Number tangent = std::tan(0.5 * theta);
                sum += stub.kind == StubKind::spring ? stub.impedance / tangent
                                                     : -stub.impedance * tangent;
            }
        }
        return sum;
    }

    /// Pivots times sines: where a row begins at a clamp its sine is left over.
    [[nodiscard]] std::complex<double> determinant(std::complex<double> theta,
                                                   double dashpots) const
    {
        std::complex<double> product(1.0, 0.0);
        forEachPivot(theta, dashpots,
                     [&product](const auto& numerator, const auto&) { product *= numerator; });
        for (const CellRow& row : rows_) {
            if (network_.nodes[row.left].isClamped) {
                product *= std::sin(static_cast<double>(row.cells) * theta);
            }
        }
        return product;
    }

    const Network& network_;
    const NetworkBar& bar_;
    std::vector<CellRow> rows_;
};

}  // namespace

SceneReference referenceOf(const Network& network)
{
    SceneReference reference;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t bar = 0; bar < network.bars.size(); ++bar) {
        const BarModes modes(network, bar);
        const auto first = modes.first();
        if (!first || *first >= least) {
            continue;
        }
        least = *first;
        const auto damped = modes.damped(least);
        reference.frequency = least / network.scales.time;
        reference.damping = damped ? std::optional(damped->imag() / damped->real()) : std::nullopt;
    }
    const NetworkContact& contact = network.contacts.front();
    const double compliance = complianceOf(network, contact);
    if (std::isfinite(compliance)) {
        const NetworkScales& scales = network.scales;
        const double gap = contact.gap * scales.displacement;
        reference.compliance = compliance * scales.displacement / scales.force();
        reference.energy = 0.5 * gap * gap / *reference.compliance;
    }
    return reference;
}

}  // namespace signorini
