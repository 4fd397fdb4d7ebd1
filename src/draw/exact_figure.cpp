#include "exact_figure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "axes.hpp"
#include "excited_amplitude.hpp"

namespace signorini {

namespace {

using namespace plot;

/// A part of a curve: what disturbances do, and how often a stop is touched in a period.
struct PartSort {
    const char* words;
    Dash dash;
    double width;
};

const std::array<PartSort, 3> partSorts{{{"attracts", Dash::solid, 2.4},
                                         {"repels", Dash::dashed, 1.4},
                                         {"not known", Dash::dotted, 1.8}}};

std::size_t kindOf(const ExactStability& stability)
{
    return !stability.attracts ? 2U : *stability.attracts ? 0U : 1U;
}

/// Force above, impulse below, over the same frequencies.
class ExactPanels {
public:
    ExactPanels(const std::vector<ExactFrequency>& frequencies,
                const std::vector<ExactBranch>& branches, const ResponseRange& range,
                const Bar& bar)
        : branches_(branches), range_(range), bar_(bar)
    {
        low_ = frequencies.back().frequencyRatio;
        high_ = frequencies.front().frequencyRatio;
        if (!(low_ < high_)) {  // a single one in the middle
            low_ *= 0.98;
            high_ *= 1.02;
        }
        for (const ExactFrequency& at : frequencies) {
            for (const ExactMotion& one : at.motions) {
                look(one.motion);
            }
        }
        for (const ExactBranch& branch : branches) {
            for (const BranchPoint& point : branch.curve.points) {
                look(point.motion);
            }
        }
        const Scales unit = scales(bar);
        const double force = bar.axialStiffness * unit.strain;
        forceUnit_ = axisUnit(force, force_ * 1.15, "N");
        impulseUnit_ = axisUnit(force * unit.time, impulse_ * 1.15, "N s");
        hertz_ = 0.25 / unit.time;
    }

    FigureData figure(const std::vector<ExactFrequency>& frequencies,
                      const std::vector<FrequencyResponse>& staircase)
    {
        FigureData figure;
        figure.title =
            fmt::format("{} of amplitude {},  ζ = {:.4g},  exact harmonic",
                        range_.place == Excited::tip ? "force on the tip" : "base moving",
                        withUnit(range_.amplitude * amplitudeUnit(range_.place, bar_, 0),
                                 amplitudeUnitName(range_.place, 0)),
                        range_.damping.ratio);
        figure.height = 15.0;
        upper_ = {.name = "force", .place = {0.12, 0.95, 0.58, 0.85}};
        upper_.x = bare(axisIn({hertz_, "Hz"}, "", low_, high_, "ω/ω_1"));
        upper_.y = axisIn(forceUnit_, "largest force", 0.0, 1.15 * force_);
        lower_ = {.name = "impulse", .place = {0.12, 0.95, 0.27, 0.54}, .legend = Legend::below};
        lower_.legendRows = 4;
        lower_.x = {.label = "frequency of the excitation  [Hz]",
                    .low = low_ * hertz_,
                    .high = high_ * hertz_};
        lower_.y = axisIn(impulseUnit_, "impulse per period", 0.0, 1.15 * impulse_);
        addStaircase(staircase);
        for (const bool areSeveral : {false, true}) {
            for (std::size_t kind = 0; kind < partSorts.size(); ++kind) {
                addCurves(kind, areSeveral);
            }
        }
        addLone(frequencies);
        addMarks(true);
        addMarks(false);
        figure.panels = {std::move(upper_), std::move(lower_)};
        return figure;
    }

private:
    void look(const HarmonicMotion& motion)
    {
        force_ = std::max(force_, motion.extremes.peakForce);
        impulse_ = std::max(impulse_, motion.extremes.impulse);
    }

    void add(Series& above, Series& below, double ratio, const HarmonicMotion& motion) const
    {
        above.add(ratio * hertz_, motion.extremes.peakForce * forceUnit_.factor);
        below.add(ratio * hertz_, motion.extremes.impulse * impulseUnit_.factor);
    }

    void push(Series above, const Series& below, std::string words)
    {
        upper_.add(std::move(above));
        lower_.add(below.named(std::move(words)));
    }

    /// A line goes on to the next point, whatever that does, unless curves have a gap there.
    void addCurves(std::size_t kind, bool areSeveral)
    {
        const auto [words, dash, width] = partSorts[kind];
        Series above = line(areSeveral ? Role::strain : Role::contact, width, dash);
        Series below = above;
        for (const ExactBranch& branch : branches_) {
            const auto& points = branch.curve.points;
            bool goesOn = false;
            for (std::size_t k = 0; k <= points.size(); ++k) {
                const bool isIn = k < points.size() && kindOf(branch.stability[k]) == kind &&
                                  (points[k].motion.contacts.size() > 1) == areSeveral;
                if (k < points.size() && (isIn || goesOn)) {
                    add(above, below, points[k].frequencyRatio, points[k].motion);
                }
                if (goesOn && !isIn) {
                    above.breakOff();
                    below.breakOff();
                }
                goesOn = isIn;
            }
        }
        push(std::move(above), below,
             fmt::format("{}: {}", areSeveral ? "several contacts" : "one contact", words));
    }

    /// What a force in steps has, to compare.
    void addStaircase(const std::vector<FrequencyResponse>& staircase)
    {
        Series above = dots(Role::faint, 0.6);
        Series below = above;
        std::int64_t steps = 0;
        for (const FrequencyResponse& at : staircase) {
            for (const ForcedMotion& one : at.motions) {
                steps = one.schedule.cells;
                above.add(at.frequencyRatio * hertz_, one.extremes.peakForce * forceUnit_.factor);
                below.add(at.frequencyRatio * hertz_, one.extremes.impulse * impulseUnit_.factor);
            }
        }
        push(std::move(above), below, fmt::format("staircase, {} steps in L/c", steps));
    }

    /// Attractors of many contacts have curves too short to be seen.
    void addLone(const std::vector<ExactFrequency>& frequencies)
    {
        Series above = dots(Role::strain, 0.5);
        Series below = above;
        for (const ExactFrequency& at : frequencies) {
            for (const ExactMotion& one : at.motions) {
                if (one.motion.contacts.size() > 1) {
                    add(above, below, at.frequencyRatio, one.motion);
                }
            }
        }
        push(std::move(above), below, "several contacts: from rest");
    }

    /// Folds, or where a contact comes or goes.
    void addMarks(bool areFolds)
    {
        Series above = dots(Role::ink, 0.9, areFolds ? Marker::diamond : Marker::ring);
        Series below = above;
        for (const ExactBranch& branch : branches_) {
            for (const BranchMark& mark : branch.curve.marks) {
                const bool isChange = mark.event == BranchEvent::grazing ||
                                      mark.event == BranchEvent::newContact ||
                                      mark.event == BranchEvent::lostContact;
                if ((areFolds ? mark.event == BranchEvent::fold : isChange) &&
                    branch.curve.points.size() >= 4) {
                    add(above, below, mark.frequencyRatio, branch.curve.points[mark.after].motion);
                }
            }
        }
        push(std::move(above), below, areFolds ? "fold" : "a contact more or less");
    }

    const std::vector<ExactBranch>& branches_;
    const ResponseRange& range_;
    const Bar& bar_;
    double low_ = 0.0;
    double high_ = 0.0;
    double hertz_ = 1.0;
    double force_ = 1e-12;
    double impulse_ = 1e-12;
    Unit forceUnit_;
    Unit impulseUnit_;
    Panel upper_;
    Panel lower_;
};

/// The tip between its stops.
Panel tipPanel(Series tip, const Stops& stops, const Unit& place)
{
    const double end = tip.x.back();
    Panel panel{.name = "tip", .place = {0.12, 0.86, 0.38, 0.62}};
    panel.x = {.low = 0.0, .high = end, .hasNumbers = false};
    panel.add(across(0.0, end, static_cast<double>(stops.right) * place.factor, 1.0, Dash::dotted));
    if (stops.left) {
        panel.add(across(0.0, end, -stops.left->value() * place.factor, 1.0, Dash::dotted));
    }
    panel.add(std::move(tip));
    panel.y = axisAround(panel.series, labelled("tip  u(L)", place));
    return panel;
}

}  // namespace

FigureData exactFigure(const std::vector<ExactFrequency>& frequencies,
                       const std::vector<ExactBranch>& branches, const ResponseRange& range,
                       const Bar& bar, const std::vector<FrequencyResponse>& staircase)
{
    if (frequencies.empty()) {
        throw std::invalid_argument("figure: the response holds no frequency to draw");
    }
    return ExactPanels(frequencies, branches, range, bar).figure(frequencies, staircase);
}

FigureData harmonicFigure(const HarmonicField& motion, const Scene& scene)
{
    constexpr int instants = 600;
    constexpr int nodes = 120;
    const Bar& bar = scene.bar;
    const Scales unit = scales(bar);
    Series field{.kind = Kind::image};
    Series tip{.width = 1.8};
    Series force{.role = Role::contact, .width = 1.8};
    double pressed = 0.0;
    double swing = 1.0;
    std::vector<double> times;
    for (int m = 0; m <= instants; ++m) {
        times.push_back(motion.period() * m / instants);
        pressed = std::max(pressed, std::abs(motion.push(times.back())));
        swing = std::max(swing, std::abs(motion.displacement(1.0, times.back())));
    }
    const Unit time = unitFor(motion.period() * unit.time, "s");
    const Unit place = axisUnit(unit.displacement, swing, "m");
    const Unit push = axisUnit(bar.axialStiffness * unit.strain, pressed, "N");
    for (const double t : times) {
        field.x.push_back(t * unit.time * time.factor);
        tip.add(field.x.back(), motion.displacement(1.0, t) * place.factor);
        force.add(field.x.back(), motion.push(t) * push.factor);
    }
    for (int i = 0; i <= nodes; ++i) {
        const double x = static_cast<double>(i) / nodes;
        field.y.push_back(x * bar.length);
        for (const double t : times) {
            field.z.push_back(motion.displacement(x, t) * place.factor);
        }
    }
    const Physical physical = physicalOf(motion.motion().extremes, bar);
    FigureData figure{.title = fmt::format("a period under an exact harmonic:  {},  {:.5g} Hz,  {}",
                                           withUnit(1.0 / physical.frequency, "s"),
                                           physical.frequency, withUnit(physical.impulse, "N s"))};
    Panel above{.name = "displacement", .place = {0.12, 0.86, 0.66, 0.92}};
    above.x = {.low = 0.0, .high = field.x.back(), .hasNumbers = false};
    above.y = {.label = "place  x  [m]", .low = 0.0, .high = bar.length};
    above.colour = {.label = labelled("u", place)};
    above.colourBar = Place{0.88, 0.9, 0.66, 0.92};
    above.hasGrid = false;
    above.series.push_back(std::move(field));
    Panel middle = tipPanel(std::move(tip), stopsOf(scene), place);
    Panel below{.name = "force", .place = {0.12, 0.86, 0.1, 0.34}};
    below.x = {.label = labelled("time  t", time), .low = 0.0, .high = force.x.back()};
    below.series.push_back(std::move(force));
    below.y = axisAround(below.series, labelled("force", push));
    figure.panels = {std::move(above), std::move(middle), std::move(below)};
    return figure;
}

}  // namespace signorini
