#pragma once
/// \file
/// Collects every fault of an argument, then throws them as one std::invalid_argument.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>

namespace signorini {

/// Text for a message: the middle of what is long is left out.
inline std::string shortened(std::string_view text, std::size_t most = 60)
{
    if (text.size() <= most) {
        return std::string(text);
    }
    // A character of several bytes stays whole.
    const auto isInside = [text](std::size_t at) {
        return (static_cast<unsigned char>(text[at]) & 0xC0U) == 0x80U;
    };
    std::size_t head = most * 2 / 3;
    std::size_t tail = text.size() - (most - head);
    for (int k = 0; k < 3 && isInside(head); ++k) {
        --head;
    }
    for (int k = 0; k < 3 && tail < text.size() && isInside(tail); ++k) {
        ++tail;
    }
    return fmt::format("{}…{}", text.substr(0, head), text.substr(tail));
}

/// What is wrong with a value: how it reads where some are allowed, and where none is.
inline constexpr std::string_view outOfRange = " is out of range: allowed ";
inline constexpr std::string_view notApplied = " is not allowed";

/// One line per check: field, value, allowed range ("none", and where, if no value is), and what to
/// do about it.
class Faults {
public:
    template <typename Value>
    void add(std::string_view field, const Value& value, std::string_view allowed,
             std::string_view remedy = {})
    {
        if (!text_.empty()) {
            text_ += "; ";
        }
        if constexpr (std::is_convertible_v<Value, std::string_view>) {
            text_ += fmt::format("{} = {}", field, shortened(value));
        } else {
            text_ += fmt::format("{} = {}", field, value);
        }
        constexpr std::string_view none = "none";
        const std::string_view rest = allowed.substr(std::min(none.size(), allowed.size()));
        const bool isNone = allowed.starts_with(none) &&
                            (rest.empty() || rest.front() == ' ' || rest.front() == ':');
        text_ += isNone ? notApplied : outOfRange;
        text_ += isNone ? rest : allowed;
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

    void requireWhole(std::string_view field, std::int64_t value, std::int64_t most)
    {
        if (value < 1 || value > most) {
            add(field, value, fmt::format("whole numbers 1..{}", most));
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

/// \throws std::invalid_argument with this one fault.
template <typename Value>
[[noreturn]] void throwFault(std::string_view field, const Value& value, std::string_view allowed,
                             std::string_view remedy = {})
{
    Faults faults;
    faults.add(field, value, allowed, remedy);
    faults.throwIfAny();
    throw std::logic_error("a fault was added");
}

}  // namespace signorini
