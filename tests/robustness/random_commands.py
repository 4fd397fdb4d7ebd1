#!/usr/bin/env python3
"""Random command lines, right and wrong: no crash, no hang, no wrong status, no file left behind.

A wrong call (status 2) prints one line and leaves the folder as it was; an answer in JSON is
valid and says what the exit status says.
"""

import os
import pathlib
import shutil
import subprocess
import tempfile

from campaign import (FOUND, NONE, UNAVAILABLE, UNDECIDED, WRONG_USE, arguments, campaign, snapshot,
                      strict_json)

NASTY = ["", " ", "0", "-1", "-0", "nan", "-nan", "inf", "-inf", "1e400", "1e-400", "-1e300",
         "9223372036854775808", "99999999999999999999999", "-9223372036854775809", "0x10", "1e3",
         "+3", " 3", "3 ", "3x", "3,5", "1/0", "0/0", "7/", "/2", "٣", "½", "−5", "NaN", "true",
         "null", "--", "-", "---", "-x", "--cells", "=", "a=b", "%s%n", "\n", "\t3", "\x1b[31m",
         "\x7f", "x\ny", "é.csv", b"\xff\xfe", b"\xc3", "a" * 5000, "9" * 400, "1e9999999999"]
COMMANDS = ["find", "continuum", "modes", "mode", "families", "atlas",
            "response", "simulate"]
WORDS = [*COMMANDS, "help", "", "--help", "-h", "--version", "-V", "--frobnicate", "--cell",
         "--formatt=json", "-5", "7", "--quiet=no", "--quiet", "@file"]

COUNTS = ["1", "2", "3", "4", "5", "7", "8", "12"]
REALS = ["1", "0.5", "2", "1e-3", "4", "20", "1e6", "3.25", "1e-12", "1e300", "5e-324"]
READ = ["state.csv", "other.csv", "measured.csv", "text.txt", "empty", "folder", "missing.csv", "atlas.sqlite",
        "/dev/null", "no/such/folder.csv", "state.csv/x"]
TABLES = ["out.csv", "out.vtk", "out.pvd", "busy.pvd", "state.csv", "folder", "no/such/out.csv", "out.pdf", "out",
          "/dev/null", "folder/out.csv", "text.txt/out.csv", "ünï code.csv", "-out.csv"]
PICTURES = ["out.svg", "out.gif", "folder", "no/such/out.svg", "state.csv/out.svg", "out"]
MOVING = ["out.gif", "out.mp4", "folder", "no/such/out.gif", "out.svg", "out"]
DATABASES = ["atlas.sqlite", "new.sqlite", "state.csv", "empty", "folder", "no/such.sqlite",
             "text.txt", "/dev/null", ":memory:", "file:x?mode=ro"]
COMMON = {"--cells": COUNTS, "--length": REALS, "--wave-speed": REALS, "--axial-stiffness": REALS,
          "--gap": REALS, "--young": REALS, "--density": REALS, "--area": REALS,
          "--format": [*["json"] * 9, *["text"] * 2, "xml"], "--quiet": None,
          "--threads": ["1", "2", "3"], "--help": None}
FORCES = ["tip", "base", "tip", "base", "rope"]
STEPS = [*COUNTS, *COUNTS, "10", "15", "18", "20", "27", "41", "1000000000000000000"]
OPTIONS = {
    "find": {"--solver": ["auto", "closed-form", "glpk-simplex", "glpk-interior", "glpk-exact",
                          "ipopt", "nlopt-slsqp", "mosek"],
             "--formulation": ["auto", "state", "reduced", "lumped", "joints"],
             "--objective": ["any", "min-energy", "max-energy", "min-peak-strain", "max-impulse",
                             "nearest", "best"],
             "--target": READ, "--energy-ratio": REALS, "--strain-limit": REALS,
             "--energy": REALS, "--yield-stress": REALS, "--hertz": REALS,
             "--period": ["7/2", "3.5", "10/3", "4", "5", "22/7", "1/1000000007"],
             "--frequency": ["8/7", "1.25", "1", "3", "6/5", "1.1428571428571428"],
             "--tip-floor": ["-1", "-0.01", "-1e-3", "0", "1e-3", "-0.5"], "--tolerance": REALS,
             "--time-limit": ["1e-9", "0.1", "1"], "--state": TABLES, "--motion": TABLES,
             "--damping": ["0.01", "0.1", "0", "-1"], "--force": FORCES, "--amplitude": REALS,
             "--cycles": COUNTS, "--figure": PICTURES, "--animate": MOVING},
    "continuum": {"--energy-ratio": REALS, "--points": ["2", "3", "10"], "--from": READ,
                  "--to": READ, "--direction": READ, "--sample": None, "--seed": COUNTS,
                  "--engine": ["auto", "geometric", "ipopt", "nlopt", "hand"],
                  "--strain-limit": REALS, "--tolerance": REALS, "--csv": TABLES,
                  "--member": ["0", "0.1", "0.25", "1", "3"], "--state": TABLES,
                  "--figure": PICTURES, "--animate": MOVING},
    "modes": {"--max-energy-ratio": REALS, "--max-order": COUNTS, "--max-period": REALS,
              "--csv": TABLES, "--figure": PICTURES},
    "families": {"--max-energy-ratio": REALS, "--max-order": [*COUNTS, "60"], "--csv": TABLES,
                 "--figure": PICTURES},
    "mode": {"--period": ["3.5", "7/2", "3.14159265358979", "10/3", "2.5", "3", "4", "29/11"],
             "--state": TABLES, "--motion": TABLES, "--figure": PICTURES,
             "--animate": MOVING},
    "atlas": {"--database": DATABASES, "--max-contact": COUNTS, "--max-free": COUNTS,
              "--phases": ["1", "2"], "--max-energy-ratio": REALS, "--all": None,
              "--families-only": None, "--resume": None,
              "--near": [*REALS, "8/7", "1/0"], "--within": REALS, "--schedules": None,
              "--period": ["7/2", "3.5", "4", "10/3", "1/1000000007"], "--twins": None,
              "--figure": PICTURES, "--map": PICTURES, "--csv": TABLES},
    "response": {"--damping": ["0.01", "0.1", "1", "0", "-1"], "--force": FORCES,
                 "--amplitude": REALS, "--from": ["0.5", "1", "1.9", "3"],
                 "--to": ["0.6", "1.2", "2", "3"], "--cycles": COUNTS, "--stability": None,
                 "--csv": TABLES, "--figure": PICTURES},
    "simulate": {"--from": READ, "--rest": None, "--damping": ["0.01", "0.1", "1", "0", "-1"],
                 "--force": FORCES, "--amplitude": REALS, "--frequency": ["0.5", "1", "1.1", "3"],
                 "--phase": ["0", "-1", "3.14"], "--time": ["1", "0.5", "20", "1e-12", "1e300"],
                 "--periods": COUNTS, "--events": TABLES, "--tip": TABLES, "--figure": PICTURES},
}
MATERIAL = {"--young", "--density", "--area"}
# Options that make sense together; what they clash with.
TOGETHER = [(MATERIAL, MATERIAL, {"--wave-speed", "--axial-stiffness"}),
            ({"--target"}, {"--objective"}, set()),
            ({"--energy"}, set(), {"--energy-ratio"}),
            ({"--period"}, set(), {"--frequency", "--hertz"}),
            ({"--frequency"}, set(), {"--hertz"}),
            ({"--yield-stress"}, {"--young"}, set()),
            ({"--time-limit"}, {"--solver"}, set()),
            ({"--from"}, {"--to"}, {"--direction", "--sample"}),
            ({"--member"}, {"--state"}, set()),
            ({"--within"}, {"--near"}, {"--period", "--twins"}),
            ({"--families-only"}, set(), {"--all", "--phases", "--map"}),
            ({"--schedules"}, {"--near"}, {"--period", "--twins"}),
            ({"--force"}, {"--amplitude"}, set()),
            ({"--time"}, set(), {"--periods"}), ({"--rest"}, set(), {"--from"}),
            ({"--near", "--period", "--twins"}, set(),
             {"--max-contact", "--max-free", "--phases", "--max-energy-ratio", "--all",
              "--families-only", "--resume"})]
OUTPUTS = {"--animate", "--state", "--motion", "--figure", "--csv", "--map", "--database",
           "--events", "--tip"}
STATUS_OF = {"found": FOUND, "done": FOUND, "none": NONE, "undecided": UNDECIDED,
             "interrupted": UNDECIDED}


def value_for(case, pool, nasty):
    return case.random.choice(NASTY if case.random.random() < nasty else pool)


def options_of(case, command, nasty):
    """Some options with values, as lists of words that belong together."""
    known = {**OPTIONS[command], **COMMON}
    chosen = case.random.sample(list(OPTIONS[command]), case.random.choice([0, 1, 1, 2, 2, 3, 4]))
    chosen += case.random.sample(list(COMMON), case.random.choice([0, 0, 1, 1, 2, 5]))
    chosen = list(dict.fromkeys([*chosen, "--format"] if case.random.random() < 0.5 else chosen))
    if case.random.random() < 0.8:
        chosen = ["--cells", *(name for name in chosen if name != "--cells")]
    if command == "atlas" and case.random.random() < 0.9:
        chosen = ["--database", *(name for name in chosen if name != "--database")]
    if command == "continuum" and case.random.random() < 0.9:
        chosen = ["--energy-ratio", *(name for name in chosen if name != "--energy-ratio")]
    usual = {"response": ["--damping", "--force", "--amplitude"], "simulate": ["--time"]}
    if command in usual and case.random.random() < 0.8:
        chosen = list(dict.fromkeys([*usual[command], *chosen]))
    if command == "find" and case.random.random() < 0.05:
        return [["--cells", "12"], ["--time-limit", "1e-9"], ["--format", "json"],
                ["--solver", case.random.choice(["ipopt", "nlopt-slsqp", "glpk-interior"])],
                ["--formulation", case.random.choice(["state", "reduced"])]]
    if case.random.random() > nasty:
        for some, needed, clashing in TOGETHER:
            if some & set(chosen):
                chosen = [name for name in chosen if name not in clashing]
                chosen += sorted(name for name in needed if name not in chosen and name in known)
    groups = []
    for name in chosen:
        # gnuplot takes a second: drawn now and then only.
        if name in ("--figure", "--map", "--animate", "--help") and case.random.random() < 0.9:
            continue
        count = 2 if name == "--near" and case.random.random() < 0.9 else 1
        values = [value_for(case, known[name], nasty) for _ in range(count if known[name] else 0)]
        if name == "--objective" and "--target" in chosen and case.random.random() > nasty:
            values = ["nearest"]
        if values and case.random.random() < 0.15:
            groups.append([b"=".join(map(os.fsencode, [name, values[0]])), *values[1:]])
        else:
            groups.append([name, *values])
    return groups


def spoil(case, words):
    """One mistake, as people and scripts make them."""
    words = list(words)
    at = case.random.randrange(len(words) + 1)
    kind = case.random.randrange(6)
    if kind == 0:
        words.insert(at, case.random.choice(NASTY))
    elif kind == 1:
        words.insert(at, case.random.choice(WORDS))
    elif kind == 2 and at < len(words):
        del words[at]
    elif kind == 3 and at < len(words):
        words.insert(at, words[at])
    elif kind == 4:
        case.random.shuffle(words)
    else:
        words = words[:at]
    return words


def command_line(case):
    command = case.random.choice([*COMMANDS, "find", "atlas"])
    nasty = case.random.choice([0.0, 0.0, 0.05, 0.3])
    groups = options_of(case, command, nasty)
    asks = any(group[0] in ("--period", "--frequency", "--hertz") for group in groups)
    if command == "continuum" or (command == "find" and not (asks and case.random.random() < 0.9)):
        pairs = case.random.choice([1, 1, 1, 1, 2, 3])
        groups.append([value_for(case, STEPS, nasty) for _ in range(2 * pairs)])
    if command == "mode":
        contact = case.random.choice([["4", "-1"], ["8", "-3"], ["4", "-3"], ["12", "-5"]])
        groups.append([value_for(case, [word], nasty) for word in contact])
        if case.random.random() < 0.9 and all(group[0] != "--period" for group in groups):
            groups.append(["--period", value_for(case, OPTIONS["mode"]["--period"], nasty)])
    case.random.shuffle(groups)
    words = [command, *(word for group in groups for word in group)]
    while case.random.random() < nasty:
        words = spoil(case, words)
    # An argument ends at its first NUL, and there is none in it.
    return [os.fsencode(word) for word in words]


def too_much(words):
    """Work that was asked for and takes its time: the default grid of 300 cells."""
    texts = [os.fsdecode(word) for word in words]
    isLong = "atlas" in texts or "response" in texts
    return isLong and not any(text.startswith("--cells") for text in texts)


def only_explains(outcome):
    """Did --help or --version answer?"""
    return b"Usage:" in outcome.out or outcome.out.startswith(b"signorini ")


def judge_json(case, words, outcome):
    asked = [os.fsdecode(word) for word in words]
    isJson = ("json" in asked and "--format" in asked) or "--format=json" in asked
    if only_explains(outcome) or not isJson:
        return
    if not outcome.out and outcome.status == UNDECIDED:
        return  # ended before there was an answer; stderr says why
    if not outcome.out and asked[0] == "atlas" and outcome.status == FOUND:
        return  # a picture of an atlas that exists
    try:
        answer = strict_json(outcome.out)
    except ValueError as error:
        case.fault(words, f"no JSON: {error}: {outcome.out[:200]!r}")
        return
    if "status" in answer and STATUS_OF.get(answer["status"]) != outcome.status:
        case.fault(words, f"JSON says {answer['status']}, the exit status {outcome.status}")


def judge_files(case, words):
    """After a success the files that were asked for exist."""
    texts = [os.fsdecode(word) for word in words]
    pairs = [text.split("=", 1) for text in texts if "=" in text] + list(zip(texts, texts[1:]))
    for option, name in pairs:
        if option in OUTPUTS and not (case.folder / name).exists():
            case.fault(words, f"success without the file {name}")


def judge(case, template):
    shutil.copytree(template, case.folder, dirs_exist_ok=True)
    words = command_line(case)
    while too_much(words):
        words = command_line(case)
    outcome = case.run(words)
    if outcome.status in (FOUND, NONE, UNDECIDED):
        judge_json(case, words, outcome)
    if outcome.status in (FOUND, NONE) and b"--quiet" in words and outcome.err:
        case.fault(words, f"not quiet: {outcome.err!r}")
    if outcome.status == FOUND and not only_explains(outcome):
        judge_files(case, words)
    if outcome.status == UNDECIDED and not outcome.out and not outcome.err:
        case.fault(words, "undecided, and not a word why")
    if outcome.status == WRONG_USE and snapshot(case.folder) != snapshot(template):
        case.fault(words, "a usage error changed files")
    return f"status {outcome.status}"


def make_template(program, folder):
    """The files that command lines may name."""
    def make(*words):
        subprocess.run([program, *words], cwd=folder, check=True, capture_output=True)
    make("find", "3", "18", "--cells", "6", "--state", "state.csv")
    make("find", "2", "12", "--cells", "4", "--state", "other.csv")
    make("atlas", "--cells", "4", "--database", "atlas.sqlite")
    (folder / "measured.csv").write_text(
        "x;v;s\n" + "".join(f"{k / 40};{(-1) ** k * 1e-4};-2e-3\n" for k in range(41)),
        encoding="ascii")
    (folder / "busy_files").mkdir()
    (folder / "busy_files" / "thesis.txt").touch()
    (folder / "text.txt").write_text("neither a table nor a database\n", encoding="utf-8")
    (folder / "empty").touch()
    (folder / "folder").mkdir()


def main():
    given = arguments(__doc__, 20_000)
    with tempfile.TemporaryDirectory() as name:
        template = pathlib.Path(name)
        make_template(given.program, template)
        campaign(given, "command lines", lambda case: judge(case, template),
                 [f"status {status}" for status in (FOUND, NONE, WRONG_USE, UNAVAILABLE)])


if __name__ == "__main__":
    main()
