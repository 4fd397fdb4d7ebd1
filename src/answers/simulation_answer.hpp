#pragma once
/// \file
/// What a simulation came to.

#include "parts.hpp"
#include "signorini/settling.hpp"
#include "watch.hpp"

namespace signorini::answers {

/// What moves the bar.
struct Drive {
    Excited place = Excited::tip;
    double amplitude = 0.0;       ///< [N] or [m]
    double frequencyRatio = 0.0;  ///< omega/omega_1
    double phase = 0.0;           ///< [rad], at the start
    std::int64_t steps = 0;       ///< of a period
    double period = 0.0;          ///< [s]

    /// In so many steps in L/c, nearly, which it follows. \throws as excitationAt naming `field`.
    [[nodiscard]] Excitation excitation(const Bar& bar, double cells,
                                        std::string_view field = "frequency");
    /// Takes steps and period of an excitation.
    void follow(const Excitation& excitation, const Bar& bar);
};

/// One start, what moves, and for how long; what moves several bars need not be said where there is
/// one. \throws std::invalid_argument on options that do not go together.
void requireWhole(const Call& call, bool isOfBars);

/// Of --amplitude or its derivatives, --frequency and --phase, ω₁ being so many Hz. \pre The first
/// two are given. \throws std::invalid_argument naming a wrong one.
[[nodiscard]] Drive driveAsked(const Call& call, double firstHertz, Excited place);

/// Did it reach its end?
enum class Ending { done, interrupted };
[[nodiscard]] std::string_view name(Ending ending);

/// How a simulation repeats itself, and the unit of its impulse [N s].
struct SettledOn {
    Settled value;
    double impulseUnit = 1.0;
};

/// Energy that came and went, in SI units.
struct Balance {
    double work = 0.0;
    double dissipated = 0.0;
    double error = 0.0;
    double size = 0.0;  ///< what the error is to be compared with
};

/// The outcome of one call.
struct SimulationAnswer {
    Scene scene;
    Damping damping = {};
    std::optional<Drive> drive = {};
    std::int64_t cells = 0;
    double resolution = 0.0;  ///< [L/c], SimulationOptions::resolution
    Settling settling = {};
    bool isComplete = true;

    // What was seen, in the simulation's own units.
    double time = 0.0;
    std::int64_t contactCount = 0;
    double impulse = 0.0;
    double tip = 0.0;
    bool isHeld = false;
    Stop heldAt = Stop::right;  ///< if it is
    double energyRatio = 0.0;
    EnergyBalance balance = {};
    std::int64_t events = 0;
    std::int64_t pieces = 0;
    double merged = 0.0;

    /// Takes what was seen so far.
    void see(const BarSimulation& simulation);
    /// What units mean: of the first material.
    [[nodiscard]] Bar bar() const;
    [[nodiscard]] Ending status() const { return isComplete ? Ending::done : Ending::interrupted; }
};

/// How long a bar is followed, and what is seen of it.
struct SimulationWish {
    std::optional<double> time = {};           ///< [s]
    std::optional<std::int64_t> periods = {};  ///< in its place: of what drives the bar
    std::optional<double> resolution = {};     ///< [s]; one step of the excitation without
    bool recordsTip = true;
};

/// A bar on its way, and its answer.
struct FollowedBar {
    SimulationAnswer answer;
    BarSimulation simulation;
    double stretch = 1.0;  ///< of time (settling.hpp)
    double total = 0.0;    ///< so many of them

    /// To the end, or until it is cancelled.
    void follow(const Watch& watch);
};

/// A bar at its start. Scene, damping and drive are those of `asked`.
/// \throws std::invalid_argument naming time or periods beyond 1e9 L/c; as BarSimulation.
[[nodiscard]] FollowedBar started(SimulationAnswer asked, const Waves& start,
                                  const Excitation& driving, const SimulationWish& wish);

void describe(auto& d, Type<Drive>)
{
    d.record("Drive", "What moves the bar.");
    d.key("force", "-", R"(What is excited: "tip" or "base".)", &Drive::place);
    d.key("amplitude", "N or m > 0", "Of the excitation.", &Drive::amplitude);
    d.key("frequency_ratio", "- > 0", "omega/omega_1.", &Drive::frequencyRatio);
    d.key("frequency", "Hz > 0", "Of the excitation.",
          [](const Drive& drive) { return 1.0 / drive.period; });
    d.key("phase", "rad", "At the start.", &Drive::phase);
    d.key("steps", "- >= 3", "Of a period.", &Drive::steps);
}

void describe(auto& d, Type<SettledOn>)
{
    using T = SettledOn;
    d.record("Settled", "How a simulation repeats itself.");
    d.key("periods", "- >= 1", "Of the excitation, after which all is as before.",
          ofValue(&Settled::periods));
    d.key("residual", "- >= 0",
          "Bound of the distance to a motion that repeats itself, in its own size.",
          ofValue(&Settled::residual));
    d.key("contacts", "- >= 0", "In that time.", ofValue(&Settled::contacts));
    d.key("impulse", "N s >= 0", "In that time.",
          [](const T& s) { return s.value.impulse * s.impulseUnit; });
}

/// Keys of what a simulation settles on.
void describeSettled(auto& d, auto settling, auto impulseUnit)
{
    d.key("settled", "-", "How it repeats itself.", [=](const auto& s) {
        const std::optional<Settled>& settled = settling(s).settled;
        return settled ? std::optional(SettledOn{*settled, impulseUnit(s)}) : std::nullopt;
    });
    d.key("why", "-", "Where it has not settled, what it does instead.", [=](const auto& s) {
        const std::string& why = settling(s).why;
        return why.empty() ? std::nullopt : std::optional(why);
    });
}

void describe(auto& d, Type<Balance>)
{
    d.record("EnergyBalance", "Energy that came and went.");
    d.key("work", "J", "Done by the excitation.", &Balance::work);
    d.key("dissipated", "J", "In dashpots.", &Balance::dissipated);
    d.key("error", "J", "What does not add up.", &Balance::error);
}

/// State and energy at the end.
void describeEnd(auto& d)
{
    using T = SimulationAnswer;
    d.key("tip", "m", "u(L) at the end.",
          [](const T& s) { return s.tip * scales(s.bar()).displacement; });
    d.key("held", "-", "Is the tip at the wall?", &T::isHeld);
    d.key("energy", "J >= 0", "At the end.",
          [](const T& s) { return s.energyRatio * scales(s.bar()).energy; });
    d.key("energy_ratio", "- >= 0", "At the end, E/E_1, where there is a gap.", [](const T& s) {
        return s.scene.bar.gap == 0.0 ? std::nullopt : std::optional(s.energyRatio);
    });
    d.key("balance", "-", "Of energy since the start.", [](const T& s) {
        const double joule = scales(s.bar()).energy;
        return Balance{s.balance.work * joule, s.balance.dissipated * joule,
                       s.balance.error * joule};
    });
    d.key("events", "- >= 0", "So many.", &T::events);
    d.key("pieces", "- >= 1", "Under way at the end.", &T::pieces);
    d.key("merged", "m >= 0", "Most that merging faded jumps can have moved.",
          [](const T& s) { return s.merged * scales(s.bar()).displacement; });
}

void describe(auto& d, Type<SimulationAnswer>)
{
    using T = SimulationAnswer;
    d.record("Simulation", R"(What a bar did, event by event.

Arrays over contacts and the path of the tip come in SI units, and with ``_ratio`` in L/c, g,
EA g/L and EA g/c on the simulation's own memory.
)");
    d.key("status", "-", R"("done", or "interrupted".)", &T::status);
    d.key("cells", "- >= 1", "Of the state at the start.", &T::cells);
    describeScene(d, &T::scene);
    d.key("damping", "-", "A dashpot.", [](const T& s) { return Of<Damping>{s.damping, s.bar()}; });
    d.key("excitation", "-", "What moves the bar.", &T::drive);
    d.key("time", "s >= 0", "Simulated.", [](const T& s) { return s.time * scales(s.bar()).time; });
    d.key("time_ratio", "L/c >= 0", "Simulated.", &T::time);
    d.key("contacts", "- >= 0", "How many are over, and pressed.", &T::contactCount);
    d.key("impulse", "N s >= 0", "Of all of them.",
          [](const T& s) { return s.impulse * impulseUnit(s.bar()); });
    d.key("resolution", "s >= 0", "Contacts no further apart are one.",
          [](const T& s) { return s.resolution * scales(s.bar()).time; });
    describeSettled(
        d, [](const T& s) -> const Settling& { return s.settling; },
        [](const T& s) { return impulseUnit(s.bar()); });
    describeEnd(d);
}

}  // namespace signorini::answers
