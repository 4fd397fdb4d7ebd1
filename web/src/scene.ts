// Controls of what stands around the bar, and of any schedule that one types.

import type { Motion, ScheduleMotion } from './core';
import { byId, input, round, select, shown, slide } from './dom';
import type { Explorer } from './explorer';
import { paperCase, phasesAsText, typedPhases } from './view';

/** A motion of each scene, to begin with. */
const scenes: Record<string, Motion> = {
  gap: paperCase,
  touching: { show: 'schedule', cells: 300, phases: [[150, 600]], gap: 0, energy: 2e-5 },
  pressed: { show: 'schedule', cells: 300, phases: [[450, 300]], gap: -1e-3 },
  stops: { show: 'schedule', cells: 300, phases: [[75, 375], [75, 375, 'L']], second_stop: 1e-3 },
};

const nameOf = ({ gap, second_stop: stop }: ScheduleMotion): string =>
  (stop !== undefined ? 'stops' : gap === undefined || gap > 0 ? 'gap' : gap === 0 ? 'touching' : 'pressed');

export class SceneControls {
  constructor(private readonly explorer: Explorer) {
    select('scene').onchange = () => void explorer.show(scenes[select('scene').value]);
    slide('second-stop', (stop) => {
      const { energy: _, ...motion } = explorer.view.motion as ScheduleMotion;
      void explorer.show({ ...motion, second_stop: round(stop / 1000) });
    });
    byId<HTMLFormElement>('schedule-form').onsubmit = (event) => {
      event.preventDefault();
      this.showTyped();
    };
  }

  /** The schedule that was typed, in the scene that is shown. */
  private showTyped(): void {
    const { gap, second_stop: stop, energy } = this.explorer.view.motion as ScheduleMotion;
    try {
      const motion: ScheduleMotion = { show: 'schedule', cells: Number(input('schedule-cells').value), phases: typedPhases(input('schedule-text').value),
        ...(gap === undefined ? {} : { gap }), ...(stop === undefined ? {} : { second_stop: stop }), ...(gap === 0 && energy !== undefined ? { energy } : {}) };
      void this.explorer.show(motion);
    } catch (fault) {
      this.explorer.say(`${(fault as Error).message}. What is shown stays as it was.`);
    }
  }

  follow(motion: ScheduleMotion): void {
    select('scene').value = nameOf(motion);
    byId('second-stop-row').hidden = motion.second_stop === undefined;
    input('second-stop').value = String((motion.second_stop ?? 1e-3) * 1000);
    byId('second-stop-value').textContent = `${shown((motion.second_stop ?? 1e-3) * 1000, 3)} mm`;
    input('schedule-text').value = phasesAsText(motion.phases).replaceAll(',', ', ');
    input('schedule-cells').value = String(motion.cells);
  }
}
