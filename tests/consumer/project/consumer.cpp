// A program against an installed signorini, as in the README and with a proof.

#include <iostream>
#include <signorini/signorini.hpp>

int main()
{
    using namespace signorini;
    const PeriodicResult found = findPeriodic(150, 900);  // n_c, n_f on 300 cells
    if (!found.motion) {
        std::cout << name(found.status) << ' ' << found.detail << '\n';
        return 1;
    }
    std::cout << "E/E1 = " << found.motion->energyRatio << " in [" << found.set.energy->least
              << ", " << found.set.energy->most << "], residual " << found.motion->residuals.worst()
              << '\n';

    const PeriodicResult none = findPeriodic(20, 109, 40);
    std::cout << "20, 109 on 40 cells: " << name(none.status) << ", " << name(none.absence->reason)
              << ", proof holds: " << isProof(none) << '\n';
    return found.motion->energyRatio == 4.0 && isProof(none) ? 0 : 1;
}
