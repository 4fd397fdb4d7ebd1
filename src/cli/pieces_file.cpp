// --segments-file: the pieces of a bar as a drawing has them.

#include <algorithm>
#include <array>
#include <numbers>

#include "arguments.hpp"
#include "files.hpp"
#include "given.hpp"
#include "table.hpp"

namespace signorini::cli {

namespace {

/// Rows of a table with columns length [m], young [Pa], density [kg/m^3], and area [m^2] or
/// diameter [m]; clamp first.
std::vector<BarPiece> readPieces(const std::string& path)
{
    return forFile("--segments-file", path, [&] {
        Table table(path);
        const bool isRound = table.has("diameter");
        if (isRound == table.has("area")) {
            table.refuse("columns area and diameter: allowed one of them");
        }
        const auto positive = [&table](std::size_t column, const char* unit) {
            const double value = table.numberAt(column, unit);
            if (!(value > 0.0)) {
                table.refuse(column, fmt::format("numbers > 0 [{}]", unit));
            }
            return value;
        };
        const std::size_t length = table.columnOf("length");
        const std::size_t young = table.columnOf("young");
        const std::size_t density = table.columnOf("density");
        const std::size_t section = table.columnOf(isRound ? "diameter" : "area");
        std::vector<BarPiece> pieces;
        while (table.next()) {
            const double size = positive(section, isRound ? "m" : "m^2");
            pieces.push_back({.length = positive(length, "m"),
                              .young = positive(young, "Pa"),
                              .density = positive(density, "kg/m^3"),
                              .area = isRound ? 0.25 * std::numbers::pi * size * size : size});
            if (pieces.size() > maxParts) {
                table.refuse(fmt::format("more than {} pieces", maxParts));
            }
        }
        return pieces;
    });
}

}  // namespace

const PiecedBar& CommonOptions::pieces() const
{
    if (!pieces_) {
        constexpr std::array others{"--wave-speed", "--axial-stiffness", "--young", "--density",
                                    "--area",       "--diameter"};
        const bool isClash = !segments_.empty() || !sceneText.empty() ||
                             given_->number("--length").value_or(Bar{}.length) != Bar{}.length ||
                             std::any_of(others.begin(), others.end(),
                                         [this](const char* other) { return given_->has(other); });
        refuseIf(isClash,
                 "--segments-file clashes with --scene, --segments, --length, --wave-speed, "
                 "--axial-stiffness, --young, --density, --area: the file gives them");
        pieces_ = barOfPieces(readPieces(piecesFile_), given_->number("--gap").value_or(Bar{}.gap),
                              cells.value_or(300));
    }
    return *pieces_;
}

}  // namespace signorini::cli
