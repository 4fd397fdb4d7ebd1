"""The figures of the report, by matplotlib."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import matplotlib
import report_table as tables
from report_table import Record, Table, distinct, total_seconds, where

matplotlib.use("Agg")
from matplotlib import pyplot  # noqa: E402

#: One colour and one marker for one solver, on every figure: a colour of
#: Okabe and Ito for each library, a marker for each of its methods.
STYLES = {
    "signorini": ("#000000", "o"), "closed-form": ("#000000", "D"),
    "glpk-simplex": ("#0072b2", "s"), "glpk-interior": ("#0072b2", "^"),
    "glpk-exact": ("#0072b2", "v"), "clp-simplex": ("#009e73", "P"),
    "clp-primal": ("#009e73", "<"), "clp-barrier": ("#009e73", ">"),
    "ipopt": ("#d55e00", "X"), "nlopt-slsqp": ("#cc79a7", "d"),
    "nlopt-auglag": ("#cc79a7", "h"), "nlopt-cobyla": ("#cc79a7", "*"),
    "characteristics": ("#0072b2", "p"), "Moreau-Jean": ("#777777", "x"),
    "Newmark, penalty": ("#d55e00", "H"),
    "damped Newmark, penalty": ("#cc79a7", "+"),
    "mass redistribution": ("#009e73", "1"),
    "CVODE, penalty": ("#e69f00", "4"),
    "march from rest": ("#56b4e9", "8"),
}

#: From dark to light, for what is no solver: sizes, operations.
SHADES = ("#440154", "#3b528b", "#21918c", "#5ec962", "#b5a200")

#: An error of 0 cannot be drawn on a logarithmic axis.
SMALLEST = 1e-17


def style_of(solver: str) -> dict[str, Any]:
    """How a solver looks."""
    colour, marker = STYLES.get(solver, ("#777777", "."))
    return {"color": colour, "marker": marker, "ms": 5.5, "lw": 1.3,
            "label": solver}


def _finish(figure: Any, path: Path) -> None:
    figure.savefig(path, dpi=130, bbox_inches="tight")
    pyplot.close(figure)


def _figure(columns: int, width: float, height: float
            ) -> tuple[Any, list[Any]]:
    figure, axes = pyplot.subplots(1, columns, squeeze=False,
                                   figsize=(width * columns, height),
                                   layout="constrained")
    for each in axes[0]:
        each.grid(color="#dddddd", lw=0.5)
        each.set_axisbelow(True)
    return figure, list(axes[0])


def _at_least_a_decade(axes: Any) -> None:
    """Widen a narrow range of times, whose labels would lie on each other."""
    low, high = axes.get_xlim()
    if high < 10.0 * low:
        middle = math.sqrt(low * high)
        axes.set_xlim(middle / math.sqrt(10.0), middle * math.sqrt(10.0))


def _one_legend(figure: Any, panels: list[Any]) -> None:
    """All solvers of all panels once, below them."""
    entries = {}
    for axes in panels:
        handles, labels = axes.get_legend_handles_labels()
        entries.update(zip(labels, handles))
    figure.legend(entries.values(), entries.keys(), ncols=6,
                  loc="upper center", bbox_to_anchor=(0.5, 0.0),
                  fontsize="small")


def _headline_cells(table: Table) -> float:
    """The grid that figures are about: 300 cells if they were measured."""
    cells = [r.figure("cells") for r in table]
    return 300.0 if 300.0 in cells else max(cells, default=math.nan)


def work_precision(table: Table, path: Path) -> str:
    """Error against time."""
    figure, panels = _figure(3, 4.2, 4.6)
    for axes, (what, title) in zip(panels, (
            ("any", "any motion"), ("least energy", "least energy"),
            ("energy 20", "energy 20 E$_1$"))):
        rows = where(table, lambda r: r.suite == "accuracy"
                     and r.case.startswith("A ")
                     and r.setting.startswith(what))
        cells = _headline_cells(rows)
        rows = where(rows, lambda r: r.figure("cells") == cells and r.is_claim
                     and r.outcome != "wrong"
                     and (r.formulation == "sy" or r.is_ours))
        for who in distinct(r.back_end for r in rows):
            points = [(r.figure("seconds_median"),
                       max(r.figure("error"), SMALLEST))
                      for r in rows if r.back_end == who
                      and not math.isnan(r.figure("error"))]
            axes.loglog(*zip(*points), **style_of(who)) if points else None
        axes.set_title(f"{title}, N = {cells:.0f}", fontsize="medium")
        axes.set_xlabel("time [s]")
        axes.set_ylim(SMALLEST / 3, 1)
    panels[0].set_ylabel("error (0 is drawn at $10^{-17}$)")
    _one_legend(figure, panels)
    _finish(figure, path)
    return ("Error against time, one point per tolerance 1e-3 ... 1e-12, in "
            "the paper's unknowns (sy); wrong claims are not drawn")


def scenes(table: Table, path: Path) -> str:
    """Error of least energy against time, beyond the paper's scene."""
    figure, panels = _figure(3, 4.2, 4.6)
    for axes, (suite, family, title) in zip(panels, (
            ("accuracy", "D ", "D, g < 0"), ("accuracy", "E ", "E, two stops"),
            ("stepped", "F N", "F, stepped"))):
        rows = where(table, lambda r: r.suite == suite
                     and r.case.startswith(family)
                     and r.setting.startswith(("least energy", "min-energy"))
                     and r.outcome in ("right", "inaccurate")
                     and not math.isnan(r.figure("error"))
                     and (r.is_ours or r.formulation
                          in ("reduced", "kernel", "joints")))
        cells = _headline_cells(rows)
        rows = where(rows, lambda r: r.figure("cells") == cells)
        for who, form in dict.fromkeys((r.back_end, r.formulation) for r in rows):
            mine = where(rows, lambda r: (r.back_end, r.formulation)
                         == (who, form))
            look = style_of(who)
            if form in ("kernel", "joints"):
                look.update(label=f"{who}, {form}",
                            ls="-" if form == "kernel" else "--")
            axes.loglog(*zip(*((r.figure("seconds_median"),
                                max(r.figure("error"), SMALLEST))
                               for r in mine)), **look)
        axes.set_title(f"{title}, N = {cells:.0f}", fontsize="medium")
        axes.set_xlabel("time [s]")
        axes.set_ylim(SMALLEST / 3, 1e-9)
        _at_least_a_decade(axes)
    panels[0].set_ylabel("error (0 is drawn at $10^{-17}$)")
    _one_legend(figure, panels)
    _finish(figure, path)
    return ("Error of the motion of least energy against time in amplitudes "
            "(D, E) and in kernel and joints (F), one point per tolerance")


def performance_profile(table: Table, path: Path) -> str:
    """Share of cases done right against time."""
    figure, panels = _figure(2, 5.2, 4.8)
    for axes, (form, title) in zip(panels, (
            ("sy", "a, b and prefix sums (sy)"),
            ("reduced", "amplitudes (reduced)"))):
        rows = where(table, lambda r: r.suite == "accuracy"
                     and r.setting == "any 1e-06" and r.was_tried
                     and (r.formulation == form
                          or r.back_end == "signorini"))
        curves = tables.profiles(rows)
        far = max([10.0, *(points[-1][0] for points in curves.values()
                           if points)])
        for who, points in curves.items():
            xs = [0.8, *(factor for factor, _ in points), 2 * far]
            ys = [0.0, *(share for _, share in points)]
            axes.step(xs, [*ys, ys[-1]], where="post", markevery=0.1,
                      **style_of(who))
        axes.set_xscale("log")
        axes.set_ylim(0, 1.02)
        axes.set_title(title, fontsize="medium")
        axes.set_xlabel("time over the best time of any")
    panels[0].set_ylabel("share of the cases done right")
    _one_legend(figure, panels)
    _finish(figure, path)
    return ("Share of the existence problems (families and random schedules) "
            "done right within a multiple of the best time; a failure takes "
            "for ever")


def scaling_label(r: Record) -> str:
    """What a row of the scaling suite measures."""
    return r.setting if r.back_end == "signorini" else \
        f"{r.back_end}, {r.formulation}"


def scaling(table: Table, path: Path) -> str:
    """Time against the number of cells."""
    figure, panels = _figure(2, 6.4, 4.6)
    for axes, ours in zip(panels, (True, False)):
        rows = where(table, lambda r: r.suite == "scaling"
                     and (r.back_end == "signorini") == ours
                     and r.outcome in ("right", "reference"))
        for k, label in enumerate(distinct(map(scaling_label, rows))):
            mine = where(rows, lambda r: scaling_label(r) == label)
            points = [(r.figure("cells"), r.figure("seconds_median"))
                      for r in mine]
            exponent = tables.power_law(points)
            name = label if math.isnan(exponent) else \
                f"{label}: $N^{{{round(exponent, 2) + 0.0:.2f}}}$"
            look = style_of(mine[0].back_end)
            look["label"] = name
            if ours:  # operations of one solver: a shade and a dash for each
                look.update(color=SHADES[k % len(SHADES)],
                            ls=("-", "--", ":", "-.")[k // len(SHADES) % 4])
            else:
                forms = distinct(r.formulation for r in rows)
                look["ls"] = ("-", "--", ":", "-.")[
                    forms.index(mine[0].formulation) % 4]
            axes.loglog(*zip(*points), **look)
        axes.set_title("the library" if ours else "programs, family A",
                       fontsize="medium")
        axes.set_xlabel("cells N")
        axes.set_ylabel("time [s]")
        if rows:
            axes.legend(fontsize="x-small", loc="upper left",
                        bbox_to_anchor=(1.0, 1.0))
    _finish(figure, path)
    return "Time against the number of cells, with fitted exponents"


def leaving_out(table: Table, path: Path) -> str:
    """Bars: time of each program, for two solvers."""
    rows = where(table, lambda r: r.suite == "leaving-out"
                 and r.case.startswith("A ") and r.back_end != "signorini")
    cases = distinct(r.case for r in rows)
    forms = distinct(r.formulation for r in rows)
    figure, panels = _figure(2, 6.2, 4.2)
    for axes, solver in zip(panels, ("glpk-simplex", "clp-simplex")):
        for k, case in enumerate(cases):
            wide = 0.85 / len(cases)
            for at, form in enumerate(forms):
                times = [total_seconds(r) for r in rows if r.case == case
                         and r.formulation == form and r.outcome == "right"
                         and r.back_end in (solver, "closed-form")]
                if times:
                    axes.bar(at + (k + 0.5) * wide - 0.425, times[-1], wide,
                             color=SHADES[k % len(SHADES)], edgecolor="black",
                             lw=0.5, label=case if at == 0 else None)
        axes.set_yscale("log")
        axes.set_xticks(range(len(forms)),
                        ["closed form" if f == "-" else f for f in forms],
                        rotation=30)
        axes.set_title(solver, fontsize="medium")
        axes.set_ylabel("time to pose and solve [s]")
        axes.legend(fontsize="small", loc="upper left")
    _finish(figure, path)
    return ("Time to pose and solve the same request, existence, with more "
            "and more of what the library leaves out; missing bars were ended "
            "by a limit")


RIVALS = ("characteristics", "Newmark, penalty", "damped Newmark, penalty",
          "Moreau-Jean", "mass redistribution", "CVODE, penalty", "signorini")


def rivals(table: Table, path: Path) -> str:
    """Error of the tip against time."""
    marches = where(table, lambda r: r.suite == "rivals"
                    and not math.isnan(r.figure("tip_error")))
    figure, panels = _figure(4, 3.3, 4.2)
    for axes, case in zip(panels, distinct(r.case for r in marches)):
        for who in RIVALS:
            points = [(r.figure("seconds_median"),
                       max(r.figure("tip_error"), SMALLEST))
                      for r in marches if r.case == case
                      and r.back_end == who]
            if points:
                axes.loglog(*zip(*points), **style_of(who))
        axes.set_ylim(SMALLEST / 3, 3)
        axes.set_title(case, fontsize="medium")
        axes.set_xlabel("processor time for 100 periods [s]")
    panels[0].set_ylabel("tip error, r.m.s. of 5 periods, of its reach [-]")
    _one_legend(figure, panels)
    _finish(figure, path)
    return ("Error of the tip displacement against time, one point per number "
            "of elements; ours event by event")


def draw(table: Table, folder: Path) -> list[tuple[str, str]]:
    """Draw what the table has data for: [(file, caption), ...]."""
    def has(suite: str) -> bool:
        return any(r.suite == suite and r.outcome == "right" for r in table)

    programs = any(r.suite == "leaving-out" and r.case.startswith("A ")
                   and r.formulation == "lumped" and r.outcome == "right"
                   for r in table)
    wanted = [(has("accuracy"), work_precision),
              (has("accuracy"), performance_profile),
              (has("scaling"), scaling), (programs, leaving_out),
              (has("rivals"), rivals), (has("stepped"), scenes)]
    drawn = []
    for is_wanted, function in wanted:
        if is_wanted:
            name = function.__name__ + ".png"
            drawn.append((name, function(table, folder / name)))
    return drawn
