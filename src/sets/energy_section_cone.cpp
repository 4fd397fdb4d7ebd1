#include <algorithm>
#include <cmath>
#include <optional>

#include "echo.hpp"
#include "energy_section.hpp"
#include "stops.hpp"

namespace signorini {

namespace {

/// Without a gap any motion but the bar at rest presses, so no motion's opposite is one: the set is
/// a convex cone without lines. Cut by a sphere it is connected.
class Cone final : public ConeSection {
public:
    Cone(LumpedSet set, double energyRatio) : set_(std::move(set)), energy_(energyRatio)
    {
        shape_ = shapeOf(set_);
        facts_.range = shape_.energy;
        facts_.dimension = shape_.dimension - 1;
        facts_.isConnected = true;
        facts_.components = 1;
        facts_.isFinite = facts_.dimension == 0;
        facts_.largestWave = std::sqrt(squaresOf(energy_, cells(), set_.classes.window));
        findPulses();
    }

    [[nodiscard]] std::optional<bool> joins(const State&, const State&) const override
    {
        return true;
    }

    [[nodiscard]] std::vector<State> isolated(std::int64_t) const override
    {
        return {sized(equalMotion(set_, set_.leastSums))};
    }

    [[nodiscard]] std::vector<double> sharesOf(const State& state) const override
    {
        const std::vector<double> z = amplitudesOf(set_.classes, state);
        const ClassType& type = set_.type(*pulsed_);
        std::vector<double> shares(z.data() + type.first, z.data() + type.first + type.count);
        double sum = 0.0;
        for (const double value : shares) {
            sum += value;
        }
        for (double& value : shares) {
            value /= sum;
        }
        return shares;
    }

    [[nodiscard]] State motionOf(const std::vector<double>& shares) const override
    {
        return sized(signorini::motionOf(
            set_.classes,
            sharedOut(set_, shares, [this](std::size_t t) { return t == *pulsed_; })));
    }

    [[nodiscard]] AmplitudeSet sampled() const override
    {
        return {.kind = SetKind::simplex, .count = set_.type(*pulsed_).count, .sum = 1.0};
    }

    [[nodiscard]] State draw(std::mt19937_64& generator) const override
    {
        return sized(drawMotion(set_, shape_, generator));
    }

private:
    [[nodiscard]] std::int64_t cells() const { return set_.classes.schedule.cells; }

    [[nodiscard]] State sized(State state) const
    {
        const double factor = std::sqrt(energy_ / energyRatio(state));
        state.a *= factor;
        state.b *= factor;
        return state;
    }

    /// The pressing type of most classes can carry pulses of force, together half as long.
    void findPulses()
    {
        std::int64_t most = 2;
        for (std::size_t t = 0; t < set_.live.size(); ++t) {
            if (set_.type(t).kind == TypeKind::pressing && set_.type(t).count > most &&
                set_.leastSums[t] > 0.0) {
                most = set_.type(t).count;
                pulsed_ = t;
            }
        }
        if (pulsed_) {
            const double covered = std::max(2.0, 0.5 * static_cast<double>(most));
            facts_.simplex = SphereSection{most, 1.0 / covered};
            facts_.isWhole = false;
        }
    }

    LumpedSet set_;
    LumpedShape shape_;
    double energy_;
    std::optional<std::size_t> pulsed_;  ///< the live type in which motions differ on a curve
};

}  // namespace

std::unique_ptr<ConeSection> sectionOfCone(const Schedule& schedule, double energyRatio)
{
    auto set = isCone(schedule.stops) ? reachableSet(schedule) : std::nullopt;
    return set ? std::make_unique<Cone>(std::move(*set), energyRatio) : nullptr;
}

}  // namespace signorini
