// Sliders, lists and buttons: each changes the view and nothing else.

import { Builder, firstScene } from './builder';
import { commandOf, filesOf, polygonOrder, pythonOf, responseCommand, save, sweepCommand } from './takeaway';
import type { ForcedMotion, Motion, Phases, ScheduleMotion, Simulation, Start } from './core';
import { firstPolygon, PolygonControls } from './contacts';
import { byId, input, round, select, shown, slide } from './dom';
import type { Explorer } from './explorer';
import { pictures } from './pictures';
import { SceneControls } from './scene';
import { paperCase, type Forcing, type MapKind } from './view';
import { isShown, listenToTabs } from './side';
import { unitOf, withUnit } from './units';

type Json = Record<string, any>;

const option = (value: string, text: string): HTMLOptionElement => new Option(text, value);

/** "pi", "22/7", "sqrt(10)", "3.3". */
export function periodOf(text: string): number {
  const word = text.trim().toLowerCase().replace('π', 'pi');
  if (word === 'pi') return Math.PI;
  const root = /^sqrt\(?([\d.]+)\)?$/.exec(word);
  if (root) return Math.sqrt(Number(root[1]));
  const quotient = /^([\d.]+)\/([\d.]+)$/.exec(word);
  return quotient ? Number(quotient[1]) / Number(quotient[2]) : word === '' ? NaN : Number(word);
}

export class Controls {
  private start: Start = { kind: 'pluck', place: 1, displacement: -3 };
  private readonly scene: SceneControls;
  private readonly polygon: PolygonControls;
  private readonly builder: Builder;
  private readonly last: Partial<Record<Motion['show'], Motion>> = {};

  constructor(private readonly explorer: Explorer) {
    this.listen();
    listenToTabs((panel) => { if (panel === 'take') this.followTake(this.motion); });
    this.scene = new SceneControls(explorer);
    this.polygon = new PolygonControls(explorer);
    this.builder = new Builder(explorer);
    explorer.onShown = () => this.follow();
  }

  private get motion(): Motion { return this.explorer.view.motion; }
  private get answer(): Json { return (this.explorer.answer?.json.answer ?? {}) as Json; }

  private listen(): void {
    const { explorer } = this;
    for (const radio of document.querySelectorAll<HTMLInputElement>('input[name="map"]')) {
      radio.addEventListener('change', () => explorer.showMap(radio.value as MapKind));
    }
    for (const radio of document.querySelectorAll<HTMLInputElement>('input[name="kind"]')) {
      radio.addEventListener('change', () => this.choose(radio.value as Motion['show']));
    }
    byId('zoom-in').onclick = () => explorer.map.scale(0.7);
    byId('zoom-out').onclick = () => explorer.map.scale(1.43);
    byId('zoom-whole').onclick = () => explorer.map.plot.zoom();
    byId('map-previous').onclick = () => explorer.map.step(this.motion, -1);
    byId('map-next').onclick = () => explorer.map.step(this.motion, 1);
    this.listenSchedule();
    this.listenMode();
    this.listenForcing();
    this.listenPluck();
    slide('time', (share) => {
      explorer.setPlaying(false);
      explorer.setTime(share);
    });
    slide('pace', (power) => {
      explorer.view.pace = round(10 ** power, 3);
      this.labels();
      explorer.keepLink();
    });
    slide('magnified', (power) => {
      explorer.view.magnified = Math.round(10 ** power);
      explorer.bar.magnified = explorer.view.magnified;
      explorer.bar.paint();
      this.labels();
      explorer.keepLink();
    });
    byId('play').onclick = () => explorer.setPlaying(!explorer.isPlaying);
    byId('bar-canvas').addEventListener('keydown', (event) => {
      const step = { ArrowRight: 0.01, ArrowLeft: -0.01 }[event.key];
      if (event.key === ' ') explorer.setPlaying(!explorer.isPlaying);
      else if (step) explorer.setTime((explorer.view.time + step + 1) % 1);
      else return;
      event.preventDefault();
    });
    const scrub = (event: PointerEvent): void => {
      if (event.type === 'pointermove' && event.buttons === 0) return;
      explorer.setPlaying(false);
      explorer.setTime(explorer.surface.shareAt(event.offsetX));
    };
    byId('surface').addEventListener('pointerdown', scrub);
    byId('surface').addEventListener('pointermove', scrub);
  }

  private listenSchedule(): void {
    select('family').onchange = () => {
      const [order, nu, blocks] = select('family').value.split(',').map(Number);
      const family = this.explorer.map.atlas?.families.find((f) => f.order === order && f.nu === nu && f.blocks === blocks);
      if (family) void this.explorer.pick({ kind: 'family', family, energy: family.least });
    };
    slide('energy', (share) => {
      const [least, most] = this.energies()!;
      const { pause: _, energy: __, ...motion } = this.motion as ScheduleMotion;
      void this.explorer.show(share === 0 && motion.gap !== 0 ? motion : { ...motion, energy: Math.min(round(least * (most / least) ** share, 5), most) });
    });
    slide('pause', (share) => {
      const [first, last] = this.explorer.answer!.json.pauses as [number, number];
      void this.explorer.show({ ...(this.motion as ScheduleMotion), pause: Math.min(Math.max(round(first + share * (last - first)), first), last) });
    });
    slide('contact', (contact) => {
      const { pause: _, ...motion } = this.motion as ScheduleMotion;
      const steps = motion.phases[0][0] + motion.phases[0][1];
      void this.explorer.show({ ...motion, phases: [[contact, steps - contact]] });
    });
  }

  /** The energies of the slider: those of the schedule, or of a moderate size where every one is met. */
  private energies(): [number, number] | undefined {
    if ((this.motion as ScheduleMotion).gap === 0) return this.answer.status === 'found' ? [1e-6, 1e-4] : undefined;
    const range = this.answer.energy_ratio_range as [number, number | null] | null | undefined;
    return range?.[1] && range[1] > range[0] ? [range[0], range[1]] : undefined;
  }

  private listenMode(): void {
    const toMode = (period: number): void => {
      const [contact, turns] = select('mode').value.split(',').map(Number);
      void this.explorer.show({ show: 'mode', contact, turns, period, cells: 200 });
    };
    const ends = (): [number, number] => {
      const value = select('mode').value;
      const mode = this.explorer.map.atlas?.modes.find((m) => m.contact.join(',') === value);
      return mode ? [mode.lowest, mode.highest] : [3, 4];
    };
    select('mode').onchange = () => {
      const [low, high] = ends();
      toMode(round(low + 0.6 * (high - low), 8));
    };
    slide('period', (share) => {
      const [low, high] = ends();
      toMode(round(low + (0.002 + 0.996 * share) * (high - low), 8));
    });
    byId<HTMLFormElement>('period-form').onsubmit = (event) => {
      event.preventDefault();
      const period = periodOf(input('period-text').value);
      if (Number.isFinite(period)) toMode(period);
      else this.explorer.say(`T = “${input('period-text').value}”: allowed pi, 22/7, sqrt(10) or a number in ${unitOf('time')}.`);
    };
  }

  private listenForcing(): void {
    const { explorer } = this;
    const changed = (forcing: Partial<Forcing>): void => {
      Object.assign(explorer.view.forcing, forcing);
      explorer.sweeps.clear();
      this.labels();
      if (this.motion.show === 'forced') {
        const { damping, place, amplitude } = explorer.view.forcing;
        void explorer.show({ ...this.motion, damping, place, amplitude });
      }
      void explorer.loadResponse();
      explorer.keepLink();
    };
    slide('damping', (damping) => changed({ damping }));
    slide('amplitude', (amplitude) => changed({ amplitude: round(amplitude / 1000) }));
    select('force-place').onchange = () => changed({ place: select('force-place').value === 'base' ? 'base' : 'tip' });
    select('force-cells').onchange = () => changed({ cells: Number(select('force-cells').value) });
    byId('settle').onclick = () => void explorer.show(this.shaken({ kind: 'rest' }));
  }

  /** Damped and shaken, at the period of the forced motion that was looked at last. */
  private shaken(start: Start = this.start): Simulation {
    const { damping, place, amplitude, cells } = this.explorer.view.forcing;
    const forced = this.last.forced as ForcedMotion | undefined;
    const grid = forced?.cells ?? cells;
    const steps = forced ? forced.phases[0][0] + forced.phases[0][1] : Math.round((4 * grid) / 1.1);
    return { show: 'simulation', cells: grid, start, damping, steps, periods: 300, place, amplitude, from: 0, span: 24, frames: 60 };
  }

  plucked(): Simulation {
    if (input('shaken').checked) return { ...this.shaken(), damping: Number(input('dashpot').value) || this.explorer.view.forcing.damping };
    return { show: 'simulation', cells: 200, start: this.start, damping: Number(input('dashpot').value), crossings: 40, from: 0, span: 16, frames: 60 };
  }

  private listenPluck(): void {
    const { explorer } = this;
    const read = (): void => {
      this.start = { kind: 'pluck', place: Number(input('pluck-place').value), displacement: Number(input('pluck-displacement').value) };
      this.labels();
      explorer.bar.pluck = this.start;
      explorer.bar.paint();
    };
    for (const id of ['pluck-place', 'pluck-displacement']) slide(id, read);
    slide('dashpot', () => this.labels());
    byId('release').onclick = () => void explorer.show(this.plucked());
    byId('look-end').onclick = () => {
      const motion = this.motion as Simulation;
      const end = Number(explorer.answer?.json.end ?? 0);
      void explorer.show({ ...motion, from: motion.from > 0 ? 0 : round(Math.max(end - motion.span, 0), 9) });
    };
    const canvas = byId<HTMLCanvasElement>('bar-canvas');
    let from: { x: number; place: number } | undefined;
    canvas.addEventListener('pointerdown', (event) => {
      if (this.motion.show === 'scene') return;
      const place = explorer.bar.placeOf(event.offsetX);
      if (place < 0.05 || place > 1.3) return;
      from = { x: event.offsetX, place: round(Math.min(Math.max(place, 0.1), 1), 2) };
      canvas.setPointerCapture(event.pointerId);
    });
    canvas.addEventListener('pointermove', (event) => {
      if (!from || Math.abs(event.offsetX - from.x) < 4) return;
      this.start = { kind: 'pluck', place: from.place,
        displacement: round(Math.min(Math.max(explorer.bar.pulledBy(event.offsetX - from.x, from.place), -20), 1), 3) };
      explorer.bar.pluck = this.start;
      explorer.bar.paint();
    });
    const release = (): void => {
      if (from && explorer.bar.pluck) {
        explorer.setPlaying(true);
        void explorer.show(this.plucked());
      }
      from = undefined;
    };
    canvas.addEventListener('pointerup', release);
    canvas.addEventListener('pointercancel', release);
  }

  private choose(kind: Motion['show']): void {
    const known = this.last[kind];
    if (known) return void this.explorer.show(known);
    if (kind === 'schedule') return void this.explorer.show(paperCase);
    if (kind === 'mode') return void this.explorer.show({ show: 'mode', contact: 4, turns: -1, period: Math.PI, cells: 200 });
    if (kind === 'simulation') return void this.explorer.show(this.plucked());
    if (kind === 'scene') return void this.explorer.show(firstScene);
    if (kind === 'polygon') {
      this.explorer.showMap('contacts');
      return void this.explorer.show(firstPolygon);
    }
    const { damping, place, amplitude, cells } = this.explorer.view.forcing;
    this.explorer.showMap('response');
    const point = this.explorer.map.response.findLast((p) => p.stays >= 0 && p.frequency > 1.05);
    if (point) return void this.explorer.pick({ kind: 'response', point });
    void this.explorer.show({ show: 'forced', cells, phases: [[Math.round(0.4 * cells), Math.round(3.2 * cells)]], damping, place, amplitude, which: 1 });
  }

  private labels(): void {
    const { view } = this.explorer;
    const put = (id: string, text: string): void => {
      byId(id).textContent = text;
    };
    put('pace-value', `${withUnit('time', view.pace, 2)} per s`);
    const { drawn } = this.explorer.bar;
    put('magnified-value', `× ${drawn < view.magnified ? `${shown(drawn, 3)} of ` : ''}${view.magnified}`);
    put('damping-value', shown(view.forcing.damping, 3));
    put('amplitude-value', withUnit(view.forcing.place === 'tip' ? 'force' : 'displacement', view.forcing.amplitude * 1000, 4));
    if (this.start.kind === 'pluck') {
      put('pluck-place-value', withUnit('place', this.start.place, 3));
      put('pluck-displacement-value', withUnit('displacement', this.start.displacement, 3));
    }
    put('dashpot-value', shown(Number(input('dashpot').value), 3));
  }

  /**
   * What is shown has changed: sliders, lists, links and files follow. Other answers may come before
   * that to the last question: the kind chosen stays.
   */
  private follow(): void {
    const { asked, view, map, answer } = this.explorer;
    const { motion } = view;
    this.last[motion.show] = motion;
    const check = (name: string, value: string): void => {
      const radio = document.querySelector<HTMLInputElement>(`input[name="${name}"][value="${value}"]`);
      if (radio) radio.checked = true;
    };
    check('kind', asked.show);
    check('map', view.map);
    for (const part of document.querySelectorAll<HTMLElement>('[data-kind]')) part.hidden = part.dataset.kind !== motion.show;
    input('pace').value = String(Math.log10(view.pace));
    input('magnified').value = String(Math.log10(view.magnified));
    input('damping').value = String(view.forcing.damping);
    input('amplitude').value = String(view.forcing.amplitude * 1000);
    select('force-place').value = view.forcing.place;
    select('force-cells').value = String(view.forcing.cells);
    if (map.atlas) this.fillLists();
    if (motion.show === 'schedule') this.followSchedule(motion);
    if (motion.show === 'mode') this.followMode(motion.contact, motion.turns, motion.period);
    if (motion.show === 'polygon') this.polygon.follow(motion);
    if (motion.show === 'scene') this.builder.follow(motion);
    byId('settled-where').hidden = motion.show !== 'simulation' || motion.start.kind !== 'beside';
    if (motion.show === 'simulation') {
      if (motion.start.kind === 'pluck') this.start = motion.start;
      input('dashpot').value = String(motion.damping);
      input('shaken').checked = motion.steps !== undefined;
      byId('look-end').hidden = Number(answer?.json.end ?? 0) <= motion.span;
      byId('look-end').textContent = motion.from > 0 ? 'Look at the beginning' : 'Look at the end';
    }
    if (this.start.kind === 'pluck') {
      input('pluck-place').value = String(this.start.place);
      input('pluck-displacement').value = String(this.start.displacement);
    }
    byId('forcing').hidden = view.map !== 'response' || motion.show === 'scene';
    byId('units').textContent = view.units === 'si' ? 'Scaled units' : 'SI units';
    byId('beside').setAttribute('aria-pressed', String(Boolean(this.explorer.bar.kept)));
    this.labels();
    if (isShown('take')) this.followTake(motion);
  }

  private fillLists(): void {
    const { atlas } = this.explorer.map;
    const families = select('family');
    if (!atlas || families.dataset.units === this.explorer.view.units) return;
    families.dataset.units = this.explorer.view.units;
    families.replaceChildren(option('', 'another one'), ...atlas.families.filter((f) => f.order <= 12).map((f) =>
      option(`${f.order},${f.nu},${f.blocks}`, `(${f.order}, ${f.nu}, ${f.blocks})  T = ${withUnit('time', f.period, 5)}, from ${withUnit('energy', f.least, 5)}`)));
    byId('mode').replaceChildren(...atlas.modes.map((m) =>
      option(m.contact.join(','), `t_c = ${m.contact_text}${m.family ? ` (${m.family})` : ''}`)));
  }

  private followSchedule(motion: ScheduleMotion): void {
    const a = this.answer;
    const family = a.family as Json | null;
    select('family').value = family ? `${family.order},${family.nu},${family.contact_blocks}` : '';
    if (select('family').selectedIndex < 0) select('family').value = '';
    const range = this.energies();
    const energy = input('energy');
    energy.disabled = !range;
    if (range) energy.value = String(Math.log((motion.energy ?? range[0]) / range[0]) / Math.log(range[1] / range[0]));
    byId('energy-value').textContent = motion.gap === 0 ? `${motion.energy} of EA L/2: without a gap there is no E₁` : a.energy_ratio ? `${withUnit('energy', a.energy_ratio)}${motion.energy === undefined ? ' (the least)' : ''}` : '–';
    const pauses = this.explorer.answer?.json.pauses as [number, number] | null | undefined;
    input('pause').disabled = !pauses || pauses[1] <= pauses[0];
    input('pause').value = String(pauses && motion.pause !== undefined ? (motion.pause - pauses[0]) / (pauses[1] - pauses[0]) : 0);
    byId('pause-value').textContent = pauses ? `pause ${withUnit('time', motion.pause ?? pauses[0], 4)}` : motion.phases.length > 1 || motion.gap !== undefined || motion.second_stop !== undefined
      ? 'here with one wall, a gap and one contact only' : 'give it more energy first';
    const contact = input('contact');
    const [nc, nf] = motion.phases[0];
    this.scene.follow(motion);
    contact.disabled = motion.phases.length > 1 || !family || motion.gap !== undefined || motion.second_stop !== undefined;
    if (family) {
      const top = nc - family.offset;
      const classes = family.amplitudes + Math.abs(family.offset);
      contact.min = String(Math.max(1, top - classes + 1));
      contact.max = String(Math.min(nc + nf - 1, top + classes - 1));
    }
    contact.value = String(nc);
    byId('contact-value').textContent = `${nc} of ${nc + nf} steps, ${withUnit('time', nc / motion.cells, 4)}`;
  }

  private followMode(contact: number, turns: number, period: number): void {
    const list = select('mode');
    list.value = `${contact},${turns}`;
    const mode = this.explorer.map.atlas?.modes.find((m) => m.contact[0] === contact && m.contact[1] === turns);
    if (mode) input('period').value = String((period - mode.lowest) / (mode.highest - mode.lowest));
    byId('period-value').textContent = withUnit('time', period, 12);
  }

  private followTake(motion: Motion): void {
    const isResponse = this.explorer.view.map === 'response';
    const nearest = this.explorer.answer?.json.nearest as Phases | undefined;
    const swept = isResponse ? this.explorer.sweeps.last : undefined;
    const phase = motion.show === 'simulation' && motion.start.kind === 'beside' ? Number((this.answer.excitation as Json | null)?.phase ?? 0) : 0;
    byId('command').textContent = [commandOf(motion, nearest, phase), ...(isResponse ? [responseCommand(this.explorer.view.forcing)] : []),
      ...(swept === undefined ? [] : [sweepCommand(this.explorer.view.forcing, swept)])].join('\n');
    byId('python').textContent = pythonOf(motion, nearest, phase);
    const offer = (label: string, act: () => Promise<Blob>, file: string): HTMLButtonElement => {
      const button = Object.assign(document.createElement('button'), { textContent: label });
      button.dataset.file = file;
      button.onclick = () => act().then((content) => save(file, content), (fault: Error) => this.explorer.say(fault.message));
      return button;
    };
    const ask = async (name: string, of: object): Promise<Blob> =>
      new Blob([(await this.explorer.library.ask({ show: 'file', name, of })).json.text as string]);
    const { damping, place, amplitude, cells, least, most } = this.explorer.view.forcing;
    const forcing = { damping, place, amplitude, cells, least, most, stability: true };
    byId('files').replaceChildren(
      ...filesOf(motion).map(({ label, name, file }) => offer(label, () => ask(name, name.startsWith('polygons') ? { order: polygonOrder } : motion), file)),
      ...(isResponse ? [offer('Response (JSON)', () => ask('response.json', forcing), 'response.json'),
        offer('Response (CSV)', () => ask('response.csv', forcing), 'response.csv')] : []),
      ...(swept === undefined ? [] : [offer('Sweep (JSON)', () => ask('sweep.json', this.explorer.sweeps.question(swept)), 'sweep.json'),
        offer('Sweep (CSV)', () => ask('sweep.csv', this.explorer.sweeps.question(swept)), 'sweep.csv')]),
      offer('Families (CSV)', () => ask('families.csv', { order: 12 }), 'families.csv'));
    byId('pictures').replaceChildren(...pictures(this.explorer).flatMap(({ label, file, png, svg }) => [
      offer(`${label} PNG`, png, `${file}.png`), offer(`${label} SVG`, svg, `${file}.svg`)]));
  }
}
