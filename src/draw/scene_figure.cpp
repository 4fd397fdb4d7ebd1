
#include <algorithm>
#include <cmath>
#include <vector>

#include "network.hpp"
#include "scene_figures.hpp"

namespace signorini {

namespace {

using namespace plot;

constexpr double symbol = 0.045;  ///< width of gaps and symbols, in lengths of all bars
constexpr double tallest = 0.24;  ///< half the height of the bar of most impedance
constexpr double ground = -0.85;  ///< where springs and dashpots stand
constexpr double wall = 0.5;      ///< half the height of walls

class SceneSketch {
public:
    explicit SceneSketch(const Network& network) : network_(network) { place(); }

    FigureData figure()
    {
        figure_ = {.width = 16.0, .height = 5.0};
        Panel& panel =
            figure_.add({.name = "scene", .place = {0.01, 0.99, 0.02, 0.98}, .isFramed = false});
        panel.x = {.low = -2.5 * symbol, .high = places_.back() + 2.5 * symbol};
        panel.y = {.low = -1.05, .high = 1.0};
        for (const CellRow& row : network_.rows) {
            box(places_[row.left], -heightOf(row), places_[row.right], heightOf(row), Role::grid);
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
        return std::move(figure_);
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

    void draw(Series series) { figure_.panels.front().add(std::move(series)); }

    void box(double left, double low, double right, double high, Role role, bool isHatched = false)
    {
        Series filled = plot::box(role, left, low, right, high);
        filled.isHatched = isHatched;
        draw(std::move(filled));
        draw({.role = role == Role::grid ? Role::ink : role,
              .width = 1.0,
              .x = {left, right, right, left, left},
              .y = {low, low, high, high, low}});
    }
    void line(double x, double y, double toX, double toY, double width = 1.2)
    {
        draw({.width = width, .x = {x, toX}, .y = {y, toY}});
    }
    void arrow(double x, double y, double toX, double toY, double width = 1.5)
    {
        draw({.kind = Kind::arrows, .width = width, .x = {x}, .y = {y}, .x2 = {toX}, .y2 = {toY}});
    }
    void label(double x, double y, const std::string& words, Role role = Role::ink,
               Align align = Align::centre)
    {
        Series said = plot::labels(1.0, align, role);
        said.add(x, y, words);
        draw(std::move(said));
    }

    void drawNode(std::size_t node)
    {
        const NetworkNode& here = network_.nodes[node];
        const double x = places_[node];
        if (isLeftEnd(node) && isRightEnd(node)) {  // a face without cells
            box(x, -0.3, x + 0.2 * symbol, 0.3, Role::ink);
        }
        if (here.isClamped) {
            const double side = isLeftEnd(node) ? -1.0 : isRightEnd(node) ? 1.0 : 0.0;
            box(x + (side == 0.0 ? -0.25 : std::min(side, 0.0)) * 0.6 * symbol, -wall,
                x + (side == 0.0 ? 0.25 : std::max(side, 0.0)) * 0.6 * symbol, wall, Role::ink,
                true);
            line(x, -wall, x, wall);
        }
        if (here.isShaken) {
            arrow(x, 0.66, x + symbol, 0.66);
            arrow(x, 0.66, x - symbol, 0.66);
            label(x, 0.8, "base", Role::ink);
        }
        if (here.isDriven) {
            arrow(x, -0.42, x + symbol, -0.42);
            arrow(x, -0.42, x - symbol, -0.42);
            // Beside, as springs and dashpots stand below.
            const double side = isLeftEnd(node) ? 1.0 : -1.0;
            label(x + 1.3 * side * symbol, -0.42, "F cos ωt", Role::ink,
                  side > 0.0 ? Align::left : Align::right);
        }
        if (here.force != 0.0) {
            const double way = here.force > 0.0 ? 1.2 * symbol : -1.2 * symbol;
            arrow(x, heightAt(node) + 0.08, x + way, heightAt(node) + 0.08, 2.0);
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
        box(x - 0.35 * symbol, ground - 0.09, x + 0.35 * symbol, ground, Role::ink, true);
        line(x - 0.35 * symbol, ground, x + 0.35 * symbol, ground);
    }

    void drawDashpot(double x, double from)
    {
        const double middle = 0.5 * (from + ground);
        const double half = 0.2 * symbol;
        line(x, from, x, middle);
        line(x - 0.8 * half, middle, x + 0.8 * half, middle, 2.5);
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
        Series coil = plot::line(Role::ink, 1.2);
        coil.add(x, from);
        for (int k = 0; k <= turns; ++k) {
            const double side = k == 0 || k == turns ? 0.0 : k % 2 == 0 ? -0.18 : 0.18;
            coil.add(x + side * symbol, from + step * (k + 1));
        }
        coil.add(x, ground);
        draw(std::move(coil));
        drawGround(x);
    }

    void drawMass(std::size_t node)
    {
        const double x = places_[node];
        const double height = heightAt(node) + 0.08;
        box(x - 0.25 * symbol, -height, x + 0.25 * symbol, height, Role::ink);
        label(x, height + 0.1, "M", Role::ink);
    }

    void drawContact(std::size_t number)
    {
        const NetworkContact& contact = network_.contacts[number];
        const double x = places_[contact.node];
        const std::string words = std::to_string(number + 1);
        if (contact.kind == ContactKind::gap) {
            label(0.5 * (x + places_[contact.node + 1]), 0.62, words, Role::contact);
            return;
        }
        const double side = contact.kind == ContactKind::stopRight ? 1.0 : -1.0;
        const double face = x + side * 0.6 * symbol;
        const double back = face + side * 0.4 * symbol;
        const bool isOuter = side > 0.0 ? isRightEnd(contact.node) : isLeftEnd(contact.node);
        if (isOuter) {
            box(std::min(face, back), -wall, std::max(face, back), wall, Role::contact, true);
        } else {  // posts beside a collar
            const double height = heightAt(contact.node);
            line(x, -height - 0.1, x, height + 0.1, 4);
            box(std::min(face, back), height + 0.03, std::max(face, back), wall, Role::contact,
                true);
            box(std::min(face, back), -wall, std::max(face, back), -height - 0.03, Role::contact,
                true);
        }
        label(0.5 * (face + back), 0.62, words, Role::contact);
    }

    const Network& network_;
    FigureData figure_;
    std::vector<double> places_;
    double most_ = 1.0;
};

}  // namespace

FigureData sceneFigure(const Assembly& assembly)
{
    const Network network = networkOf(assembly);
    return SceneSketch(network).figure();
}

}  // namespace signorini
