#pragma once
/// \file
/// Classes and types for any number of contact phases: the unknowns that are left of (30).
///
/// As in reduction.hpp the n steps of a period fall into G = gcd(2N, n) classes m = alpha G + j.
/// Cut 0..G-1 at every phase boundary modulo G: at most 2K runs of neighbouring classes remain, the
/// **types**. All classes of a type meet contact and free flight in the same alpha, so they share
/// one sign pattern, p_{alpha G + j} = epsilon_alpha z_j. A type is
///
/// - dead: an odd number of free steps per class, p = 0;
/// - blocked: the kernel allows an amplitude, but contact steps ask for both signs, so z = 0;
/// - pressing: it has contact steps; epsilon is taken +1 there, so z >= 0;
/// - grazing: it has none, and z is free in sign.

#include <cstdint>
#include <vector>

#include "signorini/schedule.hpp"

namespace signorini {

/// What the contact steps of a type allow.
enum class TypeKind { dead, blocked, pressing, grazing };

/// A run of neighbouring classes with one sign pattern.
struct ClassType {
    std::int64_t first = 0;           ///< j of its first class
    std::int64_t count = 0;           ///< [-], d, number of classes
    TypeKind kind = TypeKind::dead;   ///< whether amplitudes live on it, and of which sign
    std::vector<std::int8_t> signs;   ///< epsilon_alpha, alpha = 0..nu-1; empty if dead
    std::int64_t windowSum = 0;       ///< [-], sum of epsilon over a window of 2N steps
    std::int64_t contactMembers = 0;  ///< [-], contact steps in each class

    /// Does it carry amplitudes?
    [[nodiscard]] bool isLive() const
    {
        return kind == TypeKind::pressing || kind == TypeKind::grazing;
    }
};

/// The classes of a schedule, type by type.
struct ClassTypes {
    Schedule schedule;                 ///< folded; all counts refer to it
    std::int64_t classes = 0;          ///< [-], G
    std::int64_t members = 0;          ///< [-], nu, steps in a class
    std::int64_t window = 0;           ///< [-], w = 2N/G
    std::int64_t kernelDimension = 0;  ///< [-], dim ker(W - 1): classes that are not dead
    std::vector<ClassType> types;      ///< in ascending order of `first`; together all G classes
};

/// Finds classes and types. O(nu K) time and memory.
/// \throws std::invalid_argument on an invalid schedule.
[[nodiscard]] ClassTypes classTypes(const Schedule& schedule);

/// Steps alpha G + first .. alpha G + first + count - 1: one type in one turn, all of one kind.
struct Block {
    std::int64_t alpha = 0;  ///< 0..nu-1
    std::size_t type = 0;    ///< index into ClassTypes::types
    std::size_t phase = 0;   ///< index into the phases of the schedule
    bool isContact = false;  ///< held, or flying
    bool endsPhase = false;  ///< last block of its phase's flight
};

/// First step of each stretch of contact or flight in turn, and n at the end. O(K).
[[nodiscard]] std::vector<std::int64_t> stretchesOf(const Schedule& schedule);

/// Calls action(block) for every block of one period in the order of time, without storing any.
/// O(nu K).
template <typename Action>
void forEachBlock(const ClassTypes& classes, Action action)
{
    const std::vector<std::int64_t> stretches = stretchesOf(classes.schedule);
    std::size_t stretch = 0;
    for (std::int64_t alpha = 0; alpha < classes.members; ++alpha) {
        for (std::size_t type = 0; type < classes.types.size(); ++type) {
            const ClassType& run = classes.types[type];
            const std::int64_t step = alpha * classes.classes + run.first;
            stretch += step == stretches[stretch + 1] ? 1 : 0;
            const bool isContact = stretch % 2 == 0;
            action(Block{.alpha = alpha,
                         .type = type,
                         .phase = stretch / 2,
                         .isContact = isContact,
                         .endsPhase = !isContact && step + run.count == stretches[stretch + 1]});
        }
    }
}

/// All blocks of one period in the order of time. O(nu K).
[[nodiscard]] std::vector<Block> blocksOf(const ClassTypes& classes);

}  // namespace signorini
