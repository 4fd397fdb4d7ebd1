#!/usr/bin/env python3
"""Damaged atlases: refused (4 or 2), or answered as if nothing had happened.

Each database is asked by --near, --period and --twins, and its run is resumed. An answer says
what Python reads in the tables: numbers that were changed into other numbers look as if they were
meant, but a word for a number must not be taken for one. Tables that the damage left as they were
give the undamaged answers and, resumed, the undamaged rows; a count of batches that cannot be is
refused, or mended.
"""

import sqlite3
import subprocess
import tempfile
from pathlib import Path

from campaign import FOUND, UNAVAILABLE, UNDECIDED, WRONG_USE, arguments, campaign, strict_json

RANGE = ["atlas", "--cells", "40", "--quiet", "--format", "json", "--database"]
QUESTIONS = [["--near", "1.143", "20", "--within", "0.3", "--schedules"], ["--period", "7/2"],
             ["--twins"], ["--period", "15/4", "--cells", "40", "--schedules"]]
VALUES = ["-5", "-1", "0", "1", "7", "1e300", "-9223372036854775808", "9223372036854775807",
          "NULL", "''", "'x'", "'1:2'", "'3:'", "':3'", "'0:0'", "'-1:5'", "'1:2,'", "x'00ff'",
          "'99999999999999999999:1'", "'found'", "zeroblob(100000)", "0.5", "1e999", "-1e999"]
STATEMENTS = [
    "DROP TABLE runs", "DROP TABLE schedules", "DROP TABLE families", "DELETE FROM runs",
    "DELETE FROM schedules", "DELETE FROM families", "UPDATE families SET schedules = 5",
    "UPDATE schedules SET family = NULL", "DROP INDEX schedules_without_family",
    "DROP INDEX one_run_per_range", "ALTER TABLE schedules DROP COLUMN canonical",
    "ALTER TABLE schedules RENAME COLUMN kind TO sort", "ALTER TABLE runs ADD COLUMN more TEXT",
    "ALTER TABLE schedules ADD COLUMN more TEXT NOT NULL DEFAULT 'x'",
    "PRAGMA user_version = 0", "PRAGMA user_version = 1", "PRAGMA application_id = 0",
    "PRAGMA application_id = 7", "PRAGMA journal_mode = WAL",
    "DROP TABLE schedules; CREATE VIEW schedules AS SELECT 1 AS cells, '1:5' AS phases",
    "DROP TABLE runs; CREATE TABLE runs(id INTEGER)",
    "CREATE TRIGGER t AFTER INSERT ON schedules BEGIN SELECT RAISE(ABORT, 'no'); END",
    "CREATE TRIGGER t AFTER UPDATE ON runs BEGIN DELETE FROM schedules; END",
    "INSERT INTO schedules SELECT cells, phases || ',1:1', steps, period, frequency_ratio, status,"
    " reason, kernel_dimension, kind, dimension, contact, canonical, energy_ratio_min,"
    " energy_ratio_max, family FROM schedules LIMIT 3",
    "DELETE FROM schedules WHERE rowid % 2", "UPDATE runs SET next_batch = 0, finished = NULL",
]


def columns(path):
    with sqlite3.connect(path) as database:
        found = [(table, row[1]) for table in ("schedules", "families", "runs")
                 for row in database.execute(f"PRAGMA table_info({table})")]
    database.close()
    return found


def edit(random, path):
    """One statement that a person with a database browser may give; returns it."""
    if random.random() < 0.35:
        statement = random.choice(STATEMENTS)
    else:
        table, column = random.choice(columns(path))
        rows = random.choice(["", " WHERE rowid = 1", " WHERE rowid % 7 = 0"])
        statement = f"UPDATE {table} SET {column} = {random.choice(VALUES)}{rows}"
    database = sqlite3.connect(path)
    try:
        database.execute("PRAGMA writable_schema = 0")
        database.executescript(statement)
    except sqlite3.Error:
        statement = ""  # the schema itself refuses it
    database.commit()
    database.close()
    return statement


def damage(random, path):
    """Damages the file; returns what was done."""
    content = path.read_bytes()
    kind = random.randrange(10)
    if kind < 5:
        return edit(random, path)
    if kind == 5:
        at = random.choice([0, 1, 99, 100, 512, 4096, len(content) - 1,
                            random.randrange(len(content))])
        path.write_bytes(content[:at])
        return f"cut at {at}"
    if kind == 6:
        other = random.choice([b"", b"not a database\n", b"\0" * 4096, random.randbytes(5000),
                               b"SQLite format 3\0", content[:100] + b"\0" * 4000,
                               content + b"more", content + content])
        path.write_bytes(other)
        return f"other content: {other[:20]!r}"
    if kind == 7:
        path.unlink()
        database = sqlite3.connect(path)
        database.execute("CREATE TABLE people(name)")
        database.commit()
        database.close()
        return "another database"
    flipped = bytearray(content)
    places = random.choice([range(100), range(100, 4096), range(len(content))])
    for _ in range(random.choice([1, 1, 3, 20])):
        flipped[random.choice(places)] = random.randrange(256)
    path.write_bytes(bytes(flipped))
    return "bytes flipped"


def read(path):
    """All that the tables say but times, or None if SQLite cannot read them."""
    database = sqlite3.connect(path)
    try:
        if database.execute("PRAGMA integrity_check").fetchall() != [("ok",)]:
            return None
        rows = database.execute("SELECT * FROM schedules ORDER BY cells, phases").fetchall()
        families = database.execute("SELECT * FROM families ORDER BY cells, phases").fetchall()
        runs = database.execute(
            "SELECT cells, max_contact, max_free, phases, max_energy_ratio, keeps_refuted,"
            " batches, next_batch, decided, pressing, grazing, refuted, undecided FROM runs"
        ).fetchall()
        return rows, runs, families
    except (sqlite3.Error, OverflowError, UnicodeDecodeError):
        return None
    finally:
        database.close()


def phases_of(text):
    return [[int(steps) for steps in phase.split(":")] for phase in text.split(",")]


def energies_of(least, most):
    return [least, None if most == float("inf") else most]


def as_told(table_row):
    """A row of schedules as an answer tells it, or None if it makes no sense."""
    (cells, phases, _, _, _, status, reason, kernel, kind, dimension, contact, canonical, least,
     most, family) = table_row[:15]
    try:
        told = {"cells": cells, "status": status, "kernel_dimension": kernel, "family": family,
                "schedule": phases_of(phases)}
    except (AttributeError, ValueError):
        return None
    if status == "found":
        told |= {"kind": kind, "dimension": dimension, "contact": contact,
                 "canonical": bool(canonical) if isinstance(canonical, int) else None,
                 "energy_ratio_range": energies_of(least, most)}
    else:
        told["reason"] = reason
    return told


def family_as_told(table_row):
    """The same of a row of families."""
    (number, cells, order, nu, blocks, phases, _, _, _, contact, kind, dimension, least, most,
     schedules) = table_row[:15]
    try:
        return {"id": number, "cells": cells, "order": order, "nu": nu, "contact_blocks": blocks,
                "schedule": phases_of(phases), "contact": contact, "kind": kind,
                "dimension": dimension, "energy_ratio_range": energies_of(least, most),
                "schedules": schedules}
    except (AttributeError, ValueError):
        return None


def entries_of(answer, table):
    yield from answer.get(table, [])
    for group in answer.get("twins", []):
        yield from group[table]


def untrue(answer, tables):
    """What the answer says and the tables do not; both as Python reads them."""
    for table, rows, tell, place in (("schedules", tables[0], as_told, 1),
                                     ("families", tables[2], family_as_told, 5)):
        known = {row[place]: tell(row) for row in rows if row[place] is not None}
        for entry in entries_of(answer, table):
            phases = ",".join(f"{contact}:{free}" for contact, free in entry["schedule"])
            told = known.get(phases)
            said = {name: entry.get(name) for name in told or entry}
            if said != told:
                return f"{said}, the table: {told}"
    ranges = [list(run[:5]) for run in tables[1]]
    for run in answer["ranges"]:
        said = [run[name] for name in ("cells", "max_contact", "max_free", "phases",
                                       "max_energy_ratio")]
        if said not in ranges:
            return f"range {said}, the table: {ranges}"
    return None


def without_times(text):
    """An answer in JSON. Raises ValueError."""
    answer = strict_json(text)
    for run in [answer, *answer.get("runs", [])]:
        for name in ("seconds", "started", "finished", "workers"):
            run.pop(name, None)
    return answer


def batches_make_sense(tables, truth):
    most = truth[1][0][6]
    return tables is None or all(run[6] == most and isinstance(run[7], int) and 0 <= run[7] <= most
                                 for run in tables[1])


def judge(case, whole, answers):
    path = case.folder / "a.sqlite"
    path.write_bytes(whole)
    truth = read(path)
    done = damage(case.random, path)
    damaged = path.read_bytes()
    tables = read(path)
    words = []
    word = "refused"
    for question, right in zip(QUESTIONS, answers):
        words = ["atlas", "--database", "a.sqlite", "--format", "json", *question]
        outcome = case.run(words)
        if outcome.status in (WRONG_USE, UNAVAILABLE):
            continue
        word = "answered"
        try:
            answer = without_times(outcome.out)
            false = untrue(answer, tables) if tables else None
        except ValueError as error:
            case.fault(words, f"{done}: no JSON: {error}: {outcome.out[:200]!r}")
            continue
        if outcome.status not in (FOUND, UNDECIDED):
            case.fault(words, f"{done}: status {outcome.status}")
        elif tables == truth and answer != right:
            case.fault(words, f"{done}: another answer: {str(answer)[:300]}")
        elif false:
            case.fault(words, f"{done}: the answer says {false}")
    if path.read_bytes() != damaged and "WAL" not in done:
        case.fault(words, f"{done}: a question changed the database")
    words = [*RANGE, "a.sqlite", "--resume"]
    outcome = case.run(words)
    if outcome.status in (FOUND, UNDECIDED):
        after = read(path)
        if after is None and tables is not None:
            case.fault(words, f"{done}: resumed into a broken database")
        if after != truth and (tables == truth or not batches_make_sense(tables, truth)):
            case.fault(words, f"{done}: resumed, and the rows are others")
    elif outcome.status not in (WRONG_USE, UNAVAILABLE):
        case.fault(words, f"{done}: status {outcome.status}")
    return word


def main():
    given = arguments(__doc__, 250)
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "a.sqlite"
        subprocess.run([given.program, *RANGE, path], check=True, capture_output=True)
        whole = path.read_bytes()
        answers = []
        for question in QUESTIONS:
            done = subprocess.run([given.program, "atlas", "--database", path, "--format", "json",
                                   *question], check=True, capture_output=True)
            answers.append(without_times(done.stdout))
    campaign(given, "damaged databases", lambda case: judge(case, whole, answers),
             ["answered", "refused"])


if __name__ == "__main__":
    main()
