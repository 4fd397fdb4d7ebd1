#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "axes.hpp"
#include "field.hpp"
#include "signorini/figures.hpp"
#include "signorini/motion.hpp"
#include "wall_force.hpp"

namespace signorini {

namespace {

using namespace plot;

constexpr std::size_t mostRows = 160;
constexpr std::size_t mostColumns = 400;
constexpr std::array memberNames{"first", "middle", "last"};

/// A number of each cell or step, for each motion of the curve.
using Profiles = std::vector<std::vector<double>>;

/// The longest profile, without the zeros at its end.
std::size_t lengthOf(const Profiles& profiles)
{
    std::size_t pieces = 0;
    for (const std::vector<double>& profile : profiles) {
        const auto last = std::find_if(profile.rbegin(), profile.rend(),
                                       [](double value) { return value != 0.0; });
        pieces = std::max(pieces, static_cast<std::size_t>(profile.rend() - last));
    }
    return pieces > 0 ? pieces : profiles.front().size();
}

std::vector<double> values(const Eigen::VectorXd& vector)
{
    return {vector.begin(), vector.end()};
}

const char* unitOf(const Continuum& curve)
{
    switch (curve.parameter) {
        case Parameter::arcLength:
            return curve.scene.bar.gap != 0.0 ? "arc length λ [√E_1]" : "arc length λ [√(EA L/2)]";
        case Parameter::pause:
            return "pause λ between the pulses [L/c]";
        case Parameter::number:
            return "number λ of the motion";
    }
    return "λ";
}

class ContinuumPanels {
public:
    explicit ContinuumPanels(const Continuum& curve)
        : curve_(curve),
          scale_(scales(curve.scene.bar)),
          low_(curve.points.front().lambda),
          high_(curve.points.back().lambda)
    {
        if (!(high_ > low_)) {
            high_ = low_ + 1.0;
        }
        const std::size_t last = curve.points.size() - 1;
        for (const std::size_t k : {std::size_t{0}, last / 2, last}) {
            if (full_.empty() || full_.back() != k) {
                full_.push_back(k);
            }
        }
        for (std::size_t row = 0; row < mostRows; ++row) {
            rows_.push_back(low_ + (high_ - low_) * (static_cast<double>(row) + 0.5) / mostRows);
            const auto at = std::min_element(
                curve.points.begin(), curve.points.end(), [this](const auto& x, const auto& y) {
                    return std::abs(x.lambda - rows_.back()) < std::abs(y.lambda - rows_.back());
                });
            members_.push_back(static_cast<std::size_t>(at - curve.points.begin()));
        }
    }

    [[nodiscard]] FigureData figure() const
    {
        const Bar& bar = curve_.scene.bar;
        FigureData figure{.width = 18.0, .height = 18.0};
        figure.title =
            fmt::format("{}   ω/ω_1 = {:.5g}   {}   {}, {} motions", describe(curve_.schedule),
                        frequencyRatio(curve_.schedule), energyLabel(bar, curve_.energyRatio),
                        curve_.family, curve_.points.size());
        Schedule folded = curve_.schedule;
        fold(folded);
        const auto cells = static_cast<double>(curve_.schedule.cells);
        const Unit second = unitFor(period(folded) * scale_.time, "s");
        const Unit metre = unitFor(bar.length, "m");
        const double dx = bar.length * metre.factor / cells;
        std::array<Profiles, 3> profiles;
        for (const std::size_t k : members_) {
            const State& state = curve_.points[k].state;
            profiles[0].push_back(wallForces(Motion(state, curve_.schedule)));
            profiles[1].push_back(values(strain(state)));
            profiles[2].push_back(values(velocity(state)));
        }
        const std::string time = labelled("time  t", second);
        const std::string position = labelled("position  x", metre);
        add(figure, "force", 0.1, profiles[0], scale_.time * second.factor / cells, time,
            curve_.scene.secondStop ? "force of the stops" : "force of the wall",
            bar.axialStiffness * scale_.strain, "N");
        add(figure, "strain", 0.41, profiles[1], dx, position, "strain  s(x, 0)", scale_.strain,
            "");
        add(figure, "velocity", 0.73, profiles[2], dx, position, "velocity  v(x, 0)",
            scale_.velocity, "m/s");
        figure.panels.front().y.label = unitOf(curve_);
        addMotions(figure);
        return figure;
    }

private:
    /// λ upwards, a row for each motion, coloured by what is put together in `profiles`.
    void add(FigureData& figure, const char* name, double left, const Profiles& profiles,
             double width, const std::string& axis, const std::string& words, double scale,
             const char* base) const
    {
        const std::size_t pieces = lengthOf(profiles);
        const std::size_t columns = std::min(pieces, mostColumns);
        const double length = width * static_cast<double>(pieces);
        Series image{.kind = Kind::image, .y = rows_};
        double largest = 0.0;
        for (std::size_t i = 0; i < columns; ++i) {
            image.x.push_back(length * (static_cast<double>(i) + 0.5) /
                              static_cast<double>(columns));
        }
        for (const std::vector<double>& profile : profiles) {
            for (std::size_t i = 0; i < columns;
                 ++i) {  // the largest of what is too fine for print
                double shown = 0.0;
                for (std::size_t k = i * pieces / columns; k < (i + 1) * pieces / columns; ++k) {
                    shown = std::abs(profile[k]) > std::abs(shown) ? profile[k] : shown;
                }
                image.z.push_back(shown);
                largest = std::max(largest, std::abs(shown));
            }
        }
        const Unit unit = axisUnit(scale, largest, base);
        for (double& value : image.z) {
            value *= unit.factor;
        }
        Panel& panel = figure.add({.name = name, .place = {left, left + 0.19, 0.54, 0.89}});
        panel.title = labelled(words, unit);
        panel.hasGrid = false;
        panel.x = {.label = axis, .low = 0.0, .high = length, .step = niceStep(length / 3.0)};
        panel.y = {.low = low_, .high = high_, .hasNumbers = figure.panels.size() == 1};
        panel.map = ColourMap::diverging;
        panel.colour = {.low = -largest * unit.factor, .high = largest * unit.factor};
        if (!(largest > 0.0)) {
            panel.colour = {.low = -1.0, .high = 1.0};
        }
        panel.colourBar = Place{left + 0.2, left + 0.212, 0.54, 0.89};
        panel.add(std::move(image));
        for (const std::size_t k : full_) {
            const double level = curve_.points[k].lambda;
            panel.add(across(0.0, length, level, 1.0, Dash::dashed));
        }
    }

    /// The paper's Fig. 3, for the members marked above.
    void addMotions(FigureData& figure) const
    {
        const Bar& bar = curve_.scene.bar;
        const double reach =
            bar.gap != 0.0 ? 1.0
                           : -extremesOf(curve_.points.front().state, curve_.schedule).lowestTip;
        const Unit metre = unitFor(bar.length, "m");
        const Unit deflection = axisUnit(scale_.displacement, reach, "m");
        const Unit second = axisUnit(scale_.time, period(curve_.schedule), "s");
        const std::size_t first = figure.panels.size();
        std::pair<double, double> range{0.0, 0.0};
        for (std::size_t k = 0; k < full_.size(); ++k) {
            const ContinuumPoint& point = curve_.points[full_[k]];
            const Motion motion(point.state, curve_.schedule);
            const double left = 0.1 + 0.265 * static_cast<double>(k);
            Panel& panel =
                figure.add({.name = memberNames[k], .place = {left, left + 0.24, 0.08, 0.42}});
            panel.title = fmt::format("λ = {:.4g}", point.lambda);
            panel.hasGrid = false;
            const double length = bar.length * metre.factor;
            panel.x = {.label = labelled("position  x", metre),
                       .low = 0.0,
                       .high = length,
                       .step = niceStep(length / 3.0)};
            panel.y =
                axisIn(second, k == 0 ? "time  t" : "", 0.0,
                       static_cast<double>(motion.steps()) / static_cast<double>(motion.cells()));
            if (k > 0) {
                panel.y.label.clear();
                panel.y.hasNumbers = false;
            }
            panel.add(fieldOf(motion, length, second.factor, deflection.factor, 201, 401));
            const auto [least, most] =
                std::minmax_element(panel.series.front().z.begin(), panel.series.front().z.end());
            range = {std::min(range.first, *least), std::max(range.second, *most)};
        }
        for (std::size_t k = first; k < figure.panels.size(); ++k) {
            figure.panels[k].colour = {.label = labelled("displacement  u(x, t)", deflection),
                                       .low = range.first,
                                       .high = range.second};
        }
        const double left = figure.panels.back().place.right;
        figure.panels.back().colourBar = Place{left + 0.02, left + 0.035, 0.08, 0.42};
    }

    const Continuum& curve_;
    Scales scale_;
    double low_;
    double high_;
    std::vector<std::size_t> full_;     ///< drawn in full
    std::vector<double> rows_;          ///< λ
    std::vector<std::size_t> members_;  ///< nearest to them
};

}  // namespace

FigureData continuumFigure(const Continuum& curve)
{
    if (curve.points.empty()) {
        throw std::invalid_argument("figure: the curve holds no motion to draw");
    }
    return ContinuumPanels(curve).figure();
}

}  // namespace signorini
