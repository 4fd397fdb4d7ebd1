#include "certificate_report.hpp"

#include <fmt/format.h>

#include <cmath>

#include "energy_bound.hpp"
#include "network_route.hpp"
#include "proofs.hpp"
#include "stepped_bar.hpp"

namespace signorini::cli {

namespace {

constexpr std::string_view none = R"("certificate":null)";
constexpr std::size_t longestPiece = 1U << 16U;  ///< characters

/// Writes the keys of a proof: all rows and multipliers, for what says "verified" can be verified
/// by others.
template <typename Proof>
struct ProofWriter {
    const Proof& proof;
    const WriteText& write;
    std::string text = {};
    char before = '{';

    static void record(const char*, const char*) {}
    template <typename Get>
    void key(const char* name, const char*, const char*, Get get,
             answers::When when = answers::When::always)
    {
        using Value = std::remove_cvref_t<std::invoke_result_t<Get, const Proof&>>;
        const auto& value = std::invoke(get, proof);
        const auto begin = [&] {
            text += fmt::format("{}\"{}\":", std::exchange(before, ','), name);
        };
        if constexpr (answers::isA<Value, std::vector>) {
            begin();
            std::string_view comma = "[";
            for (const auto& row : value) {
                text += comma;
                text += jsonOf(row).dump();
                comma = ",";
                flush();
            }
            text += value.empty() ? "[]" : "]";
        } else if (const Json json = jsonOf(value); !json.is_null() || !mayBeLeftOut(when)) {
            begin();
            text += json.dump();
        }
        flush();
    }
    void flush()
    {
        if (text.size() > longestPiece) {
            write(text);
            text.clear();
        }
    }
};

/// That a stepped bar has no motion of less energy than the one found, but for the tolerance.
std::optional<Json> segmentsCertificate(const PeriodicResult& result, const FindOptions& options)
{
    const auto floor = leastEnergyFloor(result.schedule, options);
    if (!floor ||
        std::abs(result.motion->energyRatio / floor->energyRatio - 1.0) > options.tolerance) {
        return std::nullopt;
    }
    Json json = jsonOf(*floor);
    const State& state = result.motion->state;  // at t = 0; the checker steps it in time
    json["state"] = {{"a", jsonOf(state.a)}, {"b", jsonOf(state.b)}};
    return json;
}

/// Does the range of energies of the whole schedule say which energy the motion has? Within limits
/// that is so for the least of all.
bool isOfRange(const PeriodicResult& result, const FindOptions& options)
{
    const bool isLimited = std::isfinite(options.strainLimit) || std::isfinite(options.tipFloor);
    return !result.motion || !isLimited ||
           (result.how.objective == Objective::minEnergy &&
            result.motion->energyRatio <= result.set.energy->least * (1.0 + options.tolerance));
}

}  // namespace

void writeCertificate(const Absence& absence, const WriteText& write)
{
    std::visit(
        [&write](const auto& proof) {
            ProofWriter<std::remove_cvref_t<decltype(proof)>> writer{proof, write};
            describe(writer, answers::Type<std::remove_cvref_t<decltype(proof)>>());
            write(writer.text + "}");
        },
        absence.proof);
}

Json claimOf(const Json& answer, const std::optional<Json>& energies)
{
    Json claim = Json::object();
    for (const char* key : {"schema", "version", "status", "cells", "schedule", "bar", "stops",
                            "segments", "certificate"}) {
        claim[key] = answer.at(key);
    }
    if (!energies) {
        const auto reason = answer.find("reason");
        if (reason != answer.end() && *reason == name(Reason::constraints) &&
            answer.at("segments").size() > 1) {
            claim["reason"] = *reason;  // an energy to hold is excluded, not all
        }
        return claim;
    }
    claim["certificate"] = *energies;
    claim["energy_ratio_range"] = answer.at("energy_ratio_range");
    if (energies->at("rows") == "network") {
        claim["energy_ratio_range"][1] = nullptr;  // of the most nothing is proved
    }
    const std::string objective = answer.at("objective");
    if (answer.at("status") == name(Status::found) &&
        (objective == name(Objective::minEnergy) ||
         (objective == name(Objective::maxEnergy) && energies->at("rows") != "network"))) {
        claim["objective"] = objective;
        claim["energy_ratio"] = answer.at("energy_ratio");
    }
    return claim;
}

void writeAnswer(const Json& answer, const PeriodicResult& result, const WriteText& write)
{
    const std::string line = asLine(answer);
    const std::size_t place = line.find(none);
    if (!result.absence || place == std::string::npos) {
        write(line);
        return;
    }
    const std::size_t value = place + none.size() - std::string_view("null").size();
    const std::string_view text = line;
    write(text.substr(0, value));
    writeCertificate(*result.absence, write);
    write(text.substr(place + none.size()));
}

std::optional<Json> energyCertificate(const PeriodicResult& result, const FindOptions& options)
{
    if (result.motion && result.how.objective == Objective::minEnergy && asksOfJoints(options)) {
        return segmentsCertificate(result, options);
    }
    const auto* exclusion =
        result.absence ? std::get_if<EnergyExclusion>(&result.absence->proof) : nullptr;
    if (!result.set.energy || !isUniform(result.scene.segments) ||
        (!result.motion && exclusion == nullptr) || !isOfRange(result, options)) {
        return std::nullopt;
    }
    const auto proof = leastEnergyProof(result.schedule);
    if (!proof) {
        return std::nullopt;
    }
    constexpr double rounding = 1e-12;
    Json json{{"kind", "energy-range"},
              {"verified",
               exclusion != nullptr
                   ? exclusion->isVerified
                   : exceedEnergy(result.schedule, result.set.energy->least * (1.0 - rounding))},
              {"rows", name(Formulation::lumped)}};
    if (exclusion != nullptr) {
        json["energy_ratio"] = exclusion->energyRatio;
        if (std::isfinite(exclusion->strainLimit)) {
            json["strain_limit"] = exclusion->strainLimit * (1.0 + exclusion->tolerance);
        }
    }
    json["equalities"] = jsonOf(proof->equalities);
    json["inequalities"] = jsonOf(proof->inequalities);
    return json;
}

}  // namespace signorini::cli
