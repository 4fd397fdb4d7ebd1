"""Figures show what they are asked to show."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from matplotlib import pyplot

import signorini as sg
from signorini import plot
from support import ROOT


def drawn(axes: Any, folder: Path) -> None:
    """A figure that can be saved has no bad text in it."""
    axes.figure.savefig(folder / "figure.png", dpi=50)


def test_a_motion(tmp_path: Path) -> None:
    answer = sg.find(150, 900)
    axes = plot.motion(answer)
    tip, times = axes["tip"].get_lines()[0].get_data()
    np.testing.assert_allclose(
        tip, 1e3 * answer.motion.displacement(1.0, times), atol=1e-6)
    assert axes["tip"].get_xlabel() == "tip  u(L, t)  [mm]"
    assert axes["force"].get_xlabel() == "wall force  [mN]"
    drawn(axes["tip"], tmp_path)
    with pytest.raises(ValueError, match="nothing to draw"):
        plot.motion(sg.find(20, 109, cells=40))


def test_a_continuum(tmp_path: Path) -> None:
    curve = sg.continuum(150, 900, energy_ratio=20, points=21)
    axes = plot.continuum(curve)
    assert set(axes) == {"force", "strain", "velocity", "first", "middle",
                         "last"}
    drawn(axes["force"], tmp_path)


def test_the_plane_with_data_over_it(tmp_path: Path) -> None:
    data = [(8 / 7, 20.0), (1.1, 9.0)]
    axes = plot.frequency_energy(data=data, data_label="measured")
    over = [line for line in axes.get_lines()
            if line.get_label() == "measured"]
    np.testing.assert_allclose(over[0].get_xydata(), data)
    drawn(axes, tmp_path)


def test_atlas_figures(tmp_path: Path) -> None:
    atlas = sg.Atlas.build(tmp_path / "a.sqlite", cells=12)
    drawn(plot.frequency_energy(atlas), tmp_path)
    axes = plot.existence_map(atlas)
    assert axes.get_xlabel() == "flight time  t$_{\\mathrm{f}}$  [L/c]"
    drawn(axes, tmp_path)


def test_families_have_a_cell_each(tmp_path: Path) -> None:
    axes = plot.families()
    boxes = [made for made in axes.collections
             if made.get_array() is not None]
    assert [len(made.get_paths()) for made in boxes] == [33]
    drawn(axes, tmp_path)


def test_forced_motions_and_scenes(tmp_path: Path) -> None:
    """Their tips go as low as the answers say."""
    options: dict[str, Any] = {"damping": 0.02, "force": "tip", "amplitude": 2e-4}
    found: list[tuple[Any, str]] = [
        (sg.find(frequency=1.02, **options), "y"),
        (sg.find(10, 60, cells=20, **options), "x")]
    for answer, side in found:
        axes = plot.motion(answer)["tip"]
        label = getattr(axes, f"get_{side}label")()
        unit = {"mm": 1e-3, "µm": 1e-6, "m": 1.0}[label[label.index("[") + 1:-1]]
        lowest = min(min(getattr(line, f"get_{side}data")())
                     for line in axes.get_lines())
        assert unit * lowest == pytest.approx(
            answer.motions[-1].physical.tip_lowest, rel=0.01)
        drawn(axes, tmp_path)
    _, three = pyplot.subplots(3)
    assert plot.motion(found[0][0], axes=three)["tip"] is three[1] and three[1].lines
    assert len(plot.animate(found[0][0], frames=3).axes) == 2
    with pytest.raises(ValueError, match="nothing to draw"):
        plot.motion(sg.find(20, 109, cells=40, **options))
    drawn(plot.scene(sg.Scene(sg.Bar(), 1e-3, [sg.Segment(4), sg.Segment(6, 1.3)])),
          tmp_path)


def test_polytopes(tmp_path: Path) -> None:
    """Motions with several contacts, as the program draws them; in a notebook by themselves."""
    rows = sg.modes(phases=2, max_order=3, max_period=8)
    contact, energy = plot.polytopes(rows)
    drawn(contact, tmp_path)
    assert "first contact" in contact.get_ylabel() and "energy" in energy.get_ylabel()
    assert contact.get_xlim()[1] > max(p / q for row in rows for p, q in row.period_range)
    assert rows._repr_png_().startswith(b"\x89PNG")
    with pytest.raises(ValueError, match="no motion to draw"):
        plot.polytopes([])
    with pytest.raises(ValueError, match="gap > 0"):
        plot.polytopes(sg.modes(phases=2, max_order=3, max_period=8, gap=-1e-3))


def test_response_and_simulation(tmp_path: Path) -> None:
    options: dict[str, Any] = {"damping": 0.02, "force": "tip",
                               "amplitude": 2e-4, "cells": 10}
    upper, lower = plot.response(sg.response(start=0.8, to=1.4, **options))
    drawn(upper, tmp_path)
    assert "m" in lower.get_ylabel()
    asked: dict[str, Any] = {**options, "start": 1.1, "to": 1.2, "cells": 4}
    exact = sg.exact_response(**asked)
    _, two = pyplot.subplots(2)
    upper, lower = plot.response(exact, axes=two)
    assert upper is two[0] and lower is two[1]
    assert "N s" in lower.get_ylabel() and len(upper.lines) >= len(exact.branches) > 0
    drawn(upper, tmp_path)
    bars = sg.exact_response(scene="clamp 3 dash=0.1 driven gap=1e-3 4 dash=0.2 2 clamp",
                             force="tip", amplitude=2e-3, start=1.0, to=1.5)
    upper, lower = plot.response(bars)
    drawn(upper, tmp_path)
    assert "Hz" in lower.get_xlabel() and bars.found
    run = sg.simulate(frequency=1.1, periods=30, **options)
    drawn(plot.simulation(run)[0], tmp_path)
    upper, lower = plot.sweep(sg.sweep("frequency", 0.9, 1.2, points=4,
                                       **options))
    drawn(upper, tmp_path)
    assert "Hz" in lower.get_xlabel()
    assert [line.get_label() for line in upper.lines
            if line.get_label()[0] != "_"] == ["upward", "downward"]
    table = sg.study(gap=[5e-4, 1e-3], damping=0.05, amplitude=[1e-5, 3e-4],
                     force="tip", start=0.9, to=1.2, points=3, cells=10)
    drawn(plot.study(table), tmp_path)
    with pytest.raises(ValueError, match="gap|damping|amplitude"):
        plot.study(table, x="speed")
    with pytest.raises(ValueError, match="tip=True"):
        plot.simulation(sg.simulate(frequency=1.1, periods=3, tip=False,
                                    **options))


def test_axes_of_ones_own_are_used() -> None:
    from matplotlib import pyplot
    _, axes = pyplot.subplots()
    assert plot.families(axes=axes) is axes


def test_moving_pictures(tmp_path: Path) -> None:
    moving = plot.animate(sg.find(15, 90, cells=30), tmp_path / "a.gif",
                          frames=4)
    assert (tmp_path / "a.gif").read_bytes()[:4] == b"GIF8"
    assert "<" in moving._repr_html_()
    with pytest.raises(ValueError, match="gif or .mp4"):
        moving.save(tmp_path / "a.avi")


def test_units_have_prefixes() -> None:
    assert plot.unit_for(0.002, "m") == (1000.0, "mm")
    assert plot.unit_for(0.0, "m") == (1.0, "m")
    factor, unit = plot.unit_for(5e4, "Hz")
    assert factor == pytest.approx(1e-3) and unit == "kHz"


def test_colours_are_those_of_the_library() -> None:
    header = ROOT / "src" / "draw" / "palette.hpp"
    text = header.read_text()
    for name in ("ink", "strain", "velocity", "contact", "faint", "grid"):
        assert f'{name} = "{plot.colours[name]}"' in text


def many() -> list[tuple[Any, Any, list[str]]]:
    """Each function of several axes, what it draws, and their names."""
    options: dict[str, Any] = {"damping": 0.02, "force": "tip",
                               "amplitude": 2e-4, "cells": 10}
    found = sg.find(15, 90, cells=30)
    curve = sg.continuum(6, 36, cells=12, energy_ratio=8, points=5)
    return [
        (plot.motion, found, ["strain", "velocity", "displacement", "tip",
                              "force", "words"]),
        (plot.continuum, curve, ["force", "strain", "velocity", "first",
                                 "middle", "last"]),
        (plot.response, sg.response(start=1.0, to=1.2, **options),
         ["impulse", "tip"]),
        (plot.simulation, sg.simulate(frequency=1.1, periods=9, **options),
         ["tip", "impulse"]),
        (plot.sweep, sg.sweep("frequency", 0.9, 1.2, points=3, **options),
         ["impulse", "tip"]),
        (lambda moving, **where: plot.animate(moving, frames=2, **where).axes,
         found, ["bar", "displacement"])]


def label_of(axes: Any) -> tuple[str, str]:
    """What stands at the axes."""
    return axes.get_xlabel(), axes.get_ylabel()


@pytest.mark.filterwarnings("ignore:Animation was deleted")
def test_several_axes_of_ones_own(tmp_path: Path) -> None:
    from matplotlib import pyplot
    for function, data, names in many():
        made = function(data)
        listed = list(made.values()) if isinstance(made, dict) else made
        labels = list(map(label_of, listed))
        figure, own = pyplot.subplots(len(names) // 2, 2, figsize=(9, 9))
        flat = list(own.flat)
        before = pyplot.get_fignums()
        given: Any
        for given in (own, flat, dict(zip(names, flat))):
            for axes in flat:
                axes.clear()
            used = function(data, axes=given)
            assert list(used.values() if isinstance(used, dict)
                        else used) == flat
            assert list(map(label_of, flat)) == labels
        assert pyplot.get_fignums() == before
        drawn(flat[0], tmp_path)
        for wrong in (flat[:-1], flat[0], {"one": flat[0]}, []):
            with pytest.raises(ValueError, match=f"allowed {len(names)} of"):
                function(data, axes=wrong)
        with pytest.raises(ValueError, match="axes clashes with figure"):
            function(data, axes=flat, figure=figure)
        left, right = pyplot.figure(figsize=(12, 6)).subfigures(1, 2)
        used = function(data, figure=right)
        inside = list(used.values() if isinstance(used, dict) else used)
        assert all(axes in right.axes for axes in inside) and not left.axes
        pyplot.close("all")


def test_profiles_of_a_motion_need_not_share_axes() -> None:
    from matplotlib import pyplot
    answer = sg.find(15, 90, cells=30, length=2.0)
    own = pyplot.subplots(2, 3)[1]
    axes = plot.motion(answer, axes=own)
    for name in ("strain", "velocity", "displacement"):
        assert axes[name].get_xlim() == (0, 2)
    for name in ("displacement", "tip", "force"):
        assert axes[name].get_ylim() == pytest.approx((0, 3.5 * 2))


def test_one_axes_in_a_figure_of_ones_own(tmp_path: Path) -> None:
    from matplotlib import pyplot
    atlas = sg.Atlas.build(tmp_path / "a.sqlite", cells=8)
    left, right = pyplot.figure().subfigures(1, 2)
    draw: list[Any] = [plot.families, plot.frequency_energy,
                       lambda **where: plot.existence_map(atlas, **where)]
    for function in draw:
        assert function(figure=right) in right.axes and not left.axes
        with pytest.raises(ValueError, match="axes clashes with figure"):
            function(figure=right, axes=right.axes[0])


def test_each_of_several_forced_motions_is_drawn() -> None:
    answer = sg.find(period="13/4", damping=0.02, force="tip", amplitude=2e-4)
    assert len(answer.motions) == 2
    last = max(plot.motion(answer)["force"].lines[0].get_ydata())
    for k in (-2, -1, 0, 1):
        force = plot.motion(answer, index=k)["force"].lines[0].get_ydata()
        assert (max(force) == last) == (k in (-1, 1))
    with pytest.raises(ValueError, match="index = 2"):
        plot.motion(answer, index=2)
