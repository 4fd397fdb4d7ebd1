#include <algorithm>
#include <cmath>

#include "section_numbers.hpp"
#include "sphere_section.hpp"

namespace signorini {

namespace {

/// How much of each cell [j, j + 1] the interval of a centre and a width covers.
std::vector<double> coverage(std::int64_t count, double centre, double width)
{
    std::vector<double> z(static_cast<std::size_t>(count), 0.0);
    const double low = std::max(0.0, centre - 0.5 * width);
    const double high = std::min(static_cast<double>(count), centre + 0.5 * width);
    for (auto j = static_cast<std::size_t>(low); j < z.size() && static_cast<double>(j) < high;
         ++j) {
        const auto left = static_cast<double>(j);
        z[j] = std::min(high, left + 1.0) - std::max(low, left);
    }
    return z;
}

/// sum z^2/(sum z)^2 of the same interval, from its two ends. O(1).
double coverageRatio(double centre, double width)
{
    const double low = centre - 0.5 * width;
    const double high = centre + 0.5 * width;
    const double firstWhole = std::ceil(low);
    const double lastWhole = std::floor(high);
    if (firstWhole > lastWhole) {
        return 1.0;  // inside one cell
    }
    const double left = firstWhole - low;
    const double right = high - lastWhole;
    const double whole = lastWhole - firstWhole;
    const double sum = whole + left + right;
    return (whole + left * left + right * right) / (sum * sum);
}

/// The root of a falling function.
template <typename Function>
double bisect(double low, double high, Function falling)
{
    for (int k = 0; k < 200; ++k) {
        const double middle = 0.5 * (low + high);
        if (middle <= low || middle >= high) {
            break;
        }
        (falling(middle) > 0.0 ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

}  // namespace

TravellingBlock::TravellingBlock(const SphereSection& section) : section_(clamped(section))
{
    const auto count = static_cast<double>(section_.count);
    if (section_.ratio > 0.5) {
        // Centres of the second and of the last cell; a lone amplitude has no companion.
        first_ = section_.count == 1 ? 0.5 : 1.5;
        last_ = count - 0.5;
        return;
    }
    // The block that starts at 0. A whole number of cells is a double root, which bisection finds
    // to half of the digits only.
    const auto excess = [this](double w) { return coverageRatio(0.5 * w, w) - section_.ratio; };
    double width = bisect(1.0, count, excess);
    if (std::abs(excess(std::round(width))) <= 1e-15) {
        width = std::round(width);
    }
    first_ = std::min(0.5 * width, 0.5 * count);
    last_ = count - first_;
}

std::vector<double> TravellingBlock::at(double position) const
{
    const double centre = std::clamp(position, first_, last_);
    if (section_.ratio > 0.5) {
        return companionAt(centre);
    }
    // One cell wide is never too wide: it covers two parts of sum 1.
    const double width = bisect(1.0, static_cast<double>(section_.count), [&](double w) {
        return coverageRatio(centre, w) - section_.ratio;
    });
    std::vector<double> z = coverage(section_.count, centre, width);
    const double sum = sumOf(z);
    for (double& value : z) {
        value /= sum;
    }
    return z;
}

std::vector<double> TravellingBlock::companionAt(double position) const
{
    if (section_.count == 1) {
        return {1.0};
    }
    std::vector<double> y = coverage(section_.count, position, 1.0);
    const double root = rootAt(y, section_.ratio);
    return lifted(std::move(y), 0, section_.ratio, root);
}

}  // namespace signorini
