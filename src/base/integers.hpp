#pragma once
/// \file
/// Whole numbers of any size the problem can have: 64-bit arithmetic that refuses to wrap.
///
/// Step counts are `std::int64_t` everywhere. Sums and products of user data go through these two
/// functions; everything derived from a validated Schedule is bounded (see schedule.hpp) and uses
/// plain arithmetic.

#include <cstdint>
#include <stdexcept>
#include <utility>

namespace signorini {

/// a + b. \throws std::overflow_error if the sum does not fit in 64 bits.
[[nodiscard]] inline std::int64_t checkedAdd(std::int64_t a, std::int64_t b)
{
    std::int64_t result = 0;
    if (__builtin_add_overflow(a, b, &result)) {
        throw std::overflow_error("64-bit sum overflows");
    }
    return result;
}

/// a * b. \throws std::overflow_error if the product does not fit in 64 bits.
[[nodiscard]] inline std::int64_t checkedMultiply(std::int64_t a, std::int64_t b)
{
    std::int64_t result = 0;
    if (__builtin_mul_overflow(a, b, &result)) {
        throw std::overflow_error("64-bit product overflows");
    }
    return result;
}

/// x in 0..modulus-1 with x * value = 1 (mod modulus), by Euclid's algorithm. \pre both > 0, and
/// coprime.
[[nodiscard]] constexpr std::int64_t inverseOf(std::int64_t value, std::int64_t modulus)
{
    std::int64_t rest = modulus;
    std::int64_t next = value % modulus;
    std::int64_t factor = 0;  // factor * value = rest (mod modulus)
    std::int64_t nextFactor = 1;
    while (next != 0) {
        const std::int64_t quotient = rest / next;
        rest = std::exchange(next, rest - quotient * next);
        factor = std::exchange(nextFactor, factor - quotient * nextFactor);
    }
    return factor < 0 ? factor + modulus : factor;
}

}  // namespace signorini
