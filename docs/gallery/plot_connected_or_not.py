"""
Connected or not
================

The motions of one energy are a sphere cut with a simplex. Up to half of the largest energy it
is one piece; above, one piece for each cell in which a spike can sit. Two members of one piece
can be joined by a curve of motions, two of different pieces cannot, and both is proved.
"""

import matplotlib.pyplot as plt
import numpy as np

import signorini as sg

ratios = np.concatenate([np.linspace(4.5, 300, 30), np.linspace(300.001, 599, 30)])
pieces = [sg.find(150, 900, energy_ratio=ratio).energy_section.components for ratio in ratios]

axes = plt.figure(figsize=(8, 3)).subplots()
axes.step(ratios, pieces, where="post", color="black")
axes.set(xlabel="energy E/E₁", ylabel="pieces", yscale="log", title="N = 300, (150, 900)")

# %%
# Three amplitudes can be looked at: the triangle is the simplex of N = 6, (3, 18), the curves are
# its motions of one energy.

right = plt.figure(figsize=(8, 5)).subplots()
corners = np.array([[0, 0], [1, 0], [0.5, np.sqrt(3) / 2]])
right.fill(*corners.T, color="#eeeeee")
shown = ((4.8, "#440154"), (5.6, "#3b528b"), (6.0, "#21918c"), (8.0, "#d55e00"))
for ratio, colour in shown:
    curve = sg.continuum(3, 18, cells=6, energy_ratio=ratio, sample=True, points=600)
    share = np.array([point.motion.p[:3] for point in curve])
    place = share / share.sum(1, keepdims=True) @ corners
    right.plot(*place.T, ".", ms=4, color=colour, label=f"{ratio} E₁: {curve.components}")
right.set(aspect="equal", title="pieces, N = 6, (3, 18)")
right.axis("off")
right.legend(markerscale=6, loc="upper left", title="energy: pieces")
