"""Answers in a notebook: a table of what was asked and found, and a figure."""

from __future__ import annotations

import base64
import io
from collections.abc import Callable, Iterable, Iterator, Sequence
from html import escape
from typing import Any

from . import _core
from ._forced import Response, simulate
from ._question import Question
from ._tables import (Cell, Table, cells_of, cells_of_key, flat, frame_of,
                      is_record, keys_of, text_of)

#: What a status means; of a list, whether it is whole.
STATUS = {
    "found": "there is such a motion",
    "none": "it is proved that there is none",
    "undecided": "neither a motion nor a proof that there is none",
    "done": "followed to the end",
    "interrupted": "stopped before the end",
}
STATUS_OF_LIST = {"found": "the list is complete",
                  "undecided": "the list may lack motions"}

#: Keys of what was asked; others are the answer.
ASKED = {"bar", "stops", "segments", "static_force", "cells", "schedule",
         "question", "damping", "force", "amplitude", "cycles", "excitation",
         "over", "carried", "yield_stress", "band",
         "frequency_ratio_range", "strain_limit", "objective", "target",
         "max_order", "max_energy_ratio", "max_period_ratio", "phases"}

#: Said in the first line.
STATUS_LINE = ("status", "reason", "why", "detail")

#: Rows and columns of a list that are shown, letters of a text.
ROWS, COLUMNS, LETTERS = 10, 14, 300

STYLE = """<style>
.signorini {color: inherit; font-size: 0.9em}
.signorini div {overflow-x: auto}
.signorini table {border-collapse: collapse; margin: 0.4em 0; color: inherit}
.signorini tr, .signorini td, .signorini th
  {background: none !important; color: inherit}
.signorini td, .signorini th {padding: 0.1em 0.7em 0.1em 0; border: 0;
  text-align: left !important; vertical-align: top; font-weight: normal;
  white-space: nowrap}
.signorini td.value {white-space: normal; max-width: 45em}
.signorini .list .number {text-align: right !important;
  font-variant-numeric: tabular-nums}
.signorini .part th {font-weight: bold; padding-top: 0.5em;
  border-bottom: 1px solid rgba(128, 128, 128, 0.5)}
.signorini .unit {opacity: 0.7}
.signorini p {margin: 0.3em 0; padding-left: 0.6em;
  border-left: 4px solid rgba(128, 128, 128, 0.6)}
.signorini p.found, .signorini p.done {border-color: #2e8b57}
.signorini p.none {border-color: #c0504d}
.signorini p.undecided, .signorini p.interrupted {border-color: #d08a1d}
.signorini img {display: block; max-width: 100%; background: white}
</style>"""


def _is_number(value: Any) -> bool:
    return isinstance(value, (int, float)) and not isinstance(value, bool)


def _short(value: Any, longest: int) -> str:
    """The value as text, escaped."""
    text = "" if value is None else text_of(value)
    return escape(text if len(text) <= longest else text[:longest - 1] + "…")


def _unit(unit: str, said: dict[str, Any]) -> str:
    """The unit as people write it, where it depends on what was asked."""
    of = said.get("amplitude_of", said.get("force", ""))
    amplitude = {"tip": "N", "force": "N", "base": "m", "displacement": "m",
                 "velocity": "m/s", "acceleration": "m/s^2"}.get(of, "N or m")
    if unit in ("N or m", "N, m, m/s or m/s^2"):
        unit = amplitude
    elif unit.startswith("omega_1, N"):
        unit = {"frequency": "omega_1", "amplitude": amplitude, "gap": "m",
                "damping": ""}[said["over"]]
    return unit.replace("E_1", "E₁").replace("omega_1", "ω₁")


def _in_a_line(cells: Sequence[Cell]) -> str:
    """Cells of a record one after the other, with their units."""
    said = {cell.name: cell.value for cell in cells}
    return ", ".join(
        f"{cell.name} = {text_of(cell.value)} {_unit(cell.unit, said)}".rstrip()
        for cell in cells if cell.value not in (None, ""))


def _is_list_of_records(value: Any) -> bool:
    return isinstance(value, (list, Table)) and len(value) > 0 and all(
        is_record(row) for row in value)


def _lines(name: str, value: Any, said: str) -> Iterator[Cell]:
    """The lines for a key: none where there is no value, one for a record."""
    if value is None or value == []:
        return
    if is_record(value) and name != "physical":
        yield Cell(name, _in_a_line(list(cells_of(value))), "")
    else:
        for cell in cells_of_key(name, value, said):
            if cell.value is not None:
                yield cell


def _part(title: str, cells: Sequence[Cell], said: dict[str, Any]) -> str:
    """A heading and a row for each cell: name, value and unit."""
    if not cells:
        return ""
    rows = [f'<tr class="part"><th colspan="2">{title}</th></tr>'] * bool(title)
    rows += [f'<tr><th>{escape(cell.name)}</th>'
             f'<td class="value">{_short(cell.value, LETTERS)} <span class="unit">'
             f"{escape(_unit(cell.unit, said))}</span></td></tr>"
             for cell in cells]
    return "".join(rows)


def _columns(rows: Iterable[Sequence[Cell]]) -> dict[str, Cell]:
    """The first cell of each column that has one, of parts and scene none."""
    columns: dict[str, Cell] = {}
    for row in rows:
        is_answer = any(cell.name == "stops" for cell in row)
        for cell in row:
            if cell.value is not None and "." not in cell.name and not (
                    is_answer and cell.name in ASKED - {"schedule"}):
                columns.setdefault(cell.name, cell)
    return columns


def _list(name: str, rows: Sequence[Any], said: dict[str, Any]) -> str:
    """A table with a row for each of the first records."""
    shown = [list(cells_of(row)) for row in rows[:ROWS]]
    known = _columns(shown)
    columns = list(known.values())[:COLUMNS]
    title = f"{name}: {len(rows)}"
    if len(rows) > ROWS:
        title += f", the first {ROWS} of them"
    if len(known) > COLUMNS:
        title += f", {COLUMNS} of {len(known)} columns"
    kinds = ["number" if _is_number(cell.value) else "text" for cell in columns]

    def line(tag: str, texts: Iterable[str], more: str = "") -> str:
        return "<tr>" + "".join(
            f'<{tag} class="{kind}{more}">{text}</{tag}>'
            for kind, text in zip(kinds, texts)) + "</tr>"

    head = line("th", (escape(cell.name) for cell in columns))
    head += line("th", (escape(_unit(cell.unit, said)) for cell in columns),
                 " unit")
    body = ""
    for row in shown:
        held = {cell.name: cell.value for cell in row}
        body += line("td", (_short(held.get(cell.name), 40)
                            for cell in columns))
    return (f'<div><table class="list"><thead><tr class="part">'
            f'<th colspan="{max(len(columns), 1)}">{escape(title)}</th></tr>'
            f"{head}</thead><tbody>{body}</tbody></table></div>")


def _keys(record: Any) -> list[tuple[str, Any, str]]:
    """Keys of a record, or of a table: what it says beside its rows."""
    if not isinstance(record, Table):
        return list(keys_of(record))
    head = [(name, value, getattr(_core.ResponseData, name, None).__doc__ or "")
            for name, value in record._head.items() if name != "count"]
    return [*head, (record._name, list(record), "")]


def _sentence(record: Any, said: dict[str, Any]) -> str:
    """What it is and, of an answer, its status in words."""
    name = type(record).__name__
    if "status" not in said:
        of = f" of {record._name}" if isinstance(record, Table) else ""
        return f"<p><b>{escape(name + of)}</b></p>"
    status = said["status"]
    text = STATUS.get(status, "")
    if isinstance(record, Response):
        text = f"{STATUS_OF_LIST[status]}: {len(record.motions)} with one contact"
    if said.get("reason"):
        text += f" ({said['reason']})"
    text = "; ".join([text, *(said[key] for key in ("why", "detail")
                              if said.get(key))])
    return (f'<p class="{escape(status)}">{escape(name)}: '
            f"<b>{escape(status)}</b>, {escape(text)}</p>")


def _asked(said: dict[str, Any]) -> set[str]:
    """Keys of what was asked, where other answers have it, too."""
    asked = set(ASKED)
    if "amplitude_range" in said:  # of one schedule it may be what was found
        asked.discard("amplitude")
    if "band" in said:
        asked.add("contacts")
    return asked


def html(record: Any) -> str:
    """What a notebook shows of a record or a table."""
    keys = _keys(record)
    said = {name: value for name, value, _ in keys}
    is_answer = "status" in said or isinstance(record, Table)
    asked = _asked(said)
    parts: dict[bool, list[Cell]] = {True: [], False: []}
    lists = ""
    for name, value, doc in keys:
        if _is_list_of_records(value) and name != "stops":
            lists += _list(name, value, said)
        elif name not in STATUS_LINE or "status" not in said:
            parts[is_answer and name in asked].extend(_lines(name, value, doc))
    body = _part("asked", parts[True], said)
    body += _part("answer" if is_answer else "", parts[False], said)
    table = f"<div><table>{body}</table></div>" if body else ""
    drawn = png(record)
    image = "" if drawn is None else (
        '<img alt="figure" src="data:image/png;base64,'
        f'{base64.b64encode(drawn).decode()}">')
    return (f'{STYLE}<div class="signorini">{_sentence(record, said)}{table}'
            f"{lists}{image}</div>")


#: Which function of `signorini.plot` draws what, and how large [inches].
_DRAWN: dict[type, tuple[str, tuple[float, float]]] = {
    _core.Result: ("motion", (9, 7)),
    Question: ("motion", (9, 7)),  # the first of them
    _core.Motion: ("motion", (9, 7)),
    _core.ContinuumPoint: ("motion", (9, 7)),
    _core.Continuum: ("continuum", (9, 7)),
    _core.SceneContinuumPoint: ("motion", (8, 5)),
    _core.SceneContinuum: ("continuum", (9, 7)),
    _core.Simulation: ("simulation", (8, 5)),
    _core.Sweep: ("sweep", (8, 6)),
    Response: ("response", (8, 6)),
    _core.ExactResponse: ("response", (8, 6)),
    _core.SceneResponse: ("response", (8, 6)),
    _core.ForcedResult: ("motion", (9, 7)),
    _core.HarmonicResult: ("motion", (8, 6)),
    _core.SceneResult: ("motion", (8, 5)),
    _core.SceneForcedResult: ("motion", (8, 5)),
    _core.SceneHarmonicResult: ("motion", (8, 5)),
    _core.SceneQuestion: ("scene", (8, 2.5)),
    _core.SceneSimulation: ("simulation", (8, 5)),
    _core.ModeMotion: ("simulation", (8, 5)),
    _core.PolytopeMotion: ("simulation", (8, 5)),
    _core.Mode: ("frequency_energy", (8, 5)),
    _core.Scene: ("scene", (8, 2.5)),
    _core.ForceRange: ("scene", (8, 2.5)),
}

#: The same of tables, by what a row is.
_DRAWN_BY_ROW: dict[type, tuple[str, tuple[float, float]]] = {
    _core.Family: ("families", (9, 6.5)),
    _core.Mode: ("frequency_energy", (9, 6)),
    _core.ModePolytope: ("polytopes", (8, 9.5)),
    _core.StudyPoint: ("study", (7, 5)),
}


def _walked(record: Any) -> _core.Simulation:
    """Two periods of a motion that is known by its state, followed from there."""
    return simulate(record.state(300), time=2.0 * record.period)


def _points_of(mode: _core.Mode) -> list[tuple[float, float]]:
    """(omega/omega_1, E/E_1) along its curve, as far up as the figure goes."""
    (p, q), (r, s) = mode.period_range
    periods = [p / q + k / 40 * (r / s - p / q) for k in range(1, 40)]
    points = [(4.0 / period, mode.energy_ratio(period)) for period in periods]
    return [point for point in points if point[1] < 50.0]


def _draw(name: str, record: Any, figure: Any) -> None:
    from . import plot
    if name == "frequency_energy":
        points = _points_of(record) if isinstance(record, _core.Mode) else []
        plot.frequency_energy(figure=figure, data=points or None, data_label="this mode")
    elif name == "simulation" and not isinstance(
            record, (_core.Simulation, _core.SceneSimulation)):
        plot.simulation(_walked(record), figure=figure)
    else:
        getattr(plot, name)(record[0] if isinstance(record, Question) else record, figure=figure)


#: What was drawn last: a notebook asks for the table and for the figure.
_last: list[tuple[Any, bytes]] = []


def png(record: Any) -> bytes | None:
    """A figure as a file, None where there is none to draw.

    It is not one of pyplot's: what a user draws there stays as it is.
    """
    how = _DRAWN.get(type(record))
    if type(record) is Table and len(record) > 0:
        how = _DRAWN_BY_ROW.get(type(record[0]))
    if how is None or (
            isinstance(record, (Question, _core.SceneQuestion)) and not record):
        return None
    for known, drawn in _last:
        if known is record:
            return drawn
    try:
        from matplotlib.figure import Figure

        from .plot._style import NothingToDraw
    except ImportError:
        return None
    name, size = how
    figure = Figure(figsize=size, layout="constrained")
    try:
        _draw(name, record, figure)
    except NothingToDraw:
        return None
    if not any(hasattr(axes, "get_subplotspec") and axes.get_subplotspec()
               for axes in figure.axes):
        figure.set_layout_engine("none")  # all have their places
    file = io.BytesIO()
    figure.savefig(file, format="png", dpi=80)
    _last[:] = [(record, file.getvalue())]
    return file.getvalue()


def _found(answer: Any) -> bool:
    """Was a motion found?"""
    if isinstance(answer, Response):  # it is found when the list is whole
        return any(at.motions or at.permanent_contact for at in answer)
    return bool(answer.status == "found")


def _frame_of(name: str) -> Callable[[Any], Any]:
    def frame(self: Any) -> Any:
        return frame_of(map(flat, getattr(self, name)))
    frame.__doc__ = f"Return a pandas DataFrame, a row for each of `{name}`."
    return frame


def _contacts(run: Any) -> Any:
    """Return a pandas DataFrame, a row for each contact that is over."""
    names = [name for name in dir(run) if name.startswith("contact_")]
    columns = zip(*(getattr(run, name) for name in names))
    return frame_of(dict(zip((name[len("contact_"):] for name in names), row))
                    for row in columns)


def _set(kind: Any, name: str, value: Any) -> None:
    setattr(kind, name, value)


def be_at_home() -> None:
    """Give the compiled classes and tables what a notebook asks for."""
    kinds = [kind for kind in vars(_core).values()
             if isinstance(kind, type) and hasattr(kind, "_keys")]
    for kind in (*kinds, _core.Motion, Table):
        _set(kind, "_repr_html_", html)
    for kind in (*_DRAWN, Table):
        _set(kind, "_repr_png_", png)
    for kind in (Question, Response):
        _set(kind, "found", property(_found))
        _set(kind, "__bool__", _found)
    for kind, rows in ((_core.Continuum, "points"), (_core.SceneContinuum, "points"),
                       (_core.Sweep, "points"),
                       (_core.ExactResponse, "frequencies"),
                       (_core.SceneResponse, "frequencies"),
                       (_core.ForcedResult, "motions"),
                       (_core.HarmonicResult, "motions"),
                       (_core.SceneForcedResult, "motions"),
                       (_core.SceneHarmonicResult, "motions"), (_core.SceneQuestion, "sets")):
        _set(kind, "frame", _frame_of(rows))
    for kind in (_core.Simulation, _core.SceneSimulation):
        _set(kind, "frame", _contacts)
