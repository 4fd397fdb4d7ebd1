#include "least_norm.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

namespace signorini {

namespace {

using std::abs;

/// Part of a row of length 1 that rows in force do not make.
template <typename Number>
constexpr double dependent = isFine<Number> ? 1e-30 : 1e-10;

template <typename Number>
class ActiveSet {
    using Vector = VectorOf<Number>;
    using Matrix = MatrixOf<Number>;

public:
    ActiveSet(const RowSystemOf<Number>& system, double tolerance, double largest)
        : system_(system),
          tolerance_(tolerance),
          largest_(largest),
          lengths_(system.rows.rowwise().norm()),
          z_(Vector::Zero(system.rows.cols())),
          u_(Vector::Zero(system.rows.rows()))
    {
    }

    LeastNormOf<Number> run(const Cancel& cancel)
    {
        const std::int64_t most = 50 + 10 * (system_.rows.cols() + system_.rows.rows());
        while (steps_ < most && !isRequested(cancel)) {
            const auto broken = mostBroken();
            if (!broken) {
                return ended(LeastNormEnd::found);
            }
            if (!enforce(*broken, most)) {
                return ended(LeastNormEnd::empty);
            }
        }
        return ended(LeastNormEnd::stopped);
    }

private:
    struct Broken {
        Eigen::Index row;
        double sign;  ///< -1 where an equality is exceeded
    };

    [[nodiscard]] LeastNormOf<Number> ended(LeastNormEnd end) const
    {
        return {end, z_, u_, steps_};
    }

    [[nodiscard]] Number slack(Eigen::Index row) const
    {
        return system_.rows.row(row).dot(z_) - system_.rhs[row];
    }

    /// Equalities come first.
    [[nodiscard]] std::optional<Broken> mostBroken() const
    {
        std::optional<Broken> worst;
        const Number size = z_.norm();
        Number most = tolerance_;
        for (Eigen::Index row = 0; row < system_.rows.rows(); ++row) {
            if (row == system_.equalities && worst) {
                return worst;
            }
            if (std::find(active_.begin(), active_.end(), row) != active_.end()) {
                continue;
            }
            const Number by = slack(row);
            const Number length = lengths_[row] * size + abs(system_.rhs[row]);
            const Number missing = row < system_.equalities ? Number(abs(by)) : Number(-by);
            // A row that no z changes misses by what it misses.
            const Number broken = lengths_[row] > 0.0 ? Number(missing / length) : missing;
            if (broken > most) {
                most = broken;
                worst = Broken{row, by > 0.0 ? -1.0 : 1.0};
            }
        }
        return worst;
    }

    /// Multipliers of rows in force that come nearest to `normal`.
    [[nodiscard]] Vector madeOf(const Vector& normal) const
    {
        if (active_.empty()) {
            return {};
        }
        Matrix columns(normal.size(), static_cast<Eigen::Index>(active_.size()));
        for (std::size_t k = 0; k < active_.size(); ++k) {
            columns.col(static_cast<Eigen::Index>(k)) = system_.rows.row(active_[k]).transpose();
        }
        return OrthogonalFactors<Number>(columns).solve(normal);
    }

    /// Moves until the row is met. False if it contradicts those in force.
    bool enforce(const Broken& broken, std::int64_t most)
    {
        const Vector normal = broken.sign * system_.rows.row(broken.row).transpose();
        Number taken = 0.0;  // multiplier of the new row
        while (steps_++ < most) {
            const Vector r = madeOf(normal);
            Vector way = normal;
            for (std::size_t k = 0; k < active_.size(); ++k) {
                way -= r[static_cast<Eigen::Index>(k)] * system_.rows.row(active_[k]).transpose();
            }
            const Number square = way.squaredNorm();
            const bool isFree = way.norm() > dependent<Number> * lengths_[broken.row];
            const Number missing = -broken.sign * slack(broken.row);
            const Number full = isFree ? Number(missing / square) : never;
            const auto [leaving, part] = firstToLeave(r);
            const Number step = std::min(full, part);
            if (!(step < never) || (isFree && (z_ + step * way).norm() > largest_)) {
                contradict(broken, r);
                return false;
            }
            for (std::size_t k = 0; k < active_.size(); ++k) {
                u_[active_[k]] -= step * r[static_cast<Eigen::Index>(k)];
            }
            taken += step;
            if (isFree) {
                z_ += step * way;
            }
            if (full <= part) {
                u_[broken.row] = broken.sign * taken;
                active_.push_back(broken.row);
                return true;
            }
            u_[active_[leaving]] = 0.0;
            active_.erase(active_.begin() + static_cast<std::ptrdiff_t>(leaving));
        }
        return true;
    }

    struct Leaving {
        std::size_t index = 0;
        Number step = never;
    };

    /// The inequality in force whose multiplier vanishes first.
    [[nodiscard]] Leaving firstToLeave(const Vector& r) const
    {
        Leaving first;
        for (std::size_t k = 0; k < active_.size(); ++k) {
            const Number& rate = r[static_cast<Eigen::Index>(k)];
            if (active_[k] >= system_.equalities && rate > 0.0 &&
                u_[active_[k]] / rate < first.step) {
                first = {k, std::max(Number(0), u_[active_[k]]) / rate};
            }
        }
        return first;
    }

    /// The row is made of others in force, which ask for less.
    void contradict(const Broken& broken, const Vector& r)
    {
        u_.setZero();
        u_[broken.row] = broken.sign;
        for (std::size_t k = 0; k < active_.size(); ++k) {
            const Number value = -r[static_cast<Eigen::Index>(k)];
            u_[active_[k]] = active_[k] < system_.equalities ? value : std::max(Number(0), value);
        }
    }

    inline static const Number never = std::numeric_limits<Number>::infinity();

    const RowSystemOf<Number>& system_;
    double tolerance_;
    double largest_;
    Vector lengths_;
    Vector z_;
    Vector u_;
    std::vector<Eigen::Index> active_;
    std::int64_t steps_ = 0;
};

}  // namespace

template <typename Number>
LeastNormOf<Number> leastNorm(const RowSystemOf<Number>& system, double tolerance, double largest,
                              const Cancel& cancel)
{
    return ActiveSet<Number>(system, tolerance, largest).run(cancel);
}

template LeastNormOf<double> leastNorm(const RowSystemOf<double>&, double, double, const Cancel&);
template LeastNormOf<FineNumber> leastNorm(const RowSystemOf<FineNumber>&, double, double,
                                           const Cancel&);

}  // namespace signorini
