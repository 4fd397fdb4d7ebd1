"""Python says what the program says, bit for bit."""

from __future__ import annotations

import pickle
import random
from fractions import Fraction
from pathlib import Path
from typing import Any

import pytest

import signorini as sg

from support import Program, alike, words_of

FAMILIES = list(sg.families(9))


def question(dice: random.Random) -> tuple[list[int], dict[str, Any]]:
    """A schedule on a small grid and what is asked of it."""
    cells = dice.choice([1, 2, 3, 4, 6, 8, 12, 20, 30])
    steps = [dice.randint(1, 2 * cells), dice.randint(1, 5 * cells)]
    if dice.random() < 0.6:  # near the middle of a tent there are motions
        family = dice.choice(FAMILIES)
        cells = family.order * dice.randint(1, 6)
        (contact, free), = family.schedule(cells)
        off = dice.randint(-2, 2)
        if contact + off > 0:
            steps = [contact + off, free - off]
    options: dict[str, Any] = {"cells": cells}
    if dice.random() < 0.15 and cells <= 6:
        steps += [dice.randint(1, cells), dice.randint(1, 4 * cells)]
    if dice.random() < 0.3:
        options["energy_ratio"] = dice.choice([1, 2.5, 4, 9, 12.3, 20])
    elif dice.random() < 0.3:
        options["objective"] = dice.choice(["any", "max-energy",
                                            "min-peak-strain"])
    if dice.random() < 0.3:
        options.update(length=dice.uniform(0.1, 9.0),
                       gap=10 ** dice.uniform(-7, -2), young=210e9,
                       density=7800.0, area=1e-4)
    if dice.random() < 0.05:
        options["stability"] = True
    return steps, options


def test_a_thousand_random_requests_agree_bit_for_bit(
        program: Program) -> None:
    dice = random.Random(16)
    seen = {"found": 0, "none": 0, "undecided": 0}
    for _ in range(1000):
        steps, options = question(dice)
        said = program("find", *steps, *words_of(options))
        answer = sg.find(*steps, **options)
        alike(said, answer.to_dict(), f"{steps} {options}")
        seen[answer.status] += 1
    assert min(seen["found"], seen["none"]) > 100


def test_questions_in_physics_agree(program: Program) -> None:
    steel = {"young": 210e9, "density": 7800, "area": 1e-4, "length": 3,
             "gap": 1e-5}
    questions: list[tuple[list[object], dict[str, Any]]] = [
        (["--frequency", "8/7", "--energy-ratio", 20],
         {"frequency": "8/7", "energy_ratio": 20}),
        (["--period", "7/2", "--cells", 8], {"period": "7/2", "cells": 8}),
        (["--period", "7/2", "--cells", 8, "--stability"],
         {"period": "7/2", "cells": 8, "stability": True}),
        (["--period", "4"], {"period": 4}),
        (["--period", "5"], {"period": 5}),
        (["--hertz", 494, "--energy", 7e-3, *words_of(steel)],
         {"hertz": 494, "energy": 7e-3, **steel}),
    ]
    for words, options in questions:
        said = program("find", *words)
        ours = sg.find(**options).to_dict()
        del said["question"]["asked"], ours["question"]["asked"]
        alike(said, ours, str(options))
    with pytest.raises(ValueError, match="nearest 27/8.*cells=7 or"):
        sg.find(period=Fraction(24, 7), cells=8)


def test_states_agree_bit_for_bit(program: Program, tmp_path: Path) -> None:
    path = tmp_path / "state.csv"
    program("find", 150, 900, "--energy-ratio", 20, "--gap", 2e-5,
            "--state", path)
    answer = sg.find(150, 900, energy_ratio=20, gap=2e-5)
    ours = tmp_path / "ours.csv"
    answer.state.write(str(ours))
    assert ours.read_text() == path.read_text()


def test_lists_agree(program: Program) -> None:
    alike(program("families"), sg.families().to_dict())
    alike(program("families", "--max-order", 40, "--max-energy-ratio", 9,
                  "--length", 3),
          sg.families(40, max_energy_ratio=9, length=3).to_dict())
    alike(program("modes"), sg.modes().to_dict())
    alike(program("modes", "--phases", 2), sg.modes(phases=2).to_dict())
    alike(program("modes", "--phases", 3, "--max-order", 5, "--gap", 0.1),
          sg.modes(phases=3, max_order=5, gap=0.1).to_dict())
    for phases in (1, 2, 3, 4, 5):
        bounds = ("--max-energy-ratio", 1e-9)
        said = program("modes", "--phases", phases, *bounds)
        alike(said, sg.modes(phases=phases,  # type: ignore[call-overload]
                             max_energy_ratio=1e-9).to_dict())
    said = program("mode", 4, -1, "--period", "22/7")
    ours = sg.mode(4, -1, "22/7").to_dict()
    alike(said, ours)


def test_continua_agree(program: Program) -> None:
    alike(program("continuum", 150, 900, "--energy-ratio", 20, "--points", 9),
          sg.continuum(150, 900, energy_ratio=20, points=9).to_dict())
    alike(program("continuum", 6, 36, "--cells", 12, "--energy-ratio", 8,
                  "--seed", 3, "--points", 5),
          sg.continuum(6, 36, cells=12, energy_ratio=8, seed=3,
                       points=5).to_dict())
    member = program("continuum", 150, 900, "--energy-ratio", 20, "--member",
                     0.25, "--state", "/dev/null")["member"]
    curve = sg.continuum(150, 900, energy_ratio=20)
    alike(member, curve.member(0.25).to_dict())
    bars = "clamp 12 gap=1e-3 16 clamp"
    more: list[dict[str, Any]] = [{"points": 5}, {"sample": True, "points": 4, "seed": 9},
                                  {"sample": True, "points": 3, "strain_limit": 7e-3}]
    for given in more:
        options: dict[str, Any] = {"energy_ratio": 20.0, **given}
        words = [word for name, value in options.items() for word in (
            "--" + name.replace("_", "-"), *([] if value is True else [value]))]
        alike(program("continuum", "1:6", "-:40", "--scene", bars, *words),
              sg.continuum("1:6", "-:40", scene=bars, **options).to_dict())
        alike(program("continuum", 6, 36, "--segments", "6:1,6:1", *words),
              sg.continuum(6, 36, segments=[(6, 1), (6, 1)], **options).to_dict())


@pytest.mark.parametrize("name, value", [
    ("amplitude", 4e-4), ("amplitude_velocity", 6e-4),
    ("amplitude_acceleration", 1e-3)])
def test_amplitudes_of_a_base_agree(program: Program, name: str, value: float) -> None:
    option = "--" + name.replace("_", "-")
    drive: dict[str, Any] = {"damping": 0.05, "force": "base", name: value}
    words = ["--damping", 0.05, "--force", "base", option, value]
    alike(program("response", *words, "--cells", 12),
          sg.response(cells=12, **drive).to_dict())
    alike(program("sweep", *words, "--cells", 12, "--from", 0.9, "--to", 1.1,
                  "--points", 3),
          sg.sweep("frequency", 0.9, 1.1, points=3, cells=12, **drive).to_dict())
    alike(program("simulate", *words, "--rest", "--cells", 12, "--frequency", 1.1,
                  "--periods", 20),
          sg.simulate(cells=12, frequency=1.1, periods=20, **drive).to_dict())
    alike(program("find", 6, 30, *words, "--cells", 12),
          sg.find(6, 30, cells=12, **drive).to_dict())
    alike(program("find", "--frequency", "8/7", *words),
          sg.find(frequency="8/7", **drive).to_dict())
    alike(program("find", "--frequency", "8/7", "--strain-limit", 1e-5, *words),
          sg.find(frequency="8/7", strain_limit=1e-5, **drive).to_dict())
    with pytest.raises(ValueError, match="clash|only"):
        sg.response(cells=12, damping=0.05, force="tip", amplitude_velocity=1.0)
    with pytest.raises(ValueError, match="allowed one amplitude"):
        sg.response(cells=12, amplitude_velocity=1.0, amplitude_acceleration=1.0,
                    damping=0.05, force="base")


@pytest.mark.parametrize("asked, cycles, drive", [
    ({"period": "7/2"}, 1, {"force": "tip", "amplitude": 3e-4}),
    ({"period": 3.7}, 2, {"force": "tip", "amplitude": 2e-4}),
    ({"frequency": "10/9"}, 1, {"force": "base", "amplitude": 4e-4}),
    ({"hertz": 0.27}, 1, {"force": "tip", "amplitude": 2e-4}),
    ({"period": "7/2"}, 1, {"force": "tip", "amplitude": 1e-7})])
def test_motions_off_the_grid_agree(program: Program, asked: dict[str, Any], cycles: int,
                                    drive: dict[str, Any]) -> None:
    words = [word for name, value in {**asked, **drive, "cycles": cycles}.items()
             for word in (f"--{name}", value)]
    ours = sg.find(damping=0.05, cycles=cycles, **asked, **drive)
    alike(program("find", *words, "--damping", 0.05), ours.to_dict())
    assert bool(ours) == ours.found == (len(ours.motions) > 0)
    assert len(ours.frame()) == len(ours.motions)
    again = pickle.loads(pickle.dumps(ours))
    assert again == ours


def test_forced_motions_of_segments_agree(program: Program) -> None:
    drive: dict[str, Any] = {"damping": 0.05, "force": "tip"}
    alike(program("find", 6, 28, "--segments", "4:1,4:1.3", "--damping", 0.05,
                  "--force", "tip"),
          sg.find(6, 28, segments=[(4, 1.0), (4, 1.3)], **drive).to_dict())
    for name, value in (("period", "7/2"), ("frequency", 1.1), ("hertz", 0.3)):
        asked: dict[str, Any] = {name: value, "amplitude": 2e-3, **drive}
        alike(program("find", "--segments", "4:1,4:1.3", *words_of(asked)),
              sg.find(segments=[(4, 1.0), (4, 1.3)], **asked).to_dict())


def test_forced_motions_agree(program: Program) -> None:
    words = ["--damping", 0.02, "--force", "tip", "--amplitude", 2e-4,
             "--cells", 20]
    options: dict[str, Any] = {"damping": 0.02, "force": "tip",
                               "amplitude": 2e-4, "cells": 20}
    said = program("response", *words, "--from", 0.9, "--to", 1.3)
    ours = sg.response(start=0.9, to=1.3, **options)
    alike(said, ours.to_dict())
    assert sg.response(start=0.9, to=1.3, threads=3, **options) == ours
    for steps in ((10, 60), (3, 2)):
        alike(program("find", *steps, *words, "--stability"),
              sg.find(*steps, stability=True, **options).to_dict())


def test_sweeps_agree(program: Program) -> None:
    words = ["--damping", 0.02, "--force", "tip", "--amplitude", 2e-4,
             "--cells", 12, "--points", 4, "--periods", 200]
    options: dict[str, Any] = {"damping": 0.02, "force": "tip",
                               "amplitude": 2e-4, "cells": 12, "points": 4,
                               "periods": 200}
    ours = sg.sweep("frequency", 0.9, 1.2, **options)
    alike(program("sweep", *words, "--from", 0.9, "--to", 1.2),
          ours.to_dict())
    assert sg.sweep("frequency", 0.9, 1.2, threads=2, **options) == ours
    del options["amplitude"]
    words = [word for word in words if word not in ("--amplitude", 2e-4)]
    alike(program("sweep", *words, "--over", "amplitude", "--frequency", 1.1,
                  "--from", 1e-4, "--to", 3e-4, "--up", "--rest"),
          sg.sweep("amplitude", 1e-4, 3e-4, frequency=1.1, direction="up",
                   rest=True, **options).to_dict())


def test_simulations_agree(program: Program) -> None:
    said = program("simulate", "--rest", "--damping", 0.02, "--force", "tip",
                   "--amplitude", 2e-4, "--frequency", 1.1, "--periods", 60,
                   "--cells", 20)
    run = sg.simulate(damping=0.02, force="tip", amplitude=2e-4,
                      frequency=1.1, periods=60, cells=20)
    alike(said, run.to_dict())


def test_atlases_agree(program: Program, tmp_path: Path) -> None:
    path = tmp_path / "atlas.sqlite"
    atlas = sg.Atlas.build(path, cells=12)
    said = program("atlas", "--database", path, "--near", "8/7", 20,
                   "--within", 0.1)
    ours = atlas.near("8/7", 20, within=0.1)
    alike(said["families"], [row.to_dict() for row in ours])
    assert any(row.connected_at_energy for row in ours)
    assert "dimension_at_energy" not in atlas.families()[0].to_dict()
    run = atlas.runs[0].to_dict()
    alike(said["ranges"], [{key: run[key] for key in said["ranges"][0]}])
    said = program("atlas", "--database", path, "--cells", 12)
    alike({key: said[key] for key in run if key not in ("finished", "seconds")},
          {key: run[key] for key in run if key not in ("finished", "seconds")})
    assert run["finished"] and atlas.runs[0].max_energy_ratio is None
    said = program("atlas", "--database", path, "--period", "7/2",
                   "--schedules")
    alike(said["schedules"],
          [row.to_dict() for row in atlas.schedules_of_period("7/2")])


def test_versions_and_backends_are_those_of_the_program() -> None:
    assert sg.backends()["closed-form"] == sg.__version__


@pytest.mark.parametrize("words, options", [
    ((0, 900), {}), ((150, 900), {"cells": 0}), ((150,), {}), ((), {}),
    ((150, 900), {"energy_ratio": -1}), ((150, 900), {"solver": "abacus"}),
    ((150, 900), {"objective": "best"}), ((150, 900), {"gap": float("nan")}),
    ((150, 900), {"density": 1.0}), ((10 ** 30, 5), {}),
    ((150, 900), {"tolerance": -1.0}), ((150, 900), {"amplitude": 1.0}),
    ((150, 900), {"force": "tip"}),
    ((150, 900), {"force": "wind", "damping": 0.1}),
])
def test_wrong_use_is_a_value_error(words: tuple[int, ...],
                                    options: dict[str, Any]) -> None:
    with pytest.raises(ValueError, match="allowed"):
        sg.find(*words, **options)


def test_wrong_types_are_type_errors() -> None:
    with pytest.raises(TypeError):
        sg.find(150.5, 900)  # type: ignore[call-overload]
    with pytest.raises(TypeError):
        sg.find(150, 900, gapp=1.0)  # type: ignore[call-overload]


def test_responses_to_an_exact_harmonic_agree(program: Program) -> None:
    """Their curves, too; kept and drawn as other responses."""
    drive: dict[str, Any] = {"damping": 0.05, "force": "tip", "amplitude": 3e-4}
    said = program("response", "--exact", "--cells", 4, "--from", 1.1, "--to", 1.2,
                   *words_of(drive))
    ours = sg.exact_response(cells=4, start=1.1, to=1.2, **drive)
    alike(said, ours.to_dict())
    assert ours.found and ours.branches and len(ours.frame()) == len(ours.frequencies)
    assert pickle.loads(pickle.dumps(ours)) == ours


def test_responses_of_bars_to_a_harmonic_in_steps_agree(program: Program) -> None:
    """Stability, too; of bars that nothing holds."""
    bars = "clamp 6 dash=0.1 driven gap=1e-3 8 dash=0.2 2 clamp"
    said = program("response", "--scene", bars, "--from", "0.5Hz", "--to", "0.7Hz",
                   "--force", "tip", "--amplitude", 2e-3, "--stability")
    ours = sg.response(scene=bars, force="tip", amplitude=2e-3, start="0.5 Hz", to="0.7 Hz",
                       threads=2, stability=True)
    alike(said, ours.to_dict())
    motions = [motion for at in ours.frequencies for motion in at.motions]
    assert motions and all(motion.release == "step" for motion in motions)
    assert pickle.loads(pickle.dumps(ours)) == ours
    flying = "stop=1e-3 4 dash=0.1 driven stop=1e-3"
    said = program("response", "--scene", flying, "--from", "0.5Hz", "--to", "0.7Hz",
                   "--force", "tip", "--amplitude", 2e-3)
    alike(said, sg.response(scene=flying, force="tip", amplitude=2e-3, start="0.5Hz",
                            to="0.7Hz").to_dict())
    with pytest.raises(ValueError, match="dash"):
        sg.response(scene=bars, damping=0.1, force="tip",  # type: ignore[call-overload]
                    amplitude=2e-3)
    with pytest.raises(ValueError, match="damping"):
        sg.response(cells=4, force="tip", amplitude=2e-3)  # type: ignore[call-overload]


def test_responses_of_bars_to_an_exact_harmonic_agree(program: Program) -> None:
    """Of several bars, and of a bar of several segments."""
    bars = "clamp 6 dash=0.1 driven gap=1e-3 8 dash=0.2 2 clamp"
    said = program("response", "--exact", "--scene", bars, "--from", "0.4Hz", "--to", "0.7Hz",
                   "--force", "tip", "--amplitude", 2e-3)
    ours = sg.exact_response(scene=bars, force="tip", amplitude=2e-3, start="0.4 Hz", to="0.7 Hz",
                             threads=2)
    alike(said, ours.to_dict())
    assert ours.found and any(at.motions for at in ours.frequencies)
    assert len(ours.frame()) == len(ours.frequencies)
    assert pickle.loads(pickle.dumps(ours)) == ours
    two = "clamp 8 dash=0.2 driven stop=1e-3"
    said = program("response", "--exact", "--contacts", 2, "--scene", two, "--from", 0.9, "--to",
                   1.1, "--force", "tip", "--amplitude", 4e-3)
    alike(said, sg.exact_response(scene=two, force="tip", amplitude=4e-3, start=0.9, to=1.1,
                                  contacts=2).to_dict())
    with pytest.raises(ValueError, match="contacts: allowed 1"):
        sg.exact_response(damping=0.1, force="tip", amplitude=4e-3, contacts=2)
    drive: dict[str, Any] = {"damping": 0.05, "force": "base", "amplitude_acceleration": 3e-3}
    said = program("response", "--exact", "--segments", "6:1,6:1.3", "--from", 1.1, "--to", 1.4,
                   *words_of(drive))
    segments = [sg.Segment(6), sg.Segment(6, 1.3)]
    alike(said, sg.exact_response(segments=segments, start=1.1, to=1.4, **drive).to_dict())
    with pytest.raises(ValueError, match="dash"):
        sg.exact_response(scene=bars, damping=0.1, force="tip",  # type: ignore[call-overload]
                          amplitude=2e-3)
    ball = "4 dash=0.1 driven stop=1e-3"  # bounces under its weight
    said = program("response", "--exact", "--scene", ball, "--gravity", 9e-4, "--from", "0.4Hz",
                   "--to", "0.7Hz", "--force", "tip", "--amplitude", 2e-4)
    ours = sg.exact_response(scene=ball, gravity=9e-4, force="tip", amplitude=2e-4, start="0.4 Hz",
                             to="0.7 Hz")
    alike(said, ours.to_dict())
    assert any(at.motions for at in ours.frequencies)
    assert pickle.loads(pickle.dumps(ours)) == ours


def test_responses_with_two_contacts_agree(program: Program) -> None:
    """Of one bar and of several."""
    drive: dict[str, Any] = {"force": "tip", "amplitude": 2e-3, "contacts": 2, "band": 0.3}
    bars = "clamp 6 dash=0.1 driven gap=1e-3 8 dash=0.2 2 clamp"
    said = program("response", "--scene", bars, "--from", "0.5Hz", "--to", "0.55Hz",
                   *words_of(drive))
    several = sg.response(scene=bars, start="0.5 Hz", to="0.55 Hz", **drive)
    alike(said, several.to_dict())
    assert any(motion.spans for at in several.frequencies for motion in at.motions)
    assert pickle.loads(pickle.dumps(several)) == several
    said = program("response", "--cells", 6, "--damping", 0.05, "--from", 0.9, "--to", 1.1,
                   *words_of(drive))
    alike(said, sg.response(cells=6, damping=0.05, start=0.9, to=1.1, **drive).to_dict())
    with pytest.raises(ValueError, match="contacts=2"):
        sg.response(cells=4, damping=0.1, force="tip", amplitude=2e-3, band=0.1)
    with pytest.raises(ValueError, match="contacts = 3 .* allowed 1, 2"):
        sg.response(cells=4, damping=0.1, force="tip", amplitude=2e-3, contacts=3)


def test_two_contacts_of_bars_are_those_on_which_the_bar_settles() -> None:
    """Under an exact harmonic one bar lists by itself what it settles on; bars are asked for it."""
    drive: dict[str, Any] = {"force": "tip", "amplitude": 4e-3, "start": 0.9, "to": 1.1}
    of_bar = sg.exact_response(cells=8, damping=0.1, **drive).frequencies
    bars = sg.exact_response(scene="clamp 8 dash=0.15580032922161893 driven stop=1e-3", contacts=2,
                             **drive).frequencies
    seen = 0
    for one, other in zip(of_bar, bars):
        assert one.steps == other.steps
        settled = [motion for motion in one.motions if len(motion.contacts) == 2]
        ours = [motion for motion in other.motions if len(motion.contacts or []) == 2]
        for motion, same in zip(settled, ours):
            assert same.impulse == pytest.approx(motion.physical.impulse, rel=1e-7)
            assert same.phase == pytest.approx(motion.phase, abs=1e-6)
        seen += len(settled)
        assert len(settled) <= len(ours)
    assert seen > 0
