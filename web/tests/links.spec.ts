// Untrusted links, without a page: whatever follows #, a view comes of it whose every
// number is allowed, and a sentence where something was passed over. The same in every run.

import { isDeepStrictEqual } from 'node:util';
import { expect, test } from '@playwright/test';
import type { Phases } from '../src/core';
import { pythonOf } from '../src/takeaway';
import { type View, asLink, fromLink, maps, typedPhases, usual, whatOf } from '../src/view';

let seed = 0;
test.beforeEach(() => { seed = 19; });
/** Mulberry32. */
function random(): number {
  seed = (seed + 0x6d2b79f5) | 0;
  let t = Math.imul(seed ^ (seed >>> 15), 1 | seed);
  t = (t + Math.imul(t ^ (t >>> 7), 61 | t)) ^ t;
  return ((t ^ (t >>> 14)) >>> 0) / 2 ** 32;
}
const whole = (low: number, high: number): number => low + Math.floor(random() * (high - low + 1));
const number = (low: number, high: number): number => Math.min(high, Math.max(low, Number((low + random() * (high - low)).toPrecision(whole(1, 17)))));
const oneOf = <T>(list: readonly T[]): T => list[whole(0, list.length - 1)];
const encoded = (text: string): string => encodeURIComponent(text.replace(/[\ud800-\udfff]/g, ''));
const many = <T>(least: number, most: number, make: () => T): T[] => Array.from({ length: whole(least, most) }, make);

const phases = (): Phases => many(1, 3, () => [whole(1, 999), whole(1, 9999), ...(random() < 0.3 ? ['L' as const] : [])] as Phases[number]);

/** Any motion that a link can have. */
function motion(forcing: View['forcing']): View['motion'] {
  const cells = whole(2, 5000);
  const { damping, place, amplitude } = forcing;
  return oneOf([
    () => ({ show: 'schedule' as const, cells, phases: phases(), ...(random() < 0.5 ? { energy: number(1e-9, 1e9), ...(random() < 0.5 ? { pause: number(0, 9) } : {}) } : {}),
      ...(random() < 0.3 ? { gap: number(-0.1, 0.1) } : {}), ...(random() < 0.3 ? { second_stop: number(1e-6, 0.1) } : {}) }),
    () => ({ show: 'mode' as const, cells, contact: whole(4, 40004), turns: whole(-10001, -1), period: number(1e-6, 4) }),
    () => ({ show: 'polygon' as const, cells, period: number(1e-6, 8), split: number(0.001, 0.999),
      chains: many(1, 3, () => [whole(0, 99), whole(0, 99), whole(0, 3)] as [number, number, number]) }),
    () => ({ show: 'forced' as const, cells, phases: phases(), damping, place, amplitude, which: whole(0, 1) }),
    () => ({ show: 'simulation' as const, cells, damping: number(0, 1), from: number(0, 1e6), span: number(0.1, 100), frames: 60,
      start: random() < 0.5 ? { kind: 'rest' as const } : { kind: 'pluck' as const, place: number(0.05, 1), displacement: number(-20, 1) },
      ...(random() < 0.5 ? { crossings: number(0.1, 1000) } : { steps: whole(3, 100 * cells), periods: whole(1, 2000), place, amplitude }) }),
    () => ({ show: 'simulation' as const, cells, damping: number(0, 1), from: number(0, 1e6), span: number(0.1, 100), frames: 60, steps: whole(3, 100 * cells), periods: whole(1, 2000),
      place, amplitude, start: { kind: 'beside' as const, share: number(0.5, 1) }, phases: phases(), which: whole(0, 1) }),
    () => ({ show: 'scene' as const, words: oneOf(['clamp 100 gap=1e-3 140:1.3 clamp', 'stop=-2e-3 200 stop=right:2e-3', 'spring=2 200 dash=.1 stop=1e-3']), from: number(0, 1e4), span: number(0.1, 200),
      hands: random() < 0.5 ? [] : [number(1, 100), number(-100, 100)], ...(random() < 0.5 ? { gravity: number(-10, 10) } : {}),
      ...(random() < 0.5 ? { amplitude: number(1e-9, 10), frequency: number(0.01, 100) } : {}) }),
  ])() as View['motion'];
}

function anyView(): View {
  const least = number(0.1, 5);
  const forcing = { damping: number(1e-4, 1), place: oneOf(['tip', 'base'] as const), amplitude: number(1e-9, 10), cells: whole(4, 5000), least, most: number(least, 10) };
  const view: View = { motion: motion(forcing), map: oneOf(maps), forcing: structuredClone(usual.forcing),
    magnified: number(1, 1000), pace: number(0.01, 10), time: Number(random().toFixed(4)), units: oneOf(['scaled', 'si'] as const) };
  if (view.map === 'response' || view.motion.show === 'forced' || (view.motion.show === 'simulation' && view.motion.steps !== undefined)) view.forcing = forcing;
  return view;
}

const odd = ['', ' ', '0', '-0', '-1', '1', '1.5', 'NaN', 'Infinity', '-Infinity', '1e999', '1e-999', '0x10', '0b1', '1_0', '1,5', '٣', '9'.repeat(400), '1e3', '+2',
  'null', 'undefined', '__proto__', 'constructor', 'toString', '<b>', '%', '%zz', '%E0%A4%A', '\0', '\ud800', '150:900', 'L:1:1', '1:1:', '::', ':', '2:1:2', '2::1', '1:', 'rest', 'beside:0.99', 'clamp', 'si',
  'mode', 'schedule', 'tip', 'x'.repeat(100_000)];
const names = ['show', 'cells', 'phases', 'energy', 'pause', 'gap', 'second_stop', 'contact', 'turns', 'period', 'chains', 'split', 'which', 'start', 'dashpot', 'crossings', 'steps',
  'periods', 'from', 'span', 'words', 'hands', 'gravity', 'force', 'ratio', 'units', 'map', 'damping', 'place', 'amplitude', 'grid', 'least', 'most', 'magnified', 'pace', 'time', 'dance', '__proto__', 'hasOwnProperty', ''];

/** One to three things that happen to links. */
function damaged(link: string): string {
  for (let k = whole(1, 3); k > 0; --k) {
    const words = link.split('&');
    const at = whole(0, words.length - 1);
    const cut = whole(0, link.length);
    link = oneOf([
      () => words.with(at, `${words[at].split('=')[0]}=${oneOf(odd)}`).join('&'),
      () => words.with(at, `${words[at].split('=')[0]}=${encoded(oneOf(odd))}`).join('&'),
      () => words.with(at, `${oneOf(names)}=${words[at].split('=')[1] ?? ''}`).join('&'),
      () => [...words, `${oneOf(names)}=${oneOf(odd)}`].join('&'),
      () => words.toSpliced(at, 1).join('&'),
      () => [...words, words[at]].join('&'),
      () => link.slice(0, cut),
      () => link.slice(0, cut) + String.fromCharCode(whole(0, random() < 0.5 ? 127 : 0xffff)) + link.slice(cut + whole(0, 1)),
      () => link.slice(0, cut) + oneOf(odd) + link.slice(cut),
      () => encoded(link),
    ])();
  }
  return link;
}

/** What only the page knows the ranges of; and that numbers are numbers. How large they may be says the library. */
function requireAllowed({ motion, forcing, ...view }: View): void {
  const inside = (value: number, low: number, high: number): void => {
    if (!(value >= low && value <= high)) throw new Error(`${value} is not in ${low} … ${high}`);
  };
  inside(view.magnified, 1, 1000);
  inside(view.pace, 0.01, 10);
  inside(view.time, 0, 1);
  if (!maps.includes(view.map)) throw new Error(view.map);
  const requireFinite = (value: unknown): void => {
    if (typeof value === 'number' ? !Number.isFinite(value) : value === undefined || value === null) throw new Error(JSON.stringify(motion));
    if (typeof value === 'object') Object.values(value!).forEach(requireFinite);
  };
  requireFinite(motion);
  requireFinite(forcing);
}

test('schedules: blanks, brackets and colons are all understood, nonsense is not', () => {
  for (const text of ['150 900', '150:900', ' (150, 900) ', '150, 900', '150 : 900']) expect(typedPhases(text), text).toEqual([[150, 900]]);
  for (const text of ['75 375 L:75 375', '75:375, L:75:375', '(75, 375) L:(75, 375)']) {
    expect(typedPhases(text), text).toEqual([[75, 375], [75, 375, 'L']]);
  }
  for (const text of ['150', '150 900 3', '3 and 5', '', '150 -900', '1.5 3', '0 3']) expect(() => typedPhases(text), text).toThrow('allowed contact:free');
});

test('take away: the Python line of a member of a continuum names the member', () => {
  expect(pythonOf({ show: 'scene', words: 'clamp 100 driven gap=1e-3 spring=50', hands: [0, 0], amplitude: 4e-4, frequency: 0.9, from: 2, span: 6 }))
    .toBe('import signorini\nbars = signorini.simulate(scene="clamp 100 driven gap=1e-3 spring=50", force="tip", amplitude=0.0004, frequency=0.9, time=8)');
  expect(pythonOf({ show: 'scene', words: '40:2 gap=1e-3 160', hands: [1, 0], gravity: 1, from: 0, span: 6 })).toContain('160", velocity=[0.001,0], gravity=1, time=6)');
  expect(pythonOf({ show: 'schedule', cells: 300, phases: [[150, 900]], energy: 20, pause: 0.25 }))
    .toContain('signorini.continuum(150, 900, energy_ratio=20).member(0.25)');
  expect(pythonOf({ show: 'simulation', cells: 60, start: { kind: 'beside', share: 0.99 }, damping: 0.1, steps: 200, periods: 30, place: 'tip', amplitude: 1e-4, from: 0, span: 16, frames: 60 }, undefined, 0.5))
    .toContain('signorini.simulate("start.csv", cells=60, damping=0.1, force="tip", amplitude=0.0001, frequency=1.2, phase=0.5, periods=30)');
});

test('links: when and how one looks is no other view', () => {
  const view = anyView();
  expect(whatOf(asLink({ ...view, time: 0.5, pace: 3, magnified: 7, units: view.units === 'si' ? 'scaled' : 'si' }))).toBe(whatOf(asLink(view)));
  expect(whatOf(asLink({ ...view, map: view.map === 'energy' ? 'response' : 'energy' }))).not.toBe(whatOf(asLink(view)));
});

test('links: three thousand views come back as they were', () => {
  for (let k = 0; k < 3000; ++k) {
    const view = anyView();
    const link = asLink(view);
    const again = fromLink(`#${link}`);
    if (!isDeepStrictEqual(again, { view })) expect(again, link).toEqual({ view });
  }
});

test('links: twenty thousand damaged ones give a view that is allowed, and a sentence', () => {
  const tally = { followed: 0, ignored: 0, refused: 0 };
  for (let k = 0; k < 20_000; ++k) {
    const link = damaged(asLink(anyView()));
    const { view, fault } = fromLink(link);
    requireAllowed(view);
    const isIgnored = fault?.startsWith('Of the link this was ignored') ?? false;
    ++tally[fault === undefined ? 'followed' : isIgnored ? 'ignored' : 'refused'];
    if (fault === undefined || isIgnored) {
      const again = fromLink(asLink(view));
      if (again.fault !== undefined || asLink(again.view) !== asLink(view) || !isDeepStrictEqual(again.view.motion, view.motion)) {
        expect(again, link.slice(0, 500)).toEqual({ view });
      }
    } else if (!isDeepStrictEqual(view, usual) || !/^The link could not be followed: [a-z_]+ = “[^]*”: allowed /.test(fault!)) {
      expect({ view, fault }, link.slice(0, 500)).toEqual({ view: usual });
    }
    if ((fault ?? '').length > 700) throw new Error(`${fault!.length} letters: ${fault!.slice(0, 500)}`);
  }
  for (const count of Object.values(tally)) expect(count).toBeGreaterThan(500);
});
