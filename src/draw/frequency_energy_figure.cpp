#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "axes.hpp"
#include "faults.hpp"
#include "signorini/figures.hpp"

namespace signorini {

namespace {

using namespace plot;

/// What print can show: the width of a column in the detail, and the relative height of a line.
constexpr double columnWidth = 5e-4;
constexpr double lineHeight = 1.004;
constexpr std::size_t pointsPerCurve = 60;
constexpr std::size_t pointsInAll = 60'000;
constexpr std::size_t maxMarked = 200;  // modes; beyond, no labels and smaller marks

/// Bottom of the ordinate: no motion that reaches the wall has less than E_1.
constexpr double lowestEnergy = 0.7;

/// The crowded part of the abscissa, T in ]3, 4], drawn once more.
constexpr double detailLeft = 0.985;
constexpr double detailRight = 1.295;

/// How a group of modes is drawn, told apart by width and dashes.
struct Style {
    const char* family;  ///< start of familyName
    const char* words;
    Series line;
};

/// In their order, the first on top: twins lie on the main mode.
const std::array<Style, 5> styles{{
    {"twin", "twins of the main mode", line(Role::velocity, 1.5, Dash::dashed)},
    {"main", "main mode  t_c = 4 − T", line(Role::ink, 3.5)},
    {"subharmonic", "subharmonic p  t_c = 4p − (2p−1)T", line(Role::ink, 2.0)},
    {"higher", "higher m  t_c = 4 − (2m+1)T", line(Role::ink, 2.0, Dash::longDashed)},
    {"", "other modes", line(Role::faint, 1.0)},
}};

/// Half-lines of families, orders from the one above to `last`.
struct Shade {
    std::int64_t last;
    Role role;
    double width;
};

constexpr std::array<Shade, 6> shades{{{4, Role::shade1, 4.0},
                                       {6, Role::shade2, 3.0},
                                       {9, Role::shade3, 2.2},
                                       {15, Role::shade3, 1.2},
                                       {30, Role::shade4, 1.0},
                                       {maxFamilyOrder, Role::shade4, 0.5}}};
constexpr std::int64_t maxNamedFamily = 7;

const Style& styleOf(const Mode& mode)
{
    const std::string family = familyName(mode);
    return *std::find_if(styles.begin(), styles.end(), [&family](const Style& style) {
        return family.starts_with(style.family);
    });
}

double frequencyAt(const ExactPeriod& period)
{
    return 4.0 / period.value();
}

void validate(std::span<const EnergyBar> bars, const FrequencyEnergyOptions& options)
{
    Faults faults;
    const double top = topOf(options);
    if (!(std::isfinite(top) && top > 1.0)) {
        faults.add("maxEnergyRatio", top, "finite and > 1 [E_1]");
    }
    if (options.maxFrequencyRatio) {
        faults.requirePositive("maxFrequencyRatio", *options.maxFrequencyRatio, "-");
    }
    for (const EnergyBar& bar : bars) {
        if (!(std::isfinite(bar.frequencyRatio) && bar.frequencyRatio > 0.0 && bar.least > 0.0 &&
              bar.least <= bar.most)) {
            faults.add("energy bar",
                       fmt::format("({}, {}…{})", bar.frequencyRatio, bar.least, bar.most),
                       "a frequency ratio finite and > 0, and energies 0 < least <= most");
            break;
        }
    }
    faults.throwIfAny();
}

/// The part of the plane that is drawn.
struct Extent {
    double left = 0.9;
    double right = 1.5;
    double top = 0.0;

    Extent(const FrequencyEnergyPlot& plot, const FrequencyEnergyOptions& options)
        : top(topOf(options))
    {
        double last = 1.4;
        for (const Mode& mode : plot.modes) {
            last = std::max(last, frequencyAt(mode.lowest));
        }
        for (const EnergyBar& bar : plot.bars) {
            if (bar.least <= top) {
                last = std::max(last, bar.frequencyRatio);
                left = std::min(left, bar.frequencyRatio - 0.1);
            }
        }
        left = std::max(left, 0.3);
        right = options.maxFrequencyRatio.value_or(last + 0.1);
        if (options.leastFrequencyRatio) {
            left = *options.leastFrequencyRatio;
        }
    }
};

/// The curve in the frame, from its highest to its lowest period. Evenly in the logarithm of
/// E.
void addCurve(Series& line, const Mode& mode, const Extent& frame, std::size_t points)
{
    const auto root = [&mode](const ExactPeriod& end) {
        return static_cast<double>(mode.kappa * end.numerator - mode.mu * end.denominator) /
               static_cast<double>(end.denominator);
    };
    const double atTop = 1.0 / std::sqrt(frame.top);
    const double first = std::max(root(mode.highest), atTop);
    const double last = std::max(root(mode.lowest), atTop);
    for (std::size_t k = 0; k <= points; ++k) {
        const double w =
            first * std::pow(last / first, static_cast<double>(k) / static_cast<double>(points));
        const double period = (w + static_cast<double>(mode.mu)) / static_cast<double>(mode.kappa);
        line.add(4.0 / period, 1.0 / (w * w));
    }
    line.breakOff();
}

/// Fills panels that differ in what they show of the plane and in their labels.
class EnergyPanels {
public:
    EnergyPanels(const FrequencyEnergyPlot& plot, const FrequencyEnergyOptions& options)
        : plot_(plot), options_(options), frame_(plot, options)
    {
        addBars(Contact::grazing, {.width = 1.2,
                                   .dash = Dash::dotted,
                                   .legend = "linear motions that only graze the wall"});
        addBars(Contact::pressing, {.role = Role::faint,
                                    .width = 1.2,
                                    .legend = "several contacts, to E_{max} of the grid"});
        addFamilies();
        addModes();
        if (options.bar == Bar{}) {
            Series halo = dots(Role::paper, 3.2, Marker::diamond);
            Series paper =
                dots(Role::ink, 2.2, Marker::diamond).named("the paper’s motion, (8/7, 20)");
            for (Series* mark : {&halo, &paper}) {
                mark->add(8.0 / 7.0, 20.0);
                shown_.add(std::move(*mark));
            }
        }
    }

    [[nodiscard]] FigureData figure() const
    {
        FigureData figure{.width = 18.0};
        if (options_.leastFrequencyRatio) {
            Panel one = panel("energy", {0.09, 0.97, 0.12, 0.86}, *options_.leastFrequencyRatio,
                              frame_.right, true);
            one.legend = Legend::bottomRight;
            figure.panels.push_back(std::move(one));
            return figure;
        }
        std::vector<Series> said;
        for (const Series& series : shown_.series) {
            if (!series.legend.empty()) {
                said.push_back(series);
                said.back().x = said.back().y = {};
            }
        }
        const std::size_t rows = (said.size() + 1) / 2;
        const double words =
            0.52 * static_cast<double>(rows) + (plot_.families.empty() ? 0.3 : 1.5);  // [cm]
        figure.height = 15.6 + words;
        const auto placed = [&figure](double bottom, double top) {
            return Place{0.09, 0.97, bottom / figure.height, top / figure.height};
        };
        Panel whole = panel("whole", placed(figure.height - 4.7, figure.height - 0.3), frame_.left,
                            frame_.right, false);
        whole.x.label = "frequency  ω/ω_1 = 4L/(cT)";
        whole.x.isLogarithmic = true;
        for (const double tick :
             {0.5, 0.7, 1.0, 1.2, 1.5, 2.0, 3.0, 4.0, 5.0, 7.0, 10.0, 15.0, 20.0, 30.0, 50.0}) {
            whole.x.ticks.push_back({tick, fmt::format("{:g}", tick)});
        }
        Panel detail = panel("detail", placed(words + 1.5, figure.height - 7.6), detailLeft,
                             detailRight, true);
        Panel key{.name = "words",
                  .place = placed(0.1, words - 0.1),
                  .legend = Legend::topLeft,
                  .legendRows = static_cast<int>(rows),
                  .isFramed = false};
        key.x = {.low = 0.0, .high = 1.0};
        key.y = {.low = 0.0, .high = 1.0};
        key.series = std::move(said);
        if (!plot_.families.empty()) {
            Series said2{.kind = Kind::words, .isInPanel = true, .align = Align::centre};
            said2.add(0.5, 0.9 / words,
                      "A family (w, ν, k) has every energy above its least one, on grids fine "
                      "enough.");
            said2.add(0.5, 0.3 / words,
                      "E_{max} is the grid’s: G times the least, G = 2N/w on N cells.");
            key.add(std::move(said2));
        }
        figure.panels = {std::move(whole), std::move(detail), std::move(key)};
        return figure;
    }

private:
    [[nodiscard]] Panel panel(const char* name, Place place, double left, double right,
                              bool isDetail) const
    {
        Panel panel{.name = name, .place = place};
        panel.x = isDetail ? frequencyAxis("frequency", left, right, options_.bar)
                           : Axis{.low = left, .high = right};
        panel.y = energyAxis("energy  E/E_1", lowestEnergy, frame_.top);
        panel.series = shown_.series;
        panel.add(namesIn(panel, isDetail));
        return panel;
    }

    /// The bars of one kind, those of one column that overlap made one.
    void addBars(Contact contact, Series style)
    {
        struct Stroke {
            double column;
            EnergyBar bar;
        };
        std::vector<Stroke> strokes;
        for (EnergyBar bar : plot_.bars) {
            if (bar.contact == contact && bar.least <= frame_.top &&
                bar.frequencyRatio <= frame_.right) {
                bar.most = std::min(bar.most, frame_.top) * lineHeight;
                strokes.push_back({std::round(bar.frequencyRatio / columnWidth), bar});
            }
        }
        std::sort(strokes.begin(), strokes.end(), [](const Stroke& x, const Stroke& y) {
            return std::tie(x.column, x.bar.least) < std::tie(y.column, y.bar.least);
        });
        style.kind = Kind::strokes;
        for (std::size_t k = 0; k < strokes.size();) {
            const double column = strokes[k].column;
            EnergyBar bar = strokes[k].bar;
            for (++k; k < strokes.size() && strokes[k].column == column &&
                      strokes[k].bar.least <= bar.most;
                 ++k) {
                bar.most = std::max(bar.most, strokes[k].bar.most);
            }
            style.add(bar.frequencyRatio, bar.least, bar.frequencyRatio, bar.most);
        }
        shown_.add(std::move(style));
    }

    /// From where a family starts.
    [[nodiscard]] std::optional<std::pair<double, double>> footOf(const Family& family) const
    {
        const double energy = leastEnergy(family).value();
        const double frequency = frequencyAt(exactPeriod(family));
        if (energy > frame_.top || frequency > frame_.right) {
            return std::nullopt;
        }
        return std::pair{frequency, energy};
    }

    /// Half-lines in the shade of their order, the highest orders in the background, and dots.
    void addFamilies()
    {
        for (std::size_t k = shades.size(); k-- > 0;) {
            const auto [last, role, width] = shades.at(k);
            std::int64_t most = 0;
            Series lines = plot::strokes(role, width);
            for (const Family& family : plot_.families) {
                if (family.order > last || (k > 0 && family.order <= shades.at(k - 1).last)) {
                    continue;
                }
                if (const auto foot = footOf(family)) {
                    lines.add(foot->first, foot->second, foot->first, frame_.top);
                    most = std::max(most, family.order);
                }
            }
            lines.legend = fmt::format("families of order w ≤ {}", most);
            shown_.add(std::move(lines));
        }
        Series dots = plot::dots(Role::contact, 0.7).named("families on the grid");
        for (const Family& family : plot_.onGrid) {
            if (const auto foot = footOf(family)) {
                dots.add(foot->first, foot->second);
            }
        }
        shown_.add(std::move(dots));
    }

    /// Is any of it below the top?
    [[nodiscard]] bool startsBelow(const Mode& mode) const
    {
        const auto energyAt = [&mode](double part) {
            return energyRatio(mode, std::lerp(mode.lowest.value(), mode.highest.value(), part));
        };
        return std::min(energyAt(0.001), energyAt(0.999)) < frame_.top;
    }

    /// The modes of each style, and the points where they leave linear motions.
    void addModes()
    {
        // Where curves crowd, those without a name of their own get fewer points.
        const std::size_t few =
            std::clamp<std::size_t>(pointsInAll / (plot_.modes.size() + 1), 4, pointsPerCurve);
        for (std::size_t k = styles.size(); k-- > 0;) {
            Series line = styles.at(k).line;
            line.legend = styles.at(k).words;
            for (const Mode& mode : plot_.modes) {
                if (&styleOf(mode) == &styles.at(k) && startsBelow(mode)) {
                    addCurve(line, mode, frame_, k + 1 == styles.size() ? few : pointsPerCurve);
                }
            }
            shown_.add(std::move(line));
        }
        Series starts =
            plot::dots(Role::ink, plot_.modes.size() <= maxMarked ? 1.0 : 0.35, Marker::ring)
                .named("contact begins, at ω_{|b|}/a");
        for (const Mode& mode : plot_.modes) {
            if (startsBelow(mode)) {
                starts.add(frequencyAt(mode.highest), static_cast<double>(mode.b * mode.b));
            }
        }
        shown_.add(std::move(starts));
    }

    /// Of the first families, in the detail, and of the linear motions at which contact begins:
    /// each where no other stands.
    [[nodiscard]] Series namesIn(const Panel& panel, bool isDetail) const
    {
        Series names = plot::labels(0.85);
        std::vector<std::pair<double, double>> taken;
        const auto put = [&](double frequency, double energy, const std::string& name) {
            const double x = (frequency - *panel.x.low) / (*panel.x.high - *panel.x.low);
            const double y = std::log(energy / lowestEnergy) / std::log(frame_.top / lowestEnergy);
            const bool isFree = std::none_of(taken.begin(), taken.end(), [&](const auto& other) {
                return std::abs(x - other.first) < 0.08 && std::abs(y - other.second) < 0.05;
            });
            if (isFree && x >= 0.0 && x < 0.95 && energy < 0.8 * frame_.top) {
                taken.emplace_back(x, y);
                names.add(frequency, energy * (isDetail ? 0.9 : 0.95), "  " + name);
            }
        };
        for (const Family& family : plot_.families) {
            const auto foot = footOf(family);
            if (isDetail && foot && family.order <= maxNamedFamily) {
                put(foot->first, foot->second,
                    fmt::format("({}, {}, {})", family.order, family.blocks, family.contactBlocks));
            }
        }
        for (const Mode& mode : plot_.modes) {
            const double frequency = frequencyAt(mode.highest);
            if (plot_.modes.size() <= maxMarked && (isDetail || frequency > detailRight)) {
                put(frequency, static_cast<double>(mode.b * mode.b),
                    fmt::format("ω_{{{}}}{}", -mode.b,
                                mode.a == 1 ? "" : fmt::format("/{}", mode.a)));
            }
        }
        return names;
    }

    const FrequencyEnergyPlot& plot_;
    const FrequencyEnergyOptions& options_;
    Extent frame_;
    Panel shown_;  ///< the series of all panels
};

}  // namespace

FigureData frequencyEnergyFigure(const FrequencyEnergyPlot& plot,
                                 const FrequencyEnergyOptions& options)
{
    validate(plot.bars, options);
    return EnergyPanels(plot, options).figure();
}

}  // namespace signorini
