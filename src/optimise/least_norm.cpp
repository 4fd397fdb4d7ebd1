#include "least_norm.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

namespace signorini {

namespace {

constexpr double dependent = 1e-10;  // part of a row of length 1 that rows in force do not make

class ActiveSet {
public:
    ActiveSet(const RowSystem& system, double tolerance, double largest)
        : system_(system),
          tolerance_(tolerance),
          largest_(largest),
          lengths_(system.rows.rowwise().norm()),
          z_(Eigen::VectorXd::Zero(system.rows.cols())),
          u_(Eigen::VectorXd::Zero(system.rows.rows()))
    {
    }

    LeastNorm run(const Cancel& cancel)
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

    [[nodiscard]] LeastNorm ended(LeastNormEnd end) const { return {end, z_, u_, steps_}; }

    [[nodiscard]] double slack(Eigen::Index row) const
    {
        return system_.rows.row(row).dot(z_) - system_.rhs[row];
    }

    /// Equalities come first.
    [[nodiscard]] std::optional<Broken> mostBroken() const
    {
        std::optional<Broken> worst;
        const double size = z_.norm();
        double most = tolerance_;
        for (Eigen::Index row = 0; row < system_.rows.rows(); ++row) {
            if (row == system_.equalities && worst) {
                return worst;
            }
            if (std::find(active_.begin(), active_.end(), row) != active_.end()) {
                continue;
            }
            const double by = slack(row);
            const double length = lengths_[row] * size + std::abs(system_.rhs[row]);
            const double broken =
                (row < system_.equalities ? std::abs(by) : -by) / (length > 0.0 ? length : 1.0);
            if (broken > most) {
                most = broken;
                worst = Broken{row, by > 0.0 ? -1.0 : 1.0};
            }
        }
        return worst;
    }

    /// Multipliers of rows in force that come nearest to `normal`.
    [[nodiscard]] Eigen::VectorXd madeOf(const Eigen::VectorXd& normal) const
    {
        if (active_.empty()) {
            return {};
        }
        const Eigen::MatrixXd columns = system_.rows(active_, Eigen::all).transpose();
        return Eigen::HouseholderQR<Eigen::MatrixXd>(columns).solve(normal);
    }

    /// Moves until the row is met. False if it contradicts those in force.
    bool enforce(const Broken& broken, std::int64_t most)
    {
        const Eigen::VectorXd normal = broken.sign * system_.rows.row(broken.row).transpose();
        double taken = 0.0;  // multiplier of the new row
        while (steps_++ < most) {
            const Eigen::VectorXd r = madeOf(normal);
            Eigen::VectorXd way = normal;
            if (!active_.empty()) {
                way -= system_.rows(active_, Eigen::all).transpose() * r;
            }
            const double square = way.squaredNorm();
            const bool isFree = way.norm() > dependent * lengths_[broken.row];
            const double missing = -broken.sign * slack(broken.row);
            const double full = isFree ? missing / square : std::numeric_limits<double>::infinity();
            const auto [leaving, part] = firstToLeave(r);
            const double step = std::min(full, part);
            if (!std::isfinite(step) || (isFree && (z_ + step * way).norm() > largest_)) {
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
        double step = std::numeric_limits<double>::infinity();
    };

    /// The inequality in force whose multiplier vanishes first.
    [[nodiscard]] Leaving firstToLeave(const Eigen::VectorXd& r) const
    {
        Leaving first;
        for (std::size_t k = 0; k < active_.size(); ++k) {
            const double rate = r[static_cast<Eigen::Index>(k)];
            if (active_[k] >= system_.equalities && rate > 0.0 &&
                u_[active_[k]] / rate < first.step) {
                first = {k, std::max(0.0, u_[active_[k]]) / rate};
            }
        }
        return first;
    }

    /// The row is made of others in force, which ask for less.
    void contradict(const Broken& broken, const Eigen::VectorXd& r)
    {
        u_.setZero();
        u_[broken.row] = broken.sign;
        for (std::size_t k = 0; k < active_.size(); ++k) {
            const double value = -r[static_cast<Eigen::Index>(k)];
            u_[active_[k]] = active_[k] < system_.equalities ? value : std::max(0.0, value);
        }
    }

    const RowSystem& system_;
    double tolerance_;
    double largest_;
    Eigen::VectorXd lengths_;
    Eigen::VectorXd z_;
    Eigen::VectorXd u_;
    std::vector<Eigen::Index> active_;
    std::int64_t steps_ = 0;
};

}  // namespace

LeastNorm leastNorm(const RowSystem& system, double tolerance, double largest, const Cancel& cancel)
{
    return ActiveSet(system, tolerance, largest).run(cancel);
}

}  // namespace signorini
