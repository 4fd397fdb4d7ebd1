#include "mode_chains.hpp"

#include <algorithm>
#include <utility>

namespace signorini {

namespace {

bool isZero(const LinearForm& form)
{
    return form.rhs == 0 && std::all_of(form.coefficients.begin(), form.coefficients.end(),
                                        [](std::int64_t c) { return c == 0; });
}

LinearForm constant(std::size_t unknowns, std::int64_t value)
{
    return {std::vector<std::int64_t>(unknowns), -value, false, 0};
}

bool isRelease(const std::vector<ModeChain>& chains, const ChainJump& jump)
{
    return jump.k == chains[jump.chain].k;
}

/// A coordinate of a vertex in lowest terms.
ExactPeriod fraction(const Integer& numerator, const Integer& denominator)
{
    const Rational value(numerator, denominator);
    return {static_cast<std::int64_t>(boost::multiprecision::numerator(value)),
            static_cast<std::int64_t>(boost::multiprecision::denominator(value))};
}

/// The walk along all jumps, from one contact to the next.
class Walk {
public:
    Walk(const std::vector<ModeChain>& chains, const std::vector<ChainJump>& jumps)
        : chains_(chains), jumps_(jumps), forms_(chains)
    {
    }

    /// None if the signs do not fit.
    std::optional<ModeRows> run()
    {
        for (std::size_t l = 0; l < chains_.size(); ++l) {
            rows_.gaps.push_back(forms_.contact(l));
            if (!fly(l)) {
                return std::nullopt;
            }
        }
        rows_.window = window();
        return std::move(rows_);
    }

private:
    /// From release l to the next arrival, first down, then up, ...
    bool fly(std::size_t l)
    {
        if (next_ == jumps_.size() || !isRelease(chains_, jumps_[next_]) ||
            chains_[jumps_[next_].chain].release != l) {
            return false;
        }
        LinearForm prefix = constant(chains_.size(), 0);
        LinearForm before = forms_.release(l);
        std::int64_t sign = -1;
        const auto pass = [&](const LinearForm& to) {
            LinearForm gap = plus(to, -1, before);
            prefix = plus(std::move(prefix), sign, gap);
            rows_.gaps.push_back(std::move(gap));
            before = to;
        };
        for (++next_; next_ < jumps_.size() && !isRelease(chains_, jumps_[next_]); ++next_) {
            // Upwards is an odd jump of its chain.
            if ((jumps_[next_].k % 2 == 1) != (sign < 0)) {
                return false;
            }
            pass(forms_.at(jumps_[next_]));
            if (sign > 0) {
                rows_.prefixes.push_back(plus(constant(chains_.size(), 0), -1, prefix));
            }
            sign = -sign;
        }
        pass(forms_.arrival(l + 1));
        if (sign > 0 && !isZero(prefix)) {
            prefix.isEquality = true;
            rows_.closures.push_back(prefix);
        }
        return sign > 0;
    }

    /// -win: 2 is the first jump of chain 0 and whole periods, over which epsilon sums to all
    /// contact.
    [[nodiscard]] LinearForm window() const
    {
        LinearForm sum = constant(chains_.size(), 0);
        LinearForm before = sum;
        std::int64_t sign = 1;
        for (const ChainJump& jump : jumps_) {
            LinearForm at = forms_.at(jump);
            sum = plus(plus(std::move(sum), -sign, at), sign, before);
            before = std::move(at);
            sign = -sign;
            if (jump.chain == 0 && jump.k == 1) {
                for (std::size_t l = 0; l < chains_.size(); ++l) {
                    sum = plus(std::move(sum), -jump.turns, forms_.contact(l));
                }
                break;
            }
        }
        return sum;
    }

    const std::vector<ModeChain>& chains_;
    const std::vector<ChainJump>& jumps_;
    ChainForms forms_;
    ModeRows rows_;
    std::size_t next_ = 0;
};

/// The vertices of a cut cone, and what is read off them.
class Description {
public:
    Description(const PolyhedralCone& cone, const ModeRows& rows) : cone_(cone), rows_(rows) {}

    /// \returns false if all motions have one period.
    bool describe(ModePolytope& polytope) const
    {
        std::vector<RationalVector> points;
        for (const PolyhedralCone::Ray& ray : cone_.rays()) {
            std::vector<ExactPeriod> vertex;
            RationalVector point;
            for (std::size_t i = 0; i + 1 < ray.at.size(); ++i) {
                vertex.push_back(fraction(ray.at[i], ray.at.back()));
                point.emplace_back(ray.at[i], ray.at.back());
            }
            polytope.vertices.push_back(std::move(vertex));
            points.push_back(std::move(point));
        }
        std::sort(polytope.vertices.begin(), polytope.vertices.end(), isBefore);
        const auto [low, high] = std::minmax_element(
            points.begin(), points.end(), [](const auto& l, const auto& r) { return l[0] < r[0]; });
        if ((*low)[0] == (*high)[0]) {
            return false;
        }
        polytope.lowest = polytope.vertices.front().front();
        polytope.highest = polytope.vertices.back().front();
        polytope.lowestEnd = endAt((*low)[0]);
        polytope.highestEnd = endAt((*high)[0]);
        polytope.dimension = dimension(points) - 1;
        setEnergy(polytope, *low, *high);
        return true;
    }

private:
    static bool isBefore(const std::vector<ExactPeriod>& left,
                         const std::vector<ExactPeriod>& right)
    {
        return std::lexicographical_compare(left.begin(), left.end(), right.begin(), right.end(),
                                            [](const ExactPeriod& l, const ExactPeriod& r) {
                                                return Integer(l.numerator) * r.denominator <
                                                       Integer(r.numerator) * l.denominator;
                                            });
    }

    static Rational at(const LinearForm& form, const RationalVector& point)
    {
        Rational value = -form.rhs;
        for (std::size_t i = 0; i < point.size(); ++i) {
            value += form.coefficients[i] * point[i];
        }
        return value;
    }

    static std::int64_t dimension(const std::vector<RationalVector>& points)
    {
        std::vector<RationalVector> edges = points;
        for (RationalVector& edge : edges) {
            for (std::size_t i = 0; i < edge.size(); ++i) {
                edge[i] -= points.front()[i];
            }
        }
        return std::ssize(reduceRows(edges, points.front().size()));
    }

    /// Does the form vanish at all vertices of this period?
    [[nodiscard]] bool vanishesAt(const LinearForm& form, const Rational& period) const
    {
        return std::all_of(cone_.rays().begin(), cone_.rays().end(), [&](const auto& ray) {
            return Rational(ray.at.front(), ray.at.back()) != period ||
                   valueAt(form, ray.at).is_zero();
        });
    }

    [[nodiscard]] ModeEnd endAt(const Rational& period) const
    {
        if (vanishesAt(rows_.window, period)) {
            return ModeEnd::energyInfinite;
        }
        const bool isTouch =
            std::any_of(rows_.gaps.begin(), rows_.gaps.end(), [&](const LinearForm& gap) {
                return gap.tag == contactTag && vanishesAt(gap, period);
            });
        return isTouch ? ModeEnd::contactVanishes : ModeEnd::jumpsMeet;
    }

    /// The energy depends on T alone (docs/theory.md), so two periods tell it.
    void setEnergy(ModePolytope& polytope, const RationalVector& low,
                   const RationalVector& high) const
    {
        const Rational first = at(rows_.window, low) / 2;
        const Rational last = at(rows_.window, high) / 2;
        const Rational slope = (last - first) / (high[0] - low[0]);
        const Homogeneous whole = overCommonDenominator({slope, slope * low[0] - first});
        polytope.kappa = static_cast<std::int64_t>(whole.numerators[0]);
        polytope.mu = static_cast<std::int64_t>(whole.numerators[1]);
        polytope.divisor = static_cast<std::int64_t>(whole.denominator);
    }

    const PolyhedralCone& cone_;
    const ModeRows& rows_;
};

/// Are all motions of an isolated type shorter ones, run several times?
bool isRepetition(const std::vector<ModeChain>& chains, const IntegerVector& point)
{
    const std::size_t count = chains.size();
    const Integer& period = point.front();
    const auto arrival = [&](std::size_t i) {
        return i % count == 0 ? Integer(0) : point[i % count];
    };
    for (std::size_t shift = 1; shift < count; ++shift) {
        if (count % shift != 0 || nameFrom(chains, shift) != nameFrom(chains, 0)) {
            continue;
        }
        bool fits = true;
        for (std::size_t i = 0; i < count && fits; ++i) {
            const Integer ahead =
                arrival(i + shift) - arrival(i) + (i + shift >= count ? period : Integer(0));
            fits = ahead * static_cast<std::int64_t>(count / shift) == period;
        }
        if (fits) {
            return true;
        }
    }
    return false;
}

}  // namespace

LinearForm plus(LinearForm left, std::int64_t factor, const LinearForm& right)
{
    for (std::size_t i = 0; i < left.coefficients.size(); ++i) {
        left.coefficients[i] += factor * right.coefficients[i];
    }
    left.rhs += factor * right.rhs;
    return left;
}

ChainForms::ChainForms(const std::vector<ModeChain>& chains)
    : count_(chains.size()), releases_(chains.size())
{
    for (std::size_t i = 0; i < count_; ++i) {
        releases_[chains[i].release] = at({i, chains[i].k, chains[i].turns});
    }
}

LinearForm ChainForms::arrival(std::size_t i) const
{
    LinearForm form = constant(count_, 0);
    if (i > 0) {
        form.coefficients[i % count_] = 1;
    }
    return form;
}

LinearForm ChainForms::at(const ChainJump& jump) const
{
    LinearForm form = arrival(jump.chain);
    form.coefficients[0] -= jump.turns;
    form.rhs -= 2 * jump.k;
    return form;
}

LinearForm ChainForms::contact(std::size_t l) const
{
    LinearForm form = plus(releases_[l], -1, arrival(l));
    form.tag = contactTag;
    return form;
}

std::optional<ModeRows> rowsOf(const std::vector<ModeChain>& chains,
                               const std::vector<ChainJump>& jumps)
{
    return Walk(chains, jumps).run();
}

PolyhedralCone arrivalCone(std::size_t phases)
{
    PolyhedralCone cone(phases);
    const ChainForms forms(std::vector<ModeChain>(phases, ModeChain{0, 0, 0}));
    for (std::size_t i = 0; i < phases; ++i) {
        const LinearForm between = plus(forms.arrival(i + 1), -1, forms.arrival(i));
        cone.cut(between);
        cone.cut(plus(constant(phases, 4), -1, between));
    }
    return cone;
}

bool cutStrictly(PolyhedralCone& cone, const LinearForm& form)
{
    bool isSomewhere = false;
    bool isBroken = false;
    for (const PolyhedralCone::Ray& ray : cone.rays()) {
        const Integer value = valueAt(form, ray.at);
        isSomewhere = isSomewhere || value > 0;
        isBroken = isBroken || value < 0;
    }
    if (isSomewhere && isBroken) {
        cone.cut(form);
    }
    return isSomewhere;
}

IntegerVector middleOf(const PolyhedralCone& cone)
{
    IntegerVector sum = cone.rays().front().at;
    for (std::size_t k = 1; k < cone.rays().size(); ++k) {
        for (std::size_t i = 0; i < sum.size(); ++i) {
            sum[i] += cone.rays()[k].at[i];
        }
    }
    return sum;
}

std::optional<ModePolytope> polytopeIn(PolyhedralCone cone, const std::vector<ModeChain>& chains,
                                       std::vector<ChainJump> jumps)
{
    const auto rows = rowsOf(chains, jumps);
    if (!rows) {
        return std::nullopt;
    }
    for (const auto* kind : {&rows->closures, &rows->prefixes}) {
        for (const LinearForm& form : *kind) {
            cone.cut(form);
            if (cone.rays().empty()) {
                return std::nullopt;
            }
        }
    }
    if (!cutStrictly(cone, rows->window)) {
        return std::nullopt;
    }
    const IntegerVector middle = middleOf(cone);
    const bool isOpen =
        std::all_of(rows->gaps.begin(), rows->gaps.end(),
                    [&middle](const LinearForm& gap) { return valueAt(gap, middle) > 0; });
    ModePolytope polytope;
    if (!isOpen || !Description(cone, *rows).describe(polytope) ||
        (polytope.dimension == 0 && isRepetition(chains, middle))) {
        return std::nullopt;
    }
    polytope.chains = chains;
    polytope.jumps = std::move(jumps);
    for (const ModeChain& chain : chains) {
        polytope.order += chain.turns;
    }
    return polytope;
}

std::vector<std::int64_t> nameFrom(const std::vector<ModeChain>& chains, std::size_t first)
{
    const std::size_t count = chains.size();
    std::vector<std::int64_t> name(3 * count);
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t place = (i + count - first) % count;
        const ModeChain& chain = chains[i];
        name[place] = chain.k;
        name[count + place] = chain.turns + (i < first ? 1 : 0) - (chain.release < first ? 1 : 0);
        name[2 * count + place] =
            static_cast<std::int64_t>((chain.release + count - first) % count);
    }
    return name;
}

bool isListedName(const std::vector<ModeChain>& chains)
{
    const auto own = nameFrom(chains, 0);
    for (std::size_t first = 1; first < chains.size(); ++first) {
        if (nameFrom(chains, first) > own) {
            return false;
        }
    }
    return true;
}

}  // namespace signorini
