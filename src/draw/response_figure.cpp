#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "axes.hpp"
#include "excited_amplitude.hpp"
#include "signorini/figures.hpp"
#include "stepped_bar.hpp"
#include "two_panels.hpp"

namespace signorini {

namespace {

using namespace plot;

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

/// How motions are drawn that do so where disturbed a little: those that last stand out.
struct Sort {
    const char* words;
    Marker marker;
    double size;
    std::optional<Stability> stability;
};

const std::array<Sort, 4> sorts{{{": repels", Marker::disc, 0.28, Stability::repels},
                                 {": not clear", Marker::square, 0.5, Stability::unclear},
                                 {": attracts", Marker::disc, 1.0, Stability::attracts},
                                 {"", Marker::disc, 0.6, std::nullopt}}};

/// What the tip touches in a period.
struct Touched {
    const char* words;
    Role role;
    std::size_t phases;
    Stop first;
    Stop last;
};

const std::array<Touched, 5> touches{
    {{"one contact", Role::contact, 1, Stop::right, Stop::right},
     {"one, on the second stop", Role::strain, 1, Stop::left, Stop::left},
     {"one on each stop", Role::ink, 2, Stop::right, Stop::left},
     {"two contacts", Role::strain, 2, Stop::right, Stop::right},
     {"two, on the second stop", Role::velocity, 2, Stop::left, Stop::left}}};

/// "150:1, 150:1.3": cells and impedance of each; the first of many.
std::string segmentsOf(const ResponseRange& range)
{
    constexpr std::size_t most = 4;
    std::string text;
    for (std::size_t k = 0; k < std::min(most, range.segments.size()); ++k) {
        const Segment& segment = range.segments[k];
        text += fmt::format("{}{}:{:.4g}", k == 0 ? "" : ", ", segment.cells,
                            segment.impedance / range.segments.front().impedance);
    }
    return text + (range.segments.size() > most ? ", …" : "");
}

std::string titleOf(const ResponseRange& range, const Bar& bar)
{
    const bool hasUnit = range.stops.right != 0;
    const double amplitude = range.amplitude * amplitudeUnit(range.place, bar, range.derivative);
    return fmt::format("{} of amplitude {},  ζ = {:.4g},  N = {}{}{}{}",
                       range.place == Excited::tip ? "force on the tip" : "base moving",
                       withUnit(amplitude, amplitudeUnitName(range.place, range.derivative)),
                       range.damping.ratio, range.cells,
                       range.stops.right < 0 ? ",  g < 0"
                       : hasUnit             ? ""
                                             : ",  g = 0",
                       range.cycles > 1
                           ? fmt::format(",  period of {} cycles of the excitation", range.cycles)
                           : "",
                       isUniform(range.segments) ? "" : ",  segments " + segmentsOf(range));
}

/// Impulse and swing of what is drawn, over the same frequencies.
class ResponsePanels {
public:
    ResponsePanels(std::span<const FrequencyResponse> frequencies, const ResponseRange& range,
                   const Bar& bar)
        : frequencies_(frequencies), range_(range), bar_(bar)
    {
        const bool hasUnit = range.stops.right != 0;
        const std::string gap = range.stops.right < 0 ? "|g|" : hasUnit ? "g" : "L";
        const double impulse = bar.axialStiffness * scales(bar).strain * scales(bar).time;
        panels_ = {.upper = {.name = "impulse",
                             .place = {0.12, 0.88, 0.53, 0.83},
                             .legend = Legend::topLeft},
                   .lower = {.name = "tip", .place = {0.12, 0.88, 0.12, 0.48}},
                   .above = {"impulse per period", "N s", impulse, "EA " + gap + "/c"},
                   .below = {"swing  −min u(L)", "m", scales(bar).displacement, gap, 1.08}};
        double swing = hasUnit ? 2.0 : 0.0;
        if (range.stops.left) {
            swing = std::max(swing, range.stops.left->value());
        }
        for (const FrequencyResponse& response : frequencies) {
            swing = std::max(swing, hasUnit ? 0.0 : response.linearPeak);
            if (!response.motions.empty()) {
                first_ = std::min(first_, response.frequencyRatio);
                last_ = std::max(last_, response.frequencyRatio);
            }
        }
        panels_.below.largest = swing * panels_.below.scale;
    }

    FigureData figure()
    {
        const auto [least, most] =
            std::minmax(frequencies_.front().frequencyRatio, frequencies_.back().frequencyRatio);
        const double margin = most > least ? 0.01 * (most - least) : 0.05;
        addModes();
        addLinear();
        addMotions();
        addSecondStop(least - margin, most + margin);
        return std::move(panels_).figure(
            titleOf(range_, bar_),
            frequencyAxis("frequency of the excitation", least - margin, most + margin, bar_));
    }

private:
    void add(SeriesPair& pair, double frequency, const Extremes& extremes) const
    {
        pair.add(frequency, extremes.impulse * panels_.above.scale,
                 -extremes.lowestTip * panels_.below.scale);
    }

    /// The backbones of a uniform bar, as far as there are motions.
    void addModes()
    {
        if (!isUniform(range_.segments) || !(last_ > 0.0)) {
            return;
        }
        SeriesPair modes(plot::line(Role::shade6, 5.0));
        for (const Backbone& backbone : backbonesOf(first_, last_, range_.cycles, range_.stops)) {
            for (const BackbonePoint& point : backbone.points) {
                add(modes, point.frequencyRatio, point.extremes);
            }
            modes.breakOff();
        }
        panels_.add(std::move(modes), "modes: free, undamped", false);
    }

    /// The bar without a wall: where it stays clear, and where the wall is in its way.
    void addLinear()
    {
        SeriesPair clear(plot::line(Role::ink, 2.0));
        SeriesPair blocked(plot::line(Role::faint, 1.5, Dash::dashed));
        for (std::size_t k = 0; k < frequencies_.size(); ++k) {
            const FrequencyResponse& response = frequencies_[k];
            const bool isNear = k > 0 && frequencies_[k - 1].touches != response.touches;
            const double peak = response.linearPeak * panels_.below.scale;
            for (SeriesPair* pair : {&clear, &blocked}) {
                const bool isShown = response.touches == (pair == &blocked) || isNear;
                pair->below.add(response.frequencyRatio, isShown ? peak : nothing);
            }
        }
        panels_.add(std::move(clear), "no contact", false);
        panels_.add(std::move(blocked), "no stop in its way", false);
    }

    void addMotions()
    {
        for (const Sort& sort : sorts) {
            for (const Touched& touched : touches) {
                SeriesPair marks(
                    dots(sort.stability == Stability::unclear ? Role::faint : touched.role,
                         sort.size, sort.marker));
                for (const FrequencyResponse& response : frequencies_) {
                    for (const ForcedMotion& motion : response.motions) {
                        const std::vector<Phase>& phases = motion.schedule.phases;
                        if (motion.stability == sort.stability && phases.size() == touched.phases &&
                            phases.front().stop == touched.first &&
                            phases.back().stop == touched.last) {
                            add(marks, response.frequencyRatio, motion.extremes);
                        }
                    }
                }
                panels_.add(std::move(marks), std::string(touched.words) + sort.words);
            }
        }
    }

    void addSecondStop(double low, double high)
    {
        if (const auto& second = range_.stops.left) {
            const double stop = second->value() * panels_.below.scale;
            panels_.lower.add(across(low, high, stop, 1.0, Dash::dotted));
            Series words = plot::labels();
            words.add(low, stop + 0.05 * panels_.below.room * panels_.below.largest,
                      "  second stop");
            panels_.lower.add(std::move(words));
        }
    }

    std::span<const FrequencyResponse> frequencies_;
    const ResponseRange& range_;
    const Bar& bar_;
    double first_ = std::numeric_limits<double>::infinity();  ///< frequency with contact
    double last_ = 0.0;                                       ///< the same
    TwoPanels panels_;
};

}  // namespace

FigureData responseFigure(std::span<const FrequencyResponse> frequencies,
                          const ResponseRange& range, const Bar& bar)
{
    if (frequencies.empty()) {
        throw std::invalid_argument("figure: the response holds no frequency to draw");
    }
    return ResponsePanels(frequencies, range, bar).figure();
}

}  // namespace signorini
