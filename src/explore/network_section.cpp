#include "network_section.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace signorini {

namespace {

/// Of rows and pivots that are 0 but for rounding, and of those that are not, relative.
constexpr double noRow = 1e-11;
constexpr double clearRow = 1e-7;

}  // namespace

NetworkSection::NetworkSection(const Network& network, const std::vector<ContactSpan>& schedule,
                               double energy)
    : blocks_(network, schedule, false),
      kernel_(kernelOf<double>(blocks_)),
      norm_(std::sqrt(energy))
{
    if (!kernel_) {
        return;
    }
    conditions_ = rowsOf(blocks_, *kernel_);
    steady_ = steadyCoordinates(blocks_, *kernel_);
    const RowSystem& system = conditions_.system;
    const Eigen::MatrixXd held = system.rows.topRows(system.equalities);
    const LeastSquares equalities(held, noRow);
    isClear_ = kernel_->isClear && conditions_.isClear &&
               equalities.rank() == LeastSquares(held, clearRow).rank();
    const Eigen::VectorXd sums = system.rhs + system.rows * steady_;
    centre_ = equalities.solve(sums.head(system.equalities));
    basis_ = equalities.kernel();
    const Eigen::VectorXd none = Eigen::VectorXd::Zero(steady_.size());
    const double shared =
        energyOf(network, wavesAt(blocks_, *kernel_, none, steadyInputs(*kernel_))) -
        steady_.squaredNorm();
    radius_ = std::sqrt(std::max(0.0, energy - shared - centre_.squaredNorm()));
    enterRows();
}

void NetworkSection::enterRows()
{
    const RowSystem& system = conditions_.system;
    const Eigen::Index below = system.rows.rows() - system.equalities;
    const auto all = system.rows.bottomRows(below);
    rows_ = all * basis_;
    rhs_ = system.rhs.tail(below) + all * (steady_ - centre_);
    // A row that is the same for all t is met by all motions, or by none.
    Eigen::Index kept = 0;
    for (Eigen::Index row = 0; row < below; ++row) {
        if (rows_.row(row).norm() > noRow * all.row(row).norm()) {
            rows_.row(kept) = rows_.row(row);
            rhs_[kept] = rhs_[row];
            ++kept;
        }
    }
    rows_.conservativeResize(kept, Eigen::NoChange);
    rhs_.conservativeResize(kept);
}

Eigen::VectorXd NetworkSection::coordinatesAt(const Eigen::VectorXd& t) const
{
    return centre_ + basis_ * t - steady_;
}

Eigen::VectorXd NetworkSection::unknownsOf(std::span<const double> waves) const
{
    return basis_.transpose() * (coordinatesOf(blocks_, *kernel_, waves) - centre_);
}

NetworkClaim NetworkSection::motionOf(const Eigen::VectorXd& t) const
{
    return motionOf(wavesAt(blocks_, *kernel_, coordinatesAt(t), steadyInputs(*kernel_)));
}

NetworkClaim NetworkSection::motionOf(std::vector<double> waves) const
{
    NetworkClaim claim{std::move(waves)};
    claim.displacements = displacementsAt(blocks_, conditions_, claim.waves);
    claim.schedule = blocks_.schedule();
    return claim;
}

bool NetworkSection::addBroken(const Eigen::VectorXd& t)
{
    const bool areBroken =
        addBrokenStrains(conditions_, blocks_, *kernel_, blocks_.network().strainLimit,
                         coordinatesAt(t), steadyInputs(*kernel_)) > 0;
    if (areBroken) {
        enterRows();
    }
    return areBroken;
}

GreatCircles::GreatCircles(Eigen::VectorXd t, std::uint64_t seed)
    : t_(std::move(t)), generator_(seed)
{
}

const Eigen::VectorXd& GreatCircles::next(const NetworkSection& section, int moves)
{
    for (int k = 0; k < moves; ++k) {
        move(section);
    }
    return t_;
}

void GreatCircles::move(const NetworkSection& section)
{
    constexpr double turn = 2.0 * std::numbers::pi;
    std::normal_distribution<double> normal;
    Eigen::VectorXd way(t_.size());
    for (double& one : way) {
        one = normal(generator_);
    }
    way -= way.dot(t_) / t_.squaredNorm() * t_;
    way *= section.radius() / way.norm();
    // At angle x a row is at size cos(x - middle), so what breaks it is the arc around the other
    // side, wider the higher h is. Rows that rounding breaks here are met.
    const Eigen::VectorXd here = section.rows() * t_;
    const Eigen::VectorXd there = section.rows() * way;
    std::vector<std::pair<double, double>> broken;
    for (Eigen::Index row = 0; row < here.size(); ++row) {
        const double size = std::hypot(here[row], there[row]);
        const double least = std::min(section.rhs()[row], here[row]);
        if (least <= -size) {
            continue;
        }
        const double met = std::acos(std::clamp(least / size, -1.0, 1.0));
        double begin = std::fmod(std::atan2(there[row], here[row]) + met + turn, turn);
        const double width = turn - 2.0 * met;
        if (begin + width > turn) {
            broken.emplace_back(begin, turn);
            broken.emplace_back(0.0, begin + width - turn);
        } else {
            broken.emplace_back(begin, begin + width);
        }
    }
    std::sort(broken.begin(), broken.end());
    std::vector<std::pair<double, double>> free;
    double end = 0.0;
    double total = 0.0;
    for (const auto& [first, last] : broken) {
        if (first > end) {
            free.emplace_back(end, first);
            total += first - end;
        }
        end = std::max(end, last);
    }
    if (end < turn) {
        free.emplace_back(end, turn);
        total += turn - end;
    }
    double drawn = std::uniform_real_distribution<double>(0.0, total)(generator_);
    double angle = 0.0;
    for (const auto& [first, last] : free) {
        if (drawn <= last - first) {
            angle = first + drawn;
            break;
        }
        drawn -= last - first;
    }
    t_ = std::cos(angle) * t_ + std::sin(angle) * way;
    t_ *= section.radius() / t_.norm();
}

}  // namespace signorini
