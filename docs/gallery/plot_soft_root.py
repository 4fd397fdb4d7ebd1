"""
A soft root, and what a wall makes of its mode
==============================================

The root of the bar stands on a spring of 2 EA/L, so its first frequency is c k/(2 π L), where k tan k = 2. A force
F cos ωt on the tip, beside a dashpot of d = 0.3 EA/c, moves it by F over the size of EA u'/u + iωd; u is
cos kx + 2/k sin kx at x = L, k now ωL/c. With a wall in its way it is pressed once in each period.
"""

import csv
import json
import math
import pathlib
import subprocess
import tempfile
from typing import Any

import matplotlib.pyplot as plt
import numpy as np
from numpy.typing import NDArray

Numbers = NDArray[np.float64]
folder = pathlib.Path(tempfile.mkdtemp())
spring, dashpot, cells = 2.0, 0.3, 6


def settled(force: float, ratio: float, wall: float, periods: int = 12) -> tuple[Any, Numbers, Numbers]:
    """The answer, and the path of the tip in the last two periods of the force."""
    words = f"spring={spring} {cells} dash={dashpot} driven stop={wall}"
    call = ["signorini", "simulate", "--scene", words, "--amplitude", str(force), "--frequency", str(ratio),
            "--periods", str(periods), "--tip", str(folder / "tip.csv"), "--format", "json", "--quiet"]
    seen = json.loads(subprocess.run(call, capture_output=True, check=True, text=True).stdout)
    with (folder / "tip.csv").open() as file:
        path = np.array([(float(row["time"]), float(row["displacement"])) for row in csv.DictReader(file)
                         if row["node"] == "2"])
    times, tip = path.T
    late = times >= times[-1] * (1.0 - 2.0 / periods)
    return seen, times[late], tip[late]


low, high = 0.0, 0.5 * math.pi
for _ in range(60):
    middle = 0.5 * (low + high)
    low, high = (middle, high) if middle * math.tan(middle) < spring else (low, middle)


def linear(k: Numbers) -> Numbers:
    """|u(L)|/F."""
    u, slope = np.cos(k) + spring / k * np.sin(k), spring * np.cos(k) - k * np.sin(k)
    moved: Numbers = np.abs(u / (slope + 1j * k * dashpot * u))
    return moved


ratios = np.linspace(0.5, 1.5, 9)
weak = [settled(1e-5, ratio, 1.0) for ratio in ratios]
first = weak[0][0]["reference"]["frequency"]
print(f"ω₁ L/c = {2.0 * math.pi * first:.6f} on {cells} cells, the root is {low:.6f}")
peaks = np.array([max(abs(tip)) for _, _, tip in weak]) / 1e-5
exact = linear(2.0 * math.pi * first * ratios)
print(f"amplitudes off by {max(abs(peaks / exact - 1.0)):.1e}")

figure, (response, motion) = plt.subplots(1, 2, figsize=(9, 4), layout="constrained")
k = np.linspace(0.4, 1.7, 300)
response.plot(k, linear(k), color="black", label="formula")
response.plot(2.0 * math.pi * first * ratios, peaks, "o", color="#0072b2", mfc="none", label="simulated, no contact")
response.axvline(low, color="#999999", ls=":", label="root of k tan k = 2")
response.set(xlabel="ωL/c", ylabel="amplitude of the tip  [F L/EA]", ylim=(0, None))
response.legend(fontsize="small")
for wall, colour, name in ((1.0, "#999999", "without a wall"), (1e-3, "#d55e00", "with a wall")):
    seen, times, tip = settled(1e-3, 1.05, wall, 20)
    print(f"{name}: {seen['settled'] or seen['why']}")
    motion.plot((times - times[0]) * 1.05 * first, 1e3 * tip, color=colour, label=name)
motion.axhline(1.0, color="black", lw=2, label="wall")
motion.set(xlabel="time  [periods of the force]", ylabel="tip  [mm]", xlim=(0, 2), ylim=(-4, 3.5))
motion.legend(fontsize="small", loc="lower center", ncol=3)
