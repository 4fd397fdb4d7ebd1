#include <fmt/format.h>

#include "signorini/output.hpp"

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

}  // namespace signorini
