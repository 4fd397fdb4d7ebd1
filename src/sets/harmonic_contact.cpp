#include "harmonic_contact.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "harmonic_release.hpp"
#include "harmonic_walk.hpp"
#include "portable.hpp"

namespace signorini {

namespace {

using Complex = HarmonicCase::Complex;
using std::numbers::pi;

constexpr double sameMotion = 1e-7;      // what rounding makes of a double root
constexpr double shortestPiece = 1e-13;  // of a period

/// Of a number of cells of contact.
struct Chain {
    std::int64_t contact = 0;
    Complex sum;   ///< of kappa e^{i omega m h} over the cells of 2L/c
    Complex last;  ///< kappa on the last cell of contact
    Complex next;  ///< kappa on the cell after it
};

/// All cells in the order of the law, m to m + w: what goes in comes out of a stretch of them, and
/// adds to the sum, as an affine function. A binary tree of stretches, so that one cell changes
/// its law in O(log nu).
class ChainTree {
public:
    ChainTree(std::int64_t cells)
    {
        while (size_ < static_cast<std::size_t>(cells)) {
            size_ *= 2;
        }
        nodes_.resize(2 * size_);
    }

    /// Of one cell: out = factor in + source, and weight in is added to the sum.
    void set(std::int64_t place, Complex factor, Complex source, Complex weight)
    {
        std::size_t i = size_ + static_cast<std::size_t>(place);
        nodes_[i] = {factor, source, weight, 0.0};
        for (i /= 2; i > 0; i /= 2) {
            const Node& x = nodes_[2 * i];
            const Node& y = nodes_[2 * i + 1];
            nodes_[i] = {y.factor * x.factor, y.factor * x.source + y.source,
                         x.weight + y.weight * x.factor, x.sum + y.weight * x.source + y.sum};
        }
    }

    /// What comes out after all where 0 goes in.
    [[nodiscard]] Complex source() const { return nodes_[1].source; }
    [[nodiscard]] Complex sum(Complex in) const { return nodes_[1].weight * in + nodes_[1].sum; }
    /// What goes into one cell.
    [[nodiscard]] Complex at(std::int64_t place, Complex in) const
    {
        std::size_t i = 1;
        for (std::size_t half = size_ / 2; half > 0; half /= 2) {
            i *= 2;
            if ((static_cast<std::size_t>(place) & half) != 0) {
                in = nodes_[i].factor * in + nodes_[i].source;
                ++i;
            }
        }
        return in;
    }

private:
    struct Node {
        Complex factor = 1.0;
        Complex source;
        Complex weight;
        Complex sum;
    };
    std::size_t size_ = 1;  ///< a power of two; cells beyond do nothing
    std::vector<Node> nodes_;
};

/// Every cell of tau, one after the other.
class ContactSearch {
public:
    explicit ContactSearch(const HarmonicCase& given)
        : given_(given),
          back_(given.inCells(-given.back)),
          places_(static_cast<std::size_t>(given.cells)),
          tree_(given.cells)
    {
        std::int64_t m = 0;
        for (std::int64_t k = 0; k < given.cells; ++k) {
            turns_.push_back(given.inCells(k));
            places_[static_cast<std::size_t>(m)] = k;
            m = (m + given.back) % given.cells;
        }
        for (std::int64_t k = 0; k < given.cells; ++k) {
            setLaw(k, false);
        }
    }

    std::vector<HarmonicMotion> run()
    {
        Chain before = chainOf(0);
        for (std::int64_t j = 1; j < given_.cells; ++j) {
            setLaw(j - 1, true);
            const Chain after = chainOf(j);
            for (const Stop stop : {Stop::right, Stop::left}) {
                if (stop == Stop::right || given_.stops.left) {
                    addSmooth(j - 1, after, before, stop);
                    addPinned(j, after, stop);
                }
            }
            before = after;
        }
        std::sort(found_.begin(), found_.end(),
                  [](const HarmonicMotion& x, const HarmonicMotion& y) {
                      return x.extremes.impulse < y.extremes.impulse;
                  });
        return std::move(found_);
    }

private:
    void setLaw(std::int64_t m, bool isContact)
    {
        const std::int64_t times =
            given_.back / given_.cells + (m < given_.back % given_.cells ? 1 : 0);
        const Complex factor = isContact ? back_ : -given_.rho * back_;
        tree_.set(placeOf(m), factor, back_ * given_.after(0.0, isContact),
                  static_cast<double>(times) * inCells(m));
    }

    [[nodiscard]] std::int64_t placeOf(std::int64_t m) const
    {
        return places_[static_cast<std::size_t>(m % given_.cells)];
    }

    /// kappa on cell 0. \pre contact < nu.
    [[nodiscard]] Complex first(std::int64_t contact, Complex source) const
    {
        const auto flights = static_cast<double>(given_.cells - contact);
        const double decay = flights * portable::log(given_.rho);
        const bool isEven = (given_.cells - contact) % 2 == 0;
        return source / (isEven ? -portable::expm1(decay) : 1.0 + portable::exp(decay));
    }

    /// O(log nu). \pre the laws are those of so many cells of contact.
    [[nodiscard]] Chain chainOf(std::int64_t contact) const
    {
        const Complex wave = first(contact, tree_.source());
        return {contact, tree_.sum(wave), tree_.at(placeOf(contact + given_.cells - 1), wave),
                tree_.at(placeOf(contact), wave)};
    }

    /// All of it, twice around. O(nu).
    [[nodiscard]] std::vector<Complex> wavesOf(std::int64_t contact) const
    {
        std::vector<Complex> waves(static_cast<std::size_t>(given_.cells));
        const auto goRound = [&](Complex wave) {
            std::int64_t m = 0;
            for (std::int64_t k = 0; k < given_.cells; ++k) {
                waves[static_cast<std::size_t>(m)] = wave;
                wave = back_ * given_.after(wave, m < contact);
                m = (m + given_.back) % given_.cells;
            }
            return wave;
        };
        goRound(first(contact, goRound(0.0)));
        return waves;
    }

    [[nodiscard]] Complex inCells(std::int64_t m) const
    {
        return turns_[static_cast<std::size_t>(m % given_.cells)];
    }

    /// R(tau) = 0 in cell j.
    void addSmooth(std::int64_t j, const Chain& early, const Chain& late, Stop stop)
    {
        const Complex integrate = Complex(0.0, -1.0) / given_.omega;  // 1/(i omega)
        const Complex jump = late.sum - early.sum;
        const ReleaseCell cell{given_.place() - (inCells(1) * late.sum - early.sum) * integrate,
                               jump * integrate, given_.push(early.last) * inCells(j),
                               given_.placeOf(stop) / given_.amplitude, given_.omega * given_.step};
        forEachSmoothRelease(
            cell, [&](double part, Complex unit) { add(j, part, unit, early, late, stop); });
    }

    /// tau = jh, R passes through 0 there.
    void addPinned(std::int64_t j, const Chain& chain, Stop stop)
    {
        const Complex gap =
            given_.place() + Complex(0.0, 1.0) / given_.omega * chain.sum * (inCells(1) - 1.0);
        forEachPinnedRelease(gap, given_.placeOf(stop) / given_.amplitude, [&](Complex unit) {
            const Complex now = unit * inCells(j);
            const double sign = stop == Stop::right ? 1.0 : -1.0;
            const double before = sign * (given_.push(chain.last) * now).real();
            const double after = sign * (given_.push(chain.next) * now).real();
            const double near =
                harmonicTolerance * (1.0 + lengthOf(chain.last) + lengthOf(chain.next));
            if (before >= -near && after <= near) {
                add(j, 0.0, unit, chain, chain, stop);
            }
        });
    }

    /// With contact to (j + part) h and the excitation |A| unit, if it is a motion.
    void add(std::int64_t j, double part, Complex unit, const Chain& early, const Chain& late,
             Stop stop)
    {
        HarmonicMotion motion;
        const double release = (static_cast<double>(j) + part) * given_.step;
        if (release <= shortestPiece * given_.period()) {
            return;
        }
        motion.phase = -angleOf(unit);
        motion.contacts.push_back({.end = release,
                                   .stop = stop,
                                   .isPinned = part == 0.0,
                                   .travel = part == 0.0 ? release : 0.0});
        const Complex excitation = given_.amplitude * unit;
        const std::vector<Complex> before = wavesOf(early.contact);
        const std::vector<Complex> after = wavesOf(late.contact);
        double begin = 0.0;
        const auto append = [&](double end, Complex wave) {
            if (end - begin > shortestPiece * given_.period()) {
                motion.pieces.push_back({end, wave * excitation});
                begin = end;
            }
        };
        for (std::int64_t m = 0; m < given_.cells; ++m) {
            const auto i = static_cast<std::size_t>(m);
            append((static_cast<double>(m) + part) * given_.step, before[i]);
            append(static_cast<double>(m + 1) * given_.step, after[i]);
        }
        measure(given_, motion);
        const bool isKnown = std::any_of(found_.begin(), found_.end(), [&](const auto& other) {
            return std::abs(other.contacts[0].end - release) <= sameMotion &&
                   other.contacts[0].stop == stop &&
                   std::abs(std::remainder(other.phase - motion.phase, 2.0 * pi)) <= sameMotion;
        });
        if (motion.residual <= harmonicTolerance && !isKnown) {
            found_.push_back(std::move(motion));
        }
    }

    const HarmonicCase& given_;
    Complex back_;  ///< e^{-2 i omega}
    std::vector<Complex> turns_;
    std::vector<std::int64_t> places_;  ///< of each cell in the order of the law
    ChainTree tree_;
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
