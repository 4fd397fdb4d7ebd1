"""
What force and damping leave behind
===================================

A force on the tip and a dashpot, both made 4 and 16 times smaller together: the curves of forced
motions with one contact, contact and release at any times, come down on the main mode of the free
bar from both sides. Its impulse is known in closed form: contact lasts 4 − T, flight 2T − 4, and the
mean place of the tip is that of the pushes.
"""

import matplotlib.pyplot as plt
import numpy as np

import signorini as sg

axes = plt.figure().subplots()
for share, colour in ((1, "#d55e00"), (4, "#e69f00"), (16, "#56b4e9")):
    forced = sg.exact_response(damping=0.02 / share, force="tip", amplitude=2e-4 / share,
                               cells=30, start=1.02, to=1.3)
    for number, branch in enumerate(forced.branches):
        one = [point for point in branch.points if point.contacts == 1]
        words = f"F = {200 / share:g} µN, ζ = {2 / share:g} %" if number == 0 else None
        axes.plot([point.frequency_ratio for point in one], [1e3 * point.impulse for point in one],
                  color=colour, lw=1.2, label=words)
period = np.linspace(4 / 1.3, 4 / 1.02, 200)
contact, flight = 4 - period, 2 * period - 4
axes.plot(4 / period, period * contact / (flight**2 / 4 - contact), "--", color="black", lw=1.0,
          label="free: the main mode")
axes.set(xlabel="frequency ω/ω₁", ylabel="impulse on the wall [mN s] per period", ylim=(0, 4))
axes.set_title("one contact in a period, g = 1 mm")
axes.legend(loc="upper left")
