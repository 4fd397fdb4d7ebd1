// One system of units at a time: those of the theory, L = c = g = 1, or SI of the bar of the page and of
// the command line: L = 1 m, c = 1 m/s, EA = 1 N, g = 1 mm.

import { shown } from './dom';

export type System = 'scaled' | 'si';

/** Name in the one system, name and size of that unit in the other. */
const table = {
  time: ['L/c', 's', 1], place: ['L', 'm', 1], displacement: ['g', 'mm', 1], velocity: ['c g/L', 'mm/s', 1], strain: ['g/L', '‰', 1],
  force: ['EA g/L', 'mN', 1], impulse: ['EA g/c', 'mN s', 1], energy: ['E₁', 'µJ', 0.5], frequency: ['ω₁', 'Hz', 0.25], weight: ['c² g/L²', 'mm/s²', 1], count: ['', '', 1],
} as const;

export type Quantity = keyof typeof table;

export const units: { system: System } = { system: 'scaled' };

export const unitOf = (what: Quantity): string => table[what][units.system === 'si' ? 1 : 0];
export const inUnit = (what: Quantity, value: number): number => (units.system === 'si' ? value * table[what][2] : value);
export const withUnit = (what: Quantity, value: number, digits = 6): string => `${shown(inUnit(what, value), digits)} ${unitOf(what)}`;
