"""
Back ends compared
==================

The closed form is not the only way. The paper's rows (30)–(32) as they stand are a linear
program, and codes that know nothing of bars solve it. All answers are verified by the same
independent code.
"""

import matplotlib.pyplot as plt

import signorini as sg

print(sg.backends())
rows = []
for name, version in sg.backends().items():
    if name == "nlopt-cobyla" or not version:
        continue  # at most 40 unknowns
    form = "auto" if name == "closed-form" else "state"
    found = sg.find(15, 90, cells=30, solver=name, formulation=form, objective="any")
    rows.append((name, found.solver.seconds, found.status, found.energy_ratio))
    worst = found.residuals.worst() if found.residuals else None
    print(f"{name:14} {found.status:10} E/E₁ = {found.energy_ratio}, residual {worst}")

axes = plt.figure(figsize=(8, 4)).subplots()
colours = ["#d55e00"] + ["#0072b2"] * (len(rows) - 1)
axes.barh([row[0] for row in rows], [row[1] for row in rows], color=colours)
for place, (_, seconds, status, energy) in enumerate(rows):
    words = f" {status}, {energy:.4g} E₁" if energy else f" {status}"
    axes.annotate(words, (seconds, place), va="center", fontsize=9)
axes.set(xscale="log", xlim=(1e-7, 30), xlabel="seconds for any motion of (15, 90) on 30 cells")
axes.invert_yaxis()
