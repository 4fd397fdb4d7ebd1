#include "signorini/sphere_section.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "faults.hpp"
#include "signorini/closed_form.hpp"

namespace signorini {

namespace {

double squaresOf(std::span<const double> z)
{
    return std::inner_product(z.begin(), z.end(), z.begin(), 0.0);
}

double sumOf(std::span<const double> z)
{
    return std::accumulate(z.begin(), z.end(), 0.0);
}

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

/// The point of the cap above y, with root = rho - |y|^2 (1 - rho) given.
std::vector<double> lifted(std::vector<double> y, std::size_t apex, double rho, double root)
{
    if (y.size() == 1) {
        return {1.0};
    }
    const double t = (1.0 - rho) / (1.0 + std::sqrt(root));
    for (double& value : y) {
        value *= t;
    }
    y[apex] = 1.0 - t;
    return y;
}

double rootAt(const std::vector<double>& y, double rho)
{
    return std::max(0.0, rho - squaresOf(y) * (1.0 - rho));
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

/// A point in the caps of both i and k: z_i = z_k, and the rest in the mean proportions of the two
/// ends, flattened as far as rho asks for. With r of sum 1 for the rest and q = |r|^2,
/// 2 x^2 + (1 - 2 x)^2 q = rho has a solution x >= rho if q <= rho/(1 - 2 rho).
std::vector<double> bridge(const SphereSection& section, std::span<const double> from,
                           std::span<const double> to, std::size_t i, std::size_t k)
{
    const double rho = section.ratio;
    const std::size_t count = from.size();
    std::vector<double> z(count, 0.0);
    if (count > 2) {
        const double even = 1.0 / static_cast<double>(count - 2);
        for (std::size_t j = 0; j < count; ++j) {
            z[j] = std::max(0.0, from[j]) + std::max(0.0, to[j]);
        }
        z[i] = z[k] = 0.0;
        const double sum = sumOf(z);
        for (double& value : z) {
            value = sum > 0.0 ? value / sum : even;
        }
        z[i] = z[k] = 0.0;
        const double most = rho < 0.5 ? rho / (1.0 - 2.0 * rho) : 1.0;
        const double spread = squaresOf(z) - even;
        const double share =
            spread > most - even ? std::sqrt(std::max(0.0, most - even) / spread) : 1.0;
        for (double& value : z) {
            value = even + share * (value - even);
        }
        z[i] = z[k] = 0.0;
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

SphereSection clamped(const SphereSection& section)
{
    if (section.count < 1) {
        throw std::invalid_argument("sphere section: allowed at least one amplitude");
    }
    return {section.count,
            std::clamp(section.ratio, 1.0 / static_cast<double>(section.count), 1.0)};
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

/// Amplitudes [sum z] below this are on the face: two that reach it together differ by rounding.
constexpr double negligible = 1e-15;

SlidingWalk::SlidingWalk(const SphereSection& section, std::span<const double> from,
                         std::span<const double> direction)
    : section_(section), z_(from.begin(), from.end()), wish_(direction.begin(), direction.end())
{
    if (z_.size() != wish_.size() || static_cast<std::int64_t>(z_.size()) != section.count) {
        throw std::invalid_argument(fmt::format(
            "direction = {} amplitudes is out of range: allowed {}", wish_.size(), section.count));
    }
    for (double& value : z_) {
        value = value > negligible ? value : 0.0;
    }
    findTangent();
}

/// The part of the wish that keeps sum and sum z^2, without the amplitudes that are zero and would
/// become negative. Leaving one out changes the others, so this repeats until nothing is left out.
void SlidingWalk::findTangent()
{
    const std::size_t count = z_.size();
    std::vector<bool> active(count, false);
    for (bool changed = true; changed;) {
        changed = false;
        double members = 0.0;
        double sum = 0.0;
        for (std::size_t j = 0; j < count; ++j) {
            members += active[j] ? 0.0 : 1.0;
            sum += active[j] ? 0.0 : wish_[j];
        }
        centre_ = 1.0 / std::max(members, 1.0);
        double along = 0.0;
        double squares = 0.0;
        for (std::size_t j = 0; j < count; ++j) {
            const double out = active[j] ? 0.0 : z_[j] - centre_;
            along += out * wish_[j];
            squares += out * out;
        }
        radius_ = std::sqrt(squares);
        tangent_.assign(count, 0.0);
        double length = 0.0;
        for (std::size_t j = 0; j < count; ++j) {
            if (!active[j]) {
                const double out = z_[j] - centre_;
                tangent_[j] =
                    wish_[j] - sum * centre_ - (squares > 0.0 ? along / squares * out : 0.0);
                length += tangent_[j] * tangent_[j];
            }
        }
        length = std::sqrt(length);
        canMove_ = length > 1e-12 && radius_ > 0.0;
        for (std::size_t j = 0; canMove_ && j < count; ++j) {
            tangent_[j] /= length;
            if (!active[j] && z_[j] <= 0.0 && tangent_[j] < 0.0) {
                active[j] = changed = true;
            }
        }
    }
}

/// On the circle z_j = centre + out cos(t) + radius tangent sin(t), the first t > 0 at which an
/// amplitude falls through zero.
double SlidingWalk::angleToFace(std::size_t& meets) const
{
    constexpr double turn = 2.0 * std::numbers::pi;
    double first = turn;
    meets = z_.size();
    for (std::size_t j = 0; j < z_.size(); ++j) {
        const double cosine = z_[j] - centre_;
        const double sine = radius_ * tangent_[j];
        const double swing = std::hypot(cosine, sine);
        if (swing <= centre_ || (z_[j] <= 0.0 && tangent_[j] == 0.0)) {
            continue;
        }
        const double falls = std::atan2(sine, cosine) + std::acos(-centre_ / swing);
        const double angle = falls <= 0.0 ? falls + turn : falls;
        if (angle < first) {
            first = angle;
            meets = j;
        }
    }
    return first;
}

const std::vector<double>& SlidingWalk::advance(double length)
{
    while (canMove_ && length > 0.0) {
        std::size_t meets = 0;
        const double face = angleToFace(meets);
        const double angle = std::min(length / radius_, face);
        const double c = std::cos(angle);
        const double s = std::sin(angle);
        for (std::size_t j = 0; j < z_.size(); ++j) {
            if (z_[j] <= 0.0 && tangent_[j] == 0.0) {
                continue;  // active
            }
            const double out = z_[j] - centre_;
            const double next = centre_ + c * out + s * radius_ * tangent_[j];
            z_[j] = next > negligible ? next : 0.0;
            tangent_[j] = c * tangent_[j] - s * out / radius_;
        }
        length -= angle * radius_;
        if (angle == face && meets < z_.size()) {
            z_[meets] = 0.0;
        }
        wish_ = tangent_;
        findTangent();
    }
    return z_;
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

SectionSampler::SectionSampler(const AmplitudeSet& set, double squares, std::uint64_t seed)
    : set_(set), generator_(seed), z_(amplitudesWithSquares(set, squares))
{
    radius_ = std::sqrt(std::max(0.0, squares - leastSquares(set)));
}

const std::vector<double>& SectionSampler::next(int moves)
{
    for (int k = 0; k < moves; ++k) {
        if (set_.count > 2) {
            move();
        }
        if (set_.kind == SetKind::simplex) {
            std::shuffle(z_.begin(), z_.end(), generator_);
        }
    }
    return z_;
}

void SectionSampler::move()
{
    const double mean = set_.sum / static_cast<double>(set_.count);
    std::normal_distribution<double> normal;
    std::vector<double> direction(z_.size());
    for (double& value : direction) {
        value = normal(generator_);
    }
    // At right angles to (1, ..., 1) and to the radius, and as long as the radius.
    const double average = sumOf(direction) / static_cast<double>(z_.size());
    double along = 0.0;
    for (std::size_t j = 0; j < z_.size(); ++j) {
        direction[j] -= average;
        along += direction[j] * (z_[j] - mean);
    }
    const double squares = radius_ * radius_;
    if (!(squares > 0.0)) {
        return;  // equal amplitudes are the only member
    }
    for (std::size_t j = 0; j < z_.size(); ++j) {
        direction[j] -= along / squares * (z_[j] - mean);
    }
    const double length = std::sqrt(squaresOf(direction));
    for (double& value : direction) {
        value *= radius_ / length;
    }
    findArcs(direction);
    const double angle = drawAngle();
    std::vector<double> next(z_.size());
    for (std::size_t j = 0; j < z_.size(); ++j) {
        next[j] = mean + std::cos(angle) * (z_[j] - mean) + std::sin(angle) * direction[j];
        if (set_.kind == SetKind::simplex) {
            next[j] = std::max(next[j], 0.0);
        }
    }
    // Rounding must not add up over many moves.
    const double shift = (sumOf(next) - set_.sum) / static_cast<double>(next.size());
    double reached = 0.0;
    for (double& value : next) {
        value -= shift;
        reached += (value - mean) * (value - mean);
    }
    for (double& value : next) {
        value = mean + (value - mean) * radius_ / std::sqrt(reached);
    }
    z_ = std::move(next);
}

/// A bound level + x cos(angle) + y sin(angle) >= 0 fails within acos(level/A) of the angle
/// opposite to (x, y), A = |(x, y)|.
void SectionSampler::findArcs(const std::vector<double>& direction)
{
    outside_.clear();
    const auto bound = [this](double level, double x, double y) {
        const double size = std::hypot(x, y);
        if (size <= level) {
            return;
        }
        const double half = std::acos(std::clamp(level / size, -1.0, 1.0));
        double start = std::atan2(-y, -x) - half;
        start += start < 0.0 ? 2.0 * std::numbers::pi : 0.0;
        const double end = start + 2.0 * half;
        outside_.push_back({start, std::min(end, 2.0 * std::numbers::pi)});
        if (end > 2.0 * std::numbers::pi) {
            outside_.push_back({0.0, end - 2.0 * std::numbers::pi});
        }
    };
    const double mean = set_.sum / static_cast<double>(set_.count);
    double centre = 0.0;
    double x = 0.0;
    double y = 0.0;
    for (std::size_t j = 0; j + 1 < z_.size() || (j < z_.size() && set_.kind != SetKind::box);
         ++j) {
        const bool isBox = set_.kind == SetKind::box;
        centre = (isBox ? centre : 0.0) + mean;
        x = (isBox ? x : 0.0) + z_[j] - mean;
        y = (isBox ? y : 0.0) + direction[j];
        bound(centre - (isBox ? set_.lower : 0.0), x, y);
        if (isBox) {
            bound(set_.upper - centre, -x, -y);
        }
    }
}

/// Evenly from the angles in no arc; 0, where the walk stands, if rounding leaves none.
double SectionSampler::drawAngle()
{
    std::sort(outside_.begin(), outside_.end(),
              [](const Arc& a, const Arc& b) { return a.start < b.start; });
    std::vector<Arc> inside;
    double reached = 0.0;
    double total = 0.0;
    const auto gapUpTo = [&](double end) {
        if (end > reached) {
            inside.push_back({reached, end});
            total += end - reached;
        }
    };
    for (const Arc& arc : outside_) {
        gapUpTo(arc.start);
        reached = std::max(reached, arc.end);
    }
    gapUpTo(2.0 * std::numbers::pi);
    double rest = std::uniform_real_distribution<double>(0.0, total)(generator_);
    for (const Arc& arc : inside) {
        if (rest <= arc.end - arc.start) {
            return arc.start + rest;
        }
        rest -= arc.end - arc.start;
    }
    return 0.0;
}

}  // namespace signorini
