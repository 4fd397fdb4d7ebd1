#include "signorini/simulation.hpp"

#include <algorithm>
#include <cmath>

#include "compensated_sum.hpp"
#include "faults.hpp"
#include "infinity.hpp"
#include "largest.hpp"
#include "segment_lines.hpp"

namespace signorini {

namespace {

constexpr double sameInstant = 1e-12;  // [L/c]
constexpr double atWall = 1e-9;        // of what waves and stops reach: a start there is at a stop
constexpr double largest = 1e100;      // of any size, so that its square is a number

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

/// The largest wave at the start, or that the excitation sends [g/L].
double largestWave(const Waves& start, const Excitation& excitation)
{
    double most =
        std::max(largestSizeOf(start.a, &Piece::value), largestSizeOf(start.b, &Piece::value));
    for (std::int64_t m = 0; m < excitation.steps(); ++m) {
        most =
            std::max({most, std::abs(excitation.force(m)), std::abs(excitation.baseVelocity(m))});
    }
    return most;
}

/// What pieces may differ by and still become one [g/L].
double mergedBelow(const Waves& start, const Damping& damping, const Excitation& excitation,
                   const SimulationOptions& options)
{
    requireWaves(start);
    signorini::validate(excitation);
    const bool isExact = damping.ratio == 0.0 && options.segments.empty();
    const double below = options.mergeBelow.value_or(isExact ? 0.0 : 1e-11);
    const double size = largestWave(start, excitation);
    Faults faults;
    if (!(below >= 0.0 && std::isfinite(below))) {
        faults.add("mergeBelow", below, "finite and >= 0 [-]");
    }
    if (!(options.resolution >= 0.0 && std::isfinite(options.resolution))) {
        faults.add("resolution", options.resolution, "finite and >= 0 [L/c]");
    }
    if (size > largest || (size > 0.0 && size < 1.0 / largest)) {
        faults.add(
            "largest wave of start and excitation", size,
            fmt::format("0 or {}..{}, so that its energy is a number", 1.0 / largest, largest));
    }
    faults.throwIfAny();
    return below * size;
}

/// How far the base is from 0, at the start or at any time [g].
double reachOfBase(const Waves& start, const Excitation& excitation)
{
    double reach = std::abs(start.base.value_or(0.0));
    for (std::int64_t m = 0; m < excitation.steps(); ++m) {
        reach = std::max(reach, std::abs(excitation.baseDisplacement(m)));
    }
    return reach;
}

/// How far start and stops reach [g].
double reachOf(const Waves& start, const Excitation& excitation, const Stops& stops)
{
    double reach = reachOfBase(start, excitation);
    for (const auto* wave : {&start.a, &start.b}) {
        for (const Piece& piece : *wave) {
            reach += piece.duration / start.crossing * std::abs(piece.value);
        }
    }
    const double left = stops.left ? std::abs(stops.left->value()) : 0.0;
    return std::max({reach, left, std::abs(static_cast<double>(stops.right))});
}

/// From where the excitation has the base to where it is [g]; 0 where that is rounding.
double leadOf(const Waves& start, const Excitation& excitation)
{
    constexpr double rounding = 1e-9;
    const double there = excitation.baseDisplacement(0);
    const double here = start.base.value_or(there);
    const double reach = reachOfBase(start, excitation);
    return std::abs(here - there) <= rounding * reach ? 0.0 : here - there;
}

}  // namespace

void BarSimulation::Clock::pass(double duration, double same)
{
    left -= duration;
    if (left <= same) {
        value = values[next];
        next = next + 1 == values.size() ? first : next + 1;
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
      way_(infinity),
      excitation_(std::move(excitation)),
      echo_(mergedBelow(start, damping, excitation_, options)),
      parts_(options.segments),
      resolution_(options.resolution)
{
    signorini::validate(damping);
    if (!parts_.empty()) {
        const SteppedBar bar = steppedBar(parts_);
        segments_.emplace_back(bar, start, mergedBelow(start, damping, excitation_, options));
        impedance_ = bar.segments.back().impedance;
        rho_ = (impedance_ - eta_) / (impedance_ + eta_);
        admittance_ = 1.0 / (impedance_ + eta_);
    }
    lead_ = leadOf(start, excitation_);
    setClocks();
    place(start);
    const double room = opening_.total() / crossing_;
    const double roomBehind = way_ / crossing_ - room;
    const double same = atWall * reachOf(start, excitation_, stops_);
    if (room < -same || roomBehind < -same) {
        throwFault("start: u(L)/g", stops_.right - room,
                   room < 0.0 ? fmt::format("at most {}, the wall", stops_.right)
                              : fmt::format("at least {}, the second stop",
                                            stops_.right - way_ / crossing_));
    }
    if (room <= same) {
        hold(Stop::right, 0.0);
    } else if (roomBehind <= same) {
        hold(Stop::left, 0.0);
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
    force_.left = infinity;
    base_.left = infinity;
    const std::int64_t steps = excitation_.steps();
    if (steps == 0) {
        return;
    }
    const bool isForce = excitation_.place == Excited::tip;
    Clock& clock = isForce ? force_ : base_;
    clock.step = crossing_ / excitation_.stepsPerCrossing;
    const double slope = lead_ * excitation_.stepsPerCrossing / static_cast<double>(steps);
    for (std::int64_t m = 0; m < steps && !isForce && lead_ != 0.0; ++m) {
        clock.values.push_back(excitation_.baseVelocity(m) - slope);
    }
    clock.first = clock.values.size();
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
    opening_.add(crossing_ * (stops_.right - base()));
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

BarSimulation BarSimulation::fork(bool recordsTip) const
{
    BarSimulation other(*this);
    other.contacts_.clear();
    other.path_.clear();
    other.contact_ = {};
    other.impulse_ = 0.0;
    other.events_ = 0;
    other.lead_ = 0.0;
    other.time_ = {};
    other.start_ = other.storedSquares();
    other.work_ = {};
    other.dissipated_ = {};
    other.recordsTip_ = recordsTip;
    other.recordTip();
    return other;
}

/// The stop is pressed with a force, by a wave p, for a time in units.
void BarSimulation::press(double push, double p, double lasts)
{
    const double now = time();
    lasts /= crossing_;
    if (contact_.impulse == 0.0) {
        const bool goesOn = !contacts_.empty() && contacts_.back().stop == stop_ &&
                            now - contacts_.back().end <= resolution_;
        if (goesOn && resolution_ > 0.0) {
            contact_ = contacts_.back();
            contacts_.pop_back();
        } else {
            contact_ = {.start = now, .speed = speed_, .stop = stop_};
            stretchEnd_ = now + resolution_;
            stretchImpulse_ = 0.0;
        }
    }
    const double impulse = push * lasts;
    contact_.impulse += impulse;
    contact_.energy += 2.0 * impedance_ * p * p * lasts;
    contact_.peakForce = std::max(contact_.peakForce, push);
    impulse_ += impulse;
    if (resolution_ == 0.0) {
        contact_.meanForce = contact_.peakForce;
        return;
    }
    // No mean is beyond the peak; where the resolution is near the rounding of times, quotients
    // are.
    const auto see = [&](double mean) {
        contact_.meanForce = std::max(contact_.meanForce, std::min(mean, contact_.peakForce));
    };
    if (now >= stretchEnd_) {  // since then nothing pressed
        stretchEnd_ += resolution_ * (1.0 + std::floor((now - stretchEnd_) / resolution_));
        stretchImpulse_ = 0.0;
    }
    const double end = now + lasts;
    stretchImpulse_ += push * (std::min(end, stretchEnd_) - now);
    see(stretchImpulse_ / resolution_);
    if (end > stretchEnd_) {
        const double whole = std::floor((end - stretchEnd_) / resolution_);
        stretchEnd_ += resolution_ * (1.0 + whole);
        stretchImpulse_ = push * (end - (stretchEnd_ - resolution_));
        see(whole > 0.0 ? push : stretchImpulse_ / resolution_);
    }
}

void BarSimulation::closeContact()
{
    if (contact_.impulse > 0.0) {
        contact_.end = time();
        contacts_.push_back(contact_);
    }
    contact_ = {};
}

void BarSimulation::hold(Stop stop, double speed)
{
    isHeld_ = true;
    speed_ = speed;
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
    if (v > 0.0 || (v < 0.0 && way_ < infinity)) {
        const double room = v > 0.0 ? opening_.total() : way_ - opening_.total();
        const double hit = room / std::abs(v);
        arrives = hit <= lasts + same_;
        lasts = hit < lasts - same_ ? std::max(hit, 0.0) : lasts;
        if (hit <= same_) {
            hold(ahead, std::abs(v));
            return;
        }
    }
    ++events_;
    if (isHeld_ && push > 0.0) {
        press(push, p, lasts);
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
    force_.left < infinity ? force_.pass(lasts, same_) : void();
    base_.left < infinity ? base_.pass(lasts, same_) : void();
    time_.add(lasts);
    if (arrives) {
        hold(ahead, std::abs(v));
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
        throwFault("duration", duration, "finite and >= 0");
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
    const double passed = excitation_.place == Excited::base && excitation_.steps() > 0
                              ? std::min(steps / static_cast<double>(excitation_.steps()), 1.0)
                              : 0.0;
    return lead_ * (1.0 - passed) + std::lerp(excitation_.baseDisplacement(m),
                                              excitation_.baseDisplacement(m + 1), steps - whole);
}

}  // namespace signorini
