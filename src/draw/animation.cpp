// Moving pictures of a motion over time and of a continuum over lambda.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "axes.hpp"
#include "gnuplot.hpp"
#include "palette.hpp"
#include "signorini/figures.hpp"
#include "signorini/motion.hpp"
#include "text.hpp"

namespace signorini {

namespace {

constexpr std::size_t maxFrames = 121;
constexpr double gapShown = 0.1;  ///< [L], the gap in the picture of the bar

/// 0 ... last, at most so many, both ends among them.
std::vector<std::size_t> chosen(std::size_t count, std::size_t most)
{
    std::vector<std::size_t> result;
    const std::size_t gaps = std::min(count, most) - 1;
    for (std::size_t k = 0; k <= gaps; ++k) {
        result.push_back(gaps == 0 ? 0 : k * (count - 1) / gaps);
    }
    return result;
}

/// The largest and least of what frames show, so that all have the same axes.
struct Range {
    double low = 0.0;
    double high = 0.0;

    void see(double value)
    {
        low = std::min(low, value);
        high = std::max(high, value);
    }
    [[nodiscard]] std::string text() const
    {
        const double margin = 0.08 * std::max(high - low, 1e-300);
        return fmt::format("[{}:{}]", low - margin, high + margin);
    }
};

/// Between two heights of the picture.
void panel(Text& script, double bottom, double top)
{
    print(script, "set bmargin at screen {}\nset tmargin at screen {}\n", bottom, top);
}

void begin(Text& script, const std::string& title)
{
    print(script,
          "set multiplot\nset label 1 \"{}\" at screen 0.5,0.965 center\n"
          "set lmargin at screen 0.13\nset rmargin at screen 0.97\n",
          title);
}

void end(Text& script)
{
    print(script, "unset multiplot\nunset label 1\nunset object\nunset key\n");
}

/// What the axes of a frame say, in the scales of the bar.
struct AxisNames {
    const char* displacement;
    const char* fields;
    const char* force;
};

AxisNames axisNames(double gap)
{
    if (gap == 0.0) {
        return {"L", "s,  v/c", "R/EA"};
    }
    return gap > 0.0 ? AxisNames{"g", "s L/g,  v L/(c g)", "R L/(EA g)"}
                     : AxisNames{"|g|", "s L/|g|,  v L/(c |g|)", "R L/(EA |g|)"};
}

/// x/L, s L/g, v L/(c g), u/g of one instant.
class MotionFrames {
public:
    explicit MotionFrames(const MotionSamples& samples)
        : samples_(samples),
          unit_(scales(samples.bar())),
          nodes_(chosen(samples.nodes(), static_cast<std::size_t>(maxNodes))),
          instants_(chosen(samples.instants(), maxFrames)),
          wall_(samples.bar().gap / unit_.displacement)
    {
        tip_.see(wall_);
        if (const auto& second = samples.scene().secondStop) {
            second_ = -*second / unit_.displacement;
            tip_.see(*second_);
        }
        for (const std::size_t m : instants_) {
            for (const std::size_t i : nodes_) {
                fields_.see(samples.strain(i, m) / unit_.strain);
                fields_.see(samples.velocity(i, m) / unit_.velocity);
                tip_.see(samples.displacement(i, m) / unit_.displacement);
            }
        }
        size_ = std::max({fields_.high, -fields_.low, 1e-300});
    }

    [[nodiscard]] std::string script() const
    {
        Text script;
        print(script,
              "set border lw 0.8\nset tics out nomirror scale 0.6\nset grid lw 0.4 lc '{}'\n"
              "set palette defined (0 '{}', 1 '{}', 2 '{}')\nset cbrange [{}:{}]\n"
              "unset colorbox\n",
              palette::grid, palette::diverging[0], palette::diverging[1], palette::diverging[2],
              -size_, size_);
        // The last instant is the first one again.
        for (std::size_t k = 0; k + 1 < std::max<std::size_t>(instants_.size(), 2); ++k) {
            printFrame(script, instants_[k]);
        }
        return fmt::to_string(script);
    }

private:
    void printFrame(Text& script, std::size_t instant) const
    {
        const Bar& bar = samples_.bar();
        print(script, "$frame << EOD\n");
        double left = 0.0;  // end of the cell before
        for (const std::size_t i : nodes_) {
            const double x = samples_.x(i) / bar.length;
            const double u = samples_.displacement(i, instant) / unit_.displacement;
            const double right = x + gapShown * u;
            print(script, "{:.5g} {:.5g} {:.5g} {:.5g} {:.5g} {:.5g}\n", x,
                  samples_.strain(i, instant) / unit_.strain,
                  samples_.velocity(i, instant) / unit_.velocity, u, left, right);
            left = right;
        }
        print(script, "EOD\n");
        begin(script, fmt::format("t = {:.4g} s  of  {:.4g} s", samples_.time(instant),
                                  samples_.time(samples_.instants() - 1)));
        panel(script, 0.76, 0.92);
        print(script,
              "set xrange [-0.02:1.25]\nset yrange [-1:1]\nunset ytics\nset ylabel ''\n"
              "set format x ''\nset xlabel ''\n"
              "set object 1 rectangle from first {0},graph 0 to graph 1,graph 1 fillcolor "
              "'{1}' fillstyle solid noborder front\n"
              "set object 2 rectangle from graph 0,graph 0 to first 0,graph 1 fillcolor '{1}' "
              "fillstyle solid noborder front\n"
              "plot $frame using 6:(0):5:6:(-0.5):(0.5):2 with boxxyerror fillcolor palette "
              "fillstyle solid noborder\n"
              "unset object 1\nunset object 2\nset ytics\n",
              1.0 + gapShown * wall_, palette::faint);
        panel(script, 0.46, 0.71);
        print(
            script,
            "set yrange {}\nset ylabel 'displacement  u/{}'\n"
            "plot {} with lines lw 1 dt (4,4) lc 'black', {} with lines lw 1 dt (4,4) lc 'black', "
            "$frame using 1:4 with lines lw 2 lc 'black'\n",
            tip_.text(), axisNames(wall_).displacement, wall_, second_.value_or(wall_));
        panel(script, 0.12, 0.41);
        print(script,
              "set yrange {0}\nset ylabel '{1}'\nset format x '%g'\n"
              "set xlabel 'position  x/L'\nset key top right horizontal Left reverse samplen 1.5\n"
              "plot $frame using 1:2 with fsteps lw 4 lc '{2}' title 'strain', "
              "$frame using 1:3 with fsteps lw 2 lc '{3}' title 'velocity'\n",
              fields_.text(), axisNames(wall_).fields, palette::strain, palette::velocity);
        end(script);
    }

    const MotionSamples& samples_;
    Scales unit_;
    std::vector<std::size_t> nodes_;
    std::vector<std::size_t> instants_;
    Range fields_;
    Range tip_;
    double wall_;                   ///< u(L) there
    std::optional<double> second_;  ///< u(L) at the second stop
    double size_ = 0.0;             ///< of the fields
};

/// Force and tip over a period, strain and velocity at t = 0, one frame for each member.
class CurveFrames {
public:
    explicit CurveFrames(const Continuum& curve)
        : curve_(curve),
          members_(chosen(curve.points.size(), maxFrames)),
          wall_(curve.scene.bar.gap / scales(curve.scene.bar).displacement),
          second_(wall_)
    {
        if (const auto& stop = curve.scene.secondStop) {
            second_ = -*stop / scales(curve.scene.bar).displacement;
        }
        tip_.see(wall_);
        tip_.see(second_);
        for (const std::size_t k : members_) {
            const State& state = curve.points[k].state;
            const Motion motion(state, curve.schedule);
            period_ = static_cast<double>(motion.steps()) / static_cast<double>(motion.cells());
            for (std::int64_t m = 0; m < motion.steps(); ++m) {
                force_.see(motion.wallForce(m));
                tip_.see(motion.displacement(motion.cells(), m));
            }
            for (const double value : strain(state)) {
                fields_.see(value);
            }
            for (const double value : velocity(state)) {
                fields_.see(value);
            }
        }
    }

    [[nodiscard]] std::string script() const
    {
        Text script;
        print(script,
              "set border lw 0.8\nset tics out nomirror scale 0.6\nset grid lw 0.4 lc '{}'\n",
              palette::grid);
        for (const std::size_t k : members_) {
            printFrame(script, curve_.points[k]);
        }
        return fmt::to_string(script);
    }

private:
    void printData(Text& script, const State& state) const
    {
        const Motion motion(state, curve_.schedule);
        const auto cells = static_cast<double>(motion.cells());
        print(script, "$time << EOD\n");
        for (const std::int64_t m : thinned(motion.steps() - 1, maxInstants)) {
            print(script, "{:.5g} {:.5g} {:.5g}\n", static_cast<double>(m) / cells,
                  motion.wallForce(m), motion.displacement(motion.cells(), m));
        }
        print(script, "EOD\n$bar << EOD\n");
        for (const std::int64_t i : thinned(motion.cells(), maxInstants)) {
            const std::int64_t cell = std::max<std::int64_t>(i, 1);
            print(script, "{:.5g} {:.5g} {:.5g}\n", static_cast<double>(i) / cells,
                  motion.strain(cell, 0), motion.velocity(cell, 0));
        }
        print(script, "EOD\n");
    }

    void printFrame(Text& script, const ContinuumPoint& point) const
    {
        printData(script, point.state);
        begin(script, fmt::format("{}, {}:   λ = {:.4g} ({})", curve_.family,
                                  energyLabel(curve_.scene.bar, curve_.energyRatio), point.lambda,
                                  name(curve_.parameter)));
        panel(script, 0.72, 0.92);
        print(script,
              "set xrange [0:{}]\nset yrange {}\nset ylabel '{}'\nset format x ''\n"
              "set xlabel ''\nset key top right Left reverse samplen 1.5\n"
              "plot $time using 1:2 with fillsteps fillcolor '{}' fillstyle solid noborder "
              "title 'force on the {}'\n"
              "unset key\n",
              period_, force_.text(), axisNames(wall_).force, palette::contact,
              curve_.scene.secondStop ? "stops, of the second below 0" : "wall");
        panel(script, 0.48, 0.68);
        print(script,
              "set yrange {}\nset ylabel 'u(L,t)/{}'\nset format x '%g'\n"
              "set xlabel 'time  t c/L' offset 0,0.6\n"
              "plot {} with lines lw 1 dt (4,4) lc 'black', {} with lines lw 1 dt (4,4) lc "
              "'black', $time using 1:3 with lines lw 2 lc 'black'\n",
              tip_.text(), axisNames(wall_).displacement, wall_, second_);
        panel(script, 0.11, 0.35);
        print(script,
              "set xrange [0:1]\nset yrange {0}\nset ylabel '{1}'\n"
              "set xlabel 'position  x/L  at t = 0'\n"
              "set key top right horizontal Left reverse samplen 1.5\n"
              "plot $bar using 1:2 with fsteps lw 4 lc '{2}' title 'strain', "
              "$bar using 1:3 with fsteps lw 2 lc '{3}' title 'velocity'\n",
              fields_.text(), axisNames(wall_).fields, palette::strain, palette::velocity);
        end(script);
    }

    const Continuum& curve_;
    std::vector<std::size_t> members_;
    double wall_;          ///< u(L) there
    double second_;        ///< at the second stop, or at the wall
    double period_ = 0.0;  ///< [L/c], of the folded schedule
    Range force_;
    Range tip_;
    Range fields_;
};

}  // namespace

AnimationFormat animationFormat(const std::string& path)
{
    if (path.ends_with(".gif")) {
        return AnimationFormat::gif;
    }
    if (path.ends_with(".mp4")) {
        return AnimationFormat::mp4;
    }
    throw std::invalid_argument(fmt::format(
        "animation = {} is out of range: allowed a name ending in .gif or .mp4", onOneLine(path)));
}

void animateMotion(const MotionSamples& samples, AnimationFormat format, const std::string& path)
{
    runGnuplot(MotionFrames(samples).script(), format, path);
}

void animateContinuum(const Continuum& curve, AnimationFormat format, const std::string& path)
{
    if (curve.points.empty()) {
        throw std::invalid_argument("animation: the curve holds no motion to draw");
    }
    runGnuplot(CurveFrames(curve).script(), format, path);
}

}  // namespace signorini
