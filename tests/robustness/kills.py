#!/usr/bin/env python3
"""An atlas killed at random moments and resumed has the rows of one that nobody disturbed."""

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


def main():
    given = arguments(__doc__, 100)
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "whole.sqlite"
        start = time.monotonic()
        subprocess.run([given.program, *RANGE, "--database", path], check=True,
                       capture_output=True)
        longest = time.monotonic() - start
        whole = contents(path)
    campaign(given, "broken atlases",
             lambda case: judge(case, given.program, whole, longest), ["killed"])


if __name__ == "__main__":
    main()
