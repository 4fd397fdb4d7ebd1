#include "signorini/settling.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "infinity.hpp"
#include "stepped_bar.hpp"

namespace signorini {

namespace {

constexpr std::int64_t mostPieces = 200'000;  // of 16 states in a row, so that memory suffices
constexpr std::int64_t shortestLag = 4;       // [periods], over which a rate is taken
constexpr double isRounding = 1e-6;           // of contact times, by its root: no growth

/// Parts of a run of `total` periods: before its end lie total/2, total/4, ...
std::vector<std::int64_t> lagsOf(std::int64_t total)
{
    std::vector<std::int64_t> lags;
    for (std::int64_t part = 2; part <= 64 && total / part >= shortestLag; part *= 2) {
        lags.push_back(total / part);
    }
    return lags;
}

/// Reads a wave piece by piece.
struct Reader {
    const std::vector<Piece>* pieces;
    std::size_t at = 0;
    double left = pieces->front().duration;

    [[nodiscard]] bool isAtEnd() const { return at == pieces->size(); }
    [[nodiscard]] double value() const { return (*pieces)[at].value; }
    void pass(double duration)
    {
        left -= duration;
        while (left <= 0.0 && ++at < pieces->size()) {
            left += (*pieces)[at].duration;
        }
    }
};

/// The integral of weight (one - other)^2.
double squaresBetween(const std::vector<Piece>& one, const std::vector<Piece>& other,
                      const std::vector<Piece>& weights)
{
    Reader first{&one};
    Reader second{&other};
    Reader weight{&weights};
    double sum = 0.0;
    while (!first.isAtEnd() && !second.isAtEnd() && !weight.isAtEnd()) {
        const double lasts = std::min({first.left, second.left, weight.left});
        const double apart = first.value() - second.value();
        sum += weight.value() * apart * apart * lasts;
        for (Reader* reader : {&first, &second, &weight}) {
            reader->pass(lasts);
        }
    }
    return sum;
}

/// The root of the energy of the difference of two states.
double distance(const std::vector<Piece>& one, const std::vector<Piece>& other,
                const std::vector<Piece>& weights)
{
    return std::sqrt(squaresBetween(one, other, weights));
}

/// A bar; its energy in E_1.
class WatchedBar : public Watched {
public:
    explicit WatchedBar(BarSimulation& simulation) : simulation_(simulation), seen_(simulation) {}
    explicit WatchedBar(const BarSimulation& simulation) : seen_(simulation) {}

    void advance(double duration) override { simulation_->get().advance(duration); }
    [[nodiscard]] std::int64_t contacts() const override
    {
        return static_cast<std::int64_t>(seen_.contacts().size());
    }
    [[nodiscard]] double impulse() const override { return seen_.impulse(); }
    [[nodiscard]] std::int64_t pieces() const override { return seen_.pieces(); }
    [[nodiscard]] std::vector<Piece> state() const override { return joined(seen_.waves()); }
    [[nodiscard]] std::vector<Piece> rest() const override
    {
        return joined(seen_.segments().empty() ? wavesAtRest(crossing(), seen_.stops())
                                               : wavesAtRest(seen_.segments(), seen_.stops()));
    }
    [[nodiscard]] std::vector<Piece> weights() const override
    {
        const double unit = 2.0 / crossing();
        std::vector<Piece> weights{{2.0 * crossing(), unit}};
        if (!seen_.segments().empty()) {
            weights.clear();
            for (const Segment& segment : steppedBar(seen_.segments()).segments) {
                weights.push_back({static_cast<double>(segment.cells), segment.impedance * unit});
            }
            std::vector<Piece> back = weights;
            std::reverse(weights.begin(), weights.end());
            weights.insert(weights.end(), back.begin(), back.end());
        }
        return weights;
    }
    /// |u(L)| <= g sqrt(E/E_1).
    [[nodiscard]] double clearance(double duration) const override
    {
        BarSimulation next = seen_.fork(true);
        next.advance(duration);
        const Stops& stops = seen_.stops();
        double room = infinity;
        for (const TipPoint& point : next.tipPath()) {
            room = std::min(room, stops.right - point.displacement);
            if (stops.left) {
                room = std::min(room, point.displacement + stops.left->value());
            }
        }
        return room;
    }

private:
    [[nodiscard]] double crossing() const { return seen_.waves().crossing; }
    static std::vector<Piece> joined(Waves waves)
    {
        waves.a.insert(waves.a.end(), waves.b.begin(), waves.b.end());
        return std::move(waves.a);
    }

    std::optional<std::reference_wrapper<BarSimulation>> simulation_;
    const BarSimulation& seen_;
};

}  // namespace

/// What a state differs by from those a multiple of `length` periods before, in its own size.
struct SettlingWatch::Comparison {
    std::int64_t length = 0;
    double change = infinity;    ///< in the last `length` periods
    double factor = 1.0;         ///< of the change in one period
    double residual = infinity;  ///< bound of all changes to come
};

bool SettlingWatch::isKept(std::int64_t period) const
{
    const std::int64_t before = total_ - period;
    const auto isIn = [&](std::int64_t lag) { return before >= lag && before <= lag + longest_; };
    const std::vector<std::int64_t> lags = lagsOf(total_);
    return isIn(0) || std::any_of(lags.begin(), lags.end(), isIn);
}

void SettlingWatch::see(const BarSimulation& simulation)
{
    see(WatchedBar(simulation));
}

void SettlingWatch::see(const Watched& simulation)
{
    ++seen_;
    counted_.push_back({simulation.contacts(), simulation.impulse()});
    constexpr std::size_t most = 3 * mostPeriods + 1;
    if (counted_.size() > most) {
        counted_.pop_front();
    }
    if (kept_.empty()) {
        weights_ = simulation.weights();
        longest_ = std::clamp<std::int64_t>(
            mostPeriods * mostPieces / std::max<std::int64_t>(simulation.pieces(), 1), 1,
            mostPeriods);
    }
    if (isKept(seen_)) {
        kept_.push_back({seen_, simulation.state()});
    }
}

const std::vector<Piece>* SettlingWatch::stateBefore(std::int64_t periods) const
{
    const std::int64_t period = seen_ - periods;
    const auto found = std::lower_bound(
        kept_.begin(), kept_.end(), period,
        [](const Kept& kept, std::int64_t wanted) { return kept.period < wanted; });
    return found != kept_.end() && found->period == period ? &found->state : nullptr;
}

/// The distance of two ends of periods, so many before the last, in the size of the last.
double SettlingWatch::apart(std::int64_t late, std::int64_t early) const
{
    const std::vector<Piece>* one = stateBefore(late);
    const std::vector<Piece>* other = stateBefore(early);
    return one == nullptr || other == nullptr ? infinity : distance(*one, *other, weights_) / size_;
}

/// How far the state gets in ten times as long a run, by what it differs from those up to `lag`
/// periods ago: contact times that drift by tau change it by the root of tau.
double SettlingWatch::wandering(std::int64_t length, std::int64_t lag) const
{
    if (lag < 4 * length) {
        return infinity;
    }
    const auto away = [&](std::int64_t far) {
        return apart(0, (far + length - 1) / length * length);
    };
    const double soon = away(lag / 4);
    const double late = away(lag);
    const double times = 10.0 * static_cast<double>(seen_) / static_cast<double>(lag);
    return std::max({soon, away(lag / 2), late, apart(0, length)}) *
           (late <= 3.0 * soon ? std::sqrt(times) : times);
}

SettlingWatch::Comparison SettlingWatch::compared(std::int64_t length) const
{
    Comparison result{.length = length};
    result.change = apart(0, length);
    if (result.change == 0.0) {
        result.residual = 0.0;  // all goes on as it did
        return result;
    }
    // Over an eighth, a quarter and a half of the run.
    for (std::int64_t part : {8, 4, 2}) {
        const std::int64_t lag = seen_ / part;
        const double before = apart(lag, lag + length);
        if (lag < std::max(shortestLag, length) || !(before < infinity)) {
            continue;
        }
        if (result.change > 10.0 * before && result.change > isRounding) {
            result.residual = infinity;  // it grows
            break;
        }
        const double rate = std::pow(result.change / before, 1.0 / static_cast<double>(lag));
        if (rate < 1.0) {
            result.residual =
                std::min(result.residual,
                         result.change / -std::expm1(static_cast<double>(length) * std::log(rate)));
            result.factor = rate;
        }
        result.residual = std::min(result.residual, wandering(length, lag));
    }
    return result;
}

Settled SettlingWatch::counted(const Comparison& repeats) const
{
    Settled result{repeats.length, repeats.residual, 0, 0.0};
    // A contact is counted when it ends, so single periods may be one off.
    const auto available = static_cast<std::int64_t>(counted_.size()) - 1;
    const std::int64_t times = std::clamp<std::int64_t>(
        available / repeats.length, 1, std::max<std::int64_t>(3, 16 / repeats.length));
    const Counted& end = counted_.back();
    const Counted& begin =
        counted_[counted_.size() - 1 - static_cast<std::size_t>(times * repeats.length)];
    result.contacts = (2 * (end.contacts - begin.contacts) + times) / (2 * times);
    result.impulse = (end.impulse - begin.impulse) / static_cast<double>(times);
    return result;
}

std::string SettlingWatch::whyNot(const std::vector<Comparison>& all) const
{
    const auto least = [&all](double Comparison::*what) {
        return *std::min_element(
            all.begin(), all.end(),
            [what](const auto& one, const auto& other) { return one.*what < other.*what; });
    };
    const auto every = [](std::int64_t length) {
        return length == 1 ? std::string("period") : fmt::format("{} periods", length);
    };
    const double nearest = least(&Comparison::residual).residual;
    if (nearest < 0.5) {
        const Comparison& one = *std::find_if(all.begin(), all.end(), [nearest](const auto& any) {
            return any.residual < 2.0 * nearest;
        });
        const double more = std::log(tolerance_ / one.residual) / std::log(one.factor);
        return fmt::format(
            "still on its way: the last {} changed the state by {:.2g} of itself, all changes to "
            "come add up to {:.2g}{}",
            every(one.length), one.change, one.residual,
            more >= 1.0 ? fmt::format("; about {:.0f} more periods at this rate", std::ceil(more))
                        : ", and a shorter period is not excluded");
    }
    const Comparison closest = least(&Comparison::change);
    if (closest.change < 0.1) {
        return fmt::format(
            "still on its way: the last {} changed the state by {:.2g} of itself, and changes do "
            "not fade",
            every(closest.length), closest.change);
    }
    return fmt::format(
        "does not repeat itself after 1..{} periods: the nearest, after {}, differs by {:.2g} of "
        "its size",
        all.back().length, closest.length, closest.change);
}

Settling SettlingWatch::settling(const BarSimulation& simulation, double period)
{
    return settling(WatchedBar(simulation), period);
}

Settling SettlingWatch::settling(const Watched& simulation, double period)
{
    const std::vector<Piece>* last = stateBefore(0);
    std::vector<Comparison> all;
    if (last != nullptr) {
        size_ = distance(*last, simulation.rest(), weights_);
        size_ = size_ > 0.0 ? size_ : 1.0;
        for (std::int64_t length = 1; length <= longest_ && stateBefore(length) != nullptr;
             ++length) {
            all.push_back(compared(length));
        }
    }
    if (all.empty()) {
        return {{}, fmt::format("followed for {} period{} only", seen_, seen_ == 1 ? "" : "s")};
    }
    const auto found = std::find_if(all.begin(), all.end(), [this](const Comparison& one) {
        return one.residual <= tolerance_;
    });
    if (found == all.end()) {
        return {{}, whyNot(all)};
    }
    // Where a short period is nearly reached, a longer one may be nearer, as deviations take turns;
    // or both are, but for rounding: the mean over all shifts by the short one is no further away.
    Comparison repeats = *std::find_if(all.begin(), all.end(), [&found](const Comparison& one) {
        return one.residual == found->residual || one.change <= 20.0 * found->residual;
    });
    if (repeats.length < found->length) {
        repeats.residual =
            static_cast<double>(found->length) * (repeats.change + 2.0 * found->residual);
    }
    if (repeats.residual > tolerance_) {
        return {{}, whyNot(all)};
    }
    const Settled settled = counted(repeats);
    if (settled.contacts == 0 && settled.residual > 0.0) {
        // |u(L)| <= g sqrt(E/E_1): the tip comes nearer by no more than the residual.
        const double room =
            simulation.clearance(period * static_cast<double>(settled.periods)) / size_;
        if (room <= settled.residual) {
            return {{},
                    fmt::format("no contact so far, but the tip stays clear of a stop by {:.2g} "
                                "of its swing only, and changes to come add up to {:.2g}",
                                room, settled.residual)};
        }
    }
    return {settled, ""};
}

double stretchOf(const Excitation& excitation, double crossing)
{
    return excitation.steps() > 0
               ? static_cast<double>(excitation.steps()) * crossing / excitation.stepsPerCrossing
               : 16.0 * crossing;
}

Followed follow(BarSimulation& simulation, double stretch, double total, const Cancel& cancel,
                const std::function<void(double, double)>& show)
{
    WatchedBar watched(simulation);
    return follow(watched, stretch, total, cancel, show);
}

Followed follow(Watched& simulation, double stretch, double total, const Cancel& cancel,
                const std::function<void(double, double)>& show)
{
    SettlingWatch watch(static_cast<std::int64_t>(total));
    double done = 0.0;
    for (; done + 1.0 <= total && !isRequested(cancel); done += 1.0) {
        simulation.advance(stretch);
        watch.see(simulation);
        if (show) {
            show(done + 1.0, total);
        }
    }
    if (done + 1.0 <= total) {
        return {{{}, "interrupted"}, false};
    }
    Followed followed{watch.settling(simulation, stretch)};
    if (total > done) {
        simulation.advance((total - done) * stretch);
    }
    return followed;
}

}  // namespace signorini
