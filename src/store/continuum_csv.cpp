#include <fmt/format.h>

#include "signorini/output.hpp"
#include "state_table.hpp"

namespace signorini {

void writeContinuumCsv(const std::string& path, const Continuum& curve)
{
    const double unit = scales(curve.scene.bar).strain;
    TextFile file(path);
    file.write("lambda");
    for (const char wave : {'a', 'b'}) {
        for (std::int64_t i = 1; i <= curve.schedule.cells; ++i) {
            file.write(fmt::format(",{}_{}", wave, i));
        }
    }
    file.write("\n");
    for (const ContinuumPoint& point : curve.points) {
        file.write(fmt::format("{}", point.lambda));
        for (const Eigen::VectorXd* wave : {&point.state.a, &point.state.b}) {
            for (const double value : *wave) {
                file.write(fmt::format(",{}", value * unit + 0.0));  // -0 is shown as 0
            }
        }
        file.write("\n");
    }
    file.close();
}

void writeContinuumCsv(const std::string& path, const Network& network,
                       const NetworkContinuum& curve)
{
    TextFile file(path);
    file.write("lambda");
    for (std::size_t wave = 1; wave <= network.waves(); ++wave) {
        file.write(fmt::format(",wave_{}", wave));
    }
    for (std::size_t node = 1; node <= network.nodes.size(); ++node) {
        file.write(fmt::format(",displacement_{}", node));
    }
    file.write("\n");
    for (const NetworkCurvePoint& point : curve.points) {
        file.write(fmt::format("{}", point.lambda));
        for (const double wave : point.motion.waves) {
            file.write(fmt::format(",{}", wave * network.scales.velocity() + 0.0));
        }
        for (const double place : point.motion.displacements) {
            file.write(fmt::format(",{}", place * network.scales.displacement + 0.0));
        }
        file.write("\n");
    }
    file.close();
}

}  // namespace signorini
