#include "segments_text.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "text.hpp"

namespace signorini {

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
        if (!takeNumberBefore(rest, ':', segment.cells) ||
            !takeNumberBefore(rest, ':', segment.impedance) ||
            !takeNumberBefore(rest, ':', segment.speed) ||
            !takeNumberBefore(rest, ',', segment.dashpot)) {
            throw std::invalid_argument(
                fmt::format("segments = {}: allowed cells:impedance:speed:dashpot,...", text));
        }
        segments.push_back(segment);
    }
    return segments;
}

}  // namespace signorini
