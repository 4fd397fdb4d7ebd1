"""States and fields against what the wave equation says, in other code."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.typing import NDArray

import signorini as sg

from support import Program

Array = NDArray[np.float64]


def marched(state: sg.State, schedule: sg.Schedule) -> tuple[Array, Array]:
    """Tip and wall force of a march by the paper's (21)-(25): the waves move
    one cell a step; the clamp sends a = -b, the tip a = b if free, b = -a if
    held."""
    a, b = state.a.copy(), state.b.copy()
    tip, force = [float(np.sum(b - a)) / len(a)], []
    for contact, free in schedule:
        for step in range(contact + free):
            out, back = a[-1], b[0]
            held = step < contact
            a = np.append(-back, a[:-1])
            b = np.append(b[1:], -out if held else out)
            force.append(2 * out if held else 0.0)
            tip.append(float(np.sum(b - a)) / len(a))
    return np.array(tip), np.array(force)


def test_tip_and_force_are_those_of_a_march() -> None:
    for words, cells in [((150, 900), 300), ((5, 31), 10),
                         ((1, 12, 3, 12), 4)]:
        answer = sg.find(*words, cells=cells)
        tip, force = marched(answer.state, answer.schedule)
        motion = answer.motion
        np.testing.assert_allclose(motion.tip_ratio, tip, atol=1e-12)
        np.testing.assert_allclose(motion.force_ratio, force, atol=1e-12)
        bar = answer.bar
        np.testing.assert_allclose(motion.tip, tip * bar.gap, atol=1e-14)
        np.testing.assert_allclose(motion.force, force * bar.force_unit,
                                   atol=1e-14)


def test_the_field_is_that_of_the_motion_file(program: Program,
                                              tmp_path: Path) -> None:
    path = tmp_path / "motion.csv"
    program("find", 5, 31, "--cells", 10, "--energy-ratio", 9, "--length", 3,
            "--wave-speed", 7, "--motion", path)
    t, x, u, _, _, _ = np.loadtxt(path, delimiter=",", skiprows=1).T
    motion = sg.find(5, 31, cells=10, energy_ratio=9, length=3,
                     wave_speed=7).motion
    np.testing.assert_allclose(motion.displacement(x, t), u, atol=1e-17)


@settings(max_examples=60, deadline=None)
@given(st.floats(0, 1), st.floats(-20, 20), st.floats(1e-3, 1e3),
       st.floats(1e-3, 1e3))
def test_units_are_only_units(x: float, t: float, length: float,
                              speed: float) -> None:
    motion = sg.find(5, 31, cells=10, length=length, wave_speed=speed).motion
    u = motion.displacement_ratio(x, t)
    assert motion.displacement(x * length, t * length / speed) == \
        pytest.approx(u * motion.bar.gap, rel=1e-9, abs=1e-12)


@settings(max_examples=60, deadline=None)
@given(st.floats(0.01, 0.99), st.floats(0.01, 5.99))
def test_velocity_and_strain_are_derivatives(x: float, t: float) -> None:
    # Waves jump at whole cells and steps: look inside.
    cells = 10
    x = (math.floor(x * cells) + 0.5) / cells
    t = (math.floor(t * cells) + 0.25) / cells
    motion = sg.find(5, 31, cells=cells).motion
    h = 1e-4
    v = (motion.displacement_ratio(x, t + h)
         - motion.displacement_ratio(x, t - h)) / (2 * h)
    s = (motion.displacement_ratio(x + h, t)
         - motion.displacement_ratio(x - h, t)) / (2 * h)
    assert motion.velocity_ratio(x, t) == pytest.approx(v, abs=1e-8)
    assert motion.strain_ratio(x, t) == pytest.approx(s, abs=1e-8)


def test_a_motion_repeats_and_obeys_the_wall() -> None:
    answer = sg.find(150, 900, energy_ratio=20)
    motion = answer.motion
    t = np.linspace(-7, 7, 1001)
    np.testing.assert_allclose(motion.displacement(1.0, t),
                               motion.displacement(1.0, t + answer.period),
                               atol=1e-15)
    assert motion.tip.max() <= answer.bar.gap * (1 + 1e-9)
    assert motion.force.min() >= 0.0
    assert motion.force.max() == pytest.approx(answer.physical.peak_force)
    step = answer.period / motion.steps
    assert motion.force.sum() * step == \
        pytest.approx(answer.physical.impulse)
    np.testing.assert_array_equal(motion.displacement(0.0, t), 0.0)


def test_modes_and_grids_have_one_motion() -> None:
    mode = sg.mode(4, -1, "7/2")
    grid = sg.find(150, 900).motion
    x, t = np.random.default_rng(1).uniform((0, 0), (1, 3.5), (500, 2)).T
    np.testing.assert_allclose(mode.displacement(x, t),
                               grid.displacement(x, t), atol=1e-15)
    assert mode.energy_ratio == pytest.approx(4.0)


def test_arrays_of_any_shape() -> None:
    motion = sg.find(150, 900).motion
    x = np.linspace(0, 1, 5)
    t = np.linspace(0, 3.5, 7)
    u = motion.displacement(x[None, :], t[:, None])
    assert u.shape == (7, 5)
    assert u[3, 2] == motion.displacement(x[2], t[3])
    assert isinstance(motion.displacement(0.5, 1), float)
    backwards = motion.displacement(x[::-1], 1.0)
    np.testing.assert_array_equal(backwards, motion.displacement(x, 1.0)[::-1])
    np.testing.assert_array_equal(
        motion.displacement(np.float32(x), [1])[:1], u[0, :1] * 0)
    assert motion.displacement([], 0.0).shape == (0,)
    with pytest.raises(ValueError, match="x = "):
        motion.displacement(1.5, 0.0)
    with pytest.raises(ValueError, match="t = "):
        motion.displacement(0.5, np.nan)


def test_our_memory_is_not_copied() -> None:
    answer = sg.find(150, 900)
    first, again = answer.state.a, answer.state.a
    assert np.shares_memory(first, again)
    assert not first.flags.writeable and not first.flags.owndata
    motion = answer.motion
    assert np.shares_memory(motion.p, motion.p)
    kept, copied = answer.state.a, answer.state.a.copy()
    del answer, again, first
    sg.find(150, 900, energy_ratio=20)
    # The memory lives as long as an array does.
    np.testing.assert_array_equal(kept, copied)


@settings(max_examples=50, deadline=None)
@given(st.lists(st.floats(-1e6, 1e6), min_size=1, max_size=20))
def test_states_take_any_array(values: list[float]) -> None:
    doubled = np.repeat(np.array(values), 2)
    state = sg.State(doubled[::2], values)
    np.testing.assert_array_equal(state.a, values)
    np.testing.assert_array_equal(state.velocity_ratio, 2 * np.array(values))
    np.testing.assert_allclose(state.strain_ratio, 0)


@pytest.mark.parametrize("a, b", [([], []), ([1.0], [1.0, 2.0]),
                                  ([[1.0]], [[1.0]])])
def test_bad_states_are_refused(a: Any, b: Any) -> None:
    with pytest.raises(ValueError, match="allowed two of one length"):
        sg.State(a, b)


def test_a_certificate_holds_by_hand() -> None:
    """Farkas: the rows add up to 0 < 0; here with matrices made in NumPy."""
    answer = sg.find(20, 109, cells=40)
    proof = answer.certificate
    assert isinstance(proof, sg.FarkasCertificate)
    cells = 40
    contact, free = answer.schedule[0]
    unknowns = 2 * cells

    def step(waves: Array, held: bool) -> Array:
        a, b = waves[:cells], waves[cells:]
        last = -a[-1:] if held else a[-1:]
        return np.concatenate((-b[:1], a[:-1], b[1:], last))

    waves = np.eye(unknowns)
    arrive = []
    for m in range(contact + free):
        arrive.append(waves[cells - 1].copy())
        waves = step(waves, m < contact)
    rows = -np.array(arrive[:contact]), np.cumsum(arrive[contact:], axis=0)
    total = np.zeros(unknowns)
    for at, y in proof.periodicity:
        total += y * (waves - np.eye(unknowns))[at]
    total += proof.gap * np.concatenate((-np.ones(cells), np.ones(cells)))
    for block, multipliers in zip(rows, (proof.pressure, proof.penetration)):
        for at, mu in multipliers:
            assert mu >= 0
            total += mu * block[at]
    assert not total.any() and proof.gap * cells < 0
    assert answer.is_proof()
