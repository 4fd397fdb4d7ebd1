#pragma once
/// \file
/// A network of bars: rows of cells that meet at nodes, and contacts between nodes and the ground
/// or between two nodes. Every scene is one. docs/theory.md, section 20.
///
/// A wave crosses every cell in one step. At a node the waves w_k arrive along its branches k (rows
/// of cells and stubs) with impedances Z_k; D is its dashpot to the ground, f the force on it:
///
///     v = (2 sum Z_k w_k + f)/(sum Z_k + D),   what leaves along branch k: v - w_k.            (N)
///
/// A clamp and a closed stop have v = 0, a shaken clamp a given v; the two nodes of a closed gap
/// move together, as one node with the branches, dashpots and forces of both. A stub is a line of
/// half a step with one wave: what enters it comes back one step later, negated (its far end is
/// clamped: a spring of stiffness 2 Z/h) or not (free: a mass Z h/2).
///
/// Nodes stand from left to right; a bar is a run of nodes joined by rows, and a gap parts node i
/// from node i + 1. So clusters of closed contacts are runs of nodes, too.
///
/// Units: time in steps h, displacement in delta, velocity in delta/h, impedance in Z_1 (that of
/// relative impedance 1), force in Z_1 delta/h, energy in Z_1 delta^2/h; energy is the sum of
/// Z_k w_k^2 over all waves. `NetworkScales` says what they are in SI. Numbers that were typed in
/// stand for the simplest fractions that round to them (`exactly`).

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <type_traits>
#include <vector>

#include "infinity.hpp"
#include "signorini/assembly.hpp"
#include "signorini/bar.hpp"
#include "signorini/schedule.hpp"
#include "signorini/simulation.hpp"

namespace signorini {

/// Equal cells in a row between two nodes.
struct CellRow {
    std::int64_t cells = 1;  ///< >= 1
    double impedance = 1.0;
    double speed = 1.0;     ///< relative; a cell is c speed h long
    std::size_t left = 0;   ///< node
    std::size_t right = 0;  ///< node, left + 1

    friend bool operator==(const CellRow&, const CellRow&) = default;
};

/// What stands at the end of half a step.
enum class StubKind { spring, mass };

/// A spring to the ground, or a mass, at a node.
struct Stub {
    StubKind kind = StubKind::spring;
    double impedance = 1.0;
    std::size_t node = 0;

    friend bool operator==(const Stub&, const Stub&) = default;
};

/// Where branches meet.
struct NetworkNode {
    bool isClamped = false;
    bool isShaken = false;  ///< a clamp that moves with the base
    bool isDriven = false;  ///< the harmonic force acts here
    double dashpot = 0.0;   ///< D
    double force = 0.0;     ///< constant f
    std::size_t bar = 0;    ///< to which it belongs
    /// Where weight puts it at rest; displacements are counted from there, gaps, too.
    double rest = 0.0;

    friend bool operator==(const NetworkNode&, const NetworkNode&) = default;
};

enum class ContactKind {
    stopRight,  ///< u <= gap, pushes to the left
    stopLeft,   ///< u >= -gap, pushes to the right
    gap,        ///< u of the node <= gap + u of the next one
};

/// A place that pushes and never pulls. Its distance: gap - u, gap + u, or gap + u_next - u.
struct NetworkContact {
    ContactKind kind = ContactKind::stopRight;
    std::size_t node = 0;
    double gap = 0.0;  ///< at rest, of any sign

    friend bool operator==(const NetworkContact&, const NetworkContact&) = default;
};

/// What the distance of a contact grows by while nodes move by way(node): -u, u, or u_next - u.
template <typename Way>
[[nodiscard]] auto openingOf(const NetworkContact& contact, const Way& way)
{
    const auto here = way(contact.node);
    return contact.kind == ContactKind::stopRight  ? -here
           : contact.kind == ContactKind::stopLeft ? here
                                                   : way(contact.node + 1) - here;
}

/// Visits the node of a stop, or both of a gap: visit(node, sign), sign times its displacement
/// being what the distance grows by.
void forEachSide(const NetworkContact& contact, const auto& visit)
{
    visit(contact.node, contact.kind == ContactKind::stopLeft ? 1 : -1);
    if (contact.kind == ContactKind::gap) {
        visit(contact.node + 1, 1);
    }
}

/// Nodes that are connected while all contacts are open.
struct NetworkBar {
    std::size_t firstNode = 0;
    std::size_t lastNode = 0;
    int clamps = 0;
    int springs = 0;
    int masses = 0;

    /// Without clamp and spring: its displacement is an unknown of its own.
    [[nodiscard]] bool drifts() const { return clamps + springs == 0; }

    friend bool operator==(const NetworkBar&, const NetworkBar&) = default;
};

/// What the units of a network are in SI.
struct NetworkScales {
    double time = 1.0;          ///< [s], h
    double displacement = 1.0;  ///< [m], delta
    double impedance = 1.0;     ///< [N s/m], Z_1

    [[nodiscard]] double velocity() const { return displacement / time; }
    [[nodiscard]] double force() const { return impedance * velocity(); }
    [[nodiscard]] double energy() const { return force() * displacement; }

    friend bool operator==(const NetworkScales&, const NetworkScales&) = default;
};

/// Bit j: contact j is closed.
using ContactSet = std::uint64_t;

[[nodiscard]] constexpr bool contains(ContactSet set, std::size_t contact)
{
    return (set >> contact & 1U) != 0;
}

inline constexpr std::size_t maxContacts = 64;
/// Widest gap [delta]: in a step a wave of size 1 moves a node by about one.
inline constexpr double mostGap = 1e15;

/// All of it, from left to right; contacts in the order in which they are numbered.
struct Network {
    std::vector<CellRow> rows;
    std::vector<Stub> stubs;
    std::vector<NetworkNode> nodes;
    std::vector<NetworkContact> contacts;
    std::vector<NetworkBar> bars;
    NetworkScales scales = {};
    double gravity = 0.0;  ///< by which `rest` was found [delta/h^2]
    /// S > 0: only motions with (l - r)/speed >= -S everywhere are asked for, the shape under
    /// weight included. Nothing that moves knows of it.
    double strainLimit = infinity;

    /// M, of all rows.
    [[nodiscard]] std::int64_t cells() const;
    /// Waves in a state: 2 M + stubs. Row by row, the right-going ones from left to right, then the
    /// left-going ones from left to right; stubs last.
    [[nodiscard]] std::size_t waves() const;
    /// First right-going wave of a row; the left-going ones follow after as many as it has cells.
    [[nodiscard]] std::size_t firstWave(std::size_t row) const;
    /// By how much cell k of a row, from the left, is stretched at rest [delta]: more above the
    /// middle of the row, which carries what hangs below, and less beneath it.
    [[nodiscard]] double stretchAtRest(const CellRow& row, std::int64_t k) const;

    /// Places where a wave arrives in a step: 2 row + 0 the right-going waves of a row (at its
    /// right end), 2 row + 1 the left-going ones (at its left end), then the stubs.
    [[nodiscard]] std::size_t channels() const { return 2 * rows.size() + stubs.size(); }
    [[nodiscard]] std::size_t nodeOf(std::size_t channel) const;
    [[nodiscard]] double impedanceOf(std::size_t channel) const;
    /// The channel that what leaves along this branch enters: the other one of the row, or itself.
    [[nodiscard]] std::size_t entered(std::size_t channel) const;
    /// -1 for a spring, which negates what enters it, else 1.
    [[nodiscard]] int sign(std::size_t channel) const;

    friend bool operator==(const Network&, const Network&) = default;
};

/// \throws std::invalid_argument with what is wrong: nodes or bars out of order, numbers that are
/// not finite or not positive, a contact at a clamp, too many contacts, no waves at a node.
void validate(const Network& network);

/// The number that was meant: 0, or +- the simplest fraction that rounds to it. \pre isSimple.
[[nodiscard]] Fraction exactly(double value);

/// Do `exactly` and 64 bits hold it?
[[nodiscard]] bool isSimple(double value);

/// That number: as it is in double, exactly in Rational, enclosed in Interval. One that is not
/// simple stands for itself.
template <typename Number>
[[nodiscard]] Number asNumber(double value)
{
    if constexpr (std::is_same_v<Number, double>) {
        return value;
    } else {
        if (!isSimple(value)) {
            return Number(value);
        }
        const Fraction fraction = exactly(value);
        return Number(static_cast<double>(fraction.numerator)) /
               Number(static_cast<double>(fraction.denominator));
    }
}

/// A velocity or a push: sum of coefficient times arriving wave, and what does not depend on waves.
template <typename Number>
struct LinearForm {
    struct Term {
        std::size_t channel;
        Number coefficient;
    };
    std::vector<Term> terms = {};
    Number constant = Number(0);  ///< by constant forces
    Number perForce = Number(0);  ///< times the harmonic force in this step
    Number perBase = Number(0);   ///< times the velocity of the base in this step

    void add(const LinearForm& other, const Number& factor)
    {
        for (const Term& term : other.terms) {
            terms.push_back({term.channel, factor * term.coefficient});
        }
        constant = constant + factor * other.constant;
        perForce = perForce + factor * other.perForce;
        perBase = perBase + factor * other.perBase;
    }
    [[nodiscard]] Number at(std::span<const Number> arriving, const Number& force,
                            const Number& base) const
    {
        Number sum = constant + perForce * force + perBase * base;
        for (const Term& term : terms) {
            sum = sum + term.coefficient * arriving[term.channel];
        }
        return sum;
    }
};

/// Nodes that move as one while certain contacts are closed.
struct Cluster {
    std::size_t firstNode = 0;
    std::size_t lastNode = 0;
    std::optional<std::size_t> held = {};  ///< the node that is clamped or at a closed stop
};

/// The runs of nodes that a set of closed contacts joins.
/// \throws std::invalid_argument if one of them is held at two nodes: the pushes between these do
/// not follow from the waves. \pre a valid network.
[[nodiscard]] std::vector<Cluster> clustersOf(const Network& network, ContactSet closed);

/// Of a sum, by what drives the network in one step.
template <typename Number>
struct DrivenDerivatives {
    Number force = Number(0);
    Number base = Number(0);      ///< its velocity
    Number constant = Number(0);  ///< what constant forces add
};

/// (N), while certain contacts are closed. `Number`: double, Rational, Interval.
template <typename Number>
class NetworkLaw {
public:
    /// O(channels). \throws std::invalid_argument as clustersOf does. \pre a valid network.
    NetworkLaw(const Network& network, ContactSet closed);

    [[nodiscard]] ContactSet closed() const { return closed_; }
    /// v of a node.
    [[nodiscard]] const LinearForm<Number>& velocity(std::size_t node) const
    {
        return clusters_[clusterOf_[node]].velocity;
    }
    /// q of a closed contact.
    [[nodiscard]] const LinearForm<Number>& push(std::size_t contact) const
    {
        return pushes_[contact];
    }
    /// What comes in and goes out along one branch of a cluster.
    struct Branch {
        std::size_t channel;
        std::size_t entered;
        Number sign;
        Number weight;  ///< of its wave in v; 0 where held
        Number own;     ///< weight - 1, rounded once: what comes back along this branch
    };
    /// Nodes that move as one. What enters a channel: own * its wave + weight * the other one +
    /// pulled where there are two branches, else v - its wave; times the sign.
    struct Scatterer {
        Cluster nodes;
        std::vector<Branch> branches;
        LinearForm<Number> velocity;
    };
    [[nodiscard]] const std::vector<Scatterer>& scatterers() const { return clusters_; }
    /// The one to which a node belongs.
    [[nodiscard]] std::size_t scattererOf(std::size_t node) const { return clusterOf_[node]; }

    /// What enters each channel, signs of springs included, when that arrives. O(channels).
    void scatter(std::span<const Number> arriving, std::span<Number> entering,
                 const Number& force = Number(0), const Number& base = Number(0)) const;
    /// The transpose: from the derivatives by what enters each channel those by what arrived in it,
    /// and, returned, by the harmonic force and the velocity of the base in the step. O(channels).
    [[nodiscard]] DrivenDerivatives<Number> scatterBack(std::span<const Number> byEntering,
                                                        std::span<Number> byArriving) const;

private:
    [[nodiscard]] Scatterer scattererFor(const Network& network, const Cluster& cluster) const;
    [[nodiscard]] LinearForm<Number> forceOn(const Network& network, std::size_t node) const;
    void findPushes(const Network& network, const Cluster& cluster);

    ContactSet closed_;
    std::vector<std::size_t> clusterOf_;
    std::vector<Scatterer> clusters_;
    std::vector<LinearForm<Number>> pushes_;  ///< by contact; empty where open
};

/// The laws of a network, each made once. \pre the network outlives them.
template <typename Number>
class NetworkLaws {
public:
    explicit NetworkLaws(const Network& network) : network_(network) {}

    const NetworkLaw<Number>& of(ContactSet closed)
    {
        return laws_.try_emplace(closed, network_, closed).first->second;
    }

private:
    const Network& network_;
    std::map<ContactSet, NetworkLaw<Number>> laws_;
};

/// A state of a network that goes on step by step: two rings for each row. \pre the laws that it is
/// given are those of its network.
template <typename Number>
class NetworkWaves {
public:
    /// Waves in the order of `Network::waves`. O(M). \throws std::invalid_argument if they are not
    /// as many.
    NetworkWaves(const Network& network, std::vector<Number> waves);

    /// What arrives in the next step, by channel. O(channels).
    [[nodiscard]] std::span<const Number> arriving() const { return now_; }
    /// One step. O(channels).
    void step(const NetworkLaw<Number>& law, const Number& force = Number(0),
              const Number& base = Number(0));
    /// One step back of the transposed operator, lambda <- S^T lambda, for derivatives in place of
    /// waves; the rows of that step are added after it. Returns S's own. O(channels).
    DrivenDerivatives<Number> stepBack(const NetworkLaw<Number>& law);
    /// Adds to what arrives next in a channel.
    void add(std::size_t channel, const Number& value);
    /// All waves, in the order of `Network::waves`. O(M).
    [[nodiscard]] std::vector<Number> waves() const;

private:
    /// Right-going and left-going waves of a row. Both arrive from place `head`, and what enters
    /// takes their place there.
    struct Ring {
        std::size_t first;  ///< of the right-going ones in values_
        std::size_t size;   ///< cells; the left-going ones follow
        std::size_t head;
    };

    std::vector<Ring> rings_;      ///< by row
    std::vector<Number> values_;   ///< of the rows
    std::vector<Number> now_;      ///< by channel: what arrives next
    std::vector<Number> scratch_;  ///< by channel
};

/// How the displacement of a node follows from the waves: reference + signed sums of l - r over
/// whole rows.
struct DisplacementForm {
    /// Unknown displacement of the bar's first node where the bar drifts; else the reference is a
    /// clamp (displacement of the base where shaken, else 0) or the wave of a spring.
    bool hasDrift = false;
    std::optional<std::size_t> spring = {};  ///< stub whose node is the reference, u = -w
    std::optional<std::size_t> clamp = {};   ///< node
    struct Stretch {
        std::size_t row;
        int sign;  ///< of the sum of l - r
    };
    std::vector<Stretch> rows = {};
};

/// Counted from the first clamp of the bar, else from its first spring, else its first node.
[[nodiscard]] DisplacementForm displacementOf(const Network& network, std::size_t node);

/// The network of an assembly. delta = |G|/M, G the first gap that is not 0 (the length of all bars
/// if there is none), M all cells; h = length/(c sum of cells times speed). A bar that is clamped
/// nowhere carries its weight as a force at the contact that it stands on.
/// \throws std::invalid_argument on an assembly that is no scene.
[[nodiscard]] Network networkOf(const Assembly& assembly);

/// What a scene is measured with: its own first linear mode, contacts open, and the least energy
/// with which contact 1 is reached.
struct SceneReference {
    double frequency = 0.0;            ///< [rad/s], omega_1 of the bars without dashpots
    std::optional<double> damping;     ///< [-], zeta; none where the mode does not vibrate
    std::optional<double> compliance;  ///< [m/N], of contact 1; none where a bar drifts
    std::optional<double> energy;      ///< [J], E_1 = g^2/(2 compliance)
};

/// O(nodes) for each digit. \pre a valid network.
[[nodiscard]] SceneReference referenceOf(const Network& network);

/// Today's scenes. One node at the clamp, one at each joint, one at the tip; contact 1 the wall,
/// contact 2 the second stop. delta = |gap|/N (L/N where the gap is 0), so that a gap is +-N; h the
/// time of a cell. Damping as a dashpot at the tip; the tip driven, the clamp shaken.
/// \throws std::invalid_argument on an invalid scene, or cells that are not those of the segments.
[[nodiscard]] Network networkOf(const Scene& scene, std::int64_t cells,
                                const Damping& damping = {});
/// The same of a bar whose stops are all that is known of them: |g| = 1, or L = 1 without a gap.
[[nodiscard]] Network networkOf(const Stops& stops, const std::vector<Segment>& segments,
                                std::int64_t cells, const Damping& damping = {});

}  // namespace signorini

#include "network_law.hpp"
