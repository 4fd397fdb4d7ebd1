// The map one points at: frequency and energy, contact and flight, or the response.

import type uPlot from 'uplot';
import { asText, drawScale, palette, through, tones } from './colours';
import type { Answer, Motion, Phases } from './core';
import { at, fontOf, letters, Plot, trace, type Axes } from './plots';
import type { Polygons, PolygonPick } from './polygons';
import type { SweepPoint } from './sweeps';
import { withUnit } from './units';
import type { Forcing, MapKind, View } from './view';

export interface ModeLine {
  contact: [number, number]; contact_text: string; family: string | null;
  lowest: number; highest: number;
}
export interface FamilyPoint { order: number; nu: number; blocks: number; period: number; least: number }
export interface ResponsePoint {
  steps: number; frequency: number; contact: number; impulse: number; stays: number; which: number;
}

/** What was pointed at. */
export type Pick =
  | { kind: 'family'; family: FamilyPoint; energy: number }
  | { kind: 'mode'; mode: ModeLine; period: number }
  | { kind: 'schedule'; phases: Phases }
  | ({ kind: 'polygon' } & PolygonPick)
  | { kind: 'response'; point: ResponsePoint };

export const mostEnergy = 60;  // of the maps [E₁]
/** Families crowd above ω₁: there the axis is spread. */
const frequencies: { range: [number, number]; spread: NonNullable<Axes['spreadX']> } = {
  range: [0.995, 2.1],
  spread: { there: (ratio) => Math.log(ratio - 0.93), back: (place) => 0.93 + Math.exp(place), ticks: [1, 1.05, 1.1, 1.2, 1.3, 1.5, 1.7, 2] },
};

export class Atlas {
  readonly families: FamilyPoint[] = [];
  readonly modes: ModeLine[];
  readonly curves: Float64Array;
  readonly samples: number;
  readonly schedules: Float64Array;

  constructor(answer: Answer, readonly cells: number) {
    const rows = answer.array('families');
    for (let i = 0; i < rows.length; i += 5) {
      this.families.push({ order: rows[i], nu: rows[i + 1], blocks: rows[i + 2], period: rows[i + 3], least: rows[i + 4] });
    }
    this.modes = answer.json.modes as ModeLine[];
    this.curves = answer.array('curves');
    this.samples = Number(answer.json.samples);
    this.schedules = answer.array('schedules');
  }
}

const dot = (c: CanvasRenderingContext2D, x: number, y: number, r: number): void => {
  c.beginPath();
  c.arc(x, y, r, 0, 2 * Math.PI);
};

/** The next or the last one of a list, which goes round; the first where none is chosen. */
const beside = <One>(list: One[], now: number, direction: number): One => list[now < 0 ? 0 : (now + direction + list.length) % list.length];

export class MapView {
  readonly plot: Plot;
  atlas: Atlas | undefined;
  polygons: Polygons | undefined;
  readonly lines: [number, number, number][] = [];      // omega/omega_1, highest tip without wall, touches
  readonly response: ResponsePoint[] = [];
  readonly sweep: SweepPoint[] = [];
  settled: { x: number; y: number } | undefined;  // where a bar settled that was let go beside a motion
  private kind: MapKind = 'energy';
  private here: { x: number; y: number } | undefined;

  constructor(host: HTMLElement, private readonly onPick: (pick: Pick) => void) {
    this.plot = new Plot(host);
    this.plot.onPlot = (plot) => this.listen(plot);
    this.plot.drawOver = (plot, c) => this.drawOver(plot, c);
  }

  private listen(plot: uPlot): void {
    let from: [number, number] | undefined;
    plot.over.addEventListener('pointerdown', (event) => {
      from = [event.clientX, event.clientY];
      if (this.kind === 'contacts' && event.pointerType === 'mouse') plot.over.setPointerCapture(event.pointerId);
    });
    const pick = (event: MouseEvent): void => {
      const frame = plot.over.getBoundingClientRect();
      this.pickAt(plot, event.clientX - frame.left, event.clientY - frame.top);
    };
    // Among polygons the point itself is dragged.
    plot.over.addEventListener('pointermove', (event) => {
      if (this.kind === 'contacts' && event.buttons !== 0 && from) pick(event);
    });
    plot.over.addEventListener('click', (event) => {
      if (from && Math.hypot(event.clientX - from[0], event.clientY - from[1]) <= 5) pick(event);
    });
    // The wheel scrolls the page, until one has clicked here, or with Ctrl.
    let isEntered = false;
    plot.over.addEventListener('pointerdown', () => { isEntered = true; });
    plot.over.addEventListener('pointerleave', () => { isEntered = false; });
    plot.over.addEventListener('wheel', (event) => {
      if (!event.ctrlKey && !isEntered) return;
      event.preventDefault();
      const frame = plot.over.getBoundingClientRect();
      this.scale(event.deltaY < 0 ? 0.8 : 1.25, (event.clientX - frame.left) / frame.width, 1 - (event.clientY - frame.top) / frame.height);
    }, { passive: false });
  }

  /** Shows `factor` of what is shown now, at most the whole, around a place given as shares of width and height. */
  scale(factor: number, shareX = 0.5, shareY = 0.5): void {
    const plot = this.plot.inner;
    if (!plot) return;
    const part = (low: number, high: number, share: number, [least, most]: [number, number]): [number, number] => {
      const centre = low + share * (high - low);
      return [Math.max(centre + (low - centre) * factor, least), Math.min(centre + (high - centre) * factor, most)];
    };
    const { x, y } = plot.scales;
    const whole = this.plot.whole();
    const isLog = this.kind === 'energy';
    const same = (value: number): number => value;
    const zoomed = ({ min, max }: uPlot.Scale, share: number, edges: [number, number], there: typeof same, back: typeof same): [number, number] => {
      const [low, high] = part(there(min!), there(max!), share, [there(edges[0]), there(edges[1])]);
      // At its edges the whole, to the last digit.
      return [low === there(edges[0]) ? edges[0] : back(low), high === there(edges[1]) ? edges[1] : back(high)];
    };
    const { there, back } = this.plot.spread ?? { there: same, back: same };
    this.plot.zoom(zoomed(x, shareX, whole.x, there, back), zoomed(y, shareY, whole.y, isLog ? Math.log : same, isLog ? Math.exp : same));
  }

  private pickAt(plot: uPlot, px: number, py: number): void {
    const place = (x: number, y: number): [number, number] => [plot.valToPos(x, 'x'), plot.valToPos(y, 'y')];
    if (this.kind === 'contacts') {
      const pick = this.polygons?.pick(plot, px, py);
      if (pick) this.onPick({ kind: 'polygon', ...pick });
      return;
    }
    let best: { distance: number; pick: Pick } | undefined;
    const offer = (distance: number, pick: () => Pick): void => {
      if (!best || distance < best.distance) best = { distance, pick: pick() };
    };
    if (this.kind === 'energy' && this.atlas) {
      const { families, modes, curves, samples } = this.atlas;
      const energy = plot.posToVal(py, 'y');
      for (const family of families) {
        if (family.order > 24) continue;
        const [x, y] = place(4 / family.period, family.least);
        // A half-line upwards; of neighbours the one of lower order is meant.
        const distance = Math.hypot(px - x, Math.max(py - y, 0)) + 0.25 * family.order;
        offer(distance, () => ({ kind: 'family', family, energy: Math.max(energy, family.least) }));
      }
      modes.forEach((mode, k) => {
        for (let j = 0; j < samples; ++j) {
          const [period, e] = [curves[2 * (k * samples + j)], curves[2 * (k * samples + j) + 1]];
          const [x, y] = place(4 / period, e);
          offer(Math.hypot(px - x, py - y) + 2, () => ({ kind: 'mode', mode, period }));
        }
      });
    } else if (this.kind === 'existence' && this.atlas) {
      const { schedules, cells } = this.atlas;
      for (let i = 0; i < schedules.length; i += 4) {
        const [x, y] = place(schedules[i] / cells, schedules[i + 1] / cells);
        offer(Math.hypot(px - x, py - y), () => ({ kind: 'schedule', phases: [[schedules[i], schedules[i + 1]]] }));
      }
    } else if (this.kind === 'response') {
      for (const point of this.response) {
        const [x, y] = place(point.frequency, point.impulse);
        offer(Math.hypot(px - x, py - y), () => ({ kind: 'response', point }));
      }
    }
    if (best) this.onPick(best.pick);
  }

  /** The next or the last one along the frequency, for those who have no pointer. */
  step(motion: Motion, direction: number): void {
    if (this.kind === 'response' && this.response.length > 0) {
      const sorted = [...this.response].sort((a, b) => a.frequency - b.frequency || a.impulse - b.impulse);
      const now = sorted.findIndex((p) => motion.show === 'forced' && motion.phases[0][0] === p.contact &&
        motion.phases[0][0] + motion.phases[0][1] === p.steps && motion.which === p.which);
      this.onPick({ kind: 'response', point: beside(sorted, now, direction) });
      return;
    }
    if (this.kind === 'contacts') return this.stepPolygon(motion, direction);
    if (!this.atlas) return;
    const sorted = this.atlas.families.filter((f) => f.order <= 12).sort((a, b) => b.period - a.period);
    let now = -1;
    if (motion.show === 'schedule') {
      const period = motion.phases.reduce((n, p) => n + p[0] + p[1], 0) / motion.cells;
      now = sorted.findIndex((f) => Math.abs(f.period - period) < 1e-9);
    }
    const family = beside(sorted, now, direction);
    this.onPick({ kind: 'family', family, energy: family.least });
  }

  private stepPolygon(motion: Motion, direction: number): void {
    const { polygons } = this;
    if (!polygons || polygons.all.length === 0) return;
    const sorted = [...polygons.all.keys()].sort((a, b) => polygons.all[a].lowest - polygons.all[b].lowest);
    const now = motion.show === 'polygon' ? sorted.indexOf(polygons.of(motion)) : -1;
    const polygon = polygons.all[beside(sorted, now, direction)];
    const period = Number((0.5 * (polygon.lowest + polygon.highest)).toPrecision(6));
    this.onPick({ kind: 'polygon', polygon, period, split: 0.5 });
  }

  setHere(here: { x: number; y: number } | undefined): void {
    this.here = here;
    // Of polygons the one that is meant is drawn otherwise.
    if (this.kind === 'contacts') this.plot.redraw();
    else this.plot.redrawOver();
  }

  show(kind: MapKind, view: View): void {
    this.kind = kind;
    if (kind === 'energy') {
      this.plot.show({ x: ['frequency ω', 'frequency'], y: ['energy E', 'energy'], logY: true, spreadX: frequencies.spread, xRange: frequencies.range, yRange: [0.95, mostEnergy],
        zoom: true, yTicks: [1, 2, 5, 10, 20, 50] }, [[1, 2], [1, 1]], [{ show: false }], (plot) => this.drawEnergy(plot));
    } else if (kind === 'existence') {
      this.plot.show({ x: ['contact time t_c', 'time'], y: ['flight time t_f', 'time'], xRange: [0, 2], yRange: [0, 4], zoom: true },
        [[0, 2], [0, 4]], [{ show: false }], (plot) => this.drawExistence(plot));
    } else if (kind === 'contacts') {
      const { x, y } = this.polygons?.ranges() ?? { x: [0, 8], y: [0, 2] };
      this.plot.show({ x: ['period T', 'time'], y: ['first contact', 'time'], xRange: x, yRange: y, zoom: true, isDragged: true },
        [x, y], [{ show: false }], (plot) => this.drawContacts(plot, view.motion));
    } else {
      this.showResponse(view.forcing);
    }
  }

  showResponse(forcing: Forcing): void {
    const most = Math.max(0.5, ...this.response.map((p) => p.impulse), ...this.sweep.map((p) => p.most));
    this.plot.show({ x: ['frequency of the excitation', 'frequency'], y: ['impulse', 'impulse'], xRange: [forcing.least, forcing.most],
      yRange: [0, 1.08 * most], zoom: true }, [[forcing.least, forcing.most], [0, 1]], [{ show: false }], (plot) => this.drawResponse(plot));
  }

  private drawHere(plot: uPlot, c: CanvasRenderingContext2D): void {
    if (!this.here) return;
    const r = 7 * devicePixelRatio * letters();
    const { left, top, width, height } = plot.bbox;
    const [trueX, trueY] = at(plot, this.here.x, this.here.y);
    const inside = (value: number, low: number, high: number): number => Math.min(Math.max(value, low), high);
    const [x, y] = [inside(trueX, left + 3 * r, left + width - 3 * r), inside(trueY, top + 3 * r, top + height - 3 * r)];
    const isOutside = trueX < left || trueX > left + width || trueY < top || trueY > top + height;
    if (isOutside) return this.drawAway(plot, c, x, y, Math.atan2(trueY - y, trueX - x), r);
    this.drawRing(c, trueX, trueY, r);
  }

  /** The motion is beyond what the map shows: an arrow there, and where it is. */
  private drawAway(plot: uPlot, c: CanvasRenderingContext2D, x: number, y: number, angle: number, r: number): void {
    c.save();
    c.translate(x, y);
    c.rotate(angle);
    c.strokeStyle = palette.contact;
    c.fillStyle = palette.contact;
    c.lineWidth = 3 * devicePixelRatio;
    trace(c, 'stroke', [-r, 0], [1.6 * r, 0]);
    trace(c, 'fill', [2.6 * r, 0], [1.2 * r, -r], [1.2 * r, r]);
    c.restore();
    const { left, width } = plot.bbox;
    c.font = fontOf(13 * devicePixelRatio);
    c.textAlign = 'center';
    c.textBaseline = 'middle';
    const { x: hereX, y: hereY } = this.here!;
    const what = this.kind === 'energy' ? `E = ${withUnit('energy', hereY, 4)} at ${withUnit('frequency', hereX, 4)}` : `at ${Number(hereX.toPrecision(4))}, ${Number(hereY.toPrecision(4))}`;
    // Behind the arrow, on paper of its own: curves pass below.
    const half = c.measureText(what).width / 2;
    const [atX, atY] = [Math.min(Math.max(x, left + half), left + width - half), y + (angle < 0 ? 2.5 : -2.5) * r];
    c.fillStyle = tones().paper;
    c.fillRect(atX - half, atY - r, 2 * half, 2 * r);
    c.fillStyle = tones().ink;
    c.fillText(what, atX, atY);
  }

  private drawRing(c: CanvasRenderingContext2D, x: number, y: number, r: number): void {
    c.strokeStyle = palette.contact;
    c.lineWidth = 3 * devicePixelRatio;
    dot(c, x, y, r);
    c.stroke();
    c.lineWidth = devicePixelRatio;
    c.strokeStyle = tones().ink;
    for (const [dx, dy] of [[1, 0], [-1, 0], [0, 1], [0, -1]]) {
      trace(c, 'stroke', [x + dx * r * 1.2, y + dy * r * 1.2], [x + dx * r * 1.9, y + dy * r * 1.9]);
    }
  }

  private drawEnergy(plot: uPlot): void {
    const { atlas } = this;
    if (!atlas) return;
    const c = plot.ctx;
    const { ink } = tones();
    const top = plot.bbox.top;
    // Families: half-lines, the bolder the lower their order.
    for (const family of [...atlas.families].reverse()) {
      const [x, y] = at(plot, 4 / family.period, family.least);
      const weight = Math.min(1, 5 / family.order);
      c.globalAlpha = 0.08 + 0.75 * weight * weight;
      c.strokeStyle = palette.strain;
      c.lineWidth = (0.6 + 2 * weight) * devicePixelRatio;
      trace(c, 'stroke', [x, y], [x, top]);
      if (family.order <= 12) {
        c.globalAlpha = 1;
        c.fillStyle = palette.strain;
        dot(c, x, y, (1.5 + 2 * weight) * devicePixelRatio);
        c.fill();
      }
    }
    c.globalAlpha = 1;
    c.strokeStyle = ink;
    atlas.modes.forEach((mode, k) => {
      // The fewer turns of T a mode counts, the bolder.
      const weight = Math.min(1, 3 / -mode.contact[1]);
      c.lineWidth = (0.7 + 1.5 * weight) * devicePixelRatio;
      c.globalAlpha = 0.35 + 0.65 * weight;
      trace(c, 'stroke', ...Array.from({ length: atlas.samples }, (_, j) => {
        const i = 2 * (k * atlas.samples + j);
        return at(plot, 4 / atlas.curves[i], atlas.curves[i + 1]);
      }));
    });
    c.globalAlpha = 1;
  }

  private drawExistence(plot: uPlot): void {
    const { atlas } = this;
    if (!atlas) return;
    const c = plot.ctx;
    const { faint } = tones();
    const colour = through(palette.sequence.slice(0, 8));
    const size = Math.max(1.5, 0.6 * (plot.bbox.width / (2 * atlas.cells))) * (plot.bbox.width > 300 ? 1 : 0.8) + 1;
    for (let i = 0; i < atlas.schedules.length; i += 4) {
      const [nc, nf, least, presses] = atlas.schedules.subarray(i, i + 4);
      if (nf > 4 * atlas.cells) continue;
      const [x, y] = at(plot, nc / atlas.cells, nf / atlas.cells);
      c.fillStyle = presses ? asText(colour(Math.log(least) / Math.log(mostEnergy))) : faint;
      c.globalAlpha = presses ? 1 : 0.45;
      c.fillRect(x - size / 2, y - size / 2, size, size);
    }
    c.globalAlpha = 1;
    // What the colours mean, in the corner where there are no motions.
    const unit = devicePixelRatio * letters();
    const { left, top, width } = plot.bbox;
    c.font = fontOf(12 * devicePixelRatio);
    c.textAlign = 'right';
    c.textBaseline = 'middle';
    c.fillStyle = tones().ink;
    const [ends, y] = [[withUnit('energy', 1), withUnit('energy', mostEnergy)], top + 12 * unit];
    const right = left + width - 8 * unit - c.measureText(ends[1]).width;
    c.fillText(ends[1], left + width - 4 * unit, y);
    c.fillText(`least energy ${ends[0]}`, right - 84 * unit, y);
    drawScale(c, right - 80 * unit, y - 5 * unit, 80 * unit, 10 * unit, colour);
  }

  private drawContacts(plot: uPlot, motion: Motion): void {
    if (!this.polygons) return;
    this.polygons.draw(plot, motion.show === 'polygon' ? this.polygons.of(motion) : -1);
  }

  private drawResponse(plot: uPlot): void {
    const c = plot.ctx;
    const { faint, paper } = tones();
    const r = 3.2 * devicePixelRatio;
    // Where the bar without a wall would stay clear of it.
    c.fillStyle = faint;
    c.globalAlpha = 0.18;
    // Runs of neighbours are one band.
    const edge = (k: number): number => {
      const [here, next] = [this.lines[Math.max(k, 0)], this.lines[Math.min(k + 1, this.lines.length - 1)]];
      return plot.valToPos((here[0] + next[0]) / 2, 'x', true);
    };
    for (let k = 0; k < this.lines.length; ++k) {
      if (this.lines[k][2]) continue;
      const first = k;
      while (k + 1 < this.lines.length && !this.lines[k + 1][2]) ++k;
      const [from, to] = [edge(first - 1), edge(k)];
      c.fillRect(Math.min(from, to), plot.bbox.top, Math.abs(to - from), plot.bbox.height);
    }
    c.globalAlpha = 1;
    for (const point of this.response) {
      const [x, y] = at(plot, point.frequency, point.impulse);
      // Full: tried, it attracts. Open: tried, it repels. Small: not tried.
      dot(c, x, y, point.stays === 0 ? 0.4 * r : r);
      c.strokeStyle = palette.strain;
      c.lineWidth = 1.5 * devicePixelRatio;
      c.fillStyle = point.stays < 0 ? paper : palette.strain;
      c.fill();
      c.stroke();
    }
  }

  private drawOver(plot: uPlot, c: CanvasRenderingContext2D): void {
    if (this.kind === 'response') this.drawSweep(plot, c);
    this.drawHere(plot, c);
    if (this.kind === 'response' && this.settled) {
      const r = 3.2 * devicePixelRatio;
      const [x, y] = at(plot, this.settled.x, this.settled.y);
      c.strokeStyle = palette.velocity;
      c.lineWidth = 3 * devicePixelRatio;
      c.beginPath();
      for (const [dx, dy] of [[-1, 0], [0, -1], [1, 0], [0, 1]]) c.lineTo(x + 3.2 * r * dx, y + 3.2 * r * dy);
      c.closePath();
      c.stroke();
    }
  }

  /** Triangles that point where the sweep went; a bar from the least impulse to the most where a motion does not repeat every period. */
  private drawSweep(plot: uPlot, c: CanvasRenderingContext2D): void {
    const r = 4.5 * devicePixelRatio;
    for (const { frequency, least, most, isDown } of this.sweep) {
      c.fillStyle = c.strokeStyle = isDown ? palette.velocity : palette.contact;
      const [x, low] = at(plot, frequency, least);
      const [, high] = at(plot, frequency, most);
      c.lineWidth = 2 * devicePixelRatio;
      trace(c, 'stroke', [x, low], [x, high]);
      const side = isDown ? -1 : 1;
      const y = isDown ? low : high;
      trace(c, 'fill', [x, y - side * r], [x - r, y + side * r], [x + r, y + side * r]);
    }
  }
}
