"""
A bouncing bar, a million times
===============================

Doyen, Ern and Piperno (2011) compare schemes for contact by an elastic bar that is dropped on the ground: L = 10,
E = 900, ρ = 1, g = 10, from a height of 5. It falls for 1, is on the ground for 2/3, and flies for 2; all repeats after
16/3. Numerical schemes lose energy at each bounce, or oscillate, or do not come back. Here the program ``signorini`` is
called, as weight belongs to scenes of bars in a row (:doc:`../commands`).
"""

import csv
import json
import pathlib
import subprocess
import tempfile
from typing import Any

import matplotlib.pyplot as plt
import numpy as np

folder = pathlib.Path(tempfile.mkdtemp())


def simulate(*words: object) -> Any:
    call = ["signorini", "simulate", *map(str, words), "--format", "json", "--quiet"]
    return json.loads(subprocess.run(call, capture_output=True, check=True, text=True).stdout)


bar = ("--length", 10, "--wave-speed", 30, "--axial-stiffness", 900, "--gravity", 10)
length, speed, drop, cells = 10, 30, 5, 20
seen = simulate("--scene", f"{cells} stop={drop}", *bar, "--velocity", 0, "--time", 1 + 2 * 16 / 3)
contact = seen["contacts"][0]
print(f"{contact['count']} bounces, {contact['contact_time'] / contact['count']:.15g} each")
print(f"their impulse {contact['impulse'] / contact['count']:.15g}, the weight's is {100 * 8 / 3:.15g}")

# %%
# A state has the two waves in all cells in the order in which they arrive: their sum is the velocity, their difference
# c times the strain beyond that of the bar standing on the ground.

places = np.linspace(0, length, cells + 1)  # from the top
standing = 10 * (length**2 - places**2) / (2 * speed**2)
times = np.arange(361) / 60  # steps of L/(N c)
heights = [length + drop - places]
velocities = []
for time in times[1:]:
    simulate("--scene", f"{cells} stop={drop}", *bar, "--velocity", 0, "--time", time,
             "--state", folder / "state.csv")
    rows = list(csv.DictReader((folder / "state.csv").open()))
    waves = []
    for number in ("1", "2"):
        pieces = [row for row in rows if row["wave"] == number]
        ends = np.cumsum([float(row["duration"]) for row in pieces]) * speed
        at = np.searchsorted(ends, (places[:-1] + places[1:]) / 2)
        waves.append(np.array([float(row["velocity"]) for row in pieces])[at])
    down, up = waves[0][::-1], waves[1]
    strain = (up - down) / speed
    u = standing + float(rows[0]["displacement"])
    u[1:] += np.cumsum(strain) * length / cells
    heights.append(length + drop - places - u)
    velocities.append(-(up + down))
paths = np.array(heights)

figure, axes = plt.subplots()
mesh = axes.pcolormesh(np.repeat(times[:, None], cells + 1, axis=1), paths, np.array(velocities),
                       cmap="RdBu", vmin=-15, vmax=15)
axes.plot(times, paths[:, ::4], color="black", lw=0.6)
axes.axhline(0, color="#d55e00", lw=3)
axes.set(xlabel="time", ylabel="height above the ground", ylim=(-0.3, 15.5),
         title="A bar on its way through two bounces")
figure.colorbar(mesh, label="velocity upwards")

# %%
# Shocks run through the bar and leave it as it came, with its velocity reversed: nothing is lost. In units in which all numbers
# are short in binary (L = c = EA = g = 1, from 4.5), the state after a million bounces is that before, byte by byte.

same = ("--scene", "2 stop=4.5", "--gravity", 1)
simulate(*same, "--velocity", 0, "--time", 22, "--state", folder / "before.csv")
after = simulate(*same, "--from", folder / "before.csv", "--time", 8 * 10**6, "--state", folder / "after.csv")
print(after["contacts"][0]["count"], "bounces, the same state:",
      (folder / "after.csv").read_bytes() == (folder / "before.csv").read_bytes())
