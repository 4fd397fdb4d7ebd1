"""
A refutation, added up by hand
==============================

"There is no motion" comes with whole numbers, one for each row of the paper's (30)–(32). The
rows times these numbers add up to 0 = N·(something negative). Here are the rows, and the sum.
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
    p.append(x[N - 1])
    x = np.vstack([-x[N], x[: N - 1], x[N + 1 :], -p[-1] if step < contact else p[-1]])
pushing, tip = np.array(p[:contact]), np.cumsum(p[contact:], axis=0)

# %%
# The certificate in five lines: (30) is W − 1, (31) Σ(b − a) = N, (10) −p ≤ 0, (12) tip ≤ 0.

proof = found.certificate
assert isinstance(proof, sg.FarkasCertificate)
total = proof.gap * np.repeat([-1, 1], N)
for rows, pairs in ((x - unity, proof.periodicity), (-pushing, proof.pressure), (tip, proof.penetration)):
    total = total + sum(y * rows[at] for at, y in pairs)
assert all(y >= 0 for _, y in [*proof.pressure, *proof.penetration])
assert not total.any() and proof.gap * N < 0  # 0 < 0: there is no motion

axes = plt.figure(figsize=(8, 4)).subplots()
axes.locator_params(integer=True)
axes.imshow((x - unity).T, cmap="RdBu", aspect="auto")
axes.plot([row for row, _ in proof.periodicity], [20.2] * len(proof.periodicity), "^", clip_on=False)
axes.set(xlabel="row of (30); triangles: rows the proof uses", ylabel="unknown")
