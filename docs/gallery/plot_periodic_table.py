"""
The periodic table of families
==============================

All motions that press the wall once per period come in families (w, ν, k): a period 2ν/w, a
contact of k blocks, every energy from the least one upwards. There are 33 of order w up to 12,
on every grid and for every bar.
"""

import matplotlib.pyplot as plt
import numpy as np

import signorini as sg

families = sg.families(12)
axes = plt.figure(figsize=(9, 8)).subplots()
least = [f.least_energy_ratio for f in families]
# Families that share order and period stand side by side.
place = [(f.order + 0.42 * (f.contact_blocks // 3), 2 * f.nu / f.order) for f in families]
look = {"s": 520, "marker": "s", "cmap": "viridis_r", "alpha": 0.6}
dots = axes.scatter(*zip(*place), c=np.log10(least), **look)
for family, cell in zip(families, place):
    words = f"{family.nu},{family.contact_blocks}"
    axes.annotate(words, cell, ha="center", va="center", fontsize=8)
axes.set(xlabel="order w", ylabel="period T [L/c]", xticks=range(3, 13), ylim=(1, 4))
axes.set_title("the families (w, ν, k), labelled ν,k")
axes.figure.colorbar(dots, label="log₁₀ of the least energy, E/E₁")

# %%
# As a table, for a bar of your own, in hertz and joules:

steel = sg.Bar(young=210e9, density=7800, area=1e-4, length=3, gap=1e-5)
print(sg.families(5, bar=steel).frame()[["order", "nu", "contact_blocks", "frequency", "least_energy"]])
