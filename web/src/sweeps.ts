// What fills the response map while one watches: sweeps of the frequency, and where a bar settled that
// was let go beside a motion.

import type { Answer, ForcedMotion, Simulation } from './core';
import { byId } from './dom';
import type { Explorer } from './explorer';
import type { ResponsePoint } from './map';
import { withUnit } from './units';

/** ω/ω₁, least and most impulse in a period of the excitation, periods after which it repeats itself (0: it does not). */
export interface SweepPoint { frequency: number; least: number; most: number; periods: number; isDown: boolean }

const points = 60;
const share = 0.99;  // of the motion beside which the bar starts

export class Sweeps {
  private run = 0;
  private started: [ForcedMotion, Answer] | undefined;

  constructor(private readonly explorer: Explorer) {
    byId('sweep-up').onclick = () => void this.sweep(false);
    byId('sweep-down').onclick = () => void this.sweep(true);
    byId('start-beside').onclick = () => void this.startBeside();
  }

  /** What the library is asked for, of the excitation that is set. */
  question(isDown: boolean): Record<string, unknown> {
    const { damping, place, amplitude, cells, least, most } = this.explorer.view.forcing;
    return { damping, place, amplitude, cells, least, most, points, periods: 200, down: isDown };
  }
  get last(): boolean | undefined { return this.explorer.map.sweep.at(-1)?.isDown; }

  stop(): void {
    ++this.run;
    byId('sweep-progress').textContent = '';
  }
  clear(): void {
    this.stop();
    this.explorer.map.sweep.length = 0;
    this.explorer.map.settled = this.started = undefined;
  }

  private async sweep(isDown: boolean): Promise<void> {
    const run = ++this.run;
    const { explorer } = this;
    const { map } = explorer;
    explorer.haltResponse();
    const others = map.sweep.filter((one) => one.isDown !== isDown);
    for (let done = 0, all = points; done < all; ) {
      const answer = await explorer.library.ask({ show: 'sweep', ...this.question(isDown), wanted: done + 1 });
      if (run !== this.run) return;
      all = Number(answer.json.all);
      const rows = answer.array('points');
      done = rows.length / 4;
      const mine: SweepPoint[] = Array.from({ length: done }, (_, k) => ({ frequency: rows[4 * k], least: rows[4 * k + 1], most: rows[4 * k + 2], periods: rows[4 * k + 3], isDown }));
      map.sweep.splice(0, map.sweep.length, ...others, ...mine);
      map.showResponse(explorer.view.forcing);
      const unsettled = mine.filter((one) => one.periods !== 1).length;
      byId('sweep-progress').textContent = `${isDown ? '▼ down' : '▲ up'}: ${done} of ${all} frequencies, the state carried over${unsettled ? `; ${unsettled} do not repeat every period` : ''}`;
    }
    explorer.onShown();
  }

  /** One per cent beside the motion on the screen. */
  private async startBeside(): Promise<void> {
    const { explorer } = this;
    const motion = explorer.view.motion as ForcedMotion;
    const { cells, phases, damping, place, amplitude } = motion;
    const which = Number(explorer.answer!.json.which ?? motion.which);
    const steps = phases[0][0] + phases[0][1];
    const simulation: Simulation = { show: 'simulation', cells, phases, which, start: { kind: 'beside', share }, damping, steps, periods: 400, place, amplitude, from: 0, span: 24, frames: 60 };
    await explorer.show(simulation);
    if (explorer.view.motion === simulation) this.started = [{ ...motion, which }, explorer.answer!];
    this.mark();
  }

  /** Where the bar settled, and why; in the units that are chosen. */
  mark(): void {
    if (!this.started) return;
    const [from, answer] = this.started;
    const { map } = this.explorer;
    const steps = from.phases[0][0] + from.phases[0][1];
    const settled = (answer.json.answer as { settled: { periods: number; contacts: number; impulse: number } | null; why?: string }).settled;
    const started = map.response.find((p) => p.steps === steps && p.contact === from.phases[0][0] && p.which === from.which);
    const tried = !started || started.stays === 0 ? 'It was not tried yet whether that motion attracts'
      : started.stays > 0 ? 'That motion attracts: the difference dies out' : 'That motion repels: the difference grew';
    const frequency = (4 * from.cells) / steps;
    let where = 'it has not settled on a motion that repeats itself within 16 periods';
    map.settled = undefined;
    if (settled) {
      const impulse = settled.impulse / 1e-3 / settled.periods;
      map.settled = { x: frequency, y: impulse };
      const there = map.response.filter((p) => p.steps === steps).reduce<ResponsePoint | undefined>(
        (best, p) => (!best || Math.abs(p.impulse - impulse) < Math.abs(best.impulse - impulse) ? p : best), undefined);
      const isThere = settled.periods === 1 && there && Math.abs(there.impulse - impulse) < 1e-3 * Math.max(there.impulse, 0.01);
      where = settled.contacts === 0 ? 'it came to rest clear of the wall, shaken without a contact'
        : isThere && there === started ? `it came back to the same motion, impulse ${withUnit('impulse', impulse, 4)}`
          : isThere ? `it settled on the other motion of this frequency, (${there.contact}, ${there.steps - there.contact}), impulse ${withUnit('impulse', impulse, 4)}, ${there.stays > 0 ? 'which attracts' : 'a dot of this map'}`
            : `it settled on a motion of ${settled.contacts} contacts in ${settled.periods} periods, impulse ${withUnit('impulse', impulse, 4)} a period, which is no dot of this map`;
    }
    byId('settled-where').textContent = `Started 1 % away from (${from.phases[0].slice(0, 2).join(', ')}) at ${withUnit('frequency', frequency, 4)}. ${tried}; ${where}${map.settled ? ' (the diamond)' : ''}.`;
    map.plot.redrawOver();
  }
}
