#include <algorithm>
#include <cmath>

#include "echo.hpp"
#include "energy_section.hpp"
#include "rational.hpp"
#include "signorini/amplitude_set.hpp"

namespace signorini {

namespace {

/// rho = sum z^2/S^2 = E win^2/(2 w N), exactly.
Rational ratioOf(const OnePhaseSet& whole, double energyRatio)
{
    const Rational windowSum = whole.windowSum;
    return Rational(energyRatio) * windowSum * windowSum /
           (2 * Rational(whole.window) * Rational(whole.schedule.cells));
}

/// n over k, or empty if it does not fit.
std::optional<std::int64_t> binomial(std::int64_t n, std::int64_t k)
{
    if (k < 0 || k > n) {
        return 0;
    }
    Integer result = 1;
    k = std::min(k, n - k);
    for (std::int64_t i = 1; i <= k; ++i) {
        result = result * (n - k + i) / i;
        if (result > Integer(1) << 62) {
            return std::nullopt;
        }
    }
    return static_cast<std::int64_t>(result);
}

/// The vertices of a box -N <= Z_j <= 0 at one energy. Z jumps between its bounds in an odd number
/// of places: Q/S^2 is that number, and z alternates between S and -S there. Moving a jump to the
/// next place keeps the number, and halfway Q/S^2 is less by 1/2; two jumps may appear or vanish
/// side by side.
struct BoxVertices {
    std::int64_t places;  ///< d
    std::int64_t least;   ///< least odd number of jumps >= rho
    bool slides;          ///< may vertices with the least number move a jump?

    BoxVertices(const OnePhaseSet& whole, double energyRatio) : places(whole.set.count)
    {
        const Rational rho = ratioOf(whole, energyRatio);
        least = 1;
        while (rho > least && least + 2 <= places) {
            least += 2;
        }
        slides = rho <= least - Rational(1, 2);
    }

    /// Places without a jump in vertices of the least number. A vertex that cannot slide gets away
    /// only by two more jumps side by side.
    [[nodiscard]] std::int64_t holes() const { return places - least; }

    [[nodiscard]] bool isStuck(const std::vector<bool>& jumps) const
    {
        if (slides || std::count(jumps.begin(), jumps.end(), true) != least) {
            return false;
        }
        for (std::size_t j = 0; j + 1 < jumps.size(); ++j) {
            if (!jumps[j] && !jumps[j + 1]) {
                return false;
            }
        }
        return true;
    }

    [[nodiscard]] Connectivity connectivity() const
    {
        if (slides || holes() == 0) {
            return {};
        }
        // At most one hole in each of the least + 1 gaps around the jumps; the others hang
        // together.
        std::optional<std::int64_t> components = binomial(least + 1, holes());
        if (components && holes() > 1) {
            ++*components;
        }
        return {components == 1, components};
    }
};

/// Raises each partial sum, given in shares, to the bound towards which Q does not fall.
std::vector<bool> jumpsAbove(const std::vector<double>& shares)
{
    const std::size_t count = shares.size();
    std::vector<double> sums(count + 1, 0.0);
    for (std::size_t j = 0; j < count; ++j) {
        sums[j + 1] = sums[j] + shares[j];
    }
    sums[count] = 1.0;
    std::vector<bool> jumps(count);
    for (std::size_t j = 1; j <= count; ++j) {
        if (j < count) {
            sums[j] = 2.0 * sums[j] >= sums[j - 1] + sums[j + 1] ? 1.0 : 0.0;
        }
        jumps[j - 1] = sums[j] != sums[j - 1];
    }
    return jumps;
}

class OnePhase final : public EnergySection {
public:
    OnePhase(OnePhaseSet whole, double energyRatio) : whole_(std::move(whole)), energy_(energyRatio)
    {
        const AmplitudeSet& set = whole_.set;
        facts_.range = energyRange(whole_);
        if (!(energy_ >= facts_.range.least && energy_ <= facts_.range.most)) {
            facts_.components = 0;
            return;
        }
        const Connectivity connectivity = connectivityOf(whole_, energy_);
        facts_.isConnected = connectivity.isConnected;
        facts_.components = connectivity.components;
        const bool isEnd = energy_ == facts_.range.least || energy_ == facts_.range.most;
        facts_.dimension = isEnd ? 0 : set.count - 2;
        facts_.isFinite = isEnd || set.count <= 2;

        const auto count = static_cast<double>(set.count);
        const double ratio = static_cast<double>(ratioOf(whole_, energy_));
        const double spread = std::sqrt(std::max(0.0, (count - 1.0) * (count * ratio - 1.0)));
        const double size = std::abs(set.sum);
        facts_.largestWave = size * std::min(1.0, (1.0 + spread) / count);
        facts_.isWhole = set.kind != SetKind::box || set.count <= 2;
        facts_.simplex = SphereSection{set.count, ratio};
        facts_.unit = size * std::sqrt(energyOf(1.0, whole_.cells, whole_.window));
    }

    [[nodiscard]] std::optional<bool> joins(const State& from, const State& to) const override
    {
        if (facts_.isConnected == true) {
            return true;
        }
        const std::vector<double> start = sharesOf(from);
        const std::vector<double> end = sharesOf(to);
        if (facts_.isWhole) {
            return dominant(start) == dominant(end);
        }
        const BoxVertices vertices(whole_, energy_);
        const std::vector<bool> first = jumpsAbove(start);
        const std::vector<bool> last = jumpsAbove(end);
        return first == last || (!vertices.isStuck(first) && !vertices.isStuck(last));
    }

    [[nodiscard]] std::vector<State> isolated(std::int64_t most) const override
    {
        std::vector<State> motions;
        if (facts_.components == 1) {
            motions.push_back(signorini::motionOf(whole_, energy_ == facts_.range.least
                                                              ? leastAmplitudes(whole_.set)
                                                              : mostAmplitudes(whole_.set)));
            return motions;
        }
        for (std::int64_t j = 0; j < std::min(most, whole_.set.count); ++j) {
            motions.push_back(motionOf(isolatedShares(j)));
        }
        return motions;
    }

    [[nodiscard]] std::vector<double> sharesOf(const State& state) const override
    {
        std::vector<double> shares = amplitudesOf(whole_, state);
        for (double& value : shares) {
            value /= whole_.set.sum;
        }
        return shares;
    }

    [[nodiscard]] State motionOf(const std::vector<double>& shares) const override
    {
        std::vector<double> z = shares;
        for (double& value : z) {
            value *= whole_.set.sum;
        }
        return signorini::motionOf(whole_, z);
    }

    [[nodiscard]] AmplitudeSet sampled() const override
    {
        AmplitudeSet set = whole_.set;
        set.lower = whole_.set.upper / set.sum;
        set.upper = whole_.set.lower / set.sum;
        set.sum = 1.0;
        return set;
    }

private:
    /// One motion of most energy, or of the two of a pair, for each j = 0..d-1: a vertex of the
    /// simplex, or the vertex of a box with a jump everywhere but at j.
    [[nodiscard]] std::vector<double> isolatedShares(std::int64_t j) const
    {
        const std::int64_t count = whole_.set.count;
        std::vector<double> shares(static_cast<std::size_t>(count), 0.0);
        if (count == 2) {
            const double ratio = std::clamp(facts_.simplex->ratio, 0.5, 1.0);
            const double swing = std::sqrt(2.0 * ratio - 1.0);
            shares = {0.5 * (1.0 + swing), 0.5 * (1.0 - swing)};
            if (j == 1) {
                std::reverse(shares.begin(), shares.end());
            }
        } else if (facts_.isWhole) {
            shares[static_cast<std::size_t>(j)] = 1.0;
        } else {
            double sign = 1.0;
            for (std::int64_t k = 0; k < count; ++k) {
                shares[static_cast<std::size_t>(k)] = k == j ? 0.0 : sign;
                sign = k == j ? sign : -sign;
            }
        }
        return shares;
    }

    OnePhaseSet whole_;
    double energy_;
};

}  // namespace

Connectivity connectivityOf(const OnePhaseSet& whole, double energyRatio)
{
    if (energyRatio <= energyRange(whole).least || whole.set.count == 1) {
        return {};
    }
    if (whole.set.kind == SetKind::box && whole.set.count > 2) {
        return BoxVertices(whole, energyRatio).connectivity();
    }
    const bool isOne = ratioOf(whole, energyRatio) <= Rational(1, 2);
    return {isOne, isOne ? 1 : whole.set.count};
}

std::unique_ptr<EnergySection> sectionOfOnePhase(const Schedule& schedule, double energyRatio)
{
    OnePhaseSet whole = onePhaseSet(schedule);
    if (whole.reason) {
        return nullptr;
    }
    return std::make_unique<OnePhase>(std::move(whole), energyRatio);
}

}  // namespace signorini
