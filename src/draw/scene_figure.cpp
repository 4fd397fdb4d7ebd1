#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "gnuplot.hpp"
#include "network.hpp"
#include "palette.hpp"
#include "scene_figures.hpp"
#include "text.hpp"

namespace signorini {

namespace {

constexpr double symbol = 0.045;  ///< width of gaps and symbols, in lengths of all bars
constexpr double tallest = 0.24;  ///< half the height of the bar of most impedance
constexpr double ground = -0.85;  ///< where springs and dashpots stand
constexpr double wall = 0.5;      ///< half the height of walls
constexpr const char* hatched = "fillstyle pattern 4 border";

class SceneSketch {
public:
    explicit SceneSketch(const Network& network) : network_(network) { place(); }

    std::string script()
    {
        print(text_,
              "set termoption font ',11'\nunset border\nunset tics\nunset key\nset xrange "
              "[{:.6g}:{:.6g}]\nset "
              "yrange [-1.05:1]\nset lmargin 1\nset rmargin 1\nset tmargin 0.5\nset bmargin 0.5\n",
              -2.5 * symbol, places_.back() + 2.5 * symbol);
        for (const CellRow& row : network_.rows) {
            box(places_[row.left], -heightOf(row), places_[row.right], heightOf(row),
                "fillstyle solid 1.0 border lc 'black'", palette::grid);
        }
        for (std::size_t node = 0; node < network_.nodes.size(); ++node) {
            drawNode(node);
        }
        for (const Stub& stub : network_.stubs) {
            stub.kind == StubKind::spring ? drawSpring(stub.node) : drawMass(stub.node);
        }
        for (std::size_t j = 0; j < network_.contacts.size(); ++j) {
            drawContact(j);
        }
        print(text_, "plot NaN notitle\n");
        return fmt::to_string(text_);
    }

private:
    /// Rows to scale; a gap, and a face without cells, get the width of a symbol.
    void place()
    {
        double cells = 0.0;
        double most = 0.0;
        for (const CellRow& row : network_.rows) {
            cells += static_cast<double>(row.cells) * row.speed;
            most = std::max(most, row.impedance);
        }
        most_ = most;
        places_.assign(network_.nodes.size(), 0.0);
        auto row = network_.rows.begin();
        for (std::size_t node = 1; node < places_.size(); ++node) {
            double step = isLeftEnd(node) && isRightEnd(node) ? 2.5 * symbol : symbol;
            if (row != network_.rows.end() && row->right == node) {
                step = static_cast<double>(row->cells) * row->speed / cells;
                ++row;
            }
            places_[node] = places_[node - 1] + step;
        }
    }

    [[nodiscard]] double heightOf(const CellRow& row) const
    {
        return tallest * std::max(0.25, std::sqrt(row.impedance / most_));
    }

    /// Of what stands at a node.
    [[nodiscard]] double heightAt(std::size_t node) const
    {
        double height = 0.06;
        for (const CellRow& row : network_.rows) {
            height =
                row.left == node || row.right == node ? std::max(height, heightOf(row)) : height;
        }
        return height;
    }

    [[nodiscard]] bool isLeftEnd(std::size_t node) const
    {
        return network_.bars[network_.nodes[node].bar].firstNode == node;
    }
    [[nodiscard]] bool isRightEnd(std::size_t node) const
    {
        return network_.bars[network_.nodes[node].bar].lastNode == node;
    }

    void box(double left, double low, double right, double high, const char* style,
             const char* colour)
    {
        print(text_,
              "set object {} rectangle from {:.6g},{:.6g} to {:.6g},{:.6g} fillcolor '{}' {}\n",
              ++objects_, left, low, right, high, colour, style);
    }
    void line(double x, double y, double toX, double toY, const char* style = "nohead lw 1.2")
    {
        print(text_, "set arrow from {:.6g},{:.6g} to {:.6g},{:.6g} {} lc '{}' front\n", x, y, toX,
              toY, style, palette::ink);
    }
    void label(double x, double y, const std::string& words, const char* colour)
    {
        print(text_, "set label \"{}\" at {:.6g},{:.6g} center textcolor '{}' front\n", words, x, y,
              colour);
    }

    void drawNode(std::size_t node)
    {
        const NetworkNode& here = network_.nodes[node];
        const double x = places_[node];
        if (isLeftEnd(node) && isRightEnd(node)) {  // a face without cells
            box(x, -0.3, x + 0.2 * symbol, 0.3, "fillstyle solid 1.0 border", palette::ink);
        }
        if (here.isClamped) {
            const double side = isLeftEnd(node) ? -1.0 : isRightEnd(node) ? 1.0 : 0.0;
            box(x + (side == 0.0 ? -0.25 : std::min(side, 0.0)) * 0.6 * symbol, -wall,
                x + (side == 0.0 ? 0.25 : std::max(side, 0.0)) * 0.6 * symbol, wall, hatched,
                palette::ink);
            line(x, -wall, x, wall);
        }
        if (here.isShaken) {
            line(x - symbol, 0.66, x + symbol, 0.66, "heads size screen 0.008,25 filled lw 1.5");
            label(x, 0.8, "base", palette::ink);
        }
        if (here.isDriven) {
            line(x - symbol, -0.42, x + symbol, -0.42, "heads size screen 0.008,25 filled lw 1.5");
            label(x, -0.54, "F cos ωt", palette::ink);
        }
        if (here.force != 0.0) {
            const double way = here.force > 0.0 ? 1.2 * symbol : -1.2 * symbol;
            line(x, heightAt(node) + 0.08, x + way, heightAt(node) + 0.08,
                 "head size screen 0.01,25 filled lw 2");
        }
        if (here.dashpot > 0.0) {
            drawDashpot(x - (hasSpring(node) ? 0.3 * symbol : 0.0), -heightAt(node));
        }
    }

    [[nodiscard]] bool hasSpring(std::size_t node) const
    {
        return std::any_of(network_.stubs.begin(), network_.stubs.end(), [node](const Stub& stub) {
            return stub.node == node && stub.kind == StubKind::spring;
        });
    }

    void drawGround(double x)
    {
        box(x - 0.35 * symbol, ground - 0.09, x + 0.35 * symbol, ground, hatched, palette::ink);
        line(x - 0.35 * symbol, ground, x + 0.35 * symbol, ground);
    }

    void drawDashpot(double x, double from)
    {
        const double middle = 0.5 * (from + ground);
        const double half = 0.2 * symbol;
        line(x, from, x, middle);
        line(x - 0.8 * half, middle, x + 0.8 * half, middle, "nohead lw 2.5");
        line(x - half, middle + 0.08, x - half, middle - 0.1);
        line(x + half, middle + 0.08, x + half, middle - 0.1);
        line(x - half, middle - 0.1, x + half, middle - 0.1);
        line(x, middle - 0.1, x, ground);
        drawGround(x);
    }

    void drawSpring(std::size_t node)
    {
        const double x = places_[node] + (network_.nodes[node].dashpot > 0.0 ? 0.3 * symbol : 0.0);
        const double from = -heightAt(node);
        constexpr int turns = 8;
        const double step = (ground - from) / (turns + 2);
        line(x, from, x, from + step);
        for (int k = 0; k < turns; ++k) {
            const auto side = [&](int corner) {
                return corner == 0 || corner == turns ? 0.0
                       : corner % 2 == 0              ? -0.18 * symbol
                                                      : 0.18 * symbol;
            };
            line(x + side(k), from + step * (k + 1), x + side(k + 1), from + step * (k + 2));
        }
        line(x, ground - step, x, ground);
        drawGround(x);
    }

    void drawMass(std::size_t node)
    {
        const double x = places_[node];
        const double height = heightAt(node) + 0.08;
        box(x - 0.25 * symbol, -height, x + 0.25 * symbol, height, "fillstyle solid 1.0 border",
            palette::ink);
        label(x, height + 0.1, "M", palette::ink);
    }

    void drawContact(std::size_t number)
    {
        const NetworkContact& contact = network_.contacts[number];
        const double x = places_[contact.node];
        const std::string words = std::to_string(number + 1);
        if (contact.kind == ContactKind::gap) {
            label(0.5 * (x + places_[contact.node + 1]), 0.62, words, palette::contact);
            return;
        }
        const double side = contact.kind == ContactKind::stopRight ? 1.0 : -1.0;
        const double face = x + side * 0.6 * symbol;
        const double back = face + side * 0.4 * symbol;
        const bool isOuter = side > 0.0 ? isRightEnd(contact.node) : isLeftEnd(contact.node);
        if (isOuter) {
            box(std::min(face, back), -wall, std::max(face, back), wall, hatched, palette::contact);
        } else {  // posts beside a collar
            const double height = heightAt(contact.node);
            line(x, -height - 0.1, x, height + 0.1, "nohead lw 4");
            box(std::min(face, back), height + 0.03, std::max(face, back), wall, hatched,
                palette::contact);
            box(std::min(face, back), -wall, std::max(face, back), -height - 0.03, hatched,
                palette::contact);
        }
        label(0.5 * (face + back), 0.62, words, palette::contact);
    }

    const Network& network_;
    Text text_;
    std::vector<double> places_;
    double most_ = 1.0;
    int objects_ = 0;
};

}  // namespace

void drawScene(const Assembly& assembly, FigureFormat format, const std::string& path)
{
    const Network network = networkOf(assembly);
    runGnuplot(SceneSketch(network).script(), format, 16.0, 5.0, path);
}

}  // namespace signorini
