#!/usr/bin/env python3
"""The time series of --motion FILE.pvd, read as ParaView's users read it: with a reader of others.

Every file that the collection names opens, time ascends to the period, the bar stands where the
CSV of the same motion says, and cells carry its velocity, strain and force.
"""

import argparse
import csv
import pathlib
import subprocess
import tempfile
import xml.etree.ElementTree

import meshio
import numpy

LENGTH, STIFFNESS, GAP = 2.0, 2e7, 1e-4
BAR = ["--length", str(LENGTH), "--wave-speed", "5000", "--axial-stiffness", str(STIFFNESS),
       "--gap", str(GAP)]


def table(path):
    """time -> x, displacement, velocity, strain of each node."""
    rows = {}
    with open(path, encoding="utf-8", newline="") as file:
        for row in csv.DictReader(file):
            rows.setdefault(float(row["time"]), []).append(
                [float(row[name]) for name in ("x", "displacement", "velocity", "strain")])
    return {time: numpy.array(values) for time, values in rows.items()}


def check_instant(path, nodes):
    mesh = meshio.read(path)
    x, u, v, s = nodes.T
    low, high = mesh.points[::2], mesh.points[1::2]
    assert numpy.allclose(low[:, 0], x + u, rtol=0, atol=1e-15)
    assert numpy.array_equal(low[:, 0], high[:, 0])
    assert numpy.allclose(high[:, 1] - low[:, 1], LENGTH / 20)
    assert numpy.array_equal(mesh.point_data["displacement"][::2, 0], u)
    (block,) = mesh.cells
    assert block.type == "quad" and len(block.data) == len(x) - 1
    assert numpy.array_equal(block.data[:, 0], numpy.arange(0, 2 * len(x) - 2, 2))
    fields = {name: values[0] for name, values in mesh.cell_data.items()}
    assert numpy.array_equal(fields["velocity"], v[1:])
    assert numpy.array_equal(fields["strain"], s[1:])
    assert numpy.allclose(fields["force"], STIFFNESS * s[1:], rtol=1e-15)


def check_series(folder, name, motion):
    collection = xml.etree.ElementTree.parse(folder / f"{name}.pvd").getroot()
    sets = collection.find("Collection").findall("DataSet")
    bars = [entry for entry in sets if entry.get("part") == "0"]
    times = [float(entry.get("timestep")) for entry in bars]
    assert times == sorted(set(times)) and times == list(motion), (times, list(motion))
    named = {entry.get("file") for entry in sets}
    assert named == {f"{name}_files/{file.name}" for file in (folder / f"{name}_files").iterdir()}
    for entry, nodes in zip(bars, motion.values()):
        check_instant(folder / entry.get("file"), nodes)
    wall = meshio.read(folder / f"{name}_files/wall.vtu")
    assert numpy.isclose(wall.points[:, 0].min(), LENGTH + GAP)
    return len(bars)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--program", required=True)
    program = pathlib.Path(parser.parse_args().program).resolve()
    calls = {"grid": ["find", "6", "36", "--cells", "12", "--energy-ratio", "8"],
             "mode": ["mode", "4", "-1", "--period", "3.14159", "--cells", "30"]}
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        for motion, call in calls.items():
            for ending in ("csv", "pvd"):
                subprocess.run([program, *call, *BAR, "--motion", f"{motion}.{ending}", "--quiet"],
                               cwd=folder, check=True, capture_output=True)
            instants = check_series(folder, motion, table(folder / f"{motion}.csv"))
            print(f"time series: {motion}: {instants} instants read")


if __name__ == "__main__":
    main()
