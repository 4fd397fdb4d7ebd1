#include "signorini/frequency_energy_figure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <string_view>
#include <tuple>
#include <vector>

#include "faults.hpp"
#include "gnuplot.hpp"

namespace signorini {

namespace {

using Buffer = fmt::memory_buffer;

template <typename... Args>
void print(Buffer& buffer, fmt::format_string<Args...> format, Args&&... args)
{
    fmt::format_to(std::back_inserter(buffer), format, std::forward<Args>(args)...);
}

/// What print can show: columns across the figure, and the relative height of a line of energy.
constexpr double columns = 2000.0;
constexpr double lineHeight = 1.004;
constexpr int pointsPerCurve = 60;

/// How a group of curves is drawn; colours after Okabe and Ito, told apart by dashes as well.
struct Style {
    const char* family;  ///< start of familyName
    const char* title;
    const char* line;
};

constexpr std::array<Style, 5> styles{{
    {"main", "main mode  t_c = 4 − T", "lw 3 lc 'black'"},
    {"subharmonic", "subharmonic p  t_c = 4p − (2p−1)T", "lw 2 lc '#0072b2'"},
    {"higher", "higher m  t_c = 4 − (2m+1)T", "lw 2 dt (8,4) lc '#d55e00'"},
    {"twin", "twins of the main mode", "lw 2 dt (3,6) lc '#f0e442'"},
    {"", "other modes", "lw 2 dt (4,3) lc '#009e73'"},
}};

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
    if (!(std::isfinite(options.maxEnergyRatio) && options.maxEnergyRatio > 1.0)) {
        faults.add("maxEnergyRatio", options.maxEnergyRatio, "finite and > 1 [E_1]");
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
struct Frame {
    double left = 0.9;
    double right = 1.5;
    double top = 50.0;

    Frame(std::span<const Mode> modes, std::span<const EnergyBar> bars,
          const FrequencyEnergyOptions& options)
        : top(options.maxEnergyRatio)
    {
        double last = 1.4;
        for (const Mode& mode : modes) {
            last = std::max(last, frequencyAt(mode.lowest));
        }
        for (const EnergyBar& bar : bars) {
            last = std::max(last, bar.frequencyRatio);
            left = std::min(left, bar.frequencyRatio - 0.1);
        }
        left = std::max(left, 0.0);
        right = options.maxFrequencyRatio.value_or(last + 0.1);
    }
};

/// The curve in the frame, from its highest to its lowest period. Evenly in the logarithm of E.
void printCurve(Buffer& script, const Mode& mode, const Frame& frame)
{
    const auto root = [&mode](const ExactPeriod& end) {
        return static_cast<double>(mode.kappa * end.numerator - mode.mu * end.denominator) /
               static_cast<double>(end.denominator);
    };
    const double atTop = 1.0 / std::sqrt(frame.top);
    const double first = std::max(root(mode.highest), atTop);
    const double last = std::max(root(mode.lowest), atTop);
    for (int k = 0; k <= pointsPerCurve; ++k) {
        const double w = first * std::pow(last / first, k / double{pointsPerCurve});
        const double period = (w + static_cast<double>(mode.mu)) / static_cast<double>(mode.kappa);
        print(script, "{:.6g} {:.6g}\n", 4.0 / period, 1.0 / (w * w));
    }
    print(script, "\n");
}

/// The modes of each style, and the points where modes leave linear motions.
void printModes(Buffer& script, std::span<const Mode> modes, const Frame& frame)
{
    for (std::size_t k = 0; k < styles.size(); ++k) {
        print(script, "$modes{} << EOD\n", k);
        for (const Mode& mode : modes) {
            if (&styleOf(mode) == &styles[k]) {
                printCurve(script, mode, frame);
            }
        }
        print(script, "EOD\n");
    }
    print(script, "$starts << EOD\n");
    for (const Mode& mode : modes) {
        print(script, "{:.6g} {}\n", frequencyAt(mode.highest), mode.b * mode.b);
    }
    print(script, "EOD\n");
}

/// The bars of one kind, those of one column that overlap made one.
void printBars(Buffer& script, std::span<const EnergyBar> bars, Contact contact, const Frame& frame)
{
    const double width = (frame.right - frame.left) / columns;
    std::vector<EnergyBar> shown;
    for (EnergyBar bar : bars) {
        if (bar.contact == contact && bar.least <= frame.top && bar.frequencyRatio <= frame.right) {
            bar.frequencyRatio = std::round(bar.frequencyRatio / width) * width;
            bar.most = std::min(bar.most, frame.top) * lineHeight;
            shown.push_back(bar);
        }
    }
    std::sort(shown.begin(), shown.end(), [](const EnergyBar& x, const EnergyBar& y) {
        return std::tie(x.frequencyRatio, x.least) < std::tie(y.frequencyRatio, y.least);
    });
    print(script, "${} << EOD\n", name(contact));
    for (std::size_t k = 0; k < shown.size();) {
        EnergyBar bar = shown[k];
        for (++k; k < shown.size() && shown[k].frequencyRatio == bar.frequencyRatio &&
                  shown[k].least <= bar.most;
             ++k) {
            bar.most = std::max(bar.most, shown[k].most);
        }
        print(script, "{0:.6g} {1:.5g}\n{0:.6g} {2:.5g}\n\n", bar.frequencyRatio, bar.least,
              bar.most);
    }
    print(script, "EOD\n");
}

template <typename Range, typename Condition>
bool any(const Range& range, Condition condition)
{
    return std::any_of(range.begin(), range.end(), condition);
}

std::string scriptFor(std::span<const Mode> modes, std::span<const EnergyBar> bars,
                      const FrequencyEnergyOptions& options)
{
    const Frame frame(modes, bars, options);
    Buffer script;
    printModes(script, modes, frame);
    printBars(script, bars, Contact::grazing, frame);
    printBars(script, bars, Contact::pressing, frame);
    print(script,
          "set border lw 0.8\nset tics out nomirror scale 0.6\nset grid lw 0.4 lc '#cccccc'\n"
          "set xlabel 'frequency  ω/ω_1 = 4L/(cT)'\nset ylabel 'energy  E/E_1'\n"
          "set logscale y\nset xrange [{}:{}]\nset yrange [0.9:{}]\n"
          "set key below Left reverse samplen 2.5 spacing 1.2 width 1\nplot ",
          frame.left, frame.right, frame.top);
    if (any(bars, [](const EnergyBar& bar) { return bar.contact == Contact::grazing; })) {
        print(script, "$grazing with lines lw 1.2 lc '#e69f00' title 'grazing: no force', ");
    }
    if (any(bars, [](const EnergyBar& bar) { return bar.contact == Contact::pressing; })) {
        print(script,
              "$pressing with lines lw 1.2 lc '#999999' title 'all motions of a schedule', ");
    }
    for (std::size_t k = 0; k < styles.size(); ++k) {
        if (any(modes, [k](const Mode& mode) { return &styleOf(mode) == &styles[k]; })) {
            print(script, "$modes{} with lines {} title '{}', ", k, styles[k].line,
                  styles[k].title);
        }
    }
    if (!modes.empty()) {
        print(script,
              "$starts with points pt 6 ps 0.8 lw 1.5 lc 'black' title 'a linear motion touches "
              "the wall', ");
    }
    print(script,
          "'+' using (8.0/7):(20) every ::::0 with points pt 3 ps 1.6 lw 2 lc '#cc79a7' title "
          "'the paper’s example, (8/7, 20)'\n");
    return fmt::to_string(script);
}

}  // namespace

void writeFrequencyEnergyFigure(const std::string& path, std::span<const Mode> modes,
                                std::span<const EnergyBar> bars,
                                const FrequencyEnergyOptions& options)
{
    validate(bars, options);
    const FigureFormat format = options.format ? *options.format : figureFormat(path);
    runGnuplot(scriptFor(modes, bars, options), format, 18.0, 13.0, path);
}

}  // namespace signorini
