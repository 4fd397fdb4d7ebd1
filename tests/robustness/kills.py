#!/usr/bin/env python3
"""Atlases, sweeps and studies killed at random moments and resumed have the rows of undisturbed ones."""

import signal
import sqlite3
import subprocess
import tempfile
import time
from pathlib import Path

from campaign import FOUND, arguments, campaign

RANGE = ["atlas", "--cells", "400", "--max-contact", "2400", "--max-free", "4800", "--quiet"]
MOST_KILLS = 5


def contents(path):
    """Both tables in their order, and the runs without times; the check of SQLite itself."""
    with sqlite3.connect(path) as database:
        check = database.execute("PRAGMA integrity_check").fetchall()
        rows = [row for table in ("families", "schedules")
                for row in database.execute(f"SELECT * FROM {table} ORDER BY rowid")]
        runs = database.execute("SELECT cells, max_contact, max_free, phases, batches, next_batch,"
                                " decided, pressing, grazing, refuted, undecided,"
                                " finished IS NULL FROM runs").fetchall()
    database.close()
    return check, rows, runs


def kill_later(case, program, words, longest):
    """Starts the program and kills it after a random time; True if it was still at work."""
    process = subprocess.Popen([program, *words], cwd=case.folder, stdin=subprocess.DEVNULL,
                               stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    time.sleep(case.random.uniform(0.0, longest))
    process.kill()
    return process.wait() == -signal.SIGKILL


def judge(case, program, whole, longest):
    kills = 0
    for _ in range(case.random.randint(1, MOST_KILLS)):
        words = [*RANGE, "--threads", str(case.random.randint(1, 3)), "--database", "a.sqlite"]
        if not kill_later(case, program, [*words, "--resume"], longest):
            break
        kills += 1
    words = [*RANGE, "--database", "a.sqlite", "--resume"]
    if case.run(words).status != FOUND:
        case.fault(words, f"not finished after {kills} kills")
        return "unfinished"
    check, rows, runs = contents(case.folder / "a.sqlite")
    if check != [("ok",)]:
        case.fault(words, f"integrity_check: {check}")
    if rows != whole[1]:
        case.fault(words, f"{len(rows)} rows, not those of an unbroken run ({len(whole[1])})")
    if runs != whole[2]:
        case.fault(words, f"runs {runs}, unbroken {whole[2]}")
    left = sorted(path.name for path in case.folder.iterdir())
    if left != ["a.sqlite"]:
        case.fault(words, f"files left: {left}")
    return "killed" if kills else "not killed"


SWEEP = ["sweep", "--damping", "0.02", "--force", "tip", "--amplitude", "2e-4", "--from", "0.9", "--to", "1.3",
         "--points", "25", "--cells", "40", "--periods", "200", "--csv", "t.csv"]
STUDY = ["study", "q.toml", "--csv", "t.csv"]
QUESTION = """force = "base"
gap = ["0.05mm", 1e-4]      # metres where nothing is said
damping = [0.03, "10%"]
amplitude = [1e-5, 2e-5, 4e-5]
young = "210GPa"
density = 7850
area = "1cm2"
from = 0.9
to = 1.3
points = 6
cells = 20
periods = 200
"""


def judge_table(case, program, words, whole, longest):
    """The table of a long run: the same to the last byte, and nothing beside it."""
    (case.folder / "q.toml").write_text(QUESTION)
    kills = 0
    for _ in range(case.random.randint(1, MOST_KILLS)):
        if not kill_later(case, program, [*words, "--resume", "--quiet"], longest):
            break
        kills += 1
        for staged in case.folder.glob(".signorini*"):
            staged.unlink()
    if case.run([*words, "--resume", "--quiet"]).status != FOUND:
        case.fault(words, f"not finished after {kills} kills")
        return "unfinished"
    if (case.folder / "t.csv").read_bytes() != whole:
        case.fault(words, "the table is not that of an unbroken run")
    left = sorted(path.name for path in case.folder.iterdir())
    if left != ["q.toml", "t.csv"]:
        case.fault(words, f"files left: {left}")
    return f"{words[0]} killed" if kills else f"{words[0]} not killed"


def unbroken(program, words, folder):
    """The table of a run that nobody disturbs, and how long it took."""
    start = time.monotonic()
    subprocess.run([program, *words, "--quiet"], check=True, capture_output=True, cwd=folder)
    return (Path(folder) / "t.csv").read_bytes(), time.monotonic() - start


def main():
    given = arguments(__doc__, 100)
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "whole.sqlite"
        start = time.monotonic()
        subprocess.run([given.program, *RANGE, "--database", path], check=True,
                       capture_output=True)
        longest = time.monotonic() - start
        whole = contents(path)
        (Path(folder) / "q.toml").write_text(QUESTION)
        tables = [(words, *unbroken(given.program, words, folder)) for words in (SWEEP, STUDY)]

    def judge_one(case):
        if case.number % 3 == 0:
            return judge(case, given.program, whole, longest)
        words, table, time_of = tables[case.number % 3 - 1]
        return judge_table(case, given.program, words, table, time_of)

    campaign(given, "broken runs", judge_one, ["killed", "sweep killed", "study killed"])


if __name__ == "__main__":
    main()
