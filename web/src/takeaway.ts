// What the reader takes along: the command and the Python line of the same motion, files, pictures.

import type { Motion, Phase, Phases, SceneMotion } from './core';
import type { Forcing } from './view';

const steps = (m: { phases: Phases }): string => m.phases.map(([contact, free, stop]) => `${stop ? 'L:' : ''}${contact} ${free}`).join(' ');
const argumentsOf = (m: { phases: Phases }): string => {
  const isPlain = m.phases.every((phase) => !phase[2]);
  const one = ([contact, free, stop]: Phase): string => (isPlain ? `${contact}, ${free}` : `(${contact}, ${free}${stop ? ', "left"' : ''})`);
  return m.phases.map(one).join(', ');
};

const given = (before: string, value: number | undefined): string => (value === undefined ? '' : `${before}${value}`);

/** Types of two contacts are listed up to this order. */
export const polygonOrder = 9;

/** Speeds of the bars [m/s], where the hands do anything, and what they cannot say there. */
function thrown(m: SceneMotion): { speeds: string; note: string } {
  if (m.hands.every((hand) => hand === 0)) return { speeds: '', note: '' };
  return { speeds: m.hands.map((hand) => Number((hand * 1e-3).toPrecision(6))).join(','),
    note: '  # where all bars fly; one that is held starts at rest there, here it is pulled' };
}

function sceneCommand(m: SceneMotion): string {
  const drive = m.amplitude === undefined ? '' : ` --amplitude ${m.amplitude} --frequency ${m.frequency}`;
  const { speeds, note } = thrown(m);
  return `signorini simulate --scene "${m.words.trim()}"${speeds && ` --velocity ${speeds}`}${given(' --gravity ', m.gravity)}${drive} --time ${m.from + m.span} --format json${note}`;
}

function scenePython(m: SceneMotion): string {
  const place = /\bdriven\b/.test(m.words) ? 'tip' : 'base';
  const drive = m.amplitude === undefined ? '' : `, force="${place}", amplitude=${m.amplitude}, frequency=${m.frequency}`;
  const { speeds, note } = thrown(m);
  return `import signorini\nbars = signorini.simulate(scene="${m.words.trim()}"${speeds && `, velocity=[${speeds}]`}${given(', gravity=', m.gravity)}${drive}, time=${m.from + m.span})${note}`;
}

/** The command that gives the same motion, as the command line writes its JSON. */
export function commandOf(motion: Motion, nearest?: Phases, phase = 0): string {
  if (motion.show === 'scene') return sceneCommand(motion);
  const cells = motion.cells === 300 ? '' : ` --cells ${motion.cells}`;
  if (motion.show === 'schedule') {
    if (motion.pause !== undefined) {
      return `signorini continuum ${steps(motion)}${cells} --energy-ratio ${motion.energy} --member ${motion.pause} --state state.csv --format json`;
    }
    const scene = given(' --gap ', motion.gap) + given(' --second-stop ', motion.second_stop) + given(' --energy-ratio ', motion.energy);
    return `signorini find ${steps(motion)}${cells}${scene} --state state.csv --motion motion.csv --format json`;
  }
  if (motion.show === 'mode') {
    return `signorini mode ${motion.contact} ${motion.turns} --period ${motion.period}${cells} --motion motion.csv --format json`;
  }
  if (motion.show === 'polygon') {
    return `signorini modes --phases 2 --max-order ${polygonOrder} --csv polygons.csv --format json` +
      (nearest ? `\nsignorini find ${steps({ phases: nearest })}${cells}  # the nearest motion on ${motion.cells} cells` : '');
  }
  if (motion.show === 'forced') {
    return `signorini find ${steps(motion)}${cells} --damping ${motion.damping} --force ${motion.place} --amplitude ${motion.amplitude} --state state.csv --format json`;
  }
  const start = motion.start.kind === 'rest' ? '--rest' : '--from start.csv';
  const span = motion.steps === undefined ? `--time ${motion.crossings}`
    : `--force ${motion.place} --amplitude ${motion.amplitude} --frequency ${(4 * motion.cells) / motion.steps}${phase ? ` --phase ${phase}` : ''} --periods ${motion.periods}`;
  return `signorini simulate ${start}${cells} --damping ${motion.damping} ${span} --tip tip.csv --events events.csv --format json`;
}

export const sweepCommand = (f: Forcing, isDown: boolean): string =>
  `signorini sweep --damping ${f.damping} --force ${f.place} --amplitude ${f.amplitude} --from ${f.least} --to ${f.most} --points 60 --periods 200 --cells ${f.cells} --${isDown ? 'down' : 'up'} --csv sweep.csv --format json`;

export function responseCommand(f: Forcing): string {
  return `signorini response --damping ${f.damping} --force ${f.place} --amplitude ${f.amplitude} --from ${f.least} --to ${f.most} --cells ${f.cells} --stability --csv response.csv --format json`;
}

export function pythonOf(motion: Motion, nearest?: Phases): string {
  if (motion.show === 'scene') return scenePython(motion);
  const cells = motion.cells === 300 ? '' : `, cells=${motion.cells}`;
  const head = 'import signorini\n';
  if (motion.show === 'schedule') {
    if (motion.pause !== undefined) {
      return `${head}member = signorini.continuum(${argumentsOf(motion)}, energy_ratio=${motion.energy}${cells}).member(${motion.pause})`;
    }
    const scene = given(', gap=', motion.gap) + given(', second_stop=', motion.second_stop) + given(', energy_ratio=', motion.energy);
    return `${head}result = signorini.find(${argumentsOf(motion)}${scene}${cells})`;
  }
  if (motion.show === 'mode') {
    return `${head}motion = signorini.mode(${motion.contact}, ${motion.turns}, ${motion.period})`;
  }
  if (motion.show === 'polygon') {
    return nearest ? `${head}result = signorini.find(${argumentsOf({ phases: nearest })}${cells})` : `# no motion of these contacts has a period of whole steps on ${motion.cells} cells near this one`;
  }
  if (motion.show === 'forced') {
    return `${head}result = signorini.find(${argumentsOf(motion)}${cells}, damping=${motion.damping}, force="${motion.place}", amplitude=${motion.amplitude})`;
  }
  const start = motion.start.kind === 'rest' ? '' : '"start.csv", ';
  const span = motion.steps === undefined ? `time=${motion.crossings}`
    : `force="${motion.place}", amplitude=${motion.amplitude}, frequency=${(4 * motion.cells) / motion.steps}, periods=${motion.periods}`;
  return `${head}bar = signorini.simulate(${start}damping=${motion.damping}, ${span}${cells})`;
}

export interface FileOffer { label: string; name: string; file: string }

/** The files of a motion: what the button says, which one the library writes, and its name. */
export function filesOf(motion: Motion): FileOffer[] {
  const json = (what: string): FileOffer => ({ label: 'JSON', name: `${what}.json`, file: 'answer.json' });
  if (motion.show === 'schedule') {
    return [json('schedule'), { label: 'State (CSV)', name: 'schedule.state', file: 'state.csv' },
      ...(motion.pause === undefined ? [{ label: 'Motion (CSV)', name: 'schedule.motion', file: 'motion.csv' }]
        : [{ label: 'Continuum (CSV)', name: 'schedule.continuum', file: 'continuum.csv' }])];
  }
  if (motion.show === 'polygon') {
    return [json('polygons'), { label: 'Polygons (CSV)', name: 'polygons.csv', file: 'polygons.csv' },
      { label: 'Motion (CSV)', name: 'polygon.motion', file: 'motion.csv' }];
  }
  if (motion.show === 'scene') return [];
  if (motion.show === 'mode') return [json('mode'), { label: 'Motion (CSV)', name: 'mode.motion', file: 'motion.csv' }];
  if (motion.show === 'forced') return [json('forced'), { label: 'State (CSV)', name: 'forced.state', file: 'state.csv' }];
  return [json('simulation'),
    ...(motion.start.kind !== 'rest' ? [{ label: 'Start (CSV)', name: 'simulation.start', file: 'start.csv' }] : []),
    { label: 'Tip (CSV)', name: 'simulation.tip', file: 'tip.csv' },
    { label: 'Contacts (CSV)', name: 'simulation.events', file: 'events.csv' }];
}

export function save(name: string, content: Blob): void {
  const link = document.createElement('a');
  link.href = URL.createObjectURL(content);
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10_000);
}
