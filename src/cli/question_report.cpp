#include "question_report.hpp"

#include <fmt/format.h>

#include <utility>

namespace signorini::cli {

QuestionReport::QuestionReport(AskedPeriod asked, std::int64_t cells, const FindOptions& options,
                               std::optional<TargetReport> target)
    : asked_(std::move(asked)),
      period_{cells, {{1, asked_.steps - 1}}},
      bar_(options.scene.bar),
      energyRatio_(options.energyRatio),
      target_(std::move(target))
{
}

void QuestionReport::add(const PeriodicResult& result)
{
    Json answer = answerOf(result, target_);
    Json set;
    for (const char* key : {"schedule", "family", "energy_ratio_range", "status", "reason"}) {
        set[key] = answer[key];
    }
    sets_.push_back(std::move(set));
    if (result.status == Status::found) {
        ++found_;
        motions_.push_back(std::move(answer));
        motionsAsText_.append("\n").append(asText(result, target_));
        return;
    }
    isUndecided_ = isUndecided_ || result.status == Status::undecided;
    othersAsText_.append("\n").append(asText(result, target_));
}

Status QuestionReport::status() const
{
    return found_ > 0 ? Status::found : isUndecided_ ? Status::undecided : Status::none;
}

std::string QuestionReport::question() const
{
    const ExactPeriod exact = exactPeriod(asked_.steps, period_.cells);
    std::string text =
        fmt::format("T = {} L/c = {:.10g} s, ω/ω₁ = {} ({} steps on {} cells)",
                    fractionAsText(exact), period(period_) * scales(bar_).time,
                    fractionAsText(exactPeriod(4 * exact.denominator, exact.numerator)),
                    asked_.steps, period_.cells);
    if (energyRatio_) {
        text += fmt::format(", E = {:.10g} E₁", *energyRatio_);
    }
    if (asked_.option == "hertz") {
        text += fmt::format("; asked {} Hz, nearest on this grid {:.10g} Hz", asked_.word,
                            1.0 / (period(period_) * scales(bar_).time));
    }
    return text;
}

std::string QuestionReport::reason() const
{
    if (sets_.empty()) {
        return "no motion with one contact in a period has this period, on any grid";
    }
    return "motions with one contact in a period have this period, but none on this grid meets the "
           "demands";
}

std::string QuestionReport::text() const
{
    std::string text = fmt::format("{:<12}{}\n", name(status()), question());
    text += fmt::format("sets        {} with this period and one contact in it, {} with a motion\n",
                        sets_.size(), found_);
    if (status() == Status::none) {
        text += fmt::format("reason      {}\n", reason());
    }
    return text + motionsAsText_ + othersAsText_;
}

Json QuestionReport::json() const
{
    const double seconds = period(period_) * scales(bar_).time;
    Json json = newAnswer();
    json.update(Json{{"bar", barAsJson(bar_)},
                     {"status", name(status())},
                     {"cells", period_.cells},
                     {"question",
                      {{"asked", {{asked_.option, asked_.word}}},
                       {"steps", asked_.steps},
                       {"period", seconds},
                       {"period_ratio", period(period_)},
                       {"frequency", 1.0 / seconds},
                       {"frequency_ratio", frequencyRatio(period_)},
                       {"energy", nullptr},
                       {"energy_ratio", nullptr}}},
                     {"sets", sets_},
                     {"motions", motions_},
                     {"reason", nullptr}});
    if (energyRatio_) {
        json["question"]["energy"] = *energyRatio_ * scales(bar_).energy;
        json["question"]["energy_ratio"] = *energyRatio_;
    }
    if (asked_.option == "hertz") {
        json["question"]["nearest"] = 1.0 / seconds;
    }
    if (status() == Status::none) {
        json["reason"] = sets_.empty() ? "period" : "constraints";
        json["detail"] = reason();
    }
    return json;
}

}  // namespace signorini::cli
