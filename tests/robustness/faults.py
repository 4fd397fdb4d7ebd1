#!/usr/bin/env python3
"""One call to the system fails while the program writes: all of its files are there, or none."""

import errno
import json
import os
import pathlib
import subprocess
import sys
import tempfile

from campaign import FOUND, UNAVAILABLE, arguments, campaign, snapshot
from kills import contents

STEEL = ["--young", "210e9", "--density", "7800", "--area", "1e-4", "--gap", "1e-6"]
FORCED = ["--damping", "0.05", "--force", "tip", "--amplitude", "3e-4"]
CALLS = [
    ["find", "150", "900", "--state", "s.csv", "--motion", "m.csv", "--figure", "f.svg"],
    ["find", "150", "900", "--motion", "m.pvd", "--state", "s.csv", *STEEL],
    ["continuum", "150", "900", "--energy-ratio", "20", "--points", "5", "--csv", "k.csv",
     "--figure", "k.pdf"],
    ["families", "--csv", "f.csv", "--figure", "f.png"],
    ["modes", "--max-order", "9", "--csv", "m.csv"],
    ["response", "--cells", "10", *FORCED, "--from", "1", "--to", "1.1", "--csv", "r.csv"],
    ["simulate", "--cells", "10", *FORCED, "--frequency", "1.1", "--periods", "20",
     "--events", "e.csv", "--tip", "t.csv"],
    ["atlas", "--database", "a.sqlite", "--cells", "12", "--csv", "a.csv"],
]
ERRORS = [errno.ENOSPC, errno.EIO, errno.EDQUOT]


class Interposed:
    """The library of faults.c, made for this campaign."""

    def __init__(self, folder):
        self.path = str(pathlib.Path(folder, "faults.so"))
        source = pathlib.Path(__file__).with_name("faults.c")
        subprocess.run(["cc", "-shared", "-fPIC", "-O1", "-Wall", "-Wextra", "-Werror", "-o",
                        self.path, str(source), "-ldl"], check=True)

    def calls_of(self, program, words):
        """The calls that a run without faults makes, by name, and the files and words it leaves."""
        with tempfile.TemporaryDirectory() as folder, tempfile.NamedTemporaryFile() as log:
            done = subprocess.run([program, *words], cwd=folder, capture_output=True, check=False,
                                  env=dict(os.environ, LD_PRELOAD=self.path,
                                           SIGNORINI_FAULT_LOG=log.name))
            names = pathlib.Path(log.name).read_text(encoding="ascii").split()
            return names, snapshot(pathlib.Path(folder)), done


def comparable(files):
    """Files without what differs from run to run: the seconds, and a database's own order."""
    return {name: data for name, data in files.items()
            if not name.endswith((".sqlite", ".pdf", ".png"))}


def judge(case, interposed, runs):
    words, names, whole, clean = case.random.choice(runs)
    name = case.random.choice(sorted(set(names)))
    ordinal = case.random.randint(1, names.count(name))
    is_short = name in ("write", "pwrite") and case.random.random() < 0.25
    error = 0 if is_short else case.random.choice(ERRORS)
    before = {}
    if case.random.random() < 0.5:  # files of an earlier call, to be replaced or kept
        before = {file: b"of an earlier call\n" for file in whole if not file.endswith(".sqlite")}
        for file, data in before.items():
            if "/" not in file:
                (case.folder / file).write_bytes(data)
        before = snapshot(case.folder)
    os_words = {"LD_PRELOAD": interposed.path, "SIGNORINI_FAULT": f"{name} {ordinal} {error}"}
    outcome = case.run(words, os_words)
    told = f"{name} {ordinal} of {names.count(name)}, error {error}"
    after = snapshot(case.folder)
    if outcome.status == clean.returncode:
        if comparable(after).keys() != comparable({**before, **whole}).keys():
            case.fault(words, f"{told}: status {outcome.status}, but files {sorted(after)}")
        elif any(len(after[file]) != len(data) for file, data in comparable(whole).items()):
            case.fault(words, f"{told}: status {outcome.status}, but not the files of a clean run")
        return "short" if is_short else "survived"
    if is_short or outcome.status != UNAVAILABLE:
        case.fault(words, f"{told}: status {outcome.status}: {outcome.err[-200:]!r}")
    database = {file: data for file, data in after.items() if file.startswith("a.sqlite")}
    if {file: data for file, data in after.items() if file not in database} != before:
        case.fault(words, f"{told}: neither all files nor none: {sorted(after)}")
    if database and case.run([*words, "--resume"]).status != FOUND:
        case.fault(words, f"{told}: the atlas cannot be resumed")
    elif database and contents(case.folder / "a.sqlite")[0] != [("ok",)]:
        case.fault(words, f"{told}: the resumed atlas is not sound")
    return "refused"


def main():
    given = arguments(__doc__, 500)
    with tempfile.TemporaryDirectory() as folder:
        interposed = Interposed(folder)
        runs = []
        for words in CALLS:
            names, whole, clean = interposed.calls_of(given.program, words)
            if clean.returncode not in (0, 1) or not names:
                sys.exit(f"signorini {' '.join(words)}: {clean.returncode}, {names}, {clean.stderr!r}")
            runs.append((words, names, whole, clean))
        print(json.dumps({" ".join(words[:2]): {n: names.count(n) for n in sorted(set(names))}
                          for words, names, _, _ in runs}))
        campaign(given, "calls with a fault of the file system",
                 lambda case: judge(case, interposed, runs), least=["refused", "short"])


if __name__ == "__main__":
    main()
