#include "harmonic_march.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "portable.hpp"

namespace signorini {

namespace {

constexpr double besideStop = 1e-12;   // [g]
constexpr double sameInstant = 1e-11;  // L/c

}  // namespace

HarmonicMarch::HarmonicMarch(const HarmonicCase& given, double phase,
                             std::deque<ArrivingPiece> arriving, double tip,
                             std::optional<double> mergeBelow)
    : given_(given),
      phase_(phase),
      mergeBelow_(mergeBelow),
      force_{0.0, given.force() * given.amplitude * turned(-phase)},
      base_(given.fromBase() * given.amplitude * turned(-phase)),
      turn_(turned(-2.0 * given.omega)),
      pieces_(std::move(arriving)),
      tip_(tip)
{
    path_.push_back({0.0, tip, {}});
    for (const Stop stop : {Stop::right, Stop::left}) {
        if ((stop == Stop::right || given.stops.left) &&
            std::abs(tip - given.placeOf(stop)) <= besideStop) {
            touch(0.0, stop);
        }
    }
}

HarmonicMarch HarmonicMarch::atRest(const HarmonicCase& given, double mergeBelow)
{
    const double place = std::min(0.0, given.placeOf(Stop::right));
    const double phase = 0.5 * std::numbers::pi;
    // What the base sends arrives from 1 on.
    const std::complex<double> sent =
        given.fromBase() * given.amplitude * turned(-phase - 2.0 * given.omega);
    return {
        given, phase, {{1.0, {-0.5 * place, 0.0}}, {2.0, {-0.5 * place, sent}}}, place, mergeBelow};
}

HarmonicMarch HarmonicMarch::of(const HarmonicCase& given, const HarmonicMotion& motion,
                                double mergeBelow)
{
    std::deque<ArrivingPiece> arriving;
    for (double past = 0.0; past < 2.0; past += given.period()) {
        for (const HarmonicPiece& piece : motion.pieces) {
            if (arriving.empty() || arriving.back().end < 2.0) {
                arriving.push_back({std::min(2.0, past + piece.end), {0.0, piece.wave}});
            }
        }
    }
    arriving.back().end = 2.0;
    // u(L, 0) is what the waves say, at the stop but for rounding unless they are disturbed.
    double tip = (given.place() * given.amplitude * turned(-motion.phase)).real();
    double begin = 0.0;
    for (const ArrivingPiece& piece : arriving) {
        tip -= (piece.wave.swing * (given.at(piece.end) - given.at(begin))).imag() / given.omega;
        begin = piece.end;
    }
    return {given, motion.phase, std::move(arriving), tip, mergeBelow};
}

void HarmonicMarch::advance(double until)
{
    while (time_ < until) {
        const ArrivingPiece piece = pieces_.front();
        if (!(time_ < piece.end)) {
            pieces_.pop_front();
            front_ = pieces_.front().front;
            continue;
        }
        const HarmonicWave push{2.0 * piece.wave.steady, 2.0 * piece.wave.swing + force_.swing};
        const double end = std::min(until, piece.end);
        isHeld_ ? hold(push, piece, end) : fly(push, piece, end);
    }
}

double HarmonicMarch::value(const HarmonicWave& wave, double time) const
{
    return wave.steady + (wave.swing * given_.at(time)).real();
}

double HarmonicMarch::integral(const HarmonicWave& wave, double from, double to) const
{
    const std::complex<double> turn = given_.at(to) - given_.at(from);
    return wave.steady * (to - from) + (wave.swing * turn).imag() / given_.omega;
}

/// Where the wave changes its sign, ascending.
std::vector<double> HarmonicMarch::zeros(const HarmonicWave& wave, double from, double to) const
{
    std::vector<double> all;
    const double size = lengthOf(wave.swing);
    if (size <= std::abs(wave.steady)) {
        return all;
    }
    const double angle = portable::acos(-wave.steady / size);
    const double turn = 2.0 * std::numbers::pi / given_.omega;
    for (const double side : {-angle, angle}) {
        const double first = (side - angleOf(wave.swing)) / given_.omega;
        for (double t = first + turn * std::ceil((from - first) / turn); t < to; t += turn) {
            if (t > from) {
                all.push_back(t);
            }
        }
    }
    std::sort(all.begin(), all.end());
    return all;
}

double HarmonicMarch::place(const TipPath& path, double time) const
{
    return path.at + integral(path.velocity, path.begin, time);
}

/// The tip obeys one law until a time; what leaves it comes back 2 L/c later.
void HarmonicMarch::send(const HarmonicWave& arriving, double until)
{
    TipPath path{time_, tip_, {}};
    HarmonicWave back = arriving;
    if (!isHeld_) {
        const double y = given_.admittance();
        path.velocity = {2.0 * y * arriving.steady, y * (2.0 * arriving.swing + force_.swing)};
        back = {-given_.rho * arriving.steady, -given_.rho * arriving.swing - y * force_.swing};
    }
    if (mergeBelow_) {
        back.swing = (back.swing + base_) * turn_;
        comeBack(back, until + 2.0);
    }
    front_.reset();
    tip_ = place(path, until);
    path_.push_back(path);
    time_ = until;
}

void HarmonicMarch::comeBack(const HarmonicWave& wave, double until)
{
    ArrivingPiece& last = pieces_.back();
    const HarmonicWave jump = wave - last.wave;
    if (std::abs(jump.steady) + lengthOf(jump.swing) <= *mergeBelow_ * given_.amplitude) {
        last.end = until;
    } else if (pieces_.size() > 1 && last.end - pieces_[pieces_.size() - 2].end < sameInstant) {
        last = {until, wave, last.front ? last.front : front_};
    } else {
        pieces_.push_back({until, wave, front_});
    }
}

/// Held until the stop would have to pull.
void HarmonicMarch::hold(const HarmonicWave& push, const ArrivingPiece& piece, double until)
{
    HarmonicContact& contact = contacts_.back();
    const double sign = contact.stop == Stop::right ? 1.0 : -1.0;
    std::vector<double> turns = zeros(push, time_, until);
    turns.push_back(until);
    double end = time_;
    for (const double to : turns) {
        // The push has one sign from here to there.
        if (sign * value(push, 0.5 * (end + to)) < 0.0) {
            break;
        }
        end = to;
    }
    if (end == time_) {
        contact.end = time_;
        contact.isPinned = front_.has_value();
        contact.front = front_.value_or(0);
        isHeld_ = false;
        return;
    }
    const double passed = sign * integral(push, time_, end);
    contact.impulse += passed;
    contact.peakForce =
        std::max({contact.peakForce, sign * value(push, time_), sign * value(push, end)});
    tip_ = given_.placeOf(contact.stop);
    send(piece.wave, end);
}

void HarmonicMarch::touch(double time, Stop stop)
{
    contacts_.push_back({.begin = time, .stop = stop});
    tip_ = given_.placeOf(stop);
    isHeld_ = true;
    front_ = contacts_.size() - 1;
}

/// Free until the tip comes to a stop.
void HarmonicMarch::fly(const HarmonicWave& push, const ArrivingPiece& piece, double until)
{
    const double y = given_.admittance();
    const TipPath path{time_, tip_, {y * push.steady, y * push.swing}};
    std::vector<double> turns = zeros(push, time_, until);
    turns.push_back(until);
    double from = time_;
    for (const double to : turns) {
        // The tip goes one way from here to there.
        const double speed = value(push, 0.5 * (from + to));
        const Stop stop = speed > 0.0 ? Stop::right : Stop::left;
        if (speed != 0.0 && (stop == Stop::right || given_.stops.left)) {
            const double side = speed > 0.0 ? 1.0 : -1.0;
            const auto isBeyond = [&](double at) {
                return side * (place(path, at) - given_.placeOf(stop)) >= 0.0;
            };
            if (isBeyond(to)) {
                double low = from;
                double high = to;
                while (low < 0.5 * (low + high) && 0.5 * (low + high) < high) {
                    const double middle = 0.5 * (low + high);
                    (isBeyond(middle) ? high : low) = middle;
                }
                if (high > time_) {
                    send(piece.wave, high);
                }
                touch(high, stop);
                contacts_.back().speed = std::abs(value(path.velocity, high));
                return;
            }
        }
        from = to;
    }
    send(piece.wave, until);
}

double HarmonicMarch::tip(double time) const
{
    const auto after =
        std::upper_bound(path_.begin() + 1, path_.end(), time,
                         [](double t, const TipPath& path) { return t < path.begin; });
    return place(*(after - 1), time);
}

}  // namespace signorini
