"""The bar, its stops and the schedule of an answer: what a proof is about."""
from collections import namedtuple
from fractions import Fraction

from .reading import NoProof, close, integer, number, require_keys, shown, simplest

MOST_CELLS = 10 ** 6
MOST_STEPS = 10 ** 9  # of a phase; what repeats is cut off before anything is done with them
MOST_PHASES = 1000
MOST_WORK = 10 ** 6  # cells times phases
ASKED = ("status", "cells", "schedule", "bar", "stops", "segments", "certificate")
# Who found the answer, and what else is said of it: named, not proved.
BESIDES = ("schema", "version", "detail", "reason", "route", "route_reason", "left_out", "solver", "near_schedule",
           "kernel_dimension", "solution_set", "family")
DERIVED = ("period", "period_ratio", "frequency_ratio", "static_force")

Segment = namedtuple("Segment", "cells impedance speed dashpot")


def positive(found, key, what):
    """A number above 0."""
    value = number(found[key], f"{what}: {key}")
    if not value > 0:
        raise NoProof(f"{what}: {key}: allowed above 0")
    return value


def listed(value, what):
    """A list of the file."""
    if not isinstance(value, list):
        raise NoProof(f"{what}: {shown(value)} is no list")
    return value


def brief(value):
    """A number in words, all of its digits."""
    return f"{value:g}" if float(f"{value:g}") == value else repr(value)


class Scene:
    """A schedule of a bar. Places are in units of |g|, or of the bar's length where g = 0."""

    def __init__(self, answer):
        self.read_bar(answer["bar"])
        self.read_stops(answer["stops"])
        self.read_schedule(answer)
        self.read_segments(answer["segments"])

    def read_bar(self, bar):
        """Length, gap, and what else is said of the material."""
        self.bar = require_keys(bar, "bar", ("length", "gap"), ("wave_speed", "axial_stiffness", "young"))
        self.gap, self.length = number(bar["gap"], "bar: gap"), positive(bar, "length", "bar")
        for key in ("wave_speed", "axial_stiffness", "young"):
            if bar.get(key) is not None:
                positive(bar, key, "bar")
        self.unit = abs(self.gap) or self.length  # of places

    def read_stops(self, stops):
        """Where the tip is stopped, {"right": 1, 0 or -1, "left": a fraction or nothing}."""
        self.where, self.places = {}, {}
        for stop in listed(stops, "stops"):
            side = require_keys(stop, "stops", ("side", "place"))["side"]
            if side not in ("right", "left") or side in self.places:
                raise NoProof(f"stops: {shown(stop)} is no stop, or given twice")
            self.places[side] = number(stop["place"], "stops")
        if self.places.get("right") != self.gap:
            raise NoProof("stops: allowed the wall at the gap of the bar, and perhaps one on the left")
        self.where["right"] = (self.gap > 0) - (self.gap < 0)
        if "left" in self.places:
            if not self.places["left"] < 0:
                raise NoProof("stops: allowed a left one below 0")
            self.where["left"] = -simplest(-self.places["left"] / self.unit)
            if not self.where["left"] < min(0, self.where["right"]):
                raise NoProof("stops: allowed a left one to the left of the right one")

    def read_schedule(self, answer):
        """Cells, phases (n_c, n_f), and the stop of each."""
        self.cells = integer(answer["cells"], "cells")
        phases = listed(answer["schedule"], "schedule")
        if not 1 <= self.cells <= MOST_CELLS or not 1 <= len(phases) <= MOST_PHASES or \
                self.cells * len(phases) > MOST_WORK:
            raise NoProof(f"cells, schedule: allowed 1 <= N <= {MOST_CELLS}, 1 to {MOST_PHASES} phases, and "
                          f"{MOST_WORK} of both together")
        self.phases, self.stops = [], []
        for phase in phases:
            if not isinstance(phase, list) or len(phase) not in (2, 3) or \
                    not all(1 <= integer(steps, "schedule") <= MOST_STEPS for steps in phase[:2]) or \
                    phase[2:] not in ([], ["left"]) or (phase[2:] and "left" not in self.where):
                raise NoProof(f"schedule: {shown(phase)} is not [n_c, n_f], 1 to {MOST_STEPS}, on a stop "
                              "that is there")
            self.phases.append(tuple(phase[:2]))
            self.stops.append((phase[2:] or ["right"])[0])
        self.steps = sum(map(sum, self.phases))

    def read_segments(self, segments):
        """Clamp first; none of one bar."""
        self.segments = []
        for found in listed(segments, "segments"):
            require_keys(found, "segments", Segment._fields)
            if not integer(found["cells"], "segments: cells") >= 1 or \
                    not number(found["dashpot"], "segments: dashpot") >= 0:
                raise NoProof("segments: allowed cells above 0 and dashpots of 0 or more")
            self.segments.append(Segment(found["cells"], positive(found, "impedance", "segments"),
                                         positive(found, "speed", "segments"), float(found["dashpot"])))
        if self.segments and sum(s.cells for s in self.segments) != self.cells:
            raise NoProof(f"segments: their cells are not {self.cells} together")
        if self.segments and self.segments[-1].dashpot:
            raise NoProof("segments: a dashpot needs another segment behind it")

    def is_uniform(self):
        """Are its segments, if it has any, those of one bar, from which no wave comes back?"""
        return all(s.impedance == self.segments[0].impedance and s.dashpot == 0 for s in self.segments)

    def speed(self, k):
        """The wave speed of a segment over that of the first one."""
        return Fraction(self.segments[k].speed) / Fraction(self.segments[0].speed)

    def lengthening(self):
        """Its length over that of a bar of the first material with the same travel time."""
        parts = [Fraction(s.cells) * Fraction(s.speed) / Fraction(self.segments[0].speed) for s in self.segments]
        return sum(parts) / self.cells if parts else Fraction(1)

    def reach(self):
        """Of the places of the stops those that matter: without a gap, small motions reach no stop that is
        not touched, and each may be as small."""
        return {"right": 0} if not self.where["right"] and "left" not in self.stops else self.where

    def sided(self):
        """Phases (n_c, n_f, side)."""
        return [(*phase, stop) for phase, stop in zip(self.phases, self.stops)]

    def require_derived(self, answer, cycles=1):
        """What follows from the scene, where it is said, has to follow from it."""
        parts = self.segments or [Segment(self.cells, 1.0, 1.0, 0.0)]
        first = parts[0]
        length = self.lengthening() * self.cells
        compliance = sum(Fraction(s.cells) * Fraction(first.impedance) / Fraction(s.impedance) for s in parts)
        told = {key: Fraction(self.bar[key]) if self.bar.get(key) else None
                for key in ("wave_speed", "axial_stiffness")}
        truth = {"period_ratio": Fraction(self.steps, self.cells),
                 "frequency_ratio": Fraction(4 * self.cells * cycles, self.steps)}
        if told["wave_speed"]:
            truth["period"] = self.steps * Fraction(self.length) / (length * told["wave_speed"])
        if told["axial_stiffness"]:
            truth["static_force"] = max(-Fraction(self.gap), 0) * told["axial_stiffness"] / \
                Fraction(self.length) * length / compliance
        for key in DERIVED:
            if key in answer and (key not in truth or not close(answer[key], truth[key], Fraction(1, 10 ** 9))):
                raise NoProof(f"{key}: {shown(answer[key])} does not follow from bar and schedule")

    def text(self):
        """All of it, in words."""
        phases = ", ".join(f"{'L:' * (stop == 'left')}{contact} {free}"
                           for (contact, free), stop in zip(self.phases, self.stops))
        parts = ",".join(":".join(map(brief, s)) for s in self.segments)
        bar = ", ".join(f"{name} {self.bar[key]!r}" for key, name in
                        (("length", "L"), ("wave_speed", "c"), ("axial_stiffness", "EA"), ("young", "E"),
                         ("gap", "g")) if self.bar.get(key) is not None)
        second = f", second stop {self.places['left']!r}" if "left" in self.places else ""
        return (f"schedule {phases} on {self.cells} cells{' of segments ' * bool(parts)}{parts}, bar {bar}{second}")


def unsaid(answer, more=()):
    """What an answer says besides, in words."""
    keys = sorted(key for key in (*BESIDES[2:], *more) if answer.get(key) not in (None, [], ""))
    return f" (not checked: {', '.join(keys)})" if keys else ""
