// What the reader takes along: the command and the Python line of the same motion, files, pictures.

import type { ForcedMotion, Motion, Phase, Phases, SceneMotion, ScheduleMotion, Simulation } from './core';
import type { Forcing } from './view';

type Value = string | number | number[] | undefined;

/** A question with the options that the command line and Python share; "note" is of the hands of a scene. */
interface Call { name: 'find' | 'continuum' | 'simulate'; phases?: Phases; options: Record<string, Value>; note?: string }

const givenOf = (options: Record<string, Value>): [string, Value][] => Object.entries(options).filter(([, value]) => value !== undefined);

const asCommand = ({ name, phases = [], options }: Call): string =>
  [`signorini ${name}`, ...phases.map(([contact, free, stop]) => `${stop ? 'L:' : ''}${contact} ${free}`),
    ...givenOf(options).map(([option, value]) => `--${option.replace('_', '-')} ${option === 'scene' ? `"${value}"` : value}`)].join(' ');

function asPython({ name, phases = [], options }: Call, ...before: string[]): string {
  const isPlain = phases.every((phase) => !phase[2]);
  const one = ([contact, free, stop]: Phase): string => (isPlain ? `${contact}, ${free}` : `(${contact}, ${free}${stop ? ', "left"' : ''})`);
  const written = (value: Value): string => (typeof value === 'string' ? `"${value}"` : Array.isArray(value) ? `[${value}]` : String(value));
  return `signorini.${name}(${[...before, ...phases.map(one), ...givenOf(options).map(([option, value]) => `${option}=${written(value)}`)].join(', ')})`;
}

const cellsOf = ({ cells }: { cells: number }): number | undefined => (cells === 300 ? undefined : cells);

/** Types of two contacts are listed up to this order. */
export const polygonOrder = 9;

/** Speeds of the bars [m/s] where the hands do anything; of one that is held they say something else there. */
function sceneCall({ words, hands, gravity, amplitude, frequency, from, span }: SceneMotion): Call {
  const isThrown = hands.some((hand) => hand !== 0);
  return { name: 'simulate',
    options: { scene: words.trim(), velocity: isThrown ? hands.map((hand) => Number((hand * 1e-3).toPrecision(6))) : undefined, gravity,
      force: amplitude === undefined ? undefined : /\bdriven\b/.test(words) ? 'tip' : 'base', amplitude, frequency, time: from + span },
    ...(isThrown ? { note: '  # where all bars fly; one that is held starts at rest there, here it is pulled' } : {}) };
}

/** What the command line and Python are asked for the same motion. */
function callOf(motion: ScheduleMotion | ForcedMotion | Simulation | SceneMotion, phase: number): Call {
  if (motion.show === 'scene') return sceneCall(motion);
  const cells = cellsOf(motion);
  if (motion.show === 'schedule') {
    const { phases, gap, second_stop, energy: energy_ratio, pause } = motion;
    return { name: pause === undefined ? 'find' : 'continuum', phases, options: { cells, gap, second_stop, energy_ratio } };
  }
  const { damping, place: force, amplitude } = motion;
  if (motion.show === 'forced') return { name: 'find', phases: motion.phases, options: { cells, damping, force, amplitude } };
  const { steps, periods, crossings: time } = motion;
  return { name: 'simulate', options: { cells, damping, ...(steps === undefined ? { time } : { force, amplitude, frequency: (4 * motion.cells) / steps, phase: phase || undefined, periods }) } };
}

/** The command that gives the same motion, as the command line writes its JSON. */
export function commandOf(motion: Motion, nearest?: Phases, phase = 0): string {
  if (motion.show === 'mode') {
    return `signorini mode ${motion.contact} ${motion.turns} --period ${motion.period}${motion.cells === 300 ? '' : ` --cells ${motion.cells}`} --motion motion.csv --format json`;
  }
  if (motion.show === 'polygon') {
    return `signorini modes --phases 2 --max-order ${polygonOrder} --csv polygons.csv --format json` +
      (nearest ? `\n${asCommand({ name: 'find', phases: nearest, options: { cells: cellsOf(motion) } })}  # the nearest motion on ${motion.cells} cells` : '');
  }
  const call = callOf(motion, phase);
  const more = motion.show === 'scene' ? '' : motion.show === 'forced' ? ' --state state.csv'
    : motion.show === 'simulation' ? ` ${motion.start.kind === 'rest' ? '--rest' : '--from start.csv'} --tip tip.csv --events events.csv`
      : motion.pause === undefined ? ' --state state.csv --motion motion.csv' : ` --member ${motion.pause} --state state.csv`;
  return `${asCommand(call)}${more} --format json${call.note ?? ''}`;
}

export const sweepCommand = (f: Forcing, isDown: boolean): string =>
  `signorini sweep --damping ${f.damping} --force ${f.place} --amplitude ${f.amplitude} --from ${f.least} --to ${f.most} --points 60 --periods 200 --cells ${f.cells} --${isDown ? 'down' : 'up'} --csv sweep.csv --format json`;

export function responseCommand(f: Forcing): string {
  return `signorini response --damping ${f.damping} --force ${f.place} --amplitude ${f.amplitude} --from ${f.least} --to ${f.most} --cells ${f.cells} --stability --csv response.csv --format json`;
}

export function pythonOf(motion: Motion, nearest?: Phases, phase = 0): string {
  const head = 'import signorini\n';
  if (motion.show === 'mode') return `${head}motion = signorini.mode(${motion.contact}, ${motion.turns}, ${motion.period})`;
  if (motion.show === 'polygon') {
    return nearest ? `${head}result = ${asPython({ name: 'find', phases: nearest, options: { cells: cellsOf(motion) } })}`
      : `# no motion of these contacts has a period of whole steps on ${motion.cells} cells near this one`;
  }
  const call = callOf(motion, phase);
  if (motion.show === 'scene') return `${head}bars = ${asPython(call)}${call.note ?? ''}`;
  if (motion.show === 'simulation') return `${head}bar = ${asPython(call, ...(motion.start.kind === 'rest' ? [] : ['"start.csv"']))}`;
  return motion.show === 'schedule' && motion.pause !== undefined ? `${head}member = ${asPython(call)}.member(${motion.pause})` : `${head}result = ${asPython(call)}`;
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
