#!/usr/bin/env python3
"""Certificates the program prints prove absence to a checker that shares no code with it.

certificates_test.py PROGRAM [--count N] [--seed S]

Random schedules of uniform bars and of bars of several segments: every "none" must come with a
proof, and a proof spoilt in one number is refused.
The same with two stops or several phases, where no proof may fit a schedule that has motions.
"""
import argparse
import copy
import json
import pathlib
import random
import sqlite3
import subprocess
import sys
import tempfile
from fractions import Fraction

if (tools := str(pathlib.Path(__file__).resolve().parents[2] / "tools")) not in sys.path:
    sys.path.append(tools)
from checkers import certificate as certificates, lift, paper
from checkers.reading import NoProof
from checkers.scene import ASKED


def require_proof(check, answer, words):
    """Ends the run if the checker does not accept the proof."""
    try:
        check(answer)
    except NoProof as why:
        sys.exit(f"{words}: {why}")


def refuse(check, answer, words):
    """Ends the run if the checker accepts a proof of what is not so."""
    try:
        sys.exit(f"{words}: {check(answer)}")
    except NoProof:
        pass


def bare(answer, certificate=None):
    """What is claimed of a schedule, and nothing of its motions; as none, with another certificate."""
    claim = {key: answer[key] for key in ASKED}
    return claim if certificate is None else {**claim, "status": "none", "certificate": certificate}


def spoilt(answer, draw):
    """The answer with one change that no proof survives."""
    answer = copy.deepcopy(answer)
    certificate = answer["certificate"]
    names = ("periodicity", "pressure", "penetration", "landing", "equalities", "inequalities")
    lists = [name for name in names if certificate.get(name)]
    ways = ["gap"] if "gap" in certificate else []
    ways += [(way, name) for name in lists for way in ("value", "drop", "twice")]
    way = draw.choice(ways)
    if way == "gap":
        gap = certificate["gap"]
        certificate["gap"] = draw.choice([v for v in (0, 1, -1, -gap, gap - 1, 1.5) if v != gap])
        return answer, "gap"
    kind, name = way
    rows = certificate[name]
    place = draw.randrange(len(rows))
    if kind == "value":
        value = rows[place][1]
        change = draw.choice([-1, 1])
        rows[place][1] = value + change if isinstance(value, int) else str(Fraction(value) + change)
    elif kind == "drop":
        del rows[place]
    else:
        rows.append(rows[place])
    return answer, f"{name}, {kind}, row {place}"


def random_bar(draw):
    """--segments of a bar, and its cells."""
    parts = [(draw.randint(1, 3), draw.choice([1, 1.3, 0.2, 7, 1e-3, 1e3]))
             for _ in range(draw.choice([2, 2, 2, 3, 4]))]
    dashpots = [draw.choice([0, 0, 0, 0.3]) for _ in parts[1:]] + [0]
    words = [f"{cells}:{impedance}" + (f":1:{dashpot}" if dashpot else "")
             for (cells, impedance), dashpot in zip(parts, dashpots)]
    return ["--segments", ",".join(words)], sum(cells for cells, _ in parts)


def is_without_effect(answer, other):
    """Do they differ only in rows of (30) that read 0 = 0, where W leaves the unknown alone?"""
    first, second = (dict(map(tuple, a["certificate"]["periodicity"])) for a in (answer, other))
    changed = [row for row in first.keys() | second.keys() if first.get(row, 0) != second.get(row, 0)]
    if not changed:  # the landing of a flight whose p add up to 0 whatever they are
        first, second = (dict(map(tuple, a["certificate"].get("landing", [])))
                         for a in (answer, other))
        return bool(first) and all(answer["schedule"][row][1] % (4 * answer["cells"]) == 0
                                   for row in first if first[row] != second.get(row, 0))
    state = [(unknown, 1) for unknown in range(2 * answer["cells"])]
    for contact, free in answer["schedule"]:
        state = paper.carried(paper.carried(state, paper.dd, contact), paper.dn, free)
    return bool(changed) and all(state[row] == (row, 1) for row in changed)


def random_scene(draw):
    """Words for a schedule of one to three phases, on one stop or two."""
    cells = draw.choice([1, 2, 3, 4, 6, 9, 12, 30])
    two = draw.random() < 0.7
    words = []
    for _ in range(draw.choice([1, 2, 3] if two else [2, 3])):
        left = "L:" if two and draw.random() < 0.5 else ""
        words += [f"{left}{draw.randint(1, 3 * cells)}", str(draw.randint(1, 6 * cells))]
    if two and draw.random() < 0.3:  # a pair of mirrored phases
        words = [words[0].replace("L:", ""), words[1]]
        words += ["L:" + words[0], words[1]]
    words += ["--cells", str(cells), "--format", "json"]
    words += draw.choice([[], ["--gap", "-1e-3"], ["--gap", "0", "--energy", "1"]])
    if two:
        words += ["--second-stop", repr(draw.choice([1.001e-3, 2e-3, draw.uniform(1.01e-3, 4e-3),
                                                     4e-3 / 3]))]
    return words


def refuse_spoilt(answer, draw, words):
    """How many of three spoilt proofs are refused; the others must not have lost anything."""
    refused = 0
    for _ in range(3):
        bad, what = spoilt(answer, draw)
        try:
            certificates.check(bad)
        except NoProof:
            refused += 1
            continue
        if not is_without_effect(answer, bad):
            sys.exit(f"{words}: spoilt ({what}), and still taken for a proof")
    return refused


def check_lifted(options, draw):
    """Proofs over sums as proofs over the paper's rows; how many hold, how many spoilt ones are
    refused."""
    lifted = refused = 0
    while lifted < options.count:
        words = random_scene(draw)
        if "--second-stop" in words:
            continue
        answer = json.loads(subprocess.run([options.program, "find", *words], capture_output=True,
                                           check=False).stdout or "{}")
        if (answer.get("certificate") or {}).get("rows") != "lumped":
            continue
        answer = bare(answer)
        answer["certificate"] = lift.lifted(answer)
        require_proof(certificates.check, answer, f"{' '.join(words)}, lifted")
        lifted += 1
        refused += refuse_spoilt(answer, draw, " ".join(words))
    return lifted, refused


def check_scenes(options, draw):
    """Proofs over the rows of sums; how many hold, and how many are refused where motions exist."""
    proved = refused = 0
    mirrored = ["1", "5", "L:1", "5", "--cells", "4", "--second-stop", "1e-3", "--format", "json"]
    found, proofs = [json.loads(subprocess.check_output([options.program, "find", *mirrored]))], []
    while proved < options.count:
        words = random_scene(draw)
        call = subprocess.run([options.program, "find", *words], capture_output=True, check=False)
        if call.returncode not in (0, 1):
            continue  # without a gap some schedules are refused
        answer = json.loads(call.stdout)
        if answer["status"] == "found":
            found.append(answer)
            continue
        if answer["reason"] == "constraints":
            continue  # between two stops without a gap only the bar at rest, and no energy
        require_proof(certificates.check, answer, " ".join(words))
        proved += 1
        proofs.append(answer["certificate"])
    for answer in found:
        for certificate in proofs:
            refuse(certificates.check, bare(answer, certificate), f"{answer['schedule']} has motions")
            refused += 1
    return proved, refused


def spoilt_energies(answer, draw):
    """The answer with one change after which its energies are not proved, or not those claimed."""
    answer = copy.deepcopy(answer)
    certificate, (least, most) = answer["certificate"], answer["energy_ratio_range"]
    ways = ["least", "drop"] + (["most", "unbounded"] if most is not None else [])
    if answer["status"] == "found":
        ways.append("state")
    elif most is None or most > 1.001 * least:
        ways.append("wanted")
    way = draw.choice(ways)
    if way == "least":
        answer["energy_ratio_range"][0] = least * draw.choice([1 - 1e-9, 1 + 1e-9])
    elif way == "most":
        answer["energy_ratio_range"][1] = most * draw.choice([1 - 1e-9, 1 + 1e-9])
    elif way == "unbounded":  # a claim less
        answer["energy_ratio_range"] = [least * 2, None]
    elif way == "wanted":
        if "strain_limit" in certificate:
            certificate["strain_limit"] = 1e9
        certificate["energy_ratio"] = 1.0005 * least
    elif way == "state":
        answer["objective"] = draw.choice(["min-energy", "max-energy"])
        answer["energy_ratio"] = (least if answer["objective"] == "min-energy" else most or 1)
        answer["energy_ratio"] *= draw.choice([1 - 1e-6, 1 + 1e-6])
    else:
        certificate["equalities"] = []
    return answer, way


def existing(options, folder):
    """Words of calls about schedules that have motions, from atlases."""
    calls = []
    for number, (scene, words) in enumerate([
            (["--cells", "30"], []), (["--cells", "7", "--gap", "-1e-3"], []),
            (["--cells", "3"], ["--phases", "2"]),
            (["--cells", "6"], ["--phases", "2", "--max-contact", "4"]),
            (["--cells", "3", "--gap", "-1e-3"], ["--phases", "2"]),
            (["--cells", "2", "--second-stop", "1.5e-3"], ["--phases", "2"])]):
        path = folder / f"atlas{number}.sqlite"
        subprocess.run([options.program, "atlas", "--quiet", "--database", str(path), *scene, *words],
                       stdout=subprocess.DEVNULL, check=True)
        base = sqlite3.connect(path)
        rows = base.execute("SELECT phases FROM schedules WHERE status = 'found' ORDER BY rowid")
        calls.append([[word for phase in phases.split(",") for word in phase.rsplit(":", 1)] + scene
                      for phases, in rows])
        base.close()
    return calls


def check_all_energies(options, draw):
    """Least and most energies of random schedules; how many hold, how many spoilt ones are refused."""
    proved = refused = several = most_known = beyond = limited = 0
    with tempfile.TemporaryDirectory() as name:
        path = pathlib.Path(name) / "proof.json"
        calls = existing(options, path.parent)
        while proved < options.count:
            demand = draw.choice([[], [], ["--objective", "max-energy"],
                                  ["--energy-ratio", repr(draw.choice([1.01, 300]))],
                                  ["--energy-ratio", repr(draw.choice([10, 30, 100])),
                                   "--strain-limit", repr(draw.choice([3e-3, 1e-2]))]])
            path.unlink(missing_ok=True)
            group = calls[0] if "--strain-limit" in demand else draw.choice(calls)  # of one phase
            words = ["find", *draw.choice(group), *demand, "--solver", "closed-form",
                     "--quiet", "--certificate", str(path)]
            subprocess.run([options.program, *words], stdout=subprocess.DEVNULL,
                           stderr=subprocess.DEVNULL, check=False)
            if not path.exists():
                continue  # an energy or an end that the closed form does not know
            answer = json.loads(path.read_text(encoding="utf-8"))
            try:
                certificates.check(answer)
            except NoProof as why:
                if "not known to this checker" in str(why):
                    continue
                sys.exit(f"{' '.join(words)}: {why}")
            proved += 1
            certificate = answer["certificate"]
            several += len(certificate["equalities"]) + len(certificate["inequalities"]) > 1
            most_known += answer["energy_ratio_range"][1] is not None
            beyond += answer["status"] == "none"
            limited += "strain_limit" in certificate
            bad, what = spoilt_energies(answer, draw)
            refuse(certificates.check, bad, f"{' '.join(words)}: spoilt ({what})")
            refused += 1
    if limited < options.count // 50:
        sys.exit(f"energies: only {limited} of them within a limit of strain")
    return (f"{proved} proofs hold, {several} of several rows, {most_known} with the most energy, "
            f"{beyond} of no motion of an energy, {limited} of them within a limit of strain; {refused} "
            "spoilt ones are refused")


def check_stepped_energies(options, draw):
    """Least energies of bars of several segments; how many hold, how many spoilt ones are refused."""
    proved = refused = 0
    with tempfile.TemporaryDirectory() as name:
        path = pathlib.Path(name) / "proof.json"
        while proved < options.count // 10:
            words = call_of_few_cells(draw)
            path.unlink(missing_ok=True)
            subprocess.run([options.program, *words, "--quiet", "--certificate", str(path)],
                           stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, check=False)
            answer = json.loads(path.read_text(encoding="utf-8")) if path.exists() else {}
            if answer.get("status") != "found" or answer["certificate"]["rows"] != "network":
                continue
            require_proof(certificates.check, answer, " ".join(words))
            proved += 1
            for factor in (1 - 1e-6, 1 + 1e-6, None):
                bad = copy.deepcopy(answer)
                if factor:
                    bad["energy_ratio"] *= factor
                else:
                    bad["certificate"]["places"] = []
                refuse(certificates.check, bad, f"{' '.join(words)}: spoilt ({factor})")
                refused += 1
    return proved, refused


def call_of_many_cells(draw):
    """Words about a schedule of a stepped bar that hardly has motions."""
    counts = [draw.randint(13, 40) for _ in range(draw.choice([2, 3, 4]))]
    bar = ",".join(f"{count}:{draw.uniform(0.3, 3)!r}" for count in counts)
    steps = draw.randint(3 * sum(counts), 4 * sum(counts))
    contact = draw.randint(1, steps - 1)
    scene = draw.choice([[], ["--gap", "-1e-3"], ["--second-stop", "2e-3"], ["--tip-floor", "-3e-2"]])
    return ["find", str(contact), str(steps - contact), "--segments", bar, *scene, "--format", "json"]


def check_floors(options, draw, count, is_large):
    """Stepped bars, whose absence is proved below a huge energy; how many hold, how many spoilt ones are
    refused."""
    proved = refused = 0
    while proved < count:
        words = call_of_many_cells(draw) if is_large else stepped_call(draw)
        answer = json.loads(subprocess.run([options.program, *words], capture_output=True, check=False).stdout)
        if answer["status"] != "none" or answer["certificate"]["rows"] != "network":
            continue
        require_proof(certificates.check, answer, " ".join(words))
        proved += 1
        for name, spoil in FLOOR_SPOILS.items():
            if not is_large and name in ("a wave off", "another bar", "another gap"):
                continue  # of few waves some stay alone, and there is no motion either
            bad = copy.deepcopy(answer)
            spoil(bad, bad["certificate"])
            refuse(certificates.check, bad, f"{' '.join(words)}: {name}")
            refused += 1
    return proved, refused


FLOOR_SPOILS = {
    "an energy beyond all": lambda answer, proof: proof.update(energy_ratio=1e300),
    "an energy that a bar bears": lambda answer, proof: proof.update(energy_ratio=1e6),
    "no energy": lambda answer, proof: proof.pop("energy_ratio"),
    "a wave off": lambda answer, proof: proof["periodicity"].__setitem__(0, proof["periodicity"][0] + 1.0),
    "a wave less": lambda answer, proof: proof["periodicity"].pop(),
    "a place twice": lambda answer, proof: proof["places"].append(proof["places"][0]),
    "no place": lambda answer, proof: proof.update(places=[]),
    "a pull": lambda answer, proof: proof["pushes"].append([1, 0, -1e-9]),
    "a push in flight": lambda answer, proof: proof["pushes"].append([1, answer["schedule"][0][0], 1.0]),
    "a contact more": lambda answer, proof: proof["places"].append([4, 0, 1.0]),
    "a key that nobody knows": lambda answer, proof: proof.update(damping=0.1),
    "another gap": lambda answer, proof: (answer["bar"].update(gap=-answer["bar"]["gap"]),
                                          answer["stops"][0].update(place=-answer["stops"][0]["place"])),
    "another bar": lambda answer, proof: answer["segments"][0].update(
        impedance=answer["segments"][0]["impedance"] * 1.01),
}


def call_of_few_cells(draw):
    """Words about a schedule of a stepped bar that may well have motions."""
    counts = [draw.randint(1, 4) for _ in range(draw.choice([2, 2, 3]))]
    bar = ",".join(f"{count}:{draw.choice([0.2, 0.5, 1, 1.3, 2, 3, 7])}" for count in counts)
    joint = draw.choice(["", "", ":1:0.3"])
    scene = draw.choice([[], ["--gap", "-1e-3"], ["--second-stop", "1.3e-3"], ["--tip-floor", "-5e-3"]])
    cells = sum(counts)
    phases = [str(draw.randint(1, 2 * cells)), str(draw.randint(1, 6 * cells))]
    if draw.random() < 0.2:
        phases += phases
    return ["find", *phases, "--segments", bar.replace(",", joint + ",", 1), *scene]


def stepped_call(draw):
    """Words of the program about a random schedule of a random bar of few cells."""
    bar, cells = random_bar(draw)
    scene = draw.choice([[], ["--gap", "-1e-3"], ["--second-stop", "1.3e-3"], ["--tip-floor", "-2e-4"]])
    other = "L:" if scene[:1] == ["--second-stop"] else ""
    phases = [str(draw.randint(1, 3 * cells)), str(draw.randint(1, 4 * cells))]
    if draw.random() < 0.3:
        phases += [other + str(draw.randint(1, cells)), str(draw.randint(1, 2 * cells))]
    return ["find", *phases, *bar, *scene, "--format", "json"]


def random_call(draw):
    """Words of the program about a random schedule."""
    scene = draw.choice([[], ["--gap", "-1e-3"], ["--gap", "0", "--energy", "1"]])
    cells = draw.choice([1, 2, 3, 4, 6, 9, 12, 30, 60])
    phases = [str(draw.randint(1, 3 * cells)), str(draw.randint(1, 6 * cells))]
    return ["find", *phases, "--cells", str(cells), *scene, "--format", "json"]


def with_limits(draw, motion):
    """Words of limits, one of which at least the motion does not keep."""
    seen, wall = motion["physical"], motion["stops"][0]["place"]
    strain = ["--strain-limit", repr(draw.choice([0.3, 0.9, 0.999]) * seen["peak_compression"])]
    floor = seen["tip_lowest"] + draw.choice([1e-3, 0.1, 0.9]) * (wall - seen["tip_lowest"])
    floor = ["--tip-floor", repr(floor)] if floor < wall else strain
    return draw.choice([strain, floor, [*floor, "--strain-limit", repr(1.1 * seen["peak_compression"])]])


def check_limits(options, draw, has_simplex):
    """That no motion keeps limits of strain and tip: how many proofs hold, how many of them limit each,
    and how many are refused with limits that a motion keeps, which is known. The tip wants a simplex
    method."""
    held = {"strain_limit": 0, "tip_floor": 0}
    with tempfile.TemporaryDirectory() as name:
        calls = sum(existing(options, pathlib.Path(name)), [])
    proved = refused = 0
    while proved < options.count:
        words = ["find", *draw.choice(calls), "--solver", "closed-form", "--format", "json", "--quiet"]
        motion = json.loads(subprocess.run([options.program, *words], capture_output=True,
                                           check=True).stdout)
        words += with_limits(draw, motion)
        answer = json.loads(subprocess.run([options.program, *words], capture_output=True,
                                           check=False).stdout or "{}")
        certificate = answer.get("certificate")
        if answer.get("reason") != "constraints" or certificate["kind"] != "farkas":
            continue  # other motions keep them, or it is not the closed form that knows
        answer = bare(answer)
        require_proof(certificates.check, answer, " ".join(words))
        proved += 1
        gap = abs(motion["bar"]["gap"])
        kept = {"strain_limit": motion["physical"]["peak_compression"] / gap * (1 + 1e-9),
                "tip_floor": motion["physical"]["tip_lowest"] / gap - 1e-9}
        for name, value in kept.items():
            if certificate[name] is not None:
                held[name] += 1
                certificate[name] = value
        refuse(certificates.check, answer, f"{' '.join(words)}: with limits {kept}")
        refused += 1
    if min(held.values() if has_simplex else [held["strain_limit"]]) < options.count // 4:
        sys.exit(f"limits: one of them is hardly ever there: {held}")
    return proved, held, refused


def check_many(options, draw):
    """So many proofs over the paper's rows, and spoilt ones."""
    proved = refused = 0
    while proved < options.count:
        call = random_call(draw)
        answer = json.loads(subprocess.run([options.program, *call], capture_output=True,
                                           check=False).stdout)
        words = " ".join(call)
        if answer["status"] != "none" or answer["certificate"]["rows"] == "lumped":
            continue
        require_proof(certificates.check, answer, words)
        proved += 1
        refused += refuse_spoilt(answer, draw, words)
    return proved, refused


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("program")
    parser.add_argument("--count", type=int, default=200)
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args()
    draw = random.Random(options.seed)
    print("uniform bars: {} proofs hold, {} spoilt ones are refused".format(*check_many(options, draw)))
    print("scenes: {} proofs hold, {} of others are refused".format(
        *check_scenes(options, draw)))
    print("lifted to the paper's rows: {} proofs hold, {} spoilt ones are refused".format(
        *check_lifted(options, draw)))
    backends = subprocess.run([options.program, "--version"], capture_output=True, text=True,
                              check=True).stdout
    has_simplex = not any(line.split()[0] == "glpk-simplex" and "not in this build" in line
                          for line in backends.splitlines() if line.strip())
    print("limits: {} proofs hold, {}; {} are refused with limits of a motion".format(
        *check_limits(options, draw, has_simplex)))
    print("energies:", check_all_energies(options, draw))
    for sort, count in (("few", options.count // 4), ("many", max(3, options.count // 40))):
        print("stepped bars of {} cells: {} proofs hold, {} spoilt ones are refused".format(
            sort, *check_floors(options, draw, count, sort == "many")))
    print("energies of stepped bars: {} proofs hold, {} spoilt ones are refused".format(
        *check_stepped_energies(options, draw)))


if __name__ == "__main__":
    main()
