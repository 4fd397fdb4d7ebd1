#pragma once
/// \file
/// Does a simulation repeat itself, and how nearly? docs/theory.md, section 16.
///
/// x_n is the state at the end of period n of the excitation, |x| the square root of its energy,
/// and of the static one taken off. After k periods it differs from itself by
///
///     change_k(n) = |x_n - x_{n-k}|/|x_n|.
///
/// Between two ends of the run it falls by a factor q in k periods. All changes to come add up to
/// no more than change_k/(1 - q): that is the residual, the distance to a motion that repeats
/// itself after k periods. Once changes are what rounding leaves they no longer fall: then the
/// residual is the largest distance to a state of long ago, extrapolated to a run ten times as
/// long, by its root where distances went with the root of time (contacts that drift by tau change
/// the state by the root of tau).

#include <cstdint>
#include <deque>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "signorini/simulation.hpp"

namespace signorini {

/// What a simulation has come to, where it repeats itself.
struct Settled {
    std::int64_t periods = 0;   ///< of the excitation, after which everything is as before
    double residual = 0.0;      ///< [-], bound of the distance to such a motion, in its own size
    std::int64_t contacts = 0;  ///< in that time
    double impulse = 0.0;       ///< in that time [EA g/c]
};

/// The verdict.
struct Settling {
    std::optional<Settled> settled;
    std::string why = {};  ///< where it has not: what it does instead, in words
};

/// Residual of a motion that has settled, at most. A contact that begins late by tau changes the
/// state by the square root of tau: this is 1e-6 L/c.
inline constexpr double settledBelow = 1e-3;

/// Most periods of the excitation after which a motion is asked whether it repeats itself.
inline constexpr std::int64_t mostPeriods = 16;

/// What is watched: a bar, or a network (network_watched.hpp).
class Watched {
public:
    Watched() = default;
    Watched(const Watched&) = delete;
    Watched& operator=(const Watched&) = delete;
    virtual ~Watched() = default;

    /// So many units of its time.
    virtual void advance(double duration) = 0;
    /// Contacts and impulse so far.
    [[nodiscard]] virtual std::int64_t contacts() const = 0;
    [[nodiscard]] virtual double impulse() const = 0;
    [[nodiscard]] virtual std::int64_t pieces() const = 0;
    /// All waves, one after the other.
    [[nodiscard]] virtual std::vector<Piece> state() const = 0;
    /// The same at rest.
    [[nodiscard]] virtual std::vector<Piece> rest() const = 0;
    /// By which their squares count, so that together they are an energy.
    [[nodiscard]] virtual std::vector<Piece> weights() const = 0;
    /// How near a contact without one comes to it in so many units, in roots of that energy.
    [[nodiscard]] virtual double clearance(double duration) const = 0;
};

/// Watches the ends of the periods of an excitation.
class SettlingWatch {
public:
    /// For a run of so many periods.
    explicit SettlingWatch(std::int64_t total, double tolerance = settledBelow)
        : total_(total), tolerance_(tolerance)
    {
    }

    /// To be called at the end of each period. O(1) but for about a hundred of them, of which the
    /// state is kept: O(pieces).
    void see(const Watched& simulation);
    void see(const BarSimulation& simulation);

    /// Has it settled after the periods that were seen? The simulation goes on for up to 16 periods
    /// of `period` units in a copy. O(pieces). \pre see was called with it last.
    [[nodiscard]] Settling settling(const Watched& simulation, double period);
    [[nodiscard]] Settling settling(const BarSimulation& simulation, double period);

private:
    struct Counted {
        std::int64_t contacts = 0;
        double impulse = 0.0;
    };
    struct Kept {
        std::int64_t period = 0;
        std::vector<Piece> state;
    };
    struct Comparison;

    [[nodiscard]] bool isKept(std::int64_t period) const;
    [[nodiscard]] const std::vector<Piece>* stateBefore(std::int64_t periods) const;
    [[nodiscard]] double apart(std::int64_t late, std::int64_t early) const;
    [[nodiscard]] double wandering(std::int64_t length, std::int64_t lag) const;
    [[nodiscard]] Comparison compared(std::int64_t length) const;
    [[nodiscard]] Settled counted(const Comparison& repeats) const;
    [[nodiscard]] std::string whyNot(const std::vector<Comparison>& all) const;

    std::int64_t total_;
    double tolerance_;
    std::int64_t longest_ = mostPeriods;  ///< fewer where states have very many pieces
    std::vector<Piece> weights_;
    double size_ = 1.0;  ///< |x_n| of the last period
    std::int64_t seen_ = 0;
    std::deque<Counted> counted_;  ///< at the ends of the last periods
    std::vector<Kept> kept_;       ///< in the order of time
};

/// What came of following a simulation.
struct Followed {
    Settling settling;
    bool isComplete = true;  ///< false: it was cancelled, and ends with the stretch under way
};

/// One period of the excitation in units of the simulation's start; 16 crossings without any.
[[nodiscard]] double stretchOf(const Excitation& excitation, double crossing);

/// Goes on for `total` stretches of time (a part of one at the end is not watched) and says what
/// the simulation has settled on. `show(done, total)` is called after each.
[[nodiscard]] Followed follow(Watched& simulation, double stretch, double total,
                              const Cancel& cancel = {},
                              const std::function<void(double, double)>& show = {});
[[nodiscard]] Followed follow(BarSimulation& simulation, double stretch, double total,
                              const Cancel& cancel = {},
                              const std::function<void(double, double)>& show = {});

}  // namespace signorini
