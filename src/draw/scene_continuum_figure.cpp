#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <stdexcept>

#include "axes.hpp"
#include "curve_points.hpp"
#include "lambda_images.hpp"
#include "largest.hpp"
#include "network_field.hpp"
#include "scene_figures.hpp"

namespace signorini {

namespace {

using namespace plot;
using answers::SceneContinuumAnswer;

constexpr std::int64_t mostInstants = 400;
constexpr std::size_t mostFrames = 60;
constexpr std::size_t parts = 200;  ///< along the bars

/// A motion over its period, in units of the network.
struct SeenMotion {
    std::vector<double> instants;
    std::vector<std::vector<double>> pushes;  ///< by contact, means between instants
    NetworkLook start;                        ///< at t = 0
    NetworkLook all;                          ///< displacements, instants by places
};

SeenMotion seenIn(const Network& network, const NetworkClaim& motion,
                  const std::vector<NetworkPlace>& places, bool isWhole)
{
    SeenMotion seen;
    seen.pushes.resize(network.contacts.size());
    look(seen.start, network, {motion.waves, motion.displacements}, places);
    std::vector<double> before(network.contacts.size(), 0.0);
    const auto period = static_cast<double>(motion.steps());
    (void)throughPeriod(
        network, {motion.waves, motion.displacements}, {}, period,
        std::min(motion.steps(), mostInstants), [&](const NetworkSimulation& now) {
            const double since = seen.instants.empty() ? 0.0 : seen.instants.back();
            for (std::size_t j = 0; j < before.size(); ++j) {
                const double pushed = now.impulseAt(j);
                if (now.time() > since) {
                    seen.pushes[j].push_back((pushed - before[j]) / (now.time() - since));
                }
                before[j] = pushed;
            }
            if (now.time() > since || seen.instants.empty()) {
                seen.instants.push_back(now.time());
                if (isWhole) {
                    look(seen.all, network, now.state(), places);
                }
            }
        });
    return seen;
}

/// 0 where nothing presses.
std::vector<double> withoutRounding(std::vector<double> pushes)
{
    constexpr double rounding = 1e-9;
    const double largest = *std::max_element(pushes.begin(), pushes.end());
    for (double& push : pushes) {
        push = push > rounding * largest ? push : 0.0;
    }
    return pushes;
}

/// The parameter of a curve with its unit.
std::string unitOf(const SceneContinuumAnswer& answer)
{
    if (answer.curve().parameter == Parameter::number) {
        return "number λ of the motion";
    }
    return answer.schedule().unit ? "arc length λ [√E_1]" : "arc length λ [√E]";
}

/// What is drawn of a curve, and its units.
class BarsCurve {
public:
    explicit BarsCurve(const SceneContinuumAnswer& answer)
        : answer_(answer),
          curve_(answer.curve()),
          network_(answer.schedule().network()),
          length_(answer.schedule().bars.assembly.length),
          places_(placesAlong(network_, parts)),
          positions_(positionsOf(network_, places_, length_)),
          second_(axisUnit(network_.scales.time, period(), "s")),
          metre_(unitFor(length_, "m"))
    {
    }

    [[nodiscard]] FigureData figure()
    {
        const LambdaImages rows(lambdasOf(curve_.points), unitOf(answer_));
        for (const std::size_t k : rows.full()) {
            seen_.emplace(k, seenIn(network_, curve_.points[k].motion, places_, true));
        }
        const std::size_t contacts = std::min<std::size_t>(network_.contacts.size(), 2);
        const std::string time = labelled("time  t", second_);
        const std::string along = labelled("along the bars", metre_);
        const double step = second_.factor * period() /
                            static_cast<double>(member(rows.members().front()).pushes[0].size());
        const double part = length_ * metre_.factor / static_cast<double>(parts);
        const NetworkScales& scale = network_.scales;
        std::vector<LambdaImage> images;
        for (std::size_t j = 0; j < contacts; ++j) {
            images.push_back({j == 0 ? "force" : "second force", time,
                              fmt::format("force of contact {}", j + 1), scale.force(), "N", step});
        }
        if (contacts < 2) {
            images.push_back(
                {"velocity", along, "velocity  v(x, 0)", scale.velocity(), "m/s", part});
        }
        images.push_back(
            {"displacement", along, "displacement  u(x, 0)", scale.displacement, "m", part});
        for (const std::size_t k : rows.members()) {
            const SeenMotion& seen = member(k);
            for (std::size_t j = 0; j < contacts; ++j) {
                images[j].profiles.push_back(withoutRounding(seen.pushes[j]));
            }
            if (contacts < 2) {
                images[1].profiles.push_back(seen.start.velocities);
            }
            images[2].profiles.push_back(seen.start.displacements);
        }
        return rows.figure(title(), images, motions(rows));
    }

    /// Forces over a period and u along the bars at t = 0, a frame for each member.
    [[nodiscard]] std::vector<FigureData> frames()
    {
        const std::size_t count = curve_.points.size();
        const std::size_t every = 1 + (count - 1) / mostFrames;
        double force = 0.0;
        double reach = 0.0;
        for (std::size_t k = 0; k < count; k += every) {
            const SeenMotion& seen = member(k);
            for (const std::vector<double>& pushes : seen.pushes) {
                force = std::max(force, largestOf(pushes));
            }
            reach = std::max(reach, largestSizeOf(seen.start.displacements));
        }
        std::vector<FigureData> all;
        for (std::size_t k = 0; k < count; k += every) {
            all.push_back(frameOf(k, std::max(force, 1e-300), std::max(reach, 1e-300)));
        }
        return all;
    }

private:
    [[nodiscard]] double period() const
    {
        return static_cast<double>(stepsOf(answer_.schedule().spans));
    }

    [[nodiscard]] std::string title() const
    {
        const auto ratio = answer_.schedule().ratio(curve_.energy);
        const double joules = answer_.schedule().joules(curve_.energy);
        return fmt::format(
            "{}   {}   {}, {} motions", textOf(answer_.schedule().spans),
            ratio ? fmt::format("E/E_1 = {:.6g}", *ratio) : "E = " + withUnit(joules, "J"),
            curve_.family, curve_.points.size());
    }

    /// Simulated once.
    const SeenMotion& member(std::size_t k)
    {
        const auto known = seen_.find(k);
        return known != seen_.end()
                   ? known->second
                   : seen_.emplace(k, seenIn(network_, curve_.points[k].motion, places_, false))
                         .first->second;
    }

    [[nodiscard]] FullMotions motions(const LambdaImages& rows)
    {
        const double reach = largestOf(rows.full(), [this](std::size_t k) {
            return largestSizeOf(member(k).all.displacements);
        });
        const Unit deflection = axisUnit(network_.scales.displacement, reach, "m");
        FullMotions full{labelled("along the bars", metre_), length_ * metre_.factor,
                         axisIn(second_, "time  t", 0.0, period()),
                         labelled("displacement  u(x, t)", deflection)};
        for (const std::size_t k : rows.full()) {
            const SeenMotion& seen = member(k);
            Series& field = full.fields.emplace_back(Series{.kind = Kind::image});
            for (const double x : positions_) {
                field.x.push_back(x * metre_.factor);
            }
            for (const double instant : seen.instants) {
                field.y.push_back(instant * second_.factor);
            }
            for (const double u : seen.all.displacements) {
                field.z.push_back(u * deflection.factor);
            }
        }
        const std::vector<double> nodes = placesOf(network_, length_);
        for (const NetworkContact& contact : network_.contacts) {
            const double x = nodes[contact.node] * metre_.factor;
            full.marks.add(x, *full.upwards.low, x, *full.upwards.high);
        }
        return full;
    }

    [[nodiscard]] FigureData frameOf(std::size_t k, double force, double reach)
    {
        const SeenMotion& seen = member(k);
        const Unit newton = axisUnit(network_.scales.force(), force, "N");
        const Unit deflection = axisUnit(network_.scales.displacement, reach, "m");
        constexpr std::array roles{Role::contact, Role::ink, Role::strain, Role::velocity};
        Panel forces{.name = "force", .place = {0.13, 0.97, 0.6, 0.9}};
        forces.x = axisIn(second_, "time  t", 0.0, period());
        forces.y = axisIn(newton, "forces", -0.05 * force, 1.1 * force);
        for (std::size_t j = 0; j < std::min(seen.pushes.size(), roles.size()); ++j) {
            Series line = plot::line(roles.at(j), 2.0).named(fmt::format("contact {}", j + 1));
            for (std::size_t m = 0; m < seen.pushes[j].size(); ++m) {
                line.addStep(seen.instants[m] * second_.factor,
                             seen.instants[m + 1] * second_.factor,
                             seen.pushes[j][m] * newton.factor);
            }
            forces.add(std::move(line));
        }
        forces.legend = Legend::above;
        Panel shape{.name = "displacement", .place = {0.13, 0.97, 0.11, 0.45}};
        shape.x = axisIn(Unit{metre_.factor, metre_.name}, "along the bars", 0.0, length_);
        shape.y = axisIn(deflection, "u at t = 0", -1.1 * reach, 1.1 * reach);
        Series u = plot::line(Role::ink, 2.0);
        for (std::size_t i = 0; i < positions_.size(); ++i) {
            const auto barAt = [this](std::size_t of) {
                return network_.nodes[network_.rows[places_[of].row].left].bar;
            };
            if (i > 0 && barAt(i) != barAt(i - 1)) {
                u.breakOff();
            }
            u.add(positions_[i] * metre_.factor, seen.start.displacements[i] * deflection.factor);
        }
        shape.add(std::move(u));
        FigureData frame{.width = 20.0, .height = 13.0};
        frame.title = fmt::format("{}:   λ = {:.4g} ({})", curve_.family, curve_.points[k].lambda,
                                  name(curve_.parameter));
        frame.panels = {std::move(forces), std::move(shape)};
        return frame;
    }

    const SceneContinuumAnswer& answer_;
    const NetworkContinuum& curve_;
    Network network_;
    double length_;
    std::vector<NetworkPlace> places_;
    std::vector<double> positions_;
    Unit second_;
    Unit metre_;
    std::map<std::size_t, SeenMotion> seen_;
};

}  // namespace

FigureData sceneContinuumFigure(const SceneContinuumAnswer& answer)
{
    return BarsCurve(answer).figure();
}

std::vector<FigureData> sceneContinuumFrames(const SceneContinuumAnswer& answer)
{
    if (answer.curve().points.empty()) {
        throw std::invalid_argument("animation: the curve holds no motion to draw");
    }
    return BarsCurve(answer).frames();
}

}  // namespace signorini
