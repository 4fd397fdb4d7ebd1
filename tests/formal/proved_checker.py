#!/usr/bin/python3
"""Certificates of random questions, and forgeries of them, before tools/check-proved.

Every certificate that `signorini find` writes about free motions with a gap has to be accepted by
tools/check-certificate and, if the proved checker knows its kind, by tools/check-proved. Of each a number
of forgeries are made: keys added or doubled, claims moved to another bar, schedule or gap, multipliers
changed, dropped or doubled, energies and limits altered. What damages only multipliers may leave a proof,
so an accepted forgery is a fault unless its claim is true: the program is asked the altered question.

    proved_checker.py [--program PATH] [--count N] [--forgeries M] [--seed S]
"""
import argparse
import collections
import copy
import functools
import json
import os
import pathlib
import random
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
# What is left to tools/check-certificate:
UNKNOWN = ("; of most energies this checker knows nothing", "; not known to this checker")


def phase_words(phase):
    return [f"{'L:' if phase[2:] == ['left'] else ''}{phase[0]}", str(phase[1])]


def segment_words(segments):
    return ",".join(f"{s['cells']}:{s['impedance']!r}:{s['speed']!r}:{s['dashpot']!r}" for s in segments)


def command(question):
    """The arguments of `signorini` for a question, a dictionary."""
    words = ["find"] + [w for phase in question["phases"] for w in phase_words(phase)]
    words += ["--segments", segment_words(question["segments"])] if question.get("segments") else \
        ["--cells", str(question["cells"])]
    for name in ("gap", "second-stop", "strain-limit", "tip-floor", "energy-ratio"):
        if question.get(name) is not None:
            words += [f"--{name}={question[name]!r}"]
    return words


def random_question(rng):
    """A small question about free motions, with a gap of either sign."""
    question = {"cells": rng.randint(1, 12), "gap": rng.choice([1e-3, 1e-3, -1e-3])}
    if rng.random() < 0.25:
        count = rng.randint(2, 3)
        question["segments"] = [
            {"cells": rng.randint(1, 4), "impedance": 1.0 if i == 0 else rng.choice([0.5, 1.3, 2.0, 0.7]), "speed": 1.0,
             "dashpot": rng.choice([0.0, 0.0, 0.0, 0.25]) if i + 1 < count else 0.0} for i in range(count)]
        question["cells"] = sum(s["cells"] for s in question["segments"])
    cells = question["cells"]
    phases = [[rng.randint(1, 2 * cells + 1), rng.randint(1, 5 * cells)] for _ in range(rng.choice([1, 1, 2, 2, 3]))]
    if rng.random() < 0.3:  # such as have motions more often
        contact = rng.randint(1, cells)
        phases = [[contact, 4 * cells - 2 * contact], [contact, 4 * cells - 2 * contact]][:rng.choice([1, 1, 2])]
    if rng.random() < 0.2:
        question["second-stop"] = rng.choice([1e-3, 2e-3, 1.5e-3, 2.7e-3])
        phases = [phase + rng.choice([[], ["left"]]) for phase in phases]
        phases[0] = phases[0][:2]
    question["phases"] = phases
    draw = rng.random()
    if draw < 0.1 and "segments" not in question:
        question["strain-limit"] = round(rng.uniform(5e-4, 4e-3), 6)
    elif draw < 0.15:
        question["tip-floor"] = -round(rng.uniform(5e-4, 4e-3), 6)
    elif draw < 0.2 and "segments" not in question:
        question["energy-ratio"] = round(rng.uniform(0.5, 8), 3)
    return question


def answered(program, question, folder, seconds=20):
    """The certificate's file as JSON text; nothing where the program wrote none."""
    path = pathlib.Path(folder, "certificate.json")
    path.unlink(missing_ok=True)
    try:
        subprocess.run([program, *command(question), "--quiet", f"--certificate={path}"], capture_output=True,
                       check=False, timeout=seconds)
    except subprocess.TimeoutExpired:
        return None
    return path.read_text(encoding="utf-8") if path.exists() else None


def judged(checker, texts, folder):
    """The line that a checker says about each text."""
    names = []
    for i, text in enumerate(texts):
        path = pathlib.Path(folder, f"{i}.json")
        path.write_text(text, encoding="utf-8")
        names.append(str(path))
    said = {}
    done = subprocess.run([checker, *names], capture_output=True, text=True, check=False)
    for line in done.stdout.splitlines():
        name, verdict = line.split(": ", 1)
        said[name] = verdict
    return [said.get(name, "wrong use") for name in names]


# ---- forgeries

def of_rows(answer, rng):
    """A list of rows with multipliers of the certificate that is not empty."""
    lists = [v for v in answer["certificate"].values() if isinstance(v, list) and v and isinstance(v[0], list)]
    return rng.choice(lists) if lists else None


def alter_multiplier(answer, rng):
    rows = of_rows(answer, rng)
    if rows:
        pair = rng.choice(rows)
        old = pair[-1]
        negated = -old if isinstance(old, float) else str(old)[1:] if str(old)[0] == "-" else f"-{old}"
        pair[-1] = rng.choice([0, 1, -1, "1/3", "x", "1/0", 1e3, True, None, negated])


def drop_multiplier(answer, rng):
    rows = of_rows(answer, rng)
    if rows:
        del rows[rng.randrange(len(rows))]


def double_row(answer, rng):
    rows = of_rows(answer, rng)
    if rows:
        rows.append(list(rng.choice(rows)))


def move_row(answer, rng):
    rows = of_rows(answer, rng)
    if rows:
        rng.choice(rows)[0] = rng.choice([0, 1, 2, 3, 7, -1, 10 ** 6, 2.0])


def add_key(answer, rng):
    where = rng.choice([answer, answer["certificate"], answer["bar"]])
    where[rng.choice(["damping", "force", "cycles", "amplitude", "note", "Gap", "strain_limits"])] = \
        rng.choice([0, 1, None, {}, "tip"])


def other_schedule(answer, rng):
    rng.choice(answer["schedule"])[rng.randrange(2)] += rng.choice([-1, 1, 2, 5])


def other_cells(answer, rng):
    answer["cells"] += rng.choice([-1, 1, 2])


def other_gap(answer, rng):
    which = rng.randrange(4)
    if which != 1:
        answer["bar"]["gap"] *= rng.choice([-1, 2])
    if which > 0 and answer["stops"]:
        answer["stops"][0]["place"] *= -1


def no_gap(answer, rng):
    answer["bar"] = rng.choice([{}, [], {**answer["bar"], "gap": None}, {**answer["bar"], "gap": float("nan")}])


def other_stop(answer, rng):
    if len(answer["stops"]) > 1:
        answer["stops"][1]["place"] *= rng.choice([0.5, 2, -1, 1.25])
    else:
        answer["stops"].append({"side": "left", "place": rng.choice([-1e-3, -3e-3, 1e-3])})


def other_phases(answer, rng):
    rng.choice([answer["schedule"].reverse, lambda: answer["schedule"].append([1, 4]), answer["schedule"].pop])()


def other_segments(answer, rng):
    if not answer["segments"]:
        answer["segments"] = [{"cells": answer["cells"], "impedance": 1.0, "speed": 1.0,
                               "dashpot": rng.choice([0.0, 0.1])}]
        return
    rng.choice(answer["segments"])[rng.choice(["cells", "impedance", "dashpot"])] = \
        rng.choice([1, 2, 1.5, "1.3", -1, None, 0])


def other_energy(answer, rng):
    factor = rng.choice([1.001, 1.5, 0.5, 1 + 1e-5])
    for values, key in ((answer, "energy_ratio"), (answer["certificate"], "energy_ratio")):
        if isinstance(values.get(key), float) and rng.random() < 0.7:
            values[key] *= factor
    if isinstance(answer.get("energy_ratio_range"), list):
        answer["energy_ratio_range"][0] *= factor


def upper_energy(answer, rng):
    if answer["certificate"]["rows"] == "network" and isinstance(answer.get("energy_ratio_range"), list):
        answer["energy_ratio_range"][1] = rng.choice([1.0, 2 * answer["energy_ratio_range"][0], 1e9])


def gap_alone(answer, rng):
    """The gap's row as the only multiplier, and an energy to go with it."""
    certificate = answer["certificate"]
    for name in ("equalities", "inequalities", "periodicity", "pressure", "penetration", "landing", "pushes"):
        if certificate.get(name):
            certificate[name] = certificate[name][:1] if name == "equalities" else []
    if certificate.get("places"):
        certificate["places"] = [[1, 0, -1.0]]
    energy = rng.choice([1.1304, 1.0, 4.0])
    for values in (answer, certificate):
        if isinstance(values.get("energy_ratio"), float):
            values["energy_ratio"] = energy
    if isinstance(answer.get("energy_ratio_range"), list):
        answer["energy_ratio_range"][0] = energy


def other_limits(answer, rng):
    name = rng.choice(["strain_limit", "tip_floor"])
    value = answer["certificate"].get(name)
    answer["certificate"][name] = rng.choice([None, 0, 1.5 * (value or 1.0), 0.5 * (value or -1.0), "1"])


def other_status(answer, rng):
    answer["status"] = {"none": "found", "found": "none"}.get(answer["status"], "none")
    if rng.random() < 0.5:
        answer["objective"] = rng.choice(["min-energy", "max-energy", "any", None])


def other_rows(answer, rng):
    answer["certificate"][rng.choice(["rows", "kind"])] = \
        rng.choice(["paper", "lumped", "network", "farkas", "energy-range", "energy-floor", None])


KINDS = [alter_multiplier, drop_multiplier, double_row, move_row, add_key, other_schedule, other_cells, other_gap,
         no_gap, other_stop, other_phases, other_segments, other_energy, upper_energy, gap_alone, other_limits,
         other_status, other_rows]


def forged(text, rng):
    """A kind, the text altered so, and whether it makes the same claim by other multipliers; or nothing."""
    if rng.random() < 0.05:
        key = rng.choice(["\"status\":\"none\"", "\"cells\":1", "\"certificate\":null", "\"bar\":{}"])
        return "key_twice", text.rstrip()[:-1] + "," + key + "}", False
    answer = json.loads(text)
    before = copy.deepcopy(answer)
    kind = rng.choice(KINDS)
    kind(answer, rng)
    if answer == before:
        return None
    claim = claim_of(answer)
    return kind.__name__, json.dumps(answer), claim is not None and claim == claim_of(before)


def question_of(answer):
    """What a file claims to answer, asked anew; nothing where nobody could ask it."""
    certificate = answer["certificate"]
    gap = abs(answer["bar"]["gap"])
    question = {"cells": answer["cells"], "gap": answer["bar"]["gap"], "phases": answer["schedule"],
                "segments": answer["segments"]}
    if len(answer["stops"]) > 1:
        question["second-stop"] = -answer["stops"][1]["place"]
    if certificate.get("strain_limit") is not None:
        question["strain-limit"] = certificate["strain_limit"] * gap
    if certificate.get("tip_floor") is not None:
        question["tip-floor"] = certificate["tip_floor"] * gap
    if answer["status"] == "none" and certificate["kind"] == "energy-range" and \
            certificate.get("energy_ratio") is not None:
        question["energy-ratio"] = certificate["energy_ratio"]
    return question


def claim_of(answer):
    """What a file says apart from its multipliers; nothing where it asks no question."""
    try:
        certificate = answer["certificate"]
        return command(question_of(answer)), answer["status"], answer.get("objective"), answer.get("energy_ratio"), \
            answer.get("energy_ratio_range"), certificate.get("energy_ratio"), certificate["kind"]
    except (TypeError, KeyError, AttributeError, IndexError):
        return None


@functools.lru_cache(maxsize=4096)
def asked_anew(program, words):
    done = subprocess.run([program, *words, "--quiet", "--format=json"], capture_output=True, text=True, check=False)
    return done.stdout


def is_true(program, answer):
    """Does the program, asked anew, say what was proved of a forged file? Of "found" that is a bound, which
    holds where there is no motion at all."""
    words = command(question_of(answer)) + (["--objective=min-energy"] if answer["status"] == "found" else [])
    try:
        new = json.loads(asked_anew(program, tuple(words)))
    except ValueError:
        return False
    if new["status"] == "none" and (answer["status"] == "found" or new["reason"] != "constraints"):
        return True
    if answer["certificate"]["kind"] == "energy-floor" and answer["status"] == "none":
        return new["status"] == "found" and \
            answer["certificate"]["energy_ratio"] <= new["energy_ratio_range"][0] * (1 + 1e-6)
    if answer["status"] == "found":  # a bound: it may be lower than the least, and hold of none
        return new["status"] == "none" or \
            (new["status"] == "found" and answer["energy_ratio_range"][0] <= new["energy_ratio_range"][0] * (1 + 1e-6))
    if new["status"] != answer["status"]:
        return False
    if answer["certificate"]["kind"] == "farkas":
        return True
    least = new["energy_ratio_range"][0]
    return abs(answer["energy_ratio_range"][0] / least - 1) < 1e-6


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("--program", default=str(ROOT / "build/release/bin/signorini"))
    parser.add_argument("--count", type=int, default=300, help="certificates")
    parser.add_argument("--forgeries", type=int, default=3000)
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args()
    if not os.path.exists(options.program):
        parser.error(f"{options.program} is not there: build signorini-program")
    rng = random.Random(options.seed)
    faults = 0
    proved = str(ROOT / "build/proofs/check-proved")
    plain = str(ROOT / "tools/check-certificate")
    counts, made, refused, left = collections.Counter(), 0, collections.Counter(), 0
    same, true = 0, collections.Counter()
    each = -(-options.forgeries // options.count)
    with tempfile.TemporaryDirectory() as folder:
        while made < options.count:
            texts = []
            while len(texts) < min(200, options.count - made):
                text = answered(options.program, random_question(rng), folder)
                if text:
                    texts.append(text)
            for text, ours, theirs in zip(texts, judged(proved, texts, folder), judged(plain, texts, folder)):
                certificate = json.loads(text)["certificate"]
                if any(reason in ours for reason in UNKNOWN):
                    left += 1
                elif not ours.startswith("proved") or not theirs.startswith("proved"):
                    faults += 1
                    print(f"proved checker: {ours}\nPython: {theirs}\n{text}\n")
                else:
                    counts[certificate["kind"], certificate["rows"]] += 1
            made += len(texts)
            fakes = [fake for text in texts for fake in (forged(text, rng) for _ in range(each)) if fake]
            for start in range(0, len(fakes), 1000):
                some = fakes[start:start + 1000]
                for (kind, text, repeated), said in zip(some, judged(proved, [fake[1] for fake in some], folder)):
                    if not said.startswith("proved"):
                        refused[kind] += 1
                    elif repeated:
                        same += 1
                    elif kind != "key_twice" and is_true(options.program, json.loads(text)):
                        true[kind] += 1
                    else:
                        faults += 1
                        print(f"forgery {kind} accepted: {said}\n{text}\n")
            if made % 1000 == 0:
                print(f"{made} certificates, {sum(refused.values())} forgeries refused", file=sys.stderr, flush=True)
    for (kind, rows), number in sorted(counts.items()):
        print(f"{number} certificates accepted by both, {kind} over rows {rows}")
    print(f"{made} certificates: {sum(counts.values())} accepted by both checkers, {left} of kinds that the proved "
          f"one does not know; of {sum((refused + true).values()) + same} alterations {sum(refused.values())} refused, "
          f"{same} still proofs of the same claim, {sum(true.values())} of another that is true; {faults} faults")
    print("refused: " + ", ".join(f"{kind} {number}" for kind, number in sorted(refused.items())))
    print("true: " + ", ".join(f"{kind} {number}" for kind, number in sorted(true.items())))
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
