#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "find_command.hpp"
#include "interrupt.hpp"
#include "network_find.hpp"
#include "scene_figures.hpp"
#include "scene_options.hpp"
#include "signorini/find_periodic.hpp"
#include "units.hpp"

namespace signorini::cli {

namespace {

constexpr std::int64_t mostSceneSteps = 1'000'000;

ContactSet setOf(std::string_view text, std::size_t contacts, const std::string& word)
{
    if (text == "-" || text.empty()) {
        return 0;
    }
    ContactSet closed = 0;
    for (bool isLast = false; !isLast;) {
        const std::size_t plus = text.find('+');
        isLast = plus == std::string_view::npos;
        const auto number = wholeIn(text.substr(0, plus), 1, static_cast<std::int64_t>(contacts));
        const ContactSet one = number ? ContactSet{1} << (*number - 1) : 0;
        refuseIf(!number || (closed & one) != 0, "schedule", word,
                 fmt::format("SET:STEPS, SET - or different contacts 1..{} joined by +", contacts));
        closed |= one;
        text.remove_prefix(isLast ? text.size() : plus + 1);
    }
    return closed;
}

/// What is known of a schedule.
struct FreeAnswer {
    const SceneFind& of;
    std::optional<double> unit;  ///< E_1 [Z_1 delta^2/h]
    NetworkWish wish;
    LeastMotion motions;

    [[nodiscard]] double joules(double energy) const { return energy * of.network.scales.energy(); }
    [[nodiscard]] Json ratio(double energy) const { return unit ? Json(energy / *unit) : Json(); }
    [[nodiscard]] std::string inWords(double energy) const
    {
        return unit ? fmt::format("{:.6g} E₁", energy / *unit)
                    : fmt::format("{:.6g} J", joules(energy));
    }
    /// Pushes on a bar that drifts balance what else acts on it, on average.
    [[nodiscard]] std::string whyGrazing() const
    {
        return pushesBalance(of.network, of.schedule)
                   ? ", nor does it in any other motion of this schedule: the pushes on a bar that "
                     "nothing else holds balance"
                   : "";
    }
    /// What is proved is that of least energy.
    [[nodiscard]] bool isProof() const
    {
        return motions.status == Status::none ||
               (motions.status == Status::found && wish.isOfLeast());
    }
    [[nodiscard]] bool presses() const
    {
        const auto& impulses = motions.residuals.impulses;
        return std::any_of(impulses.begin(), impulses.end(), [](double one) { return one > 1e-9; });
    }
};

/// `unit`: E_1, if there is one.
NetworkWish wishOf(const SceneFind& of, const std::optional<double>& unit)
{
    const FindOptions& options = of.call.options;
    NetworkWish wish{options.objective, of.call.given.number("--energy"), {}};
    refuseIf(wish.energy && options.energyRatio,
             "--energy clashes with --energy-ratio: allowed one of them");
    if (wish.energy) {
        *wish.energy /= of.network.scales.energy();
    } else if (options.energyRatio) {
        refuseIf(!unit, "--energy-ratio", of.call.given.text("--energy-ratio"),
                 "none where no energy E₁ is needed to reach contact 1: --energy in its place");
        wish.energy = *options.energyRatio * *unit;
    }
    const std::string target = of.call.given.text("--target");
    requireTarget(options, target);
    if (!target.empty()) {
        wish.target = forFile("--target", target, [&] {
            return meansOf(of.network, readStateTable(target, of.network));
        });
    }
    return wish;
}

Json certificateAsJson(const FreeAnswer& answer)
{
    if (!answer.isProof() || answer.motions.provedEnergy == 0.0) {
        return nullptr;
    }
    Json json{{"kind", "energy-floor"}, {"verified", true}, {"rows", "network"}};
    json["energy_ratio"] = answer.ratio(answer.motions.provedEnergy);
    json["energy"] = answer.joules(answer.motions.provedEnergy);
    json.update(multipliersAsJson(answer.motions.multipliers));
    return json;
}

Json asJson(const FreeAnswer& answer)
{
    const LeastMotion& motions = answer.motions;
    Json json = answer.of.keys(motions.status);
    json.update(Json{{"kernel_dimension", jsonOf(motions.kernelDimension)},
                     {"contacts", jsonOf(contactsOf(answer.of.network, answer.of.assembly.length))},
                     {"contact", nullptr},
                     {"energy", nullptr},
                     {"energy_ratio", nullptr},
                     {"energy_ratio_proved", nullptr},
                     {"residuals", nullptr},
                     {"certificate", certificateAsJson(answer)},
                     {"detail", motions.detail}});
    if (motions.status == Status::none && !motions.isEmpty) {  // what is held excludes all
        json["reason"] = name(Reason::constraints);
    }
    if (motions.status != Status::found) {
        return json;
    }
    json["energy"] = answer.joules(motions.energy);
    json["contact"] = answer.presses() ? "pressing" : "grazing";
    json["energy_ratio"] = answer.ratio(motions.energy);
    json["energy_ratio_proved"] = answer.ratio(motions.provedEnergy);
    json["residuals"] = {{"periodicity", motions.residuals.periodicity},
                         {"tie", motions.residuals.tie},
                         {"gap", motions.residuals.gap},
                         {"pressure", motions.residuals.pressure},
                         {"penetration", motions.residuals.penetration}};
    addForces(json["contacts"], answer.of.network, answer.of.schedule, motions.residuals);
    return json;
}

std::string asText(const FreeAnswer& answer)
{
    const LeastMotion& motions = answer.motions;
    std::string text = answer.of.lines(motions.status) +
                       fmt::format("frequency   {:.6g} Hz\n", 1.0 / answer.of.period());
    if (motions.status == Status::none) {
        text += fmt::format("proof       none below {}; verified by stepping backwards in time\n",
                            answer.inWords(motions.provedEnergy));
    } else if (motions.status == Status::undecided) {
        text += fmt::format("why         {}\n", motions.detail);
    } else {
        text += fmt::format(
            "energy      {:.6g} J{}{}; proved: none has less than {}\n",
            answer.joules(motions.energy), answer.unit ? ", " + answer.inWords(motions.energy) : "",
            answer.wish.isOfLeast() ? ", the least" : "", answer.inWords(motions.provedEnergy));
        if (!answer.presses()) {
            text += fmt::format("contact     grazing: nothing presses{}\n", answer.whyGrazing());
        }
        text += forcesAsText(answer.of.network, motions.residuals);
        text += fmt::format("residual    {:.2g}\n", motions.residuals.worst());
    }
    return text;
}

}  // namespace

std::vector<ContactSpan> parseSpans(const std::vector<std::string>& words, std::size_t contacts)
{
    std::vector<ContactSpan> spans;
    const bool arePairs =
        contacts == 1 && !words.empty() && words.front().find(':') == std::string::npos;
    if (words.empty() || (arePairs && words.size() % 2 != 0)) {
        refuse("schedule", fmt::format("{} words", words.size()),
               contacts == 1 ? "NC NF [NC NF ...], or SET:STEPS ..." : "SET:STEPS ...");
    }
    for (const std::string& word : words) {
        const std::size_t colon = word.find(':');
        std::string_view number = word;
        if (!arePairs) {
            number.remove_prefix(colon == std::string::npos ? word.size() : colon + 1);
        }
        const auto steps = wholeIn(number, 1, mostSceneSteps);
        refuseIf(!steps, "schedule", word,
                 fmt::format("{}, steps 1..{}", arePairs ? "NC NF" : "SET:STEPS", mostSceneSteps));
        spans.push_back({arePairs ? (spans.size() % 2 == 0 ? 1U : 0U)
                                  : setOf(std::string_view(word).substr(0, colon), contacts, word),
                         *steps});
    }
    return spans;
}

SceneFind::SceneFind(const FindCommand& of)
    : call(of),
      assembly(of.common.assembly()),
      network(networkOf(assembly)),
      schedule(parseSpans(of.given.words(), network.contacts.size())),
      files(of)
{
}

Json SceneFind::keys(Status status) const
{
    Json json = newAnswer();
    json.update(Json{{"status", name(status)},
                     {"scene", jsonOf(assembly)},
                     {"reference", jsonOf(referenceOf(network))},
                     {"cells", network.cells()},
                     {"schedule", scheduleAsJson(schedule)},
                     {"period", period()}});
    return json;
}

std::string SceneFind::lines(Status status) const
{
    return headline(assembly, network) + fmt::format("{:<12}{}\n", name(status), textOf(schedule));
}

ExitStatus SceneFind::finish(Status status, const NetworkClaim* motion, bool isProof,
                             const Json& json, const std::string& text)
{
    if (motion != nullptr) {
        files.writeBars(
            [&](const std::string& path) {
                writeStateTable(path, network, {motion->waves, motion->displacements});
            },
            [&] { return periodFigure(network, *motion); });
    } else {
        files.lackMotion();
    }
    if (isProof) {
        files.writeProof([&json](TextFile& file) { file.write(asLine(json)); });
    } else {
        files.lackProof();
    }
    writeOut(call.common.wantsJson ? asLine(json) : text);
    call.common.useOneThread();
    return exitStatusOf(status);
}

ExitStatus findInScene(const FindCommand& command)
{
    if (command.isForced()) {
        return findForcedInScene(command);
    }
    SceneFind scene(command);
    const Interrupt interrupt;
    FindOptions options = command.options;
    options.cancel = interrupt.cancel();
    FreeAnswer answer{scene, firstEnergy(scene.network), {}, {}};
    answer.wish = wishOf(scene, answer.unit);
    answer.motions = wishedMotion(scene.network, scene.schedule,
                                  hugeEnergyRatio * usualEnergy(scene.network, scene.schedule),
                                  answer.wish, options);
    const auto& motion = answer.motions.motion;
    return scene.finish(answer.motions.status, motion ? &*motion : nullptr, answer.isProof(),
                        asJson(answer), asText(answer));
}

}  // namespace signorini::cli
