#include "signorini/certificate.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <set>
#include <utility>

#include "catch.hpp"
#include "equations.hpp"
#include "integers.hpp"
#include "signorini/one_phase_set.hpp"
#include "signorini/verification.hpp"
#include "support.hpp"

using namespace signorini;
using test::onePhase;

namespace {

/// The combination of the paper's own sparse rows, added up in doubles that hold the integers
/// exactly: an independent reading of certificate.hpp.
bool holdsOverThePapersRows(const FarkasCertificate& certificate, const Schedule& schedule)
{
    const Eigen::Index size = 2 * schedule.cells;
    SparseMatrix periodicity = periodMap(schedule);
    SparseMatrix one(size, size);
    one.setIdentity();
    periodicity -= one;
    const Inequalities rows = inequalities(schedule);
    Eigen::VectorXd total =
        static_cast<double>(certificate.gap) * gapRow(schedule.cells).transpose().toDense();
    const auto add = [&](const SparseMatrix& matrix, const std::vector<Multiplier>& multipliers,
                         bool isInequality) {
        for (const Multiplier& m : multipliers) {
            REQUIRE(m.row < matrix.rows());
            REQUIRE((!isInequality || m.value >= 0));
            total += static_cast<double>(m.value) *
                     Eigen::VectorXd(matrix.row(static_cast<Eigen::Index>(m.row)).transpose());
        }
    };
    add(periodicity, certificate.periodicity, false);
    add(rows.pressure, certificate.pressure, true);
    add(rows.penetration, certificate.penetration, true);
    return certificate.gap < 0 && total.isZero(0.0);
}

}  // namespace

TEST_CASE("certificate: every absence up to N = 6 is proved over the paper's own rows")
{
    std::set<Reason> seen;
    test::forAllSchedules(6, 3, [&](const Schedule& schedule) {
        const OnePhaseSet r = onePhaseSet(schedule);
        if (!r.reason) {
            return;
        }
        seen.insert(*r.reason);
        const FarkasCertificate certificate = proveAbsence(r);
        INFO(describe(schedule));
        REQUIRE(isProof(certificate, schedule));
        REQUIRE(holdsOverThePapersRows(certificate, schedule));
    });
    CHECK(seen ==
          std::set{Reason::noLiveClass, Reason::contactSign, Reason::penetration, Reason::gap});
}

TEST_CASE("certificate: the proof over the folded schedule holds for the long one")
{
    for (std::int64_t free = 17; free < 60; ++free) {
        const Schedule schedule = onePhase(2, 9, free);
        const OnePhaseSet r = onePhaseSet(schedule);
        if (r.reason) {
            INFO(describe(schedule));
            CHECK(isProof(proveAbsence(r), schedule));
            CHECK(holdsOverThePapersRows(proveAbsence(r), schedule));
        }
    }
    const Schedule huge = onePhase(1, 1'000'000'000'000, 1'000'000'000'000'000);
    CHECK(isProof(proveAbsence(onePhaseSet(huge)), huge));
}

TEST_CASE("certificate: large schedules are proved too")
{
    for (const Schedule& schedule : {onePhase(300, 150, 1200), onePhase(10'000, 5'000, 40'000),
                                     onePhase(99'991, 1'000, 300'007)}) {
        const OnePhaseSet r = onePhaseSet(schedule);
        INFO(describe(schedule));
        REQUIRE(r.reason);
        CHECK(isProof(proveAbsence(r), schedule));
    }
}

TEST_CASE("certificate: what is no proof is not accepted")
{
    const Schedule none = onePhase(10, 23, 42);
    const OnePhaseSet r = onePhaseSet(none);
    REQUIRE(r.reason);
    const FarkasCertificate proof = proveAbsence(r);
    REQUIRE(isProof(proof, none));

    SECTION("a wrong sign of the gap row")
    {
        FarkasCertificate wrong = proof;
        wrong.gap = -wrong.gap;
        CHECK_FALSE(isProof(wrong, none));
        wrong.gap = 0;
        CHECK_FALSE(isProof(wrong, none));
    }
    SECTION("any multiplier changed by one")
    {
        for (std::size_t k = 0; k < proof.periodicity.size(); ++k) {
            FarkasCertificate wrong = proof;
            wrong.periodicity[k].value += 1;
            CHECK_FALSE(isProof(wrong, none));
        }
    }
    SECTION("every multiplier times 2^40: a proof still, and none with one changed")
    {
        FarkasCertificate large = proof;
        const std::int64_t factor = std::int64_t{1} << 40;
        large.gap *= factor;
        large.size *= factor;
        for (auto* rows : {&large.periodicity, &large.pressure, &large.penetration}) {
            for (Multiplier& m : *rows) {
                m.value *= factor;
            }
        }
        CHECK(isProof(large, none));
        for (Multiplier& m : large.periodicity) {
            // By 2^32, too, which 32 bits do not see.
            for (const std::int64_t change : {std::int64_t{1}, std::int64_t{1} << 32}) {
                m.value += change;
                CHECK_FALSE(isProof(large, none));
                m.value -= change;
            }
        }
    }
    SECTION("negative multipliers of inequalities, rows out of range or out of order")
    {
        FarkasCertificate wrong = proof;
        wrong.pressure = {{0, -1}};
        CHECK_FALSE(isProof(wrong, none));
        wrong.pressure = {{23, 1}};
        CHECK_FALSE(isProof(wrong, none));
        wrong = proof;
        wrong.penetration = {{-1, 1}};
        CHECK_FALSE(isProof(wrong, none));
        wrong = proof;
        wrong.periodicity.push_back({0, 1});
        CHECK_FALSE(isProof(wrong, none));
        wrong = proof;
        std::swap(wrong.periodicity.front(), wrong.periodicity.back());
        CHECK_FALSE(isProof(wrong, none));
    }
    SECTION("multipliers that overflow")
    {
        FarkasCertificate wrong = proof;
        constexpr std::int64_t most = std::numeric_limits<std::int64_t>::max();
        wrong.periodicity = {{0, most}, {1, most}, {2, most}, {3, most}};
        wrong.gap = -most;
        CHECK_FALSE(isProof(wrong, none));
    }
    SECTION("the proof of another schedule")
    {
        CHECK_FALSE(isProof(proof, onePhase(10, 23, 43)));
        CHECK_FALSE(isProof(proof, onePhase(10, 9, 22)));
    }
}

TEST_CASE("certificate: of two phases, just those that the paper's own rows add up to are accepted")
{
    std::mt19937_64 generator(7);
    std::uniform_int_distribution<std::int64_t> small(0, 2);
    std::uniform_int_distribution<std::int64_t> steps(1, 6);
    int proofs = 0;
    int ofSecondFlight = 0;
    for (int trial = 0; trial < 300; ++trial) {
        Schedule schedule;
        schedule.cells = 1;
        schedule.phases = {{small(generator) + 1, steps(generator)},
                           {small(generator) + 1, steps(generator)}};
        Eigen::MatrixXd periodicity = periodMap(schedule).toDense();
        periodicity -= Eigen::MatrixXd::Identity(2, 2);
        const Inequalities rows = inequalities(schedule);
        const Eigen::MatrixXd pressure = rows.pressure.toDense();
        const Eigen::MatrixXd penetration = rows.penetration.toDense();
        const Eigen::VectorXd gap = gapRow(1).toDense().transpose();
        for (int k = 0; k < 200; ++k) {
            FarkasCertificate certificate{};
            certificate.gap = -1;
            Eigen::VectorXd total = -gap;
            const auto draw = [&](const Eigen::MatrixXd& matrix, std::int64_t shift) {
                std::vector<Multiplier> multipliers;
                for (Eigen::Index row = 0; row < matrix.rows(); ++row) {
                    const std::int64_t value = small(generator) * small(generator) / 2 - shift;
                    if (value != 0 || row == 0) {  // a zero is a multiplier, too
                        multipliers.push_back({row, value});
                        total += static_cast<double>(value) * matrix.row(row).transpose();
                    }
                }
                return multipliers;
            };
            certificate.periodicity = draw(periodicity, small(generator));
            certificate.pressure = draw(pressure, 0);
            certificate.penetration = draw(penetration, 0);
            const bool isTrue = total.isZero(0.0);
            CAPTURE(describe(schedule), k);
            REQUIRE(isProof(certificate, schedule) == isTrue);
            if (isTrue) {
                ++proofs;
                ofSecondFlight +=
                    !certificate.penetration.empty() &&
                            certificate.penetration.back().row >= schedule.phases.front().free
                        ? 1
                        : 0;
                FarkasCertificate wrong = certificate;
                wrong.pressure.push_back({pressure.rows(), 1});
                REQUIRE_FALSE(isProof(wrong, schedule));
                wrong = certificate;
                wrong.penetration.push_back({penetration.rows(), 1});
                REQUIRE_FALSE(isProof(wrong, schedule));
            }
        }
    }
    CHECK(proofs > 100);
    CHECK(ofSecondFlight > 50);
}

TEST_CASE("certificate: where only rest comes back, any rows of any phase are part of a proof")
{
    // W - 1 is regular there: whatever pushes and depths add up to, some y of (30) cancels it.
    std::mt19937_64 generator(8);
    const auto upTo = [&generator](std::int64_t most) {
        return std::uniform_int_distribution<std::int64_t>(1, most)(generator);
    };
    int proofs = 0;
    for (int trial = 0; trial < 400; ++trial) {
        Schedule schedule{upTo(5), {}};
        for (std::int64_t phases = 1 + upTo(2); phases > 0; --phases) {
            schedule.phases.push_back({upTo(7), upTo(12)});
        }
        const Eigen::Index size = 2 * schedule.cells;
        const Eigen::MatrixXd change =
            periodMap(schedule).toDense() - Eigen::MatrixXd::Identity(size, size);
        // Every cycle of waves makes a factor 1 - 1 or 1 + 1.
        const double factor = std::round(std::abs(change.determinant()));
        if (factor == 0.0) {
            continue;
        }
        ++proofs;
        FarkasCertificate certificate{};
        certificate.gap = -static_cast<std::int64_t>(factor);
        Eigen::VectorXd total = -factor * gapRow(schedule.cells).toDense().transpose();
        const auto draw = [&](const SparseMatrix& matrix) {
            std::vector<Multiplier> multipliers;
            for (Eigen::Index row = 0; row < matrix.rows(); ++row) {
                const auto value = static_cast<std::int64_t>(factor) * (upTo(3) - 1);
                multipliers.push_back({row, value});
                total += static_cast<double>(value) * Eigen::VectorXd(matrix.row(row).transpose());
            }
            return multipliers;
        };
        const Inequalities rows = inequalities(schedule);
        certificate.pressure = draw(rows.pressure);
        certificate.penetration = draw(rows.penetration);
        const Eigen::VectorXd y = change.transpose().fullPivLu().solve(-total);
        for (Eigen::Index row = 0; row < size; ++row) {
            certificate.periodicity.push_back({row, std::llround(y[row])});
        }
        INFO(describe(schedule));
        REQUIRE(holdsOverThePapersRows(certificate, schedule));
        REQUIRE(isProof(certificate, schedule));
        for (auto* part : {&certificate.periodicity, &certificate.pressure}) {
            for (Multiplier& m : *part) {
                ++m.value;
                REQUIRE_FALSE(isProof(certificate, schedule));
                --m.value;
            }
        }
    }
    CHECK(proofs > 50);
}

TEST_CASE("certificate: rows of a long flight that are one and the same count one by one")
{
    int proofs = 0;
    test::forAllSchedules(6, 3, [&](const Schedule& schedule) {
        const OnePhaseSet r = onePhaseSet(schedule);
        const std::int64_t repeat = 4 * schedule.cells;
        // Folding takes whole repeats of 4N steps: the flight must have one to be folded.
        if (!r.reason || schedule.phases.front().free < repeat) {
            return;
        }
        FarkasCertificate certificate = proveAbsence(r);
        if (certificate.penetration.empty()) {
            return;
        }
        ++proofs;
        constexpr std::int64_t times = 60;
        for (auto* part : {&certificate.periodicity, &certificate.pressure}) {
            for (Multiplier& m : *part) {
                m.value *= times;
            }
        }
        certificate.gap *= times;
        std::vector<Multiplier> spread;
        for (std::int64_t k = 0; k < times; ++k) {
            for (const Multiplier& m : certificate.penetration) {
                spread.push_back({m.row % repeat + k * repeat, m.value});
            }
        }
        std::sort(spread.begin(), spread.end(),
                  [](const Multiplier& x, const Multiplier& y) { return x.row < y.row; });
        certificate.penetration = spread;
        Schedule longer = schedule;
        longer.phases.front().free += times * repeat;
        INFO(describe(longer));
        REQUIRE(holdsOverThePapersRows(certificate, longer));
        REQUIRE(isProof(certificate, longer));
        certificate.penetration.back().value += 1;
        const std::int64_t row = certificate.penetration.back().row;
        REQUIRE(isProof(certificate, longer) == (row % repeat == repeat - 1));
    });
    CHECK(proofs > 20);
}

TEST_CASE("certificate: there is none where motions exist")
{
    CHECK_THROWS_AS(proveAbsence(onePhaseSet(onePhase(300, 150, 900))), std::invalid_argument);
}

TEST_CASE("integers: sums and products that do not fit are refused")
{
    constexpr std::int64_t most = std::numeric_limits<std::int64_t>::max();
    CHECK(checkedAdd(most, -1) == most - 1);
    CHECK(checkedMultiply(most, -1) == -most);
    CHECK_THROWS_AS(checkedAdd(most, 1), std::overflow_error);
    CHECK_THROWS_AS(checkedMultiply(most, 2), std::overflow_error);
}
