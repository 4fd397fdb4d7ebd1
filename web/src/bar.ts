// Bars between clamps, walls and one another.

import { asText, diverging, drawScale, palette, tones } from './colours';
import type { Answer } from './core';
import { shown } from './dom';
import { fontOf, letters, trace } from './plots';
import { inUnit, unitOf } from './units';

export interface Contact { kind: 'right stop' | 'left stop' | 'gap'; at: number; next: number | null; gap: number }
interface Row { from: number; to: number; bar: number; impedance: number }
interface Standing { kind: string; at: number }

/** A motion sampled at instants of equal distance, and what stands around its bars; displacements in g. */
export class Film {
  readonly times: Float64Array;
  readonly u: Float64Array;
  readonly pathTimes: Float64Array;
  readonly tip: Float64Array;
  readonly force: Float64Array;
  readonly nodes: number;
  readonly x: Float64Array;       // of each node, in L, all bars end to end
  readonly rows: Row[];
  readonly contacts: Contact[];
  readonly stands: Standing[];
  readonly drifts: boolean[];
  readonly forces: Float64Array;  // of each contact at each time, where there are several bars
  readonly offsets: Float64Array; // of each node, for the gaps before it [g]
  readonly mostStrain: number;
  readonly mostForce: number;
  readonly mostDisplacement: number;
  readonly mostCompression: number;  // of a part between two nodes [g/L]
  readonly reach: [number, number];

  constructor(answer: Answer, gap: number, stop: number | undefined) {
    const { json } = answer;
    [this.times, this.u, this.pathTimes, this.tip, this.force, this.forces] =
      ['times', 'u', 'path_times', 'tip', 'force', 'forces'].map((name) => answer.array(name)) as [Float64Array, Float64Array, Float64Array, Float64Array, Float64Array, Float64Array];
    this.nodes = Number(json.nodes);
    const last = this.nodes - 1;
    this.x = answer.has('x') && json.rows ? answer.array('x') : Float64Array.from({ length: this.nodes }, (_, i) => i / last);
    this.rows = (json.rows as Row[] | undefined) ?? [{ from: 0, to: this.nodes, bar: 0, impedance: 1 }];
    this.contacts = (json.contacts as Contact[] | undefined) ?? [{ kind: 'right stop', at: last, next: null, gap },
      ...(stop === undefined ? [] : [{ kind: 'left stop' as const, at: last, next: null, gap: stop }])];
    this.stands = (json.stands as Standing[] | undefined) ?? [{ kind: 'clamp left', at: 0 }];
    this.drifts = (json.drifts as boolean[] | undefined) ?? [false];
    this.offsets = this.x.map((_, node) => this.contacts.reduce((sum, one) => (one.next !== null && node >= one.next ? sum + one.gap : sum), 0));
    const most = (values: Float64Array): number => values.reduce((high, v) => Math.max(high, Math.abs(v)), 0) || 1;
    this.mostForce = most(json.rows ? this.forces : this.force);
    this.mostDisplacement = most(this.u);
    let [shortest, longest] = [0, 0];
    for (let m = 0; m < this.times.length; ++m) {
      for (const { from, to } of this.rows) {
        for (let i = from + 1; i < to; ++i) {
          const s = this.strain(m, i);
          if (s < shortest) shortest = s;
          if (s > longest) longest = s;
        }
      }
    }
    this.mostCompression = -shortest;
    this.mostStrain = Math.max(-shortest, longest) || 1;
    this.reach = this.reachOf();
  }

  get isScene(): boolean { return this.tip.length === 0; }
  get begin(): number { return this.times[0]; }
  get end(): number { return this.times[this.times.length - 1]; }

  /** Between node i - 1 and node i. */
  strain(row: number, i: number): number {
    const at = row * this.nodes + i;
    return (this.u[at] - this.u[at - 1]) / (this.x[i] - this.x[i - 1]);
  }
  /** The instant at or before a share of the whole, and how far on the next one is. */
  locate(share: number): { row: number; rest: number } {
    const place = Math.min(Math.max(share, 0), 1) * (this.times.length - 1);
    const row = Math.min(Math.floor(place), this.times.length - 2);
    return { row, rest: place - row };
  }
  displacement(node: number, { row, rest }: { row: number; rest: number }): number {
    const here = this.u[row * this.nodes + node];
    return here + rest * (this.u[(row + 1) * this.nodes + node] - here);
  }
  /** The force of a contact just now, positive where it pushes. */
  push(contact: number, share: number): number {
    if (this.isScene) return this.forces[this.locate(share).row * this.contacts.length + contact];
    const place = Math.min(Math.floor(share * (this.force.length - 1)), this.force.length - 2);
    return contact === 0 ? this.force[place] : -this.force[place];
  }
  /** How far to the left and to the right of the bars at rest things go [g]. */
  private reachOf(): [number, number] {
    const last = this.nodes - 1;
    const end = this.offsets[last];
    let [low, high] = [0, end];
    for (const { kind, at, gap } of this.contacts) {
      if (kind === 'right stop' && at === last) high = Math.max(high, end + gap);
      if (kind === 'left stop' && at === 0) low = Math.min(low, -gap);
    }
    const isHeld = (kind: string): boolean => this.stands.some((one) => one.kind === kind);
    for (let m = 0; m < this.times.length; ++m) {
      if (!isHeld('clamp left')) low = Math.min(low, this.u[m * this.nodes]);
      if (!isHeld('clamp right')) high = Math.max(high, end + this.u[m * this.nodes + last]);
    }
    return [low, high];
  }
}

const gapShare = 1e-3;  // g/L
const mostShortened = 0.9;  // of a part of the bar as it is drawn: nothing passes its neighbour, and so no clamp and no wall
const mostReach = 0.6;      // beyond the bars at rest, of their length, as it is drawn

/** As asked, or as many times as leave the bars in order: compression in g/L, reach in g. */
export function drawnTimes(asked: number, compression: number, reach: number): number {
  const limit = (most: number, size: number): number => (size > 0 ? most / (gapShare * size) : Infinity);
  return Math.min(asked, limit(mostShortened, compression), limit(mostReach, reach));
}

export type Drawing = CanvasRenderingContext2D;

const levels = 65;

export interface Pluck { place: number; displacement: number }
export interface Kept { film: Film; name: string }

export class BarView {
  private readonly context: Drawing;
  private lut: string[] = [];
  film: Film | undefined;
  kept: Kept | undefined;     // drawn below, at the same time
  magnified = 100;            // as the reader wants it
  pluck: Pluck | undefined;   // shown instead of the motion while the bar is held
  share = 0;

  constructor(readonly canvas: HTMLCanvasElement) {
    this.context = canvas.getContext('2d')!;
    this.recolour();
    new ResizeObserver(() => {
      this.canvas.width = Math.max(1, Math.round(this.canvas.clientWidth * devicePixelRatio));
      this.canvas.height = Math.max(1, Math.round(this.canvas.clientHeight * devicePixelRatio));
      this.paint();
    }).observe(canvas);
  }

  recolour(): void {
    const map = diverging();
    this.lut = Array.from({ length: levels }, (_, k) => asText(map(k / (levels - 1))));
  }

  /** How far to the left and to the right of bars at rest the motions go [g]. */
  private get reach(): [number, number] {
    const all = [this.film, this.kept?.film].flatMap((film) => (film ? [film.reach] : []));
    return [Math.min(0, ...all.map(([low]) => low)), Math.max(0, ...all.map(([, high]) => high))];
  }

  /** Displacements are drawn so many times larger, of both motions where there are two. */
  get drawn(): number {
    const { pluck, kept, film } = this;
    const compression = pluck ? -pluck.displacement / pluck.place : Math.max(film?.mostCompression ?? 0, kept?.film.mostCompression ?? 0);
    const [low, high] = this.reach;
    return drawnTimes(this.magnified, compression, high - low);
  }

  /** Where x = 0 stands, pixels of a length L, and of one g. */
  private frame(): { left: number; length: number; unit: number } {
    const room = 36 * letters();
    const share = gapShare * this.drawn;
    const [low, high] = this.reach;
    const length = (this.canvas.clientWidth - 2 * room) / (1 + share * (high - low));
    return { left: room - share * length * low, length, unit: share * length };
  }

  /** Where on the bar at rest a pointer is, 0..1 and beyond. */
  placeOf(x: number): number {
    const { left, length } = this.frame();
    return (x - left) / length;
  }
  /** How far [g] the bar is pulled when the hand, at a share of the length, has moved so far. */
  pulledBy(pixels: number, place: number): number {
    const unit = gapShare * this.magnified;
    return Math.max(pixels / (this.frame().length * unit), (-mostShortened * place) / unit);
  }
  /** The bar of a scene under a pointer. */
  barAt(x: number): number | undefined {
    const { film } = this;
    if (!film) return undefined;
    const { left, length, unit } = this.frame();
    const now = film.locate(this.share);
    const at = (node: number): number => left + length * film.x[node] + unit * (film.offsets[node] + film.displacement(node, now));
    return film.rows.find(({ from, to }) => at(from) <= x && x <= at(to - 1))?.bar;
  }
  /** Pixels as g, as it is drawn. */
  asDisplacement(pixels: number): number { return pixels / this.frame().unit; }
  /** The contact whose wall or face is under a pointer. */
  contactAt(x: number): number | undefined {
    const { film } = this;
    const { left, length, unit } = this.frame();
    const found = film?.contacts.findIndex(({ kind, at, gap }) => {
      const rest = left + length * film.x[at] + unit * film.offsets[at];
      return kind === 'right stop' ? Math.abs(x - rest - unit * gap - 8) < 14 : kind === 'left stop' && Math.abs(x - rest + unit * gap + 8) < 14;
    });
    return found !== undefined && found >= 0 ? found : undefined;
  }

  paint(): void {
    this.draw(this.context, this.canvas.clientWidth, this.canvas.clientHeight, devicePixelRatio);
  }

  draw(c: Drawing, width: number, height: number, ratio: number): void {
    const { ink, paper } = tones();
    const { film, kept } = this;
    c.setTransform(ratio, 0, 0, ratio, 0, 0);
    c.fillStyle = paper;
    c.fillRect(0, 0, width, height);
    const line = 18 * letters();
    const bottom = height - 1.1 * line;
    const most = Math.max(film?.mostStrain ?? 1, kept?.film.mostStrain ?? 0);
    const thick = kept ? bottom / 2 - 2.1 * line : bottom - 2 * line;
    if (film) this.drawBars(c, film, this.share, 1.3 * line, thick, most, this.pluck);
    if (film && kept) {
      const period = kept.film.end - kept.film.begin;
      const passed = this.share * (film.end - film.begin);
      this.drawBars(c, kept.film, (passed / period) % 1, bottom / 2 + 1.3 * line, thick, most);
      c.fillStyle = ink;
      c.font = fontOf(12);
      c.textAlign = 'left';
      c.textBaseline = 'top';
      const room = width - 40 - 80 * letters();
      const whole = `kept: ${kept.name}`;
      c.fillText(c.measureText(whole).width < room ? whole : whole.split(': ').slice(0, 2).join(': '), 40, bottom / 2 + 2, room);
    }
    c.fillStyle = ink;
    c.font = fontOf(12);
    c.textBaseline = 'alphabetic';
    c.textAlign = 'left';
    const why = this.drawn < this.magnified * 0.999 ? `, for × ${this.magnified} would draw one thing through another` : '';
    const times = `${width > 480 ? 'displacements' : 'u'} × ${shown(this.drawn, 3)}${width > 700 ? why : ''}`;
    c.fillText(times, 8, height - 5);
    this.drawScale(c, height, most, width - 8, 16 + c.measureText(times).width);
  }

  /** What the colours of the bar mean. */
  private drawScale(c: Drawing, height: number, most: number, right: number, left: number): void {
    const size = shown(inUnit('strain', most), 3);
    const [after, before] = [` +${size} ${unitOf('strain')} stretched`, `compressed −${size} `];
    c.textAlign = 'right';
    const end = right - c.measureText(after).width;
    const long = Math.min(90 * letters(), end - c.measureText(before).width - left);
    if (long < 12) return;
    c.fillText(after, right, height - 5);
    c.fillText(before, end - long, height - 5);
    drawScale(c, end - long, height - 14, long, 10, diverging());
  }

  private drawBars(c: Drawing, film: Film, share: number, top: number, thick: number, most: number, pluck?: Pluck): void {
    const { ink } = tones();
    const { left, length, unit } = this.frame();
    const now = film.locate(share);
    const rest = (node: number): number => left + length * film.x[node] + unit * film.offsets[node];
    const xOf = (node: number): number => rest(node) + unit * (pluck
      ? pluck.displacement * Math.min(film.x[node] / pluck.place, 1) : film.displacement(node, now));
    for (const row of film.rows) this.drawRow(c, film, row, now.rest < 0.5 ? now.row : now.row + 1, xOf, top, thick, most, pluck, ink);
    for (const one of film.stands) this.drawStanding(c, one.kind, xOf(one.at), top, thick, ink);
    film.contacts.forEach((one, k) => this.drawContact(c, film, one, pluck ? 0 : film.push(k, share), rest, xOf, unit, top, thick));
  }

  private drawRow(c: Drawing, film: Film, { from, to, impedance }: Row, row: number, xOf: (node: number) => number, top: number, thick: number, most: number,
    pluck: Pluck | undefined, ink: string): void {
    // Heavier rows are thicker.
    const high = thick * Math.min(1, 0.62 + 0.38 * Math.min(impedance, 2.5) / 2.5 + (film.rows.length === 1 ? 1 : 0));
    const y = top + (thick - high) / 2;
    const half = (levels - 1) / 2;
    const level = (i: number): number => {
      const strain = pluck ? (film.x[i] <= pluck.place + 1e-9 ? pluck.displacement / pluck.place : 0) : film.strain(row, i);
      return Math.round(half + half * Math.min(Math.max(strain / most, -1), 1));
    };
    // Stretches of one colour are one rectangle.
    let begin = xOf(from);
    let colour = level(from + 1);
    for (let i = from + 1; i < to; ++i) {
      const next = i + 1 < to ? level(i + 1) : -1;
      if (next === colour) continue;
      const end = xOf(i);
      c.fillStyle = this.lut[colour];
      c.fillRect(begin, y, end - begin + 0.6, high);
      begin = end;
      colour = next;
    }
    c.strokeStyle = ink;
    c.lineWidth = 1;
    const first = xOf(from);
    c.strokeRect(first, y, xOf(to - 1) - first, high);
    // Cross-sections, to see it stretch.
    const sections = Math.max(2, Math.round(10 * (film.x[to - 1] - film.x[from])));
    c.beginPath();
    for (let k = 1; k < sections; ++k) {
      const x = xOf(from + Math.round(((to - 1 - from) * k) / sections));
      c.moveTo(x, y);
      c.lineTo(x, y + high);
    }
    c.globalAlpha = 0.35;
    c.stroke();
    c.globalAlpha = 1;
  }

  private drawStanding(c: Drawing, kind: string, x: number, top: number, thick: number, ink: string): void {
    c.strokeStyle = ink;
    c.fillStyle = ink;
    c.lineWidth = 1.5;
    if (kind.startsWith('clamp')) {
      const side = kind === 'clamp left' ? -1 : 1;
      c.fillRect(side < 0 ? x - 6 : x, top - 8, 6, thick + 16);
      c.beginPath();
      for (let y = top - 8; y < top + thick + 8; y += 9) {
        c.moveTo(x + 6 * side, y);
        c.lineTo(x + 14 * side, y + 8);
      }
      c.stroke();
      return;
    }
    // Below the bar: a spring, a dashpot, a weight; an arrow where a force acts.
    const y = top + thick;
    c.beginPath();
    if (kind === 'spring') {
      c.moveTo(x - 30, y + 8);
      for (let k = 0; k <= 6; ++k) c.lineTo(x - 26 + 4 * k, y + (k % 2 ? 3 : 13));
      c.lineTo(x, y + 8);
      c.lineTo(x, y);
      c.moveTo(x - 30, y + 2);
      c.lineTo(x - 30, y + 14);
    } else if (kind === 'dash') {
      c.strokeRect(x - 24, y + 3, 12, 9);
      c.moveTo(x - 18, y + 8);
      c.lineTo(x, y + 8);
      c.lineTo(x, y);
    } else if (kind === 'driven') {
      c.moveTo(x - 16, top - 6);
      c.lineTo(x + 12, top - 6);
      c.lineTo(x + 6, top - 10);
      c.moveTo(x + 12, top - 6);
      c.lineTo(x + 6, top - 2);
    } else {
      c.fillRect(x - 6, y + 2, 12, 11);
    }
    c.stroke();
    c.lineWidth = 1;
  }

  private drawContact(c: Drawing, film: Film, { kind, at, next, gap }: Contact, push: number, rest: (node: number) => number, xOf: (node: number) => number,
    unit: number, top: number, thick: number): void {
    const { ink, faint } = tones();
    const lit = Math.max(push, 0) / film.mostForce;
    const isPressed = lit > 1e-6;
    const y = top + thick / 2;
    const isEnd = at === film.nodes - 1 || at === 0;
    const block = (x: number, from: number, high: number, wide: number): void => {
      c.fillStyle = faint;
      c.fillRect(x, from, wide, high);
      if (!isPressed) return;
      c.globalAlpha = 0.35 + 0.65 * Math.min(lit, 1);
      c.fillStyle = palette.contact;
      c.fillRect(x, from, wide, high);
      c.globalAlpha = 1;
    };
    let face = 0;
    if (kind === 'gap') {
      face = xOf(at);
      if (isPressed) block(face - 3, top, thick, Math.max(xOf(next!) - face, 0) + 6);
    } else {
      const side = kind === 'right stop' ? 1 : -1;
      face = rest(at) + side * unit * gap;
      if (isEnd && (side > 0) === (at !== 0)) {
        block(side > 0 ? face : face - 18, top - 8, thick + 16, 18);
      } else {
        // A block above the bar and one below, and the flange that they hold.
        for (const from of [top - 14, top + thick + 2]) block(side > 0 ? face : face - 14, from, 12, 14);
        c.fillStyle = ink;
        c.fillRect(xOf(at) - 1.5, top - 13, 3, thick + 26);
      }
      // The place of the node at rest.
      c.strokeStyle = faint;
      c.setLineDash([4, 4]);
      trace(c, 'stroke', [rest(at), top - 12], [rest(at), top + thick + 12]);
      c.setLineDash([]);
    }
    if (isPressed) this.drawPush(c, face, y, kind === 'left stop' ? -1 : 1, Math.min(lit, 1), ink);
    c.fillStyle = ink;
    c.font = fontOf(12);
    c.textBaseline = 'bottom';
    c.textAlign = kind === 'left stop' ? 'left' : 'right';
    if (thick > 30 && (isPressed || !film.isScene) && kind !== 'left stop') c.fillText(isPressed ? 'presses' : kind === 'gap' ? '' : 'wall', face + (kind === 'gap' ? 20 : 18), top - 9);
  }

  /** An arrow as long as the force is large: nothing is told by colour alone. */
  private drawPush(c: Drawing, x: number, y: number, side: number, lit: number, ink: string): void {
    const reach = (14 + 36 * lit) * side;
    c.strokeStyle = ink;
    c.fillStyle = ink;
    c.lineWidth = 2;
    trace(c, 'stroke', [x - 2 * side, y], [x - reach, y]);
    trace(c, 'fill', [x - reach - 8 * side, y], [x - reach, y - 5], [x - reach, y + 5]);
    c.lineWidth = 1;
  }
}
