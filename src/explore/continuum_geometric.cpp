#include "continuum_geometric.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "faults.hpp"
#include "stops.hpp"

namespace signorini {

namespace {

/// Members drawn evenly; one if there is only one.
void sampleMembers(ContinuumRecord& record, const EnergySection& section, std::uint64_t seed)
{
    const SectionFacts& facts = section.facts();
    SectionSampler sampler(section.sampled(), facts.simplex->ratio, seed);
    record.result.parameter = Parameter::number;
    record.result.family = "members drawn evenly";
    const bool isOne = facts.dimension == 0 && facts.components == 1;
    const std::int64_t points = isOne ? 1 : record.options.points;
    for (std::int64_t k = 1; k <= points; ++k) {
        if (record.isCancelled() ||
            !record.keep(static_cast<double>(k), section.motionOf(sampler.next()))) {
            return;
        }
    }
    record.finish();
}

/// From one end in a direction, for half a turn of the sphere about equal amplitudes.
void walk(ContinuumRecord& record, const EnergySection& section, const trace::Walk& asked)
{
    const SphereSection simplex = *section.facts().simplex;
    SlidingWalk walker(simplex, section.sharesOf(asked.from), section.sharesOf(asked.direction));
    const double radius =
        std::sqrt(std::max(0.0, simplex.ratio - 1.0 / static_cast<double>(simplex.count)));
    const double step = std::numbers::pi * radius / static_cast<double>(record.options.points - 1);
    record.result.family = "walk in a given direction";
    for (std::int64_t k = 0; k < record.options.points; ++k) {
        const std::vector<double>& shares = walker.advance(k == 0 ? 0.0 : step);
        const double lambda = static_cast<double>(k) * step * section.facts().unit;
        if (record.isCancelled() || !record.keep(lambda, section.motionOf(shares))) {
            return;
        }
        if (!walker.canMove()) {
            record.finish("the direction ends in a corner of the set");
            return;
        }
    }
    record.finish();
}

void tracePath(ContinuumRecord& record, const EnergySection& section,
               const std::vector<double>& from, const std::vector<double>& to, const char* family)
{
    const SectionPath path(*section.facts().simplex, from, to);
    const Spacing spacing = equalSpacing(path, record.options.points);
    record.result.family = family;
    for (std::size_t k = 0; k < spacing.lengths.size(); ++k) {
        if (record.isCancelled() ||
            !record.keep(section.facts().unit * spacing.lengths[k],
                         section.motionOf(path.at(spacing.parameters[k])))) {
            return;
        }
    }
    record.finish();
}

void joinRandomMembers(ContinuumRecord& record, const EnergySection& section, std::uint64_t seed)
{
    constexpr int moves = 200;
    const SphereSection simplex = *section.facts().simplex;
    SectionSampler sampler({.kind = SetKind::simplex, .count = simplex.count, .sum = 1.0},
                           simplex.ratio, seed);
    const std::vector<double> from = sampler.next(moves);
    const std::vector<double> to = sampler.next(moves);
    if (simplex.ratio > 0.5 && dominant(from) != dominant(to)) {
        record.result.status = Status::none;
        record.result.connected = false;
        record.result.detail = wordsForApart(section, from, to);
        return;
    }
    tracePath(record, section, from, to, "path between two random members");
}

/// What is to be said of the split pulse where it is not what its name says.
std::string remarkOn(const ContinuumRecord& record, const EnergySection& section)
{
    if (isCone(record.result.schedule.stops)) {
        return "without a gap the impulse is free: the curve holds that of pulses which together "
               "take half the contact";
    }
    if (section.facts().isShared) {
        return "every contact of the curve carries the same pulses, at two stops mirrored; a path "
               "between two motions leaves this family";
    }
    if (!section.facts().isWhole) {
        return "the pulses are those of the wave: where motions only graze, the wall feels no "
               "force";
    }
    if (section.facts().simplex->ratio > 0.5) {
        return "at this energy less than two cells carry force, so a pulse cannot be cut: the "
               "curve stays in the component with the large pulse first; a finer grid has more";
    }
    return "";
}

struct GeometricTrace {
    ContinuumRecord& record;
    const EnergySection& section;

    void operator()(const trace::SplitPulse&) const { splitPulse(record, section); }
    void operator()(const trace::Path& path) const
    {
        tracePath(record, section, section.sharesOf(path.from), section.sharesOf(path.to),
                  "path between two given motions");
    }
    void operator()(const trace::Walk& asked) const { walk(record, section, asked); }
    void operator()(const trace::RandomPath& path) const
    {
        joinRandomMembers(record, section, path.seed);
    }
    void operator()(const trace::Sample& sample) const
    {
        sampleMembers(record, section, sample.seed);
    }
};

}  // namespace

void splitPulse(ContinuumRecord& record, const EnergySection& section)
{
    const SphereSection simplex = *section.facts().simplex;
    record.result.parameter = Parameter::pause;
    record.result.family =
        simplex.ratio <= 0.5 ? "split pulse" : "pulse of one cell and a smaller one";
    const double longest =
        PulsePair(simplex).longestPause() / static_cast<double>(record.result.schedule.cells);
    for (std::int64_t k = 0; k < record.options.points; ++k) {
        const double share =
            static_cast<double>(k) / static_cast<double>(record.options.points - 1);
        if (record.isCancelled() || !keepSplitPulse(record, section, share * longest)) {
            return;
        }
    }
    record.finish(remarkOn(record, section));
}

std::string wordsForApart(const EnergySection& section, const std::vector<double>& from,
                          const std::vector<double>& to)
{
    return fmt::format(
        "the two motions lie in different components: at this energy one amplitude exceeds half of "
        "the sum, the {}. in one motion and the {}. in the other, and no curve of motions can "
        "exchange them ({} components)",
        dominant(from) + 1, dominant(to) + 1, section.facts().components.value_or(0));
}

bool keepSplitPulse(ContinuumRecord& record, const EnergySection& section, double pause)
{
    const PulsePair pulses(*section.facts().simplex);
    const double cells = pause * static_cast<double>(record.result.schedule.cells);
    return record.keep(pause, section.motionOf(pulses.at(cells)));
}

void traceGeometrically(ContinuumRecord& record, const EnergySection& section)
{
    std::visit(GeometricTrace{record, section}, record.options.trace);
}

void listIsolated(ContinuumRecord& record, const EnergySection& section)
{
    const ContinuumOptions& options = record.options;
    const auto* sample = std::get_if<trace::Sample>(&options.trace);
    record.result.parameter = Parameter::number;
    record.result.family = "isolated motions";
    if (const State* from = record.from()) {
        if (record.keep(1.0, *from)) {
            record.finish("the motion is isolated: no other one of this energy is near it");
        }
        return;
    }
    // A strain limit may exclude some: then all must be seen.
    const bool isLimited = std::isfinite(record.demands.strainLimit);
    const std::int64_t most = isLimited || sample != nullptr ? maxContinuumPoints : options.points;
    std::vector<State> motions = section.isolated(most);
    if (isLimited) {
        std::erase_if(motions, [&record](const State& motion) {
            return violation(record.demands, motion, record.result.schedule) >
                   record.options.tolerance;
        });
        const auto left = static_cast<std::int64_t>(motions.size());
        record.result.components = left;
        record.result.connected = left == 1;
    }
    if (motions.empty()) {
        record.result.status = Status::none;
        record.result.connected.reset();
        record.result.reason = Reason::constraints;
        record.result.detail = fmt::format("all motions with E/E_1 = {} exceed the strain limit {}",
                                           record.energy(), options.strainLimit);
        return;
    }
    if (sample != nullptr && motions.size() > 1) {
        std::mt19937_64 generator(sample->seed);
        std::uniform_int_distribution<std::size_t> draw(0, motions.size() - 1);
        for (std::int64_t k = 1; k <= options.points; ++k) {
            if (!record.keep(static_cast<double>(k), motions[draw(generator)])) {
                return;
            }
        }
    } else {
        const auto number =
            std::min<std::size_t>(motions.size(), static_cast<std::size_t>(options.points));
        for (std::size_t k = 0; k < number; ++k) {
            if (!record.keep(static_cast<double>(k + 1), std::move(motions[k]))) {
                return;
            }
        }
    }
    record.finish(record.result.components == 1
                      ? ""
                      : "finitely many motions have this energy, and no curve joins two of them");
}

}  // namespace signorini
