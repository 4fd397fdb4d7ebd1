// What is said of a motion: a headline, what is proved, computed and assumed.

import type { Answer, Motion } from './core';
import { byId, counted, fill, shown } from './dom';
import { assumed } from './words';

type Json = Record<string, any>;

const kinds: Record<string, string> = { simplex: 'a simplex', box: 'a box', point: 'a single motion', polytope: 'a polytope', cone: 'a cone' };
const reasons: Record<string, string> = {
  'no-live-class': 'only the bar at rest repeats with this period',
  'contact-sign': 'the same wave would have to push and to pull on the wall',
  penetration: 'the tip would enter the wall in flight, whatever the amplitudes',
  gap: 'the tip cannot be at the wall when contact starts',
  constraints: 'motions of the schedule exist, but none meets the demands',
};

export function headlineOf(motion: Motion, answer: Answer): string {
  const a = answer.json.answer as Json;
  if (motion.show === 'schedule' || motion.show === 'forced') {
    const name = motion.phases.map(([c, f, stop]) => `${stop ? 'L:' : ''}(${c}, ${f})`).join(' ');
    if (a.status !== 'found') {
      return a.status === 'none' ? `No motion follows ${name} on ${motion.cells} cells: ${a.detail ?? reasons[a.reason] ?? a.reason}.`
        : `Undecided: ${a.detail}`;
    }
    if (motion.show === 'forced') {
      const one = a.motions[Number(answer.json.which)];
      return `${name} on ${motion.cells} cells, shaken at ${shown(a.frequency_ratio)} ω₁: impulse ${shown(one.impulse / 1e-3, 5)} EA g/c in a period.`;
    }
    return `${name} on ${motion.cells} cells: T = ${shown(a.period_ratio)} L/c, ω = ${shown(a.frequency_ratio, 5)} ω₁, E = ${a.energy_ratio === null ? `${shown(a.energy)} J` : `${shown(a.energy_ratio)} E₁`}.`;
  }
  if (motion.show === 'polygon') {
    const [first, , second] = a.stretches as number[];
    return `Two contacts of ${shown(first, 4)} and ${shown(second, 4)} L/c at T = ${shown(motion.period, 10)} L/c: ω = ${shown(a.frequency_ratio, 5)} ω₁, E = ${shown(a.energy_ratio)} E₁.`;
  }
  if (motion.show === 'mode') {
    return `Mode t_c = ${motion.contact} − ${motion.turns === -1 ? '' : -motion.turns}T at T = ${shown(motion.period, 10)} L/c: contact ${shown(a.contact_time_ratio)} L/c, E = ${shown(a.energy_ratio)} E₁.`;
  }
  const from = motion.start.kind === 'rest' ? 'Started at rest' : `Held at ${shown(motion.start.place)} L, pulled by ${shown(motion.start.displacement)} g, let go`;
  const every = a.settled?.periods === 1 ? 'every period' : `every ${a.settled?.periods} periods`;
  const end = a.settled ? ` It settles: ${a.settled.contacts > 0 ? `${counted(a.settled.contacts, 'contact')} ${every}` : `clear of the wall, the same ${every}`}.`
    : motion.steps !== undefined ? ' It has not settled.' : '';
  return `${from}: ${counted(a.contacts, 'contact')} in ${shown(a.time_ratio)} L/c.${end}`;
}

function provedOf(motion: Motion, answer: Answer): string[] {
  const a = answer.json.answer as Json;
  if (motion.show === 'schedule') {
    if (a.status === 'none') {
      return [`No motion exists, by a certificate over the paper’s own rows that is checked in ${a.certificate?.kind === 'farkas' ? 'integers' : 'exact numbers'}.`];
    }
    const set = a.solution_set;
    const list = [];
    if (set) {
      list.push(`All motions of this schedule form ${kinds[set.kind] ?? set.kind}${set.dimension > 0 ? ` of ${set.dimension} dimensions` : ''}, in closed form.`);
    }
    if (a.energy_ratio_range?.[1]) list.push(`Their energies are all from ${shown(a.energy_ratio_range[0])} to ${shown(a.energy_ratio_range[1])} E₁ on this grid.`);
    if (a.energy_section) {
      list.push(`Those of this energy have dimension ${a.energy_section.dimension} and are ${a.energy_section.connected ? 'connected: each can become any other' : `in ${a.energy_section.components} parts`}.`);
    }
    if (a.family) list.push(`It belongs to the family (${a.family.order}, ${a.family.nu}, ${a.family.contact_blocks}), and to no other.`);
    return list;
  }
  if (motion.show === 'mode') {
    const [[p, q], [r, s]] = a.mode.period_range;
    return [`The mode has a motion for every T between ${p}/${q} and ${r}/${s} L/c, and no other one contact time 4a + bT.`,
      'For irrational T motions with one contact are isolated: no continuum.'];
  }
  if (motion.show === 'polygon') {
    const [[p, q], [r, s]] = a.polytope.period_range;
    const [least, most] = a.first_contact_range as [number, number];
    const where = `Its type (${a.text}) has motions for every T between ${p}/${q} and ${r}/${s} L/c, with an energy that depends on T alone.`;
    return [where, most > least ? `At this T the first contact may last anything from ${shown(least, 4)} to ${shown(most, 4)} L/c; both together always ${shown(a.contact_time_ratio, 6)} L/c.`
      : 'For irrational T they are isolated: nothing can be shared out otherwise.'];
  }
  if (motion.show === 'forced') {
    if (a.status !== 'found') return [a.certificate?.verified ? 'Absence is proved with interval arithmetic.' : 'Nothing.'];
    return [`The forced motions of this schedule are a segment or a ray; at most two have one amplitude. Here ${a.motions.length}.`];
  }
  return ['Each event follows from the one before, exact up to rounding. Nothing is proved about what it settles on.'];
}

function computedOf(motion: Motion, answer: Answer): [string, string][] {
  const a = answer.json.answer as Json;
  const list: [string, string][] = [];
  const add = (name: string, value: number | null | undefined, unit: string): void => {
    if (value !== null && value !== undefined) list.push([name, `${shown(value)} ${unit}`]);
  };
  add('Period', a.period_ratio, 'L/c');
  add('Frequency', a.frequency_ratio, 'ω₁');
  add('Energy', a.energy_ratio, 'E₁');
  const p = a.physical;
  if (p) {
    add('Wall is pressed for', p.contact_time, 's in a period');
    add('Peak force', p.peak_force, 'N');
    add('Impulse', p.impulse, 'N s');
    add('Tip meets the wall at', p.approach_speed, 'm/s');
    add('Peak compression', p.peak_compression, '');
    add('Lowest tip', p.tip_lowest, 'm');
  }
  if (motion.show === 'schedule') {
    add('Different motions on the curve', answer.json.orbits as number, '');
    const residuals = a.residuals as Record<string, number> | null;
    if (residuals) {
      const worst = answer.json.residual ?? Math.max(...Object.values(residuals));
      list.push(['Worst residual', `${shown(worst as number, 2)}, by an independent time-stepping check`]);
    }
  }
  if (motion.show === 'forced' && a.status === 'found') {
    const one = a.motions[Number(answer.json.which)];
    add('Amplitudes of the schedule from', a.amplitude_range?.[0], motion.place === 'tip' ? 'N' : 'm');
    add('to', a.amplitude_range?.[1] ?? Infinity, motion.place === 'tip' ? 'N' : 'm');
    add('Phase', one.phase, 'rad');
    add('Peak force', one.peak_force, 'N');
    add('Worst residual', one.residual, '');
  }
  if (motion.show === 'simulation') {
    add('Impulse in all', a.impulse, 'N s');
    if (a.settled) add('Impulse when settled', a.settled.impulse, 'N s');
    add('Energy at the end', a.energy_ratio, 'E₁');
    add('Balance of energy is off by', a.balance.error, 'J');
    add('Events', a.events, '');
  }
  const { gap = 1e-3, second_stop: stop } = motion.show === 'schedule' ? motion : {};
  list.push(['Bar', `L = 1 m, c = 1 m/s, EA = 1 N, g = ${shown(gap * 1000)} mm${stop === undefined ? (gap === 1e-3 ? ', as the command line has it' : '') : `, second stop at −${shown(stop * 1000)} mm`}`]);
  return list;
}

export function showFacts(motion: Motion, answer: Answer): void {
  byId('headline').textContent = headlineOf(motion, answer);
  fill(byId('proved'), provedOf(motion, answer));
  byId('computed').replaceChildren(...computedOf(motion, answer).flatMap(([name, value]) => [
    Object.assign(document.createElement('dt'), { textContent: name }),
    Object.assign(document.createElement('dd'), { textContent: value }),
  ]));
  fill(byId('assumed'), assumed);
}
