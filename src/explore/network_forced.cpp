#include "network_forced.hpp"

#include <Eigen/LU>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>

#include "network_simulation.hpp"
#include "periodic_multipliers.hpp"

namespace signorini {

namespace {

constexpr double leastPivot = 1e-10;  // of 1 - W; below it the waves are anyone's guess
constexpr double noPivot = 1e-12;     // that is 0 but for rounding

bool isInTime(NetworkCondition::Kind kind)
{
    return kind == NetworkCondition::Kind::place || kind == NetworkCondition::Kind::push;
}

NetworkWaves<double> started(const Network& network, const Eigen::VectorXd& x)
{
    return {network, std::span(x.data(), static_cast<std::size_t>(x.size()))};
}

}  // namespace

NetworkForced::NetworkForced(Network network, std::vector<ContactSpan> schedule,
                             std::vector<StepDrive> shapes)
    : network_(std::move(network)),
      schedule_(std::move(schedule)),
      shapes_(std::move(shapes)),
      scale_(static_cast<Eigen::Index>(network_.waves()))
{
    Eigen::Index next = 0;
    for (const CellRow& row : network_.rows) {
        scale_.segment(next, 2 * row.cells).setConstant(std::sqrt(row.impedance));
        next += 2 * row.cells;
    }
    for (const Stub& stub : network_.stubs) {
        scale_[next++] = std::sqrt(stub.impedance);
    }
    for (const NetworkNode& node : network_.nodes) {
        forces_ += std::abs(node.force);
    }
    const Network still = withoutForces(network_);
    for (const ContactSpan& span : schedule_) {
        laws_.emplace_back(still, span.closed);
        if (!(still == network_)) {
            forcedLaws_.emplace_back(network_, span.closed);
        }
    }
    list();
    choosePivots();
    solve();
    if (isClear_) {
        read();
    }
}

Eigen::VectorXd NetworkForced::carried(const Eigen::VectorXd& x, const Laws& laws,
                                       const StepDrive* shape) const
{
    NetworkWaves<double> waves = started(network_, x);
    std::size_t m = 0;
    for (std::size_t k = 0; k < schedule_.size(); ++k) {
        for (const auto end = m + static_cast<std::size_t>(schedule_[k].steps); m < end; ++m) {
            waves.step(laws[k], shape != nullptr ? shape->forces[m] : 0.0,
                       shape != nullptr ? shape->velocities[m] : 0.0);
        }
    }
    const std::vector<double> all = waves.waves();
    return Eigen::Map<const Eigen::VectorXd>(all.data(), x.size());
}

/// In the norm of the energy.
void NetworkForced::solve()
{
    const Eigen::Index size = scale_.size();
    Eigen::MatrixXd change = Eigen::MatrixXd::Identity(size, size);
    for (Eigen::Index k = 0; k < size; ++k) {
        const Eigen::VectorXd unit = Eigen::VectorXd::Unit(size, k) / scale_[k];
        change.col(k) -= carried(unit, laws_, nullptr).cwiseProduct(scale_);
    }
    std::vector<Eigen::VectorXd> made;
    const Eigen::VectorXd none = Eigen::VectorXd::Zero(size);
    for (const StepDrive& shape : shapes_) {
        made.emplace_back(carried(none, laws_, &shape).cwiseProduct(scale_));
    }
    steady_ = none;
    if (!forcedLaws_.empty()) {
        steady_ = carried(none, forcedLaws_, nullptr).cwiseProduct(scale_);
    }
    kernel_.resize(size, 0);
    // Of free waves only the kernel matters.
    const Eigen::PartialPivLU<Eigen::MatrixXd> factors(change);
    const Eigen::VectorXd pivots = factors.matrixLU().diagonal().cwiseAbs();
    if (pivots.minCoeff() > leastPivot && factors.rcond() > leastPivot) {
        for (const Eigen::VectorXd& wave : made) {
            driven_.emplace_back(factors.solve(wave).cwiseQuotient(scale_));
        }
        steady_ = factors.solve(steady_).cwiseQuotient(scale_);
        return;
    }
    Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> ranked;
    ranked.setThreshold(leastPivot);
    ranked.compute(change);
    const Eigen::Index rank = ranked.rank();
    const auto diagonal = ranked.matrixQTZ().diagonal().cwiseAbs();
    isClear_ = std::all_of(diagonal.begin() + rank, diagonal.end(),
                           [](double pivot) { return pivot < noPivot; });
    if (!isClear_) {
        return;
    }
    Eigen::MatrixXd last = Eigen::MatrixXd::Zero(size, size - rank);
    last.bottomRows(size - rank).setIdentity();
    const Eigen::MatrixXd kernel = ranked.householderQ() * last;  // of the transpose, too
    for (const Eigen::VectorXd& wave : made) {
        driven_.emplace_back(ranked.solve(wave).cwiseQuotient(scale_));
    }
    for (Eigen::Index k = 0; k < kernel.cols(); ++k) {
        const auto on = [&](std::size_t shape) {
            return shape < made.size() ? kernel.col(k).dot(made[shape]) : 0.0;
        };
        work_.push_back({on(0), on(1)});
    }
    const Eigen::VectorXd work = kernel.transpose() * steady_;
    steadyWork_.assign(work.begin(), work.end());
    steady_ = ranked.solve(steady_).cwiseQuotient(scale_);
    kernel_ = scale_.cwiseInverse().asDiagonal() * kernel;
}

/// Distances of open contacts, but right after a closed step, where they are 0; those that close,
/// that of the first step in front.
void NetworkForced::list()
{
    using Kind = NetworkCondition::Kind;
    const auto isClosed = [](const ContactSpan& span, std::size_t contact) {
        return contains(span.closed, contact);
    };
    std::int64_t step = 0;
    for (std::size_t k = 0; k < schedule_.size(); ++k) {
        const ContactSpan& before = schedule_[(k == 0 ? schedule_.size() : k) - 1];
        for (std::int64_t m = 0; m < schedule_[k].steps; ++m, ++step) {
            for (std::size_t j = 0; j < network_.contacts.size(); ++j) {
                const bool was = isClosed(m == 0 ? before : schedule_[k], j);
                const bool is = isClosed(schedule_[k], j);
                if (!was) {
                    conditions_.push_back({Kind::place, j, step, is});
                }
                if (is) {
                    conditions_.push_back({Kind::push, j, step, false});
                }
            }
        }
    }
    ties_ = tiesOf(network_);
    for (std::size_t k = 0; k < ties_.size(); ++k) {
        conditions_.push_back({Kind::tie, 0, static_cast<std::int64_t>(k), true});
    }
    bars_ = driftingBars(network_);
    for (std::size_t j = 0; j < network_.contacts.size(); ++j) {
        driftsAt_.push_back(driftsOf(network_, j));
    }
    for (std::size_t k = 0; k < bars_.size(); ++k) {
        conditions_.push_back({Kind::drift, 0, static_cast<std::int64_t>(k), true});
    }
}

std::vector<double> NetworkForced::watch(const Eigen::VectorXd& x, const Laws& laws,
                                         const StepDrive* shape) const
{
    std::vector<double> distances;
    for (std::size_t j = 0; j < network_.contacts.size(); ++j) {
        std::vector<double> row(network_.waves(), 0.0);
        const double byPlace = addDistance(row, network_, j, 1.0);
        double sum = shape != nullptr ? byPlace * shape->places.front() : 0.0;
        for (std::size_t k = 0; k < row.size(); ++k) {
            sum += row[k] * x[static_cast<Eigen::Index>(k)];
        }
        distances.push_back(sum);
    }
    NetworkWaves<double> waves = started(network_, x);
    std::vector<double> values;
    values.reserve(conditions_.size());
    std::vector<double> ways(bars_.size(), 0.0);
    auto next = conditions_.begin();
    std::int64_t step = 0;
    for (std::size_t k = 0; k < schedule_.size(); ++k) {
        const NetworkLaw<double>& law = laws[k];
        for (std::int64_t m = 0; m < schedule_[k].steps; ++m, ++step) {
            const auto at = static_cast<std::size_t>(step);
            const double force = shape != nullptr ? shape->forces[at] : 0.0;
            const double base = shape != nullptr ? shape->velocities[at] : 0.0;
            for (; next != conditions_.end() && next->step == step && isInTime(next->kind);
                 ++next) {
                values.push_back(next->kind == NetworkCondition::Kind::place
                                     ? distances[next->contact]
                                     : law.push(next->contact).at(waves.arriving(), force, base));
            }
            const auto speed = [&](std::size_t node) {
                return law.velocity(node).at(waves.arriving(), force, base);
            };
            for (std::size_t j = 0; j < bars_.size(); ++j) {
                ways[j] += speed(network_.bars[bars_[j]].firstNode);
            }
            for (std::size_t j = 0; j < distances.size(); ++j) {
                const NetworkContact& contact = network_.contacts[j];
                const double v = speed(contact.node);
                distances[j] += contact.kind == ContactKind::stopLeft ? v : -v;
                distances[j] += contact.kind == ContactKind::gap ? speed(contact.node + 1) : 0.0;
            }
            waves.step(law, force, base);
        }
    }
    for (const std::vector<double>& tie : ties_) {
        values.push_back(Eigen::Map<const Eigen::VectorXd>(tie.data(), x.size()).dot(x));
    }
    values.insert(values.end(), ways.begin(), ways.end());
    return values;
}

std::vector<double> NetworkForced::waves(Plane place, std::span<const double> free) const
{
    Eigen::VectorXd x = steady_;
    for (std::size_t k = 0; k < driven_.size(); ++k) {
        x += (k == 0 ? place.c : place.s) * driven_[k];
    }
    for (std::size_t k = 0; k < free.size(); ++k) {
        x += free[k] * kernel_.col(static_cast<Eigen::Index>(k));
    }
    return {x.begin(), x.end()};
}

std::vector<double> NetworkForced::displacements(Plane place, std::span<const double> free) const
{
    Eigen::VectorXd drifts = drifts_[shapes_.size()];
    for (std::size_t k = 0; k < shapes_.size(); ++k) {
        drifts += (k == 0 ? place.c : place.s) * drifts_[k];
    }
    for (std::size_t k = 0; k < free.size(); ++k) {
        drifts += free[k] * drifts_[shapes_.size() + 1 + k];
    }
    const std::vector<double> all = waves(place, free);
    std::vector<double> places = displacementsOf(
        network_, all, std::span(drifts.data(), static_cast<std::size_t>(drifts.size())));
    double base = 0.0;
    for (std::size_t k = 0; k < shapes_.size(); ++k) {
        base += (k == 0 ? place.c : place.s) * shapes_[k].places.front();
    }
    for (std::size_t node = 0; node < places.size(); ++node) {
        const auto clamp = displacementOf(network_, node).clamp;
        places[node] += clamp && network_.nodes[*clamp].isShaken ? base : 0.0;
    }
    return places;
}

std::vector<double> NetworkForced::contradiction(std::span<const std::size_t> rows,
                                                 std::optional<Plane> way) const
{
    const auto count = static_cast<Eigen::Index>(rows.size());
    Eigen::MatrixXd parts = Eigen::MatrixXd::Zero(3 + kernel_.cols(), count);
    for (Eigen::Index k = 0; k < count; ++k) {
        const ForcedRow& row = rows_[rows[static_cast<std::size_t>(k)]];
        parts(0, k) = row.limit;
        parts(1, k) = row.plane.c;
        parts(2, k) = row.plane.s;
        for (const auto& [wave, factor] : row.free) {
            parts(3 + static_cast<Eigen::Index>(wave), k) = factor;
        }
    }
    Eigen::VectorXd right = Eigen::VectorXd::Unit(parts.rows(), 0);
    if (way) {
        right.head(3) << 0.0, -way->c, -way->s;
    }
    const Eigen::VectorXd found = parts.completeOrthogonalDecomposition().solve(right);
    if (!((parts * found - right).norm() < 1e-6)) {
        return {};
    }
    std::vector<double> multipliers(found.begin(), found.end());
    for (std::size_t k = 0; k < rows.size(); ++k) {
        if (!rows_[rows[k]].isEquality) {
            multipliers[k] = std::max(multipliers[k], 0.0);
        }
    }
    return multipliers;
}

EnergyFloor NetworkForced::floor(std::span<const std::size_t> rows,
                                 std::span<const double> multipliers, bool isLeast) const
{
    EnergyFloor floor;
    Eigen::VectorXd works = Eigen::VectorXd::Zero(scale_.size());
    std::vector<double> ways(bars_.size(), 0.0);
    Eigen::VectorXd left = Eigen::VectorXd::Zero(driftBy_.rows());  // of displacements that drift
    for (std::size_t k = 0; k < rows.size(); ++k) {
        const NetworkCondition& condition = conditions_[rows[k]];
        if (multipliers[k] == 0.0 || condition.kind == NetworkCondition::Kind::tie) {
            continue;
        }
        if (condition.kind == NetworkCondition::Kind::drift) {
            ways[static_cast<std::size_t>(condition.step)] += multipliers[k];
        } else if (condition.kind == NetworkCondition::Kind::work) {
            works += multipliers[k] * kernel_.col(static_cast<Eigen::Index>(condition.step));
        } else {
            (condition.kind == NetworkCondition::Kind::place ? floor.places : floor.pushes)
                .push_back({condition.contact, condition.step, multipliers[k]});
        }
        if (condition.kind == NetworkCondition::Kind::place) {
            for (const auto& [bar, sign] : driftsAt_[condition.contact]) {
                left[static_cast<Eigen::Index>(bar)] += sign * multipliers[k];
            }
        }
    }
    const Eigen::VectorXd tied = driftBy_.transpose() * left;
    for (std::size_t k = 0; k < tied_.size(); ++k) {
        floor.places.push_back(
            {tied_[k].contact, tied_[k].step, tied[static_cast<Eigen::Index>(k)]});
    }
    works = works.cwiseProduct(scale_).cwiseProduct(scale_);
    floor.periodicity.assign(works.begin(), works.end());
    floor.periodicity.insert(floor.periodicity.end(), ways.begin(), ways.end());
    completeFloor(floor, network_, schedule_, {},
                  isLeast ? std::span(steady_.data(), static_cast<std::size_t>(steady_.size()))
                          : std::span<const double>());
    return floor;
}

}  // namespace signorini
