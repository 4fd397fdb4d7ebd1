#include "harmonic_pattern.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "dense.hpp"
#include "harmonic_march.hpp"
#include "harmonic_walk.hpp"
#include "pattern_waves.hpp"

namespace signorini {

namespace {

using Complex = HarmonicCase::Complex;

constexpr int mostSteps = 25;              // of Newton
constexpr int mostPatterns = 12;           // that are read off
constexpr double longestStep = 0.1;        // L/c, of a place; and rad of the phase
constexpr double stillness = 1e-13;        // a step that changes nothing any more
constexpr double noFlightAtAll = 1e-10;    // L/c
constexpr double shortestContact = 1e-12;  // L/c, of a contact

/// Newton on one pattern, with |A| as it is, or across a tangent. \return the A that solves it.
std::optional<Complex> solve(const HarmonicCase& given, HarmonicPattern& pattern,
                             Complex excitation, const Eigen::VectorXd& tangent = {})
{
    Eigen::VectorXd residual;
    Eigen::MatrixXd slope;
    for (int k = 0; k < mostSteps; ++k) {
        if (!pattern.isOrdered() || !pattern.setWaves()) {
            return std::nullopt;
        }
        pattern.equations(excitation, residual, slope);
        const Eigen::Index last = residual.size() - 1;
        residual[last] = 0.0;
        slope(last, 0) = excitation.real();
        slope(last, 1) = excitation.imag();
        if (tangent.size() > 0) {
            slope.row(last) = tangent.transpose();
        }
        Eigen::VectorXd step = SquareFactors(slope).solve(-residual);
        if (!step.allFinite()) {
            return std::nullopt;
        }
        const double turn = lengthOf({step[0], step[1]}) / given.amplitude;
        const double shift =
            step.size() > 2 ? step.tail(step.size() - 2).cwiseAbs().maxCoeff() * given.step : 0.0;
        step *= std::min(1.0, longestStep / std::max({turn, shift, 1e-300}));
        excitation += Complex(step[0], step[1]);
        excitation *= tangent.size() > 0 ? 1.0 : given.amplitude / lengthOf(excitation);
        pattern.move(step);
        if (std::max(turn, shift) < stillness) {
            return pattern.isOrdered() && pattern.setWaves() ? std::optional(excitation)
                                                             : std::nullopt;
        }
    }
    return std::nullopt;
}

/// The same with t = 0 at the first beginning.
HarmonicStart startingAt0(const HarmonicCase& given, HarmonicStart start)
{
    if (!start.contacts.empty()) {
        const double first = start.contacts.front().begin;
        start.phase = std::remainder(start.phase - given.omega * first, 2.0 * std::numbers::pi);
        for (HarmonicContact& one : start.contacts) {
            one.begin -= first;
            one.end -= first;
        }
    }
    return start;
}

}  // namespace

std::int64_t returnOf(const HarmonicCase& given, const HarmonicContact& one)
{
    std::int64_t i = 1;
    while (i < given.cells && std::abs(std::remainder(2.0 * static_cast<double>(i) - one.travel,
                                                      given.period())) > sameTravel) {
        ++i;
    }
    return i;
}

std::vector<HarmonicContact> joined(const std::vector<HarmonicContact>& all, double within)
{
    std::vector<HarmonicContact> found;
    std::vector<std::size_t> index;  // where one is now
    for (const HarmonicContact& one : all) {
        if (!found.empty() && found.back().stop == one.stop &&
            one.begin - found.back().end < within) {
            const double begin = found.back().begin;
            found.back() = one;
            found.back().begin = begin;
        } else {
            found.push_back(one);
        }
        index.push_back(found.size() - 1);
    }
    for (HarmonicContact& one : found) {
        one.front = index[one.front];
    }
    return found;
}

std::vector<HarmonicContact> HarmonicPattern::contactsOf(Complex excitation) const
{
    std::deque<ArrivingPiece> arriving;
    double begin = 0.0;
    for (std::size_t i = 0; i < waves_.size(); ++i) {
        const double end = i + 1 == waves_.size() ? given_.period() : timeAt(i + 1);
        if (end > begin) {
            const std::size_t place = order_[i % places()];
            arriving.push_back({end, {0.0, waves_[i] * excitation}});
            if (place < contacts_.size()) {
                arriving.back().front = place;
            }
            begin = end;
        }
    }
    HarmonicMarch march(given_, -angleOf(excitation), std::move(arriving),
                        given_.placeOf(contacts_.front().stop));
    march.advance(given_.period());
    std::vector<HarmonicContact> found = march.contacts();
    if (march.isHeld()) {
        // Just begun, it is the first contact again.
        found.back().end = given_.period();
        found.resize(std::max<std::size_t>(1, found.size() - 1));
    }
    std::erase_if(found, [](const auto& one) { return !(one.end > one.begin + shortestContact); });
    for (HarmonicContact& one : found) {
        if (one.isPinned) {
            const double left = timeOf(contacts_[one.front].begin);
            const auto apart = [&](const HarmonicContact& other) {
                return std::abs(std::remainder(other.begin - left, given_.period()));
            };
            one.travel = one.end - left;
            one.front =
                static_cast<std::size_t>(std::min_element(found.begin(), found.end(),
                                                          [&](const auto& x, const auto& y) {
                                                              return apart(x) < apart(y);
                                                          }) -
                                         found.begin());
        }
    }
    return joined(found, noFlightAtAll);
}

namespace {

/// What does not change f at first order; of length 1 in relative A and L/c.
std::optional<Eigen::VectorXd> tangentOf(const HarmonicCase& given, HarmonicPattern& pattern,
                                         Complex excitation)
{
    if (!pattern.isOrdered() || !pattern.setWaves()) {
        return std::nullopt;
    }
    Eigen::VectorXd residual;
    Eigen::MatrixXd slope;
    pattern.equations(excitation, residual, slope);
    const Eigen::Index n = residual.size();
    Eigen::VectorXd scale = Eigen::VectorXd::Constant(n, 1.0 / given.step);
    scale.head(2).setConstant(given.amplitude);
    const Eigen::MatrixXd rows = slope.topRows(n - 1) * scale.asDiagonal();
    const FullFactors parts(rows);
    if (parts.rank() != n - 1) {
        return std::nullopt;
    }
    Eigen::VectorXd tangent = parts.kernel().col(0).normalized();
    return tangent.cwiseProduct(scale);
}

}  // namespace

bool stepAlongAmplitude(HarmonicCase& given, HarmonicMotion& motion, HarmonicDirection& direction,
                        double length)
{
    HarmonicPattern pattern(given, {motion.phase, motion.contacts});
    Complex excitation = given.amplitude * turned(-motion.phase);
    auto tangent = tangentOf(given, pattern, excitation);
    if (!tangent) {
        return false;
    }
    const Complex change = Complex((*tangent)[0], (*tangent)[1]) / excitation;
    HarmonicDirection way{change.real(), -change.imag()};
    for (const PatternContact& one : pattern.contacts()) {
        for (const PatternInstant& at : {one.begin, one.end}) {
            way.push_back(at.place == 0
                              ? 0.0
                              : given.step * (*tangent)[static_cast<Eigen::Index>(at.place) + 1]);
        }
    }
    const double along = direction.size() == way.size()
                             ? std::inner_product(way.begin(), way.end(), direction.begin(), 0.0)
                             : way[0];
    if (along < 0.0) {
        *tangent *= -1.0;
        for (double& part : way) {
            part = -part;
        }
    }
    pattern.move(length * *tangent);
    excitation += length * Complex((*tangent)[0], (*tangent)[1]);
    Eigen::VectorXd across = *tangent;
    across.head(2) /= given.amplitude * given.amplitude;
    across.tail(across.size() - 2) *= given.step * given.step;
    const auto found = solve(given, pattern, excitation, across);
    if (!found) {
        return false;
    }
    HarmonicCase there = given;
    there.amplitude = lengthOf(*found);
    HarmonicMotion next = pattern.motion(*found);
    measure(there, next);
    if (next.residual > harmonicTolerance) {
        const auto other =
            harmonicNear(there, startingAt0(there, {next.phase, pattern.contactsOf(*found)}));
        if (!other) {
            return false;
        }
        next = *other;
    }
    given = there;
    motion = std::move(next);
    direction = std::move(way);
    return true;
}

std::optional<HarmonicMotion> harmonicNear(const HarmonicCase& given, const HarmonicStart& start)
{
    HarmonicStart now = start;
    for (int k = 0; k < mostPatterns; ++k) {
        if (now.contacts.empty() || std::ssize(now.contacts) > maxHarmonicContacts) {
            return std::nullopt;
        }
        HarmonicPattern pattern(given, now);
        const auto excitation = solve(given, pattern, given.amplitude * turned(-now.phase));
        if (!excitation) {
            return std::nullopt;
        }
        HarmonicMotion motion = pattern.motion(*excitation);
        if (auto fewer = joined(motion.contacts, noFlightAtAll);
            fewer.size() < motion.contacts.size()) {
            now = {motion.phase, std::move(fewer)};
            continue;
        }
        measure(given, motion);
        if (motion.residual <= harmonicTolerance) {
            return motion;
        }
        now = startingAt0(given, {motion.phase, pattern.contactsOf(*excitation)});
    }
    return std::nullopt;
}

}  // namespace signorini
