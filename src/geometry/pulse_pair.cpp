#include <algorithm>

#include "portable.hpp"
#include "section_numbers.hpp"
#include "sphere_section.hpp"

namespace signorini {

namespace {

/// Adds how much of each cell [j, j + 1] an interval covers.
void cover(double low, double high, std::vector<double>& z)
{
    for (auto j = static_cast<std::size_t>(low); j < z.size() && static_cast<double>(j) < high;
         ++j) {
        const auto left = static_cast<double>(j);
        z[j] += std::min(high, left + 1.0) - std::max(low, left);
    }
}

/// sum c^2q/(sum c^q)^2 of cells of which `whole` are covered wholly, c the cover of the others.
double ratioOf(double whole, const std::vector<double>& others, double power)
{
    double sum = whole;
    double squares = whole;
    for (const double cover : others) {
        const double value = portable::pow(cover, power);
        sum += value;
        squares += value * value;
    }
    return squares / (sum * sum);
}

/// The power of the cover at which the ratio is rho: it grows with the power, is at most rho for 1,
/// and not below it where only whole cells are left. O(1): at most four cells are covered in part.
double powerFor(double rho, const std::vector<double>& cover)
{
    double whole = 0.0;
    std::vector<double> others;
    for (const double value : cover) {
        if (value >= 1.0) {
            whole += 1.0;
        } else if (value > 0.0) {
            others.push_back(value);
        }
    }
    constexpr double rounding = 1e-15;
    constexpr double most = 1e9;
    double low = 1.0;
    if (ratioOf(whole, others, low) >= rho * (1.0 - rounding)) {
        return low;
    }
    double high = 2.0;
    while (high < most && ratioOf(whole, others, high) < rho) {
        low = high;
        high *= 2.0;
    }
    while (true) {
        const double middle = 0.5 * (low + high);
        if (middle <= low || middle >= high) {
            return middle;
        }
        (ratioOf(whole, others, middle) < rho ? low : high) = middle;
    }
}

}  // namespace

PulsePair::PulsePair(const SphereSection& section)
    : section_(clamped(section)),
      width_(section_.count == 1 ? 0.5 : std::max(1.0, 0.5 / section_.ratio)),
      longest_(std::max(0.0, static_cast<double>(section_.count) - 2.0 * width_))
{
}

std::vector<double> PulsePair::at(double pause) const
{
    const double second = width_ + std::clamp(pause, 0.0, longest_);
    std::vector<double> z(static_cast<std::size_t>(section_.count), 0.0);
    cover(second, second + width_, z);
    if (section_.ratio > 0.5) {
        const double root = rootAt(z, section_.ratio);
        return lifted(std::move(z), 0, section_.ratio, root);
    }
    cover(0.0, width_, z);
    for (double& value : z) {
        value = std::min(value, 1.0);  // both parts of one cell, but for rounding
    }
    const double power = powerFor(section_.ratio, z);
    double sum = 0.0;
    for (double& value : z) {
        value = value > 0.0 ? portable::pow(value, power) : 0.0;
        sum += value;
    }
    for (double& value : z) {
        value /= sum;
    }
    return z;
}

}  // namespace signorini
