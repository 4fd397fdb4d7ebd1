#include <fmt/format.h>

#include <array>
#include <vector>

#include "axes.hpp"
#include "curve_points.hpp"
#include "field.hpp"
#include "lambda_images.hpp"
#include "signorini/figures.hpp"
#include "signorini/motion.hpp"

namespace signorini {

namespace {

using namespace plot;

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
          images_(lambdasOf(curve.points), unitOf(curve))
    {
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
        for (const std::size_t k : images_.members()) {
            const State& state = curve_.points[k].state;
            profiles[0].push_back(wallForces(Motion(state, curve_.schedule)));
            profiles[1].push_back(values(strain(state)));
            profiles[2].push_back(values(velocity(state)));
        }
        const std::string time = labelled("time  t", second);
        const std::string position = labelled("position  x", metre);
        images_.add(
            figure, 0, profiles[0], scale_.time * second.factor / cells,
            {"force", time, curve_.scene.secondStop ? "force of the stops" : "force of the wall",
             bar.axialStiffness * scale_.strain, "N"});
        images_.add(figure, 1, profiles[1], dx,
                    {"strain", position, "strain  s(x, 0)", scale_.strain, ""});
        images_.add(figure, 2, profiles[2], dx,
                    {"velocity", position, "velocity  v(x, 0)", scale_.velocity, "m/s"});
        addMotions(figure);
        return figure;
    }

private:
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
        const double length = bar.length * metre.factor;
        for (std::size_t k = 0; k < images_.full().size(); ++k) {
            const Motion motion(curve_.points[images_.full()[k]].state, curve_.schedule);
            Panel& panel = images_.addFull(
                figure, k, labelled("position  x", metre), length,
                axisIn(second, "time  t", 0.0,
                       static_cast<double>(motion.steps()) / static_cast<double>(motion.cells())));
            panel.add(fieldOf(motion, length, second.factor, deflection.factor, 201, 401));
        }
        images_.shareColours(figure, labelled("displacement  u(x, t)", deflection));
    }

    const Continuum& curve_;
    Scales scale_;
    LambdaImages images_;
};

}  // namespace

FigureData continuumFigure(const Continuum& curve)
{
    return ContinuumPanels(curve).figure();
}

}  // namespace signorini
