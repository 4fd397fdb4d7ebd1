#include "signorini/assembly.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "faults.hpp"
#include "signorini/schedule.hpp"
#include "stepped_bar.hpp"
#include "units.hpp"

namespace signorini {

namespace {

constexpr const char* allWords =
    "clamp, free, N[:Z[:C]], gap=G, stop=[right:|left:]G, dash=D, spring=K, mass=M, force=F, "
    "driven, shaken";

[[noreturn]] void refuseWord(std::size_t number, std::string_view word, std::string_view allowed)
{
    throwFault(fmt::format("scene, word {}", number), word.empty() ? "''" : word, allowed);
}

/// A finite number in a unit.
bool readNumber(std::string_view text, std::string_view unit, double& value)
{
    const auto read = numberIn(text, unit);
    value = read.value_or(value);
    return read.has_value();
}

struct PlainWord {
    std::string_view word;
    PartKind kind;
};
constexpr std::array plainWords{
    PlainWord{"clamp", PartKind::clamp}, PlainWord{"free", PartKind::free},
    PlainWord{"driven", PartKind::driven}, PlainWord{"shaken", PartKind::shaken}};

struct ValuedWord {
    std::string_view word;
    PartKind kind;
    std::string_view unit;
    std::string_view allowed;
    bool isPositive;
};
constexpr std::array valuedWords{
    ValuedWord{"gap", PartKind::gap, "m", "gap=G, G finite [m]", false},
    ValuedWord{"dash", PartKind::dash, "-", "dash=D, D finite and > 0, in units of the impedance 1",
               true},
    ValuedWord{"spring", PartKind::spring, "N/m", "spring=K, K finite and > 0 [N/m]", true},
    ValuedWord{"mass", PartKind::mass, "kg", "mass=M, M finite and > 0 [kg]", true},
    ValuedWord{"force", PartKind::force, "N", "force=F, F finite [N]", false}};

AssemblyPart cellsOf(std::size_t number, std::string_view word)
{
    AssemblyPart part{.kind = PartKind::cells};
    std::string_view rest = word;
    const auto take = [&rest] {
        const std::size_t colon = rest.find(':');
        const std::string_view taken = rest.substr(0, colon);
        rest.remove_prefix(colon == std::string_view::npos ? rest.size() : colon + 1);
        return taken;
    };
    const bool endsWithColon = word.back() == ':';
    part.cells = wholeIn(take(), 1, maxCells).value_or(0);
    bool isGood = part.cells > 0;
    for (double* value : {&part.impedance, &part.speed}) {
        if (!rest.empty()) {
            isGood = readNumber(take(), "-", *value) && isImpedance(*value) && isGood;
        }
    }
    if (!isGood || !rest.empty() || endsWithColon) {
        refuseWord(number, word,
                   fmt::format("N[:Z[:C]], N cells in 1..{}, impedance Z and speed C in {}..{}",
                               maxCells, 1.0 / mostImpedance, mostImpedance));
    }
    return part;
}

AssemblyPart stopOf(std::size_t number, std::string_view word, std::string_view value)
{
    AssemblyPart part{.kind = PartKind::rightStop};
    const bool saysRight = value.starts_with("right:");
    const bool saysLeft = value.starts_with("left:");
    value.remove_prefix(saysRight ? 6 : saysLeft ? 5 : 0);
    if (!readNumber(value, "m", part.value)) {
        refuseWord(number, word,
                   "stop=G (to the right), stop=-G (to the left), stop=right:G or stop=left:G (G < "
                   "0: pressed), G finite [m]");
    }
    if (saysLeft) {
        part.kind = PartKind::leftStop;
    } else if (!saysRight && std::signbit(part.value)) {
        part.kind = PartKind::leftStop;
        part.value = -part.value;
    }
    return part;
}

AssemblyPart partOf(std::size_t number, std::string_view word)
{
    for (const PlainWord& plain : plainWords) {
        if (word == plain.word) {
            return {.kind = plain.kind};
        }
    }
    if (word.front() >= '0' && word.front() <= '9') {
        return cellsOf(number, word);
    }
    const std::size_t equals = word.find('=');
    const std::string_view name = word.substr(0, equals);
    const std::string_view value =
        equals == std::string_view::npos ? std::string_view{} : word.substr(equals + 1);
    if (name == "stop") {
        return stopOf(number, word, value);
    }
    for (const ValuedWord& valued : valuedWords) {
        if (name == valued.word) {
            AssemblyPart part{.kind = valued.kind};
            if (!readNumber(value, valued.unit, part.value) ||
                (valued.isPositive && !(part.value > 0.0))) {
                refuseWord(number, word, valued.allowed);
            }
            return part;
        }
    }
    refuseWord(number, word, allWords);
}

}  // namespace

std::vector<AssemblyPart> partsOf(std::string_view text)
{
    std::vector<AssemblyPart> parts;
    constexpr std::string_view blanks = " \t\r\n";
    while (true) {
        text.remove_prefix(std::min(text.find_first_not_of(blanks), text.size()));
        if (text.empty()) {
            return parts;
        }
        if (parts.size() == maxParts) {
            refuseWord(maxParts + 1, text.substr(0, text.find_first_of(blanks)),
                       fmt::format("at most {} words", maxParts));
        }
        const std::string_view word = text.substr(0, text.find_first_of(blanks));
        parts.push_back(partOf(parts.size() + 1, word));
        text.remove_prefix(word.size());
    }
}

std::string textOf(const AssemblyPart& part)
{
    for (const PlainWord& plain : plainWords) {
        if (part.kind == plain.kind) {
            return std::string(plain.word);
        }
    }
    for (const ValuedWord& valued : valuedWords) {
        if (part.kind == valued.kind) {
            return fmt::format("{}={}", valued.word, part.value);
        }
    }
    if (part.kind == PartKind::cells) {
        return part.speed != 1.0 ? fmt::format("{}:{}:{}", part.cells, part.impedance, part.speed)
               : part.impedance != 1.0 ? fmt::format("{}:{}", part.cells, part.impedance)
                                       : fmt::format("{}", part.cells);
    }
    const bool isRight = part.kind == PartKind::rightStop;
    if (std::signbit(part.value)) {  // pressed, or -0
        return fmt::format("stop={}:{}", isRight ? "right" : "left", part.value);
    }
    return fmt::format("stop={}", isRight ? part.value : -part.value);
}

std::string textOf(const std::vector<AssemblyPart>& parts)
{
    std::string text;
    for (const AssemblyPart& part : parts) {
        if (!text.empty()) {
            text += ' ';
        }
        text += textOf(part);
    }
    return text;
}

namespace {

/// The words at one node.
struct NodeWords {
    std::vector<std::pair<PartKind, std::size_t>> words;  ///< and their numbers
    bool endsBar = false;                                 ///< a gap or an end of the scene is here
    bool hasCells = false;
    bool hasGap = false;

    [[nodiscard]] std::size_t numberOf(PartKind kind) const
    {
        const auto found = std::find_if(words.begin(), words.end(),
                                        [kind](const auto& word) { return word.first == kind; });
        return found == words.end() ? 0 : found->second;
    }
    [[nodiscard]] bool has(PartKind kind) const { return numberOf(kind) > 0; }
};

class AssemblyCheck {
public:
    explicit AssemblyCheck(const Assembly& assembly) : assembly_(assembly) {}

    void run()
    {
        NodeWords here;
        here.endsBar = true;
        for (const AssemblyPart& part : assembly_.parts) {
            ++number_;
            checkValue(part);
            if (part.kind == PartKind::cells || part.kind == PartKind::gap) {
                const bool isGap = part.kind == PartKind::gap;
                here.hasCells = here.hasCells || !isGap;
                here.hasGap = here.hasGap || isGap;
                here.endsBar = here.endsBar || isGap;
                contacts_ += isGap ? 1 : 0;
                finish(here);
                here = {{}, isGap, !isGap, isGap};
                cells_ += part.cells;
                if (cells_ > maxCells) {
                    refuse(number_, fmt::format("at most {} cells in all", maxCells));
                }
                continue;
            }
            if (here.has(part.kind)) {
                refuse(number_, "once at a node");
            }
            here.words.emplace_back(part.kind, number_);
        }
        here.endsBar = true;
        finish(here);
        if (cells_ == 0) {
            throwScene("a row of cells, as in clamp 300 stop=1e-3");
        }
        if (contacts_ == 0) {
            throwScene("a contact: stop=G or gap=G");
        }
        if (contacts_ > 64) {
            throwScene("at most 64 contacts");
        }
    }

private:
    [[noreturn]] void refuse(std::size_t number, std::string_view allowed) const
    {
        refuseWord(number, textOf(assembly_.parts[number - 1]), allowed);
    }
    [[noreturn]] void throwScene(std::string_view allowed) const
    {
        const std::string text = textOf(assembly_.parts);
        throwFault("scene", text.empty() ? "''" : text, allowed);
    }

    /// Of the whole length: a gap, or a force.
    [[nodiscard]] double strainOf(const AssemblyPart& part) const
    {
        if (part.kind == PartKind::force) {
            return std::abs(part.value) / assembly_.axialStiffness;
        }
        const bool isWay = part.kind == PartKind::gap || part.kind == PartKind::rightStop ||
                           part.kind == PartKind::leftStop;
        return isWay ? std::abs(part.value) / assembly_.length : 0.0;
    }
    [[nodiscard]] double energyOf(double strain) const
    {
        return 0.5 * assembly_.axialStiffness * strain * strain * assembly_.length;
    }

    void checkValue(const AssemblyPart& part) const
    {
        const bool isPositive = part.kind == PartKind::dash || part.kind == PartKind::spring ||
                                part.kind == PartKind::mass;
        if (!std::isfinite(part.value) || (isPositive && !(part.value > 0.0))) {
            refuse(number_, isPositive ? "finite and > 0" : "finite");
        }
        if (const double strain = strainOf(part); strain != 0.0) {
            const double largest =
                std::max({strain, strain * assembly_.waveSpeed, energyOf(strain)});
            const double least = std::min({strain, strain * assembly_.waveSpeed, energyOf(strain)});
            if (!(least >= 1e-250 && largest <= 1e250)) {
                refuse(number_,
                       "0, or what leaves strains, speeds and energies in 1e-250..1e250, in SI "
                       "units");
            }
        }
        if (part.kind == PartKind::cells &&
            (part.cells < 1 || part.cells > maxCells || !isImpedance(part.impedance) ||
             !isImpedance(part.speed))) {
            refuse(number_, fmt::format("1..{} cells, impedance and speed in {}..{}", maxCells,
                                        1.0 / mostImpedance, mostImpedance));
        }
    }

    /// A node is known whole.
    void finish(const NodeWords& here)
    {
        const std::size_t clamp = here.numberOf(PartKind::clamp);
        const std::size_t right = here.numberOf(PartKind::rightStop);
        const std::size_t left = here.numberOf(PartKind::leftStop);
        contacts_ += (right > 0 ? 1 : 0) + (left > 0 ? 1 : 0);
        if (clamp > 0) {
            for (const auto& [kind, number] : here.words) {
                if (kind != PartKind::clamp && kind != PartKind::shaken) {
                    refuse(number, "places that move: a clamp does not");
                }
            }
            if (here.hasGap) {
                refuse(clamp, "a stop in its place: a clamp at a gap does not move");
            }
            if (!here.hasCells) {
                refuse(clamp, "a clamp with cells beside it");
            }
        }
        if (const std::size_t shaken = here.numberOf(PartKind::shaken); shaken > 0 && clamp == 0) {
            refuse(shaken, "at a clamp");
        }
        if (const std::size_t free = here.numberOf(PartKind::free); free > 0 && !here.endsBar) {
            refuse(free, "at an end of a bar");
        }
        const bool isContact = right > 0 || left > 0 || here.hasGap;
        if (const std::size_t mass = here.numberOf(PartKind::mass); mass > 0 && isContact) {
            refuse(
                mass,
                "places without contact: what happens when a mass strikes needs a law of impact");
        }
        if (right > 0 && left > 0 &&
            !(assembly_.parts[right - 1].value + assembly_.parts[left - 1].value > 0.0)) {
            refuse(std::max(right, left), "two stops that leave the node some way between them");
        }
        if (!here.hasCells) {
            checkFace(here);
        }
    }

    /// A node without cells: what stands behind a gap.
    void checkFace(const NodeWords& here) const
    {
        const std::size_t spring = here.numberOf(PartKind::spring);
        if (!here.hasGap) {
            throwScene("a row of cells, as in clamp 300 stop=1e-3");
        }
        if (spring == 0) {
            refuse(number_, "a gap with cells, or a spring and a dashpot, on either side");
        }
        const std::size_t dash = here.numberOf(PartKind::dash);
        if (dash == 0) {
            refuse(spring,
                   "behind a gap only with dash=D: without one its open face would ring for ever");
        }
    }

    const Assembly& assembly_;
    std::size_t number_ = 0;
    std::int64_t cells_ = 0;
    int contacts_ = 0;
};

}  // namespace

void validate(const Assembly& assembly)
{
    Faults faults;
    faults.requirePositive("length", assembly.length, "m");
    faults.requirePositive("wave speed", assembly.waveSpeed, "m/s");
    faults.requirePositive("axial stiffness", assembly.axialStiffness, "N");
    requireWeight(faults, assembly.gravity, assembly.length, assembly.waveSpeed);
    if (assembly.young) {
        faults.requirePositive("Young's modulus", *assembly.young, "Pa");
    }
    faults.throwIfAny();
    AssemblyCheck(assembly).run();
}

}  // namespace signorini
