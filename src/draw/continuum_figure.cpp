#include <fmt/format.h>

#include <vector>

#include "axes.hpp"
#include "curve_points.hpp"
#include "field.hpp"
#include "lambda_images.hpp"
#include "signorini/figures.hpp"
#include "signorini/motion.hpp"

namespace signorini {

namespace {

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

/// The paper's Fig. 3 of the members that are marked.
FullMotions motionsOf(const Continuum& curve, const LambdaImages& images)
{
    const Bar& bar = curve.scene.bar;
    const Scales scale = scales(bar);
    const double reach =
        bar.gap != 0.0 ? 1.0 : -extremesOf(curve.points.front().state, curve.schedule).lowestTip;
    const Unit metre = unitFor(bar.length, "m");
    const Unit deflection = axisUnit(scale.displacement, reach, "m");
    const Unit second = axisUnit(scale.time, period(curve.schedule), "s");
    FullMotions full{labelled("position  x", metre),
                     bar.length * metre.factor,
                     {},
                     labelled("displacement  u(x, t)", deflection)};
    for (const std::size_t k : images.full()) {
        const Motion motion(curve.points[k].state, curve.schedule);
        full.upwards =
            axisIn(second, "time  t", 0.0,
                   static_cast<double>(motion.steps()) / static_cast<double>(motion.cells()));
        full.fields.push_back(
            fieldOf(motion, full.length, second.factor, deflection.factor, 201, 401));
    }
    return full;
}

}  // namespace

FigureData continuumFigure(const Continuum& curve)
{
    const LambdaImages rows(lambdasOf(curve.points), unitOf(curve));
    const Bar& bar = curve.scene.bar;
    const Scales scale = scales(bar);
    Schedule folded = curve.schedule;
    fold(folded);
    const auto cells = static_cast<double>(curve.schedule.cells);
    const Unit second = unitFor(period(folded) * scale.time, "s");
    const Unit metre = unitFor(bar.length, "m");
    const double dx = bar.length * metre.factor / cells;
    const std::string position = labelled("position  x", metre);
    std::vector<LambdaImage> images{
        {"force", labelled("time  t", second),
         curve.scene.secondStop ? "force of the stops" : "force of the wall",
         bar.axialStiffness * scale.strain, "N", scale.time * second.factor / cells},
        {"strain", position, "strain  s(x, 0)", scale.strain, "", dx},
        {"velocity", position, "velocity  v(x, 0)", scale.velocity, "m/s", dx}};
    for (const std::size_t k : rows.members()) {
        const State& state = curve.points[k].state;
        images[0].profiles.push_back(wallForces(Motion(state, curve.schedule)));
        images[1].profiles.push_back(values(strain(state)));
        images[2].profiles.push_back(values(velocity(state)));
    }
    return rows.figure(
        fmt::format("{}   ω/ω_1 = {:.5g}   {}   {}, {} motions", describe(curve.schedule),
                    frequencyRatio(curve.schedule), energyLabel(bar, curve.energyRatio),
                    curve.family, curve.points.size()),
        images, motionsOf(curve, rows));
}

}  // namespace signorini
