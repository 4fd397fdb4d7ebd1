// Members drawn by hit-and-run against members drawn from the whole sphere, those outside refused.

#include <cmath>
#include <random>
#include <vector>

#include "catch.hpp"
#include "sphere_section.hpp"

using namespace signorini;

namespace {

/// Evenly from the sphere of given sum and sum of squares.
std::vector<double> drawFromSphere(std::mt19937_64& generator, const AmplitudeSet& set,
                                   double squares)
{
    std::normal_distribution<double> normal;
    std::vector<double> z(static_cast<std::size_t>(set.count));
    double sum = 0.0;
    for (double& value : z) {
        value = normal(generator);
        sum += value;
    }
    const auto count = static_cast<double>(set.count);
    double length = 0.0;
    for (double& value : z) {
        value -= sum / count;
        length += value * value;
    }
    const double mean = set.sum / count;
    for (double& value : z) {
        value = mean + value * std::sqrt((squares - mean * set.sum) / length);
    }
    return z;
}

/// How often each amplitude and each partial sum falls into each of ten parts of [-2|S|, 2|S|].
class Histogram {
public:
    void add(const AmplitudeSet& set, const std::vector<double>& z)
    {
        const double width = 0.4 * std::abs(set.sum);
        double partial = 0.0;
        hits_.resize(20 * z.size());
        for (std::size_t j = 0; j < z.size(); ++j) {
            partial += z[j];
            const auto part = [width](double value) {
                return static_cast<std::size_t>(std::clamp(value / width + 5.0, 0.0, 9.0));
            };
            ++hits_[20 * j + part(z[j])];
            ++hits_[20 * j + 10 + part(partial)];
        }
        ++count_;
    }

    [[nodiscard]] int count() const { return count_; }

    /// The largest difference of two shares, in standard deviations.
    [[nodiscard]] double differenceFrom(const Histogram& other) const
    {
        double worst = 0.0;
        for (std::size_t k = 0; k < hits_.size(); ++k) {
            const double mine = static_cast<double>(hits_[k]) / count_;
            const double theirs = static_cast<double>(other.hits_[k]) / other.count_;
            const double both =
                static_cast<double>(hits_[k] + other.hits_[k]) / (count_ + other.count_);
            const double deviation = std::sqrt(std::max(both * (1.0 - both), 1e-4) *
                                               (1.0 / count_ + 1.0 / other.count_));
            worst = std::max(worst, std::abs(mine - theirs) / deviation);
        }
        return worst;
    }

private:
    std::vector<int> hits_;
    int count_ = 0;
};

}  // namespace

TEST_CASE("section sampler: even over the part of the sphere in a simplex or a box")
{
    const auto [set, share] = GENERATE(table<AmplitudeSet, double>({
        {{SetKind::simplex, 3, 1.0, 0.0, 0.0}, 0.2},
        {{SetKind::simplex, 3, 1.0, 0.0, 0.0}, 0.5},
        {{SetKind::simplex, 4, 2.0, 0.0, 0.0}, 0.3},
        {{SetKind::box, 3, -1.0, -1.0, 0.0}, 0.4},
        {{SetKind::box, 3, -1.0, -2.0, 0.5}, 0.3},
        {{SetKind::box, 3, 2.0, -1.5, 3.0}, 0.2},
        {{SetKind::box, 4, -1.0, -1.2, 0.2}, 0.3},
        {{SetKind::box, 5, -1.0, -0.9, 0.4}, 0.2},
    }));
    const double squares = std::lerp(leastSquares(set), mostSquares(set), share);
    SectionSampler sampler(set, squares, 5);
    Histogram walked;
    for (int k = 0; k < 4000; ++k) {
        const std::vector<double>& z = sampler.next(set.count == 3 ? 1 : 10);
        REQUIRE(distanceOutside(set, z) <= 1e-12);
        walked.add(set, z);
    }
    Histogram refused;
    std::mt19937_64 generator(6);
    for (int k = 0; k < 2'000'000 && refused.count() < 20000; ++k) {
        const std::vector<double> z = drawFromSphere(generator, set, squares);
        if (distanceOutside(set, z) <= 1e-12) {
            refused.add(set, z);
        }
    }
    CAPTURE(set.count, set.lower, set.upper, squares);
    REQUIRE(refused.count() > 2000);
    CHECK(walked.differenceFrom(refused) < 5.0);
}

TEST_CASE("section sampler: of two amplitudes it visits every member there is")
{
    // 1/3, 2/3 and the other way round; in the box that is not symmetric one of them alone.
    const AmplitudeSet symmetric{SetKind::box, 2, -1.0, -1.0, 0.0};
    const AmplitudeSet wider{SetKind::box, 2, -1.0, -1.5, 0.5};
    const AmplitudeSet oblique{SetKind::box, 2, -1.0, -1.0, 0.5};
    for (const AmplitudeSet& set : {symmetric, wider, oblique}) {
        const double squares = std::lerp(leastSquares(set), mostSquares(set), 0.5);
        const std::vector<double> first = SectionSampler(set, squares, 1).next(0);
        CHECK(first == amplitudesWithSquares(set, squares));
        SectionSampler sampler(set, squares, 1);
        bool isTurned = false;
        for (int k = 0; k < 50; ++k) {
            const std::vector<double> z = sampler.next(1);
            REQUIRE(distanceOutside(set, z) <= 1e-15);
            REQUIRE(z[0] * z[0] + z[1] * z[1] == Approx(squares));
            isTurned = isTurned || std::abs(z[0] - first[0]) > 0.1;
        }
        CHECK(isTurned == (set.lower + set.upper == set.sum));
    }
}
