"""
An atlas, asked in SQL
======================

1.44 million schedules of N = 300 are decided in a moment, and those with motions are in
an SQLite database that every language can read.
"""

import sqlite3
import tempfile
from pathlib import Path

import matplotlib.pyplot as plt

import signorini as sg

path = Path(tempfile.mkdtemp()) / "atlas.sqlite"
sg.Atlas.build(path, cells=300, max_free=2400)
database = sqlite3.connect(path)
count = "SELECT contact, count(*), sum(schedules) FROM families GROUP BY contact"
for contact, families, schedules in database.execute(count):
    print(f"{contact}: {families} sets of orbits, in {schedules} schedules")

# %%
# Which schedules have motions? Contact and flight of every one, coloured by the dimension of its
# set.

pressing = "SELECT phases, dimension FROM schedules WHERE contact = 'pressing'"
rows = database.execute(pressing).fetchall()
steps, colour = zip(*[(map(int, phases.split(":")), size) for phases, size in rows])
axes = plt.figure(figsize=(8, 6)).subplots()
dots = axes.scatter(*zip(*steps), c=colour, s=2, cmap="viridis_r")
axes.set(xlabel="contact steps $n_c$", ylabel="flight steps $n_f$", title="each tent: a family")
axes.figure.colorbar(dots, label="dimension of the set of motions")

# %%
# The paper's point, 8/7 ω₁ and 20 E₁, is one family:

print(sg.Atlas(path).near(8 / 7, 20))
