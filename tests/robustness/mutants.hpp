// What mutations.py writes into the copy of the library that it spoils (schemata.py): operations
// that change when the mutant of their number is on. SIGNORINI_MUTANT is that number;
// SIGNORINI_MUTANTS_RUN names a file that receives the numbers of all that were met.
#pragma once
#pragma GCC system_header
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wsign-compare"
#pragma GCC diagnostic ignored "-Wparentheses"
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
// The tests of mutants notice what is read out of bounds.
#ifndef _GLIBCXX_ASSERTIONS
#define _GLIBCXX_ASSERTIONS
#endif
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <initializer_list>
#include <type_traits>

namespace mutants {
inline unsigned char met[50000];

struct Switch {
    int number = 0;
    const char* file = std::getenv("SIGNORINI_MUTANTS_RUN");
    Switch()
    {
        if (const char* text = std::getenv("SIGNORINI_MUTANT"))
            number = std::atoi(text);
    }
    ~Switch()
    {
        std::FILE* out = file ? std::fopen(file, "w") : nullptr;
        for (int i = 0; out && i < 50000; ++i)
            if (met[i])
                std::fprintf(out, "%d\n", i);
        if (out)
            std::fclose(out);
    }
};
inline Switch chosen;

constexpr bool is_on(int number)
{
    if (std::is_constant_evaluated())
        return false;
    if (chosen.number == 0)
        met[number] = 1;
    return chosen.number == number;
}

template <class A, class B>
concept Numbers = std::is_arithmetic_v<A> && std::is_arithmetic_v<B>;

// Numbers are passed by value, which lambdas may do with constants that they do not capture.
#define SIGNORINI_MUTANT_OPERATION(name, sign, other)                                \
    template <class A, class B>                                                      \
    requires Numbers<A, B>                                                           \
    constexpr auto name(int number, A a, B b)                                        \
    {                                                                                \
        return is_on(number) ? a other b : a sign b;                                 \
    }                                                                                \
    template <class A, class B>                                                      \
    requires(!Numbers<A, B>) constexpr auto name(int number, const A& a, const B& b) \
    {                                                                                \
        return is_on(number) ? a other b : a sign b;                                 \
    }
SIGNORINI_MUTANT_OPERATION(less, <, <=)
SIGNORINI_MUTANT_OPERATION(less_equal, <=, <)
SIGNORINI_MUTANT_OPERATION(greater, >, >=)
SIGNORINI_MUTANT_OPERATION(greater_equal, >=, >)
SIGNORINI_MUTANT_OPERATION(equal, ==, !=)
SIGNORINI_MUTANT_OPERATION(unequal, !=, ==)
SIGNORINI_MUTANT_OPERATION(plus, +, -)
SIGNORINI_MUTANT_OPERATION(minus, -, +)
#undef SIGNORINI_MUTANT_OPERATION

template <class A, class B>
constexpr A& add(int number, A& a, const B& b)
{
    return is_on(number) ? a -= b : a += b;
}
template <class A, class B>
constexpr A& subtract(int number, A& a, const B& b)
{
    return is_on(number) ? a += b : a -= b;
}
constexpr int zero(int number)
{
    return is_on(number) ? 1 : 0;
}
template <class T>
constexpr T min(int number, T a, T b)
{
    return is_on(number) ? std::max(a, b) : std::min(a, b);
}
template <class T>
constexpr T max(int number, T a, T b)
{
    return is_on(number) ? std::min(a, b) : std::max(a, b);
}
template <class T>
constexpr T min(int number, std::initializer_list<T> values)
{
    return is_on(number) ? std::max(values) : std::min(values);
}
template <class T>
constexpr T max(int number, std::initializer_list<T> values)
{
    return is_on(number) ? std::min(values) : std::max(values);
}
}  // namespace mutants
