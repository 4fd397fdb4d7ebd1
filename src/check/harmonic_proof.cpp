#include "harmonic_proof.hpp"

#include <algorithm>
#include <array>
#include <numbers>
#include <numeric>

#include "dense.hpp"
#include "harmonic_discs.hpp"

namespace signorini {

namespace {

constexpr std::array boxRadii{1e-9, 1e-8, 1e-7};  // L/c, and rad of the phase
constexpr double wholeWithin = 1e-6;              // cells: a travel is whole cells

/// Of a beginning or release: a place within a cell, and the cell.
struct Mark {
    std::size_t place;
    std::int64_t cell;
};

struct Held {
    Mark begin;
    Mark end;
    const HarmonicContact& contact;
};

class Enclosure {
public:
    Enclosure(const HarmonicCase& given, const HarmonicMotion& motion)
        : given_(given), discs_(given), phase_(motion.phase)
    {
        for (const HarmonicContact& one : motion.contacts) {
            const Mark begin = marked(one.begin);
            contacts_.push_back({begin, begin, one});
        }
        for (Held& one : contacts_) {
            if (!one.contact.isPinned) {
                one.end = marked(one.contact.end);
                continue;
            }
            const Mark from = contacts_[one.contact.front].begin;
            const double cells = one.contact.travel / given.step;
            one.end = {from.place, from.cell + std::llround(cells)};
            areWhole_ = areWhole_ && std::abs(cells - std::round(cells)) < wholeWithin;
        }
        places_[0] = 0.0;
    }

    HarmonicProof run()
    {
        if (!areWhole_) {
            return {.why = "a front does not come to the release that it ends"};
        }
        if (!sortPlaces(boxRadii[0]) || !setHeld() || !setWaves()) {
            return {.why = why_};
        }
        HarmonicProof proof;
        for (const double radius : boxRadii) {
            const auto root = sortPlaces(radius) ? krawczyk(radius) : std::nullopt;
            if (root) {
                proof.aloneWithin = radius;
                proof.within = proof.isProved ? std::min(proof.within, *root) : *root;
                proof.isProved = true;
            } else if (proof.isProved) {
                break;
            }
        }
        if (proof.isProved && sortPlaces(proof.within)) {
            setBox(proof.within);
            return areSigns() ? proof : HarmonicProof{.why = why_};
        }
        return {.why = "the equations are not seen to have one root in the box"};
    }

private:
    Mark marked(double time)
    {
        const double cells = time / given_.step;
        const double cell = std::floor(cells);
        places_.push_back(cells - cell);
        return {places_.size() - 1, static_cast<std::int64_t>(cell)};
    }

    /// Places of a box; order does not change in it.
    bool sortPlaces(double radius)
    {
        order_.resize(places_.size());
        std::iota(order_.begin(), order_.end(), 0U);
        std::sort(order_.begin(), order_.end(),
                  [this](std::size_t x, std::size_t y) { return places_[x] < places_[y]; });
        rank_.resize(order_.size());
        const double apart = 4.0 * radius / given_.step;
        for (std::size_t p = 0; p < order_.size(); ++p) {
            rank_[order_[p]] = p;
            const double next = p + 1 < order_.size() ? places_[order_[p + 1]] : 1.0;
            if (!(next - places_[order_[p]] > apart)) {
                why_ = "fronts of two events meet at one instant";
                return false;
            }
        }
        return order_[0] == 0;
    }

    [[nodiscard]] std::size_t count() const { return places_.size(); }
    [[nodiscard]] std::size_t pieces() const
    {
        return count() * static_cast<std::size_t>(given_.cells);
    }
    [[nodiscard]] std::size_t indexOf(Mark at) const
    {
        return static_cast<std::size_t>(at.cell) * count() + rank_[at.place];
    }

    bool setHeld()
    {
        isHeld_.assign(pieces(), false);
        std::size_t last = 0;
        for (const Held& one : contacts_) {
            const std::size_t from = indexOf(one.begin);
            const std::size_t to = indexOf(one.end);
            if (from < last || to <= from || to > pieces() || one.begin.cell < 0) {
                why_ = "contacts are not in their order";
                return false;
            }
            std::fill(isHeld_.begin() + static_cast<std::ptrdiff_t>(from),
                      isHeld_.begin() + static_cast<std::ptrdiff_t>(to), true);
            last = to;
        }
        return contacts_[0].begin.cell == 0;
    }

    /// e^{2 pi i K (m + sigma)/nu}.
    [[nodiscard]] Disc turn(std::int64_t m, double sigma, double within) const
    {
        const auto cells = static_cast<double>(given_.cells);
        const auto cycles = static_cast<double>(given_.cycles);
        const auto part = static_cast<double>((m * given_.cycles) % given_.cells);
        const double angle = 2.0 * std::numbers::pi * ((part + cycles * sigma) / cells);
        return HarmonicDiscs::turn(angle, 7.0 * cycles / cells * within);
    }

    bool setWaves()
    {
        waves_.resize(pieces());
        for (std::size_t p = 0; p < count(); ++p) {
            const std::vector<Disc> chain = discs_.waves(
                [&](std::int64_t m) { return isHeld_[static_cast<std::size_t>(m) * count() + p]; });
            if (!std::isfinite(chain[0].radius)) {
                why_ = "a wave that is always in contact is free";
                return false;
            }
            for (std::size_t m = 0; m < chain.size(); ++m) {
                waves_[m * count() + p] = chain[m];
            }
        }
        return true;
    }

    void setBox(double within)
    {
        excitation_ = Disc(given_.amplitude) * HarmonicDiscs::turn(-phase_, within);
        turns_.resize(pieces());
        for (std::size_t i = 0; i < pieces(); ++i) {
            const std::size_t place = order_[i % count()];
            turns_[i] = turn(static_cast<std::int64_t>(i / count()), places_[place],
                             place == 0 ? 0.0 : within / given_.step);
        }
    }

    [[nodiscard]] const Disc& wave(std::size_t i) const { return waves_[i % pieces()]; }
    [[nodiscard]] const Disc& before(std::size_t i) const
    {
        return waves_[(i + pieces() - 1) % pieces()];
    }
    [[nodiscard]] const Disc& turnAt(std::size_t i) const { return turns_[i % pieces()]; }
    /// y(t + 1) of A = 1.
    [[nodiscard]] Disc base(std::size_t i) const
    {
        return given_.isForce ? Disc(0.0) : discs_.place() * turnAt(i);
    }
    [[nodiscard]] Disc push(const Disc& wave, std::size_t at) const
    {
        return discs_.push(wave) * turnAt(at) * excitation_;
    }

    /// f of the box, and its derivatives: by the phase first.
    void equations(std::vector<Interval>& f, std::vector<Interval>& slopes) const
    {
        const std::size_t n = count();
        f.clear();
        slopes.assign(n * n, Interval(0.0));
        const Disc turned{0.0 - std::complex<double>(0.0, 1.0)};
        for (const Held& one : contacts_) {
            const std::size_t from = indexOf(one.begin);
            const std::size_t to = from + static_cast<std::size_t>(given_.back) * n;
            Disc gap = base(from);
            std::vector<Disc> moves(n, Disc(0.0));
            for (std::size_t i = from; i < to; ++i) {
                gap = gap - wave(i) * (turnAt(i + 1) - turnAt(i)) * discs_.integrate();
                if (i > from) {
                    const std::size_t place = order_[i % n];
                    moves[place] = moves[place] + (wave(i) - before(i)) * turnAt(i);
                }
            }
            Disc& own = moves[one.begin.place];
            own = own + discs_.slope(base(from)) + wave(from) * turnAt(from) -
                  before(to) * turnAt(to);
            const std::size_t row = f.size();
            f.push_back((gap * excitation_).real() - Interval(given_.placeOf(one.contact.stop)));
            slopes[row * n] = (gap * excitation_ * turned).real();
            for (std::size_t place = 1; place < n; ++place) {
                slopes[row * n + place] = (moves[place] * excitation_).real();
            }
        }
        for (const Held& one : contacts_) {
            if (!one.contact.isPinned) {
                const std::size_t at = indexOf(one.end);
                const Disc force = push(before(at), at);
                const std::size_t row = f.size();
                f.push_back(force.real());
                slopes[row * n] = (force * turned).real();
                slopes[row * n + one.end.place] = discs_.slope(force).real();
            }
        }
    }

    /// \return the radius in which the one root of the box is.
    std::optional<double> krawczyk(double radius)
    {
        const std::size_t n = count();
        const auto size = static_cast<Eigen::Index>(n);
        std::vector<Interval> f;
        std::vector<Interval> slopes;
        setBox(0.0);
        equations(f, slopes);
        Eigen::MatrixXd middle(size, size);
        for (std::size_t i = 0; i < n * n; ++i) {
            middle(static_cast<Eigen::Index>(i / n), static_cast<Eigen::Index>(i % n)) =
                0.5 * (slopes[i].low + slopes[i].high);
        }
        const Eigen::MatrixXd inverse = FullFactors(middle).inverse();
        if (!inverse.allFinite()) {
            return std::nullopt;
        }
        std::vector<Interval> unused;
        setBox(radius);
        equations(unused, slopes);
        double root = 0.0;
        for (std::size_t row = 0; row < n; ++row) {
            Interval at = 0.0;
            Interval spread = 0.0;
            for (std::size_t column = 0; column < n; ++column) {
                Interval entry = row == column ? 1.0 : 0.0;
                for (std::size_t k = 0; k < n; ++k) {
                    entry = entry - Interval(inverse(static_cast<Eigen::Index>(row),
                                                     static_cast<Eigen::Index>(k))) *
                                        slopes[k * n + column];
                }
                at = at - Interval(inverse(static_cast<Eigen::Index>(row),
                                           static_cast<Eigen::Index>(column))) *
                              f[column];
                spread = spread + entry * Interval(-radius, radius);
            }
            const Interval all = at + spread;
            if (!(all.low > -radius && all.high < radius)) {
                return std::nullopt;
            }
            root = std::max({root, -all.low, all.high});
        }
        return root;
    }

    [[nodiscard]] bool fails(const char* why)
    {
        why_ = why;
        return false;
    }

    bool areSigns()
    {
        const double half = 0.5 * static_cast<double>(given_.cells) /
                            static_cast<double>(given_.cycles);  // a cycle, in cells
        for (std::size_t p = 0; p < count(); ++p) {
            const double next = p + 1 < count() ? places_[order_[p + 1]] : 1.0;
            if (!(next - places_[order_[p]] < 0.999 * half)) {
                return fails("a piece is longer than half a cycle");
            }
        }
        for (std::size_t k = 0; k < contacts_.size(); ++k) {
            const Held& next = contacts_[(k + 1) % contacts_.size()];
            const std::size_t arrival = k + 1 < contacts_.size() ? indexOf(next.begin) : pieces();
            if (!presses(contacts_[k]) ||
                !flies(contacts_[k], indexOf(contacts_[k].end), arrival, next)) {
                return false;
            }
        }
        return true;
    }

    /// A piece is shorter than half a cycle: a harmonic that is > 0 at both ends is so between.
    bool presses(const Held& one)
    {
        const double sign = one.contact.stop == Stop::right ? 1.0 : -1.0;
        const std::size_t last = indexOf(one.end);
        for (std::size_t i = indexOf(one.begin); i < last; ++i) {
            const bool isSmooth = i + 1 == last && !one.contact.isPinned;
            const Interval begin = Interval(sign) * push(wave(i), i).real();
            const Interval end = Interval(sign) * push(wave(i), i + 1).real();
            if (!begin.isPositive() || !(end.isPositive() || isSmooth)) {
                return fails("a push is not seen to be positive");
            }
        }
        const Interval after = Interval(sign) * push(wave(last), last).real();
        const Interval fading = Interval(sign) * discs_.slope(push(before(last), last)).real();
        if (one.contact.isPinned ? !after.isNegative() : !fading.isNegative()) {
            return fails("a release is not seen to be one");
        }
        return true;
    }

    /// The tip stays between the stops from one to the next.
    bool flies(const Held& one, std::size_t from, std::size_t to, const Held& next)
    {
        Interval tip = given_.placeOf(one.contact.stop);
        for (std::size_t i = from; i < to; ++i) {
            const Disc speed = Disc(given_.admittance()) * discs_.push(wave(i)) * excitation_;
            const Disc way = speed * discs_.integrate();
            const Interval after = tip + (way * (turnAt(i + 1) - turnAt(i))).real();
            for (const Stop stop : {Stop::right, Stop::left}) {
                if (stop == Stop::left && !given_.stops.left) {
                    continue;
                }
                const Interval sign = stop == Stop::right ? 1.0 : -1.0;
                const Interval place = given_.placeOf(stop);
                const bool leaves = i == from && one.contact.stop == stop;
                const bool arrives = i + 1 == to && next.contact.stop == stop;
                const bool isSmooth = leaves && !one.contact.isPinned;
                const bool goesAway = isSmooth || (sign * (speed * turnAt(i)).real()).isNegative();
                const bool comes = (sign * (speed * turnAt(i + 1)).real()).isPositive();
                // Between its ends the tip turns back once at most.
                const Interval top = tip - (way * turnAt(i)).real() + sign * way.magnitude();
                const bool isBetween = goesAway || comes || (sign * (top - place)).isNegative();
                if (!(leaves || (sign * (tip - place)).isNegative()) ||
                    !(arrives || (sign * (after - place)).isNegative()) || !isBetween ||
                    (arrives && !comes)) {
                    return fails("the tip is not seen to stay between the stops");
                }
            }
            tip = after;
        }
        return true;
    }

    const HarmonicCase& given_;
    HarmonicDiscs discs_;
    double phase_;
    std::vector<Held> contacts_;
    std::vector<double> places_;  ///< middles, in cells
    std::vector<std::size_t> order_;
    std::vector<std::size_t> rank_;
    bool areWhole_ = true;
    Disc excitation_;
    std::vector<bool> isHeld_;
    std::vector<Disc> waves_;  ///< kappa
    std::vector<Disc> turns_;  ///< e^{i omega t} where pieces begin
    std::string why_;
};

}  // namespace

HarmonicProof enclosed(const HarmonicCase& given, const HarmonicMotion& motion)
{
    return Enclosure(given, motion).run();
}

}  // namespace signorini
