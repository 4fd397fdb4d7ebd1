#include "study_answer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

namespace signorini::answers {

namespace {

void keepLarger(std::optional<double>& worst, const std::optional<double>& value)
{
    if (value && (!worst || *value > *worst)) {
        worst = value;
    }
}

/// The worst of a sweep up and down; nothing if it was cancelled.
std::optional<StudyPoint> studyAt(const StudyCase& of, const Cancel& cancel)
{
    SweepAnswer answer = of.sweep;
    answer.points =
        sweep(answer.range, {SweepDirection::up, SweepDirection::down}, {.cancel = cancel});
    if (answer.points.size() != 2 * static_cast<std::size_t>(answer.range.points)) {
        return std::nullopt;
    }
    StudyPoint point{.gap = answer.scene.bar.gap,
                     .damping = answer.range.damping.ratio,
                     .amplitude = of.amplitude};
    const Scales unit = scales(answer.bar);
    double irregular = 0.0;
    for (const SweepPointOf& at : answer.listed()) {
        const SweepPoint& seen = at.value;
        const double hertz = seen.frequencyRatio / 4.0 / unit.time;
        const double impulse = seen.impulse[1] * impulseUnit(answer.bar);
        if (point.frequency == 0.0 || impulse > point.impulse) {
            point.impulse = impulse;
            point.frequency = hertz;
        }
        point.meanForce = std::max(point.meanForce, seen.meanForce * forceUnit(answer.bar));
        keepLarger(point.strain, seen.strain * unit.strain);
        keepLarger(point.stress, at.stress());
        if (seen.meanContacts > 0.0) {
            point.from = std::min(point.from.value_or(hertz), hertz);
            point.to = std::max(point.to.value_or(hertz), hertz);
        }
        irregular += seen.settling.settled ? 0.0 : 1.0;
    }
    point.irregular = irregular / static_cast<double>(answer.points.size());
    return point;
}

/// \throws std::invalid_argument on a row that is none.
StudyPoint studyPointOf(const std::string& row)
{
    std::vector<std::optional<double>> fields;
    for (std::size_t at = 0; at <= row.size();) {
        const std::size_t comma = std::min(row.find(',', at), row.size());
        const std::string field = row.substr(at, comma - at);
        char* end = nullptr;
        const double value = std::strtod(field.c_str(), &end);
        if (*end != '\0') {
            fields.clear();
            break;
        }
        fields.push_back(field.empty() ? std::nullopt : std::optional(value));
        at = comma + 1;
    }
    constexpr std::size_t columns = 11;
    const bool isWhole = fields.size() == columns &&
                         std::all_of(fields.begin(), fields.begin() + 6,
                                     [](const auto& field) { return field.has_value(); }) &&
                         fields.back();
    if (!isWhole) {
        throw std::invalid_argument(
            fmt::format("row {}: allowed a row of a study: {}", row, studyHeader));
    }
    return {*fields[0], *fields[1], *fields[2], *fields[3], *fields[4], *fields[5],
            fields[6],  fields[7],  fields[8],  fields[9],  *fields[10]};
}

}  // namespace

std::optional<std::string> studyRow(const StudyCase& of, const Cancel& cancel)
{
    const std::optional<StudyPoint> p = studyAt(of, cancel);
    if (!p) {
        return std::nullopt;
    }
    const auto maybe = [](const std::optional<double>& value) {
        return value ? fmt::format("{}", *value) : std::string();
    };
    return fmt::format("{},{},{},{},{},{},{},{},{},{},{}", p->gap, p->damping, p->amplitude,
                       p->impulse, p->frequency, p->meanForce, maybe(p->strain), maybe(p->stress),
                       maybe(p->from), maybe(p->to), p->irregular);
}

std::string keyOf(const StudyCase& of)
{
    return fmt::format("{},{},{},", of.sweep.scene.bar.gap, of.sweep.range.damping.ratio,
                       of.amplitude);
}

std::vector<StudyPoint> studyPointsOf(const std::vector<std::string>& rows)
{
    std::vector<StudyPoint> points;
    for (const std::string& row : rows) {
        if (!row.empty()) {
            points.push_back(studyPointOf(row));
        }
    }
    return points;
}

}  // namespace signorini::answers
