// What multipliers of rows prove about the excitations of a network.

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "energy_floor.hpp"
#include "forced_cut.hpp"
#include "infinity.hpp"
#include "network_forced.hpp"

namespace signorini {

namespace {

constexpr std::size_t mostBorders = 20;

}  // namespace

bool NetworkForced::isCertain(std::span<const EnergyFloor> cuts) const
{
    const auto known = cutsOf(cuts, waves_.network(), waves_.schedule(), waves_.shapes());
    if (!canRest_) {
        return forbidUpTo(known, mostCutAmplitude, mostEnergy_);
    }
    // What is touched alone scales with the excitation.
    const bool scales = std::all_of(cuts.begin(), cuts.end(), [this](const EnergyFloor& cut) {
        return cut.strains.empty() &&
               std::all_of(cut.places.begin(), cut.places.end(), [this](const auto& place) {
                   return waves_.network().contacts[place.contact].gap == 0.0;
               });
    });
    return scales && forbidJust(known, 1.0, mostEnergy_);
}

/// One for each row, and one more for each equality, negated.
std::vector<EnergyFloor> NetworkForced::floorsOf(std::span<const std::size_t> rows) const
{
    std::vector<EnergyFloor> floors;
    for (const std::size_t row : rows) {
        const double size = 1.0 / std::max(1e-300, signorini::size(waves_.rows()[row].plane));
        for (const double sign : {size, -size}) {
            if (sign > 0.0 || waves_.rows()[row].isEquality) {
                floors.push_back(waves_.floor(std::array{row}, std::array{sign}));
            }
        }
    }
    return floors;
}

/// A program says so: the row that is added, C >= 1 and the like, contradicts others, whose sum is
/// the cut.
std::optional<EnergyFloor> NetworkForced::barrier(Plane way, std::optional<double> most,
                                                  std::vector<std::size_t>& used) const
{
    constexpr double beyond = 1e-7;
    std::vector<ForcedRow> rows = waves_.rows();
    const double limit = most ? *most + beyond * (1.0 + std::abs(*most)) : 1.0;
    rows.push_back({{ForcedRule::gap, 0}, false, way, {}, limit});
    const auto found = forcedPolytope(std::move(rows), {true, waves_.freeWaves()});
    if (!found.conflict || !(found.added > 0.0)) {
        return std::nullopt;
    }
    std::vector<std::size_t> conflict{0};
    std::vector<double> start = found.multipliers;
    for (const ForcedCondition& row : *found.conflict) {
        conflict.push_back(static_cast<std::size_t>(row.step));
    }
    for (double& multiplier : start) {
        multiplier /= found.added;
    }
    const auto multipliers = waves_.barrier(conflict, start, way, most.has_value());
    if (multipliers.empty()) {
        return std::nullopt;
    }
    used.insert(used.end(), conflict.begin(), conflict.end());
    return waves_.floor(conflict, multipliers);
}

/// Four programs say that no way from C = S = 0 leads anywhere.
void NetworkForced::explainRest(ForcedSet& set) const
{
    set.detail = "conditions exclude each other by no more than rounding can do";
    std::vector<EnergyFloor> cuts;
    std::vector<std::size_t> used;
    for (const Plane way : {Plane{1, 0}, Plane{0, 1}, Plane{-1, 0}, Plane{0, -1}}) {
        auto cut = barrier(way, {}, used);
        if (!cut) {
            return;
        }
        cuts.push_back(std::move(*cut));
    }
    if (isCertain(cuts)) {
        std::sort(used.begin(), used.end());
        used.erase(std::unique(used.begin(), used.end()), used.end());
        enterProof(set, used, std::move(cuts));
    }
}

std::vector<EnergyFloor> NetworkForced::bordersOf(const std::vector<ForcedCorner>& corners,
                                                  std::vector<std::size_t>& used) const
{
    std::vector<Plane> places;
    places.reserve(corners.size());
    for (const ForcedCorner& corner : corners) {
        places.push_back({corner.place[0], corner.place[1]});
    }
    std::vector<Plane> ways{{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
    if (places.size() > mostBorders) {
        ways.clear();
        for (std::size_t k = 0; k < mostBorders; ++k) {
            const double angle =
                2.0 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(mostBorders);
            ways.push_back({std::cos(angle), std::sin(angle)});
        }
    } else if (places.size() > 1) {
        ways.clear();
        for (std::size_t k = 0; k < places.size(); ++k) {
            const Plane edge = places[(k + 1) % places.size()] - places[k];
            const double length = std::sqrt(edge.dot(edge));
            ways.push_back((1.0 / length) * Plane{edge.s, -edge.c});
            if (places.size() == 2) {
                ways.push_back((1.0 / length) * edge);
            }
        }
    }
    std::vector<EnergyFloor> cuts;
    for (const Plane way : ways) {
        double most = -infinity;
        for (const Plane place : places) {
            most = std::max(most, way.dot(place));
        }
        if (auto cut = barrier(way, most, used)) {
            cuts.push_back(std::move(*cut));
        }
    }
    return cuts;
}

AmplitudeExclusion NetworkForced::exclusion(const ForcedSet& set, double amplitude) const
{
    AmplitudeExclusion exclusion{amplitude, {}, {}, false};
    const auto decideBy = [&](std::vector<EnergyFloor> cuts, std::span<const std::size_t> rows) {
        exclusion.cuts = std::move(cuts);
        exclusion.conflict = named(rows);
        exclusion.isCertain =
            forbidJust(cutsOf(exclusion.cuts, waves_.network(), waves_.schedule(), waves_.shapes()),
                       amplitude, mostEnergy_);
    };
    std::vector<std::size_t> rows;
    if (set.kind == ForcedKind::polytope) {
        for (std::size_t row = 0; row < waves_.rows().size(); ++row) {
            if (waves_.rows()[row].condition.rule == ForcedRule::work) {
                rows.push_back(row);
            }
        }
        decideBy(floorsOf(rows), rows);
        if (!exclusion.isCertain) {
            rows.clear();
            std::vector<EnergyFloor> borders = bordersOf(set.corners, rows);
            std::sort(rows.begin(), rows.end());
            rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
            decideBy(std::move(borders), rows);
        }
        return exclusion;
    }
    const ForcedLine line = this->line();
    rows.push_back(0);
    for (const auto& row : {line.lowRow, line.highRow}) {
        if (row) {
            rows.push_back(static_cast<std::size_t>(row->step));
        }
    }
    decideBy(floorsOf(rows), rows);
    return exclusion;
}

}  // namespace signorini
