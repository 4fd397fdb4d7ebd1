#!/usr/bin/env python3
"""Damaged proofs: tools/check-certificate, lift-certificate, check-apart and check-atlas say yes, no or
a usage error, and yes only of what is still true.

What they read is spoilt by bytes and by structure: kinds of values, keys, numbers, lengths, depth.
A yes about another schedule or bar than the program was asked for is judged by the program, which shares no
code with the checkers; multipliers of the paper's rows by a march of random integers, in which the
rows have to cancel.
"""

import copy
import json
import math
import random
import resource
import shutil
import sqlite3
import subprocess
import sys
import tempfile
from pathlib import Path

import damaged_databases
from campaign import FOUND, NONE, arguments, campaign

TOOLS = Path(__file__).resolve().parents[2] / "tools"
MEMORY = 2 << 30
ASKED = [["5", "36", "--cells", "10"], ["3", "7", "--cells", "2", "--gap", "-1e-3"],
         ["3", "7", "--cells", "2", "--gap", "0", "--energy", "1"],
         ["1", "5", "3", "12", "--cells", "4"], ["2", "11", "3", "12", "--cells", "4"],
         ["1", "12", "2", "6", "--cells", "4"],
         ["2", "5", "L:1", "5", "--cells", "4", "--second-stop", "1e-3"],
         ["3", "12", "--segments", "4:1,4:1.3"], ["5", "30", "--cells", "10"],
         ["5", "30", "--cells", "10", "--energy-ratio", "1.01"],
         ["5", "30", "--cells", "10", "--objective", "max-energy"],
         ["5", "30", "--cells", "10", "--strain-limit", "1.9e-3"],
         ["5", "30", "--cells", "10", "--tip-floor", "-1e-4", "--strain-limit", "0.1"],
         ["5", "30", "--cells", "10", "--strain-limit", "3e-3", "--energy-ratio", "15"]]
ODD = [None, True, False, 0, 1, -1, 2, 3, 1.5, -0.0, 0.0, 1e-320, 1e308, -1e308, math.inf, -math.inf,
       math.nan, 10 ** 12, -10 ** 18, 2 ** 63, 10 ** 400, -10 ** 400, "", "x", "1", "1/2", "-7/0",
       "1e999999999", "1_0", " 1", "\u0663/\u0664", "\ud800", "none", "found", "right", "left", "lumped", "paper",
       "joints", "farkas", "energy-range", [], [[]], {}, [1], [1, 1], [1, 1, "left"], {"side": "left"},
       {"a": {}}, [[0, 1]], [[0, -1], [0, -1]]]
BYTES = [b"", b"\0", b"\xff", b"\xef\xbb\xbf", b"NaN", b"Infinity", b"1e999", b"-", b",", b"{", b"[", b"]",
         b"}", b'"', b"\\", b"\\ud800", b"0", b"9" * 30, b"9" * 5000, b"[" * 100_000, b'{"a":' * 100_000,
         b"/*", b"'", b"true", b"null", b".5", b"e5", b"\n", b'"status":"none",']
CLAIM = ("status", "cells", "schedule", "stops", "segments")


def places(value, way=()):
    """Ways to every value of a JSON answer."""
    found = [way]
    parts = value.items() if isinstance(value, dict) else \
        enumerate(value) if isinstance(value, list) else []
    for key, part in parts:
        found += places(part, (*way, key))
    return found


def spoil(draw, answer):
    """The answer with one value, key or place of its structure changed."""
    what = draw.choice(["certificate", "stops", "segments", "schedule", "bar", None, None])
    ways = [way for way in places(answer) if way and (what is None or way[0] == what)]
    if not ways:
        return
    *way, key = draw.choice(ways)
    part = answer
    for step in way:
        part = part[step]
    value, kind = part[key], draw.randrange(8)
    if kind == 0 or (kind > 4 and type(value) not in (int, float)):
        part[key] = copy.deepcopy(draw.choice(ODD))
    elif kind == 1:
        del part[key]
    elif kind == 2 and isinstance(part, list):
        part.insert(draw.randrange(len(part) + 1), copy.deepcopy(value))
    elif kind == 3 and isinstance(part, dict):
        part[draw.choice([*answer, *part])] = part.pop(key)
    elif kind == 4:
        part[key] = draw.choice([[value], {"x": value}, str(value)])
    elif kind > 4:
        part[key] = draw.choice([value + 1, value - 1, -value, 2 * value, float(value), str(value),
                                 value + 1e-9, value * (1 + 1e-9)])


def damage(draw, answer):
    """The text of a spoilt answer."""
    if draw.random() < 0.6:
        answer = copy.deepcopy(answer)
        for _ in range(draw.choice([1, 1, 1, 2, 4])):
            spoil(draw, answer)
        return json.dumps(answer).encode()
    text = json.dumps(answer).encode()
    for _ in range(draw.choice([1, 1, 2, 5])):
        at = draw.randrange(len(text) + 1)
        text = draw.choice([text[:at], text[:at] + draw.randbytes(1) + text[at + 1:],
                            text[:at] + text[at + draw.randrange(40):],
                            *[text[:at] + draw.choice(BYTES) + text[at:]] * 3])
    return text.decode("latin-1").encode("utf-16") if draw.random() < 0.02 else text


def limits(answer):
    return {name: answer["certificate"].get(name) for name in ("strain_limit", "tip_floor")}


def question(answer):
    """Words of the program for the schedule and the bar of an answer."""
    stops = {stop["side"]: stop["place"] for stop in
             answer.get("stops", [{"side": "right", "place": 1}])}
    words = ["--gap", repr(float(stops["right"]))]
    if stops["right"] == 0 and "left" not in stops:
        words += ["--energy", "1"]
    if "left" in stops:
        words += ["--second-stop", repr(-float(stops["left"]))]
    if answer.get("segments"):
        words += ["--segments", ",".join(f"{s['cells']}:{s['impedance']!r}:1:{s['dashpot']!r}"
                                         for s in answer["segments"])]
    else:
        words += ["--cells", str(answer["cells"])]
    for name, limit in limits(answer).items():
        if limit is not None:
            words += ["--" + name.replace("_", "-"), repr(limit * (abs(stops["right"]) or 1))]
    for contact, free, *stop in answer["schedule"]:
        words += [("L:" if stop == ["left"] else "") + str(contact), str(free)]
    return words


def cancels(answer):
    """Do the paper's rows with their multipliers add up to 0 for a random state, marched?"""
    cells, certificate, draw = answer["cells"], answer["certificate"], random.Random(1)
    lists = {name: certificate.get(name, []) for name in
             ("periodicity", "pressure", "penetration", "landing")}
    rows = {name: dict(map(tuple, pairs)) for name, pairs in lists.items()}
    if any(len(rows[name]) < len(lists[name]) for name in rows) or \
            min([0, *rows["pressure"].values(), *rows["penetration"].values()]) < 0:
        return False
    a, b = [[draw.randrange(-10 ** 30, 10 ** 30) for _ in range(cells)] for _ in range(2)]
    start, pressed, flown, sized = a + b, 0, 0, certificate.get("size", 0)
    total = certificate["gap"] * (sum(b) - sum(a))
    for k, (contact, free, *_) in enumerate(answer["schedule"]):
        counted = contact if contact < 2 * cells else 2 * cells + contact % (2 * cells)
        for m in range(contact):
            total += a[-1] * ((sized if m < counted else 0) - rows["pressure"].pop(pressed, 0))
            a, b, pressed = [-b[0]] + a[:-1], b[1:] + [-a[-1]], pressed + 1
        way = 0
        for _ in range(free):
            way += a[-1]
            total += way * rows["penetration"].pop(flown, 0)
            a, b, flown = [-b[0]] + a[:-1], b[1:] + [a[-1]], flown + 1
        total += way * rows["landing"].pop(k, 0)
    total += sum((a + b)[row] * value - start[row] * value
                 for row, value in rows.pop("periodicity").items())
    gap = answer.get("stops", [{"place": 1}])[0]["place"]
    right = certificate["gap"] * gap if gap else sized
    return total == 0 and right < 0 and not any(rows.values())


def energies(answer):
    ends = answer.get("energy_ratio_range")
    return [answer.get("energy_ratio"), *(ends or [None, None])]


def is_true(case, answer, original):
    """Is what the spoilt answer says of its schedule so?"""
    certificate = answer["certificate"]
    if certificate["rows"] == "paper" and not cancels(answer):
        return False
    if certificate["kind"] == "farkas" and \
            all(answer.get(name) == original.get(name) for name in CLAIM) and \
            limits(answer) == limits(original):
        return True
    words = ["find", *question(answer), "--quiet", "--format", "json"]
    demands = {"max-energy": ["--objective", "max-energy"]}.get(answer.get("objective"), [])
    if certificate["kind"] == "energy-range" and answer["status"] == "none":
        demands = ["--energy-ratio", repr(float(certificate["energy_ratio"]))]
    outcome = case.run(words + demands)
    if outcome.status != (FOUND if answer["status"] == "found" else NONE):
        return False
    if certificate["kind"] == "farkas":
        return True
    truth = json.loads(outcome.out)
    said = [(mine, its) for mine, its in zip(energies(truth), energies(answer))]
    if answer["status"] == "none" or answer.get("objective") not in ("min-energy", "max-energy"):
        said = said[1:]
    return all(its is None or abs(mine - its) <= 1e-7 * mine for mine, its in said)


def call(case, tool, *names):
    """Runs a tool in the case's folder within a memory; status and what it said."""
    words = [tool, *map(str, names)]
    try:
        done = subprocess.run(
            [sys.executable, "-EsSB", TOOLS / tool, *map(str, names)], cwd=case.folder,
            stdin=subprocess.DEVNULL, capture_output=True, timeout=60, check=False,
            preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY)))
    except subprocess.TimeoutExpired:
        case.fault(words, "no end within 60 s")
        return None, b""
    text = done.stdout if done.returncode == 0 or tool != "lift-certificate" else done.stderr
    lines = (done.stderr if done.returncode == 2 else text).split(b"\n")
    expected = {0: b"{" if tool == "lift-certificate" else str(names[0]).encode() + b": ",
                1: str(names[0]).encode() + b": no", 2: str(names[0]).encode() + b": "}
    if done.returncode not in expected:
        case.fault(words, f"status {done.returncode}: {done.stderr[-300:]!r}")
    elif len(lines) != 2 or not lines[0].startswith(expected[done.returncode]) or \
            (done.returncode == 2 and done.stdout):
        case.fault(words, f"status {done.returncode} with {done.stdout!r}, {done.stderr!r}")
    return done.returncode, done.stdout


def judge_certificate(case, proofs):
    original = case.random.choice(proofs)
    text = damage(case.random, original)
    (case.folder / "proof.json").write_bytes(text)
    status, _ = call(case, "check-certificate", "proof.json")
    if status == 0 and not is_true(case, json.loads(text), original):
        case.fault(["check-certificate"], f"proved: {text!r}")
    if case.random.random() < 0.3:
        lifted, content = call(case, "lift-certificate", "proof.json")
        if lifted == 0 and (status != 0 or not cancels(json.loads(content))):
            case.fault(["lift-certificate"], f"lifted: {text!r}")
    return {0: "proved", 1: "no proof", 2: "unreadable"}.get(status, "broken")


def judge_apart(case, pair):
    answer, files = pair
    for name, content in files.items():
        (case.folder / name).write_bytes(content)
    text = damage(case.random, answer)
    if case.random.random() < 0.3:  # a state instead
        text, name = json.dumps(answer).encode(), case.random.choice(list(files))
        fields = files[name].split(b",")
        fields[case.random.randrange(len(fields))] = case.random.choice(
            [b"", b"nan", b"inf", b"1e999", b"x", b"1", b"-1e-3", b"\xff", b"\n", b'"', b"a"])
        (case.folder / name).write_bytes(b",".join(fields))
    (case.folder / "answer.json").write_bytes(text)
    status, _ = call(case, "check-apart", "answer.json", *files)
    if status == 0:
        kept = ("connected", "cells", "schedule")
        told = json.loads(text)
        if any(told[name] != answer[name] for name in kept) or \
                abs(told["energy_ratio"] / answer["energy_ratio"] - 1) > 1e-8:
            case.fault(["check-apart"], f"apart: {text!r}")
    return {0: "apart", 1: "not shown", 2: "unreadable"}.get(status, "broken")


def told_by(path):
    """What check-atlas vouches for: each schedule and each family with its numbers."""
    database = sqlite3.connect(path)
    try:
        return [[round(value, 9) if isinstance(value, float) else value for value in row]
                for table in (
                    "cells, phases, steps, period, frequency_ratio, status, kernel_dimension, kind, dimension, contact,"
                    " canonical, family, energy_ratio_min, energy_ratio_max FROM schedules",
                    "cells, phases, family_order, nu, contact_blocks, steps, period, frequency_ratio, contact, kind,"
                    " dimension, energy_ratio_min, energy_ratio_max, schedules, id FROM families")
                for row in database.execute(f"SELECT {table} ORDER BY cells, phases")]
    finally:
        database.close()


def judge_atlas(case, whole):
    path = Path(shutil.copy(whole, case.folder / "atlas.sqlite"))
    done = damaged_databases.damage(case.random, path)
    status, _ = call(case, "check-atlas", path.name)
    if status == 0 and told_by(path) != told_by(whole):
        case.fault(["check-atlas"], f"complete: {done}")
    return {0: "complete", 1: "incomplete", 2: "unreadable"}.get(status, "broken")


def pair_apart(program, folder):
    """Two motions that no curve joins: one amplitude of five is nearly everything, another in the other."""
    files = {}
    for name, place in (("one.csv", 1), ("two.csv", 3)):
        z = [5e-3 * (0.9 if k == place else 0.025) for k in range(5)]
        a, b = [-value for value in z[::-1]] + z[::-1], z + z
        files[name] = b"a,b\n" + b"".join(b"%r,%r\n" % pair for pair in zip(a, b))
        (folder / name).write_bytes(files[name])
    ratio = 20 * (0.81 + 4 * 0.025 ** 2)
    call_ = [program, "continuum", "5", "30", "--cells", "10", "--energy-ratio", repr(ratio), "--points",
             "3", "--from", folder / "one.csv", "--to", folder / "two.csv", "--format", "json"]
    return json.loads(subprocess.run(call_, capture_output=True, check=False).stdout), files


def main():
    given = arguments(__doc__.split("\n")[0], 3_000)
    with tempfile.TemporaryDirectory() as name:
        folder, proofs = Path(name), []
        for words in ASKED:
            path = folder / "proof.json"
            subprocess.run([given.program, "find", *words, "--quiet", "--certificate", path],
                           check=False, capture_output=True)
            proofs.append(json.loads(path.read_bytes()))
        whole = folder / "atlas.sqlite"
        subprocess.run([given.program, "atlas", "--cells", "4", "--all", "--quiet", "--database", whole],
                       check=True, capture_output=True)
        pair = pair_apart(given.program, folder)

        def judge(case):
            kind = case.random.randrange(10)
            return judge_certificate(case, proofs) if kind < 7 else \
                judge_apart(case, pair) if kind == 7 else judge_atlas(case, whole)

        campaign(given, "damaged proofs", judge,
                 ["proved", "no proof", "apart", "not shown", "complete", "incomplete", "unreadable"])


if __name__ == "__main__":
    main()
