#include "reports.hpp"

#include <fmt/format.h>

#include <cmath>

#include "printing.hpp"

namespace signorini::cli {

namespace {

constexpr std::size_t pieceSize = std::size_t{1} << 16;

/// On whose curve it stands, inside.
std::optional<Mode> modeOf(const Family& family)
{
    return standsOnMode(family) ? std::optional(modeThrough(family)) : std::nullopt;
}

/// Calls `add(text, family)` for each and hands the text on to `write` in pieces.
void inPieces(const std::vector<Family>& families, auto add, auto write)
{
    Text text;
    for (const Family& family : families) {
        add(text, family);
        if (text.size() > pieceSize) {
            write({text.data(), text.size()});
            text.clear();
        }
    }
    write({text.data(), text.size()});
}

}  // namespace

void writeText(const answers::FamilyList& list, const Write& write)
{
    const Scales unit = scales(list.bar);
    const std::string energy = std::isfinite(list.maxEnergyRatio)
                                   ? fmt::format(" that reach below {} E₁", list.maxEnergyRatio)
                                   : std::string();
    std::string head = fmt::format(
        "{} families of order w ≤ {}{}{}{}\n", list.families.size(), list.maxOrder, energy,
        list.secondStop ? ", clear of the second stop" : "",
        list.isComplete() ? "" : fmt::format(": {}, the list is not complete", list.ended));
    if (!list.families.empty()) {
        head += fmt::format("\n{:>5} {:>5} {:>4}  {:<10}{:<10}{:<10}{:<13}{:<13}{:<13}{:<14}{}\n",
                            "w", "ν", "k", "T [L/c]", "t_c≤[L/c]", "ω/ω₁", "f [Hz]", "E/E₁ from",
                            "= ", "E [J] from", "mode t_c");
    }
    write(head);
    inPieces(
        list.families,
        [&unit](Text& text, const Family& family) {
            const double period = exactPeriod(family).value();
            const ExactEnergy least = leastEnergy(family);
            const std::optional<Mode> mode = modeOf(family);
            print(text,
                  "{:>5} {:>5} {:>4}  {:<10}{:<10}{:<10.6g}{:<13.7g}{:<13}{:<13.6g}{:<14.6g}{}\n",
                  family.order, family.blocks, family.contactBlocks,
                  fractionAsText(exactPeriod(family)), fractionAsText(longestContact(family)),
                  4.0 / period, 1.0 / (period * unit.time),
                  fractionAsText({least.numerator, least.denominator}), least.value(),
                  least.value() * unit.energy, mode ? contactAsText(*mode) : "–");
        },
        write);
}

void writeJson(const answers::FamilyList& list, const Write& write)
{
    // The list goes in the place of "null}\n", piece by piece.
    std::string head = asLine(wholeJsonOf(list, "families"));
    head.resize(head.size() - std::string_view("null}\n").size());
    write(head + "[");
    std::string_view comma;
    inPieces(
        list.families,
        [&](Text& text, const Family& family) {
            print(text, "{}{}", comma, jsonOf(answers::FamilyOf{family, list.bar}).dump());
            comma = ",";
        },
        write);
    write("]}\n");
}

void writeFamiliesCsv(const std::string& path, const answers::FamilyList& list)
{
    constexpr std::string_view header =
        "order,nu,contact_blocks,period_ratio,contact_ratio,frequency_ratio,least_energy_ratio,"
        "period,frequency,least_energy,mode_contact,mode_turns";
    const Scales unit = scales(list.bar);
    writeCsv(path, header, [&](CsvRows& row) {
        for (const Family& family : list.families) {
            const double period = exactPeriod(family).value();
            const double energy = leastEnergy(family).value();
            const std::optional<Mode> mode = modeOf(family);
            row(family.order, family.blocks, family.contactBlocks, period,
                longestContact(family).value(), 4.0 / period, energy, period * unit.time,
                1.0 / (period * unit.time), energy * unit.energy,
                mode ? fmt::format("{},{}", 4 * mode->a, mode->b) : ",");
        }
    });
}

}  // namespace signorini::cli
