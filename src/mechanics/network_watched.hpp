#pragma once
/// \file
/// Does a network repeat itself? The rule is that of a bar (settling.hpp), in the energy of the
/// network; where its bars drift their places count, too.

#include "network_simulation.hpp"
#include "signorini/settling.hpp"

namespace signorini {

/// A network; its energy in Z_1 delta^2/h.
class WatchedNetwork : public Watched {
public:
    /// Refers to the simulation, which `drive` moves.
    WatchedNetwork(NetworkSimulation& simulation, const NetworkDrive& drive)
        : simulation_(simulation), drive_(drive)
    {
    }

    void advance(double duration) override { simulation_.advance(duration); }
    [[nodiscard]] std::int64_t contacts() const override { return simulation_.contactCount(); }
    [[nodiscard]] double impulse() const override { return simulation_.impulse(); }
    [[nodiscard]] std::int64_t pieces() const override;
    [[nodiscard]] std::vector<Piece> state() const override;
    [[nodiscard]] std::vector<Piece> rest() const override;
    [[nodiscard]] std::vector<Piece> weights() const override;
    /// u^2 <= 2 E times the compliance at a contact.
    [[nodiscard]] double clearance(double duration) const override;

private:
    [[nodiscard]] std::vector<Piece> joined(const NetworkStart& state) const;

    NetworkSimulation& simulation_;
    const NetworkDrive& drive_;
};

}  // namespace signorini
