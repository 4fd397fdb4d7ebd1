// A growing contact of a bar of segments, against what its pushes and ways leave.

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include "catch.hpp"
#include "forced_truth.hpp"
#include "growing_bar.hpp"
#include "signorini/response.hpp"
#include "stepped_bar.hpp"
#include "support.hpp"

using namespace signorini;

namespace {

struct GrowingCount {
    int lines = 0;
    int empty = 0;
    int free = 0;
    int spoilt = 0;
    int ends = 0;
    int work = 0;
};

/// Every contact of one n: the line against what R and v of the same contact leave of it, and the
/// rows against R and v.
void checkGrowing(const SteppedBar& bar, double eta, Excited place, std::int64_t cycles,
                  std::int64_t n, GrowingCount& count)
{
    test::GrowingBar grown(bar.segments, eta, place, cycles, n);
    GrowingContact& waves = grown.waves();
    std::int64_t residues = n;
    for (const Segment& segment : bar.segments) {
        residues = std::gcd(residues, 2 * segment.cells);
    }
    const auto size = [](Plane x) { return std::abs(x.c) + std::abs(x.s); };
    while (waves.contact() + 1 < n) {
        waves.grow();
        const std::int64_t contact = waves.contact();
        const auto free = static_cast<std::size_t>(waves.freePushes());
        INFO("n = " << n << ", n_c = " << contact << ", eta " << eta << ", " << bar.segments.size()
                    << " segments, free " << free);
        double most = 0.1;  // what the excitation alone would move is larger
        for (std::int64_t m = 0; m < n; ++m) {
            most = std::max({most, size(waves.push(m)), size(waves.speed(m))});
        }
        // Which free pushes press in which residues, and how much all their steps together.
        std::vector<std::vector<double>> sums(static_cast<std::size_t>(residues),
                                              std::vector<double>(free, 0.0));
        std::vector<bool> isFree(static_cast<std::size_t>(residues), false);
        for (std::size_t k = 0; k < free; ++k) {
            std::vector<double> unit(free, 0.0);
            unit[k] = 1.0;
            for (std::int64_t m = 0; m < contact; ++m) {
                const double push = waves.freePush(m, unit);
                const auto r = static_cast<std::size_t>(m % residues);
                sums[r][k] += push;
                isFree[r] = isFree[r] || push != 0.0;
            }
        }
        bool isStill = true;
        for (std::int64_t m = 0; m < contact; ++m) {
            isStill = isStill && (isFree[static_cast<std::size_t>(m % residues)] ||
                                  size(waves.speed(m)) <= 1e-9 * most);
        }
        if (!waves.isClear()) {
            ++count.spoilt;
            continue;
        }
        const ForcedLine line = waves.line();
        REQUIRE(isStill);
        const std::vector<ForcedRow> rows = waves.rows();
        REQUIRE(rows.front().condition.rule == ForcedRule::gap);
        std::vector<std::int64_t> pressing(static_cast<std::size_t>(n), 0);
        Plane way;
        std::vector<Plane> ways(static_cast<std::size_t>(n));
        for (std::int64_t m = contact; m < n; ++m) {
            way = way - waves.speed(m);
            ways[static_cast<std::size_t>(m)] = way;
        }
        for (const ForcedRow& row : rows) {
            const std::int64_t m = row.condition.step;
            INFO(name(row.condition.rule) << " in step " << m);
            REQUIRE((size(row.plane) > 0.0 || !row.free.empty() ||
                     row.condition.rule == ForcedRule::gap));
            Plane known = waves.place();
            if (row.condition.rule == ForcedRule::pressure) {
                REQUIRE(m < contact);
                known = waves.push(m);
            } else if (row.condition.rule == ForcedRule::penetration) {
                REQUIRE(m >= contact);
                REQUIRE(m < n - 1);
                known = ways[static_cast<std::size_t>(m)];
            } else if (row.condition.rule == ForcedRule::work) {
                REQUIRE(isFree[static_cast<std::size_t>(m % residues)]);
                known = waves.speed(m);
                REQUIRE(size(known) > 1e-11 * most);
                REQUIRE(row.isEquality);
                ++count.work;
            }
            REQUIRE(row.plane.c == Approx(known.c).margin(1e-9 * most));
            REQUIRE(row.plane.s == Approx(known.s).margin(1e-9 * most));
        }
        // Free pushes so that those of a residue are 0 on average: one of each does.
        Plane tip = waves.place();
        for (std::int64_t r = 0; r < residues; ++r) {
            if (!isFree[static_cast<std::size_t>(r)]) {
                continue;
            }
            Plane sum;
            for (std::int64_t m = r; m < contact; m += residues) {
                sum = sum + waves.push(m);
            }
            const auto& all = sums[static_cast<std::size_t>(r)];
            std::size_t which = 0;
            for (std::size_t k = 0; k < free; ++k) {
                which = std::abs(all[k]) > std::abs(all[which]) ? k : which;
            }
            REQUIRE(std::abs(all[which]) > 1e-6);
            const auto factor =
                std::find_if(rows.front().free.begin(), rows.front().free.end(),
                             [which](const auto& entry) { return entry.first == which; });
            REQUIRE(factor != rows.front().free.end());
            tip = tip - (factor->second / all[which]) * sum;
        }
        const double squares = tip.dot(tip);
        if (squares < 1e-6 * (1.0 + most * most) || most > 1e3) {  // too far away for this
            continue;
        }
        count.free += free > 0 ? 1 : 0;
        const Plane foot = (grown.cells() / squares) * tip;
        const Plane along = (1.0 / std::sqrt(squares)) * Plane{-tip.s, tip.c};
        test::TrueCut cut;
        const auto by = [&](Plane row) {
            cut.by(row.dot(foot), row.dot(along), size(row) + 1e-4 * most);
        };
        for (std::int64_t m = 0; m < contact; ++m) {
            if (!isFree[static_cast<std::size_t>(m % residues)]) {
                by(waves.push(m));
            }
        }
        for (std::int64_t m = contact; m + 1 < n; ++m) {
            by(ways[static_cast<std::size_t>(m)]);
        }
        const bool isNone = line.isEmpty();
        REQUIRE_FALSE((isNone && cut.emptiness() < 0));
        REQUIRE_FALSE((!isNone && cut.emptiness() > 0));
        if (!isNone) {
            REQUIRE(line.foot.c == Approx(foot.c).epsilon(1e-7).margin(1e-9));
            REQUIRE(line.foot.s == Approx(foot.s).epsilon(1e-7).margin(1e-9));
            REQUIRE(test::isSameEnd(line.low, cut.low()));
            REQUIRE(test::isSameEnd(line.high, cut.high()));
        }
        isNone ? ++count.empty : ++count.lines;
        for (const bool isLow : {true, false}) {
            const auto& named = isLow ? line.lowRow : line.highRow;
            if (named) {
                const double t = isLow ? line.low : line.high;
                const Plane row = named->rule == ForcedRule::pressure
                                      ? waves.push(named->step)
                                      : ways[static_cast<std::size_t>(named->step)];
                REQUIRE((named->rule == ForcedRule::pressure) == (named->step < contact));
                REQUIRE(std::abs(row.dot(line.at(t))) <=
                        1e-7 * (size(row) + 1e-3 * most) * (1.0 + std::abs(t) + size(foot)));
                ++count.ends;
            }
        }
    }
}

}  // namespace

TEST_CASE("response of segments: the line of every contact is what its pushes and ways leave")
{
    std::mt19937_64 generator(71);
    const auto draw = [&generator](std::int64_t low, std::int64_t high) {
        return std::uniform_int_distribution<std::int64_t>(low, high)(generator);
    };
    GrowingCount count;
    for (int trial = 0; trial < 120; ++trial) {
        std::vector<Segment> segments;
        for (std::int64_t i = draw(1, 3); i > 0; --i) {
            const bool isFirst = segments.empty();
            segments.push_back(
                {.cells = draw(1, 4),
                 .impedance = isFirst ? 1.0 : 0.5 * static_cast<double>(draw(1, 4))});
        }
        const SteppedBar bar = steppedBar(segments);
        const std::int64_t n = draw(2 * bar.cells + 2, 6 * bar.cells + 3);
        // A dashpot that swallows what arrives, one that is hardly any, one between them.
        const double etas[] = {segments.back().impedance, 1e-8, 0.05, 0.3};
        const Excited place = trial % 3 == 0 ? Excited::base : Excited::tip;
        const std::int64_t cycles = draw(1, 2);
        checkGrowing(bar, etas[trial % 4], place, cycles, n, count);
    }
    // So little that a push does not know of it.
    CHECK_THROWS_AS(test::GrowingBar({{.cells = 3}, {.cells = 2, .impedance = 2.0}}, 1e-10,
                                     Excited::tip, 1, 17),
                    Resonance);
    INFO(count.lines << " lines, " << count.empty << " empty, " << count.free << " free, "
                     << count.spoilt << " spoilt, " << count.ends << " ends, " << count.work
                     << " rows of work");
    CHECK(count.lines > 50);
    CHECK(count.empty > 500);
    CHECK(count.free > 50);
    CHECK(count.ends > 500);
    CHECK(count.spoilt > 50);
    CHECK(count.work > 20);
}
