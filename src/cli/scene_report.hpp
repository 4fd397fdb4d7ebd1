#pragma once
/// \file
/// A scene in words and as JSON.

#include <string>
#include <string_view>
#include <vector>

#include "json.hpp"
#include "network.hpp"

namespace signorini::cli {

/// "right stop", "left stop", "gap".
[[nodiscard]] std::string_view name(ContactKind kind);

/// Where each node is at rest [m], in bars of so much length in all that stand end to end.
[[nodiscard]] std::vector<double> placesOf(const Network& network, double length);

/// Number, kind, place and gap of each contact.
[[nodiscard]] Json contactsAsJson(const Network& network, double length);

/// omega_1, zeta, E_1 of the scene.
[[nodiscard]] Json referenceAsJson(const Network& network);

/// The line that restates the bars.
[[nodiscard]] std::string headline(const Assembly& assembly, const Network& network);

}  // namespace signorini::cli
