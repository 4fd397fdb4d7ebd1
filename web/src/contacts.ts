// Controls of the motions with two contacts: which polygon, and where in it.

import type { PolygonMotion } from './core';
import { byId, input, round, select, shown, slide } from './dom';
import type { Explorer } from './explorer';
import type { Polygon } from './polygons';
import { withUnit } from './units';

/** In the widest polygon, away from its middle. */
export const firstPolygon: PolygonMotion = { show: 'polygon', chains: [[2, 1, 2], [2, 2, 1]], period: 2.58, split: 0.3, cells: 200 };

/** "8 − 3T". */
const contactOf = ({ contact: [sum, turns] }: Polygon): string => `${sum} − ${turns === -1 ? '' : -turns}T`;

export class PolygonControls {
  constructor(private readonly explorer: Explorer) {
    select('polygon').onchange = () => {
      const polygon = explorer.map.polygons!.all[Number(select('polygon').value)];
      void explorer.pick({ kind: 'polygon', polygon, period: round(0.5 * (polygon.lowest + polygon.highest)), split: 0.5 });
    };
    this.slide('polygon-period', (share, motion) => {
      const polygon = this.polygon(motion);
      return polygon ? { ...motion, period: round(polygon.lowest + (0.002 + 0.996 * share) * (polygon.highest - polygon.lowest)) } : motion;
    });
    this.slide('split', (split, motion) => ({ ...motion, split }));
  }

  private polygon(motion: PolygonMotion): Polygon | undefined {
    const { polygons } = this.explorer.map;
    return polygons?.all[polygons.of(motion)];
  }

  private slide(id: string, moved: (value: number, motion: PolygonMotion) => PolygonMotion): void {
    slide(id, (value) => void this.explorer.show(moved(value, this.explorer.view.motion as PolygonMotion)));
  }

  follow(motion: PolygonMotion): void {
    const { polygons } = this.explorer.map;
    const list = select('polygon');
    if (polygons && list.options.length === 0) {
      list.append(...polygons.all.map((one, k) => new Option(
        `contacts ${contactOf(one)}, T from ${shown(one.lowest, 4)} to ${shown(one.highest, 4)} (${one.free > 0 ? 'shared freely' : 'single motions'})`, String(k))));
    }
    const polygon = this.polygon(motion);
    if (polygon) {
      list.value = String(polygons!.of(motion));
      input('polygon-period').value = String((motion.period - polygon.lowest) / (polygon.highest - polygon.lowest));
    }
    const answer = this.explorer.answer?.json.answer as { first_contact_range: [number, number]; stretches: number[] };
    const [least, most] = answer.first_contact_range;
    input('split').disabled = !(most > least);
    input('split').value = String(motion.split);
    byId('polygon-period-value').textContent = withUnit('time', motion.period, 10);
    byId('split-value').textContent = `${shown(answer.stretches[0], 4)} and ${withUnit('time', answer.stretches[2], 4)}`;
  }
}
