#include "simulate_command.hpp"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <algorithm>
#include <cmath>

#include "files.hpp"
#include "interrupt.hpp"
#include "progress.hpp"
#include "signorini/figures.hpp"

namespace signorini::cli {

namespace {

constexpr double longest = 1e9;  // [L/c]

/// The outcome of one call.
struct Answer {
    Bar bar;
    const ForceOptions& force;
    Excitation excitation;
    double frequencyRatio = 0.0;
    double phase = 0.0;
    std::int64_t cells = 0;
    std::optional<Settled> settled;
    bool isComplete = true;

    /// Period of the excitation [L/c]; 0 without.
    [[nodiscard]] double period() const
    {
        return static_cast<double>(excitation.steps()) / excitation.stepsPerCrossing;
    }
};

std::string asText(const Answer& answer, const BarSimulation& simulation)
{
    const Scales unit = scales(answer.bar);
    const EnergyBalance balance = simulation.balance();
    const double energy = energyRatio(simulation.waves());
    std::string text = fmt::format(
        "{:<12}{:.6g} s ({:.6g} L/c), {} events\n", answer.isComplete ? "simulated" : "interrupted",
        simulation.time() * unit.time, simulation.time(), simulation.events());
    text += fmt::format("contacts    {}, impulse {:.6g} N s in all\n", simulation.contacts().size(),
                        simulation.impulse() * impulseUnit(answer.bar));
    if (answer.settled) {
        const Settled& settled = *answer.settled;
        text += fmt::format(
            "settled     repeats every {} of the excitation: {} contact{}, {:.6g} N s\n",
            settled.periods == 1 ? "period" : fmt::format("{} periods", settled.periods),
            settled.contacts, settled.contacts == 1 ? "" : "s",
            settled.impulse * impulseUnit(answer.bar));
    } else if (answer.force.place) {
        text += "settled     no\n";
    }
    text += fmt::format("tip         u = {:.10g} m at the end{}\n",
                        simulation.tip() * unit.displacement,
                        simulation.isHeld() ? ", at the wall" : "");
    text += fmt::format(
        "energy      {:.10g} J = {:.10g} E₁; work {:.6g} J, dissipated {:.6g} J, "
        "balance off by {:.3g} of the largest\n",
        energy * unit.energy, energy, balance.work * unit.energy, balance.dissipated * unit.energy,
        balance.size > 0.0 ? std::abs(balance.error) / balance.size : 0.0);
    if (simulation.merged() > 0.0) {
        text += fmt::format("merged      faded jumps, at most {:.3g} g of displacement in all\n",
                            simulation.merged());
    }
    return text;
}

std::string asJson(const Answer& answer, const BarSimulation& simulation)
{
    const Bar& bar = answer.bar;
    const Scales unit = scales(bar);
    const EnergyBalance balance = simulation.balance();
    const double energy = energyRatio(simulation.waves());
    Json json = newAnswer();
    json.update(Json{{"status", answer.isComplete ? "done" : "interrupted"},
                     {"cells", answer.cells},
                     {"bar", barAsJson(bar)},
                     {"damping", dampingAsJson(answer.force.damping(), bar)},
                     {"excitation", nullptr},
                     {"time", simulation.time() * unit.time},
                     {"time_ratio", simulation.time()},
                     {"contacts", simulation.contacts().size()},
                     {"impulse", simulation.impulse() * impulseUnit(bar)},
                     {"settled", nullptr},
                     {"tip", simulation.tip() * unit.displacement},
                     {"held", simulation.isHeld()},
                     {"energy", energy * unit.energy},
                     {"energy_ratio", energy},
                     {"balance",
                      {{"work", balance.work * unit.energy},
                       {"dissipated", balance.dissipated * unit.energy},
                       {"error", balance.error * unit.energy}}},
                     {"events", simulation.events()},
                     {"pieces", simulation.pieces()},
                     {"merged", simulation.merged() * unit.displacement}});
    if (answer.force.place) {
        json["excitation"] = {{"force", name(*answer.force.place)},
                              {"amplitude", *answer.force.amplitude},
                              {"frequency_ratio", answer.frequencyRatio},
                              {"frequency", 1.0 / (answer.period() * unit.time)},
                              {"phase", answer.phase},
                              {"steps", answer.excitation.steps()}};
    }
    if (answer.settled) {
        json["settled"] = {{"periods", answer.settled->periods},
                           {"contacts", answer.settled->contacts},
                           {"impulse", answer.settled->impulse * impulseUnit(bar)}};
    }
    return asLine(json);
}

void writeEvents(const std::string& path, const BarSimulation& simulation, const Bar& bar)
{
    const double second = scales(bar).time;
    TextFile file(path);
    file.write("start,end,impulse,peak_force\n");
    for (const ContactEvent& contact : simulation.contacts()) {
        file.write(fmt::format("{},{},{},{}\n", contact.start * second, contact.end * second,
                               contact.impulse * impulseUnit(bar),
                               contact.peakForce * forceUnit(bar)));
    }
    file.close();
}

void writeTip(const std::string& path, const BarSimulation& simulation, const Bar& bar)
{
    const Scales unit = scales(bar);
    TextFile file(path);
    file.write("time,displacement\n");
    for (const TipPoint& point : simulation.tipPath()) {
        file.write(
            fmt::format("{},{}\n", point.time * unit.time, point.displacement * unit.displacement));
    }
    file.close();
}

}  // namespace

void SimulateCommand::addTo(CLI::App& command)
{
    command.add_option("--from", fromFile, "state to start from, as find --state writes it")
        ->type_name("FILE.csv");
    command.add_flag("--rest", fromRest, "start at rest (so without --from)");
    force.addTo(command);
    addPositive(command, "--frequency", "omega_1", frequencyRatio, "W",
                "frequency of the excitation, ω/ω₁");
    addWord(command, "--phase", "RAD", "of the excitation at the start, cos(ωt - phase) (0)",
            [this](const std::string& text) { phase = parseReal("--phase", text, "rad"); });
    addPositive(command, "--time", "s", time, "T", "how long, in seconds");
    addWhole(command, "--periods", 1, 1'000'000'000, periods, "P",
             "or how many periods of the excitation");
    command
        .add_option("--events", eventsFile, "write all contacts: start, end, impulse, peak force")
        ->type_name("FILE.csv");
    command.add_option("--tip", tipFile, "write the path of the tip")->type_name("FILE.csv");
    command.add_option("--figure", figureFile, "draw tip, contacts and force (needs gnuplot)")
        ->type_name("FILE.svg|.png|.pdf");
    common.addTo(command);
    command.footer(
        "Nothing is on a grid but the excitation, which is constant for L/(N c), or as much as "
        "fits "
        "a whole number of\ntimes into its period.");
}

void SimulateCommand::requireWhole() const
{
    if (fromRest && !fromFile.empty()) {
        throw std::invalid_argument("--rest clashes with --from: allowed one of them");
    }
    const int given = (force.place ? 1 : 0) + (force.amplitude ? 1 : 0) + (frequencyRatio ? 1 : 0);
    if (given != 0 && given != 3) {
        throw std::invalid_argument(
            "--force, --amplitude, --frequency: allowed only all three together");
    }
    if (periods && !force.place) {
        throw std::invalid_argument("--periods: allowed only together with --force");
    }
    if (time.has_value() == periods.has_value()) {
        throw std::invalid_argument(time ? "--time clashes with --periods: allowed one of them"
                                         : "--time, --periods: missing: allowed one of them");
    }
}

Waves SimulateCommand::start(const Bar& bar) const
{
    if (fromFile.empty()) {
        return wavesAtRest(static_cast<double>(common.usualCells()));
    }
    return wavesOf(forFile("--from", fromFile,
                           [&] { return readState(fromFile, bar, common.usualCells()).state; }));
}

Excitation SimulateCommand::excitation(const Bar& bar, double cells) const
{
    if (!force.place) {
        return {.stepsPerCrossing = cells};
    }
    // A period of 4/W L/c is as many whole steps as come nearest to cells in L/c.
    const double exact = 4.0 * cells / *frequencyRatio;
    const double steps = std::round(exact);
    if (!(steps >= 3.0 && steps <= static_cast<double>(maxExcitationSteps))) {
        refuse("--frequency", fmt::format("{}", *frequencyRatio),
               fmt::format("about {:.3g}..{:.3g} [ω₁] with {} steps in L/c (--cells)",
                           4.0 * cells / static_cast<double>(maxExcitationSteps), 4.0 * cells / 3.0,
                           cells));
    }
    const bool isWhole = std::abs(exact - steps) <= 1e-9 * exact;
    return excitationOf({.place = *force.place,
                         .amplitude = force.scaledAmplitude(bar),
                         .phase = phase,
                         .cycles = 1,
                         .steps = static_cast<std::int64_t>(steps),
                         .stepsPerCrossing = isWhole ? cells : steps * *frequencyRatio / 4.0});
}

ExitStatus SimulateCommand::run() const
{
    requireWhole();
    Answer answer{common.bar(), force, {}, frequencyRatio.value_or(0.0), phase, 0, {}};
    if (!figureFile.empty()) {
        (void)figureFormat(figureFile);
    }
    const OutputOption eventsOption{"--events", eventsFile};
    const OutputOption tipOption{"--tip", tipFile};
    const OutputOption figureOption{"--figure", figureFile};
    validateOutputs({eventsOption, tipOption, figureOption});
    const Waves waves = start(answer.bar);
    answer.cells = static_cast<std::int64_t>(waves.crossing);
    answer.excitation =
        excitation(answer.bar, common.cells ? static_cast<double>(*common.cells) : waves.crossing);
    BarSimulation simulation(
        waves, force.damping(), answer.excitation,
        {.mergeBelow = {}, .recordsTip = !tipFile.empty() || !figureFile.empty()});
    OutputFiles files;
    const std::string events = stage(files, eventsOption);
    const std::string tip = stage(files, tipOption);
    const std::string figure = stage(files, figureOption);

    // In units of the simulation's; a period of the excitation is a whole number of its steps.
    const double stretch = answer.excitation.steps() > 0
                               ? static_cast<double>(answer.excitation.steps()) * waves.crossing /
                                     answer.excitation.stepsPerCrossing
                               : 16.0 * waves.crossing;
    const double total = periods ? static_cast<double>(*periods)
                                 : *time / scales(answer.bar).time * waves.crossing / stretch;
    if (const double most = longest * scales(answer.bar).time;
        !(total * stretch <= longest * waves.crossing)) {
        refuse(time ? "--time" : "--periods",
               time ? fmt::format("{}", *time) : fmt::format("{}", *periods),
               fmt::format("what lasts at most {} L/c, {:.3g} s", longest, most));
    }
    SettlingWatch watch;
    {
        const Interrupt interrupt;
        const Cancel cancel = interrupt.cancel();
        Progress progress(!common.quiet, "simulating");
        double done = 0.0;
        for (; done + 1.0 <= total && !isRequested(cancel); done += 1.0) {
            simulation.advance(stretch);
            watch.see(simulation);
            progress.show(done, total);
        }
        answer.isComplete = done + 1.0 > total;
        if (answer.isComplete && total > done) {
            simulation.advance((total - done) * stretch);
        }
    }
    if (force.place) {
        answer.settled = watch.settled();
    }
    if (answer.isComplete) {
        if (!events.empty()) {
            forFile("--events", eventsFile, [&] { writeEvents(events, simulation, answer.bar); });
        }
        if (!tip.empty()) {
            forFile("--tip", tipFile, [&] { writeTip(tip, simulation, answer.bar); });
        }
        if (!figure.empty()) {
            forFile("--figure", figureFile, [&] {
                drawSimulation(simulation, answer.excitation, figureFormat(figureFile), figure);
            });
        }
        files.commit();
    } else if (!common.quiet) {
        tell("signorini simulate: interrupted; no file was written\n");
    }
    writeOut(common.wantsJson ? asJson(answer, simulation) : asText(answer, simulation));
    common.useOneThread("simulate");
    return answer.isComplete ? exitFound : exitUndecided;
}

}  // namespace signorini::cli
