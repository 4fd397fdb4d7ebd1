#include "network_motions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "energy_floor.hpp"
#include "network_set.hpp"
#include "periodic_multipliers.hpp"

namespace signorini {

namespace {

template <typename Number>
constexpr double broken = isFine<Number> ? 1e-30 : 1e-10;  // a row, of its size
constexpr double negligibleMultiplier = 1e-9;              // of the largest
constexpr double hugeFactor =
    1e7;  // motions of so much more energy than is excluded are no motions

/// Do waves pass a joint, or are they sent back, all but for less than rounding tells from 0?
bool isDelicate(const Network& network)
{
    constexpr double near = 1e-7;
    for (std::size_t node = 0; node < network.nodes.size(); ++node) {
        std::vector<double> impedances;
        for (std::size_t k = 0; k < network.channels(); ++k) {
            if (network.nodeOf(k) == node) {
                impedances.push_back(network.impedanceOf(k));
            }
        }
        const double dashpot = network.nodes[node].dashpot;
        const auto [least, most] = std::minmax_element(impedances.begin(), impedances.end());
        const double rest = (*most - *least) / *most;
        if ((rest > 0.0 && rest < near) || *least < near * *most ||
            (dashpot > 0.0 && dashpot < near * *most)) {
            return true;
        }
    }
    return false;
}

/// Is a row met, or broken, by so little that rounding may have done it, and by too much to be 0?
bool isDoubtful(const RowSystem& system, const Eigen::VectorXd& z)
{
    constexpr double least = 1e-13;
    constexpr double most = 1e-9;
    const double size = z.norm();
    for (Eigen::Index row = system.equalities; row < system.rhs.size(); ++row) {
        const double slack = system.rows.row(row).dot(z) - system.rhs[row];
        const double length = system.rows.row(row).norm() * size + std::abs(system.rhs[row]);
        if (std::abs(slack) > least * length && std::abs(slack) < most * length) {
            return true;
        }
    }
    return false;
}

/// One request.
class Search {
public:
    Search(const NetworkBlocks& blocks, const LeastDemands& demands)
        : blocks_(blocks), demands_(demands)
    {
    }

    LeastMotion run()
    {
        const bool canBeFine = blocks_.stateSize() <= mostFineState;
        const bool isHard = isDelicate(blocks_.network());
        bool isClear = false;
        if (!(isHard && canBeFine)) {
            for (const double zero : {noPivot, clearPivot}) {
                if (attempt<double>(zero, isClear) || isClear || isRequested(demands_.cancel)) {
                    break;
                }
            }
            if (isHard) {
                result_.kernelDimension.reset();
            }
        }
        if (result_.status == Status::undecided && canBeFine && !isRequested(demands_.cancel)) {
            attempt<FineNumber>(noPivot, isClear);
        }
        return std::move(result_);
    }

private:
    /// True if that decided it.
    template <typename Number>
    bool attempt(double zero, bool& isClear)
    {
        isClear = false;
        const auto kernel = kernelOf<Number>(blocks_, zero);
        if (!kernel) {
            result_.detail =
                fmt::format("the kernel of W - 1 is out of reach: more than {} waves in a block",
                            mostKernelState);
            isClear = true;  // no other threshold helps
            return false;
        }
        isClear = kernel->isClear;
        if (isClear) {
            result_.kernelDimension = kernel->dimension;
        }
        NetworkRows<Number> rows = rowsOf(blocks_, *kernel);
        const Eigen::Index unlimited = rows.system.rhs.size();
        // Waves that constant forces make are part of the energy, and of the way to a target.
        VectorOf<Number> from = -steadyCoordinates(blocks_, *kernel);
        if (demands_.target) {
            from += coordinatesOf(blocks_, *kernel, *demands_.target);
        }
        RowSystemOf<Number> system;
        LeastNormOf<Number> least;
        do {
            system = rows.system;
            system.rhs -= system.rows * from;
            least = leastNorm(system, broken<Number>, std::sqrt(demands_.absent * hugeFactor),
                              demands_.cancel);
            result_.how.solver.iterations += least.steps;
        } while (least.end == LeastNormEnd::found &&
                 addBrokenStrains(rows, blocks_, *kernel, blocks_.network().strainLimit,
                                  VectorOf<Number>(from + least.z), steadyInputs(*kernel)) > 0);
        if (least.end == LeastNormEnd::stopped) {
            result_.detail = isRequested(demands_.cancel)
                                 ? "cancelled"
                                 : "rounding does not tell which conditions are in force";
            return false;
        }
        if constexpr (!isFine<Number>) {
            if (least.end == LeastNormEnd::found && blocks_.stateSize() <= mostFineState &&
                (!rows.isClear || isDoubtful(system, least.z))) {
                result_.detail = "rounding does not tell which conditions are met";
                isClear = true;
                return false;
            }
        }
        enterMultipliers(*kernel, rows, least.multipliers.template cast<double>());
        if (least.end == LeastNormEnd::empty) {
            return enterAbsence();
        }
        const VectorOf<Number> forces = steadyInputs(*kernel);
        if (kernel->hasForces) {
            result_.steady = wavesAt(blocks_, *kernel, VectorOf<Number>(0.0 * from), forces);
        }
        NetworkClaim claim{wavesAt(blocks_, *kernel, VectorOf<Number>(from + least.z), forces)};
        claim.displacements = displacementsAt(blocks_, rows, claim.waves);
        const bool isFound = enterMotion(result_, blocks_, std::move(claim), demands_.tolerance);
        if (isFound && isClear && demands_.asksSet && !isDelicate(blocks_.network())) {
            enterSet(*kernel, rows, unlimited);
        }
        return isFound;
    }

    /// Of rows but for those of limits on strain, which come last.
    template <typename Number>
    void enterSet(const NetworkKernel<Number>& kernel, const NetworkRows<Number>& rows,
                  Eigen::Index unlimited)
    {
        NetworkKernel<double> sizes;
        sizes.firsts = kernel.firsts;
        sizes.dimension = kernel.dimension;
        NetworkRows<double> all;
        all.system = {rows.system.rows.topRows(unlimited).template cast<double>(),
                      rows.system.rhs.head(unlimited).template cast<double>(),
                      rows.system.equalities};
        all.conditions.assign(rows.conditions.begin(),
                              rows.conditions.begin() + static_cast<std::ptrdiff_t>(unlimited));
        all.tied = rows.tied;
        if (const auto dimension = dimensionOfSet(blocks_, sizes, all, demands_.cancel)) {
            result_.dimension = *dimension;
            result_.kind = *dimension == 0              ? SetKind::point
                           : all.system.rhs.isZero(0.0) ? SetKind::cone
                                                        : SetKind::polytope;
        }
    }

    template <typename Number>
    void enterMultipliers(const NetworkKernel<Number>& kernel, const NetworkRows<Number>& rows,
                          const Eigen::VectorXd& values)
    {
        const std::vector<BlockCondition>& conditions = rows.conditions;
        result_.unproved = conditionsOf(blocks_, kernel, rows, values);
        result_.conditions.clear();
        const double least =
            values.size() > 0 ? negligibleMultiplier * values.cwiseAbs().maxCoeff() : 0.0;
        for (std::size_t k = 0; k < conditions.size(); ++k) {
            if (std::abs(values[static_cast<Eigen::Index>(k)]) > least) {
                result_.conditions.push_back(conditions[k]);
            }
        }
    }

    bool enterAbsence()
    {
        result_.isEmpty = true;
        prove(result_, blocks_, demands_.relaxed != nullptr ? *demands_.relaxed : blocks_.network(),
              demands_.cancel);
        if (result_.provedEnergy >= demands_.absent) {
            result_.status = Status::none;
            result_.detail.clear();
            if (reasonOf(result_, blocks_) != Reason::constraints) {
                result_.kind = SetKind::empty;
            }
            return true;
        }
        result_.detail = "conditions exclude each other by no more than rounding can do";
        return false;
    }

    const NetworkBlocks& blocks_;
    const LeastDemands& demands_;
    LeastMotion result_;
};

}  // namespace

Provenance howOf(const NetworkBlocks& blocks, std::string reason)
{
    Provenance how;
    how.reason = std::move(reason);
    const auto types = static_cast<std::int64_t>(blocks.types().size());
    if (types < blocks.unit()) {
        how.leftOut.push_back(
            fmt::format("all but {} of the {} steps: residues mod {} obey equations of their own, "
                        "alike in blocks",
                        blocks.turns() * types, blocks.turns() * blocks.unit(), blocks.unit()));
    }
    how.leftOut.emplace_back("closure of the last flight: periodicity implies it");
    enterSolver(how, "active-set");
    return how;
}

void enterSolver(Provenance& how, std::string_view solver)
{
    how.solver.name = solver;
    how.route = fmt::format("{} on the kernel formulation", solver);
}

LeastMotion leastMotion(const NetworkBlocks& blocks, const LeastDemands& demands)
{
    return Search(blocks, demands).run();
}

template <typename Number>
VectorOf<Number> coordinatesOf(const NetworkBlocks& blocks, const NetworkKernel<Number>& kernel,
                               std::span<const double> waves)
{
    const std::vector<double> impedances = impedancesOf(blocks.network());
    VectorOf<Number> z(kernel.coordinates());
    for (Eigen::Index k = 0; k < z.size(); ++k) {
        const std::vector<double> x =
            wavesAt(blocks, kernel, VectorOf<Number>(VectorOf<Number>::Unit(z.size(), k)),
                    VectorOf<Number>(0.0 * steadyInputs(kernel)));
        double sum = 0.0;
        for (std::size_t i = 0; i < x.size(); ++i) {
            sum += x[i] * impedances[i] * waves[i];
        }
        z[k] = sum;
    }
    return z;
}
template VectorOf<double> coordinatesOf(const NetworkBlocks&, const NetworkKernel<double>&,
                                        std::span<const double>);
template VectorOf<FineNumber> coordinatesOf(const NetworkBlocks&, const NetworkKernel<FineNumber>&,
                                            std::span<const double>);

template <typename Number>
VectorOf<Number> steadyCoordinates(const NetworkBlocks& blocks, const NetworkKernel<Number>& kernel)
{
    const VectorOf<Number> none = VectorOf<Number>::Zero(kernel.coordinates());
    return kernel.hasForces
               ? coordinatesOf(blocks, kernel, wavesAt(blocks, kernel, none, steadyInputs(kernel)))
               : none;
}
template VectorOf<double> steadyCoordinates(const NetworkBlocks&, const NetworkKernel<double>&);
template VectorOf<FineNumber> steadyCoordinates(const NetworkBlocks&,
                                                const NetworkKernel<FineNumber>&);

double energyOf(const Network& network, std::span<const double> waves)
{
    const std::vector<double> impedances = impedancesOf(network);
    double sum = 0.0;
    for (std::size_t k = 0; k < waves.size(); ++k) {
        sum += impedances[k] * waves[k] * waves[k];
    }
    return sum;
}

bool enterMotion(LeastMotion& result, const NetworkBlocks& blocks, NetworkClaim claim,
                 double tolerance)
{
    claim.schedule = blocks.schedule();
    result.residuals = walk(blocks.network(), claim);
    if (!(result.residuals.worst() <= tolerance)) {
        result.detail = fmt::format("the motion that was found leaves a residual of {:.3g}",
                                    result.residuals.worst());
        return false;
    }
    if (const double excess = strainExcess(blocks.network(), claim, result.residuals.extremes);
        !(excess <= tolerance)) {
        result.detail =
            fmt::format("the motion that was found exceeds the limit on strain by {:.3g}", excess);
        return false;
    }
    result.status = Status::found;
    result.isEmpty = false;
    result.detail.clear();
    result.energy = energyOf(blocks.network(), claim.waves);
    result.motion = std::move(claim);
    return true;
}

void prove(LeastMotion& motion, const NetworkBlocks& blocks, const Network& network,
           const Cancel& cancel)
{
    motion.multipliers = motion.unproved;
    // Where there is a motion those of the least one: eta is near Z times what forces make.
    completeFloor(motion.multipliers, network, blocks.schedule(), cancel,
                  motion.isEmpty ? std::span<const double>() : motion.steady);
    motion.provedEnergy = provedEnergy(motion.multipliers, network, blocks.schedule());
}

Reason reasonOf(const LeastMotion& motion, const NetworkBlocks& blocks)
{
    if (motion.kernelDimension == 0) {
        return Reason::noLiveClass;
    }
    const ContactSet first = blocks.schedule().front().closed;
    bool isOfGap = true;
    bool isOfContact = true;
    for (const BlockCondition& condition : motion.conditions) {
        if (condition.kind == BlockCondition::Kind::strain) {
            return Reason::constraints;
        }
        const bool isStart =
            condition.kind != BlockCondition::Kind::push &&
            (condition.kind == BlockCondition::Kind::tie || contains(first, condition.contact)) &&
            condition.type == 0 && condition.turn == 0;
        isOfGap = isOfGap && isStart;
        isOfContact = isOfContact && (isStart || condition.kind == BlockCondition::Kind::push);
    }
    return isOfGap ? Reason::gap : isOfContact ? Reason::contactSign : Reason::penetration;
}

}  // namespace signorini
