"""Runs of an atlas that are about bars in a row: that what is refuted has no motion."""
import collections

from .floor import HUGE
from .network import WORDS
from .network_claim import NINE, Claim
from .reading import NoProof, shown
from .schedules import each_once

MOST = 10 ** 5  # schedules: some minutes
KINDS = {"gap": "gap", "spring": "stiffness", "mass": "mass", "force": "force", "dash": "impedance"}


def part_of(word):
    """One word of a scene as files have it."""
    name, equals, value = word.partition("=")
    if not equals and name in WORDS:
        return {"kind": name}
    if not equals:
        values = [float(text) for text in name.split(":")[1:]] + [1.0, 1.0]
        return {"kind": "cells", "cells": int(name.split(":")[0]), "impedance": values[0], "speed": values[1]}
    if name == "stop":
        side, colon, place = value.rpartition(":")
        side = side if colon else "left" if float(place) < 0 else "right"
        return {"kind": f"{side} stop", "gap": float(place) if colon or side == "right" else -float(place)}
    return {"kind": name, KINDS[name]: float(value)}


def scene_of(text):
    """ "words; length wave_speed axial_stiffness gravity young" as answers have it."""
    try:
        words, scales = str(text).split("; ")
        names = ("length", "wave_speed", "axial_stiffness", "gravity", "young")
        scene = dict(zip(names, map(float, scales.split()), strict=True))
        scene["young"] = scene["young"] or None
        return {**scene, "parts": [part_of(word) for word in words.split()]}
    except (ValueError, KeyError):
        raise NoProof(f"{shown(text)} is no scene") from None


def lists_of(text):
    """The multipliers of a proof: "y ...; contact:step:value ...; contact:step:value ..."."""
    try:
        waves, *conditions = str(text).split(";")
        entries = [[[int(contact), int(step), float(value)] for contact, step, value in
                    (entry.split(":") for entry in part.split())] for part in conditions]
        places, pushes = entries
        return {"periodicity": [float(value) for value in waves.split()], "places": places, "pushes": pushes}
    except ValueError:
        raise NoProof(f"proof {shown(text)[:60]}: no multipliers") from None


class Bars:
    """A run about bars in a row."""

    def __init__(self, run):
        self.run, self.scene = run, scene_of(run["segments"])
        claim = Claim({"scene": self.scene, "schedule": [{"closed": [], "steps": 1}]})
        self.contacts = len(claim.bars.contacts)
        if claim.bars.cells != run["cells"]:
            raise NoProof(f"run {run['id']}: {run['cells']} cells are not those of its scene")

    def schedules(self):
        """All, each once: of those that differ in where they begin the first."""
        run = self.run
        if (run["max_contact"] * run["max_free"] * self.contacts) ** run["phases"] > MOST:
            raise NoProof(f"run {run['id']}: more than {MOST} schedules")
        return each_once(run, range(1, self.contacts + 1))

    def check(self, phases, proof):
        """That a schedule has no motion below 10^9 E_1, or what takes its place."""
        spans = [span for contact, free, name in phases
                 for span in ({"closed": [name], "steps": contact}, {"closed": [], "steps": free})]
        claim = Claim({"scene": self.scene, "schedule": spans})
        claim.take(lists_of(proof), {})
        unit = claim.bars.unit()[0]
        least = HUGE * (unit or claim.bars.natural(len(claim.closed)))
        if claim.least() < least * (1 - NINE):
            raise NoProof(f"{words_of(phases)}: its proof leaves motions below 10^9 E_1")


def words_of(phases):
    """As the column `phases` has it."""
    return " ".join(f"{name}:{contact} -:{free}" for contact, free, name in phases)


def require_times(row, steps):
    """That steps and what follows from them are those of the schedule."""
    if row["steps"] != steps or row["period"] != steps / row["cells"] or \
            row["frequency_ratio"] != 4 * row["cells"] / steps or row["family"] is not None:
        raise NoProof(f"{row['phases']}: steps, period, frequency_ratio or family are not its own")


def check_bars(runs, rows):
    """Refuted rows of all runs, in words. `rows`: by cells and schedule."""
    said, known = [], set()
    for run in runs:
        bars = Bars(run)
        counts, contacts = dict.fromkeys(("found", "none", "undecided"), 0), collections.Counter()
        if not run["keeps_refuted"] or run["max_energy_ratio"] is not None:
            raise NoProof(f"run {run['id']} did not keep all: --all without --max-energy-ratio does")
        if run["gap_sign"] != 1 or run["second_stop"] is not None:
            raise NoProof(f"run {run['id']}: a gap or a second stop of one bar")
        for phases in bars.schedules():
            row = rows.get((run["cells"], words_of(phases)))
            if row is None:
                raise NoProof(f"{words_of(phases)}: no row")
            known.add(row["phases"])
            if row["status"] not in counts or (row["status"] != "none" and row["proof"] is not None):
                raise NoProof(f"{row['phases']}: status {shown(row['status'])}, with a proof of none")
            counts[row["status"]] += 1
            contacts[row["contact"]] += 1
            require_times(row, sum(contact + free for contact, free, _ in phases))
            if row["status"] == "none":
                bars.check(phases, row["proof"])
        if (counts["none"], counts["undecided"], contacts["pressing"], contacts["grazing"]) != tuple(
                run[name] for name in ("refuted", "undecided", "pressing", "grazing")) or \
                run["decided"] != sum(counts.values()) or run["families"]:
            raise NoProof(f"run {run['id']}: its counts are not those of its rows")
        said.append(f"N = {run['cells']}, {run['segments'].split(';')[0]}, up to {run['phases']} phases of "
                    f"{run['max_contact']} {run['max_free']}: {counts['none']} schedules have no motion")
    if len(known) < len(rows):
        raise NoProof("schedules: rows of no run")
    return ("; ".join(said) + " (not checked: that the others have motions, of which energy, kind and contact; "
            "kernel_dimension, reason, canonical; who made the runs, when, with which words)")
