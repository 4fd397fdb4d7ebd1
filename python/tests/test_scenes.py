"""Gaps of any sign, a second stop, stepped bars: what the program says."""

from __future__ import annotations

import random
from pathlib import Path
from typing import Any

import pytest

import signorini as sg

from support import Program, alike, words_of

Question = tuple[list[Any], dict[str, Any]]


def tent(dice: random.Random, gap: float) -> Question:
    """A schedule near the middle of a tent, where there are motions."""
    family = dice.choice(list(sg.families(9, gap=gap)))
    cells = family.order * dice.randint(2, 5)
    (contact, free), = family.schedule(cells)
    off = dice.randint(-2, 2)
    if dice.random() < 0.4:  # anywhere
        contact, free = dice.randint(1, 2 * cells), dice.randint(1, 4 * cells)
    return [max(1, contact + off), max(1, free - off)], {"cells": cells,
                                                         "gap": gap}


def pressed(dice: random.Random) -> Question:
    """The bar at rest presses on the wall."""
    steps, options = tent(dice, -10 ** dice.uniform(-6, -2))
    if dice.random() < 0.5:
        options["energy_ratio"] = dice.choice([0.5, 1, 2, 9.5])
    return steps, options


def without_gap(dice: random.Random) -> Question:
    """The energy sets the size."""
    steps, options = tent(dice, 0.0)
    return steps, {**options, "energy": 10 ** dice.uniform(-6, 1)}


def between(dice: random.Random) -> Question:
    """Two stops, touched in turn."""
    cells = dice.choice([2, 4, 6, 12])
    steps = [(dice.randint(1, cells), dice.randint(1, 3 * cells)),
             (dice.randint(1, cells), dice.randint(1, 3 * cells), "left")]
    if dice.random() < 0.7:
        steps[1] = (*steps[0], "left")
    return steps, {"cells": cells, "gap": 1e-3,
                   "second_stop": dice.choice([1e-3, 2e-3, 5e-4])}


def stepped(dice: random.Random) -> Question:
    """A bar of two materials."""
    half = dice.choice([2, 3, 4])
    thick = dice.choice([0.7, 1.0, 1.3, 2.0])
    return ([dice.randint(1, 2 * half), dice.randint(1, 8 * half)],
            {"cells": 2 * half, "segments": [(half, 1.0), (half, thick)],
             "objective": dice.choice(["any", "min-energy"])})


def said(steps: list[Any], options: dict[str, Any]) -> list[str]:
    """The same words for the program."""
    words = []
    for step in steps:
        if isinstance(step, tuple):
            contact, free, *left = step
            words += ["L:" * len(left) + str(contact), str(free)]
        else:
            words.append(str(step))
    rest = dict(options)
    parts = rest.pop("segments", None)
    if parts:
        rest["segments"] = ",".join(f"{n}:{z!r}" for n, z in parts)
    return words + words_of(rest)


@pytest.mark.parametrize("ask, count, least", [
    (pressed, 150, 20), (without_gap, 100, 20), (between, 150, 10),
    (stepped, 60, 5)])
def test_random_requests_agree_bit_for_bit(program: Program, ask: Any,
                                           count: int, least: int) -> None:
    dice = random.Random(ask.__name__)
    seen = {"found": 0, "none": 0, "undecided": 0}
    for _ in range(count):
        steps, options = ask(dice)
        answer = sg.find(*steps, **options)
        alike(program("find", *said(steps, options)), answer.to_dict(),
              f"{steps} {options}")
        seen[answer.status] += 1
        assert answer.status != "none" or answer.is_proof()
    assert min(seen["found"], seen["none"]) >= least, seen


def test_forced_motions_know_their_stops(program: Program) -> None:
    """Random gaps of any sign and second stops, as the program has them."""
    dice = random.Random("forced")
    seen = {"found": 0, "none": 0, "undecided": 0}
    for number in range(120):
        cells = dice.choice([4, 6, 10])
        steps: list[Any] = [(dice.randint(1, 3 * cells),
                             dice.randint(1, 4 * cells))]
        options: dict[str, Any] = {
            "cells": cells, "damping": dice.choice([0.02, 0.2]),
            "force": dice.choice(["tip", "base"]),
            "gap": dice.choice([1e-3, 0.0, -1e-3, -4e-3])}
        if dice.random() < 0.5:
            options["second_stop"] = dice.choice([5e-3, 7e-3])
            if dice.random() < 0.5:
                steps.append((*steps[0], "left"))
        if options["gap"] == 0 or dice.random() < 0.3:
            options["amplitude"] = 10 ** dice.uniform(-3.5, -2)
        answer = sg.find(*steps, **options)
        alike(program("find", *said(steps, options)), answer.to_dict(),
              f"{steps} {options}")
        seen[answer.status] += 1
    assert min(seen["found"], seen["none"]) >= 10, seen


def test_a_forced_bar_that_is_pressed_at_rest() -> None:
    """The sign of the gap decides; a second stop in the way, as well."""
    options: dict[str, Any] = {"damping": 0.02, "force": "tip"}
    assert sg.find(450, 300, gap=1e-3, **options).status == "none"
    found = sg.find(450, 300, gap=-1e-3, **options)
    assert found.status == "found" and found.static_force > 0
    (motion,) = found.motions
    assert motion.state.displacement[-1] == pytest.approx(-1e-3, rel=1e-9)
    stop = -motion.tip_lowest  # how far it swings
    near = sg.find(450, 300, gap=-1e-3, second_stop=1.1 * stop, **options)
    assert near.amplitude == pytest.approx(found.amplitude, rel=1e-9)
    far = sg.find(450, 300, gap=-1e-3, second_stop=0.9 * stop, **options)
    assert far.status == "none" or far.amplitude > 1.001 * found.amplitude
    with pytest.raises(ValueError, match="amplitude is missing"):
        sg.find(450, 300, gap=0, **options)


def test_pressed_questions_agree(program: Program) -> None:
    """All motions of one period, pressed at rest."""
    asked = program("find", "--period", "5/2", "--gap", -1e-3, "--cells", 20)
    ours = sg.find(period="5/2", gap=-1e-3, cells=20).to_dict()
    alike(asked, ours)


def test_simulations_between_stops_agree(program: Program) -> None:
    words = ["--rest", "--damping", 0.02, "--force", "tip", "--amplitude",
             5e-3, "--frequency", 1.05, "--periods", 40, "--cells", 16,
             "--second-stop", 1e-3]
    run = sg.simulate(damping=0.02, force="tip", amplitude=5e-3,
                      frequency=1.05, periods=40, cells=16, second_stop=1e-3)
    alike(program("simulate", *words), run.to_dict())
    assert {"left", "right"} == set(run.contact_stop)


def test_response_of_a_stepped_bar(program: Program) -> None:
    options: dict[str, Any] = {"damping": 0.05, "force": "tip",
                               "amplitude": 4e-4}
    parts = [(4, 1.0), (4, 1.3)]
    ours = sg.response(segments=parts, start=0.9, to=1.2, **options)
    assert ours.cells == 8 and len(ours.segments) == 2
    assert len(ours.motions) > 5
    words = [word for key, value in options.items()
             for word in (f"--{key}", value)]
    said = program("response", *words, "--segments", "4:1,4:1.3",
                   "--from", 0.9, "--to", 1.2)
    alike(said, ours.to_dict())
    same = sg.response(scene=sg.Scene(segments=[sg.Segment(*part)
                                                for part in parts]),
                       start=0.9, to=1.2, **options)
    assert same == ours
    _, motion = ours.motions[0]
    assert len(motion.state.segments) == 2
    assert motion.state.displacement_ratio[-1] == pytest.approx(1, abs=1e-9)
    said = program("response", *words, "--segments", "4:1,4:1.3", "--gap", 2e-3,
                   "--second-stop", 1e-3, "--from", 0.9, "--to", 1.2)
    two = sg.response(segments=parts, gap=2e-3, second_stop=1e-3, start=0.9, to=1.2, **options)
    alike(said, two.to_dict())
    assert any("left" in str(motion.schedule) for _, motion in two.motions)


def test_state_of_a_stepped_bar_knows_its_segments(program: Program, tmp_path: Path) -> None:
    parts = [(4, 1.0), (4, 1.3, 2.0)]
    found = sg.find(3, 25, cells=8, segments=parts)
    state = found.state
    assert [part.cells for part in state.segments] == [4, 4]
    assert state.energy_ratio == pytest.approx(found.energy_ratio, rel=1e-12)
    assert state.energy == pytest.approx(found.energy, rel=1e-12)
    # The tip ends where the bar does; a cell of twice the speed is twice as
    # long, and stretches half as much.
    assert state.x[-1] == pytest.approx(found.bar.length, rel=1e-12)
    assert state.x[7] - state.x[6] == pytest.approx(2 * state.x[0], rel=1e-12)
    cells = [right - left for left, right
             in zip([0.0, *state.x[:-1]], state.x)]
    stretched = sum(s * cell for s, cell in zip(state.strain, cells))
    assert stretched == pytest.approx(state.displacement[-1], rel=1e-12)
    later = found.motion.state_at(28)
    assert later.a == pytest.approx(state.a, abs=1e-9)
    assert later.energy_ratio == pytest.approx(state.energy_ratio, rel=1e-9)
    fine = state.refined(3)
    assert fine.energy_ratio == pytest.approx(state.energy_ratio, rel=1e-12)
    state.write(str(tmp_path / "state.csv"))
    assert program("simulate", "--segments", "4:1:1,4:1.3:2", "--from", tmp_path / "state.csv",
                   "--time", 1)["energy_ratio"] == pytest.approx(state.energy_ratio, rel=1e-12)
    assert list(sg.plot.motion(found)) == ["displacement", "contact 1"]
    with pytest.raises(ValueError, match="cells of all segments"):
        sg.State([1.0], [1.0], segments=state.segments)
    assert sg.find(6, 28, cells=8, segments=parts, damping=0.05, force="tip").status


def test_a_stepped_bar_from_a_drawing(program: Program, tmp_path: Path) -> None:
    pieces = [(1.2, 210e9, 7850.0, 3.1e-4), (0.7, 120e9, 8900.0, 7.1e-4)]
    scene, rounding = sg.Scene.of_pieces(pieces, gap=1e-4, cells=60)
    assert 0.0 < rounding < 1e-2
    times = [length * (density / young) ** 0.5
             for length, young, density, _ in pieces]
    cells = [segment.cells for segment in scene.segments]
    for steps, time in zip(cells, times):
        assert abs(steps / sum(cells) / (time / sum(times)) - 1) <= rounding + 1e-12
    (tmp_path / "rod.csv").write_text(
        "\n".join(["length,young,density,area"] + [
            ",".join(map(repr, piece)) for piece in pieces]) + "\n")
    said = program("find", 12, 68, "--segments-file", tmp_path / "rod.csv",
                   "--cells", 60, "--gap", 1e-4)
    alike(said, sg.find(12, 68, scene=scene).to_dict())
    with pytest.raises(ValueError, match="young of piece 2 = -1"):
        sg.Scene.of_pieces([pieces[0], (1, -1, 1, 1)])


def test_sweeps_of_several_bars_agree(program: Program) -> None:
    words = "clamp 20 driven dash=0.1 gap=1e-3 dash=0.1 20:1.3 clamp"
    options: dict[str, Any] = {"force": "tip", "amplitude": 4e-4, "length": 2.0,
                               "points": 3, "periods": 60}
    asked: dict[str, Any] = {"scene": words, **options}
    swept = sg.sweep(start=0.9, to=1.2, **asked)
    said = program("sweep", "--scene", words, "--from", 0.9, "--to", 1.2,
                   *words_of(options))
    alike(said, swept.to_dict())
    assert len(swept.to_dict()["contacts"]) == 1 and "bar" not in said
    wrongs: list[dict[str, Any]] = [
        {"over": "gap"}, {"damping": 0.1}, {"force": "base"},
        {"second_stop": 1e-3}, {"scene": "clamp 20 nonsense"}]
    for wrong in wrongs:
        with pytest.raises(ValueError, match="|".join(["scene", "word", *wrong])):
            sg.sweep(**{**asked, **wrong})


def test_a_refused_sweep_of_several_bars_leaves_no_file(tmp_path: Path) -> None:
    wrongs: list[tuple[dict[str, Any], str]] = [
        ({"resolve": 1e-9}, "at least"), ({"to": "9Hz"}, r"^to = .* \[Hz\]"),
        ({"start": "8Hz", "to": "9Hz"}, r"^start = .* \[Hz\]")]
    for wrong, named in wrongs:
        with pytest.raises(ValueError, match=named):
            sg.sweep(scene="clamp 6 dash=0.1 driven gap=1e-3 4:1.5 dash=0.2 5 clamp",
                     force="tip", amplitude=2e-3, points=2, periods=20,
                     file=tmp_path / "x.csv", **wrong)
        assert not any(tmp_path.iterdir())


def test_what_any_force_can_do_agrees(program: Program) -> None:
    for low, high, words in ((0.9, 1.1, "clamp 7 stop=2 3 driven"),
                             (-1.0, 1.0, "clamp 7 stop=0.1 3 driven")):
        reach = sg.force_range(words, low, high, time=9.0)
        said = program("simulate", "--scene", words, "--time", 9,
                       f"--force-range={low},{high}")
        alike(said, reach.to_dict())
        assert (reach.closes is None) == (low > 0.0)
        for peak in (one for contact in reach.contacts
                     for one in contact["displacement"]):
            assert abs(peak["reached"]) <= abs(peak["bound"])
    with pytest.raises(ValueError, match="low, high"):
        sg.force_range("clamp 7 stop=1 3 driven", 1.0, 0.9, time=3.0)


def bars_of(dice: random.Random) -> str:
    """Two bars that meet, or three, some damped, one driven."""
    parts = ["clamp", str(dice.randint(2, 5)), "driven", f"gap={dice.choice([1e-3, 5e-4])}"]
    if dice.random() < 0.3:
        parts += [str(dice.randint(2, 4)), "spring=2", "gap=1e-3"]
    parts += [f"{dice.randint(2, 5)}:{dice.choice([1.0, 0.5, 1.3])}", "clamp"]
    if dice.random() < 0.5:
        parts.insert(2, "dash=0.1")
    return " ".join(parts)


@pytest.mark.parametrize("ask", ["schedule", "forced", "simulate"])
def test_random_requests_about_several_bars_agree(program: Program, ask: str,
                                                  tmp_path: Path) -> None:
    """To the last bit; what one refuses, the other does."""
    dice = random.Random(ask)
    found = 0
    for _ in range(40):
        words = bars_of(dice)
        options: dict[str, Any] = {"scene": words, "length": dice.choice([1.0, 2.5])}
        schedule: list[Any] = []
        more: list[dict[str, Any]]
        if ask == "simulate":
            more = [{}, {"velocity": [0.1] * (words.count("gap") + 1)},
                    {"force": "tip", "amplitude": 1e-3, "frequency": 1.1}]
            options |= {"time": 20.0, **dice.choice(more)}
        else:
            schedule = [dice.randint(1, 8), dice.randint(2, 20)]
            if words.count("gap") == 2:
                closed = dice.choice(["1", "2", "1+2", "3"])
                schedule = [f"{closed}:{schedule[0]}", f"-:{schedule[1]}"]
            more = [{}, {"objective": "max-impulse"}, {"energy_ratio": 3.0}, {"energy": 1e-5}]
            if ask == "forced":
                more = [{"force": "tip"}, {"force": "tip", "amplitude": 5e-3}]
            options |= dice.choice(more)
            if dice.random() < 0.3:
                options["stability"] = True
        said = program(ask if ask == "simulate" else "find", *schedule,
                       *words_of({k: ",".join(map(str, v)) if k == "velocity" else v
                                  for k, v in options.items()}), may_be_wrong=True)
        try:
            answer = getattr(sg, ask, sg.find)(*schedule, **options)
        except ValueError as error:
            assert said is None, error
            continue
        alike(said, answer.to_dict())
        found += 1
        if ask != "simulate" and answer:
            answer.write(str(tmp_path / "s.csv"))
            assert (tmp_path / "s.csv").read_text().startswith("node")
    assert found > 20


def test_all_motions_of_a_period_of_bars_agree(program: Program) -> None:
    """Of several bars, and of a bar of several segments; a row of the frame is a schedule."""
    bars = {"scene": "clamp 4 gap=2e-3 4 clamp", "length": 2.0}
    asked: list[tuple[dict[str, Any], dict[str, Any]]] = [
        ({"period": 1.75}, bars), ({"hertz": 0.3, "energy_ratio": 20.0}, bars),
        ({"frequency": 0.75, "objective": "max-impulse"}, bars),
        ({"frequency": 0.75, "stability": True}, bars),
        ({"frequency": 0.75, "strain_limit": 2.7e-3}, bars),
        ({"frequency": 0.75, "objective": "min-peak-strain"}, bars),
        ({"period": 3.5, "strain_limit": 4e-3}, {"segments": [(3, 1.0), (3, 2.0)]}),
        ({"period": 3.5}, {"segments": [(3, 1.0), (3, 2.0)]})]
    for when, where in asked:
        answer = sg.find(**when, **where)
        assert isinstance(answer, sg.SceneQuestion)
        given = {**when, **where} if where is bars else {**when, "segments": "3:1,3:2"}
        said = program("find", *words_of(given))
        alike(said, answer.to_dict())
        assert answer.found == bool(answer.motions) and len(answer.frame()) == len(answer.sets)
        shown: Any = answer
        assert (shown._repr_png_() is not None) == answer.found
        assert "sets" in shown._repr_html_()
    parts = [(2, 1.0, 1.0), (2, 1.0, 2.0), (3, 1.0, 0.5)]
    alike(program("find", 2, 26, "--segments", "2:1,2:1:2,3:1:0.5", "--energy", 1e-5),
          sg.find(2, 26, segments=parts, energy=1e-5).to_dict())
    with pytest.raises(ValueError, match="clashes with period"):
        sg.find(3, 11, period=1.75, scene="clamp 4 gap=2e-3 4 clamp")  # type: ignore[call-overload]
    with pytest.raises(ValueError, match="tip_floor: allowed"):
        sg.find(period=3.5, segments=[(3, 1.0), (3, 2.0)], tip_floor=-1.0)


def test_motions_of_bars_come_back_and_are_drawn(tmp_path: Path) -> None:
    """What `write` writes is where a simulation starts, and a target."""
    file = str(tmp_path / "s.csv")
    bars: dict[str, Any] = {"scene": "clamp 4 gap=2e-3 4 clamp", "length": 2.0}
    found = sg.find("1:3", "-:11", **bars)
    found.write(file)
    run = sg.simulate(file, time=5 * found.period, **bars)
    assert run.contacts[0]["count"] == 5
    assert run.energy == pytest.approx(found.energy)
    assert sum(run.contact_impulse) == pytest.approx(5 * found.contacts[0]["impulse"])
    near = sg.find(3, 11, objective="nearest", target=file, **bars)
    assert near.energy == pytest.approx(found.energy)
    assert list(sg.plot.motion(found)) == ["displacement", "contact 1"]
    moving = sg.plot.animate(found, str(tmp_path / "pair.gif"), frames=7)
    assert (tmp_path / "pair.gif").stat().st_size > 1000 and "<img" in moving._repr_html_()
    assert len(sg.plot.simulation(run)) == 1 and sg.plot.scene(run)
    silent: Any = sg.simulate(file, time=5 * found.period, tip=False, **bars)
    assert silent.contacts == run.contacts and silent._repr_png_() is None
    with pytest.raises(ValueError, match="tip=True"):
        sg.plot.simulation(silent)
    with pytest.raises(ValueError, match="energy_ratio = 3.* E₁"):
        sg.find("1:3", "-:9", scene="stop=1e-3 8 stop=1e-3", energy_ratio=3.0)
    assert found._repr_png_() and run._repr_png_()
    assert "contact" in run._repr_html_() and len(run.frame()) == 5
    with pytest.raises(ValueError, match="no motion was found"):
        sg.plot.motion(sg.find(11, 3, **bars))
    assert sg.find(3, 11, objective="max-energy", **bars).energy >= found.energy
    gentle = sg.find(3, 11, **bars, strain_limit=1e-3)
    assert gentle.status == "none" and gentle.certificate
    assert gentle.certificate["strain_limit"] == 1e-3 and gentle.certificate["strains"]
    wrongs: list[tuple[str, dict[str, Any]]] = [
        ("dash=D", {"damping": 0.1}), ("cells", {"cells": 4}), ("amplitude", {"amplitude": 1.0}),
        ("cycles", {"cycles": 2}), ("strain_limit = -1", {"strain_limit": -1}),
        ("word driven", {"force": "tip"}),
        ("energy", {"energy": 1.0, "energy_ratio": 1.0}), ("contacts", {"contacts": 2})]
    for said, wrong in wrongs:
        with pytest.raises(ValueError, match=said):
            sg.find(3, 11, **bars, **wrong)
    wrongs = [("velocity", {"velocity": [1.0]}), ("dash=D", {"damping": 0.1}),
              ("one of them", {"start": file, "velocity": [0.0, 0.0]})]
    for said, wrong in wrongs:
        with pytest.raises(ValueError, match=said):
            sg.simulate(time=1.0, **bars, **wrong)
    with pytest.raises(ValueError, match="only with a scene of words"):
        sg.simulate(time=1.0, velocity=[1.0])  # type: ignore[call-overload]


BARS = "clamp 30 dash=0.1 driven gap=1e-3 20:1.3 dash=0.2 20:1.3 clamp"


def test_bars_that_meet_under_an_exact_harmonic() -> None:
    """As a simulation from rest settles on it."""
    found = sg.find(scene=BARS, hertz=0.5, force="tip", amplitude=2e-3)
    assert found.status == "found" and found.steps == 140
    motion, = found.motions
    assert motion.release == "pinned" and motion.residual < 1e-9
    assert motion.contact_time == pytest.approx(2 / 7)
    # 1.35451e-3 N s: what `simulate --rest` settles on, on ten times as many cells.
    assert motion.impulse == pytest.approx(1.35451e-3, rel=1e-5)
    again = sg.find(scene=BARS, frequency=found.frequency_ratio, force="tip", amplitude=2e-3)
    assert again.motions == found.motions
    limited = sg.find(scene=BARS, hertz=0.5, force="tip", amplitude=2e-3, strain_limit=1e-6)
    assert limited.status == "undecided" and not limited.motions and limited.beyond_limit == 1
    with pytest.raises(ValueError, match="energy"):
        sg.find(  # type: ignore[call-overload]
            scene=BARS, hertz=0.5, force="tip", amplitude=2e-3, energy=1.0)
    with pytest.raises(ValueError, match="70 to L/c"):
        sg.find(scene=BARS, period="1/3", force="tip", amplitude=2e-3)


def test_what_drives_bars_is_said_only_where_there_is_a_choice() -> None:
    drive: dict[str, Any] = {"amplitude": 2e-3, "frequency": "0.5Hz", "periods": 3}
    assert sg.simulate(scene=BARS, **drive) == sg.simulate(scene=BARS, force="tip", **drive)
    with pytest.raises(ValueError, match=r"one word driven .* force tip\|base says which"):
        sg.simulate(scene=BARS.replace("30 dash", "shaken 30 dash"), **drive)
    with pytest.raises(ValueError, match="^amplitude, frequency: allowed only together$"):
        sg.simulate(scene=BARS, amplitude=2e-3, time=1.0)


def test_the_contact_of_bars_is_drawn() -> None:
    """What the curves say is what the motion says, and a notebook has them."""
    found = sg.find(scene=BARS, frequency="0.5Hz", force="tip", amplitude=2e-3)
    motion, = found.motions
    axes = sg.plot.motion(found)
    gap, force = (axes[name].lines[0].get_ydata() for name in ("gap", "force"))
    assert gap[0] == 0.0 and abs(gap[-1]) < 1e-9 and min(gap) > -1e-9 and max(gap) > 0.0
    unit = {"mN": 1e3, "N": 1.0}[axes["force"].get_ylabel().split("[")[1].strip("] ")]
    assert max(force) == pytest.approx(unit * motion.peak_force, rel=1e-2)
    assert motion.strains["peak_compression"] > 0.0
    assert sg.plot.animate(found, frames=5)._repr_html_()
    assert found and found._repr_png_() and len(found.frame()) == 1  # type: ignore[attr-defined]
    assert "<img" in found._repr_html_()
    assert sg.plot.scene(found).collections or sg.plot.scene(found).lines
