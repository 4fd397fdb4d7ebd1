"""Makes report.md and the figures of a folder with results.csv.

usage: python3 benchmarks/report.py FOLDER
"""

from __future__ import annotations

import math
import os
import sys
from collections.abc import Iterable
from pathlib import Path

import report_table as tables
from report_table import Record, Table, distinct, total_seconds, where

OUTCOMES = ("right", "inaccurate", "wrong", "withdrawn", "undecided",
            "timeout", "memory", "crashed", "skipped")


def seconds(value: float) -> str:
    """Three digits are more than a shared machine repeats."""
    if math.isnan(value):
        return "–"
    for size, unit in ((1e-6, "ns"), (1e-3, "µs"), (1.0, "ms")):
        if value < size:
            return f"{1e3 * value / size:.3g} {unit}"
    return f"{value:.3g} s"


def number(value: float) -> str:
    """Two digits."""
    return "–" if math.isnan(value) else f"{value:.2g}"


def count(value: float) -> str:
    """A whole number."""
    return "–" if math.isnan(value) else f"{value:.0f}"


def share(part: int, whole: int, digits: int = 0) -> str:
    """Per cent."""
    return f"{100 * part / whole:.{digits}f} %" if whole else "–"


def grid(head: Iterable[str], rows: Iterable[Iterable[str]]) -> str:
    """A table in Markdown."""
    head = list(head)
    lines = [head, ["---"] * len(head), *(list(row) for row in rows)]
    return "".join("| " + " | ".join(line) + " |\n" for line in lines) + "\n"


def bold_unless_right(r: Record) -> str:
    """The outcome."""
    return "right" if r.outcome == "right" else f"**{r.outcome}**"


def overview(table: Table) -> str:
    """Who did what."""
    text = (
        "## All cases\n\n*right*: the verdict is right and every error is at "
        "most 10 times the tolerance asked for. *inaccurate*: a larger error, "
        "below 1e-2. *wrong*: the other verdict, or a point with an error of "
        "1e-2 and more. *withdrawn*: the back end claimed a point that does "
        "not meet its rows; the library noticed. *undecided*: no claim. "
        "*timeout*, *memory*, *crashed*: the process was ended. *skipped*: an "
        "easier case of the series was. Success: right among tried; "
        "correctness: right or inaccurate among claims.\n\n")
    lines = []
    for who in distinct(r.back_end for r in table):
        rows = where(table, lambda r: r.back_end == who and r.was_tried
                     and r.suite != "rivals")
        if rows:
            counts = [sum(r.outcome == o for r in rows) for o in OUTCOMES]
            lines.append([who, *map(str, counts),
                          share(counts[0], len(rows), 1),
                          share(counts[0] + counts[1], sum(counts[:3]), 1)])
    text += grid(["back end", *OUTCOMES, "success", "correctness"], lines)
    for who in distinct(r.back_end for r in table if r.outcome == "absent"):
        text += (f"`{who}` is absent from this build or machine: its cases "
                 "were not run.\n\n")
    return text


def accuracy(table: Table) -> str:
    """Error against run time."""
    table = where(table, lambda r: r.suite == "accuracy")
    if not table:
        return ""
    usual = where(table, lambda r: r.figure("tolerance") == 1e-6
                  and r.was_tried)
    lines = []
    for who in distinct(r.back_end for r in usual):
        for form in distinct(r.formulation for r in usual
                             if r.back_end == who):
            rows = where(usual, lambda r: r.back_end == who
                         and r.formulation == form)
            within = [share(sum(r.is_right_within(e) for r in rows),
                            len(rows)) for e in (1e-3, 1e-6, 1e-9)]
            wrong = sum(r.outcome == "wrong" for r in rows)
            lines.append([who, form, str(len(rows)), *within, str(wrong)])
    text = (
        "## Error against run time\n\n### Success at fixed errors\n\nShare of "
        "the cases tried, at tolerance 1e-6, whose verdict is right and whose "
        "error is at most the one in the head of the column.\n\n" + grid(
            ["back end", "form", "cases", "1e-3", "1e-6", "1e-9",
             "wrong claims"], lines) +
        "### Times at tolerance 1e-6\n\nMedian of the call of the solver, "
        "without writing the program down; what is not right is named "
        "instead.\n\n")
    for case in distinct(r.case for r in usual
                         if not r.case.startswith("random")):
        mine = where(usual, lambda r: r.case == case)
        for setting in distinct(r.setting for r in mine):
            text += times_of(case, setting,
                             where(mine, lambda r: r.setting == setting))
    return text


def times_of(case: str, setting: str, rows: Table) -> str:
    """Who took how long for one request, form by form."""
    forms = ["sd", "sy", "dy", "ky", "kd", "reduced", "lumped"]
    lines = []
    for who in distinct(r.back_end for r in rows):
        mine = where(rows, lambda r: r.back_end == who)
        if mine[0].is_ours:
            r = mine[0]
            lines.append([who, f"{seconds(r.figure('seconds_median'))} "
                          f"({r.outcome}, error {number(r.figure('error'))})",
                          *[""] * (len(forms) - 1)])
            continue
        line = [who]
        for form in forms:
            found = [r for r in mine if r.formulation == form]
            line.append("–" if not found else
                        seconds(found[0].figure("seconds_median"))
                        if found[0].outcome == "right"
                        else f"*{found[0].outcome}*")
        lines.append(line)
    return f"**{case}, {setting}**\n\n" + grid(["back end", *forms], lines)


def extremes(table: Table) -> str:
    """Extreme cases."""
    rows = where(table, lambda r: r.suite == "extremes")
    return rows and "## Extremes\n\n" + grid(
        ["case", "back end", "form", "setting", "outcome", "error", "time",
         "peak memory", "words"],
        [[r.case, r.back_end, r.formulation, r.setting, bold_unless_right(r),
          number(r.figure("error")), seconds(r.figure("seconds_median")),
          count(r.figure("peak_megabytes")) + " MB", r.detail[:80]]
         for r in rows]) or ""


def leaving_out(table: Table) -> str:
    """The same request, program by program."""
    rows = where(table, lambda r: r.suite == "leaving-out")
    if not rows:
        return ""
    lines = []
    for r in rows:
        least = min((total_seconds(o) for o in rows if o.case == r.case
                     and o.back_end == r.back_end and o.outcome == "right"),
                    default=math.nan)
        lines.append([
            r.case, r.back_end, r.formulation, r.setting,
            *(count(r.figure(name)) for name in ("variables", "rows",
                                                 "entries")),
            seconds(total_seconds(r)),
            number(total_seconds(r) / least) if r.outcome == "right" else "–",
            count(r.figure("peak_megabytes")) + " MB", bold_unless_right(r)])
    return ("## What leaving out gains\n\nThe same request and solver, program"
            " by program; *time* is writing it down and solving it, *factor* "
            "is over the smallest program of the same case and solver.\n\n" +
            grid(["case", "solver", "form", "setting", "unknowns", "rows",
                  "entries", "time", "factor", "peak memory", "outcome"],
                 lines))


def scaling(table: Table) -> str:
    """Time against the number of cells."""
    rows = where(table, lambda r: r.suite == "scaling")
    if not rows:
        return ""

    def label(r: Record) -> str:
        words = r.setting.rpartition(" ")[0] or r.setting
        return r.setting if r.back_end == "signorini" else \
            f"{r.back_end}, {r.formulation}, {words}"

    floor = {r.figure("cells"): r.figure("seconds_median") for r in rows
             if r.setting == "writing 2N doubles"}
    lines = []
    for what in distinct(map(label, rows)):
        mine = where(rows, lambda r: label(r) == what)
        points = [(r.figure("cells"), r.figure("seconds_median"))
                  for r in mine if r.outcome in ("right", "reference")]
        failed = "".join(f" N = {r.figure('cells'):.0f}: {r.outcome}."
                         for r in mine if r.was_tried and r.outcome != "right")
        if not points:
            lines.append([what, "–", "–" + failed, "–", "–", "–"])
            continue
        (first, least), (last, most) = points[0], points[-1]
        lines.append([what, f"{round(tables.power_law(points), 2) + 0.0:.2f}",
                      f"{first:.0f} … {last:.0f}{failed}", seconds(least),
                      seconds(most), number(most / floor[last])
                      if last in floor else "–"])
    return ("## Scaling\n\ntime = factor · N^exponent, least squares in "
            "logarithms over the right cases with N ≤ "
            f"{tables.MOST_CELLS_IN_CACHE:,}, whose state stays in the "
            "cache; *floor* is the time at the largest N over that of writing "
            "2N doubles.\n\n" +
            grid(["what", "exponent", "N", "time at the smallest",
                  "at the largest", "floor"], lines))


def rivals(table: Table) -> str:
    """Other programs."""
    rows = where(table, lambda r: r.suite == "rivals")
    return rows and (
        "## Rivals\n\nErrors of tip and force: root mean square over the "
        "first five periods, relative to the reach of the tip and to the "
        "force's own; drift: of the energy after 100 periods; time: of the "
        "processor, for those 100.\n\n" + grid(
            ["what", "who", "setting", "outcome", "tip error", "force error",
             "drift", "time", "words"],
            [[r.case, r.back_end, r.setting, r.outcome,
              number(r.figure("tip_error")), number(r.figure("force_error")),
              number(r.figure("energy_drift")),
              seconds(r.figure("seconds_median")), r.detail]
             for r in rows])) or ""


def lies(table: Table) -> str:
    """Every wrong claim, and our answer to the same request."""
    wrong = where(table, lambda r: r.outcome in ("wrong", "withdrawn"))
    if not wrong:
        return "## Wrong and withdrawn claims\n\nNone.\n\n"
    ours: dict[str, str] = {}
    for r in table:
        if r.back_end == "signorini":
            said = f"{r.claim}, {r.outcome}"
            ours[f"{r.case} | {r.setting}"] = said
            ours.setdefault(r.case, said)
    return "## Wrong and withdrawn claims\n\n" + grid(
        ["case", "back end", "form", "setting", "claim", "outcome", "error",
         "signorini on the same request"],
        [[r.case, r.back_end, r.formulation, r.setting, r.claim, r.outcome,
          number(r.figure("error")),
          ours.get(f"{r.case} | {r.setting}", ours.get(r.case, "–"))]
         for r in wrong])


def our_failures(table: Table) -> str:
    """What went wrong with us."""
    failed = where(table, lambda r: r.is_ours
                   and r.outcome not in ("right", "reference")
                   # Of a march: an error, no verdict.
                   and not (r.outcome == "approximate"
                            and r.suite == "rivals"))
    if not failed:
        return ("## Our own failures\n\nNone: every row of `signorini` and "
                "`closed-form` is right.\n\n")
    return "## Our own failures\n\n" + "".join(
        f"- {r.key}: {r.claim}, {r.outcome} {r.detail}\n"
        for r in failed) + "\n"


def drawn(table: Table, folder: Path) -> str:
    """The figures, or why there are none."""
    try:
        import report_figures as figures
    except ImportError as error:
        return f"No figures: {error}\n\n"
    return "## Figures\n\n" + "".join(
        f"![{caption}]({name})\n\n*{caption}*\n\n"
        for name, caption in figures.draw(table, folder))


def report(folder: Path) -> Path:
    """Write report.md for the rows of the last provenance in the table."""
    table = tables.read(folder / "results.csv")
    if not table:
        raise OSError(f"{folder / 'results.csv'}: holds no results")
    machine = table[-1].provenance
    table = where(table, lambda r: r.provenance == machine)
    words = folder / f"provenance-{machine}.txt"
    said = words.read_text(encoding="utf-8") if words.exists() else ""
    text = (
        f"# signorini-bench: report\n\nMade from `results.csv`, {len(table)} "
        f"rows of provenance {machine}.\n\n```\n{said}```\n\nTimes are medians"
        " of wall time on a machine that may be shared: ratios say more than "
        "digits. Every case ran in a process of its own, under the same "
        "limits.\n\n")
    text += overview(table) + our_failures(table) + drawn(table, folder)
    for part in (rivals, leaving_out, scaling, extremes, accuracy, lies):
        text += part(table)
    path = folder / "report.md"
    staged = folder / ".report.md.new"
    staged.write_text(text, encoding="utf-8")
    os.replace(staged, path)
    return path


def main(words: list[str]) -> int:
    """Return the exit status: 0, 2 usage error, 4 no such table."""
    if len(words) != 1:
        print(__doc__, file=sys.stderr)
        return 2
    try:
        print(f"report: {report(Path(words[0]))}")
    except OSError as error:
        print(f"report: {error}", file=sys.stderr)
        return 4
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
