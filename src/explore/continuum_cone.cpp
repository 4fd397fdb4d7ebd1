// Curves and members without a gap: great circles of a cone.

#include <algorithm>
#include <cmath>
#include <random>

#include "continuum_geometric.hpp"
#include "continuum_record.hpp"
#include "faults.hpp"

namespace signorini {

namespace {

/// The arc of the great circle from one state to another of the same energy: a mean of both with
/// weights >= 0, so it stays in a convex cone.
class Arc {
public:
    Arc(const State& from, const State& to) : from_(from), to_(to)
    {
        const double radius = std::sqrt(energyRatio(from_));
        const double chord = energyDistance(to_, from_);
        angle_ = 2.0 * std::asin(std::min(1.0, 0.5 * chord / radius));
        length_ = radius * angle_;
    }

    /// In the norm of the energy.
    [[nodiscard]] double length() const { return length_; }

    /// 0 <= s <= 1.
    [[nodiscard]] State at(double s) const
    {
        const double whole = std::sin(angle_);
        if (whole == 0.0) {
            return from_;
        }
        const double first = std::sin((1.0 - s) * angle_) / whole;
        const double last = std::sin(s * angle_) / whole;
        return {first * from_.a + last * to_.a, first * from_.b + last * to_.b};
    }

private:
    const State& from_;
    const State& to_;
    double angle_;
    double length_;
};

struct ConeTrace {
    ContinuumRecord& record;
    const ConeSection& section;

    void operator()(const trace::SplitPulse&) const
    {
        if (section.facts().simplex) {
            splitPulse(record, section);
        } else {
            operator()(trace::RandomPath{});
        }
    }

    void operator()(const trace::Path& path) const
    {
        alongArc(path.from, path.to, "great circle between two given motions");
    }

    void operator()(const trace::RandomPath& path) const
    {
        std::mt19937_64 generator(path.seed);
        const State from = section.draw(generator);
        alongArc(from, section.draw(generator), "great circle between two random members");
    }

    void operator()(const trace::Sample& sample) const
    {
        std::mt19937_64 generator(sample.seed);
        record.result.parameter = Parameter::number;
        record.result.family = "members drawn at random";
        for (std::int64_t k = 1; k <= record.options.points; ++k) {
            if (record.isCancelled() ||
                !record.keep(static_cast<double>(k), section.draw(generator))) {
                return;
            }
        }
        record.finish();
    }

    void operator()(const trace::Walk&) const
    {
        throw std::invalid_argument(
            "direction: allowed only with a gap; without one give both ends, as the great circle "
            "between two motions stays in their cone");
    }

private:
    void alongArc(const State& from, const State& to, const char* family) const
    {
        const Arc arc(from, to);
        record.result.family = family;
        for (std::int64_t k = 0; k < record.options.points; ++k) {
            const double s =
                static_cast<double>(k) / static_cast<double>(record.options.points - 1);
            if (record.isCancelled() || !record.keep(s * arc.length(), arc.at(s))) {
                return;
            }
        }
        record.finish();
    }
};

}  // namespace

void traceInCone(ContinuumRecord& record, const ConeSection& section)
{
    std::visit(ConeTrace{record, section}, record.options.trace);
}

}  // namespace signorini
