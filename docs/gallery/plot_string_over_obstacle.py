"""
A string over a point obstacle
==============================

Cabannes plucked a string in the middle, above a point obstacle at a rational height h, and found that it
swings periodically, in closed form. Half of such a string is our bar, pressed on a wall: longitudinal and
transverse waves obey one equation. His motion is the one of least energy of its schedule.
"""

import matplotlib.pyplot as plt
import numpy as np

import signorini as sg

cells = 48
height = 1 / 3  # of the obstacle; the string is plucked by 1
schedule = (round(cells * (1 + height)), round(cells * (2 - 2 * height)))
plucked = sg.find(*schedule, cells=cells, gap=-1e-3)
print(f"E = {plucked.energy_ratio:g} E₁: Cabannes' is 1/h² = {1 / height ** 2:g}")
print(f"period {plucked.motion.period:g} L/c, his (3 - h)/2 of the whole string: {3 - height:g}")

# %%
# A string goes up where the bar goes to the left of where it is held; the wall holds it at h.

motion = plucked.motion
places = np.linspace(0.0, 1.0, cells + 1)  # of the bar
shape = -1e3 * height * motion.displacement(places, motion.t[:, None])  # instants, then places
half = np.linspace(0.0, 0.5, shape.shape[1])
figure, (strings, middle) = plt.subplots(1, 2, figsize=(9, 4), layout="constrained")
colours = plt.get_cmap("viridis")
begin = np.argmax(shape[:, -1])  # plucked
for share in np.linspace(0.0, 0.5, 6):
    k = (begin + round(share * (len(shape) - 1))) % (len(shape) - 1)
    line = np.concatenate([shape[k], shape[k, -2::-1]])
    strings.plot(np.concatenate([half, 1.0 - half[-2::-1]]), line, color=colours(1.8 * share),
                 lw=3 - 4 * share, label=f"{share * motion.period:.2f}")
strings.plot(0.5, height, "^", color="#d55e00", ms=11, zorder=3)
strings.set(xlabel="place along the string [2L]", ylabel="height [-]", title="from its plucked shape on")
strings.legend(title="after [L/c]", fontsize="small")
middle.axhline(height, color="#d55e00", lw=3)
middle.plot(motion.t, shape[:, -1], color="black")
middle.set(xlabel="t [L/c]", ylabel="height of the middle [-]", title="one period, from contact on")

# %%
# It is one motion of many: this is the set of those with his contacts. All others have more energy.

print(plucked.solution_set)
