// What is on the screen, as a link: every choice of the reader and nothing else.

import type { Chain, Motion, Phases, Place, SceneMotion, Start } from './core';
import type { System } from './units';

export const maps = ['energy', 'existence', 'contacts', 'response'] as const;
export type MapKind = (typeof maps)[number];

/** Of the excitation: damping ratio, place, amplitude [N or m], grid and frequencies of its map. */
export interface Forcing {
  damping: number; place: Place; amplitude: number; cells: number; least: number; most: number;
}

export interface View {
  motion: Motion;
  map: MapKind;
  forcing: Forcing;
  magnified: number;  // displacements are drawn so many times larger
  pace: number;       // L/c of motion in a second of the reader's
  time: number;       // share of the period, where the cursor stands
  units: System;
}

export const paperCase: Motion = { show: 'schedule', cells: 300, phases: [[150, 900]] };

export const usual: View = {
  motion: paperCase,
  map: 'energy',
  forcing: { damping: 0.02, place: 'tip', amplitude: 2e-4, cells: 60, least: 0.8, most: 1.4 },
  magnified: 100,
  pace: 0.5,
  time: 0,
  units: 'scaled',
};

export const phasesAsText = (phases: Phases): string =>
  phases.map(([contact, free, stop]) => `${stop ? 'L:' : ''}${contact}:${free}`).join(',');

type Word = string | number | undefined;

/** The words of a motion in a link. */
function wordsOf(m: Motion): Record<string, Word> {
  switch (m.show) {
    case 'schedule': return { phases: phasesAsText(m.phases), energy: m.energy, pause: m.pause, gap: m.gap, second_stop: m.second_stop };
    case 'mode': return { contact: m.contact, turns: m.turns, period: m.period };
    case 'polygon': return { chains: m.chains.map((chain) => chain.join(':')).join(','), period: m.period, split: m.split };
    case 'forced': return { phases: phasesAsText(m.phases), which: m.which };
    case 'simulation': return {
      start: m.start.kind === 'rest' ? 'rest' : m.start.kind === 'pluck' ? `${m.start.place}:${m.start.displacement}` : `beside:${m.start.share}`,
      phases: m.phases && phasesAsText(m.phases), which: m.which,
      dashpot: m.damping, crossings: m.crossings, steps: m.steps, periods: m.periods, from: m.from, span: m.span,
    };
    case 'scene': return {
      words: m.words, hands: m.hands.some((hand) => hand !== 0) ? m.hands.join(':') : undefined, gravity: m.gravity,
      force: m.amplitude, ratio: m.frequency, from: m.from, span: m.span,
    };
  }
}

/** The part of the address behind #. */
export function asLink(view: View): string {
  const m = view.motion;
  const { cells: grid, ...f } = view.forcing;
  const isForced = view.map === 'response' || m.show === 'forced' || (m.show === 'simulation' && m.steps !== undefined);
  const all: Record<string, Word> = {
    show: m.show, cells: m.show === 'scene' ? undefined : m.cells, ...wordsOf(m), map: view.map,
    ...(isForced ? { damping: f.damping, place: f.place, amplitude: f.amplitude, grid, least: f.least, most: f.most } : {}),
    magnified: view.magnified, pace: view.pace, time: Number(view.time.toFixed(4)),
    units: view.units === 'si' ? 'si' : undefined,
  };
  const words = new URLSearchParams(Object.entries(all).flatMap(([name, value]) => (value === undefined ? [] : [[name, String(value)]])));
  return words.toString().replaceAll('%3A', ':').replaceAll('%2C', ',');
}

/** Of a link all but how and when one looks. */
export const whatOf = (link: string): string => link.replace(/&(magnified|pace|time|units)=[^&]*/g, '');

const mostLetters = 60;

/** A word of a stranger, to be quoted. */
const shortened = (text: string): string => (text.length > mostLetters ? `${text.slice(0, mostLetters)}…` : text);

/** NaN for what is no number in full: no empty word, no other base than ten; and no -0. */
const numberIn = (text: string | undefined): number => (/^[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?$/i.test(text ?? '') ? Number(text) + 0 : NaN);

/** "75:375, L:75:375". */
export function phasesOf(text: string): Phases {
  return text.split(',').map((word) => {
    const found = /^\s*(L:)?(\d{1,9}):(\d{1,9})\s*$/.exec(word);
    if (!found || Number(found[2]) < 1 || Number(found[3]) < 1) {
      throw new Error(`phases = “${shortened(text)}”: allowed contact:free steps, such as 150:900, with L: before those at a second stop`);
    }
    return [Number(found[2]), Number(found[3]), ...(found[1] ? ['L' as const] : [])] as Phases[number];
  });
}

/** The same as people type it: "150 900", "(75, 375) L:(75, 375)", "75:375, L:75:375". */
export function typedPhases(text: string): Phases {
  const words = text.replace(/[(),;]/g, ' ').replace(/\s*:\s*/g, ':').trim();
  if (!/^((L:)?\d+[\s:]+\d+(\s+|$))+$/.test(words)) return phasesOf(text);
  return phasesOf([...words.matchAll(/(L:)?(\d+)[\s:]+(\d+)/g)].map(([, stop, contact, free]) => `${stop ?? ''}${contact}:${free}`).join(','));
}

class Words {
  private readonly known = new Set<string>();

  constructor(private readonly words: URLSearchParams) {}

  has(name: string): boolean {
    this.known.add(name);
    return this.words.has(name);
  }
  text(name: string): string {
    this.known.add(name);
    return this.words.get(name) ?? '';
  }
  /** Names that nobody asked for, or that are there twice. */
  left(): string[] {
    const names = [...this.words.keys()];
    return [...new Set(names)].filter((name) => !this.known.has(name) || names.indexOf(name) < names.lastIndexOf(name));
  }
  number(name: string, low: number, high: number): number {
    const text = this.text(name);
    const value = numberIn(text);
    if (!(value >= low && value <= high)) {
      throw new Error(`${name} = “${shortened(text)}”: allowed numbers ${low} to ${high}`);
    }
    return value;
  }
  whole(name: string, low: number, high: number): number {
    const value = this.number(name, low, high);
    if (!Number.isInteger(value)) {
      throw new Error(`${name} = “${shortened(this.text(name))}”: allowed whole numbers ${low} to ${high}`);
    }
    return value;
  }
  oneOf<Word extends string>(name: string, allowed: readonly Word[]): Word {
    const found = allowed.find((word) => word === this.text(name));
    if (!found) throw new Error(`${name} = “${shortened(this.text(name))}”: allowed ${allowed.join(', ')}`);
    return found;
  }
  phases(): Phases { return phasesOf(this.text('phases')); }
  chains(): Chain[] {
    const text = this.text('chains');
    return text.split(',').map((row) => {
      const numbers = row.split(':').map(numberIn);
      if (numbers.length !== 3 || !numbers.every((n) => Number.isSafeInteger(n) && n >= 0)) {
        throw new Error(`chains = “${shortened(text)}”: allowed jumps:turns:release of each contact, such as 2:1:2,2:2:1`);
      }
      return [numbers[0], numbers[1], numbers[2]];
    });
  }
  start(): Start {
    const text = this.text('start');
    if (text === 'rest') return { kind: 'rest' };
    const parts = text.split(':');
    const [place, displacement] = parts.map(numberIn);
    if (parts.length === 2 && parts[0] === 'beside' && displacement >= 0.5 && displacement <= 1) return { kind: 'beside', share: displacement };
    if (parts.length !== 2 || !(place >= 0.05 && place <= 1 && displacement >= -20 && displacement <= 1)) {
      throw new Error(`start = “${shortened(text)}”: allowed rest, or place:displacement such as 1:-3`);
    }
    return { kind: 'pluck', place, displacement };
  }
  scene(): SceneMotion {
    const words = this.text('words');
    if (words.length > 2000 || !/^[a-z0-9=:.+ -]+$/i.test(words)) throw new Error(`words = “${shortened(words)}”: allowed parts of a scene, such as clamp 150 gap=1e-3 200 clamp`);
    const hands = this.has('hands') ? this.text('hands').split(':').map(numberIn) : [];
    if (hands.length > 100 || hands.some((hand) => !(Math.abs(hand) <= 100))) throw new Error(`hands = “${shortened(this.text('hands'))}”: allowed numbers -100 to 100, one for each bar`);
    const motion: SceneMotion = { show: 'scene', words, hands: hands.some((hand) => hand !== 0) ? hands : [], from: this.number('from', 0, 1e4), span: this.number('span', 0.1, 200) };
    if (this.has('gravity')) motion.gravity = this.number('gravity', -10, 10);
    if (this.has('force')) {
      motion.amplitude = this.number('force', 1e-9, 10);
      motion.frequency = this.number('ratio', 0.01, 100);
    }
    return motion;
  }
}

export const mostCells = 5000;

function motionOf(words: Words, forcing: Forcing): Motion {
  const show = words.oneOf('show', ['schedule', 'mode', 'polygon', 'forced', 'simulation', 'scene'] as const);
  if (show === 'scene') return words.scene();
  const cells = words.whole('cells', 2, mostCells);
  const some = <T>(name: string, read: () => T): T | undefined => (words.has(name) ? read() : undefined);
  if (show === 'schedule') {
    const motion: Motion = { show, cells, phases: words.phases() };
    const gap = some('gap', () => words.number('gap', -0.1, 0.1));
    const stop = some('second_stop', () => words.number('second_stop', 1e-6, 0.1));
    if (gap !== undefined) motion.gap = gap;
    if (stop !== undefined) motion.second_stop = stop;
    const energy = some('energy', () => words.number('energy', 1e-9, 1e9));
    const pause = some('pause', () => words.number('pause', 0, 1e9));
    if (energy !== undefined) motion.energy = energy;
    if (pause !== undefined && energy !== undefined) motion.pause = pause;
    return motion;
  }
  if (show === 'mode') {
    return {
      show, cells, contact: words.whole('contact', 4, 40004), turns: words.whole('turns', -10001, -1),
      period: words.number('period', 1e-6, 4),
    };
  }
  if (show === 'polygon') {
    return { show, cells, chains: words.chains(), period: words.number('period', 1e-6, 8), split: words.number('split', 0.001, 0.999) };
  }
  if (show === 'forced') {
    const { damping, place, amplitude } = forcing;
    return { show, cells, phases: words.phases(), damping, place, amplitude, which: words.whole('which', 0, 1) };
  }
  const simulation: Motion = {
    show, cells, start: words.start(), damping: words.number('dashpot', 0, 1),
    from: words.number('from', 0, 1e6), span: words.number('span', 0.1, 100), frames: 60,
  };
  if (words.has('steps')) {
    simulation.steps = words.whole('steps', 3, 100 * cells);
    simulation.periods = words.whole('periods', 1, 2000);
    simulation.place = forcing.place;
    simulation.amplitude = forcing.amplitude;
    if (simulation.start.kind === 'beside') Object.assign(simulation, { phases: words.phases(), which: words.whole('which', 0, 1) });
  } else {
    if (simulation.start.kind === 'beside') throw new Error(`start = “${simulation.start.kind}”: allowed only with a forced motion, with steps and periods`);
    simulation.crossings = words.number('crossings', 0.1, 1000);
  }
  return simulation;
}

/** What of a link was passed over, as a sentence. */
function passedOver(names: string[]): string {
  const listed = names.slice(0, 5).map((name) => `“${shortened(name)}”`).join(', ');
  return `Of the link this was ignored, as it is unknown here or there twice: ${listed}${names.length > 5 ? ', …' : ''}.`;
}

/** The view of a link, and a sentence where a part of it was not understood. */
export function fromLink(link: string): { view: View; fault?: string } {
  const words = new Words(new URLSearchParams(link.replace(/^#/, '')));
  const view: View = structuredClone(usual);
  try {
    const read = <Key extends 'magnified' | 'pace' | 'time'>(key: Key, low: number, high: number): void => {
      if (words.has(key)) view[key] = words.number(key, low, high);
    };
    read('magnified', 1, 1000);
    read('pace', 0.01, 10);
    read('time', 0, 1);
    if (words.has('units')) view.units = words.oneOf('units', ['scaled', 'si'] as const);
    if (words.has('map')) view.map = words.oneOf('map', maps);
    const f = view.forcing;
    if (words.has('damping')) f.damping = words.number('damping', 1e-4, 1);
    if (words.has('place')) f.place = words.oneOf('place', ['tip', 'base'] as const);
    if (words.has('amplitude')) f.amplitude = words.number('amplitude', 1e-9, 10);
    if (words.has('grid')) f.cells = words.whole('grid', 4, mostCells);
    if (words.has('least')) f.least = words.number('least', 0.1, 10);
    f.most = words.has('most') ? words.number('most', f.least, 10) : Math.max(f.least, f.most);
    if (words.has('show')) view.motion = motionOf(words, f);
    const left = words.left();
    return left.length === 0 ? { view } : { view, fault: passedOver(left) };
  } catch (fault) {
    return {
      view: structuredClone(usual),
      fault: `The link could not be followed: ${(fault as Error).message}. The paper's case is shown instead.`,
    };
  }
}
