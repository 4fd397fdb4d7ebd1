#!/usr/bin/env python3
"""Atlases the program makes are complete to a checker that shares no code with it.

atlases_test.py PROGRAM CHECKER [--cells N]

Atlases of all grids up to N cells, of a gap, none and one that presses, of one contact and two, with
one stop and with two; and none passes any more when one number of it is changed, or one row taken away.
"""
import argparse
import pathlib
import random
import shutil
import sqlite3
import subprocess
import sys
import tempfile

SPOILT = [
    ("a motion taken away", "DELETE FROM schedules WHERE rowid = {}", "found"),
    ("a refuted schedule taken away", "DELETE FROM schedules WHERE rowid = {}", "none"),
    ("a motion called none", "UPDATE schedules SET status = 'none' WHERE rowid = {}", "found"),
    ("a refuted one called found", "UPDATE schedules SET status = 'found' WHERE rowid = {}", "none"),
    ("a kernel", "UPDATE schedules SET kernel_dimension = kernel_dimension + 1 WHERE rowid = {}",
     "found"),
    ("least energy",
     "UPDATE schedules SET energy_ratio_min = energy_ratio_min * (1 + 1e-9) WHERE rowid = {}", "found"),
    ("most energy",
     "UPDATE schedules SET energy_ratio_max = energy_ratio_max * (1 - 1e-9) WHERE rowid = {}", "found"),
    ("a period", "UPDATE schedules SET period = period * 2 WHERE rowid = {}", "found"),
    ("steps", "UPDATE schedules SET steps = steps + 1 WHERE rowid = {}", "none"),
    ("a reason", "UPDATE schedules SET reason = 'constraints' WHERE rowid = {}", "none"),
    ("a count", "UPDATE runs SET pressing = pressing + 1 WHERE {}", "found"),
    ("an end", "UPDATE runs SET finished = NULL WHERE {}", "found"),
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


def spoil(checker, path, draw):
    """One change after another, each of which has to be refused; how many."""
    for what, change, status in SPOILT:
        bad = shutil.copy(path, path.with_name("spoilt.sqlite"))
        base = sqlite3.connect(bad)
        rows = base.execute("SELECT rowid FROM schedules WHERE status = ? AND "
                            "(energy_ratio_max IS NOT NULL OR reason IS NOT NULL) ORDER BY rowid",
                            (status,)).fetchall()
        changed = base.execute(change.format(draw.choice(rows)[0])).rowcount
        base.commit()
        base.close()
        if changed != 1 or checked(checker, bad)[0]:
            sys.exit(f"spoilt ({what}), and still taken for complete")
    return len(SPOILT)


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
                decided += int(text.split(":")[3].split()[0])
        spoilt = 0
        for words in (["--cells", "4"], ["--cells", "4", "--second-stop", "1.5e-3"],
                      ["--cells", "4", "--second-stop", "1.5e-3", "--gap", "-1e-3"]):
            spoilt += spoil(options.checker, made(options.program, folder, words), draw)
    print(f"{decided} schedules are as the atlases say; {spoilt} spoilt ones are refused")


if __name__ == "__main__":
    main()
