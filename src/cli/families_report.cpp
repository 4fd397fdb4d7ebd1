#include "reports.hpp"

#include <fmt/format.h>

#include <cmath>

#include "printing.hpp"

namespace signorini::cli {

namespace {

constexpr std::size_t pieceSize = std::size_t{1} << 16;

/// What people ask of a family, in the units of a bar.
struct FamilyNumbers {
    double periodRatio;        ///< [L/c]
    double frequencyRatio;     ///< [-], omega/omega_1
    double period;             ///< [s]
    double frequency;          ///< [Hz]
    double energyRatio;        ///< [E_1], least
    double energy;             ///< [J], least
    std::optional<Mode> mode;  ///< on whose curve it stands, inside
};

FamilyNumbers numbersOf(const Family& family, const Scales& unit)
{
    const double ratio = exactPeriod(family).value();
    const double energy = leastEnergy(family).value();
    return {.periodRatio = ratio,
            .frequencyRatio = 4.0 / ratio,
            .period = ratio * unit.time,
            .frequency = 1.0 / (ratio * unit.time),
            .energyRatio = energy,
            .energy = energy * unit.energy,
            .mode = standsOnMode(family) ? std::optional(modeThrough(family)) : std::nullopt};
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
            const FamilyNumbers numbers = numbersOf(family, unit);
            const ExactEnergy least = leastEnergy(family);
            print(text,
                  "{:>5} {:>5} {:>4}  {:<10}{:<10}{:<10.6g}{:<13.7g}{:<13}{:<13.6g}{:<14.6g}{}\n",
                  family.order, family.blocks, family.contactBlocks,
                  fractionAsText(exactPeriod(family)), fractionAsText(longestContact(family)),
                  numbers.frequencyRatio, numbers.frequency,
                  fractionAsText({least.numerator, least.denominator}), numbers.energyRatio,
                  numbers.energy, numbers.mode ? contactAsText(*numbers.mode) : "–");
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
    writeCsv(path, header, [&list](CsvRows& row) {
        for (const Family& family : list.families) {
            const FamilyNumbers numbers = numbersOf(family, scales(list.bar));
            row(family.order, family.blocks, family.contactBlocks, numbers.periodRatio,
                longestContact(family).value(), numbers.frequencyRatio, numbers.energyRatio,
                numbers.period, numbers.frequency, numbers.energy,
                numbers.mode ? fmt::format("{},{}", 4 * numbers.mode->a, numbers.mode->b) : ",");
        }
    });
}

}  // namespace signorini::cli
