// The bar between clamp and wall, and u(x, t) over the period.

import { asText, diverging, palette, tones } from './colours';
import type { Answer } from './core';

/** A motion sampled at instants of equal distance; straight between them, as u is on a grid. */
export class Film {
  readonly times: Float64Array;
  readonly u: Float64Array;
  readonly s: Float64Array;
  readonly force: Float64Array;
  readonly nodes: number;
  readonly mostStrain: number;
  readonly mostForce: number;
  readonly mostDisplacement: number;
  readonly mostCompression: number;  // of a part between two nodes [g/L]

  constructor(answer: Answer) {
    this.times = answer.array('times');
    this.u = answer.array('u');
    this.s = answer.array('s');
    this.force = answer.array('force');
    this.nodes = Number(answer.json.nodes);
    const most = (values: Float64Array): number => values.reduce((high, v) => Math.max(high, Math.abs(v)), 0) || 1;
    this.mostStrain = most(this.s);
    this.mostForce = most(this.force);
    this.mostDisplacement = most(this.u);
    let shortest = 0;
    for (let row = 0; row < this.u.length; row += this.nodes) {
      for (let i = row + 1; i < row + this.nodes; ++i) shortest = Math.min(shortest, this.u[i] - this.u[i - 1]);
    }
    this.mostCompression = -shortest * (this.nodes - 1);
  }

  get begin(): number { return this.times[0]; }
  get end(): number { return this.times[this.times.length - 1]; }

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
  /** The path of the tip at all instants. */
  tip(): Float64Array {
    return this.times.map((_, m) => this.u[m * this.nodes + this.nodes - 1]);
  }
}

/** As asked, or as many times as leave the bar in order: its compression is given in g/L, the gap in g. */
export function drawnTimes(asked: number, compression: number, gap: number): number {
  const limit = (most: number, size: number): number => (size > 0 ? most / (gapShare * size) : Infinity);
  return Math.min(asked, limit(mostShortened, compression), limit(mostGap, gap));
}

export type Drawing = CanvasRenderingContext2D;

const levels = 65;
const gapShare = 1e-3;  // g/L
const mostShortened = 0.9;  // of a part of the bar as it is drawn: nothing passes its neighbour, and so no clamp and no wall
const mostGap = 0.5;        // of the bar's length, as it is drawn

export interface Pluck { place: number; displacement: number }

export class BarView {
  private readonly context: Drawing;
  private lut: string[] = [];
  film: Film | undefined;
  magnified = 100;            // as the reader wants it
  pluck: Pluck | undefined;  // shown instead of the motion while the bar is held
  share = 0;
  gap = 1;                    // of the wall, in g of the usual bar: 0, or less where the bar at rest is pressed
  stop: number | undefined;  // of the second stop, as far on the other side

  constructor(readonly canvas: HTMLCanvasElement) {
    this.context = canvas.getContext('2d')!;
    this.recolour();
    new ResizeObserver(() => {
      this.fit();
      this.paint();
    }).observe(canvas);
  }

  recolour(): void {
    const map = diverging();
    this.lut = Array.from({ length: levels }, (_, k) => asText(map(k / (levels - 1))));
  }

  private fit(): void {
    const ratio = devicePixelRatio;
    this.canvas.width = Math.max(1, Math.round(this.canvas.clientWidth * ratio));
    this.canvas.height = Math.max(1, Math.round(this.canvas.clientHeight * ratio));
  }

  /** Displacements are drawn so many times larger. */
  get drawn(): number {
    const { pluck } = this;
    return drawnTimes(this.magnified, pluck ? -pluck.displacement / pluck.place : this.film?.mostCompression ?? 0, this.gap);
  }

  /** Left end and length of the bar at rest, in CSS pixels. */
  private frame(): { left: number; length: number } {
    const width = this.canvas.clientWidth;
    const left = 34;
    // Room for the gap as it is drawn, at most a quarter of the bar, and the wall.
    return { left, length: (width - left - 44) / (1 + gapShare * this.drawn * Math.max(this.gap, 0)) };
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

  paint(): void {
    this.draw(this.context, this.canvas.clientWidth, this.canvas.clientHeight, devicePixelRatio);
  }

  draw(c: Drawing, width: number, height: number, ratio: number): void {
    const { ink, paper, faint } = tones();
    const { left, length } = this.frame();
    const unit = length * gapShare * this.drawn;  // pixels of one g
    const [top, thick] = [height * 0.3, height * 0.36];
    c.setTransform(ratio, 0, 0, ratio, 0, 0);
    c.fillStyle = paper;
    c.fillRect(0, 0, width, height);
    // Clamp.
    c.fillStyle = ink;
    c.fillRect(left - 7, top - 16, 7, thick + 32);
    c.strokeStyle = ink;
    c.lineWidth = 1;
    c.beginPath();
    for (let y = top - 16; y < top + thick + 16; y += 9) {
      c.moveTo(left - 7, y);
      c.lineTo(left - 15, y + 8);
    }
    c.stroke();
    this.drawBar(c, left, length, unit, top, thick, ink);
    this.drawWall(c, left + length + unit * this.gap, top, thick, ink, faint);
    if (this.stop !== undefined) this.drawStop(c, left + length - unit * this.stop, top, thick, faint);
    // The tip at rest.
    c.strokeStyle = faint;
    c.setLineDash([4, 4]);
    c.beginPath();
    c.moveTo(left + length, top - 20);
    c.lineTo(left + length, top + thick + 20);
    c.stroke();
    c.setLineDash([]);
    c.fillStyle = ink;
    c.font = '13px system-ui, sans-serif';
    c.textAlign = 'center';
    c.textBaseline = 'bottom';
    if (unit > 40 && this.gap > 0) c.fillText('gap g', left + length + unit / 2, top - 22);
    c.textBaseline = 'top';
    c.textAlign = 'left';
    c.fillText('clamp', left - 15, top + thick + 20);
    c.textAlign = 'center';
    const magnified = `displacements × ${Number(this.drawn.toPrecision(3))}`;
    c.fillText(this.drawn < this.magnified ? `${magnified}: × ${this.magnified} would draw the bar through itself` : magnified,
      left + length / 2, top + thick + 20);
  }

  private force(): number {
    if (!this.film || this.pluck) return 0;
    return this.film.force[this.film.locate(this.share).row] ?? 0;
  }

  private drawWall(c: Drawing, x: number, top: number, thick: number, ink: string, faint: string): void {
    const force = this.force();
    const lit = this.film ? Math.max(force, 0) / this.film.mostForce : 0;
    c.fillStyle = faint;
    c.fillRect(x, top - 24, 20, thick + 48);
    if (lit > 1e-9) {
      c.globalAlpha = 0.35 + 0.65 * Math.min(lit, 1);
      c.fillStyle = palette.contact;
      c.fillRect(x, top - 24, 20, thick + 48);
      c.globalAlpha = 1;
      // An arrow as long as the force is large: nothing is told by colour alone.
      const y = top + thick / 2;
      const reach = 14 + 40 * Math.min(lit, 1);
      c.strokeStyle = ink;
      c.fillStyle = ink;
      c.lineWidth = 2;
      c.beginPath();
      c.moveTo(x - 2, y);
      c.lineTo(x - reach, y);
      c.stroke();
      c.beginPath();
      c.moveTo(x - reach - 8, y);
      c.lineTo(x - reach, y - 5);
      c.lineTo(x - reach, y + 5);
      c.closePath();
      c.fill();
      c.lineWidth = 1;
    }
    c.fillStyle = ink;
    c.font = '13px system-ui, sans-serif';
    c.textBaseline = 'bottom';
    c.textAlign = 'right';
    c.fillText(lit > 1e-9 ? 'wall presses' : 'wall', x + 20, top - 42);
  }

  /** The second stop holds the tip from behind: a block above the bar and one below. */
  private drawStop(c: Drawing, x: number, top: number, thick: number, faint: string): void {
    const lit = Math.max(-this.force(), 0) / (this.film?.mostForce ?? 1);
    for (const y of [top - 19, top + thick + 3]) {
      c.fillStyle = faint;
      c.fillRect(x - 20, y, 20, 16);
      c.globalAlpha = lit > 1e-9 ? 0.35 + 0.65 * Math.min(lit, 1) : 0;
      c.fillStyle = palette.contact;
      c.fillRect(x - 20, y, 20, 16);
      c.globalAlpha = 1;
    }
    // The flange by which it is held.
    const tip = this.film && !this.pluck ? this.film.displacement(this.film.nodes - 1, this.film.locate(this.share)) : this.pluck?.displacement ?? 0;
    const { left, length } = this.frame();
    c.fillStyle = tones().ink;
    c.fillRect(left + length + length * gapShare * this.drawn * tip - 3, top - 18, 3, thick + 36);
  }

  private drawBar(c: Drawing, left: number, length: number, unit: number, top: number, thick: number, ink: string): void {
    const { film, pluck } = this;
    if (pluck) {
      const hand = left + length * pluck.place + unit * pluck.displacement;
      const tip = left + length + unit * pluck.displacement;
      const strained = pluck.displacement < 0 ? 0 : levels - 1;
      c.fillStyle = this.lut[strained];
      c.fillRect(left, top, Math.max(hand - left, 0), thick);
      c.fillStyle = this.lut[(levels - 1) / 2];
      c.fillRect(hand, top, Math.max(tip - hand, 0), thick);
      c.strokeStyle = ink;
      c.strokeRect(left, top, tip - left, thick);
      return;
    }
    if (!film) return;
    const place = film.locate(this.share);
    const cells = film.nodes - 1;
    const xOf = (node: number): number => left + (length * node) / cells + unit * film.displacement(node, place);
    const half = (levels - 1) / 2;
    const row = (place.rest < 0.5 ? place.row : place.row + 1) * cells;
    // Cells of one colour that touch are one rectangle.
    let begin = xOf(0);
    let colour = Math.round(half + half * (film.s[row] / film.mostStrain));
    for (let i = 1; i <= cells; ++i) {
      const next = i < cells ? Math.round(half + half * (film.s[row + i] / film.mostStrain)) : -1;
      if (next === colour) continue;
      const end = xOf(i);
      c.fillStyle = this.lut[colour];
      c.fillRect(begin, top, end - begin + 0.6, thick);
      begin = end;
      colour = next;
    }
    c.strokeStyle = ink;
    c.lineWidth = 1;
    c.strokeRect(left, top, xOf(cells) - left, thick);
    // Ten cross-sections, to see it stretch.
    c.beginPath();
    for (let k = 1; k < 10; ++k) {
      const x = xOf(Math.round((cells * k) / 10));
      c.moveTo(x, top);
      c.lineTo(x, top + thick);
    }
    c.globalAlpha = 0.35;
    c.stroke();
    c.globalAlpha = 1;
  }
}
