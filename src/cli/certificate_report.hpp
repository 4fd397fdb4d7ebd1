#pragma once
/// \file
/// Proofs of absence in JSON, written piece by piece: one of a fine grid has more numbers than
/// memory should hold twice. docs/certificates.md says what each number means.

#include <functional>
#include <optional>
#include <string_view>

#include "json.hpp"
#include "signorini/find_periodic.hpp"

namespace signorini::cli {

using WriteText = std::function<void(std::string_view)>;

/// "certificate" of an answer.
void writeCertificate(const Absence& absence, const WriteText& write);

/// Of an answer what a proof says, and no more, with the proof about energies if it is one: a
/// checker refuses what it does not check.
[[nodiscard]] Json claimOf(const Json& answer, const std::optional<Json>& energies);

/// An answer, whose certificate is null, as one line with the certificate of its absence in place.
void writeAnswer(const Json& answer, const PeriodicResult& result, const WriteText& write);

/// What proves the least energy of a set with a gap, and what an energy to hold misses; nothing
/// where the answer keeps a further limit, or where no multipliers are known.
[[nodiscard]] std::optional<Json> energyCertificate(const PeriodicResult& result,
                                                    const FindOptions& options);

}  // namespace signorini::cli
