#pragma once
/// \file
/// Bars in a row with all that stands at them, in SI units, and the words in which one writes that.
///
/// A text is read from left to right; words are separated by blanks:
///
///     clamp            the node here does not move
///     free             nothing holds it: what both ends are unless said otherwise
///     N[:Z[:C]]        N cells of relative impedance Z and wave speed C (1)
///     gap=G            the bar is cut here; at rest its faces are G apart (< 0: pressed)
///     stop=G stop=-G   the node may move by G to the right, to the left
///     stop=right:G     the same with G of any sign (< 0: pressed), also left:G
///     dash=D           a dashpot to the ground, in units of the impedance 1
///     spring=K mass=M  to the ground [N/m]; [kg]
///     force=F          constant, to the right [N]
///     driven           the harmonic force acts here
///     shaken           this clamp is the base that moves
///
/// "clamp 300 stop=1e-3" is the paper's bar. Contacts are numbered in the order in which they are
/// written. docs/theory.md, section 20.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace signorini {

/// What one word says.
enum class PartKind {
    clamp,
    free,
    cells,
    gap,
    rightStop,
    leftStop,
    dash,
    spring,
    mass,
    force,
    driven,
    shaken,
};

/// One word.
struct AssemblyPart {
    PartKind kind = PartKind::free;
    double value = 0.0;      ///< G [m], D [-], K [N/m], M [kg] or F [N]
    std::int64_t cells = 0;  ///< N
    double impedance = 1.0;  ///< [-], Z
    double speed = 1.0;      ///< [-], C

    friend bool operator==(const AssemblyPart&, const AssemblyPart&) = default;
};

/// All of it.
struct Assembly {
    std::vector<AssemblyPart> parts = {};
    double length = 1.0;                         ///< [m], of all bars without gaps
    double waveSpeed = 1.0;                      ///< [m/s], where C = 1
    double axialStiffness = 1.0;                 ///< [N], EA where Z = C = 1
    double gravity = 0.0;                        ///< [m/s^2], to the right
    std::optional<double> young = std::nullopt;  ///< [Pa], where C = 1

    friend bool operator==(const Assembly&, const Assembly&) = default;
};

/// Most words.
inline constexpr std::size_t maxParts = 10'000;

/// The words of a text.
/// \throws std::invalid_argument naming the word, its place, and what is allowed.
[[nodiscard]] std::vector<AssemblyPart> partsOf(std::string_view text);

/// The words of which `partsOf` makes the same parts.
[[nodiscard]] std::string textOf(const std::vector<AssemblyPart>& parts);

/// One word of it.
[[nodiscard]] std::string textOf(const AssemblyPart& part);

/// Is it a scene: are scales finite and positive, does something stand at every node, is there a
/// contact, and none where its law is unknown?
/// \throws std::invalid_argument naming the word and what is allowed.
void validate(const Assembly& assembly);

}  // namespace signorini
