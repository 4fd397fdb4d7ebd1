#include "harmonic_walk.hpp"

#include <algorithm>
#include <cmath>
#include <deque>
#include <numbers>

#include "portable.hpp"

namespace signorini {

namespace {

using Complex = HarmonicCase::Complex;

constexpr double besides = 1e-9;  // L/c from an end of a piece: on this side of it

/// An extreme of a harmonic.
struct Peak {
    double angle;
    double value;
};

/// Re(z e^{i angle}) for from <= angle <= to: at both ends, and where it turns in between.
std::vector<Peak> peaksOf(Complex z, double from, double to)
{
    const double lead = portable::atan2(z.imag(), z.real());
    const double size = lengthOf(z);
    std::vector<Peak> peaks{{from, size * portable::cos(from + lead)},
                            {to, size * portable::cos(to + lead)}};
    const double half = std::ceil((from + lead) / std::numbers::pi);
    for (const double k : {half, half + 1.0}) {
        if (const double angle = k * std::numbers::pi - lead; angle <= to) {
            peaks.push_back({angle, std::fmod(k, 2.0) == 0.0 ? size : -size});
        }
    }
    return peaks;
}

class PieceWalk {
public:
    PieceWalk(const HarmonicCase& given, HarmonicMotion& motion)
        : given_(given),
          motion_(motion),
          seen_(motion.extremes),
          excitation_(given.amplitude * turned(-motion.phase)),
          size_(given.amplitude * std::max(given.force(), lengthOf(given.fromBase())))
    {
        for (const HarmonicPiece& piece : motion.pieces) {
            size_ = std::max(size_, lengthOf(piece.wave));
        }
    }

    void run()
    {
        std::vector<HarmonicContact>& contacts = motion_.contacts;
        tip_ = startOfContact();
        seen_.period = given_.period();
        seen_.lowestTip = given_.placeOf(contacts.front().stop);
        double defect = 0.0;
        double begin = 0.0;
        std::size_t k = contacts.size() - 1;
        for (const HarmonicPiece& piece : motion_.pieces) {
            const double middle = 0.5 * (begin + piece.end);
            if (const std::size_t next = (k + 1) % contacts.size();
                middle > contacts[next].begin && middle < contacts[next].end && next != k) {
                k = next;
            }
            HarmonicContact& contact = contacts[k];
            const bool isContact = middle > contact.begin && middle < contact.end;
            defect = std::max({defect, defectOfLaw(piece, middle, isContact),
                               isContact ? press(contact, piece, begin) : fly(piece, begin)});
            if (!isContact) {
                contacts[(k + 1) % contacts.size()].speed = std::abs(speed_);
            }
            begin = piece.end;
        }
        defect = std::max(defect, std::abs(tip_ - given_.placeOf(contacts.front().stop)));
        for (const HarmonicContact& contact : contacts) {
            seen_.contactTime += contact.end - contact.begin;
            seen_.impulse += contact.impulse;
            seen_.peakForce = std::max(seen_.peakForce, contact.peakForce);
            seen_.approachSpeed = std::max(seen_.approachSpeed, contact.speed);
        }
        motion_.residual =
            defect / std::max(size_, std::abs(static_cast<double>(given_.stops.right)));
        if (motion_.residual <= harmonicTolerance) {
            strain();
        }
    }

private:
    /// R = Re(push e^{i omega t}).
    [[nodiscard]] Complex push(const HarmonicPiece& piece) const
    {
        return 2.0 * piece.wave + given_.force() * excitation_;
    }

    /// The integral of Re(z e^{i omega t}).
    [[nodiscard]] double integral(Complex z, double begin, double end) const
    {
        return (z * (turned(given_.omega * end) - turned(given_.omega * begin))).imag() /
               given_.omega;
    }

    /// u(L, 0).
    [[nodiscard]] double startOfContact() const
    {
        double place = (given_.place() * excitation_).real();
        for (double past = 0.0; past < 2.0; past += given_.period()) {
            double begin = 0.0;
            for (const HarmonicPiece& piece : motion_.pieces) {
                const double end = std::min(piece.end, 2.0 - past);
                if (begin >= end) {
                    break;
                }
                place -= integral(piece.wave, begin, end);
                begin = piece.end;
            }
        }
        return place;
    }

    /// \return by how much the tip is beside the stop, or the stop pulls.
    double press(HarmonicContact& contact, const HarmonicPiece& piece, double begin)
    {
        const double sign = contact.stop == Stop::right ? 1.0 : -1.0;
        const Complex force = sign * push(piece);
        const HarmonicBounds seen = boundsOf(force, given_.omega * begin, given_.omega * piece.end);
        contact.peakForce = std::max(contact.peakForce, seen.most);
        contact.impulse += integral(force, begin, piece.end);
        return std::max(-seen.least, std::abs(tip_ - given_.placeOf(contact.stop)));
    }

    /// \return by how much the tip is beyond a stop.
    double fly(const HarmonicPiece& piece, double begin)
    {
        const Complex speed = given_.admittance() * push(piece);
        const Complex place = speed * Complex(0.0, -1.0 / given_.omega);
        const double from = given_.omega * begin;
        const double to = given_.omega * piece.end;
        const double start = tip_ - (place * turned(from)).real();
        const HarmonicBounds way = boundsOf(place, from, to);
        seen_.lowestTip = std::min(seen_.lowestTip, start + way.least);
        speed_ = (speed * turned(to)).real();
        tip_ += integral(speed, begin, piece.end);
        const double beyond = start + way.most - static_cast<double>(given_.stops.right);
        return given_.stops.left ? std::max(beyond, given_.placeOf(Stop::left) - start - way.least)
                                 : beyond;
    }

    /// What arrives 2L/c later is what the tip makes of this.
    [[nodiscard]] double defectOfLaw(const HarmonicPiece& piece, double time, bool isContact) const
    {
        const double later = std::fmod(time + 2.0, given_.period());
        const auto next =
            std::upper_bound(motion_.pieces.begin(), motion_.pieces.end() - 1, later,
                             [](double t, const HarmonicPiece& other) { return t < other.end; });
        const Complex law = excitation_ * given_.after(piece.wave / excitation_, isContact);
        return lengthOf(next->wave * given_.inCells(given_.back) - law);
    }

    void strain()
    {
        const Complex base =
            excitation_ * given_.fromBase() * std::conj(given_.inCells(given_.back));
        std::vector<Peak> arriving;
        std::vector<Peak> left;  // B; angles are times here
        double begin = 0.0;
        for (const HarmonicPiece& piece : motion_.pieces) {
            const double middle = 0.5 * (begin + piece.end);
            const bool isContact = std::any_of(
                motion_.contacts.begin(), motion_.contacts.end(),
                [&](const auto& one) { return middle > one.begin && middle < one.end; });
            const Complex leaving = given_.fromBase() * excitation_ -
                                    excitation_ * given_.after(piece.wave / excitation_, isContact);
            addPeaks(arriving, piece.wave, begin, piece.end);
            addPeaks(left, base - piece.wave, begin, piece.end);
            for (const Complex end : {base - 2.0 * piece.wave, leaving - piece.wave}) {
                const HarmonicBounds seen =
                    boundsOf(end, given_.omega * begin, given_.omega * piece.end);
                stretch(seen.least);
                stretch(seen.most);
            }
            begin = piece.end;
        }
        // B - r with r no more than 2L/c before B, in a window that slides along.
        for (const double sign : {1.0, -1.0}) {
            spread(arriving, left, sign);
        }
    }

    /// The largest sign (B - r).
    void spread(const std::vector<Peak>& arriving, const std::vector<Peak>& left, double sign)
    {
        std::vector<Peak> before;
        for (double past = std::ceil(2.0 / given_.period()); past >= 0.0; --past) {
            for (const Peak& r : arriving) {
                before.push_back({r.angle - past * given_.period(), sign * r.value});
            }
        }
        std::deque<Peak> least;  // of the window: each is below those that follow
        auto next = before.begin();
        for (const Peak& b : left) {
            for (; next != before.end() && next->angle <= b.angle; ++next) {
                while (!least.empty() && least.back().value >= next->value) {
                    least.pop_back();
                }
                least.push_back(*next);
            }
            while (!least.empty() && b.angle - least.front().angle > 2.0) {
                least.pop_front();
            }
            if (!least.empty()) {
                stretch(sign * (sign * b.value - least.front().value));
            }
        }
    }

    void addPeaks(std::vector<Peak>& peaks, Complex z, double begin, double end) const
    {
        const auto first = static_cast<std::ptrdiff_t>(peaks.size());
        const double middle = 0.5 * (begin + end);  // of a piece that may be shorter than that
        for (Peak peak : peaksOf(z, given_.omega * begin, given_.omega * end)) {
            peak.angle = std::clamp(peak.angle / given_.omega, std::min(begin + besides, middle),
                                    std::max(end - besides, middle));
            peaks.push_back(peak);
        }
        std::sort(peaks.begin() + first, peaks.end(),
                  [](const Peak& x, const Peak& y) { return x.angle < y.angle; });
    }

    void stretch(double s)
    {
        seen_.peakCompression = std::max(seen_.peakCompression, -s);
        seen_.peakTension = std::max(seen_.peakTension, s);
    }

    const HarmonicCase& given_;
    HarmonicMotion& motion_;
    Extremes& seen_;
    Complex excitation_;  ///< A
    double size_;         ///< of the waves
    double tip_ = 0.0;    ///< u(L)
    double speed_ = 0.0;  ///< of it, at the end of a flight
};

}  // namespace

HarmonicBounds boundsOf(Complex z, double from, double to)
{
    const auto peaks = peaksOf(z, from, to);
    const auto [least, most] = std::minmax_element(
        peaks.begin(), peaks.end(), [](const Peak& x, const Peak& y) { return x.value < y.value; });
    return {least->value, most->value};
}

void measure(const HarmonicCase& given, HarmonicMotion& motion)
{
    PieceWalk(given, motion).run();
}

}  // namespace signorini
