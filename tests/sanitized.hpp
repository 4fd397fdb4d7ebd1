#pragma once
/// \file
/// What tests do less often where addresses are watched, which takes several times as long and sees
/// what is done, not how often; and where tools/build-and-test tries another choice of back ends.

#include <cstdlib>

// Defined for what is not watched itself, but calls what is.
#if defined(SIGNORINI_IS_SANITIZED)
#elif defined(__SANITIZE_ADDRESS__)
#define SIGNORINI_IS_SANITIZED 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
#define SIGNORINI_IS_SANITIZED 1
#endif
#endif

namespace signorini::test {

#ifdef SIGNORINI_IS_SANITIZED
inline constexpr bool isSanitized = true;
#else
inline constexpr bool isSanitized = false;
#endif

inline bool drawsFew()
{
    return isSanitized || std::getenv("SIGNORINI_FEW_DRAWS") != nullptr;
}

/// So many draws, or what they show; there a fifth.
inline int drawn(int most)
{
    return drawsFew() ? most / 5 : most;
}

}  // namespace signorini::test
