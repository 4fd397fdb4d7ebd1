"""
Pressed at rest, and between two stops
======================================

The gap may be negative: then the bar presses on the wall at rest, like a preloaded valve, and a
motion must first overcome that. And there may be a stop on the other side, too: a phase names the
stop that it touches. Both are decided as exactly as the paper's case.
"""

import matplotlib.pyplot as plt
import numpy as np

import signorini as sg

pressed = sg.find(60, 40, cells=40, gap=-1e-3)
between = sg.find((10, 50), (10, 50, "left"), cells=40, second_stop=1e-3)
print(f"pressed at rest with {1e3 * pressed.static_force:g} mN, in motion with up to", end=" ")
print(f"{1e3 * pressed.physical.peak_force:g} mN; off the wall from {pressed.energy_ratio:g} E₁ on")

figure, both = plt.subplots(2, 1, figsize=(8, 6))
for axes, found, name in zip(both, (pressed, between), ("pressed at rest", "between two stops")):
    motion = found.motion
    time = np.concatenate([motion.t, motion.t[1:] + motion.period])
    tip = np.concatenate([motion.tip, motion.tip[1:]])
    for stop in found.stops:
        axes.axhline(1e3 * stop["place"], color="#999999", lw=3)
        held = np.isclose(tip, stop["place"])
        axes.plot(time, np.where(held, 1e3 * tip, np.nan), color="#d55e00", lw=6)
    axes.plot(time, 1e3 * tip, color="black")
    axes.set(title=f"{name}: {found.schedule}", xlabel="t [s]", ylabel="tip u(L, t) [mm]")

# %%
# Grey are the stops, orange is contact. Schedules without a motion are refuted here, too:

none = sg.find((10, 20), (10, 20, "left"), cells=40, second_stop=1e-3)
print(none.status, none.reason, none.is_proof())
