#include "double_description.hpp"

#include <algorithm>
#include <utility>

namespace signorini {

namespace {

Homogeneous homogeneous(const IntegerVector& at, int sign = 1)
{
    Homogeneous point{at, at.back() * sign};
    point.numerators.pop_back();
    for (Integer& value : point.numerators) {
        value *= sign;
    }
    return point;
}

/// a left - b right, in least integers.
IntegerVector combine(const Integer& a, const IntegerVector& left, const Integer& b,
                      const IntegerVector& right)
{
    IntegerVector result;
    Integer common = 0;
    for (std::size_t i = 0; i < left.size(); ++i) {
        result.emplace_back(a * left[i] - b * right[i]);
        common = gcd(common, result.back());
    }
    if (common > 1) {
        for (Integer& value : result) {
            value /= common;
        }
    }
    return result;
}

}  // namespace

Integer valueAt(const ExactRow& row, const IntegerVector& at)
{
    Integer value = -row.rhs * at.back();
    for (std::size_t i = 0; i < row.coefficients.size(); ++i) {
        value += row.coefficients[i] * at[i];
    }
    return value;
}

PolyhedralCone::PolyhedralCone(std::size_t unknowns)
{
    for (std::size_t i = 0; i <= unknowns; ++i) {
        IntegerVector unit(unknowns + 1);
        unit[i] = 1;
        lines_.push_back(std::move(unit));
    }
    // t >= 0 is the row 0 . x >= -t.
    cut({std::vector<std::int64_t>(unknowns), -1, false, 0});
}

void PolyhedralCone::cut(const ExactRow& row)
{
    const auto crossing = std::find_if(lines_.begin(), lines_.end(), [&row](const auto& line) {
        return !valueAt(row, line).is_zero();
    });
    if (crossing != lines_.end()) {
        IntegerVector line = std::move(*crossing);
        lines_.erase(crossing);
        cutLine(row, std::move(line));
    } else {
        cutRays(row);
    }
}

/// Everything else is moved along the line onto the row; half of the line remains.
void PolyhedralCone::cutLine(const ExactRow& row, IntegerVector line)
{
    if (valueAt(row, line) < 0) {
        for (Integer& value : line) {
            value = -value;
        }
    }
    const Integer slope = valueAt(row, line);
    for (IntegerVector& other : lines_) {
        other = combine(slope, other, valueAt(row, other), line);
    }
    for (Ray& ray : rays_) {
        ray.at = combine(slope, ray.at, valueAt(row, ray.at), line);
        ray.tight.push_back(true);
        ray.isChecked = false;
    }
    if (!row.isEquality) {
        std::vector<bool> tight(rows_, true);
        tight.push_back(false);
        rays_.push_back({std::move(line), std::move(tight), false});
    }
    ++rows_;
}

void PolyhedralCone::cutRays(const ExactRow& row)
{
    std::vector<Integer> values;
    for (const Ray& ray : rays_) {
        values.push_back(valueAt(row, ray.at));
    }
    std::vector<Ray> kept;
    for (std::size_t i = 0; i < rays_.size(); ++i) {
        for (std::size_t j = 0; j < rays_.size(); ++j) {
            if (values[i] > 0 && values[j] < 0 && areAdjacent(i, j)) {
                Ray edge{combine(values[i], rays_[j].at, values[j], rays_[i].at), commonRows(i, j),
                         false};
                edge.tight.push_back(true);
                kept.push_back(std::move(edge));
            }
        }
    }
    for (std::size_t i = 0; i < rays_.size(); ++i) {
        if (values[i].is_zero() || (values[i] > 0 && !row.isEquality)) {
            rays_[i].tight.push_back(values[i].is_zero());
            kept.push_back(std::move(rays_[i]));
        }
    }
    rays_ = std::move(kept);
    ++rows_;
}

std::vector<bool> PolyhedralCone::commonRows(std::size_t i, std::size_t j) const
{
    std::vector<bool> common(rows_);
    for (std::size_t k = 0; k < rows_; ++k) {
        common[k] = rays_[i].tight[k] && rays_[j].tight[k];
    }
    return common;
}

bool PolyhedralCone::areAdjacent(std::size_t i, std::size_t j) const
{
    const std::vector<bool> common = commonRows(i, j);
    for (std::size_t other = 0; other < rays_.size(); ++other) {
        if (other == i || other == j) {
            continue;
        }
        bool liesOnAll = true;
        for (std::size_t k = 0; k < rows_ && liesOnAll; ++k) {
            liesOnAll = !common[k] || rays_[other].tight[k];
        }
        if (liesOnAll) {
            return false;
        }
    }
    return true;
}

namespace {

/// A row of the source that the cone breaks.
std::optional<ExactRow> violatedRow(const RowSource& source, PolyhedralCone& cone)
{
    for (PolyhedralCone::Ray& ray : cone.rays()) {
        if (ray.isChecked) {
            continue;
        }
        if (auto row = source.violatedRow(homogeneous(ray.at))) {
            return row;
        }
        ray.isChecked = true;
    }
    for (const IntegerVector& line : cone.lines()) {
        for (const int sign : {1, -1}) {
            if (auto row = source.violatedRow(homogeneous(line, sign))) {
                return row;
            }
        }
    }
    return std::nullopt;
}

}  // namespace

std::optional<Generators> generatorsOf(const RowSource& source, std::size_t maxRays)
{
    PolyhedralCone cone(source.unknowns());
    while (const auto row = violatedRow(source, cone)) {
        cone.cut(*row);
        if (cone.rays().size() > maxRays) {
            return std::nullopt;
        }
    }
    Generators result;
    for (const PolyhedralCone::Ray& ray : cone.rays()) {
        (ray.at.back() > 0 ? result.vertices : result.directions).push_back(homogeneous(ray.at));
    }
    for (const IntegerVector& line : cone.lines()) {
        result.directions.push_back(homogeneous(line));
        result.directions.push_back(homogeneous(line, -1));
    }
    return result;
}

}  // namespace signorini
