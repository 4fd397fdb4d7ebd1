#include "measurements.hpp"

#include <algorithm>
#include <cmath>

namespace signorini {

namespace {

double share(std::int64_t i, std::int64_t cells)
{
    return static_cast<double>(i) / static_cast<double>(cells);
}

/// Straight lines through points of ascending x, asked for values and integrals in ascending x.
class Polyline {
public:
    Polyline(std::vector<double> x, std::vector<double> y) : x_(std::move(x)), y_(std::move(y))
    {
        sums_.assign(1, 0.0);
        for (std::size_t k = 1; k < x_.size(); ++k) {
            sums_.push_back(sums_.back() + 0.5 * (x_[k] - x_[k - 1]) * (y_[k] + y_[k - 1]));
        }
    }

    /// The last line goes on beyond its end.
    [[nodiscard]] double at(double x) const
    {
        const std::size_t k = lineBefore(x);
        const double slope = (y_[k] - y_[k - 1]) / (x_[k] - x_[k - 1]);
        return y_[k - 1] + slope * (x - x_[k - 1]);
    }

    /// From the first point to x, constant beyond the ends.
    [[nodiscard]] double integral(double x) const
    {
        if (x <= x_.front()) {
            return (x - x_.front()) * y_.front();
        }
        if (x >= x_.back()) {
            return sums_.back() + (x - x_.back()) * y_.back();
        }
        const std::size_t k = lineBefore(x);
        return sums_[k - 1] + 0.5 * (x - x_[k - 1]) * (y_[k - 1] + at(x));
    }

private:
    /// The line between points k - 1 and k that holds x.
    [[nodiscard]] std::size_t lineBefore(double x) const
    {
        const auto after = std::upper_bound(x_.begin(), x_.end(), x) - x_.begin();
        return std::clamp<std::size_t>(static_cast<std::size_t>(after), 1, x_.size() - 1);
    }

    std::vector<double> x_;
    std::vector<double> y_;
    std::vector<double> sums_;
};

std::vector<double> meansOver(const Polyline& line, std::int64_t cells)
{
    std::vector<double> means;
    for (std::int64_t i = 1; i <= cells; ++i) {
        means.push_back((line.integral(share(i, cells)) - line.integral(share(i - 1, cells))) *
                        static_cast<double>(cells));
    }
    return means;
}

/// The clamp does not move: a row at x = 0 is not needed, and does not move it.
Polyline fromClamp(const Measurements& measured)
{
    std::vector<double> x = measured.x;
    std::vector<double> u = measured.other;
    if (x.front() > 0.0) {
        x.insert(x.begin(), 0.0);
        u.insert(u.begin(), 0.0);
    }
    u.front() = 0.0;
    return {std::move(x), std::move(u)};
}

std::vector<double> strains(const Measurements& measured, std::int64_t cells)
{
    if (!measured.isDisplacement) {
        return isOnCells(measured, cells) ? measured.other
                                          : meansOver(Polyline(measured.x, measured.other), cells);
    }
    const Polyline u = fromClamp(measured);
    std::vector<double> result;
    for (std::int64_t i = 1; i <= cells; ++i) {
        result.push_back((u.at(share(i, cells)) - u.at(share(i - 1, cells))) *
                         static_cast<double>(cells));
    }
    return result;
}

}  // namespace

bool isOnCells(const Measurements& measured, std::int64_t cells)
{
    constexpr double rounding = 1e-9;
    if (static_cast<std::int64_t>(measured.x.size()) != cells) {
        return false;
    }
    for (std::int64_t i = 1; i <= cells; ++i) {
        if (std::abs(measured.x[static_cast<std::size_t>(i - 1)] - share(i, cells)) > rounding) {
            return false;
        }
    }
    return true;
}

State onCells(const Measurements& measured, std::int64_t cells)
{
    const std::vector<double> v = isOnCells(measured, cells)
                                      ? measured.velocity
                                      : meansOver(Polyline(measured.x, measured.velocity), cells);
    const std::vector<double> s = strains(measured, cells);
    State state{Eigen::VectorXd(cells), Eigen::VectorXd(cells)};
    for (Eigen::Index i = 0; i < cells; ++i) {
        const auto k = static_cast<std::size_t>(i);
        state.a[i] = 0.5 * (v[k] - s[k]);
        state.b[i] = 0.5 * (v[k] + s[k]);
    }
    return state;
}

}  // namespace signorini
