#include "segments_text.hpp"

#include <fmt/format.h>

#include <charconv>
#include <stdexcept>

namespace signorini {

namespace {

/// Takes a number and the mark after it, if there is more, from the front of a text.
template <typename Number>
bool take(std::string_view& text, Number& value, char mark)
{
    const char* end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, value);
    if (error != std::errc{} || stop == end || *stop != mark) {
        return false;
    }
    text.remove_prefix(static_cast<std::size_t>(stop - text.data()) + 1);
    return true;
}

}  // namespace

std::string textOf(std::span<const Segment> segments)
{
    std::string text;
    for (const Segment& segment : segments) {
        text += fmt::format("{}{}:{}:{}:{}", text.empty() ? "" : ",", segment.cells,
                            segment.impedance, segment.speed, segment.dashpot);
    }
    return text;
}

std::vector<Segment> segmentsOf(std::string_view text)
{
    std::vector<Segment> segments;
    const std::string ended = text.empty() ? "" : std::string(text) + ',';
    for (std::string_view rest = ended; !rest.empty();) {
        Segment segment;
        if (!take(rest, segment.cells, ':') || !take(rest, segment.impedance, ':') ||
            !take(rest, segment.speed, ':') || !take(rest, segment.dashpot, ',')) {
            throw std::invalid_argument(
                fmt::format("segments = {}: allowed cells:impedance:speed:dashpot,...", text));
        }
        segments.push_back(segment);
    }
    return segments;
}

}  // namespace signorini
