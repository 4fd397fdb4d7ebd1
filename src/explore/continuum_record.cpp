#include "continuum_record.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <string_view>
#include <unordered_map>

#include "faults.hpp"

namespace signorini {

namespace {

/// Of the bits: equal states have equal ones.
std::size_t hashOf(const State& state)
{
    const auto hash = [](const Eigen::VectorXd& wave) {
        return std::hash<std::string_view>{}(
            {reinterpret_cast<const char*>(wave.data()),
             static_cast<std::size_t>(wave.size()) * sizeof(double)});
    };
    return hash(state.a) ^ (hash(state.b) << 1U);
}

}  // namespace

double energyDistance(const State& first, const State& second)
{
    return std::sqrt(energyRatio({first.a - second.a, first.b - second.b}));
}

ContinuumRecord::ContinuumRecord(const Schedule& schedule, double energyRatio,
                                 const ContinuumOptions& given)
    : options(given)
{
    demands.strainLimit = options.strainLimit / scales(options.scene.bar).strain;
    demands.energyRatio = energyRatio;
    validate(demands, schedule);
    result.schedule = schedule;
    result.scene = options.scene;
    result.energyRatio = energyRatio;
    result.detail.clear();
}

double ContinuumRecord::peakStrainOf(const State& state) const
{
    return extremesOf(state, result.schedule).peakCompression * scales(options.scene.bar).strain;
}

const State* ContinuumRecord::from() const
{
    if (const auto* path = std::get_if<trace::Path>(&options.trace)) {
        return &path->from;
    }
    const auto* walk = std::get_if<trace::Walk>(&options.trace);
    return walk != nullptr ? &walk->from : nullptr;
}

const State* ContinuumRecord::to() const
{
    const auto* path = std::get_if<trace::Path>(&options.trace);
    return path != nullptr ? &path->to : nullptr;
}

void ContinuumRecord::requireMotion(const char* field, const State* state) const
{
    if (state == nullptr) {
        return;
    }
    const double residual =
        state->cells() == result.schedule.cells && state->b.size() == state->a.size()
            ? verify(*state, result.schedule, options.tolerance).residuals.worst()
            : std::numeric_limits<double>::infinity();
    if (!(residual <= options.tolerance)) {
        throw std::invalid_argument(
            fmt::format("{} = a state with residual {:.3g} is out of range: allowed motions of "
                        "{}, residual at most {:.3g}",
                        field, residual, describe(result.schedule), options.tolerance));
    }
    if (!(violation(demands, *state, result.schedule) <= options.tolerance)) {
        throw std::invalid_argument(
            fmt::format("{} = a motion with E/E_1 = {}, peak strain {} is out of range: "
                        "allowed E/E_1 = {}, peak strain at most {}",
                        field, signorini::energyRatio(*state), peakStrainOf(*state), energy(),
                        options.strainLimit));
    }
}

bool ContinuumRecord::keep(double lambda, State state)
{
    const std::size_t number = result.points.size() + 1;
    Residuals residuals = verify(state, result.schedule, options.tolerance).residuals;
    residuals.demands = violation(demands, state, result.schedule);
    if (!(residuals.worst() <= options.tolerance)) {
        stop(
            fmt::format("point {} at lambda = {} has a residual of {:.3g}, more than the "
                        "tolerance {:.3g}",
                        number, lambda, residuals.worst(), options.tolerance));
        return false;
    }
    result.points.push_back({lambda, std::move(state), 0.0, residuals.worst(), 0.0});
    ContinuumPoint& point = result.points.back();
    point.energyRatio = signorini::energyRatio(point.state);
    point.peakStrain = peakStrainOf(point.state);
    if (options.progress) {
        options.progress(static_cast<double>(number), static_cast<double>(options.points));
    }
    return true;
}

bool ContinuumRecord::keepNext(State state)
{
    const double step =
        result.points.empty() ? 0.0 : energyDistance(result.points.back().state, state);
    const double reached = result.points.empty() ? 0.0 : result.points.back().lambda;
    return keep(reached + step, std::move(state));
}

bool ContinuumRecord::isCancelled()
{
    if (!isRequested(options.cancel)) {
        return false;
    }
    stop(fmt::format("interrupted after {} of {} points", result.points.size(), options.points));
    return true;
}

void ContinuumRecord::stop(std::string why)
{
    result.status = Status::undecided;
    result.detail = std::move(why);
}

void ContinuumRecord::finish(std::string detail)
{
    result.status = Status::found;
    result.detail = std::move(detail);
    if (result.parameter == Parameter::number || result.points.size() < 2) {
        return;
    }
    double largest = 0.0;
    for (std::size_t k = 1; k < result.points.size(); ++k) {
        largest =
            std::max(largest, energyDistance(result.points[k - 1].state, result.points[k].state));
    }
    result.resolution = largest / std::sqrt(energy());
}

std::int64_t countOrbits(const Continuum& curve)
{
    std::unordered_multimap<std::size_t, const State*> seen;
    for (const ContinuumPoint& point : curve.points) {
        const std::size_t hash = hashOf(orbitRepresentative(point.state, curve.schedule));
        const auto [first, last] = seen.equal_range(hash);
        if (std::none_of(first, last, [&](const auto& other) {
                return isSameOrbit(point.state, *other.second, curve.schedule);
            })) {
            seen.emplace(hash, &point.state);
        }
    }
    return static_cast<std::int64_t>(seen.size());
}

}  // namespace signorini
