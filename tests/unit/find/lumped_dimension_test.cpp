#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <vector>

#include "catch.hpp"
#include "formulation.hpp"
#include "lumped_support.hpp"
#include "scene_oracle.hpp"
#include "signorini/lumped_set.hpp"
#include "solver.hpp"

using namespace signorini;
using test::feasibleSchedule;

namespace {

/// The affine dimension of the amplitudes that a program allows, by brute force: minimise and
/// maximise functionals that are constant on all points found so far, until none varies.
class BruteForceHull {
public:
    explicit BruteForceHull(Formulated formulated)
        : formulated_(std::move(formulated)), solver_(makeSolver("glpk-simplex"))
    {
        const Eigen::Index n = formulated_.program.variables();
        // Only unknowns that p reads; bounds of boxes are no amplitudes.
        amplitudes_.assign(static_cast<std::size_t>(n), false);
        for (const DelayTerm& term : formulated_.delay) {
            if (term.factor != 0.0) {
                amplitudes_[static_cast<std::size_t>(term.column)] = true;
            }
        }
    }

    /// Number of directions, or -1 if there is no point.
    int dimension()
    {
        const auto first = extreme(Eigen::VectorXd::Zero(formulated_.program.variables()));
        if (!first) {
            return -1;
        }
        std::vector<Eigen::VectorXd> directions;
        std::vector<Eigen::VectorXd> known;
        while (true) {
            const auto c = orthogonalTo(known);
            if (!c) {
                return static_cast<int>(directions.size());
            }
            bool varies = false;
            for (const double sign : {1.0, -1.0}) {
                const auto other = extreme(sign * *c);
                REQUIRE(other);
                if (std::abs(c->dot(*other - *first)) > 1e-6) {
                    directions.push_back(masked(*other - *first));
                    known.push_back(directions.back());
                    varies = true;
                    break;
                }
            }
            if (!varies) {
                known.push_back(*c);
            }
        }
    }

    /// Vertices that random functionals are least at: all of them, if they are few.
    std::size_t vertices(std::mt19937_64& generator, int functionals)
    {
        std::normal_distribution<double> normal;
        std::vector<Eigen::VectorXd> found;
        for (int k = 0; k < functionals; ++k) {
            Eigen::VectorXd cost(formulated_.program.variables());
            std::generate(cost.begin(), cost.end(), [&] { return normal(generator); });
            const auto vertex = extreme(masked(cost));
            REQUIRE(vertex);
            const Eigen::VectorXd amplitudes = masked(*vertex);
            const bool isNew = std::none_of(
                found.begin(), found.end(),
                [&](const Eigen::VectorXd& other) { return (other - amplitudes).norm() < 1e-6; });
            if (isNew) {
                found.push_back(amplitudes);
            }
        }
        return found.size();
    }

private:
    [[nodiscard]] Eigen::VectorXd masked(Eigen::VectorXd x) const
    {
        for (Eigen::Index i = 0; i < x.size(); ++i) {
            x[i] = amplitudes_[static_cast<std::size_t>(i)] ? x[i] : 0.0;
        }
        return x;
    }

    [[nodiscard]] std::optional<Eigen::VectorXd> extreme(const Eigen::VectorXd& cost)
    {
        formulated_.program.linear = cost;
        const SolverResult result = solver_->solve(formulated_.program);
        REQUIRE(
            (result.status == SolverStatus::optimal || result.status == SolverStatus::infeasible));
        return result.status == SolverStatus::optimal ? std::optional(result.x) : std::nullopt;
    }

    [[nodiscard]] std::optional<Eigen::VectorXd> orthogonalTo(
        const std::vector<Eigen::VectorXd>& known) const
    {
        const auto n = static_cast<Eigen::Index>(amplitudes_.size());
        for (Eigen::Index i = 0; i < n; ++i) {
            if (!amplitudes_[static_cast<std::size_t>(i)]) {
                continue;
            }
            Eigen::VectorXd c = Eigen::VectorXd::Unit(n, i);
            if (!known.empty()) {
                Eigen::MatrixXd basis(n, static_cast<Eigen::Index>(known.size()));
                for (std::size_t k = 0; k < known.size(); ++k) {
                    basis.col(static_cast<Eigen::Index>(k)) = known[k];
                }
                c -= basis * basis.colPivHouseholderQr().solve(c);
            }
            if (c.norm() > 1e-6) {
                return masked(c / c.norm());
            }
        }
        return std::nullopt;
    }

    Formulated formulated_;
    std::unique_ptr<Solver> solver_;
    std::vector<bool> amplitudes_;
};

}  // namespace

TEST_CASE("lumped set: the dimension is that of brute force in class amplitudes", "[glpk]")
{
    std::mt19937_64 generator(31);
    int varying = 0;
    for (int trial = 0; trial < 2500; ++trial) {
        const Schedule schedule = feasibleSchedule(generator, 8, trial);
        const LumpedShape shape = shapeOf(lumpedSet(schedule));
        INFO(describe(schedule));
        BruteForceHull hull(formulate(schedule, Formulation::reduced));
        REQUIRE(hull.dimension() == shape.dimension);
        varying += shape.spanning.size() > 1 ? 1 : 0;
    }
    CHECK(varying > 80);
}

TEST_CASE("lumped set: with other stops dimension and vertices are those of brute force", "[glpk]")
{
    std::mt19937_64 generator(32);
    const std::vector<Stops> scenes{{1, {}},          {-1, {}},         {1, Fraction{3, 2}},
                                    {0, Fraction{3}}, {0, Fraction{5}}, {-1, Fraction{4}}};
    int varying = 0;
    std::map<SetKind, int> seen;
    for (std::size_t trial = 0; trial < 9000; ++trial) {
        const Stops& stops = scenes[trial % scenes.size()];
        const Schedule schedule = stops == Stops{} ? test::nearMultiples(generator, 8, 4)
                                                   : test::randomScene(generator, stops, 6);
        const LumpedSet set = lumpedSet(schedule);
        if (set.absence) {
            continue;
        }
        const LumpedShape shape = shapeOf(set);
        INFO(describe(schedule) << " gap " << schedule.stops.right);
        BruteForceHull hull(formulate(schedule, Formulation::reduced));
        REQUIRE(hull.dimension() == shape.dimension);
        if (shape.dimension > 0 && shape.dimension < 5 && shape.kind != SetKind::box) {
            const auto simplex = static_cast<std::size_t>(shape.dimension) + 1;
            const std::size_t vertices = hull.vertices(generator, 50);
            CHECK(vertices >= simplex);
            CHECK((shape.kind == SetKind::simplex) == (vertices == simplex));
        }
        varying += shape.spanning.size() > 1 ? 1 : 0;
        ++seen[shape.kind];
    }
    CHECK(varying > 10);
    CHECK(seen[SetKind::simplex] > 50);
    CHECK(seen[SetKind::polytope] > 10);
}
