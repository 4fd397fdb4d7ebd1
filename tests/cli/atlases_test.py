#!/usr/bin/env python3
"""Atlases the program makes are complete to a checker that shares no code with it.

atlases_test.py PROGRAM CHECKER [--cells N]

Atlases of all grids up to N cells, of a gap, none and one that presses, of one contact and two, with
one stop and with two, and of random bars of several segments; and none passes any more when one number
of it is changed, or one row taken away.
"""
import argparse
import pathlib
import random
import re
import shutil
import sqlite3
import subprocess
import sys
import tempfile

SPOILT = [
    ("a motion taken away", "DELETE FROM schedules WHERE rowid = {row}", "found"),
    ("a refuted schedule taken away", "DELETE FROM schedules WHERE rowid = {row}", "none"),
    ("a motion called none", "UPDATE schedules SET status = 'none' WHERE rowid = {row}", "found"),
    ("a motion called undecided", "UPDATE schedules SET status = 'undecided' WHERE rowid = {row}", "found"),
    ("a refuted one called found", "UPDATE schedules SET status = 'found' WHERE rowid = {row}", "none"),
    ("a kernel", "UPDATE schedules SET kernel_dimension = kernel_dimension + 1 WHERE rowid = {row}",
     "found"),
    ("least energy",
     "UPDATE schedules SET energy_ratio_min = energy_ratio_min * (1 + {part}) WHERE rowid = {row}", "found"),
    ("most energy",
     "UPDATE schedules SET energy_ratio_max = energy_ratio_max * (1 - {part}) WHERE rowid = {row}", "found"),
    ("a period", "UPDATE schedules SET period = period * 2 WHERE rowid = {row}", "found"),
    ("steps", "UPDATE schedules SET steps = steps + 1 WHERE rowid = {row}", "none"),
    ("a reason", "UPDATE schedules SET reason = 'constraints' WHERE rowid = {row}", "none"),
    ("a count", "UPDATE runs SET pressing = pressing + 1 WHERE {row}", "found"),
    ("an end", "UPDATE runs SET finished = NULL WHERE {row}", "found"),
]
SPOILT_SEGMENTS = [
    ("a proof", "UPDATE schedules SET proof = substr(proof, instr(proof, ' ') + 1) WHERE rowid = {row}",
     "none"),
    ("an impedance", "UPDATE runs SET segments = replace(segments, ':1.3:', ':1.31:') WHERE {row}", "found"),
    ("a dashpot", "UPDATE runs SET segments = replace(segments, ':1:0,', ':1:0.1,') WHERE {row}", "found"),
    ("the gap", "UPDATE runs SET gap_sign = -gap_sign WHERE {row}", "found"),
]


SPOILT_BARS = [
    SPOILT[1], SPOILT[9], ("a proof taken away", "UPDATE schedules SET proof = NULL WHERE rowid = {row}", "none"),
    ("a wave", "UPDATE schedules SET proof = '7 ' || proof WHERE rowid = {row}", "none"),
    ("a node", "UPDATE runs SET segments = replace(segments, ';', ' 1;') WHERE {row}", "none"),
    ("an end", "UPDATE runs SET finished = NULL WHERE {row}", "none"),
]


def made(program, folder, words):
    path = folder / "atlas.sqlite"
    path.unlink(missing_ok=True)
    subprocess.run([program, "atlas", "--database", str(path), "--all", "--quiet", *words], check=True,
                   stdout=subprocess.DEVNULL)
    return path


def checked(checker, path):
    call = subprocess.run([sys.executable, checker, str(path)], capture_output=True, text=True,
                          check=False)
    if call.returncode == 2:
        sys.exit(call.stderr)
    return call.returncode == 0, call.stdout


def spoil(checker, path, draw, spoilt, part):
    """One change after another, each of which has to be refused; how many. Energies by that part."""
    for what, change, status in spoilt:
        bad = shutil.copy(path, path.with_name("spoilt.sqlite"))
        base = sqlite3.connect(bad)
        rows = base.execute("SELECT rowid FROM schedules WHERE status = ? AND "
                            "(energy_ratio_max IS NOT NULL OR reason IS NOT NULL) ORDER BY rowid",
                            (status,)).fetchall()
        changed = base.execute(change.format(row=draw.choice(rows)[0], part=part)).rowcount
        base.commit()
        base.close()
        if changed != 1 or checked(checker, bad)[0]:
            sys.exit(f"spoilt ({what}), and still taken for complete")
    return len(spoilt)


def is_possible(program, folder):
    """Does this build decide schedules of several segments?"""
    call = subprocess.run([program, "atlas", "--database", str(folder / "possible.sqlite"), "--segments",
                           "1:1,1:1.3", "--max-contact", "1", "--max-free", "5", "--quiet"],
                          capture_output=True, check=False)
    return call.returncode == 0


def random_bar(draw, most_cells):
    """--segments of a bar of two segments, or of three and few cells, whose proofs are long."""
    count = draw.choice([2, 2, 3])
    most_cells = min(most_cells, 10 - 2 * count)
    cuts = sorted(draw.sample(range(1, most_cells), count - 1))
    cells = [end - first for first, end in zip([0] + cuts, cuts + [most_cells])]
    impedances = draw.sample([0.2, 0.5, 1, 1.3, 2.417, 7], count)
    dashpots = [draw.choice([0, 0, 0, 0, 0.3]) for _ in cells[1:]] + [0]
    return ["--segments", ",".join(f"{n}:{impedance}:1:{dashpot}"
                                   for n, impedance, dashpot in zip(cells, impedances, dashpots))]


def numbers(text):
    """Schedules, and how many have motions, as the checker says."""
    return [int(number) for number in re.search(r": (\d+) schedules, (\d+) have motions", text).groups()]


def check_segments(options, folder, draw):
    """Bars of several segments, of one contact and two, pressed or not: a sentence."""
    gaps = ([], ["--gap", "-1e-3"])
    few = ["--phases", "2", "--max-contact", "3", "--max-free", "4"]
    ranges = [random_bar(draw, draw.randint(3, 6)) + draw.choice(gaps) for _ in range(8)]
    ranges += [random_bar(draw, 4) + few + gap for gap in gaps for _ in range(2)]
    ranges += [["--segments", "4:1,4:1.3"], ["--segments", "3:1,1:0.4", "--max-energy-ratio", "9"]]
    decided = 0
    found = {False: 0, True: 0}  # of one contact, of two
    for words in ranges:
        holds, text = checked(options.checker, made(options.program, folder, words))
        if not holds:
            sys.exit(f"{' '.join(words)}: {text}")
        schedules, motions = numbers(text)
        decided += schedules
        found["--phases" in words] += motions
    if not all(found.values()):
        sys.exit(f"of {decided} schedules of bars of several segments too few have motions")
    # No motion exactly: in (3, 4) a wave pulls by 1e-8, less than the tolerance allows.
    edge = ["--segments", "2:1,1:0.99999999", *gaps[1], "--max-contact", "4", "--max-free", "4"]
    holds, text = checked(options.checker, made(options.program, folder, edge))
    if not holds or "only within" in text:
        sys.exit(f"{' '.join(edge)}: {text}")
    spoilt = sum(spoil(options.checker, made(options.program, folder, ["--segments", "2:1,2:1.3", *gap]), draw,
                       SPOILT + SPOILT_SEGMENTS, 1e-6) for gap in gaps)
    return (f"several segments: {decided} schedules, {found[False]} of one contact and {found[True]} of two with "
            f"motions, are as the atlases say; {spoilt} spoilt ones are refused")


def check_bars(options, folder, draw):
    """Bars in a row, one contact and two: that what is refuted has no motion; a sentence."""
    refuted = spoilt = 0
    for scene in ("clamp 3 gap=1e-3 4:1.7 clamp", "clamp 2 stop=1e-3 gap=-2e-4 3 dash=0.2 1 clamp",
                  "free 3 gap=1e-3 2 clamp", "clamp 2:1:1.3 mass=0.1 3 stop=-1e-3 stop=2e-3",
                  "spring=2 4 force=1e-4 stop=1e-3"):
        for more in (["--max-contact", "4", "--max-free", "17"],
                     ["--phases", "2", "--max-contact", "2", "--max-free", "5"]):
            path = made(options.program, folder, ["--scene", scene, *more])
            holds, text = checked(options.checker, path)
            if not holds:
                sys.exit(f"{scene}: {text}")
            refuted += (count := int(re.search(r": (\d+) schedules have no motion", text).group(1)))
            if count:
                spoilt += spoil(options.checker, path, draw, SPOILT_BARS, 0)
    return f"bars in a row: {refuted} schedules have no motion, as their proofs say; {spoilt} spoilt ones are refused"


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("program")
    parser.add_argument("checker")
    parser.add_argument("--cells", type=int, default=7)
    options = parser.parse_args()
    draw = random.Random(options.cells)
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        ranges = [["--cells", str(n)] for n in range(1, options.cells + 1)]
        ranges += [["--cells", str(n), "--phases", "2"] for n in (1, 2, 3)]
        ranges += [["--cells", "2", "--phases", "3", "--max-free", "4"],
                   ["--cells", "5", "--max-free", "47", "--max-contact", "23"],
                   ["--cells", "6", "--max-energy-ratio", "5"]]
        for place in ("1.1e-3", "2e-3", "3.3e-3"):
            ranges += [["--cells", str(n), "--second-stop", place] for n in (1, 2, 3, 7)]
            ranges += [["--cells", "2", "--phases", "2", "--second-stop", place],
                       ["--cells", "3", "--phases", "2", "--max-contact", "3", "--max-free", "7",
                        "--second-stop", place]]
        decided = 0
        for words in ranges:
            for gap in ([], ["--gap", "-1e-3"], ["--gap", "0"]):
                if gap[1:] == ["0"] and "--max-energy-ratio" in words:
                    continue
                holds, text = checked(options.checker, made(options.program, folder, words + gap))
                if not holds:
                    sys.exit(f"{' '.join(words + gap)}: {text}")
                decided += numbers(text)[0]
        spoilt = 0
        for words in (["--cells", "4"], ["--cells", "4", "--second-stop", "1.5e-3"],
                      ["--cells", "4", "--second-stop", "1.5e-3", "--gap", "-1e-3"]):
            spoilt += spoil(options.checker, made(options.program, folder, words), draw, SPOILT, 1e-9)
        print(f"{decided} schedules are as the atlases say; {spoilt} spoilt ones are refused")
        if is_possible(options.program, folder):
            print(check_segments(options, folder, draw))
            print(check_bars(options, folder, draw))
        else:
            print("several segments: this build has no solver for them")


if __name__ == "__main__":
    main()
