#include "limited_energy.hpp"

#include <algorithm>
#include <cmath>

#include "capped_amplitudes.hpp"
#include "echo.hpp"
#include "infinity.hpp"
#include "known_motions.hpp"
#include "section_numbers.hpp"

namespace signorini {

namespace {

constexpr std::size_t mostPlaces = 2000;  // S at which spikes are tried where sums vary

/// Several types of classes, whose sums are a polyhedron with known vertices.
class LimitedSums {
public:
    LimitedSums(const LumpedSet& set, const LumpedShape& shape, double cap)
        : set_(set), shape_(shape), cap_(cap)
    {
    }

    [[nodiscard]] std::optional<LimitedEnergy> run() const
    {
        const auto& vertices = shape_.spanning.size() == 1 ? shape_.spanning : shape_.vertices;
        if (vertices.empty() || !shape_.isBounded) {
            return std::nullopt;
        }
        LimitedEnergy result;
        double most = -1.0;
        const auto look = [&](const std::vector<double>& sums) {
            if (const auto z = spikes(sums); z && squaresOf(*z) > most) {
                most = squaresOf(*z);
                result.motion = motionOf(set_.classes, *z);
            }
        };
        double bound = 0.0;
        for (const std::vector<double>& vertex : vertices) {
            look(vertex);
            bound = std::max(bound, boundAt(vertex));
        }
        const bool isFixed = vertices.size() == 1;
        if (!isFixed) {
            for (const std::vector<double>& sums : places(vertices)) {
                look(sums);
            }
        }
        result.most = inEnergy(isFixed && most >= 0.0 ? most : bound);
        return result;
    }

private:
    /// A class whose waves only come with the sign -1 makes no compression.
    [[nodiscard]] double capOf(std::size_t live) const
    {
        const auto& signs = set_.type(live).signs;
        if (std::find(signs.begin(), signs.end(), 1) == signs.end()) {
            return infinity;
        }
        return cap_;
    }

    [[nodiscard]] double inEnergy(double squares) const
    {
        return energyOf(squares, set_.classes.schedule.cells, set_.classes.window);
    }

    /// sum z^2 <= max |z| sum |z|.
    [[nodiscard]] double boundAt(const std::vector<double>& sums) const
    {
        double bound = 0.0;
        for (std::size_t t = 0; t < sums.size(); ++t) {
            const double size =
                std::min(capOf(t), set_.type(t).kind == TypeKind::pressing ? sums[t] : capOf(t));
            bound += set_.type(t).kind == TypeKind::pressing
                         ? size * sums[t]
                         : static_cast<double>(set_.type(t).count) * size * size;
        }
        return bound;
    }

    /// The amplitudes of most squares for these sums; empty if the limit leaves none.
    [[nodiscard]] std::optional<std::vector<double>> spikes(const std::vector<double>& sums) const
    {
        std::vector<double> z(static_cast<std::size_t>(set_.classes.classes), 0.0);
        for (std::size_t t = 0; t < sums.size(); ++t) {
            const AmplitudeSet own = amplitudesAt(set_, sums, t);
            const auto part = mostAmplitudesBelow(own, capOf(t));
            if (!part) {
                return std::nullopt;
            }
            std::copy(part->begin(), part->end(),
                      z.begin() + static_cast<std::ptrdiff_t>(set_.type(t).first));
        }
        return z;
    }

    /// Where a pressing sum becomes a multiple of the cap, on the ways between vertices: there the
    /// slope of the most squares changes.
    [[nodiscard]] std::vector<std::vector<double>> places(
        const std::vector<std::vector<double>>& vertices) const
    {
        std::vector<std::vector<double>> all;
        for (std::size_t i = 0; i < vertices.size(); ++i) {
            for (std::size_t k = 0; k < i; ++k) {
                for (std::size_t t = 0; t < vertices[i].size(); ++t) {
                    const double from = vertices[k][t];
                    const double to = vertices[i][t];
                    const double cap = capOf(t);
                    for (double sum = cap * std::ceil(std::min(from, to) / cap);
                         from != to && sum <= std::max(from, to) && all.size() < mostPlaces;
                         sum += cap) {
                        std::vector<double> place(vertices[i].size());
                        for (std::size_t j = 0; j < place.size(); ++j) {
                            place[j] = std::lerp(vertices[k][j], vertices[i][j],
                                                 (sum - from) / (to - from));
                        }
                        all.push_back(std::move(place));
                    }
                }
            }
        }
        return all;
    }

    const LumpedSet& set_;
    const LumpedShape& shape_;
    double cap_;
};

/// All amplitudes beyond their mean are bounded by max |z| sum |z|, whether there are any or not.
double boundOf(const AmplitudeSet& set, double cap)
{
    return set.kind == SetKind::box ? cap * cap * static_cast<double>(set.count) : cap * set.sum;
}

}  // namespace

std::optional<LimitedEnergy> energyWithin(const Known& known, double strainLimit)
{
    const double cap = 0.5 * strainLimit;
    if (known.sums && !known.sums->absence) {
        return LimitedSums(*known.sums, known.shape, cap).run();
    }
    if (!known.onePhase || known.onePhase->reason || known.onePhase->set.kind == SetKind::cone) {
        return std::nullopt;
    }
    const OnePhaseSet& whole = *known.onePhase;
    LimitedEnergy result;
    double squares = boundOf(whole.set, cap);
    if (const auto z = mostAmplitudesBelow(whole.set, cap)) {
        squares = squaresOf(*z);
        result.motion = motionOf(whole, *z);
    }
    result.most = energyOf(squares, whole.schedule.cells, whole.window);
    return result;
}

std::optional<State> motionWithin(const Known& known, double strainLimit, double energyRatio)
{
    const auto within = energyWithin(known, strainLimit);
    if (!within || !within->motion) {
        return std::nullopt;
    }
    State equal;
    if (known.onePhase) {
        equal = leastEnergyMotion(*known.onePhase);
    } else {
        // Equal amplitudes of the same sums keep the limit, too.
        const std::vector<double> z = amplitudesOf(known.sums->classes, *within->motion);
        std::vector<double> sums;
        for (const std::size_t t : known.sums->live) {
            const ClassType& type = known.sums->classes.types[t];
            double sum = 0.0;
            for (std::int64_t j = 0; j < type.count; ++j) {
                sum += z[static_cast<std::size_t>(type.first + j)];
            }
            sums.push_back(sum);
        }
        equal = equalMotion(*known.sums, sums);
    }
    return motionOfEnergy(equal, *within->motion, energyRatio);
}

}  // namespace signorini
