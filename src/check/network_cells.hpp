#pragma once
/// \file
/// The cells of a network, as a check moves them: the law of network.hpp written down once more.

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "infinity.hpp"
#include "network_walk.hpp"

namespace signorini {

/// The largest and least of the last values of a row of them. O(1) each, on average.
class SlidingRange {
public:
    explicit SlidingRange(std::size_t window) : window_(window) {}

    void add(double value);
    [[nodiscard]] double most() const { return most_.first(); }
    [[nodiscard]] double least() const { return least_.first(); }

private:
    struct Entry {
        std::size_t number;
        double value;
    };

    /// Those that no later one beats.
    struct Ends {
        std::vector<Entry> entries;
        std::size_t gone = 0;  ///< so many at the front

        [[nodiscard]] double first() const { return entries[gone].value; }
    };

    std::size_t window_;
    std::size_t count_ = 0;
    Ends most_;  ///< falling
    Ends least_;
};

/// Waves, displacements, and what was seen of them. In each step `look`, `find` or `decide`,
/// `take`.
class NetworkCells {
public:
    /// O(M). \pre the claim's waves and displacements are those of the network.
    NetworkCells(const Network& network, const NetworkClaim& claim, double tolerance);

    /// What pulls at the nodes in a step.
    void look(std::size_t step);
    /// The velocities of all nodes: runs that closed gaps join have one.
    void find(ContactSet closed);
    /// The same, with the contacts that close by Signorini's rule, from all open.
    [[nodiscard]] ContactSet decide();
    /// The deepest after the step.
    [[nodiscard]] double overlap(ContactSet closed) const;
    /// Moves on. Returns the contacts that press.
    ContactSet take(ContactSet closed);

    [[nodiscard]] double distance(std::size_t number) const;
    /// Change of the waves since the start, relative to the largest; once it is more than enough,
    /// not all of them are looked at. O(M).
    [[nodiscard]] double change(double enough = infinity) const;
    /// That of the displacements of bars that drift, relative to the length.
    [[nodiscard]] double moved() const;
    /// Displacements against elongations and springs. O(M).
    [[nodiscard]] double untied() const;
    /// Work done by forces and shaken clamps - dissipation, relative to the work of all steps, or,
    /// if they are more, to what is dissipated or waves of the largest size would hold.
    [[nodiscard]] double unbalanced() const;

    /// What lengths are compared with.
    [[nodiscard]] double length() const { return length_; }
    [[nodiscard]] const NetworkExtremes& extremes() const { return extremes_; }
    [[nodiscard]] double deepestPull() const { return pull_; }            ///< relative
    [[nodiscard]] double deepestOverlap() const { return penetration_; }  ///< relative

private:
    /// Two rings; what arrives next is at the head of both.
    struct Row {
        std::vector<double> right;
        std::vector<double> left;
        SlidingRange rights;  ///< those of which some still meet what enters now
        SlidingRange lefts;
        double rest;  ///< stretch of a cell in the middle of the row at rest
        std::size_t head = 0;
        std::int64_t met = 0;  ///< so many of either side
    };
    /// 2 sum Z w + f and sum Z + D of a node.
    struct Pull {
        double force;
        double impedance;
    };

    void compareWith();
    void meet(Row& row, double speed, double right, double left,
              std::optional<std::pair<double, double>> arriving);
    void work();
    void send();
    [[nodiscard]] double approach(std::size_t number) const;
    [[nodiscard]] double pushOf(ContactSet closed, std::size_t number) const;
    [[nodiscard]] double balance(std::size_t node) const;
    [[nodiscard]] std::optional<std::size_t> closedGap(ContactSet closed, std::size_t node,
                                                       int side) const;
    [[nodiscard]] std::pair<bool, double> borne(ContactSet closed, std::size_t node,
                                                int side) const;

    const Network& network_;
    const NetworkClaim& claim_;
    double tolerance_;
    std::vector<Row> rows_;
    std::vector<double> stubs_;
    std::vector<double> displacements_;
    std::vector<double> velocities_;
    std::vector<Pull> pulls_;
    std::vector<bool> isHeld_;
    std::vector<bool> isJoined_;  ///< to the node before
    double driven_ = 0.0;
    double base_ = 0.0;
    double shaken_ = 0.0;     ///< work of the clamps in this step
    double gained_ = 0.0;     ///< work
    double exchanged_ = 0.0;  ///< sum of its sizes
    double spent_ = 0.0;      ///< in dashpots
    NetworkExtremes extremes_;
    double pull_ = 0.0;
    double penetration_ = 0.0;
    double size_ = 0.0;  ///< largest wave
    double length_ = 0.0;
    std::vector<double> forces_;  ///< what pushes are compared with
};

}  // namespace signorini
