#!/usr/bin/env python3
"""Forged proofs: what tools/checkers believes of them is so.

Proofs of every kind are forged in one process: keys are added, removed, exchanged; claims are moved to another bar,
schedule, scene or number; multipliers, conditions and states are shortened, doubled, moved, changed; rows of an atlas
are doubled, dropped, exchanged. A forgery that says what its original says, or less, is no forgery. A yes to anything
else is a fault, unless the program, asked the forged question, says the same.
"""

import concurrent.futures
import copy
import csv
import io
import json
import math
import random
import sqlite3
import subprocess
import sys
import tempfile
import time
from collections import Counter
from fractions import Fraction
from pathlib import Path

from campaign import FOUND, NONE, arguments
from checkers import apart, atlas, certificate, forced
from checkers.reading import UNUSABLE, NoProof
from damaged_proofs import ASKED, ODD, pair_apart, question

MORE = [["3", "25", "--segments", "4:1,4:1.3"], ["3", "25", "--segments", "4:1,4:1.3", "--tip-floor", "-4e-3"],
        ["4", "20", "--segments", "4:1,4:1.3"], ["3", "14", "5", "10", "--segments", "2:1,2:1.3"],
        ["5", "30", "--cells", "10", "--gap", "-1e-3"], ["2", "6", "2", "6", "--cells", "2"]]
DRIVEN = [["12", "75", "--cells", "10", "--damping", "0.02", "--force", "tip", "--amplitude", "1e-4"],
          ["3", "7", "--cells", "4", "--damping", "0.1", "--force", "base"],
          ["4", "9", "--cells", "4", "--damping", "0", "--force", "tip", "--gap", "-1e-3"],
          ["3", "9", "L:2", "9", "--cells", "4", "--damping", "0.05", "--force", "tip", "--second-stop", "2e-3"]]
ATLASES = [["--cells", "3"], ["--cells", "3", "--gap", "-1e-3"], ["--cells", "2", "--second-stop", "1.5e-3"]]
KEYS = ["damping", "force", "cycles", "amplitude", "strain_limit", "tip_floor", "second_stop", "energy", "energy_ratio",
        "energy_ratio_range", "objective", "size", "gap", "landing", "state", "connected", "phases", "physical", "note",
        "period", "static_force", "residuals", "young", "rows", "segments", "left"]
NUMBERS = (int, float)


def parts_of(value, kind):
    """All objects or lists in a JSON value."""
    found = [value] if isinstance(value, kind) else []
    for part in value.values() if isinstance(value, dict) else value if isinstance(value, list) else []:
        if isinstance(part, (dict, list)):
            found += parts_of(part, kind)
    return found


def shifted(draw, value):
    """Another value of its kind."""
    if isinstance(value, bool) or not isinstance(value, NUMBERS):
        return draw.choice(ODD)
    if isinstance(value, int):
        return value + draw.choice([-2, -1, 1, 2, 5])
    return draw.choice([-value, 2 * value, value / 2, value + 1e-3, value * (1 + 1e-5), 0.0, math.nan])


def add_key(draw, answer, _):
    draw.choice(parts_of(answer, dict))[draw.choice(KEYS)] = copy.deepcopy(draw.choice(ODD))


def remove_key(draw, answer, _):
    part = draw.choice([part for part in parts_of(answer, dict) if part])
    del part[draw.choice(list(part))]


def exchange_keys(draw, answer, _):
    part = draw.choice([part for part in parts_of(answer, dict) if len(part) > 1])
    one, two = draw.sample(list(part), 2)
    part[one], part[two] = part[two], part[one]


def rename_key(draw, answer, _):
    part = draw.choice([part for part in parts_of(answer, dict) if part])
    part[draw.choice(KEYS)] = part.pop(draw.choice(list(part)))


def move_proof(draw, answer, others):
    answer["certificate"] = copy.deepcopy(draw.choice(others)["certificate"])


def move_claim(draw, answer, others):
    other = draw.choice(others)
    for key in draw.choice([("bar", "stops"), ("schedule",), ("cells", "segments"), ("bar",), ("stops",), ("cells",),
                            ("segments",), ("status",), ("cells", "schedule", "segments")]):
        if key in other:
            answer[key] = copy.deepcopy(other[key])


def other_schedule(draw, answer, _):
    phases = answer["schedule"]
    change = draw.randrange(5)
    if change == 0:
        phases.append(copy.deepcopy(draw.choice(phases)))
    elif change == 1 and len(phases) > 1:
        phases.pop(draw.randrange(len(phases)))
    else:
        phase = draw.choice(phases)
        phase[draw.randrange(2)] += draw.choice([-1, 1, 2, 3])


def other_number(draw, answer, _):
    places = [(part, key) for part in parts_of(answer, (dict, list)) for key, value in
              (part.items() if isinstance(part, dict) else enumerate(part)) if isinstance(value, NUMBERS)]
    part, key = draw.choice(places)
    part[key] = shifted(draw, part[key])


def other_bar(draw, answer, _):
    part = draw.choice([answer["bar"], *answer["stops"], *answer["segments"]])
    key = draw.choice(list(part))
    part[key] = shifted(draw, part[key])
    if draw.random() < 0.5:  # a wall that follows the gap
        answer["stops"][0]["place"] = answer["bar"].get("gap")


def rows_of(draw, answer):
    """A list of the proof that is not empty."""
    lists = [part for part in parts_of(answer.get("certificate", answer), list) if part]
    return draw.choice(lists or [answer["schedule"]])


def shorten(draw, answer, _):
    rows = rows_of(draw, answer)
    at = draw.randrange(len(rows))
    del rows[at:at + draw.choice([1, 1, 2, len(rows)])]


def double(draw, answer, _):
    rows = rows_of(draw, answer)
    rows.insert(draw.randrange(len(rows) + 1), copy.deepcopy(draw.choice(rows)))


def other_multiplier(draw, answer, _):
    pair = draw.choice([rows for rows in parts_of(answer.get("certificate", answer), list)
                        if len(rows) == 2] or [rows_of(draw, answer)])
    at = draw.randrange(len(pair))
    value = pair[at]
    if isinstance(value, str):
        try:
            pair[at] = str(Fraction(value) * draw.choice([-1, 2, Fraction(999, 1000)]) + draw.choice([0, 1]))
            return
        except (ValueError, ZeroDivisionError):
            pass
    pair[at] = shifted(draw, value)


def other_energy(draw, answer, _):
    factor = draw.choice([0.5, 0.9, 1 - 1e-6, 1 + 1e-6, 1.1, 3])
    for part in (answer, answer.get("certificate", {})):
        if isinstance(part, dict) and isinstance(part.get("energy_ratio"), float):
            part["energy_ratio"] *= factor
    if isinstance(answer.get("energy_ratio_range"), list):
        ends = answer["energy_ratio_range"]
        at = draw.randrange(len(ends)) if ends else 0
        if ends and isinstance(ends[at], float):
            ends[at] *= factor
        elif ends:
            ends[at] = factor


FORGE = [add_key, remove_key, exchange_keys, rename_key, move_proof, move_claim, other_schedule, other_number,
         other_bar, shorten, double, other_multiplier, other_energy]
SAID = ("status", "cells", "schedule", "stops", "segments", "damping", "force", "cycles", "strain_limit", "amplitude",
        "connected", "energy_ratio", "energy_ratio_range", "objective")


def claim(answer):
    """What an answer says: of a schedule, and within which limits."""
    proof = answer.get("certificate")
    said = {key: answer[key] for key in SAID if answer.get(key) is not None}
    said["gap"] = answer["bar"]["gap"]
    if "connected" in answer:  # the yes says that nothing is said of it
        said.pop("energy_ratio_range", None)
    if isinstance(proof, dict):
        said["proof"] = {key: proof[key] for key in ("strain_limit", "tip_floor", "energy_ratio", "kind")
                         if proof.get(key) is not None}
        if proof.get("kind") == "forced":
            said.pop("amplitude", None)
    said["segments"] = [{**part, "speed": 1.0} for part in answer["segments"]]
    if isinstance(said.get("damping"), dict):
        said["damping"] = said["damping"]["ratio"]
    return json.dumps(said, sort_keys=True)


class Oracle:
    """The program, asked the forged question."""

    def __init__(self, program):
        self.program, self.known = program, {}

    def ask(self, words):
        key = tuple(words)
        if key not in self.known:
            done = subprocess.run([self.program, *words, "--quiet", "--format", "json"], capture_output=True,
                                  check=False)
            self.known[key] = done.returncode, json.loads(done.stdout or b"null")
        return self.known[key]

    def is_true(self, answer):
        """Does it say the same?"""
        if "damping" in answer:
            return self.is_driven(answer)
        proof, words = answer["certificate"], ["find", *question({"certificate": {}, **answer})]
        if proof["kind"] == "energy-range" and answer["status"] == "none":
            words += ["--energy-ratio", repr(float(proof["energy_ratio"]))]
        elif proof["kind"] == "energy-range":
            words += ["--objective", answer.get("objective", "min-energy")]
        status, told = self.ask(words)
        if status != (FOUND if answer["status"] == "found" else NONE):
            return False
        if proof["kind"] == "farkas":
            return True
        pairs = list(zip(answer["energy_ratio_range"], told["energy_ratio_range"]))
        pairs += [(answer["energy_ratio"], told["energy_ratio"])] if answer.get("objective") else []
        return all(mine is None or abs(mine - its) <= 1e-6 * its for mine, its in pairs if its is not None)

    def is_driven(self, answer):
        """The same of a driven bar."""
        words = ["find", *question({**answer, "certificate": {}}), "--damping", repr(answer["damping"]["ratio"]),
                 "--force", answer["force"], "--cycles", str(answer["cycles"])]
        words = [word for k, word in enumerate(words) if word != "--energy" and words[k - 1] != "--energy"]
        for key, option in (("axial_stiffness", "--axial-stiffness"), ("length", "--length"),
                            ("wave_speed", "--wave-speed")):
            words += [option, repr(answer["bar"][key])]
        if answer["strain_limit"] is not None:
            words += ["--strain-limit", repr(answer["strain_limit"])]
        if answer["amplitude"] is not None and answer["certificate"]["kind"] != "forced":
            words += ["--amplitude", repr(answer["amplitude"])]
        elif answer["bar"]["gap"] == 0:  # all amplitudes are one
            words += ["--amplitude", "1"]
        return self.ask(words)[0] == NONE


class Certificates:
    """Answers of `find` and their forgeries."""

    def __init__(self, check, answers, program):
        self.check, self.answers, self.oracle = check, answers, Oracle(program)

    def draw(self, draw):
        """The name of a way, what it made of a proof, and a word for what became of that."""
        original = draw.choice(self.answers)
        bad, way = copy.deepcopy(original), draw.choice(FORGE)
        way(draw, bad, self.answers)
        if draw.random() < 0.2:
            try:
                draw.choice(FORGE)(draw, bad, self.answers)
            except (KeyError, TypeError, IndexError, AttributeError, ValueError, OverflowError):
                pass
        try:
            self.check(bad)
        except (NoProof, *UNUSABLE):
            return way.__name__, bad, "refused"
        return way.__name__, bad, self.judge(bad, original)

    def judge(self, bad, original):
        """Of what was believed."""
        if claim(bad) == claim(original):
            return "the same claim"
        return "another claim that is so" if self.oracle.is_true(bad) else "fault"


class Apart(Certificates):
    """Pairs of motions that no curve joins."""

    def __init__(self, pair, program, folder):
        answer, self.files = pair
        self.folder = folder
        for name, content in self.files.items():
            (folder / name).write_bytes(content)
        super().__init__(lambda bad: apart.check(bad, *(folder / name for name in self.files)), [answer], program)

    def draw(self, draw):
        if draw.random() < 0.7:
            return super().draw(draw)
        name, other = draw.sample(list(self.files), 2)
        rows = list(csv.reader(io.StringIO(self.files[name].decode())))
        change = draw.randrange(4)
        if change == 0:
            rows = list(csv.reader(io.StringIO(self.files[other].decode())))
        elif change == 1:
            rows.insert(draw.randrange(1, len(rows)), draw.choice(rows[1:]))
        elif change == 2:
            del rows[draw.randrange(len(rows))]
        else:
            at, column = draw.randrange(1, len(rows)), draw.randrange(2)
            rows[at][column] = repr(shifted(draw, float(rows[at][column])))
        content = "".join(",".join(row) + "\n" for row in rows).encode()
        (self.folder / name).write_bytes(content)
        try:
            self.check(self.answers[0])
            word = "the same claim" if self.numbers(content) == self.numbers(self.files[name]) else "fault"
        except (NoProof, *UNUSABLE, KeyError, TypeError, csv.Error):
            word = "refused"
        finally:
            (self.folder / name).write_bytes(self.files[name])
        return "other_state", rows, word

    @staticmethod
    def numbers(content):
        """Of a state, as text."""
        return [list(map(float, row)) for row in list(csv.reader(io.StringIO(content.decode())))[1:]]

    def judge(self, bad, original):
        return "the same claim" if claim(bad) == claim(original) else "fault"


class Atlas:
    """An atlas in memory, whose schedules are decided once."""

    NUMBERS = ["x", "0", "1", "2", "x + 1", "x - 1", "x * 2", "x / 2", "-x", "1 - x", "x * 1.001", "NULL", "'x'",
               "'found'", "'none'", "'grazing'", "'pressing'", "'point'", "'gap'", "'penetration'", "'1:5'", "'3:7'"]

    def __init__(self, path):
        self.whole = sqlite3.connect(path)
        self.decided = {}
        self.told = self.content(self.base())

    def base(self):
        base = sqlite3.connect(":memory:")
        self.whole.backup(base)
        base.row_factory = sqlite3.Row
        return base

    @staticmethod
    def content(base):
        """What an atlas says, but for who made it. Of several true reasons any may stand; that a false one is refused
        is tried by tests/cli/atlases_test.py."""
        told = {}
        for table, columns in atlas.COLUMNS.items():
            kept = ["reason IS NULL" if name == "reason" else name
                    for name in columns.split() if table != "runs" or name not in
                    ("version", "options", "started", "finished", "seconds", "workers", "id", "batches", "next_batch")]
            told[table] = sorted(map(repr, map(tuple, base.execute(f"SELECT {', '.join(kept)} FROM {table}"))))
        return told

    def draw(self, draw):
        """One or two changes of the tables."""
        base = self.base()
        words = [self.change(draw) for _ in range(draw.choice([1, 1, 1, 2]))]
        try:
            for word in words:
                base.executescript(word)
        except sqlite3.Error:
            return "atlas", words, "refused"
        try:
            rows = atlas.Rows(base, self.decided)
            rows.check()
        except (NoProof, *UNUSABLE, sqlite3.Error):
            return "atlas", words, "refused"
        return "atlas", words, "the same claim" if self.content(base) == self.told else "fault"

    def change(self, draw):
        """SQL that changes something."""
        table = draw.choice(["schedules", "schedules", "families", "runs"])
        at = draw.randrange(30) if table != "runs" else 0
        row = f"rowid = (SELECT rowid FROM {table} ORDER BY rowid LIMIT 1 OFFSET {at})"
        name = draw.choice(atlas.COLUMNS[table].split())
        kind = draw.randrange(8)
        if kind == 0:
            return f"DELETE FROM {table} WHERE {row}"
        if kind == 1:
            return (f"CREATE TABLE plain AS SELECT * FROM {table}; DROP TABLE {table};"
                    f"ALTER TABLE plain RENAME TO {table}; INSERT INTO {table} SELECT * FROM {table} WHERE {row}")
        if kind == 2:
            other = draw.choice(atlas.COLUMNS[table].split())
            return f"UPDATE {table} SET {name} = {other}, {other} = {name} WHERE {row}"
        if kind == 3:
            return f"ALTER TABLE {table} ADD COLUMN {draw.choice(KEYS)}_2"
        value = draw.choice(self.NUMBERS).replace("x", name) if draw.random() < 0.7 else draw.choice(self.NUMBERS[1:4])
        return f"UPDATE {table} SET {name} = {value} WHERE {row}"


def corpus(program, folder):
    """Proofs of every kind."""
    found, driven = [], []
    for words in [*ASKED, *MORE, *DRIVEN]:
        path = folder / "proof.json"
        path.unlink(missing_ok=True)
        subprocess.run([program, "find", *words, "--quiet", "--certificate", path], check=False, capture_output=True)
        if path.exists():
            answer = json.loads(path.read_bytes())
            (forced if "force" in answer else certificate).check(answer)
            (driven if "force" in answer else found).append(answer)
    makers = [Certificates(certificate.check, found, program), Certificates(forced.check, driven, program),
              Apart(pair_apart(program, folder), program, folder)]
    for number, words in enumerate(ATLASES):
        path = folder / f"{number}.sqlite"
        subprocess.run([program, "atlas", *words, "--all", "--quiet", "--database", path], check=True,
                       capture_output=True)
        makers.append(Atlas(path))
    return makers, Counter(answer["certificate"]["kind"] + " " + answer["certificate"].get("rows", "")
                           for answer in found + driven)


def forge(program, seed, first, count):
    """So many forgeries: what became of them, and the faults."""
    words, faults = Counter(), []
    with tempfile.TemporaryDirectory() as name:
        makers, kinds = corpus(program, Path(name))
        shares = [7, 3, 1] + [1] * (len(makers) - 3)
        for number in range(first, first + count):
            draw = random.Random(f"{seed} {number}")
            maker = draw.choices(makers, shares)[0]
            for _ in range(50):
                try:
                    way, bad, word = maker.draw(draw)
                except (KeyError, TypeError, IndexError, AttributeError, ValueError, OverflowError) as error:
                    if isinstance(error.__traceback__, type(None)) or in_checker(error):
                        way, bad, word = "traceback", repr(error), "fault"
                    else:
                        continue  # nothing there to change so
                if word != "the same claim":
                    break
            words[word] += 1
            words[f"  {way}: {word}"] += 1
            if word == "fault":
                faults.append(f"case {number}, {way}: {json.dumps(bad, default=str)[:3000]}")
    return words, faults, kinds


def in_checker(error):
    """Was it raised by what is tried, and not by what tries?"""
    trace, names = error.__traceback__, []
    while trace:
        names.append(trace.tb_frame.f_code.co_filename)
        trace = trace.tb_next
    return any("checkers" in Path(name).parts[-2:] for name in names)


def main():
    given = arguments(__doc__.split("\n")[0], 100_000)
    start, words, faults = time.monotonic(), Counter(), []
    with concurrent.futures.ProcessPoolExecutor(given.jobs) as pool:
        share = max(1, -(-given.count // given.jobs))
        end = given.first + given.count
        calls = [pool.submit(forge, given.program, given.seed, first, min(share, end - first))
                 for first in range(given.first, end, share)]
        for call in calls:
            counted, found, kinds = call.result()
            words.update(counted)
            faults += found
    for fault in faults[:50]:
        print(fault)
    print(f"proofs: {dict(kinds)}")
    for word in sorted(words):
        print(f"{words[word]:8} {word}")
    if len(kinds) < 5 or words["refused"] < 0.8 * given.count:
        faults.append("too little was tried")
        print(faults[-1])
    print(f"{given.count} forgeries: {words['refused']} refused, {words['another claim that is so']} say something "
          f"else that is so, {words['the same claim']} say the same; {len(faults)} faults "
          f"({time.monotonic() - start:.0f} s)")
    sys.exit(1 if faults else 0)


if __name__ == "__main__":
    main()
