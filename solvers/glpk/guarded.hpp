#pragma once
/// \file
/// Calls of GLPK that come back where GLPK would end the process: out of memory, or a failed check.
///
/// GLPK reports both through a hook that must not return. The hook here jumps back to the caller,
/// as GLPK's manual proposes. Only frames of C and of plain lambdas lie between, so that no
/// destructor is passed over.

#include <glpk.h>

#include <type_traits>

#include "signorini/control.hpp"

namespace signorini::glpk {

/// A call ended because it was asked to.
struct Cancelled {};

/// A problem object of GLPK in the environment of this thread.
class Problem {
public:
    /// Also silences GLPK in this thread. `cancel` is asked whenever GLPK has something to say of
    /// its progress, and must live as long as this. \throws std::bad_alloc.
    explicit Problem(const Cancel& cancel = {});
    Problem(const Problem&) = delete;
    Problem& operator=(const Problem&) = delete;
    ~Problem();

    [[nodiscard]] glp_prob* get() const { return handle_; }

    /// Runs `call(glp_prob*)`, which calls GLPK and holds nothing that needs a destructor.
    /// \throws std::bad_alloc if GLPK is out of memory, std::runtime_error with its words if a
    /// check of its own fails, Cancelled. Then the problem is gone, and nothing but destroying this
    /// is allowed. Its memory is given back unless the thread has other objects of GLPK, which stay
    /// as they are.
    template <typename Call>
    void run(Call call)
    {
        static_assert(std::is_trivially_destructible_v<Call>, "GLPK may jump out of it");
        attempt([](void* data, glp_prob* problem) { (*static_cast<Call*>(data))(problem); }, &call);
    }

private:
    void attempt(void (*call)(void*, glp_prob*), void* data);
    void freeAll();
    [[noreturn]] void giveUp(const char* words);

    glp_prob* handle_ = nullptr;
    const Cancel* cancel_ = nullptr;  ///< none: GLPK is not asked to speak
    bool isAlone_ = false;            ///< was GLPK's environment of this thread empty before?
};

}  // namespace signorini::glpk
