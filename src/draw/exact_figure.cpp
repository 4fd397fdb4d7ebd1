#include "exact_figure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "axes.hpp"
#include "excited_amplitude.hpp"
#include "two_panels.hpp"

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
    ExactPanels(const std::vector<ExactBranch>& branches, const Bar& bar)
        : branches_(branches),
          hertz_(0.25 / scales(bar).time),
          force_(bar.axialStiffness * scales(bar).strain),
          impulse_(force_ * scales(bar).time)
    {
    }

    FigureData figure(const std::vector<ExactFrequency>& frequencies, const std::string& title,
                      const std::vector<FrequencyResponse>& staircase)
    {
        double low = frequencies.back().frequencyRatio;
        double high = frequencies.front().frequencyRatio;
        if (!(low < high)) {  // a single one in the middle
            low *= 0.98;
            high *= 1.02;
        }
        addStaircase(staircase);
        for (const bool areSeveral : {false, true}) {
            for (std::size_t kind = 0; kind < partSorts.size(); ++kind) {
                addCurves(kind, areSeveral);
            }
        }
        addLone(frequencies);
        addMarks(true);
        addMarks(false);
        FigureData figure =
            std::move(panels_).figure(title, hertzAxis(low * hertz_, high * hertz_, hertz_));
        figure.height = 15.0;
        return figure;
    }

private:
    void add(SeriesPair& pair, double ratio, const auto& motion) const
    {
        pair.add(ratio * hertz_, motion.extremes.peakForce * force_,
                 motion.extremes.impulse * impulse_);
    }

    /// A line goes on to the next point, whatever that does, unless curves have a gap there.
    void addCurves(std::size_t kind, bool areSeveral)
    {
        const auto [words, dash, width] = partSorts[kind];
        SeriesPair curve(line(areSeveral ? Role::strain : Role::contact, width, dash));
        for (const ExactBranch& branch : branches_) {
            const auto& points = branch.curve.points;
            bool goesOn = false;
            for (std::size_t k = 0; k <= points.size(); ++k) {
                const bool isIn = k < points.size() && kindOf(branch.stability[k]) == kind &&
                                  (points[k].motion.contacts.size() > 1) == areSeveral;
                if (k < points.size() && (isIn || goesOn)) {
                    add(curve, points[k].frequencyRatio, points[k].motion);
                }
                if (goesOn && !isIn) {
                    curve.breakOff();
                }
                goesOn = isIn;
            }
        }
        panels_.add(std::move(curve),
                    fmt::format("{}: {}", areSeveral ? "several contacts" : "one contact", words));
    }

    /// What a force in steps has, to compare.
    void addStaircase(const std::vector<FrequencyResponse>& staircase)
    {
        SeriesPair steady(dots(Role::faint, 0.6));
        std::int64_t steps = 0;
        for (const FrequencyResponse& at : staircase) {
            for (const ForcedMotion& one : at.motions) {
                steps = one.schedule.cells;
                add(steady, at.frequencyRatio, one);
            }
        }
        panels_.add(std::move(steady), fmt::format("staircase, {} steps in L/c", steps));
    }

    /// Attractors of many contacts have curves too short to be seen.
    void addLone(const std::vector<ExactFrequency>& frequencies)
    {
        SeriesPair lone(dots(Role::strain, 0.5));
        for (const ExactFrequency& at : frequencies) {
            for (const ExactMotion& one : at.motions) {
                if (one.motion.contacts.size() > 1) {
                    add(lone, at.frequencyRatio, one.motion);
                }
            }
        }
        panels_.add(std::move(lone), "several contacts: from rest");
    }

    /// Folds, or where a contact comes or goes.
    void addMarks(bool areFolds)
    {
        SeriesPair marks(dots(Role::ink, 0.9, areFolds ? Marker::diamond : Marker::ring));
        for (const ExactBranch& branch : branches_) {
            for (const BranchMark& mark : branch.curve.marks) {
                const bool isChange = mark.event == BranchEvent::grazing ||
                                      mark.event == BranchEvent::newContact ||
                                      mark.event == BranchEvent::lostContact;
                if ((areFolds ? mark.event == BranchEvent::fold : isChange) &&
                    branch.curve.points.size() >= 4) {
                    add(marks, mark.frequencyRatio, branch.curve.points[mark.after].motion);
                }
            }
        }
        panels_.add(std::move(marks), areFolds ? "fold" : "a contact more or less");
    }

    const std::vector<ExactBranch>& branches_;
    double hertz_;    ///< [Hz], ω_1
    double force_;    ///< [N], EA g/L
    double impulse_;  ///< [N s], EA g/c
    TwoPanels panels_{.upper = {.name = "force", .place = {0.12, 0.95, 0.58, 0.85}},
                      .lower = {.name = "impulse",
                                .place = {0.12, 0.95, 0.27, 0.54},
                                .legend = Legend::below,
                                .legendRows = 4},
                      .above = {.words = "largest force", .base = "N", .scale = force_},
                      .below = {.words = "impulse per period", .base = "N s", .scale = impulse_}};
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
    const std::string title =
        fmt::format("{} of amplitude {},  ζ = {:.4g},  exact harmonic",
                    range.place == Excited::tip ? "force on the tip" : "base moving",
                    withUnit(range.amplitude * amplitudeUnit(range.place, bar, 0),
                             amplitudeUnitName(range.place, 0)),
                    range.damping.ratio);
    return ExactPanels(branches, bar).figure(frequencies, title, staircase);
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
