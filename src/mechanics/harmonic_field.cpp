#include "harmonic_field.hpp"

#include <algorithm>
#include <cmath>

namespace signorini {

HarmonicField::HarmonicField(HarmonicCase given, HarmonicMotion motion)
    : given_(given), motion_(std::move(motion))
{
    base_ = given_.isForce ? 0.0 : given_.amplitude * turned(-motion_.phase);
    double begin = 0.0;
    sums_.push_back(0.0);
    for (const HarmonicPiece& piece : motion_.pieces) {
        sums_.push_back(sums_.back() +
                        (piece.wave * (given_.at(piece.end) - given_.at(begin))).imag() /
                            given_.omega);
        begin = piece.end;
    }
}

std::size_t HarmonicField::pieceAt(double t) const
{
    const auto piece =
        std::upper_bound(motion_.pieces.begin(), motion_.pieces.end() - 1, t,
                         [](double at, const HarmonicPiece& one) { return at < one.end; });
    return static_cast<std::size_t>(piece - motion_.pieces.begin());
}

double HarmonicField::arriving(double t) const
{
    const double at = t - period() * std::floor(t / period());
    return (motion_.pieces[pieceAt(at)].wave * given_.at(at)).real();
}

double HarmonicField::integral(double t) const
{
    const double periods = std::floor(t / period());
    const double at = t - period() * periods;
    const std::size_t k = pieceAt(at);
    const double begin = k == 0 ? 0.0 : motion_.pieces[k - 1].end;
    return periods * sums_.back() + sums_[k] +
           (motion_.pieces[k].wave * (given_.at(at) - given_.at(begin))).imag() / given_.omega;
}

double HarmonicField::displacement(double x, double t) const
{
    return (base_ * given_.at(t + x)).real() - integral(t + 1.0 + x) + integral(t + 1.0 - x);
}

double HarmonicField::velocity(double x, double t) const
{
    const std::complex<double> speed = std::complex<double>(0.0, given_.omega) * base_;
    return (speed * given_.at(t + x)).real() - arriving(t + 1.0 + x) + arriving(t + 1.0 - x);
}

double HarmonicField::strain(double x, double t) const
{
    const std::complex<double> speed = std::complex<double>(0.0, given_.omega) * base_;
    return (speed * given_.at(t + x)).real() - arriving(t + 1.0 + x) - arriving(t + 1.0 - x);
}

double HarmonicField::push(double t) const
{
    const double at = t - period() * std::floor(t / period());
    const bool isHeld =
        std::any_of(motion_.contacts.begin(), motion_.contacts.end(),
                    [&](const auto& one) { return at >= one.begin && at < one.end; });
    const double force =
        given_.force() * given_.amplitude * (given_.at(at) * turned(-motion_.phase)).real();
    return isHeld ? force + 2.0 * arriving(at) : 0.0;
}

}  // namespace signorini
