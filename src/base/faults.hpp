#pragma once
/// \file
/// Collects every fault of an argument, then throws them as one std::invalid_argument.

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>
#include <string>
#include <string_view>

namespace signorini {

/// One line per check: field, value, allowed range, and what to do about it.
class Faults {
public:
    template <typename Value>
    void add(std::string_view field, const Value& value, std::string_view allowed,
             std::string_view remedy = {})
    {
        if (!text_.empty()) {
            text_ += "; ";
        }
        text_ += fmt::format("{} = {} is out of range: allowed {}", field, value, allowed);
        if (!remedy.empty()) {
            text_ += fmt::format(" ({})", remedy);
        }
    }

    void requirePositive(std::string_view field, double value, std::string_view unit)
    {
        if (!(std::isfinite(value) && value > 0.0)) {
            add(field, value, fmt::format("finite and > 0 [{}]", unit));
        }
    }

    /// \throws std::invalid_argument with all faults found, if there are any.
    void throwIfAny() const
    {
        if (!text_.empty()) {
            throw std::invalid_argument(text_);
        }
    }

private:
    std::string text_;
};

}  // namespace signorini
