#include "signorini/simulation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "compensated_sum.hpp"
#include "faults.hpp"
#include "segment_lines.hpp"

namespace signorini {

namespace {

constexpr double sameInstant = 1e-12;  // [L/c]
constexpr double atWall = 1e-9;        // [g], where a start counts as being there
constexpr double never = std::numeric_limits<double>::infinity();

void requirePieces(Faults& faults, const char* field, const std::vector<Piece>& pieces,
                   double crossing)
{
    double total = 0.0;
    for (const Piece& piece : pieces) {
        if (!(piece.duration > 0.0) || !std::isfinite(piece.duration) ||
            !std::isfinite(piece.value)) {
            faults.add(field, fmt::format("({}, {})", piece.duration, piece.value),
                       "pieces of duration > 0 with finite values");
            return;
        }
        total += piece.duration;
    }
    if (!(std::abs(total - crossing) <= 1e-9 * crossing)) {
        faults.add(field, total, fmt::format("durations that add up to {}", crossing));
    }
}

void requireWaves(const Waves& waves)
{
    Faults faults;
    faults.requirePositive("crossing", waves.crossing, "-");
    faults.throwIfAny();
    requirePieces(faults, "a", waves.a, waves.crossing);
    requirePieces(faults, "b", waves.b, waves.crossing);
    faults.throwIfAny();
}

/// What pieces may differ by and still become one.
double mergedBelow(const Damping& damping, const SimulationOptions& options)
{
    const bool isExact = damping.ratio == 0.0 && options.segments.empty();
    const double below = options.mergeBelow.value_or(isExact ? 0.0 : 1e-12);
    if (!(below >= 0.0 && std::isfinite(below))) {
        Faults faults;
        faults.add("mergeBelow", below, "finite and >= 0 [g/L]");
        faults.throwIfAny();
    }
    return below;
}

}  // namespace

void BarSimulation::Clock::pass(double duration, double same)
{
    left -= duration;
    if (left <= same) {
        value = values[next];
        next = next + 1 == values.size() ? 0 : next + 1;
        left += step;
    }
}

void BarSimulation::Sum::add(double term)
{
    addCompensated(value, lost, term);
}

BarSimulation::BarSimulation(const Waves& start, const Damping& damping, Excitation excitation,
                             const SimulationOptions& options)
    : crossing_(start.crossing),
      same_(sameInstant * start.crossing),
      rho_(damping.rho()),
      eta_(damping.eta()),
      admittance_(1.0 / (1.0 + damping.eta())),
      recordsTip_(options.recordsTip),
      stops_(options.stops),
      way_(never),
      excitation_(std::move(excitation)),
      echo_(mergedBelow(damping, options))
{
    requireWaves(start);
    signorini::validate(damping);
    signorini::validate(excitation_);
    if (!options.segments.empty()) {
        const SteppedBar bar = steppedBar(options.segments);
        segments_.emplace_back(bar, start, mergedBelow(damping, options));
        impedance_ = bar.segments.back().impedance;
        rho_ = (impedance_ - eta_) / (impedance_ + eta_);
        admittance_ = 1.0 / (impedance_ + eta_);
    }
    setClocks();
    place(start);
    const double room = opening_.total() / crossing_;
    const double roomBehind = way_ / crossing_ - room;
    if (room < -atWall || roomBehind < -atWall) {
        Faults faults;
        faults.add("start: u(L)/g", stops_.right - room,
                   room < 0.0 ? fmt::format("at most {}, the wall", stops_.right)
                              : fmt::format("at least {}, the second stop",
                                            stops_.right - way_ / crossing_));
        faults.throwIfAny();
    }
    if (room <= atWall) {
        hold(Stop::right);
    } else if (roomBehind <= atWall) {
        hold(Stop::left);
    }
    start_ = storedSquares();
    recordTip();
}

BarSimulation::BarSimulation(const BarSimulation&) = default;
BarSimulation::BarSimulation(BarSimulation&&) noexcept = default;
BarSimulation& BarSimulation::operator=(const BarSimulation&) = default;
BarSimulation& BarSimulation::operator=(BarSimulation&&) noexcept = default;
BarSimulation::~BarSimulation() = default;

/// Starts the excitation.
void BarSimulation::setClocks()
{
    force_.left = never;
    base_.left = never;
    const std::int64_t steps = excitation_.steps();
    if (steps == 0) {
        return;
    }
    const bool isForce = excitation_.place == Excited::tip;
    Clock& clock = isForce ? force_ : base_;
    clock.step = crossing_ / excitation_.stepsPerCrossing;
    for (std::int64_t m = 0; m < steps; ++m) {
        clock.values.push_back(isForce ? excitation_.force(m) : excitation_.baseVelocity(m));
    }
    // At the tip of a uniform bar what the base does is felt a crossing later.
    clock.left = isForce || !segments_.empty() ? 0.0 : crossing_;
    if (clock.left == 0.0) {
        clock.pass(0.0, 0.0);
    }
}

/// Places the tip, and what it sent before.
void BarSimulation::place(const Waves& start)
{
    if (stops_.left) {
        const Fraction& left = *stops_.left;
        way_ = crossing_ * (stops_.right + static_cast<double>(left.numerator) /
                                               static_cast<double>(left.denominator));
    }
    opening_.add(crossing_ * (stops_.right - excitation_.baseDisplacement(0)));
    for (const Piece& piece : start.a) {
        opening_.add(piece.duration * piece.value);
    }
    for (const Piece& piece : start.b) {
        opening_.add(-piece.duration * piece.value);
    }
    if (!segments_.empty()) {
        return;
    }
    // Of what is merged here nothing moves during the simulation.
    for (const Piece& piece : start.a) {
        echo_.append(piece.duration, -piece.value);
    }
    for (const Piece& piece : start.b) {
        echo_.append(piece.duration, piece.value);
    }
    mergedBefore_ = echo_.merged();
}

void BarSimulation::closeContact()
{
    if (contact_.impulse > 0.0) {
        contact_.end = time();
        contact_.stop = stop_;
        contacts_.push_back(contact_);
    }
    contact_ = {};
}

void BarSimulation::hold(Stop stop)
{
    isHeld_ = true;
    stop_ = stop;
    opening_ = {};
    opening_.add(stop == Stop::right ? 0.0 : way_);
}

void BarSimulation::recordTip()
{
    if (recordsTip_) {
        path_.push_back({time(), tip()});
    }
}

/// One event: until it the tip obeys one law.
void BarSimulation::step(double most)
{
    const bool isStepped = !segments_.empty();
    // What the base takes up, and what the tip does.
    const double atBase = isStepped ? segments_.front().atBase() : echo_.front().value;
    const double p = isStepped ? segments_.front().atTip() : base_.value - atBase;
    const double pull = force_.value + 2.0 * impedance_ * p;
    const double push = stop_ == Stop::right ? pull : -pull;  // of a tip that is held
    if (isHeld_ && push < 0.0) {
        closeContact();
        isHeld_ = false;
    }
    const double v = isHeld_ ? 0.0 : admittance_ * pull;
    double lasts = std::min({most, force_.left, base_.left});
    const double sameFor = isStepped ? segments_.front().lasts() : echo_.front().duration;
    if (sameFor <= lasts + same_) {
        lasts = sameFor;
    }
    bool arrives = false;
    const Stop ahead = v > 0.0 ? Stop::right : Stop::left;
    if (v > 0.0 || (v < 0.0 && way_ < never)) {
        const double room = v > 0.0 ? opening_.total() : way_ - opening_.total();
        const double hit = room / std::abs(v);
        arrives = hit <= lasts + same_;
        lasts = hit < lasts - same_ ? std::max(hit, 0.0) : lasts;
        if (hit <= same_) {
            hold(ahead);
            return;
        }
    }
    ++events_;
    if (isHeld_ && push > 0.0) {
        if (contact_.impulse == 0.0) {
            contact_.start = time();
        }
        const double impulse = push * lasts / crossing_;
        contact_.impulse += impulse;
        contact_.peakForce = std::max(contact_.peakForce, push);
        impulse_ += impulse;
    } else if (!isHeld_) {
        opening_.add(-v * lasts);
        if (eta_ > 0.0) {
            dissipated_.add(eta_ * v * v * lasts);
        }
        if (force_.value != 0.0) {
            work_.add(force_.value * v * lasts);
        }
    }
    if (base_.value != 0.0) {
        work_.add(base_.value * (base_.value - 2.0 * atBase) * lasts);
    }
    send(isHeld_ ? -p : rho_ * p + admittance_ * force_.value, lasts);
    force_.left < never ? force_.pass(lasts, same_) : void();
    base_.left < never ? base_.pass(lasts, same_) : void();
    time_.add(lasts);
    if (arrives) {
        hold(ahead);
    }
    recordTip();
}

/// What the tip sends goes on its way, and all other waves with it.
void BarSimulation::send(double q, double lasts)
{
    if (segments_.empty()) {
        echo_.take(lasts, 0.0);
        echo_.append(lasts, q);
    } else {
        dissipated_.add(segments_.front().pass(lasts, q, base_.value, same_));
    }
}

void BarSimulation::advance(double duration)
{
    if (!(duration >= 0.0 && std::isfinite(duration))) {
        Faults faults;
        faults.add("duration", duration, "finite and >= 0");
        faults.throwIfAny();
    }
    owed_ += duration;
    while (owed_ > same_) {
        const double before = time_.value;
        const double lost = time_.lost;
        step(owed_);
        owed_ -= (time_.value - before) + (time_.lost - lost);
    }
}

double BarSimulation::time() const
{
    return time_.total() / crossing_;
}

double BarSimulation::tip() const
{
    return stops_.right - opening_.total() / crossing_;
}

double BarSimulation::base() const
{
    const double steps = time() * excitation_.stepsPerCrossing;
    const double whole = std::floor(steps);
    const auto m = static_cast<std::int64_t>(whole);
    return std::lerp(excitation_.baseDisplacement(m), excitation_.baseDisplacement(m + 1),
                     steps - whole);
}

Waves BarSimulation::waves() const
{
    return segments_.empty() ? wavesOfEcho() : segments_.front().waves();
}

Waves BarSimulation::wavesOfEcho() const
{
    Waves waves;
    waves.crossing = crossing_;
    const auto put = [](std::vector<Piece>& to, double duration, double value) {
        if (!to.empty() && to.back().value == value) {
            to.back().duration += duration;
        } else {
            to.push_back({duration, value});
        }
    };
    Clock clock = base_;
    double left = crossing_;
    for (std::size_t k = 0; k < echo_.size(); ++k) {
        Piece piece = echo_[k];
        while (left > same_ && piece.duration > 0.0) {
            double lasts = std::min(clock.left, left);
            lasts = piece.duration <= lasts + same_ ? piece.duration : lasts;
            put(waves.a, lasts, clock.value - piece.value);
            piece.duration -= lasts;
            left -= lasts;
            clock.left < never ? clock.pass(lasts, same_) : void();
        }
        if (piece.duration > 0.0) {
            put(waves.b, piece.duration, piece.value);
        }
    }
    return waves;
}

std::int64_t BarSimulation::pieces() const
{
    return static_cast<std::int64_t>(segments_.empty() ? echo_.size() : segments_.front().pieces());
}

double BarSimulation::energyRatio() const
{
    return segments_.empty() ? signorini::energyRatio(waves()) : 2.0 * storedSquares() / crossing_;
}

double BarSimulation::merged() const
{
    return (segments_.empty() ? echo_.merged() - mergedBefore_ : segments_.front().merged()) /
           crossing_;
}

double BarSimulation::storedSquares() const
{
    return segments_.empty() ? echo_.squares() : segments_.front().squares();
}

EnergyBalance BarSimulation::balance() const
{
    // What the base does is counted where it is felt, so the energy is that of what left the tip.
    const double unit = 2.0 / crossing_;
    const double squares = storedSquares();
    Sum error;
    for (const double term :
         {squares, -start_, -work_.value, -work_.lost, dissipated_.value, dissipated_.lost}) {
        error.add(term);
    }
    return {unit * work_.total(), unit * dissipated_.total(), unit * error.total(),
            unit * std::max({squares, start_, std::abs(work_.total()), dissipated_.total()})};
}

}  // namespace signorini
