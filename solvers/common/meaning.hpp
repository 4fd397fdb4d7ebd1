#pragma once
/// \file
/// What the codes of a library mean.

#include <algorithm>
#include <span>

#include "solver.hpp"

namespace signorini {

/// A code, the claim that it stands for, and words for people.
struct Meaning {
    int code;
    SolverStatus status;
    const char* detail;

    void enter(SolverResult& result) const
    {
        result.status = status;
        result.detail = detail;
    }
};

/// That of a code; of one that is not among them a failure, with these words.
[[nodiscard]] inline Meaning meaningOf(int code, std::span<const Meaning> all, const char* unknown)
{
    const auto found = std::find_if(all.begin(), all.end(),
                                    [code](const Meaning& one) { return one.code == code; });
    return found != all.end() ? *found : Meaning{code, SolverStatus::failed, unknown};
}

}  // namespace signorini
