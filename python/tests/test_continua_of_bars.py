"""Curves of motions of several bars: sequences, points, files, pictures."""

from __future__ import annotations

import pickle
from pathlib import Path
from typing import Any

import pytest

import signorini as sg

BARS = "clamp 12 gap=1e-3 16 clamp"
STEPS = ("1:6", "-:40")


def sample(**options: Any) -> sg.SceneContinuum:
    return sg.continuum(*STEPS, scene=BARS, energy_ratio=8.0, points=5, sample=True, **options)


def test_a_curve_of_bars_is_a_sequence_of_motions(tmp_path: Path) -> None:
    curve = sample()
    assert curve and curve.found and len(curve) == 5 and len(curve[1:4]) == 3
    assert [point.lambda_ for point in curve] == [1, 2, 3, 4, 5]
    assert pickle.loads(pickle.dumps(curve)) == curve and sample() == curve != sample(seed=4)
    assert len(curve.frame()) == 5
    assert curve.member(2.2).to_dict() == curve[1].to_dict()
    assert repr(curve[0]).startswith("SceneContinuumPoint(lambda=1, E = 8 E_1")
    with pytest.raises(ValueError, match="allowed lambda = 1..5"):
        curve.member(7.0)
    # A point, and the file it writes, are an end of another curve.
    curve[0].write(str(tmp_path / "a.csv"))
    starts: list[Any] = [curve[0], str(tmp_path / "a.csv")]
    for start in starts:
        path = sg.continuum(*STEPS, scene=BARS, energy_ratio=8.0, points=5, start=start,
                            to=curve[3])
        assert path.connected and path.family == "path between two given motions"
    with pytest.raises(ValueError, match="from = a state of 56 waves is out of range"):
        sg.continuum("1:1", "-:4", scene="clamp 2 gap=1e-3 3 clamp", energy_ratio=9.0,
                     start=curve[0], to=curve[0])
    none = sg.continuum(*STEPS, scene=BARS, energy_ratio=2.0)
    assert none.status == "none" and not none and none.certificate is not None
    assert not len(none)


def test_a_curve_of_bars_is_drawn(tmp_path: Path) -> None:
    import matplotlib
    matplotlib.use("Agg")
    from signorini import plot
    curve = sample()
    assert list(plot.continuum(curve)) == ["force", "velocity", "displacement", "first",
                                           "middle", "last"]
    assert "contact 1" in plot.motion(curve[2])
    assert plot.scene(curve) is not None
    plot.animate(curve[1], tmp_path / "one.gif", frames=3)
    assert (tmp_path / "one.gif").stat().st_size > 0
    for shown in (curve, curve[0]):
        assert shown._repr_png_() and "<" in shown._repr_html_()  # type: ignore[attr-defined]
    with pytest.raises(ValueError, match="no points"):
        plot.continuum(sg.continuum(*STEPS, scene=BARS, energy_ratio=2.0))


def test_segments_and_gravity_are_asked_about_as_bars_are() -> None:
    """Equal segments are one bar; a bar that sags is one with a smaller gap."""
    one = sg.continuum(6, 36, cells=12, energy=4.5e-6, points=3, sample=True)
    two = sg.continuum(6, 36, segments=[(6, 1), (6, 1)], energy=4.5e-6, points=3, sample=True)
    three = sg.continuum(6, 36, cells=12, gap=1.2e-3, gravity=4e-4, energy="4.5e-6J", points=3,
                         sample=True)
    for bars in (two, three):
        assert isinstance(bars, sg.SceneContinuum) and bars.dimension == one.dimension
        assert bars[0].contacts[0]["impulse"] == pytest.approx(one[0].physical.impulse)
    with pytest.raises(ValueError, match="cells: allowed only"):
        sg.continuum(*STEPS, scene=BARS, cells=28,  # type: ignore[call-overload]
                     energy_ratio=8.0)
    with pytest.raises(ValueError, match="energy_ratio = 8 is not allowed"):
        sg.continuum("1:2", "-:14", scene="stop=1e-3 8 stop=1e-3", energy_ratio=8.0)
