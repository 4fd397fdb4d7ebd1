// Scenes of several bars, built of parts: what each may be dragged to, and the words of it.

import { byId, input, round, select, shown, slide } from './dom';
import type { SceneMotion } from './core';
import type { Explorer } from './explorer';
import { withUnit } from './units';

interface Model { name: string; motion: Omit<SceneMotion, 'show' | 'from'> }

const models: Model[] = [
  { name: 'two bars that meet', motion: { words: 'clamp 100 gap=1e-3 140:1.3 clamp', hands: [-4, 2], span: 16 } },
  { name: 'a striker hits a rod', motion: { words: '40:2 gap=1e-3 160', hands: [1, 0], span: 6 } },
  { name: 'a bar flies between two walls', motion: { words: 'stop=-2e-3 200 stop=2e-3', hands: [1], span: 24 } },
  { name: 'a bar bounces', motion: { words: '100 stop=4e-3', hands: [0], gravity: 5e-4, span: 40 } },
  { name: 'a string on a point obstacle', motion: { words: 'clamp 80 stop=5e-4 120 clamp', hands: [-3], span: 12 } },
  { name: 'a soft root', motion: { words: 'spring=2 200 stop=1e-3', hands: [-3], span: 20 } },
  { name: 'a soft wall, shaken', motion: { words: 'clamp 100 driven gap=1e-3 spring=20 dash=1', hands: [0, 0], amplitude: 4e-4, frequency: 0.9, span: 40 } },
];

/** Parts that can be added, and how they begin. */
const palette = ['clamp', '100', 'gap=1e-3', 'stop=1e-3', 'stop=-1e-3', 'spring=2', 'mass=0.1', 'dash=0.1', 'driven', 'shaken', 'free'];

const kindOf = (word: string): string => (/^\d/.test(word) ? 'bar' : word.split('=')[0]);
const titles: Record<string, string> = {
  bar: 'cells[:impedance[:speed]]', gap: 'the bar is cut; faces so far apart [m]', stop: 'may move so far, to the left if negative [m]', spring: 'to the ground [N/m]', mass: '[kg]',
  dash: 'a dashpot to the ground, in impedances', clamp: 'does not move', free: 'an end that nothing holds', driven: 'a harmonic force acts here', shaken: 'this clamp oscillates',
};

export const firstScene: SceneMotion = { show: 'scene', from: 0, ...models[0].motion };

type Change = { [Key in keyof SceneMotion]?: SceneMotion[Key] | undefined };

export class Builder {
  private dragged = -1;

  constructor(private readonly explorer: Explorer) {
    const list = select('scene-model');
    list.append(new Option('a scene of your own', ''), ...models.map(({ name }, k) => new Option(name, String(k))));
    list.onchange = () => { if (list.value !== '') void explorer.show({ show: 'scene', from: 0, ...models[Number(list.value)].motion }); };
    byId('palette').append(...palette.map((word) => {
      const button = Object.assign(document.createElement('button'), { textContent: `+ ${word.includes('=-') ? 'left ' : ''}${kindOf(word)}`, title: titles[kindOf(word)], draggable: true });
      button.onclick = () => this.build([...this.words, word]);
      button.ondragstart = (event) => event.dataTransfer?.setData('text/plain', word);
      return button;
    }));
    const parts = byId('parts');
    parts.ondragover = (event) => event.preventDefault();
    parts.ondrop = (event) => { if (event.target === parts) this.drop(event, this.words.length); };
    byId<HTMLFormElement>('words-form').onsubmit = (event) => {
      event.preventDefault();
      this.build(input('words').value.trim().split(/\s+/));
    };
    slide('weight', (gravity) => this.change({ gravity: gravity === 0 ? undefined : gravity }));
    slide('scene-amplitude', (amplitude) => this.change(amplitude === 0 ? { amplitude: undefined, frequency: undefined }
      : { amplitude: round(amplitude / 1e4), frequency: this.motion.frequency ?? 0.9 }));
    slide('scene-frequency', (frequency) => this.change(this.motion.amplitude === undefined ? {} : { frequency }));
    this.listenToBars();
  }

  /** Of quick clicks each changes what the one before has asked for. */
  private get motion(): SceneMotion {
    const { asked, view } = this.explorer;
    return (asked.show === 'scene' ? asked : view.motion) as SceneMotion;
  }
  private get words(): string[] { return this.motion.words.trim().split(/\s+/); }

  private change(part: Change): void {
    const motion = { ...this.motion, ...part } as SceneMotion;
    for (const key of ['gravity', 'amplitude', 'frequency'] as const) if (motion[key] === undefined) delete motion[key];
    void this.explorer.show(motion);
  }
  private build(words: string[]): void {
    const isDriven = words.includes('driven') || words.includes('shaken');
    this.change({ words: words.join(' '), ...(isDriven ? {} : { amplitude: undefined, frequency: undefined }) });
  }

  /** A bar that is dragged is pulled, or thrown if nothing holds it; a wall is moved. */
  private listenToBars(): void {
    const canvas = byId<HTMLCanvasElement>('bar-canvas');
    const { bar } = this.explorer;
    let held: { x: number; contact: number | undefined; bar: number | undefined; from: number } | undefined;
    canvas.addEventListener('pointerdown', (event) => {
      if (this.explorer.view.motion.show !== 'scene') return;
      const contact = bar.contactAt(event.offsetX);
      const of = contact === undefined ? bar.barAt(event.offsetX) : undefined;
      if (contact === undefined && of === undefined) return;
      held = { x: event.offsetX, contact, bar: of, from: contact === undefined ? this.motion.hands[of!] ?? 0 : this.gapOf(contact) };
      canvas.setPointerCapture(event.pointerId);
    });
    canvas.addEventListener('pointermove', (event) => {
      if (!held || Math.abs(event.offsetX - held.x) < 3) return;
      const moved = bar.asDisplacement(event.offsetX - held.x);
      if (held.contact !== undefined) this.moveStop(held.contact, held.from + moved);
      else {
        const hands = this.explorer.film!.drifts.map((_, k) => this.motion.hands[k] ?? 0);
        hands[held.bar!] = round(Math.min(Math.max(held.from + moved, -20), 20), 3);
        this.change({ hands });
      }
    });
    for (const kind of ['pointerup', 'pointercancel']) canvas.addEventListener(kind, () => { held = undefined; });
  }

  /** Words of contacts, in the order in which they are numbered. */
  private contactWord(contact: number): number {
    return this.words.map((word, k) => [word, k] as const).filter(([word]) => /^(gap|stop)=/.test(word))[contact][1];
  }
  private gapOf(contact: number): number {
    const value = this.words[this.contactWord(contact)].split('=')[1].split(':').at(-1)!;
    return Number(value) / 1e-3;
  }
  private moveStop(contact: number, gap: number): void {
    const words = this.words;
    const at = this.contactWord(contact);
    const [name, value] = words[at].split('=');
    const side = /^(left|right):/.exec(value)?.[0] ?? '';
    const isLeft = name === 'stop' && !side && Number(value) < 0;
    const least = side ? gap : isLeft ? Math.min(gap, -0.1) : Math.max(gap, 0.1);
    words[at] = `${name}=${side}${round(least * 1e-3, 3)}`;
    this.build(words);
  }

  follow(motion: SceneMotion): void {
    const of = models.findIndex((one) => one.motion.words === motion.words);
    select('scene-model').value = of < 0 ? '' : String(of);
    if (document.activeElement !== input('words')) input('words').value = motion.words;
    this.followParts(motion.words);
    this.followHands(motion);
    input('weight').value = String(motion.gravity ?? 0);
    byId('weight-value').textContent = motion.gravity ? withUnit('weight', motion.gravity / 1e-3, 3) : 'none';
    const words = this.words;
    byId('scene-drive').hidden = !words.includes('driven') && !words.includes('shaken');
    input('scene-amplitude').value = String((motion.amplitude ?? 0) * 1e4);
    input('scene-frequency').value = String(motion.frequency ?? 0.9);
    byId('scene-amplitude-value').textContent = withUnit(words.includes('driven') ? 'force' : 'displacement', (motion.amplitude ?? 0) / 1e-3, 3);
    byId('scene-frequency-value').textContent = `${shown(motion.frequency ?? 0.9, 3)} of its own first`;
  }

  /** What is typed in a part stays until it is done, and the focus where it was. */
  private followParts(words: string): void {
    const parts = byId('parts');
    if (parts.dataset.words === words) return;
    parts.dataset.words = words;
    const focusable = (): HTMLElement[] => [...parts.querySelectorAll<HTMLElement>('input, button')];
    const at = focusable().indexOf(document.activeElement as HTMLElement);
    parts.replaceChildren(...this.words.map((word, k) => this.chip(word, k)));
    focusable()[at]?.focus();
  }

  /** A slider for each bar: pulled, or thrown. */
  private followHands(motion: SceneMotion): void {
    const drifts = this.explorer.film?.drifts ?? [];
    const host = byId('hands');
    if (host.childElementCount !== drifts.length) {
      host.replaceChildren(...drifts.map((_, k) => {
        const label = document.createElement('label');
        const slider = Object.assign(document.createElement('input'), { type: 'range', min: '-8', max: '8', step: '0.1', id: `hand-${k}` });
        slider.addEventListener('input', () => this.change({ hands: Array.from({ length: host.childElementCount }, (__, j) => Number(input(`hand-${j}`).value)) }));
        label.append(document.createElement('span'), document.createElement('output'), slider);
        return label;
      }));
    }
    drifts.forEach((isFree, k) => {
      const [name, value] = host.children[k].children;
      const hand = motion.hands[k] ?? 0;
      name.textContent = `Bar ${k + 1}: ${isFree ? 'thrown at ' : 'pulled by '}`;
      value.textContent = withUnit(isFree ? 'velocity' : 'displacement', hand, 3);
      input(`hand-${k}`).value = String(hand);
    });
  }

  private chip(word: string, k: number): HTMLElement {
    const [name, value] = /^\d/.test(word) ? ['bar', word] : word.split('=');
    const chip = Object.assign(document.createElement('span'), { className: `part ${kindOf(word)}`, draggable: true, title: titles[kindOf(word)] ?? '' });
    chip.setAttribute('role', 'listitem');
    chip.append(name);
    if (value !== undefined) {
      const field = Object.assign(document.createElement('input'), { value, ariaLabel: `${name}, part ${k + 1}` });
      field.onchange = () => this.build(this.words.with(k, name === 'bar' ? field.value.trim() : `${name}=${field.value.trim()}`));
      chip.append(field);
    }
    const away = Object.assign(document.createElement('button'), { textContent: '×', ariaLabel: `Remove part ${k + 1}, ${name}` });
    away.onclick = () => this.build(this.words.toSpliced(k, 1));
    chip.append(away);
    chip.ondragstart = (event) => {
      this.dragged = k;
      event.dataTransfer?.setData('text/plain', word);
    };
    chip.ondragend = () => { this.dragged = -1; };
    chip.ondragover = (event) => {
      event.preventDefault();
      chip.classList.add('over');
    };
    chip.ondragleave = () => chip.classList.remove('over');
    chip.ondrop = (event) => this.drop(event, k);
    return chip;
  }

  /** A part is dropped before the part k, or after all of them. */
  private drop(event: DragEvent, k: number): void {
    event.preventDefault();
    const from = this.dragged;
    const words = from < 0 ? this.words : this.words.toSpliced(from, 1);
    this.build(words.toSpliced(from >= 0 && from < k ? k - 1 : k, 0, event.dataTransfer?.getData('text/plain') ?? ''));
  }
}
