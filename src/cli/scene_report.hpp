#pragma once
/// \file
/// A scene in words and as JSON.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "contact_spans.hpp"
#include "json.hpp"
#include "network.hpp"
#include "network_walk.hpp"
#include "scene_answer.hpp"
#include "signorini/certificate.hpp"

namespace signorini::cli {

using answers::contactsOf;
using answers::placesOf;

/// E_1 [Z_1 delta^2/h]; none where a bar drifts, or the gap is 0.
[[nodiscard]] std::optional<double> firstEnergy(const Network& network);

/// E_1, or else what bars have that move by the gaps in a step, or under constant forces in a
/// period: motions of `hugeEnergyRatio` times as much are not looked for [Z_1 delta^2/h].
[[nodiscard]] double usualEnergy(const Network& network, const std::vector<ContactSpan>& schedule);

/// [s].
[[nodiscard]] double periodOf(const Network& network, const std::vector<ContactSpan>& schedule);

/// "1:2 -:9 1+2:3 -:8".
[[nodiscard]] std::string textOf(const std::vector<ContactSpan>& schedule);
[[nodiscard]] Json scheduleAsJson(const std::vector<ContactSpan>& schedule);

/// Lists of [contact, step, multiplier]; contacts count from 1.
[[nodiscard]] Json multipliersAsJson(const EnergyFloor& multipliers);

/// Enters peak force, impulse and duration of a period into the JSON of contacts.
void addForces(Json& contacts, const Network& network, const std::vector<ContactSpan>& schedule,
               const NetworkResiduals& residuals);

/// The same in words, a line for each contact.
[[nodiscard]] std::string forcesAsText(const Network& network, const NetworkResiduals& residuals);

/// The line that restates the bars.
[[nodiscard]] std::string headline(const Assembly& assembly, const Network& network);

}  // namespace signorini::cli
