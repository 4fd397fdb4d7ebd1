#pragma once
/// \file
/// What tests do less often where addresses are watched, which takes several times as long and sees
/// what is done, not how often.

#if defined(__SANITIZE_ADDRESS__)
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

/// So many draws, or what they show; there a fifth.
constexpr int drawn(int most)
{
    return isSanitized ? most / 5 : most;
}

}  // namespace signorini::test
