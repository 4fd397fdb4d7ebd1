#pragma once
/// \file
/// Proofs of absence in JSON, written piece by piece: one of a fine grid has more numbers than
/// memory should hold twice. docs/certificates.md says what each number means.

#include <functional>
#include <string_view>

#include "json.hpp"
#include "signorini/find_periodic.hpp"

namespace signorini::cli {

using WriteText = std::function<void(std::string_view)>;

/// "certificate" of an answer.
void writeCertificate(const Absence& absence, const WriteText& write);

/// An answer, whose certificate is null, as one line with the certificate of its absence in place.
void writeAnswer(const Json& answer, const PeriodicResult& result, const WriteText& write);

}  // namespace signorini::cli
