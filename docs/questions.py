#!/usr/bin/env python3
"""Makes docs/questions.md: what can be asked of which scene, as the program itself answers.

    docs/questions.py [--check] [--program FILE]

Each cell is a run of the program with one question, one scene and one demand: a dot where it answers
(found, none or undecided), else the number of the reason, which is what the program says. With --check
nothing is written, and what is stale is shown. Options that a command has and this file does not know
are a fault, so that the table is whole.
"""

import argparse
import ast
import difflib
import os
import re
import shlex
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
PAGE = ROOT / "docs/questions.md"

#: Scenes: what the program is given, and where one of them writes a schedule in its own way.
SCENES = {
    "one stop": "--cells 12",
    "two stops": "--cells 12 --second-stop 2e-3",
    "pressed": "--cells 12 --gap -1e-4",
    "stepped": "--segments 6:1,6:2",
    "two bars": "--scene 'clamp 6 gap=1e-3 6 clamp'",
    "flying": "--scene 'stop=-1e-3 8 stop=1e-3'",
    "soft root": "--scene 'spring=2 6 stop=1e-3'",
}
DRIVEN = {
    "two bars": "--scene 'clamp 6 dash=0.2 driven gap=1e-3 6 clamp'",
    "flying": "--scene 'stop=-1e-3 8 dash=0.2 driven stop=1e-3'",
    "soft root": "--scene 'spring=2 6 dash=0.2 driven stop=1e-3'",
}
FORCE = "--damping 0.02 --force tip --amplitude 2e-3"
#: On scenes of several bars dashpots stand among the words.
OWN_FORCE = "--force tip --amplitude 2e-3"
#: Question: command, its words, and the call of Python that answers it.
QUESTIONS = {
    "A motion of a schedule": ("find", "6 36", "find"),
    "All motions of a period": ("find", "--period 7/2", "find"),
    "A forced motion of a schedule": ("find", "6 42 {force}", "find"),
    "All motions of a period under a harmonic force": ("find", "--frequency 1.1 {force}", "find"),
    "Motions of one schedule and energy": ("continuum", "6 36 --energy-ratio 9", "continuum"),
    "Families": ("families", "--max-order 3", "families"),
    "Modes": ("modes", "--max-order 2 --max-period 3", "modes"),
    "The motion of a mode": ("mode", "4 -1 --period 3.14", "mode"),
    "An atlas": ("atlas", "--database {folder}/new.sqlite --max-contact 4 --max-free 8", "Atlas"),
    "A query of an atlas": ("atlas", "--database {folder}/known.sqlite --period 4", "Atlas"),
    "Response to a staircase of forces": ("response", "{force} --from 1 --to 1.1", "response"),
    "Response to the harmonic itself": ("response", "--exact {force} --from 1.05 --to 1.1", "exact_response"),
    "Simulation": ("simulate", "--rest --periods 2 --frequency 1 {force}", "simulate"),
    "Sweep": ("sweep", "--periods 5 --points 2 --from 1 --to 1.1 {force}", "sweep"),
}
#: Where a scene needs other words.
OTHERWISE = {("The motion of a mode", "pressed"): "4 -1 --period 2.5",
             ("Motions of one schedule and energy", "flying"): "6 36 --energy 1e-5",
             # Three motions, not eleven, which to disturb takes half a minute.
             ("All motions of a period", "stepped", "--stability"): "--period 5/6"}
#: Demands: an example of each. The text of the program says what they do.
DEMANDS = {
    "--solver": "auto", "--formulation": "kernel", "--objective": "max-energy", "--target": "{folder}/state.csv",
    "--energy-ratio": "9", "--energy": "1e-5", "--points": "5", "--sample": "", "--seed": "1", "--engine": "auto",
    "--strain-limit": "0.1", "--resolution": "0.2", "--tip-floor": "-0.1", "--tolerance": "1e-6",
    "--time-limit": "10", "--member": "0", "--cycles": "1", "--contacts": "2", "--band": "0.04",
    "--force-steps": "60", "--max-energy-ratio": "20", "--phases": "1", "--all": "", "--families-only": "",
    "--within": "0.01", "--schedules": "", "--resolve": "0.1", "--up": "", "--down": "", "--stability": "",
    "--yield-stress": "1e3", "--certificate": "{folder}/proof.json", "--state": "{folder}/state_out.csv",
    "--motion": "{folder}/motion.vtk", "--figure": "{folder}/figure.svg", "--animate": "{folder}/moving.gif",
    "--csv": "{folder}/table.csv", "--map": "{folder}/map.svg", "--map-csv": "{folder}/map.csv",
    "--backbone-csv": "{folder}/backbone.csv", "--bifurcation": "{folder}/bifurcation.svg",
    "--events": "{folder}/events.csv", "--statistics": "{folder}/statistics.csv", "--tip": "{folder}/tip.csv",
    "--threads": "2", "--gravity": "2e-4",
}
#: Bars of one segment, whose unknowns are others.
UNIFORM = ("one stop", "two stops", "pressed")
#: Options that are the question, the scene or the way of printing.
OTHERS = set("""--help --version --period --frequency --hertz --from --to --direction --damping --force --amplitude
    --amplitude-velocity --amplitude-acceleration --phase --from-hertz --to-hertz --exact --over --rest --time
    --periods --force-file --force-range --velocity --max-order --max-period --database --max-contact --max-free
    --resume --near --twins --scene --cells --length --wave-speed --axial-stiffness --gap --second-stop --segments
    --segments-file --young --density --area --diameter --format --quiet --verbose --progress""".split())
#: Schedules with states of several bars.
STATES = {"two bars": "1:6 -:18", "flying": "1:16 -:24 2:16 -:24", "soft root": "1:3 -:24"}
#: What a demand needs beside it to mean anything.
WITH = {("find", "--target"): "--objective nearest", ("continuum", "--member"): "--state {folder}/state_out.csv",
        ("continuum", "--state"): "--member 0", ("response", "--band"): "--contacts 2",
        ("response", "--force-steps"): "--figure {folder}/figure.svg"}
YIELDING = " --young 1e4 --density 1 --area 1e-4"  # EA = 1 N, as where nothing is said
#: What it takes the place of in the question.
INSTEAD = {"--energy": r"--energy(-ratio)? \S+"}


class Asker:
    """Runs the program; each run in a folder of its own."""

    def __init__(self, program, folder):
        self.program, self.folder = program, folder
        self.folder, self.state = folder, folder / "state.csv"
        of_bars = [f"find {words} {SCENES[scene]} --state '{folder}/{scene}.csv'" for scene, words in STATES.items()]
        known = [f"atlas {given} --database '{folder}/{scene}.sqlite' --max-contact 4 --max-free 8"
                 for scene, given in SCENES.items()]
        for words in (*known, f"find 6 36 --cells 12 --state {self.state}", *of_bars):
            subprocess.run([program, *shlex.split(words)], check=True, capture_output=True)

    def run(self, words):
        """None where it answers, else why not."""
        with tempfile.TemporaryDirectory(dir=self.folder) as folder:
            for path in (*self.folder.glob("*.sqlite"), *self.folder.glob("*.csv")):
                Path(folder, path.name).write_bytes(path.read_bytes())
            given = shlex.split(words.format(folder=folder, force="{force}"))
            done = subprocess.run([self.program, *given, "--quiet"], capture_output=True, text=True, check=False,
                                  timeout=300)
            if done.returncode in (0, 1, 3):
                return None
            said = done.stderr.strip().splitlines()[-1] if done.stderr.strip() else f"status {done.returncode}"
            said = re.sub(r"^signorini[^:]*: ", "", said.replace(folder + "/", ""))
            return re.sub(r"^--scene '[^']*': ", "", said)

    def options(self, command):
        text = subprocess.run([self.program, command, "--help"], capture_output=True, text=True, check=True).stdout
        found = set(re.findall(r"(?m)^  (?:-h,)?(--[a-z-]+)", text))
        if unknown := found - set(DEMANDS) - OTHERS:
            sys.exit(f"docs/questions.py does not know {', '.join(sorted(unknown))} of signorini {command}")
        return [name for name in DEMANDS if name in found]


def words_of(question, scene, demand=None):
    """What is typed."""
    command, words, _ = QUESTIONS[question]
    words = OTHERWISE.get((question, scene, demand), OTHERWISE.get((question, scene), words))
    words = words.replace("{folder}/known.sqlite", f"'{{folder}}/{scene}.sqlite'")
    given = SCENES[scene]
    if "{force}" in words:
        words = words.replace("{force}", OWN_FORCE if scene in DRIVEN else FORCE)
        given = DRIVEN.get(scene, given)
    if command in ("find", "continuum") and "--scene" in given:
        words = re.sub(r"^6 (36|42)", r"1:6 -:\1", words)
    if demand:
        words = re.sub(INSTEAD.get(demand, "\0"), "", words)
        value = DEMANDS[demand]
        if demand == "--target" and scene in STATES:
            value = f"'{{folder}}/{scene}.csv'"
        if demand == "--formulation" and scene in UNIFORM:
            value = "state"
        words += f" {demand} {value} {WITH.get((command, demand), '')}"
        words += YIELDING if demand == "--yield-stress" else ""
    return f"{command} {words} {given}"


def calls_of_python():
    """The names that the package has, read from its text."""
    tree = ast.parse((ROOT / "python/signorini/__init__.py").read_text("utf-8"))
    return {alias.name for node in tree.body if isinstance(node, ast.ImportFrom) for alias in node.names}


def table_of(question, demands, said):
    """Rows of demands, columns of scenes, and the reasons below."""
    reasons = []

    def mark(demand, scene):
        if demand and said[question, scene, None]:
            return ""  # of a question that is refused
        why = said[question, scene, demand]
        if why and demand:
            why = re.sub(rf"^{demand}\b( = \S+)?", "it", why)
        if why and why not in reasons:
            reasons.append(why)
        return f"{reasons.index(why) + 1}" if why else "●"

    rows = [[f"`{demand}`" if demand else "the question", *(mark(demand, scene) for scene in SCENES)]
            for demand in (None, *demands)]
    lines = [" | ".join(row) for row in [["", *SCENES], ["---", *[":-:"] * len(SCENES)], *rows]]
    notes = [f"{k}. {why}" for k, why in enumerate(reasons, 1)]
    return [*(f"| {line} |" for line in lines), "", *notes, *([""] if notes else [])]


def page(asker):
    demands = {question: [name for name in asker.options(command) if f"{name} " not in words]
               for question, (command, words, _) in QUESTIONS.items()}
    cells = [(question, scene, demand) for question in QUESTIONS for demand in (None, *demands[question])
             for scene in SCENES]
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        said = dict(zip(cells, pool.map(lambda cell: asker.run(words_of(*cell)), cells)))
    python = calls_of_python()
    lines = ["# What can be asked of which scene", "",
             "<!-- made by docs/questions.py; a test fails when it is stale -->", "",
             "Each mark is an answer of the program to one question, on one scene, with one demand: ● where it",
             "answers, the number of the reason where it refuses, in its own words (*it* is the demand). An option",
             "that is not listed does not belong to the command.",
             "", "| scene | as it was given | driven |", "|---|---|---|",
             *(f"| {scene} | `{words}` | `{DRIVEN.get(scene, '… ' + FORCE)}` |"
               for scene, words in SCENES.items()), ""]
    for question, (command, words, call) in QUESTIONS.items():
        if call not in python:
            sys.exit(f"docs/questions.py: the Python package has no {call}")
        shown = re.sub(r"\{folder\}/", "", words).replace("{force}", "…")
        lines += [f"## {question}", "", f"`signorini {command} {shown}`, in Python `sg.{call}`.", "",
                  *table_of(question, demands[question], said)]
    return "\n".join(lines).rstrip() + "\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--check", action="store_true", help="write nothing; fail where the page is stale")
    parser.add_argument("--program", default=ROOT / "build/release/bin/signorini", type=Path)
    given = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        made = page(Asker(given.program.resolve(), Path(folder)))
    if not given.check:
        PAGE.write_text(made, "utf-8")
    elif made != PAGE.read_text("utf-8"):
        sys.exit("\n".join(["docs/questions.md is stale, docs/questions.py makes it anew:", *difflib.unified_diff(
            PAGE.read_text("utf-8").splitlines(), made.splitlines(), lineterm="", n=0)]))


if __name__ == "__main__":
    main()
