#include "reports.hpp"

#include "text.hpp"

namespace signorini::cli {

namespace {

std::string asText(const ForcedCondition& condition)
{
    switch (condition.rule) {
        case ForcedRule::gap:
            return "u(L) at the stop at t = 0";
        case ForcedRule::pressure:
            return fmt::format("a push in step {}", condition.step);
        case ForcedRule::held:
            return fmt::format("a push on average in step {} and every 2N later", condition.step);
        case ForcedRule::secondStop:
            return fmt::format("u(L) ≥ −h after step {}", condition.step);
        case ForcedRule::penetration:
            return fmt::format("u(L) ≤ g after step {}", condition.step);
        case ForcedRule::closure:
            return fmt::format("u(L) at the stop after step {}", condition.step);
        case ForcedRule::work:
            return fmt::format("no work in step {} and every 2N later", condition.step);
        case ForcedRule::strain:
            return fmt::format("the strain limit in step {}", condition.step);
        case ForcedRule::rest:
            return "the tip that rests at the wall";
    }
    return {};
}

std::string asText(const std::vector<ForcedCondition>& conflict)
{
    std::string rows;
    for (const ForcedCondition& condition : conflict) {
        rows += (rows.empty() ? "" : ", ") + asText(condition);
    }
    return rows;
}

const char* wordsOf(Excited place)
{
    return place == Excited::tip ? "force on the tip" : "moving base";
}

std::string wordsOf(std::int64_t cycles)
{
    return cycles > 1 ? fmt::format(", {} cycles in a period", cycles) : "";
}

}  // namespace

std::string asText(const answers::ForcedAnswer& answer)
{
    const ForcedSet& set = answer.set;
    Text text;
    print(text, "{:<12}{}, ζ = {}, {}{}, ω/ω₁ = {:.10g}\n", name(answer.status()),
          describe(set.schedule), set.damping.ratio, wordsOf(set.forcing.place),
          wordsOf(set.forcing.cycles),
          static_cast<double>(set.forcing.cycles) * frequencyRatio(set.schedule));
    if (set.status == Status::found) {
        print(text, "set         {}, amplitudes {}\n", name(set.kind), answer.amplitudes());
    }
    for (const answers::ForcedMotionOf& motion : answer.motions) {
        print(text, "motion      amplitude {:.6g} {}, phase {:.6g} rad, residual {:.2g}\n{}",
              motion.amplitude(), answer.unitName(), motion.value.phase, motion.value.residual,
              asText(motion.physical()));
        if (motion.value.stability) {
            print(text, "stability   {} (tried: disturbed a little, 300 periods)\n",
                  name(*motion.value.stability));
        }
    }
    if (set.reason) {
        print(text, "reason      {}\n", name(*set.reason));
    }
    if (!set.conflict.empty() && set.conflict.front().rule == ForcedRule::rest) {
        print(text,
              "proof       the tip rests at the wall, and without a gap nothing presses it\n");
    } else if (!set.conflict.empty()) {
        print(text, "proof       {} contradicts {}{}; verified by interval arithmetic\n",
              asText({ForcedRule::gap, 0}), asText(set.conflict),
              set.cuts.empty() ? ""
                               : fmt::format(": none below 1e9 E₁ and an amplitude of {:.6g} {}",
                                             mostCutAmplitude * answer.unit(), answer.unitName()));
    }
    if (const auto detail = answer.detail()) {
        print(text, "why         {}\n", *detail);
    }
    return fmt::to_string(text);
}

std::string asText(const answers::HarmonicAnswer& answer)
{
    Text text;
    print(text, "{:<12}{} in T = {} L/c, {}{} of amplitude {:.6g} {}, ω/ω₁ = {:.10g}{}\n",
          name(answer.status()),
          answer.contacts == 1 ? "one contact" : fmt::format("{} contacts", answer.contacts),
          fractionAsText(answer.period), wordsOf(answer.place), wordsOf(answer.cycles),
          answer.amplitude, answer.place == Excited::tip ? "N" : "m", answer.frequencyRatio(),
          answer.question().nearest());
    for (const answers::HarmonicMotionOf& motion : answer.motions) {
        const auto& contacts = motion.value.contacts;
        for (const HarmonicContact& one : contacts) {
            print(text, "{:<12}contact of {:.10g} L/c{}, {}{}",
                  &one == contacts.data() ? "motion" : "", one.end - one.begin,
                  contacts.size() == 1 ? "" : fmt::format(" from {:.10g} L/c", one.begin),
                  one.isPinned ? "ended by a wave front" : "ended smoothly",
                  &one == &contacts.back() ? "; " : "\n");
        }
        print(text, "phase {:.6g} rad, residual {:.2g}\n{}", motion.value.phase,
              motion.value.residual, asText(motion.physical()));
        if (motion.proof.isProved) {
            print(text,
                  "proof       interval arithmetic: one such motion within {:.1e} L/c of these, "
                  "and no other within {:.0e}\n",
                  motion.proof.within, motion.proof.aloneWithin);
        }
        print(text, "{}", growthText(motion.growth, motion.attracts));
    }
    print(text, "{}", limitText(answer.limit));
    if (answer.all.rests.value_or(false)) {
        print(text, "rests       the tip may stay on a stop for good, without a flight\n");
    }
    if (const auto flight = answer.completeFrom(); flight && answer.status() != Status::undecided) {
        print(text, "all         interval arithmetic: no {}motion with one contact in a period{}\n",
              answer.motions.empty() && answer.limit.beyond == 0 ? "" : "other ",
              *flight > 0.0 ? fmt::format(" that flies for {:.6g} s or more", *flight) : "");
    }
    if (const auto detail = answer.detail()) {
        print(text, "why         {}\n", *detail);
    }
    return fmt::to_string(text);
}

}  // namespace signorini::cli
