// The example of the README, built against an installed signorini.

#include <iostream>
#include <signorini/signorini.hpp>

int main()
{
    using namespace signorini;
    const PeriodicResult motion = findPeriodic(150, 900);  // n_c, n_f on 300 cells
    if (motion.status != Status::found) {
        std::cout << name(motion.status) << ' ' << motion.detail << '\n';
        return 1;
    }
    std::cout << "E/E1 = " << motion.energyRatio << " in [" << motion.energyRange->least << ", "
              << motion.energyRange->most << "], residual " << motion.residuals.worst() << '\n';

    const PeriodicResult none = findPeriodic(20, 109, 40);
    std::cout << "20, 109 on 40 cells: " << name(none.status) << ", " << name(*none.reason)
              << ", proof holds: " << isProof(*none.certificate, none.schedule) << '\n';
    return motion.energyRatio == 4.0 && none.status == Status::none ? 0 : 1;
}
