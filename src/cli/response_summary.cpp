#include "response_summary.hpp"

#include <algorithm>
#include <functional>

#include "reports.hpp"

namespace signorini::cli {

namespace {

bool canRattle(const SummedFrequency& at)
{
    return at.mustRattle || std::any_of(at.motions.begin(), at.motions.end(),
                                        [](const SummedMotion& one) { return one.isImpact; });
}

bool lacksMotion(const SummedFrequency& at)
{
    return at.undecided == 0 && at.motions.empty();
}

}  // namespace

std::string ResponseSummary::where(const std::function<bool(const SummedFrequency&)>& holds) const
{
    return bandsText(
        frequencies.size(), [&](std::size_t k) { return holds(frequencies[k]); },
        [&](std::size_t first, std::size_t last) {
            const SummedFrequency& low = frequencies[first];
            const SummedFrequency& high = frequencies[last];
            std::string text = fmt::format("{:.6g}", low.hertz);
            std::string ratios = low.ratio ? fmt::format("{:.4g}", *low.ratio) : "";
            if (first != last) {
                text += fmt::format(" … {:.6g}", high.hertz);
                ratios += high.ratio ? fmt::format(" … {:.4g}", *high.ratio) : "";
            }
            return text + " Hz" + (ratios.empty() ? "" : fmt::format(" ({} ω₁)", ratios));
        });
}

void ResponseSummary::addRattles(Text& text, const char* otherwise) const
{
    const std::string all = where(canRattle);
    if (all.empty()) {
        const bool isOpen =
            std::any_of(frequencies.begin(), frequencies.end(), [](const SummedFrequency& at) {
                return at.undecided > 0 || (!at.isKnown && at.motions.empty());
            });
        print(text, "rattles     nowhere{}\n",
              !isComplete ? " that was reached"
              : isOpen    ? " that was decided"
                          : otherwise);
        return;
    }
    const std::string must = where([](const SummedFrequency& at) { return at.mustRattle; });
    print(text, "rattles     can: {}; must, as {}: {}\n", all, because,
          must.empty() ? "nowhere" : must);
}

void ResponseSummary::addGaps(Text& text) const
{
    const std::string unmet =
        where([](const SummedFrequency& at) { return lacksMotion(at) && at.mustRattle; });
    if (!unmet.empty()) {
        print(text, "no motion   {}, though {}: {}{}\n", which, because, unmet, hint);
    }
    const std::string unknown =
        where([](const SummedFrequency& at) { return lacksMotion(at) && !at.isKnown; });
    if (!unknown.empty()) {
        print(text,
              "no motion   {}, and the linear response does not say that there is one: {}{}\n",
              which, unknown, hint);
    }
    std::int64_t undecided = 0;
    const SummedFrequency* first = nullptr;
    for (const SummedFrequency& at : frequencies) {
        undecided += at.undecided;
        first = at.undecided > 0 && first == nullptr ? &at : first;
    }
    if (first != nullptr) {
        print(text, "undecided   {}{}; the first: {}\n",
              countsSchedules ? fmt::format("{} schedules: ", undecided) : "",
              where([](const SummedFrequency& at) { return at.undecided > 0; }), first->reason);
    }
}

void ResponseSummary::addWorst(Text& text) const
{
    const auto line = [&](const char* label, const char* unit, bool isOfImpacts, auto value,
                          auto remark) {
        const SummedFrequency* worstAt = nullptr;
        const SummedMotion* worst = nullptr;
        for (const SummedFrequency& at : frequencies) {
            for (const SummedMotion& one : at.motions) {  // of equals the highest frequency
                if ((one.isImpact || !isOfImpacts) &&
                    (worst == nullptr || value(one) > value(*worst) ||
                     (&at != worstAt && value(one) == value(*worst)))) {
                    worstAt = &at;
                    worst = &one;
                }
            }
        }
        if (worst != nullptr) {
            print(text, "{:<12}at most {:.6g} {} at {:.6g} Hz, {}{}\n", label, value(*worst), unit,
                  worstAt->hertz, worst->called, remark(value(*worst)));
        }
    };
    const auto nothing = [](double) { return std::string(); };
    line("force", "N", true, std::mem_fn(&SummedMotion::force), nothing);
    line("impulse", "N s per period", true, std::mem_fn(&SummedMotion::impulse), nothing);
    line("speed", "m/s before an impact", true, std::mem_fn(&SummedMotion::speed), nothing);
    line("strain", "[-]", false, std::mem_fn(&SummedMotion::strain), nothing);
    const bool hasStress = std::any_of(
        frequencies.begin(), frequencies.end(),
        [](const SummedFrequency& at) { return !at.motions.empty() && at.motions.front().stress; });
    if (hasStress) {
        line(
            "stress", "Pa", false, [](const SummedMotion& one) { return one.stress.value_or(0.0); },
            [this](double stress) { return yieldText(stress, yieldStress, "in these motions"); });
    }
}

}  // namespace signorini::cli
