#pragma once
/// \file
/// What a call asks, ready to be answered: at once, or in a thread of its own.

#include <functional>

#include "call.hpp"
#include "signorini/control.hpp"

namespace signorini::answers {

/// What may end a long answer, and what is told how far it is.
struct Watch {
    Cancel cancel = {};
    std::function<void(double done, double total)> show = {};

    /// Options of the library that end and tell so.
    template <typename Options>
    [[nodiscard]] Options on(Options options) const
    {
        options.cancel = cancel;
        if constexpr (requires { options.progress; }) {
            options.progress = show;
        }
        return options;
    }
};

/// It owns all that it uses.
template <typename Answer>
using Question = std::function<Answer(const Watch& watch)>;

/// \throws std::invalid_argument where a period has too many steps for --stability.
void requireTried(std::int64_t steps);

/// The same question, and where --stability is given starts beside the motions, whose periods have
/// so many steps. \throws as requireTried.
template <typename Answer>
[[nodiscard]] Question<Answer> tried(const Call& call, std::int64_t steps,
                                     Question<Answer> question)
{
    if (!call.has("--stability")) {
        return question;
    }
    requireTried(steps);
    return [question = std::move(question)](const Watch& watch) {
        Answer answer = question(watch);
        tryStability(answer, watch.cancel);
        return answer;
    };
}

}  // namespace signorini::answers
