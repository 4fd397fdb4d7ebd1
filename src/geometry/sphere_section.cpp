#include "sphere_section.hpp"

#include <algorithm>
#include <cmath>

#include "faults.hpp"
#include "section_numbers.hpp"

namespace signorini {

namespace {

/// y of the point z seen from a vertex: what is left without the apex, scaled to sum 1.
std::vector<double> chart(std::span<const double> z, std::size_t apex)
{
    std::vector<double> y(z.begin(), z.end());
    for (double& value : y) {
        value = std::max(value, 0.0);
    }
    y[apex] = 0.0;
    const double sum = sumOf(y);
    for (std::size_t j = 0; j < y.size(); ++j) {
        y[j] = j == apex ? 0.0 : sum > 0.0 ? y[j] / sum : 1.0 / static_cast<double>(y.size() - 1);
    }
    return y;
}

/// The root below a point z of the cap. At the rim it is 0, where its own formula loses half of
/// the digits; z itself tells it exactly, unless z misses rho by more than rounding.
double rootBelow(std::span<const double> z, std::size_t apex, const std::vector<double>& y,
                 double rho)
{
    constexpr double rounding = 1e-14;
    const double root = 1.0 - (1.0 + squaresOf(y)) * (1.0 - z[apex]);
    const double plain = rootAt(y, rho);
    return std::abs(root * root - plain) <= rounding ? root * root : plain;
}

/// A point in the caps of both i and k: z_i = z_k = x, and the rest in the mean proportions of the
/// two ends. With r of sum 1 for the rest and q = |r|^2, 2 x^2 + (1 - 2 x)^2 q = rho has a solution
/// x >= rho if q <= rho/(1 - 2 rho); that of an end is (rho - u^2 - w^2)/(1 - u - w)^2, u >= rho
/// its largest and w <= rho its other one, which is most at u = w = rho; a mean has no more.
std::vector<double> bridge(const SphereSection& section, std::span<const double> from,
                           std::span<const double> to, std::size_t i, std::size_t k)
{
    const double rho = section.ratio;
    std::vector<double> z(from.size(), 0.0);
    for (std::size_t j = 0; j < z.size(); ++j) {
        z[j] = std::max(0.0, from[j]) + std::max(0.0, to[j]);
    }
    z[i] = z[k] = 0.0;
    const double sum = sumOf(z);  // 0 but for rounding where both ends are the pair at 1/2
    for (double& value : z) {
        value = sum > 0.0 ? value / sum : 0.0;
    }
    // (2 + 4q) x^2 - 4q x + q - rho = 0, the larger root; clamped where rounding spoils it.
    const double q = squaresOf(z);
    const double root = std::sqrt(std::max(0.0, 2.0 * rho * (1.0 + 2.0 * q) - 2.0 * q));
    const double x = std::min(0.5, (2.0 * q + root) / (2.0 + 4.0 * q));
    for (double& value : z) {
        value *= 1.0 - 2.0 * x;
    }
    z[i] = z[k] = x;
    return z;
}

double distance(std::span<const double> a, std::span<const double> b)
{
    double squares = 0.0;
    for (std::size_t j = 0; j < a.size(); ++j) {
        squares += (a[j] - b[j]) * (a[j] - b[j]);
    }
    return std::sqrt(squares);
}

/// Lengths of the path up to each parameter.
std::vector<double> lengthsAt(const SectionPath& path, const std::vector<double>& parameters)
{
    std::vector<double> lengths(parameters.size(), 0.0);
    std::vector<double> previous = path.at(parameters.front());
    for (std::size_t k = 1; k < parameters.size(); ++k) {
        std::vector<double> next = path.at(parameters[k]);
        lengths[k] = lengths[k - 1] + distance(previous, next);
        previous = std::move(next);
    }
    return lengths;
}

/// Where `lengths` reaches n equally spaced values, by linear interpolation.
Spacing spread(const std::vector<double>& parameters, const std::vector<double>& lengths,
               std::int64_t n)
{
    Spacing result;
    std::size_t k = 1;
    for (std::int64_t i = 0; i < n; ++i) {
        const double share = n == 1 ? 0.0 : static_cast<double>(i) / static_cast<double>(n - 1);
        const double wanted = share * lengths.back();
        while (k + 1 < lengths.size() && lengths[k] < wanted) {
            ++k;
        }
        const double step = lengths[k] - lengths[k - 1];
        const double part = step > 0.0 ? (wanted - lengths[k - 1]) / step : share;
        result.parameters.push_back(
            std::clamp(std::lerp(parameters[k - 1], parameters[k], part), 0.0, 1.0));
        result.lengths.push_back(wanted);
    }
    return result;
}

}  // namespace

std::size_t dominant(std::span<const double> z)
{
    return static_cast<std::size_t>(std::max_element(z.begin(), z.end()) - z.begin());
}

SectionPath::SectionPath(const SphereSection& section, std::span<const double> from,
                         std::span<const double> to)
    : section_(clamped(section))
{
    const auto count = static_cast<std::size_t>(section_.count);
    if (from.size() != count || to.size() != count) {
        throw std::invalid_argument(
            fmt::format("amplitudes: {} and {} values given: allowed exactly {}", from.size(),
                        to.size(), section_.count));
    }
    const std::size_t i = dominant(from);
    const std::size_t k = dominant(to);
    if (i == k || to[i] >= section_.ratio) {
        addLeg(i, from, to);
        return;
    }
    if (from[k] >= section_.ratio) {
        addLeg(k, from, to);
        return;
    }
    if (section_.ratio > 0.5) {
        throw std::invalid_argument(
            fmt::format("amplitudes: the largest are {} and {}: allowed the same, as the two lie "
                        "in different components",
                        i + 1, k + 1));
    }
    const std::vector<double> middle = bridge(section_, from, to, i, k);
    addLeg(i, from, middle);
    addLeg(k, middle, to);
}

void SectionPath::addLeg(std::size_t apex, std::span<const double> from, std::span<const double> to)
{
    Leg leg{apex, chart(from, apex), chart(to, apex), 0.0, 0.0, 0.0};
    leg.startRoot = rootBelow(from, apex, leg.start, section_.ratio);
    leg.endRoot = rootBelow(to, apex, leg.end, section_.ratio);
    const double chord = distance(leg.start, leg.end);
    leg.rise = (1.0 - section_.ratio) * chord * chord;
    legs_.push_back(std::move(leg));
}

std::vector<double> SectionPath::at(double s) const
{
    const double scaled = std::clamp(s, 0.0, 1.0) * static_cast<double>(legs_.size());
    const auto index = std::min(static_cast<std::size_t>(scaled), legs_.size() - 1);
    const Leg& leg = legs_[index];
    const double part = scaled - static_cast<double>(index);
    std::vector<double> y(leg.start.size());
    for (std::size_t j = 0; j < y.size(); ++j) {
        y[j] = (1.0 - part) * leg.start[j] + part * leg.end[j];
    }
    // |y|^2 along a line falls short of the mean of its ends: no term is negative.
    const double root =
        (1.0 - part) * leg.startRoot + part * leg.endRoot + part * (1.0 - part) * leg.rise;
    return lifted(std::move(y), leg.apex, section_.ratio, root);
}

Spacing equalSpacing(const SectionPath& path, std::int64_t n)
{
    // Grids that are more and more even iron out the steep ends of a chart.
    const std::int64_t nodes = std::min<std::int64_t>(4 * n, 4000) + 1;
    Spacing grid = spread({0.0, 1.0}, {0.0, 1.0}, nodes);
    for (int pass = 0; pass < 3; ++pass) {
        grid = spread(grid.parameters, lengthsAt(path, grid.parameters), nodes);
    }
    return spread(grid.parameters, lengthsAt(path, grid.parameters), n);
}

}  // namespace signorini
