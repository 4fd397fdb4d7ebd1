"""
A refutation, added up by hand
==============================

"There is no motion" comes with whole numbers, one for each row of the paper's (30)–(32). The
rows times these numbers add up to 0 = N·(something negative). Nothing has to be believed: here
are the rows, and the sum.
"""

import matplotlib.pyplot as plt
import numpy as np

import signorini as sg

N, contact, flight = 10, 5, 40
found = sg.find(contact, flight, cells=N)
print(found.status, found.reason)

unity = x = np.eye(2 * N, dtype=int)  # a₁ … a_N, b₁ … b_N in terms of the initial state
p = []  # what arrives at the tip in each step
for step in range(contact + flight):
    echo = -x[N - 1] if step < contact else x[N - 1]
    p.append(x[N - 1])
    x = np.vstack([-x[N], x[: N - 1], x[N + 1 :], echo])
pushing, tip = np.array(p[:contact]), np.cumsum(p[contact:], axis=0)

# %%
# The certificate, checked in five lines: (30) is W − 1, (31) is Σ(b − a) = N, (10) says −p ≤ 0,
# (12) says tip ≤ 0.

proof = found.certificate
total = proof.gap * np.repeat([-1, 1], N)
for rows, pairs in ((x - unity, proof.periodicity), (-pushing, proof.pressure), (tip, proof.penetration)):
    total = total + sum(y * rows[at] for at, y in pairs)
assert all(y >= 0 for _, y in [*proof.pressure, *proof.penetration])
assert not total.any() and proof.gap * N < 0  # 0 < 0: there is no motion

axes = plt.figure(figsize=(8, 4)).subplots()
axes.imshow((x - unity).T, cmap="RdBu", vmin=-2, vmax=2, aspect="auto")
used = [row for row, _ in proof.periodicity]
axes.plot(used, np.full(len(used), 20.2), "^", color="#d55e00", clip_on=False)
axes.set(xlabel="row of (30); triangles: rows the proof uses", ylabel="unknown")
axes.set(xticks=range(0, 20, 5), yticks=range(0, 20, 5))
