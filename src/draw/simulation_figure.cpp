#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "axes.hpp"
#include "largest.hpp"
#include "signorini/figures.hpp"
#include "stops.hpp"

namespace signorini {

namespace {

using namespace plot;

constexpr double shownPeriods = 4.0;
constexpr double shownTime = 16.0;  // [L/c], of a bar that nothing excites
constexpr std::size_t maxPoints = 4000;

/// More contacts in a period are one clatter: dots of each would look like so many branches.
constexpr double fewContacts = 4.0;

/// A stretch of time [L/c].
struct Window {
    double begin;
    double end;
};

class SimulationPanels {
public:
    SimulationPanels(const SeenTip& seen, const Bar& bar)
        : seen_(seen), period_(seen.period > 0.0 ? seen.period : shownTime / shownPeriods)
    {
        const Stops& stops = seen.stops;
        wall_ = stops.right;
        lowest_ = std::min(0.0, stops.left ? placeOf(stops, Stop::left).value() : wall_ - 0.1);
        for (const TipPoint& point : seen.path) {
            lowest_ = std::min(lowest_, point.displacement);
        }
        const Scales si = scales(bar);
        time_ = axisUnit(si.time, seen.time, "s");
        place_ = axisUnit(si.displacement, std::max(std::abs(lowest_), std::abs(wall_)), "m");
        sumByPeriod();
        impulse_ = axisUnit(bar.axialStiffness * si.strain * si.time, largestOf(sums_), "N s");
    }

    FigureData figure()
    {
        const double end = seen_.time;
        const double shown = std::min(end, shownPeriods * period_);
        FigureData figure;
        Panel first = tipPanel("beginning", {0.12, 0.53, 0.58, 0.9}, {0.0, shown});
        first.title = "the beginning";
        Panel last = tipPanel("end", {0.57, 0.97, 0.58, 0.9}, {end - shown, end});
        last.title = "the end";
        last.y = bare(last.y);
        figure.panels = {std::move(first), std::move(last), impulsePanel()};
        return figure;
    }

    /// The whole path in one panel.
    FigureData whole()
    {
        FigureData figure;
        figure.panels = {tipPanel("tip", {0.12, 0.95, 0.55, 0.95}, {0.0, seen_.time}),
                         impulsePanel()};
        return figure;
    }

private:
    /// What the stops got in each whole period, and how many contacts there were at most. Periods
    /// are counted from where contacts are rarest, opposite to their mean phase: none is cut in
    /// two.
    void sumByPeriod()
    {
        double sine = 0.0;
        double cosine = 0.0;
        for (const ContactEvent& contact : seen_.contacts) {
            const double angle = 2.0 * std::numbers::pi * contact.start / period_;
            sine += contact.impulse * std::sin(angle);
            cosine += contact.impulse * std::cos(angle);
        }
        begin_ = (std::atan2(sine, cosine) / (2.0 * std::numbers::pi) - 0.5) * period_;
        sums_.assign(static_cast<std::size_t>(std::max((seen_.time - begin_) / period_, 1.0)), 0.0);
        std::vector<double> counts(sums_.size(), 0.0);
        for (const ContactEvent& contact : seen_.contacts) {
            const auto k = static_cast<std::size_t>((contact.start - begin_) / period_);
            if (k < sums_.size()) {
                sums_[k] += contact.impulse;
                counts[k] += 1.0;
            }
        }
        mostContacts_ = *std::max_element(counts.begin(), counts.end());
    }

    void addStop(Panel& panel, Window window, double from, double to) const
    {
        panel.add(box(Role::faint, window.begin * time_.factor, from * place_.factor,
                      window.end * time_.factor, to * place_.factor));
    }

    [[nodiscard]] Panel tipPanel(const char* name, Place place, Window window) const
    {
        const double room = 0.08 * (wall_ - lowest_);
        Panel panel{.name = name, .place = place};
        panel.x = axisIn(time_, "time", window.begin, window.end);
        panel.x.step = niceStep((window.end - window.begin) * time_.factor / 5.0);
        panel.y = axisIn(place_, "tip  u(L,t)", lowest_ - room, wall_ + room);
        addStop(panel, window, wall_, wall_ + room);
        if (seen_.stops.left) {
            addStop(panel, window, lowest_ - room, placeOf(seen_.stops, Stop::left).value());
        }
        const std::span<const TipPoint> path = seen_.path;
        const auto isBefore = [](const TipPoint& point, double at) { return point.time < at; };
        auto first = std::lower_bound(path.begin(), path.end(), window.begin, isBefore);
        const auto last = std::lower_bound(first, path.end(), window.end, isBefore);
        first -= first == path.begin() ? 0 : 1;
        const auto count = static_cast<std::size_t>(last - first);
        Series tip = plot::line(Role::ink, 1.2);
        for (std::size_t k = 0; k <= count; k += 1 + count / maxPoints) {
            const auto at = first + static_cast<std::ptrdiff_t>(k);
            if (at != path.end()) {
                tip.add(at->time * time_.factor, at->displacement * place_.factor);
            }
        }
        panel.add(std::move(tip));
        Series pressed = plot::strokes(Role::contact, 5.0);
        for (const ContactEvent& contact : seen_.contacts) {
            if (contact.end > window.begin && contact.start < window.end) {
                const double stop = placeOf(seen_.stops, contact.stop).value() * place_.factor;
                pressed.add(std::max(contact.start, window.begin) * time_.factor, stop,
                            std::min(contact.end, window.end) * time_.factor, stop);
            }
        }
        panel.add(std::move(pressed));
        return panel;
    }

    /// Steps of the sums, and dots of single contacts where they are few.
    [[nodiscard]] Panel impulsePanel() const
    {
        Panel panel{.name = "impulse", .place = {0.12, 0.97, 0.12, 0.40}};
        panel.x = axisIn(time_, "time", 0.0, seen_.time);
        panel.y = {.label = labelled("impulse", impulse_), .low = 0.0};
        panel.legend = Legend::above;
        if (seen_.contacts.empty()) {
            panel.y.high = 1.0;
            Series word = notes(Align::centre);
            word.add(0.5, 0.5, "no contact");
            panel.add(std::move(word));
            return panel;
        }
        Series steps =
            line(Role::ink, 1.2)
                .named(seen_.period > 0.0 ? "of all contacts in a period of the excitation"
                                          : "of all contacts in 4 L/c");
        double largest = 0.0;
        for (std::size_t k = 0; k < sums_.size(); ++k) {
            const double from = std::max(begin_ + static_cast<double>(k) * period_, 0.0);
            const double to = begin_ + static_cast<double>(k + 1) * period_;
            const double sum = sums_[k] * impulse_.factor;
            largest = std::max(largest, sum);
            steps.add(from * time_.factor, sum);
            steps.add(to * time_.factor, sum);
        }
        panel.y.high = 1.12 * largest;
        Series dots = plot::dots(Role::contact, 0.8).named("of a contact");
        for (const ContactEvent& contact : seen_.contacts) {
            if (mostContacts_ <= fewContacts) {
                dots.add(contact.start * time_.factor, contact.impulse * impulse_.factor);
            }
        }
        if (mostContacts_ > fewContacts) {
            steps.legend += fmt::format(", {} in all, up to {:.0f} in one", seen_.contacts.size(),
                                        mostContacts_);
        }
        panel.add(std::move(steps));
        panel.add(std::move(dots));
        return panel;
    }

    const SeenTip& seen_;
    double period_;
    double wall_ = 0.0;
    double lowest_ = 0.0;
    double begin_ = 0.0;  ///< of the first period, <= 0
    double mostContacts_ = 0.0;
    std::vector<double> sums_;
    Unit time_;
    Unit place_;
    Unit impulse_;
};

}  // namespace

FigureData simulationFigure(const SeenTip& seen, const Bar& bar, bool isWhole)
{
    if (seen.path.size() < 2) {
        throw std::invalid_argument("figure: the simulation holds no path of the tip to draw");
    }
    SimulationPanels panels(seen, bar);
    return isWhole ? panels.whole() : panels.figure();
}

FigureData simulationFigure(const BarSimulation& simulation, const Excitation& excitation,
                            const Bar& bar)
{
    const double period = excitation.steps() > 0 ? static_cast<double>(excitation.steps()) /
                                                       excitation.stepsPerCrossing
                                                 : 0.0;
    return simulationFigure({simulation.time(), simulation.stops(), simulation.tipPath(),
                             simulation.contacts(), period},
                            bar);
}

}  // namespace signorini
