#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "axes.hpp"
#include "excited_amplitude.hpp"
#include "signorini/figures.hpp"
#include "stepped_bar.hpp"

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

/// Both panels: impulse and swing of what is drawn, over the same frequencies.
class ResponsePanels {
public:
    ResponsePanels(std::span<const FrequencyResponse> frequencies, const ResponseRange& range,
                   const Bar& bar)
        : frequencies_(frequencies), range_(range), bar_(bar)
    {
        double pushed = 0.0;
        swing_ = range.stops.right != 0 ? 2.0 : 0.0;
        if (range.stops.left) {
            swing_ = std::max(swing_, range.stops.left->value());
        }
        for (const FrequencyResponse& response : frequencies) {
            swing_ = std::max(swing_, range.stops.right != 0 ? 0.0 : response.linearPeak);
            for (const ForcedMotion& motion : response.motions) {
                pushed = std::max(pushed, motion.extremes.impulse);
                first_ = std::min(first_, response.frequencyRatio);
                last_ = std::max(last_, response.frequencyRatio);
                swing_ = std::max(swing_, -motion.extremes.lowestTip);
            }
        }
        impulse_ = pushed > 0.0 ? 1.15 * pushed : 1.0;
        swing_ *= 1.08;
        const Scales unit = scales(bar);
        impulseUnit_ = axisUnit(bar.axialStiffness * unit.strain * unit.time, impulse_, "N s");
        swingUnit_ = axisUnit(unit.displacement, swing_, "m");
    }

    FigureData figure()
    {
        const auto [least, most] =
            std::minmax(frequencies_.front().frequencyRatio, frequencies_.back().frequencyRatio);
        low_ = least - (most > least ? 0.01 * (most - least) : 0.05);
        high_ = most + (most > least ? 0.01 * (most - least) : 0.05);
        const std::string gap = range_.stops.right < 0 ? "|g|" : range_.stops.right > 0 ? "g" : "L";
        upper_ = {.name = "impulse", .place = {0.12, 0.88, 0.53, 0.83}, .legend = Legend::topLeft};
        upper_.x = bare(frequencyAxis("", low_, high_, bar_));
        upper_.y = axisIn(impulseUnit_, "impulse per period", 0.0, impulse_, "EA " + gap + "/c");
        lower_ = {.name = "tip", .place = {0.12, 0.88, 0.12, 0.48}};
        lower_.x = {.label = "frequency of the excitation  ω/ω_1", .low = low_, .high = high_};
        lower_.y = axisIn(swingUnit_, "swing  −min u(L)", 0.0, swing_, gap);
        addModes();
        addLinear();
        addMotions();
        addSecondStop();
        FigureData figure{.title = titleOf(range_, bar_)};
        figure.panels = {std::move(upper_), std::move(lower_)};
        return figure;
    }

private:
    void add(Series& series, double frequency, double impulse, double swing, Series& below) const
    {
        series.add(frequency, impulse * impulseUnit_.factor);
        below.add(frequency, swing * swingUnit_.factor);
    }

    void push(Series series, Series below)
    {
        upper_.add(std::move(series));
        lower_.add(std::move(below));
    }

    /// The backbones of a uniform bar, as far as there are motions.
    void addModes()
    {
        if (!isUniform(range_.segments) || !(last_ > 0.0)) {
            return;
        }
        Series modes = plot::line(Role::shade6, 5.0);
        Series below = modes;
        modes.legend = "modes: free, undamped";
        for (const Backbone& backbone : backbonesOf(first_, last_, range_.cycles, range_.stops)) {
            for (const BackbonePoint& point : backbone.points) {
                const bool isIn =
                    -point.extremes.lowestTip <= swing_ && point.extremes.impulse <= impulse_;
                add(modes, point.frequencyRatio, isIn ? point.extremes.impulse : nothing,
                    isIn ? -point.extremes.lowestTip : nothing, below);
            }
            add(modes, nothing, nothing, nothing, below);
        }
        push(std::move(modes), std::move(below));
    }

    /// The bar without a wall: where it stays clear, and where the wall is in its way.
    void addLinear()
    {
        Series clear = plot::line(Role::ink, 2.0).named("no contact");
        Series blocked = plot::line(Role::faint, 1.5, Dash::dashed).named("no stop in its way");
        for (std::size_t k = 0; k < frequencies_.size(); ++k) {
            const FrequencyResponse& response = frequencies_[k];
            const bool isNear = k > 0 && frequencies_[k - 1].touches != response.touches;
            const double peak = response.linearPeak * swingUnit_.factor;
            for (Series* series : {&clear, &blocked}) {
                const bool isShown = response.touches == (series == &blocked) || isNear;
                series->add(response.frequencyRatio, isShown ? peak : nothing);
            }
        }
        for (Series& series : {std::ref(clear), std::ref(blocked)}) {
            Series named = series;  // the legend stands above
            named.x.clear();
            named.y.clear();
            upper_.series.push_back(std::move(named));
            series.legend.clear();
            lower_.series.push_back(std::move(series));
        }
    }

    void addMotions()
    {
        for (const Sort& sort : sorts) {
            for (const Touched& touched : touches) {
                Series marks =
                    dots(sort.stability == Stability::unclear ? Role::faint : touched.role,
                         sort.size, sort.marker);
                Series below = marks;
                marks.legend = std::string(touched.words) + sort.words;
                for (const FrequencyResponse& response : frequencies_) {
                    for (const ForcedMotion& motion : response.motions) {
                        const std::vector<Phase>& phases = motion.schedule.phases;
                        if (motion.stability == sort.stability && phases.size() == touched.phases &&
                            phases.front().stop == touched.first &&
                            phases.back().stop == touched.last) {
                            add(marks, response.frequencyRatio, motion.extremes.impulse,
                                -motion.extremes.lowestTip, below);
                        }
                    }
                }
                push(std::move(marks), std::move(below));
            }
        }
    }

    void addSecondStop()
    {
        if (const auto& second = range_.stops.left) {
            const double stop = second->value() * swingUnit_.factor;
            lower_.add(across(low_, high_, stop, 1.0, Dash::dotted));
            lower_.series.push_back({.kind = Kind::words,
                                     .x = {low_},
                                     .y = {stop + 0.05 * swing_ * swingUnit_.factor},
                                     .words = {"  second stop"}});
        }
    }

    std::span<const FrequencyResponse> frequencies_;
    const ResponseRange& range_;
    const Bar& bar_;
    double first_ = std::numeric_limits<double>::infinity();  ///< frequency with contact
    double last_ = 0.0;                                       ///< the same
    double low_ = 0.0;
    double high_ = 0.0;
    double impulse_ = 0.0;
    double swing_ = 0.0;
    Unit impulseUnit_;
    Unit swingUnit_;
    Panel upper_;
    Panel lower_;
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
