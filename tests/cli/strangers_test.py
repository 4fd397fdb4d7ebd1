#!/usr/bin/env python3
"""Cases of the literature that nobody here wrote, against the exact answers of their sources.

strangers_test.py PROGRAM

Every expected number is computed here from the formulas of the source, in fractions where these are
rational; nothing is taken from the program. docs/verification.md lists sources and commands.
"""
import csv
import json
import math
import pathlib
import random
import subprocess
import sys
import tempfile
from fractions import Fraction

ROUNDING = 1e-12


def in_cells(pieces, count):
    """The velocities of a wave cell by cell; pieces last whole cells."""
    cell = sum(duration for duration, _ in pieces) / count
    return [velocity for duration, velocity in pieces for _ in range(round(duration / cell))]


def waves_of(text):
    """Displacements of nodes, and the pieces of each wave, of a state file."""
    nodes, waves = [], {}
    for row in csv.DictReader(text.splitlines()):
        if row["wave"] == "0":
            nodes.append(float(row["displacement"]))
        else:
            waves.setdefault(int(row["wave"]), []).append((float(row["duration"]), float(row["velocity"])))
    return nodes, waves


class Run:
    """One simulation: its answer, contacts, path of the contact's node and final state."""

    def __init__(self, folder, scene, *words):
        names = {"--events": "events.csv", "--tip": "tip.csv", "--state": "state.csv"}
        files = [word for option, name in names.items() for word in (option, str(folder / name))]
        texts = [repr(float(word)) if isinstance(word, Fraction) else str(word) for word in words]
        call = [PROGRAM, "simulate", "--scene", scene, *texts, *files, "--format", "json", "--quiet"]
        self.words = " ".join(call[1:5])
        self.answer = json.loads(subprocess.run(call, stdout=subprocess.PIPE, check=True).stdout)
        self.contacts, self.path = (
            [{name: float(value) for name, value in row.items()}
             for row in csv.DictReader((folder / name).read_text().splitlines())]
            for name in ("events.csv", "tip.csv"))
        _, waves = waves_of((folder / "state.csv").read_text())
        self.waves = []
        counts = [int(word.split(":")[0]) for word in scene.split() if word[0].isdigit()]
        for bar, count in enumerate(counts):
            # In the order of arrival at the right, and at the left.
            right, left = (in_cells(waves[2 * bar + side], count) for side in (1, 2))
            self.waves += list(zip(reversed(right), left))
        self.speeds = [right + left for right, left in self.waves]

    def place(self, time):
        """Where the node is at a time: it moves in straight lines between the rows of its path."""
        for before, after in zip(self.path, self.path[1:]):
            if before["time"] <= time <= after["time"]:
                part = (time - before["time"]) / (after["time"] - before["time"])
                return before["displacement"] + part * (after["displacement"] - before["displacement"])
        raise AssertionError(f"{self.words}: no row at {time}")


def require(is_so, what):
    """Ends the run if an answer is not that of the source."""
    if not is_so:
        sys.exit(f"strangers: {what}")


def near(value, exact, what, tolerance=ROUNDING):
    """The same but for rounding."""
    require(abs(value - float(exact)) <= tolerance * max(1.0, abs(float(exact))), f"{what}: {value}, not {exact}")


def bouncing_bar(folder):
    """Doyen, Ern and Piperno (2011): L = 10, E = 900, rho = 1, g = 10, dropped from 5.

    It falls for sqrt(2 h/g); then 2 L/c on the ground, where it stops from the foot upwards, so the push
    is Z (v + g t); its centre leaves with the speed v upwards and flies 2 v/g. All repeats after two bounces.
    """
    length, speed, gravity, height, density = 10, 30, 10, 5, 1
    falls = Fraction(math.isqrt(2 * height * gravity), gravity)
    arrives, contact = gravity * falls, Fraction(2 * length, speed)
    flight = 2 * arrives / gravity
    push = density * speed * (arrives * contact + gravity * contact ** 2 / 2)
    period = 2 * (contact + flight)
    require(period == Fraction(16, 3), "the published period")
    require(push == density * length * gravity * period / 2, "the impulse of a bounce is the weight's")
    for cells in (1, 4, 100):
        run = Run(folder, f"{cells} stop={height}", "--gravity", gravity, "--length", length,
                  "--wave-speed", speed, "--axial-stiffness", density * speed ** 2, "--velocity", 0,
                  "--time", falls + 20 * period)
        require(len(run.contacts) == 40 or len(run.contacts) == 41, f"{len(run.contacts)} bounces, not 40")
        for k, bounce in enumerate(run.contacts[:40]):
            begins = falls + k * (contact + flight)
            near(bounce["start"], begins, f"bounce {k} begins")
            near(bounce["end"], begins + contact, f"bounce {k} ends")
            near(bounce["impulse"], push, f"impulse of bounce {k}")
            # The greatest push, as its mean over the last step before the shock is back at the foot.
            step = contact / (2 * cells)
            near(bounce["peak_force"], density * speed * (arrives + gravity * (contact - step / 2)),
                 f"peak force of bounce {k}")
    # L/c is no short binary number: fronts that meet have to do so for ever, or they multiply.
    many = 12000
    for cells in (1, 4):
        answer = json.loads(subprocess.run(
            [PROGRAM, "simulate", "--scene", f"{cells} stop={height}", "--gravity", str(gravity),
             "--length", str(length), "--wave-speed", str(speed),
             "--axial-stiffness", str(density * speed ** 2), "--velocity", "0", "--quiet",
             "--time", str(float(falls + many * period / 2 - flight / 2)), "--format", "json"],
            stdout=subprocess.PIPE, check=True).stdout)
        require(answer["contacts"][0]["count"] == many, f"{many} bounces on {cells} cells")
        near(answer["contacts"][0]["impulse"], many * push, f"impulse of {many} bounces on {cells} cells")
    # The same in units in which all numbers are short in binary: L = c = EA = 1, g = 1, and a drop of 9/2.
    require(gravity * length * Fraction(9, 2) == Fraction(height, length) * speed ** 2, "the units fit")
    bounces, begin = 10 ** 6, folder / "begin.csv"
    call = [PROGRAM, "simulate", "--scene", "2 stop=4.5", "--gravity", "1", "--format", "json", "--quiet", "--state"]
    subprocess.run([*call, str(begin), "--velocity", "0", "--time", "22"], stdout=subprocess.DEVNULL, check=True)
    done = subprocess.run([*call, str(folder / "state.csv"), "--from", str(begin), "--time", str(8 * bounces)],
                          stdout=subprocess.PIPE, check=True)
    require(json.loads(done.stdout)["contacts"][0]["count"] == bounces and
            (folder / "state.csv").read_bytes() == begin.read_bytes(), f"{bounces} bounces bit for bit")
    return f"bouncing bar: 3 grids, 40 bounces each, and {many}, to rounding; {bounces} bounces, bit for bit the same"


def bouncing_schedule(folder):
    """The same as a schedule: contact 2/3, flight 2, twice. At the end of a contact any strains and velocities may be
    added that leave the momentum as it is: in flight, 6 L/c long, they come back three times, in contact they are
    turned over, twice in a period. So near the published motion there is a family of 2 N - 1 dimensions."""
    words = ["--gravity", "10", "--length", "10", "--wave-speed", "30", "--axial-stiffness", "900", "--format", "json",
             "--quiet"]
    draw, begin, end = random.Random(3), folder / "begin.csv", folder / "end.csv"
    for cells in (1, 2, 5):
        schedule = [f"1:{2 * cells}", f"-:{6 * cells}"] * 2
        call = [PROGRAM, "find", "--scene", f"{cells} stop=5", *schedule, *words]
        found = json.loads(subprocess.run(call, stdout=subprocess.PIPE, check=True).stdout)
        near(found["period"], Fraction(16, 3), "period")
        require(found["kernel_dimension"] == 2 * cells, f"kernel of {found['kernel_dimension']} dimensions")
        near(found["contacts"][0]["impulse"], 10 * 10 * Fraction(16, 3), "the weight's impulse")
        near(found["contacts"][0]["contact_time"], Fraction(4, 3), "contact")
        call = [PROGRAM, "simulate", "--scene", f"{cells} stop=5", *words, "--state"]
        subprocess.run([*call, str(begin), "--velocity", "0", "--time", repr(5 / 3)], stdout=subprocess.DEVNULL,
                       check=True)
        published = None
        for trial in range(20 if cells > 1 else 1):
            added = [draw.uniform(-0.4, 0.4) if trial else 0.0 for _ in range(2 * cells)]
            mean = sum(added) / len(added)
            added = [value - mean for value in added]
            nodes, waves = waves_of(begin.read_text()) if trial == 0 else published
            published = nodes, waves
            rows = ["node,displacement,wave,duration,velocity"] + [f"{i + 1},{u!r},0,0,0" for i, u in enumerate(nodes)]
            for wave, pieces in waves.items():
                velocities = in_cells(pieces, cells)
                rows += [f"0,0,{wave},{1 / 3 / cells!r},{velocity + added[2 * i + wave - 1]!r}"
                         for i, velocity in enumerate(velocities)]
            begin.write_text("\n".join(rows) + "\n")
            done = subprocess.run([*call, str(end), "--from", str(begin), "--time", repr(10 * 16 / 3)],
                                  stdout=subprocess.PIPE, check=True)
            contact = json.loads(done.stdout)["contacts"][0]
            require(contact["count"] == 20, f"{contact['count']} bounces in ten periods")
            near(contact["impulse"], 10000 * Fraction(16, 30), "impulse of ten periods")
            (nodes, waves), (others, ends) = waves_of(begin.read_text()), waves_of(end.read_text())
            for one, other in zip(nodes, others):
                near(other, one, f"ten periods of neighbour {trial}: displacement", 1e-9)
            for wave in waves:
                for one, other in zip(in_cells(waves[wave], cells), in_cells(ends[wave], cells)):
                    near(other, one, f"ten periods of neighbour {trial}: wave {wave}", 1e-9)
    return "bouncing bar as a schedule: found, and 38 neighbours on two grids that repeat themselves ten times"


def two_bars(folder):
    """doi 10.1002/nme.4516: L = 10, E = rho = 1, v = 0.1 and -0.1: in contact for 2 L/c, speeds exchanged."""
    for cells in (1, 7, 100):
        run = Run(folder, f"{cells} gap=0 {cells}", "--length", 20, "--velocity", "0.1,-0.1", "--time", 25)
        require([(c["start"], c["end"]) for c in run.contacts] == [(0, 20)], f"contacts {run.contacts}")
        require(run.speeds == [-0.1] * cells + [0.1] * cells, "the speeds are exchanged")
    return "two equal bars: speeds exchanged after 20, bit for bit"


def driven_bar(folder):
    """Idesman (2013): L = 4, E = rho = 1, v(0, t) = 1, the far end fixed: v = 1 where t > x, to t = 4; then
    the wave comes back, and v = 1 for x < 8 - t. An equal bar that arrives with 2 gives the end the speed 1
    for 2 L/c, as neither knows of the other's far end."""
    cells = 32
    for step in range(1, 2 * cells):
        run = Run(folder, f"{cells} gap=0 {cells} clamp", "--length", 8, "--velocity", "2,0", "--time", step / 8)
        front = min(step, 2 * cells - step)
        require(run.speeds[cells:] == [1.0] * front + [0.0] * (cells - front), f"v at {step / 8}: {run.speeds}")
    return "driven bar: v in {0, 1} at 63 times, bit for bit"


def rigid_wall(folder):
    """Code_Aster V5.03.100 (SDNV100): a block with L = 0.2, E = 2e11, nu = 0.3, rho = 8000, a side of 0.02, held
    sideways, 2 mm from a rigid wall at 100 m/s: a shock of 2 L/c, push rho c V A, rebound at -V."""
    modulus, density, ratio, area, speed = 2e11, 8000, 0.3, 0.02 ** 2, 100
    modulus *= (1 - ratio) / ((1 + ratio) * (1 - 2 * ratio))
    wave = math.sqrt(modulus / density)
    run = Run(folder, "30 stop=2e-3", "--length", 0.2, "--young", repr(modulus), "--density", density,
              "--area", repr(area), "--velocity", speed, "--time", 2e-4)
    require(len(run.contacts) == 1, "one shock")
    shock = run.contacts[0]
    near(shock["start"] / 2e-5, 1, "the shock begins")
    near((shock["end"] - shock["start"]) / (2 * 0.2 / wave), 1, "the shock lasts")
    near(shock["peak_force"] / (density * wave * speed * area), 1, "its push")
    for rebound in run.speeds:
        near(rebound / speed, -1, "rebound")
    return "impact on a rigid wall: 2 L/c, rho c V A, -V, to rounding"


def stepped_load(folder):
    """The clamped-free bar of ARCH-COMP under a constant force at the tip from rest: greatest velocity F/Z and
    displacement 2 F x/(EA) at x = 0.7 L until t = 0.01."""
    length, young, density = 200, 30e6, 7.3e-4
    force = 10100
    most, farthest = force / math.sqrt(young * density), 2 * force * 0.7 * length / young
    require(round(most, 4) == 68.2495 and round(farthest, 7) == 0.0942667, "the published figures")
    speeds = []
    for k in range(1, 41):
        run = Run(folder, f"clamp 7 stop=1 3 force={force}", "--length", length, "--young", young,
                  "--density", density, "--area", 1, "--velocity", 0, "--time", k * 0.01 / 40)
        speeds.append(max(run.speeds[6], run.speeds[7]))
    near(max(speeds) / most, 1, "greatest velocity")
    near(max(row["displacement"] for row in run.path) / farthest, 1, "greatest displacement")
    return "bar of ARCH-COMP, constant force: 68.2495 and 0.0942667"


def any_load(folder):
    """The same under any force in [9900, 10100]: v is a sum of echoes F(t - d)/Z of both signs, so the greatest has
    10100 in those that add and 9900 in the others: 5 and 4 of them until t = 0.01. """
    length, young, density, low, high, end = 200, 30e6, 7.3e-4, 9900, 10100, 0.01
    wave, impedance = math.sqrt(young / density), math.sqrt(young * density)
    arrivals = sorted((2 * echo + 1 + side * 0.7, echo, side) for echo in range(6) for side in (-1, 1))
    echoes = [(delay * length / wave, 1 if (side < 0) == (echo % 2 == 0) else -1) for delay, echo, side in arrivals]
    speed = most = before = way = farthest = level = 0.0
    for delay, sign in echoes:
        if delay <= end:
            speed += sign * (high if sign > 0 else low)
            most = max(most, speed / impedance)
        # u is the integral of F times the step response, 10100 where that is positive and 9900 where it is not.
        way += (min(delay, end) - before) * level * (high if level > 0 else low) / impedance
        before, level, farthest = min(delay, end), level + sign, max(farthest, way)
    require(round(most, 4) == 73.6554, f"the published figure, not {most}")
    call = [PROGRAM, "simulate", "--scene", "clamp 7 stop=1 3 driven", "--length", str(length), "--young", str(young),
            "--density", str(density), "--area", "1", "--force-range", f"{low},{high}", "--time", str(end), "--format",
            "json", "--quiet"]
    answer = json.loads(subprocess.run(call, stdout=subprocess.PIPE, check=True).stdout)
    require(answer["closes"] is None, "nothing closes")
    velocity, displacement = (answer["contacts"][0][key][1] for key in ("velocity", "displacement"))
    for said in ("bound", "reached"):
        near(velocity[said] / most, 1, f"greatest velocity, {said}")
        near(displacement[said] / farthest, 1, f"greatest displacement, {said}", 1e-10)
    require(velocity["bound"] >= velocity["reached"] * (1 - 1e-15), "a bound is no less than what is reached")
    return f"bar of ARCH-COMP, any force: {most:.4f}, proved and reached"


def at_the_obstacle(height, time):
    """u(0, t) of a string of length 1 plucked by 1 in the middle, above a point obstacle at height h: Cabannes'
    u = (1 + h)/(3 - h) + (3 - h)/2 (K_1 - K_2) at x = 0, where X = 0, T = t and l = h."""
    def k(y):
        y = abs(y)
        return (y - math.floor(y) - Fraction(1, 2)) ** 2
    scale = 3 - height
    first = 2 * k(2 * time / scale)
    second = k((2 * time + 1 - height) / scale) + k((1 - height - 2 * time) / scale)
    return (1 + height) / scale + scale / 2 * (first - second)


def string(folder):
    """Cabannes: string over a point obstacle, periodic for rational h, with the period (3 - h)/2."""
    cells, begin, compared = 6, folder / "begin.csv", 0
    for height in (Fraction(1, 2), Fraction(1, 3), Fraction(1, 4), Fraction(2, 3), Fraction(3, 8)):
        # To the obstacle is to the right: u = -w.
        rows = ["node,displacement,wave,duration,velocity", "1,0,0,0,0", "2,-1,0,0,0", "3,0,0,0,0"]
        rows += [f"0,0,{wave + 1},0.5,{velocity}" for wave, velocity in enumerate((1, -1, -1, 1))]
        begin.write_text("\n".join(rows) + "\n")
        period = (3 - height) / 2
        run = Run(folder, f"clamp {cells} stop=right:{-float(height)!r} {cells} clamp", "--length", 1,
                  "--from", begin, "--time", 6 * period)
        require(len(run.contacts) == 6, f"{len(run.contacts)} contacts, not 6")
        for k, contact in enumerate(run.contacts[:5]):  # its middle moves with 2, until a wave has crossed it all
            near(contact["start"], k * period + (1 - height) / 2, "it meets the obstacle")
            near(contact["end"], k * period + 1, "it leaves the obstacle")
        for k in range(500):
            time = 5 * period * k / 500
            near(-run.place(float(time)), at_the_obstacle(height, time), f"h = {height}, t = {time}")
            compared += 1
        n = 2 * height.denominator  # half of it is a bar pressed on a wall at rest
        schedule = [str(n * (1 + height)), str(n * (2 - 2 * height))]
        call = [PROGRAM, "find", *schedule, "--cells", str(n), "--gap", "-1e-3", "--format", "json", "--quiet"]
        found = json.loads(subprocess.run(call, stdout=subprocess.PIPE, check=True).stdout)
        near(found["energy_ratio_range"][0], 1 / height ** 2, f"h = {height}: it has the least energy of {schedule}")
    return f"string with a point obstacle: {compared} places by Cabannes' formula, to rounding"


def striker(folder):
    """A striker of impedance Z_s, speed V, meets a rod of Z_b: the rod's end moves at V r g^k in the k-th interval
    of 2 L_s/c, r = Z_s/(Z_s + Z_b), g = (Z_s - Z_b)/(Z_s + Z_b) (St. Venant; the theory of the Hopkinson bar)."""
    cells = 32
    for impedance in (3, 7, 15):  # g = 1/2, 3/4, 7/8
        ratio, step = impedance / (impedance + 1), (impedance - 1) / (impedance + 1)
        for k in range(5):
            run = Run(folder, f"{cells}:{impedance} gap=0 {8 * cells}", "--length", 9, "--velocity", "1,0",
                      "--time", 2 * k + 1)
            require(run.speeds[cells] == ratio * step ** k, f"Z = {impedance}, step {k}: {run.speeds[cells]}")
    for impedance, after in ((1, 0.0), (0.25, -0.6)):
        run = Run(folder, f"{cells}:{impedance} gap=0 {8 * cells}", "--length", 9, "--velocity", "1,0", "--time", 5)
        pulse = impedance / (impedance + 1)
        require([(c["start"], c["end"]) for c in run.contacts] == [(0, 2)], f"contacts {run.contacts}")
        near(run.contacts[0]["impulse"], 2 * pulse, "impulse")
        for speed in run.speeds[:cells]:
            near(speed, after, "the striker afterwards")
        for speed, exact in zip(run.speeds[cells:], [0] * 3 * cells + [pulse] * 2 * cells + [0] * 3 * cells):
            near(speed, exact, "the pulse")
    return "striker and rod: staircases of five steps, bit for bit"


def pile(folder):
    """A pile of impedance 1, length 1, hit by a striker; at its toe a resistance R, rigid until it is overcome, and a
    dashpot J (Smith; Goble and Rausche, CAPWAP): v = max(0, (2 Z r - R)/(Z + J)), r what arrives. The toe is a stop
    that R presses it to, so this holds until it would turn back. The Case formula (F_1 + F_2)/2 + Z (v_1 - v_2)/2,
    from the head alone, 2 L/c apart, is the force at the toe, R + J v or what holds it."""
    cells, compared = 32, 0
    for impedance, static, dashpot in ((1, 0.25, 0.5), (3, 0.5, 0.25), (3, 0.75, 1), (7, 1.0, 0.125), (1, 1.5, 0.5)):
        scene = f"{4 * cells}:{impedance} gap=0 {cells} stop=left:0 force={-static} dash={dashpot}"
        arriving, moves, states = impedance / (impedance + 1), [], {}
        for time in (0.5, 1.5, 2.5):
            run = Run(folder, scene, "--length", 5, "--velocity", "1,0", "--time", time)
            states[time] = run.waves[-cells:]
            moves.append(run.speeds[-1])
        toe = max(0.0, (2 * arriving - static) / (1 + dashpot))
        near(moves[1], toe, f"the toe moves, Z = {impedance}, R = {static}, J = {dashpot}")
        near(moves[0], 0, "the toe waits")
        # The head: what goes down at 1/2, what comes up at 5/2.
        (down, up), (later, back) = states[0.5][0], states[2.5][0]
        forces, speeds = (down - up, later - back), (down + up, later + back)
        case = sum(forces) / 2 + (speeds[0] - speeds[1]) / 2
        near(case, static + dashpot * toe if toe > 0 else 2 * arriving, "the Case formula")
        compared += 1
    return f"pile: {compared} blows, toe and Case formula to rounding"


def measured_bar(folder):
    """A Hopkinson bar in a laboratory: the test of 2006-12-01 among the examples of HopPyBar (Los Alamos National
    Laboratory, 20061201_1148HE_CuOFE_273K.raw at commit e922e62). By its header the striker has 127 mm, of the bar's
    own alloy and diameter, and waves pass 2 * 381 mm in 156.6 us. Read from its trace, 0.1 us a row: the incident
    pulse is 526 rows long at half its height."""
    speed = 2 * 0.381 / 156.6e-6
    run = Run(folder, "20 gap=0 100", "--length", 6 * 0.127, "--wave-speed", speed, "--velocity", "10,0",
              "--time", 1e-4)
    require(len(run.contacts) == 1, "the striker touches once")
    lasts = run.contacts[0]["end"] - run.contacts[0]["start"]
    near(lasts, 2 * 0.127 / speed, "2 L/c of the striker")
    near(lasts / 52.6e-6, 1, "the measured pulse", 0.01)
    return f"measured Hopkinson bar: a pulse of {1e6 * lasts:.1f} us, 52.6 measured"


def smith_toe(cells, long, impedance, static, dashpot, steps):
    """Where the toe of a pile is after each step when a striker of `long` cells has hit it, by its waves in fractions:
    a toe that never moves back."""
    pile, striker = [[[Fraction(0)] * cells for _ in "du"], [[Fraction(1, 2)] * long for _ in "du"]]
    places, apart = [Fraction(0)], Fraction(0)
    for _ in range(steps):
        (down, up), (ahead, behind) = pile, striker
        free, head = 2 * ahead[-1], 2 * up[0]
        if apart == 0 and free > head:
            free = head = (impedance * free + head) / (impedance + 1)
        apart += (head - free) / cells
        require(apart >= 0, "a striker that comes back is not foreseen")
        toe = max(Fraction(0), (2 * down[-1] - static) / (1 + dashpot))
        places.append(places[-1] + toe / cells)
        pile = [[head - up[0], *down[:-1]], [*up[1:], toe - down[-1]]]
        striker = [[behind[0], *ahead[:-1]], [*behind[1:], free - ahead[-1]]]
    return places


def pile_that_stays(folder):
    """The same with a toe that stays where a blow has left it: the stop is moved there, and the run goes on."""
    cells, stays = 16, 0
    for long, impedance, static, dashpot in ((32, 1, "1/4", "1/2"), (16, 3, "1/2", "1/4"), (16, 1, "1/8", "1")):
        static, dashpot = Fraction(static), Fraction(dashpot)
        places = smith_toe(cells, long, impedance, static, dashpot, 9 * cells)
        at, before = 0, ["--velocity", "1,0"]
        while at < len(places) - 1:
            goes = next(k for k in range(at, len(places)) if k + 1 == len(places) or places[k + 1] > places[k])
            rests = next(k for k in range(goes, len(places)) if k + 1 == len(places) or places[k + 1] == places[k])
            scene = (f"{long}:{impedance} gap=0 {cells} stop=left:{-float(places[at])!r} force={float(-static)} "
                     f"dash={float(dashpot)}")
            run = Run(folder, scene, "--length", Fraction(long + cells, cells), *before,
                      "--time", Fraction(rests - at, cells))
            run.path = [row for row in run.path if row["node"] == 4]
            for k in range(at, rests + 1):
                near(run.place((k - at) / cells), places[k], f"toe of a pile after {k} steps")
            (folder / "from.csv").write_bytes((folder / "state.csv").read_bytes())
            at, before, stays = rests, ["--from", folder / "from.csv"], stays + 1
    return f"pile: a toe that stays, {stays} times, by its waves in fractions"


def main():
    with tempfile.TemporaryDirectory() as name:
        for case in (bouncing_bar, bouncing_schedule, two_bars, driven_bar, rigid_wall, stepped_load, any_load, string,
                     striker, measured_bar, pile, pile_that_stays):
            print(case(pathlib.Path(name)), flush=True)


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    PROGRAM = sys.argv[1]
    main()
