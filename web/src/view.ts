// What is on the screen, as a link: every choice of the reader and nothing else.

import type { Chain, Motion, Phases, Place, Start } from './core';
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

/** Of a link all but how and when one looks. */
export const whatOf = (link: string): string => link.replace(/&(magnified|pace|time|units)=[^&]*/g, '');

const mostLetters = 60;

/** A word of a stranger, to be quoted. */
const shortened = (text: string): string => (text.length > mostLetters ? `${text.slice(0, mostLetters)}…` : text);

/** NaN for what is no number in full: no empty word, no other base than ten; and no -0. */
const numberIn = (text: string | undefined): number => (/^[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?$/i.test(text ?? '') ? Number(text) + 0 : NaN);

function wrong(): never {
  throw new Error('no word of this kind');
}
const finite = (value: number): number => (Number.isFinite(value) ? value : wrong());

const allowedPhases = 'contact:free steps, such as 150:900, with L: before those at a second stop';

/** "75:375, L:75:375". */
function phasesOf(text: string): Phases {
  return text.split(',').map((word) => {
    const found = /^\s*(L:)?(\d{1,9}):(\d{1,9})\s*$/.exec(word);
    if (!found || Number(found[2]) < 1 || Number(found[3]) < 1) {
      throw new Error(`phases = “${shortened(text)}”: allowed ${allowedPhases}`);
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

/** A value of a motion as a word of a link, and back; no text: it is left out. */
interface Kind<T> { write: (value: T) => string; read: (text: string) => T; allowed: string }

const number: Kind<number> = { write: String, read: (text) => finite(numberIn(text)), allowed: 'finite numbers' };
const text: Kind<string> = { write: String, read: String, allowed: 'words' };
const phases: Kind<Phases> = { write: phasesAsText, read: phasesOf, allowed: allowedPhases };
const chains: Kind<Chain[]> = {
  write: (all) => all.map((chain) => chain.join(':')).join(','),
  read: (all) => all.split(',').map((row) => {
    const [jumps, turns, release, ...more] = row.split(':').map((part) => finite(numberIn(part)));
    return more.length === 0 && release !== undefined ? [jumps, turns, release] : wrong();
  }),
  allowed: 'jumps:turns:release of each contact, such as 2:1:2,2:2:1',
};
const start: Kind<Start> = {
  write: (from) => (from.kind === 'rest' ? 'rest' : from.kind === 'pluck' ? `${from.place}:${from.displacement}` : `beside:${from.share}`),
  read: (word) => {
    if (word === 'rest') return { kind: 'rest' };
    const [place, displacement, ...more] = word.split(':');
    const last = more.length > 0 ? wrong() : finite(numberIn(displacement));
    return place === 'beside' ? { kind: 'beside', share: last } : { kind: 'pluck', place: finite(numberIn(place)), displacement: last };
  },
  allowed: 'rest, or place:displacement such as 1:-3',
};
const hands: Kind<number[]> = {
  write: (all) => all.join(':'),
  read: (all) => all.split(':').map((hand) => finite(numberIn(hand))),
  allowed: 'numbers, one for each bar',
};

/** Words of a link, in their order: name there (with ? where it may be missing), name in the question, kind. How large a number may be says the library. */
type Field = [string, string, Kind<any>];
const same = (names: string, kind: Kind<any> = number): Field[] => names.split(' ').map((name) => [name, name.replace('?', ''), kind]);
const fields: Record<Motion['show'], Field[]> = {
  schedule: [...same('cells'), ...same('phases', phases), ...same('energy? pause? gap? second_stop?')],
  mode: same('cells contact turns period'),
  polygon: [...same('cells'), ...same('chains', chains), ...same('period split')],
  forced: [...same('cells'), ...same('phases', phases), ...same('which')],
  simulation: [...same('cells'), ...same('start', start), ...same('phases?', phases), ...same('which?'), ['dashpot', 'damping', number], ...same('crossings? steps? periods? from span')],
  scene: [...same('words', text), ...same('hands?', hands), ['gravity?', 'gravity', number], ['force?', 'amplitude', number], ['ratio?', 'frequency', number], ...same('from span')],
};

const isForced = (m: Motion): boolean => m.show === 'forced' || (m.show === 'simulation' && m.steps !== undefined);

/** The part of the address behind #. */
export function asLink(view: View): string {
  const { motion, forcing: { cells: grid, ...forcing } } = view;
  const values = motion as unknown as Record<string, unknown>;
  const words: unknown[][] = [['show', motion.show],
    ...fields[motion.show].flatMap(([name, key, kind]) => (values[key] === undefined ? [] : [[name.replace('?', ''), kind.write(values[key])]])), ['map', view.map],
    ...(view.map === 'response' || isForced(motion) ? Object.entries({ damping: forcing.damping, place: forcing.place, amplitude: forcing.amplitude, grid, least: forcing.least, most: forcing.most }) : []),
    ['magnified', view.magnified], ['pace', view.pace], ['time', Number(view.time.toFixed(4))], ['units', view.units === 'si' ? 'si' : '']];
  const some = words.map(([name, value]) => [String(name), String(value)]).filter(([, value]) => value !== '');
  return new URLSearchParams(some).toString().replaceAll('%3A', ':').replaceAll('%2C', ',');
}

class Words {
  private readonly known = new Set<string>();

  constructor(private readonly words: URLSearchParams) {}

  has(name: string): boolean {
    this.known.add(name);
    return this.words.has(name);
  }
  /** Names that nobody asked for, or that are there twice. */
  left(): string[] {
    const names = [...this.words.keys()];
    return [...new Set(names)].filter((name) => !this.known.has(name) || names.indexOf(name) < names.lastIndexOf(name));
  }
  read<T>(name: string, kind: Kind<T>): T {
    this.known.add(name);
    const word = this.words.get(name) ?? '';
    try {
      return kind.read(word);
    } catch {
      throw new Error(`${name} = “${shortened(word)}”: allowed ${kind.allowed}`);
    }
  }
  number(name: string, low: number, high: number): number {
    const read = (word: string): number => {
      const value = numberIn(word);
      return value >= low && value <= high ? value : wrong();
    };
    return this.read(name, { ...number, read, allowed: `numbers ${low} to ${high}` });
  }
  oneOf<Word extends string>(name: string, allowed: readonly Word[]): Word {
    const read = (word: string): Word => allowed.find((one) => one === word) ?? wrong();
    return this.read(name, { write: String, read, allowed: allowed.join(', ') });
  }
}

function motionOf(words: Words, { damping, place, amplitude }: Forcing): Motion {
  const show = words.oneOf('show', Object.keys(fields) as Motion['show'][]);
  const read = fields[show].filter(([name]) => !name.endsWith('?') || words.has(name.slice(0, -1)));
  const values = Object.fromEntries(read.map(([name, key, kind]) => [key, words.read(name.replace('?', ''), kind)]));
  if (values.energy === undefined) delete values.pause;
  const motion = { show, ...(show === 'scene' ? { hands: [] } : show === 'simulation' ? { frames: 60 } : {}), ...values } as Motion;
  return isForced(motion) ? { damping, ...motion, place, amplitude } as Motion : motion;
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
    if (words.has('place')) view.forcing.place = words.oneOf('place', ['tip', 'base'] as const);
    for (const [name, key] of [['damping', 'damping'], ['amplitude', 'amplitude'], ['grid', 'cells'], ['least', 'least'], ['most', 'most']] as const) {
      if (words.has(name)) view.forcing[key] = words.read(name, number);
    }
    if (words.has('show')) view.motion = motionOf(words, view.forcing);
    const left = words.left();
    return left.length === 0 ? { view } : { view, fault: passedOver(left) };
  } catch (fault) {
    return {
      view: structuredClone(usual),
      fault: `The link could not be followed: ${(fault as Error).message}. The paper's case is shown instead.`,
    };
  }
}
