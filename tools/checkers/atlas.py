"""That an atlas holds every schedule of its ranges that has motions, and no other."""
import collections
import itertools
import math
import pathlib
import re
import sqlite3
from fractions import Fraction

from .atlas_bars import check_bars
from .reading import NoProof, close, integer, multiplier, number, shown
from .scene import MOST_CELLS, Scene
from .schedules import each_once
from .segments import JointRows
from .verdicts import EXACT, SteppedVerdict, Verdict

MOST_ROWS = 10 ** 6
MOST_SCHEDULES = {1: 10 ** 6, 2: 10 ** 5}  # of one phase: ten minutes; of several: one or two
MOST_WORK = 2 * 10 ** 9  # schedules times steps
# All that an atlas holds, and no more: what nobody reads might say anything.
COLUMNS = {
    "runs": ("id version options cells max_contact max_free phases max_energy_ratio keeps_refuted families_only "
             "gap_sign segments second_stop batches next_batch decided pressing grazing refuted undecided families "
             "started finished seconds workers"),
    "schedules": ("cells phases steps period frequency_ratio status reason kernel_dimension kind dimension contact "
                  "canonical energy_ratio_min energy_ratio_max family proof"),
    "families": ("id cells family_order nu contact_blocks phases steps period frequency_ratio contact kind dimension "
                 "energy_ratio_min energy_ratio_max schedules"),
}
RANGE = ("cells", "max_contact", "max_free", "phases", "max_energy_ratio", "keeps_refuted", "families_only")
INDICES = ("schedules_without_family", "one_run_per_range")


def phases_of(text):
    """"nc:nf[,nc:nf...]" as triples (n_c, n_f, is it on the second stop), which begin "L:"."""
    phases = []
    for phase in text.split(","):
        is_left = phase.startswith("L:")
        try:
            contact, free = (int(steps) for steps in phase[2 * is_left:].split(":"))
        except ValueError:
            raise NoProof(f"{text!r} is no schedule") from None
        phases.append((contact, free, is_left))
    if any(min(phase[:2]) < 1 for phase in phases):
        raise NoProof(f"{text!r} is no schedule")
    return phases


def text_of(phases):
    return ",".join(f"{'L:' if is_left else ''}{contact}:{free}" for contact, free, is_left in phases)


def is_of_bars(run):
    """Is it about bars in a row, not one bar?"""
    return ";" in str(run["segments"])


def segments_of(run):
    """"cells:impedance:speed:dashpot[,...]", clamp first; nothing of one bar."""
    segments = []
    if is_of_bars(run):
        return segments
    for segment in str(run["segments"]).split(",") if run["segments"] else []:
        if not re.fullmatch("[0-9]{1,9}(:[-+.e0-9]+){3}", segment):
            raise NoProof(f"{shown(segment)} is no segment")
        cells, *others = segment.split(":")
        segments.append({"cells": int(cells), **dict(zip(("impedance", "speed", "dashpot"), map(float, others)))})
    return segments


def stops_of(run):
    """Where the tip is stopped, in |g|, or in L without a gap."""
    where = {"right": run["gap_sign"]}
    if run["second_stop"] is not None:
        where["left"] = -Fraction(multiplier(run["second_stop"], "second_stop"))
        if not where["left"] < min(0, where["right"]):
            raise NoProof(f"run {run['id']}: a second stop {shown(run['second_stop'])} above the first")
    return where


class Range:
    """A run of the program: what it was to decide."""

    def __init__(self, run):
        self.run, self.id = run, run["id"]
        for name in ("id", "cells", "max_contact", "max_free", "phases", "gap_sign", "keeps_refuted", "families_only",
                     "batches", "next_batch", "decided", "pressing", "grazing", "refuted", "undecided", "families"):
            integer(run[name], name)
        if min(run["cells"], run["max_contact"], run["max_free"], run["phases"], run["batches"]) < 1 or \
                abs(run["gap_sign"]) > 1 or run["cells"] > MOST_CELLS or \
                {run["keeps_refuted"], run["families_only"]} - {0, 1} or run["phases"] > 8:
            raise NoProof(f"run {self.id}: no range")
        if run["finished"] is None or run["next_batch"] != run["batches"]:
            raise NoProof(f"run {self.id} is not finished")
        self.cells, self.where, self.segments = run["cells"], stops_of(run), segments_of(run)
        self.limit = math.inf if run["max_energy_ratio"] is None else \
            number(run["max_energy_ratio"], "max_energy_ratio")
        self.require_small()

    def require_small(self):
        """Of what is decided in minutes."""
        run = self.run
        phases = run["max_contact"] * run["max_free"] * len(self.where)
        count = sum(phases ** k for k in range(1, run["phases"] + 1))
        steps = min((run["max_contact"] + run["max_free"]) * run["phases"], 6 * self.cells * run["phases"])
        if count > MOST_SCHEDULES[min(run["phases"], 2)] or count * steps > MOST_WORK or \
                (self.segments and count * steps * self.cells > MOST_WORK / 200):
            raise NoProof(f"run {self.id}: {shown(count)} schedules are more than this checker decides")

    def schedules(self):
        """All, each once."""
        return each_once(self.run, (False, True) if "left" in self.where else (False,))

    def scene(self, phases):
        """A schedule of several segments as certificates are about."""
        return Scene({"cells": self.cells, "segments": self.segments, "bar": {"length": 1, "gap": self.where["right"]},
                      "schedule": [list(phase[:2]) for phase in phases],
                      "stops": [{"side": "right", "place": self.where["right"]}]})

    def decide(self, phases):
        """A schedule, here."""
        if not self.segments or self.scene(phases).is_uniform():
            return Verdict(self.cells, phases, self.where)
        if list(self.where.values()) not in ([1], [-1]):
            raise NoProof(f"run {self.id}: segments with a second stop, or without a gap, are not known to "
                          "this checker")
        scene = self.scene(phases)
        return SteppedVerdict(JointRows(scene), scene)

    def scene_key(self):
        """What its verdicts depend on."""
        return self.cells, tuple(sorted(self.where.items())), self.run["segments"]

    def keeps(self, verdict):
        """Is its least energy low enough?"""
        return verdict.least is None or verdict.least * (1 + verdict.accuracy) <= self.limit

    def text(self):
        """What it holds, in words."""
        run = self.run
        stop = f", second stop at {self.where['left']}" if "left" in self.where else ""
        parts = f" of segments {run['segments']}" if self.segments else ""
        limit = "" if self.limit == math.inf else f", up to {self.limit!r} E_1"
        return (f"N = {self.cells}{parts}, gap {self.where['right']}{stop}, up to {run['phases']} phases of "
                f"{run['max_contact']} {run['max_free']}{limit}")


class Rows:
    """The tables of a database, and what was decided of their rows here."""

    def __init__(self, base, decided=None):
        self.base, self.decided = base, {} if decided is None else decided  # by range and schedule
        self.require_tables()
        self.runs = [Range(run) for run in self.all("runs")]
        if not self.runs:
            raise NoProof("no run")
        first = self.runs[0].run
        if len({run.id for run in self.runs}) < len(self.runs) or \
                len({tuple(run.run[name] for name in RANGE) for run in self.runs}) < len(self.runs):
            raise NoProof("runs: two of one range")
        for found in self.runs:
            if any(found.run[name] != first[name] for name in ("gap_sign", "segments", "second_stop")):
                raise NoProof("runs are about more than one bar")
        self.schedules = self.by_name("schedules")
        self.families = self.by_name("families")
        self.names = {row["id"]: key for key, row in self.families.items()}
        self.verdicts = {}
        self.members = collections.Counter()  # of each family, as many as the largest run has
        self.unknown = collections.Counter()

    def require_tables(self):
        """Tables as the program makes them: no view, no trigger, no other column."""
        for kind, name in self.base.execute("SELECT type, name FROM sqlite_master").fetchall():
            if not ((kind == "table" and name in COLUMNS) or
                    (kind == "index" and (name in INDICES or str(name).startswith("sqlite_autoindex_")))):
                raise NoProof(f"{shown(kind)} {shown(name)}: not known to this checker")
        for name, columns in COLUMNS.items():
            found = [row["name"] for row in self.base.execute(f"PRAGMA table_info({name})")]
            if sorted(found) != sorted(columns.split()):
                raise NoProof(f"table {name}: its columns are not those of an atlas")

    def all(self, table):
        """Its rows."""
        rows = self.base.execute(f"SELECT * FROM {table} ORDER BY rowid LIMIT {MOST_ROWS + 1}").fetchall()
        if len(rows) > MOST_ROWS:
            raise NoProof(f"table {table}: this checker reads up to {MOST_ROWS} rows")
        return rows

    def by_name(self, table):
        """Its rows, by cells and schedule, each once."""
        rows = self.all(table)
        found = {(row["cells"], row["phases"]): row for row in rows}
        if len(found) < len(rows):
            raise NoProof(f"table {table}: two rows about one schedule")
        return found

    def verdict(self, run, phases):
        """What a schedule is, decided once."""
        key = run.scene_key(), text_of(phases)
        if key not in self.decided:
            self.decided[key] = run.decide(phases)
        return self.decided[key]

    def check(self):
        """All of it, in words."""
        if is_of_bars(self.runs[0].run):
            if self.families or any(found.run["families_only"] for found in self.runs):
                raise NoProof("families of bars in a row")
            return check_bars([found.run for found in self.runs], self.schedules)
        checked = "; ".join(self.check_run(run) for run in self.runs)
        self.check_families()
        self.check_known()
        besides = [f"{what} ({count} rows)" for what, count in sorted(self.unknown.items())]
        return f"{checked} (not checked: {', '.join(besides + ['who made the runs, when, with which words'])})"

    def check_run(self, run):
        """Every schedule of one range; in words."""
        if run.run["families_only"] and run.run["phases"] > 1:
            raise NoProof(f"run {run.id}: families of several phases")
        seen, families, members = collections.Counter(), set(), collections.Counter()
        for phases in run.schedules():
            key = run.cells, text_of(phases)
            self.verdicts[key] = self.verdict(run, phases)
            verdict, row = self.verdicts[key], self.schedules.get(key)
            status = "found" if verdict.exists else "none"
            if row is not None:
                if verdict.exists and all(one.run["families_only"] for one in self.runs):
                    raise NoProof(f"{key[1]} is there, and every run kept families only")
                status = check_row(row, verdict, self)
            elif verdict.exists and run.keeps(verdict) and not run.run["families_only"]:
                raise NoProof(f"{key[1]} has motions, and is not there")
            elif not verdict.exists and run.run["keeps_refuted"]:
                raise NoProof(f"{key[1]} is not there")
            seen[status] += 1
            seen[row["contact"] if status == "near" else verdict.contact if status == "found" else None] += 1
            if verdict.family:
                families.add(verdict.family)
                if run.keeps(verdict):
                    members[verdict.family] += 1
        for family, count in members.items():
            self.members[run.cells, family] = max(self.members[run.cells, family], count)
        counted = {"decided": sum(seen[status] for status in ("found", "near", "none", "undecided")),
                   "refuted": seen["none"], "undecided": seen["undecided"], "pressing": seen["pressing"],
                   "grazing": seen["grazing"], "families": len(families)}
        for key, value in counted.items():
            if run.run[key] != value:
                raise NoProof(f"run {run.id}: {key} is {run.run[key]}, not {value}")
        return f"{run.text()}: {counted['decided']} schedules, {seen['found'] + seen['near']} have motions" + \
            (f", {seen['near']} of them only within 1e-7" if seen["near"] else "") + \
            (f", {seen['undecided']} undecided" if seen["undecided"] else "")

    def check_families(self):
        """Those of the ranges with an energy to keep, each once, and no other."""
        wanted = {}
        for (cells, (triple, top, steps)), count in self.members.items():
            wanted[cells, text_of([(*top, False)])] = (triple, top, steps, count)
        for key in self.families:
            if key not in wanted:
                raise NoProof(f"families: {shown(key[1])} of {shown(key[0])} cells is in no range")
        ranges = {run.cells: run for run in self.runs}
        for key, (triple, top, steps, count) in wanted.items():
            row = self.families.get(key)
            if row is None:
                raise NoProof(f"families: {key[1]} of {key[0]} cells is not there")
            verdict = self.verdict(ranges[key[0]], ((*top, False),))
            for name, value in zip(("family_order", "nu", "contact_blocks", "steps", "contact", "kind", "dimension",
                                    "schedules"), (*triple, steps, verdict.contact, verdict.kind, verdict.dimension,
                                                   count)):
                require_same(row, name, value)
            check_numbers(row, verdict, steps)

    def check_known(self):
        """No row is about a schedule of no range, or says "none" where no run keeps such."""
        keeps = {run.cells for run in self.runs if run.run["keeps_refuted"]}
        for (cells, phases), row in self.schedules.items():
            if (cells, phases) not in self.verdicts or (row["status"] == "none" and cells not in keeps):
                raise NoProof(f"{shown(phases)} of {shown(cells)} cells is in no range")


def require_same(row, key, *values):
    """A value of a row, one of these and of its kind."""
    if not any(row[key] == value and type(row[key]) is type(value) for value in values):
        raise NoProof(f"{row['phases']}: {key} is {shown(row[key])}, not {values[0]!r}")


def require_near(row, key, exact, accuracy=EXACT):
    """The same of a number that was rounded; nothing stands for no end."""
    if exact == math.inf:
        if row[key] not in (None, math.inf):
            raise NoProof(f"{row['phases']}: {key} is {shown(row[key])}, and has no end")
    elif not close(row[key], exact, accuracy):
        raise NoProof(f"{row['phases']}: {key} is {shown(row[key])}, not {float(exact)!r}")


def check_numbers(row, verdict, steps):
    """Period, frequency and energies of a row of a table."""
    require_near(row, "period", Fraction(steps, row["cells"]))
    require_near(row, "frequency_ratio", Fraction(4 * row["cells"], steps))
    require_near(row, "energy_ratio_min", verdict.least, verdict.accuracy)
    if verdict.most is not None:
        require_near(row, "energy_ratio_max", verdict.most, verdict.accuracy)
    elif verdict.is_stepped:  # nothing is said
        require_same(row, "energy_ratio_max", None)


def claim(row, verdict):
    """The status of a row if it may say so; "near" for what the program may take for a motion."""
    status = row["status"]
    if status == ("found" if verdict.exists else "none") or \
            (verdict.is_stepped and status == "undecided"):
        return status
    if verdict.is_stepped and status == "found" and verdict.is_near():
        return "near"
    raise NoProof(f"{row['phases']}: status is {shown(status)}, and it has {'' if verdict.exists else 'no '}motions")


def check_row(row, verdict, rows):
    """One row of the database against what was decided here; its status."""
    status = claim(row, verdict)
    require_same(row, "kernel_dimension", verdict.kernel, *([None] if verdict.is_stepped else []))
    if row["reason"] not in (verdict.reasons if status == "none" else {None}):
        raise NoProof(f"{row['phases']}: {shown(row['reason'])} is not the reason")
    require_same(row, "steps", verdict.steps)
    require_near(row, "period", Fraction(verdict.steps, row["cells"]))
    require_near(row, "frequency_ratio", Fraction(4 * row["cells"], verdict.steps))
    if status in ("none", "undecided"):
        for key in ("kind", "dimension", "contact", "canonical", "energy_ratio_min", "energy_ratio_max", "family"):
            require_same(row, key, None)
    elif status == "found":
        check_numbers(row, verdict, verdict.steps)
    if status == "found":
        for key in ("contact",) if verdict.is_stepped else ("contact", "kind", "dimension", "canonical"):
            require_same(row, key, getattr(verdict, key))
    if verdict.unknown:
        rows.unknown["energy_ratio_max where a bound depends on sums"] += 1
    elif status == "near":
        rows.unknown["what is only within 1e-7"] += 1
    elif verdict.is_stepped and status == "found":
        rows.unknown["kind, dimension and canonical of several segments"] += 1
    check_family(row, verdict, rows, status)
    if verdict.is_stepped and status == "none" and row["proof"] is not None:
        verdict.check_proof(row["proof"])
    elif row["proof"] is not None:
        raise NoProof(f"{row['phases']}: a proof that nobody reads")
    return status


def check_family(row, verdict, rows, status):
    """Does it name the row of its family?"""
    wanted = None
    if verdict.family and status == "found":
        wanted = row["cells"], text_of([(*verdict.family[1], False)])
    if rows.names.get(row["family"]) != wanted or (wanted is None and row["family"] is not None):
        raise NoProof(f"{row['phases']}: family {shown(row['family'])} is not its family")


def check(name):
    """What an atlas holds, in a sentence."""
    base = sqlite3.connect(pathlib.Path(name).resolve().as_uri() + "?mode=ro", uri=True)
    base.row_factory = sqlite3.Row
    budget = itertools.count()
    base.set_progress_handler(lambda: next(budget) > 10 ** 4, 10 ** 5)  # steps of SQLite: some seconds
    try:
        return Rows(base).check()
    finally:
        base.close()
