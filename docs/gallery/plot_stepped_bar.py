"""
A stepped bar, by its motions of least energy
=============================================

Two segments of the same wave speed, the outer one thicker by 30 %. At the joint a wave is partly
sent back, steps are no longer shifts, and there is no closed form: the least norm among all states
that repeat decides, and stepping backwards in time proves where there is none. Which schedules of 4 + 4 cells have a motion?
"""

import matplotlib.pyplot as plt

import signorini as sg

stepped = sg.Scene(segments=[sg.Segment(4, 1.0), sg.Segment(4, 1.3)])
schedules = [(contact, free) for contact in range(1, 8) for free in range(1, 40)]
verdicts = {which: sg.find(*which, scene=stepped, cells=8, objective="any") for which in schedules}
undecided = [which for which, found in verdicts.items() if found.status == "undecided"]
assert not undecided
assert all(found.is_proof() for found in verdicts.values() if found.status == "none")

uniform = [which for which in schedules if sg.find(*which, cells=8).status == "found"]
exist = [which for which, found in verdicts.items() if found.status == "found"]
axes = plt.figure().subplots()
axes.plot(*zip(*[(free, contact) for contact, free in uniform]), "s", ms=9, mfc="none", mec="gray")
axes.plot(*zip(*[(free, contact) for contact, free in exist]), "o", color="#d55e00")
axes.set(xlabel="flight steps $n_f$", ylabel="contact steps $n_c$")
axes.set_title(f"stepped bar: {len(exist)} of {len(schedules)} (squares: uniform bar)")

# %%
# The motion of least energy of one of them is a quadratic program:

gentle = sg.find(3, 25, scene=stepped, cells=8)
print(gentle.route, gentle.energy_ratio, "E₁, residual", gentle.residuals.worst())
