#!/usr/bin/env python3
"""Validates what the program answers against the schemas in docs/schema.

schema_test.py PROGRAM FOLDER_OF_SCHEMAS
"""

import json
import pathlib
import shlex
import subprocess
import sys
import tempfile
import warnings

import jsonschema

warnings.simplefilter("ignore", DeprecationWarning)

# Schema and call, {} the folder of the test; what stands first is done first.
STEEL = "--length 2 --young 210e9 --density 7800 --area 1e-4 --gap 1e-5"
FORCE = "--damping 0.05 --force tip --amplitude 3e-4"
CALLS = [
    ("find", "find 150 900"),
    ("find", f"find 150 900 --energy-ratio 20 {STEEL}"),
    ("find", "find 140 910 --energy-ratio 700"),
    ("find", "find 1 79 --cells 20 --energy-ratio 3"),
    ("find", "find 20 109 --cells 40"),
    ("find", "find 2 4 --cells 2"),
    ("find", "find 150 900 --strain-limit 0.0019"),
    ("find", "find 150 900 --energy-ratio 3"),
    ("find", "find 1 12 3 12 --cells 4"),
    ("find", "find 1 12 3 12 --cells 4 --energy-ratio 6"),
    ("find", "find 1 1 1 1 --cells 4"),
    ("find", "find 150 900 --gap 0.6 --quiet"),
    ("find", "find 15 90 --cells 30 --solver closed-form --objective max-impulse --tip-floor -1e-9"),
    ("find", "find 15 90 --cells 30 --stability"),
    ("find-question", "find --frequency 8/7 --energy-ratio 20"),
    ("find-question", f"find --hertz 740 --energy 1e-3 {STEEL}"),
    ("find-question", "find --period 22/7 --cells 70"),
    ("find-question", "find --period 4/3 --cells 30"),
    ("find-question", "find --period 5"),
    ("find-question", "find --frequency 8/7 --energy-ratio 2"),
    ("continuum", "continuum 150 900 --energy-ratio 20 --points 5"),
    ("continuum", "continuum 150 900 --energy-ratio 3 --points 5"),
    ("continuum", "continuum 1 12 3 12 --cells 4 --energy-ratio 6 --points 3"),
    ("modes", "modes --max-order 9"),
    ("modes", f"modes --max-order 3 {STEEL}"),
    ("modes-phases", "modes --phases 2 --max-order 7"),
    ("modes-phases", f"modes --phases 3 --max-order 3 --max-energy-ratio 1e9 {STEEL}"),
    ("mode", "mode 4 -1 --period 7/2"),
    ("mode", f"mode 4 -1 --period 3.7 {STEEL}"),
    ("families", "families"),
    ("families", f"families --max-order 5 --max-energy-ratio 9 {STEEL}"),
    ("response", "response --cells 10 --damping 0.02 --force base --amplitude 1e-4 --from 1 --to 1.1"
                 " --stability"),
    ("simulate", "simulate --rest --damping 0.05 --time 3"),
    ("sweep", f"sweep --cells 10 {FORCE} --from 0.9 --to 1.2 --points 3 --periods 60"),
    ("sweep", "sweep --scene 'clamp 20 driven dash=0.1 gap=1e-3 dash=0.1 20:1.3 clamp' --force tip"
     " --amplitude 4e-4 --from 0.9 --to 1.2 --points 2 --periods 40"),
    ("sweep", "sweep --cells 10 --force base --amplitude 1e-4 --over damping --from 0.01 --to 0.1 --points 2"
              " --periods 60 --frequency 1.1 --rest --down"),
    ("atlas", "atlas --database {}/a.sqlite --cells 8"),
    ("atlas-query", "atlas --database {}/a.sqlite --cells 8 --near 1.143 5"),
    ("atlas-query", "atlas --database {}/a.sqlite --cells 8 --near 8/7 5 --schedules"),
    ("atlas-query", "atlas --database {}/a.sqlite --cells 8 --period 4 --schedules"),
    ("atlas", "atlas --database {}/b.sqlite --cells 8 --max-free 26 --phases 2 --max-contact 4"),
    ("atlas-query", "atlas --database {}/b.sqlite --twins"),
    ("atlas", "atlas --database {}/c.sqlite --cells 8 --families-only"),
    ("atlas-query", "atlas --database {}/a.sqlite --cells 8 --period 7/2"),
    ("atlas-query", "atlas --database {}/a.sqlite --cells 8 --twins"),
    ("find", "find 3 25 --segments 4:1,4:1.3"),
    ("find", "find 3 12 --segments 4:1,4:1.3:2"),
    ("response", f"response --cells 20 {FORCE} --from 1 --to 1.2 --stability"),
    ("response", f"response --cells 10 {FORCE} --from 1 --to 1.2 --contacts 2 --band 0.5"),
    ("response", f"response --cells 20 {FORCE} --from 1 --to 1.2 {STEEL}"),
    ("find-forced", f"find 8 72 --cells 20 {FORCE}"),
    ("find-forced", "find 8 72 --cells 20 --damping 0.05 --force base"),
    ("find-harmonic", f"find --frequency 1.1 {FORCE}"),
    ("find-harmonic", f"find --frequency 1.1 {FORCE} --strain-limit 1e-9"),
    ("find-harmonic-bars", "find --period 21/14 --scene 'clamp 6 dash=0.1 driven gap=1e-3 8 dash=0.2 2 clamp'"
     " --force tip --amplitude 2e-3"),
    ("find-harmonic-bars", "find --period 21/14 --scene 'clamp 6 dash=0.1 driven gap=1e-3 8 dash=0.2 2 clamp'"
     " --force tip --amplitude 2e-3 --strain-limit 1e-2"),
    ("find-harmonic-bars", "find --period 25/7 --contacts 2 --force tip --amplitude 2e-3"
     " --scene 'clamp 3 driven stop=5e-4 2 dash=0.3 gap=1e-3 dash=0.3 2:1.3 clamp'"),
    ("response-bars", "response --exact --from 0.4Hz --to 0.7Hz --scene 'clamp 6 dash=0.1 driven gap=1e-3 8 dash=0.2 2"
     " clamp' --force tip --amplitude 2e-3"),
    ("response-bars", "response --from 1.2 --to 1.3 --force base --amplitude 1e-3"
                      " --scene 'clamp shaken 8:2:0.5 gap=1 5:0.5 dash=100 stop=1e-3'"),  # touches
    ("response-bars", "response --exact --from 0.9 --to 1.4 --segments 6:1,6:1.3 --damping 0.03 --force base"
     " --amplitude-acceleration 3e-3"),
    ("find-harmonic", "find --period 18/5 --contacts 1 --damping 0.05 --force base --amplitude 1e-9"),
    ("find-forced", "find 12 96 --cells 30 --damping 0.03 --force tip --amplitude 1e-5"),
    ("find-forced", "find 30 40 --cells 20 --damping 0.03 --force tip"),
    ("find-forced", "find 6 36 --cells 12 --damping 0 --force tip"),
    ("find-forced", "find 6 36 --cells 12 --damping 0 --force tip --amplitude 1e-4"),
    ("find-forced", "find 12 96 12 96 --cells 30 --damping 0.03 --force tip --cycles 2"),
    ("find-forced", "find 12 96 13 97 --cells 30 --damping 0.03 --force tip --cycles 2"),
    ("find-forced", "find 12 96 --cells 30 --damping 0.03 --force tip --strain-limit 1e-9"),
    ("simulate", f"simulate --cells 20 {FORCE} --frequency 1.1 --periods 60"),
    ("simulate", "simulate --time 3"),
    ("find", "find 6 4 --cells 4 --gap -1e-3"),
    ("find", "find 1 4 --cells 4 --gap -1e-3"),
    ("find", "find 3 7 --cells 4 --gap 0 --energy 1e-6 --quiet"),
    ("find", "find 3 8 --cells 4 --gap 0 --energy 1e-6"),
    ("find", "find 1 5 L:1 5 --cells 4 --second-stop 1e-3"),
    ("find", "find 1 4 L:1 4 --cells 4 --second-stop 1e-3"),
    ("find-question", "find --period 5/2 --cells 4 --gap -1e-3"),
    ("find-question", "find --period 7/2 --cells 8 --second-stop 2e-3"),
    ("find-forced", f"find 12 8 --cells 10 --gap -1e-3 {FORCE}"),
    ("find-forced", f"find 5 20 --cells 10 --gap 0 {FORCE}"),
    ("find-forced", f"find 3 17 L:3 17 --cells 10 --second-stop 1e-3 {FORCE}"),
    ("find-forced", f"find 3 17 L:4 18 --cells 10 --second-stop 1e-3 {FORCE}"),
    ("response", f"response --cells 10 --gap -1e-3 {FORCE} --from 1 --to 1.2 --stability"),
    ("response", f"response --cells 6 --gap -1e-3 --second-stop 2e-3 {FORCE} --from 1.2 --to 1.4 --contacts 2"),
    ("find-forced", "find 13 3 --cells 6 --gap 0 --damping 0.0033 --force tip --amplitude 0.165"),
    ("response", f"response --cells 10 --gap 0 {FORCE} --from 1 --to 1.2"),
    ("response", f"response --cells 10 --second-stop 1e-3 {FORCE} --from 1 --to 1.2"),
    ("response", f"response --segments 4:1,4:1.3 {FORCE} --from 1 --to 1.2 --stability"),
    ("find-forced", "find 6 28 --segments 4:1,4:1.3 --damping 0.05 --force tip"),
    ("families", "families --second-stop 1.5e-3"),
    ("atlas", "atlas --database {}/d.sqlite --cells 4 --phases 2 --max-contact 3 --max-free 6"
              " --second-stop 1e-3"),
    ("atlas-query", "atlas --database {}/d.sqlite --cells 4 --period 3 --schedules"),
    ("atlas", "atlas --database {}/e.sqlite --segments 4:1,4:1.3 --max-contact 3 --max-free 9 --all"),
    ("atlas-query", "atlas --database {}/e.sqlite --segments 4:1,4:1.3 --period 3/2 --schedules"),
    ("atlas", "atlas --database {}/r.sqlite --scene 'clamp 3 gap=1e-3 4 clamp' --max-contact 3 --max-free 14 --all"),
    ("atlas-query", "atlas --database {}/r.sqlite --near 1 5 --schedules --within 0.2"),
    ("atlas", "atlas --database {}/s.sqlite --scene 'free 3 gap=1e-3 4 clamp' --max-contact 3 --max-free 14"),
    ("atlas-query", "atlas --database {}/s.sqlite --twins"),
    ("atlas-query", "atlas --database {}/s.sqlite --period 2 --schedules"),
    ("atlas", "atlas --database {}/f.sqlite --cells 4 --gap 0"),
    ("atlas-query", "atlas --database {}/f.sqlite --gap 0 --period 4 --schedules"),
    ("find", "find 6 4 --cells 4 --gap -1e-3 --stability"),
    ("families", "families --gap -1e-3"),
    ("families", "families --gap 0"),
    ("modes", "modes --gap -1e-3"),
    ("mode", "mode 4 -1 --gap -1e-3 --period 5/2"),
    ("simulate", "simulate --rest --gap -1e-3 --time 3"),
    ("simulate", "simulate --rest --second-stop 1e-3 --damping 0.05 --force tip --amplitude 1e-3"
                 " --frequency 1 --periods 20 --cells 20"),
    ("scene", "scene clamp 150 gap=1e-3 200:1.3 clamp"),
    ("scene", "scene clamp shaken 30 stop=-1e-5 30:2:0.5 mass=1e-3 dash=0.1 9 driven stop=1e-5"
              " --length 2 --young 210e9 --density 7800 --area 1e-4"),
    ("scene", "scene stop=-1e-3 300 stop=1e-3 --gravity -9.81"),
    ("simulate-scene", "simulate --scene '50:3 gap=0 200' --velocity 1,0 --time 0.5"),
    ("find-scene", "find --scene 'clamp 3 stop=1e-3 3 clamp' 1 10"),
    ("find-scene-forced", "find --scene 'clamp 3 dash=0.1 driven gap=1e-3 4:1.3 dash=0.05 2 clamp' 4 13 --force tip"),
    ("find-scene-forced", "find --scene 'clamp 3 dash=0.1 driven gap=1e-3 4:1.3 dash=0.05 2 clamp' 3 17 --force tip"),
    ("find-scene", "find --scene '4 stop=0' --gravity 10 8 24"),
    ("find-scene", "find 3 11 --scene 'clamp 4 gap=2e-3 4 clamp' --stability"),
    ("find-scene-forced", "find 6 42 --scene 'clamp 6 dash=0.2 driven gap=1e-3 6 clamp' --force tip --stability"),
    ("continuum-scene", "continuum 1:6 -:40 --scene 'clamp 12 gap=1e-3 16 clamp' --energy-ratio 20 --points 3"
                        " --member 0 --state {}/member.csv"),
    ("continuum-scene", "continuum 1:6 -:40 --scene 'clamp 12 gap=1e-3 16 clamp' --energy-ratio 2"),
    ("continuum-scene", "continuum 1:2 -:14 --scene 'stop=1e-3 8 stop=1e-3' --energy 1e-5 --sample --points 3"
                        " --strain-limit 0.02"),
    ("continuum-scene", "continuum 6 36 --segments 6:1,6:2 --energy-ratio 400 --sample --points 2"),
    ("find-scene-question", "find --period 1.75 --scene 'clamp 4 gap=2e-3 4 clamp'"),
    ("find-scene-question", "find --hertz 0.6 --scene 'stop=1e-3 6 stop=1e-3' --energy 1e-5"),
    ("find-scene-question", "find --period 7/2 --segments 4:1,4:2"),
    ("find-scene", "find --scene '4 stop=0' --gravity 10 8 24 --energy 1e-9"),
    ("find-scene", "find --scene 'clamp 3 stop=1e-3 3 gap=1e-3 4 clamp' 1:2 -:9 1+2:3 -:8"),
    ("simulate-scene", "simulate --scene 'clamp 20 driven stop=1e-3 dash=0.05' --amplitude 4e-4"
                       " --frequency 1 --periods 60"),
    ("simulate-scene", "simulate --scene 'clamp 20 gap=-1e-3 spring=3 dash=1' --time 3"
                       " --state {}/state.csv"),
    ("simulate-scene", "simulate --scene 'clamp 20 gap=-1e-3 spring=3 dash=1' --time 3"
                       " --from {}/state.csv"),
    ("simulate-scene", "simulate --cells 30 --velocity 0.1 --time 9"),
    ("simulate-reach", "simulate --scene 'clamp 7 stop=1 3 driven' --force-range 0.9,1 --time 3"),
    ("simulate-reach", "simulate --scene 'clamp 7 stop=0.1 3 driven' --force-range -1,1 --time 9"),
]
# Spoilt answers that a schema worth its name refuses.
SPOILT = [
    ("find", "find 150 900", lambda answer: answer.pop("physical")),
    ("find", "find 150 900", lambda answer: answer["physical"].pop("impulse")),
    ("find", "find 150 900", lambda answer: answer.update(physical=None)),
    ("find", "find 150 900", lambda answer: answer.update(schema=1)),
    ("find", "find 150 900", lambda answer: answer.update(schedule=[[150]])),
    ("find", "find 15 90 --cells 30 --stability",
     lambda answer: answer["stability"][0].pop("trials")),
    ("find", "find 20 109 --cells 40", lambda answer: answer.update(reason=None)),
    ("find", "find 150 900", lambda answer: answer.update(surplus=1)),
    ("find", "find 150 900", lambda answer: answer["physical"].update(surplus=1)),
    ("find", "find 20 109 --cells 40", lambda answer: answer["certificate"].update(surplus=1)),
    ("find", "find 20 109 --cells 40", lambda answer: answer.update(energy=1.0)),
    ("find-question", "find --period 7/2", lambda answer: answer.update(motions=[])),
    ("find-question", "find --period 7/2", lambda answer: answer["motions"][0].pop("bar")),
    ("continuum", "continuum 150 900 --energy-ratio 20 --points 5",
     lambda answer: answer["points"][0].pop("lambda")),
    ("mode", "mode 4 -1 --period 7/2", lambda answer: answer["physical"].pop("peak_stress")),
    ("families", "families --max-order 5", lambda answer: answer["families"][0].pop("nu")),
    ("response", f"response --cells 20 {FORCE} --from 1 --to 1.2",
     lambda answer: answer["frequencies"][0].pop("touches")),
    ("find-forced", f"find 8 72 --cells 20 {FORCE}",
     lambda answer: answer["motions"].append({"amplitude": 1})),
    ("find-forced", "find 30 40 --cells 20 --damping 0.03 --force tip",
     lambda answer: answer["certificate"]["conditions"][0].pop("rule")),
    ("simulate", "simulate --time 3", lambda answer: answer.pop("settled")),
    ("sweep", f"sweep --cells 10 {FORCE} --from 1 --to 1.2 --points 2 --up --periods 60",
     lambda answer: answer["points"][0].update(speed=1)),
    ("modes", "modes --max-order 3", lambda answer: answer["modes"][0].update(contact=[4])),
    ("scene", "scene clamp 3 stop=1", lambda answer: answer["scene"]["parts"].append({"kind": "x"})),
    ("scene", "scene clamp 3 stop=1", lambda answer: answer["scene"]["parts"][1].pop("cells")),
    ("simulate-scene", "simulate --scene '3 stop=1' --velocity 1 --time 9",
     lambda answer: answer["contacts"][0].pop("impulse")),
    ("simulate-reach", "simulate --scene 'clamp 7 stop=1 3 driven' --force-range 0.9,1 --time 3",
     lambda answer: answer["contacts"][0]["velocity"].pop()),
    ("atlas", "atlas --database {}/a.sqlite --cells 8", lambda answer: answer.update(finished=True)),
    ("atlas", "atlas --database {}/a.sqlite --cells 8", lambda answer: answer.pop("refuted")),
    ("atlas", "atlas --database {}/a.sqlite --cells 8", lambda answer: answer.pop("stops")),
    ("atlas", "atlas --database {}/r.sqlite --scene 'clamp 3 gap=1e-3 4 clamp' --max-contact 3 --max-free 14 --all",
     lambda answer: answer.pop("reference")),
    ("atlas-query", "atlas --database {}/a.sqlite --period 4", lambda answer: answer.pop("families")),
    ("atlas-query", "atlas --database {}/a.sqlite --period 4", lambda answer: answer.update(twins=[])),
    ("atlas-query", "atlas --database {}/a.sqlite --period 4", lambda answer: answer["families"][0].pop("nu")),
    ("atlas-query", "atlas --database {}/a.sqlite --period 4 --schedules",
     lambda answer: answer["schedules"][0].update(surplus=1)),
    ("atlas-query", "atlas --database {}/a.sqlite --period 4",
     lambda answer: answer["ranges"][0].update(decided=1)),
    ("atlas-query", "atlas --database {}/a.sqlite --near 8/7 5", lambda answer: answer["near"].pop("within")),
    ("atlas-query", "atlas --database {}/b.sqlite --twins", lambda answer: answer["twins"][0].pop("energy")),
    ("modes-phases", "modes --phases 2 --max-order 3",
     lambda answer: answer["polytopes"][0]["vertices"][0].append([1])),
]


def main():
    program, folder = sys.argv[1], pathlib.Path(sys.argv[2])
    schemas = {path.name: json.loads(path.read_text("utf-8")) for path in folder.glob("*.json")}
    for schema in schemas.values():
        jsonschema.Draft202012Validator.check_schema(schema)

    def validator(name):
        schema = schemas[f"{name}.json"]
        resolver = jsonschema.RefResolver.from_schema(schema, store=schemas)
        return jsonschema.Draft202012Validator(schema, resolver=resolver)

    with tempfile.TemporaryDirectory() as work:
        def answer(call):
            words = [program, *shlex.split(call.format(work)), "--format", "json"]
            done = subprocess.run(words, capture_output=True, text=True, check=False)
            assert done.returncode in (0, 1, 3), f"{call}: status {done.returncode}: {done.stderr}"
            return json.loads(done.stdout)

        for name, call in CALLS:
            faults = list(validator(name).iter_errors(answer(call)))
            assert not faults, f"{call}: {faults[0].json_path}: {faults[0].message}"
        for name, call, spoil in SPOILT:
            spoilt = answer(call)
            spoil(spoilt)
            assert not validator(name).is_valid(spoilt), f"{call}: the schema misses a fault"
    print(f"{len(CALLS)} answers are as their schemas say, {len(SPOILT)} spoilt ones are not")


if __name__ == "__main__":
    main()
