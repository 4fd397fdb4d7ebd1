#pragma once
/// \file
/// Catch2, whichever major version is installed.

#include <string>

#if __has_include(<catch2/catch_all.hpp>)
#include <catch2/catch_all.hpp>
using Catch::Approx;
inline auto containsText(const std::string& text)
{
    return Catch::Matchers::ContainsSubstring(text);
}
#else
#include <catch2/catch.hpp>
inline auto containsText(const std::string& text)
{
    return Catch::Matchers::Contains(text);
}
#endif
