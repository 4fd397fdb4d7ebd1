#include "certificate_report.hpp"

#include <fmt/format.h>

#include <cmath>

#include "energy_bound.hpp"
#include "report.hpp"
#include "stepped_bar.hpp"
#include "stepped_route.hpp"
#include "text.hpp"

namespace signorini::cli {

namespace {

constexpr std::string_view none = R"("certificate":null)";
constexpr std::size_t longestPiece = 1U << 16U;  ///< characters

class Writer {
public:
    explicit Writer(const WriteText& write) : write_(write) {}

    void operator()(const FarkasCertificate& c) const
    {
        begin("paper");
        write_(fmt::format(R"(,"gap":{},"size":{})", c.gap, c.size));
        list("periodicity", c.periodicity);
        list("pressure", c.pressure);
        list("penetration", c.penetration);
        write_("}");
    }

    void operator()(const ProgramProof& proof) const
    {
        begin(name(proof.rows));
        limit("strain_limit", proof.demands.strainLimit * (1.0 + proof.tolerance));
        limit("tip_floor", proof.demands.tipFloor - proof.tolerance);
        lists(proof.multipliers);
    }

    void operator()(const SteppedProof& proof) const
    {
        begin(name(Formulation::joints));
        limit("tip_floor", proof.tipFloor - proof.tolerance);
        lists(proof.multipliers);
    }

    void operator()(const EnergyExclusion& exclusion) const
    {
        Json json{{"kind", "energy-range"}, {"verified", exclusion.isVerified}};
        if (!exclusion.isVerified) {
            json["note"] = rangeNote;
        }
        write_(json.dump());
    }

private:
    void begin(std::string_view rows) const
    {
        write_(fmt::format(R"({{"kind":"farkas","verified":true,"rows":"{}")", rows));
    }

    /// Of the motions that are excluded; null where it limits nothing.
    void limit(std::string_view key, double value) const
    {
        write_(fmt::format(R"(,"{}":)", key) +
               (std::isfinite(value) ? Json(value) : Json()).dump());
    }

    template <typename Proof>
    void lists(const Proof& proof) const
    {
        list("equalities", proof.equalities);
        list("inequalities", proof.inequalities);
        write_("}");
    }

    /// Rows and multipliers as pairs, all of them: what says "verified" can be verified by others.
    template <typename Rows>
    void list(std::string_view key, const Rows& rows) const
    {
        Text text;
        const auto flush = [&] {
            write_({text.data(), text.size()});
            text.clear();
        };
        print(text, R"(,"{}":[)", key);
        std::string_view comma;
        for (const auto& m : rows) {
            print(text, "{}[{},", comma, m.row);
            printValue(text, m.value);
            text.push_back(']');
            comma = ",";
            if (text.size() > longestPiece) {
                flush();
            }
        }
        text.push_back(']');
        flush();
    }

    static void printValue(Text& text, std::int64_t value) { print(text, "{}", value); }
    static void printValue(Text& text, const std::string& fraction)
    {
        print(text, R"("{}")", fraction);
    }

    const WriteText& write_;
};

/// Adds multipliers to a certificate as pairs.
void addRows(Json& json, const RationalProof& proof)
{
    const auto list = [&json](const char* key, const std::vector<RationalMultiplier>& rows) {
        json[key] = Json::array();
        for (const RationalMultiplier& m : rows) {
            json[key].push_back({m.row, m.value});
        }
    };
    list("equalities", proof.equalities);
    list("inequalities", proof.inequalities);
}

/// That a stepped bar has no motion of less energy than the one found, but for the tolerance.
std::optional<Json> steppedCertificate(const PeriodicResult& result, const FindOptions& options)
{
    const auto proof = leastSteppedEnergy(result.schedule, options);
    if (!proof ||
        !(std::abs(result.motion->energyRatio / proof->energyRatio - 1.0) <= options.tolerance)) {
        return std::nullopt;
    }
    Json json{{"kind", "energy-range"},
              {"verified", true},
              {"rows", name(Formulation::joints)},
              {"tip_floor", std::isfinite(options.tipFloor) ? Json(options.tipFloor) : Json()},
              {"energy_ratio", proof->energyRatio}};
    addRows(json, proof->multipliers);
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
    std::visit(Writer(write), absence.proof);
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
    if (result.motion && result.how.objective == Objective::minEnergy && isStepped(options)) {
        return steppedCertificate(result, options);
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
    addRows(json, *proof);
    return json;
}

}  // namespace signorini::cli
