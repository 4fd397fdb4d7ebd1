#pragma once
/// \file
/// The members of the library's plain structs, listed once: what makes two of them equal, and what
/// a pickle holds. A struct that gains a member no longer compiles here until it is listed.

#include <tuple>
#include <utility>

#include "signorini/signorini.hpp"

namespace signorini::python {

/// Pointers to all members of T, in the order of its declaration.
template <typename T>
struct Members {
};

template <typename A, typename B>
struct Members<std::pair<A, B>> {
    static constexpr auto list = std::tuple{&std::pair<A, B>::first, &std::pair<A, B>::second};
};

template <typename T>
concept HasMembers = requires
{
    Members<T>::list;
};

namespace detail {

/// Becomes any member in a braced list.
struct AnyMember {
    template <typename T>
    operator T() const;  // NOLINT: that it converts is its purpose
};

template <typename T, typename... Given>
constexpr std::size_t countMembers()
{
    if constexpr (requires { T{Given{}..., AnyMember{}}; }) {
        return countMembers<T, Given..., AnyMember>();
    } else {
        return sizeof...(Given);
    }
}

}  // namespace detail

/// Does the list name every member?
template <typename T>
constexpr bool isWhole()
{
    return std::tuple_size_v<std::remove_cvref_t<decltype(Members<T>::list)>> ==
           detail::countMembers<T>();
}

// One line for each struct.
#define SIGNORINI_MEMBERS(Type, ...)                          \
    template <>                                               \
    struct Members<Type> {                                    \
        using T = Type;                                       \
        static constexpr auto list = std::tuple{__VA_ARGS__}; \
    };                                                        \
    static_assert(isWhole<Type>(), "a member of " #Type " is not listed")

SIGNORINI_MEMBERS(Bar, &T::length, &T::waveSpeed, &T::axialStiffness, &T::gap, &T::young);
SIGNORINI_MEMBERS(Segment, &T::cells, &T::impedance, &T::speed, &T::dashpot);
SIGNORINI_MEMBERS(Phase, &T::contact, &T::free, &T::stop);
SIGNORINI_MEMBERS(Fraction, &T::numerator, &T::denominator);
SIGNORINI_MEMBERS(Stops, &T::right, &T::left);
SIGNORINI_MEMBERS(ExactEnergy, &T::numerator, &T::denominator);
SIGNORINI_MEMBERS(Schedule, &T::cells, &T::phases, &T::stops);
SIGNORINI_MEMBERS(EnergyRange, &T::least, &T::most);
SIGNORINI_MEMBERS(State, &T::a, &T::b);
SIGNORINI_MEMBERS(Physical, &T::frequency, &T::contactTime, &T::peakForce, &T::impulse,
                  &T::approachSpeed, &T::peakCompression, &T::peakTension, &T::peakStress,
                  &T::tipLowest);
SIGNORINI_MEMBERS(Residuals, &T::periodicity, &T::gap, &T::pressure, &T::penetration, &T::march,
                  &T::demands);
SIGNORINI_MEMBERS(AmplitudeSet, &T::kind, &T::count, &T::sum, &T::lower, &T::upper);
SIGNORINI_MEMBERS(HeldEnergy, &T::dimension, &T::isConnected, &T::components);
SIGNORINI_MEMBERS(Family, &T::order, &T::blocks, &T::contactBlocks, &T::windowSum);
SIGNORINI_MEMBERS(TentPlace, &T::family, &T::classes, &T::amplitudes, &T::offset);
SIGNORINI_MEMBERS(Mode, &T::a, &T::b, &T::lowest, &T::highest, &T::lowestEnd, &T::highestEnd,
                  &T::kappa, &T::mu, &T::gapSign);
SIGNORINI_MEMBERS(ModeChain, &T::release, &T::k, &T::turns);
SIGNORINI_MEMBERS(ChainJump, &T::chain, &T::k, &T::turns);
SIGNORINI_MEMBERS(ModePolytope, &T::chains, &T::jumps, &T::order, &T::dimension, &T::lowest,
                  &T::highest, &T::lowestEnd, &T::highestEnd, &T::kappa, &T::mu, &T::divisor,
                  &T::vertices);
SIGNORINI_MEMBERS(MotionSet, &T::kernelDimension, &T::kind, &T::dimension, &T::amplitudes,
                  &T::energy, &T::family, &T::held);
SIGNORINI_MEMBERS(FoundMotion, &T::state, &T::contact, &T::canonical, &T::repetitions, &T::pressing,
                  &T::isSymmetric, &T::energy, &T::energyRatio, &T::physical, &T::residuals);
SIGNORINI_MEMBERS(Multiplier, &T::row, &T::value);
SIGNORINI_MEMBERS(FarkasCertificate, &T::gap, &T::size, &T::periodicity, &T::pressure,
                  &T::penetration);
SIGNORINI_MEMBERS(InfeasibilityProof, &T::equalities, &T::inequalities);
SIGNORINI_MEMBERS(FixedValue, &T::wave, &T::cell, &T::value);
SIGNORINI_MEMBERS(Demands, &T::objective, &T::target, &T::strainLimit, &T::tipFloor, &T::fixed,
                  &T::energyRatio);
SIGNORINI_MEMBERS(ProgramProof, &T::multipliers, &T::rows, &T::demands, &T::tolerance);
SIGNORINI_MEMBERS(EnergyExclusion, &T::energyRatio, &T::range, &T::tolerance, &T::strainLimit,
                  &T::isVerified);
SIGNORINI_MEMBERS(RationalMultiplier, &T::row, &T::value);
SIGNORINI_MEMBERS(RationalProof, &T::equalities, &T::inequalities);
SIGNORINI_MEMBERS(SteppedProof, &T::multipliers, &T::tipFloor, &T::tolerance);
SIGNORINI_MEMBERS(ContactMultiplier, &T::contact, &T::step, &T::value);
SIGNORINI_MEMBERS(EnergyFloor, &T::periodicity, &T::places, &T::pushes);
SIGNORINI_MEMBERS(EnergyFloorProof, &T::multipliers, &T::energyRatio, &T::tipFloor, &T::tolerance,
                  &T::held);
SIGNORINI_MEMBERS(Absence, &T::reason, &T::proof);
SIGNORINI_MEMBERS(SolverReport, &T::name, &T::iterations, &T::seconds);
SIGNORINI_MEMBERS(Provenance, &T::route, &T::reason, &T::leftOut, &T::objective, &T::solver);
SIGNORINI_MEMBERS(PeriodicResult, &T::status, &T::detail, &T::schedule, &T::scene, &T::period,
                  &T::frequencyRatio, &T::set, &T::motion, &T::absence, &T::how);
SIGNORINI_MEMBERS(ContinuumPoint, &T::lambda, &T::state, &T::energyRatio, &T::residual,
                  &T::peakStrain);
SIGNORINI_MEMBERS(Continuum, &T::status, &T::detail, &T::reason, &T::connected, &T::components,
                  &T::resolution, &T::schedule, &T::scene, &T::energyRatio, &T::energyRange,
                  &T::dimension, &T::solver, &T::parameter, &T::family, &T::points, &T::orbits);
SIGNORINI_MEMBERS(AtlasFamily, &T::id, &T::cells, &T::family, &T::top, &T::steps, &T::kind,
                  &T::dimension, &T::energy, &T::schedules);
SIGNORINI_MEMBERS(AtlasRow, &T::number, &T::status, &T::reason, &T::kernelDimension, &T::kind,
                  &T::dimension, &T::contact, &T::isCanonical, &T::energy, &T::steps,
                  &T::familyTop);
SIGNORINI_MEMBERS(AtlasEntry, &T::schedule, &T::row, &T::family);
SIGNORINI_MEMBERS(AtlasTally, &T::decided, &T::pressing, &T::grazing, &T::refuted, &T::undecided,
                  &T::families);
SIGNORINI_MEMBERS(AtlasRange, &T::cells, &T::maxContact, &T::maxFree, &T::maxPhases,
                  &T::maxEnergyRatio, &T::keepsRefuted, &T::familiesOnly, &T::gapSign, &T::segments,
                  &T::secondStop);
SIGNORINI_MEMBERS(AtlasRun, &T::id, &T::range, &T::nextBatch, &T::batches, &T::tally, &T::seconds);
SIGNORINI_MEMBERS(Damping, &T::ratio);
SIGNORINI_MEMBERS(Excitation, &T::place, &T::values, &T::stepsPerCrossing);
SIGNORINI_MEMBERS(Forcing, &T::place, &T::cycles, &T::shape);
SIGNORINI_MEMBERS(Extremes, &T::period, &T::contactTime, &T::peakForce, &T::impulse,
                  &T::approachSpeed, &T::peakCompression, &T::peakTension, &T::lowestTip);
SIGNORINI_MEMBERS(ForcedMotion, &T::schedule, &T::damping, &T::excitation, &T::amplitude, &T::phase,
                  &T::state, &T::extremes, &T::residual, &T::stability);
SIGNORINI_MEMBERS(ForcedCondition, &T::rule, &T::step);
SIGNORINI_MEMBERS(ForcedLimits, &T::strain);
SIGNORINI_MEMBERS(ForcedCorner, &T::place, &T::free);
SIGNORINI_MEMBERS(AmplitudeExclusion, &T::amplitude, &T::conflict, &T::cuts, &T::isCertain);
SIGNORINI_MEMBERS(AmplitudeBranch, &T::contact, &T::least, &T::most);
SIGNORINI_MEMBERS(ForcedSet, &T::schedule, &T::damping, &T::forcing, &T::limits, &T::segments,
                  &T::status, &T::detail, &T::reason, &T::conflict, &T::cuts, &T::kind,
                  &T::leastAmplitude, &T::mostAmplitude, &T::foot, &T::direction, &T::low, &T::high,
                  &T::freeWaves, &T::corners, &T::waves);
SIGNORINI_MEMBERS(ResponseRange, &T::cells, &T::damping, &T::place, &T::amplitude, &T::derivative,
                  &T::cycles, &T::leastFrequencyRatio, &T::mostFrequencyRatio, &T::contacts,
                  &T::band, &T::stops, &T::segments);
SIGNORINI_MEMBERS(TwoContactBranch, &T::phases, &T::least, &T::most);
SIGNORINI_MEMBERS(PermanentContact, &T::leastForce, &T::extremes, &T::residual);
SIGNORINI_MEMBERS(FrequencyResponse, &T::steps, &T::frequencyRatio, &T::linearPeak, &T::touches,
                  &T::undecided, &T::detail, &T::permanent, &T::motions, &T::branches,
                  &T::twoContacts);
SIGNORINI_MEMBERS(Piece, &T::duration, &T::value);
SIGNORINI_MEMBERS(Waves, &T::crossing, &T::a, &T::b, &T::base);
SIGNORINI_MEMBERS(ContactEvent, &T::start, &T::end, &T::impulse, &T::peakForce, &T::meanForce,
                  &T::speed, &T::energy, &T::stop);
SIGNORINI_MEMBERS(TipPoint, &T::time, &T::displacement);
SIGNORINI_MEMBERS(EnergyBalance, &T::work, &T::dissipated, &T::error, &T::size);
SIGNORINI_MEMBERS(Settled, &T::periods, &T::residual, &T::contacts, &T::impulse);
SIGNORINI_MEMBERS(Settling, &T::settled, &T::why);

/// It has constructors of its own, and so no list of braces to count.
template <>
struct Members<Scene> {
    static constexpr auto list = std::tuple{&Scene::bar, &Scene::secondStop, &Scene::segments};
};

}  // namespace signorini::python
