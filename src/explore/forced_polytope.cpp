#include "forced_polytope.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "backend_choice.hpp"
#include "infinity.hpp"
#include "least_norm.hpp"
#include "portable.hpp"

namespace signorini {

namespace {

constexpr double farAway = 1e6;           // amplitudes beyond count as infinite
constexpr double vanishing = 1e-14;       // an amplitude that is 0
constexpr double alike = 1e-9;            // places that differ by less are one
constexpr std::size_t mostCorners = 200;  // corners
constexpr double missedByMore = 1e-9;     // rows that no rounding misses by as much

Plane planeOf(const std::array<double, 2>& place)
{
    return {place[0], place[1]};
}

double sizeOf(Plane x)
{
    return portable::hypot(x.c, x.s);
}

double cross(Plane x, Plane y)
{
    return x.c * y.s - x.s * y.c;
}

class Search {
public:
    Search(std::vector<ForcedRow> rows, const ForcedUnknowns& unknowns, const Solver& solver)
        : rows_(std::move(rows)),
          unknowns_(unknowns),
          solver_(solver),
          program_(forcedProgram(rows_, unknowns_, farAway))
    {
    }

    ForcedPolytope run()
    {
        const std::vector<Plane> ways = unknowns_.isPlane
                                            ? std::vector<Plane>{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}
                                            : std::vector<Plane>{{1, 0}, {-1, 0}};
        for (const Plane way : ways) {
            const auto corner = farthest(way);
            if (!corner) {
                return withoutCorner();
            }
            if (corners_.empty() ||
                (!isAlike(*corner, corners_.back()) && !isAlike(*corner, corners_.front()))) {
                corners_.push_back(*corner);
            }
        }
        // Beyond each edge a corner is looked for, until there is none.
        for (std::size_t k = 0; corners_.size() > 1 && k < corners_.size();) {
            const Plane from = planeOf(corners_[k].place);
            const Plane to = planeOf(corners_[(k + 1) % corners_.size()].place);
            const Plane edge = to - from;
            const Plane out = (1.0 / sizeOf(edge)) * Plane{edge.s, -edge.c};
            const auto corner = unknowns_.isPlane ? farthest(out) : std::nullopt;
            if (corner && corners_.size() < mostCorners &&
                out.dot(planeOf(corner->place) - from) > alike * std::max(1.0, sizeOf(from))) {
                corners_.insert(corners_.begin() + static_cast<std::ptrdiff_t>(k) + 1, *corner);
            } else {
                ++k;
            }
        }
        const bool isBounded =
            std::all_of(corners_.begin(), corners_.end(), [](const ForcedCorner& corner) {
                return std::max(std::abs(corner.place[0]), std::abs(corner.place[1])) <
                       0.99 * farAway;
            });
        return {.detail = {}, .conflict = {}, .corners = corners_, .isBounded = isBounded};
    }

private:
    static bool isAlike(const ForcedCorner& x, const ForcedCorner& y)
    {
        return sizeOf(planeOf(x.place) - planeOf(y.place)) <=
               alike * std::max(1.0, sizeOf(planeOf(x.place)));
    }

    /// Nothing was found: which rows keep the others from being met?
    [[nodiscard]] ForcedPolytope withoutCorner() const
    {
        const MissedProgram missed = leastMissed(rows_, unknowns_);
        const SolverResult answer = solver_.solve(missed.program);
        if (answer.status == SolverStatus::optimal && answer.objective > missedByMore) {
            return conflictOf(missed, answer);
        }
        return {.detail = "the linear program: " + trouble_, .conflict = {}, .corners = {}};
    }

    /// The rows that do.
    [[nodiscard]] ForcedPolytope conflictOf(const MissedProgram& missed,
                                            const SolverResult& answer) const
    {
        const Eigen::VectorXd duals = answer.inequalityDuals.cwiseAbs();
        const double least = alike * duals.maxCoeff();
        ForcedPolytope result{.detail = {}, .conflict = {}, .multipliers = {0.0}, .corners = {}};
        std::vector<ForcedCondition>& conflict = result.conflict.emplace();
        for (std::size_t k = 0; k < rows_.size(); ++k) {
            const double below = duals[missed.first[k]];
            const double above = rows_[k].isEquality ? duals[missed.first[k] + 1] : 0.0;
            const double multiplier = (below - above) / missed.sizes[k];
            if (k == 0) {
                result.multipliers.front() = multiplier;
            } else if (rows_[k].condition.rule == ForcedRule::gap) {
                result.added = multiplier;
            } else if (below + above > least) {
                conflict.push_back(rows_[k].condition);
                result.multipliers.push_back(multiplier);
            }
        }
        return result;
    }

    /// Sets may be no more than a point: rows give way a little, and are polished afterwards.
    std::optional<ForcedCorner> farthest(Plane way)
    {
        Program roomy = program_;
        roomy.inequalityRhs.array() += missedByMore;
        roomy.linear[0] = -way.c;
        if (unknowns_.isPlane) {
            roomy.linear[1] = -way.s;
        }
        // Loosely: what is off by more than rounding is polished away, or seen by the march.
        const SolverResult answer = solver_.solve(roomy, {.tolerance = 1e-5});
        if (answer.status != SolverStatus::optimal) {
            trouble_ = answer.detail;
            return std::nullopt;
        }
        const Eigen::VectorXd x = polished(answer.x);
        const auto free = x.tail(unknowns_.free);
        const auto place = [&x](Eigen::Index k) { return std::abs(x[k]) < vanishing ? 0.0 : x[k]; };
        return ForcedCorner{{place(0), unknowns_.isPlane ? place(1) : 0.0},
                            {free.begin(), free.end()}};
    }

    /// A solver leaves rows off by its tolerance: those that are met with equality are met to
    /// rounding by the least change.
    [[nodiscard]] Eigen::VectorXd polished(Eigen::VectorXd x) const
    {
        constexpr double met = 1e-5;
        const Eigen::VectorXd below = program_.inequalities * x - program_.inequalityRhs;
        // Of each row: an amplitude that stands for infinity makes no other row look met.
        const Eigen::VectorXd size =
            (program_.inequalities.cwiseAbs() * x.cwiseAbs() + program_.inequalityRhs.cwiseAbs())
                .cwiseMax(1.0);
        std::vector<Eigen::Index> active;
        for (Eigen::Index row = 0; row < below.size(); ++row) {
            if (below[row] > -met * size[row]) {
                active.push_back(row);
            }
        }
        const Eigen::Index equal = program_.equalities.rows();
        const auto count = static_cast<Eigen::Index>(active.size());
        Eigen::MatrixXd rows(equal + count, x.size());
        Eigen::VectorXd right(equal + count);
        rows.topRows(equal) = program_.equalities;
        right.head(equal) = program_.equalityRhs;
        for (Eigen::Index k = 0; k < count; ++k) {
            rows.row(equal + k) = program_.inequalities.row(active[static_cast<std::size_t>(k)]);
            right[equal + k] = program_.inequalityRhs[active[static_cast<std::size_t>(k)]];
        }
        const LeastSquares nearest(rows, 1e-10);
        for (int pass = 0; pass < 2; ++pass) {
            x += nearest.solve(right - rows * x);
        }
        return x;
    }

    std::vector<ForcedRow> rows_;
    ForcedUnknowns unknowns_;
    const Solver& solver_;
    Program program_;
    std::vector<ForcedCorner> corners_;
    std::string trouble_;
};

/// sum of weights times corners.
ForcedCorner mean(std::span<const ForcedCorner* const> corners, std::span<const double> weights)
{
    ForcedCorner result{{}, std::vector<double>(corners.front()->free.size())};
    for (std::size_t k = 0; k < corners.size(); ++k) {
        for (std::size_t i = 0; i < 2; ++i) {
            result.place[i] += weights[k] * corners[k]->place[i];
        }
        for (std::size_t i = 0; i < result.free.size(); ++i) {
            result.free[i] += weights[k] * corners[k]->free[i];
        }
    }
    return result;
}

/// Where on the way from one place to the other the origin is nearest, 0 to 1.
double nearestOn(Plane from, Plane to)
{
    const Plane way = to - from;
    const double squares = way.dot(way);
    return squares > 0.0 ? std::clamp(-from.dot(way) / squares, 0.0, 1.0) : 0.0;
}

Plane farthestPlace(const std::vector<ForcedCorner>& corners)
{
    return planeOf(std::max_element(corners.begin(), corners.end(),
                                    [](const ForcedCorner& x, const ForcedCorner& y) {
                                        return sizeOf(planeOf(x.place)) < sizeOf(planeOf(y.place));
                                    })
                       ->place);
}

}  // namespace

ForcedPolytope forcedPolytope(std::vector<ForcedRow> rows, const ForcedUnknowns& unknowns)
{
    const auto solver = simplexWithDuals();
    if (!solver) {
        return {.detail = "this build has no solver of linear programs that returns multipliers",
                .conflict = {},
                .corners = {}};
    }
    return Search(std::move(rows), unknowns, *solver).run();
}

ForcedCorner meanAt(const std::vector<ForcedCorner>& corners, std::array<double, 2> place)
{
    // Of the triangles with the first corner the one that holds the place, or misses it by least.
    const ForcedCorner& first = corners.front();
    const Plane target = planeOf(place) - planeOf(first.place);
    ForcedCorner best = first;
    double miss = sizeOf(target);
    const auto tryMean = [&](std::span<const ForcedCorner* const> some,
                             std::span<const double> weights) {
        ForcedCorner one = mean(some, weights);
        const double missed = sizeOf(planeOf(one.place) - planeOf(place));
        if (missed < miss) {
            miss = missed;
            best = std::move(one);
        }
    };
    for (std::size_t k = 1; k < corners.size(); ++k) {
        const Plane x = planeOf(corners[k].place) - planeOf(first.place);
        const double along = std::clamp(target.dot(x) / std::max(x.dot(x), 1e-300), 0.0, 1.0);
        tryMean(std::array{&first, &corners[k]}, std::array{1.0 - along, along});
        if (k + 1 == corners.size()) {
            break;
        }
        const Plane y = planeOf(corners[k + 1].place) - planeOf(first.place);
        const double area = cross(x, y);
        const double toX = std::max(cross(target, y) / area, 0.0);
        const double toY = std::max(cross(x, target) / area, 0.0);
        if (std::isfinite(toX) && std::isfinite(toY) && toX + toY <= 1.0) {
            tryMean(std::array{&first, &corners[k], &corners[k + 1]},
                    std::array{1.0 - toX - toY, toX, toY});
        }
    }
    return best;
}

std::array<double, 2> nearestPlace(const std::vector<ForcedCorner>& corners)
{
    Plane best = planeOf(corners.front().place);
    bool isInside = corners.size() > 2;
    double area = 0.0;
    double squares = 0.0;
    for (std::size_t k = 0; k < corners.size(); ++k) {
        const Plane from = planeOf(corners[k].place);
        const Plane to = planeOf(corners[(k + 1) % corners.size()].place);
        isInside = isInside && cross(from, to) >= 0.0;
        area += cross(from, to);
        squares += from.dot(from);
        const Plane near = from + nearestOn(from, to) * (to - from);
        best = sizeOf(near) < sizeOf(best) ? near : best;
    }
    // Corners on a line have no inside, whatever rounding makes of it.
    return isInside && area > alike * squares ? std::array{0.0, 0.0} : std::array{best.c, best.s};
}

std::pair<double, double> amplitudesOf(const ForcedPolytope& polytope)
{
    return {sizeOf(planeOf(nearestPlace(polytope.corners))),
            polytope.isBounded ? sizeOf(farthestPlace(polytope.corners)) : infinity};
}

std::array<double, 2> placeOfAmplitude(const std::vector<ForcedCorner>& corners, double amplitude)
{
    // On the way from the nearest place to the farthest amplitudes grow: |x + s way| = amplitude.
    const Plane from = planeOf(nearestPlace(corners));
    const Plane way = farthestPlace(corners) - from;
    const double squares = way.dot(way);
    const double half = from.dot(way);
    const double least = sizeOf(from);
    const double lack = (amplitude - least) * (amplitude + least);
    const double along =
        squares > 0.0 ? (std::sqrt(half * half + squares * lack) - half) / squares : 0.0;
    const Plane place = from + std::clamp(along, 0.0, 1.0) * way;
    return {place.c, place.s};
}

}  // namespace signorini
