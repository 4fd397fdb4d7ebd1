"""One bar under gravity, which is answered as several bars are."""

from __future__ import annotations

import pickle
from typing import Any

import pytest

import signorini as sg


def test_a_bar_under_gravity_is_one_that_has_sagged() -> None:
    """By g L^2/(2 c^2): its gap is smaller, and nothing else is."""
    weight: dict[str, Any] = {"gap": 1e-3, "gravity": "0.0004m/s^2", "cells": 10}
    sagged: dict[str, Any] = {"gap": 8e-4, "cells": 10}
    free = sg.find(1, 39, **weight)
    assert free.energy == pytest.approx(sg.find(1, 39, **sagged).energy, rel=1e-9)
    for schedule in (((1, 39),), (sg.Schedule(1, 39, cells=10),), ("1:1", "-:39")):
        assert sg.find(*schedule, **weight) == free
    force: dict[str, Any] = {"damping": 0.1, "force": "tip", "amplitude": 0.01}
    one = sg.find(5, 31, **weight, **force).motions[0]
    other = sg.find(5, 31, **sagged, **force).motions[0]
    assert one.contacts[0]["impulse"] == pytest.approx(other.impulse, rel=1e-9)
    response = sg.response(start=1, to=1.2, **weight, **force)
    truth = sg.response(start=1, to=1.2, **sagged, **force)
    assert [[m.impulse for m in at.motions] for at in response.frequencies] == [
        pytest.approx([m.impulse for m in at.motions], rel=1e-9) for at in truth]
    swept = [sg.sweep(start=1, to=1.2, points=3, direction="up", **scene, **force).points[0]
             for scene in (weight, sagged)]  # of 40 steps
    assert swept[0].impulse == pytest.approx(swept[1].impulse, rel=1e-6)
    fallen = sg.simulate(time=4, **weight)
    assert fallen.to_dict()["contacts"] == sg.simulate(
        time=4, scene="clamp 10 stop=1e-3", gravity=4e-4).to_dict()["contacts"]
    for flight in (3, 5, 7):
        both: Any = sg.find((1, flight), (1, flight, "left"), cells=4, gravity=1e-6,
                            second_stop=1e-3)
        words = sg.find("1:1", f"-:{flight}", "2:1", f"-:{flight}", gravity=1e-6,
                        scene="clamp 4 stop=1e-3 stop=-1e-3")
        assert (both.status, both.energy) == (words.status, words.energy)
    families = sg.families(6, gap=1e-3, gravity="0.0004m/s^2")
    assert [f.least_energy for f in families] == pytest.approx(
        [f.least_energy for f in sg.families(6, gap=8e-4)], rel=1e-9)
    listed = sg.modes(max_order=3, gap=1e-3, gravity=4e-4)
    assert listed.gravity == 4e-4
    whole = sg.mode(4, -1, "7/2", gap=1e-3, gravity="0.0004m/s^2")
    about = sg.mode(4, -1, "7/2", gap=8e-4)
    assert (whole.gravity, about.gravity) == (4e-4, 0.0)
    assert whole.displacement(0.5, 1.0) == pytest.approx(
        about.displacement(0.5, 1.0) + 4e-4 * 0.375, rel=1e-9)
    assert whole.strain(0.5, 1.1) == pytest.approx(about.strain(0.5, 1.1) + 2e-4, rel=1e-9)
    assert listed[0].motion(3.5, 4e-4) == whole == pickle.loads(pickle.dumps(whole))
    with pytest.raises(ValueError, match="damping, force"):
        sg.find(1, 39, damping=0.1, **weight)
    velocity: dict[str, Any] = {"velocity": [1.0]}
    with pytest.raises(ValueError, match="velocity: allowed only"):
        sg.simulate(time=4, **velocity)
