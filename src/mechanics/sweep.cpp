#include "signorini/sweep.hpp"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <numbers>

#include "excited_amplitude.hpp"
#include "excited_names.hpp"
#include "faults.hpp"
#include "infinity.hpp"
#include "stepped_bar.hpp"
#include "sweep_point.hpp"

namespace signorini {

namespace {

/// The range at one value, and the unit of its lengths in gaps of the range.
struct At {
    SweepRange range;
    double gap = 1.0;
};

At at(SweepRange range, double value)
{
    switch (range.over) {
        case Swept::frequency:
            range.frequencyRatio = value;
            break;
        case Swept::amplitude:
            range.amplitude = value;
            range.derivative = 0;
            break;
        case Swept::damping:
            range.damping.ratio = value;
            break;
        case Swept::gap:
            range.amplitude /= value;
            if (range.stops.left) {
                range.stops.left = simplestFraction(range.stops.left->value() / value);
            }
            break;
    }
    range.amplitude = displacementOf(range.amplitude, range.derivative, range.frequencyRatio);
    range.derivative = 0;
    const double gap = range.over == Swept::gap ? value : 1.0;
    return {std::move(range), gap};
}

/// The excitation, sin(0) at the start: a base stands at 0. Its steps divide both its period and
/// L/c, so that echoes of one step meet the next ones, and pieces do not multiply: the fewest with
/// which the frequency is that asked for within 1e-5, or the nearest.
Excitation drivingOf(const SweepRange& range, std::string_view field = "frequencyRatio")
{
    constexpr double near = 1e-5;
    constexpr double most = 4.0;  // times as many steps
    const double stride = isUniform(range.segments) ? 1.0 : range.cells;
    double best = infinity;
    double cells = range.cells;
    for (double tried = cells; tried <= most * range.cells && best > near; tried += stride) {
        const double steps = std::round(4.0 * tried / range.frequencyRatio);
        const double off = std::abs(4.0 * tried / (steps * range.frequencyRatio) - 1.0);
        if (off < best) {
            best = off;
            cells = tried;
        }
    }
    const double steps = std::round(4.0 * cells / range.frequencyRatio);
    return excitationAt({.place = range.place,
                         .amplitude = range.amplitude,
                         .phase = std::numbers::pi / 2.0,
                         .stepsPerCrossing = cells},
                        steps >= 3.0 ? 4.0 * cells / steps : range.frequencyRatio, field);
}

Waves atRest(const SweepRange& range)
{
    return isUniform(range.segments) ? wavesAtRest(range.cells, range.stops)
                                     : wavesAtRest(range.segments, range.stops);
}

double placeOfTip(const Waves& waves)
{
    return stretching(waves, 1)[1];
}

/// With a smaller gap a second stop may be nearer than the tip is: the waves shrink until it is
/// not.
void keepClear(Waves& waves, const Stops& stops)
{
    const double limit = stops.left ? -stops.left->value() : 0.0;
    if (const double tip = placeOfTip(waves); stops.left && tip < limit) {
        for (auto* wave : {&waves.a, &waves.b}) {
            for (Piece& piece : *wave) {
                piece.value *= limit / tip;
            }
        }
    }
}

/// Follows the bar for the periods that are reported, and one before them: contacts that are under
/// way at the start are not theirs.
void measure(const BarSimulation& simulation, double period, double gap, SweepPoint& point,
             Waves& waves)
{
    const std::int64_t repeats =
        point.settling.settled ? point.settling.settled->periods : mostPeriods;
    BarSimulation seen = simulation.fork(true);
    std::vector<std::int64_t> contacts;
    std::vector<double> impulses;
    double begin = 0.0;
    for (std::int64_t k = 0; k <= repeats; ++k) {
        const double pushed = seen.impulse();
        const auto before = static_cast<std::int64_t>(seen.contacts().size());
        const double strain = largestStrain(seen, period);
        point.strain = std::max(point.strain, gap * strain);
        if (k == 0) {
            begin = seen.time();
        } else {
            contacts.push_back(static_cast<std::int64_t>(seen.contacts().size()) - before);
            impulses.push_back(gap * (seen.impulse() - pushed));
        }
    }
    enterPeriods(point, contacts, impulses);
    for (const ContactEvent& contact : seen.contacts()) {
        if (contact.end > begin) {
            point.impulses.push_back(gap * contact.impulse);
            point.meanForce = std::max(point.meanForce, gap * contact.meanForce);
        }
    }
    const auto [low, high] = std::minmax_element(
        seen.tipPath().begin(), seen.tipPath().end(),
        [](const TipPoint& a, const TipPoint& b) { return a.displacement < b.displacement; });
    point.tip = {gap * low->displacement, gap * high->displacement};
    waves = seen.waves();
}

/// One call: what is known already, and what is told as it goes on.
class Sweeping {
public:
    Sweeping(const SweepRange& range, const SweepBody& body,
             const std::vector<SweepDirection>& directions, const SweepControl& control)
        : range_(range),
          body_(body),
          directions_(directions),
          control_(control),
          values_(valuesOf(range)),
          seen_(range.isCarried ? directions.size() : directions.size() * values_.size())
    {
    }

    [[nodiscard]] std::vector<SweepPoint> run()
    {
        const auto serve = [this](std::size_t k) {
            range_.isCarried ? follow(k) : settle(k);
            return !isRequested(control_.cancel);
        };
        if (control_.share) {
            control_.share(seen_.size(), serve);
        } else {
            for (std::size_t k = 0; k < seen_.size() && serve(k); ++k) {
            }
        }
        std::vector<SweepPoint> all;
        for (std::vector<SweepPoint>& part : seen_) {
            std::move(part.begin(), part.end(), std::back_inserter(all));
        }
        return all;
    }

private:
    /// One direction, step by step, from where an earlier call was left.
    void follow(std::size_t which)
    {
        const SweepDirection direction = directions_[which];
        Waves waves = body_.atRest();
        for (std::size_t k = 0; k < values_.size(); ++k) {
            const double value =
                direction == SweepDirection::up ? values_[k] : values_[values_.size() - 1 - k];
            if (!stepTo(value, direction, knownOf(direction, k), waves, seen_[which])) {
                return;
            }
        }
    }

    /// One value, from rest.
    void settle(std::size_t k)
    {
        const double value = values_[k % values_.size()];
        const SweepDirection direction = directions_[k / values_.size()];
        const auto known =
            std::find_if(control_.known.begin(), control_.known.end(), [&](const SweepStep& step) {
                return step.point.value == value && step.point.direction == direction;
            });
        Waves waves = body_.atRest();
        (void)stepTo(value, direction, known == control_.known.end() ? nullptr : &*known, waves,
                     seen_[k]);
    }

    /// What an earlier call did at the k-th value of a direction, if it came so far.
    [[nodiscard]] const SweepStep* knownOf(SweepDirection direction, std::size_t k) const
    {
        for (const SweepStep& step : control_.known) {
            if (step.point.direction == direction && k-- == 0) {
                return &step;
            }
        }
        return nullptr;
    }

    bool stepTo(double value, SweepDirection direction, const SweepStep* known, Waves& waves,
                std::vector<SweepPoint>& seen)
    {
        if (known != nullptr) {
            seen.push_back(known->point);
            waves = known->waves;
            tell(nullptr);
            return true;
        }
        std::optional<SweepPoint> point = body_.settle(value, direction, waves, control_.cancel);
        if (!point) {
            return false;
        }
        const SweepStep step{std::move(*point), control_.keep ? waves : Waves{}};
        seen.push_back(step.point);
        tell(&step);
        return true;
    }

    void tell(const SweepStep* isNew)
    {
        const std::lock_guard lock(mutex_);
        done_ += 1.0;
        if (isNew != nullptr && control_.keep) {
            control_.keep(*isNew);
        }
        if (control_.show) {
            control_.show(done_, static_cast<double>(directions_.size() * values_.size()));
        }
    }

    const SweepRange& range_;
    const SweepBody& body_;
    const std::vector<SweepDirection>& directions_;
    const SweepControl& control_;
    std::vector<double> values_;
    std::vector<std::vector<SweepPoint>> seen_;
    std::mutex mutex_;
    double done_ = 0.0;
};

}  // namespace

std::string_view name(Swept swept)
{
    return nameIn(sweptNames, swept);
}

std::string_view name(SweepDirection direction)
{
    return nameIn(sweepDirections, direction);
}

std::vector<double> valuesOf(const SweepRange& range)
{
    Faults faults;
    faults.requirePositive("least", range.least, "-");
    faults.requirePositive("most", range.most, "-");
    if (range.most < range.least) {
        faults.add("most", range.most, fmt::format("at least {}", range.least));
    }
    faults.requireWhole("points", range.points, maxSweepPoints);
    faults.requireWhole("periods", range.periods, maxSweepPeriods);
    faults.requirePositive("amplitude", range.amplitude, "EA g/L or g");
    if (range.derivative < 0 || range.derivative > (range.place == Excited::base ? 2 : 0)) {
        faults.add("derivative", range.derivative, "0, or of a base 1 or 2");
    }
    faults.requirePositive("frequencyRatio", range.frequencyRatio, "ω₁");
    faults.requirePositive("cells", range.cells, "-");
    if (!(range.resolution >= 0.0 && range.resolution < infinity)) {
        faults.add("resolution", range.resolution, "finite and >= 0 [L/c]");
    }
    if (range.over == Swept::gap && range.stops.right != 1) {
        faults.add("over", name(range.over), "only where there is a gap > 0");
    }
    faults.throwIfAny();
    std::vector<double> values;
    for (std::int64_t k = 0; k < range.points; ++k) {
        const double part =
            range.points > 1 ? static_cast<double>(k) / static_cast<double>(range.points - 1) : 0.0;
        values.push_back(range.least * (1.0 - part) + range.most * part);
    }
    const bool isVaried = range.over == Swept::frequency;
    (void)drivingOf(at(range, values.front()).range, isVaried ? "least" : "frequencyRatio");
    (void)drivingOf(at(range, values.back()).range, isVaried ? "most" : "frequencyRatio");
    validate(at(range, values.back()).range.damping);
    return values;
}

std::optional<SweepPoint> settleAt(const SweepRange& range, double value, SweepDirection direction,
                                   Waves& waves, const Cancel& cancel)
{
    const auto [now, gap] = at(range, value);
    const Excitation driving = drivingOf(now);
    if (range.over == Swept::gap) {
        keepClear(waves, now.stops);
    }
    BarSimulation simulation(
        waves, now.damping, driving,
        {.mergeBelow = {},
         .recordsTip = false,
         .stops = now.stops,
         .segments = isUniform(now.segments) ? std::vector<Segment>{} : now.segments,
         .resolution = now.resolution > 0.0 ? now.resolution : 1.0 / driving.stepsPerCrossing});
    const double period = stretchOf(driving, waves.crossing);
    SweepPoint point{.value = value, .direction = direction};
    point.frequencyRatio = 4.0 * driving.stepsPerCrossing / static_cast<double>(driving.steps());
    if (!settle(point, range.periods, [&](double periods) {
            return signorini::follow(simulation, period, periods, cancel);
        })) {
        return std::nullopt;
    }
    if (point.settling.settled) {
        point.settling.settled->impulse *= gap;
    }
    measure(simulation, period, gap, point, waves);
    return point;
}

std::vector<SweepPoint> sweep(const SweepRange& range,
                              const std::vector<SweepDirection>& directions,
                              const SweepControl& control)
{
    const SweepBody bar{
        [&range] { return atRest(range); },
        [&range](double value, SweepDirection direction, Waves& waves, const Cancel& cancel) {
            return settleAt(range, value, direction, waves, cancel);
        }};
    return sweep(range, bar, directions, control);
}

std::vector<SweepPoint> sweep(const SweepRange& range, const SweepBody& body,
                              const std::vector<SweepDirection>& directions,
                              const SweepControl& control)
{
    return Sweeping(range, body, directions, control).run();
}

}  // namespace signorini
