#pragma once
/// \file
/// Methods that people march such bars with, on one model: equal linear elements, L = EA = c = 1.
///
/// Every scheme is one step of time; `march` does the rest. None knows the schedule.

#include <Eigen/Core>
#include <functional>
#include <memory>
#include <string_view>
#include <vector>

namespace signorini::bench {

/// A bar, what moves it, and how it starts.
struct MarchedBar {
    bool isClamped = true;  ///< at x = 0; else free
    double wall = 1.0;      ///< u(1) <= wall
    double weight = 0.0;    ///< [EA/L for each L], towards the wall
    double dashpot = 0.0;   ///< [EA/c], at the tip
    std::function<double(double)> force = [](double) { return 0.0; };  ///< on the tip, of time
    std::function<double(double)> displacement;                        ///< at the start, of x
    std::function<double(double)> velocity;                            ///< at the start, of x
};

/// What is seen after a step.
struct Sample {
    double time;   ///< [L/c]
    double tip;    ///< u(1)
    double force;  ///< of the wall, mean of the step
};

/// What a march came to.
struct TimeSteps {
    std::vector<Sample> samples;  ///< of the first periods
    double energyBefore = 0.0;    ///< of the model: elastic and kinetic, and of the weight
    double energyAfter = 0.0;
    double seconds = 0.0;  ///< of the processor
};

/// One bar under way.
class Scheme {
public:
    virtual ~Scheme() = default;
    /// From `time` to `time + h`.
    virtual void step(double time, double h) = 0;
    [[nodiscard]] virtual double tip() const = 0;
    /// Of the wall, mean of the last step.
    [[nodiscard]] virtual double force() const = 0;
    [[nodiscard]] virtual double energy() const = 0;
    /// Largest step, in crossings of an element.
    [[nodiscard]] virtual double courant() const { return 1.0; }
};

/// "characteristics", "Newmark, penalty", "damped Newmark, penalty", "Moreau-Jean",
/// "mass redistribution", "CVODE, penalty".
[[nodiscard]] const std::vector<std::string_view>& schemeNames();

/// \throws BackendUnavailable if this build does not contain it.
[[nodiscard]] std::unique_ptr<Scheme> schemeOf(std::string_view name, const MarchedBar& bar,
                                               int elements);

/// Marches so many periods in equal steps that fit into one, and keeps samples of the first ones.
[[nodiscard]] TimeSteps march(std::string_view name, const MarchedBar& bar, int elements,
                              double period, int periods, int kept);

}  // namespace signorini::bench
