#pragma once
/// \file
/// Damping and force, as `response` and `simulate` take them: SI in, scaled units out.

#include <optional>
#include <string>

#include "arguments.hpp"
#include "signorini/simulation.hpp"

namespace signorini::cli {

struct ForceOptions {
    std::optional<double> ratio;
    std::optional<Excited> place;
    std::optional<double> amplitude;  ///< [N] or [m]

    void addTo(CLI::App& command);

    /// None without --damping.
    [[nodiscard]] Damping damping() const { return {ratio.value_or(0.0)}; }
    /// In units of EA g/L (tip) or g (base). \pre place and amplitude were given.
    [[nodiscard]] double scaledAmplitude(const Bar& bar) const;
};

}  // namespace signorini::cli
