#!/usr/bin/env python3
"""Forgeries that checkers once believed are refused, and what is believed is said whole.

forgeries_test.py PROGRAM

Each is a proof of the program with a change that makes it say something else, or more than it proves.
"""
import collections
import copy
import itertools
import json
import math
import pathlib
import resource
import shutil
import sqlite3
import subprocess
import sys
import tempfile
import time
import types

if (tools := str(pathlib.Path(__file__).resolve().parents[2] / "tools")) not in sys.path:
    sys.path.append(tools)
from checkers import apart, atlas, certificate, energies, forced, sums, verdicts
from checkers.reading import NoProof

STEPPED = ["--segments", "4:1,4:1.3"]
SECONDS = 30


class Forger:
    """Proofs of a program, and what became of them."""

    def __init__(self, program, folder):
        self.program, self.folder, self.refused, self.said = program, folder, 0, 0

    def proof(self, *words):
        """The file of --certificate."""
        path = self.folder / "proof.json"
        path.unlink(missing_ok=True)
        subprocess.run([self.program, "find", *words, "--quiet", "--certificate", path], check=False,
                       stdout=subprocess.DEVNULL)
        return json.loads(path.read_text(encoding="utf-8"))

    def say(self, check, answer, *parts):
        """It is believed, and what is said of it holds these parts."""
        try:
            text = check(answer)
        except NoProof as why:
            sys.exit(f"refused: {why}")
        for part in parts:
            if part not in text:
                sys.exit(f"{part!r} is not in: {text}")
        self.said += 1

    def refuse(self, check, answer, what):
        """It is not believed."""
        try:
            sys.exit(f"{what}: believed: {check(answer)}")
        except NoProof:
            self.refused += 1

    def changed(self, check, answer, what, change):
        """The same after a change of a copy."""
        bad = copy.deepcopy(answer)
        change(bad)
        self.refuse(check, bad, what)


def with_energy(answer, energy):
    """The claim of another least energy."""
    bad = copy.deepcopy(answer)
    bad["certificate"]["energy_ratio"] = energy
    bad["energy_ratio"], bad["energy_ratio_range"] = energy, [energy, None]
    return bad


def forge_motions(forger):
    """The least energy of a motion that is not there."""
    answer = forger.proof("3", "25", *STEPPED)
    forger.say(certificate.check, answer, "3 25 on 8 cells of segments 4:1:1:0,4:1.3", "free and undamped",
               "the state of the file is a motion")
    bad = with_energy(answer, 0.5 * answer["energy_ratio"])  # which is proved, but no motion has it
    forger.refuse(certificate.check, bad, "half the energy")
    forger.changed(certificate.check, bad, "a schedule without motions",
                   lambda a: a.update(schedule=[[4, 20]]))
    for name, change in [("no state", lambda c: c.pop("state")),
                         ("a state of nothing", lambda c: c.update(state={"a": [0.0] * 8, "b": [0.0] * 8})),
                         ("a state of other cells", lambda c: c["state"]["a"].pop()),
                         ("a state that is louder", lambda c: c["state"].update(
                             {key: [1.001 * x for x in c["state"][key]] for key in "ab"})),
                         ("a wave less", lambda c: c["state"]["b"].__setitem__(4, 0.0)),
                         ("a wave that is no number", lambda c: c["state"]["a"].__setitem__(0, math.nan)),
                         ("three waves", lambda c: c["state"].update(c=[0.0] * 8))]:
        forger.changed(certificate.check, answer, name, lambda a, change=change: change(a["certificate"]))


def forge_floors(forger):
    """A floor that the motion does not keep, one that nothing is said of, one beyond all numbers."""
    words = ["3", "14", "5", "10", "--segments", "2:1,2:1.3"]
    forger.say(certificate.check, forger.proof(*words), "3 14, 5 10 on 4 cells", "E/E_1 >= 7.8115")
    answer = forger.proof(*words, "--tip-floor", "-0.0015")
    forger.say(certificate.check, answer, "E/E_1 >= 9.5467", "with the tip >= -1.5 |g|")
    for floor in (None, -2.0, -1.4, math.nan):
        forger.changed(certificate.check, answer, f"a floor at {floor}",
                       lambda a: a["certificate"].update(tip_floor=floor))
    forger.changed(certificate.check, answer, "no floor", lambda a: a["certificate"].pop("tip_floor"))
    held = forger.proof("3", "25", *STEPPED, "--tip-floor", "-0.003")
    forger.say(certificate.check, held, "the tip >= -3.0")
    for floor in (1e300, -1e300, 1e308, "0", math.inf):
        bad = copy.deepcopy(held)
        bad["certificate"]["tip_floor"] = floor
        try:
            certificate.check(bad)
        except NoProof:
            forger.refused += 1


def forge_bars(forger):
    """Claims about another bar."""
    uniform = forger.proof("5", "36", "--cells", "10")
    stepped = forger.proof("3", "12", *STEPPED)
    motion = forger.proof("3", "25", *STEPPED)
    gentle = forger.proof("5", "30", "--cells", "10", "--strain-limit", "1.9e-3")
    for answer in (uniform, stepped, motion, gentle):
        forger.say(certificate.check, answer, "bar L 1.0", "g 0.001", "free and undamped")
        for name, value in [("damping", {"ratio": 0.05, "dashpot": 0.1}), ("force", "tip"), ("cycles", 2),
                            ("strain_limit", 0.0), ("amplitude", 1.0), ("anything", None)]:
            forger.changed(certificate.check, answer, name, lambda a: a.__setitem__(name, value))
            forger.changed(certificate.check, answer, f"certificate: {name}",
                           lambda a: a["certificate"].__setitem__(name, value)
                           if name not in a["certificate"] else a["certificate"].pop("rows"))
            forger.changed(certificate.check, answer, f"bar: {name}", lambda a: a["bar"].__setitem__(name, value))
        for gap in (-1e-3, math.nan, "0.001", 2e-3, True, None):
            forger.changed(certificate.check, answer, f"gap {gap}", lambda a: a["bar"].update(gap=gap))
        forger.changed(certificate.check, answer, "no gap", lambda a: a["bar"].pop("gap"))
        forger.changed(certificate.check, answer, "no bar", lambda a: a.update(bar={}))
        forger.changed(certificate.check, answer, "nothing", lambda a: a.pop("bar"))
        forger.changed(certificate.check, answer, "no stops", lambda a: a.pop("stops"))
        forger.changed(certificate.check, answer, "an energy", lambda a: a.update(energy=1.0))
    parts = {"speed": 1.0, "dashpot": 0.0}
    for name, cells in [("too few cells", (3, 4)), ("too many", (5, 9))]:
        for impedance in (1.0, "1"):
            forger.changed(certificate.check, uniform, name, lambda a: a.update(
                segments=[{"cells": n, "impedance": impedance, **parts} for n in cells]))
    forger.changed(certificate.check, uniform, "text", lambda a: a.update(
        segments=[{"cells": n, "impedance": "1", **parts} for n in (4, 6)]))
    forger.changed(certificate.check, motion, "a most energy",
                   lambda a: a["energy_ratio_range"].__setitem__(1, 1))
    ranged = forger.proof("5", "30", "--cells", "10")
    forger.changed(certificate.check, ranged, "a most energy", lambda a: a["energy_ratio_range"].__setitem__(1, 10.0))
    forger.changed(certificate.check, ranged, "an objective", lambda a: a.update(objective="max-energy"))


def forge_rows(forger):
    """Bars in a row: what follows from scene and schedule is checked, and what does not is said not to be."""
    bars = ["--scene", "clamp 4 gap=1e-3 5:1.3 clamp"]
    none, motion = forger.proof("6", "16", *bars), forger.proof("6", "36", "--scene", "clamp 12 stop=1e-3")
    forger.say(certificate.check, none, "from which frequency_ratio follows")
    forger.say(certificate.check, motion, "not checked: contact", "physical, admissible",
               "solution_set, route, route_reason, left_out, solver")
    for answer, kind in ((none, "point"), (motion, "empty")):
        forger.changed(certificate.check, answer, f"a set that is {kind}",
                       lambda a: a["solution_set"].update(kind=kind, dimension=None))
    forger.changed(certificate.check, none, "an empty set of a dimension",
                   lambda a: a["solution_set"].update(dimension=0))
    for name in ("solution_set", "route", "solver"):
        forger.changed(certificate.check, motion, f"no {name}", lambda a: a.pop(name))
    for answer in (none, motion):
        for name in ("period_ratio", "frequency_ratio"):
            for value in (7.0, None, "1"):
                forger.changed(certificate.check, answer, name, lambda a: a.__setitem__(name, value))
    for name, value in (("physical", motion["physical"]), ("admissible", True)):
        forger.changed(certificate.check, none, name, lambda a: a.__setitem__(name, value))


def forge_strains(forger):
    """Limits of strain of bars whose waves meet in more than one place, and of waves that do not meet."""
    bars = ["--scene", "clamp 4 gap=2e-3 4:2:0.5 clamp"]
    for words, limit, seen in ((["3", "11", "--segments", "4:1,2:0.5"], 3e-2, 86.0), (["3", "11", *bars], 2e-3, 8e-3)):
        answer = forger.proof(*words, "--strain-limit", repr(limit))
        forger.say(certificate.check, answer, "no" + ("ne below" if "--segments" in words else " periodic motion"),
                   "with strains >= -")
        held = answer["certificate"]
        if answer["status"] != "none" or not held["strains"]:
            sys.exit(f"{words}: the limit is not what excludes motions")
        for value in (seen * 1.001, 0.0, -1.0, None, "1", math.nan):
            forger.changed(certificate.check, answer, f"a limit of {value}",
                           lambda a: a["certificate"].update(strain_limit=value))
        for key in ("strain_limit", "strains"):
            forger.changed(certificate.check, answer, f"no {key}", lambda a: a["certificate"].pop(key))
        row, right, left, value = held["strains"][0]
        steps, cells = sum(map(int, words[:2])), 4
        for entry in ([row, right, left, -value], [0, right, left, value], [9, right, left, value],
                      [row, steps, left, value], [row, right, -1, value], [row, right, left], 1,
                      [row, right, left, 2 * value], [row, right, left, "1"],
                      [row, right, (right + cells + 1) % steps, value]):
            forger.changed(certificate.check, answer, f"strains: {entry}",
                           lambda a: a["certificate"]["strains"].__setitem__(0, entry))
    driven = forger.proof("6", "28", "--scene", "clamp 4 dash=0.2 4:1.3 driven stop=1e-3", "--force", "tip",
                          "--strain-limit", "1e-3")
    forger.say(certificate.check, driven, "no forced motion", "with strains >= -0.001")
    for value in (1.0, 0.0, None, "1"):
        forger.changed(certificate.check, driven, f"a limit of {value}", lambda a: a.update(strain_limit=value))
    forger.changed(certificate.check, driven, "no limit", lambda a: a.pop("strain_limit"))
    forger.changed(certificate.check, driven, "a limit of the certificate",
                   lambda a: a["certificate"].update(strain_limit=1e-3))
    words = ["3", "25", *STEPPED]
    motion = forger.proof(*words, "--strain-limit", "1")
    forger.say(certificate.check, motion, "with strains >= -1000")
    for value in (0.5, 1e-3, 0.0):
        forger.changed(certificate.check, motion, f"a limit of {value} that the state exceeds",
                       lambda a: a["certificate"].update(strain_limit=value))


def forge_driven(forger):
    """Keys beside the question of a driven bar, and driven keys beside motions that no curve joins."""
    answer = forger.proof("12", "75", "--cells", "10", "--damping", "0.02", "--force", "tip", "--amplitude", "1e-4")
    forger.say(forced.check, answer, "12 75 on 10 cells", "damping ratio 0.02", "amplitude 0.0001",
               "a force on the tip")
    for name, value in [("second_stop", 1e-3), ("phases", 2), ("tip_floor", 0.0), ("gap", -1e-3)]:
        forger.changed(forced.check, answer, name, lambda a: a.__setitem__(name, value))
        forger.changed(forced.check, answer, f"certificate: {name}",
                       lambda a: a["certificate"].__setitem__(name, value))
        forger.changed(forced.check, answer, f"damping: {name}", lambda a: a["damping"].__setitem__(name, value))
    for key in ("strain_limit", "amplitude", "cycles", "damping", "stops", "bar"):
        forger.changed(forced.check, answer, f"without {key}", lambda a: a.pop(key))
    forger.changed(forced.check, answer, "a gap", lambda a: a["bar"].update(gap=2e-3))
    forger.changed(forced.check, answer, "a dashpot", lambda a: a["damping"].update(dashpot=0.5))
    z = [[5e-3 * (0.9 if k == place else 0.025) for k in range(5)] for place in (1, 3)]
    files = [forger.folder / name for name in ("one.csv", "two.csv")]
    for path, run in zip(files, z):
        a, b = [-value for value in run[::-1]] + run[::-1], run + run
        path.write_text("a,b\n" + "".join(f"{x!r},{y!r}\n" for x, y in zip(a, b)), encoding="utf-8")
    ratio = 20 * (0.81 + 4 * 0.025 ** 2)
    answer = json.loads(subprocess.run(
        [forger.program, "continuum", "5", "30", "--cells", "10", "--energy-ratio", repr(ratio), "--points", "3",
         "--from", files[0], "--to", files[1], "--format", "json"], capture_output=True, check=False).stdout)

    def check(found):
        return apart.check(found, *files)

    forger.say(check, answer, "5 30 on 10 cells", "free and undamped", f"E/E_1 = {ratio!r}")
    for name, value in [("damping", {"ratio": 0.05}), ("force", "tip"), ("cycles", 2), ("certificate", {})]:
        forger.changed(check, answer, name, lambda a: a.__setitem__(name, value))
    forger.changed(check, answer, "a gap", lambda a: a["bar"].update(gap=-1e-3))
    forger.changed(check, answer, "an energy", lambda a: a.update(energy=2 * a["energy"]))


ALONE = """CREATE TABLE plain AS SELECT * FROM schedules; DROP TABLE schedules;
ALTER TABLE plain RENAME TO schedules;"""
FORGED_ATLASES = {
    "two rows for one schedule": ALONE + "INSERT INTO schedules SELECT * FROM schedules LIMIT 1",
    "a row that another hides": ALONE + """
        INSERT INTO schedules SELECT * FROM schedules WHERE status = 'found' LIMIT 1;
        UPDATE schedules SET status = 'none'
        WHERE rowid = (SELECT min(rowid) FROM schedules WHERE status = 'found')""",
    "a period that divides it": """
        UPDATE schedules SET steps = steps / 2, period = period / 2, frequency_ratio = frequency_ratio * 2
        WHERE rowid = (SELECT min(rowid) FROM schedules WHERE status = 'found' AND steps % 2 = 0)""",
    "canonical": "UPDATE schedules SET canonical = 1 - canonical",
    "a contact": "UPDATE schedules SET contact = 'grazing' WHERE contact = 'pressing'",
    "a kind": "UPDATE schedules SET kind = 'polytope' WHERE kind = 'point'",
    "a dimension": "UPDATE schedules SET dimension = dimension + 1",
    "no families": "DELETE FROM families",
    "a family less": "DELETE FROM families WHERE id = 1",
    "a family altered": "UPDATE families SET nu = nu + 1 WHERE id = 1",
    "members": "UPDATE families SET schedules = schedules + 1 WHERE id = 1",
    "a family's energy": "UPDATE families SET energy_ratio_min = energy_ratio_min * 1.1 WHERE id = 1",
    "another family": "UPDATE schedules SET family = 3 - family WHERE family < 3",
    "no family": "UPDATE schedules SET family = NULL",
    "pressing for grazing": "UPDATE runs SET pressing = pressing + 1, grazing = grazing - 1",
    "families counted": "UPDATE runs SET families = families + 1",
    "batches": "UPDATE runs SET next_batch = next_batch - 1",
    "a column": "ALTER TABLE schedules ADD COLUMN damping REAL DEFAULT 0.05",
    "a table": "CREATE TABLE damping(ratio REAL)",
    "a proof of one bar": "UPDATE schedules SET proof = '1:1;' WHERE status = 'none'",
}
ENDLESS = """ALTER TABLE schedules RENAME TO plain;
CREATE VIEW schedules AS WITH RECURSIVE more(n) AS (SELECT 1 UNION ALL SELECT n + 1 FROM more)
SELECT plain.* FROM plain, more"""


def forge_atlases(forger):
    """What an atlas says besides status and energies, and rows that hide others."""
    for scene in ([], ["--gap", "-1e-3"]):
        whole = forger.folder / "whole.sqlite"
        whole.unlink(missing_ok=True)
        subprocess.run([forger.program, "atlas", "--cells", "4", "--all", "--quiet", *scene, "--database", whole],
                       check=True, stdout=subprocess.DEVNULL)
        forger.say(atlas.check, whole, "N = 4, gap", "up to 1 phases of 8 16", "not checked: who made the runs")
        for name, change in {**FORGED_ATLASES, "a view without end": ENDLESS}.items():
            bad = shutil.copy(whole, forger.folder / "bad.sqlite")
            base = sqlite3.connect(bad)
            base.executescript(change)
            base.commit()
            base.close()
            begin = time.process_time()
            forger.refuse(atlas.check, bad, name)
            if time.process_time() - begin > SECONDS:
                sys.exit(f"{name}: refused after {time.process_time() - begin:.0f} s")


def forge_bounds(forger):
    """A run that only the second stop holds, p = -z <= 0 always, has no strain that a limit bounds."""
    held = 0
    for cells, contact in itertools.product((1, 2, 3), range(1, 12)):
        found = sums.Sums(cells, [(contact, 1)], ["left"], {"right": 1, "left": -2})
        if any(set(found.signs[first].values()) == {-1} for first in found.live):
            held += 1
            if energies.Energies(found).most_within(1) is not None:
                sys.exit(f"{cells}, {contact}: a bound by a strain that is not limited")
    if not held:
        sys.exit("no run that the second stop alone holds")
    forger.refused += held


def forge_unknown(forger):
    """Where the most energy is not known, because a bound depends on sums, the least still is."""
    phases = ((2, 1, False), (1, 9, False), (4, 7, False))
    verdict = verdicts.Verdict(6, phases, {"right": -1})
    if not verdict.unknown or verdict.least != 6:
        sys.exit(f"{phases}: least {verdict.least}, {verdict.unknown}")
    row = {"cells": 6, "phases": atlas.text_of(phases), "steps": 24, "period": 4.0, "frequency_ratio": 1.0,
           "status": "found", "reason": None, "family": None, "proof": None, "kernel_dimension": verdict.kernel,
           "energy_ratio_min": 6.0, "energy_ratio_max": None,
           **{key: getattr(verdict, key) for key in ("contact", "kind", "dimension", "canonical")}}
    table = types.SimpleNamespace(names={}, unknown=collections.Counter())

    def check(answer):
        return f"{atlas.check_row(answer, verdict, table)} {dict(table.unknown)}"

    forger.say(check, row, "found", "where a bound depends on sums")
    for key, value in (("energy_ratio_min", 6.001), ("energy_ratio_min", None), ("steps", 12), ("dimension", 9)):
        forger.refuse(check, {**row, key: value}, f"{key} {value}")


def call(words, **how):
    """A command within a time of its own and a memory; its status and what it said."""
    def bound():
        resource.setrlimit(resource.RLIMIT_AS, (1 << 31, 1 << 31))
        resource.setrlimit(resource.RLIMIT_CPU, (SECONDS, SECONDS))

    done = subprocess.run([sys.executable, *map(str, words)], stderr=subprocess.PIPE, check=False, preexec_fn=bound,
                          **how)
    return done.returncode, done.stderr.decode()


def forge_streams(forger):
    """What cannot be said or read ends with a line and status 2; what is too large ends soon."""
    folder = pathlib.Path(tools)
    path = forger.folder / "proof.json"
    forger.proof("5", "36", "--cells", "10")
    wide = json.loads(path.read_text(encoding="utf-8"))
    with open("/dev/full", "wb") as full:
        cases = [([folder / "check-certificate", path], {"stdout": full}),
                 ([folder / "check-forced", path], {"stdout": full}),
                 ([folder / "lift-certificate", "-"], {"stdout": subprocess.PIPE, "stdin": None})]
        for words, how in cases:
            if how.get("stdin", 1) is None:
                script = "import os, sys; os.close(0); os.execv(sys.executable, [sys.executable] + sys.argv[1:])"
                words = ["-c", script, *words]
                how = {"stdout": subprocess.PIPE}
            status, text = call(words, **how)
            if status != 2 or text.count("\n") != 1 or "Traceback" in text:
                sys.exit(f"{words}: {status} {text}")
    for change in ({"cells": 10 ** 8}, {"cells": 10 ** 6, "schedule": [[10 ** 9, 10 ** 9]]},
                   {"schedule": [[7, 11]] * 1000}, {"cells": 10 ** 6, "schedule": [[3, 4]] * 1000},
                   {"schedule": [[10 ** 12, 1]]}):
        for rows in ("paper", "lumped"):
            bad = {**wide, **change}
            bad["certificate"] = {**wide["certificate"], "rows": rows}
            if rows == "lumped":
                bad["certificate"] = {"kind": "farkas", "verified": True, "rows": rows, "equalities": [[0, -1]],
                                      "inequalities": []}
            path.write_text(json.dumps(bad), encoding="utf-8")
            status, text = call([folder / "check-certificate", path], stdout=subprocess.DEVNULL)
            if status != 1:
                sys.exit(f"{change}, {rows}: {status} {text}")
            forger.refused += 1


def main():
    program = sys.argv[1]
    with tempfile.TemporaryDirectory() as name:
        forger = Forger(program, pathlib.Path(name))
        forge_bounds(forger)
        forge_unknown(forger)
        forge_streams(forger)
        forge_atlases(forger)
        forge_driven(forger)
        has_simplex = subprocess.run([program, "find", "3", "12", *STEPPED, "--objective", "min-energy"],
                                     capture_output=True, check=False).returncode == 1
        if has_simplex:
            forge_motions(forger)
            forge_floors(forger)
            forge_bars(forger)
            forge_rows(forger)
            forge_strains(forger)
        else:
            print("several segments: this build has no solver for them")
    print(f"{forger.refused} forgeries are refused, {forger.said} proofs say all that they are about")


if __name__ == "__main__":
    main()
