// The rows that found forced motions, and those that check them, against the law at the tip.

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <random>

#include "catch.hpp"
#include "forced_case.hpp"
#include "forced_cut.hpp"
#include "forced_polytope.hpp"
#include "forced_rows.hpp"
#include "forced_support.hpp"
#include "forced_truth.hpp"
#include "signorini/response.hpp"
#include "support.hpp"

using namespace signorini;
using test::onePhase;

namespace {

std::int64_t drawn(std::mt19937_64& generator, std::int64_t low, std::int64_t high)
{
    return std::uniform_int_distribution<std::int64_t>(low, high)(generator);
}

/// n steps in one to three phases, each on one of the stops there are.
std::vector<Phase> randomPhases(std::mt19937_64& generator, std::int64_t n, bool hasLeft)
{
    const std::int64_t count = drawn(generator, 1, std::min<std::int64_t>(3, n / 2));
    std::vector<Phase> phases;
    for (std::int64_t left = n, k = count; k > 0; --k) {
        const std::int64_t all = k == 1 ? left : drawn(generator, 2, left - 2 * (k - 1));
        const std::int64_t contact = drawn(generator, 1, all - 1);
        const bool isLeft = hasLeft && drawn(generator, 0, 1) == 1;
        phases.push_back({contact, all - contact, isLeft ? Stop::left : Stop::right});
        left -= all;
    }
    return phases;
}

constexpr ForcedRule allRules[] = {
    ForcedRule::gap,        ForcedRule::pressure, ForcedRule::held, ForcedRule::penetration,
    ForcedRule::secondStop, ForcedRule::closure,  ForcedRule::work, ForcedRule::strain};

/// A cosine and a sine, or one shape, or a cosine with a kick in the first step.
std::vector<Excitation> randomShapes(std::mt19937_64& generator, std::int64_t cells, std::int64_t n)
{
    Forcing forcing;
    forcing.place = drawn(generator, 0, 1) == 0 ? Excited::tip : Excited::base;
    forcing.cycles =
        drawn(generator, 1, std::max<std::int64_t>(1, std::min<std::int64_t>(2, (n - 1) / 2)));
    std::vector<Excitation> shapes = shapesOf(forcing, cells, n);
    if (const std::int64_t which = drawn(generator, 0, 4); which == 0) {
        shapes.pop_back();
    } else if (which == 1) {
        shapes.front().values.front() += 0.7;
    }
    return shapes;
}

/// Does the second half undo the first?
bool isMirror(const Schedule& schedule, std::span<const Excitation> shapes)
{
    const auto& phases = schedule.phases;
    if (phases.size() != 2 || !schedule.stops.left ||
        schedule.stops.left->value() != schedule.stops.right ||
        phases[0].contact != phases[1].contact || phases[0].free != phases[1].free ||
        phases[0].stop == phases[1].stop) {
        return false;
    }
    const std::size_t half = shapes.front().values.size() / 2;
    for (const Excitation& e : shapes) {
        const double mean = std::accumulate(e.values.begin(), e.values.end(), 0.0);
        for (std::size_t m = 0; m < half; ++m) {
            if (std::abs(e.values[m] + e.values[m + half]) > 1e-9 ||
                (e.place == Excited::base && std::abs(mean) > 1e-9)) {
                return false;
            }
        }
    }
    return true;
}

}  // namespace

TEST_CASE("forced rows: both kinds of them are those of the law at the tip, step by step")
{
    std::mt19937_64 generator(51);
    const Stops stops[] = {
        {1, {}}, {0, {}}, {-1, {}}, {1, Fraction{1, 1}}, {1, Fraction{2, 3}}, {-1, Fraction{3, 2}}};
    int listed = 0;
    int lines = 0;
    int empty = 0;
    int heldLines = 0;
    int ends = 0;
    int mirrored = 0;
    for (int trial = 0; trial < 250; ++trial) {
        const std::int64_t cells = drawn(generator, 1, 4);
        const std::int64_t n = trial % 6 == 3 ? 2 * drawn(generator, 2, 4 * cells)
                                              : drawn(generator, 3, 7 * cells + 3);
        Schedule schedule{cells, {}, stops[trial % 6]};
        const auto shapes = randomShapes(generator, cells, n);
        const double rho = trial % 5 == 0 ? 1.0 : 0.1 * static_cast<double>(drawn(generator, 3, 9));
        const double waveLimit =
            trial % 2 == 0 ? std::numeric_limits<double>::infinity() : 0.5 + 0.1 * (trial % 17);
        ForcedWaves waves(cells, rho, shapes, schedule.stops);
        for (int change = 0; change < 8; ++change) {
            schedule.phases = randomPhases(generator, n, schedule.stops.left.has_value());
            if (change % 3 == 2) {
                const std::int64_t contact = drawn(generator, 1, n - 1);
                schedule.phases = {{contact, n - contact, schedule.phases.front().stop}};
            } else if (change % 3 == 1 && n % 2 == 0 && n >= 4 && schedule.stops.left) {
                const std::int64_t contact = drawn(generator, 1, n / 2 - 1);
                schedule.phases = {{contact, n / 2 - contact, Stop::right},
                                   {contact, n / 2 - contact, Stop::left}};
            }
            INFO(describe(schedule) << " stops " << schedule.stops.right << " "
                                    << (schedule.stops.left ? schedule.stops.left->value() : 0.0)
                                    << " rho " << rho << " trial " << trial);
            // Those of the proofs.
            const ForcedQuestion question{schedule, rho, shapes, waveLimit};
            const EnclosedWaves enclosed(question);
            const test::TrueRows fromZero(schedule, rho, shapes, false);
            for (const ForcedRule rule : allRules) {
                for (std::int64_t m = -1; m <= n; ++m) {
                    const auto row = enclosed.row({rule, m});
                    auto known = fromZero.row({rule, m}, waveLimit);
                    INFO(name(rule) << " in step " << m);
                    REQUIRE(row.has_value() == known.has_value());
                    if (!row) {
                        continue;
                    }
                    const double factor =
                        rule == ForcedRule::gap ? static_cast<double>(cells) : 1.0;
                    REQUIRE(row->isEquality == known->isEquality);
                    REQUIRE(row->plane.c.low == Approx(factor * known->c).margin(1e-9));
                    REQUIRE(row->plane.c.high == Approx(factor * known->c).margin(1e-9));
                    if (shapes.size() > 1) {
                        REQUIRE(row->plane.s.low == Approx(factor * known->s).margin(1e-9));
                        REQUIRE(row->plane.s.high == Approx(factor * known->s).margin(1e-9));
                    }
                    REQUIRE(row->limit.low == Approx(factor * known->limit).margin(1e-9));
                    REQUIRE(row->limit.high == Approx(factor * known->limit).margin(1e-9));
                    for (std::int64_t j = 0; j < fromZero.classes(); ++j) {
                        const auto seen = row->free.find(j);
                        REQUIRE(
                            (seen == row->free.end() ? 0.0 : static_cast<double>(seen->second)) ==
                            Approx(factor * known->free[j]).margin(1e-9));
                    }
                }
            }
            // Those of the line and of the programs.
            waves.setPhases(schedule.phases);
            const test::TrueRows truth(schedule, rho, shapes, true);
            std::vector<std::int64_t> free;
            std::int64_t held = 0;
            for (std::int64_t j = 0; j < truth.classes(); ++j) {
                if (truth.kind(j) != test::TrueRows::Kind::damped) {
                    free.push_back(j);
                    held += truth.kind(j) == test::TrueRows::Kind::held ? 1 : 0;
                }
            }
            REQUIRE(waves.freeClasses() == free);
            REQUIRE(waves.heldClasses() == held);
            REQUIRE(waves.undampedClasses() == static_cast<std::int64_t>(free.size()) - held);
            const auto& phases = schedule.phases;
            const bool isAlone = std::all_of(
                phases.begin(), phases.end(),
                [&phases](const Phase& phase) { return phase.stop == phases.front().stop; });
            REQUIRE(waves.boundsHeld() ==
                    (isAlone && (phases.front().stop == Stop::left || schedule.stops.right > 0)));
            for (std::int64_t m = 0; m < n; ++m) {
                REQUIRE(waves.wave(m).c == Approx(truth.wave(m).c).margin(1e-9));
                REQUIRE(waves.wave(m).s == Approx(truth.wave(m).s).margin(1e-9));
                REQUIRE(waves.tip(m).c == Approx(truth.tip(m).c).margin(1e-9));
                REQUIRE(waves.tip(m).s == Approx(truth.tip(m).s).margin(1e-9));
            }
            const std::vector<ForcedRow> rows = waves.rows(waveLimit);
            const bool isMirrored = free.empty() && isMirror(schedule, shapes);
            mirrored += isMirrored ? 1 : 0;
            for (const ForcedRow& row : rows) {
                INFO(name(row.condition.rule) << " in step " << row.condition.step);
                auto known = truth.row(row.condition, waveLimit);
                REQUIRE(known);
                REQUIRE((row.plane.c != 0.0 || row.plane.s != 0.0 || !row.free.empty() ||
                         row.limit != 0.0));
                REQUIRE(row.isEquality == known->isEquality);
                REQUIRE(row.plane.c == Approx(known->c).margin(1e-9));
                REQUIRE(row.plane.s == Approx(known->s).margin(1e-9));
                REQUIRE(row.limit == Approx(known->limit).margin(1e-9));
                std::map<std::int64_t, double> factors;
                for (const auto& [which, factor] : row.free) {
                    factors[free.at(which)] = factor;
                }
                for (const std::int64_t j : free) {
                    REQUIRE(factors[j] == Approx(known->free[j]).margin(1e-9));
                }
                ++listed;
            }
            // None is left out that says something.
            for (const ForcedRule rule : allRules) {
                for (std::int64_t m = 0; m < n; ++m) {
                    const auto known = truth.row({rule, m}, waveLimit);
                    const bool isDue = known && rule != ForcedRule::held &&
                                       (rule != ForcedRule::gap || m == 0) &&
                                       (rule != ForcedRule::work || m < truth.classes());
                    const bool isFlight =
                        rule == ForcedRule::penetration || rule == ForcedRule::secondStop;
                    const bool isLate = isFlight && truth.isLast(m);
                    const bool isClosed =
                        rule == ForcedRule::closure &&
                        truth.phaseOf(m) + 1 >= (isMirrored ? phases.size() / 2 : phases.size());
                    const auto isIt = [&](const ForcedRow& row) {
                        return row.condition == ForcedCondition{rule, m};
                    };
                    INFO(name(rule) << " in step " << m);
                    const auto times = std::count_if(rows.begin(), rows.end(), isIt);
                    const bool isSilent =
                        known && known->size() < 1e-9 && known->limit == 0.0 &&
                        std::all_of(known->free.begin(), known->free.end(),
                                    [](const auto& f) { return std::abs(f.second) < 1e-9; });
                    if (!isDue || isLate || isClosed) {
                        REQUIRE(times == 0);
                    } else if (!isSilent) {
                        REQUIRE(times == 1);
                    }
                }
            }
            // What they leave of the line.
            if (shapes.size() < 2 || waves.undampedClasses() > 0 ||
                (held > 0 && !waves.boundsHeld()) || (phases.size() > 1 && !isMirrored)) {
                continue;
            }
            test::TrueRow gap = *truth.row({ForcedRule::gap, 0}, waveLimit);
            const double squares = gap.c * gap.c + gap.s * gap.s;
            if (squares < 1e-12) {
                continue;
            }
            const Plane foot = (gap.limit / squares) * Plane{gap.c, gap.s};
            const Plane along = (1.0 / std::sqrt(squares)) * Plane{-gap.s, gap.c};
            const auto cutBy = [&](double limitOfWaves) {
                test::TrueCut cut;
                for (const ForcedRow& row : rows) {
                    const auto known = truth.row(row.condition, limitOfWaves);
                    const bool isFlight = row.condition.rule == ForcedRule::penetration ||
                                          row.condition.rule == ForcedRule::secondStop;
                    const bool isOwn = row.condition.rule == ForcedRule::pressure &&
                                       truth.kind(row.condition.step) == test::TrueRows::Kind::held;
                    if (known && !known->isEquality && !isOwn &&
                        !(isFlight && held > 0 && known->limit != 0.0)) {
                        const Plane plane{known->c, known->s};
                        cut.by(plane.dot(foot) - known->limit, plane.dot(along),
                               known->size() + 1e-4);
                    }
                }
                return cut;
            };
            const auto compare = [&](const ForcedLine& line, const test::TrueCut& cut, bool isWhole,
                                     double limitOfWaves) {
                const bool isNone = line.isEmpty();
                REQUIRE_FALSE((isNone && cut.emptiness() < 0));
                REQUIRE_FALSE((!isNone && cut.emptiness() > 0));
                if (!isNone && isWhole) {
                    REQUIRE(line.foot.c == Approx(foot.c).margin(1e-9));
                    REQUIRE(line.foot.s == Approx(foot.s).margin(1e-9));
                    REQUIRE(test::isSameEnd(line.low, cut.low()));
                    REQUIRE(test::isSameEnd(line.high, cut.high()));
                }
                // An end is where the row that is named is met with equality.
                for (const bool isLow : {true, false}) {
                    const auto& named = isLow ? line.lowRow : line.highRow;
                    if (named) {
                        const auto row = truth.row(*named, limitOfWaves);
                        REQUIRE(row);
                        const double t = isLow ? line.low : line.high;
                        const double value = Plane{row->c, row->s}.dot(line.at(t));
                        REQUIRE(value == Approx(row->limit).margin(1e-7 * (1.0 + std::abs(t))));
                        ++ends;
                    }
                }
                isNone ? ++empty : ++lines;
                heldLines += held > 0 ? 1 : 0;
            };
            const double unlimited = std::numeric_limits<double>::infinity();
            compare(waves.line(true), cutBy(unlimited), false, unlimited);
            compare(waves.line(false, waveLimit), cutBy(waveLimit), true, waveLimit);
            compare(waves.line(true), cutBy(unlimited), false, unlimited);
        }
    }
    INFO(listed << " rows, " << lines << " lines, " << heldLines << " beside held waves, " << empty
                << " empty, " << ends << " ends, " << mirrored << " mirrored");
    CHECK(listed > 20'000);
    CHECK(lines > 100);
    CHECK(heldLines > 50);
    CHECK(empty > 500);
    CHECK(ends > 200);
    CHECK(mirrored > 5);
}

TEST_CASE("forced line: equations that meet in a point, but for rounding, leave it; another none")
{
    std::mt19937_64 generator(52);
    std::uniform_real_distribution<double> value(-1.0, 1.0);
    for (int trial = 0; trial < 2000; ++trial) {
        const Plane gap{value(generator), 1.0 + value(generator)};
        const double place = trial % 3 == 0 ? 5.0 : value(generator);
        ForcedCut cut(gap, place, 1.0, true, false);
        const Plane point = cut.result().at(3.0 * value(generator));
        for (std::int64_t k = 0; k < 4; ++k) {
            // Steep enough to fix the point.
            const Plane row = cut.result().direction + (0.5 * value(generator)) * gap;
            REQUIRE(cut.to(row, {ForcedRule::closure, k}, row.dot(point)));
            REQUIRE(cut.result().low == cut.result().high);
            REQUIRE(cut.result().at(cut.result().low).c == Approx(point.c).margin(1e-9));
        }
        const Plane row = cut.result().direction;
        REQUIRE_FALSE(cut.to(row, {ForcedRule::closure, 4}, row.dot(point) + 1e-6));
    }
}
