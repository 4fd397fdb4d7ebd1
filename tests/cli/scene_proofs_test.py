#!/usr/bin/env python3
"""Answers about bars in a row are proved by tools/check-certificate, and no longer once they are altered.

    scene_proofs_test.py PROGRAM CHECKER [COUNT]

The checker has a law of its own, in fractions. Altered are what is claimed, the multipliers, and the scene: each
alteration either claims more than is proved or takes the proof away.
"""
import copy
import json
import random
import subprocess
import sys


def scene_of(rng):
    """Words of bars that are held, and how many contacts they have."""
    words, contacts = ["clamp"], 0
    for bar in range(rng.randint(1, 3)):
        if bar:
            words.append(f"gap={rng.choice([1e-3, 2e-3, 5e-4, -1e-3])}")
            contacts += 1
        for part in range(rng.randint(1, 2)):
            if part and rng.random() < 0.4:
                words.append(rng.choice(["dash=0.3", "stop=1e-3", "stop=-1.5e-3"]))
                contacts += words[-1].startswith("stop")
            words.append(rng.choice(["{}", "{}:1.3", "{}:0.4:2"]).format(rng.randint(1, 6)))
        if bar or rng.random() < 0.4:
            words += ["clamp"] if bar else []
        if not bar and rng.random() < 0.5:
            words.append("stop=1e-3")
            contacts += 1
            break
    if not contacts:
        words.append("stop=1e-3")
        contacts = 1
    return " ".join(words), contacts


def loose_scene_of(rng):
    """Words of bars on springs, with masses and forces, under their weight, or that nothing holds."""
    kind = rng.randrange(4)
    cells = rng.randint(2, 6)
    if kind == 0:  # bounces
        return f"{cells} stop={rng.choice([0, 1e-3])}", [str(2 * cells), str(6 * cells + rng.choice([0, 0, 1]))], 10
    if kind == 1:  # flies
        f = rng.randint(1, 12)
        return f"stop=-1e-3 {cells} stop=1e-3", [f"2:{2 * cells}", f"-:{f}", f"1:{2 * cells}", f"-:{f}"], 0
    if kind == 2:
        words = f"spring={rng.choice([2, 30])} {cells} {rng.choice(['', 'mass=0.1 '])}{cells} stop=1e-3"
    else:
        words = f"clamp {cells} force={rng.choice([1e-4, -2e-4])} {rng.choice(['', 'spring=3 '])}{cells} gap=5e-4 " \
            f"{rng.choice(['2', '3:2'])} gap=1e-3 2 clamp"
        spans = [f"1:{rng.randint(1, 4)}", f"-:{rng.randint(2, 12)}"]
        return words, [*spans, *(span.replace("1:", "2:") if span[0] == "1" else span for span in spans)], 0
    return words, [str(rng.randint(1, 9)), str(rng.randint(2, 25))], rng.choice([0, 1e-4])


def forced_scene_of(rng):
    """Words of bars that something drives, a schedule, weight, and what drives."""
    cells, kind = rng.randint(2, 5), rng.randrange(4)
    spans, gravity = [str(rng.randint(1, 6)), str(rng.randint(3, 20))], 0
    if kind == 0:
        other = f"{rng.randint(2, 4)}:{rng.choice([1, 1.3])}"
        words = f"clamp shaken {cells} dash=0.1 driven gap=1e-3 {other} dash=0.05 2 clamp"
    elif kind == 1:
        words = f"driven stop=-1e-3 {cells} dash=0.1 stop=1e-3"
        spans = [f"1:{spans[0]}", f"-:{spans[1]}", f"2:{spans[0]}", f"-:{spans[1]}"]
    elif kind == 2:
        words = f"spring=4 {cells} dash={rng.choice([0.1, 1])} driven stop=1e-3"
    else:
        words, gravity = f"driven {cells} dash=0.1 stop={rng.choice([0, 1e-3])}", rng.choice([1e-4, -1e-4])
    force = "base" if kind == 0 and rng.random() < 0.5 else "tip"
    amplitude = ["--amplitude", repr(10 ** rng.uniform(-5, -1))] if rng.random() < 0.7 else []
    return words, spans, gravity, ["--force", force, *amplitude]


def forged_forced(answer, rng):
    """The same with one thing that is not so."""
    forged = copy.deepcopy(answer)
    kind = rng.choice(["status", "cycles", "frequency", "force", "limits", "no cuts", "push", "waves", "gap"])
    cuts = forged["certificate"]["cuts"]
    if kind == "status":
        forged["status"] = "found"
    elif kind == "cycles":
        forged["cycles"] += 1
    elif kind == "frequency":
        forged["frequency"] *= 1.01
    elif kind == "force":
        forged["force"] = "both"
    elif kind == "limits":
        cuts[0]["limits"] = 1
    elif kind == "no cuts":
        forged["certificate"]["cuts"] = []
    elif kind == "push":
        cuts[0]["pushes"].append([1, 0, -1.0])
    elif kind == "waves":
        for cut in cuts:
            size = 1 + sum(map(abs, cut["periodicity"]))
            cut["periodicity"] = [value + size * rng.uniform(-1, 1) for value in cut["periodicity"]]
    else:
        forged["contacts"][0]["gap"] += 1e-3
    return kind, forged


def schedule_of(rng, contacts):
    """SET:STEPS ..., the last one open."""
    spans = []
    for _ in range(rng.randint(1, 2)):
        closed = rng.sample(range(1, contacts + 1), rng.randint(1, min(2, contacts)))
        spans += [f"{'+'.join(map(str, sorted(closed)))}:{rng.randint(1, 9)}", f"-:{rng.randint(1, 25)}"]
    return spans


def with_motions(rng):
    """The paper's bar, or two of equal travel time, whose push is that of one (docs/theory.md, section 20)."""
    cells = 2 * rng.randint(1, 12)
    other = f"gap=1e-3 {cells}:{rng.choice([1, 2, 0.7])} clamp"
    return f"clamp {cells} {rng.choice(['stop=1e-3', other])}", [str(cells // 2), str(3 * cells)]


def altered(answer, rng):
    """The same with one thing that is not so."""
    forged = copy.deepcopy(answer)
    certificate = forged["certificate"]
    kinds = ["claim", "push", "period", "status", "spring", "cells", "key", "reason"]
    is_loaded = answer["scene"]["gravity"] or any(part["kind"] == "force" for part in answer["scene"]["parts"])
    if answer["contacts"][0]["gap"]:
        kinds.append("gap")
    if answer["kernel_dimension"] < 2 * answer["cells"]:
        kinds.append("waves")  # else all waves come back, and what multiplies their change is nothing
    if all(contact["gap"] > 0 for contact in answer["contacts"]) and not is_loaded:
        kinds.append("open")  # what is pressed at rest, or by forces, has to keep away then, and perhaps cannot
    kind = rng.choice(kinds)
    if kind == "claim":  # whole multipliers prove any energy but for the checker's own rounding
        key = "energy_ratio" if answer["reference"]["energy"] else "energy"
        certificate[key] = 1e300 if answer["status"] == "none" else 1.01 * certificate[key] + 1e-300
    elif kind == "waves":
        size = 1 + sum(map(abs, certificate["periodicity"]))
        certificate["periodicity"] = [value + size * rng.uniform(-1, 1) for value in certificate["periodicity"]]
    elif kind == "push":
        certificate["pushes"].append([1, 0, -1.0])
    elif kind == "period":
        forged["period"] *= 1.01
    elif kind == "gap":
        forged["contacts"][0]["gap"] *= -1
    elif kind == "status":
        forged["status"] = "none" if answer["status"] == "found" else "found"
    elif kind == "spring":
        forged["scene"]["parts"].insert(1, {"kind": "spring", "stiffness": 1.0})
    elif kind == "cells":
        next(part for part in forged["scene"]["parts"] if part["kind"] == "cells")["cells"] += 1
    elif kind == "reason":  # allowed are constraints, with none
        forged["reason"] = "constraints" if answer["status"] == "found" else "penetration"
    elif kind == "key":
        certificate["limits"] = 1
    else:  # no contact closes, so no distance has to be 0
        for span in forged["schedule"]:
            span["closed"] = []
    return kind, forged


def main():
    program, checker = sys.argv[1:3]
    count = int(sys.argv[3]) if sys.argv[3:] else 150
    rng = random.Random(20261124)
    said, refused = {"none": 0, "found": 0, "undecided": 0, "no question": 0}, 0

    def is_proved(answer):
        done = subprocess.run([checker, "-"], input=json.dumps(answer), capture_output=True, text=True, check=False)
        assert done.returncode in (0, 1), done.stderr
        return done.returncode == 0, done.stdout

    for _ in range(count):
        gravity, drive = 0, []
        draw = rng.random()
        if draw < 0.25:
            scene, spans, gravity, drive = forced_scene_of(rng)
        elif draw < 0.4:
            scene, spans = with_motions(rng)
        elif draw < 0.7:
            scene, spans, gravity = loose_scene_of(rng)
        else:
            scene, contacts = scene_of(rng)
            spans = schedule_of(rng, contacts)
        words = [program, "find", "--scene", scene, *spans, "--format", "json", "--quiet"]
        words += ["--gravity", str(gravity)] * bool(gravity) + drive
        done = subprocess.run(words, capture_output=True, text=True, check=False)
        if done.returncode == 2:  # held twice, or the bars at rest are a motion
            said["no question"] += 1
            continue
        answer = json.loads(done.stdout)
        said[answer["status"]] += 1
        proved, why = is_proved(answer)
        assert proved == (answer["certificate"] is not None), (words, why)
        wanted = answer["status"] == "none" if drive else answer["status"] != "undecided" and answer["energy"] != 0
        assert proved == wanted, (words, why)
        if proved:
            kind, forged = (forged_forced if drive else altered)(answer, rng)
            proved, why = is_proved(forged)
            assert not proved, (words, kind, why)
            refused += 1
    print(said, f"{refused} forgeries refused")
    assert said["none"] > count // 4 and said["found"] > count // 10 and said["undecided"] <= count // 100


if __name__ == "__main__":
    main()
