#include "harmonic_contact.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "harmonic_walk.hpp"
#include "portable.hpp"

namespace signorini {

namespace {

using Complex = HarmonicCase::Complex;
using std::numbers::pi;

constexpr double sameMotion = 1e-7;      // what rounding makes of a double root
constexpr double nearEnd = 1e-12;        // of an angle, in which a release may be the next cell's
constexpr double shortestPiece = 1e-13;  // of a period

/// kappa on all cells.
struct Chain {
    std::vector<Complex> waves;
    Complex sum;  ///< of kappa e^{i omega m h} over the cells of 2L/c

    [[nodiscard]] Complex at(std::int64_t m) const { return waves[static_cast<std::size_t>(m)]; }
};

/// Every cell of tau, one after the other.
class ContactSearch {
public:
    explicit ContactSearch(const HarmonicCase& given)
        : given_(given), back_(given.inCells(-given.back))
    {
        for (std::int64_t m = 0; m < given.cells; ++m) {
            turns_.push_back(given.inCells(m));
        }
    }

    std::vector<HarmonicMotion> run()
    {
        Chain before = chainOf(0);
        for (std::int64_t j = 1; j < given_.cells; ++j) {
            Chain after = chainOf(j);
            addSmooth(j - 1, after, before);
            addPinned(j, after);
            before = std::move(after);
        }
        std::sort(found_.begin(), found_.end(),
                  [](const HarmonicMotion& x, const HarmonicMotion& y) {
                      return x.extremes.impulse < y.extremes.impulse;
                  });
        return std::move(found_);
    }

private:
    /// Of `contact` cells of contact. O(nu). \pre contact < nu.
    [[nodiscard]] Chain chainOf(std::int64_t contact) const
    {
        Chain chain{std::vector<Complex>(static_cast<std::size_t>(given_.cells)), 0.0};
        const auto goRound = [&](Complex wave) {
            std::int64_t m = 0;
            for (std::int64_t k = 0; k < given_.cells; ++k) {
                chain.waves[static_cast<std::size_t>(m)] = wave;
                wave = back_ * given_.after(wave, m < contact);
                m = (m + given_.back) % given_.cells;
            }
            return wave;
        };
        const auto flights = static_cast<double>(given_.cells - contact);
        const double decay = flights * portable::log(given_.rho);
        const bool isEven = (given_.cells - contact) % 2 == 0;
        goRound(goRound(0.0) / (isEven ? -portable::expm1(decay) : 1.0 + portable::exp(decay)));
        const std::int64_t whole = given_.back / given_.cells;
        for (std::int64_t m = 0; m < given_.cells; ++m) {
            const std::int64_t times = whole + (m < given_.back % given_.cells ? 1 : 0);
            chain.sum += static_cast<double>(times) * (chain.at(m) * inCells(m));
        }
        return chain;
    }

    [[nodiscard]] Complex inCells(std::int64_t m) const
    {
        return turns_[static_cast<std::size_t>(m % given_.cells)];
    }

    /// R(tau) = 0 in cell j: A = +-i |A| unit e^{-i omega sigma h}.
    void addSmooth(std::int64_t j, const Chain& early, const Chain& late)
    {
        const Complex integrate = Complex(0.0, -1.0) / given_.omega;  // 1/(i omega)
        const Complex alpha = given_.place() - (inCells(1) * late.sum - early.sum) * integrate;
        const Complex beta = (late.sum - early.sum) * integrate;
        const Complex release = given_.push(early.at(j));
        if (lengthOf(alpha) == 0.0 || lengthOf(release) == 0.0) {
            return;  // u(L, 0) or R is the same for all sigma
        }
        const Complex unit =
            Complex(0.0, 1.0) * std::conj(release) / lengthOf(release) * std::conj(inCells(j));
        const double wall = static_cast<double>(given_.stops.right) / given_.amplitude;
        const double cell = given_.omega * given_.step;
        for (const double sign : {1.0, -1.0}) {
            const double cosine = (sign * wall - (unit * beta).real()) / lengthOf(alpha);
            if (!(std::abs(cosine) <= 1.0 + nearEnd)) {
                continue;
            }
            const double apart = portable::acos(std::clamp(cosine, -1.0, 1.0));
            const double middle = angleOf(unit * alpha);
            for (double angle : {middle - apart, middle + apart}) {
                angle -= 2.0 * pi * std::floor((angle + nearEnd) / (2.0 * pi));
                for (; angle <= cell + nearEnd; angle += 2.0 * pi) {
                    const double part = std::clamp(angle / cell, 0.0, 1.0);
                    add(j, part, sign * unit * turned(-part * cell), early, late);
                }
            }
        }
    }

    /// tau = jh, R passes through 0 there.
    void addPinned(std::int64_t j, const Chain& chain)
    {
        const Complex gap =
            given_.place() + Complex(0.0, 1.0) / given_.omega * chain.sum * (inCells(1) - 1.0);
        const double cosine =
            static_cast<double>(given_.stops.right) / given_.amplitude / lengthOf(gap);
        if (!(std::abs(cosine) <= 1.0 + nearEnd)) {
            return;
        }
        const double apart = portable::acos(std::clamp(cosine, -1.0, 1.0));
        for (const double angle : {apart, -apart}) {
            const Complex unit = turned(angle - angleOf(gap));
            const Complex now = unit * inCells(j);
            const double before = (given_.push(chain.at(j - 1)) * now).real();
            const double after = (given_.push(chain.at(j)) * now).real();
            const double near =
                harmonicTolerance * (1.0 + lengthOf(chain.at(j - 1)) + lengthOf(chain.at(j)));
            if (before >= -near && after <= near) {
                add(j, 0.0, unit, chain, chain);
            }
        }
    }

    /// With contact to (j + part) h and the excitation |A| unit, if it is a motion.
    void add(std::int64_t j, double part, Complex unit, const Chain& early, const Chain& late)
    {
        HarmonicMotion motion;
        const double release = (static_cast<double>(j) + part) * given_.step;
        if (release <= shortestPiece * given_.period()) {
            return;
        }
        motion.phase = -angleOf(unit);
        motion.contacts.push_back(
            {.end = release, .isPinned = part == 0.0, .travel = part == 0.0 ? release : 0.0});
        const Complex excitation = given_.amplitude * unit;
        double begin = 0.0;
        const auto append = [&](double end, Complex wave) {
            if (end - begin > shortestPiece * given_.period()) {
                motion.pieces.push_back({end, wave * excitation});
                begin = end;
            }
        };
        for (std::int64_t m = 0; m < given_.cells; ++m) {
            append((static_cast<double>(m) + part) * given_.step, early.at(m));
            append(static_cast<double>(m + 1) * given_.step, late.at(m));
        }
        measure(given_, motion);
        const bool isKnown = std::any_of(found_.begin(), found_.end(), [&](const auto& other) {
            return std::abs(other.contacts[0].end - release) <= sameMotion &&
                   std::abs(std::remainder(other.phase - motion.phase, 2.0 * pi)) <= sameMotion;
        });
        if (motion.residual <= harmonicTolerance && !isKnown) {
            found_.push_back(std::move(motion));
        }
    }

    const HarmonicCase& given_;
    Complex back_;  ///< e^{-2 i omega}
    std::vector<Complex> turns_;
    std::vector<HarmonicMotion> found_;
};

}  // namespace

std::vector<HarmonicMotion> harmonicContacts(const HarmonicCase& given)
{
    return ContactSearch(given).run();
}

std::vector<HarmonicMotion> harmonicContacts(const Damping& damping, const Harmonic& excitation,
                                             const Stops& stops)
{
    return harmonicContacts(harmonicCase(damping, excitation, stops));
}

}  // namespace signorini
