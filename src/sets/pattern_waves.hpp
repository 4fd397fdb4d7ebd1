#pragma once
/// \file
/// The waves of one pattern of contacts, and what they say: see harmonic_pattern.hpp.

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "harmonic_pattern.hpp"
#include "portable.hpp"

namespace signorini {

/// A beginning or a release: its class, and the cell in which it is.
struct PatternInstant {
    std::size_t place;
    std::int64_t cell;
};

struct PatternContact {
    PatternInstant begin;
    PatternInstant end;
    Stop stop;
    bool isPinned;
};

class HarmonicPattern {
public:
    using Complex = HarmonicCase::Complex;

    HarmonicPattern(const HarmonicCase& given, const HarmonicStart& start) : given_(given)
    {
        for (const HarmonicContact& one : start.contacts) {
            const PatternInstant begin = newPlace(one.begin);
            contacts_.push_back({begin, begin, one.stop, one.isPinned});
        }
        for (std::size_t k = 0; k < contacts_.size(); ++k) {
            const HarmonicContact& one = start.contacts[k];
            if (one.isPinned) {
                // Places come to rest in their cells only with Newton: a travel is whole cells.
                const PatternInstant from = contacts_[one.front].begin;
                contacts_[k].end = {from.place, from.cell + std::llround(one.travel / given_.step)};
            } else {
                contacts_[k].end = newPlace(one.end);
            }
        }
        places_[0] = 0.0;
    }

    [[nodiscard]] std::size_t places() const { return places_.size(); }
    [[nodiscard]] double timeOf(PatternInstant at) const
    {
        return (places_[at.place] + static_cast<double>(at.cell)) * given_.step;
    }
    [[nodiscard]] const std::vector<PatternContact>& contacts() const { return contacts_; }

    /// kappa of all pieces. \return none if a chain never flies.
    [[nodiscard]] bool setWaves()
    {
        sortPlaces();
        const auto cells = static_cast<std::size_t>(given_.cells);
        waves_.assign(cells * places(), 0.0);
        isHeld_.assign(cells * places(), false);
        for (const PatternContact& one : contacts_) {
            const std::size_t last = indexOf(one.end);
            for (std::size_t i = indexOf(one.begin); i < last; ++i) {
                isHeld_[i % isHeld_.size()] = true;
            }
        }
        for (std::size_t p = 0; p < places(); ++p) {
            if (!setChain(p)) {
                return false;
            }
        }
        return true;
    }

    /// Residuals of all equations for an A, and their derivatives by Re A, Im A and the places but
    /// the first.
    void equations(Complex excitation, Eigen::VectorXd& residual, Eigen::MatrixXd& slope)
    {
        const std::size_t n = places() + 1;
        residual.setZero(static_cast<Eigen::Index>(n));
        slope.setZero(static_cast<Eigen::Index>(n), static_cast<Eigen::Index>(n));
        sumUp();
        Eigen::Index row = 0;
        for (const PatternContact& one : contacts_) {
            const std::size_t from = indexOf(one.begin);
            const std::size_t period = waves_.size();
            const std::size_t to = from + static_cast<std::size_t>(given_.back) * places();
            const Complex here = turns_[from % period];
            const Complex gap = given_.place() * here - (sumTo(to) - sumTo(from));
            setRow(row, gap, slope);
            residual[row] = (gap * excitation).real() - given_.placeOf(one.stop);
            // The ends of the window move with its own place.
            const auto move = [&](std::size_t place, Complex by) {
                if (place > 0) {
                    slope(row, static_cast<Eigen::Index>(place) + 1) +=
                        given_.step * (by * excitation).real();
                }
            };
            const Complex there = turns_[to % period];
            move(one.begin.place, Complex(0.0, given_.omega) * given_.place() * here -
                                      before(to) * there + waves_[from % period] * here);
            for (std::size_t place = 1; place < places(); ++place) {
                Complex jumps = jumpsTo(place, to) - jumpsTo(place, from);
                if (place == one.begin.place) {
                    jumps -= jumpAt(from);
                }
                move(place, -jumps);
            }
            ++row;
        }
        for (const PatternContact& one : contacts_) {
            if (one.isPinned) {
                continue;
            }
            const std::size_t at = indexOf(one.end);
            const Complex push = given_.push(before(at)) * turns_[at % waves_.size()];
            setRow(row, push, slope);
            residual[row] = (push * excitation).real();
            slope(row, static_cast<Eigen::Index>(one.end.place) + 1) =
                given_.step * (Complex(0.0, given_.omega) * push * excitation).real();
            ++row;
        }
    }

    void move(const Eigen::VectorXd& step)
    {
        for (std::size_t place = 1; place < places(); ++place) {
            places_[place] += step[static_cast<Eigen::Index>(place) + 1];
            const double whole = std::floor(places_[place]);
            places_[place] -= whole;
            for (PatternContact& one : contacts_) {
                for (PatternInstant* at : {&one.begin, &one.end}) {
                    at->cell += at->place == place ? static_cast<std::int64_t>(whole) : 0;
                }
            }
        }
    }

    /// Are beginnings and releases in their order, within one period?
    [[nodiscard]] bool isOrdered() const
    {
        double last = 0.0;
        for (const PatternContact& one : contacts_) {
            if (timeOf(one.begin) < last || timeOf(one.end) <= timeOf(one.begin)) {
                return false;
            }
            last = timeOf(one.end);
        }
        return last <= given_.period();
    }

    /// The contacts that a tip has on which these waves arrive; its first begins at 0.
    [[nodiscard]] std::vector<HarmonicContact> contactsOf(Complex excitation) const;

    [[nodiscard]] HarmonicMotion motion(Complex excitation) const
    {
        HarmonicMotion motion;
        motion.phase = -angleOf(excitation);
        for (const PatternContact& one : contacts_) {
            HarmonicContact contact{timeOf(one.begin), timeOf(one.end), one.stop, one.isPinned};
            contact.front = frontOf(one.end.place);
            contact.travel =
                one.isPinned ? contact.end - timeOf(contacts_[contact.front].begin) : 0.0;
            motion.contacts.push_back(contact);
        }
        const double least = 1e-13 * given_.period();
        double begin = 0.0;
        for (std::size_t i = 0; i < waves_.size(); ++i) {
            const double end = i + 1 == waves_.size() ? given_.period() : timeAt(i + 1);
            if (end - begin > least) {
                motion.pieces.push_back({end, waves_[i] * excitation});
                begin = end;
            }
        }
        return motion;
    }

private:
    PatternInstant newPlace(double time)
    {
        const double cells = time / given_.step;
        const double cell = std::floor(cells);
        places_.push_back(cells - cell);
        return {places_.size() - 1, static_cast<std::int64_t>(cell)};
    }

    /// The contact whose beginning has this place.
    [[nodiscard]] std::size_t frontOf(std::size_t place) const
    {
        return place < contacts_.size() ? place : 0;
    }

    void sortPlaces()
    {
        order_.resize(places());
        std::iota(order_.begin(), order_.end(), 0U);
        std::sort(order_.begin() + 1, order_.end(),
                  [this](std::size_t x, std::size_t y) { return places_[x] < places_[y]; });
        rank_.resize(places());
        for (std::size_t p = 0; p < places(); ++p) {
            rank_[order_[p]] = p;
        }
    }

    /// Pieces are counted through all cells: the one that begins at an instant.
    [[nodiscard]] std::size_t indexOf(PatternInstant at) const
    {
        return static_cast<std::size_t>(at.cell) * places() + rank_[at.place];
    }
    [[nodiscard]] double timeAt(std::size_t i) const
    {
        const std::size_t cell = i / places();
        return (static_cast<double>(cell) + places_[order_[i % places()]]) * given_.step;
    }
    /// kappa at the end of the piece before.
    [[nodiscard]] Complex before(std::size_t i) const
    {
        return waves_[(i + waves_.size() - 1) % waves_.size()];
    }

    /// Piece p of every cell, from one to the one 2L/c later until all are through.
    [[nodiscard]] bool setChain(std::size_t p)
    {
        const Complex back = given_.inCells(-given_.back);
        const std::array source{back * given_.after(0.0, false), back * given_.after(0.0, true)};
        const std::array factor{-given_.rho * back, back};
        std::int64_t flights = 0;
        const auto goRound = [&](Complex wave) {
            std::int64_t m = 0;
            for (std::int64_t k = 0; k < given_.cells; ++k) {
                const std::size_t i = static_cast<std::size_t>(m) * places() + p;
                waves_[i] = wave;
                const bool isHeld = isHeld_[i];
                wave = factor[isHeld ? 1 : 0] * wave + source[isHeld ? 1 : 0];
                flights += isHeld ? 0 : 1;
                m += given_.back;
                m -= m >= given_.cells ? m / given_.cells * given_.cells : 0;
            }
            return wave;
        };
        const Complex wave = goRound(0.0);
        if (flights == 0) {
            return false;
        }
        const double decay = static_cast<double>(flights) * portable::log(given_.rho);
        goRound(wave / (flights % 2 == 0 ? -portable::expm1(decay) : 1.0 + portable::exp(decay)));
        return true;
    }

    /// Integrals of kappa e^{i omega t}, and of its jumps at each place, from 0 on.
    void sumUp()
    {
        const std::size_t n = waves_.size();
        turns_.resize(n);
        std::vector<Complex> shifts(places());
        for (std::size_t p = 0; p < places(); ++p) {
            shifts[p] = given_.at(places_[order_[p]] * given_.step);
        }
        for (std::size_t i = 0; i < n; ++i) {
            turns_[i] = turn(i / places()) * shifts[i % places()];
        }
        sums_.resize(n + 1);
        sums_[0] = 0.0;
        const Complex integrate = Complex(0.0, -1.0) / given_.omega;
        for (std::size_t i = 0; i < n; ++i) {
            sums_[i + 1] = sums_[i] + waves_[i] * (turns_[(i + 1) % n] - turns_[i]) * integrate;
        }
        jumps_.resize(n + places());
        for (std::size_t p = 0; p < places(); ++p) {
            jumps_[p] = 0.0;
        }
        for (std::size_t i = 0; i < n; ++i) {
            jumps_[i + places()] = jumps_[i] + jumpAt(i);
        }
    }

    [[nodiscard]] Complex turn(std::size_t cell)
    {
        if (cellTurns_.empty()) {
            for (std::int64_t m = 0; m < given_.cells; ++m) {
                cellTurns_.push_back(given_.inCells(m));
            }
        }
        return cellTurns_[cell];
    }

    [[nodiscard]] Complex sumTo(std::size_t i) const
    {
        const std::size_t n = waves_.size();
        const std::size_t rounds = i / n;
        return static_cast<double>(rounds) * sums_[n] + sums_[i % n];
    }
    /// r before less r after the beginning of piece i.
    [[nodiscard]] Complex jumpAt(std::size_t i) const
    {
        return (before(i) - waves_[i % waves_.size()]) * turns_[i % waves_.size()];
    }
    /// Of the pieces before i that begin at a place.
    [[nodiscard]] Complex jumpsTo(std::size_t place, std::size_t i) const
    {
        const std::size_t n = waves_.size();
        const std::size_t rank = rank_[place];
        const std::size_t left = i % n;
        const std::size_t cells = left / places() + (left % places() > rank ? 1 : 0);
        const std::size_t rounds = i / n;
        return static_cast<double>(rounds) * jumps_[n + rank] + jumps_[cells * places() + rank];
    }

    static void setRow(Eigen::Index row, Complex q, Eigen::MatrixXd& slope)
    {
        slope(row, 0) = q.real();
        slope(row, 1) = -q.imag();
    }

    const HarmonicCase& given_;
    std::vector<PatternContact> contacts_;
    std::vector<double> places_;      ///< in cells, [0, 1[; first those of the beginnings
    std::vector<std::size_t> order_;  ///< places, ascending
    std::vector<std::size_t> rank_;   ///< of a place in it
    std::vector<bool> isHeld_;
    std::vector<Complex> waves_;  ///< kappa, cell by cell
    std::vector<Complex> turns_;  ///< e^{i omega t} where pieces begin
    std::vector<Complex> sums_;
    std::vector<Complex> jumps_;
    std::vector<Complex> cellTurns_;
};

}  // namespace signorini
