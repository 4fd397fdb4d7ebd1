#pragma once
/// \file
/// The points of a simplex at one distance from the origin: pure geometry, O(d) per point.
///
///     M = { z >= 0,  z_1 + ... + z_d = 1,  sum z^2 = rho },   1/d <= rho <= 1
///
/// Since sum z^2 <= max z, every point lies in one of the d *caps* U_j = { z in M : z_j >= rho }.
/// Seen from the vertex e_j, z = (1 - t) e_j + t y with y in the opposite face, a cap is a graph
/// over a convex set: y with |y|^2 <= rho/(1 - rho), and
///
///     t(y) = (1 - rho)/(1 + sqrt(rho - |y|^2 (1 - rho))).
///
/// So a cap is connected, straight lines in y stay inside it, and amplitudes that are zero at both
/// ends stay zero: the path slides along the faces of the simplex. Two caps meet exactly when
/// rho <= 1/2. Hence M is connected for rho <= 1/2, and for rho > 1/2 it has d components, told
/// apart by the one amplitude above 1/2. docs/theory.md, section 11, has the proof.

#include <cstddef>
#include <cstdint>
#include <random>
#include <span>
#include <vector>

#include "signorini/amplitude_set.hpp"

namespace signorini {

/// d and rho. The functions below take rho < 1/d as 1/d and rho > 1 as 1.
struct SphereSection {
    std::int64_t count = 1;  ///< [-], d
    double ratio = 1.0;      ///< [-], rho = sum z^2/(sum z)^2
};

/// The index 0..d-1 of the largest amplitude: for rho > 1/2, the name of the component.
[[nodiscard]] std::size_t dominant(std::span<const double> z);

/// A path in M from one point to another: at most two straight lines, each in the chart y of a cap.
class SectionPath {
public:
    /// The ends are moved onto M by rounding at most. If rho > 1/2 they must have the same dominant
    /// amplitude. \throws std::invalid_argument if they do not, or on wrong lengths.
    SectionPath(const SphereSection& section, std::span<const double> from,
                std::span<const double> to);

    /// The point at 0 <= s <= 1, from one end to the other. O(d).
    [[nodiscard]] std::vector<double> at(double s) const;

private:
    struct Leg {
        std::size_t apex;           ///< j of the cap U_j
        std::vector<double> start;  ///< y at its start, 0 at the apex
        std::vector<double> end;    ///< y at its end
        double startRoot;           ///< rho - |y|^2 (1 - rho) at its start
        double endRoot;             ///< the same at its end
        double rise;                ///< what it gains in the middle: (1 - rho) |end - start|^2
    };
    void addLeg(std::size_t apex, std::span<const double> from, std::span<const double> to);

    SphereSection section_;
    std::vector<Leg> legs_;
};

/// Walks through M from a point in a direction: along great circles of the sphere. Where an
/// amplitude reaches zero it becomes active, stays zero, and the walk slides on along that face, on
/// the smaller sphere of the others: what is left of the direction lies in the face, so nothing
/// frees it again. From equal amplitudes on a face, whose sphere is that point alone, it starts on
/// the whole sphere. The way does not depend on the lengths it is walked in. O(d) per great circle,
/// no matrix.
class SlidingWalk {
public:
    /// `direction` needs d values; only its part along the sphere and into the set counts.
    /// \throws std::invalid_argument on wrong lengths.
    SlidingWalk(const SphereSection& section, std::span<const double> from,
                std::span<const double> direction);

    /// Moves on by an arc length [sum z] and returns the point reached. False in `canMove` means
    /// that it stands where the direction leads nowhere.
    [[nodiscard]] const std::vector<double>& advance(double length);
    [[nodiscard]] bool canMove() const { return canMove_; }

private:
    void settle();
    [[nodiscard]] bool leaveEqualAmplitudes();
    void findTangent();
    [[nodiscard]] double angleToFace(std::size_t& meets) const;

    SphereSection section_;
    std::vector<double> z_;
    std::vector<double> wish_;     ///< the direction asked for, carried along
    std::vector<bool> active_;     ///< zero for the rest of the walk
    std::vector<double> tangent_;  ///< of length 1, or zero
    double centre_ = 0.0;          ///< 1/f on the f amplitudes that are not active
    double radius_ = 0.0;          ///< sqrt(rho - 1/f)
    bool canMove_ = true;
};

/// n >= 1 parameters s of a path at equal distances along it, and its length up to each. Found on
/// grids of min(4 n, 4000) points, so equal within a few percent. O(min(n, 1000) d).
struct Spacing {
    std::vector<double> parameters;
    std::vector<double> lengths;  ///< [sum z]
};
[[nodiscard]] Spacing equalSpacing(const SectionPath& path, std::int64_t n);

/// A natural curve in M with a pause as its parameter [cells]: two pulses, the first at the front,
/// the second later and later. z_1 > 0 on all of it.
///
/// For rho <= 1/2 two rectangles of equal height and width, together 1/rho cells: from one block
/// with no pause to a pulse at either end. z is the part c_j of each cell that they cover, to the
/// power that makes sum z^2 = rho exactly (it takes 1 for whole cells), scaled to sum 1. For
/// rho > 1/2 less than two cells cannot be cut: z_1 dominates, and the rest of the sum is a pulse
/// one cell wide.
class PulsePair {
public:
    explicit PulsePair(const SphereSection& section);

    /// Of the pulses at either end. The shortest pause is 0.
    [[nodiscard]] double longestPause() const { return longest_; }
    /// The point with this pause, or with the nearest one that there is. O(d).
    [[nodiscard]] std::vector<double> at(double pause) const;

private:
    SphereSection section_;
    double width_;  ///< of each pulse
    double longest_;
};

/// Walks at random over the members of a simplex or a box with a given sum z^2: hit-and-run. Each
/// move draws a great circle through the point, of the sphere about equal amplitudes, and a point
/// evenly from the arcs of it that lie in the set; on a simplex the amplitudes are also shuffled,
/// on a box their order may be reversed, which maps the set to itself and visits every component of
/// a simplex, and both members where only two are left. Even in the long run.
class SectionSampler {
public:
    /// `squares` in [least, most] of the set (amplitude_set.hpp). \throws std::invalid_argument if
    /// it is not.
    SectionSampler(const AmplitudeSet& set, double squares, std::uint64_t seed);

    /// The member reached after `moves` more moves. O(moves d log d).
    [[nodiscard]] const std::vector<double>& next(int moves = 50);

private:
    [[nodiscard]] bool isSymmetric() const;
    void move();
    void findArcs(const std::vector<double>& direction);
    [[nodiscard]] double drawAngle();

    AmplitudeSet set_;
    double radius_;  ///< distance from equal amplitudes
    std::mt19937_64 generator_;
    std::vector<double> z_;
    struct Arc {
        double start;
        double end;
    };
    std::vector<Arc> outside_;  ///< angles at which a bound is violated
};

}  // namespace signorini
