#include <algorithm>
#include <limits>
#include <utility>

#include "double_description.hpp"
#include "echo.hpp"
#include "exact_projection.hpp"
#include "infinity.hpp"
#include "lumped_rows.hpp"
#include "signorini/amplitude_set.hpp"
#include "signorini/lumped_set.hpp"
#include "stops.hpp"

namespace signorini {

namespace {

constexpr std::size_t maxRays = 512;
constexpr std::size_t maxTypesForVertices = 12;

/// Finds the affine hull of the polyhedron of the sums by projecting points beside it.
class AffineHull {
public:
    AffineHull(const LumpedSet& set, const LumpedRows& rows) : rows_(rows), counts_(countsOf(set))
    {
        const std::size_t size = set.live.size();
        Projection nearest = project(rows, RationalVector(size), counts_);
        points_.push_back(std::move(nearest.point));
        for (const WeightedRow& active : nearest.rows) {
            if (active.row.isEquality) {
                addKnown({active.row.coefficients.begin(), active.row.coefficients.end()});
            }
        }
        while (const auto c = nullVector(known_, size)) {
            if (!stretch(*c, 1) && !stretch(*c, -1)) {
                addKnown({c->begin(), c->end()});
            }
        }
    }

    /// Points that span the polyhedron, one more than it has dimensions.
    [[nodiscard]] const std::vector<RationalVector>& points() const { return points_; }

    /// Their mean, a point in the relative interior.
    [[nodiscard]] RationalVector centre() const
    {
        RationalVector mean(points_.front().size());
        for (const RationalVector& point : points_) {
            for (std::size_t i = 0; i < mean.size(); ++i) {
                mean[i] += point[i] / points_.size();
            }
        }
        return mean;
    }

private:
    /// A functional that is constant on the polyhedron, or a direction inside it: either way one
    /// that need not be tried again.
    void addKnown(RationalVector row) { known_.push_back(std::move(row)); }

    /// Does c . x rise anywhere above its value at the first point? That point is its own
    /// projection from c beyond it exactly if not.
    bool stretch(const IntegerVector& c, int sign)
    {
        RationalVector beside = points_.front();
        for (std::size_t i = 0; i < beside.size(); ++i) {
            beside[i] += c[i] * counts_[i] * sign;
        }
        RationalVector reached = project(rows_, beside, counts_).point;
        if (reached == points_.front()) {
            return false;
        }
        RationalVector direction = reached;
        for (std::size_t i = 0; i < direction.size(); ++i) {
            direction[i] -= points_.front()[i];
        }
        addKnown(std::move(direction));
        points_.push_back(std::move(reached));
        return true;
    }

    const LumpedRows& rows_;
    std::vector<std::int64_t> counts_;
    std::vector<RationalVector> known_;
    std::vector<RationalVector> points_;
};

/// Everything that decides kind and most energy, once the affine hull is known.
class Shape {
public:
    explicit Shape(const LumpedSet& set) : set_(set), rows_(set.classes, set.live) {}

    LumpedShape build()
    {
        const AffineHull hull(set_, rows_);
        const RationalVector centre = hull.centre();
        sumDimension_ = static_cast<std::int64_t>(hull.points().size()) - 1;
        result_.dimension = sumDimension_;
        for (std::size_t i = 0; i < set_.live.size(); ++i) {
            const ClassType& type = set_.type(i);
            if (type.count > 1 && hasInterior(centre, i)) {
                result_.dimension += type.count - 1;
                (type.kind == TypeKind::pressing ? spreadsPressing_ : spreadsGrazing_) = true;
            }
        }
        for (const RationalVector& point : hull.points()) {
            result_.spanning.push_back(asDoubles(point));
        }
        findVertices();
        result_.energy = {set_.leastEnergy, mostEnergy()};
        result_.kind = kind();
        if (isCone(set_.classes.schedule.stops)) {  // what was looked at is a section of it
            result_.kind = SetKind::cone;
            ++result_.dimension;
            result_.energy = {0.0, infinity};
        }
        return std::move(result_);
    }

private:
    /// Can the amplitudes of the type differ from each other at a point inside the polyhedron? The
    /// width of a box is concave in S, so if it is 0 there it is 0 everywhere.
    [[nodiscard]] bool hasInterior(const RationalVector& centre, std::size_t i) const
    {
        if (set_.type(i).kind == TypeKind::pressing) {
            return !centre[i].is_zero();
        }
        const auto [lower, upper] = boundsOf<Rational>(set_.classes, centre, i, 1);
        return lower < upper;
    }

    void findVertices()
    {
        if (set_.live.size() > maxTypesForVertices) {
            return;
        }
        const auto generators = generatorsOf(rows_, maxRays);
        if (!generators) {
            return;
        }
        result_.isBounded = generators->directions.empty();
        for (const Homogeneous& vertex : generators->vertices) {
            vertices_.push_back(asRationals(vertex));
            result_.vertices.push_back(asDoubles(vertices_.back()));
        }
    }

    /// A convex function is largest at a vertex of the whole set: a vertex S, with all of a
    /// pressing sum in one class. Grazing boxes add vertices of their own unless S is fixed.
    [[nodiscard]] double mostEnergy() const
    {
        if (!result_.isBounded) {
            return infinity;
        }
        if (vertices_.empty() || (spreadsGrazing_ && sumDimension_ > 0)) {
            return std::numeric_limits<double>::quiet_NaN();
        }
        if (spreadsGrazing_) {
            return mostEnergyOfBoxes();
        }
        Rational most = 0;
        for (const RationalVector& vertex : vertices_) {
            Rational squares = 0;
            for (const Rational& sum : vertex) {
                squares += sum * sum;
            }
            most = std::max(most, squares);
        }
        return static_cast<double>(inEnergy(most));
    }

    /// S is one point.
    [[nodiscard]] double mostEnergyOfBoxes() const
    {
        const std::vector<double>& sums = result_.spanning.front();
        double squares = 0.0;
        for (std::size_t i = 0; i < sums.size(); ++i) {
            squares += mostSquares(amplitudesAt(set_, sums, i));
        }
        return inEnergy(squares);
    }

    template <typename Number>
    [[nodiscard]] Number inEnergy(const Number& squares) const
    {
        return energyOf(squares, set_.classes.schedule.cells, set_.classes.window);
    }

    [[nodiscard]] SetKind kind() const
    {
        if (result_.dimension == 0) {
            return SetKind::point;
        }
        if (sumDimension_ == 0 && !spreadsPressing_) {
            return SetKind::box;
        }
        const bool isSimplex = !spreadsGrazing_ && result_.isBounded &&
                               vertexCount() == static_cast<double>(result_.dimension) + 1.0;
        return isSimplex ? SetKind::simplex : SetKind::polytope;
    }

    /// Vertices of the set in amplitudes: each positive pressing sum may sit in any of its classes.
    [[nodiscard]] double vertexCount() const
    {
        double count = 0.0;
        for (const RationalVector& vertex : vertices_) {
            double lifts = 1.0;
            for (std::size_t i = 0; i < vertex.size(); ++i) {
                lifts *= vertex[i].is_zero() || set_.type(i).kind == TypeKind::grazing
                             ? 1.0
                             : static_cast<double>(set_.type(i).count);
            }
            count += lifts;
        }
        return count;
    }

    const LumpedSet& set_;
    LumpedRows rows_;
    std::int64_t sumDimension_ = 0;
    bool spreadsPressing_ = false;
    bool spreadsGrazing_ = false;
    std::vector<RationalVector> vertices_;
    LumpedShape result_;
};

}  // namespace

LumpedShape shapeOf(const LumpedSet& set)
{
    return set.absence ? LumpedShape{} : Shape(set).build();
}

}  // namespace signorini
