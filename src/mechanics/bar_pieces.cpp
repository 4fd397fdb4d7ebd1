#include "signorini/bar_pieces.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

#include "faults.hpp"
#include "infinity.hpp"

namespace signorini {

namespace {

constexpr double alike = 1e-12;  // roundings of this size are those of the numbers given

/// Cells of each piece, and how far they are from its travel time.
struct Grid {
    std::vector<std::int64_t> cells = {};
    std::int64_t sum = 0;
    double rounding = infinity;
};

Grid measured(std::vector<std::int64_t> cells, const std::vector<double>& times, double total)
{
    Grid grid{.cells = std::move(cells), .rounding = 0.0};
    grid.sum = std::accumulate(grid.cells.begin(), grid.cells.end(), std::int64_t{0});
    for (std::size_t k = 0; k < times.size(); ++k) {
        const double made =
            total * static_cast<double>(grid.cells[k]) / static_cast<double>(grid.sum);
        grid.rounding = std::max(grid.rounding, std::abs(made / times[k] - 1.0));
    }
    return grid;
}

/// The best of at most so many cells.
Grid bestGrid(const std::vector<double>& times, double total, std::int64_t mostCells)
{
    const auto pieces = static_cast<std::int64_t>(times.size());
    Grid best = measured(std::vector<std::int64_t>(times.size(), 1), times, total);
    std::vector<std::int64_t> cells(times.size());
    for (std::int64_t wanted = mostCells; wanted > pieces; --wanted) {
        for (std::size_t k = 0; k < times.size(); ++k) {
            const double share = times[k] / total * static_cast<double>(wanted);
            cells[k] = std::max(std::int64_t{1}, static_cast<std::int64_t>(std::round(share)));
        }
        Grid grid = measured(cells, times, total);
        // Of those that round alike the first, the finest, stays.
        const bool isBetter = best.sum == pieces ? grid.rounding <= best.rounding + alike + alike
                                                 : grid.rounding < best.rounding - alike;
        if (grid.sum <= mostCells && isBetter) {
            best = std::move(grid);
        }
    }
    return best;
}

void requirePositive(std::span<const BarPiece> pieces)
{
    Faults faults;
    std::size_t number = 0;
    for (const BarPiece& piece : pieces) {
        const std::string of = fmt::format(" of piece {}", ++number);
        faults.requirePositive("length" + of, piece.length, "m");
        faults.requirePositive("young" + of, piece.young, "Pa");
        faults.requirePositive("density" + of, piece.density, "kg/m^3");
        faults.requirePositive("area" + of, piece.area, "m^2");
    }
    faults.throwIfAny();
}

}  // namespace

PiecedBar barOfPieces(std::span<const BarPiece> pieces, double gap, std::int64_t mostCells)
{
    Faults faults;
    if (pieces.empty()) {
        faults.add("pieces", 0, "at least 1");
    }
    const auto count = static_cast<std::int64_t>(pieces.size());
    if (!(mostCells >= std::max(count, std::int64_t{1}) && mostCells <= mostPieceCells)) {
        faults.add("cells", mostCells, fmt::format("{}..{}", count, mostPieceCells));
    }
    faults.throwIfAny();
    requirePositive(pieces);

    std::vector<double> times;
    double total = 0.0;
    for (const BarPiece& piece : pieces) {
        times.push_back(piece.length / std::sqrt(piece.young / piece.density));
        total += times.back();
    }
    const Grid best = bestGrid(times, total, mostCells);
    const BarPiece& first = pieces.front();
    PiecedBar answer{
        .scene = Scene(barOfMaterial(first.length, first.young, first.density, first.area, gap)),
        .cells = best.sum,
        .rounding = best.rounding};
    Bar& bar = answer.scene.bar;
    bar.length = 0.0;
    for (std::size_t k = 0; k < pieces.size(); ++k) {
        const BarPiece& piece = pieces[k];
        const double made =
            total * (static_cast<double>(best.cells[k]) / static_cast<double>(best.sum));
        bar.length += piece.length * (made / times[k]);
        if (pieces.size() > 1) {
            const double stiffness = piece.young / first.young;
            const double density = piece.density / first.density;
            answer.scene.segments.push_back(
                {.cells = best.cells[k],
                 .impedance = piece.area / first.area * std::sqrt(stiffness * density),
                 .speed = std::sqrt(stiffness / density)});
        }
        if (piece.young != first.young) {
            bar.young.reset();
        }
    }
    validate(answer.scene);
    return answer;
}

}  // namespace signorini
