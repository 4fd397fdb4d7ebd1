#pragma once
/// \file
/// What a network does from any state, event by event: the arrival of a front at a node, a contact
/// that closes, a step of the excitation. Nothing is on a grid but what starts there.
///
/// Every channel (network.hpp) keeps the fronts under way in it, by the time at which they arrive;
/// a front that arrives changes one node, or the nodes that closed contacts join with it, and sends
/// one front along each branch. Between fronts nothing is computed, so a long row costs no more
/// than its fronts. An event costs O(branches of the nodes that change + channels).
///
/// Contacts: closed ones that would have to pull open, open ones without distance that would
/// overlap close, until neither is left. Units as in network.hpp.

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "compensated_sum.hpp"
#include "infinity.hpp"
#include "network.hpp"

namespace signorini {

/// What a network starts from.
struct NetworkStart {
    std::vector<double> waves;          ///< in the order of Network::waves
    std::vector<double> displacements;  ///< of the nodes
    /// Off the grid, in place of `waves`: of each channel, in the order of arrival.
    std::vector<std::vector<Piece>> pieces = {};
};

/// The waves of a start, piece by piece.
[[nodiscard]] std::vector<std::vector<Piece>> piecesOf(const Network& network,
                                                       const NetworkStart& start);

/// Means of a start over the cells, as waves: what is nearest to them on the grid is nearest to it.
/// \throws std::invalid_argument on pieces that do not fill their channels.
[[nodiscard]] std::vector<double> meansOf(const Network& network, const NetworkStart& start);

/// At rest under its constant forces, its shaken clamps standing at `base` [delta]. \throws as
/// restOf.
[[nodiscard]] NetworkStart startAtRest(const Network& network, double base = 0.0);

/// Not strained, every bar with its own speed. Under weight that is not the shape at rest.
/// \throws std::invalid_argument unless there is one speed for each bar, finite.
[[nodiscard]] NetworkStart startWithSpeeds(const Network& network, std::span<const double> speeds);

/// Displacements of the nodes that go with waves; bars that drift have those given for their first
/// node, from the left.
[[nodiscard]] std::vector<double> displacementsOf(const Network& network,
                                                  std::span<const double> waves,
                                                  std::span<const double> drifts);

/// What moves it: values of one period, constant in each step of excitation.
struct NetworkDrive {
    std::vector<double> forces = {};      ///< on the driven nodes
    std::vector<double> velocities = {};  ///< of the shaken clamps
    double step = 1.0;                    ///< its length [h]
    double past = 0.0;                    ///< of the first one, over at the start [h], < step
    /// [delta], by which the shaken clamps are led to their motion, evenly in its first period.
    double lead = 0.0;
};

struct NetworkContactEvent {
    std::size_t contact = 0;
    double start = 0.0;
    double end = 0.0;      ///< when it last pressed
    double impulse = 0.0;  ///< [Z_1 delta]
    double peakForce = 0.0;
    double speed = 0.0;  ///< with which it closed

    friend bool operator==(const NetworkContactEvent&, const NetworkContactEvent&) = default;
};

/// A node at one instant; straight between neighbours.
struct NodePoint {
    double time = 0.0;
    double displacement = 0.0;
};

struct NetworkOptions {
    /// [velocity], neighbours that differ by no more become one piece with their mean.
    double mergeBelow = 0.0;
    bool recordsPaths = false;  ///< keep the paths of all nodes at contacts
};

/// What came and went since the start.
struct NetworkBalance {
    double work = 0.0;        ///< by constant forces, harmonic force and base
    double dissipated = 0.0;  ///< in dashpots
    double error = 0.0;       ///< energy now - at the start - work + dissipated
    double size = 0.0;        ///< what the error is to be compared with
};

/// Momentum of all bars and masses: now - at the start - what forces, dashpots, springs, clamps and
/// stops gave it.
struct MomentumBalance {
    double given = 0.0;
    double error = 0.0;
    double size = 0.0;  ///< what the error is to be compared with
};

class NetworkSimulation {
public:
    /// \throws std::invalid_argument on an invalid network, or values that are not finite, or not
    /// as many as there should be.
    NetworkSimulation(const Network& network, const NetworkStart& start,
                      const NetworkDrive& drive = {}, const NetworkOptions& options = {});

    /// Goes on for so many h.
    void advance(double duration);

    [[nodiscard]] const Network& network() const { return network_; }
    [[nodiscard]] double time() const { return base_ + now_; }
    [[nodiscard]] std::int64_t events() const { return events_; }
    [[nodiscard]] double displacement(std::size_t node) const
    {
        const Node& at = nodes_[node];
        return at.displacement + at.velocity * (now_ - at.since);
    }
    [[nodiscard]] double velocity(std::size_t node) const { return nodes_[node].velocity; }
    [[nodiscard]] ContactSet closed() const { return closed_; }
    /// The force of a contact just now, 0 while it is open [Z_1 delta/h].
    [[nodiscard]] double push(std::size_t contact) const { return touches_[contact].push; }
    /// Those that have ended, and then those that last.
    [[nodiscard]] std::vector<NetworkContactEvent> contacts() const;
    /// How many have begun to press.
    [[nodiscard]] std::int64_t contactCount() const { return pressed_; }
    /// Of all contacts so far, those that last included.
    [[nodiscard]] double impulse() const;
    [[nodiscard]] const std::vector<std::vector<NodePoint>>& paths() const { return paths_; }
    /// Whole; `waves` are averages over the cells, exact on a grid. O(fronts + M).
    [[nodiscard]] NetworkStart state() const;
    /// What one contact has pushed until now [Z_1 delta].
    [[nodiscard]] double impulseAt(std::size_t contact) const
    {
        const Touch& touch = touches_[contact];
        return touch.pushed + touch.push * (now_ - touch.since);
    }
    /// Least distance of a contact at all events at which it was open.
    [[nodiscard]] double nearest(std::size_t contact) const { return touches_[contact].nearest; }
    /// Sum of Z w^2. O(fronts).
    [[nodiscard]] double energy() const;
    [[nodiscard]] NetworkBalance balance() const;
    [[nodiscard]] MomentumBalance momentumBalance() const;
    [[nodiscard]] std::size_t fronts() const;
    /// Sum of |jump| times duration of all that became one: most that anything can have moved.
    [[nodiscard]] double merged() const { return merged_; }

private:
    /// A wave changes its value.
    struct Front {
        double time;
        double value;
    };
    /// Fronts under way, in the order of arrival, in a ring. Places count on for ever.
    struct Channel {
        std::vector<Front> ring = std::vector<Front>(16);  ///< a power of two
        std::size_t mask = 15;                             ///< one less
        std::size_t begin = 0;
        std::size_t end = 0;
        double now = 0.0;  ///< what arrives
        double delay = 1.0;
        double impedance = 1.0;
        std::size_t node = 0;
        double sign = 1.0;

        [[nodiscard]] std::size_t count() const { return end - begin; }
        /// The k-th last one, from 1.
        [[nodiscard]] Front& last(std::size_t k) { return ring[(end - k) & mask]; }
        /// What comes after all of them.
        [[nodiscard]] double value() const
        {
            return end != begin ? ring[(end - 1) & mask].value : now;
        }
        /// When its first front arrives; infinite where none is on its way.
        [[nodiscard]] double due() const
        {
            if (begin == end) {
                return infinity;
            }
            return ring[begin & mask].time;
        }
        void push(const Front& front)
        {
            if (count() > mask) {
                widen();
            }
            ring[end++ & mask] = front;
        }
        void pop() { now = ring[begin++ & mask].value; }
        void widen();
        /// visit(duration, value), in the order of arrival.
        void forEachPiece(double time, auto visit) const
        {
            double since = time;
            double value = now;
            for (std::size_t k = begin; k != end; ++k) {
                const Front& front = ring[k & mask];
                visit(front.time - since, value);
                since = front.time;
                value = front.value;
            }
            visit(time + delay - since, value);
        }
    };
    struct Node {
        double velocity = 0.0;
        double displacement = 0.0;  ///< when last changed
        double since = 0.0;
        double power = 0.0;     ///< of forces and base
        double loss = 0.0;      ///< D v^2
        double external = 0.0;  ///< force from outside but stops
        bool isActed = false;   ///< are these three ever other than 0?
        std::vector<std::size_t> channels;
        std::vector<std::size_t> contacts;  ///< with its neighbours, too
        ContactSet touching = 0;            ///< the same
        bool hasPath = false;               ///< is kept
    };
    struct Touch {
        double push = 0.0;
        double since = 0.0;
        bool lasts = false;   ///< an event is under way
        bool isNear = false;  ///< open, without distance
        double nearest = infinity;
        double pushed = 0.0;
        NetworkContactEvent event = {};
    };
    using Law = NetworkLaw<double>;
    /// First and last node that change at an instant.
    struct Range {
        std::size_t first;
        std::size_t last;
    };

    void place(const std::vector<std::vector<Piece>>& pieces,
               const std::vector<double>& displacements);
    void setScale(const std::vector<std::vector<Piece>>& pieces);
    void advanceTo(double end);
    inline void takeEvent(std::size_t which);
    [[nodiscard]] double& clock() { return due_[channels_.size() + touches_.size()]; }
    void takeClock();
    void settle(Range range);
    void include(std::size_t node, Range& range);
    inline void touchNode(std::size_t number);
    [[nodiscard]] inline bool isUntouched(std::size_t number) const;
    inline void commit(const Range& range);
    inline void sendFrom(const Law::Scatterer& cluster);
    inline void setPowers(std::size_t number);
    bool opensOne(const Range& range);
    bool closesOne(Range& range);
    void open(std::size_t contact);
    void close(std::size_t contact, double speed);
    void setPush(std::size_t contact, double push);
    inline void predict(std::size_t contact);
    inline void send(std::size_t number, double value);
    bool joins(Channel& channel, const Front& next);
    void rebase();
    void recordPath(std::size_t node);
    [[nodiscard]] const Law& lawOf(ContactSet closed);
    [[nodiscard]] double freshVelocity(std::size_t node) const;
    [[nodiscard]] double closingSpeed(std::size_t contact) const;
    [[nodiscard]] double distance(std::size_t contact) const;
    [[nodiscard]] double momentum() const;
    [[nodiscard]] inline std::size_t earliest() const;

    Network network_;
    NetworkDrive drive_;
    NetworkOptions options_;
    std::vector<Channel> channels_;
    std::vector<Node> nodes_;
    std::vector<Touch> touches_;
    std::vector<double> arriving_;  ///< by channel
    /// By channel, then by contact, then the clock of the drive, then never.
    std::vector<double> due_;
    std::vector<std::unique_ptr<Law>> laws_;
    const Law* law_ = nullptr;
    ContactSet closed_ = 0;
    double force_ = 0.0;
    double baseVelocity_ = 0.0;
    std::int64_t driveStep_ = 0;
    double now_ = 0.0;
    double base_ = 0.0;                           ///< whole; times are counted from it
    static constexpr double longestBase = 256.0;  ///< [h, for each cell], then times count anew
    static constexpr std::size_t none = ~std::size_t{0};
    static constexpr std::size_t lanes = 4;  ///< of times that are compared side by side
    std::size_t meeting_ = none;  ///< the contact whose distance has come to its end just now
    std::vector<double> close_;   ///< by contact: distances below it are rounding
    double same_;                 ///< instants that differ by less are one
    double together_;             ///< fronts that follow each other closer become one
    double slow_ = 0.0;           ///< velocities below it are rounding
    double small_ = 0.0;          ///< pushes below it are rounding
    std::int64_t events_ = 0;
    double startEnergy_ = 0.0;
    double startMomentum_ = 0.0;
    CompensatedSum work_;
    CompensatedSum dissipated_;
    CompensatedSum given_;
    CompensatedSum impulse_;
    std::int64_t pressed_ = 0;
    double merged_ = 0.0;
    std::vector<NetworkContactEvent> done_;
    std::vector<std::vector<NodePoint>> paths_;  ///< by node; empty where no contact is
};

}  // namespace signorini
