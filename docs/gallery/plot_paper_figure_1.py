"""
The paper's Figure 1: frequency and energy
==========================================

Curves are *modes*, one motion for every period. On the rational points of these curves stand
*families*: a half-line of energies for each, of which a grid of 300 cells has those whose order
divides 600. The circle is the paper's own motion.
"""

import matplotlib.pyplot as plt
import numpy as np

import signorini as sg

axes = plt.figure().subplots()
for family in sg.families(60):
    if 600 % family.order == 0:
        where, least = family.frequency_ratio, family.least_energy_ratio
        axes.vlines(where, least, 50, color="#56b4e9", lw=3 / family.order**0.6)
for mode in sg.modes():
    low, high = (p / q for p, q in mode.period_range)
    period = np.linspace(low, high, 402)[1:-1]
    axes.plot(4 / period, 1 / (mode.kappa * period - mode.mu) ** 2, color="black", lw=1.2)
axes.plot(8 / 7, 20, "o", color="#d55e00", label="(8/7, 20): the paper's motion")
axes.set(xlabel="frequency ω/ω₁", ylabel="energy E/E₁", yscale="log")
axes.set(xlim=(0.99, 1.6), ylim=(0.9, 50))
axes.legend(loc="lower right")

# %%
# In words: how many families stand where the circle is?

there = [f for f in sg.families(60, max_energy_ratio=20) if np.isclose(f.frequency_ratio, 8 / 7)]
print(there)
