// What is said of a motion: a headline, what is proved, computed and assumed.

import type { Answer, Motion } from './core';
import { byId, counted, fill, shown } from './dom';
import { unitOf, withUnit, type Quantity } from './units';
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
      return `${name} on ${motion.cells} cells, shaken at ${withUnit('frequency', a.frequency_ratio)}: impulse ${withUnit('impulse', one.impulse / 1e-3, 5)} in a period.`;
    }
    return `${name} on ${motion.cells} cells: T = ${withUnit('time', a.period_ratio)}, ω = ${withUnit('frequency', a.frequency_ratio, 5)}, E = ${a.energy_ratio === null ? `${shown(a.energy)} J` : withUnit('energy', a.energy_ratio)}.`;
  }
  if (motion.show === 'polygon') {
    const [first, , second] = a.stretches as number[];
    return `Two contacts of ${shown(first, 4)} and ${withUnit('time', second, 4)} at T = ${withUnit('time', motion.period, 10)}: ω = ${withUnit('frequency', a.frequency_ratio, 5)}, E = ${withUnit('energy', a.energy_ratio)}.`;
  }
  if (motion.show === 'mode') {
    return `Mode t_c = ${motion.contact} − ${motion.turns === -1 ? '' : -motion.turns}T at T = ${withUnit('time', motion.period, 10)}: contact ${withUnit('time', a.contact_time_ratio)}, E = ${withUnit('energy', a.energy_ratio)}.`;
  }
  if (motion.show === 'scene') {
    const count = (a.contacts as { count: number }[]).map((one) => one.count).join(' + ');
    return `${(answer.json.words as string).trim()}: ${count} contacts in ${withUnit('time', a.time, 4)}, ${a.events} events.`;
  }
  const from = motion.start.kind === 'rest' ? 'Started at rest' : motion.start.kind === 'beside' ? `Started ${shown(100 * (1 - motion.start.share), 2)} % away from (${motion.phases![0].slice(0, 2).join(', ')})`
    : `Held at ${withUnit('place', motion.start.place)}, pulled by ${withUnit('displacement', motion.start.displacement)}, let go`;
  const every = a.settled?.periods === 1 ? 'every period' : `every ${a.settled?.periods} periods`;
  const end = a.settled ? ` It settles: ${a.settled.contacts > 0 ? `${counted(a.settled.contacts, 'contact')} ${every}` : `clear of the wall, the same ${every}`}.`
    : motion.steps !== undefined ? ' It has not settled.' : '';
  return `${from}: ${counted(a.contacts, 'contact')} in ${withUnit('time', a.time_ratio)}.${end}`;
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
    if (a.energy_ratio_range?.[1]) list.push(`Their energies are all from ${withUnit('energy', a.energy_ratio_range[0])} to ${withUnit('energy', a.energy_ratio_range[1])} on this grid.`);
    if (a.energy_section) {
      list.push(`Those of this energy have dimension ${a.energy_section.dimension} and are ${a.energy_section.connected ? 'connected: each can become any other' : `in ${a.energy_section.components} parts`}.`);
    }
    if (a.family) list.push(`It belongs to the family (${a.family.order}, ${a.family.nu}, ${a.family.contact_blocks}), and to no other.`);
    return list;
  }
  if (motion.show === 'mode') {
    const [[p, q], [r, s]] = a.mode.period_range;
    return [`The mode has a motion for every T between ${p}/${q} and ${r}/${s} ${unitOf('time')}, and no other one contact time 4a + bT.`,
      'For irrational T motions with one contact are isolated: no continuum.'];
  }
  if (motion.show === 'polygon') {
    const [[p, q], [r, s]] = a.polytope.period_range;
    const [least, most] = a.first_contact_range as [number, number];
    const where = `Its type (${a.text}) has motions for every T between ${p}/${q} and ${r}/${s} ${unitOf('time')}, with an energy that depends on T alone.`;
    return [where, most > least ? `At this T the first contact may last anything from ${withUnit('time', least, 4)} to ${withUnit('time', most, 4)}; both together always ${withUnit('time', a.contact_time_ratio)}.`
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
  /** A value in the units of the theory; `scale` of them make the SI unit in which it came. */
  const add = (name: string, value: number | null | undefined, what: Quantity, scale = 1): void => {
    if (value !== null && value !== undefined) list.push([name, withUnit(what, value * scale).trim()]);
  };
  const milli = 1e3;  // EA g/L = 1 mN, EA g/c = 1 mN s, g = 1 mm, c g/L = 1 mm/s of the page's bar
  if (motion.show === 'scene') {
    for (const one of a.contacts as Json[]) {
      const name = `Contact ${one.number}, ${one.kind}`;
      list.push([name, counted(one.count, 'time')]);
      add(`${name}: impulse`, one.impulse, 'impulse', milli);
      add(`${name}: peak force`, one.peak_force, 'force', milli);
    }
    if (a.reference.frequency) add('First frequency, contacts open', 4 * a.reference.frequency, 'frequency');
    add('Energy at the end', a.energy / 5e-7, 'energy');
    add('Balance of energy is off by', a.balance.error / 5e-7, 'energy');
    return list;
  }
  add('Period', a.period_ratio, 'time');
  add('Frequency', a.frequency_ratio, 'frequency');
  add('Energy', a.energy_ratio, 'energy');
  const p = a.physical;
  if (p) {
    add('Wall is pressed in a period for', p.contact_time, 'time');
    add('Peak force', p.peak_force, 'force', milli);
    add('Impulse', p.impulse, 'impulse', milli);
    add('Tip meets the wall at', p.approach_speed, 'velocity', milli);
    add('Peak compression', p.peak_compression, 'strain', milli);
    add('Lowest tip', p.tip_lowest, 'displacement', milli);
  }
  if (motion.show === 'schedule') {
    add('Different motions on the curve', answer.json.orbits as number, 'count');
    const residuals = a.residuals as Record<string, number> | null;
    if (residuals) {
      const worst = answer.json.residual ?? Math.max(...Object.values(residuals));
      list.push(['Worst residual', `${shown(worst as number, 2)}, by an independent time-stepping check`]);
    }
  }
  if (motion.show === 'forced' && a.status === 'found') {
    const one = a.motions[Number(answer.json.which)];
    const what = motion.place === 'tip' ? 'force' : 'displacement';
    add('Amplitudes of the schedule from', a.amplitude_range?.[0], what, milli);
    add('to', a.amplitude_range?.[1] ?? Infinity, what, milli);
    list.push(['Phase', `${shown(one.phase)} rad`]);
    add('Peak force', one.peak_force, 'force', milli);
    add('Worst residual', one.residual, 'count');
  }
  if (motion.show === 'simulation') {
    add('Impulse in all', a.impulse, 'impulse', milli);
    if (a.settled) add('Impulse when settled', a.settled.impulse, 'impulse', milli);
    add('Energy at the end', a.energy_ratio, 'energy');
    add('Balance of energy is off by', a.balance.error / 5e-7, 'energy');
    add('Events', a.events, 'count');
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
