// Continua without a gap, and between two stops: sets are listed by cddlib from rows in the 2N
// waves, and every member runs through a march that is written here.

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <vector>

#include "catch.hpp"
#include "sanitized.hpp"
#include "scene_vertices.hpp"
#include "signorini/continuum.hpp"
#include "support.hpp"

using namespace signorini;
using test::verticesOf;

namespace {

using Point = test::Waves2N;

const Scene noGap{Bar{.gap = 0.0}};

double squaresOf(const Point& point)
{
    return std::inner_product(point.begin(), point.end(), point.begin(), 0.0);
}

/// How many groups of vertices with Q >= q there are, two joined if Q >= q between them.
std::int64_t groupsAbove(std::vector<Point> vertices, double squares)
{
    const double level = squares * (1.0 - 1e-12);
    std::erase_if(vertices, [level](const Point& vertex) { return squaresOf(vertex) < level; });
    std::vector<std::size_t> group(vertices.size());
    std::iota(group.begin(), group.end(), std::size_t{0});
    auto count = static_cast<std::int64_t>(vertices.size());
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        for (std::size_t k = 0; k < i; ++k) {
            const double cross = std::inner_product(vertices[i].begin(), vertices[i].end(),
                                                    vertices[k].begin(), 0.0);
            const double first = squaresOf(vertices[i]) - cross;
            const double second = squaresOf(vertices[k]) - cross;
            // The least Q on a line through both lies between them if both differences are > 0.
            const double least = first > 0.0 && second > 0.0
                                     ? squaresOf(vertices[i]) - first * first / (first + second)
                                     : level;
            if (least >= level && group[i] != group[k]) {
                std::replace(group.begin(), group.end(), std::size_t{group[i]},
                             std::size_t{group[k]});
                --count;
            }
        }
    }
    return count;
}

/// The number of independent ones among a few vectors.
int rankOf(std::vector<Point> rows)
{
    int rank = 0;
    for (std::size_t column = 0; column < rows.front().size(); ++column) {
        const auto used = rows.begin() + rank;
        const auto pivot =
            std::max_element(used, rows.end(), [column](const auto& a, const auto& b) {
                return std::abs(a[column]) < std::abs(b[column]);
            });
        if (pivot == rows.end() || std::abs((*pivot)[column]) < 1e-9) {
            continue;
        }
        std::iter_swap(used, pivot);
        for (auto row = used + 1; row != rows.end(); ++row) {
            const double factor = (*row)[column] / (*used)[column];
            for (std::size_t i = 0; i < row->size(); ++i) {
                (*row)[i] -= factor * (*used)[i];
            }
        }
        ++rank;
    }
    return rank;
}

/// The worst of (30)-(32) over one period, of a wave that runs to and fro.
double breachOf(const Schedule& schedule, const State& state)
{
    const Point start = test::waves2NOf(state);
    const auto cells = static_cast<double>(schedule.cells);
    const double right = schedule.stops.right;
    const auto& left = schedule.stops.left;
    const double second =
        left ? -static_cast<double>(left->numerator) / static_cast<double>(left->denominator)
             : -1e300;
    std::vector<double> line = start;
    double tip = -std::accumulate(start.begin(), start.end(), 0.0) / cells;
    double worst = 0.0;
    const auto see = [&worst](double breach) { worst = std::max(worst, breach); };
    for (const Phase& phase : schedule.phases) {
        const bool isRight = phase.stop == Stop::right;
        see(std::abs(tip - (isRight ? right : second)));
        for (std::int64_t step = 0; step < phase.contact + phase.free; ++step) {
            const bool isContact = step < phase.contact;
            const double now = line.front();
            line.erase(line.begin());
            line.push_back(isContact ? now : -now);
            if (isContact) {
                see(isRight ? -now : now);
            } else {
                tip += 2.0 * now / cells;
                see(std::max(tip - right, second - tip));
            }
        }
    }
    for (std::size_t m = 0; m < line.size(); ++m) {
        see(std::abs(line[m] - start[m]));
    }
    return worst / std::sqrt(squaresOf(start));
}

void requireMembers(const Continuum& curve, std::size_t least)
{
    INFO(describe(curve.schedule) << ": " << curve.detail);
    REQUIRE(curve.status == Status::found);
    REQUIRE(curve.points.size() >= least);
    const auto cells = static_cast<double>(curve.schedule.cells);
    for (const ContinuumPoint& point : curve.points) {
        const double energy = 2.0 / cells * squaresOf(test::waves2NOf(point.state));
        CHECK(std::abs(energy / curve.energyRatio - 1.0) < 1e-12);
        CHECK(breachOf(curve.schedule, point.state) < 1e-12);
    }
}

/// Every size: one, and a few.
const std::vector<Schedule> ofAnySize{
    {4, {{3, 9}}},  {4, {{5, 7}}}, {4, {{1, 4}}},  {4, {{2, 8}}},  {4, {{5, 7}, {6, 6}}},
    {8, {{6, 18}}}, {8, {{2, 8}}}, {6, {{4, 14}}}, {6, {{3, 12}}}, {4, {{3, 9}, {5, 7}}}};

}  // namespace

TEST_CASE("g = 0: curves of one energy lie in the cone that cddlib lists, and span what it spans")
{
    int curves = 0;
    for (const Schedule& asked : ofAnySize) {
        Schedule schedule = asked;
        schedule.stops.right = 0;
        ContinuumOptions options;
        options.scene = noGap;
        options.points = 9;
        const double energy = 3e-7;
        const Continuum curve = traceContinuum(schedule, energy, options);
        INFO(describe(schedule));
        if (!test::OracleRows(schedule).isFeasible()) {
            CHECK(curve.status == Status::none);
            continue;
        }
        const std::vector<Point> rays = verticesOf(schedule);
        CHECK(curve.connected == true);
        CHECK(curve.components == 1);
        CHECK(curve.dimension == rankOf(rays) - 1);
        requireMembers(curve, curve.dimension == 0 ? 1 : 9);
        if (curve.dimension == 0) {
            continue;
        }
        ++curves;
        for (const Trace& trace : {Trace(trace::RandomPath{3}), Trace(trace::Sample{4})}) {
            options.trace = trace;
            requireMembers(traceContinuum(schedule, energy, options), 9);
        }
        // Extreme motions, brought to the energy, are joined by the arc between them.
        const auto motionOf = [&](const Point& ray) {
            const double factor =
                std::sqrt(energy * static_cast<double>(schedule.cells) / (2.0 * squaresOf(ray)));
            State state{Eigen::VectorXd(schedule.cells), Eigen::VectorXd(schedule.cells)};
            for (Eigen::Index m = 0; m < schedule.cells; ++m) {
                state.a[schedule.cells - 1 - m] = factor * ray[static_cast<std::size_t>(m)];
                state.b[m] = -factor * ray[static_cast<std::size_t>(schedule.cells + m)];
            }
            return state;
        };
        options.trace = trace::Path{motionOf(rays.front()), motionOf(rays.back())};
        const Continuum arc = traceContinuum(schedule, energy, options);
        requireMembers(arc, 9);
        CHECK(arc.connected == true);
        CHECK((arc.points.back().state.a - motionOf(rays.back()).a).norm() < 1e-15);
    }
    CHECK(curves >= 6);
}

TEST_CASE("g = 0: the split pulse shares one impulse, and a finer grid shows the same curve")
{
    const auto trace = [](std::int64_t refined, std::int64_t points) {
        ContinuumOptions options;
        options.scene = noGap;
        options.points = points;
        return traceContinuum({4 * refined, {{3 * refined, 9 * refined}}}, 1e-6, options);
    };
    const auto impulses = [](const Continuum& curve) {
        std::vector<double> sums;
        for (const ContinuumPoint& point : curve.points) {
            double sum = 0.0;
            const Motion motion(point.state, curve.schedule);
            for (std::int64_t m = 0; m < motion.steps(); ++m) {
                sum += motion.wallForce(m) / static_cast<double>(curve.schedule.cells);
            }
            sums.push_back(sum);
        }
        return sums;
    };
    const Continuum coarse = trace(16, 7);
    const Continuum fine = trace(32, 7);
    CHECK(coarse.parameter == Parameter::pause);
    CHECK(coarse.orbits == 7);
    CHECK(coarse.points.back().lambda == Approx(fine.points.back().lambda));
    for (const double impulse : impulses(coarse)) {
        CHECK(impulse == Approx(impulses(fine).front()));
    }
    const double middle = 0.4 * coarse.points.back().lambda;
    const Member member = memberAt(coarse, middle);
    CHECK(member.isExact);
    CHECK(breachOf(coarse.schedule, member.point.state) < 1e-12);
    // Every size: the same curve at another energy is a multiple of it.
    ContinuumOptions options;
    options.scene = noGap;
    options.points = 7;
    const Continuum larger = traceContinuum(coarse.schedule, 4e-6, options);
    for (std::size_t k = 0; k < 7; ++k) {
        CHECK((larger.points[k].state.a - 2.0 * coarse.points[k].state.a).norm() < 1e-15);
    }
}

TEST_CASE("g = 0: what a cone has no answer for is refused in words")
{
    const Schedule schedule{4, {{3, 9}}};
    ContinuumOptions options;
    options.scene = noGap;
    options.solver = "ipopt";
    CHECK_THROWS_WITH(traceContinuum(schedule, 1e-6, options), containsText("gap is 0"));
    options.solver = "auto";
    options.strainLimit = 1e-5;
    CHECK_THROWS_WITH(traceContinuum(schedule, 1e-6, options), containsText("gap is 0"));
    options.strainLimit = 1.0;
    CHECK(traceContinuum(schedule, 1e-6, options).status == Status::found);
    const State member = traceContinuum(schedule, 1e-6, options).points.front().state;
    options.trace = trace::Walk{member, member};
    CHECK_THROWS_WITH(traceContinuum(schedule, 1e-6, options), containsText("direction"));
    options.trace = trace::Path{member, {2.0 * member.a, 2.0 * member.b}};
    CHECK_THROWS_WITH(traceContinuum(schedule, 1e-6, options), containsText("to = "));
}

TEST_CASE("two stops: as many components of an energy as the vertices of cddlib have")
{
    constexpr auto left = Stop::left;
    const std::vector<std::pair<double, Schedule>> cases{
        {1.0, {8, {{2, 10}, {2, 10, left}}}},  {1.0, {8, {{2, 12}, {2, 12, left}}}},
        {1.0, {8, {{6, 4}, {6, 4, left}}}},    {1.0, {12, {{3, 15}, {3, 15, left}}}},
        {1.0, {12, {{3, 18}, {3, 18, left}}}}, {0.5, {8, {{2, 10}, {2, 10, left}}}},
        {2.0, {8, {{2, 12}, {2, 12, left}}}},  {2.0, {8, {{4, 24}}}},
        {2.5, {8, {{4, 24}, {4, 24}}}},        {1.0, {4, {{1, 5}, {1, 5, left}}}}};
    int several = 0;
    int varying = 0;
    for (const auto& [height, asked] : cases) {
        const Scene scene(Bar{}, 1e-3 * height);
        Schedule schedule = asked;
        schedule.stops = stopsOf(scene);
        INFO(describe(schedule) << ", h = " << height << " g");
        ContinuumOptions options;
        options.scene = scene;
        options.points = 5;
        if (!test::OracleRows(schedule).isFeasible()) {
            CHECK(traceContinuum(schedule, 8.0, options).status == Status::none);
            continue;
        }
        const std::vector<Point> vertices = verticesOf(schedule);
        const auto cells = static_cast<double>(schedule.cells);
        double most = 0.0;
        for (const Point& vertex : vertices) {
            most = std::max(most, 2.0 / cells * squaresOf(vertex));
        }
        FindOptions find;
        find.scene = scene;
        const EnergyRange range = *findPeriodic(schedule, find).set.energy;
        CHECK(range.most == Approx(most).epsilon(1e-12));
        for (const double part : {0.2, 0.5, 0.8}) {
            const double energy = std::lerp(range.least, range.most, part);
            if (!(range.least < range.most) || (test::drawsFew() && part != 0.5)) {
                continue;
            }
            Continuum curve;
            try {
                curve = traceContinuum(schedule, energy, options);
            } catch (const BackendUnavailable&) {
                continue;
            }
            CHECK(curve.components == groupsAbove(vertices, 0.5 * cells * energy));
            several += *curve.components > 1 ? 1 : 0;
            varying += curve.dimension > 0 ? 1 : 0;
            if (curve.solver == "closed-form") {
                requireMembers(curve, 1);
            }
        }
    }
    CHECK(several >= test::drawn(5));
    CHECK(varying >= test::drawn(5));
}

TEST_CASE("two stops: both carry the same split pulse, mirrored, without a solver")
{
    for (const Schedule& schedule : {Schedule{40, {{10, 50}, {10, 50, Stop::left}}},
                                     Schedule{40, {{10, 60}, {10, 60, Stop::left}}},
                                     Schedule{40, {{30, 20}, {30, 20, Stop::left}}}}) {
        ContinuumOptions options;
        options.scene = Scene(Bar{}, 1e-3);
        options.points = 9;
        options.solver = "closed-form";
        FindOptions find;
        find.scene = options.scene;
        const EnergyRange range = *findPeriodic(schedule, find).set.energy;
        const Continuum curve = traceContinuum(schedule, 2.5 * range.least, options);
        requireMembers(curve, 9);
        CHECK(curve.orbits == 9);
        CHECK(curve.parameter == Parameter::pause);
        const std::size_t half = static_cast<std::size_t>(steps(schedule) / 2);
        for (const ContinuumPoint& point : curve.points) {
            // p_{m+n/2} = -p_m, in a wave that runs to and fro here.
            std::vector<double> line = test::waves2NOf(point.state);
            const std::vector<double> start = line;
            for (std::size_t m = 0; m < half; ++m) {
                const bool isContact = static_cast<std::int64_t>(m) < schedule.phases[0].contact;
                line.push_back(isContact ? line[m] : -line[m]);
            }
            for (std::size_t m = 0; m < start.size(); ++m) {
                CHECK(std::abs(line[m + half] + start[m]) < 1e-12);
            }
        }
        const Member member = memberAt(curve, 0.3 * curve.points.back().lambda);
        CHECK(breachOf(curve.schedule, member.point.state) < 1e-12);
        options.trace = trace::Sample{};
        CHECK_THROWS_AS(traceContinuum(schedule, 2.5 * range.least, options),
                        std::invalid_argument);
    }
}

TEST_CASE("two stops: programs trace a curve of members between both stops", "[ipopt]")
{
    ContinuumOptions options;
    options.scene = Scene(Bar{}, 1e-3);
    options.points = 9;
    options.solver = "ipopt";
    const Continuum curve = traceContinuum({12, {{3, 15}, {3, 15, Stop::left}}}, 17.0, options);
    INFO(curve.detail);
    REQUIRE(curve.status == Status::found);
    REQUIRE(curve.points.size() >= 9);
    CHECK(curve.dimension > 0);
    for (const ContinuumPoint& point : curve.points) {
        const double energy = 2.0 / 12.0 * squaresOf(test::waves2NOf(point.state));
        CHECK(energy == Approx(17.0).epsilon(1e-9));
        CHECK(breachOf(curve.schedule, point.state) < 1e-9);
    }
}

TEST_CASE("two stops and no gap: an energy sets the size, and the second stop the largest one")
{
    const Scene scene(Bar{.gap = 0.0}, 0.125);
    Schedule schedule{4, {{3, 9}}, stopsOf(scene)};
    const std::vector<Point> vertices = verticesOf(schedule);
    double most = 0.0;
    for (const Point& vertex : vertices) {
        most = std::max(most, 0.5 * squaresOf(vertex));
    }
    FindOptions find;
    find.scene = scene;
    CHECK_THROWS_WITH(findPeriodic(schedule, find), containsText("energy"));
    find.energyRatio = 0.5 * most;
    const PeriodicResult found = findPeriodic(schedule, find);
    REQUIRE(found.status == Status::found);
    CHECK(breachOf(schedule, found.motion->state) < 1e-12);
    CHECK(0.5 * squaresOf(test::waves2NOf(found.motion->state)) == Approx(0.5 * most));
    find.energyRatio = 1.01 * most;
    const PeriodicResult none = findPeriodic(schedule, find);
    CHECK(none.status == Status::none);
    CHECK(std::get<EnergyExclusion>(none.absence->proof).range.most == Approx(most));
}
