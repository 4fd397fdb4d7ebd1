#include "report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <set>

#include "figures.hpp"
#include "signorini/output.hpp"
#include "solver.hpp"
#include "statistics.hpp"
#include "text.hpp"

namespace signorini::bench {

namespace {

/// "1.2 ms": three digits are more than a shared machine repeats.
std::string seconds(double value)
{
    if (std::isnan(value)) {
        return "–";
    }
    if (value < 1e-6) {
        return fmt::format("{:.3g} ns", 1e9 * value);
    }
    if (value < 1e-3) {
        return fmt::format("{:.3g} µs", 1e6 * value);
    }
    return value < 1.0 ? fmt::format("{:.3g} ms", 1e3 * value) : fmt::format("{:.3g} s", value);
}

std::string number(double value)
{
    return std::isnan(value) ? "–" : fmt::format("{:.2g}", value);
}

std::string count(double value)
{
    return std::isnan(value) ? "–" : fmt::format("{:.0f}", value);
}

/// The request of a row, whoever answered it: problem, and the words of the setting that belong to
/// it and not to the back end.
std::string requestOf(const Record& record)
{
    return record.problem + " | " + record.setting;
}

void writeOverview(Text& text, const Table& table)
{
    constexpr std::array outcomes{"right",   "inaccurate", "wrong",   "withdrawn", "undecided",
                                  "timeout", "memory",     "crashed", "skipped"};
    print(text,
          "## All cases\n\n"
          "*right*: the verdict is right and every error is at most 10 times the tolerance asked "
          "for. *inaccurate*: a larger error, below 1e-2. *wrong*: the other verdict, or a point "
          "with an error of 1e-2 and more. *withdrawn*: the back end claimed a point that does not "
          "meet its rows; the library noticed. *undecided*: no claim. *timeout*, *memory*, "
          "*crashed*: the process was ended. *skipped*: an easier case of the series was. Success: "
          "right among tried; correctness: right or inaccurate among claims.\n\n| back end |");
    for (const char* outcome : outcomes) {
        print(text, " {} |", outcome);
    }
    print(text, " success | correctness |\n|---|{}---|---|\n", [&] {
        std::string dashes;
        for (std::size_t k = 0; k < outcomes.size(); ++k) {
            dashes += "---|";
        }
        return dashes;
    }());
    for (const std::string& backEnd : distinct(table, &Record::backEnd)) {
        const Table rows = where(table, [&backEnd](const Record& record) {
            return record.backEnd == backEnd && wasTried(record) && record.suite != "rivals";
        });
        if (rows.empty()) {
            continue;
        }
        print(text, "| {} |", backEnd);
        std::array<std::size_t, outcomes.size()> counts{};
        for (std::size_t k = 0; k < outcomes.size(); ++k) {
            counts[k] = where(rows, [&](const Record& record) {
                            return record.outcome == outcomes[k];
                        }).size();
            print(text, " {} |", counts[k]);
        }
        const auto claims = static_cast<double>(counts[0] + counts[1] + counts[2]);
        const auto tried = static_cast<double>(rows.size());
        print(text, " {:.1f} % |", 100.0 * static_cast<double>(counts[0]) / tried);
        if (claims > 0.0) {
            print(text, " {:.1f} % |\n",
                  100.0 * static_cast<double>(counts[0] + counts[1]) / claims);
        } else {
            print(text, " – |\n");
        }
    }
    const Table absent =
        where(table, [](const Record& record) { return record.outcome == "absent"; });
    for (const std::string& backEnd : distinct(absent, &Record::backEnd)) {
        print(text, "\n`{}` is absent from this build or machine: its cases were not run.\n",
              backEnd);
    }
    print(text, "\n");
}

void writeAccuracy(Text& text, const Table& all)
{
    const Table table = where(all, [](const Record& r) { return r.suite == "accuracy"; });
    if (table.empty()) {
        return;
    }
    print(text,
          "## Error against run time\n\n### Success at fixed errors\n\nShare of the cases "
          "tried, at tolerance 1e-6, whose verdict is right and whose error is at most the "
          "one in the head of the column.\n\n"
          "| back end | form | cases | 1e-3 | 1e-6 | 1e-9 | wrong claims |\n"
          "|---|---|---|---|---|---|---|\n");
    const Table usual =
        where(table, [](const Record& r) { return r.figure("tolerance") == 1e-6 && wasTried(r); });
    for (const std::string& backEnd : distinct(usual, &Record::backEnd)) {
        const Table ofBackEnd = where(usual, [&](const Record& r) { return r.backEnd == backEnd; });
        for (const std::string& form : distinct(ofBackEnd, &Record::formulation)) {
            const Table rows =
                where(ofBackEnd, [&](const Record& r) { return r.formulation == form; });
            print(text, "| {} | {} | {} |", backEnd, form, rows.size());
            for (const double error : {1e-3, 1e-6, 1e-9}) {
                const auto right = where(rows, [error](const Record& r) {
                                       return isRightWithin(r, error);
                                   }).size();
                print(text, " {:.0f} % |",
                      100.0 * static_cast<double>(right) / static_cast<double>(rows.size()));
            }
            print(text, " {} |\n",
                  where(rows, [](const Record& r) { return r.outcome == "wrong"; }).size());
        }
    }
    print(text,
          "\n### Times at tolerance 1e-6\n\nMedian of the call of the solver, without "
          "writing the program down; what is not right is named instead.\n\n");
    for (const std::string& problem : distinct(usual, &Record::problem)) {
        if (problem.starts_with("random")) {
            continue;
        }
        const Table ofProblem = where(usual, [&](const Record& r) { return r.problem == problem; });
        for (const std::string& setting : distinct(ofProblem, &Record::setting)) {
            const Table rows =
                where(ofProblem, [&](const Record& r) { return r.setting == setting; });
            const std::vector<std::string> forms{"sd", "sy", "dy", "ky", "kd", "reduced", "lumped"};
            print(text, "**{}, {}**\n\n| back end | {} |\n|---|", problem, setting,
                  fmt::join(forms, " | "));
            for (std::size_t k = 0; k < forms.size(); ++k) {
                print(text, "---|");
            }
            print(text, "\n");
            for (const std::string& backEnd : distinct(rows, &Record::backEnd)) {
                if (backEnd == "signorini" || backEnd == "closed-form") {
                    const Table row =
                        where(rows, [&](const Record& r) { return r.backEnd == backEnd; });
                    print(text, "| {} | {} ({}, error {}) |||||||\n", backEnd,
                          seconds(row.front().figure("seconds_median")), row.front().outcome,
                          number(row.front().figure("error")));
                    continue;
                }
                print(text, "| {} |", backEnd);
                for (const std::string& form : forms) {
                    const Table row = where(rows, [&](const Record& r) {
                        return r.backEnd == backEnd && r.formulation == form;
                    });
                    print(text, " {} |",
                          row.empty() ? "–"
                          : row.front().outcome == "right"
                              ? seconds(row.front().figure("seconds_median"))
                              : "*" + row.front().outcome + "*");
                }
                print(text, "\n");
            }
            print(text, "\n");
        }
    }
}

void writeExtremes(Text& text, const Table& all)
{
    const Table table = where(all, [](const Record& r) { return r.suite == "extremes"; });
    if (table.empty()) {
        return;
    }
    print(text,
          "## Extremes\n\n| case | back end | form | setting | outcome | error | time | "
          "peak memory | words |\n|---|---|---|---|---|---|---|---|---|\n");
    for (const Record& r : table) {
        print(text, "| {} | {} | {} | {} | {} | {} | {} | {} MB | {:.80} |\n", r.problem, r.backEnd,
              r.formulation, r.setting, r.outcome == "right" ? "right" : "**" + r.outcome + "**",
              number(r.figure("error")), seconds(r.figure("seconds_median")),
              count(r.figure("peak_megabytes")), r.detail);
    }
    print(text, "\n");
}

void writeLeavingOut(Text& text, const Table& all)
{
    const Table table = where(all, [](const Record& r) { return r.suite == "leaving-out"; });
    if (table.empty()) {
        return;
    }
    print(text,
          "## What leaving out gains\n\nThe same request and solver, program by program; "
          "*time* is writing it down and solving it, *factor* is over the smallest program "
          "of the same case and solver.\n\n"
          "| case | solver | form | setting | unknowns | rows | entries | time | factor | "
          "peak memory | outcome |\n|---|---|---|---|---|---|---|---|---|---|---|\n");
    const auto total = [](const Record& r) {
        const double pose = r.figure("pose_seconds");
        return r.figure("seconds_median") + (std::isnan(pose) ? 0.0 : pose);
    };
    for (const Record& r : table) {
        const Table same = where(table, [&r](const Record& other) {
            return other.problem == r.problem && other.backEnd == r.backEnd &&
                   other.outcome == "right";
        });
        double least = std::numeric_limits<double>::quiet_NaN();
        for (const Record& other : same) {
            least = std::fmin(least, total(other));
        }
        print(text, "| {} | {} | {} | {} | {} | {} | {} | {} | {} | {} MB | {} |\n", r.problem,
              r.backEnd, r.formulation, r.setting, count(r.figure("variables")),
              count(r.figure("rows")), count(r.figure("entries")), seconds(total(r)),
              r.outcome == "right" ? number(total(r) / least) : "–",
              count(r.figure("peak_megabytes")),
              r.outcome == "right" ? "right" : "**" + r.outcome + "**");
    }
    print(text, "\n");
}

void writeScaling(Text& text, const Table& all)
{
    const Table table = where(all, [](const Record& r) { return r.suite == "scaling"; });
    if (table.empty()) {
        return;
    }
    print(text,
          "## Scaling\n\ntime = factor · N^exponent, least squares in logarithms over the "
          "right cases; *floor* is the time at the largest N over that of writing 2N "
          "doubles.\n\n| what | exponent | N | time at the smallest | at the largest | "
          "floor |\n|---|---|---|---|---|---|\n");
    const auto labelOf = [](const Record& r) {
        return r.backEnd == "signorini" ? r.setting
                                        : fmt::format("{}, {}, {}", r.backEnd, r.formulation,
                                                      r.setting.substr(0, r.setting.rfind(' ')));
    };
    std::map<double, double> floor;
    std::vector<std::string> labels;
    for (const Record& r : table) {
        if (r.setting == "writing 2N doubles") {
            floor[r.figure("cells")] = r.figure("seconds_median");
        }
        if (std::find(labels.begin(), labels.end(), labelOf(r)) == labels.end()) {
            labels.push_back(labelOf(r));
        }
    }
    for (const std::string& label : labels) {
        std::vector<std::pair<double, double>> points;
        std::string failed;
        for (const Record& r : table) {
            if (labelOf(r) != label) {
                continue;
            }
            if (r.outcome == "right" || r.outcome == "reference") {
                points.emplace_back(r.figure("cells"), r.figure("seconds_median"));
            } else if (wasTried(r)) {
                failed += fmt::format(" N = {:.0f}: {}.", r.figure("cells"), r.outcome);
            }
        }
        if (points.empty()) {
            print(text, "| {} | – | –{} | – | – | – |\n", label, failed);
            continue;
        }
        const PowerLaw law = fitPowerLaw(points);
        const auto atLargest = floor.find(points.back().first);
        print(text, "| {} | {:.2f} | {:.0f} … {:.0f}{} | {} | {} | {} |\n", label, law.exponent,
              points.front().first, points.back().first, failed, seconds(points.front().second),
              seconds(points.back().second),
              atLargest == floor.end() ? "–" : number(points.back().second / atLargest->second));
    }
    print(text, "\n");
}

void writeRivals(Text& text, const Table& all)
{
    const Table table = where(all, [](const Record& r) { return r.suite == "rivals"; });
    if (table.empty()) {
        return;
    }
    print(text,
          "## Rivals\n\nTip error: root mean square over time, and largest, relative to the "
          "reach of the tip; energy: change from the exact value at the end.\n\n"
          "| what | who | setting | outcome | tip error | largest | energy | time | words "
          "|\n|---|---|---|---|---|---|---|---|---|\n");
    for (const Record& r : table) {
        print(text, "| {} | {} | {} | {} | {} | {} | {} | {} | {} |\n", r.problem, r.backEnd,
              r.setting, r.outcome, number(r.figure("tip_error")), number(r.figure("error")),
              number(r.figure("energy_error")), seconds(r.figure("seconds_median")), r.detail);
    }
    print(text, "\n");
}

/// Every wrong claim, and what the library answered to the same request.
void writeLies(Text& text, const Table& table)
{
    const Table wrong = where(
        table, [](const Record& r) { return r.outcome == "wrong" || r.outcome == "withdrawn"; });
    print(text, "## Wrong and withdrawn claims\n\n");
    if (wrong.empty()) {
        print(text, "None.\n\n");
        return;
    }
    std::map<std::string, std::string> ours;
    for (const Record& r : table) {
        if (r.backEnd == "signorini") {
            ours[requestOf(r)] = r.claim + ", " + r.outcome;
            ours.try_emplace(r.problem, r.claim + ", " + r.outcome);
        }
    }
    print(text,
          "| case | back end | form | setting | claim | outcome | error | signorini on the "
          "same request |\n|---|---|---|---|---|---|---|---|\n");
    for (const Record& r : wrong) {
        const auto same = ours.find(requestOf(r));
        const auto near = ours.find(r.problem);
        print(text, "| {} | {} | {} | {} | {} | {} | {} | {} |\n", r.problem, r.backEnd,
              r.formulation, r.setting, r.claim, r.outcome, number(r.figure("error")),
              same != ours.end()   ? same->second
              : near != ours.end() ? near->second
                                   : "–");
    }
    print(text, "\n");
}

void writeOurFailures(Text& text, const Table& table)
{
    const Table failed = where(table, [](const Record& r) {
        return isOurs(r) && r.outcome != "right" && r.outcome != "reference";
    });
    print(text, "## Our own failures\n\n");
    if (failed.empty()) {
        print(text, "None: every row of `signorini` and `closed-form` is right.\n\n");
        return;
    }
    for (const Record& r : failed) {
        print(text, "- {}: {}, {} {}\n", keyOf(r), r.claim, r.outcome, r.detail);
    }
    print(text, "\n");
}

std::string provenanceOf(const std::string& folder, const std::string& id)
{
    std::ifstream file(folder + "/provenance-" + id + ".txt");
    return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace

std::string tableIn(const std::string& folder)
{
    return folder + "/results.csv";
}

std::string makeReport(const std::string& folder)
{
    Table table = readTable(tableIn(folder));
    if (table.empty()) {
        throw FileError(tableIn(folder), "holds no results");
    }
    const std::string id = table.back().provenance;
    std::erase_if(table, [&id](const Record& record) { return record.provenance != id; });

    Text text;
    print(text,
          "# signorini-bench: report\n\nMade from `results.csv`, {} rows of provenance "
          "{}.\n\n```\n{}```\n\nTimes are medians of wall time on a machine that may be "
          "shared: ratios say more than digits. Every case ran in a process of its own, "
          "under the same limits.\n\n",
          table.size(), id, provenanceOf(folder, id));
    writeOverview(text, table);
    writeOurFailures(text, table);
    std::string words;
    try {
        print(text, "## Figures\n\n");
        for (const Figure& figure : drawFigures(table, folder)) {
            print(text, "![{}]({})\n\n*{}*\n\n", figure.caption, figure.file, figure.caption);
        }
    } catch (const BackendUnavailable& error) {
        words = fmt::format("no figures: {}\n", error.what());
        print(text, "No figures: {}\n\n", error.what());
    }
    writeRivals(text, table);
    writeLeavingOut(text, table);
    writeScaling(text, table);
    writeExtremes(text, table);
    writeAccuracy(text, table);
    writeLies(text, table);

    const std::string path = folder + "/report.md";
    OutputFiles files;
    TextFile file(files.stage(path));
    file.write({text.data(), text.size()});
    file.close();
    files.commit();
    return words + fmt::format("report: {}\n", path);
}

}  // namespace signorini::bench
