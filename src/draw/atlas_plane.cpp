#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "atlas_scene.hpp"
#include "axes.hpp"
#include "faults.hpp"
#include "infinity.hpp"
#include "signorini/figures.hpp"
#include "signorini/modes.hpp"

namespace signorini {

namespace {

using namespace plot;

/// Schedules without families on the frequency-energy plot, at their least energies.
class SchedulePlane {
public:
    SchedulePlane(const AtlasDatabase& atlas, std::optional<std::int64_t> cells,
                  const FrequencyEnergyOptions& options)
        : runs_(atlas.runs()),
          units_(unitsOf(runs_, options.bar)),
          hasRatio_(std::isfinite(units_.frequency)),
          options_(options)
    {
        requireEnds();
        const std::int64_t count = contactsOf(runs_.front().range);
        for (std::int64_t k = 0; k < count; ++k) {
            // Those on top are smaller, so that both are seen.
            const double largest = count == 1 ? 0.8 : 1.2;
            const double size = largest * std::max(std::pow(0.6, static_cast<double>(k)), 0.35);
            pressing_.push_back(
                contactDots(static_cast<std::size_t>(k), size)
                    .named(count == 1 ? "pressing" : fmt::format("contact {} presses", k + 1)));
        }
        atlas.forEachSchedule(cells, [this](const AtlasEntry& entry) { add(entry); });
        caption_ = captionOf(runs_, cells);
    }

    [[nodiscard]] FigureData figure()
    {
        const std::size_t rows = 2 + pressing_.size() / 3;  // of the legend
        const double words = 0.55 * static_cast<double>(rows);
        FigureData figure{.width = 18.0, .height = 12.0 + words, .title = caption_};
        if (undecided_ > 0) {
            figure.title += fmt::format(",  {} undecided", undecided_);
        }
        Panel& panel = figure.add(
            {.name = "energy",
             .place = {0.11, 0.96, (2.0 + words) / figure.height, 1.0 - 2.2 / figure.height},
             .legend = Legend::below,
             .legendRows = static_cast<int>(rows)});
        panel.x = frequencies();
        panel.y = energies();
        if (lowest_ > highest_) {
            panel.y = {.label = panel.y.label, .low = 0.0, .high = 1.0, .ticks = {{0.0, "0"}}};
            Series none = notes(Align::centre);
            none.add(0.5, 0.5, "no least energy above 0 is known");
            panel.add(std::move(none));
        }
        for (Series* series : all()) {
            scale(*series);
        }
        fromZero_.y.assign(fromZero_.x.size(), *panel.y.low);
        for (Series* series : all()) {
            panel.add(std::move(*series));
        }
        return figure;
    }

private:
    /// Dots nearer than this, relative, are one.
    static constexpr double nearest = 5e-4;

    void requireEnds() const
    {
        Faults faults;
        if (options_.maxFrequencyRatio) {
            faults.requirePositive("maxFrequencyRatio", *options_.maxFrequencyRatio, "-");
        }
        if (options_.maxEnergyRatio) {
            faults.requirePositive("maxEnergyRatio", *options_.maxEnergyRatio, "E_1");
        }
        faults.throwIfAny();
        if (!hasRatio_ && (options_.maxFrequencyRatio || options_.leastFrequencyRatio)) {
            throw std::invalid_argument(
                "ends in omega_1: allowed of bars that vibrate with their contacts open");
        }
        if (!units_.isRatio && options_.maxEnergyRatio) {
            throw std::invalid_argument(
                "a top in E_1: allowed of bars with E_1: nothing drifts, contact 1 has a gap");
        }
    }

    [[nodiscard]] std::vector<Series*> all()
    {
        std::vector<Series*> list{&fromZero_, &grazing_};
        for (Series& one : pressing_) {
            list.push_back(&one);
        }
        list.push_back(&several_);
        return list;
    }

    void add(const AtlasEntry& entry)
    {
        if (entry.row.status != Status::found) {
            undecided_ += entry.row.status == Status::undecided ? 1 : 0;
            return;
        }
        const double frequency = hasRatio_ ? frequencyRatio(entry) * units_.frequency
                                           : 1.0 / (period(entry) * units_.time);
        const double energy = entry.row.energy.least;
        if (frequency > options_.maxFrequencyRatio.value_or(infinity) ||
            frequency < options_.leastFrequencyRatio.value_or(0.0) ||
            energy > options_.maxEnergyRatio.value_or(infinity)) {
            return;
        }
        left_ = std::min(left_, frequency);
        right_ = std::max(right_, frequency);
        const std::vector<Phase>& phases = entry.schedule.phases;
        const auto contact = static_cast<std::size_t>(phases.front().stop);
        Series& series = energy <= 0.0                           ? fromZero_
                         : entry.row.contact == Contact::grazing ? grazing_
                         : phases.size() > 1                     ? several_
                                                                 : pressing_.at(contact);
        const auto place = [](double value) { return std::llround(std::log(value) / nearest); };
        if (!seen_.insert({&series, place(frequency), energy > 0.0 ? place(energy) : 0}).second) {
            return;
        }
        series.add(frequency, energy);
        if (energy > 0.0) {
            lowest_ = std::min(lowest_, energy);
            highest_ = std::max(highest_, energy);
        }
    }

    [[nodiscard]] Axis frequencies()
    {
        const bool isEmpty = left_ > right_;
        const double low = options_.leastFrequencyRatio.value_or(isEmpty ? 1.0 : 0.95 * left_);
        const double high =
            std::max(options_.maxFrequencyRatio.value_or(isEmpty ? 2.0 : 1.05 * right_), 1.1 * low);
        const Unit hertz =
            axisUnit(hasRatio_ ? 0.25 / (units_.time * units_.frequency) : 1.0, high, "Hz");
        const auto ticks = [](double from, double to) {
            return to < 4.0 * from ? std::vector<Tick>()
                                   : roundTicks(from, to, {1.0, 1.5, 2.0, 3.0, 5.0, 7.0});
        };
        const double unit = hasRatio_ ? 1.0 : hertz.factor;
        xUnit_ = unit;
        Axis axis = hasRatio_ ? Axis{.label = "frequency  ω/ω_1", .low = low, .high = high}
                              : axisIn(hertz, "frequency", low, high);
        axis.ticks = ticks(unit * low, unit * high);
        axis.isLogarithmic = !axis.ticks.empty();
        if (hasRatio_) {
            axis.other = OtherSide{.label = labelled("frequency", hertz), .factor = hertz.factor};
            for (const Tick& tick : ticks(hertz.factor * low, hertz.factor * high)) {
                axis.other->ticks.push_back(tick.at);
            }
        }
        return axis;
    }

    [[nodiscard]] Axis energies()
    {
        const bool isEmpty = lowest_ > highest_;
        const double low = isEmpty ? 1.0 : 0.7 * lowest_;
        const double high =
            options_.maxEnergyRatio.value_or(isEmpty ? 10.0 : std::max(1.5 * highest_, 10.0 * low));
        const Unit joule = axisUnit(1.0, high, "J");
        yUnit_ = units_.isRatio ? 1.0 : joule.factor;
        return energyAxis(
            units_.isRatio ? "least energy  E_{min}/E_1" : labelled("least energy  E_{min}", joule),
            yUnit_ * low, yUnit_ * high);
    }

    /// To the units of the axes, and smaller where there are many.
    void scale(Series& series) const
    {
        series.size *=
            std::clamp(600.0 / std::max(1.0, static_cast<double>(seen_.size())), 0.4, 1.0);
        for (double& x : series.x) {
            x *= xUnit_;
        }
        for (double& y : series.y) {
            y *= yUnit_;
        }
    }

    std::vector<AtlasRun> runs_;
    answers::AtlasUnits units_;
    bool hasRatio_;  ///< have the bars an omega_1?
    const FrequencyEnergyOptions& options_;
    std::string caption_;
    std::vector<Series> pressing_;  ///< one for each contact
    Series several_ = dots(Role::ink, 1.4, Marker::ring).named("several contacts in a period");
    Series grazing_ = dots(Role::faint, 0.65).named("grazing: contact without force");
    Series fromZero_ = dots(Role::faint, 1.0, Marker::openDiamond)
                           .named("motions from E = 0 on, at the lower edge");
    std::set<std::tuple<const Series*, std::int64_t, std::int64_t>> seen_;
    std::int64_t undecided_ = 0;
    double left_ = infinity;
    double right_ = 0.0;
    double lowest_ = infinity;
    double highest_ = 0.0;
    double xUnit_ = 1.0;
    double yUnit_ = 1.0;
};

}  // namespace

FigureData frequencyEnergyFigure(const AtlasDatabase& atlas, std::optional<std::int64_t> cells,
                                 const FrequencyEnergyOptions& options)
{
    const std::vector<AtlasRun> runs = atlas.runs();
    if (!hasFamilies(runs)) {
        return SchedulePlane(atlas, cells, options).figure();
    }
    if (!runs.empty() && stopsOf(runs.front().range) != Stops()) {
        throw std::invalid_argument(
            "the frequency-energy plot: allowed with a gap > 0 and one stop, whose modes it shows");
    }
    std::set<std::array<std::int64_t, 3>> seen;  // on several grids, each once
    std::vector<Family> onGrid;
    std::vector<EnergyBar> bars;
    const auto addBar = [&bars](const auto& row, const EnergyRange& energy, Contact contact) {
        bars.push_back({.frequencyRatio = frequencyRatio(row),
                        .least = energy.least,
                        .most = energy.most,
                        .contact = contact});
    };
    atlas.forEachFamily(cells, [&](const AtlasFamily& all) {
        if (!all.family) {
            addBar(all, all.energy, Contact::grazing);
        } else if (seen.insert({all.family->order, all.family->blocks, all.family->contactBlocks})
                       .second) {
            onGrid.push_back(*all.family);
        }
    });
    atlas.forEachFound(
        cells, [&](const AtlasEntry& entry) { addBar(entry, entry.row.energy, entry.row.contact); },
        AtlasSchedules::withoutFamily);
    const std::vector<Mode> modes = findModes();
    const std::vector<Family> families = findFamilies(options.maxOrder);
    return frequencyEnergyFigure(
        {.modes = modes, .families = families, .onGrid = onGrid, .bars = bars}, options);
}

}  // namespace signorini
