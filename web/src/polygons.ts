// Two contacts in a period: polygons of motions over period and first contact.

import type uPlot from 'uplot';
import { palette } from './colours';
import type { Answer, Chain, PolygonMotion } from './core';
import { at } from './plots';

export interface Polygon { chains: Chain[]; free: number; lowest: number; highest: number; contact: [number, number] }

/** A point of a polygon. */
export interface PolygonPick { polygon: Polygon; period: number; split: number }

interface Json { chains: { k: number; turns: number; release: number }[]; free_times: number; lowest: number; highest: number; contact: [number, number] }

const [leastSplit, mostSplit] = [0.001, 0.999];
const inside = (share: number): number => Math.min(Math.max(share, leastSplit), mostSplit);

export class Polygons {
  readonly all: Polygon[];
  private readonly bands: Float64Array;  // T, E/E_1, least and most first contact
  private readonly samples: number;

  constructor(answer: Answer) {
    this.all = (answer.json.polygons as Json[]).map(({ chains, free_times: free, lowest, highest, contact }) =>
      ({ chains: chains.map(({ k, turns, release }): Chain => [k, turns, release]), free, lowest, highest, contact }));
    this.bands = answer.array('bands');
    this.samples = Number(answer.json.samples);
  }

  private sample(k: number, j: number): Float64Array {
    const from = 4 * (k * this.samples + j);
    return this.bands.subarray(from, from + 4);
  }

  /** Where the wider ones with a choice are: the others are slim, at other periods. */
  ranges(): { x: [number, number]; y: [number, number] } {
    const wide = [...this.all.keys()].filter((k) => this.all[k].free > 0 && this.all[k].highest - this.all[k].lowest > 0.05);
    const low = Math.min(...wide.map((k) => this.all[k].lowest));
    const high = Math.max(...wide.map((k) => this.all[k].highest));
    const most = Math.max(...wide.flatMap((k) => Array.from({ length: this.samples }, (_, j) => this.sample(k, j)[3])));
    return { x: [low - 0.06 * (high - low), high + 0.06 * (high - low)], y: [-0.03 * most, 1.06 * most] };
  }

  /** Least and most first contact at a period of the polygon. */
  private contacts(k: number, period: number): [number, number] {
    const { lowest, highest } = this.all[k];
    const place = Math.min(Math.max((period - lowest) / (highest - lowest), 0), 1) * (this.samples - 1);
    const row = Math.min(Math.floor(place), this.samples - 2);
    const [from, to] = [this.sample(k, row), this.sample(k, row + 1)];
    return [2, 3].map((i) => from[i] + (place - row) * (to[i] - from[i])) as [number, number];
  }

  of(motion: PolygonMotion): number {
    const name = motion.chains.join();
    return this.all.findIndex((p) => p.chains.join() === name && p.lowest < motion.period && motion.period < p.highest);
  }

  /** The motion under a pointer; of polygons that overlap the smaller one. */
  pick(plot: uPlot, px: number, py: number): PolygonPick | undefined {
    const [period, contact] = [plot.posToVal(px, 'x'), plot.posToVal(py, 'y')];
    let best: { distance: number; size: number; pick: PolygonPick } | undefined;
    this.all.forEach((polygon, k) => {
      const width = polygon.highest - polygon.lowest;
      const nearest = polygon.lowest + inside((period - polygon.lowest) / width) * width;
      const [least, most] = this.contacts(k, nearest);
      const there = Math.min(Math.max(contact, least), most);
      const away = Math.hypot(plot.valToPos(nearest, 'x') - px, plot.valToPos(there, 'y') - py);
      const distance = away < 1 ? 0 : away;
      const size = width * (most - least);
      if (best && (distance > best.distance || (distance === best.distance && size >= best.size))) return;
      const split = most > least ? inside((there - least) / (most - least)) : 0.5;
      best = { distance, size, pick: { polygon, period: Number(nearest.toPrecision(6)), split: Number(split.toPrecision(3)) } };
    });
    return best?.pick;
  }

  draw(plot: uPlot, chosen: number): void {
    const c = plot.ctx;
    const ratio = devicePixelRatio;
    const path = (k: number, column: number, isBack: boolean): void => {
      for (let j = 0; j < this.samples; ++j) {
        const row = this.sample(k, isBack ? this.samples - 1 - j : j);
        const [x, y] = at(plot, row[0], row[column]);
        if (j === 0 && !isBack) c.moveTo(x, y);
        else c.lineTo(x, y);
      }
    };
    this.all.forEach((polygon, k) => {
      const isChosen = k === chosen;
      c.strokeStyle = polygon.free > 0 ? palette.strain : palette.contact;
      c.lineWidth = (isChosen ? 3 : polygon.free > 0 ? 1.2 : 2) * ratio;
      c.beginPath();
      path(k, 2, false);
      if (polygon.free > 0) {
        path(k, 3, true);
        c.closePath();
        c.fillStyle = palette.strain;
        c.globalAlpha = isChosen ? 0.45 : 0.16;
        c.fill();
        c.globalAlpha = 1;
      } else {
        c.setLineDash([8 * ratio, 4 * ratio]);
      }
      c.stroke();
      c.setLineDash([]);
    });
  }
}
