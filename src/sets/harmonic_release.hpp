#pragma once
/// \file
/// Where a contact under a harmonic may end, cell by cell of its length: the equations of one bar
/// and of a network are the same (docs/theory.md, section 21, "The release").

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

#include "harmonic_motion.hpp"
#include "portable.hpp"

namespace signorini {

/// A contact that ends in a cell, a part sigma of it after its beginning; e^{i omega t} is 1 where
/// contact begins, and amplitudes are for A = 1.
struct ReleaseCell {
    using Complex = std::complex<double>;

    Complex alpha;  ///< place = Re(A (alpha + beta e^{i omega sigma h}))
    Complex beta;
    Complex push;         ///< R = Re(A push e^{i omega s}), s from the beginning of the cell
    double place = 0.0;   ///< for |A| = 1
    double turn = 0.0;    ///< [rad], omega h
    double later = 0.0;   ///< d place/d sigma, and
    double steady = 0.0;  ///< what R has beside, under constant forces; for |A| = 1
};

/// An angle so near the end of its cell is in it.
inline constexpr double nearCellEnd = 1e-12;

/// Visits sigma and A/|A| of each smooth release, R = 0, in a cell: A = +-i e^{-i omega sigma h}
/// times the direction of the push, one arccos for each sign.
template <typename Visit>
void forEachSmoothRelease(const ReleaseCell& cell, const Visit& visit)
{
    using std::numbers::pi;
    const double size = lengthOf(cell.alpha);
    if (size == 0.0 || lengthOf(cell.push) == 0.0) {
        return;  // the place or R is the same for all sigma
    }
    const ReleaseCell::Complex unit =
        ReleaseCell::Complex(0.0, 1.0) * std::conj(cell.push) / lengthOf(cell.push);
    for (const double sign : {1.0, -1.0}) {
        const double cosine = (sign * cell.place - (unit * cell.beta).real()) / size;
        if (!(std::abs(cosine) <= 1.0 + nearCellEnd)) {
            continue;
        }
        const double apart = portable::acos(std::clamp(cosine, -1.0, 1.0));
        const double middle = angleOf(unit * cell.alpha);
        for (double angle : {middle - apart, middle + apart}) {
            angle -= 2.0 * pi * std::floor((angle + nearCellEnd) / (2.0 * pi));
            for (; angle <= cell.turn + nearCellEnd; angle += 2.0 * pi) {
                const double part = std::clamp(angle / cell.turn, 0.0, 1.0);
                visit(part, sign * unit * turned(-part * cell.turn));
            }
        }
    }
}

/// The same under constant forces: R = 0 leaves two values w of A e^{i omega sigma h}, and for each
/// the place a harmonic of sigma and a straight line, which has one root at most between the ends
/// and turning points of their difference. O(1), by halving.
template <typename Visit>
void forEachLoadedRelease(const ReleaseCell& cell, const Visit& visit)
{
    using std::numbers::pi;
    const double push = lengthOf(cell.push);
    if (push == 0.0 || !(std::abs(cell.steady) <= push * (1.0 + nearCellEnd))) {
        return;
    }
    const double size = lengthOf(cell.alpha);
    const double slope = cell.turn * size;
    const double away = portable::acos(std::clamp(-cell.steady / push, -1.0, 1.0));
    for (const double way : {away, -away}) {
        const ReleaseCell::Complex w = turned(way) * std::conj(cell.push) / push;
        const double start = angleOf(w * cell.alpha);
        const double level = (w * cell.beta).real() - cell.place;
        const auto miss = [&](double part) {
            return size * turned(start - cell.turn * part).real() + level - cell.later * part;
        };
        std::vector<double> ends{0.0, 1.0};
        if (std::abs(cell.later) < slope) {  // it turns back where the sine is later/slope
            const double apart = portable::acos(cell.later / slope);
            for (const double angle : {apart, -apart}) {
                const double back = start - 0.5 * pi - angle;
                const double part = (back - 2.0 * pi * std::floor(back / (2.0 * pi))) / cell.turn;
                ends.push_back(std::min(part, 1.0));
            }
            std::sort(ends.begin(), ends.end());
        }
        const double near = nearCellEnd * (size + std::abs(level));
        for (std::size_t k = 0; k + 1 < ends.size(); ++k) {
            double low = ends[k];
            double high = ends[k + 1];
            const double before = miss(low);
            const double after = miss(high);
            if (std::abs(before) <= near) {
                high = low;
            } else if (std::abs(after) <= near) {
                low = high;
            } else if ((before > 0.0) == (after > 0.0)) {
                continue;
            }
            for (double middle = 0.5 * (low + high); low < middle && middle < high;
                 middle = 0.5 * (low + high)) {
                ((miss(middle) > 0.0) == (before > 0.0) ? low : high) = middle;
            }
            visit(low, w * turned(-low * cell.turn));
        }
    }
}

/// Visits A/|A| of each contact of whole cells: place = Re(A gap).
template <typename Visit>
void forEachPinnedRelease(ReleaseCell::Complex gap, double place, const Visit& visit)
{
    const double cosine = place / lengthOf(gap);
    if (!(std::abs(cosine) <= 1.0 + nearCellEnd)) {
        return;
    }
    const double apart = portable::acos(std::clamp(cosine, -1.0, 1.0));
    for (const double angle : {apart, -apart}) {
        visit(turned(angle - angleOf(gap)));
    }
}

}  // namespace signorini
